"""Which CRC a device uses, found from packets captured at commissioning (PROTOCOLS 6.4).

Offline only: a live link never changes its dialect by itself.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import product

from app.protocols.itsc.codec import CRC_SIZE, HEAD_SIZE, SHORT_SIZE, Codec
from app.protocols.itsc.dialects import DEFAULT, DIALECTS, Dialect, EtbLayout, Order
from app.protocols.itsc.framing import Decoder, Garbled
from app.protocols.itsc.messages import Toward, Type
from app.wire.crc import NAMED, CrcFunction

_ORDERS: tuple[Order, Order] = ("big", "little")
_FUNCTIONS = {name: crc.function() for name, crc in NAMED.items()}


@dataclass(frozen=True, slots=True)
class Variant:
    """One way to compute, cover and send the CRC. ``order`` is that of the two CRC bytes."""

    crc: str
    covers_type: bool
    order: Order

    @property
    def coverage(self) -> str:
        """The first field that the CRC covers."""
        return "type" if self.covers_type else "dev_id"

    @property
    def preset(self) -> str | None:
        """The preset that differs from the default in no more than this, if there is one."""
        wanted = self.on(DEFAULT)
        return next((name for name, dialect in DIALECTS.items() if dialect == wanted), None)

    def on(self, dialect: Dialect) -> Dialect:
        """Return the dialect with this CRC."""
        return replace(dialect, crc=self.crc, crc_covers_type=self.covers_type, crc_order=self.order)

    def fits(self, covered: bytes, sent: bytes) -> bool:
        """Return whether two bytes are the CRC of what stands before them, TYPE included."""
        function: CrcFunction = _FUNCTIONS[self.crc]
        return function(covered if self.covers_type else covered[1:]) == int.from_bytes(sent, self.order)


VARIANTS = tuple(Variant(crc, covers, order) for crc, covers, order in product(NAMED, (True, False), _ORDERS))
"""The 24 combinations of six CRCs, two coverages and two orders."""


def surviving(packets: Iterable[bytes], dialect: Dialect = DEFAULT) -> list[Variant]:
    """Return the variants under which every packet's CRC fits.

    Takes whole packets: ACK, NAK and ENQ as they are, of an ETB its header (where the dialect's header has a CRC) or else
    the whole. A wrong variant survives a packet with probability 2^-16. Packets of no known size fit nothing.
    """
    pairs = [_checked(packet, dialect) for packet in packets]
    if not pairs:
        return []
    return [variant for variant in VARIANTS if all(pair and variant.fits(*pair) for pair in pairs)]


def _checked(packet: bytes, dialect: Dialect) -> tuple[bytes, bytes] | None:
    """Return what a packet's first CRC covers, TYPE included, and the CRC's bytes."""
    kind = packet[0] if packet else None
    if kind in (Type.ACK, Type.NAK):
        end = SHORT_SIZE - CRC_SIZE
        whole = len(packet) == SHORT_SIZE
    elif kind == Type.ENQ:
        end = HEAD_SIZE
        whole = len(packet) == HEAD_SIZE + CRC_SIZE
    elif kind == Type.ETB and dialect.etb is EtbLayout.HEAD_SUB_CRC:
        end = len(packet) - CRC_SIZE
        whole = end >= HEAD_SIZE
    elif kind == Type.ETB:
        end = HEAD_SIZE
        whole = len(packet) >= HEAD_SIZE + CRC_SIZE
    else:
        return None
    return (packet[:end], packet[end : end + CRC_SIZE]) if whole else None


@dataclass(frozen=True, slots=True)
class Fit:
    """How much of a stream one variant makes sense of: whole frames, their bytes, and the bytes left over."""

    variant: Variant
    frames: int
    covered: int
    dropped: int


def fits_of_stream(data: bytes, dialect: Dialect = DEFAULT) -> list[Fit]:
    """Return, best first, the variants under which at least one frame is found in a stream that may hold noise."""
    fits = []
    for variant in VARIANTS:
        decoder = Decoder(Codec(variant.on(dialect)), Toward.CONTROLLER)
        items: Sequence[object] = [*decoder.feed(data), *decoder.flush()]
        dropped = sum(item.dropped for item in items if isinstance(item, Garbled))
        frames = sum(not isinstance(item, Garbled) for item in items)
        if frames:
            fits.append(Fit(variant, frames, len(data) - dropped, dropped))
    return sorted(fits, key=lambda fit: (-fit.covered, VARIANTS.index(fit.variant)))
