"""Contracts a track: chains without branches become segments between junctions."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import TypeAlias

import networkx as nx

from app.domain.units import Barcode
from app.planning.track import Track

Times: TypeAlias = Callable[[tuple[Barcode, Barcode]], float]


@dataclass(slots=True)
class Segment:
    """A way from one junction to the next: ``path`` with both, ``at`` the time in seconds from the first to each.

    ``cuts`` are the indices in ``path`` of barcodes that cannot be reached from the one before, rising.
    """

    path: tuple[Barcode, ...]
    at: tuple[float, ...]
    tail: int
    head: int
    cuts: list[int] = field(default_factory=list)

    def is_open(self, start: int, end: int) -> bool:
        """Return whether one may drive from index ``start`` to index ``end``."""
        return not any(start < cut <= end for cut in self.cuts)

    def time(self, start: int, end: int) -> float:
        """Return the time from index ``start`` to ``end``, infinite if a cut lies between."""
        return self.at[end] - self.at[start] if self.is_open(start, end) else float("inf")


@dataclass(frozen=True, slots=True)
class Place:
    """A barcode inside a segment: where in its path."""

    segment: Segment
    index: int


@dataclass(frozen=True, slots=True)
class Contraction:
    """A track as junctions and segments.

    ``junctions`` numbers them from 0: barcodes with other than one way in and one way out, and one of each ring that has
    none. ``inside`` has every other barcode. ``edges`` has the segment of every edge and the index of the edge's end.
    """

    junctions: dict[Barcode, int]
    segments: tuple[Segment, ...]
    inside: dict[Barcode, Place]
    edges: dict[tuple[Barcode, Barcode], Place]


def contract(track: Track) -> Contraction:
    """Return the contraction of a track, with the ``time`` of its graph's edges."""
    time: dict[tuple[Barcode, Barcode], float] = nx.get_edge_attributes(track.graph, "time")
    found = Contraction(_junctions(track), (), {}, {})
    segments = list(_segments(track, found, time.__getitem__))
    for barcode in track.barcodes:
        if barcode not in found.junctions and barcode not in found.inside:
            found.junctions[barcode] = len(found.junctions)
            segments.append(_follow(track, found, barcode, track.successors(barcode)[0], time.__getitem__))
    return Contraction(found.junctions, tuple(segments), found.inside, found.edges)


def _junctions(track: Track) -> dict[Barcode, int]:
    branching = (b for b in track.barcodes if not len(track.successors(b)) == len(track.predecessors(b)) == 1)
    return {barcode: i for i, barcode in enumerate(branching)}


def _segments(track: Track, found: Contraction, time: Times) -> Iterator[Segment]:
    for junction in found.junctions:
        for first in track.successors(junction):
            yield _follow(track, found, junction, first, time)


def _follow(track: Track, found: Contraction, junction: Barcode, first: Barcode, time: Times) -> Segment:
    path, at = [junction, first], [0.0, time((junction, first))]
    while path[-1] not in found.junctions:
        after = track.successors(path[-1])[0]
        at.append(at[-1] + time((path[-1], after)))
        path.append(after)
    segment = Segment(tuple(path), tuple(at), found.junctions[junction], found.junctions[path[-1]])
    for i in range(1, len(path)):
        found.edges[path[i - 1], path[i]] = Place(segment, i)
        if i + 1 < len(path):
            found.inside[path[i]] = Place(segment, i)
    return segment
