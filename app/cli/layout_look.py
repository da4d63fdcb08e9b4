"""``hoistway layout check`` and ``diff``: what is wrong, tight or different."""

from __future__ import annotations

import json as jsons
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.findings import lines_of
from app.cli.plainly import CannotStart, text_of
from app.cli.tongue import say, table_of, told_here
from app.domain.errors import StoreError

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.plant.difference import Broken, Difference
    from app.plant.findings import Finding
    from app.plant.survey import Survey


def check(
    plant: Annotated[Path, typer.Argument(help="a plant file, YAML")],
    json: Annotated[bool, typer.Option("--json", help="print findings, remarks and figures as JSON")] = False,
) -> None:
    """Say what `hoistway check` says, and beyond: tight or doubled places, ways without another, figures. Exit 1: errors."""
    from app.plant.survey import survey

    found, findings = _read(plant)
    seen = survey(found) if found is not None and found.points else None
    if json:
        told = [{**asdict(finding), "severity": finding.severity.value} for finding in findings]
        remarks = [asdict(remark) for remark in seen.remarks] if seen else []
        figures = seen.figures if seen else None
        print(
            jsons.dumps(
                {"file": str(plant), "findings": told, "remarks": remarks, "figures": figures}, ensure_ascii=False
            )
        )
    else:
        for finding in findings:
            for line in lines_of(plant, finding):
                print(line)
        if seen is not None:
            _show(seen)
    if found is None:
        raise typer.Exit(1)


def _read(file: Path) -> tuple[Plant | None, list[Finding]]:
    """Return a file's plant, None if it is unusable, and the findings; what cannot be read ends the command with 2."""
    from app.plant import UnusablePlant, read

    try:
        return read(text_of(file), str(file))
    except CannotStart as wrong:
        print(told_here(wrong.message))
        raise typer.Exit(2) from None
    except UnusablePlant as unusable:
        return None, unusable.findings


def _show(seen: Survey) -> None:
    for remark in seen.remarks:
        named, rest = ", ".join(remark.barcodes), remark.count - len(remark.barcodes)
        places = told_here(f"{named} and {rest} more") if rest > 0 else named
        print(f"{told_here(remark.topic)}: {places}: {told_here(remark.message)}")
        if remark.remedy:
            print(f"    {told_here(remark.remedy)}")
    for line in table_of(seen.figures):
        print(line)


def diff(
    old: Annotated[Path, typer.Argument(help="the plant file as it was")],
    new: Annotated[Path, typer.Argument(help="the plant file as it is to be")],
    database: Annotated[
        str, typer.Option(help="the running plant's database: name what it has under way that would break")
    ] = "",
    json: Annotated[bool, typer.Option("--json", help="print the changes and what they break as JSON")] = False,
) -> None:
    """Say what differs between two plant files, and what that breaks in a plant that has run. Exit 1: something breaks."""
    from app.plant.difference import Difference, difference

    plants = []
    for file in (old, new):
        found, findings = _read(file)
        if found is None:
            print(next(lines_of(file, next(finding for finding in findings if finding.is_error))))
            say(f"    see all: hoistway check {file}")
            raise typer.Exit(2)
        plants.append(found)
    made = difference(*plants)
    if database:
        made = Difference(made.changes, _under_way(plants[0], plants[1], database))
    if json:
        changes = [asdict(change) for change in made.changes]
        print(jsons.dumps({"changes": changes, "breaks": [asdict(item) for item in made.broken]}, ensure_ascii=False))
    else:
        _show_difference(made)
    if made.broken:
        raise typer.Exit(1)


def _under_way(old: Plant, new: Plant, database: str) -> list[Broken]:
    """Return what the database has under way that the new plant has no place for."""
    from app.plant.touched import touched
    from app.store.standing import standing

    try:
        return touched(old, new, standing(database))
    except StoreError as wrong:
        print(f"{told_here(wrong.message)}. {told_here(wrong.remedy)}".rstrip())
        raise typer.Exit(2) from None


def _show_difference(made: Difference) -> None:
    for change in made.changes:
        print(change_line(change.what, change.name, change.how, change.text))
    for item in made.broken:
        print(f"{told_here('breaks')}: {told_here(item.what)} {named(item.name)}: {told_here(item.text)}")
        touched = ", ".join(told_here(what) for what in item.touches)
        print(f"    {told_here(item.remedy)} ({told_here('may refer to it')}: {touched})")
    if not made.changes:
        say("no difference")


def named(name: str) -> str:
    """Return a name, or several: ``1001 and 3 more``. A lone one is nobody's to translate."""
    return told_here(name) if " " in name else name


def change_line(what: str, name: str, how: str, text: str) -> str:
    """Return one difference between two plants in the language of this process."""
    line = f"{told_here(what)} {named(name)} {told_here(how)}"
    return f"{line}: {told_here(text)}" if text else line
