"""Breakdowns and closures in the fast plant: what stands still for a while, and whom it cuts off."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from heapq import heappop, heappush
from itertools import count
from random import Random

import numpy as np

from app.sim.kinematic.events import fail, repair, think_again
from app.sim.kinematic.fab import Fab
from app.sim.kinematic.state import BROKEN, DWELLING
from app.sim.kinematic.waiting import ask_again

SHUT = 1e6
"""Seconds that a way costs over track that nobody may enter: driven only by whom no other way leads out. Our choice."""
LEAST, MOST = 60.0, 300.0
"""Seconds that a breakdown or a closure lasts. Our choice."""
CYCLE, STORM = 1800.0, 600.0
"""Events come in the first ``STORM`` seconds of each ``CYCLE``: thrice as thick as evenly spread, and then all is well for long
enough to see what comes back. Our choice."""


@dataclass(frozen=True, slots=True)
class Event:
    """Something that stood still. ``what`` is a vehicle ("V17") or a barcode; ``cut_off`` the ports without another way."""

    at: float
    ends: float
    what: str
    vehicle: int
    barcode: int
    cut_off: tuple[str, ...] = ()


class Drill:
    """Lets vehicles break down and barcodes be closed at random moments, and takes both back after a while.

    Half of the events are breakdowns of vehicles on the track, half are closures of barcodes that nobody holds just then.
    They come in storms (``CYCLE``); ``per_hour`` is their mean.
    """

    def __init__(self, fab: Fab, per_hour: float, seed: int) -> None:
        self.fab = fab
        self.events: list[Event] = []
        self.began = fab.now
        self._per_hour, self._dice = per_hour, Random(f"{seed}/drill")
        self._moments = self._storms()
        self._next = next(self._moments)
        self._ends: list[tuple[float, int]] = []

    def run(self, seconds: float) -> None:
        """Let time pass, second by second, with what happens in it."""
        end = self.fab.now + seconds
        while self.fab.now < end:
            self._end_what_is_over()
            while self._next <= self.fab.now:
                self._next = next(self._moments)
                self._begin()
            self.fab.run(1.0)

    def stop(self) -> None:
        """End all that stands still now."""
        self._ends = [(self.fab.now, i) for _, i in self._ends]
        self._end_what_is_over()

    def _storms(self) -> Iterator[float]:
        """Give the moments of the events, one after the other, without end."""
        for cycle in count():
            moments = (self._dice.uniform(0.0, STORM) for _ in range(max(1, round(self._per_hour * CYCLE / 3600))))
            yield from sorted(self.began + cycle * CYCLE + moment for moment in moments)

    def _begin(self) -> None:
        s, now = self.fab.state, self.fab.now
        ends = now + self._dice.uniform(LEAST, MOST)
        if self._dice.random() < 0.5:
            able = np.flatnonzero((s.doing != DWELLING) & (s.doing != BROKEN) & (s.failed == 0))
            if not len(able):
                return
            vehicle = int(self._dice.choice(able.tolist()))
            fail(s, vehicle)
            barcode, what = int(s.ahead[vehicle, 0] if s.granted[vehicle] else s.at[vehicle]), f"V{vehicle}"
        else:
            vehicle, barcode = -1, int(self._dice.choice(np.flatnonzero((s.owner < 0) & (s.closed == 0)).tolist()))
            s.closed[barcode], what = 1, str(self.fab.map.names[barcode])
        heappush(self._ends, (ends, len(self.events)))
        self.events.append(Event(now, ends, what, vehicle, barcode))
        before = self.fab.cut_off
        self._go_round()
        names = tuple(str(self.fab.map.names[port]) for port in sorted(self.fab.cut_off - before))
        self.events[-1] = replace(self.events[-1], cut_off=names)

    def _end_what_is_over(self) -> None:
        s, ended = self.fab.state, False
        while self._ends and self._ends[0][0] <= self.fab.now:
            event = self.events[heappop(self._ends)[1]]
            ended = True
            if event.vehicle >= 0:
                repair(s, event.vehicle)
                continue
            s.closed[event.barcode] = 0
            waiting = s.waits_first[event.barcode]
            while waiting >= 0:
                ask_again(s, waiting)
                waiting = s.waits_next[waiting]
        if ended:
            self._go_round()

    def _go_round(self) -> None:
        """Let ways keep off whatever stands still now, also the ways of those that wait already."""
        shut = [self.events[i].barcode for _, i in self._ends]
        self.fab.shut = {int(self.fab.net.buffer[barcode]): SHUT for barcode in shut}
        self.fab.cut_off = frozenset(self._behind(shut))
        self.fab.weigh()
        self.fab.set_aside()
        for vehicle in range(len(self.fab.state.at)):
            think_again(self.fab.state, vehicle)

    def _behind(self, shut: list[int]) -> Iterable[int]:
        """Return the ports that no way leads to from where most traffic is, unless over one of these barcodes."""
        net, ports = self.fab.net, self.fab.ports.barcodes
        ends: dict[int, int] = {}
        for barcode in shut:
            buffer = int(net.buffer[barcode])
            ends[buffer] = min(barcode, ends.get(buffer, barcode))
        start = next(int(b) for b in np.argsort(-self.fab.state.passes, kind="stable") if int(b) not in ends)
        reached, queue = {start}, [start]
        while queue:
            here = queue.pop()
            if here in ends:
                continue
            for after in net.next_to[net.next_at[here] : net.next_at[here + 1]].tolist():
                if after not in reached:
                    reached.add(after)
                    queue.append(after)
        for port in ports:
            buffer = int(net.buffer[port])
            if buffer not in reached or port >= ends.get(buffer, port + 1):
                yield port
