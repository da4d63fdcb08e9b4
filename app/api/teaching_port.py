"""What the API needs of the store about teaching."""

from collections.abc import Sequence
from typing import Protocol

from app.domain.ids import StationId, VehicleId
from app.domain.records import StationDest, TeachingEvent, VehicleOffset
from app.domain.teaching import Proposal, TeachingSession


class TeachingReader(Protocol):
    """Committed teaching; blocking, called from the thread pool. Raises StoreError."""

    def dests(self, station: StationId) -> Sequence[StationDest]:
        """Return all versions of a station's DEST, oldest first."""
        ...

    def offsets(self, vehicle: VehicleId) -> Sequence[VehicleOffset]:
        """Return all versions of a vehicle's OFFSET, oldest first."""
        ...

    def all_dests(self, *, history: bool = False) -> Sequence[StationDest]:
        """Return the newest DEST of every station, or every version."""
        ...

    def all_offsets(self, *, history: bool = False) -> Sequence[VehicleOffset]:
        """Return the newest OFFSET of every vehicle, or every version."""
        ...

    def taught(
        self, after: int = 0, limit: int = 100, *, vehicle: str | None = None, barcode: str | None = None
    ) -> Sequence[TeachingEvent]:
        """Return raw events numbered above ``after``, oldest first."""
        ...

    def proposals(
        self,
        *,
        state: str | None = None,
        station: str | None = None,
        vehicle: str | None = None,
        session: int | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> Sequence[Proposal]:
        """Return proposals, newest first, with numbers below ``after``."""
        ...

    def proposal(self, number: int) -> Proposal | None:
        """Return one proposal."""
        ...

    def sessions(
        self,
        *,
        state: str | None = None,
        station: str | None = None,
        vehicle: str | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> Sequence[TeachingSession]:
        """Return sessions, newest first, with numbers below ``after``."""
        ...

    def session(self, number: int) -> TeachingSession | None:
        """Return one session."""
        ...
