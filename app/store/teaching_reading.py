"""The reading side of teaching: versions, raw events, proposals, sessions."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, TypeVar

import sqlalchemy as sa

from app.domain.ids import StationId, VehicleId
from app.domain.records import StationDest, TeachingEvent, VehicleOffset
from app.domain.teaching import Proposal, TeachingSession
from app.store import teaching
from app.store.columns import Found
from app.store.tables import (
    station_dests,
    teaching_events,
    teaching_proposals,
    teaching_sessions,
    vehicle_offsets,
)

T = TypeVar("T")


def where(query: sa.Select[Any], wanted: dict[sa.Column[Any], str | int | None]) -> sa.Select[Any]:
    """Return the query with the conditions that are given."""
    for column, value in wanted.items():
        if value is not None:
            query = query.where(column == value)
    return query


class TeachingReader(ABC):
    """Questions about teaching. Every method raises StoreError if the database cannot be read."""

    @abstractmethod
    def _list(self, query: sa.Select[Any], made: Callable[[Found], T]) -> list[T]: ...

    def dests(self, station: StationId) -> list[StationDest]:
        """Return every version of a station's DEST, oldest first."""
        query = sa.select(station_dests).where(station_dests.c.station == station)
        return self._list(query.order_by(station_dests.c.version), teaching.dest)

    def offsets(self, vehicle: VehicleId) -> list[VehicleOffset]:
        """Return every version of a vehicle's OFFSET, oldest first."""
        query = sa.select(vehicle_offsets).where(vehicle_offsets.c.vehicle == vehicle)
        return self._list(query.order_by(vehicle_offsets.c.version), teaching.offset)

    def all_dests(self, *, history: bool = False) -> list[StationDest]:
        """Return the newest DEST of every station, by name; with ``history`` every version, oldest first."""
        return self._list(_versions(station_dests, history=history), teaching.dest)

    def all_offsets(self, *, history: bool = False) -> list[VehicleOffset]:
        """Return the newest OFFSET of every vehicle, by name; with ``history`` every version, oldest first."""
        return self._list(_versions(vehicle_offsets, history=history), teaching.offset)

    def taught(
        self, after: int = 0, limit: int = 100, *, vehicle: str | None = None, barcode: str | None = None
    ) -> list[TeachingEvent]:
        """Return raw teaching events numbered above ``after``, oldest first."""
        events = teaching_events.c
        query = where(sa.select(teaching_events), {events.vehicle: vehicle, events.barcode: barcode})
        return self._list(query.where(events.seq > after).order_by(events.seq).limit(limit), teaching.event)

    def proposals(
        self,
        *,
        state: str | None = None,
        station: str | None = None,
        vehicle: str | None = None,
        session: int | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> list[Proposal]:
        """Return proposals, newest first; ``after`` is the number of the last one seen."""
        table = teaching_proposals
        wanted = {table.c.state: state, table.c.station: station, table.c.vehicle: vehicle, table.c.session: session}
        return self._list(_page(table, wanted, after, limit), teaching.proposal)

    def proposal(self, number: int) -> Proposal | None:
        """Return one proposal."""
        query = sa.select(teaching_proposals).where(teaching_proposals.c.number == number)
        return next(iter(self._list(query, teaching.proposal)), None)

    def sessions(
        self,
        *,
        state: str | None = None,
        station: str | None = None,
        vehicle: str | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> list[TeachingSession]:
        """Return teaching sessions, newest first; ``after`` is the number of the last one seen."""
        table = teaching_sessions
        wanted: dict[sa.Column[Any], str | int | None] = {
            table.c.state: state,
            table.c.station: station,
            table.c.vehicle: vehicle,
        }
        return self._list(_page(table, wanted, after, limit), teaching.session)

    def session(self, number: int) -> TeachingSession | None:
        """Return one session."""
        query = sa.select(teaching_sessions).where(teaching_sessions.c.number == number)
        return next(iter(self._list(query, teaching.session)), None)


def _page(
    table: sa.Table, wanted: dict[sa.Column[Any], str | int | None], after: int | None, limit: int
) -> sa.Select[Any]:
    query = where(sa.select(table), wanted)
    if after is not None:
        query = query.where(table.c.number < after)
    return query.order_by(table.c.number.desc()).limit(limit)


def _versions(table: sa.Table, *, history: bool) -> sa.Select[Any]:
    owner = next(iter(table.c))
    query = sa.select(table).order_by(owner, table.c.version)
    if history:
        return query
    last = sa.select(owner, sa.func.max(table.c.version).label("version")).group_by(owner).subquery()
    return query.join(last, sa.and_(owner == last.c[owner.name], table.c.version == last.c.version))
