"""Where track that is not connected comes too close on the plan."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import TypeAlias

import numpy as np
from scipy.spatial import cKDTree

from app.domain.layout import Edge, Point
from app.domain.units import Barcode, Millimetres

Spot: TypeAlias = tuple[int, int]
CELLS_ALONG_THE_PLAN = 2000
"""Our choice: a single very long edge then lies in at most so many cells each way."""


def near_points(points: Sequence[Point], clearance: Millimetres) -> list[tuple[Barcode, Barcode]]:
    """Return every pair of barcodes whose distance on the plan is less than ``clearance`` mm, in the points' order."""
    if clearance <= 0 or len(points) < 2:
        return []
    tree = cKDTree(np.array([(p.x, p.y) for p in points], dtype=np.float64))
    pairs = [(points[i], points[j]) for i, j in sorted(tree.query_pairs(float(clearance)))]
    return [(p.barcode, q.barcode) for p, q in pairs if (p.x - q.x) ** 2 + (p.y - q.y) ** 2 < clearance**2]


def crossing_edges(edges: Sequence[Edge], points: Mapping[Barcode, Point]) -> list[tuple[Edge, Edge]]:
    """Return every pair of edges that cross or touch on the plan without a barcode in common.

    Edges are straight between their barcodes; an edge whose ends lie at one spot says nothing of the plan and is left
    out. Takes time linear in the edges where their density is even (a grid of cells).
    """
    lines = [(_spot(points[e.start]), _spot(points[e.end])) for e in edges]
    found = {
        (i, j)
        for cell in _cells(lines).values()
        for i, j in combinations(cell, 2)
        if _apart(edges[i], edges[j]) and _meet(lines[i], lines[j])
    }
    return [(edges[i], edges[j]) for i, j in sorted(found)]


def _spot(point: Point) -> Spot:
    return point.x, point.y


def _apart(one: Edge, other: Edge) -> bool:
    return one.start not in (other.start, other.end) and one.end not in (other.start, other.end)


def _cells(lines: Sequence[tuple[Spot, Spot]]) -> dict[Spot, list[int]]:
    """Return for each cell of a grid the indices of the lines whose bounding box touches it."""
    size = _cell_size(lines)
    cells: defaultdict[Spot, list[int]] = defaultdict(list)
    for i, ((ax, ay), (bx, by)) in enumerate(lines):
        if (ax, ay) == (bx, by):
            continue
        for column in range(min(ax, bx) // size, max(ax, bx) // size + 1):
            for row in range(min(ay, by) // size, max(ay, by) // size + 1):
                cells[column, row].append(i)
    return cells


def _cell_size(lines: Sequence[tuple[Spot, Spot]]) -> int:
    extents = [max(abs(ax - bx), abs(ay - by)) for (ax, ay), (bx, by) in lines]
    return 1 + max(sum(extents) // max(1, len(extents)), max(extents, default=0) // CELLS_ALONG_THE_PLAN)


def _meet(one: tuple[Spot, Spot], other: tuple[Spot, Spot]) -> bool:
    """Return whether two closed straight lines have a spot in common. Exact, in whole numbers."""
    (a, b), (c, d) = one, other
    if not (_spans_meet(a[0], b[0], c[0], d[0]) and _spans_meet(a[1], b[1], c[1], d[1])):
        return False
    return _side(a, b, c) * _side(a, b, d) <= 0 and _side(c, d, a) * _side(c, d, b) <= 0


def _spans_meet(a: int, b: int, c: int, d: int) -> bool:
    return min(a, b) <= max(c, d) and min(c, d) <= max(a, b)


def _side(a: Spot, b: Spot, c: Spot) -> int:
    """Return the sign of the turn a-b-c: 0 if the three lie on one line."""
    turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (turn > 0) - (turn < 0)
