"""A set of names in a few bits each, for the question that is asked most: is this name new?"""

from collections.abc import Iterable

import numpy as np

BITS = 20
"""Bits for each name that there is room for: with 4 probes one new name in 900 looks known. Our choice."""
PROBES = 4


class Names:
    """Names that were added (a Bloom filter). Where there is room for no more, as much room again is made beside it."""

    def __init__(self, room: int) -> None:
        self._layers = [_Layer(room)]

    def surely_not(self, name: str) -> bool:
        """Return True if the name was never added; False may be wrong, seldom."""
        place = hash(name)
        for layer in self._layers:
            if not layer.may_hold(place):
                continue
            return False
        return True

    def add(self, name: str) -> None:
        """Add one name."""
        last = self._layers[-1]
        if last.count >= last.room:
            last = _Layer(2 * last.room)
            self._layers.append(last)
        last.add(hash(name))

    def add_all(self, names: Iterable[str]) -> None:
        """Add many at once, into what room there is."""
        self._layers[-1].add_all(np.fromiter(map(hash, names), np.int64))


class _Layer:
    """Bits for so many names; each sets those that its hash leads to, in steps that the hash gives too."""

    def __init__(self, room: int) -> None:
        self.room = room
        self.count = 0
        self._mask = (1 << (room * BITS - 1).bit_length()) - 1
        self._bytes = bytearray(self._mask // 8 + 1)
        self._bits = np.frombuffer(self._bytes, np.uint8)

    def may_hold(self, place: int) -> bool:
        step, mask, held = (place >> 32) | 1, self._mask, self._bytes
        for _ in range(PROBES):
            bit = place & mask
            if not held[bit >> 3] >> (bit & 7) & 1:
                return False
            place += step
        return True

    def add(self, place: int) -> None:
        step, mask, held = (place >> 32) | 1, self._mask, self._bytes
        for _ in range(PROBES):
            bit = place & mask
            held[bit >> 3] |= 1 << (bit & 7)
            place += step
        self.count += 1

    def add_all(self, places: "np.ndarray[tuple[int], np.dtype[np.int64]]") -> None:
        steps = (places >> 32) | 1
        for _ in range(PROBES):
            bits = places & self._mask
            np.bitwise_or.at(self._bits, bits >> 3, np.left_shift(1, bits & 7).astype(np.uint8))
            places = places + steps
        self.count += len(places)
