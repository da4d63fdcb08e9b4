"""What the symbols of a plan mean, those that it has, and how long a metre is."""

from collections.abc import Callable
from math import floor, log10

from app.domain.layout import Plant, StationKind
from app.plant.picture.palette import Palette
from app.plant.picture.shapes import Area, Disc, Drawing, Line, Shape, Spot, Text, text_width
from app.plant.picture.symbols import charger, door, parking, station, vehicle
from app.plant.picture.track import arrows

LEFT, ROW, SIZE = 48.0, 24.0, 12.0
BAR = 180.0
"""About how many pixels long the scale bar is."""
Symbol = Callable[[Spot], list[Shape]]


def legend(
    drawing: Drawing, plant: Plant, palette: Palette, scale: float, top: float, tell: Callable[[str], str]
) -> None:
    """Draw the legend and, at the right, the scale bar. ``scale``: pixels in a millimetre; ``tell``: translates."""
    _bar(drawing, palette, scale, top + 34)
    drawing.shapes.append(Line(((LEFT, top), (drawing.width - LEFT, top)), palette.zone, 1.0))
    x, y, right = LEFT, top + 28, drawing.width - LEFT - BAR - 40
    for name, draw in _symbols(plant, palette):
        text = tell(name)
        wide = 30 + text_width(text, SIZE) + 22
        if x + wide > right and x > LEFT:
            x, y = LEFT, y + ROW
        drawing.shapes += draw((x + 10, y))
        drawing.shapes.append(Text((x + 28, y + 4), text, palette.ink, SIZE))
        x += wide


def _symbols(plant: Plant, palette: Palette) -> list[tuple[str, Symbol]]:
    pairs = {(edge.start, edge.end) for edge in plant.edges}
    both = any((end, start) in pairs for start, end in pairs)
    kinds = {given.kind for given in plant.stations}
    named = {
        StationKind.PORT: "port",
        StationKind.SBFL: "side buffer, left",
        StationKind.SBFR: "side buffer, right",
        StationKind.AGV_BUFFER: "AGV buffer",
    }
    found: list[tuple[str, Symbol]] = [("one-way track", lambda s: _track(s, palette))]
    if both:
        found.append(("two-way track", lambda s: [Line(((s[0] - 10, s[1]), (s[0] + 10, s[1])), palette.both, 3)]))
    for kind, text in named.items():
        if kind in kinds:
            found.append((text, lambda s, kind=kind: station(kind, s, 11, palette)))  # type: ignore[misc]
    if any(point.park for point in plant.points):
        found.append(("parking", lambda s: parking(s, 10, palette)))
    if plant.zones:
        found.append(("zone", lambda s: [Disc(s, 9, palette.zone)]))
    if plant.doors:
        found.append(("door", lambda s: door((s[0] - 10, s[1]), (s[0] + 10, s[1]), 8, palette)))
    if plant.chargers:
        found.append(("charger", lambda s: charger(s, 10, palette)))
    if any(given.start is not None for given in plant.vehicles):
        found.append(("vehicle's start", lambda s: vehicle(s, (1.0, 0.0), 9, palette)))
    return found


def _track(spot: Spot, palette: Palette) -> list[Shape]:
    line = ((spot[0] - 10, spot[1]), (spot[0] + 10, spot[1]))
    heads: list[Shape] = [Area(head, palette.arrow) for head in arrows(line, 40, 9)]
    return [Line(line, palette.track, 2.5), *heads]


def _bar(drawing: Drawing, palette: Palette, scale: float, y: float) -> None:
    wanted = BAR / scale
    power = 10 ** floor(log10(wanted))
    length = max(step * power for step in (1, 2, 5) if step * power <= wanted)
    text = f"{length / 1000:g} m" if length >= 1000 else f"{length:g} mm"
    right, left = drawing.width - LEFT, drawing.width - LEFT - length * scale
    drawing.shapes.append(Line(((left, y), (right, y)), palette.ink, 2.0))
    drawing.shapes += [Line(((x, y - 5), (x, y + 5)), palette.ink, 2.0) for x in (left, right)]
    drawing.shapes.append(Text(((left + right) / 2, y - 9), text, palette.ink, SIZE, "middle"))
