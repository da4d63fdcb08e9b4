"""What will happen to a simulated device, in order of time: its only clock."""

import heapq
from collections.abc import Callable
from itertools import count


class Due:
    """One thing on an agenda; ``cancel`` takes it off."""

    __slots__ = ("_act",)

    def __init__(self, act: Callable[[], None]) -> None:
        self._act: Callable[[], None] | None = act

    @property
    def cancelled(self) -> bool:
        """Whether nothing will happen any more."""
        return self._act is None

    def cancel(self) -> None:
        """Take it off; harmless if it has happened."""
        self._act = None

    def act(self) -> None:
        """Do it, once."""
        act, self._act = self._act, None
        if act is not None:
            act()


class Agenda:
    """A heap of times and acts; acts of the same instant happen in the order in which they were entered.

    ``now`` is the time of the act under way, so that what follows from an act is timed from the act itself and not from
    when the owner got round to it.
    """

    __slots__ = ("_heap", "_order", "now")

    def __init__(self) -> None:
        self.now = 0.0
        self._heap: list[tuple[float, int, Due]] = []
        self._order = count()

    @property
    def deadline(self) -> float | None:
        """When the next act is due; None if there is none."""
        while self._heap and self._heap[0][2].cancelled:
            heapq.heappop(self._heap)
        return self._heap[0][0] if self._heap else None

    def after(self, seconds: float, act: Callable[[], None]) -> Due:
        """Enter an act some seconds from now."""
        due = Due(act)
        heapq.heappush(self._heap, (self.now + seconds, next(self._order), due))
        return due

    def run(self, until: float) -> None:
        """Let everything happen that is due, and bring ``now`` to ``until``; a clock that went back is ignored."""
        while (when := self.deadline) is not None and when <= until:
            due = heapq.heappop(self._heap)[2]
            self.now = max(self.now, when)
            due.act()
        self.now = max(self.now, until)

    def clear(self) -> None:
        """Forget everything that was to happen."""
        for _, _, due in self._heap:
            due.cancel()
        self._heap.clear()
