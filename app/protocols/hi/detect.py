"""Which form of BCC a drive uses, found from packets captured at commissioning (PROTOCOLS 6.4, H1).

Offline only: a live line never changes its dialect by itself.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace

from app.protocols.hi.dialects import DEFAULT, DIALECTS, Bcc, Dialect
from app.protocols.hi.framing import Decoder, Garbled


def preset_of(form: Bcc) -> str:
    """Return the preset that differs from the default in this form of BCC alone."""
    return next(name for name, dialect in DIALECTS.items() if dialect == Dialect(bcc=form))


def surviving(packets: Iterable[bytes], dialect: Dialect = DEFAULT) -> list[Bcc]:
    """Return the forms under which each is exactly one packet. No packets prove nothing."""
    all_packets = list(packets)
    if not all_packets:
        return []
    return [form for form in Bcc if all(_is_packet(packet, replace(dialect, bcc=form)) for packet in all_packets)]


def _is_packet(packet: bytes, dialect: Dialect) -> bool:
    items = Decoder(dialect).feed(packet)
    return len(items) == 1 and not isinstance(items[0], Garbled)


@dataclass(frozen=True, slots=True)
class Fit:
    """How much of a stream one form makes sense of: whole packets, their bytes, and the bytes left over."""

    form: Bcc
    frames: int
    covered: int
    dropped: int


def fits_of_stream(data: bytes, dialect: Dialect = DEFAULT) -> list[Fit]:
    """Return, best first, the forms under which at least one packet is found in a stream that may hold noise."""
    fits = []
    for form in Bcc:
        decoder = Decoder(replace(dialect, bcc=form))
        items = [*decoder.feed(data), *decoder.flush()]
        dropped = sum(item.dropped for item in items if isinstance(item, Garbled))
        frames = sum(not isinstance(item, Garbled) for item in items)
        if frames:
            fits.append(Fit(form, frames, len(data) - dropped, dropped))
    order = list(Bcc)
    return sorted(fits, key=lambda fit: (-fit.covered, order.index(fit.form)))
