"""``hoistway layout export`` and ``render``: a plant handed on to other tools and to people."""

from __future__ import annotations

import sys
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.findings import lines_of
from app.cli.plainly import plainly, refuse, said, text_of
from app.cli.tongue import counted_here, language, say, told_here

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.plant.exchange.geojson_writer import Origin
    from app.plant.findings import Finding


class To(StrEnum):
    """A format that layouts are written in."""

    LIF = "lif"
    GEOJSON = "geojson"
    GRAPHML = "graphml"
    NODE_LINK = "node-link"


_ENDINGS = {".geojson": To.GEOJSON, ".graphml": To.GRAPHML, ".lif": To.LIF, ".lif.json": To.LIF}


def plant_of(file: Path) -> Plant:
    """Return a plant file's plant, with its drives' catalogues. Raises CannotStart, UnusablePlant."""
    from app.cli.catalogues import with_catalogues
    from app.plant import read

    plant, _ = read(text_of(file), str(file))
    return with_catalogues(plant, file)[0]


def export(
    plant: Annotated[Path, typer.Argument(help="a plant file, YAML")],
    output: Annotated[Path, typer.Option("--output", "-o", help="where to write it")],
    to: Annotated[To | None, typer.Option("--format", help="without: by the file's ending")] = None,
    origin: Annotated[str, typer.Option(help="GeoJSON: LATITUDE,LONGITUDE of the plan's [0, 0], in degrees")] = "",
    bearing: Annotated[float, typer.Option(help="GeoJSON: compass direction of the plan's upward axis, degrees")] = 0.0,
    links: Annotated[
        bool, typer.Option("--links", help="node-link: name the edges links, as networkx before 3.4")
    ] = False,
    timestamp: Annotated[
        str, typer.Option(help="LIF: the time that the file is to have (without: now), ISO 8601")
    ] = "",
) -> None:
    """Write a plant's layout as VDA LIF, GeoJSON, GraphML or node-link JSON, and say what the format cannot carry."""
    wanted = to or next((kind for ending, kind in _ENDINGS.items() if output.name.casefold().endswith(ending)), None)
    if wanted is None:
        refuse(f"{output.name} does not tell the format", f"Say --format: {', '.join(To)}.")
    with plainly():
        given = plant_of(plant)
    place = _origin(origin, bearing)
    text, lost = _written(given, wanted, place, timestamp, links=links)
    write_file(output, text.encode())
    sizes = {"barcodes": len(given.points), "edges": len(given.edges), "stations": len(given.stations)}
    print(f"{output}: {wanted.value}, " + ", ".join(counted_here(count, what) for what, count in sizes.items()))
    for line in lost:
        print(f"{told_here('left out')}: {told_here(line)}")


def _written(plant: Plant, to: To, origin: Origin | None, timestamp: str, *, links: bool) -> tuple[str, list[str]]:
    from app.plant.exchange.geojson_writer import write_geojson
    from app.plant.exchange.graph_writers import write_graphml, write_node_link
    from app.plant.exchange.lif_writer import write_lif

    match to:
        case To.LIF:
            return write_lif(plant, timestamp or _now())
        case To.GEOJSON:
            return write_geojson(plant, origin)
        case To.GRAPHML:
            return write_graphml(plant)
        case To.NODE_LINK:
            return write_node_link(plant, "links" if links else "edges")


def _now() -> str:
    from datetime import UTC, datetime

    return datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%S.00Z")


def _origin(text: str, bearing: float) -> Origin | None:
    from app.plant.exchange.geojson_writer import Origin

    if not text:
        return None
    try:
        latitude, longitude = (float(part) for part in text.split(","))
    except ValueError:
        refuse(f"--origin {text} is no place", "Write LATITUDE,LONGITUDE, such as 37.25,127.05.")
    if not (abs(latitude) <= 85 and abs(longitude) <= 180 and abs(bearing) <= 360):
        refuse(f"--origin {text} is no place", "Latitudes are -85 to 85, longitudes -180 to 180, bearings -360 to 360.")
    return Origin(latitude, longitude, bearing)


def write_file(file: Path, data: bytes) -> None:
    """Write a file; what goes wrong ends the command in a sentence."""
    try:
        file.write_bytes(data)
    except OSError as wrong:
        refuse(f"{file} cannot be written: {said(wrong)}")


def render(
    plant: Annotated[Path, typer.Argument(help="a plant file, YAML")],
    output: Annotated[Path, typer.Option("--output", "-o", help="the picture, .svg or .png")],
    width: Annotated[int, typer.Option(min=640, max=12_000, help="pixels; the height follows from the plan")] = 1600,
    dark: Annotated[bool, typer.Option("--dark", help="light on dark")] = False,
    no_labels: Annotated[bool, typer.Option("--no-labels", help="no names")] = False,
) -> None:
    """Draw a plant: track with its direction, stations, zones, doors, parking, names where there is room, legend, scale.

    Of a file with errors what can be drawn is; they are named on standard error, and the exit code is 1.
    """
    from app.plant.picture import Look, compose, has_wide_letters, png, svg

    ending = output.suffix.casefold()
    if ending not in (".svg", ".png"):
        refuse(f"{output.name} is neither .svg nor .png")
    with plainly():
        given, wrong = _understood(plant)
    for finding in wrong:
        for line in lines_of(plant, finding):
            print(line, file=sys.stderr)
    if given is None or not given.points:
        refuse(f"nothing of {plant} can be drawn" if wrong else f"{plant} has no barcodes to draw")
    legible = ending == ".svg" or language() == "en" or has_wide_letters()
    drawing = compose(given, Look(width, dark=dark, labels=not no_labels), told_here if legible else str)
    write_file(output, svg(drawing).encode() if ending == ".svg" else png(drawing))
    say(f"{output}: {drawing.width} x {drawing.height} pixels")
    if not legible:
        say(
            "No font of this machine has Korean letters, so the PNG speaks English; an SVG does not need one.",
            wrong=True,
        )
    if wrong:
        refuse(f"{plant} has errors: only what is understood is drawn")


def _understood(file: Path) -> tuple[Plant | None, list[Finding]]:
    """Return what is to be drawn, as far as it is understood, and what is wrong with it. Raises CannotStart."""
    from app.plant import UnusablePlant, read

    try:
        return read(text_of(file), str(file))[0], []
    except UnusablePlant as unusable:
        return unusable.understood, unusable.findings
