"""A plant as shapes: how large, which colours, what is labelled where there is room."""

from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil, hypot
from statistics import median

from app.domain.layout import Plant, StationKind
from app.domain.units import Barcode
from app.plant.picture.labels import CELL, Labels
from app.plant.picture.legend import legend
from app.plant.picture.palette import DARK, LIGHT, STATIONS, Palette
from app.plant.picture.shapes import Area, Disc, Drawing, Line, Spot, Text
from app.plant.picture.symbols import charger, door, parking, station, vehicle
from app.plant.picture.track import Chain, Shaper, arrows, chains_of

MARGIN, HEAD, FOOT = 48.0, 74.0, 84.0
ARROWS_APART, DENSE = 95.0, 16.0
"""Pixels between arrows; barcodes nearer than DENSE pixels leave no room for one between them."""
NARROWEST, FLATTEST, TALLEST = 640, 160.0, 2.2
"""Least width; least height of the plan; most height of the plan by its width."""


@dataclass(frozen=True, slots=True)
class Look:
    """How a picture is to look; ``width`` in pixels, the height follows from the plan."""

    width: int = 1600
    dark: bool = False
    labels: bool = True


class _Plan:
    """Where everything lies on the picture, in pixels."""

    def __init__(self, plant: Plant, width: int) -> None:
        xs, ys = [point.x for point in plant.points], [point.y for point in plant.points]
        left, top = min(xs, default=0), min(ys, default=0)
        wide, high = max(1, max(xs, default=0) - left), max(1, max(ys, default=0) - top)
        room = width - 2 * MARGIN
        self.scale = min(room / wide, room * TALLEST / high)
        """Pixels in a millimetre."""
        self.height = max(FLATTEST, high * self.scale)
        dx = MARGIN + (room - wide * self.scale) / 2
        dy = HEAD + MARGIN / 2 + (self.height - high * self.scale) / 2
        self.spots: dict[Barcode, Spot] = {
            point.barcode: (dx + (point.x - left) * self.scale, dy + (point.y - top) * self.scale)
            for point in plant.points
        }
        steps = [
            hypot(self.spots[e.end][0] - self.spots[e.start][0], self.spots[e.end][1] - self.spots[e.start][1])
            for e in plant.edges
        ]
        self.step = median([step for step in steps if step > 0] or [40.0])
        """How far barcodes are apart."""


def as_said(text: str) -> str:
    """Return a text as it is."""
    return text


def compose(plant: Plant, look: Look | None = None, tell: Callable[[str], str] = as_said) -> Drawing:
    """Return the picture of a plant; ``tell`` gives each of our words in the reader's language.

    Of a plant whose file has errors it is what can be drawn: what lies at barcodes that it does not have is left out.
    """
    look, plant = look or Look(), _with_places(plant)
    width = max(NARROWEST, look.width)
    plan, palette = _Plan(plant, width), DARK if look.dark else LIGHT
    drawing = Drawing(width, ceil(HEAD + plan.height + MARGIN + FOOT), palette.paper, plant.name)
    labels = Labels(drawing, HEAD - 6, drawing.height - FOOT)
    shaper = Shaper(plant, plan.spots)
    chains = chains_of(plant)
    lines = [shaper.line(chain.barcodes) for chain in chains]
    stroke = min(4.0, max(1.1, plan.step / 9))
    _draw_zones(drawing, plant, plan, shaper, palette, stroke)
    for chain, line in zip(chains, lines, strict=True):
        drawing.shapes.append(Line(tuple(line), palette.both if chain.both else palette.track, stroke))
        labels.block_line(line, stroke)
    if plan.step >= DENSE:
        _draw_arrows(drawing, plan, shaper, chains, palette, stroke)
    _draw_marks(drawing, plant, plan, palette, stroke)
    _draw_equipment(drawing, plant, plan, palette, labels)
    _draw_stations(drawing, plant, plan, palette, labels)
    if plan.step < DENSE:
        _draw_arrows(drawing, plan, shaper, chains, palette, stroke)
    _draw_vehicles(drawing, plant, plan, palette, labels)
    if look.labels:
        _label(drawing, plant, plan, palette, labels, chains)
    _draw_head(drawing, plant, palette, tell)
    legend(drawing, plant, palette, plan.scale, drawing.height - FOOT, tell)
    return drawing


def _with_places(plant: Plant) -> Plant:
    """Return the plant without what lies nowhere."""
    known = {point.barcode for point in plant.points}
    return replace(
        plant,
        edges=tuple(edge for edge in plant.edges if {edge.start, edge.end} <= known),
        stations=tuple(station for station in plant.stations if station.barcode in known),
        zones=tuple(replace(zone, barcodes=zone.barcodes & known) for zone in plant.zones),
        vehicles=tuple(v if v.start is None or v.start in known else replace(v, start=None) for v in plant.vehicles),
        doors=tuple(
            replace(door, passages=frozenset(pair for pair in door.passages if known.issuperset(pair)))
            for door in plant.doors
        ),
        chargers=tuple(charger for charger in plant.chargers if charger.barcode in known),
    )


def _draw_zones(drawing: Drawing, plant: Plant, plan: _Plan, shaper: Shaper, palette: Palette, stroke: float) -> None:
    wide = max(stroke * 4.5, min(22.0, plan.step * 0.8))
    zones: defaultdict[Barcode, set[str]] = defaultdict(set)
    for zone in plant.zones:
        for barcode in zone.barcodes:
            zones[barcode].add(zone.id)
    for barcode in zones:
        drawing.shapes.append(Disc(plan.spots[barcode], wide / 2, palette.zone))
    for edge in plant.edges:
        if zones.get(edge.start, set()) & zones.get(edge.end, set()):
            drawing.shapes.append(Line(tuple(shaper.edge(edge.start, edge.end)), palette.zone, wide))


def _draw_arrows(
    drawing: Drawing, plan: _Plan, shaper: Shaper, chains: list[Chain], palette: Palette, stroke: float
) -> None:
    """Draw arrow heads between barcodes; where these are dense, along the line, above everything on it."""
    size = min(13.0, max(5.0, stroke * 3.4))
    every = max(1, round(ARROWS_APART / plan.step))
    for chain in chains:
        pairs = [] if chain.both else list(pairwise(chain.barcodes))
        if plan.step >= DENSE:
            parts = [shaper.edge(*pair) for pair in pairs[min(every // 2, len(pairs) // 2) :: every]]
        else:
            parts = [shaper.line(chain.barcodes)] if pairs else []
        for line in parts:
            drawing.shapes += [Area(head, palette.arrow) for head in arrows(line, ARROWS_APART, size)]


def _draw_marks(drawing: Drawing, plant: Plant, plan: _Plan, palette: Palette, stroke: float) -> None:
    radius = min(3.4, plan.step / 5)
    if radius < 1.1:
        return
    edge = min(1.4, stroke * 0.5)
    drawing.shapes += [Disc(plan.spots[p.barcode], radius, palette.paper, palette.track, edge) for p in plant.points]


def _size(plan: _Plan) -> float:
    """Return how large a station is: as large as fits between two barcodes, within reason."""
    return min(13.0, max(2.4, plan.step * 0.42))


def _sideways(plant: Plant, plan: _Plan) -> dict[Barcode, Spot]:
    """Return for each barcode the direction to the left of the track there."""
    found: dict[Barcode, Spot] = {}
    for edge in plant.edges:
        a, b = plan.spots[edge.start], plan.spots[edge.end]
        length = hypot(b[0] - a[0], b[1] - a[1]) or 1.0
        left = ((b[1] - a[1]) / length, -(b[0] - a[0]) / length)
        found.setdefault(edge.start, left)
        found.setdefault(edge.end, left)
    return found


def _draw_stations(drawing: Drawing, plant: Plant, plan: _Plan, palette: Palette, labels: Labels) -> None:
    left, size = _sideways(plant, plan), _size(plan)
    sides = {StationKind.SBFL: 1.0, StationKind.SBFR: -1.0}
    seen: defaultdict[tuple[Barcode, float], int] = defaultdict(int)
    for given in plant.stations:
        side = sides.get(given.kind, 0.0)
        x, y = plan.spots[given.barcode]
        dx, dy = left.get(given.barcode, (0.0, -1.0))
        turn = seen[given.barcode, side]
        seen[given.barcode, side] += 1
        away = side * (size * 1.25) if side else turn * size * 1.15
        spot = (x + dx * away * (1 + turn * 0.9 if side else 1), y + dy * away * (1 + turn * 0.9 if side else 1))
        drawing.shapes += station(given.kind, spot, size, palette)
        labels.block(spot[0] - size / 2, spot[1] - size / 2, spot[0] + size / 2, spot[1] + size / 2)


def _draw_equipment(drawing: Drawing, plant: Plant, plan: _Plan, palette: Palette, labels: Labels) -> None:
    size = _size(plan)
    for point in plant.points:
        if point.park:
            drawing.shapes += parking(plan.spots[point.barcode], size, palette)
            x, y = plan.spots[point.barcode]
            labels.block(x - size * 0.7, y - size * 0.7, x + size * 0.7, y + size * 0.7)
    for gate in plant.doors:
        for start, end in sorted(gate.passages):
            drawing.shapes += door(plan.spots[start], plan.spots[end], max(8.0, size * 1.3), palette)
    for plug in plant.chargers:
        drawing.shapes += charger(plan.spots[plug.barcode], max(6.0, size), palette)


def _body(plan: _Plan) -> float:
    """Return how large a vehicle is, from its middle."""
    return max(3.0, _size(plan) * 0.9)


def _draw_vehicles(drawing: Drawing, plant: Plant, plan: _Plan, palette: Palette, labels: Labels) -> None:
    left = _sideways(plant, plan)
    for given in plant.vehicles:
        if given.start is None:
            continue
        dx, dy = left.get(given.start, (0.0, -1.0))
        size = _body(plan)
        drawing.shapes += vehicle(plan.spots[given.start], (-dy, dx), size, palette)
        x, y = plan.spots[given.start]
        labels.block(x - size, y - size, x + size, y + size)


def _label(drawing: Drawing, plant: Plant, plan: _Plan, palette: Palette, labels: Labels, chains: list[Chain]) -> None:
    """Write names where they fit: stations, equipment and vehicles before barcodes, barcodes at branches before the others."""
    size, gap = (11.0, _size(plan) * 0.75 + 3) if plan.step >= 16 else (9.0, 6.0)
    if plan.step >= 9:
        named: list[tuple[Barcode, str, str]] = [(s.barcode, s.id, STATIONS[s.kind](palette)) for s in plant.stations]
        named += [(c.barcode, c.id, palette.charger) for c in plant.chargers]
        named += [(min(pair), door.id, palette.door) for door in plant.doors for pair in sorted(door.passages)[:1]]
        for barcode, text, colour in named:
            labels.place(plan.spots[barcode], text, colour, size, gap)
        for v in plant.vehicles:
            if v.start is not None:
                labels.place(plan.spots[v.start], v.id, palette.vehicle, size, _body(plan) + CELL)
    ends = dict.fromkeys(b for chain in chains for b in (chain.barcodes[0], chain.barcodes[-1]))
    every = max(1, round(42 / plan.step))
    for barcode in (*ends, *(b for chain in chains for b in chain.barcodes[::every])):
        labels.place(plan.spots[barcode], barcode, palette.faint, size - 1.5, 5.0, apart=90.0 if plan.step < 9 else 0.0)


def _draw_head(drawing: Drawing, plant: Plant, palette: Palette, tell: Callable[[str], str]) -> None:
    kilometres = sum(edge.length for edge in plant.edges) / 1e6
    counts = [(len(plant.points), "barcode"), (len(plant.stations), "station"), (len(plant.vehicles), "vehicle")]
    told = [tell(f"{count:,} {what}{'' if count == 1 else 's'}") for count, what in counts if count]
    track = f"{kilometres:.2f} km of track" if kilometres >= 0.1 else f"{kilometres * 1000:.0f} m of track"
    told.insert(1, tell(track))
    drawing.shapes.append(Text((MARGIN, 36), plant.name, palette.ink, 22, bold=True))
    drawing.shapes.append(Text((MARGIN, 58), " · ".join(told), palette.faint, 13))
