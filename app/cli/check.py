"""``hoistway check PLANT``: what is wrong with a plant file, and where."""

from __future__ import annotations

import json as jsons
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from app.cli.catalogues import with_catalogues
from app.cli.plainly import CannotStart, text_of
from app.cli.tongue import counted_here, told_here

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.plant import Finding

_COLOURS = {"error": "red", "warning": "yellow"}
_MM_PER_KM = 1_000_000


def check(
    plant: Annotated[Path, typer.Argument(help="a plant file, YAML")],
    json: Annotated[bool, typer.Option("--json", help="print findings and counts as JSON")] = False,
) -> None:
    """Say what is wrong with a plant file and its drives' catalogues: line, column, message, remedy; exit 1 if it is unusable."""
    from app.plant import Finding, UnusablePlant, read

    try:
        text = text_of(plant)
    except CannotStart as wrong:
        print(told_here(wrong.message))
        if wrong.remedy:
            print(f"    {told_here(wrong.remedy)}")
        raise typer.Exit(2) from None
    found: Plant | None = None
    try:
        found, findings = read(text, str(plant))
    except UnusablePlant as unusable:
        findings = unusable.findings
    usable, others = found is not None, list[tuple[Path, Finding]]()
    if found is not None:
        try:
            found, others, usable = with_catalogues(found, plant)
        except CannotStart as wrong:
            print(told_here(wrong.message))
            raise typer.Exit(2) from None
    if json:
        listed = [{**asdict(finding), "severity": finding.severity.value} for finding in findings]
        listed += [{**asdict(one), "severity": one.severity.value, "file": str(file)} for file, one in others]
        print(
            jsons.dumps({"file": str(plant), "plant": found and counts(found), "findings": listed}, ensure_ascii=False)
        )
    else:
        _show(plant, found, [*((plant, finding) for finding in findings), *others])
    if not usable:
        raise typer.Exit(1)


def counts(plant: Plant) -> dict[str, Any]:
    """Return how much of everything a plant has; ``kilometres`` is the length of its track."""
    return {
        "name": plant.name,
        "barcodes": len(plant.points),
        "edges": len(plant.edges),
        "kilometres": round(sum(edge.length for edge in plant.edges) / _MM_PER_KM, 3),
        "stations": len(plant.stations),
        "zones": len(plant.zones),
        "vehicles": len(plant.vehicles),
        "carriers": len(plant.carriers),
    }


def _show(file: Path, plant: Plant | None, findings: list[tuple[Path, Finding]]) -> None:
    from rich.console import Console
    from rich.text import Text

    console = Console(highlight=False, soft_wrap=True)
    for where, finding in findings:
        severity = (told_here(finding.severity.value), _COLOURS[finding.severity])
        place = (f"{where}:{finding.line}:{finding.column}: ", "bold")
        console.print(Text.assemble(place, severity, f": {told_here(finding.message)}"))
        if finding.remedy:
            console.print(Text(f"    {told_here(finding.remedy)}", style="dim"))
    errors = sum(finding.is_error for _, finding in findings)
    others = counted_here(len(findings) - errors, "warnings")
    console.print(Text(f"{file}: {counted_here(errors, 'errors')}, {others}"))
    if plant is not None:
        summary = counts(plant)
        name, kilometres = summary.pop("name"), summary.pop("kilometres")
        counted = ", ".join(counted_here(value, what) for what, value in summary.items())
        console.print(Text(f"{name}: {counted}; {told_here(f'{kilometres} km of track')}"))
