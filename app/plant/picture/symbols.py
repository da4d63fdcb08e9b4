"""The symbols of a plan."""

from math import hypot

from app.domain.layout import StationKind
from app.plant.picture.palette import STATIONS, Palette
from app.plant.picture.shapes import Area, Disc, Line, Shape, Spot, Text


def station(kind: StationKind, spot: Spot, size: float, palette: Palette) -> list[Shape]:
    """A port is a square, a side buffer a diamond beside the track, a buffer of AGVs a square with a bar."""
    (x, y), colour, r = spot, STATIONS[kind](palette), size / 2
    edge = palette.paper if size >= 5 else ""
    if kind in (StationKind.SBFL, StationKind.SBFR):
        r *= 1.15
        return [Area(((x, y - r), (x + r, y), (x, y + r), (x - r, y)), colour, edge)]
    square = ((x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r))
    found: list[Shape] = [Area(square, colour, edge)]
    if kind is StationKind.AGV_BUFFER and size >= 5:
        found.append(Line(((x - r * 0.5, y), (x + r * 0.5, y)), palette.paper, max(1.0, size / 7)))
    return found


def parking(spot: Spot, size: float, palette: Palette) -> list[Shape]:
    """A ring with a P, a dot where there is no room."""
    if size < 5:
        return [Disc(spot, size * 0.62, palette.park)]
    ring = Disc(spot, size * 0.72, palette.paper, palette.park, max(1.3, size / 7))
    if size < 9:
        return [ring]
    return [ring, Text((spot[0], spot[1] + size * 0.32), "P", palette.park, size * 0.9, "middle", bold=True)]


def charger(spot: Spot, size: float, palette: Palette) -> list[Shape]:
    """A disc with a flash."""
    x, y, r = *spot, size * 0.8
    flash = ((0.15, -0.72), (-0.45, 0.12), (-0.05, 0.12), (-0.15, 0.72), (0.45, -0.12), (0.05, -0.12))
    return [
        Disc(spot, r, palette.charger, palette.paper, 1.2),
        Area(tuple((x + dx * r, y + dy * r) for dx, dy in flash), palette.paper),
    ]


def door(start: Spot, end: Spot, size: float, palette: Palette) -> list[Shape]:
    """Two bars across the track, half way."""
    length = hypot(end[0] - start[0], end[1] - start[1]) or 1.0
    ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    x, y = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
    found: list[Shape] = []
    for away in (-2.2, 2.2):
        cx, cy = x + ux * away, y + uy * away
        found.append(Line(((cx - uy * size, cy + ux * size), (cx + uy * size, cy - ux * size)), palette.door, 2.4))
    return found


def vehicle(spot: Spot, along: Spot, size: float, palette: Palette) -> list[Shape]:
    """A pointed body where a simulated vehicle begins."""
    (x, y), (ux, uy) = spot, along
    shape = ((0.95, 0.0), (0.4, 0.55), (-0.8, 0.55), (-0.8, -0.55), (0.4, -0.55))
    spots = tuple((x + (a * ux - b * uy) * size, y + (a * uy + b * ux) * size) for a, b in shape)
    return [Area(spots, palette.vehicle, palette.paper, 1.2)]
