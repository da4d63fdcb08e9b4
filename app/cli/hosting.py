"""The controller and its server in one process."""

import asyncio
import gc
import os
import resource
import socket
import ssl
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager, contextmanager
from typing import Any

import uvicorn
from fastapi import FastAPI
from structlog.typing import FilteringBoundLogger

from app.api import application
from app.api.application import VERSION
from app.api.connections import bounded
from app.api.port import Controller as Shown
from app.api.streams import Stream
from app.cli.changes import Changes
from app.cli.plainly import CannotStart, said
from app.cli.running import COLLECTED, url_of
from app.cli.tls import context_of, renewed
from app.domain.errors import PlantError
from app.domain.layout import Plant
from app.domain.units import Seconds
from app.runtime.clock import Clock
from app.runtime.controller import Controller
from app.runtime.notify import Notifier
from app.runtime.recording import Limits
from app.runtime.telemetry import logger
from app.runtime.tracing import Traces, provider
from app.runtime.webhooks import Sender, Targets
from app.settings import Settings

GRACE = 3
"""Seconds for requests under way when the server stops. Our choice."""
TRIAL = 30.0
"""Seconds that a version of the plant has to run until what kills the controller is not taken for its doing. Our choice."""
FILES = 1 << 16
"""Most open files that we ask the system for. Our choice."""
WORD = 1 << 16
"""Longest message that a watcher may send before its connection is cut, bytes. Our choice."""


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
    changes: Changes | None = None,
) -> int:
    """Run the controller and its server until ``stop`` or until the plant is lost; return the exit code.

    ``seen`` is told the controller once it runs, ``ready`` the URL once requests are answered; so is the service manager, if
    there is one to ``notify``, and it is fed as long as the controller lives. When ``changes`` give another plant, the
    controller stops and starts anew with it: new connections wait meanwhile.
    Raises CannotStart (an address or a certificate cannot be used), PlantHeld, StoreError, TracesMissing, TargetsError.
    """
    notify = notify or Notifier({})
    context = context_of(settings)
    traces = Traces(provider(plant.name, VERSION, os.environ)) if settings.traces else None
    try:
        while True:
            controller = await _started(plant, settings, traces, changes, restored=restored)
            plant, restored = controller.plant, False
            try:
                seen(controller)
                following = await _serve(controller, settings, listening.dup(), stop, ready, notify, changes, context)
            finally:
                await controller.stop()
            if controller.lost.done():
                return 1
            if following is None or stop.is_set():
                return 0
            plant = following if changes is None else await changes.settle(plant)
    finally:
        if traces is not None:
            await asyncio.to_thread(traces.close)


async def _started(
    plant: Plant, settings: Settings, traces: Traces | None, changes: Changes | None, *, restored: bool
) -> Controller:
    """Return a controller that runs: with the plant, or, if that cannot begin after a change, with the one before."""
    days, size = settings.playback_days, settings.playback_megabytes
    playback = Limits(days * 86_400.0, size * 1_000_000) if days else None
    sender = _sender(settings)
    controller = Controller(
        plant,
        settings.database,
        restored=restored,
        keep_events=settings.keep_events,
        playback=playback,
        webhooks=lambda: sender,
        versions=None if changes is None else changes.versions,
        version=None if changes is None else changes.number,
    )
    if traces is not None:
        controller.figures.jobs.told = traces.take
    try:
        await controller.start()
    except PlantError as wrong:
        before = None if changes is None else await changes.fall_back(plant, wrong.message)
        if before is None:
            raise
        return await _started(before, settings, traces, changes, restored=restored)
    except OSError as wrong:
        address = ":".join(map(str, plant.listen or ()))
        refused = CannotStart(
            f"cannot listen for vehicles at {address}: {said(wrong)}",
            remedy="Write another one as listen into the plant file.",
        )
        before = None if changes is None else await changes.fall_back(plant, refused.message, listening=True)
        if before is None:
            raise refused from None
        return await _started(before, settings, traces, changes, restored=restored)
    return controller


@asynccontextmanager
async def _answering(
    controller: Shown, settings: Settings, listening: socket.socket, context: ssl.SSLContext | None = None
) -> AsyncIterator[asyncio.Task[None]]:
    """Answer requests within; it gives the task that does. Raises CannotStart: it did not come up."""
    app = application(controller, settings)
    server = _Server(_configured(app, settings, context))
    serving = asyncio.create_task(server.serve([listening]))
    while not server.started and not serving.done():
        await asyncio.sleep(0.01)
    if not server.started:
        listening.close()
        wrong = serving.exception()
        why = said(wrong) if isinstance(wrong, OSError) else repr(wrong)
        raise CannotStart(f"requests cannot be answered: {why}") from wrong
    try:
        yield serving
    finally:
        app.state.callers.leave()
        server.should_exit = True
        await serving


async def _serve(
    controller: Controller,
    settings: Settings,
    listening: socket.socket,
    stop: asyncio.Event,
    ready: Callable[[str], None],
    notify: Notifier,
    changes: Changes | None,
    context: ssl.SSLContext | None,
) -> Plant | None:
    """Serve requests until something ends that; return the plant to go on with, None if there is none."""
    log = logger(plant=controller.plant.name)
    url = url_of(settings.host, listening.getsockname()[1], tls=settings.tls_certificate is not None)
    async with _answering(controller, settings, listening, context) as serving:
        gc.collect()
        gc.freeze()
        gc.set_threshold(*COLLECTED)
        ready(url)
        notify.ready(f"controls {controller.plant.name} at {url}")
        notify.feed(controller, lambda reason: log.critical("the watchdog is not fed", reason=reason))
        renewing = asyncio.create_task(renewed(context, settings, log))
        changing = asyncio.create_task(changes.next(controller.plant) if changes else _never())
        proving = asyncio.create_task(_proven(changes))
        stopping = asyncio.create_task(stop.wait())
        try:
            following = await _followed(changing, {serving, stopping, controller.lost}, log)
        finally:
            for task in (stopping, changing, renewing, proving):
                task.cancel()
        if changes is not None and (following is not None or stop.is_set()):
            await changes.started()
        if following is None:
            notify.stopping()
        else:
            notify.feed(_ChangeOver(), lambda reason: log.critical("the watchdog is not fed", reason=reason))
        return following


async def _proven(changes: Changes | None) -> None:
    """A version that has run for a while is no longer on trial: what ends the controller then is not the version's doing."""
    if changes is not None:
        await asyncio.sleep(TRIAL)
        await changes.started()


async def _followed(
    changing: asyncio.Task[Plant], ends: set[asyncio.Future[Any]], log: FilteringBoundLogger
) -> Plant | None:
    """Return the plant that is to follow; None: one of the ends has come first."""
    await asyncio.wait({changing, *ends}, return_when=asyncio.FIRST_COMPLETED)
    if changing.done() and (defect := changing.exception()) is not None:
        # A plant that runs does not end because its new file cannot be looked at.
        log.critical("the plant file is not looked at any more", reason=repr(defect))
        await asyncio.wait(ends, return_when=asyncio.FIRST_COMPLETED)
        return None
    return None if any(end.done() for end in ends) else changing.result()


class _ChangeOver:
    """The heart while no controller runs: it was last seen to beat when the change-over began."""

    def __init__(self) -> None:
        self._clock = Clock()
        self._began = self._clock.now()

    def silent_for(self) -> Seconds:
        return Seconds(self._clock.now() - self._began)


async def _never() -> Plant:
    """Wait for a plant where none can come."""
    never: asyncio.Future[Plant] = asyncio.get_running_loop().create_future()
    return await never


async def serve_only(
    controller: Shown,
    settings: Settings,
    listening: socket.socket,
    stop: asyncio.Event,
    ready: Callable[[str], None],
) -> int:
    """Serve what cannot change any more until ``stop``; return the exit code. Raises CannotStart."""
    async with _answering(controller, settings, listening) as serving:
        ready(url_of(settings.host, listening.getsockname()[1]))
        stopping = asyncio.create_task(stop.wait())
        await asyncio.wait({serving, stopping}, return_when=asyncio.FIRST_COMPLETED)
        stopping.cancel()
    return 0 if stop.is_set() else 1


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


def who_may_call(controller: Controller, settings: Settings) -> str:
    """Return in a sentence who may call the server: it is better read than found out."""
    if settings.access_key is not None or controller.reception.access.closed:
        return "Whoever calls has to say who they are (docs/access.md)."
    if settings.access == "required":
        return "Nobody can log in yet: hoistway users add NAME --role admin."
    return "Everybody on this machine may do everything: nobody has to log in until there is a user (docs/access.md)."


class _Config(uvicorn.Config):
    """Settings of a server that speaks TLS by a context of ours, which outlives it."""

    context: ssl.SSLContext | None = None

    def load(self) -> None:
        super().load()
        self.ssl = self.context


def _configured(app: FastAPI, settings: Settings, context: ssl.SSLContext | None = None) -> uvicorn.Config:
    config = _Config(
        app,
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
    config.context = context
    return config
