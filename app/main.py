"""Composition root: the controller and its server in one process. Imported by the command line alone."""

import asyncio
import gc
import os
import resource
import signal
import socket
from collections.abc import Callable, Coroutine, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import uvicorn

from app.api import application
from app.api.connections import bounded
from app.domain.errors import HoistwayError
from app.domain.layout import Plant
from app.plant import UnusablePlant, read
from app.runtime.controller import Controller
from app.settings import Settings

GRACE = 3
"""Seconds for requests under way when the server stops. Our choice."""
FILES = 1 << 16
"""Most open files that we ask the system for. Our choice."""
WORD = 1 << 16
"""Longest message that a watcher may send before its connection is cut, bytes. Our choice."""


class CannotStart(HoistwayError):
    """Something outside the program prevents it from running; the message says what, in one line."""

    code = "cannot-start"


def said(error: OSError | UnicodeDecodeError) -> str:
    """Return the system's own word for an error, without the names of calls."""
    return os.strerror(error.errno) if isinstance(error, OSError) and error.errno else str(error)


def plant_of(file: Path) -> Plant:
    """Return the plant of a file. Raises CannotStart."""
    try:
        text = file.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as wrong:
        raise CannotStart(f"the plant file {file} cannot be read: {said(wrong)}") from None
    try:
        plant, _ = read(text, str(file))
    except UnusablePlant as unusable:
        errors = sum(finding.severity.value == "error" for finding in unusable.findings)
        raise CannotStart(f"the plant file {file} has {errors} errors", remedy=f"see: hoistway check {file}") from None
    return plant


def bound(host: str, port: int) -> socket.socket:
    """Return a socket that listens there. Raises CannotStart."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        return socket.create_server((host, port), family=family, backlog=2048)
    except OSError as wrong:
        raise CannotStart(f"cannot listen at {host}:{port}: {said(wrong)}", remedy="choose another --port") from None


def run(main: Coroutine[Any, Any, int]) -> int:
    """Run the program on the fastest loop there is; return its exit code."""
    try:
        import uvloop

        factory: Callable[[], asyncio.AbstractEventLoop] | None = uvloop.new_event_loop
    except ImportError:
        factory = None
    with asyncio.Runner(loop_factory=factory) as runner:
        return runner.run(main)


def stop_signal() -> asyncio.Event:
    """Return an event that is set by Ctrl-C or a polite kill."""
    stop = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, stop.set)
    return stop


class _Server(uvicorn.Server):
    """A server that leaves signals to its owner."""

    @contextmanager
    def capture_signals(self) -> Iterator[None]:
        yield


async def serve(
    plant: Plant,
    settings: Settings,
    listening: socket.socket,
    stop: asyncio.Event,
    ready: Callable[[str], None],
    *,
    restored: bool = False,
) -> int:
    """Run the controller and its server until ``stop`` or until the plant is lost; return the exit code.

    ``ready`` is told the URL once requests are answered. Raises CannotStart, PlantHeld, StoreError.
    """
    controller = Controller(plant, settings.database, restored=restored)
    try:
        await controller.start()
    except OSError as wrong:
        raise CannotStart(f"cannot listen for vehicles at {plant.listen}: {said(wrong)}") from None
    try:
        server = _Server(_configured(controller, settings))
        serving = asyncio.create_task(server.serve([listening]))
        stopping = asyncio.create_task(stop.wait())
        while not server.started and not serving.done():
            await asyncio.sleep(0.01)
        gc.collect()
        gc.freeze()
        ready(url_of(settings.host, listening.getsockname()[1]))
        ends: set[asyncio.Future[Any]] = {serving, stopping, controller.lost}
        await asyncio.wait(ends, return_when=asyncio.FIRST_COMPLETED)
        server.should_exit = True
        await serving
        stopping.cancel()
    finally:
        await controller.stop()
    return 1 if controller.lost.done() else 0


def _files() -> int:
    """Return how many files the process may open, raised as far as it may: a flood of callers must leave some to vehicles."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    most = FILES if hard == resource.RLIM_INFINITY else min(hard, FILES)
    if soft != resource.RLIM_INFINITY and soft < most:
        resource.setrlimit(resource.RLIMIT_NOFILE, (most, hard))
    return most


def url_of(host: str, port: int) -> str:
    """Return where a person finds the server."""
    shown = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}.get(host, f"[{host}]" if ":" in host else host)
    return f"http://{shown}:{port}"


def _configured(controller: Controller, settings: Settings) -> uvicorn.Config:
    return uvicorn.Config(
        application(controller, settings),
        loop="none",
        http=bounded(min(settings.connections, _files() // 2)),
        ws="websockets-sansio",
        ws_per_message_deflate=False,
        ws_max_size=WORD,
        access_log=False,
        log_config=None,
        log_level="warning",
        lifespan="off",
        timeout_graceful_shutdown=GRACE,
        server_header=False,
        h11_max_incomplete_event_size=None,
    )
