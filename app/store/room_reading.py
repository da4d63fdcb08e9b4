"""The reading side of the control room: closures."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, TypeVar

import sqlalchemy as sa

from app.domain.closures import Closure
from app.store import closure_rows
from app.store.columns import Found
from app.store.tables import closures

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
