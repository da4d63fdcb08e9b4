"""Where a vehicle's axes must go at a station: DEST + OFFSET, or why that cannot be said (DOMAIN section 3)."""

from app.domain.errors import Refusal
from app.domain.ids import StationId
from app.domain.layout import PulseSet, Station, StationKind, VehicleKind
from app.domain.pulses import AxisPulses, beyond, missing, named, target
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow


def target_for(
    books: Books, vehicle: VehicleNow, station: Station, given: PulseSet | None = None
) -> PulseSet | Refusal | None:
    """Return the pulses for a port, within the vehicle's limits; ``given`` ones before taught ones. None for a side buffer.

    Only complete sets are used: a station or a vehicle that lacks an axis is refused with the axis named.
    """
    if station.kind is not StationKind.PORT:
        return None
    if given is None:
        taught = _taught(books, vehicle, station)
        if isinstance(taught, Refusal):
            return taught
        given = taught
    if why := beyond(given, vehicle.spec.limits):
        return Refusal(
            "invalid",
            f"{why.replace(' is outside', f' for {station.id} is outside')} of {vehicle.id}",
            "correct the DEST of the station, the OFFSET of the vehicle, or the limits in the plant file",
        )
    return given


def no_dest(books: Books, station: StationId) -> Refusal | None:
    """Refusal for a port whose DEST lacks an axis, None if it is complete."""
    dest = books.dests.get(station)
    lacking = missing(dest.pulses if dest else None)
    if not lacking:
        return None
    return Refusal(
        "not-now",
        f"{station} has no DEST ({named(lacking)})",
        f"teach it: POST /api/v1/teaching/sessions; or PUT /api/v1/stations/{station}/dest",
    )


def no_offset(books: Books, vehicle: VehicleNow) -> Refusal | None:
    """Refusal for a hoist whose OFFSET lacks an axis, None if it is complete."""
    lacking = missing(_offset_of(books, vehicle))
    if not lacking or vehicle.spec.kind is not VehicleKind.HOIST:
        return None
    return Refusal(
        "not-now",
        f"{vehicle.id} has no OFFSET ({named(lacking)})",
        f"teach it: POST /api/v1/teaching/sessions; or PUT /api/v1/vehicles/{vehicle.id}/offset",
    )


def _offset_of(books: Books, vehicle: VehicleNow) -> AxisPulses | None:
    return books.teaching.offset_of(vehicle.id, books.offsets.get(vehicle.id))


def _taught(books: Books, vehicle: VehicleNow, station: Station) -> PulseSet | Refusal:
    if refusal := no_dest(books, station.id) or no_offset(books, vehicle):
        return refusal
    sum_ = target(books.dests[station.id].pulses, _offset_of(books, vehicle))
    if not isinstance(sum_, PulseSet):
        raise TypeError(f"{station.id} and {vehicle.id} are complete, their sum is not")
    return sum_
