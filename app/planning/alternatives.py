"""Ways from fork to fork by search, for what no table tells: other ways than the quickest, and ways round a new closure."""

from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from heapq import heappop, heappush
from math import inf
from typing import TypeAlias

from app.domain.units import Barcode
from app.planning.compiled import Cuts, View

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


def aim(view: View, goal: Barcode, cuts: Cuts, *, by_table: bool) -> Aim:
    """Return the search for a goal; ``by_table``: led by the view's table, and only over what is open in its version too."""
    entries, fork = view.entries(goal, cuts), view.arcs.forks.get(goal, -1)
    if not by_table:
        return Aim(view, fork, entries, cuts, lambda fork: 0.0)
    reach, known = view.reach(goal, cuts), dict[int, float]()

    def ahead(fork: int) -> float:
        if (seconds := known.get(fork)) is None:
            seconds = known[fork] = min((view.between(fork, tail) + more for tail, more in reach), default=inf)
        return seconds

    return Aim(view, fork, entries, {**dict.fromkeys(view.shut, ()), **cuts}, ahead)


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
    """Give the ways from a fork that pass no place twice, quickest first (Yen's algorithm); there may be very many."""
    view, first = goal.view, search(goal, start)
    found: list[Way] = []
    waiting: list[tuple[float, Way]] = [first] if first else []
    seen: dict[Way, None] = dict.fromkeys(way for _, way in waiting)
    while waiting:
        seconds, way = heappop(waiting)
        found.append(way)
        yield seconds, way
        root, passed = 0.0, set[int]()
        for index, arc in enumerate(way):
            taken = [other[index] for other in found if other[:index] == way[:index]]
            spur = search(goal, view.arcs.tails[arc], taken, passed)
            if spur is not None and (whole := way[:index] + spur[1]) not in seen:
                seen[whole] = None
                heappush(waiting, (root + spur[0], whole))
            root += view.whole(arc)
            passed.add(view.arcs.tails[arc])


def drawn(goal: Aim, way: Way) -> list[Barcode]:
    """Return the barcodes of a way to the goal, without the first fork."""
    rest, path = goal.view.arcs.rest, list[Barcode]()
    for arc in way[:-1]:
        path += rest[arc]
    for arc in way[-1:]:
        path += rest[arc][: goal.entries.get(arc, len(rest[arc]))]
    return path
