"""``hoistway serve``: the controller and its server."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.plainly import FileInError, plainly, refuse
from app.cli.running import bound, on_again, on_loop, plant_and_text_of, stop_signal, uncollected
from app.cli.tongue import say

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.runtime.controller import Controller
    from app.settings import Settings


def serve(
    plant: Annotated[Path | None, typer.Option(help="the plant file")] = None,
    database: Annotated[str | None, typer.Option(help="SQLAlchemy URL, such as sqlite:///hoistway.db")] = None,
    host: Annotated[str | None, typer.Option(help="address to listen at")] = None,
    port: Annotated[int | None, typer.Option(help="port to listen at")] = None,
    config: Annotated[Path | None, typer.Option(help="settings file, TOML or YAML")] = None,
    *,
    restored: Annotated[bool, typer.Option(help="the database is a backup put back: hold every vehicle")] = False,
) -> None:
    """Control a plant and serve REST, live stream and page, until Ctrl-C. SIGHUP: read the plant file again, and change over."""
    from app.settings import load

    with plainly():
        settings = load(config, plant=plant, database=database, host=host, port=port)
        if settings.plant is None:
            refuse("which plant?", "Say --plant FILE, or set HOISTWAY_PLANT.")
        code = _serve(settings, settings.plant, restored=restored)
    raise typer.Exit(code)


def _read(file: Path) -> tuple[Plant, str] | FileInError:
    """Return the plant and the text of its file, or what is wrong with that. Raises CannotStart: it cannot be read at all."""
    try:
        return plant_and_text_of(file)
    except FileInError as wrong:
        return wrong


def _serve(settings: Settings, file: Path, *, restored: bool) -> int:
    from app.runtime.telemetry import set_up

    set_up(as_json=settings.log_format == "json", level=settings.log_level)
    found = _read(file)
    listening = bound(settings.host, settings.port)
    with uncollected():
        from app.cli import hosting  # heavy: a wrong plant file and a port in use are told before
        from app.cli.changes import Changes
        from app.runtime.clock import Clock
        from app.runtime.notify import Notifier

    with Changes(file, settings.database, Clock().utc) as changes:
        plant = changes.instead(found) if isinstance(found, FileInError) else changes.begin(*found)
        said = ""

        def seen(controller: Controller) -> None:
            nonlocal said
            said = hosting.who_may_call(controller, settings)

        def ready(url: str) -> None:
            say(f"hoistway controls {plant.name}: {url}\n{said}")

        async def run() -> int:
            stop, manager = stop_signal(), Notifier(os.environ)
            on_again(changes.look)
            return await hosting.serve(
                plant, settings, listening, stop, ready, restored=restored, seen=seen, notify=manager, changes=changes
            )

        return on_loop(run())
