"""The quick way for the packet that comes most: a STATUS event in one piece (PROTOCOLS 1.10)."""

import struct
from collections.abc import Callable
from functools import lru_cache

from app.domain.units import Millimetres
from app.domain.vehicle import VehicleStatus
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.condition import barcode_text, condition_of
from app.protocols.itsc.dialects import Dialect

ENQ_SIZE = 33
BODY_AT = 15
"""Where DATA1 begins, and with it the two status words."""
BODY_END = 31

_CCITT = 0x1021
_LONG = struct.Struct(">QHIH").unpack_from
_SHORT = struct.Struct(">QIHH").unpack_from


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


def status_reader(dialect: Dialect) -> Callable[[bytes], VehicleStatus]:
    """Return what reads the STATUS of a whole packet of a dialect with the quick way."""
    return _read_short if dialect.has_dist else _read_long


def _read_long(event: bytes) -> VehicleStatus:
    words, high, low, seq = _LONG(event, BODY_AT)
    return VehicleStatus(condition_of(words), barcode_text(high << 32 | low), seq)


def _read_short(event: bytes) -> VehicleStatus:
    words, barcode, seq, dist = _SHORT(event, BODY_AT)
    return VehicleStatus(condition_of(words), barcode_text(barcode), seq, Millimetres(dist))
