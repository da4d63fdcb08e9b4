"""What a changed plant file brings along that nobody can serve, or that cannot serve, until it is taught."""

from collections.abc import Iterator

from app.domain.layout import Plant, StationKind, VehicleKind
from app.domain.pulses import missing, named
from app.domain.records import Kept
from app.plant.difference import Broken


def lacking(old: Plant, new: Plant, kept: Kept) -> list[Broken]:
    """Return the new ports and hoists whose pulses the database lacks: those in a plant file count only where it is made.

    None of it keeps a change back; jobs to such a port wait. ``kept`` is what the database of the running plant has.
    """
    return [*_ports(old, new, kept), *_hoists(old, new, kept)]


def _ports(old: Plant, new: Plant, kept: Kept) -> Iterator[Broken]:
    before = {station.id for station in old.stations}
    taught = {dest.station: dest.pulses for dest in kept.dests}
    for station in new.stations:
        axes = missing(taught.get(station.id))
        if station.kind is StationKind.PORT and station.id not in before and axes:
            remedy = f"teach it: POST /api/v1/teaching/sessions; or PUT /api/v1/stations/{station.id}/dest"
            yield Broken("station", station.id, f"{station.id} has no DEST ({named(axes)})", remedy, ("teaching",))


def _hoists(old: Plant, new: Plant, kept: Kept) -> Iterator[Broken]:
    before = {vehicle.id for vehicle in old.vehicles}
    taught = {offset.vehicle: offset.pulses for offset in kept.offsets}
    for vehicle in new.vehicles:
        axes = missing(taught.get(vehicle.id))
        known = vehicle.id in before or vehicle.id in new.reference_vehicles
        if vehicle.kind is VehicleKind.HOIST and axes and not known:
            remedy = f"teach it: POST /api/v1/teaching/sessions; or PUT /api/v1/vehicles/{vehicle.id}/offset"
            yield Broken("vehicle", vehicle.id, f"{vehicle.id} has no OFFSET ({named(axes)})", remedy, ("teaching",))
