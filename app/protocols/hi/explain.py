"""HI packets explained for people: every field by its letter, and for bytes that are no packet the reason."""

import json as jsonlib
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any

from app.protocols.hi import wording
from app.protocols.hi.codec import ETB, ETX, encode
from app.protocols.hi.dialects import DIALECTS, PREFIX, Dialect, dialect_named
from app.protocols.hi.framing import Decoder, Garbled
from app.protocols.hi.messages import ALL_DRIVES, Cmd, Content, Frame, Role, Ssa, content_of
from app.protocols.hi.plain import to_plain
from app.protocols.hi.wording import Language, said
from app.wire.hextext import show_hex


@dataclass(frozen=True, slots=True)
class Row:
    """One line of an explanation: the field's letters in the specification, its value, and what it means."""

    name: str
    value: str
    meaning: str = ""


@dataclass(frozen=True, slots=True)
class Piece:
    """A stretch of the bytes: a packet with its rows, or rubbish."""

    offset: int
    data: bytes
    found: Frame | Garbled
    rows: tuple[Row, ...]


@dataclass(frozen=True, slots=True)
class Explanation:
    """All pieces of some bytes in order, and hints on what else they could be."""

    pieces: tuple[Piece, ...]
    hints: tuple[str, ...]


def explain(data: bytes, dialect: Dialect, language: Language = "en") -> Explanation:
    """Return what the bytes say in a dialect; every byte belongs to one piece. Never fails on content."""
    pieces = []
    offset = 0
    for item in _items(data, dialect):
        size = _size(item, dialect)
        cut = data[offset : offset + size]
        rows = _garbled(item, language) if isinstance(item, Garbled) else _frame(item, cut, dialect, language)
        pieces.append(Piece(offset, cut, item, tuple(rows)))
        offset += size
    return Explanation(tuple(pieces), tuple(_other_dialects(data, dialect, language)))


def _items(data: bytes, dialect: Dialect) -> list[Frame | Garbled]:
    decoder = Decoder(dialect)
    return [*decoder.feed(data), *decoder.flush()]


def _size(item: Frame | Garbled, dialect: Dialect) -> int:
    return item.dropped if isinstance(item, Garbled) else len(encode(item, dialect))


def _garbled(garbled: Garbled, language: Language) -> Iterator[Row]:
    yield Row("", said(wording.REASONS[garbled.reason], language), garbled.detail)


def _frame(frame: Frame, data: bytes, dialect: Dialect, language: Language) -> Iterator[Row]:
    yield Row("M/S", frame.role.value, said(wording.MASTER if frame.role is Role.MASTER else wording.SLAVE, language))
    who = said(wording.ALL, language) if frame.id == ALL_DRIVES else f"{said(wording.DRIVE, language)} {frame.id}"
    yield Row("ID", f"{frame.id:X}", who)
    answer = frame.cmd == Cmd.SET and frame.role is Role.SLAVE
    word = wording.PARAMETER if answer else wording.COMMANDS.get(frame.cmd, wording.UNKNOWN_COMMAND)
    yield Row("CCC", frame.cmd, said(word, language))
    content = content_of(frame, dialect)
    if content is None:
        unfit = said(wording.UNFIT, language) if frame.cmd in wording.COMMANDS else ""
        yield from (Row("data", text, unfit) for text in frame.data)
    else:
        yield from _content(content, frame.data, language)
    sent = data[-1 - dialect.bcc.size : -1]
    shown = sent.hex().upper() if dialect.bcc == "raw" else sent.decode("ascii")
    yield Row("BCC", shown, said(wording.SUM, language))
    yield (
        Row("ETB", f"{ETB:02X}", said(wording.CONTINUED, language))
        if frame.more
        else Row("ETX", f"{ETX:02X}", said(wording.LAST, language))
    )


def _content(content: Content, data: tuple[str, ...], language: Language) -> Iterator[Row]:
    for field, text in zip(fields(content), data, strict=False):
        letters, word = wording.FIELDS[field.name]
        yield Row(letters, text, _meaning(content, field.name, language) or said(word, language))


def _meaning(content: Content, name: str, language: Language) -> str:
    value = getattr(content, name)
    if name == "mode":
        return said(wording.MODES[value], language)
    if name == "direction":
        return said(wording.DIRECTIONS[value], language)
    if name == "distance_centi":
        return f"{value / 100:.2f} mm"
    if name == "status" and isinstance(content, Ssa):
        return content.meaning
    if name in ("number", "value", "steps"):
        return f"{said(wording.FIELDS[name][1], language)}: {value}"
    return ""


def _other_dialects(data: bytes, dialect: Dialect, language: Language) -> Iterator[str]:
    """Give the presets under which more of the bytes make sense than in this dialect, the best ones, if any."""
    here = _sensible(data, dialect)
    scores = {name: _sensible(data, other) for name, other in DIALECTS.items()}
    best = max(scores.values())
    if best > here:
        for name in (name for name, score in scores.items() if score == best):
            yield said(wording.OTHER_DIALECT, language).format(name=name)


def _sensible(data: bytes, dialect: Dialect) -> int:
    """Return how many of the bytes are packets whose data fit their command, or whose command is not in the table."""
    sizes = []
    for item in _items(data, dialect):
        if not isinstance(item, Garbled):
            fits = content_of(item, dialect) is not None or item.cmd not in wording.COMMANDS or item.cmd == Cmd.PDT
            sizes.append(_size(item, dialect) if fits else 0)
    return sum(sizes)


def show(data: bytes, dialect: str, lang: str, *, json: bool) -> str:
    """Return some bytes explained, as text or as JSON; ``lang`` is en or ko. Raises: DialectError: no such dialect."""
    chosen = dialect_named(dialect)
    explanation = explain(data, chosen, "ko" if lang == "ko" else "en")
    if not json:
        return "\n".join(_lines(explanation))
    return jsonlib.dumps(_plain(explanation, chosen, dialect.removeprefix(PREFIX)), ensure_ascii=False, indent=2)


def _lines(explanation: Explanation) -> Iterator[str]:

    for piece in explanation.pieces:
        yield f"@{piece.offset}  {show_hex(piece.data)}"
        for row in piece.rows:
            if isinstance(piece.found, Garbled):
                yield f"  {row.value}: {row.meaning}"
            else:
                yield f"    {row.name:<6}  {row.value:<6}  {row.meaning}".rstrip()
        yield ""
    for hint in explanation.hints:
        yield f"* {hint}"


def _plain(explanation: Explanation, dialect: Dialect, name: str) -> dict[str, Any]:

    pieces = []
    for piece in explanation.pieces:
        entry: dict[str, Any] = {"offset": piece.offset, "hex": piece.data.hex()}
        if isinstance(piece.found, Garbled):
            entry["garbled"] = {"reason": piece.found.reason.value, "detail": piece.found.detail}
        else:
            entry["frame"] = to_plain(piece.found, dialect)
            entry["rows"] = [{"name": r.name, "value": r.value, "meaning": r.meaning} for r in piece.rows]
        pieces.append(entry)
    return {"protocol": "hi", "dialect": name, "pieces": pieces, "hints": list(explanation.hints)}
