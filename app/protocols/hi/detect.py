"""Which form of BCC a drive uses, found from packets captured at commissioning (PROTOCOLS 6.4, H1).

Offline only: a live line never changes its dialect by itself.
"""

from collections.abc import Iterable, Sequence
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


def detected(packets: Sequence[bytes]) -> tuple[str, bool]:
    """Return what there is to say of a capture, one packet in each piece or a stream cut anywhere, and whether any form fits."""
    survivors = surviving(packets)
    if survivors:
        said = [f"{len(packets)} packets, {len(Bcc)} forms of BCC tried, {len(survivors)} left:"]
        said += [f"  bcc {form.value}  (dialect {preset_of(form)})" for form in survivors]
        if len(survivors) > 1:
            said.append("more than one is left: capture more packets")
        return "\n".join(said), True
    stream = b"".join(packets)
    fits = fits_of_stream(stream)
    if not fits:
        return f"none of the {len(Bcc)} forms of BCC fits: not HI, or another sum", False
    said = [f"the lines are not one whole packet each that fits; read as a stream of {len(stream)} bytes:"]
    for fit in fits:
        preset = preset_of(fit.form)
        said.append(
            f"  bcc {fit.form.value}  (dialect {preset}): "
            f"{fit.frames} packets, {fit.covered} bytes fit, {fit.dropped} do not"
        )
    return "\n".join(said), True
