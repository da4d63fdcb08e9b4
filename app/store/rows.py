"""Records to rows and back, one pair of functions per record type.

A row is a tuple in the order of its table's columns; JSON goes in as text and comes out decoded. Times, identities and enums
come back equal to what went in, also CMD_IDs with the top bit set.
"""

import json
from collections.abc import Callable, Mapping
from typing import Any

import sqlalchemy as sa

from app.domain.ids import Actor, CarrierId, CmdId, StationId, VehicleId
from app.domain.job import Job, JobState, Leg
from app.domain.layout import Axis, PulseSet
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
    Lockout,
    Provenance,
    StationDest,
    StationRecord,
    TeachingEvent,
    VehicleOffset,
    VehicleRecord,
)
from app.domain.units import Barcode, Pulses, Timestamp
from app.store.device_rows import device_row, emergencies, emergencies_text

Row = tuple[str | int | float | bool | None, ...]
Found = sa.Row[Any]
"""A row as a query gives it."""

_TOP = 1 << 63
_WRAP = 1 << 64


def signed(cmd_id: int) -> int:
    """Return an unsigned 64-bit number as the database holds it."""
    return cmd_id - _WRAP if cmd_id >= _TOP else cmd_id


def unsigned(value: int) -> CmdId:
    """Undo :func:`signed`."""
    return CmdId(value + _WRAP if value < 0 else value)


def _json(value: Mapping[str, object] | tuple[str, ...]) -> str:
    """Return compact JSON. Raises TypeError or ValueError for what JSON cannot say."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False)


def _names(value: tuple[str, ...]) -> str:
    return _json(value) if value else "[]"


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
        _names(job.fallbacks),
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
        _names(intent.path),
        _json(dict(intent.body)) if intent.body else "{}",
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


def event_row(event: HistoryEvent) -> Row:
    """Columns of ``events``."""
    return (
        event.seq,
        event.at,
        event.event,
        event.ceid,
        event.job,
        event.carrier,
        event.vehicle,
        event.source,
        event.destination,
        event.result,
        event.detail,
    )


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
    return _json({"reason": hold.reason, "remedy": hold.remedy, "since": hold.since, "doubt": hold.doubt})


def _lockout(lockout: Lockout | None) -> str | None:
    if lockout is None:
        return None
    return _json(
        {"owner": lockout.owner, "reason": lockout.reason, "since": lockout.since, "releases": list(lockout.releases)}
    )


def vehicle_row(record: VehicleRecord) -> Row:
    """Columns of ``vehicles``."""
    return (
        record.vehicle,
        record.barcode,
        _names(record.held),
        record.carrier,
        record.believed_loaded,
        _hold(record.hold),
        _lockout(record.lockout),
        record.out_of_service,
        record.off_rail,
    )


def vehicle(row: Found) -> VehicleRecord:
    """Undo :func:`vehicle_row`."""
    lockout = row.lockout
    return VehicleRecord(
        vehicle=row.vehicle,
        barcode=row.barcode,
        held=tuple(row.held),
        carrier=row.carrier,
        believed_loaded=row.believed_loaded,
        hold=None if row.hold is None else Hold(**row.hold),
        lockout=None if lockout is None else Lockout(**{**lockout, "releases": tuple(lockout["releases"])}),
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


def dest_row(record: StationDest) -> Row:
    """Columns of ``station_dests``."""
    pulses = record.pulses
    return (
        record.station,
        record.version,
        pulses.shft,
        pulses.rota,
        pulses.lift,
        record.actor,
        record.source,
        record.at,
    )


def _pulses(row: Found) -> PulseSet:
    return PulseSet(Pulses(row.shft), Pulses(row.rota), Pulses(row.lift))


def dest(row: Found) -> StationDest:
    """Undo :func:`dest_row`."""
    return StationDest(
        StationId(row.station), row.version, _pulses(row), Actor(row.actor), row.source, Timestamp(row.at)
    )


def offset_row(record: VehicleOffset) -> Row:
    """Columns of ``vehicle_offsets``."""
    pulses = record.pulses
    return (
        record.vehicle,
        record.version,
        pulses.shft,
        pulses.rota,
        pulses.lift,
        record.actor,
        record.source,
        record.at,
    )


def offset(row: Found) -> VehicleOffset:
    """Undo :func:`offset_row`."""
    return VehicleOffset(
        VehicleId(row.vehicle), row.version, _pulses(row), Actor(row.actor), row.source, Timestamp(row.at)
    )


def teaching_row(record: TeachingEvent) -> Row:
    """Columns of ``teaching_events`` but for its number, which the database gives."""
    return (
        record.vehicle,
        record.connection,
        signed(record.cmd_id),
        record.code,
        None if record.axis is None else record.axis.value,
        record.position,
        record.barcode,
        record.at,
    )


def teaching(row: Found) -> TeachingEvent:
    """Undo :func:`teaching_row`."""
    return TeachingEvent(
        vehicle=VehicleId(row.vehicle),
        connection=row.connection,
        cmd_id=unsigned(row.cmd_id),
        code=row.code,
        axis=None if row.axis is None else Axis(row.axis),
        position=Pulses(row.position),
        barcode=Barcode(row.barcode),
        at=Timestamp(row.at),
    )


def controller_row(record: ControllerRecord) -> Row:
    """Columns of ``controller``."""
    return (1, record.state.value, record.reason, emergencies_text(record.emergencies))


def controller(row: Found) -> ControllerRecord:
    """Undo :func:`controller_row`."""
    return ControllerRecord(ControllerState(row.state), row.reason, emergencies(row.emergencies))


ROW_OF: dict[type, Callable[[Any], Row]] = {
    Job: job_row,
    Intent: intent_row,
    HistoryEvent: event_row,
    AuditRow: audit_row,
    VehicleRecord: vehicle_row,
    StationRecord: station_row,
    CarrierRecord: carrier_row,
    CarrierGone: gone_row,
    StationDest: dest_row,
    VehicleOffset: offset_row,
    TeachingEvent: teaching_row,
    ControllerRecord: controller_row,
    DeviceRecord: device_row,
}
"""How each record type becomes a row."""
