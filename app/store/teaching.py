"""Rows of teaching and back: versions, raw events, proposals, sessions. See :mod:`app.store.rows`."""

from collections.abc import Callable
from typing import Any

from app.domain.ids import Actor, StationId, VehicleId
from app.domain.layout import Axis
from app.domain.pulses import AxisPulses, known, pulses_of
from app.domain.records import StationDest, TeachingEvent, VehicleOffset
from app.domain.teaching import Basis, Proposal, ProposalState, Reading, SessionState, Side, TeachingSession
from app.domain.units import Barcode, Pulses, Timestamp
from app.store.columns import Found, Row, as_json, as_names, signed, unsigned


def _basis(basis: tuple[Basis, ...]) -> str | None:
    """Return what the axes were derived from, as JSON; None where a person wrote them."""
    if not basis:
        return None
    return as_json(
        [[b.axis.value, b.raw, b.vehicle, b.barcode, list(b.events), b.against, b.version, b.less] for b in basis]
    )


def _version_row(record: StationDest | VehicleOffset, owner: str) -> Row:
    pulses = record.pulses
    return (
        owner,
        record.version,
        pulses.shft,
        pulses.rota,
        pulses.lift,
        record.actor,
        record.source,
        record.at,
        _basis(record.basis),
        record.proposal,
        record.restores,
        record.reason or None,
    )


def _version(row: Found) -> dict[str, Any]:
    given = {Axis.SHFT: row.shft, Axis.ROTA: row.rota, Axis.LIFT: row.lift}
    basis = (
        Basis(Axis(axis), raw, vehicle, barcode, tuple(events), against, version, less)
        for axis, raw, vehicle, barcode, events, against, version, less in row.basis or ()
    )
    return {
        "version": row.version,
        "pulses": pulses_of({axis: value for axis, value in given.items() if value is not None}),
        "actor": Actor(row.actor),
        "source": row.source,
        "at": Timestamp(row.at),
        "basis": tuple(basis),
        "proposal": row.proposal,
        "restores": row.restores,
        "reason": row.reason or "",
    }


def dest_row(record: StationDest) -> Row:
    """Columns of ``station_dests``."""
    return _version_row(record, record.station)


def dest(row: Found) -> StationDest:
    """Undo :func:`dest_row`."""
    return StationDest(station=StationId(row.station), **_version(row))


def offset_row(record: VehicleOffset) -> Row:
    """Columns of ``vehicle_offsets``."""
    return _version_row(record, record.vehicle)


def offset(row: Found) -> VehicleOffset:
    """Undo :func:`offset_row`."""
    return VehicleOffset(vehicle=VehicleId(row.vehicle), **_version(row))


def event_row(record: TeachingEvent) -> Row:
    """Columns of ``teaching_events``."""
    return (
        record.number,
        record.vehicle,
        record.connection,
        signed(record.cmd_id),
        record.code,
        None if record.axis is None else record.axis.value,
        record.position,
        record.barcode,
        record.at,
        record.asked_by,
    )


def event(row: Found) -> TeachingEvent:
    """Undo :func:`event_row`."""
    return TeachingEvent(
        vehicle=VehicleId(row.vehicle),
        connection=row.connection,
        cmd_id=unsigned(row.cmd_id),
        code=row.code,
        axis=None if row.axis is None else Axis(row.axis),
        position=Pulses(row.position),
        barcode=Barcode(row.barcode),
        at=Timestamp(row.at),
        number=row.seq,
        asked_by=row.asked_by,
    )


def _pulses(pulses: AxisPulses | None) -> str | None:
    return None if pulses is None else as_json({axis.value: value for axis, value in known(pulses).items()})


def proposal_row(record: Proposal) -> Row:
    """Columns of ``teaching_proposals``."""
    readings = [[r.axis.value, r.position, signed(r.cmd_id), list(r.events)] for r in record.readings]
    return (
        record.number,
        record.side.value,
        record.vehicle,
        record.barcode,
        record.opened,
        record.at,
        as_json(readings),
        record.state.value,
        record.why,
        record.remedy,
        as_names(record.warnings),
        record.station,
        record.session,
        None if record.asked is None else signed(record.asked),
        record.asked_by,
        record.collecting,
        record.broken,
        record.mode,
        _pulses(record.result),
        record.base,
        record.against_version,
        record.closed,
        record.closed_by,
        record.reason,
        record.version,
        record.revision,
    )


def proposal(row: Found) -> Proposal:
    """Undo :func:`proposal_row`."""
    return Proposal(
        number=row.number,
        side=Side(row.side),
        vehicle=row.vehicle,
        barcode=row.barcode,
        opened=row.opened,
        at=row.at,
        readings=tuple(Reading(Axis(axis), at, unsigned(cmd), tuple(events)) for axis, at, cmd, events in row.readings),
        state=ProposalState(row.state),
        why=row.why,
        remedy=row.remedy,
        warnings=tuple(row.warnings),
        station=row.station,
        session=row.session,
        asked=None if row.asked is None else unsigned(row.asked),
        asked_by=row.asked_by,
        collecting=row.collecting,
        broken=row.broken,
        mode=row.mode,
        result=None if row.result is None else pulses_of({Axis(axis): Pulses(at) for axis, at in row.result.items()}),
        base=row.base,
        against_version=row.against_version,
        closed=row.closed,
        closed_by=row.closed_by,
        reason=row.reason,
        version=row.version,
        revision=row.revision,
    )


def session_row(record: TeachingSession) -> Row:
    """Columns of ``teaching_sessions``."""
    return (
        record.number,
        record.station,
        record.vehicle,
        record.actor,
        record.opened,
        record.note,
        record.state.value,
        record.ended,
        record.ended_by,
        record.reason,
    )


def session(row: Found) -> TeachingSession:
    """Undo :func:`session_row`."""
    return TeachingSession(
        number=row.number,
        station=row.station,
        vehicle=row.vehicle,
        actor=row.actor,
        opened=row.opened,
        note=row.note,
        state=SessionState(row.state),
        ended=row.ended,
        ended_by=row.ended_by,
        reason=row.reason,
    )


ROW_OF: dict[type, Callable[[Any], Row]] = {
    StationDest: dest_row,
    VehicleOffset: offset_row,
    TeachingEvent: event_row,
    Proposal: proposal_row,
    TeachingSession: session_row,
}
"""How each record type of teaching becomes a row."""
