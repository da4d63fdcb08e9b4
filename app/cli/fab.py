"""``hoistway fab``: a generated fab as a plant file, and its statistics."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.plainly import refuse, said
from app.cli.tongue import say, table_of

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.plant.fab import Fab


def fab(
    file: Annotated[Path | None, typer.Argument(help="where to write the plant file (without: nowhere)")] = None,
    size: Annotated[str, typer.Option(help="1k, 10k, 50k or 50k-dense: about so many barcodes")] = "10k",
    seed: Annotated[int, typer.Option(help="draws depths of bays, shortcuts, ports, and where vehicles start")] = 1,
    vehicles: Annotated[int, typer.Option(min=0, max=10_000, help="so many hoists, evenly spread")] = 0,
    carriers: Annotated[float, typer.Option(min=0, max=1, help="the share of ports that hold a carrier")] = 0.0,
    statistics: Annotated[bool, typer.Option("--statistics", help="print what the fab measures")] = False,
) -> None:
    """Generate a whole fab, the same for the same size and seed: write it as a plant file, print its statistics, or both."""
    from app.plant.fab import SIZES, generate, populate, write
    from app.wire.names import unknown

    if size not in SIZES:
        say(unknown("size", size, SIZES))
        raise typer.Exit(2)
    if file is None and not statistics:
        refuse("nothing to do", "Name a file to write, or ask for --statistics.")
    made = generate(SIZES[size], seed)
    try:
        plant = populate(made.plant, vehicles, seed, carriers)
    except ValueError as wrong:
        refuse(str(wrong), "Ask for less, or for a larger --size.")
    if file is not None:
        try:
            file.write_text(write(plant), encoding="utf-8")
        except OSError as wrong:
            refuse(f"{file} cannot be written: {said(wrong)}")
    if statistics:
        _show(made, plant)


def _show(made: Fab, plant: Plant) -> None:
    from app.plant.fab import statistics

    figures = {"fab": plant.name, "bays": len(made.bays), **asdict(statistics(plant))}
    figures |= {"vehicles": len(plant.vehicles), "carriers": len(plant.carriers)}
    for line in table_of({what.replace("_", " "): value for what, value in figures.items()}):
        print(line)
