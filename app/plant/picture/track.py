"""Track on a picture: chains of edges as smooth lines, with arrows in driving direction."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import hypot
from typing import TypeAlias

from app.domain.layout import Edge, Plant
from app.domain.units import Barcode
from app.plant.picture.shapes import Spot

STEPS = 8
"""Straight pieces of a drawn curve."""
SHARPEST = 0.2
"""A curve is drawn round only where it leaves its ends within about 78° of the straight line (the cosine)."""
Pair: TypeAlias = tuple[Barcode, Barcode]


@dataclass(frozen=True, slots=True)
class Chain:
    """Edges one after the other between branches, as one line. ``both``: driven either way."""

    barcodes: tuple[Barcode, ...]
    both: bool


def chains_of(plant: Plant) -> list[Chain]:
    """Return the track as chains; a piece that is driven both ways is in one of them once."""
    pairs = {(edge.start, edge.end) for edge in plant.edges}
    once = [e for e in plant.edges if (e.end, e.start) not in pairs or e.start < e.end]
    found = []
    for both in (False, True):
        edges = [(e.start, e.end) for e in once if ((e.end, e.start) in pairs) is both]
        found += [Chain(tuple(line), both) for line in _lines(edges, both=both)]
    return found


def _lines(edges: Sequence[Pair], *, both: bool) -> Iterator[list[Barcode]]:
    around: defaultdict[Barcode, list[Barcode]] = defaultdict(list)
    into: defaultdict[Barcode, int] = defaultdict(int)
    for start, end in edges:
        around[start].append(end)
        into[end] += 1
        if both:
            around[end].append(start)
            into[start] += 1
    simple = {b for b in around if len(around[b]) == (2 if both else 1) and into[b] == (2 if both else 1)}
    done: set[Pair] = set()
    starts = [b for b in around if b not in simple]
    for first in (*starts, *around):
        for onward in around[first]:
            if (first, onward) in done:
                continue
            line = [first, onward]
            done |= {(first, onward), (onward, first)} if both else {(first, onward)}
            while line[-1] in simple:
                after = next((b for b in around[line[-1]] if (line[-1], b) not in done), None)
                if after is None:
                    break
                done |= {(line[-1], after), (after, line[-1])} if both else {(line[-1], after)}
                line.append(after)
            yield line


class Shaper:
    """Draws edges through pixels: straight ones straight, curves as they leave and meet the track around them."""

    def __init__(self, plant: Plant, spots: dict[Barcode, Spot]) -> None:
        self._spots = spots
        self._edges: dict[Pair, Edge] = {(edge.start, edge.end): edge for edge in plant.edges}
        self._into: defaultdict[Barcode, list[Edge]] = defaultdict(list)
        self._out: defaultdict[Barcode, list[Edge]] = defaultdict(list)
        for edge in plant.edges:
            self._out[edge.start].append(edge)
            self._into[edge.end].append(edge)

    def line(self, barcodes: Sequence[Barcode]) -> list[Spot]:
        """Return the spots of a chain's line."""
        found = [self._spots[barcodes[0]]]
        for start, end in pairwise(barcodes):
            found += self.edge(start, end)[1:]
        return found

    def edge(self, start: Barcode, end: Barcode) -> list[Spot]:
        """Return the spots of one edge's line, both ends included."""
        a, b = self._spots[start], self._spots[end]
        edge = self._edges.get((start, end)) or self._edges[end, start]
        length = hypot(b[0] - a[0], b[1] - a[1])
        if not edge.curve or length < STEPS:
            return [a, b]
        along = (b[0] - a[0]) / length, (b[1] - a[1]) / length
        leave = self._direction(start, self._into[start], along, (start, end))
        meet = self._direction(end, self._out[end], along, (start, end))
        if min(_dot(leave, along), _dot(meet, along)) < SHARPEST:
            return [a, b]
        third = length / (1.5 * (1 + max(SHARPEST, _dot(leave, meet))) + 0.001)
        reach = min(third, length * 0.6)
        p, q = (a[0] + leave[0] * reach, a[1] + leave[1] * reach), (b[0] - meet[0] * reach, b[1] - meet[1] * reach)
        return [_cubic(a, p, q, b, i / STEPS) for i in range(STEPS + 1)]

    def _direction(self, at: Barcode, others: Sequence[Edge], along: Spot, pair: Pair) -> Spot:
        """Return the direction of the track at an end: that of a straight edge there, or half way to another curve's."""
        best: tuple[float, Spot] | None = None
        for other in others:
            if {other.start, other.end} == set(pair):
                continue
            a, b = self._spots[other.start], self._spots[other.end]
            length = hypot(b[0] - a[0], b[1] - a[1])
            if length == 0:
                continue
            its = (b[0] - a[0]) / length, (b[1] - a[1]) / length
            mixed = its if not other.curve else _unit((its[0] + along[0], its[1] + along[1]))
            straightness = _dot(its, along) + (0.5 if not other.curve else 0)
            if best is None or straightness > best[0]:
                best = straightness, mixed
        return best[1] if best else along


def _unit(spot: Spot) -> Spot:
    length = hypot(*spot)
    return (spot[0] / length, spot[1] / length) if length > 1e-9 else (1.0, 0.0)


def _dot(one: Spot, other: Spot) -> float:
    return one[0] * other[0] + one[1] * other[1]


def _cubic(a: Spot, p: Spot, q: Spot, b: Spot, t: float) -> Spot:
    s = 1 - t
    w = (s**3, 3 * s * s * t, 3 * s * t * t, t**3)
    return (
        w[0] * a[0] + w[1] * p[0] + w[2] * q[0] + w[3] * b[0],
        w[0] * a[1] + w[1] * p[1] + w[2] * q[1] + w[3] * b[1],
    )


def arrows(line: Sequence[Spot], apart: float, size: float) -> Iterator[tuple[Spot, Spot, Spot]]:
    """Give arrow heads along a line, evenly spread about so far apart; none on a line too short for one."""
    lengths = [hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(line)]
    whole = sum(lengths)
    if whole < size * 2.2:
        return
    number = max(1, round(whole / apart))
    wanted = [(i + 0.5) * whole / number for i in range(number)]
    way = 0.0
    pieces = iter(zip(line, line[1:], lengths, strict=False))
    a, b, length = next(pieces)
    for place in wanted:
        while way + length < place:
            way += length
            a, b, length = next(pieces)
        t = (place - way) / length if length else 0.0
        ux, uy = _unit((b[0] - a[0], b[1] - a[1]))
        x, y = a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t
        back = x - ux * size * 0.5, y - uy * size * 0.5
        side = size * 0.42
        yield (
            (x + ux * size * 0.5, y + uy * size * 0.5),
            (back[0] - uy * side, back[1] + ux * side),
            (back[0] + uy * side, back[1] - ux * side),
        )
