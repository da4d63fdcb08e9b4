"""The simulated plant: every device of a plant file, in one physical world."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial

from app.domain.devices import CartState
from app.domain.ids import VehicleId
from app.domain.layout import Plant, VehicleKind, VehicleSpec
from app.domain.ports import Endpoint
from app.domain.units import Barcode, Seconds
from app.plant.dialects import dialect_of
from app.plant.difference import difference
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
        self._track = Track.of(plant)
        self._surroundings, self._options = surroundings or self.truth, options
        placed = starts(plant)
        self.devices = {spec.id: self._hoist(spec, placed[spec.id], now) for spec in plant.hoists}
        self.halls = SimulatedHalls(plant, placed, now, self.truth)
        self.lines: Mapping[str, Endpoint] = {
            str(name): end for name, end in (*self.devices.items(), *self.halls.lines.items())
        }

    def _hoist(self, spec: VehicleSpec, start: Barcode, now: Seconds) -> SimulatedVehicle:
        hoist = SimulatedVehicle(
            spec,
            self._track,
            dialect=dialect_of(self.plant, spec.dialect),
            surroundings=self._surroundings,
            options=self._options,
            start=start,
            aligned=partial(self.truth.aligned, spec.id),
        )
        hoist.make_ready(now)
        return hoist

    def follow(self, plant: Plant, now: Seconds) -> tuple[list[VehicleSpec], list[VehicleId]]:
        """Become another plant while vehicles drive; return the hoists that came and those that went.

        Track, stations and hoists follow; ``lines`` stays as it was, and so does whatever :func:`unfollowed` names.
        A hoist that came stands ready where the plant file puts it, or, if somebody is there, where nobody is.
        """
        self.plant = plant
        self._track.lay(plant.edges)
        self.truth.follow(plant)
        here = {vehicle: place[0] for vehicle, place in self.places(now).items()}
        self.halls.follow(plant, here)
        gone = [name for name in self.devices if name not in {spec.id for spec in plant.hoists}]
        for name in gone:
            del self.devices[name], here[name]
        came = [spec for spec in plant.hoists if spec.id not in self.devices]
        placed = starts(replace(plant, vehicles=tuple(came)), here.values())
        for spec in came:
            self.devices[spec.id] = self._hoist(spec, placed[spec.id], now)
        return came, gone

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


def unfollowed(old: Plant, new: Plant) -> list[str]:
    """Return in words what a simulated plant does not follow when it becomes another: changed machines, and those on links."""
    told = []
    for change in difference(old, new).changes:
        hoist = change.what == "vehicle" and change.how != "changed" and not _is_agv(old, new, change.name)
        if change.what in {"vehicle", "link", "door", "buffer", "drive"} and not hoist:
            told.append(f"{change.what} {change.name} {change.how}")
    return told


def _is_agv(old: Plant, new: Plant, name: str) -> bool:
    return any(vehicle.id == name and vehicle.kind is VehicleKind.AGV for vehicle in (*old.vehicles, *new.vehicles))


def starts(plant: Plant, others: Iterable[Barcode] = ()) -> dict[VehicleId, Barcode]:
    """Return where each vehicle of a plant stands at first, where ``others`` stand already."""
    there = set(others)
    found: dict[VehicleId, Barcode] = {v.id: v.start for v in plant.vehicles if v.start and v.start not in there}
    taken = {*found.values(), *there}
    spare = iter(sorted((p for p in plant.points if p.barcode not in taken), key=lambda p: not p.park))
    return {vehicle.id: found.get(vehicle.id) or next(spare).barcode for vehicle in plant.vehicles}
