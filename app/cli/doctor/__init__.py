"""``hoistway doctor``: whether everything that a controller needs is there, before it is started, or when something is wrong."""

from __future__ import annotations

import json as jsons
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from app.cli.doctor.found import Found, Verdict
from app.cli.tongue import told_here


def doctor(
    plant: Annotated[Path | None, typer.Option(help="the plant file")] = None,
    database: Annotated[str | None, typer.Option(help="SQLAlchemy URL; without it, as hoistway serve takes it")] = None,
    host: Annotated[str | None, typer.Option(help="address that the server would listen at")] = None,
    port: Annotated[int | None, typer.Option(help="port that the server would listen at")] = None,
    config: Annotated[Path | None, typer.Option(help="settings file, TOML or YAML")] = None,
    *,
    reach: Annotated[
        bool, typer.Option(help="knock at every vehicle and device; never while a controller runs")
    ] = True,
    json: Annotated[bool, typer.Option("--json", help="print what was found as JSON")] = False,
) -> None:
    """Look at settings, machine, clock, database, plant, ports, serial ports and vehicles; exit 1 if one keeps it from running.

    Changes nothing. Takes the settings that hoistway serve would take: run it as the same user.
    """
    from app.cli.doctor.looks import everything

    found = everything(config, reach=reach, plant=plant, database=database, host=host, port=port)
    if json:
        print(jsons.dumps([{**asdict(one), "verdict": one.verdict.value} for one in found], ensure_ascii=False))
    else:
        _show(found)
    if any(one.verdict is Verdict.WRONG for one in found):
        raise typer.Exit(1)


def _show(found: list[Found]) -> None:
    from rich.cells import cell_len
    from rich.console import Console
    from rich.text import Text

    console = Console(highlight=False, soft_wrap=True)
    before = ""
    for one in found:
        sign, colour = _SIGNS[one.verdict]
        mark = (told_here(sign) + " " * (8 - cell_len(told_here(sign))), colour)
        console.print(Text.assemble(mark, (f"{told_here(one.what)}: ", "bold"), told_here(one.message)))
        if one.remedy and one.remedy != before:
            console.print(Text(f"        {told_here(one.remedy)}", style="dim"))
        before = one.remedy
    counts = {verdict: sum(one.verdict is verdict for one in found) for verdict in Verdict}
    console.print(
        told_here(f"{counts[Verdict.WELL]} well, {counts[Verdict.DOUBTFUL]} doubtful, {counts[Verdict.WRONG]} wrong")
    )


_SIGNS = {Verdict.WELL: ("ok", "green"), Verdict.DOUBTFUL: ("doubt", "yellow"), Verdict.WRONG: ("WRONG", "bold red")}
