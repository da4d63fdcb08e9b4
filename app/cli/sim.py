"""``hoistway sim``: everything that a plant drives as simulated devices behind TCP."""

from __future__ import annotations

import asyncio
import json
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.addresses import Wanted, demanded, simulated_at
from app.cli.following import follow_controller, is_url
from app.cli.panel import set_panels
from app.cli.plainly import CannotStart, plainly, positive, refuse, said, text_of
from app.cli.running import bound, on_again, on_loop, plant_of, reader_of, stop_signal
from app.cli.tongue import say
from app.domain.errors import HoistwayError
from app.domain.versions import Source
from app.wire.names import nearest

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Sequence

    from app.cli.operator import Bench
    from app.domain.ids import VehicleId
    from app.domain.layout import LinkSpec, Plant, VehicleSpec
    from app.domain.ports import Endpoint
    from app.domain.units import Barcode, Seconds
    from app.protocols.itsc.simulator import Options, SimulatedVehicle
    from app.runtime.lines import Line
    from app.runtime.pty import PtyPort
    from app.runtime.transports import DeviceServer, Dialler
    from app.sim.oracle import Oracle
    from app.sim.plantworld import SimulatedPlant
    from app.sim.truth import Act

FOLLOWED = "followed"
"""What a parent reads once a plant that it told is followed, as far as it can be."""
LOOK_EVERY = 0.2
"""Seconds between two looks at the rails. Our choice."""


def sim(
    plant: Annotated[Path, typer.Option(help="the plant file")],
    journal: Annotated[
        Path | None, typer.Option(help="write each physical happening there, one JSON object a line")
    ] = None,
    host: Annotated[
        str | None, typer.Option(help="serve at this address instead of each vehicle's own (0.0.0.0: all)")
    ] = None,
    controller: Annotated[str, typer.Option(help="host that vehicles which dial in themselves dial")] = "127.0.0.1",
    haste: Annotated[
        float,
        typer.Option(callback=positive, help="steps of a pick-up or place, and of homing, are so many times as quick"),
    ] = 1.0,
    operator: Annotated[
        int | None,
        typer.Option(
            min=0, max=65535, help="port of this machine for the hands at the simulated vehicles: key, jog, teach"
        ),
    ] = None,
    panel: Annotated[
        list[str] | None, typer.Option(help="set a drive's panel: DRIVE=jog, =monitoring, =parameter_select, =error7")
    ] = None,
    only: Annotated[
        list[str] | None, typer.Option(help="simulate this vehicle or link alone (may be repeated)")
    ] = None,
    without: Annotated[
        list[str] | None, typer.Option(help="do not simulate this vehicle or link: it is real (may be repeated)")
    ] = None,
    source: Annotated[
        str | None,
        typer.Option("--from", help="follow the versions of the plant that the controller at this URL activates"),
    ] = None,
    with_parent: Annotated[
        bool, typer.Option("--with-parent", help="follow what standard input says; end with it", hidden=True)
    ] = False,
) -> None:
    """Serve all vehicles and links of a plant as simulated devices at their addresses, until Ctrl-C. SIGHUP: follow its file."""
    from app.runtime.telemetry import set_up

    set_up(as_json=False, level="warning")
    with plainly():
        found = simulated(plant_of(plant), only or (), without or ())
        hands = () if operator is None else (Wanted("127.0.0.1", operator, "--operator"),)
        if source is not None:
            is_url(source)
        demanded([*hands, *simulated_at(found, host)], plant)
        reader = reader_of(plant)

        def read(text: str | None) -> Plant:
            return simulated(reader(Source(text_of(plant) if text is None else text)).plant, only or (), without or ())

        try:
            floor = _Floor(found, journal, host, controller, haste, operator, panel or (), read)
            code = on_loop(floor.run(with_parent, source))
        except OSError as wrong:
            at = f" ({wrong.filename})" if wrong.filename else ""
            refuse(f"cannot simulate {found.name}: {said(wrong)}{at}")
    raise typer.Exit(code)


def simulated(plant: Plant, only: Sequence[str], without: Sequence[str]) -> Plant:
    """Return the plant without the machines that are real: vehicles, and links with all that is on them.

    Raises CannotStart: a name that no vehicle or link has, or nothing is left.
    """
    known = {*(vehicle.id for vehicle in plant.vehicles), *(link.id for link in plant.links)}
    for name in (*only, *without):
        if name not in known:
            close = nearest(name, known)
            remedy = f"Did you mean {close}?" if close else f"There are: {', '.join(sorted(known))}."
            raise CannotStart(f"no vehicle or link is called {name}", remedy=remedy)
    # An AGV is simulated with its link: they share one line.
    asked = {*only, *(vehicle.link for vehicle in plant.vehicles if vehicle.id in only and vehicle.link)}
    links = {link.id for link in plant.links if (not only or link.id in asked) and link.id not in without}
    vehicles = tuple(
        vehicle
        for vehicle in plant.vehicles
        if vehicle.id not in without
        and (not only or vehicle.id in only or vehicle.link in only)
        and (vehicle.link is None or vehicle.link in links)
    )
    if not vehicles and not links:
        raise CannotStart("nothing is left to simulate", remedy="Name less with --without.")
    buffers = tuple(buffer for buffer in plant.buffers if buffer.link in links)
    there = {buffer.id for buffer in buffers}
    return replace(
        plant,
        vehicles=vehicles,
        links=tuple(link for link in plant.links if link.id in links),
        doors=tuple(door for door in plant.doors if door.link in links),
        buffers=buffers,
        drives=tuple(drive for drive in plant.drives if drive.link in links),
        stations=tuple(s if s.buffer in there else replace(s, buffer=None) for s in plant.stations),
    )


class _Floor:
    """The simulated plant on real sockets, watched by the oracle. ``read`` gives the plant of a text; None: of the plant file."""

    def __init__(
        self,
        plant: Plant,
        journal: Path | None,
        host: str | None,
        controller: str,
        haste: float,
        operator: int | None,
        panels: Sequence[str],
        read: Callable[[str | None], Plant],
    ) -> None:
        self._read = read
        self._following = asyncio.Lock()
        self._haste = haste
        self._panels = panels
        self._plant = self._told = plant
        self._off: set[VehicleId] = set()
        """Hoists that people have taken off the rail, whatever plant is told."""
        self._built = plant
        """What the simulated machines are built by, whatever plant is followed."""
        self._unknown: set[Barcode] = set()
        """Where a vehicle was sent to a station that the plant has not: said once each."""
        self._journal = journal.open("a", encoding="utf-8") if journal else None
        self._host = host
        self._controller = controller
        self._operator = operator
        self._hoists: dict[VehicleId, Line] = {}
        self._ends: dict[str, DeviceServer | Dialler | PtyPort] = {}

    async def run(self, with_parent: bool, source: str | None) -> int:
        """Serve until told to stop; ``source`` is the URL of a controller whose versions of the plant are followed."""
        from app.runtime.clock import Clock
        from app.sim.oracle import Oracle
        from app.sim.plantworld import SimulatedPlant

        now = Clock().now
        stop = stop_signal()
        options = _hasty(self._haste)
        floor = SimulatedPlant(self._plant, lambda act: self._note(act, oracle, now()), options, now())
        set_panels(self._panels, floor.halls.drives, now())
        oracle = Oracle(self._plant, floor.truth)

        async def follow(text: str | None) -> None:
            await self._follow(text, floor, oracle)

        tasks = set[asyncio.Task[None]]()
        on_again(lambda: tasks.add(asyncio.create_task(follow(None))))
        if with_parent:
            tasks.add(asyncio.create_task(_with_parent(stop, follow)))
        hands: Bench | None = None
        try:
            for spec in self._plant.hoists:
                await self._serve(spec, floor.devices[spec.id])
            for link in self._plant.links:
                await self._serve_link(link, floor.lines[link.id])
            hands = await self._hands(floor, oracle)
            say(f"hoistway sim: {_counted(self._plant)} of {self._plant.name} are there")
            if source is not None:
                tasks.add(asyncio.create_task(follow_controller(source, follow)))
            await self._watch(floor, oracle, stop)
        finally:
            for task in tasks:
                task.cancel()
            if hands is not None:
                hands.should_exit = True
            for end in self._ends.values():
                await end.stop()
            if self._journal:
                self._journal.close()
        return 0

    async def _follow(self, text: str | None, floor: SimulatedPlant, oracle: Oracle) -> None:
        """Become the plant of a text, or of the plant file, while vehicles drive; say what was not followed."""
        from app.sim.plantworld import unfollowed

        async with self._following:
            try:
                plant = await asyncio.to_thread(self._read, text)
                if plant.name != self._plant.name:
                    raise CannotStart(f"it is of another plant: {plant.name}")
            except HoistwayError as wrong:
                say(f"hoistway sim: the plant is not followed: {wrong.message}", wrong=True)
                return
            self._told = plant
            self._unknown.clear()
            self._off &= {spec.id for spec in plant.hoists}
            await self._become(floor, oracle)
            for change in unfollowed(self._built, self._plant):
                say(f"hoistway sim: not followed until it is started again: {change}", wrong=True)

    async def _become(self, floor: SimulatedPlant, oracle: Oracle) -> None:
        """Be the plant that was told last, without the hoists that are off the rail."""
        from app.runtime.clock import Clock

        plant = self._plant = replace(
            self._told, vehicles=tuple(spec for spec in self._told.vehicles if spec.id not in self._off)
        )
        came, gone = floor.follow(plant, Clock().now())
        stayed = (vehicle for vehicle in self._built.vehicles if vehicle.id not in gone)
        self._built = replace(self._built, vehicles=(*stayed, *came))
        oracle.follow(plant)
        for name in gone:
            await self._ends.pop(name).stop()
            del self._hoists[name]
        for spec in came:
            try:
                await self._serve(spec, floor.devices[spec.id])
            except OSError as wrong:
                say(f"hoistway sim: {spec.id} is not there: {said(wrong)}", wrong=True)

    async def _on_rail(self, name: VehicleId, on: bool, floor: SimulatedPlant, oracle: Oracle) -> bool:
        """Take a hoist off the rail or put it back; False: there is none of that name."""
        async with self._following:
            if name not in {spec.id for spec in self._told.hoists}:
                return False
            if on:
                self._off.discard(name)
            else:
                self._off.add(name)
            await self._become(floor, oracle)
            return True

    async def _hands(self, floor: SimulatedPlant, oracle: Oracle) -> Bench | None:
        """Let people at the simulated hoists, if that is wanted."""
        if self._operator is None:
            return None
        from app.cli.operator import Bench, Hands
        from app.runtime.clock import Clock

        async def rail(name: VehicleId, on: bool) -> bool:
            return await self._on_rail(name, on, floor, oracle)

        bench = Bench(Hands(floor.devices, self._hoists, Clock().now, floor.halls.agvs, rail))
        listening = bound("127.0.0.1", self._operator, "--operator")
        self._serving = asyncio.create_task(bench.serve([listening]))
        return bench

    async def _serve(self, spec: VehicleSpec, device: SimulatedVehicle) -> None:
        from app.runtime.clock import Clock
        from app.runtime.lines import Line
        from app.runtime.transports import DeviceServer, Dialler, Tcp

        line: Line = Line(device, Clock().now)
        self._hoists[spec.id] = line
        if spec.listen and self._plant.listen is not None:
            dialler = Dialler(line, Tcp(self._controller, self._plant.listen[1]), spec.id)
            dialler.start()
            line.flush()
            self._ends[spec.id] = dialler
            return
        server = DeviceServer(line, self._host or spec.host, spec.port, lambda: not device.accepting)
        self._ends[spec.id] = server
        await server.start()

    async def _serve_link(self, link: LinkSpec, device: Endpoint) -> None:
        from app.runtime.clock import Clock
        from app.runtime.lines import Line
        from app.runtime.pty import PtyPort
        from app.runtime.transports import DeviceServer

        line = Line(device, Clock().now)
        server: PtyPort | DeviceServer
        if link.serial is not None:
            server = PtyPort(line, Path(link.serial.device))
        else:
            server = DeviceServer(line, self._host or link.host, link.port)
        self._ends[link.id] = server
        await server.start()

    async def _watch(self, floor: SimulatedPlant, oracle: Oracle, stop: asyncio.Event) -> None:
        from app.runtime.clock import Clock

        told = 0
        while not stop.is_set():
            now = Clock().now()
            for device in floor.devices.values():
                device.tick(now)
            oracle.look(floor.places(now), floor.loaded(), now)
            oracle.look_at_doors({name: door.leaf_open for name, door in floor.halls.doors.items()}, now)
            for violation in oracle.violations[told:]:
                print(f"hoistway sim: {violation}", file=sys.stderr, flush=True)
                self._write({"deed": "violation", "what": violation})
            told = len(oracle.violations)
            try:
                await asyncio.wait_for(stop.wait(), LOOK_EVERY)
            except TimeoutError:
                continue

    def _note(self, act: Act, oracle: Oracle, now: Seconds) -> None:
        oracle.act(act, now)
        if act.station is None and act.barcode not in self._unknown:
            self._unknown.add(act.barcode)
            say(
                f"hoistway sim: {act.vehicle} was sent to a station at barcode {act.barcode}, which is not known here: does "
                "the controller run another version of the plant? --from URL follows it; or write that over the plant "
                "file (hoistway layout get) and send SIGHUP",
                wrong=True,
            )
        self._write(
            {
                "deed": act.deed,
                "vehicle": act.vehicle,
                "station": act.station,
                "carrier": act.carrier,
                "barcode": act.barcode,
            }
        )

    def _write(self, happening: dict[str, str | None]) -> None:
        if self._journal:
            self._journal.write(json.dumps({"at": round(time.time(), 3), **happening}) + "\n")
            self._journal.flush()


def _counted(plant: Plant) -> str:
    """Return how much is simulated, in words."""
    equipment = len(plant.doors) + len(plant.buffers) + len(plant.drives)
    return f"{len(plant.vehicles)} vehicles" + (f" and {equipment} other devices" if equipment else "")


def _hasty(times: float) -> Options:
    from app.domain.units import Seconds
    from app.protocols.itsc.simulator import Options

    usual = Options()
    return Options(
        step_time=Seconds(usual.step_time / times),
        servo_time=Seconds(usual.servo_time / times),
        search_home_time=Seconds(usual.search_home_time / times),
        go_home_time=Seconds(usual.go_home_time / times),
    )


def message(text: str) -> bytes:
    """Return a plant as a parent tells it over standard input: how many bytes, and the bytes."""
    data = text.encode()
    return b"%d\n" % len(data) + data


async def _with_parent(stop: asyncio.Event, follow: Callable[[str], Coroutine[None, None, None]]) -> None:
    """Follow the plants that whoever started us tells, each answered by a line; end with it, even if it was killed."""
    reader = asyncio.StreamReader()
    loop = asyncio.get_running_loop()
    await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)
    while size := await reader.readline():
        try:
            text = (await reader.readexactly(int(size))).decode()
        except asyncio.IncompleteReadError:
            break
        await follow(text)
        print(FOLLOWED, flush=True)
    stop.set()
