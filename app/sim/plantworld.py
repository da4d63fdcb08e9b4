"""The simulated plant: every vehicle of a plant file, in one physical world."""

from collections.abc import Callable, Mapping

from app.domain.ids import VehicleId
from app.domain.layout import Plant
from app.domain.units import Barcode, Seconds
from app.plant.dialects import dialect_of
from app.protocols.itsc.simulator import Options, Place, SimulatedVehicle, Track
from app.sim.truth import Act, Truth

START = Seconds(0.0)


class SimulatedPlant:
    """Vehicles ready on their rails (servos on, homed, in AUTO), carriers where the plant file has them.

    A vehicle without a start in the plant file is put on the first barcode, in the file's order, that is free; waiting places
    first. ``seen`` is told every physical act at a station.
    """

    def __init__(
        self,
        plant: Plant,
        seen: Callable[[Act], None] = lambda act: None,
        options: Options | None = None,
        now: Seconds = START,
    ) -> None:
        self.plant = plant
        self.truth = Truth(plant, seen)
        track = Track.of(plant)
        starts = _starts(plant)
        self.devices: Mapping[VehicleId, SimulatedVehicle] = {
            spec.id: SimulatedVehicle(
                spec,
                track,
                dialect=dialect_of(plant, spec.dialect),
                surroundings=self.truth,
                options=options,
                start=starts[spec.id],
            )
            for spec in plant.vehicles
        }
        for device in self.devices.values():
            device.make_ready(now)

    def places(self, now: Seconds) -> dict[VehicleId, Place]:
        """Return where every vehicle is."""
        return {vehicle: device.place(now) for vehicle, device in self.devices.items()}

    def loaded(self) -> dict[VehicleId, bool]:
        """Return which vehicles' sensors see a carrier."""
        return {vehicle: device.state.foup for vehicle, device in self.devices.items()}

    def refuses(self, vehicle: VehicleId) -> bool:
        """Whether a vehicle takes no connection now."""
        return not self.devices[vehicle].accepting


def _starts(plant: Plant) -> dict[VehicleId, Barcode]:
    found: dict[VehicleId, Barcode] = {v.id: v.start for v in plant.vehicles if v.start is not None}
    taken = set(found.values())
    spare = iter(sorted((p for p in plant.points if p.barcode not in taken), key=lambda p: not p.park))
    return {vehicle.id: found.get(vehicle.id) or next(spare).barcode for vehicle in plant.vehicles}
