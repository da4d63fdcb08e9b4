"""All quickest ways between forks at once: a plan made once per track, tables computed from it for any weights.

A node that has few neighbours is *eliminated*: the ways through it become direct ones between its neighbours, so that what is
left is a smaller graph with the same times. Tracks fall apart quickly under this (bays hang on a spine by few rails). Back
again, each node's row of times is a minimum over the rows of its few neighbours: whole rows at a time in numpy, many times
faster than a search from each node. What is too interwoven to be eliminated (the *core*) gets its rows from scipy's Dijkstra.

Nothing here knows barcodes; tasks and tables are arrays only, so that any process may compute them.
"""

from collections.abc import Generator, Iterable, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from itertools import chain
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
ROUNDING = 1e-12
"""Our choice: sums that differ by less than this share are the same sum in another order (some hundred roundings of 1e-16)."""


@dataclass(frozen=True, slots=True)
class Plan:
    """How to compute the tables of one track, for whatever weights: 0 ... ``size`` - 1 are forks in order of elimination.

    Forks from ``core`` on are not eliminated. A *pair* is two forks with a direct way from ``tails`` to ``heads``, by an arc or
    by what elimination adds; pairs rise by tail, and ``first[f]`` is the first one of a fork (``size`` + 1 of them). ``pair`` is
    each arc's, -1 if it leads nowhere new. ``through`` has rows (pair in, pair out, pair made), in order. ``ahead`` and
    ``behind`` have rows (fork, neighbour of it that is eliminated later, their pair).

    Arc ``a`` leads over the edges ``over[begins[a] : begins[a + 1]]``, one per barcode of its path (the first: the number of
    edges). Arcs beyond those that have a ``pair`` begin at no fork.
    """

    size: int
    core: int
    pair: Ints
    tails: Ints
    heads: Ints
    first: Ints
    through: Ints
    ahead: Ints
    behind: Ints
    over: Ints
    begins: Ints

    def at(self, seconds: Floats) -> Floats:
        """Return, aligned with ``over``, the time from the beginning of its arc to each barcode, given each edge's seconds."""
        times: Floats = np.append(seconds, 0.0).take(self.over)
        np.cumsum(times, out=times)
        times -= np.repeat(times[self.begins[:-1]], np.diff(self.begins))
        return times

    def whole(self, at: Floats, shut: Iterable[int] = ()) -> Floats:
        """Return the seconds of each arc that begins at a fork, infinite for those that are shut."""
        seconds = at[self.begins[1 : len(self.pair) + 1] - 1]
        seconds[[arc for arc in shut if arc < len(self.pair)]] = inf
        return seconds


@dataclass(frozen=True, slots=True)
class Task:
    """Tables wanted for these seconds of each edge, with these arcs shut. May be pickled and computed anywhere."""

    version: int
    plan: Plan
    seconds: Floats
    shut: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Tables:
    """What a task gives, by fork left (row) and fork reached (column).

    ``seconds`` is the time of the quickest way, 0 on the diagonal, infinite where there is none. ``hop`` tells which pair out of
    the first fork to follow, counted from the fork's first; it means nothing where the time is 0 or infinite. It is the longest
    one on a quickest way, so that a route has few. ``parts`` has a row for each pair: the two that it is made of, or its arc
    and -1; (-1, -1): it has no way. ``at`` is what ``Plan.at`` gives.
    """

    version: int
    seconds: Floats
    hop: Hops
    parts: Ints
    at: Floats


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


def planned(arcs: Sequence[tuple[int, int]], elimination: Elimination, over: Sequence[Sequence[int]]) -> Plan:
    """Return the plan for arcs (tail, head) between forks that are numbered by this elimination. A head of -1 is a dead end.

    ``over`` has the edges that each arc leads over, also of those that begin at no fork, after the others.
    """
    number = {fork: place for place, fork in enumerate(elimination.order)}
    links = [([number[f] for f in before], [number[f] for f in after]) for before, after in elimination.links]
    known = dict.fromkeys(arc for arc in arcs if arc[1] not in (-1, arc[0]))
    for before, after in links:
        known.update(((tail, head), None) for tail in before for head in after if tail != head)
    pairs = {pair: place for place, pair in enumerate(sorted(known))}
    tails = np.array([tail for tail, _ in pairs], dtype=np.int32)
    through: list[tuple[int, int, int]] = []
    ahead: list[tuple[int, int, int]] = []
    behind: list[tuple[int, int, int]] = []
    for fork, (before, after) in enumerate(links):
        behind += [(fork, tail, pairs[tail, fork]) for tail in before if tail < elimination.core]
        ahead += [(fork, head, pairs[fork, head]) for head in after]
        ways = ((tail, head) for tail in before for head in after if tail != head)
        through += [(pairs[tail, fork], pairs[fork, head], pairs[tail, head]) for tail, head in ways]
    return Plan(
        size=len(elimination.order),
        core=elimination.core,
        pair=np.array([pairs.get(arc, -1) for arc in arcs], dtype=np.int32),
        tails=tails,
        heads=np.array([head for _, head in pairs], dtype=np.int32),
        first=np.searchsorted(tails, np.arange(len(elimination.order) + 1)).astype(np.int32),
        through=_rows(through),
        ahead=_rows(ahead),
        behind=_rows(behind),
        over=np.fromiter(chain.from_iterable(over), dtype=np.int32),
        begins=np.cumsum([0, *(len(edges) for edges in over)], dtype=np.int32),
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
    at = plan.at(task.seconds)
    direct, parts = _direct(plan, plan.whole(at, task.shut))
    table = np.empty((plan.size, plan.size))
    yield
    for begin in range(0, plan.size, SLICE):
        table[begin : begin + SLICE] = inf
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
                parts[made] = one, other
        yield
    yield from _spread(plan, way, table)
    few = int(np.diff(plan.first).max(initial=0)) <= np.iinfo(np.int8).max
    hop: Hops = np.zeros((plan.size, plan.size), dtype=np.int8 if few else np.int16)
    yield from _choose(plan, way, table, hop)
    return Tables(task.version, table, hop, parts, at)


def seconds_to(plan: Plan, seconds: Floats, forks: Sequence[int]) -> Floats:
    """Return, for each of these forks (row), the seconds from every fork (column) to it, given those of each arc.

    Takes about 0.5 ms for one fork of 3,000: for a few questions that cannot wait for tables.
    """
    direct, _ = _direct(plan, seconds)
    times: Floats = np.atleast_2d(dijkstra(csr_array(_graph(plan, direct).T), indices=list(forks)))
    return times


def _direct(plan: Plan, seconds: Floats) -> tuple[Floats, Ints]:
    """Return the seconds of each pair by its quickest arc, infinite without one, and which arc that is."""
    direct = np.full(len(plan.tails), inf)
    parts: Ints = np.full((len(plan.tails), 2), -1, dtype=np.int32)
    arcs = np.flatnonzero((plan.pair >= 0) & (seconds < inf))
    arcs = arcs[np.argsort(-seconds[arcs], kind="stable")]  # of equal indices the last one counts: the quickest
    direct[plan.pair[arcs]] = seconds[arcs]
    parts[plan.pair[arcs], 0] = arcs
    return direct, parts


def _graph(plan: Plan, direct: Floats) -> csr_array:
    ways = direct < inf
    return csr_array((direct[ways], (plan.tails[ways], plan.heads[ways])), shape=(plan.size, plan.size))


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


def _choose(plan: Plan, way: list[float], table: Floats, hop: Hops) -> Generator[None, None, None]:
    """Find for each fork the longest pair that begins a quickest way."""
    spare, tight, count = np.empty(plan.size), np.empty(plan.size, dtype=bool), 0
    heads, first = plan.heads.tolist(), plan.first.tolist()
    for fork in range(plan.size):
        quickest = table[fork] * (1 + ROUNDING)
        pairs = range(first[fork], first[fork + 1])
        for pair in sorted(pairs, key=way.__getitem__):
            if way[pair] < inf:
                np.add(table[heads[pair]], way[pair], out=spare)
                np.less_equal(spare, quickest, out=tight)
                np.copyto(hop[fork], pair - pairs.start, where=tight)
        count += len(pairs)
        if count > 2 * SLICE:
            count = 0
            yield
