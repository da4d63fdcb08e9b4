"""A batch of records as few statements: compiled once per dialect, one executemany per table."""

from collections.abc import Iterator, Sequence

import sqlalchemy as sa
from sqlalchemy.dialects import postgresql, sqlite

from app.domain.errors import StoreRefused
from app.domain.job import Job
from app.domain.records import (
    AuditRow,
    CarrierGone,
    CarrierRecord,
    ControllerRecord,
    DeviceRecord,
    HistoryEvent,
    Intent,
    Record,
    StationDest,
    StationRecord,
    TeachingEvent,
    VehicleOffset,
    VehicleRecord,
)
from app.store import tables
from app.store.rows import ROW_OF, Row

REPLACED: dict[type, sa.Table] = {
    Job: tables.jobs,
    Intent: tables.intents,
    VehicleRecord: tables.vehicles,
    StationRecord: tables.stations,
    CarrierRecord: tables.carriers,
    ControllerRecord: tables.controller,
    DeviceRecord: tables.devices,
}
"""A record replaces the row of its key, the first column."""

APPENDED: dict[type, sa.Table] = {
    HistoryEvent: tables.events,
    AuditRow: tables.audit,
    StationDest: tables.station_dests,
    VehicleOffset: tables.vehicle_offsets,
    TeachingEvent: tables.teaching_events,
}

_UNDOES = {CarrierRecord: CarrierGone, CarrierGone: CarrierRecord}


class Statements:
    """The SQL of every record type in one dialect, with positional parameters."""

    def __init__(self, dialect: sa.Dialect) -> None:
        self._dialect = dialect
        self._sql = {kind: self._compiled(self._upsert(table)) for kind, table in REPLACED.items()}
        self._sql |= {kind: self._append(kind, table) for kind, table in APPENDED.items()}
        gone = tables.carriers.delete().where(tables.carriers.c.carrier == sa.bindparam("carrier"))
        self._sql[CarrierGone] = self._compiled(gone)

    def of(self, batch: Sequence[Record]) -> Iterator[tuple[str, list[Row]]]:
        """Give each statement with its rows.

        Tables do not refer to one another, so order matters within a table only; of several records with one key the last
        is written. Raises StoreRefused for a record that no row can hold.
        """
        replaced: dict[type, dict[object, Row]] = {kind: {} for kind in (*REPLACED, CarrierGone)}
        appended: dict[type, list[Row]] = {kind: [] for kind in APPENDED}
        for record in batch:
            kind = type(record)
            try:
                row = ROW_OF[kind](record)
            except (TypeError, ValueError) as cause:
                raise StoreRefused(f"a record cannot be kept: {cause}: {record!r}") from cause
            if kind in appended:
                appended[kind].append(row)
                continue
            replaced[kind][row[0]] = row
            if kind in _UNDOES:
                replaced[_UNDOES[kind]].pop(row[0], None)
        for kind, by_key in replaced.items():
            if by_key:
                yield self._sql[kind], list(by_key.values())
        for kind, rows in appended.items():
            if rows:
                yield self._sql[kind], rows

    def _compiled(self, statement: sa.ClauseElement, columns: Sequence[str] | None = None) -> str:
        return str(statement.compile(dialect=self._dialect, column_keys=columns))

    def _insert(self, table: sa.Table) -> postgresql.Insert | sqlite.Insert:
        return postgresql.insert(table) if self._dialect.name == "postgresql" else sqlite.insert(table)

    def _upsert(self, table: sa.Table) -> sa.ClauseElement:
        insert = self._insert(table)
        key, *others = table.c
        return insert.on_conflict_do_update(
            index_elements=[key], set_={c.name: insert.excluded[c.name] for c in others}
        )

    def _append(self, kind: type, table: sa.Table) -> str:
        given = [column.name for column in table.c if table.autoincrement_column is not column]
        insert = self._insert(table)
        if kind is TeachingEvent:
            return self._compiled(insert.on_conflict_do_nothing(), given)
        return self._compiled(insert, given)
