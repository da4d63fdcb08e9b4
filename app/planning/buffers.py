"""Buffers: the queues that one-way track consists of (TRAFFIC section 1)."""

from collections.abc import Iterator
from itertools import pairwise
from typing import TypeAlias

from app.domain.units import Barcode, Millimetres
from app.planning.track import Track

Row: TypeAlias = list[int]
LONGEST_PASS = Millimetres(30_000)
"""Our choice: no-stop track is crossed in one grant of at most so much; where no place to wait is nearer, one waits in it."""


class Buffers:
    """The buffers of a track, all by index.

    A buffer is a chain of barcodes without a branch: a barcode after a merge opens one, a barcode before a diverge closes one,
    and every barcode of one-way track lies in exactly one. ``of`` has the buffer of each barcode (-1: two-way floor, which has
    none), ``place`` its index in ``chains``, ``stop`` whether a vehicle may wait there: it is in no no-stop zone and keeps no
    other branch from passing (``Track.conflicts``). ``capacity`` is how many vehicles of ``length`` can wait in the buffer
    whole, one behind the other. ``transit`` buffers hold fewer than two: they are crossed in one go to one of ``outs``, the
    buffers where a vehicle may wait next, and are never waited in.
    """

    def __init__(self, track: Track, length: Millimetres) -> None:
        self._track, self._length = track, length
        self.index: dict[Barcode, int] = {barcode: i for i, barcode in enumerate(track.barcodes)}
        self.of: Row = [-1] * len(self.index)
        self.place: Row = [0] * len(self.index)
        self.chains: list[tuple[Barcode, ...]] = []
        for chain in self._chains():
            for place, barcode in enumerate(chain):
                self.of[self.index[barcode]], self.place[self.index[barcode]] = len(self.chains), place
            self.chains.append(chain)
        self.nexts: list[tuple[int, ...]] = [self._after(chain) for chain in self.chains]
        self.stop: Row = [int(not track.no_stop(b) and not track.conflicts(b)) for b in track.barcodes]
        self.capacity: Row = [self._slots(chain) for chain in self.chains]
        self.lengths: list[Millimetres] = [track.distance(chain) for chain in self.chains]
        self.transit = self._find_transit()
        self.capacity = [c if t else max(1, c) for c, t in zip(self.capacity, self.transit, strict=True)]
        self.outs: list[tuple[int, ...]] = [self._outs(buffer) for buffer in range(len(self.chains))]

    def __len__(self) -> int:
        return len(self.chains)

    def at(self, barcode: Barcode) -> int:
        """Return the buffer that a barcode lies in; -1 if it is two-way floor or not on the track."""
        index = self.index.get(barcode)
        return -1 if index is None else self.of[index]

    def _chains(self) -> Iterator[tuple[Barcode, ...]]:
        track, seen = self._track, set(self._track.floor)
        opens = [b for b in track.barcodes if self._opens(b)]
        for first in (*opens, *track.barcodes):
            if first in seen:
                continue
            chain = [first]
            seen.add(first)
            while len(after := track.successors(chain[-1])) == 1 and after[0] not in seen and not self._opens(after[0]):
                chain.append(after[0])
                seen.add(after[0])
            yield tuple(chain)

    def _opens(self, barcode: Barcode) -> bool:
        before = self._track.predecessors(barcode)
        return len(before) != 1 or len(self._track.successors(before[0])) != 1

    def _after(self, chain: tuple[Barcode, ...]) -> tuple[int, ...]:
        return tuple(self.of[self.index[b]] for b in self._track.successors(chain[-1]) if self.of[self.index[b]] >= 0)

    def _slots(self, chain: tuple[Barcode, ...]) -> int:
        """Return how many vehicles can wait in a chain, the first as far ahead as it may, none reaching out behind."""
        gaps = [self._track.edge(a, b).length for a, b in pairwise(chain)]
        count, at = 0, len(chain) - 1
        while at >= 0:
            if not self.stop[self.index[chain[at]]]:
                at -= 1
                continue
            tail, left = at, self._length
            while tail > 0 and gaps[tail - 1] <= left:
                left = Millimetres(left - gaps[tail - 1])
                tail -= 1
            if tail == 0 and left > 0 and not self._ends_before(chain[0], left):
                return count
            count += 1
            at = tail - 1
        return count

    def _ends_before(self, first: Barcode, left: Millimetres) -> bool:
        """Whether a vehicle of which so much sticks out of the buffer's first barcode covers no barcode before it."""
        return all(self._track.edge(b, first).length > left for b in self._track.predecessors(first))

    def _find_transit(self) -> Row:
        """Return which buffers are too short to wait in, where all ways out of them lead to longer ones soon enough."""
        short = [int(slots < 2) for slots in self.capacity]
        return [int(bool(is_short) and self._leads_out(b, short)) for b, is_short in enumerate(short)]

    def _leads_out(self, buffer: int, short: Row) -> bool:
        """Whether every way from here comes to a buffer that is not short within LONGEST_PASS."""
        queue = [(buffer, int(self.lengths[buffer]))]
        while queue:
            here, way = queue.pop()
            if not self.nexts[here] or way > LONGEST_PASS:
                return False
            queue += [(n, way + self._reach(here, n)) for n in self.nexts[here] if short[n]]
        return True

    def _reach(self, here: int, after: int) -> int:
        return self._track.edge(self.chains[here][-1], self.chains[after][0]).length + self.lengths[after]

    def _outs(self, buffer: int) -> tuple[int, ...]:
        """Return the buffers where a vehicle may wait next, over transit ones, each once."""
        found: dict[int, None] = {}
        seen, queue = {buffer}, list(self.nexts[buffer])
        while queue:
            here = queue.pop(0)
            if not self.transit[here]:
                found[here] = None
            elif here not in seen:
                seen.add(here)
                queue += self.nexts[here]
        return tuple(found)
