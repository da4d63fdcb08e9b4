"""``hoistway layout``: bring a layout from elsewhere, look at it, compare it, hand it on."""

from __future__ import annotations

import json as jsons
from dataclasses import asdict
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from app.cli import layout_look, layout_out, layout_versions
from app.cli.findings import lines_of
from app.cli.plainly import CannotStart, refuse, said, spared, text_of
from app.cli.tongue import counted_here, told_here
from app.domain.errors import HoistwayError

if TYPE_CHECKING:
    from app.plant.exchange.importing import Imported, Wishes

commands = typer.Typer(
    help="Import, check, draw, compare and export layouts; change the running plant.",
    no_args_is_help=True,
    rich_markup_mode=None,
)
commands.command()(layout_out.export)
commands.command()(layout_out.render)
commands.command()(layout_look.check)
commands.command()(layout_look.diff)
for command in (
    layout_versions.stage,
    layout_versions.versions,
    layout_versions.get,
    layout_versions.activate,
    layout_versions.reject,
    layout_versions.rollback,
):
    commands.command()(command)
SIZE_LIMIT = 64 << 20
"""Largest file that is read, bytes. Our choice."""


class From(StrEnum):
    """A format that layouts are read from."""

    CSV = "csv"
    XLSX = "xlsx"
    LIF = "lif"
    OPENTCS = "opentcs"
    NODE_LINK = "node-link"
    GRAPHML = "graphml"


class Drives(StrEnum):
    """What drives on a layout."""

    HOIST = "hoist"
    AGV = "agv"


class Unit(StrEnum):
    """A unit of positions."""

    MM = "mm"
    CM = "cm"
    M = "m"


@commands.command("import")
def import_(
    files: Annotated[list[Path], typer.Argument(help="the layout; several files where they are tables of one layout")],
    output: Annotated[Path | None, typer.Option("--output", "-o", help="where to write the plant file")] = None,
    given: Annotated[
        From | None, typer.Option("--format", help="the format, where it is not found out rightly")
    ] = None,
    kind: Annotated[Drives | None, typer.Option(help="what drives there (without: what the layout tells)")] = None,
    name: Annotated[str, typer.Option(help="the plant's name")] = "",
    names: Annotated[
        Path | None, typer.Option(help="CSV with name and barcode: barcodes for the layout's own names")
    ] = None,
    vehicles: Annotated[
        int, typer.Option(min=0, max=2000, help="so many simulated vehicles beside those of the layout")
    ] = 0,
    max_speed: Annotated[
        int | None, typer.Option(min=1, max=100_000, help="vehicles' own speed, mm/s: 100 percent")
    ] = None,
    clearance: Annotated[
        int, typer.Option(min=0, max=100_000, help="least distance of vehicles on other track, mm")
    ] = 0,
    unit: Annotated[Unit | None, typer.Option(help="unit of positions and lengths (lists and graphs)")] = None,
    y_up: Annotated[bool, typer.Option("--y-up", help="y grows upwards (lists and graphs)")] = False,
    encoding: Annotated[str, typer.Option(help="of a CSV file, where it is not found out rightly")] = "",
    in_order: Annotated[bool, typer.Option("--in-order", help="each row of the list leads to the next")] = False,
    loop: Annotated[bool, typer.Option("--loop", help="with --in-order: the last row leads to the first")] = False,
    layout: Annotated[str, typer.Option(help="LIF: one layout alone, by its id")] = "",
    vehicle_type: Annotated[str, typer.Option(help="LIF: the track of one vehicle type alone")] = "",
    keep_locked: Annotated[bool, typer.Option("--keep-locked", help="openTCS: locked paths are track too")] = False,
    force: Annotated[bool, typer.Option("--force", help="write over files that are there")] = False,
    json: Annotated[bool, typer.Option("--json", help="print the report as JSON")] = False,
) -> None:
    """Make a plant file of a barcode list (CSV, XLSX), VDA LIF, openTCS XML, node-link JSON or GraphML, and report what was done.

    Exit 0: the plant file passes the check. 1: it is written, but something in it needs a person. 2: nothing could be made of it.
    """
    from app.domain.layout import VehicleKind
    from app.plant.exchange.detect import Format
    from app.plant.exchange.importing import Wishes
    from app.plant.exchange.settle import Options
    from app.plant.exchange.units import Reading

    wishes = Wishes(
        format=Format(given.value) if given else None,
        encoding=encoding,
        layout=layout,
        vehicle_type=vehicle_type,
        keep_locked=keep_locked,
        reading=Reading(unit.value if unit else "", y_up, in_order or loop, loop),
        options=Options(VehicleKind(kind.value) if kind else None, _names(names), vehicles, max_speed, name, clearance),
    )
    imported = _imported(files, wishes)
    if output is not None:
        _write(output, imported.text, force=force)
    _report(imported, output, json=json)
    if not imported.is_sound:
        raise typer.Exit(1)


def _imported(files: list[Path], wishes: Wishes) -> Imported:
    from app.plant.exchange.importing import import_layout
    from app.plant.exchange.report import UnreadableLayout

    try:
        return import_layout([(file.name, bytes_of(file)) for file in files], wishes)
    except (CannotStart, UnreadableLayout) as wrong:
        _nothing_made(wrong)


def _nothing_made(wrong: HoistwayError) -> NoReturn:
    print(told_here(wrong.message) + (f"\n    {told_here(wrong.remedy)}" if wrong.remedy else ""))
    raise typer.Exit(2)


def bytes_of(file: Path) -> bytes:
    """Return what a file holds. Raises CannotStart: it cannot be read, or is too large."""
    try:
        with file.open("rb") as opened:
            data = opened.read(SIZE_LIMIT + 1)
    except OSError as wrong:
        raise CannotStart(f"{file} cannot be read: {said(wrong)}") from None
    if len(data) > SIZE_LIMIT:
        raise CannotStart(f"{file} cannot be read: it is larger than {SIZE_LIMIT >> 20} MB")
    return data


def _names(file: Path | None) -> dict[str, str]:
    import csv

    from app.plant.names import is_barcode

    if file is None:
        return {}
    try:
        rows = [row for row in csv.reader(text_of(file).splitlines()) if row and not row[0].startswith("#")]
    except CannotStart as wrong:
        refuse(wrong.message)
    found: dict[str, str] = {}
    for number, row in enumerate(rows, 1):
        if number == 1 and [cell.strip().casefold() for cell in row[:2]] == ["name", "barcode"]:
            continue
        if len(row) < 2 or not is_barcode(row[1].strip()):
            refuse(f"{file} row {number}: write a name and a barcode, 1 to 16 visible ASCII characters")
        if row[1].strip() in found.values():
            refuse(f"{file} row {number}: barcode {row[1].strip()} is given to two names")
        found[row[0].strip()] = row[1].strip()
    return found


def _write(file: Path, text: str, *, force: bool) -> None:
    try:
        spared({file: text}, force=force)
        file.write_text(text, encoding="utf-8")
    except CannotStart as wrong:
        _nothing_made(wrong)
    except OSError as wrong:
        print(told_here(f"{file} cannot be written: {said(wrong)}"))
        raise typer.Exit(2) from None


def _report(imported: Imported, output: Path | None, *, json: bool) -> None:
    from app.cli.check import counts

    if json:
        findings = [{**asdict(finding), "severity": finding.severity.value} for finding in imported.findings]
        told = {**imported.report.plain(), "plant": counts(imported.plant), "findings": findings}
        print(jsons.dumps({**told, "file": str(output) if output else None}, ensure_ascii=False))
        return
    print(told_here(imported.report.source))
    counted = ", ".join(counted_here(count, what) for what, count in imported.report.read.items())
    print(f"{told_here('read')}: {counted}")
    for note in imported.report.notes:
        named, rest = note.named
        more = told_here(f" and {rest} more") if rest else ""
        places = ", ".join(map(told_here, named)) + more
        print(f"{told_here(note.kind.value)}: {f'{places}: ' if named else ''}{told_here(note.what)}")
        if note.remedy:
            print(f"    {told_here(note.remedy)}")
    _show_plant(imported, output)


def _show_plant(imported: Imported, output: Path | None) -> None:
    from app.cli.check import counts

    file = output or told_here("(no file: say --output)")
    for finding in imported.findings:
        for line in lines_of(file, finding):
            print(line)
    told = {what: count for what, count in counts(imported.plant).items() if isinstance(count, int) and count}
    errors = sum(finding.is_error for finding in imported.findings)
    print(f"{file}: " + ", ".join(counted_here(count, what) for what, count in told.items()))
    warnings = counted_here(len(imported.findings) - errors, "warnings")
    print(f"hoistway check: {counted_here(errors, 'errors')}, {warnings}")
