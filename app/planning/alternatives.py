"""Ways from fork to fork by search, for what no table tells: other ways than the quickest, and ways round a new closure."""

from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from heapq import heappop, heappush
from math import inf
from typing import TypeAlias

import numpy as np

from app.domain.units import Barcode
from app.planning.compiled import Cuts, View
from app.planning.tables import seconds_to

Way: TypeAlias = tuple[int, ...]
"""Arcs, one after the other; the last one may be left before its end."""


@dataclass(frozen=True, slots=True)
class Aim:
    """What is searched for: a goal, the arcs it is reached over (with its index there) or the fork it is, what may not be used.

    ``ahead`` gives the seconds from a fork to the goal, or less.
    """

    view: View
    fork: int
    entries: dict[int, int]
    cuts: Cuts
    ahead: Callable[[int], float]

    def leaves(self, fork: int) -> Iterator[tuple[int, float, int]]:
        """Give (arc, its seconds, the fork it leads to: -1 for the goal) for each arc open to drive on from a fork."""
        view = self.view
        for arc in view.arcs_from(fork):
            if (index := self.entries.get(arc)) is not None:
                yield arc, view.time_along(arc, 0, index), -1
            elif arc not in self.cuts and (head := view.arcs.heads[arc]) >= 0:
                yield arc, view.whole(arc), -1 if head == self.fork else head


def by_table(view: View, goal: Barcode, cuts: Cuts) -> Aim:
    """Return the search for a goal that the view's tables lead; over what is open in its version and now."""
    reach, known = view.reach(goal, cuts), dict[int, float]()

    def ahead(fork: int) -> float:
        if (seconds := known.get(fork)) is None:
            seconds = known[fork] = min((view.between(fork, tail) + more for tail, more in reach), default=inf)
        return seconds

    shut = {**dict.fromkeys(view.shut, ()), **cuts}
    return Aim(view, view.arcs.forks.get(goal, -1), view.entries(goal, cuts), shut, ahead)


def by_present(view: View, goal: Barcode, cuts: Cuts) -> Aim:
    """Return the search for a goal with the view's times over all that is open now, whatever its version had closed."""
    arcs, reach = view.arcs, view.reach(goal, cuts)
    whole = arcs.plan.whole(view.tables.at, cuts)
    times = [inf] * arcs.plan.size
    if reach:
        rows = seconds_to(arcs.plan, whole, [fork for fork, _ in reach])
        times = (rows + np.array([[more] for _, more in reach])).min(axis=0).tolist()
    return Aim(view, arcs.forks.get(goal, -1), view.entries(goal, cuts), cuts, times.__getitem__)


def search(goal: Aim, start: int, arcs: Collection[int] = (), forks: Collection[int] = ()) -> tuple[float, Way] | None:
    """Return the seconds and arcs of a quickest way from a fork without these arcs and forks (A*); None if there is none."""
    best: dict[int, float] = {start: 0.0}
    came: dict[int, tuple[int, int]] = {}
    done: set[int] = set()
    queue: list[tuple[float, int]] = [(goal.ahead(start), start)]
    while queue and queue[0][0] < inf:
        _, here = heappop(queue)
        if here == -1:
            return best[-1], _traced(came, start)
        if here in done:
            continue
        done.add(here)
        for arc, seconds, fork in goal.leaves(here):
            if arc in arcs or fork in forks or fork in done:
                continue
            total = best[here] + seconds
            if total < best.get(fork, inf):
                best[fork], came[fork] = total, (here, arc)
                heappush(queue, (total if fork == -1 else total + goal.ahead(fork), fork))
    return None


def _traced(came: dict[int, tuple[int, int]], start: int) -> Way:
    here, way = -1, list[int]()
    while here != start:
        here, arc = came[here]
        way.append(arc)
    return tuple(reversed(way))


def ways(goal: Aim, start: int) -> Iterator[tuple[float, Way]]:
    """Give the ways from a fork that pass no place twice, quickest first; there may be very many.

    Yen's algorithm as Lawler has it: each way given splits the rest by where they leave it. A part waits in the queue under the
    least that it can take, which the table tells, and is searched only when it is at the front.
    """
    queue: list[tuple[float, bool, Way, int, Way]] = [(goal.ahead(start), False, (), 0, ())]
    while queue:
        seconds, known, way, index, taken = heappop(queue)
        if not known:
            passed = [goal.view.arcs.tails[arc] for arc in way]
            fork = goal.view.arcs.heads[way[-1]] if way else start
            if (spur := search(goal, fork, taken, passed)) is not None:
                whole = sum(map(goal.view.whole, way)) + spur[0]
                heappush(queue, (whole, True, way + spur[1], index, taken))
            continue
        yield seconds, way
        for part in _parts(goal, way, index, taken):
            heappush(queue, part)


def _parts(goal: Aim, way: Way, index: int, taken: Way) -> Iterator[tuple[float, bool, Way, int, Way]]:
    """Give the ways that leave this one from an index on: the least they take, what they share, which arcs they do not take."""
    root = sum(map(goal.view.whole, way[:index]))
    passed = {goal.view.arcs.tails[arc] for arc in way[:index]}
    for place in range(index, len(way)):
        fork = goal.view.arcs.tails[way[place]]
        passed.add(fork)
        others = (*taken, way[place]) if place == index else (way[place],)
        leaves = (leaf for leaf in goal.leaves(fork) if leaf[0] not in others and leaf[2] not in passed)
        least = min((more + (goal.ahead(head) if head >= 0 else 0.0) for _, more, head in leaves), default=inf)
        if least < inf:
            yield root + least, False, way[:place], place, others
        root += goal.view.whole(way[place])


def drawn(goal: Aim, way: Way) -> list[Barcode]:
    """Return the barcodes of a way to the goal, without the first fork."""
    rest, path = goal.view.arcs.rest, list[Barcode]()
    for arc in way[:-1]:
        path += rest[arc]
    for arc in way[-1:]:
        path += rest[arc][: goal.entries.get(arc, len(rest[arc]))]
    return path
