"""The reading side of the control room: closures, audit walks."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, TypeVar

import sqlalchemy as sa

from app.domain.closures import Closure
from app.domain.walks import Walk, WalkPlace
from app.store import closure_rows, walk_rows
from app.store.columns import Found
from app.store.tables import closures, walk_places, walks

T = TypeVar("T")


class RoomReader(ABC):
    """Questions of the control room. Every method raises StoreError if the database cannot be read."""

    @abstractmethod
    def _list(self, query: sa.Select[Any], made: Callable[[Found], T]) -> list[T]: ...

    def closure(self, number: int) -> Closure | None:
        """Return one closure, over or not."""
        query = sa.select(closures).where(closures.c.number == number)
        return next(iter(self._list(query, closure_rows.closure)), None)

    def closures(self, after: int | None = None, limit: int = 100) -> list[Closure]:
        """Return closures, newest first; ``after`` is the number of the last one seen."""
        query = sa.select(closures).order_by(closures.c.number.desc()).limit(limit)
        if after is not None:
            query = query.where(closures.c.number < after)
        return self._list(query, closure_rows.closure)

    def walk(self, number: int) -> Walk | None:
        """Return one audit walk, ended or not."""
        return next(iter(self._list(sa.select(walks).where(walks.c.number == number), walk_rows.walk)), None)

    def walks(self, after: int | None = None, limit: int = 100) -> list[Walk]:
        """Return audit walks, newest first; ``after`` is the number of the last one seen."""
        query = sa.select(walks).order_by(walks.c.number.desc()).limit(limit)
        return self._list(query if after is None else query.where(walks.c.number < after), walk_rows.walk)

    def walk_places(self, number: int) -> list[WalkPlace]:
        """Return the places of an audit walk, by station."""
        query = sa.select(walk_places).where(walk_places.c.walk == number).order_by(walk_places.c.station)
        return self._list(query, walk_rows.walk_place)
