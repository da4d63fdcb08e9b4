"""A batch of records as few statements: compiled once per dialect, one executemany per table."""

from collections.abc import Iterator, Sequence
from typing import Any

import sqlalchemy as sa
from sqlalchemy.dialects import postgresql, sqlite

from app.domain.alarms import Alarm
from app.domain.closures import Closure
from app.domain.drive_records import DriveBackup, DriveOperation, DriveRecord, DriveValue
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
from app.domain.teaching import Proposal, TeachingSession
from app.domain.walks import Walk, WalkPlace
from app.domain.webhooks import Webhook, WebhookProgress, WebhookTry
from app.domain.why import Why
from app.store import tables
from app.store.columns import Row
from app.store.rows import ROW_OF

REPLACED: dict[type, sa.Table] = {
    Job: tables.jobs,
    Intent: tables.intents,
    VehicleRecord: tables.vehicles,
    StationRecord: tables.stations,
    CarrierRecord: tables.carriers,
    ControllerRecord: tables.controller,
    DriveOperation: tables.operations,
    DriveValue: tables.drive_values,
    DriveRecord: tables.drives,
    Proposal: tables.teaching_proposals,
    TeachingSession: tables.teaching_sessions,
    DeviceRecord: tables.devices,
    Why: tables.job_whys,
    Closure: tables.closures,
    Webhook: tables.webhooks,
    WebhookProgress: tables.webhook_progress,
    WebhookTry: tables.webhook_tries,
    Alarm: tables.alarms,
    Walk: tables.walks,
    WalkPlace: tables.walk_places,
}
"""A record replaces the row of its key: the table's first columns."""

APPENDED: dict[type, sa.Table] = {
    HistoryEvent: tables.events,
    AuditRow: tables.audit,
    StationDest: tables.station_dests,
    VehicleOffset: tables.vehicle_offsets,
    TeachingEvent: tables.teaching_events,
    DriveBackup: tables.drive_backups,
}

_KEYS = {kind: len(table.primary_key) for kind, table in REPLACED.items()} | {CarrierGone: 1}
"""How many columns are the key."""
COPY = "COPY"
COPY_FROM = 8
"""From so many rows on, PostgreSQL takes events by COPY: fewer are quicker as one INSERT each. Our choice."""


def carry_out(connection: sa.Connection, sql: str, rows: Sequence[Row]) -> None:
    """Give a statement of :class:`Statements` to the database. Raises SQLAlchemyError."""
    if not sql.startswith(COPY):
        connection.exec_driver_sql(sql, list(rows))
        return
    dialect = connection.dialect
    raised = dialect.loaded_dbapi.Error
    try:
        cursor: Any = connection.connection.cursor()
        with cursor, cursor.copy(sql) as copy:
            for row in rows:
                copy.write_row(row)
    except raised as cause:
        raise sa.exc.DBAPIError.instance(sql, None, cause, raised, dialect=dialect) from cause


def _rows(kind: type, records: Sequence[Record]) -> list[Row]:
    make = ROW_OF[kind]
    made: list[Row] = []
    for record in records:
        try:
            made.append(make(record))
        except (TypeError, ValueError) as cause:
            raise StoreRefused(f"a record cannot be kept: {cause}: {str(record)[:2000]}") from cause
    return made


def _settle_carriers(found: dict[type, list[Record]], batch: Sequence[Record]) -> None:
    """Leave of each carrier the last word: where it is, or that it is gone."""
    last = {record.carrier: record for record in batch if isinstance(record, CarrierRecord | CarrierGone)}
    for kind in (CarrierRecord, CarrierGone):
        found[kind] = [record for record in last.values() if type(record) is kind]


class Statements:
    """The SQL of every record type in one dialect, with positional parameters."""

    def __init__(self, dialect: sa.Dialect) -> None:
        self._dialect = dialect
        self._sql = {kind: self._compiled(self._upsert(table)) for kind, table in REPLACED.items()}
        self._sql |= {kind: self._append(kind, table) for kind, table in APPENDED.items()}
        gone = tables.carriers.delete().where(tables.carriers.c.carrier == sa.bindparam("carrier"))
        self._sql[CarrierGone] = self._compiled(gone)
        self._copy: dict[type, str] = {}
        if dialect.name == "postgresql":
            self._copy[HistoryEvent] = f"{COPY} {tables.events.name} FROM STDIN"

    @property
    def audit(self) -> str:
        """The statement that takes audit rows, each with its number before it and its hash behind it."""
        return self._sql[AuditRow]

    def of(self, batch: Sequence[Record]) -> Iterator[tuple[str, list[Row]]]:
        """Give each statement with its rows, for :func:`carry_out`.

        Tables do not refer to one another, so order matters within a table only; of several records with one key the last
        is written. Raises StoreRefused for a record that no row can hold.
        """
        found: dict[type, list[Record]] = {}
        for record in batch:
            found.setdefault(type(record), []).append(record)
        if CarrierGone in found and CarrierRecord in found:
            _settle_carriers(found, batch)
        for kind, sql in self._sql.items():
            if found.get(kind):
                rows = _rows(kind, found[kind])
                if kind in REPLACED and len(rows) > 1:
                    keys = _KEYS[kind]
                    rows = list({row[:keys]: row for row in rows}.values())
                yield (self._copy[kind] if kind in self._copy and len(rows) >= COPY_FROM else sql), rows

    def _compiled(self, statement: sa.ClauseElement, columns: Sequence[str] | None = None) -> str:
        return str(statement.compile(dialect=self._dialect, column_keys=columns))

    def _insert(self, table: sa.Table) -> postgresql.Insert | sqlite.Insert:
        return postgresql.insert(table) if self._dialect.name == "postgresql" else sqlite.insert(table)

    def _upsert(self, table: sa.Table) -> sa.ClauseElement:
        insert = self._insert(table)
        given = {column.name: insert.excluded[column.name] for column in table.c if not column.primary_key}
        return insert.on_conflict_do_update(index_elements=list(table.primary_key), set_=given)

    def _append(self, kind: type, table: sa.Table) -> str:
        given = [column.name for column in table.c if table.autoincrement_column is not column]
        insert = self._insert(table)
        if kind is TeachingEvent:
            return self._compiled(insert.on_conflict_do_nothing(), given)
        return self._compiled(insert, given)
