"""What teaching looks like in answers: versions with their origin, proposals with what they would change."""

from collections.abc import Sequence

from app.api.calls import read
from app.api.port import Controller
from app.domain.ids import StationId, VehicleId
from app.domain.impact import Change, of_dest, of_offset
from app.domain.layout import Axis, PulseSet
from app.domain.pulses import AxisPulses, drifts
from app.domain.records import StationDest, TeachingEvent, VehicleOffset
from app.domain.teaching import Basis, Proposal, Side
from app.fleet.teaching_views import view_of_proposal
from app.runtime.showing import iso, shown

Version = StationDest | VehicleOffset


def axes(pulses: AxisPulses | None) -> dict[str, int | None]:
    """Return pulses by axis, null where one is not known."""
    return {axis.value: None if pulses is None else pulses.of(axis) for axis in Axis}


def version_row(row: Version) -> dict[str, object]:
    """Return a version with what it was derived from."""
    return {
        "version": row.version,
        **axes(row.pulses),
        "actor": row.actor,
        "source": row.source,
        "at": iso(row.at),
        "basis": [basis_row(basis) for basis in row.basis],
        "proposal": row.proposal,
        "restores": row.restores,
        "reason": row.reason,
    }


def basis_row(basis: Basis) -> dict[str, object]:
    """Return where one axis comes from."""
    return {
        "axis": basis.axis.value,
        "raw": basis.raw,
        "vehicle": basis.vehicle,
        "barcode": basis.barcode,
        "events": basis.events,
        "against": basis.against,
        "version": basis.version,
        "less": basis.less,
    }


def change_row(change: Change) -> dict[str, object]:
    """Return what one vehicle is sent at one port, before and after."""
    return {
        "station": change.station,
        "vehicle": change.vehicle,
        "old": axes(change.old),
        "new": axes(change.new),
        "beyond": change.beyond,
    }


def event_row(event: TeachingEvent) -> dict[str, object]:
    """Return a raw teaching event."""
    return {
        "number": event.number,
        "at": iso(event.at),
        "vehicle": event.vehicle,
        "barcode": event.barcode,
        "code": f"{event.code:04X}",
        "axis": event.axis.value if event.axis else None,
        "position": event.position,
        "cmd_id": f"{event.cmd_id:016x}",
        "connection": event.connection,
        "asked_by": event.asked_by,
    }


def numbered(rows: Sequence[Version], version: int | None) -> Version | None:
    """Return the version of that number, None if there is none."""
    return next((row for row in rows if row.version == version), None)


async def changes_of(
    controller: Controller, name: str, side: Side, old: AxisPulses | None, new: AxisPulses | None
) -> list[dict[str, object]]:
    """Return what changes for whom when the DEST of port ``name``, or the OFFSET of vehicle ``name``, goes from old to new."""
    if new is None:
        return []
    if side is Side.DEST:
        offsets = {row.vehicle: row for row in await read(controller.reader.all_offsets)}
        found = of_dest(controller.plant, offsets, StationId(name), old, new)
    else:
        dests = {row.station: row for row in await read(controller.reader.all_dests)}
        found = of_offset(controller.plant, dests, VehicleId(name), old, new)
    return [change_row(change) for change in found]


async def versions_of(controller: Controller, name: str, side: Side) -> Sequence[Version]:
    """Return all versions of a port's DEST or a vehicle's OFFSET, oldest first."""
    if side is Side.DEST:
        return await read(controller.reader.dests, StationId(name))
    return await read(controller.reader.offsets, VehicleId(name))


async def detail_of(controller: Controller, proposal: Proposal, far: PulseSet) -> dict[str, object]:
    """Return a proposal with the version it follows, what it changes, and how far that is."""
    name = proposal.vehicle if proposal.side is Side.OFFSET else proposal.station
    rows = await versions_of(controller, name, proposal.side) if name else []
    before = numbered(rows, proposal.base)
    old = before.pulses if before else None
    return {
        **shown(view_of_proposal(proposal)),
        "present": version_row(before) if before else None,
        "changes": await changes_of(controller, name, proposal.side, old, proposal.result) if name else [],
        "drift": drifts(old, proposal.result, far) if proposal.result else "",
    }
