"""Physical truth: where each carrier really is. Changed by the simulated vehicles alone, never seen by the controller."""

from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from zlib import crc32

from app.domain.ids import CarrierId, StationId, VehicleId
from app.domain.layout import NO_OFFSET, Axis, Plant, PulseSet, Station, StationKind, VehicleSpec
from app.domain.units import Barcode, Pulses


class Deed(StrEnum):
    """What a gripper did."""

    TAKE = "take"
    PUT = "put"
    TAKE_FAILED = "take_failed"
    PUT_FAILED = "put_failed"


@dataclass(frozen=True, slots=True)
class Act:
    """One physical happening at a station. ``carrier`` is None where nothing was there to take."""

    deed: Deed
    vehicle: VehicleId
    station: StationId | None
    carrier: CarrierId | None
    barcode: Barcode


class Truth:
    """Carriers at stations and aboard vehicles.

    Serves the simulated vehicles as their surroundings. A gripper that closes on nothing, or that opens over a carrier that is
    there already, is recorded as a failed act, whatever the vehicle then does. ``seen`` is told each act as it happens.
    """

    def __init__(self, plant: Plant, seen: Callable[[Act], None] = lambda act: None) -> None:
        self.at: dict[StationId, CarrierId] = {station: carrier for carrier, station in plant.carriers}
        self.aboard: dict[VehicleId, CarrierId] = {}
        self.total = len(plant.carriers)
        """How many carriers there must be."""
        self._seen = seen
        self._build(plant)

    def _build(self, plant: Plant) -> None:
        self._offsets = {vehicle.id: _true_offset(plant, vehicle) for vehicle in plant.vehicles}
        self._dests = {station.id: _true_dest(station) for station in plant.stations}
        self._places: defaultdict[tuple[Barcode, StationKind], list[Station]] = defaultdict(list)
        for station in plant.stations:
            self._places[station.barcode, station.kind].append(station)

    def follow(self, plant: Plant) -> None:
        """Build the plant anew. What stood at a station that goes, or was aboard a vehicle that does, goes with it."""
        self._build(plant)
        for station in [station for station in self.at if station not in self._dests]:
            self.remove(station)
        for vehicle in [vehicle for vehicle in self.aboard if vehicle not in self._offsets]:
            del self.aboard[vehicle]
            self.total -= 1

    def take(self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None) -> bool:
        """Close the gripper; return whether it holds a carrier now that was at the station."""
        station = self._station(vehicle, barcode, kind, target)
        carrier = self.at.get(station) if station is not None else None
        if station is None or carrier is None or vehicle in self.aboard:
            self._seen(Act(Deed.TAKE_FAILED, vehicle, station, carrier, barcode))
            return False
        del self.at[station]
        self.aboard[vehicle] = carrier
        self._seen(Act(Deed.TAKE, vehicle, station, carrier, barcode))
        return True

    def put(self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None) -> bool:
        """Open the gripper; return whether the carrier that was aboard stands at the station now."""
        station = self._station(vehicle, barcode, kind, target)
        carrier = self.aboard.get(vehicle)
        if station is None or carrier is None or station in self.at:
            self._seen(Act(Deed.PUT_FAILED, vehicle, station, carrier, barcode))
            return False
        del self.aboard[vehicle]
        self.at[station] = carrier
        self._seen(Act(Deed.PUT, vehicle, station, carrier, barcode))
        return True

    def install(self, carrier: CarrierId, station: StationId) -> None:
        """Put a carrier down from outside, as equipment does. Raises ValueError: something stands there."""
        if station in self.at:
            raise ValueError(f"{self.at[station]} stands at {station}")
        self.at[station] = carrier
        self.total += 1

    def remove(self, station: StationId) -> CarrierId:
        """Take a carrier away, as equipment does. Raises KeyError: nothing stands there."""
        self.total -= 1
        return self.at.pop(station)

    def aligned(self, vehicle: VehicleId, barcode: Barcode) -> PulseSet | None:
        """Return where the axes stand once a person has brought this hoist over the port at a barcode; None: none is there.

        The port's own place and the hoist's own mechanics decide, whatever anybody has taught. Of several ports the first.
        """
        ports = self._places.get((barcode, StationKind.PORT), [])
        return self._dests[ports[0].id].plus(self._offsets.get(vehicle, NO_OFFSET)) if ports else None

    def _station(
        self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None
    ) -> StationId | None:
        """Return the station that a gripper with these pulses reaches; where several share a barcode, the nearest."""
        found = self._places.get((barcode, kind), [])
        if target is None or len(found) < 2:
            return found[0].id if found else None
        offset = self._offsets.get(vehicle, NO_OFFSET)

        def off_by(station: Station) -> int:
            reached = self._dests[station.id].plus(offset)
            return sum(abs(reached.of(axis) - target.of(axis)) for axis in Axis)

        return min(found, key=off_by).id


def _true_dest(station: Station) -> PulseSet:
    """Return where a port really is: as the plant file says, else somewhere plausible that its name gives (our choice)."""
    number = crc32(station.id.encode())
    shft, rota, lift = 1400 + number % 400, number // 400 % 460 - 230, 41_000 + number // 7 % 1_800
    return station.dest or PulseSet(Pulses(shft), Pulses(rota), Pulses(lift))


def _true_offset(plant: Plant, vehicle: VehicleSpec) -> PulseSet:
    """Return a hoist's own mechanics, likewise. A reference vehicle has none: the plant says so."""
    if vehicle.id in plant.reference_vehicles:
        return NO_OFFSET
    number = crc32(vehicle.id.encode())
    shft, rota, lift = number % 41 - 20, number // 41 % 17 - 8, number // 7 % 301 - 150
    return vehicle.offset or PulseSet(Pulses(shft), Pulses(rota), Pulses(lift))
