"""What a new version changes: every port and vehicle whose pulses would be others (DOMAIN section 3)."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from app.domain.ids import StationId, VehicleId
from app.domain.layout import NO_OFFSET, Axis, Plant, VehicleKind
from app.domain.pulses import AxisPulses, PartialPulses, beyond, known, target
from app.domain.records import StationDest, VehicleOffset

Dests = Mapping[StationId, StationDest]
Offsets = Mapping[VehicleId, VehicleOffset]


@dataclass(frozen=True, slots=True)
class Change:
    """What one vehicle is sent at one port, before and after; an axis is None where it is not known.

    ``beyond`` says what is outside the vehicle's limits afterwards, empty if nothing is.
    """

    station: StationId
    vehicle: VehicleId
    old: AxisPulses
    new: AxisPulses
    beyond: str = ""


def offset_of(plant: Plant, vehicle: VehicleId, offsets: Offsets) -> AxisPulses | None:
    """Return a vehicle's OFFSET: what was taught, or zero by declaration."""
    if vehicle in plant.reference_vehicles:
        return NO_OFFSET
    taught = offsets.get(vehicle)
    return taught.pulses if taught else None


def of_dest(
    plant: Plant, offsets: Offsets, station: StationId, old: AxisPulses | None, new: AxisPulses
) -> list[Change]:
    """Return what changes when a port's DEST does: one row for each hoist whose pulses there do."""
    pairs = ((spec.id, offset_of(plant, spec.id, offsets)) for spec in plant.vehicles if spec.kind is VehicleKind.HOIST)
    rows = ((vehicle, target(old, offset), target(new, offset)) for vehicle, offset in pairs)
    return list(_changed(plant, ((station, vehicle, before, after) for vehicle, before, after in rows)))


def of_offset(plant: Plant, dests: Dests, vehicle: VehicleId, old: AxisPulses | None, new: AxisPulses) -> list[Change]:
    """Return what changes when a vehicle's OFFSET does: one row for each port whose pulses for it do."""
    there = [station.id for station in plant.stations if station.id in dests]
    rows = ((port, target(dests[port].pulses, old), target(dests[port].pulses, new)) for port in there)
    return list(_changed(plant, ((port, vehicle, before, after) for port, before, after in rows)))


def _changed(plant: Plant, rows: Iterator[tuple[StationId, VehicleId, AxisPulses, AxisPulses]]) -> Iterator[Change]:
    for station, vehicle, old, new in rows:
        spec = plant.vehicle(vehicle)
        if old != new and spec is not None:
            yield Change(station, vehicle, old, new, beyond(new, spec.limits))


def differences(old: AxisPulses | None, new: AxisPulses | None) -> AxisPulses:
    """Return new - old for the axes that both have."""
    before, after = known(old), known(new)
    found = {axis: after[axis] - before[axis] for axis in Axis if axis in before and axis in after}
    return PartialPulses(**{axis.value: value for axis, value in found.items()})  # type: ignore[arg-type]
