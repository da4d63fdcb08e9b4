"""What moves in the fast plant, as arrays."""

from typing import NamedTuple

import numpy as np

from app.planning.admission import Lines, lines
from app.sim.kinematic.network import Map, Real, Whole

AHEAD = 64
"""Barcodes that a vehicle may be granted ahead at most; a no-stop stretch longer than that cannot be crossed."""
PLAN = 40
"""Buffers from one where a vehicle may wait to the next, at most."""
WATCHED = 8
"""Buffers that a refused vehicle watches; if it hangs on more, it is asked again once a second."""
IDLE, FETCHING, LOADED = 0, 1, 2
STANDING, DRIVING, DWELLING, BROKEN = 0, 1, 2, 3
DELIVERED, PUSHED, GRANTED, EVENTS, REFUSED, ASKED, MILLIMETRES, CIRCLES = range(8)
"""What ``counts`` counts."""


class Rules(NamedTuple):
    """How vehicles drive and what rules hold. Speeds in mm/s, accelerations in mm/s², ways in mm, times in s."""

    acceleration: float
    braking: float
    reaction: float
    """From a barcode read to the longer grant in the vehicle."""
    hearing: float
    """From a grant to a vehicle that drives until it has it."""
    edge: float
    """About the way from a barcode to the next, mm."""
    more: float
    """A grant that has become short is extended by about this much beyond what is needed, mm."""
    dwell: float
    """At a port, for picking up or putting down."""
    restart: float
    """From a grant to a vehicle that stands until it starts."""
    admission: bool


class State(NamedTuple):
    """Per barcode: who holds it, whether it is closed, who waits for it first. Per buffer: how many
    have passed, who watches it first. Per vehicle: where it is, its goal (-1: none), what it is doing until when, its
    grant (``ahead`` barcodes with the way to each and the speed on it, ``granted`` of them, ``left`` mm), the buffers that it
    has decided to cross next (``plan``).
    """

    owner: Whole
    closed: Whole
    waits_first: Whole
    passes: Whole
    watch_first: Whole
    park: Whole
    """Whether a buffer is kept free for idle vehicles."""
    at: Whole
    goal: Whole
    pace: Real
    """Speed at the next barcode; where it stands, 0."""
    began: Real
    initial: Real
    rest: Real
    peak: Real
    doing: Whole
    due: Real
    ahead: Whole
    way: Real
    limit: Real
    granted: Whole
    left: Real
    plan: Whole
    planned: Whole
    phase: Whole
    failed: Whole
    """Whether it is to stand still from the next barcode on, or does."""
    since: Real
    waits_for: Whole
    waits_next: Whole
    waits_before: Whole
    watches: Whole
    watching: Whole
    watch_next: Whole
    watch_before: Whole
    destination: Whole
    finished: Whole
    clock: Real
    queue: Whole
    queued: Whole
    heap: Whole
    place: Whole
    size: Whole
    """0: of the heap; 1 and 2: from and to of the queue."""
    counts: Whole
    scratch: Whole
    hop: Whole
    """Row per goal buffer: the next buffer from each."""
    lines: Lines


def still(plan: Map, vehicles: int) -> State:
    """Return an empty plant for so many vehicles, none of them on the track yet."""
    barcodes, buffers = len(plan.names), len(plan.buffers)

    def row(size: int, value: int = 0) -> Whole:
        return np.full(size, value, dtype=np.int64)

    arrays = lines(plan.buffers, vehicles)
    return State(
        owner=row(barcodes, -1), closed=row(barcodes), waits_first=row(barcodes, -1),
        passes=row(buffers), watch_first=row(buffers, -1),
        park=row(buffers),
        at=row(vehicles, -1), goal=row(vehicles, -1), pace=np.zeros(vehicles), began=np.zeros(vehicles),
        initial=np.zeros(vehicles),
        rest=np.zeros(vehicles), peak=np.zeros(vehicles), doing=row(vehicles), due=np.zeros(vehicles),
        ahead=np.zeros((vehicles, AHEAD), dtype=np.int64), way=np.zeros((vehicles, AHEAD)), limit=np.zeros((vehicles, AHEAD)),
        granted=row(vehicles), left=np.zeros(vehicles),
        plan=np.zeros((vehicles, PLAN), dtype=np.int64), planned=row(vehicles),
        phase=row(vehicles), failed=row(vehicles), since=np.full(vehicles, -1.0),
        waits_for=row(vehicles, -1), waits_next=row(vehicles, -1), waits_before=row(vehicles, -1),
        watches=np.zeros((vehicles, WATCHED), dtype=np.int64), watching=row(vehicles),
        watch_next=row(vehicles * WATCHED, -1), watch_before=row(vehicles * WATCHED, -1),
        destination=row(vehicles, -1), finished=row(2 * vehicles), clock=np.zeros(1),
        queue=row(4 * vehicles + 8), queued=row(vehicles),
        heap=row(vehicles + 1), place=row(vehicles, -1), size=row(3), counts=row(8), scratch=row(4 * AHEAD),
        hop=np.full((buffers, buffers), -1, dtype=np.int64),
        lines=Lines(*(np.array(r, dtype=np.int64) for r in arrays)),  # type: ignore[arg-type]
    )  # fmt: skip
