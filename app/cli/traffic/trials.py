"""Trials of the rules of traffic in the fast plant: what is compared with what, and what counts (TRAFFIC sections 3 to 6)."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from itertools import chain, groupby
from time import process_time

import numpy as np

from app.domain.ids import VehicleId
from app.domain.layout import Plant as Layout
from app.domain.units import Millimetres
from app.planning.deadlock import deadlocks
from app.planning.track import BOOK_VEHICLE, Track
from app.plant.fab import Shape, generate, populate
from app.sim.kinematic.drill import CYCLE, Drill
from app.sim.kinematic.fab import Fab, Plant
from app.sim.kinematic.load import NOBODY
from app.sim.kinematic.network import Map, Real, draw
from app.sim.kinematic.state import DELIVERED, EVENTS, PUSHED, STANDING

HOIST = replace(BOOK_VEHICLE, length=Millimetres(950))
"""The vehicle of all trials: of PROTOCOLS 5.1, as long as a barcode's distance lets it be (our choice)."""
FULL = 0.5
"""Share of the ports that have a carrier at first. Our choice."""
STALLED = 5
"""A fleet that delivers nothing for so many minutes is at a standstill. Our choice."""
MODES: dict[str, Plant] = {
    "no rule": Plant(admission=False, restraint=False, reweigh=0.0),
    "admission": Plant(restraint=False, reweigh=0.0),
    "+ congestion": Plant(restraint=False),
    "all": Plant(),
}
"""What is switched on: nothing but the track itself; look-ahead; ways by the traffic too; and besides no more vehicles on their
way than the track carries.
"""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of a run. ``locked``: vehicles that wait for each other in a circle at its end; ``oldest``: the longest that a
    transfer waited for a vehicle to come, s; ``cpu``: seconds of this process.
    """

    vehicles: int
    seconds: float
    per_minute: tuple[int, ...]
    locked: int
    pushed: int
    events: int
    oldest: float
    cpu: float

    @property
    def per_hour(self) -> float:
        """Transfers delivered in an hour, without the first quarter of the run, in which the fleet spreads out."""
        steady = self.per_minute[len(self.per_minute) // 4 :]
        return 60.0 * sum(steady) / len(steady)

    @property
    def stalled(self) -> bool:
        """Whether nothing was delivered in the last ``STALLED`` minutes, though no circle is locked: one hole goes round."""
        return not self.locked and not any(self.per_minute[-STALLED:])

    @property
    def times_real(self) -> float:
        """How many seconds passed in the plant for each of this process."""
        return self.seconds / self.cpu


@cache
def _drawn(shape: Shape, seed: int) -> tuple[Layout, Track, Map]:
    layout = generate(shape, seed).plant
    track = Track(layout)
    return layout, track, draw(track, HOIST)


def track_of(shape: Shape, seed: int) -> Track:
    """Return the track of a fab."""
    return _drawn(shape, seed)[1]


def fab_of(shape: Shape, vehicles: int, how: Plant, seed: int) -> Fab:
    """Return a fab with so many vehicles, spread over it by the seed."""
    layout, _, plan = _drawn(shape, seed)
    starts = [vehicle.start for vehicle in populate(layout, vehicles, seed, FULL).vehicles]
    ports = list(dict.fromkeys(station.barcode for station in layout.stations))
    parking = [point.barcode for point in layout.points if point.park]
    return Fab(plan, HOIST, ports, [start for start in starts if start is not None], seed, how, parking=parking)


def run(fab: Fab, minutes: int) -> Outcome:
    """Let a fab work for so many minutes."""
    counts, per_minute, cpu = fab.state.counts, [], process_time()
    begun = counts.copy()
    for _ in range(minutes):
        before = int(counts[DELIVERED])
        fab.run(60.0)
        per_minute.append(int(counts[DELIVERED]) - before)
    cpu = process_time() - cpu
    return Outcome(
        vehicles=len(fab.state.at),
        seconds=60.0 * minutes,
        per_minute=tuple(per_minute),
        locked=len(locked(fab)),
        pushed=int(counts[PUSHED] - begun[PUSHED]),
        events=int(counts[EVENTS] - begun[EVENTS]),
        oldest=fab.transfers.oldest(fab.now),
        cpu=cpu,
    )


def locked(fab: Fab) -> tuple[VehicleId, ...]:
    """Return the vehicles that stand in circles, each waiting until the next one goes first, by their numbers.

    A circle of vehicles that have nothing to do holds up nobody, and does not count.
    """
    s = fab.state
    needs = {vehicle: _waits(fab, vehicle) for vehicle in np.flatnonzero(s.doing == STANDING).tolist()}
    circles = deadlocks(
        {_named(v): [[_named(other) for other in group] for group in groups] for v, groups in needs.items()}
    )
    return tuple(chain(*(circle for circle in circles if any(s.goal[int(name)] >= 0 for name in circle))))


def _waits(fab: Fab, vehicle: int) -> list[list[int]]:
    """Return of whom one must go first: who holds the barcode waited for, or the heads of the full buffers of a refusal.

    Who waits for closed track waits for nobody. The head of a queue that has nothing to do goes on where any next one has room.
    """
    s, lines = fab.state, fab.state.lines
    if (barcode := int(s.waits_for[vehicle])) >= 0:
        return [[int(s.owner[barcode])]] if s.owner[barcode] >= 0 and not s.closed[barcode] else []
    buffers = s.watches[vehicle, : s.watching[vehicle]].tolist()
    if s.goal[vehicle] < 0 and lines.head[slot := lines.slot[vehicle]] == vehicle:
        buffers = lines.outs[lines.out_at[slot] : lines.out_at[slot + 1]]
        if any(lines.load[buffer] < lines.capacity[buffer] for buffer in buffers):
            return []
    heads = [int(lines.head[buffer]) for buffer in buffers]
    others = [head for head in heads if head not in {NOBODY, vehicle}]
    return [others] if others else []


def _named(vehicle: int) -> VehicleId:
    return VehicleId(str(vehicle))


WINDOW = 300.0
"""Deliveries are compared over so many seconds: about 500, which chance alone moves by 4 %."""


@dataclass(frozen=True, slots=True)
class Storm:
    """What a storm of events did: deliveries as shares of those of the same fab undisturbed in the same seconds.

    ``before``: in the five minutes before its first event; ``during``: until the end of its last one; ``after``: in the next
    five minutes; ``then``: in the five after those, of ``usual`` deliveries. None: the drill was over by then.
    """

    began: float
    ended: float
    events: int
    before: float
    during: float
    after: float | None
    then: float | None
    usual: int


@dataclass(frozen=True, slots=True)
class Drilled:
    """What came of a drill. ``named``: events that cut ports off. ``usual``: deliveries per hour of the undisturbed twin,
    ``outcome`` has those of the drill.
    """

    events: int
    named: int
    outcome: Outcome
    usual: float
    storms: tuple[Storm, ...]

    @property
    def judged(self) -> list[float]:
        """What was delivered from five to ten minutes after each storm, as shares of the twin's."""
        return [storm.then for storm in self.storms if storm.then is not None]


def drill(shape: Shape, vehicles: int, hours: float, per_hour: float, seed: int, *, settle: float = 600.0) -> Drilled:
    """Let vehicles break down and track be closed at random; all is well ``settle`` seconds before it and after it.

    The twin is the same fab with the same seed, and no events.
    """
    fab, twin = (fab_of(shape, vehicles, Plant(), seed) for _ in range(2))
    fab.run(settle)
    trouble = Drill(fab, per_hour, seed)
    counts, cpu, begun = fab.state.counts, process_time(), fab.state.counts.copy()
    per_minute: list[int] = []
    for _ in range(int(hours * 60)):
        before = int(counts[DELIVERED])
        trouble.run(60.0)
        per_minute.append(int(counts[DELIVERED]) - before)
    trouble.stop()
    fab.run(settle)
    outcome = Outcome(
        vehicles, hours * 3600, tuple(per_minute), len(locked(fab)), int(counts[PUSHED] - begun[PUSHED]),
        int(counts[EVENTS] - begun[EVENTS]), 0.0, process_time() - cpu,
    )  # fmt: skip
    twin.run(fab.now)
    own, usual = (np.array([one.at for one in some.delivered]) for some in (fab, twin))
    end = trouble.began + 60.0 * len(per_minute)
    storms = tuple(_storms(trouble, partial(_share, own, usual), usual, end))
    named = sum(bool(event.cut_off) for event in trouble.events)
    rate = 3600 * int(((usual > trouble.began) & (usual <= end)).sum()) / (end - trouble.began)
    return Drilled(len(trouble.events), named, outcome, rate, storms)


def _share(own: Real, usual: Real, begin: float, end: float) -> float:
    """Return what was delivered from one time to another as a share of the usual."""
    first, second = (int(((at > begin) & (at <= end)).sum()) for at in (own, usual))
    return first / max(1, second)


def _storms(trouble: Drill, share: Callable[[float, float], float], undisturbed: Real, end: float) -> Iterator[Storm]:
    """Give what each storm did, as far as the drill went on after it."""
    for _, some in groupby(trouble.events, key=lambda event: int((event.at - trouble.began) // CYCLE)):
        events = list(some)
        begin, over = events[0].at, max(event.ends for event in events)
        if over > end:
            return
        after, then = (share(at, at + WINDOW) if at + WINDOW <= end else None for at in (over, over + WINDOW))
        usual = int(((undisturbed > over + WINDOW) & (undisturbed <= over + 2 * WINDOW)).sum())
        yield Storm(begin, over, len(events), share(begin - WINDOW, begin), share(begin, over), after, then, usual)


def together(drills: Sequence[Drilled]) -> list[float]:
    """Return what was delivered from five to ten minutes after each storm, in several drills together, as shares of their twins'.

    A storm is the one of its number in each. One that is not judged in all of them is left out.
    """
    found: list[float] = []
    for storms in zip(*(drilled.storms for drilled in drills), strict=False):
        counted = [(storm.then * storm.usual, storm.usual) for storm in storms if storm.then is not None]
        if len(counted) == len(drills):
            found.append(sum(own for own, _ in counted) / max(1, sum(usual for _, usual in counted)))
    return found
