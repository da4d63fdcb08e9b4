"""What the API needs of the store for the control room."""

from collections.abc import Sequence
from typing import Protocol

from app.domain.closures import Closure


class RoomReader(Protocol):
    """Committed history of the control room; blocking, called from the thread pool. Raises StoreError."""

    def closure(self, number: int) -> Closure | None:
        """Return one closure."""
        ...

    def closures(self, after: int | None = None, limit: int = 100) -> Sequence[Closure]:
        """Return closures numbered below ``after``, newest first."""
        ...
