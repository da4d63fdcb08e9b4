"""Ways by the traffic (TRAFFIC section 4): what hoists are seen to take over each queue, and how full it has been, weighs routes.

Both say little where traffic flows, and much where it does not: the rules are ``planning.traverses`` and ``planning.congestion``.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from app.domain.ids import VehicleId
from app.domain.records import ControllerState
from app.domain.units import Seconds
from app.fleet.books import Books
from app.fleet.motion import Motion
from app.fleet.vehicle import VehicleNow
from app.planning.congestion import Congestion as Fullness
from app.planning.queues import Queues
from app.planning.traverses import Real, Traverses, Whole

WEIGH_EVERY = Seconds(10.0)
"""Ways are weighed anew at most so often (TRAFFIC section 4: 5 to 20 s)."""
WORTH = 0.2
"""Only what has become so much slower or quicker is weighed anew: tables cost a second of a processor (our choice)."""
SLOW = 2.0
"""Track so many times slower than usual is shown as slow (our choice)."""


@dataclass(slots=True)
class Stay:
    """A vehicle on a piece of track: since when, and whether nothing but others has kept it there."""

    piece: int
    since: Seconds
    fair: bool


class Congestion:
    """Watches hoists on their way and weighs ways, if the plant says so. Pieces are the buffers of ``Traffic.queues``."""

    def __init__(self, books: Books, motion: Motion) -> None:
        self._books = books
        self._motion = motion
        plant = books.plant
        wanted = not plant.restrain if plant.congestion is None else plant.congestion
        self._queues = books.traffic.queues if wanted else None
        self._stays: dict[VehicleId, Stay] = {}
        self._passed: list[tuple[int, float]] = []
        self._looked = books.now
        if self._queues is not None:
            buffers = self._queues.buffers
            self._free = np.maximum(self._free_flow(self._queues), 1e-3)
            self._traverses = Traverses(self._free)
            self._fullness = Fullness(self._free, np.array(buffers.capacity, np.int64))
            self._of_edge = np.array([buffers.at(start) for start, _ in books.router.edges], np.intp)
            self._weighed = np.ones(len(buffers))

    def _free_flow(self, queues: Queues) -> Real:
        """Return the seconds from each buffer's first barcode to the next buffer's, by its quickest way out."""
        graph, buffers = self._books.track.graph, queues.buffers
        found = np.zeros(len(buffers))
        for number, chain in enumerate(buffers.chains):
            found[number] = sum(graph.edges[edge]["time"] for edge in pairwise(chain))
            found[number] += min((graph.edges[chain[-1], b]["time"] for b in graph.successors(chain[-1])), default=0.0)
        return found

    def mind(self, vehicle: VehicleNow) -> None:
        """A vehicle is different now: it may have come to another piece, or be kept by something else than others."""
        if self._queues is None or vehicle.is_agv:
            return
        buffers = self._queues.buffers
        piece = buffers.at(vehicle.barcode) if vehicle.barcode is not None else -1
        stay, now = self._stays.get(vehicle.id), self._books.now
        errand = vehicle.errand
        under_way = errand is not None and vehicle.handling is None and buffers.at(errand.goal) != piece
        drives = under_way and self._motion.may_drive(vehicle)
        if stay is None or stay.piece != piece:
            follows = stay is not None and piece in buffers.nexts[stay.piece]
            if stay is not None and stay.fair and follows:
                self._passed.append((stay.piece, now - stay.since))
            if piece < 0:
                self._stays.pop(vehicle.id, None)
            else:
                self._stays[vehicle.id] = Stay(piece, now, follows and drives)
        elif stay.fair and not drives:
            stay.fair = False

    def _load(self) -> Whole:
        """Return how many vehicles that are on their way have a slot of each piece."""
        queues = self._queues
        busy = (vehicle for vehicle in self._books.vehicles.values() if vehicle.job is not None or vehicle.errand)
        slots = [queues.slot(vehicle.id) for vehicle in busy] if queues is not None else []
        return np.bincount([slot for slot in slots if slot >= 0], minlength=len(self._free)).astype(np.int64)

    def _stilled(self) -> None:
        """All stand because they are told to: that says nothing of the track, and nor do the seconds that it lasts."""
        self._looked = self._books.now
        for stay in self._stays.values():
            stay.fair = False

    def run(self) -> None:
        """Weigh ways anew by what was seen, from time to time and where it makes a difference."""
        books, passed = self._books, self._books.now - self._looked
        if self._queues is None:
            return
        if books.controller.state is not ControllerState.AUTO:
            self._stilled()
            return
        if passed < WEIGH_EVERY:
            return
        self._looked = books.now
        inside = [(stay.piece, books.now - stay.since) for stay in self._stays.values() if stay.fair]
        seen, self._passed = self._passed, []
        self._traverses.look(*_columns(seen), *_columns(inside), passed)
        books.traffic_state.slow = int((self._traverses.slowness() >= SLOW).sum())
        self._fullness.look(self._load(), passed)
        costs = np.maximum(self._traverses.costs(), self._fullness.costs() / self._free)
        worth = np.abs(costs - self._weighed) > WORTH * self._weighed
        if worth.any():
            self._weighed = np.where(worth, costs, self._weighed)
            books.router.slow(np.append(self._weighed, 1.0)[self._of_edge])
            books.traffic_state.weighed += 1


def _columns(rows: list[tuple[int, float]]) -> tuple[Whole, Real]:
    """Return pieces and seconds as arrays."""
    return np.array([row[0] for row in rows], np.int64), np.array([row[1] for row in rows], np.float64)
