"""Faults on a line: what befalls packets between two ends, around any protocol.

Every packet draws from the one generator it is given, so that a seed gives the same faults again. The faults are those that
PROTOCOLS 5.1 lists under "Fault injection".
"""

from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from random import Random


class Fault(StrEnum):
    """What can befall a packet, in the order in which it is drawn."""

    DROP = "drop"
    STALE = "stale"
    """An earlier packet comes again before it."""
    CORRUPT = "corrupt"
    """One bit is flipped."""
    WRONG_ID = "wrong id"
    """It is forged: see ``forge``."""
    NOISE = "noise"
    """One to eight bytes of anything come before it, in one piece with it."""
    DELAY = "delay"
    DUPLICATE = "duplicate"
    SPLIT = "split"
    """It comes byte by byte."""
    MERGE = "merge"
    """It comes in one piece with the next packet."""


Rates = Mapping[Fault, float]
"""How likely each fault is for a packet, 0 to 1; what is not named does not happen."""

_EARLIER = 16
"""Packets kept for STALE. Our choice."""
_NOISE_BYTES = 8
_MERGE_WAIT = 0.05
"""Seconds that a packet waits for the one it is merged with. Our choice."""


def _as_it_is(packet: bytes) -> bytes:
    return packet


@dataclass(slots=True)
class _Piece:
    release: float
    data: bytes
    open: bool = False


class Lane:
    """One direction of a line: packets go in, pieces come out in their order, perhaps later.

    ``delay`` is the shortest and longest DELAY in seconds. ``forge`` makes a packet look as if it came from someone else.
    """

    def __init__(
        self,
        random: Random,
        rates: Rates | None = None,
        *,
        delay: tuple[float, float] = (0.1, 3.0),
        forge: Callable[[bytes], bytes] = _as_it_is,
    ) -> None:
        self.rates: Rates = rates or {}
        self._random = random
        self._delay = delay
        self._forge = forge
        self._ordered: deque[tuple[Fault, Callable[[bytes], bool]]] = deque()
        self._earlier: deque[bytes] = deque(maxlen=_EARLIER)
        self._pieces: deque[_Piece] = deque()

    @property
    def deadline(self) -> float | None:
        """When the next piece comes out."""
        return self._pieces[0].release if self._pieces else None

    def strike(self, fault: Fault, match: Callable[[bytes], bool] = lambda _: True) -> None:
        """Let a fault befall the next packet that matches, whatever the rates; several orders serve one packet each."""
        self._ordered.append((fault, match))

    def put(self, packet: bytes, now: float) -> None:
        """Take a packet in."""
        faults = self._draw(packet)
        if Fault.DROP in faults:
            return
        if Fault.STALE in faults and self._earlier:
            self._append(self._random.choice(self._earlier), now)
        self._earlier.append(packet)
        if Fault.CORRUPT in faults:
            bit = self._random.randrange(8 * len(packet))
            packet = (int.from_bytes(packet, "big") ^ 1 << bit).to_bytes(len(packet), "big")
        if Fault.WRONG_ID in faults:
            packet = self._forge(packet)
        if Fault.NOISE in faults:
            packet = self._random.randbytes(self._random.randint(1, _NOISE_BYTES)) + packet
        release = now + (self._random.uniform(*self._delay) if Fault.DELAY in faults else 0.0)
        pieces = [packet] * (2 if Fault.DUPLICATE in faults else 1)
        if Fault.SPLIT in faults:
            pieces = [piece[i : i + 1] for piece in pieces for i in range(len(piece))]
        for piece in pieces:
            self._append(piece, release)
        if Fault.MERGE in faults:
            last = self._pieces[-1]
            last.open, last.release = True, last.release + _MERGE_WAIT

    def take(self, now: float) -> bytes:
        """Return and forget the next piece that is out by now; empty if none."""
        if self._pieces and self._pieces[0].release <= now:
            return self._pieces.popleft().data
        return b""

    def clear(self) -> None:
        """Lose what is on its way."""
        self._pieces.clear()

    def _draw(self, packet: bytes) -> set[Fault]:
        faults = {fault for fault in Fault if self._random.random() < self.rates.get(fault, 0.0)}
        for order in self._ordered:
            if order[1](packet):
                self._ordered.remove(order)
                return faults | {order[0]}
        return faults

    def _append(self, data: bytes, release: float) -> None:
        last = self._pieces[-1] if self._pieces else None
        if last is not None and last.open:
            last.data += data
            last.open, last.release = False, max(release, last.release - _MERGE_WAIT)
        else:
            # A line never lets a later byte overtake an earlier one.
            self._pieces.append(_Piece(release if last is None else max(release, last.release), data))
