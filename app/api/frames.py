"""The last bytes of a vehicle's line, explained."""

from collections.abc import Iterable
from typing import Literal

from app.domain.layout import Plant, VehicleKind, VehicleSpec
from app.domain.units import Timestamp
from app.plant.dialects import dialect_of, hall_dialect_of
from app.protocols.enig import codec as enig
from app.protocols.enig import messages as hall
from app.protocols.enig.explain import frame_rows as hall_rows
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.explain import Row, frame_rows, garbled_row
from app.protocols.itsc.framing import Decoder, Garbled
from app.protocols.itsc.messages import Toward
from app.runtime.showing import iso

_HALL_TOWARD = {"in": hall.Toward.HOST, "out": hall.Toward.DEVICE}
_TOWARD = {"in": Toward.CONTROLLER, "out": Toward.VEHICLE}


def explained(
    plant: Plant,
    vehicle: VehicleSpec,
    frames: Iterable[tuple[Timestamp, str, bytes]],
    language: Literal["en", "ko"] = "en",
) -> list[dict[str, object]]:
    """Return each piece of traffic with its moment, bytes and every field by name."""
    if vehicle.kind is VehicleKind.AGV:
        return _explained_hall(plant, vehicle, frames, language)
    codec = Codec(dialect_of(plant, vehicle.dialect))
    return [
        {
            "at": iso(at),
            "direction": direction,
            "hex": data.hex(),
            "frames": _read(codec, _TOWARD[direction], data, language),
        }
        for at, direction, data in frames
    ]


def _explained_hall(
    plant: Plant, vehicle: VehicleSpec, frames: Iterable[tuple[Timestamp, str, bytes]], language: Literal["en", "ko"]
) -> list[dict[str, object]]:
    """Explain the packets on an AGV's link that are from it or to it; the others on the link are not its own."""
    link = next(link for link in plant.links if link.id == vehicle.link)
    codec = enig.Codec(hall_dialect_of(link))
    shown: list[dict[str, object]] = []
    for at, direction, data in frames:
        toward = _HALL_TOWARD[direction]
        frame = codec.decode(data, toward)
        if frame.device == vehicle.dev_id:
            rows = [
                {"name": row.name, "value": row.value, "meaning": row.meaning, "depth": 0}
                for row in hall_rows(frame, codec, toward, language)
            ]
            read = [{"kind": str(frame.body.name or "raw").lower(), "fields": rows}]
            shown.append({"at": iso(at), "direction": direction, "hex": data.hex(), "frames": read})
    return shown


def _read(codec: Codec, toward: Toward, data: bytes, language: Literal["en", "ko"]) -> list[dict[str, object]]:
    decoder = Decoder(codec, toward)
    return [
        {"kind": "garbled", "fields": [_row(garbled_row(item, language))]}
        if isinstance(item, Garbled)
        else {"kind": type(item).__name__.lower(), "fields": [_row(row) for row in frame_rows(item, codec, language)]}
        for item in decoder.feed(data) + decoder.flush()
    ]


def _row(row: Row) -> dict[str, object]:
    return {"name": row.name, "value": row.value, "meaning": row.meaning, "depth": row.depth}
