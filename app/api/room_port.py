"""What the API needs of the store for the control room."""

from collections.abc import Collection, Sequence
from typing import Protocol

from app.domain.alarms import Alarm, AlarmCount
from app.domain.closures import Closure
from app.domain.records import HistoryEvent
from app.domain.statistics import OpenJob, Queued, Transfer, Waited
from app.domain.walks import Walk, WalkPlace


class RoomReader(Protocol):
    """Committed history of the control room; blocking, called from the thread pool. Raises StoreError."""

    def closure(self, number: int) -> Closure | None:
        """Return one closure."""
        ...

    def closures(self, after: int | None = None, limit: int = 100) -> Sequence[Closure]:
        """Return closures numbered below ``after``, newest first."""
        ...

    def alarm(self, number: int) -> Alarm | None:
        """Return one alarm."""
        ...

    def alarms(
        self,
        *,
        kind: str | None = None,
        source: str | None = None,
        code: str | None = None,
        active: bool | None = None,
        acknowledged: bool | None = None,
        begin: float | None = None,
        end: float | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> Sequence[Alarm]:
        """Return alarms numbered below ``after``, newest first."""
        ...

    def alarm_counts(self, by: tuple[str, ...], begin: float, end: float, limit: int = 100) -> Sequence[AlarmCount]:
        """Return how often and how long each was there between two moments, the longest first."""
        ...

    def failures(self, begin: float, end: float) -> Sequence[tuple[str, float, float | None]]:
        """Return vehicle, begin and end of each failure between two moments, in order of begin."""
        ...

    def walk(self, number: int) -> Walk | None:
        """Return one audit walk."""
        ...

    def walks(self, after: int | None = None, limit: int = 100) -> Sequence[Walk]:
        """Return audit walks numbered below ``after``, newest first."""
        ...

    def walk_places(self, number: int) -> Sequence[WalkPlace]:
        """Return the places of an audit walk, by station."""
        ...

    def first_event(self, moment: float) -> int:
        """Return the number of the first event that is not before a moment."""
        ...

    def happened(
        self,
        begin: float,
        end: float,
        *,
        named: Collection[str] | None = None,
        job: str | None = None,
        vehicle: str | None = None,
        newest: bool = False,
        limit: int = 100,
    ) -> Sequence[HistoryEvent]:
        """Return events of a period, oldest first: the first of them, or the newest. ``named``: only such."""
        ...

    def event_count(self, begin: float, end: float) -> int:
        """Return how many events lie between two moments."""
        ...

    def transfers(self, begin: float, end: float) -> Sequence[Transfer]:
        """Return the transfers that ended between two moments, in order of acceptance."""
        ...

    def queued(self, begin: float, end: float) -> Sequence[Queued]:
        """Return the jobs that may have waited for a vehicle between two moments."""
        ...

    def waits(self, begin: float, end: float) -> tuple[Sequence[Waited], int]:
        """Return the waits of the newest jobs accepted between two moments, and of how many jobs they are."""
        ...

    def waits_named(self, names: Collection[str]) -> Sequence[Waited]:
        """Return the waits of the named jobs, in order of acceptance."""
        ...

    def open_jobs(self, moment: float) -> Sequence[OpenJob]:
        """Return the jobs that had been accepted before a moment and had not ended by then, the oldest first."""
        ...
