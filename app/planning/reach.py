"""What can be reached at all from some places, over track that is open now: by whom, and how quickly, is left out."""

from collections import defaultdict
from collections.abc import Iterable

from app.domain.units import Barcode
from app.planning.arcs import Arcs
from app.planning.compiled import Cuts, is_open


class Reach:
    """Where a way leads from any of some starts, over what is open at one moment. A start that is closed itself may be left."""

    def __init__(self, arcs: Arcs, cuts: Cuts, starts: Iterable[Barcode]) -> None:
        self._arcs, self._cuts = arcs, cuts
        self._forks = set[int]()
        self._along: defaultdict[int, list[tuple[int, int]]] = defaultdict(list)
        for start in dict.fromkeys(starts):
            self._set_out(start)
        self._spread()

    def _set_out(self, start: Barcode) -> None:
        arcs = self._arcs
        if (fork := arcs.forks.get(start)) is not None:
            self._forks.add(fork)
        for arc, index in arcs.spots.get(start, ())[:1]:
            last = len(arcs.paths[arc]) - 1
            end = min((cut - 1 for cut in self._cuts.get(arc, ()) if cut > index), default=last)
            self._along[arc].append((index, end))
            if end == last and arcs.heads[arc] >= 0:
                self._forks.add(arcs.heads[arc])

    def _spread(self) -> None:
        """Add every fork that is reached from these."""
        arcs, forks, cuts = self._arcs, self._forks, self._cuts
        queue = list(forks)
        while queue:
            fork = queue.pop()
            for arc in range(arcs.first[fork], arcs.first[fork + 1]):
                head = arcs.heads[arc]
                if head >= 0 and head not in forks and arc not in cuts:
                    forks.add(head)
                    queue.append(head)

    def leads_to(self, goal: Barcode) -> bool:
        """Return whether a way leads there."""
        arcs, forks = self._arcs, self._forks
        if (fork := arcs.forks.get(goal)) is not None:
            return fork in forks
        for arc, index in arcs.spots.get(goal, ()):
            if arc < arcs.approaches and arcs.tails[arc] in forks and is_open(self._cuts, arc, 0, index):
                return True
            if any(begin <= index <= end for begin, end in self._along.get(arc, ())):
                return True
        return False
