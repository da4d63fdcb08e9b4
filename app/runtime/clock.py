"""The only reader of clocks: everything below takes ``now`` as an argument."""

import time
from collections.abc import Callable
from typing import cast

from app.domain.units import Seconds, Timestamp

_MONOTONIC = cast(Callable[[], Seconds], time.monotonic)
"""Made once: to write the type down takes longer than to look at the clock ten times."""


class Clock:
    """Monotonic time for deadlines, UTC for records and people.

    UTC is read once and carried on by the monotonic clock, so that a step of the wall clock never reorders records. A step is
    followed within ``RESYNC`` seconds.
    """

    RESYNC = 60.0
    """Our choice."""

    __slots__ = ("_offset", "_synced")

    def __init__(self) -> None:
        self._offset = 0.0
        self._synced = float("-inf")

    @property
    def now(self) -> Callable[[], Seconds]:
        """What gives monotonic seconds since an arbitrary start: the system's own function, since each packet asks for it."""
        return _MONOTONIC

    def utc(self) -> Timestamp:
        """Return seconds since 1970-01-01T00:00:00Z."""
        now = time.monotonic()
        if now - self._synced >= self.RESYNC:
            self._offset = time.time() - now
            self._synced = now
        return Timestamp(now + self._offset)
