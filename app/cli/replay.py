"""``hoistway replay``: look at a recorded incident elsewhere."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.plainly import plainly, refuse, said
from app.cli.running import bound, on_loop, stop_signal
from app.cli.tongue import say

if TYPE_CHECKING:
    from app.runtime.incident import Incident


def replay(
    file: Annotated[Path, typer.Argument(help="what GET /api/v1/history/export gave")],
    port: Annotated[int, typer.Option(min=0, max=65535, help="port to listen at")] = 8090,
    *,
    summary: Annotated[bool, typer.Option("--summary", help="say what is in it, and serve nothing")] = False,
) -> None:
    """Serve a recorded incident, its page and its API on this machine, until Ctrl-C. It takes no commands."""
    with plainly():
        incident = _read(file)
        for line in told(incident):
            say(line)
        code = 0 if summary else _serve(incident, port)
    raise typer.Exit(code)


def _read(file: Path) -> Incident:
    from app.runtime.incident import NoIncident, read

    try:
        return read(file.read_bytes())
    except OSError as wrong:
        refuse(f"{file} cannot be read: {said(wrong)}", "Name the file that was exported.")
    except NoIncident as none:
        refuse(f"{file}: {none.message}", none.remedy)


def told(incident: Incident) -> list[str]:
    """Return what is in an incident, for people."""
    from app.runtime.showing import iso

    vehicles = len(incident.state.get("vehicles", {}))
    return [
        f"plant {incident.plant.name}, {iso(incident.begin)} to {iso(incident.end)}",
        f"recorded by {incident.actor}, {iso(incident.made)}",
        f"{vehicles} vehicles, {len(incident.changes)} changes, {len(incident.events)} events",
    ]


def _serve(incident: Incident, port: int) -> int:
    from tempfile import TemporaryDirectory

    from app.cli import hosting
    from app.runtime.recorded import Recorded
    from app.settings import Settings

    settings = Settings(port=port)
    listening = bound(settings.host, port)

    async def run(recorded: Recorded) -> int:
        return await hosting.serve_only(
            recorded, settings, listening, stop_signal(), lambda url: say(f"look at it: {url}")
        )

    with TemporaryDirectory(prefix="hoistway-replay-") as directory:
        recorded = Recorded(incident, Path(directory))
        try:
            return on_loop(run(recorded))
        finally:
            recorded.close()
