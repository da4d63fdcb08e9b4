"""Paper for track: barcodes are numbered as they are placed, edges measured as they are drawn."""

from collections.abc import Iterable, Sequence
from itertools import pairwise
from math import cos, hypot, pi, sin
from typing import TypeAlias

from app.domain.layout import Edge, Point
from app.domain.units import Barcode, Millimetres, Percent

Spot: TypeAlias = tuple[int, int]
FIRST_NUMBER = 10_001
ROUND_TO = 10
"""Each stretch begins at the next number that ends in 1, so that numbers have gaps as on a real rail. Our choice."""
SENSOR_STRAIGHT, SENSOR_CURVE = 1, 2
FULL_SPEED = Percent(100)


class Drawing:
    """Points and edges of a plan, in the order in which they are drawn."""

    def __init__(self) -> None:
        self.spots: dict[Barcode, Spot] = {}
        self.edges: list[Edge] = []
        self._next = FIRST_NUMBER

    def place(self, spots: Iterable[Spot]) -> list[Barcode]:
        """Return new barcodes at these spots, numbered along the stretch."""
        found = []
        for number, spot in enumerate(spots, self._next):
            barcode = Barcode(str(number))
            self.spots[barcode] = spot
            found.append(barcode)
        self._next += -(-len(found) // ROUND_TO) * ROUND_TO
        return found

    def straight(self, barcodes: Sequence[Barcode], speed: Percent = FULL_SPEED) -> None:
        """Draw track through barcodes in driving direction, as long as they lie apart; ``speed`` is its limit."""
        for start, end in pairwise(barcodes):
            self.edges.append(Edge(start, end, self._apart(start, end), speed, sensor=SENSOR_STRAIGHT))

    def curve(self, barcodes: Sequence[Barcode], length: Millimetres | None = None) -> None:
        """Draw track on which vehicles keep to their curve speed; ``length`` of each edge, if it is an arc."""
        for start, end in pairwise(barcodes):
            self.edges.append(Edge(start, end, length or self._apart(start, end), sensor=SENSOR_CURVE, curve=True))

    def points(self, parking: frozenset[Barcode]) -> tuple[Point, ...]:
        """Return every barcode with its place."""
        return tuple(Point(b, Millimetres(x), Millimetres(y), b in parking) for b, (x, y) in self.spots.items())

    def _apart(self, start: Barcode, end: Barcode) -> Millimetres:
        (x, y), (to_x, to_y) = self.spots[start], self.spots[end]
        return Millimetres(round(hypot(to_x - x, to_y - y)))


def between(start: Spot, end: Spot, count: int) -> list[Spot]:
    """Return ``count`` spots evenly on the straight line from start to end, both left out."""
    (x, y), (to_x, to_y), parts = start, end, count + 1
    return [(round(x + (to_x - x) * i / parts), round(y + (to_y - y) * i / parts)) for i in range(1, parts)]


def arc(centre: Spot, radius: Millimetres, turn: tuple[float, float], edges: int) -> list[Spot]:
    """Return the spots inside an arc of so many edges, from one angle to another (radians), both ends left out."""
    first, last = turn
    angles = (first + (last - first) * i / edges for i in range(1, edges))
    return [(round(centre[0] + radius * cos(a)), round(centre[1] + radius * sin(a))) for a in angles]


def arc_length(radius: Millimetres, turn: float, edges: int) -> Millimetres:
    """Return the length of each of the edges of an arc over ``turn`` radians."""
    return Millimetres(round(radius * abs(turn) / edges))


QUARTER, HALF = pi / 2, pi
