"""What a closure does to a track: which barcodes it cuts off, and how much longer routes get around it."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, dijkstra

from app.domain.units import Barcode
from app.planning.arcs import EdgeKey
from app.planning.tables import Floats
from app.planning.track import Track

STARTS = 60
"""Routes from so many places are compared, evenly chosen: each takes some 3 ms on 10,000 barcodes (our choice)."""
EXAMPLES = 5
"""So many of the routes that get longest are named."""
LONGER_BY = 0.05
"""Seconds by which a route must be longer to count as such."""


@dataclass(frozen=True, slots=True)
class Longer:
    """A route that gets longer: from and to which barcode, seconds before and with the closure."""

    start: Barcode
    goal: Barcode
    before: float
    after: float


@dataclass(frozen=True, slots=True)
class Lengthening:
    """How routes change: of so many ``pairs`` compared, ``longer`` get longer and ``lost`` are none any more.

    ``mean_before`` and ``mean_after`` are seconds over all pairs that stay connected; ``worst`` are those that grow most.
    """

    pairs: int
    longer: int
    lost: int
    mean_before: float
    mean_after: float
    worst: tuple[Longer, ...]


class Rails:
    """A track as arrays, edge by edge as the router numbers them; holds no closures and never changes."""

    def __init__(self, track: Track, edges: Mapping[EdgeKey, int]) -> None:
        self.barcodes = track.barcodes
        self.edges = edges
        self.number = {barcode: place for place, barcode in enumerate(self.barcodes)}
        order = sorted(edges, key=edges.__getitem__)
        self._tails = np.array([self.number[start] for start, _ in order], dtype=np.intp)
        self._heads = np.array([self.number[end] for _, end in order], dtype=np.intp)
        self._track = track

    def entrances(self, barcodes: AbstractSet[Barcode]) -> tuple[EdgeKey, ...]:
        """Return the edges that lead into a set of barcodes from outside, in the order of the set's barcodes on the track."""
        inside = (barcode for barcode in self.barcodes if barcode in barcodes)
        return tuple((b, barcode) for barcode in inside for b in self._track.predecessors(barcode) if b not in barcodes)

    def graph(self, seconds: Floats, shut: Iterable[EdgeKey]) -> csr_array:
        """Return the open track with the time of each edge; none takes no time, so that all are edges."""
        open_ = np.ones(len(seconds), dtype=np.bool_)
        open_[[self.edges[edge] for edge in shut if edge in self.edges]] = False
        size = len(self.barcodes)
        times = np.maximum(seconds[open_], 1e-6)
        return csr_array((times, (self._tails[open_], self._heads[open_])), shape=(size, size))

    def main(self, graph: csr_array, stations: Collection[Barcode]) -> NDArray[np.bool_]:
        """Return which barcodes lie where vehicles can go round: in each area the part with most stations.

        From any of these every other of the same area can be reached, and back. An area without a way round has none.
        """
        _, part = connected_components(graph, directed=True, connection="strong")
        size = np.bincount(part, minlength=int(part.max()) + 1 if len(part) else 0)
        at = np.array([self.number[barcode] for barcode in stations if barcode in self.number], dtype=np.intp)
        weight = size + np.bincount(part[at], minlength=len(size)) * (len(part) + 1)
        found = np.zeros(len(part), dtype=np.bool_)
        for area in self._track.areas:
            inside = np.array(sorted(self.number[barcode] for barcode in area), dtype=np.intp)
            round_ = inside[size[part[inside]] > 1] if len(inside) > 1 else inside
            if len(round_):
                found |= part == part[round_[np.argmax(weight[part[round_]])]]
        return found

    def leads_there(self, graph: csr_array, main: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Return the barcodes from which the main part can be reached, itself included."""
        size = len(self.barcodes)
        back = graph.T.tocoo()
        inside = np.flatnonzero(main)
        rows = np.concatenate([back.row, np.full(len(inside), size)])
        columns = np.concatenate([back.col, inside])
        joined = csr_array((np.ones(len(rows)), (rows, columns)), shape=(size + 1, size + 1))
        times = dijkstra(joined, indices=[size], unweighted=True)[0]
        reached: NDArray[np.bool_] = np.isfinite(times[:size])
        return reached

    def lengthening(
        self, before: csr_array, after: csr_array, places: Sequence[Barcode], starts: int = STARTS
    ) -> Lengthening:
        """Return how the routes between these places change; one start after the other, so that others have their turn."""
        if len(places) < 2:
            return Lengthening(0, 0, 0, 0.0, 0.0, ())
        goals = np.array([self.number[barcode] for barcode in places], dtype=np.intp)
        chosen = np.unique(np.linspace(0, len(places) - 1, min(starts, len(places))).astype(np.intp))
        old = np.stack([dijkstra(before, indices=goals[[row]])[0, goals] for row in chosen])
        new = np.stack([dijkstra(after, indices=goals[[row]])[0, goals] for row in chosen])
        old[np.arange(len(chosen)), chosen] = np.inf
        known = np.isfinite(old)
        both = known & np.isfinite(new)
        more = np.where(both, new, 0.0) - np.where(both, old, 0.0)
        longest = np.argsort(-more, axis=None, kind="stable")[:EXAMPLES]
        found = [divmod(int(at), len(places)) for at in longest if more.flat[at] > LONGER_BY]
        worst = tuple(
            Longer(places[chosen[row]], places[column], float(old[row, column]), float(new[row, column]))
            for row, column in found
        )
        count = max(int(both.sum()), 1)
        means = (float(old[both].sum()) / count, float(new[both].sum()) / count)
        longer = int((more > LONGER_BY).sum())
        return Lengthening(int(known.sum()), longer, int((known & ~both).sum()), *means, worst)
