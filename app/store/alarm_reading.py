"""The reading side of alarms: lists, counts, and how reliable vehicles are."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, TypeVar

import sqlalchemy as sa

from app.domain.alarms import FAILURES, Alarm, AlarmCount
from app.store import alarm_rows
from app.store.columns import Found
from app.store.tables import alarms
from app.store.teaching_reading import where

T = TypeVar("T")


class AlarmReader(ABC):
    """Questions about alarms. Times are UTC seconds. Every method raises StoreError if the database cannot be read."""

    @abstractmethod
    def _list(self, query: sa.Select[Any], made: Callable[[Found], T]) -> list[T]: ...

    def alarm(self, number: int) -> Alarm | None:
        """Return one alarm, ended or not."""
        return next(iter(self._list(sa.select(alarms).where(alarms.c.number == number), alarm_rows.alarm)), None)

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
    ) -> list[Alarm]:
        """Return alarms, newest first; ``after`` is the number of the last one seen.

        ``begin`` and ``end``: those that were there at some moment between the two.
        """
        c = alarms.c
        query = where(sa.select(alarms), {c.kind: kind, c.source: source, c.code: code})
        if active is not None:
            query = query.where(c.ended.is_(None) if active else c.ended.is_not(None))
        if acknowledged is not None:
            query = query.where(c.acknowledged.is_not(None) if acknowledged else c.acknowledged.is_(None))
        if after is not None:
            query = query.where(c.number < after)
        query = _between(query, begin, end)
        return self._list(query.order_by(c.number.desc()).limit(limit), alarm_rows.alarm)

    def alarm_counts(self, by: tuple[str, ...], begin: float, end: float, limit: int = 100) -> list[AlarmCount]:
        """Return how often and how long each was there between two moments, the longest first.

        ``by``: columns (``kind``, ``source``, ``code``) that are told apart.
        """
        c = alarms.c
        first = sa.case((c.begun < begin, begin), else_=c.begun)
        last = sa.case((c.ended.is_(None), end), (c.ended > end, end), else_=c.ended)
        seconds = sa.func.sum(last - first).label("seconds")
        groups = [c[name] for name in by]
        query: sa.Select[Any] = sa.select(
            *groups, sa.func.count().label("times"), seconds, sa.func.max(c.begun).label("newest")
        ).group_by(*groups)
        query = _between(query, begin, end).order_by(seconds.desc(), *groups).limit(limit)
        return self._list(
            query,
            lambda row: AlarmCount(
                {name: getattr(row, name) for name in by}, row.times, float(row.seconds), float(row.newest)
            ),
        )

    def failures(self, begin: float, end: float) -> list[tuple[str, float, float | None]]:
        """Return vehicle, begin and end of each failure between two moments, in order of begin."""
        c = alarms.c
        query = sa.select(c.source, c.begun, c.ended).where(c.kind.in_([kind.value for kind in FAILURES]))
        return self._list(_between(query, begin, end).order_by(c.begun), lambda row: (row.source, row.begun, row.ended))


def _between(query: sa.Select[Any], begin: float | None, end: float | None) -> sa.Select[Any]:
    if begin is not None:
        query = query.where(sa.or_(alarms.c.ended.is_(None), alarms.c.ended >= begin))
    return query if end is None else query.where(alarms.c.begun < end)
