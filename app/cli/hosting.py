"""The controller and its server in one process."""

import asyncio
import gc
import os
import resource
import socket
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import uvicorn

from app.api import application
from app.api.application import VERSION
from app.api.connections import bounded
from app.api.port import Controller as Shown
from app.api.streams import Stream
from app.cli.plainly import CannotStart, said
from app.domain.layout import Plant
from app.runtime.controller import Controller
from app.runtime.notify import Notifier
from app.runtime.recording import Limits
from app.runtime.telemetry import logger
from app.runtime.tracing import Traces, provider
from app.runtime.webhooks import Sender, Targets
from app.settings import Settings

COLLECTED = (10_000, 20, 50)
"""New objects until they are looked through for rings, and how many times until older ones are: a backlog of thousands of jobs
is no garbage, and is not to be looked through all the time. Our choice."""
GRACE = 3
"""Seconds for requests under way when the server stops. Our choice."""
FILES = 1 << 16
"""Most open files that we ask the system for. Our choice."""
WORD = 1 << 16
"""Longest message that a watcher may send before its connection is cut, bytes. Our choice."""


def bound(host: str, port: int, option: str = "--port") -> socket.socket:
    """Return a socket that listens there; ``option`` is what chose the port. Raises CannotStart."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        return socket.create_server((host, port), family=family, backlog=2048)
    except OSError as wrong:
        raise CannotStart(
            f"cannot listen at {host}:{port}: {said(wrong)}", remedy=f"Choose another one with {option}."
        ) from None


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
    notify: Notifier | None = None,
    seen: Callable[[Controller], None] = lambda controller: None,
) -> int:
    """Run the controller and its server until ``stop`` or until the plant is lost; return the exit code.

    ``seen`` is told the controller once it runs, ``ready`` the URL once requests are answered; so is the service manager, if
    there is one to ``notify``, and it is fed as long as the controller lives.
    Raises CannotStart, PlantHeld, StoreError, TracesMissing, TargetsError.
    """
    log = logger(plant=plant.name)
    days, size = settings.playback_days, settings.playback_megabytes
    playback = Limits(days * 86_400.0, size * 1_000_000) if days else None
    traces = Traces(provider(plant.name, VERSION, os.environ)) if settings.traces else None
    sender = _sender(settings)
    controller = Controller(
        plant,
        settings.database,
        restored=restored,
        keep_events=settings.keep_events,
        playback=playback,
        webhooks=lambda: sender,
    )
    if traces is not None:
        controller.figures.jobs.told = traces.take
    try:
        await controller.start()
    except OSError as wrong:
        raise CannotStart(f"cannot listen for vehicles at {plant.listen}: {said(wrong)}") from None
    try:
        seen(controller)
        server = _Server(_configured(controller, settings))
        serving = asyncio.create_task(server.serve([listening]))
        stopping = asyncio.create_task(stop.wait())
        while not server.started and not serving.done():
            await asyncio.sleep(0.01)
        gc.collect()
        gc.freeze()
        gc.set_threshold(*COLLECTED)
        url = url_of(settings.host, listening.getsockname()[1])
        ready(url)
        notify = notify or Notifier({})
        notify.ready(f"controls {plant.name} at {url}")
        notify.feed(controller, lambda reason: log.critical("the watchdog is not fed", reason=reason))
        ends: set[asyncio.Future[Any]] = {serving, stopping, controller.lost}
        await asyncio.wait(ends, return_when=asyncio.FIRST_COMPLETED)
        notify.stopping()
        server.should_exit = True
        await serving
        stopping.cancel()
    finally:
        await controller.stop()
        if traces is not None:
            await asyncio.to_thread(traces.close)
    return 1 if controller.lost.done() else 0


async def serve_only(
    controller: Shown,
    settings: Settings,
    listening: socket.socket,
    stop: asyncio.Event,
    ready: Callable[[str], None],
) -> int:
    """Serve what cannot change any more until ``stop``; return the exit code."""
    server = _Server(_configured(controller, settings))
    serving = asyncio.create_task(server.serve([listening]))
    while not server.started and not serving.done():
        await asyncio.sleep(0.01)
    ready(url_of(settings.host, listening.getsockname()[1]))
    await stop.wait()
    server.should_exit = True
    await serving
    return 0


def _sender(settings: Settings) -> Sender:
    """Return what delivers to webhooks. Raises TargetsError, CannotStart."""
    try:
        return Sender(Targets(settings.webhook_targets), VERSION, settings.webhook_authorities)
    except (OSError, ValueError) as wrong:
        raise CannotStart(f"webhook_authorities {settings.webhook_authorities} cannot be read: {wrong}") from None


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


def who_may_call(controller: Controller, settings: Settings) -> str:
    """Return in a sentence who may call the server: it is better read than found out."""
    if settings.access_key is not None or controller.reception.access.closed:
        return "Whoever calls has to say who they are (docs/access.md)."
    if settings.access == "required":
        return "Nobody can log in yet: hoistway users add NAME --role admin."
    return "Everybody on this machine may do everything: nobody has to log in until there is a user (docs/access.md)."


def _configured(controller: Shown, settings: Settings) -> uvicorn.Config:
    return uvicorn.Config(
        application(controller, settings),
        loop="none",
        http=bounded(min(settings.connections, _files() // 2)),
        ws=Stream,
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
