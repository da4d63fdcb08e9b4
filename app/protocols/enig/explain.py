"""Packets explained for people: every field by name, and for bytes that are no packet the reason."""

import json as jsonlib
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any

from app.protocols.enig import wording
from app.protocols.enig.codec import HEAD_SIZE, TAIL_SIZE, Codec
from app.protocols.enig.detect import fits_of_stream
from app.protocols.enig.dialects import ACS, PREFIX, Dialect, dialect_named
from app.protocols.enig.framing import Cut, Decoder, Garbled
from app.protocols.enig.messages import Frame, Raw, Toward
from app.protocols.enig.plain import to_plain
from app.protocols.enig.wording import Language, said
from app.wire.hextext import show_hex


@dataclass(frozen=True, slots=True)
class Row:
    """One line of an explanation: the field's name in the specification, its value, and what it means."""

    name: str
    value: str
    meaning: str = ""


@dataclass(frozen=True, slots=True)
class Reading:
    """A packet read as going one way."""

    toward: Toward
    frame: Frame
    rows: tuple[Row, ...]


@dataclass(frozen=True, slots=True)
class Piece:
    """A stretch of the bytes: a packet with one reading, or two if either way makes sense; or rubbish."""

    offset: int
    data: bytes
    readings: tuple[Reading, ...] = ()
    garbled: Garbled | None = None


@dataclass(frozen=True, slots=True)
class Explanation:
    """All pieces of some bytes in order, and hints on what else they could be."""

    pieces: tuple[Piece, ...]
    hints: tuple[str, ...]


def explain(data: bytes, dialect: Dialect, language: Language = "en") -> Explanation:
    """Return what the bytes say in a dialect; every byte belongs to one piece. Never fails on content."""
    codec = Codec(dialect)
    decoder = Decoder(codec, Toward.DEVICE)
    pieces = []
    offset = 0
    for item in [*decoder.cut(data), *decoder.cut(b"", idle=True)]:
        size = item.dropped if isinstance(item, Garbled) else len(item.data)
        cut = data[offset : offset + size]
        if isinstance(item, Garbled):
            pieces.append(Piece(offset, cut, garbled=item))
        else:
            pieces.append(Piece(offset, cut, tuple(_readings(item, codec, language))))
        offset += size
    return Explanation(tuple(pieces), tuple(_hints(data, dialect, pieces, language)))


def _readings(item: Cut, codec: Codec, language: Language) -> Iterator[Reading]:
    """Give the ways in which a packet is sound, or all if it is in none."""
    ways = {toward: codec.decode(item.data, toward) for toward in Toward}
    sound = {toward: frame for toward, frame in ways.items() if not codec.problems(frame, toward)}
    known = {toward: frame for toward, frame in ways.items() if codec.message(frame.device, toward, frame.cmd)}
    for toward, frame in (sound or known or ways).items():
        yield Reading(toward, frame, tuple(frame_rows(frame, codec, toward, language)))


def _hints(data: bytes, dialect: Dialect, pieces: list[Piece], language: Language) -> Iterator[str]:
    here = sum(len(piece.data) for piece in pieces if piece.garbled is None)
    for fit in fits_of_stream(data, dialect):
        if fit.covered > here:
            yield said(wording.OTHER_CRC, language).format(name=fit.variant.preset, frames=fit.frames)


def frame_rows(frame: Frame, codec: Codec, toward: Toward, language: Language = "en") -> Iterator[Row]:
    """Give a packet's fields from first to last, then what is wrong with them."""
    yield Row("ID", str(frame.id), _device(frame.id, codec, language))
    row = codec.message(frame.device, toward, frame.cmd)
    if row is None:
        yield Row("CMD", str(frame.cmd), said(wording.UNKNOWN_COMMAND, language))
    else:
        yield Row("CMD", str(frame.cmd), f"{row.name} ({said(wording.NAMES[row.name], language)})")
    if frame.target is not None:
        yield Row("Target", str(frame.target), _device(frame.target, codec, language))
    if isinstance(frame.body, Raw):
        yield Row("DATA", show_hex(frame.body.data))
    else:
        for field in fields(frame.body):
            yield _field_row(frame.body, field.name, getattr(frame.body, field.name), language)
    for problem in codec.problems(frame, toward):
        yield Row("!", problem, said(wording.PROBLEM, language))


def _device(number: int, codec: Codec, language: Language) -> str:
    kind = codec.class_of(number)
    if kind is None:
        return said(wording.HOST if number == ACS else wording.NOBODY, language)
    return said(wording.CLASSES[kind.value], language)


def _field_row(body: object, name: str, value: object, language: Language) -> Row:
    values = wording.VALUES.get((type(body).__name__, name))
    if values is not None and isinstance(value, int):
        return Row(name, str(value), said(values.get(value, wording.UNDEFINED), language))
    return Row(name, repr(value) if isinstance(value, str) else str(value))


def show(data: bytes, dialect: str, language: Language, *, json: bool) -> str:
    """Return the explanation as text, or for a program as JSON. Raises: DialectError: no dialect has this name."""
    chosen = dialect_named(dialect)
    explanation = explain(data, chosen, language)
    if json:
        return jsonlib.dumps(_plain(explanation, Codec(chosen), dialect), ensure_ascii=False, indent=2)
    return "\n".join(_lines(explanation, language))


def _lines(explanation: Explanation, language: Language) -> Iterator[str]:
    for piece in explanation.pieces:
        yield f"@{piece.offset}  {show_hex(piece.data)}"
        if piece.garbled is not None:
            yield f"  {said(wording.GARBLED[piece.garbled.reason.value], language)}: {piece.garbled.detail}"
        for reading in piece.readings:
            yield f"  [{said(wording.DIRECTIONS[reading.toward.value], language)}]"
            for row in reading.rows:
                yield f"    {row.name:<10}  {row.value:<8}  {row.meaning}".rstrip()
        yield ""
    for hint in explanation.hints:
        yield f"* {hint}"


def _plain(explanation: Explanation, codec: Codec, dialect: str) -> dict[str, Any]:
    pieces: list[dict[str, Any]] = []
    for piece in explanation.pieces:
        entry: dict[str, Any] = {"offset": piece.offset, "hex": piece.data.hex()}
        if piece.garbled is not None:
            entry["garbled"] = {"reason": piece.garbled.reason.value, "detail": piece.garbled.detail}
        else:
            data = piece.data[HEAD_SIZE:-TAIL_SIZE]
            entry["readings"] = [
                {
                    "direction": reading.toward.value,
                    "frame": to_plain(reading.frame, data, codec, reading.toward),
                    "rows": [{"name": r.name, "value": r.value, "meaning": r.meaning} for r in reading.rows],
                }
                for reading in piece.readings
            ]
        pieces.append(entry)
    name = dialect.removeprefix(PREFIX)
    return {"protocol": "enig", "dialect": name, "pieces": pieces, "hints": list(explanation.hints)}
