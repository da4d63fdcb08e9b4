"""Virtual time: one heap for everything that will happen in a world."""

import heapq
from collections.abc import Callable
from itertools import count

from app.domain.ports import Endpoint
from app.domain.units import Seconds

MOST_AT_ONCE = 100_000
"""Acts at one instant, after which time stands still by mistake. Our choice."""


class Standstill(RuntimeError):
    """Something wants to act again and again without time passing: a defect."""


class Agenda:
    """Acts in order of time; those of one instant in the order in which they were entered."""

    def __init__(self) -> None:
        self.now = Seconds(0.0)
        self._heap: list[tuple[float, int, Callable[[], None]]] = []
        self._order = count()

    def at(self, when: float, act: Callable[[], None]) -> None:
        """Enter an act; one in the past happens next."""
        heapq.heappush(self._heap, (max(when, self.now), next(self._order), act))

    def after(self, seconds: float, act: Callable[[], None]) -> None:
        """Enter an act some seconds from now."""
        self.at(self.now + seconds, act)

    def step(self, until: float) -> bool:
        """Let the next act happen if it is due by then; otherwise bring time there and return False."""
        if not self._heap or self._heap[0][0] > until:
            self.now = Seconds(max(self.now, until))
            return False
        when, _, act = heapq.heappop(self._heap)
        self.now = Seconds(when)
        act()
        return True

    def run(self, until: float) -> None:
        """Let everything happen that is due by then. Raises Standstill."""
        instant, acts = self.now, 0
        while self.step(until):
            if self.now > instant:
                instant, acts = self.now, 0
            acts += 1
            if acts > MOST_AT_ONCE:
                raise Standstill(f"more than {MOST_AT_ONCE} acts at {instant} s")


class Watchdog:
    """Ticks one endpoint at its deadlines. A deadline that moves back costs nothing: the entry fires early and looks again."""

    __slots__ = ("_after", "_agenda", "_armed", "_live", "_of")

    def __init__(self, agenda: Agenda, of: Endpoint, after: Callable[[], None]) -> None:
        self._agenda = agenda
        self._of = of
        self._after = after
        self._armed: float | None = None
        self._live = True

    def rearm(self) -> None:
        """Look at the deadline; call after each input to the endpoint."""
        deadline = self._of.deadline
        if deadline is not None and (self._armed is None or deadline < self._armed):
            self._armed = deadline
            self._agenda.at(deadline, lambda: self._fire(deadline))

    def stop(self) -> None:
        """Tick no more."""
        self._live = False

    def _fire(self, armed: float) -> None:
        if not self._live or self._armed != armed:
            return
        self._armed = None
        deadline = self._of.deadline
        if deadline is not None and deadline <= self._agenda.now:
            self._of.tick(self._agenda.now)
            self._after()
        self.rearm()
