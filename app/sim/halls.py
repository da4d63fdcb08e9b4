"""The simulated devices on the lines that carry several: AGVs, buffers and doors of ENIG links, drives of HI lines."""

from collections.abc import Mapping

import networkx as nx

from app.domain.devices import AgvMode, AgvSpeed, DeviceId, DeviceNumber
from app.domain.drive import DriveId
from app.domain.ids import LinkId, StationId, VehicleId
from app.domain.layout import DriveUnit, LinkSpec, Plant, StationKind, VehicleKind, VehicleSpec, Wire
from app.domain.ports import Endpoint
from app.domain.units import Barcode, Seconds
from app.plant.dialects import drive_dialect_of, hall_dialect_of
from app.protocols.enig.messages import SetCurrent
from app.protocols.enig.simulator import (
    AgvOptions,
    Hall,
    SimulatedAgv,
    SimulatedBuffer,
    SimulatedDoor,
    SimulatedLink,
    Tape,
)
from app.protocols.hi.dialects import Dialect
from app.protocols.hi.simulator import SimulatedDrive, SimulatedLine
from app.sim.truth import Truth


class SimulatedHalls:
    """AGVs ready on their tape (in auto, their tag read), doors as they are at rest, buffers with the carts of the plant file.

    ``starts`` says where the AGVs without a start in the plant file are put. Carts are carriers: ``truth`` knows where they are.
    """

    def __init__(
        self, plant: Plant, starts: Mapping[VehicleId, Barcode], now: Seconds, truth: Truth | None = None
    ) -> None:
        self._plant = plant
        self._truth = truth or Truth(plant)
        full = {station for _, station in plant.carriers}
        held = {station.buffer for station in plant.stations if station.buffer and station.id in full}
        self.doors: Mapping[DeviceId, SimulatedDoor] = {
            door.id: SimulatedDoor(door.number, is_open=door.normally_open) for door in plant.doors
        }
        self.buffers: Mapping[DeviceId, SimulatedBuffer] = {
            buffer.id: SimulatedBuffer(buffer.number, cart=buffer.id in held) for buffer in plant.buffers
        }
        self._tape, self._stations = Tape(()), dict[Barcode, StationId]()
        self._lay(starts)
        self.agvs: Mapping[VehicleId, SimulatedAgv] = self._agvs(starts)
        self.drives: dict[DriveId, SimulatedDrive] = {}
        self.lines: Mapping[LinkId, Endpoint] = {link.id: self._line(link) for link in plant.links}
        for vehicle, agv in self.agvs.items():
            agv.set_mode(AgvMode.AUTO, now)
            agv.take(SetCurrent(starts[vehicle]), now)

    def follow(self, plant: Plant, places: Mapping[VehicleId, Barcode]) -> None:
        """Lay the tape anew, with its stations and chargers. All devices stay as they are; ``places`` is where the AGVs are."""
        self._plant = plant
        self._lay(places)

    def _lay(self, places: Mapping[VehicleId, Barcode]) -> None:
        """Lay the tape that is connected with one of the AGVs' places."""
        plant = self._plant
        agvs = [spec.id for spec in plant.vehicles if spec.kind is VehicleKind.AGV and spec.id in places]
        floor = _connected(
            plant, [places[agv] for agv in agvs if places[agv] in {point.barcode for point in plant.points}]
        )
        self._tape.lay(
            [edge for edge in plant.edges if edge.start in floor],
            {str(alias): tag for alias, tag in plant.aliases.items()},
            [charger.barcode for charger in plant.chargers],
        )
        self._stations.clear()
        self._stations.update({s.barcode: s.id for s in plant.stations if s.kind is StationKind.AGV_BUFFER})

    def _agvs(self, starts: Mapping[VehicleId, Barcode]) -> dict[VehicleId, SimulatedAgv]:
        plant = self._plant
        specs = [spec for spec in plant.vehicles if spec.kind is VehicleKind.AGV]
        doors = {passage: self.doors[door.id] for door in plant.doors for passage in door.passages}
        buffers = {s.barcode: self.buffers[s.buffer] for s in plant.stations if s.buffer is not None}
        return {
            spec.id: SimulatedAgv(
                DeviceNumber(spec.dev_id),
                self._tape,
                starts[spec.id],
                options=_options(spec),
                hall=TrueHall(spec.id, self._truth, self._stations, doors, buffers),
            )
            for spec in specs
        }

    def _line(self, link: LinkSpec) -> Endpoint:
        if link.wire is Wire.HI:
            dialect = drive_dialect_of(link)
            drives = {unit.id: self._drive(unit, dialect) for unit in self._plant.drives_on(link.id)}
            self.drives |= drives
            return SimulatedLine(drives.values(), dialect)
        agvs = [self.agvs[spec.id] for spec in self._plant.agvs_on(link.id)]
        buffers = [self.buffers[spec.id] for spec in self._plant.buffers if spec.link == link.id]
        doors = [self.doors[spec.id] for spec in self._plant.doors if spec.link == link.id]
        return SimulatedLink([*agvs, *buffers, *doors], hall_dialect_of(link))

    def _drive(self, unit: DriveUnit, dialect: Dialect) -> SimulatedDrive:
        """Return a drive whose parameters are as its catalogue says they come from the factory."""
        drive = SimulatedDrive(unit.address, dialect)
        for spec in self._plant.catalogue_of(unit).parameters.values():
            if spec.default is not None:
                drive.set_value(spec.number, min(spec.default, dialect.highest_value))
        return drive


def _options(spec: VehicleSpec) -> AgvOptions:
    """Return an AGV that drives as fast as the plant file says; its half is slow (our choice)."""
    speeds = {
        AgvSpeed.SLOW: spec.max_speed / 2,
        AgvSpeed.NORMAL: float(spec.max_speed),
        AgvSpeed.FAST: float(spec.max_speed),
    }
    return AgvOptions(speeds=speeds)


class TrueHall(Hall):
    """The hall around one AGV, where carts are carriers: its lift takes them from stations and puts them there.

    The buffer device of a station sees what stands there.
    """

    def __init__(
        self,
        vehicle: VehicleId,
        truth: Truth,
        stations: Mapping[Barcode, StationId],
        doors: Mapping[tuple[Barcode, Barcode], SimulatedDoor],
        buffers: Mapping[Barcode, SimulatedBuffer],
    ) -> None:
        super().__init__(doors, buffers)
        self._vehicle, self._truth, self._stations = vehicle, truth, stations
        self._devices = buffers

    def take_cart(self, tag: Barcode, now: Seconds) -> bool:
        """Return whether a lift that has risen here has a cart on it now. Away from stations there is nothing to take."""
        if tag not in self._stations:
            return False
        taken = self._truth.take(self._vehicle, tag, StationKind.AGV_BUFFER, None)
        self._show(tag, now)
        return taken

    def put_cart(self, tag: Barcode, now: Seconds) -> bool:
        """Return whether a lift that has sunk here has left its cart at a station."""
        if tag not in self._stations:
            return False
        put = self._truth.put(self._vehicle, tag, StationKind.AGV_BUFFER, None)
        self._show(tag, now)
        return put

    def _show(self, tag: Barcode, now: Seconds) -> None:
        if tag in self._devices:
            self._devices[tag].set_cart(now, cart=self._stations[tag] in self._truth.at)


def _connected(plant: Plant, starts: list[Barcode]) -> set[Barcode]:
    """Return all barcodes that track connects with one of these."""
    graph: nx.Graph[Barcode] = nx.Graph()
    graph.add_nodes_from(point.barcode for point in plant.points)
    graph.add_edges_from((edge.start, edge.end) for edge in plant.edges)
    return {barcode for start in starts for barcode in nx.node_connected_component(graph, start)}
