"""What can be reached at all from some places, over track that is open now: by whom, and how quickly, is left out."""

from collections import defaultdict
from collections.abc import Iterable, Sequence

from app.domain.units import Barcode
from app.planning.arcs import Arcs, Spot
from app.planning.compiled import Cuts, is_open


def reached(arcs: Arcs, cuts: Cuts, starts: Iterable[Barcode], goals: Sequence[Barcode]) -> list[bool]:
    """Return for each goal whether a way leads there from any of the starts. A start that is closed itself may be left."""
    forks = set[int]()
    along: defaultdict[int, list[tuple[int, int]]] = defaultdict(list)
    for start in dict.fromkeys(starts):
        if (fork := arcs.forks.get(start)) is not None:
            forks.add(fork)
        for arc, index in arcs.spots.get(start, ())[:1]:
            last = len(arcs.paths[arc]) - 1
            end = min((cut - 1 for cut in cuts.get(arc, ()) if cut > index), default=last)
            along[arc].append((index, end))
            if end == last and arcs.heads[arc] >= 0:
                forks.add(arcs.heads[arc])
    _spread(arcs, cuts, forks)
    return [_comes_to(arcs, cuts, forks, along, goal) for goal in goals]


def _spread(arcs: Arcs, cuts: Cuts, forks: set[int]) -> None:
    """Add every fork that is reached from these."""
    queue = list(forks)
    while queue:
        fork = queue.pop()
        for arc in range(arcs.first[fork], arcs.first[fork + 1]):
            head = arcs.heads[arc]
            if head >= 0 and head not in forks and arc not in cuts:
                forks.add(head)
                queue.append(head)


def _comes_to(arcs: Arcs, cuts: Cuts, forks: set[int], along: dict[int, list[tuple[int, int]]], goal: Barcode) -> bool:
    if (fork := arcs.forks.get(goal)) is not None:
        return fork in forks
    spots: tuple[Spot, ...] = arcs.spots.get(goal, ())
    for arc, index in spots:
        if any(begin <= index <= end for begin, end in along.get(arc, ())):
            return True
        if arc < arcs.approaches and arcs.tails[arc] in forks and is_open(cuts, arc, 0, index):
            return True
    return False
