"""``hoistway demo``: simulated vehicles in a process of their own, and the controller that drives them."""

from __future__ import annotations

import asyncio
import json
import tempfile
from contextlib import suppress
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.addresses import Wanted, demanded, simulated_at
from app.cli.plainly import plainly
from app.cli.running import bound, on_again, on_loop, plant_and_text_of, stop_signal, uncollected, url_of
from app.cli.tongue import say
from app.cli.workload import order

if TYPE_CHECKING:
    from collections.abc import Iterator

    from app.domain.layout import Plant, Station
    from app.runtime.controller import Controller
    from app.settings import Settings

GRACE = 5.0
"""Seconds for the simulator to end when asked. Our choice."""
WATCHED = 10.0
"""Longest way of the transfer that is invited to, seconds: enough to be seen, and soon over. Our choice."""


def demo(
    plant: Annotated[Path, typer.Option(help="the plant file")] = Path("plants/demo.yaml"),
    port: Annotated[int, typer.Option(help="port to listen at")] = 8080,
    workload: Annotated[bool, typer.Option("--workload", help="order random jobs all the time")] = False,
    keep: Annotated[int, typer.Option(min=1, help="jobs kept open by --workload")] = 6,
    database: Annotated[
        str | None, typer.Option(help="SQLAlchemy URL; without it a new one, thrown away at the end")
    ] = None,
    operator: Annotated[
        int | None, typer.Option(min=0, max=65535, help="port for the hands at the simulated vehicles: key, jog, teach")
    ] = None,
) -> None:
    """Show a plant: simulate its vehicles, control them, print where to look. Ctrl-C ends everything."""
    from app.settings import load

    with plainly(), tempfile.TemporaryDirectory(prefix="hoistway-") as directory:
        url = database or f"sqlite:///{directory}/demo.db"
        settings = load(plant=plant, database=url, host="127.0.0.1", port=port, log_level="warning")
        code = _show(settings, plant, keep if workload else None, operator)
    raise typer.Exit(code)


def _show(settings: Settings, file: Path, keep: int | None, operator: int | None) -> int:
    from app.runtime.telemetry import set_up

    set_up(as_json=False, level=settings.log_level)
    plant, text = plant_and_text_of(file)
    demanded(_wanted(plant, settings, operator), file)
    listening = bound(settings.host, settings.port)
    with uncollected():
        from app.cli import hosting  # heavy: a wrong plant file and a port in use are told before
        from app.cli.shown import ShownChanges, Simulator
        from app.runtime.clock import Clock

    url = url_of(settings.host, listening.getsockname()[1])
    simulator = Simulator(file, text, operator)
    with ShownChanges(file, settings.database, Clock().utc, simulator) as changes:
        plant = changes.begin(plant, text)

        async def run() -> int:
            stop = stop_signal()
            on_again(changes.look)
            await simulator.start()
            await changes.show()
            watching = asyncio.create_task(_end_with(simulator.process, stop))
            working = None if keep is None else asyncio.create_task(_work(url, keep, stop, settings))
            said = ""

            def seen(controller: Controller) -> None:
                nonlocal said, plant
                said, plant = hosting.who_may_call(controller, settings), controller.plant

            def ready(url: str) -> None:
                say(f"{_invitation(plant, url)}\n{said}\nCtrl-C ends it.")

            try:
                return await hosting.serve(plant, settings, listening, stop, ready, seen=seen, changes=changes)
            finally:
                stop.set()
                if working is not None:
                    await working
                await _ended(simulator.process)
                await watching

        return on_loop(run())


def _wanted(plant: Plant, settings: Settings, operator: int | None) -> Iterator[Wanted]:
    """Give where the controller, the simulated machines and the hands at them are to listen."""
    yield Wanted(settings.host, settings.port, "--port")
    if operator is not None:
        yield Wanted("127.0.0.1", operator, "--operator")
    if plant.listen is not None:
        yield Wanted(*plant.listen, "listen")
    yield from simulated_at(plant)


async def _end_with(simulator: asyncio.subprocess.Process, stop: asyncio.Event) -> None:
    await simulator.wait()
    if not stop.is_set():
        say("hoistway: the simulated vehicles have ended", wrong=True)
        stop.set()


async def _ended(simulator: asyncio.subprocess.Process) -> None:
    if simulator.returncode is None:
        with suppress(ProcessLookupError):
            simulator.terminate()
        try:
            await asyncio.wait_for(simulator.wait(), GRACE)
        except TimeoutError:
            simulator.kill()
            await simulator.wait()


async def _work(url: str, keep: int, stop: asyncio.Event, settings: Settings) -> None:
    key = None if settings.access_key is None else settings.access_key.get_secret_value()
    await order(url, Random(), stop, rate=None, keep=keep, key=key, quiet=True)


def _alike(one: Station, other: Station) -> bool:
    """Whether one vehicle can serve both stations."""
    from app.domain.layout import VehicleKind

    return any({one.kind, other.kind} <= kind.serves for kind in VehicleKind)


def counted(plant: Plant) -> str:
    """Return what there is to see, in words: ``10 hoists, 2 AGVs, 1 door``."""
    hoists = len(plant.hoists)
    numbers = {
        "hoist": hoists,
        "AGV": len(plant.vehicles) - hoists,
        "door": len(plant.doors),
        "buffer": len(plant.buffers),
        "charger": len(plant.chargers),
        "drive": len(plant.drives),
    }
    return ", ".join(f"{number} {name}{'s' * (number > 1)}" for name, number in numbers.items() if number) or "nothing"


def _invitation(plant: Plant, url: str) -> str:
    """Return where to look and one line to try: a transfer that this plant can do."""
    lines = [f"hoistway shows {plant.name} with {counted(plant)}, all simulated: {url}"]
    if ends := _transfer(plant):
        body = json.dumps({"source": ends[0].id, "destination": ends[1].id})
        lines += [
            "Order a transfer from another terminal:",
            f"  curl -X POST {url}/api/v1/jobs -H 'Content-Type: application/json' -d '{body}'",
        ]
    return "\n".join(lines)


def _transfer(plant: Plant) -> tuple[Station, Station] | None:
    """Return where a carrier stands, and the free place that is the farthest of those not too far to wait for it."""
    from app.planning.routing import Router
    from app.planning.track import Track

    full = {station for _, station in plant.carriers}
    source = next((station for station in plant.stations if station.id in full), None)
    if source is None:
        return None
    router = Router(Track(plant))
    free = (station for station in plant.stations if station.id not in full and _alike(source, station))
    away = {station: router.time(source.barcode, station.barcode) for station in free}
    near = [station for station, seconds in away.items() if seconds <= WATCHED]
    destination = max(near, key=away.__getitem__) if near else min(away, key=away.__getitem__, default=None)
    return None if destination is None else (source, destination)
