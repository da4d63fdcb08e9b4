"""The simulated plant: every device of a plant file, in one physical world."""

from collections.abc import Callable, Mapping
from functools import partial

from app.domain.devices import CartState
from app.domain.ids import VehicleId
from app.domain.layout import Plant
from app.domain.ports import Endpoint
from app.domain.units import Barcode, Seconds
from app.plant.dialects import dialect_of
from app.protocols.itsc.simulator import Options, Place, SimulatedVehicle, Surroundings, Track
from app.sim.halls import SimulatedHalls
from app.sim.truth import Act, Truth

START = Seconds(0.0)


class SimulatedPlant:
    """Hoists ready on their rails (servos on, homed, in AUTO), AGVs ready too, carriers where the plant file has them.

    ``devices`` are the hoists, ``halls`` everything on lines that carry several devices; ``lines`` are the far ends of all lines.

    A vehicle without a start in the plant file is put on the first barcode, in the file's order, that is free; waiting places
    first. ``seen`` is told every physical act at a station. ``surroundings`` take the
    place of that physical world for the hoists, where they are only some of those that are in it.
    """

    def __init__(
        self,
        plant: Plant,
        seen: Callable[[Act], None] = lambda act: None,
        options: Options | None = None,
        now: Seconds = START,
        surroundings: Surroundings | None = None,
    ) -> None:
        self.plant = plant
        self.truth = Truth(plant, seen)
        track = Track.of(plant)
        placed = starts(plant)
        self.devices: Mapping[VehicleId, SimulatedVehicle] = {
            spec.id: SimulatedVehicle(
                spec,
                track,
                dialect=dialect_of(plant, spec.dialect),
                surroundings=surroundings or self.truth,
                options=options,
                start=placed[spec.id],
                aligned=partial(self.truth.aligned, spec.id),
            )
            for spec in plant.hoists
        }
        for device in self.devices.values():
            device.make_ready(now)
        self.halls = SimulatedHalls(plant, placed, now, self.truth)
        self.lines: Mapping[str, Endpoint] = {
            str(name): end for name, end in (*self.devices.items(), *self.halls.lines.items())
        }

    def places(self, now: Seconds) -> dict[VehicleId, Place]:
        """Return where every vehicle is."""
        hoists = {vehicle: device.place(now) for vehicle, device in self.devices.items()}
        return hoists | {vehicle: agv.place(now) for vehicle, agv in self.halls.agvs.items()}

    def loaded(self) -> dict[VehicleId, bool]:
        """Return which vehicles' sensors see a carrier."""
        hoists = {vehicle: device.state.foup for vehicle, device in self.devices.items()}
        agvs = self.halls.agvs.items()
        return hoists | {vehicle: agv.report.cart == CartState.PRESENT for vehicle, agv in agvs}

    def refuses(self, line: str) -> bool:
        """Whether the far end of a line takes no connection now."""
        hoist = self.devices.get(VehicleId(line))
        return hoist is not None and not hoist.accepting


def starts(plant: Plant) -> dict[VehicleId, Barcode]:
    """Return where each vehicle of a plant stands at first."""
    found: dict[VehicleId, Barcode] = {v.id: v.start for v in plant.vehicles if v.start is not None}
    taken = set(found.values())
    spare = iter(sorted((p for p in plant.points if p.barcode not in taken), key=lambda p: not p.park))
    return {vehicle.id: found.get(vehicle.id) or next(spare).barcode for vehicle in plant.vehicles}
