"""The quickest way over the track, in microseconds: a table over junctions, segments between them."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from itertools import pairwise
from math import inf
from typing import TypeAlias, cast

import networkx as nx
import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from app.domain.errors import NoRoute
from app.domain.units import Barcode
from app.planning.segments import Segment, contract
from app.planning.track import Track

EdgeKey: TypeAlias = tuple[Barcode, Barcode]
Row: TypeAlias = "tuple[memoryview[float], memoryview[int]]"
WHOLE_TABLE = 2000
"""Our choice: with more junctions than this (48 MB, 12 bytes per pair) rows are computed when first asked for only."""


class Router:
    """Quickest routes, by the edges' ``time`` in ``track.graph``, around what is closed.

    The whole table is computed at the start; after a change of closures each row when it is first asked for, so that no
    change halts the caller.
    """

    def __init__(self, track: Track) -> None:
        self._track = track
        self._closed: dict[Barcode | EdgeKey, None] = {}
        found = contract(track)
        self._junctions, self._segments = found.junctions, found.segments
        self._inside, self._edges = found.inside, found.edges
        self._size = len(self._junctions)
        self._links: dict[int, tuple[Barcode, ...]] = {}
        self._table: dict[int, Row] = {}
        self._connect()
        if self._size <= WHOLE_TABLE:
            self._compute(range(self._size))

    @property
    def closed(self) -> tuple[Barcode | EdgeKey, ...]:
        """The closed barcodes and edges, in the order of closing."""
        return tuple(self._closed)

    def close(self, *places: Barcode | EdgeKey) -> None:
        """Let no route lead over these barcodes, nor to them, nor over these edges. A route may start at a closed barcode."""
        self._closed.update(dict.fromkeys(places))
        self._reconnect()

    def open(self, *places: Barcode | EdgeKey) -> None:
        """End the closure of these."""
        for place in places:
            self._closed.pop(place, None)
        self._reconnect()

    def route(self, start: Barcode, goal: Barcode) -> tuple[Barcode, ...]:
        """Return the barcodes of a quickest route, start and goal included; just one if they are the same.

        Raises NoRoute: neither the layout nor, with the present closures, the open track connects them.
        """
        if start == goal and start in self._track:
            return (start,)
        path = self._path(start, goal)
        if path is None:
            raise self._no_route(start, goal)
        return tuple(path)

    def time(self, start: Barcode, goal: Barcode) -> float:
        """Return the seconds of the quickest route at full speed; infinite if there is none."""
        if (direct := self._direct(start, goal)) is not None:
            return direct
        (junction, rest), (target, more) = self._leave(start), self._reach(goal)
        if rest + more == inf:
            return inf
        return rest + self._row(target)[0][junction] + more

    def times(self, starts: Sequence[Barcode], goals: Sequence[Barcode]) -> list[list[float]]:
        """Return a row for each start with the time to each goal, in seconds, infinite if there is no route."""
        if not starts or not goals or not self._size:
            return [[inf] * len(goals) for _ in starts]
        leave = [self._leave(start) for start in starts]
        reach = [self._reach(goal) for goal in goals]
        self._compute(junction for junction, _ in reach)
        table = np.empty((len(starts), len(goals)))
        junctions = np.array([junction for junction, _ in leave])
        rest = np.array([seconds for _, seconds in leave])
        for column, (target, more) in enumerate(reach):
            table[:, column] = np.asarray(self._table[target][0])[junctions] + (rest + more)
        times: list[list[float]] = table.tolist()
        self._put_direct(times, starts, goals)
        return times

    def _put_direct(self, times: list[list[float]], starts: Sequence[Barcode], goals: Sequence[Barcode]) -> None:
        """Correct the times between places of one segment, which need not go round by its head."""
        columns: defaultdict[int, list[int]] = defaultdict(list)
        for column, goal in enumerate(goals):
            if (place := self._inside.get(goal)) is not None:
                columns[id(place.segment)].append(column)
        for row, start in enumerate(starts):
            if (place := self._inside.get(start)) is not None:
                for column in columns.get(id(place.segment), ()):
                    if (direct := self._direct(start, goals[column])) is not None:
                        times[row][column] = direct

    def _direct(self, start: Barcode, goal: Barcode) -> float | None:
        """Return the time if the goal lies ahead in the start's own segment, where there is no choice; else None."""
        if start == goal:
            return 0.0 if start in self._track else inf
        here, there = self._inside.get(start), self._inside.get(goal)
        if here is None or there is None or here.segment is not there.segment or there.index < here.index:
            return None
        return here.segment.time(here.index, there.index)

    def _leave(self, start: Barcode) -> tuple[int, float]:
        """Return the first junction of any route from here, and the time there."""
        if (place := self._inside.get(start)) is not None:
            return place.segment.head, place.segment.time(place.index, len(place.segment.path) - 1)
        return (self._junctions[start], 0.0) if start in self._junctions else (0, inf)

    def _reach(self, goal: Barcode) -> tuple[int, float]:
        """Return the last junction of any route to here, and the time from there."""
        if (place := self._inside.get(goal)) is not None:
            return place.segment.tail, place.segment.time(0, place.index)
        return (self._junctions[goal], 0.0) if goal in self._junctions else (0, inf)

    def _path(self, start: Barcode, goal: Barcode) -> list[Barcode] | None:
        here, there = self._inside.get(start), self._inside.get(goal)
        if here is not None and there is not None and here.segment is there.segment and here.index <= there.index:
            return _stretch(here.segment, here.index, there.index)
        path: list[Barcode] | None = [start]
        junction, target = self._junctions.get(start, -1), self._junctions.get(goal, -1)
        if here is not None:
            path, junction = _stretch(here.segment, here.index, len(here.segment.path) - 1), here.segment.head
        last: list[Barcode] | None = [goal]
        if there is not None:
            last, target = _stretch(there.segment, 0, there.index), there.segment.tail
        if path is None or last is None or junction < 0 or target < 0:
            return None
        hop, size, links = self._row(target)[1], self._size, self._links
        while junction != target:
            after = hop[junction]
            if after < 0:
                return None
            path += links[junction * size + after]
            junction = after
        path += last[1:]
        return path

    def _row(self, target: int) -> Row:
        if (row := self._table.get(target)) is None:
            self._compute([target])
            row = self._table[target]
        return row

    def _compute(self, targets: Iterable[int]) -> None:
        """Fill the missing rows of these goals: for each junction the time to the goal and the next junction."""
        missing = [target for target in dict.fromkeys(targets) if target not in self._table]
        if not missing:
            return
        times, hops = dijkstra(self._reversed, indices=missing, return_predecessors=True)
        for target, time, hop in zip(missing, times, hops, strict=True):
            self._table[target] = cast("memoryview[float]", time.data), hop.data

    def _reconnect(self) -> None:
        for segment in self._segments:
            segment.cuts.clear()
        for place in self._closed:
            for start, end in self._edges_of(place):
                if (cut := self._edges.get((start, end))) is not None:
                    cut.segment.cuts.append(cut.index)
        self._connect()

    def _edges_of(self, place: Barcode | EdgeKey) -> Iterable[EdgeKey]:
        if isinstance(place, tuple):
            return (place,)
        return ((before, place) for before in self._track.predecessors(place)) if place in self._track else ()

    def _connect(self) -> None:
        """Choose the quickest open segment between each two junctions, and forget the table."""
        best: dict[int, Segment] = {}
        for segment in self._segments:
            key = segment.tail * self._size + segment.head
            if not segment.cuts and (key not in best or segment.at[-1] < best[key].at[-1]):
                best[key] = segment
        self._links = {key: segment.path[1:] for key, segment in best.items()}
        tails, heads = [s.tail for s in best.values()], [s.head for s in best.values()]
        seconds = np.array([s.at[-1] for s in best.values()], dtype=np.float64)
        self._reversed = csr_array((seconds, (heads, tails)), shape=(self._size, self._size))
        self._table.clear()

    def _no_route(self, start: Barcode, goal: Barcode) -> NoRoute:
        for barcode in (start, goal):
            if barcode not in self._track:
                return NoRoute(f"no route from {start} to {goal}: {barcode} is not on the track")
        try:
            path = nx.shortest_path(self._track.graph, start, goal, weight="time")
        except nx.NetworkXNoPath:
            return NoRoute(f"no route from {start} to {goal}: the track does not connect them")
        shut = next((b if b in self._closed else f"{a} to {b}" for a, b in pairwise(path) if self._is_closed(a, b)))
        return NoRoute(f"no route from {start} to {goal}: {shut} is closed", remedy=f"open {shut}")

    def _is_closed(self, start: Barcode, end: Barcode) -> bool:
        return end in self._closed or (start, end) in self._closed


def _stretch(segment: Segment, start: int, end: int) -> list[Barcode] | None:
    """Return the barcodes from one index to another, both included; None if a cut lies between."""
    if segment.cuts and not segment.is_open(start, end):
        return None
    return list(segment.path[start : end + 1])
