"""The reading side of statistics: what ended in a period, put together by the database."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Collection
from typing import Any, TypeVar

import sqlalchemy as sa

from app.domain.job import TERMINAL, JobEvent
from app.domain.records import HistoryEvent
from app.domain.statistics import MARKS, OpenJob, Queued, Transfer, Waited
from app.store import rows
from app.store.columns import Found
from app.store.tables import events, going_on, job_whys, jobs
from app.store.teaching_reading import where

T = TypeVar("T")
BEFORE = 86_400.0
"""Seconds before a period in which the events of jobs that end in it are looked for (our choice)."""
WAITS_OF = 20_000
"""Waits are counted of so many jobs at most, the newest (our choice)."""
OPEN = 1000
"""So many jobs that are open at the end of a period are named, the oldest (our choice)."""

ENDS = (
    JobEvent.TRANSFER_COMPLETED,
    JobEvent.TRANSFER_CANCEL_COMPLETED,
    JobEvent.TRANSFER_ABORT_COMPLETED,
)


class StatisticsReader(ABC):
    """Questions about periods; times are UTC seconds. Every method raises StoreError if the database cannot be read."""

    @abstractmethod
    def _list(self, query: sa.Select[Any], made: Callable[[Found], T]) -> list[T]: ...

    def first_event(self, moment: float) -> int:
        """Return the number of the first event that is not before a moment, one above the last if none is."""
        return self._first_since(events.c.seq, moment)

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
    ) -> list[HistoryEvent]:
        """Return events of a period, oldest first: the first of them, or the newest. ``named``: only such."""
        first, last = self._first_since(events.c.seq, begin), self._first_since(events.c.seq, end)
        query = where(sa.select(events), {events.c.job: job, events.c.vehicle: vehicle})
        query = query.where(events.c.seq >= first, events.c.seq < last)
        if named is not None:
            query = query.where(events.c.event.in_(sorted(named)))
        found = self._list(query.order_by(events.c.seq.desc() if newest else events.c.seq).limit(limit), rows.event)
        return found[::-1] if newest else found

    def event_count(self, begin: float, end: float) -> int:
        """Return how many events lie between two moments."""
        return self._first_since(events.c.seq, end) - self._first_since(events.c.seq, begin)

    def transfers(self, begin: float, end: float) -> list[Transfer]:
        """Return the transfers that ended between two moments, in order of acceptance."""
        first, last = self._first_since(events.c.seq, begin - BEFORE), self._first_since(events.c.seq, end)
        e, j = events.c, jobs.c
        moments = [sa.func.max(sa.case((e.event == mark.value, e.at))).label(name) for name, mark in MARKS.items()]
        ended = sa.func.max(sa.case((e.event.in_([name.value for name in ENDS]), e.at)))
        wanted = [*(mark.value for mark in MARKS.values()), *(name.value for name in ENDS)]
        marked = (
            sa.select(e.job, ended.label("over"), *moments)
            .where(e.seq >= first, e.seq < last, e.event.in_(wanted), e.job.is_not(None))
            .group_by(e.job)
            .having(ended >= begin, ended < end)
            .subquery()
        )
        query = sa.select(jobs, *(marked.c[name].label(f"mark_{name}") for name in MARKS), marked.c.over)
        query = query.join(marked, j.id == marked.c.job).where(j.state.in_(sorted(TERMINAL))).order_by(j.number)
        return self._list(query, _transfer)

    def queued(self, begin: float, end: float) -> list[Queued]:
        """Return the jobs that may have waited for a vehicle between two moments."""
        j = jobs.c
        first, last = self._first_since(j.number, begin - BEFORE), self._first_since(j.number, end)
        until = sa.func.coalesce(j.assigned, j.ended).label("until")
        columns: list[sa.ColumnElement[Any]] = [j.created, until]
        query = sa.select(*columns).where(j.number >= first, j.number < last)
        return self._list(query.where(sa.or_(until.is_(None), until > begin)), lambda r: Queued(r.created, r.until))

    def waits(self, begin: float, end: float) -> tuple[list[Waited], int]:
        """Return the waits of the newest jobs accepted between two moments, and of how many jobs they are."""
        j = jobs.c
        first, last = self._first_since(j.number, begin), self._first_since(j.number, end)
        w = job_whys.c
        query = sa.select(w.job, w.waits).where(w.number >= first, w.number < last)
        found = self._list(query.order_by(w.number.desc()).limit(WAITS_OF), _waited)
        return [wait for one in found for wait in one], len(found)

    def waits_named(self, names: Collection[str]) -> list[Waited]:
        """Return the waits of the named jobs, in order of acceptance."""
        w = job_whys.c
        query = sa.select(w.job, w.waits).join(jobs, jobs.c.number == w.number).where(jobs.c.id.in_(sorted(names)))
        return [wait for one in self._list(query.order_by(w.number), _waited) for wait in one]

    def open_jobs(self, moment: float) -> list[OpenJob]:
        """Return the jobs that had been accepted before a moment and had not ended by then, the oldest first, ``OPEN`` at most.

        One that has ended since is known if it was accepted within the day before the moment.
        """
        j = jobs.c
        first, last = self._first_since(j.number, moment - BEFORE), self._first_since(j.number, moment)
        columns = (j.id, j.carrier, j.source, j.destination, j.priority, j.created, job_whys.c.waits)
        query = sa.select(*columns).join(job_whys, job_whys.c.number == j.number, isouter=True)
        query = query.where(j.number < last).order_by(j.number).limit(OPEN)

        def made(row: Found) -> OpenJob:
            waits = ((since, reason, until) for since, reason, until in row.waits or ())
            now = [why for since, why, until in waits if since < moment and (until is None or until >= moment)]
            reason = now[-1] if now else ""
            return OpenJob(row.id, row.carrier, row.source, row.destination, row.priority, row.created, reason)

        # Two questions, so that the index of what is going on serves the first.
        ended_since = self._list(query.where(j.number >= first, j.ended >= moment), made)
        found = [*self._list(query.where(going_on), made), *ended_since]
        return sorted(found, key=lambda one: one.created)[:OPEN]

    def _first_since(self, number: sa.Column[int], moment: float) -> int:
        """Return the first number of a row that is not before a moment, one above the last if none is.

        Numbers rise with time, and no index has the time: about twenty look-ups by number.
        """
        at = events.c.at if number is events.c.seq else jobs.c.created
        ends: list[sa.ColumnElement[Any]] = [sa.func.min(number).label("low"), sa.func.max(number).label("high")]
        bounds = self._list(sa.select(*ends), lambda row: row)
        low, high = bounds[0].low or 0, (bounds[0].high or 0) + 1
        while low < high:
            middle = (low + high) // 2
            both: list[sa.ColumnElement[Any]] = [number.label("number"), at.label("at")]
            query = sa.select(*both).where(number >= middle, number < high)
            found = self._list(query.order_by(number).limit(1), lambda row: (row.number, row.at))
            if not found or found[0][1] >= moment:
                high = middle
            else:
                low = found[0][0] + 1
        return low


def _waited(row: Found) -> list[Waited]:
    return [Waited(since, until, reason, row.job) for since, reason, until in row.waits]


def _transfer(row: Found) -> Transfer:
    return Transfer(
        job=row.id,
        state=row.state,
        carrier=row.carrier,
        source=row.source,
        destination=row.destination,
        priority=row.priority,
        vehicle=row.vehicle,
        created=row.created,
        assigned=row.mark_assigned,
        acquire_started=row.mark_acquire_started,
        acquired=row.mark_acquired,
        deposit_started=row.mark_deposit_started,
        deposited=row.mark_deposited,
        ended=row.over,
    )
