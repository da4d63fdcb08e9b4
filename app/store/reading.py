"""The reading side: what is committed, on connections of its own. Never waits for the writer and never makes it wait."""

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import sqlalchemy as sa

from app.domain.drive import DriveId
from app.domain.drive_records import DriveBackup, DriveOperation
from app.domain.errors import StoreError
from app.domain.ids import CmdId, JobId, VehicleId
from app.domain.job import Job
from app.domain.records import AuditRow, HistoryEvent, Intent
from app.domain.webhooks import WebhookTry
from app.domain.why import Why
from app.store import drive_rows, rows, webhook_rows, why_rows
from app.store.alarm_reading import AlarmReader
from app.store.chain import START, Checked, check
from app.store.columns import Found, signed
from app.store.engine import MEMORY, parsed, reading, told
from app.store.room_reading import RoomReader
from app.store.statistics_reading import StatisticsReader
from app.store.tables import audit, drive_backups, events, intents, job_whys, jobs, operations, webhook_tries
from app.store.teaching_reading import TeachingReader, where

T = TypeVar("T")
_NOW: dict[str, sa.ColumnElement[float]] = {
    "sqlite": sa.cast(sa.func.strftime("%s", "now"), sa.Double),
    "postgresql": sa.cast(sa.func.extract("epoch", sa.func.now()), sa.Double),
}
CHECKED_AT_ONCE = 2_000
"""Audit rows read at a time while they are looked at. Our choice."""
KEY_SECONDS = 7 * 86_400
"""How long an idempotency key names its job (COMMANDS section 5)."""


class Reader(TeachingReader, RoomReader, AlarmReader, StatisticsReader):
    """Questions to the database of a plant, from any thread. Every method raises StoreError if it cannot be read.

    ``after`` is the key of the last row that the caller has; ``limit`` bounds the answer. The tables must exist: open the
    ledger first. A database in memory has no second connection and is refused.
    """

    def __init__(self, url: str) -> None:
        made = parsed(url)
        if made.database == MEMORY:
            raise StoreError("a database in memory can be read by its ledger alone", remedy="Keep the plant in a file.")
        self._engine = reading(made)
        self._now = _NOW[made.get_backend_name()]

    def close(self) -> None:
        """Close all connections."""
        self._engine.dispose()

    def job(self, job: JobId) -> Job | None:
        """Return a job, ended or not."""
        return self._first(sa.select(jobs).where(jobs.c.id == job), rows.job)

    def why(self, order: int) -> Why | None:
        """Return what is kept of a job's why, by the job's order; None: it never waited and never got a vehicle."""
        return self._first(sa.select(job_whys).where(job_whys.c.number == order), why_rows.why)

    def jobs_named(self, names: Sequence[JobId]) -> list[Job]:
        """Return those of the named jobs that there are, ended or not, in any order."""
        return self._list(sa.select(jobs).where(jobs.c.id.in_(names)), rows.job)

    def job_count(self) -> int:
        """Return how many jobs there have been."""
        return self._first(sa.select(sa.func.max(jobs.c.number).label("last")), lambda row: int(row.last or 0)) or 0

    def job_names(self, after: int, limit: int) -> list[tuple[int, str]]:
        """Return orders above ``after`` and the names of their jobs, oldest first."""
        query = sa.select(jobs.c.number, jobs.c.id).where(jobs.c.number > after).order_by(jobs.c.number).limit(limit)
        return self._list(query, lambda row: (row.number, row.id))

    def job_by_key(self, key: str) -> Job | None:
        """Return the job accepted under this idempotency key within the last 7 days; the newest, if there are several."""
        known = sa.and_(jobs.c.idempotency_key == key, jobs.c.created > self._now - KEY_SECONDS)
        return self._first(sa.select(jobs).where(known).order_by(jobs.c.number.desc()).limit(1), rows.job)

    def jobs(
        self,
        *,
        state: str | None = None,
        carrier: str | None = None,
        vehicle: str | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> list[Job]:
        """Return jobs, newest first; ``after`` is the ``order`` of the last one seen."""
        query = where(sa.select(jobs), {jobs.c.state: state, jobs.c.carrier: carrier, jobs.c.vehicle: vehicle})
        if after is not None:
            query = query.where(jobs.c.number < after)
        return self._list(query.order_by(jobs.c.number.desc()).limit(limit), rows.job)

    def events(
        self, after: int = 0, limit: int = 100, *, job: str | None = None, vehicle: str | None = None
    ) -> list[HistoryEvent]:
        """Return durable events in order; ``after`` is the ``seq`` of the last one seen."""
        query = where(sa.select(events), {events.c.job: job, events.c.vehicle: vehicle})
        return self._list(query.where(events.c.seq > after).order_by(events.c.seq).limit(limit), rows.event)

    def intent(self, cmd_id: CmdId) -> Intent | None:
        """Return a command."""
        return self._first(sa.select(intents).where(intents.c.cmd_id == signed(cmd_id)), rows.intent)

    def intents(self, vehicle: VehicleId, limit: int = 100) -> list[Intent]:
        """Return a vehicle's commands, newest first."""
        query = sa.select(intents).where(intents.c.vehicle == vehicle)
        return self._list(query.order_by(intents.c.cmd_id.desc()).limit(limit), rows.intent)

    def audit(self, after: int = 0, limit: int = 100) -> list[tuple[int, AuditRow]]:
        """Return what was asked for with its number, oldest first; ``after`` is the number of the last one seen."""
        query = sa.select(audit).where(audit.c.seq > after).order_by(audit.c.seq).limit(limit)
        return self._list(query, lambda row: (row.seq, rows.audit(row)))

    def audit_found(
        self,
        *,
        actor: str | None = None,
        action: str | None = None,
        target: str | None = None,
        accepted: bool | None = None,
        begin: float | None = None,
        end: float | None = None,
        before: int | None = None,
        limit: int = 100,
    ) -> list[tuple[int, AuditRow]]:
        """Return what was asked for, newest first; ``before`` is the number of the last one seen, ``end`` lies behind."""
        wanted: dict[sa.Column[Any], str | int | None] = {
            audit.c.actor: actor, audit.c.action: action, audit.c.target: target, audit.c.accepted: accepted
        }  # fmt: skip
        query = where(sa.select(audit), wanted)
        if begin is not None:
            query = query.where(audit.c.at >= begin)
        if end is not None:
            query = query.where(audit.c.at < end)
        if before is not None:
            query = query.where(audit.c.seq < before)
        return self._list(query.order_by(audit.c.seq.desc()).limit(limit), lambda row: (row.seq, rows.audit(row)))

    def audit_hash(self, seq: int) -> str | None:
        """Return the hash of an audit row; None: there is no such row."""
        return self._first(sa.select(audit).where(audit.c.seq == seq), lambda row: str(row.hash))

    def audit_checked(self, after: int, limit: int) -> Checked:
        """Look at so many audit rows above ``after`` at most, whether each follows from the one before it.

        The row ``after`` itself is believed; 0 begins at the first. A row missing at the end is not noticed: compare the
        last number and hash with what was noted elsewhere.
        """
        first = self.audit_hash(after)
        if after and first is None:
            return Checked(0, after, "", after, f"there is no row {after}")
        checked = Checked(0, after, first or START)
        while checked.broken is None and checked.rows < limit:
            page = min(CHECKED_AT_ONCE, limit - checked.rows)
            query = sa.select(audit).where(audit.c.seq > checked.last).order_by(audit.c.seq).limit(page)
            found = self._list(query, lambda row: (row.seq, rows.audit(row), row.hash))
            checked = check(checked, found)
            if len(found) < page:
                break
        return checked

    def operation(self, number: int) -> DriveOperation | None:
        """Return an operation on drives."""
        return self._first(sa.select(operations).where(operations.c.number == number), drive_rows.operation)

    def operations(
        self, *, drive: str | None = None, line: str | None = None, after: int | None = None, limit: int = 100
    ) -> list[DriveOperation]:
        """Return operations, newest first; ``after`` is the number of the last one seen."""
        query = where(sa.select(operations), {operations.c.drive: drive, operations.c.line: line})
        if after is not None:
            query = query.where(operations.c.number < after)
        return self._list(query.order_by(operations.c.number.desc()).limit(limit), drive_rows.operation)

    def backup(self, number: int) -> DriveBackup | None:
        """Return a backup of a drive."""
        return self._first(sa.select(drive_backups).where(drive_backups.c.number == number), drive_rows.backup)

    def backups(self, drive: DriveId, after: int | None = None, limit: int = 100) -> list[DriveBackup]:
        """Return a drive's backups, newest first; ``after`` is the number of the last one seen."""
        query = sa.select(drive_backups).where(drive_backups.c.drive == drive)
        if after is not None:
            query = query.where(drive_backups.c.number < after)
        return self._list(query.order_by(drive_backups.c.number.desc()).limit(limit), drive_rows.backup)

    def webhook_tries(self, webhook: int, after: int | None = None, limit: int = 100) -> list[WebhookTry]:
        """Return a webhook's deliveries that are kept, newest first; ``after`` is the number of the last one seen."""
        query = sa.select(webhook_tries).where(webhook_tries.c.webhook == webhook)
        if after is not None:
            query = query.where(webhook_tries.c.number < after)
        return self._list(query.order_by(webhook_tries.c.number.desc()).limit(limit), webhook_rows.made_try)

    def _list(self, query: sa.Select[Any], made: Callable[[Found], T]) -> list[T]:
        with told("the database cannot be read"), self._engine.connect() as connection:
            return [made(row) for row in connection.execute(query)]

    def _first(self, query: sa.Select[Any], made: Callable[[Found], T]) -> T | None:
        return next(iter(self._list(query, made)), None)
