"""Drives on a real serial port (a pseudo terminal) and behind a TCP serial server, under the running controller."""

import asyncio
import warnings
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random

import pytest

from app.domain.drive import DriveId, Parameter, RawValue, Turn
from app.domain.drive_requests import (
    BackUpDrive,
    DriveOrder,
    JogDrive,
    KeepDriveJog,
    ReadDrive,
    ReleaseDriveJog,
    WriteDrive,
)
from app.domain.ids import Actor, LinkId
from app.domain.layout import LinkSpec, SerialPort, Wire
from app.domain.requests import Accepted
from app.domain.units import Seconds
from app.domain.view import DriveView, OperationView, ParameterView, Topic
from app.protocols.hi.messages import Mode
from app.protocols.hi.simulator import SimulatedDrive, SimulatedLine
from app.protocols.itsc.simulator.faults import Faulty
from app.runtime.clock import Clock
from app.runtime.controller import Controller
from app.runtime.lines import Line
from app.runtime.pty import PtyPort
from app.runtime.transports import DeviceServer
from app.wire.faults import Fault, Lane
from tests.control.drive_bench import D1, LINE, drive_plant
from tests.runtime.peers import run, until

KIM = Actor("kim")
NOW = Clock().now
BAD = {Fault.DROP: 0.02, Fault.NOISE: 0.1, Fault.SPLIT: 0.2}
P = Parameter


class TwoWire(Faulty):
    """A bad line on which the adapter hears what it sends."""

    def received(self, data: bytes, now: Seconds) -> None:
        self.out_lane.put(data, now)
        super().received(data, now)


@dataclass
class Rig:
    """The controller, the drives at the other end of its line, and the cable between them."""

    controller: Controller
    drives: dict[DriveId, SimulatedDrive]
    device: Faulty
    port: PtyPort | DeviceServer

    def view(self) -> DriveView:
        view = self.controller.model.get(Topic.DRIVES, D1)
        assert isinstance(view, DriveView)
        return view

    async def online(self) -> None:
        await until(lambda: self.controller.model.get(Topic.DRIVES, D1) is not None)
        await until(lambda: self.view().online is True)

    async def begin(self, request: DriveOrder) -> int:
        reply = await self.controller.ask(request)
        assert isinstance(reply, Accepted), reply
        return int(reply.key)

    def operation(self, number: int) -> OperationView:
        view = self.controller.model.get(Topic.OPERATIONS, str(number))
        assert isinstance(view, OperationView)
        return view

    async def do(self, request: DriveOrder) -> OperationView:
        number = await self.begin(request)
        await until(lambda: self.operation(number).state != "running")
        return self.operation(number)

    async def done(self, request: DriveOrder) -> OperationView:
        """Ask until it is done: on a busy machine a drive's answer may come after its 136 ms, five times on end."""
        while (view := await self.do(request)).state != "done":
            await self.online()
        return view


@asynccontextmanager
async def rig(directory: Path, *, serial: bool = True, echo: bool = False) -> AsyncIterator[Rig]:
    """Start everything; the hoists of the plant are not there."""
    drives = {DriveId(f"D{n}"): SimulatedDrive(n) for n in (1, 2)}
    device = (TwoWire if echo else Faulty)(SimulatedLine(drives.values()), Lane(Random(1)), Lane(Random(2)))
    line = Line(device, NOW)
    path = directory / "axes"
    port: PtyPort | DeviceServer = PtyPort(line, path) if serial else DeviceServer(line, "127.0.0.1", 0)
    await port.start()
    where = SerialPort(str(path)) if serial else None
    link = LinkSpec(LINE, Wire.HI, port=0 if isinstance(port, PtyPort) else port.port, serial=where)
    plant = drive_plant()
    vehicles = tuple(replace(vehicle, host="127.0.0.1", port=1) for vehicle in plant.vehicles)
    controller = Controller(
        replace(plant, links=(link,), vehicles=vehicles, listen=None), f"sqlite:///{directory / 'plant.db'}"
    )
    await controller.start()
    try:
        yield Rig(controller, drives, device, port)
    finally:
        await controller.stop()
        await port.stop()


def on_both_loops(tmp_path: Path, scenario: Callable[[Path], Coroutine[None, None, None]]) -> None:
    """Run a scenario on uvloop and on asyncio; a warning is an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")

        async def one() -> None:
            directory = tmp_path / str(len(list(tmp_path.iterdir())))
            directory.mkdir()
            await scenario(directory)

        run(one)


def test_parameters_are_read_over_a_serial_line_with_noise_losses_doubled_bytes_and_echo(tmp_path: Path) -> None:
    async def scenario(directory: Path) -> None:
        async with rig(directory, echo=True) as bench:
            for number in range(256):
                bench.drives[D1].set_value(number, 2000 + number)
            await bench.online()
            bench.device.in_lane.rates = BAD
            bench.device.out_lane.rates = BAD | {Fault.DUPLICATE: 0.1}
            done = await bench.done(ReadDrive(KIM, D1, tuple(P(number) for number in range(64))))
            assert done.state == "done", done.reason
            assert done.result["values"] == {f"{n:02X}": 2000 + n for n in range(64)}
            (line,) = bench.controller.links()
            assert line.figures["garbled"] > 0
            assert bench.controller.link_frames(LinkId(LINE))

    on_both_loops(tmp_path, scenario)


@pytest.mark.parametrize("serial", [True, False], ids=["pty", "tcp"])
def test_a_line_that_is_unplugged_is_shown_and_found_again_when_it_is_plugged_in(tmp_path: Path, serial: bool) -> None:
    async def scenario(directory: Path) -> None:
        async with rig(directory, serial=serial) as bench:
            await bench.online()
            number = await bench.begin(ReadDrive(KIM, D1, tuple(P(number) for number in range(64))))
            await until(lambda: bench.operation(number).done > 5)
            await bench.port.stop()
            await until(lambda: bench.operation(number).state != "running")
            assert bench.operation(number).state == "failed"
            await until(lambda: bench.view().online is None)
            (line,) = bench.controller.links()
            assert not line.up
            assert line.reason
            await bench.port.start()
            await bench.online()
            await bench.done(WriteDrive(KIM, D1, P(0x1C), RawValue(150)))
            assert bench.drives[D1].state(NOW()).values[0x1C] == 150

    on_both_loops(tmp_path, scenario)


def test_a_port_that_is_not_there_yet_is_opened_when_it_comes(tmp_path: Path) -> None:
    async def scenario(directory: Path) -> None:
        async with rig(directory) as bench:
            await bench.online()
            await bench.port.stop()
            await until(lambda: bench.view().online is None)
            (directory / "axes").write_text("no port", encoding="ascii")
            with pytest.raises(OSError, match="exists"):
                await bench.port.start()
            (directory / "axes").unlink()
            await bench.port.start()
            await bench.online()

    on_both_loops(tmp_path, scenario)


def test_an_axis_is_jogged_while_the_caller_says_so(tmp_path: Path) -> None:
    async def scenario(directory: Path) -> None:
        async with rig(directory) as bench:
            bench.drives[D1].panel_mode(Mode.JOG, NOW())
            await bench.online()
            await until(lambda: bench.view().mode == "jog")

            async def jogged() -> OperationView:
                """Hold the key until the axis has moved, then let go; a busy machine may be too late to hold it."""
                jog = await bench.begin(JogDrive(KIM, D1, Turn.CW))

                async def hold() -> None:
                    while isinstance(bench.controller.tell(KeepDriveJog(jog)), Accepted):
                        await asyncio.sleep(0.05)

                holding = asyncio.create_task(hold())

                def over() -> bool:
                    return bench.operation(jog).state != "running"

                await until(lambda: over() or bench.drives[D1].state(NOW()).distance > 300)
                bench.controller.tell(ReleaseDriveJog(jog))
                await until(over)
                await holding
                return bench.operation(jog)

            while (view := await jogged()).result.get("ended") != "released":
                await bench.online()
            assert view.state == "done"
            assert not bench.drives[D1].state(NOW()).jogging
            gone = await bench.begin(JogDrive(KIM, D1, Turn.CCW))
            await until(lambda: bench.operation(gone).state == "done")
            assert bench.operation(gone).result["ended"] == "caller gone"

    on_both_loops(tmp_path, scenario)


def test_what_was_asked_and_backed_up_is_there_after_a_restart(tmp_path: Path) -> None:
    async def scenario(directory: Path) -> None:
        async with rig(directory) as bench:
            bench.drives[D1].set_value(0x1C, 321)
            await bench.online()
            backup = await bench.done(BackUpDrive(KIM, D1, "first"))
        async with rig(directory) as bench:
            view = bench.controller.model.get(Topic.PARAMETERS, "D1/1C")
            assert isinstance(view, ParameterView)
            assert view.raw == 321
            reader = bench.controller.reader
            found = (await asyncio.to_thread(reader.backups, D1))[0]
            assert (found.number, found.values[0x1C], found.note) == (int(backup.id), 321, "first")
            operations = await asyncio.to_thread(reader.operations)
            assert (operations[0].number, operations[0].state.value) == (int(backup.id), "done")

    on_both_loops(tmp_path, scenario)
