"""Which way a vehicle drives that chooses its way itself, as AGVs do (PROTOCOLS 3.3, Move)."""

from collections.abc import Callable, Sequence
from heapq import heappop, heappush
from itertools import pairwise
from typing import TypeAlias

from app.domain.units import Barcode
from app.planning.track import Track

Tree: TypeAlias = dict[Barcode, tuple[int, int]]
"""For each barcode the length of the shortest way there, mm, and how many ways are as short."""


class Ways:
    """Tells how far a path may be left to the vehicle.

    Our choice: an AGV drives the shortest way, so that a path is certainly its own as long as no other way is as short. From
    any place on such a path the rest of it is the only shortest way too, also half way between two barcodes: it neither
    turns nor leaves it when it is told the end of the path while it drives.
    """

    def __init__(self, track: Track) -> None:
        self._track = track
        self._trees: dict[Barcode, Tree] = {}

    def sure(self, path: Sequence[Barcode]) -> int:
        """Return the index of the farthest barcode of the path to which the path is the vehicle's own way; 0: none is."""
        if len(path) < 2:
            return 0
        tree, way = self._tree(path[0]), 0
        for index, (start, end) in enumerate(pairwise(path)):
            way += self._track.edge(start, end).length
            if tree.get(end) != (way, 1):
                return index
        return len(path) - 1

    def _tree(self, start: Barcode) -> Tree:
        if (known := self._trees.get(start)) is None:
            known = self._trees[start] = self._grow(start)
        return known

    def _grow(self, start: Barcode) -> Tree:
        """Return the tree of shortest ways; a barcode is entered when no shorter way to it can be found any more."""
        ways: dict[Barcode, int] = {start: 1}
        best: dict[Barcode, int] = {start: 0}
        tree: Tree = {}
        queue = [(0, start)]
        while queue:
            length, here = heappop(queue)
            if here in tree:
                continue
            tree[here] = (length, ways[here])
            for ahead in self._track.successors(here):
                farther = length + self._track.edge(here, ahead).length
                if ahead in tree:
                    continue
                if farther < best.get(ahead, farther + 1):
                    best[ahead], ways[ahead] = farther, ways[here]
                    heappush(queue, (farther, ahead))
                elif farther == best[ahead]:
                    ways[ahead] += ways[here]
        return tree


def free_way(
    track: Track, start: Barcode, ends: Callable[[Barcode], bool], free: Callable[[Barcode], bool]
) -> tuple[Barcode, ...] | None:
    """Return the shortest way over free track to a place where it may end, the start included; None: there is none."""
    queue: list[tuple[int, tuple[Barcode, ...]]] = [(0, (start,))]
    seen: set[Barcode] = set()
    while queue:
        length, way = heappop(queue)
        here = way[-1]
        if here in seen:
            continue
        seen.add(here)
        if here != start and ends(here):
            return way
        for ahead in track.successors(here):
            if ahead not in seen and free(ahead):
                heappush(queue, (length + track.edge(here, ahead).length, (*way, ahead)))
    return None
