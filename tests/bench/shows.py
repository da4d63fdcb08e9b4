"""Servers of a read model of 1,000 vehicles, each in a process of its own: ``python -m tests.bench.shows KIND``."""

import asyncio
import socket
import sys
from dataclasses import replace
from typing import Any, cast

import uvicorn
import uvloop
from fastapi import FastAPI, WebSocket

from app.cli.hosting import _configured
from app.domain.view import BitView, Topic, Update, VehicleView
from app.runtime.hub import Hub, ReadModel
from app.settings import Settings
from tests.api.scripted import Scripted

VEHICLES = 1_000
CHANGED = 10
"""Vehicles that look different at each tick of the live stream."""
TICK = 0.1


def views() -> list[VehicleView]:
    """Return vehicles with all they show."""
    (first, *_) = (view for view in Scripted().model.all(Topic.VEHICLES) if isinstance(view, VehicleView))
    bits = tuple(BitView(f"field{n}", n % 4, "meaning") for n in range(18))
    full = replace(first, bits=bits, granted=("1001", "1002", "1003"), covered=("1000",), seen=1_767_225_600.25)
    return [replace(full, id=f"V{n:04}", dev_id=n) for n in range(VEHICLES)]


async def _ours(listening: socket.socket) -> None:
    plays = Scripted()
    plays.model = ReadModel()
    plays.hub = Hub(plays.model)
    known = views()
    plays.hub.publish([Update(Topic.VEHICLES, view.id, view) for view in known])

    async def change() -> None:
        tick = 0
        while True:
            await asyncio.sleep(TICK)
            if plays.hub.watchers:
                tick += 1
                moved = [replace(view, seq=tick % 10) for view in known[:CHANGED]]
                plays.hub.publish([Update(Topic.VEHICLES, view.id, view) for view in moved])

    settings = Settings(watchers=1000)
    changing = asyncio.create_task(change())
    await uvicorn.Server(_configured(cast(Any, plays), settings)).serve([listening])
    changing.cancel()


async def _naive(listening: socket.socket) -> None:
    app = FastAPI()
    known = views()
    sockets: list[WebSocket] = []

    @app.get("/api/v1/vehicles")
    async def vehicles() -> list[VehicleView]:
        return known

    @app.websocket("/api/v1/live")
    async def live(watcher: WebSocket) -> None:
        await watcher.accept()
        sockets.append(watcher)
        await watcher.receive()

    async def change() -> None:
        from dataclasses import asdict

        while True:
            await asyncio.sleep(TICK)
            for watcher in sockets:
                changes = [{"topic": "vehicles", "key": view.id, "value": asdict(view)} for view in known[:CHANGED]]
                await watcher.send_json({"type": "change", "seq": 1, "changes": changes})

    changing = asyncio.create_task(change())
    config = uvicorn.Config(app, loop="none", access_log=False, log_level="error", lifespan="off")
    await uvicorn.Server(config).serve([listening])
    changing.cancel()


KINDS: dict[str, Any] = {"ours": _ours, "naive": _naive}

if __name__ == "__main__":
    listening = socket.create_server(("127.0.0.1", 0), backlog=2048)
    print(listening.getsockname()[1], flush=True)
    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        runner.run(KINDS[sys.argv[1]](listening))
