"""Records to rows and back, one pair of functions per record type.

A row is a tuple in the order of its table's columns; JSON goes in as text and comes out decoded. Times, identities and enums
come back equal to what went in, also CMD_IDs with the top bit set.
"""

from collections.abc import Callable
from operator import attrgetter
from typing import Any

from app.domain.alarms import Alarm
from app.domain.closures import Closure
from app.domain.drive_records import DriveBackup, DriveOperation, DriveRecord, DriveValue
from app.domain.ids import Actor, CarrierId
from app.domain.job import Job, JobState, Leg
from app.domain.records import (
    AuditRow,
    CarrierGone,
    CarrierRecord,
    ControllerRecord,
    ControllerState,
    DeviceRecord,
    HistoryEvent,
    Hold,
    Intent,
    IntentState,
    Provenance,
    StationRecord,
    VehicleRecord,
)
from app.domain.units import Timestamp
from app.domain.walks import Walk, WalkPlace
from app.domain.webhooks import Webhook, WebhookProgress, WebhookTry
from app.domain.why import Why
from app.store import drive_rows, teaching
from app.store.alarm_rows import alarm_row
from app.store.closure_rows import closure_row
from app.store.columns import Found, Row, as_json, as_names, lockout_of, lockout_text, signed, unsigned
from app.store.device_rows import device_row, emergencies, emergencies_text, pauses, pauses_text
from app.store.walk_rows import walk_place_row, walk_row
from app.store.webhook_rows import progress_row, try_row, webhook_row
from app.store.why_rows import why_row


def job_row(job: Job) -> Row:
    """Columns of ``jobs``."""
    return (
        job.order,
        job.id,
        job.carrier,
        job.source,
        job.destination,
        job.priority,
        job.created,
        job.actor,
        job.fingerprint,
        job.idempotency_key,
        job.state.value,
        job.leg.value,
        job.vehicle,
        job.wish,
        as_names(job.fallbacks),
        job.reason,
        job.result,
        job.assigned,
        job.picked,
        job.ended,
    )


def job(row: Found) -> Job:
    """Undo :func:`job_row`."""
    return Job(
        id=row.id,
        order=row.number,
        carrier=row.carrier,
        source=row.source,
        destination=row.destination,
        priority=row.priority,
        created=row.created,
        actor=row.actor,
        fingerprint=row.fingerprint,
        idempotency_key=row.idempotency_key,
        state=JobState(row.state),
        leg=Leg(row.leg),
        vehicle=row.vehicle,
        wish=row.wish,
        fallbacks=tuple(row.fallbacks),
        reason=row.reason,
        result=row.result,
        assigned=row.assigned,
        picked=row.picked,
        ended=row.ended,
    )


def intent_row(intent: Intent) -> Row:
    """Columns of ``intents``."""
    return (
        signed(intent.cmd_id),
        intent.vehicle,
        intent.kind,
        intent.state.value,
        intent.opened,
        intent.actor,
        intent.job,
        as_names(intent.path),
        as_json(dict(intent.body)) if intent.body else "{}",
        None if intent.amends is None else signed(intent.amends),
        intent.closed,
        intent.outcome,
    )


def intent(row: Found) -> Intent:
    """Undo :func:`intent_row`; sequences inside ``body`` come back as lists."""
    return Intent(
        cmd_id=unsigned(row.cmd_id),
        vehicle=row.vehicle,
        kind=row.kind,
        state=IntentState(row.state),
        opened=row.opened,
        actor=row.actor,
        job=row.job,
        path=tuple(row.path),
        body=row.body,
        amends=None if row.amends is None else unsigned(row.amends),
        closed=row.closed,
        outcome=row.outcome,
    )


event_row: Callable[[HistoryEvent], Row] = attrgetter(
    "seq", "at", "event", "ceid", "job", "carrier", "vehicle", "source", "destination", "result", "detail"
)
"""Columns of ``events``. There are more of these than of all other records together."""


def event(row: Found) -> HistoryEvent:
    """Undo :func:`event_row`."""
    return HistoryEvent(
        seq=row.seq,
        at=row.at,
        event=row.event,
        ceid=row.ceid,
        job=row.job,
        carrier=row.carrier,
        vehicle=row.vehicle,
        source=row.source,
        destination=row.destination,
        result=row.result,
        detail=row.detail,
    )


def audit_row(row: AuditRow) -> Row:
    """Columns of ``audit`` but for its number, which the database gives."""
    return (row.at, row.actor, row.action, row.target, row.detail, row.accepted)


def audit(row: Found) -> AuditRow:
    """Undo :func:`audit_row`."""
    return AuditRow(Timestamp(row.at), Actor(row.actor), row.action, row.target, row.detail, row.accepted)


def _hold(hold: Hold | None) -> str | None:
    if hold is None:
        return None
    return as_json({"reason": hold.reason, "remedy": hold.remedy, "since": hold.since, "doubt": hold.doubt})


def vehicle_row(record: VehicleRecord) -> Row:
    """Columns of ``vehicles``."""
    return (
        record.vehicle,
        record.barcode,
        as_names(record.held),
        record.carrier,
        record.believed_loaded,
        _hold(record.hold),
        lockout_text(record.lockout),
        record.out_of_service,
        record.off_rail,
    )


def vehicle(row: Found) -> VehicleRecord:
    """Undo :func:`vehicle_row`."""
    return VehicleRecord(
        vehicle=row.vehicle,
        barcode=row.barcode,
        held=tuple(row.held),
        carrier=row.carrier,
        believed_loaded=row.believed_loaded,
        hold=None if row.hold is None else Hold(**row.hold),
        lockout=lockout_of(row.lockout),
        out_of_service=row.out_of_service,
        off_rail=row.off_rail,
    )


def station_row(record: StationRecord) -> Row:
    """Columns of ``stations``."""
    return (
        record.station,
        record.present,
        record.carrier,
        record.reserved,
        record.out_of_service,
        record.provenance.value,
        record.at,
    )


def station(row: Found) -> StationRecord:
    """Undo :func:`station_row`."""
    return StationRecord(
        station=row.station,
        present=row.present,
        carrier=row.carrier,
        reserved=row.reserved,
        out_of_service=row.out_of_service,
        provenance=Provenance(row.provenance),
        at=row.at,
    )


def carrier_row(record: CarrierRecord) -> Row:
    """Columns of ``carriers``."""
    return (record.carrier, record.place, record.provenance.value, record.at)


def carrier(row: Found) -> CarrierRecord:
    """Undo :func:`carrier_row`."""
    return CarrierRecord(CarrierId(row.carrier), row.place, Provenance(row.provenance), Timestamp(row.at))


def gone_row(record: CarrierGone) -> Row:
    """The key of the row to delete from ``carriers``."""
    return (record.carrier,)


def controller_row(record: ControllerRecord) -> Row:
    """Columns of ``controller``."""
    return (1, record.state.value, record.reason, emergencies_text(record.emergencies), pauses_text(record.pauses))


def controller(row: Found) -> ControllerRecord:
    """Undo :func:`controller_row`."""
    return ControllerRecord(ControllerState(row.state), row.reason, emergencies(row.emergencies), pauses(row.pauses))


ROW_OF: dict[type, Callable[[Any], Row]] = {
    Job: job_row,
    Intent: intent_row,
    HistoryEvent: event_row,
    AuditRow: audit_row,
    VehicleRecord: vehicle_row,
    StationRecord: station_row,
    CarrierRecord: carrier_row,
    CarrierGone: gone_row,
    **teaching.ROW_OF,
    ControllerRecord: controller_row,
    DriveOperation: drive_rows.operation_row,
    DriveBackup: drive_rows.backup_row,
    DriveValue: drive_rows.value_row,
    DriveRecord: drive_rows.drive_row,
    DeviceRecord: device_row,
    Why: why_row,
    Closure: closure_row,
    Webhook: webhook_row,
    WebhookProgress: progress_row,
    WebhookTry: try_row,
    Alarm: alarm_row,
    Walk: walk_row,
    WalkPlace: walk_place_row,
}
"""How each record type becomes a row."""
