"""All quickest ways between forks at once: a plan made once per track, tables computed from it for any weights.

A node that has few neighbours is *eliminated*: the ways through it become direct ones between its neighbours, so that what is
left is a smaller graph with the same times. Tracks fall apart quickly under this (bays hang on a spine by few rails). Back
again, each node's row of times is a minimum over the rows of its few neighbours: whole rows at a time in numpy, many times
faster than a search from each node. What is too interwoven to be eliminated (the *core*) gets its rows from scipy's Dijkstra.

Nothing here knows barcodes; tasks and tables are arrays only, so that any process may compute them.
"""

from collections.abc import Generator, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from math import inf
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int32]
Hops: TypeAlias = NDArray[np.signedinteger]
MOST_THROUGH = 400
"""Our choice: a node with more (ways in x ways out) than this is left to Dijkstra, whose row costs as much by then."""
SLICE = 64
"""Our choice: rows computed in one step; at 3,000 forks a step takes about 2 ms."""


@dataclass(frozen=True, slots=True)
class Plan:
    """How to compute the tables of one track, for whatever weights: 0 ... ``size`` - 1 are forks in order of elimination.

    Forks from ``core`` on are not eliminated. ``tail`` and ``head`` are the arcs', rising by tail; ``first[f]`` is the first arc
    out of a fork (``size`` + 1 of them). ``pair`` is each arc's number among the pairs of forks with a direct way, which
    elimination adds to; -1: the arc leads nowhere new. ``through`` has rows (pair in, pair out, pair made), in order.
    ``ahead`` and ``behind`` have rows (fork, neighbour of it that is eliminated later, their pair).
    """

    size: int
    core: int
    tail: Ints
    head: Ints
    first: Ints
    pair: Ints
    pairs: int
    through: Ints
    ahead: Ints
    behind: Ints


@dataclass(frozen=True, slots=True)
class Task:
    """Tables wanted for these seconds of each arc (infinite: closed). May be pickled and computed anywhere."""

    version: int
    plan: Plan
    seconds: Floats


@dataclass(frozen=True, slots=True)
class Tables:
    """What a task gives, by fork left (row) and fork reached (column).

    ``seconds`` is the time of the quickest way, 0 on the diagonal, infinite where there is none. ``hop`` tells which arc out of
    the first fork to take, counted from the fork's first; it means nothing where the time is 0 or infinite.
    """

    version: int
    seconds: Floats
    hop: Hops


class Elimination:
    """Which forks to eliminate in which order: always the one with the fewest ways through it."""

    def __init__(self, size: int, arcs: Sequence[tuple[int, int]]) -> None:
        self.after: list[set[int]] = [set() for _ in range(size)]
        self.before: list[set[int]] = [set() for _ in range(size)]
        for tail, head in arcs:
            if head not in (-1, tail):
                self.after[tail].add(head)
                self.before[head].add(tail)
        self.order: list[int] = []
        self.links: list[tuple[list[int], list[int]]] = []
        """Of each eliminated one, the forks right before and right after it that were still there, rising."""
        self._run()

    def _ways(self, fork: int) -> int:
        return len(self.after[fork]) * len(self.before[fork])

    def _run(self) -> None:
        queue = [(self._ways(fork), fork) for fork in range(len(self.after))]
        heapify(queue)
        left = dict.fromkeys(range(len(self.after)))
        while queue:
            ways, fork = heappop(queue)
            if fork not in left or ways != self._ways(fork):
                continue
            if ways > MOST_THROUGH:
                break
            del left[fork]
            for neighbour in self._eliminate(fork):
                heappush(queue, (self._ways(neighbour), neighbour))
        self.core = len(self.order)
        self.order += left

    def _eliminate(self, fork: int) -> list[int]:
        before, after = self.before[fork], self.after[fork]
        for tail in before:
            self.after[tail].discard(fork)
            self.after[tail] |= after - {tail}
        for head in after:
            self.before[head].discard(fork)
            self.before[head] |= before - {head}
        self.order.append(fork)
        self.links.append((sorted(before), sorted(after)))
        return sorted(before | after)


def planned(size: int, arcs: Sequence[tuple[int, int]], elimination: Elimination) -> Plan:
    """Return the plan for arcs (tail, head) between forks that are numbered by this elimination, rising by tail.

    A head of -1 is a dead end.
    """
    number = {fork: place for place, fork in enumerate(elimination.order)}
    pairs: dict[tuple[int, int], int] = {}
    pair = [pairs.setdefault(arc, len(pairs)) if arc[1] not in (-1, arc[0]) else -1 for arc in arcs]
    through: list[tuple[int, int, int]] = []
    ahead: list[tuple[int, int, int]] = []
    behind: list[tuple[int, int, int]] = []
    for fork, (before, after) in enumerate(elimination.links):
        tails, heads = [number[f] for f in before], [number[f] for f in after]
        into, out = [pairs[tail, fork] for tail in tails], [pairs[fork, head] for head in heads]
        behind += [(fork, tail, way) for tail, way in zip(tails, into, strict=True) if tail < elimination.core]
        ahead += [(fork, head, way) for head, way in zip(heads, out, strict=True)]
        through += [
            (one, other, pairs.setdefault((tail, head), len(pairs)))
            for tail, one in zip(tails, into, strict=True)
            for head, other in zip(heads, out, strict=True)
            if tail != head
        ]
    tail = np.array([tail for tail, _ in arcs], dtype=np.int32)
    return Plan(
        size=size,
        core=elimination.core,
        tail=tail,
        head=np.array([head for _, head in arcs], dtype=np.int32),
        first=np.searchsorted(tail, np.arange(size + 1)).astype(np.int32),
        pair=np.array(pair, dtype=np.int32),
        pairs=len(pairs),
        through=_rows(through),
        ahead=_rows(ahead),
        behind=_rows(behind),
    )


def _rows(rows: list[tuple[int, int, int]]) -> Ints:
    return np.array(rows, dtype=np.int32).reshape(-1, 3)


def compute(task: Task) -> Tables:
    """Return the tables of a task."""
    steps = computing(task)
    while True:
        try:
            next(steps)
        except StopIteration as end:
            tables: Tables = end.value
            return tables


def computing(task: Task) -> Generator[None, None, Tables]:
    """Compute the tables in small steps, for who has no other process to do it in; the generator returns them."""
    plan = task.plan
    direct = np.full(plan.pairs, inf)
    useful = plan.pair >= 0
    np.minimum.at(direct, plan.pair[useful], task.seconds[useful])
    table = np.full((plan.size, plan.size), inf)
    yield
    for begin in range(plan.core, plan.size, SLICE):
        forks = np.arange(begin, min(begin + SLICE, plan.size))
        table[forks] = dijkstra(_graph(plan, direct), indices=forks)
        yield
    way: list[float] = direct.tolist()
    for begin in range(0, len(plan.through), SLICE * SLICE):
        for one, other, made in plan.through[begin : begin + SLICE * SLICE].tolist():
            if way[one] + way[other] < way[made]:
                way[made] = way[one] + way[other]
        yield
    yield from _spread(plan, way, table)
    few = int(np.diff(plan.first).max(initial=0)) <= np.iinfo(np.int8).max
    hop: Hops = np.zeros((plan.size, plan.size), dtype=np.int8 if few else np.int16)
    for begin in range(0, plan.size, SLICE):
        _choose(plan, task.seconds, table, hop, slice(begin, min(begin + SLICE, plan.size)))
        yield
    return Tables(task.version, table, hop)


def _graph(plan: Plan, direct: Floats) -> csr_array:
    arcs = plan.pair >= 0
    tails, heads, seconds = plan.tail[arcs], plan.head[arcs], direct[plan.pair[arcs]]
    _, once = np.unique(plan.pair[arcs], return_index=True)
    once = once[seconds[once] < inf]
    return csr_array((seconds[once], (tails[once], heads[once])), shape=(plan.size, plan.size))


def _spread(plan: Plan, way: list[float], table: Floats) -> Generator[None, None, None]:
    """Fill the rows of the eliminated forks: first the times by forks eliminated earlier, then, backwards, by all."""
    core, spare = plan.core, np.empty(plan.size)
    np.fill_diagonal(table[:core, :core], 0.0)
    for count, (fork, neighbour, pair) in enumerate(plan.behind.tolist()):
        known, better, sums = table[fork, : fork + 1], table[neighbour, : fork + 1], spare[: fork + 1]
        np.add(known, way[pair], out=sums)
        np.minimum(better, sums, out=better)
        if count % (4 * SLICE) == 0:
            yield
    for count, (fork, neighbour, pair) in enumerate(reversed(plan.ahead.tolist())):
        row = table[fork]
        np.add(table[neighbour], way[pair], out=spare)
        np.minimum(row, spare, out=row)
        if count % (4 * SLICE) == 0:
            yield


def _choose(plan: Plan, seconds: Floats, table: Floats, hop: Hops, rows: slice) -> None:
    """Find for these forks which of their arcs begins the quickest way."""
    first, degree = plan.first[:-1][rows], np.diff(plan.first)[rows]
    forks = np.arange(rows.start, rows.stop)
    best = _by(plan, seconds, table, first)
    for rank in range(1, int(degree.max(initial=0))):
        having = degree > rank
        by_this = _by(plan, seconds, table, first[having] + rank)
        quicker = by_this < best[having]
        best[having] = np.minimum(best[having], by_this)
        chosen = hop[forks[having]]
        chosen[quicker] = rank
        hop[forks[having]] = chosen


def _by(plan: Plan, seconds: Floats, table: Floats, arcs: Ints) -> Floats:
    """Return the times from the tails of these arcs, one each, by way of the arc (a dead end: for ever)."""
    through = np.where(plan.pair[arcs] >= 0, seconds[arcs], inf)
    times: Floats = table[plan.head[arcs]] + through[:, None]
    return times
