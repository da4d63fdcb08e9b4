"""The simulated devices on the lines that carry several: AGVs, buffers and doors of ENIG links, drives of HI lines."""

from collections.abc import Mapping

import networkx as nx

from app.domain.devices import AgvMode, DeviceId, DeviceNumber
from app.domain.drive import DriveId
from app.domain.ids import LinkId, VehicleId
from app.domain.layout import DriveUnit, LinkSpec, Plant, VehicleKind, Wire
from app.domain.ports import Endpoint
from app.domain.units import Barcode, Seconds
from app.plant.dialects import drive_dialect_of, hall_dialect_of
from app.protocols.enig.messages import SetCurrent
from app.protocols.enig.simulator import (
    Hall,
    SimulatedAgv,
    SimulatedBuffer,
    SimulatedDoor,
    SimulatedLink,
    Tape,
)
from app.protocols.hi.dialects import Dialect
from app.protocols.hi.simulator import SimulatedDrive, SimulatedLine


class SimulatedHalls:
    """AGVs ready on their tape (in auto, their tag read), doors as they are at rest, buffers with the carts of the plant file.

    ``starts`` says where the AGVs without a start in the plant file are put.
    """

    def __init__(self, plant: Plant, starts: Mapping[VehicleId, Barcode], now: Seconds) -> None:
        self._plant = plant
        full = {station for _, station in plant.carriers}
        held = {station.buffer for station in plant.stations if station.buffer and station.id in full}
        self.doors: Mapping[DeviceId, SimulatedDoor] = {
            door.id: SimulatedDoor(door.number, is_open=door.normally_open) for door in plant.doors
        }
        self.buffers: Mapping[DeviceId, SimulatedBuffer] = {
            buffer.id: SimulatedBuffer(buffer.number, cart=buffer.id in held) for buffer in plant.buffers
        }
        self.agvs: Mapping[VehicleId, SimulatedAgv] = self._agvs(starts)
        self.drives: dict[DriveId, SimulatedDrive] = {}
        self.lines: Mapping[LinkId, Endpoint] = {link.id: self._line(link) for link in plant.links}
        for vehicle, agv in self.agvs.items():
            agv.set_mode(AgvMode.AUTO, now)
            agv.take(SetCurrent(starts[vehicle]), now)

    def _agvs(self, starts: Mapping[VehicleId, Barcode]) -> dict[VehicleId, SimulatedAgv]:
        plant = self._plant
        specs = [spec for spec in plant.vehicles if spec.kind is VehicleKind.AGV]
        floor = _connected(plant, [starts[spec.id] for spec in specs])
        tape = Tape(
            [edge for edge in plant.edges if edge.start in floor],
            {str(alias): tag for alias, tag in plant.aliases.items()},
            [charger.barcode for charger in plant.chargers],
        )
        doors = {passage: self.doors[door.id] for door in plant.doors for passage in door.passages}
        buffers = {s.barcode: self.buffers[s.buffer] for s in plant.stations if s.buffer is not None}
        hall = Hall(doors, buffers)
        return {spec.id: SimulatedAgv(DeviceNumber(spec.dev_id), tape, starts[spec.id], hall=hall) for spec in specs}

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


def _connected(plant: Plant, starts: list[Barcode]) -> set[Barcode]:
    """Return all barcodes that track connects with one of these."""
    graph: nx.Graph[Barcode] = nx.Graph()
    graph.add_nodes_from(point.barcode for point in plant.points)
    graph.add_edges_from((edge.start, edge.end) for edge in plant.edges)
    return {barcode for start in starts for barcode in nx.node_connected_component(graph, start)}
