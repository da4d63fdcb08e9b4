"""Several ENIG devices on one serial line (a pseudo terminal) with noise, under the running controller (PROTOCOLS E23)."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random

from app.domain.device_requests import CommandDevice
from app.domain.devices import AgvMode, DeviceAct, DeviceId
from app.domain.ids import Actor, VehicleId
from app.domain.layout import SerialPort, Wire
from app.domain.requests import Accepted
from app.domain.view import DeviceView, Topic, VehicleView
from app.plant import read
from app.protocols.itsc.simulator.faults import Faulty
from app.runtime.clock import Clock
from app.runtime.controller import Controller
from app.runtime.lines import Line
from app.runtime.pty import PtyPort
from app.sim.plantworld import SimulatedPlant
from app.wire.faults import Fault, Lane
from tests.runtime.peers import run, until

KIM = Actor("kim")
NOW = Clock().now
BAD = {Fault.NOISE: 0.1, Fault.SPLIT: 0.3, Fault.DUPLICATE: 0.1, Fault.CORRUPT: 0.05}
HALL = Path(__file__).parents[2] / "plants" / "hall.yaml"
DOOR, BUFFER, AGV = DeviceId("DOOR1"), DeviceId("BUFFER1"), VehicleId("AGV1")


@dataclass
class Rig:
    """The controller, the hall at the other end of its serial line, and the cable between them."""

    controller: Controller
    floor: SimulatedPlant
    device: Faulty
    port: PtyPort

    def view(self, device: DeviceId) -> DeviceView:
        view = self.controller.model.get(Topic.DEVICES, device)
        assert isinstance(view, DeviceView)
        return view

    def agv(self) -> VehicleView:
        view = self.controller.model.get(Topic.VEHICLES, AGV)
        assert isinstance(view, VehicleView)
        return view

    async def here(self) -> None:
        """Wait until every device of the line has reported."""
        await until(lambda: self.controller.model.get(Topic.VEHICLES, AGV) is not None)
        await until(lambda: self.view(DOOR).fresh and self.view(BUFFER).fresh and self.agv().activity == "idle")

    async def ask(self, act: DeviceAct) -> None:
        assert isinstance(await self.controller.ask(CommandDevice(KIM, DOOR, act)), Accepted)


@asynccontextmanager
async def rig(directory: Path) -> AsyncIterator[Rig]:
    """Start everything; the drives of the plant are not there."""
    plant, _ = read(HALL.read_text(encoding="utf-8"), HALL.name)
    (hall,) = (link for link in plant.links if link.wire is Wire.ENIG)
    serial = replace(hall, host="", port=0, serial=SerialPort(str(directory / "hall")))
    plant = replace(plant, links=(serial,), drives=())
    floor = SimulatedPlant(plant, now=NOW())
    device = Faulty(floor.lines[hall.id], Lane(Random(1)), Lane(Random(2)))
    port = PtyPort(Line(device, NOW), directory / "hall")
    await port.start()
    controller = Controller(plant, f"sqlite:///{directory / 'plant.db'}")
    await controller.start()
    try:
        yield Rig(controller, floor, device, port)
    finally:
        await controller.stop()
        await port.stop()


def test_a_door_a_buffer_and_agvs_share_one_serial_line_through_noise(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = tmp_path / str(len(list(tmp_path.iterdir())))
        directory.mkdir()
        async with rig(directory) as bench:
            await bench.here()
            assert bench.view(BUFFER).state == "cart"
            bench.device.in_lane.rates = bench.device.out_lane.rates = BAD
            await bench.ask(DeviceAct.OPEN)
            await until(lambda: bench.view(DOOR).state == "open")
            assert bench.floor.halls.doors[DOOR].is_open
            bench.floor.halls.agvs[AGV].set_mode(AgvMode.MANUAL, NOW())
            await until(lambda: bench.agv().mode == "mant")
            (line,) = bench.controller.links()
            assert (line.up, line.wire) == (True, "enig")

    run(scenario)


def test_a_serial_line_that_is_unplugged_leaves_its_devices_silent_and_brings_them_back(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = tmp_path / str(len(list(tmp_path.iterdir())))
        directory.mkdir()
        async with rig(directory) as bench:
            await bench.here()
            await bench.port.stop()
            await until(lambda: not bench.view(DOOR).fresh and not bench.agv().link.up)
            await bench.port.start()
            await bench.here()

    run(scenario)
