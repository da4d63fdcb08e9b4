"""The stream of bytes cut into iTSC packets (PROTOCOLS 1.3, 6.3).

The head-candidate rule: wait until the packet that seems to stand at the head is complete; a valid one is delivered, of
an invalid one the first byte is dropped (of an ETB with a sound header and a broken sub packet the 33 header bytes), and
the search goes on behind it. There is no look-ahead past an incomplete candidate.
"""

import re
import struct
from binascii import crc_hqx
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache

from app.protocols.itsc.codec import CRC_SIZE, DATA_SIZE, HEAD_SIZE, SHORT_SIZE, Codec
from app.protocols.itsc.dialects import EtbLayout
from app.protocols.itsc.messages import Ack, Code, Enq, Etb, Frame, Nak, Raw, Resp2, Toward
from app.protocols.itsc.status import KNOWN_STATUS, KNOWN_STATUS1, KNOWN_STATUS2, status1, status2, statuses

_ENQ_SIZE = HEAD_SIZE + CRC_SIZE
_DATA_AT = HEAD_SIZE - DATA_SIZE
_ENQ, _ACK, _NAK, _ETB = 0x05, 0x06, 0x15, 0x17
_STATUS = int(Code.STATUS)
_START = re.compile(rb"[\x05\x06\x15\x17]")


class Reason(StrEnum):
    """Why bytes were dropped."""

    NOISE = "noise"
    CRC = "crc"
    LENGTH = "length"
    TRUNCATED = "truncated"


@dataclass(slots=True)
class Garbled:
    """A run of bytes that were no packet: what was wrong first in it, in words too, and how many were dropped."""

    reason: Reason
    detail: str
    dropped: int


@dataclass(slots=True)
class _Bad:
    """A candidate that is no packet, and how many of its bytes to drop."""

    reason: Reason
    detail: str
    drop: int = 1


Buffer = bytes | bytearray | memoryview
EnqReader = Callable[[bytes, int], Enq | None]
WholeReader = Callable[[Buffer], Enq | None]
EtbReader = Callable[[bytes, int, int, int], Etb]
Candidate = tuple[Frame, int] | _Bad | int
"""A frame and its size; or what is wrong; or how many bytes must be there before more can be said."""


class Decoder:
    """Cuts one direction of one link into frames. No sequence of bytes makes it raise.

    Holds at most one incomplete packet, whose size ``max_sub`` bounds. A frame's size on the wire is fixed by its kind.
    """

    __slots__ = (
        "_checksum",
        "_codec",
        "_held",
        "_need",
        "_read_enq",
        "_read_etb",
        "_read_whole",
        "_start",
        "_structs",
        "toward",
    )

    def __init__(self, codec: Codec, toward: Toward) -> None:
        self.toward = toward
        self._codec = codec
        self._held = b""
        self._need = 0
        self._start = 0 if codec.dialect.crc_covers_type else 1
        self._checksum = codec.checksum
        self._structs, self._read_enq, self._read_whole, self._read_etb = _readers(codec, toward)

    @property
    def pending(self) -> int:
        """How many bytes wait for the rest of their packet; the caller flushes after silence (6.1: 200 ms)."""
        return len(self._held)

    def feed(self, data: Buffer) -> list[Frame | Garbled]:
        """Take bytes as they arrive and return what they complete, in order."""
        held = self._held
        if held:
            self._held = held = held + data
            if len(held) < self._need:
                return []
            return self._cut(held, idle=False)
        if len(data) == _ENQ_SIZE and (frame := self._read_whole(data)) is not None:
            return [frame]
        return self._cut(bytes(data), idle=False)

    def flush(self) -> list[Frame | Garbled]:
        """Give up waiting, since the line is idle: return what the pending bytes hold behind their broken head."""
        return self._cut(self._held, idle=True)

    def _cut(self, data: bytes, *, idle: bool) -> list[Frame | Garbled]:
        out: list[Frame | Garbled] = []
        at, end, good = 0, len(data), 0
        fault: _Bad | None = None
        self._need = 0
        while at < end:
            found = self._candidate(data, at, end)
            if isinstance(found, int):
                if not idle:
                    self._need = found
                    break
                found = _Bad(Reason.TRUNCATED, f"{end - at} of {found} bytes, then silence")
            if isinstance(found, _Bad):
                if fault is None or (fault.reason is Reason.NOISE and found.reason is not Reason.NOISE):
                    fault = found
                at += found.drop
                continue
            if fault is not None:
                out.append(Garbled(fault.reason, fault.detail, at - good))
                fault = None
            frame, size = found
            out.append(frame)
            at = good = at + size
        if fault is not None:
            out.append(Garbled(fault.reason, fault.detail, at - good))
        self._held = data[at:]
        return out

    def _candidate(self, data: bytes, at: int, end: int) -> Candidate:
        kind = data[at]
        if kind == _ETB:
            return self._etb(data, at, end)
        if kind == _ENQ:
            if end - at < _ENQ_SIZE:
                return _ENQ_SIZE
            enq = self._read_enq(data, at)
            return self._bad_crc("ENQ", data, at, HEAD_SIZE) if enq is None else (enq, _ENQ_SIZE)
        if kind in (_ACK, _NAK):
            return self._short(data, at, end)
        start = _START.search(data, at)
        return _Bad(Reason.NOISE, f"byte {kind:02X} starts no packet", (start.start() if start else end) - at)

    def _short(self, data: bytes, at: int, end: int) -> Candidate:
        if end - at < SHORT_SIZE:
            return SHORT_SIZE
        dev_id, cmd_id, crc = self._structs.short.unpack_from(data, at)
        if crc != self._checksum(data[at + self._start : at + SHORT_SIZE - CRC_SIZE]):
            return self._bad_crc("ACK" if data[at] == _ACK else "NAK", data, at, SHORT_SIZE - CRC_SIZE)
        return (Ack if data[at] == _ACK else Nak)(dev_id, cmd_id), SHORT_SIZE

    def _etb(self, data: bytes, at: int, end: int) -> Candidate:
        if end - at < _ENQ_SIZE:
            return _ENQ_SIZE
        layout = self._codec.dialect.etb
        checked_head = layout is not EtbLayout.HEAD_SUB_CRC
        if checked_head and not self._fits(data, at + self._start, at + HEAD_SIZE):
            return self._bad_crc("ETB header", data, at, HEAD_SIZE)
        length: int
        (length,) = self._structs.length.unpack_from(data, at)
        if length > self._codec.dialect.max_sub:
            return _Bad(Reason.LENGTH, f"LENGTH {length} is more than {self._codec.dialect.max_sub}")
        sub = at + HEAD_SIZE + (CRC_SIZE if checked_head else 0)
        size = sub + length + (0 if layout is EtbLayout.HEAD_CRC_SUB else CRC_SIZE) - at
        if end - at < size:
            return size
        if layout is EtbLayout.HEAD_CRC_SUB_CRC and not self._fits(data, sub, sub + length):
            return self._bad_crc("sub packet", data, sub, length, start=0, drop=_ENQ_SIZE)
        if not checked_head and not self._fits(data, at + self._start, sub + length):
            return self._bad_crc("ETB", data, at, HEAD_SIZE + length)
        return self._read_etb(data, at, sub, length), size

    def _fits(self, data: bytes, start: int, stop: int) -> bool:
        (crc,) = self._structs.crc.unpack_from(data, stop)
        return bool(crc == self._checksum(data[start:stop]))

    def _bad_crc(self, what: str, data: bytes, at: int, size: int, *, start: int | None = None, drop: int = 1) -> _Bad:
        expected = self._checksum(data[at + (self._start if start is None else start) : at + size])
        (got,) = self._structs.crc.unpack_from(data, at + size)
        return _Bad(Reason.CRC, f"{what}: CRC {got:04X}, expected {expected:04X}", drop)


@dataclass(slots=True)
class _Structs:
    """The places of the numbers that framing needs, in one dialect's byte order."""

    short: struct.Struct
    length: struct.Struct
    crc: struct.Struct

    @classmethod
    def of(cls, codec: Codec) -> "_Structs":
        prefix = _prefix(codec)
        return cls(*(struct.Struct(prefix + code) for code in ("xIQH", f"{_DATA_AT}xI", "H")))


@lru_cache(maxsize=512)
def _readers(codec: Codec, toward: Toward) -> "tuple[_Structs, EnqReader, WholeReader, EtbReader]":
    """Return what reads a codec's packets: the same for all links of one direction, since each would take kilobytes."""
    read_enq = _enq_reader(codec, toward)
    return _Structs.of(codec), read_enq, _whole_reader(codec, toward, read_enq), _etb_reader(codec)


def _prefix(codec: Codec) -> str:
    return ">" if codec.dialect.byte_order == "big" else "<"


def _enq_reader(codec: Codec, toward: Toward) -> EnqReader:
    """Return what reads 33 bytes at an offset as an ENQ, or gives None if the CRC does not fit: the hot path."""
    dialect = codec.dialect
    if toward is Toward.CONTROLLER and dialect.barcode_format == "uint" and not dialect.has_dist:
        return _enq_reader_of_status(codec)
    unpack = struct.Struct(_prefix(codec) + "xIQH16xH").unpack_from
    bodies = codec.body_readers(toward)
    checksum = codec.checksum
    start = 0 if codec.dialect.crc_covers_type else 1

    def read(data: bytes, at: int) -> Enq | None:
        dev_id, cmd_id, code, crc = unpack(data, at)
        if crc != checksum(data[at + start : at + HEAD_SIZE]):
            return None
        body = bodies.get(code, _raw)
        return Enq(dev_id, cmd_id, code, body(data, at + _DATA_AT))

    return read


def _enq_reader_of_status(codec: Codec) -> EnqReader:
    """Return the same for a controller whose RESP2 has a six-byte number: one ``unpack``, since it reads little else."""
    swap = codec.dialect.byte_order == "little"
    unpack = struct.Struct(_prefix(codec) + ("xIQHIIIHHH" if swap else "xIQHIIHIHH")).unpack_from
    bodies = codec.body_readers(Toward.CONTROLLER)
    checksum = codec.checksum
    start = 0 if codec.dialect.crc_covers_type else 1

    def read(data: bytes, at: int) -> Enq | None:
        dev_id, cmd_id, code, word1, word2, high, low, seq, crc = unpack(data, at)
        if crc != checksum(data[at + start : at + HEAD_SIZE]):
            return None
        if code != _STATUS:
            return Enq(dev_id, cmd_id, code, bodies.get(code, _raw)(data, at + _DATA_AT))
        if swap:
            high, low = low, high
        state = Resp2(
            KNOWN_STATUS1.get(word1) or status1(word1),
            KNOWN_STATUS2.get(word2) or status2(word2),
            high << 32 | low,
            seq,
        )
        return Enq(dev_id, cmd_id, code, state)

    return read


def _whole_reader(codec: Codec, toward: Toward, read_enq: EnqReader) -> WholeReader:
    """Return the same for exactly 33 bytes, None if they are no ENQ: for a STATUS what takes the least time."""
    dialect, crc = codec.dialect, codec.dialect.crc_parameters
    plain = crc.poly == 0x1021 and not crc.refin and not crc.refout and not crc.xorout and dialect.crc_covers_type
    big = dialect.byte_order == dialect.crc_order == "big"
    if not (plain and big and toward is Toward.CONTROLLER and dialect.barcode_format == "uint") or dialect.has_dist:
        return lambda data: read_enq(bytes(data), 0) if data[0] == _ENQ else None
    unpack, init = struct.Struct(">BIQHQQ2x").unpack, crc.init
    bodies, known, both, new = codec.body_readers(toward), KNOWN_STATUS, statuses, object.__new__

    def read(data: Buffer) -> Enq | None:
        # The CRC over a packet and its own CRC is 0.
        if crc_hqx(data, init):
            return None
        kind, dev_id, cmd_id, code, words, place = unpack(data)
        if kind != 0x05:
            return None
        if code != 0x7030:
            return Enq(dev_id, cmd_id, code, bodies.get(code, _raw)(bytes(data), _DATA_AT))
        try:
            axes, state = known[words]
        except KeyError:
            axes, state = both(words)
        # Attribute by attribute, since calling a class that has an __init__ in Python takes twice the time of that.
        body, frame = new(Resp2), new(Enq)
        body.status1, body.status2 = axes, state
        body.barcode, body.seq, body.dist = place >> 16, place & 0xFFFF, None
        frame.dev_id, frame.cmd_id = dev_id, cmd_id
        frame.code, frame.body = code, body
        return frame

    return read


def _raw(data: bytes, at: int) -> Raw:
    return Raw(data[at : at + DATA_SIZE])


def _etb_reader(codec: Codec) -> EtbReader:
    """Return what reads an ETB, given its offset, that of its sub data, and LENGTH; the CRCs are already checked."""
    unpack = struct.Struct(_prefix(codec) + "xIQH").unpack_from
    subs = codec.sub_readers()

    def read(data: bytes, at: int, sub: int, length: int) -> Etb:
        dev_id, cmd_id, code = unpack(data, at)
        head = data[at + _DATA_AT : at + HEAD_SIZE]
        reader = subs.get(code)
        body = Raw(head, data[sub : sub + length]) if reader is None else reader(data, sub, length, head)
        return Etb(dev_id, cmd_id, code, body)

    return read
