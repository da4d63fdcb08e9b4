"""How often somebody may ask: a bucket of requests each, refilled all the time."""

from collections.abc import Callable, Hashable

ROOM = 10_000
"""Most callers that are counted at a time; then those whose bucket is full are forgotten. Our choice."""


class Rates:
    """``rate`` requests a second for each caller, and ``burst`` at once. ``now`` gives monotonic seconds."""

    def __init__(self, rate: float, burst: float, now: Callable[[], float]) -> None:
        self._rate, self._burst, self._now = rate, burst, now
        self._left: dict[Hashable, tuple[float, float]] = {}

    def wait(self, caller: Hashable) -> float:
        """Take one request; return 0, or the seconds after which there is room for one more."""
        now = self._now()
        left, since = self._left.get(caller, (self._burst, now))
        left = min(self._burst, left + (now - since) * self._rate)
        if left < 1.0:
            return (1.0 - left) / self._rate
        if len(self._left) >= ROOM and caller not in self._left:
            self._forget(now)
        self._left[caller] = (left - 1.0, now)
        return 0.0

    def _forget(self, now: float) -> None:
        """Forget the callers whose bucket is full again, or all, if none is: nobody is refused for lack of room."""
        full = self._burst / self._rate
        kept = {caller: bucket for caller, bucket in self._left.items() if now - bucket[1] < full}
        self._left = kept if len(kept) < ROOM else {}
