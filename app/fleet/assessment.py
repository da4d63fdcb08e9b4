"""What a set of teaching events would become now, and what stands against it (DOMAIN section 3, I40)."""

from collections.abc import Collection, Iterator
from dataclasses import replace

from app.domain.layout import Axis, VehicleKind
from app.domain.pulses import (
    AxisPulses,
    beyond,
    carried_over,
    drifts,
    fits_wire,
    known,
    less,
    missing,
    named,
    pulses_of,
    target,
)
from app.domain.teaching import DRIFT, Basis, Proposal, ProposalState, Side
from app.fleet.books import Books

WARNED = 20
"""So many vehicles or ports out of range are named with a proposal (our choice)."""


def raw_of(proposal: Proposal) -> AxisPulses:
    """Return the positions that the vehicle sent."""
    return pulses_of({reading.axis: reading.position for reading in proposal.readings})


def assessed(books: Books, proposal: Proposal, accept: Collection[ProposalState] = ()) -> Proposal:
    """Return the proposal as it stands now: its state, why, what would help, the version it would make, and warnings.

    The first thing that stands against it is its state; those in ``accept`` are passed over.
    """
    other, version = _other_side(books, proposal)
    present, base = _present(books, proposal)
    result = _result(proposal, other, present)
    state, why, remedy = ProposalState.READY, "", "look at its changes, then approve or reject it"
    for found, reason, help_ in _against(books, proposal, other):
        if found not in accept:
            state, why, remedy = found, reason, help_
            break
    return replace(
        proposal,
        state=state,
        why=why,
        remedy=remedy,
        result=result,
        base=base,
        against_version=version,
        warnings=tuple(_warnings(books, replace(proposal, base=base), present, result)) if result else (),
    )


def basis_of(books: Books, proposal: Proposal) -> tuple[Basis, ...]:
    """Return what each axis of the new version comes from: those taught now, and those carried over as they were."""
    other, version = _other_side(books, proposal)
    subtracted = known(other)
    station, vehicle = proposal.station or "", proposal.vehicle
    against = vehicle if proposal.side is Side.DEST else station
    new = {
        r.axis: Basis(r.axis, r.position, vehicle, proposal.barcode, r.events, against, version, subtracted[r.axis])
        for r in proposal.readings
    }
    before = books.dests.get(proposal.station) if proposal.station else None
    present = before if proposal.side is Side.DEST else books.offsets.get(vehicle)
    carried = {basis.axis: basis for basis in present.basis} if present else {}
    merged = carried | new
    return tuple(merged[axis] for axis in Axis if axis in merged)


def _other_side(books: Books, proposal: Proposal) -> tuple[AxisPulses | None, int | None]:
    """Return what is subtracted, and its version (None for a declared reference vehicle, or while there is none)."""
    if proposal.side is Side.OFFSET:
        dest = books.dests.get(proposal.station) if proposal.station else None
        return (dest.pulses, dest.version) if dest else (None, None)
    offset = books.offsets.get(proposal.vehicle)
    pulses = books.teaching.offset_of(proposal.vehicle, offset)
    declared = books.teaching.is_reference(proposal.vehicle)
    return pulses, None if declared or offset is None else offset.version


def _present(books: Books, proposal: Proposal) -> tuple[AxisPulses | None, int]:
    if proposal.side is Side.OFFSET:
        offset = books.offsets.get(proposal.vehicle)
        return (offset.pulses, offset.version) if offset else (None, 0)
    dest = books.dests.get(proposal.station) if proposal.station else None
    return (dest.pulses, dest.version) if dest else (None, 0)


def _result(proposal: Proposal, other: AxisPulses | None, present: AxisPulses | None) -> AxisPulses | None:
    """Return the version that approval makes, None while it cannot be derived."""
    raw = raw_of(proposal)
    if other is None or not known(raw) or proposal.station is None or set(known(raw)) - set(known(other)):
        return None
    return carried_over(present, less(raw, other))


def _against(books: Books, proposal: Proposal, other: AxisPulses | None) -> Iterator[tuple[ProposalState, str, str]]:
    """Give each thing that stands against approval: state, sentence, remedy; the gravest first."""
    raw, vehicle, at = raw_of(proposal), proposal.vehicle, proposal.barcode
    again = "teach again, or reject it"
    if proposal.collecting:
        yield ProposalState.COLLECTING, f"{named(tuple(known(raw)))} came; more may follow", "wait some seconds"
    ports = books.teaching.ports_at(at)
    if not ports:
        yield (
            ProposalState.UNKNOWN_BARCODE,
            f"no port of the plant is at barcode {at}",
            "bring the vehicle to a port's barcode and teach again; or give the port in the plant file and restart",
        )
    elif proposal.station is None:
        names = ", ".join(port.id for port in ports)
        yield (
            ProposalState.AMBIGUOUS,
            f"{names} share barcode {at}, and no teaching session named one",
            f"POST /api/v1/teaching/proposals/{proposal.number}/assign with the station",
        )
    if proposal.side is Side.OFFSET and books.teaching.is_reference(vehicle):
        yield (
            ProposalState.UNUSABLE,
            f"{vehicle} is a reference vehicle: its OFFSET is zero by declaration",
            "reject it, or take `reference` out of the plant file",
        )
    if proposal.mode:
        yield ProposalState.WRONG_MODE, f"{vehicle} sent it in {proposal.mode}, and teaching needs MANT", again
    if proposal.broken and missing(raw):
        yield ProposalState.INCOMPLETE, f"{named(missing(raw))} did not come: {proposal.broken}", again
    if lacking := tuple(axis for axis in known(raw) if axis not in known(other)):
        yield ProposalState.PENDING, *_pending(proposal, named(lacking))
    if why := _out_of_range(books, proposal, other):
        yield ProposalState.OUT_OF_RANGE, why, f"{again}; or correct the vehicle's limits in the plant file"


def _pending(proposal: Proposal, axes: str) -> tuple[str, str]:
    if proposal.side is Side.DEST:
        return (
            f"{proposal.vehicle} has no OFFSET ({axes}), so no DEST can be derived from what it sent",
            f"teach {proposal.vehicle} at a reference port, or PUT /api/v1/vehicles/{proposal.vehicle}/offset",
        )
    where = proposal.station or "the port"
    return (
        f"{where} has no DEST ({axes}), so no OFFSET can be derived from what {proposal.vehicle} sent there",
        f"teach {where} with a vehicle of known OFFSET, or PUT /api/v1/stations/{where}/dest",
    )


def _out_of_range(books: Books, proposal: Proposal, other: AxisPulses | None) -> str:
    vehicle = books.vehicles.get(proposal.vehicle)
    raw = raw_of(proposal)
    if vehicle is None:
        return f"{proposal.vehicle} is not in the plant any more"
    if why := beyond(raw, vehicle.spec.limits):
        return f"{why} of {vehicle.id}"
    if other is not None and not fits_wire(less(raw, other)):
        return "what follows from it does not fit in 32 bits"
    return ""


def _warnings(books: Books, proposal: Proposal, present: AxisPulses | None, result: AxisPulses) -> Iterator[str]:
    if far := drifts(present, result, DRIFT):
        yield f"far from version {proposal.base}: {far}"
    if lacking := missing(result):
        yield f"{named(lacking)} are still not known afterwards: jobs stay refused"
    found = list(_unreachable(books, proposal, result))
    yield from found[:WARNED]
    if len(found) > WARNED:
        yield f"and {len(found) - WARNED} more are out of range"


def _unreachable(books: Books, proposal: Proposal, result: AxisPulses) -> Iterator[str]:
    """Give each vehicle (for a DEST) or port (for an OFFSET) that the new version would put out of range."""
    if proposal.side is Side.DEST:
        for vehicle in books.vehicles.values():
            offset = books.teaching.offset_of(vehicle.id, books.offsets.get(vehicle.id))
            if vehicle.spec.kind is VehicleKind.HOIST and (why := beyond(target(result, offset), vehicle.spec.limits)):
                yield f"out of range for {vehicle.id}: {why}"
        return
    taught = books.vehicles.get(proposal.vehicle)
    for station, dest in books.dests.items():
        if taught and (why := beyond(target(dest.pulses, result), taught.spec.limits)):
            yield f"out of range at {station}: {why}"
