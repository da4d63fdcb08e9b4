"""A bay: a one-way loop beside the spine, joined to the outer lane by a way in and a way out, with shortcuts across.

    outer lane   ──D───────────────M──>      in the direction of traffic, the bay to its right (drawn below)
                    ╲             ╱
                     ╲           ╱
          ╭───────────M──.──.──D──────────╮
          │                               │
       return side   <-- shortcuts -->   out side
          │                               │
          ╰───────────────────────────────╯

Whoever comes in leaves the outer lane before others come back to it, so that the lane between carries only what passes by.
"""

from dataclasses import dataclass
from itertools import accumulate, pairwise
from random import Random

from app.domain.units import Barcode, Millimetres
from app.plant.fab.drawing import QUARTER, Drawing, Spot, arc, arc_length, between
from app.plant.fab.shape import Shape
from app.plant.fab.spine import WAY_IN, WAY_OUT, Lanes, column_start

RAMP_ALONG, RAMP_ASIDE, RAMP_BARCODES = 2, Millimetres(2400), 2
"""The ramp between lane and loop: barcodes along the lane, mm aside, and the barcodes on it: room for two vehicles."""
MOUTH = 3
"""Edges of the loop between way in and way out, and at its far end."""
RADIUS, CORNER_EDGES = Millimetres(1350), 2
"""The loop's corners. Our choice: half a corner is then as long as a straight edge."""
PAIR_GAP = Millimetres(1260)
"""Between the two shortcuts of a pair: rails side by side keep 1.2 m. Our choice."""
FIRST_ROW = 3
"""Barcodes of a side before the first shortcut, and after the last."""
CLUSTER_GAP = 3
"""Least rows between shortcuts that are no pair: room for two vehicles between a diverge and the next."""


@dataclass(frozen=True, slots=True)
class Plan:
    """What one bay is to have: ``depth`` barcodes a side, and shortcuts of which some are pairs."""

    depth: int
    shortcuts: int
    pairs: int


@dataclass(frozen=True, slots=True)
class Shortcut:
    """A way across the bay at a row of its sides; ``homeward`` from the out side to the return side."""

    row: int
    homeward: bool


@dataclass(frozen=True, slots=True)
class Bay:
    """A bay as drawn: all its barcodes, its two sides, and those that lie across."""

    barcodes: tuple[Barcode, ...]
    sides: tuple[list[Barcode], list[Barcode]]
    shortcuts: tuple[list[Barcode], ...]
    far_end: list[Barcode]


def plan_bays(shape: Shape, random: Random) -> list[Plan]:
    """Return a plan for each bay; the sums are the shape's, whatever the seed."""
    spread = int(shape.depth * shape.spread)
    half = [random.randint(-spread, spread) for _ in range(shape.bays // 2)]
    depths = [shape.depth + change for change in (*half, *(-change for change in half))]
    random.shuffle(depths)
    shortcuts = _shares(shape.shortcuts, shape.bays, random)
    pairs = _shares(shape.pairs, shape.bays, random)
    return [Plan(*figures) for figures in zip(depths, shortcuts, pairs, strict=True)]


def _shares(total: int, count: int, random: Random) -> list[int]:
    shares = [total * (i + 1) // count - total * i // count for i in range(count)]
    random.shuffle(shares)
    return shares


def place_shortcuts(plan: Plan, random: Random) -> list[Shortcut]:
    """Return the shortcuts of a bay, nearest the spine first, with their rows as evenly as a little chance leaves them.

    Raises: ValueError: the bay is too short for them.
    """
    singles = plan.shortcuts - 2 * plan.pairs
    clusters = [True] * plan.pairs + [False] * singles
    random.shuffle(clusters)
    rows = plan.depth + 1 - 2 * FIRST_ROW
    if rows < len(clusters) * (CLUSTER_GAP + 2):
        raise ValueError(f"a bay of {plan.depth} barcodes a side has no room for {plan.shortcuts} shortcuts")
    found: list[Shortcut] = []
    homeward = False
    for i, pair in enumerate(clusters):
        slot = rows * i // len(clusters), rows * (i + 1) // len(clusters)
        last = slot[1] - CLUSTER_GAP - (1 if pair else 0)
        row = FIRST_ROW + random.randint(slot[0], max(slot[0], last))
        if pair:
            found += [Shortcut(row, homeward=True), Shortcut(row + 1, homeward=False)]
        else:
            homeward = not homeward
            found.append(Shortcut(row, homeward))
    return found


def draw_bay(drawing: Drawing, shape: Shape, lanes: Lanes, column: int, plan: Plan, random: Random) -> Bay:
    """Draw a bay into its column of a direction."""
    before = len(drawing.spots)
    first = column_start(shape, column)
    shortcuts = place_shortcuts(plan, random)
    paired = {s.row for s, t in pairwise(shortcuts) if t.row == s.row + 1}
    gaps = (PAIR_GAP if row in paired else shape.pitch for row in range(plan.depth))
    rows = list(accumulate(gaps, initial=0))
    outline = _Outline(drawing, shape, lanes, first)
    mouth, sides, far_end = outline.loop(rows)
    outline.ramp(lanes.outer[first + WAY_IN], mouth[0])
    outline.ramp(mouth[-1], lanes.outer[first + WAY_OUT])
    across = tuple(_shortcut(drawing, shape, sides, shortcut) for shortcut in shortcuts)
    return Bay(tuple(drawing.spots)[before:], sides, across, far_end)


class _Outline:
    """The loop of one bay, in the words of its direction."""

    def __init__(self, drawing: Drawing, shape: Shape, lanes: Lanes, first: int) -> None:
        self._drawing = drawing
        self._at = lanes.direction.at
        self._near = lanes.outer_aside + RAMP_ASIDE
        self._left = (first + WAY_IN + RAMP_ALONG) * shape.pitch
        self._right = self._left + MOUTH * shape.pitch
        self._pitch = shape.pitch

    def loop(self, rows: list[int]) -> tuple[list[Barcode], tuple[list[Barcode], list[Barcode]], list[Barcode]]:
        """Draw the loop; return its mouth, its sides (out, return) and its far end, each in driving direction."""
        drawing, at = self._drawing, self._at
        top, bottom = self._near + RADIUS, self._near + RADIUS + rows[-1]
        along = range(self._left, self._right + 1, self._pitch)
        mouth = drawing.place(at(x, self._near) for x in along)
        out = self._side(mouth[-1], (self._right, top), -QUARTER, [(self._right + RADIUS, top + row) for row in rows])
        ends = [(x, bottom + RADIUS) for x in reversed(along)]
        far = self._side(out[-1], (self._right, bottom), 0, ends)
        homeward = [(self._left - RADIUS, top + row) for row in reversed(rows)]
        back = self._side(far[-1], (self._left, bottom), QUARTER, homeward)
        corner = self._corner((self._left, top), 2 * QUARTER)
        self._bend([back[-1], *corner, mouth[0]])
        drawing.straight(mouth)
        return mouth, (out, back), far

    def ramp(self, start: Barcode, end: Barcode) -> None:
        """Draw a ramp between lane and loop."""
        drawing = self._drawing
        on_it = drawing.place(between(drawing.spots[start], drawing.spots[end], RAMP_BARCODES))
        drawing.curve([start, *on_it, end])

    def _side(self, start: Barcode, centre: Spot, angle: float, spots: list[Spot]) -> list[Barcode]:
        """Draw a corner and the straight track behind it."""
        corner = self._corner(centre, angle)
        side = self._drawing.place(self._at(*spot) for spot in spots)
        self._bend([start, *corner, side[0]])
        self._drawing.straight(side)
        return side

    def _corner(self, centre: Spot, angle: float) -> list[Barcode]:
        spots = arc(centre, RADIUS, (angle, angle + QUARTER), CORNER_EDGES)
        return self._drawing.place(self._at(*spot) for spot in spots)

    def _bend(self, barcodes: list[Barcode]) -> None:
        self._drawing.curve(barcodes, arc_length(RADIUS, QUARTER, CORNER_EDGES))


def _shortcut(
    drawing: Drawing, shape: Shape, sides: tuple[list[Barcode], list[Barcode]], shortcut: Shortcut
) -> list[Barcode]:
    out, back = sides
    across = (out[shortcut.row], back[-1 - shortcut.row])
    start, end = across if shortcut.homeward else reversed(across)
    ends = drawing.spots[start], drawing.spots[end]
    on_it = drawing.place(between(*ends, round(abs(ends[0][0] - ends[1][0]) / shape.pitch) - 1))
    drawing.curve([start, on_it[0]])
    drawing.straight(on_it)
    drawing.curve([on_it[-1], end])
    return on_it
