"""The spine: two lanes each way, lane changes at every bay, turnarounds, both ends closed as rings.

Seen along one direction of traffic, ``along`` counts in driving direction and ``aside`` to the right of the spine's middle
line; the other direction is the same turned by half a circle. So what follows is drawn once and holds for both.
"""

from dataclasses import dataclass

from app.domain.units import Barcode, Millimetres, Percent
from app.plant.fab.drawing import HALF, QUARTER, Drawing, Spot, arc, arc_length, between
from app.plant.fab.shape import Shape

INNER_ASIDE = Millimetres(1500)
"""From the middle line to an inner lane: the radius of a turnaround. Our choice."""
TURNAROUND_EDGES = 4
LEAD = 4
"""Barcodes of a lane before the first bay's way in and behind the last column. Our choice."""
WAY_IN, WAY_OUT = 0, 7
"""Where in its column, in barcodes, a bay leaves the outer lane and comes back to it."""
TO_INNER, TO_OUTER = (2, 6), (10, 14)
"""Where in its column, in barcodes, a lane change begins and ends: behind the bay's way in, and before the next one's.

It has barcodes of its own, where whoever crosses has left the one lane and waits for the other.
"""
SLANT_SPEED = Percent(50)
"""On a lane change: 1.5 m/s round its bends of 2.8 m press no harder than curve speed round a corner. Our choice."""
TURN_IN = 8
"""Where in its column a turnaround comes to an inner lane: it has left the other one just opposite."""


@dataclass(frozen=True, slots=True)
class Direction:
    """One direction of the spine: how its places lie on the plan, and the barcodes of its lanes."""

    span: Millimetres
    turned: bool

    def at(self, along: int, aside: int) -> Spot:
        """Return where on the plan a place lies."""
        return (self.span - along, -aside) if self.turned else (along, aside)


@dataclass(frozen=True, slots=True)
class Lanes:
    """The two lanes of a direction, barcode by barcode in driving direction."""

    direction: Direction
    inner: list[Barcode]
    outer: list[Barcode]
    outer_aside: Millimetres


@dataclass(frozen=True, slots=True)
class Spine:
    """Both directions of the spine, and every barcode of it that belongs to no bay."""

    lanes: tuple[Lanes, Lanes]
    barcodes: tuple[Barcode, ...]


def lane_barcodes(shape: Shape) -> int:
    """Return how many barcodes a lane has."""
    return 2 * LEAD + shape.columns * shape.column + 1


def column_start(shape: Shape, column: int) -> int:
    """Return the place in a lane, in barcodes, where a bay's column begins."""
    return LEAD + column * shape.column


def draw_spine(drawing: Drawing, shape: Shape) -> Spine:
    """Draw both directions and what joins them."""
    span = Millimetres((lane_barcodes(shape) - 1) * shape.pitch)
    north, south = (_lanes(drawing, shape, Direction(span, turned)) for turned in (True, False))
    for one, other in ((north, south), (south, north)):
        for radius, leaving, entered in (
            (INNER_ASIDE, one.inner, other.inner),
            (one.outer_aside, one.outer, other.outer),
        ):
            _turn(drawing, one.direction, radius, span, (leaving[-1], entered[0]), _ring_edges(shape, radius))
    for column in _spread_out(shape.columns, shape.turnarounds, 0):
        _turnaround(drawing, shape, (north, south), column)
    for column in _spread_out(shape.columns, shape.turnarounds, 1):
        _turnaround(drawing, shape, (south, north), shape.columns - 1 - column)
    return Spine((north, south), tuple(drawing.spots))


def _lanes(drawing: Drawing, shape: Shape, direction: Direction) -> Lanes:
    outer_aside = Millimetres(INNER_ASIDE + shape.lane_gap)
    inner, outer = (
        drawing.place(direction.at(i * shape.pitch, aside) for i in range(lane_barcodes(shape)))
        for aside in (INNER_ASIDE, outer_aside)
    )
    drawing.straight(inner)
    drawing.straight(outer)
    for column in range(shape.columns):
        first = column_start(shape, column)
        for lane, other, (begin, until) in ((outer, inner, TO_INNER), (inner, outer, TO_OUTER)):
            start, end = lane[first + begin], other[first + until]
            across = drawing.place(between(drawing.spots[start], drawing.spots[end], until - begin - 1))
            drawing.straight([start, *across, end], SLANT_SPEED)
    return Lanes(direction, inner, outer, outer_aside)


def _ring_edges(shape: Shape, radius: Millimetres) -> int:
    return max(TURNAROUND_EDGES, int(HALF * radius / shape.pitch))


def _spread_out(columns: int, count: int, odd: int) -> list[int]:
    """Return so many of the even (or odd) columns, evenly spread: each way has its own, so that none cross."""
    own = range(odd, columns, 2)
    chosen = min(count, len(own))
    return [own[(2 * i + 1) * len(own) // (2 * chosen)] for i in range(chosen)]


def _turnaround(drawing: Drawing, shape: Shape, ways: tuple[Lanes, Lanes], column: int) -> None:
    """Draw a way from the one inner lane back along the other, in a column of the direction that is left."""
    one, other = ways
    place = column_start(shape, column + 1) - TURN_IN
    opposite = column_start(shape, shape.columns - 1 - column) + TURN_IN
    ends = (one.inner[place], other.inner[opposite])
    _turn(drawing, one.direction, INNER_ASIDE, Millimetres(place * shape.pitch), ends, TURNAROUND_EDGES)


def _turn(
    drawing: Drawing,
    direction: Direction,
    radius: Millimetres,
    along: Millimetres,
    ends: tuple[Barcode, Barcode],
    edges: int,
) -> None:
    spots = [direction.at(x, y) for x, y in arc((along, 0), radius, (QUARTER, -QUARTER), edges)]
    drawing.curve([ends[0], *drawing.place(spots), ends[1]], arc_length(radius, HALF, edges))
