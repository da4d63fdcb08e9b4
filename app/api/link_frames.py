"""The last bytes of a line that carries several devices, explained."""

from collections.abc import Iterable, Iterator
from typing import Literal

from app.domain.layout import LinkSpec, Wire
from app.domain.units import Timestamp
from app.plant.dialects import drive_dialect_of, hall_dialect_of
from app.protocols.enig import explain as enig
from app.protocols.hi import explain as hi
from app.protocols.hi.framing import Garbled
from app.runtime.showing import iso

Language = Literal["en", "ko"]


def frames_of_link(
    link: LinkSpec, frames: Iterable[tuple[Timestamp, str, bytes]], language: Language = "en"
) -> list[dict[str, object]]:
    """Return each piece of traffic with its moment, bytes and every field by name."""
    read = _drives if link.wire is Wire.HI else _hall
    return [
        {"at": iso(at), "direction": direction, "hex": data.hex(), "frames": list(read(link, data, language))}
        for at, direction, data in frames
    ]


def _drives(link: LinkSpec, data: bytes, language: Language) -> Iterator[dict[str, object]]:
    for piece in hi.explain(data, drive_dialect_of(link), language).pieces:
        kind = "garbled" if isinstance(piece.found, Garbled) else piece.found.cmd
        yield {"kind": kind, "fields": [_field(row) for row in piece.rows]}


def _hall(link: LinkSpec, data: bytes, language: Language) -> Iterator[dict[str, object]]:
    for piece in enig.explain(data, hall_dialect_of(link), language).pieces:
        if piece.garbled is not None:
            reason = {"name": "", "value": piece.garbled.reason.value, "meaning": piece.garbled.detail, "depth": 0}
            yield {"kind": "garbled", "fields": [reason]}
        for reading in piece.readings:
            yield {"kind": f"toward {reading.toward.name.lower()}", "fields": [_field(row) for row in reading.rows]}


def _field(row: hi.Row | enig.Row) -> dict[str, object]:
    return {"name": row.name, "value": row.value, "meaning": row.meaning, "depth": 0}
