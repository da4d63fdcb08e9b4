"""The compiled view of a track: one version of its times, fixed, from which routes are read off."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from math import inf
from typing import TypeAlias, cast

import numpy as np

from app.domain.units import Barcode
from app.planning.arcs import Arcs, Step
from app.planning.tables import Floats, Tables

Cuts: TypeAlias = Mapping[int, Sequence[int]]
"""For each arc that a closed edge lies on, the indices in its path that cannot be reached from the one before."""
NO_CUTS: Cuts = {}
MOST_JOINED = 4
"""So many steps a pair are kept for later versions, before they are forgotten. Our choice."""


def is_open(cuts: Cuts, arc: int, start: int, end: int) -> bool:
    """Return whether one may drive along an arc from one index to another."""
    return arc not in cuts or not any(start < cut <= end for cut in cuts[arc])


class View:
    """Quickest ways over a track with the weights and closures of one version.

    ``seconds`` are the edges' (aligned with ``arcs.edges``), ``shut`` the arcs closed as a whole in this version. The ``cuts``
    given to methods are those of now: they count on the stretches before the first fork and behind the last one.
    """

    def __init__(self, arcs: Arcs, seconds: Floats, shut: Mapping[int, object], tables: Tables) -> None:
        self.arcs, self.seconds, self.tables = arcs, seconds, tables
        self.shut = frozenset(shut)
        self._size = arcs.plan.size
        self._at = cast("memoryview[float]", tables.at.data)
        self._begins = arcs.starts
        self._times = cast("memoryview[float]", tables.seconds.reshape(-1).data)
        self._hop = tables.hop.reshape(-1).data
        self._steps: list[Step | None] = [None] * len(arcs.pair_heads)

    @property
    def version(self) -> int:
        """The number of this version."""
        return self.tables.version

    def time_along(self, arc: int, start: int, end: int) -> float:
        """Return the seconds from one index of an arc's path to another."""
        begin = self._begins[arc]
        return self._at[begin + end] - self._at[begin + start]

    def whole(self, arc: int) -> float:
        """Return the seconds of an arc from its fork to the next."""
        return self._at[self._begins[arc + 1] - 1]

    def arcs_from(self, fork: int) -> range:
        """Return the arcs that begin at a fork."""
        return range(self.arcs.first[fork], self.arcs.first[fork + 1])

    def between(self, fork: int, other: int) -> float:
        """Return the seconds of the quickest way from one fork to another."""
        return self._times[fork * self._size + other]

    def entries(self, goal: Barcode, cuts: Cuts) -> dict[int, int]:
        """Return the arcs over which the goal, no fork, is reached, and its index in each."""
        if goal not in self.arcs.spots:
            return {}
        return {
            arc: index
            for arc, index in self.arcs.spots[goal]
            if arc < self.arcs.approaches and is_open(cuts, arc, 0, index)
        }

    def stretch(self, start: Barcode, goal: Barcode) -> tuple[int, int, int] | None:
        """Return (arc, index, index) if the goal lies ahead of the start before the next fork, where there is no choice."""
        for arc, index in self.arcs.spots.get(start, ())[:1]:
            for other, place in self.arcs.spots.get(goal, ()):
                if other == arc and place >= index:
                    return arc, index, place
        return None

    def path(self, start: Barcode, goal: Barcode, cuts: Cuts) -> list[Barcode] | None:
        """Return the barcodes of a quickest way, both ends included; None if this version knows none."""
        arcs, size, path = self.arcs, self._size, [start]
        first_arc, index, last, place, target = -1, 0, 0, 0, -1
        if (fork := arcs.forks.get(start, -1)) < 0 and (here := arcs.spots.get(start)) is not None:
            first_arc, index = here[0]
            fork = arcs.heads[first_arc]
        if (spots := arcs.spots.get(goal)) is None:
            target = arcs.forks.get(goal, -1)
        else:
            row, least, times, tails, at, begins = fork * size, inf, self._times, arcs.tails, self._at, self._begins
            for arc, there in spots:
                if arc == first_arc and there >= index:
                    return list(arcs.paths[arc][index : there + 1]) if is_open(cuts, arc, index, there) else None
                if fork < 0 or (tail := tails[arc]) < 0 or (arc in cuts and not is_open(cuts, arc, 0, there)):
                    continue
                if (seconds := times[row + tail] + at[begins[arc] + there]) < least:
                    target, last, place, least = tail, arc, there, seconds
        if fork < 0 or target < 0 or self._times[fork * size + target] == inf:
            return None
        if first_arc >= 0:
            if first_arc in cuts and not is_open(cuts, first_arc, index, len(arcs.paths[first_arc])):
                return None
            path += arcs.rest[first_arc][index:] if index else arcs.rest[first_arc]
        hop, steps, row, first = self._hop, self._steps, fork * size, arcs.pair_first[fork]
        end = target * size
        while row != end:
            pair = first + hop[row + target]
            leg, row, first = steps[pair] or self._step(pair)
            path += leg
        if place:
            path += arcs.rest[last][:place]
        return path

    def _step(self, pair: int) -> Step:
        """Return the step of a pair; kept for the next time."""
        one, other = self.tables.parts[pair].tolist()
        if other < 0:
            step = self._leaf(one, pair)
        else:
            step = self._joined(self._steps[one] or self._step(one), self._steps[other] or self._step(other))
        self._steps[pair] = step
        return step

    def _leaf(self, arc: int, pair: int) -> Step:
        """Return the step along one arc, the quickest of a pair: the same object in all versions, as most are."""
        found = self.arcs.joined.get((arc, -1))
        if found is None:
            head = self.arcs.pair_heads[pair]
            step = self.arcs.rest[arc], head * self._size, self.arcs.pair_first[head]
            found = self._kept((arc, -1), (step, step, step))
        return found[2]

    def _joined(self, one: Step, other: Step) -> Step:
        """Return both steps as one: the same object in all versions, as most are."""
        names = id(one), id(other)
        found = self.arcs.joined.get(names)
        if found is None:
            found = self._kept(names, (one, other, (one[0] + other[0], *other[1:])))
        return found[2]

    def _kept(self, names: tuple[int, int], steps: tuple[Step, Step, Step]) -> tuple[Step, Step, Step]:
        known = self.arcs.joined
        if len(known) > MOST_JOINED * len(self._steps):
            known.clear()
        known[names] = steps
        return steps

    def time(self, start: Barcode, goal: Barcode, cuts: Cuts) -> float:
        """Return the seconds of the quickest way; infinite if there is none."""
        if (direct := self.stretch(start, goal)) is not None:
            return self.time_along(*direct) if is_open(cuts, *direct) else inf
        fork, rest = self.leave(start, cuts)
        if rest == inf:
            return inf
        return rest + min((self.between(fork, tail) + more for tail, more in self.reach(goal, cuts)), default=inf)

    def leave(self, start: Barcode, cuts: Cuts) -> tuple[int, float]:
        """Return the first fork of any way from here, and the time there; infinite if none is reached."""
        for arc, index in self.arcs.spots.get(start, ())[:1]:
            last = len(self.arcs.paths[arc]) - 1
            if self.arcs.heads[arc] < 0 or not is_open(cuts, arc, index, last):
                return 0, inf
            return self.arcs.heads[arc], self.time_along(arc, index, last)
        return (self.arcs.forks[start], 0.0) if start in self.arcs.forks else (0, inf)

    def reach(self, goal: Barcode, cuts: Cuts) -> list[tuple[int, float]]:
        """Return the forks from which the goal is reached without another one between, and the time from each."""
        if (fork := self.arcs.forks.get(goal)) is not None:
            return [(fork, 0.0)]
        tails = self.arcs.tails
        return [(tails[arc], self.time_along(arc, 0, index)) for arc, index in self.entries(goal, cuts).items()]

    def times(self, starts: Sequence[Barcode], goals: Sequence[Barcode], cuts: Cuts) -> Floats:
        """Return the time from each start (row) to each goal (column), in seconds, infinite if there is no way."""
        found = np.full((len(starts), len(goals)), inf)
        leave = [self.leave(start, cuts) for start in starts]
        reach = [self.reach(goal, cuts) or [(0, inf)] for goal in goals]
        if self._size and found.size:
            flat = [entry for entries in reach for entry in entries]
            forks = np.array([fork for fork, _ in flat])
            more = np.array([seconds for _, seconds in flat])
            begins = np.cumsum([0, *(len(entries) for entries in reach[:-1])])
            table = self.tables.seconds[np.ix_(np.array([fork for fork, _ in leave]), forks)] + more
            found = np.minimum.reduceat(table, begins, axis=1) + np.array([[rest] for _, rest in leave])
        self._put_direct(found, starts, goals, cuts)
        return found

    def _put_direct(self, times: Floats, starts: Sequence[Barcode], goals: Sequence[Barcode], cuts: Cuts) -> None:
        """Correct the times between places of one arc, which need not go round by its head."""
        columns: defaultdict[int, list[tuple[int, int]]] = defaultdict(list)
        for column, goal in enumerate(goals):
            for arc, place in self.arcs.spots.get(goal, ()):
                columns[arc].append((column, place))
        for row, start in enumerate(starts):
            for arc, index in self.arcs.spots.get(start, ())[:1]:
                for column, place in columns.get(arc, ()):
                    if place >= index:
                        shut = not is_open(cuts, arc, index, place)
                        times[row, column] = inf if shut else self.time_along(arc, index, place)
