"""The stream of bytes cut into ENIG packets (PROTOCOLS 3.1, 6.3, E16).

The head-candidate rule: wait until the packet that seems to stand at the head is complete; a valid one is delivered, of
an invalid one the first byte is dropped and the search goes on behind it. LEN is bounded before it is waited for.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

from app.protocols.enig.codec import AROUND_LEN, ETX, STX, TAIL_SIZE, Codec, crc_of
from app.protocols.enig.messages import Frame, Toward


class Reason(StrEnum):
    """Why bytes were dropped."""

    NOISE = "noise"
    CRC = "crc"
    LENGTH = "length"
    ETX = "etx"
    TRUNCATED = "truncated"


@dataclass(slots=True)
class Garbled:
    """A run of bytes that were no packet: what was wrong first in it, in words too, and how many were dropped."""

    reason: Reason
    detail: str
    dropped: int


@dataclass(slots=True)
class _Bad:
    """A candidate that is no packet."""

    reason: Reason
    detail: str
    drop: int = 1


@dataclass(slots=True)
class Cut:
    """A packet found in a stream, and its bytes."""

    frame: Frame
    data: bytes


class Decoder:
    """Cuts one direction of one link into frames. No sequence of bytes makes it raise; it holds one packet at most."""

    __slots__ = ("_codec", "_held", "toward")

    def __init__(self, codec: Codec, toward: Toward) -> None:
        self.toward = toward
        self._codec = codec
        self._held = b""

    @property
    def pending(self) -> int:
        """How many bytes wait for the rest of their packet; the caller flushes after silence (6.1: 100 ms)."""
        return len(self._held)

    def feed(self, data: bytes) -> list[Frame | Garbled]:
        """Take bytes as they arrive and return what they complete, in order."""
        return [item.frame if isinstance(item, Cut) else item for item in self.cut(data)]

    def flush(self) -> list[Frame | Garbled]:
        """Give up waiting, since the line is idle: return what the pending bytes hold behind their broken head."""
        return [item.frame if isinstance(item, Cut) else item for item in self.cut(b"", idle=True)]

    def cut(self, data: bytes, *, idle: bool = False) -> list[Cut | Garbled]:
        """Return the same as ``feed``, or with ``idle`` as ``flush``, each packet with its bytes."""
        return list(self._cut(self._held + bytes(data), idle=idle))

    def _cut(self, data: bytes, *, idle: bool) -> Iterator[Cut | Garbled]:
        at, good = 0, 0
        fault: _Bad | None = None
        while at < len(data):
            found = self._candidate(data, at)
            if found is None:
                if not idle:
                    break
                found = _Bad(Reason.TRUNCATED, f"{len(data) - at} bytes of a packet, then silence")
            if isinstance(found, _Bad):
                if fault is None or (fault.reason is Reason.NOISE and found.reason is not Reason.NOISE):
                    fault = found
                at += found.drop
                continue
            if fault is not None:
                yield Garbled(fault.reason, fault.detail, at - good)
                fault = None
            yield found
            at = good = at + len(found.data)
        if fault is not None:
            yield Garbled(fault.reason, fault.detail, at - good)
        self._held = data[at:]

    def _candidate(self, data: bytes, at: int) -> Cut | _Bad | None:
        """Return the packet at an offset, or what is wrong with it, or None if more bytes must come first."""
        if data[at] != STX:
            start = data.find(STX, at)
            return _Bad(Reason.NOISE, f"byte {data[at]:02X} starts no packet", (len(data) if start < 0 else start) - at)
        if at + 1 == len(data):
            return None
        length, dialect = data[at + 1], self._codec.dialect
        if not 1 <= length <= dialect.max_len:
            return _Bad(Reason.LENGTH, f"LEN {length} is not from 1 to {dialect.max_len}")
        packet = data[at : at + length + AROUND_LEN]
        if len(packet) < length + AROUND_LEN:
            return None
        if packet[-1] != ETX:
            return _Bad(Reason.ETX, f"byte {packet[-1]:02X} stands in the place of ETX")
        expected, got = crc_of(packet, dialect.crc_from, dialect.crc_order), packet[-TAIL_SIZE:-1]
        if got != expected:
            return _Bad(Reason.CRC, f"CRC bytes {got.hex().upper()}, expected {expected.hex().upper()}")
        return Cut(self._codec.decode(packet, self.toward), packet)
