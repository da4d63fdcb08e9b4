"""What every command that runs for long needs: a plant, an event loop, and a way to be told to stop."""

from __future__ import annotations

import asyncio
import gc
import signal
import socket
from collections.abc import Callable, Coroutine, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from app.cli.catalogues import catalogue_texts, equipped, with_texts
from app.cli.plainly import CannotStart, FileInError, said, text_of

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.domain.versions import Source
    from app.plant.understood import Understood

COLLECTED = (10_000, 20, 50)
"""New objects until they are looked through for rings, and how many times until older ones are: neither what is imported nor a
backlog of thousands of jobs is garbage, to be looked through all the time. Our choice."""


def plant_of(file: Path) -> Plant:
    """Return the plant of a file. Raises CannotStart."""
    return plant_and_text_of(file)[0]


def plant_and_text_of(file: Path) -> tuple[Plant, str]:
    """Return the plant of a file, and what the file says. Raises CannotStart."""
    with uncollected():
        from app.plant import UnusablePlant, read

    text = text_of(file)
    try:
        plant, _ = read(text, str(file))
    except UnusablePlant as unusable:
        errors = sum(finding.severity.value == "error" for finding in unusable.findings)
        raise FileInError(f"the plant file {file} has errors: {errors}", remedy=f"See: hoistway check {file}") from None
    return equipped(plant, file), text


def reader_of(file: Path) -> Callable[[Source], Understood]:
    """Return what reads a source as if it stood in a plant file: catalogues that it does not bring are looked for beside that.

    It raises UnusablePlant: the text, or a catalogue, has errors.
    """
    from app.plant import UnusablePlant, read
    from app.plant.understood import Understood

    def read_as(source: Source) -> Understood:
        plant, findings = read(source.text, str(file))
        kept = source.catalogues
        texts = catalogue_texts(plant, file) if kept is None else kept
        whole, besides, usable = with_texts(plant, file, texts)
        if not usable:
            raise UnusablePlant("its catalogues", [finding for _, finding in besides])
        return Understood(whole, [*findings, *(finding for _, finding in besides)], replace(source, catalogues=texts))

    return read_as


@contextmanager
def uncollected() -> Iterator[None]:
    """Look for no rings of garbage in the block: nothing of what is imported is ever garbage, and it is much."""
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()


def bound(host: str, port: int, option: str = "--port") -> socket.socket:
    """Return a socket that listens there; ``option`` is what chose the port. Raises CannotStart."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        return socket.create_server((host, port), family=family, backlog=2048)
    except OSError as wrong:
        raise CannotStart(
            f"cannot listen at {host}:{port}: {said(wrong)}", remedy=f"Choose another one with {option}."
        ) from None


def url_of(host: str, port: int, *, tls: bool = False) -> str:
    """Return where a person finds the server."""
    shown = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}.get(host, f"[{host}]" if ":" in host else host)  # noqa: S104 (shown, not listened at)
    return f"{'https' if tls else 'http'}://{shown}:{port}"


def on_loop(main: Coroutine[Any, Any, int]) -> int:
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


def on_again(call: Callable[[], None]) -> None:
    """Call something on SIGHUP, where the system has it: look at the plant file again."""
    if hasattr(signal, "SIGHUP"):
        asyncio.get_running_loop().add_signal_handler(signal.SIGHUP, call)
