"""Contracts a track to the places where there is a choice: forks, and arcs from fork to fork through whatever merges between."""

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TypeAlias

from app.domain.units import Barcode
from app.planning.tables import Elimination, Plan, planned
from app.planning.track import Track

EdgeKey: TypeAlias = tuple[Barcode, Barcode]
Step: TypeAlias = tuple[tuple[Barcode, ...], int, int]
"""A pair's way without its first barcode, where the row of the fork that it leads to begins, and that fork's first pair."""
Spot: TypeAlias = tuple[int, int]
"""An arc, and an index in its path (of the barcode, or of the one that an edge leads to)."""


@dataclass(frozen=True, slots=True)
class Arcs:
    """A track as forks and arcs.

    ``forks`` numbers the barcodes with more than one way out, and one of each ring that has none, by ``plan``. An arc is the way
    from a fork by one of its edges to the next fork or dead end, both in its path (``rest``: without the first): arcs overlap
    behind a merge. The arcs from ``approaches`` on begin where no fork leads to. ``heads`` has each arc's last fork, -1 for a
    dead end; ``first[f]`` is the first arc of a fork. ``spots`` has, for every barcode that is no fork, where arcs lead over
    it; from all of them the way on is the same.

    ``edges`` numbers all edges, for ``plan.over``: one per barcode of each arc's path, the edge that leads there.
    """

    forks: dict[Barcode, int]
    paths: tuple[tuple[Barcode, ...], ...]
    rest: tuple[tuple[Barcode, ...], ...]
    heads: tuple[int, ...]
    tails: tuple[int, ...]
    first: tuple[int, ...]
    approaches: int
    spots: dict[Barcode, tuple[Spot, ...]]
    edges: dict[EdgeKey, int]
    plan: Plan
    starts: tuple[int, ...]
    """The plan's ``begins`` for plain Python, as the next two are."""
    pair_first: tuple[int, ...]
    pair_heads: tuple[int, ...]
    joined: dict[tuple[int, int], tuple[Step, Step, Step]] = field(default_factory=dict)
    """Steps made of two, by the ids of the two: all three, so that no other gets an id of theirs; by an arc and -1 the step
    along it."""

    def on(self, edge: EdgeKey) -> Iterator[Spot]:
        """Give every arc that leads over an edge, and the index of the edge's end in its path."""
        if edge not in self.edges:
            return
        start, end = edge
        if (fork := self.forks.get(start)) is None:
            yield from ((arc, index + 1) for arc, index in self.spots[start])
            return
        for arc in range(self.first[fork], self.first[fork + 1]):
            if self.paths[arc][1] == end:
                yield arc, 1


def contract(track: Track) -> Arcs:
    """Return the contraction of a track."""
    found = list(_forks(track))
    known = {barcode: number for number, barcode in enumerate(found)}
    ways = [(known[fork], _follow(track, known, fork, first)) for fork in found for first in track.successors(fork)]
    ends = [(tail, known.get(path[-1], -1)) for tail, path in ways]
    elimination = Elimination(len(found), ends)
    number = {fork: place for place, fork in enumerate(elimination.order)}
    number[-1] = -1
    order = sorted(range(len(ways)), key=lambda arc: number[ends[arc][0]])
    paths = [ways[arc][1] for arc in order]
    arcs = [(number[ends[arc][0]], number[ends[arc][1]]) for arc in order]
    edges = {edge: number for number, edge in enumerate(track.graph.edges)}
    between = tuple(arcs)
    for path in _approaches(track, known, paths):
        paths.append(path)
        arcs.append((-1, number[known.get(path[-1], -1)]))
    over = [[len(edges), *(edges[edge] for edge in pairwise(path))] for path in paths]
    plan = planned(between, elimination, over)
    return _assembled({found[fork]: place for fork, place in number.items() if fork >= 0}, paths, arcs, edges, plan)


def _assembled(
    forks: dict[Barcode, int],
    paths: Sequence[tuple[Barcode, ...]],
    arcs: Sequence[tuple[int, int]],
    edges: dict[EdgeKey, int],
    plan: Plan,
) -> Arcs:
    spots: dict[Barcode, tuple[Spot, ...]] = {}
    tails = [tail for tail, _ in arcs if tail >= 0]
    for arc, path in enumerate(paths):
        for index, barcode in enumerate(path):
            if barcode not in forks:
                spots[barcode] = (*spots.get(barcode, ()), (arc, index))
    return Arcs(
        forks=forks,
        paths=tuple(paths),
        rest=tuple(path[1:] for path in paths),
        heads=tuple(head for _, head in arcs),
        tails=tuple(tail for tail, _ in arcs),
        first=(*(bisect_left(tails, fork) for fork in range(plan.size)), len(tails)),
        approaches=len(tails),
        spots=spots,
        edges=edges,
        plan=plan,
        starts=tuple(plan.begins.tolist()),
        pair_first=tuple(plan.first.tolist()),
        pair_heads=tuple(plan.heads.tolist()),
    )


def _forks(track: Track) -> Iterator[Barcode]:
    """Give the barcodes with a choice, and of each ring without any the first that is come to, so that every way ends."""
    ends: dict[Barcode, None] = {}
    for barcode in track.barcodes:
        if len(track.successors(barcode)) > 1:
            yield barcode
    for barcode in track.barcodes:
        here, way = barcode, dict[Barcode, None]()
        while here not in ends and here not in way and len(track.successors(here)) == 1:
            way[here] = None
            here = track.successors(here)[0]
        if here in way:
            yield here
        ends.update(way)


def _follow(track: Track, forks: dict[Barcode, int], start: Barcode, first: Barcode) -> tuple[Barcode, ...]:
    path = [start, first]
    while path[-1] not in forks and (ahead := track.successors(path[-1])):
        path.append(ahead[0])
    return tuple(path)


def _approaches(
    track: Track, forks: dict[Barcode, int], paths: Iterable[tuple[Barcode, ...]]
) -> Iterator[tuple[Barcode, ...]]:
    """Give the ways that no fork leads to, from each place that nothing leads to."""
    for barcode in track.barcodes:
        if barcode in forks or track.predecessors(barcode):
            continue
        ahead = track.successors(barcode)
        yield _follow(track, forks, barcode, ahead[0]) if ahead else (barcode,)
