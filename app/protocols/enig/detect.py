"""What ENIG's CRC covers at a site and in which order it is sent, found from captured packets (PROTOCOLS 6.4, E1, E2).

Offline only: a live link never changes its dialect by itself.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import product
from typing import get_args

from app.protocols.enig.codec import AROUND_LEN, ETX, STX, TAIL_SIZE, Codec, crc_of
from app.protocols.enig.dialects import DEFAULT, DIALECTS, CrcFrom, Dialect, Order
from app.protocols.enig.framing import Decoder, Garbled
from app.protocols.enig.messages import Toward


@dataclass(frozen=True, slots=True)
class Variant:
    """One way to cover and send the CRC."""

    crc_from: CrcFrom
    crc_order: Order

    @property
    def preset(self) -> str:
        """The preset that differs from the default in no more than this; there is one for each."""
        wanted = self.on(DEFAULT)
        return next(name for name, dialect in DIALECTS.items() if dialect == wanted)

    def on(self, dialect: Dialect) -> Dialect:
        """Return the dialect with this CRC."""
        return replace(dialect, crc_from=self.crc_from, crc_order=self.crc_order)

    def fits(self, packet: bytes) -> bool:
        """Return whether a whole packet has this CRC."""
        return packet[-TAIL_SIZE:-1] == crc_of(packet, self.crc_from, self.crc_order)


VARIANTS = tuple(Variant(start, order) for start, order in product(CrcFrom, get_args(Order)))
"""The ten combinations of five coverages and two orders."""


def surviving(packets: Iterable[bytes]) -> list[Variant]:
    """Return the variants under which every packet's CRC fits; what is no whole packet fits nothing.

    A wrong variant survives a packet with probability 2^-15; one packet mostly tells, three are proof.
    """
    found = list(packets)
    if not found or not all(map(is_whole, found)):
        return []
    return [variant for variant in VARIANTS if all(map(variant.fits, found))]


def is_whole(packet: bytes) -> bool:
    """Return whether some bytes are one packet from STX to ETX by their LEN."""
    return len(packet) > AROUND_LEN and packet[0] == STX and packet[1] + AROUND_LEN == len(packet) and packet[-1] == ETX


@dataclass(frozen=True, slots=True)
class Fit:
    """How much of a stream one variant makes sense of: whole packets, their bytes, and the bytes left over."""

    variant: Variant
    frames: int
    covered: int
    dropped: int


def fits_of_stream(data: bytes, dialect: Dialect = DEFAULT) -> list[Fit]:
    """Return, best first, the variants under which at least one packet is found in a stream that may hold noise."""
    fits = []
    for variant in VARIANTS:
        decoder = Decoder(Codec(variant.on(dialect)), Toward.HOST)
        items = [*decoder.feed(data), *decoder.flush()]
        dropped = sum(item.dropped for item in items if isinstance(item, Garbled))
        frames = sum(not isinstance(item, Garbled) for item in items)
        if frames:
            fits.append(Fit(variant, frames, len(data) - dropped, dropped))
    return sorted(fits, key=lambda fit: (-fit.covered, VARIANTS.index(fit.variant)))


def detected(packets: list[bytes]) -> tuple[str, bool]:
    """Return what ``hoistway detect`` says of captured packets, or of a stream cut anyhow, and whether any variant fits."""

    def named(variant: Variant) -> str:
        order = "high byte first" if variant.crc_order == "big" else "low byte first"
        return f"crc from {variant.crc_from.value.upper()}, {order}  (dialect {variant.preset})"

    if survivors := surviving(packets):
        lines = [f"{len(packets)} packets, {len(VARIANTS)} variants tried, {len(survivors)} left:"]
        lines += [f"  {named(variant)}" for variant in survivors]
        if len(survivors) > 1:
            lines.append("more than one is left: capture more packets (three are proof)")
        return "\n".join(lines), True
    stream = b"".join(packets)
    fits = fits_of_stream(stream)
    if not fits:
        return f"none of the {len(VARIANTS)} variants fits: not ENIG, or another CRC", False
    lines = [f"the lines are not one whole packet each that fits; read as a stream of {len(stream)} bytes:"]
    for fit in fits:
        lines.append(f"  {named(fit.variant)}: {fit.frames} packets, {fit.covered} bytes fit, {fit.dropped} do not")
    return "\n".join(lines), True
