"""What a grant costs: vehicles on a whole fab pass barcodes, claim more and give back what lies behind; against an empty loop."""

import gc
import random
import time
from collections.abc import Callable, Iterator

from app.domain.ids import VehicleId
from app.domain.units import Barcode
from app.planning.routing import Router
from app.planning.track import Track
from app.planning.traffic import Traffic
from app.plant.fab import SIZES, generate
from tests.bench.measuring import Row

VEHICLES, EVENTS, AHEAD = 400, 40_000, 6


class Drivers:
    """Vehicles that hold up to six barcodes ahead, each event one of them, in turn."""

    def __init__(self, track: Track) -> None:
        self._draw = random.Random(1)
        self._router = Router(track)
        self._barcodes = sorted(track.graph)
        self.traffic = Traffic(track, admission=True)
        self.granted = 0
        self.names = [VehicleId(f"V{number:04}") for number in range(VEHICLES)]
        self._held: list[list[Barcode]] = []
        self._rest: list[list[Barcode]] = []
        places = [b for b in self._barcodes if self.traffic.queues is not None and self.traffic.may_end(b)]
        for name, place in zip(self.names, self._draw.sample(places, VEHICLES), strict=True):
            self.traffic.hold(name, [place])
            self._held.append([place])
            self._rest.append([])
        for number in range(VEHICLES):
            self._plan(number)

    def _plan(self, number: int) -> None:
        goal = self._draw.choice(self._barcodes)
        self._rest[number] = self._router.route(self._held[number][-1], goal)[1:]

    def prepare(self, number: int) -> None:
        """Find a new goal for a vehicle that is at its own; not part of what is measured."""
        if not self._rest[number]:
            self._plan(number)

    def event(self, number: int) -> None:
        """A vehicle reads the next barcode: it claims up to six ahead, and gives back the one behind."""
        name, held, rest = self.names[number], self._held[number], self._rest[number]
        if len(held) > 1:
            self.traffic.release(name, (held.pop(0),))
            self.traffic.waiters(())
        count = max(1, AHEAD + 1 - len(held))
        while count < len(rest) and not self.traffic.may_end(rest[count - 1]):
            count += 1
        wanted = rest[:count]
        granted = self.traffic.claim(name, wanted, len(wanted) == len(rest), beyond=rest, begun=len(wanted)).granted
        held += granted
        del rest[: len(granted)]
        self.granted += len(granted)

    def nothing(self, number: int) -> None:
        """Do nothing, for the floor."""


def timed(drivers: Drivers, act: Callable[[int], None]) -> list[int]:
    """Return the nanoseconds of each event, in order of size."""
    found = []
    for event in range(EVENTS):
        number = event % VEHICLES
        drivers.prepare(number)
        began = time.thread_time_ns()
        act(number)
        found.append(time.thread_time_ns() - began)
    return sorted(found)


def rows() -> Iterator[Row]:
    """Measure events of traffic with all its rules, and the same loop without them."""
    drivers = Drivers(Track(generate(SIZES["10k"], 1).plant))
    gc.collect()
    gc.freeze()
    empty = timed(drivers, drivers.nothing)
    ours = timed(drivers, drivers.event)
    mean, floor = sum(ours) / EVENTS / 1000, sum(empty) / EVENTS / 1000
    p99 = ours[EVENTS * 99 // 100] / 1000
    yield Row(
        f"one event of traffic (claim, release), {VEHICLES} vehicles on the 10k fab; floor: an empty loop over the same events",
        mean, floor, None, "µs CPU/event", None,
        note=f"p99 {p99:.1f} µs; {1e6 / mean:,.0f} events/s; {drivers.granted / EVENTS:.2f} barcodes granted at each",
    )  # fmt: skip
