"""Where a vehicle's axes must go at a station: DEST + OFFSET, or why that cannot be said (DOMAIN section 3)."""

from app.domain.errors import Refusal
from app.domain.layout import NO_OFFSET, Axis, PulseSet, Station, StationKind
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow


def target_for(
    books: Books, vehicle: VehicleNow, station: Station, given: PulseSet | None = None
) -> PulseSet | Refusal | None:
    """Return the pulses for a port, within the vehicle's limits; ``given`` ones before taught ones. None for a side buffer."""
    if station.kind is not StationKind.PORT:
        return None
    dest, offset = books.dests.get(station.id), books.offsets.get(vehicle.id)
    if given is None and dest is None:
        return Refusal(
            "not-now",
            f"{station.id} has no DEST (SHFT, ROTA, LIFT)",
            f"teach it, or PUT /api/v1/stations/{station.id}/dest",
        )
    if given is None and offset is None:
        return Refusal(
            "not-now",
            f"{vehicle.id} has no OFFSET (SHFT, ROTA, LIFT)",
            f"teach it, or PUT /api/v1/vehicles/{vehicle.id}/offset",
        )
    pulses = given or (dest.pulses if dest else NO_OFFSET).plus(offset.pulses if offset else NO_OFFSET)
    for axis in Axis:
        low, high = vehicle.spec.limits.of(axis)
        if not low <= pulses.of(axis) <= high:
            return Refusal(
                "invalid",
                f"{axis.name} {pulses.of(axis)} for {station.id} is outside {low}..{high} of {vehicle.id}",
                "correct the DEST of the station, the OFFSET of the vehicle, or the limits in the plant file",
            )
    return pulses
