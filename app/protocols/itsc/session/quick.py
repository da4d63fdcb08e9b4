"""The quick way for the packet that comes most: a STATUS event in one piece (PROTOCOLS 1.10).

What it costs is memory touched as much as instructions: a thousand sessions take turns, so that whatever one of them keeps from
event to event is out of the cache when the next event comes, and worst is letting go of an object kept 64 events ago. Therefore
the events of the quick way are remembered as bytes in a ring, not as objects, and numbers that are stored stay below 257, of
which the interpreter keeps one object each.
"""

import struct
from binascii import crc_hqx
from collections.abc import Callable, Iterator
from functools import lru_cache

from app.domain.units import Millimetres, Seconds
from app.domain.vehicle import VehicleStatus
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.condition import KNOWN_BARCODES, KNOWN_CONDITIONS, barcode_text, condition_of
from app.protocols.itsc.dialects import Dialect

ENQ_SIZE = 33
ID_AT = 5
"""Where CMD_ID begins."""
CODE_AT = 13
BODY_AT = 15
"""Where DATA1 begins, and with it the two status words."""
BODY_END = 31

RING_KEPT = 64
"""So many events of the quick way are remembered, as duplicates (I23) and for the vehicle's panel."""

NOTHING_BELOW = b""
"""What no packet is below, as bytes are compared."""
ABOVE_ALL_IDS = b"\xff" * 9
"""What follows a vehicle's prefix in bytes that are above all its packets."""

_CCITT = 0x1021
_STATUS = 0x7030
_STATUS_CODE = _STATUS.to_bytes(2, "big")
_LONG = struct.Struct(">HQHIH").unpack
_SHORT = struct.Struct(">HQIHH").unpack
_ENTRY = struct.Struct("<d8s16s")
_made = tuple.__new__
pack_ack = struct.Struct(">B12sH").pack
"""Pack an ACK: 6, both ids as they came, CRC."""

write_entry = _ENTRY.pack_into
"""Write (buffer, offset, when, CMD_ID, data) at the place of an entry of a ring."""
ENTRY_SIZE = _ENTRY.size
RING_SIZE = RING_KEPT * ENTRY_SIZE


@lru_cache(maxsize=256)
def codec_of(dialect: Dialect) -> Codec:
    """Return the codec of a dialect, one for all vehicles that speak it."""
    return Codec(dialect)


def quick_crc(dialect: Dialect) -> int | None:
    """Return the initial value with which ``crc_hqx`` over a whole sound packet gives 0; None: no quick way here.

    There is one for polynomial 0x1021, high byte first, over the whole packet, with big-endian numeric barcodes.
    """
    crc = dialect.crc_parameters
    plain = crc.poly == _CCITT and not crc.refin and not crc.refout and not crc.xorout
    order = dialect.byte_order == dialect.crc_order == "big" and dialect.crc_covers_type
    return crc.init if plain and order and dialect.barcode_format == "uint" and dialect.ack_answers else None


def new_ring() -> bytearray:
    """Return a ring that remembers nothing: entry n stands at n * ENTRY_SIZE modulo its size."""
    return bytearray(RING_SIZE)


def content_of(packet: bytes) -> bytes:
    """Return what tells a STATUS from all others of its vehicle, CMD_ID and data; empty for any other packet."""
    return packet[ID_AT:CODE_AT] + packet[BODY_AT:BODY_END] if packet[CODE_AT:BODY_AT] == _STATUS_CODE else b""


def entries(ring: bytearray, count: int, most: int) -> Iterator[tuple[int, Seconds, bytes]]:
    """Give number, moment and ``content_of`` of the newest entries of a ring, oldest first; ``count`` have been written to it."""
    for number in range(max(count - min(most, RING_KEPT), 0), count):
        when, ids, data = _ENTRY.unpack_from(ring, number * ENTRY_SIZE % RING_SIZE)
        yield number, Seconds(when), ids + data


def packet_of(prefix: bytes, content: bytes, init: int) -> bytes:
    """Return the whole STATUS with this ``content_of``; ``prefix`` is what stands before CMD_ID."""
    packet = prefix + content[:8] + _STATUS_CODE + content[8:]
    return packet + crc_hqx(packet, init).to_bytes(2, "big")


def ack_crc(init: int) -> int:
    """Return where the CRC of an ACK stands after its first byte."""
    return crc_hqx(b"\x06", init)


def ack_of(event: bytes, after_first: int) -> bytes:
    """Return the ACK of an event; ``after_first`` is ``ack_crc`` of the dialect."""
    ids = event[1:13]
    return pack_ack(6, ids, crc_hqx(ids, after_first))


StatusReader = Callable[[bytes], VehicleStatus | None]


def status_reader(dialect: Dialect) -> StatusReader:
    """Return what reads a packet's code and data (18 bytes) in a dialect with the quick way; None if they are no STATUS."""
    return _read_short if dialect.has_dist else _read_long


def _read_long(body: bytes) -> VehicleStatus | None:
    code, words, high, low, seq = _LONG(body)
    if code != _STATUS:
        return None
    barcode = high << 32 | low
    known = KNOWN_CONDITIONS.get(words) or condition_of(words)
    return _made(VehicleStatus, (known, KNOWN_BARCODES.get(barcode) or barcode_text(barcode), seq, None))


def _read_short(body: bytes) -> VehicleStatus | None:
    code, words, barcode, seq, dist = _SHORT(body)
    if code != _STATUS:
        return None
    known = KNOWN_CONDITIONS.get(words) or condition_of(words)
    return _made(VehicleStatus, (known, KNOWN_BARCODES.get(barcode) or barcode_text(barcode), seq, Millimetres(dist)))
