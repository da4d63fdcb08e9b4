"""Packets explained for people: every field and bit by name, and for bytes that are no packet the reason."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields
from types import MappingProxyType

from app.protocols.itsc import wording
from app.protocols.itsc.codec import CRC_SIZE, HEAD_SIZE, SHORT_SIZE, Codec
from app.protocols.itsc.detect import fits_of_stream
from app.protocols.itsc.dialects import DIALECTS, Dialect, EtbLayout
from app.protocols.itsc.framing import Decoder, Garbled, Reason
from app.protocols.itsc.messages import (
    AXES,
    Ack,
    Barcode,
    Body,
    Element,
    EncodeError,
    Enq,
    Etb,
    Frame,
    Jog,
    Message,
    Move,
    Nak,
    Nothing,
    Raw,
    Resp1,
    Resp2,
    Status1,
    Status2,
    Teach,
    Toward,
    Xmove,
)
from app.protocols.itsc.wording import Language, Text, said

_UNUSUAL = 10_000_000
"""Our choice: a barcode number from here on looks like a wrong dialect (1.11)."""


@dataclass(frozen=True, slots=True)
class Row:
    """One line of an explanation: the field's name in the specification, its value, and what it means."""

    name: str
    value: str
    meaning: str = ""
    depth: int = 0


@dataclass(frozen=True, slots=True)
class Reading:
    """A packet read as going one way; ``direction`` is TC>VEH, VEH>TC, or both where that makes no difference."""

    direction: str
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
    hints: tuple[str, ...] = field(default=())


def explain(data: bytes, dialect: Dialect, language: Language = "en") -> Explanation:
    """Return what the bytes say in a dialect; every byte belongs to one piece. Never fails on content."""
    codec = Codec(dialect)
    pieces = []
    hints = []
    offset = 0
    for down, up in zip(_items(data, codec, Toward.VEHICLE), _items(data, codec, Toward.CONTROLLER), strict=True):
        size = _size(down, codec)
        cut = data[offset : offset + size]
        if isinstance(down, Garbled):
            pieces.append(Piece(offset, cut, garbled=down))
        elif not isinstance(up, Garbled):
            readings = [
                Reading(way, frame, tuple(frame_rows(frame, codec, language)))
                for way, frame in _ways(down, up, cut, codec)
            ]
            pieces.append(Piece(offset, cut, tuple(readings)))
            if _asks_with_zeros(down, up, cut, codec):
                hints.append(said(wording.ZERO_ANSWER, language).format(form=_form(up)))
        offset += size
    return Explanation(tuple(pieces), (*dict.fromkeys(hints), *_other_dialects(data, dialect, language)))


def _items(data: bytes, codec: Codec, toward: Toward) -> list[Frame | Garbled]:
    """Return what a decoder makes of the bytes, neighbouring rubbish in one piece."""
    decoder = Decoder(codec, toward)
    items: list[Frame | Garbled] = []
    for item in (*decoder.feed(data), *decoder.flush()):
        last = items[-1] if items else None
        if isinstance(item, Garbled) and isinstance(last, Garbled):
            items[-1] = Garbled(last.reason, last.detail, last.dropped + item.dropped)
        else:
            items.append(item)
    return items


def _size(item: Frame | Garbled, codec: Codec) -> int:
    """Return how many bytes an item took on the wire."""
    match item:
        case Garbled():
            return item.dropped
        case Ack() | Nak():
            return SHORT_SIZE
        case Enq():
            return HEAD_SIZE + CRC_SIZE
        case Etb():
            crcs = 2 if codec.dialect.etb is EtbLayout.HEAD_CRC_SUB_CRC else 1
            sub = item.body.length if isinstance(item.body, Move | Xmove) else len(getattr(item.body, "sub", b""))
            return HEAD_SIZE + (sub or 0) + crcs * CRC_SIZE


def _form(frame: Frame) -> str:
    return frame.body.form.value if isinstance(frame, Enq | Etb) else ""


def _asks_with_zeros(down: Frame, up: Frame, data: bytes, codec: Codec) -> bool:
    """Return whether this is a request without data whose bytes could be an answer too, all zeros."""
    return isinstance(down, Enq) and isinstance(down.body, Nothing) and up != down and _is_sound(down, data, codec)


def _ways(down: Frame, up: Frame, data: bytes, codec: Codec) -> Iterator[tuple[str, Frame]]:
    """Give the ways a packet can have gone with the frame it then is: the sound readings, or all if none is."""
    if down == up or isinstance(down, Ack | Nak | Etb):
        yield Toward.VEHICLE.value if isinstance(down, Etb) else "both", down
        return
    if _asks_with_zeros(down, up, data, codec):
        yield Toward.VEHICLE.value, down
        return
    sound_down, sound_up = _is_sound(down, data, codec), _is_sound(up, data, codec)
    if sound_down or not sound_up:
        yield Toward.VEHICLE.value, down
    if sound_up or not sound_down:
        yield Toward.CONTROLLER.value, up


def _is_sound(frame: Frame, data: bytes, codec: Codec) -> bool:
    """Return whether a frame read this way is one that a strict sender would have sent in these very bytes."""
    if isinstance(frame, Enq) and isinstance(frame.body, Resp1 | Resp2) and frame.body.status2.rsv:
        return False
    try:
        return codec.encode(frame) == data
    except EncodeError:
        return False


def _other_dialects(data: bytes, dialect: Dialect, language: Language) -> Iterator[str]:
    """Give the presets, or else the CRCs, under which more of the bytes make sense than in this dialect, if any."""
    here = _sensible(data, dialect)
    if here == len(data):
        return
    scores = {name: _sensible(data, other) for name, other in DIALECTS.items()}
    best = max(scores.values())
    if best > here:
        for name in (name for name, score in scores.items() if score == best):
            items = _items(data, Codec(DIALECTS[name]), Toward.CONTROLLER)
            places = [f"barcode {barcode} SEQ {seq}" for item in items for barcode, seq in _places(item) if barcode]
            extra = f" ({', '.join(places[:3])})" if places else ""
            yield said(wording.OTHER_DIALECT, language).format(name=name, extra=extra)
    elif not here:
        for fit in fits_of_stream(data, dialect):
            crc = {"crc": fit.variant.crc, "crc_covers_type": fit.variant.covers_type, "crc_order": fit.variant.order}
            yield said(wording.OTHER_CRC, language).format(**crc)


def _sensible(data: bytes, dialect: Dialect) -> int:
    """Return how many of the bytes are packets without a problem and with usual barcodes, read one way or the other."""
    codec = Codec(dialect)
    sensible = offset = 0
    for down, up in zip(_items(data, codec, Toward.VEHICLE), _items(data, codec, Toward.CONTROLLER), strict=True):
        size = _size(down, codec)
        if not isinstance(down, Garbled) and not isinstance(up, Garbled):
            cut = data[offset : offset + size]
            ways = _ways(down, up, cut, codec)
            sensible += size * any(_is_sound(frame, cut, codec) and _is_usual(frame) for _, frame in ways)
        offset += size
    return sensible


def _is_usual(frame: Frame) -> bool:
    """Return whether all barcodes look like barcodes: not huge, and not 0 under a SEQ that counts (1.11)."""
    return all(
        not (isinstance(barcode, int) and (barcode >= _UNUSUAL or (barcode == 0 and seq > 0)))
        for barcode, seq in _places(frame)
    )


def _places(item: Frame | Garbled) -> Iterator[tuple[Barcode, int]]:
    body = item.body if isinstance(item, Enq | Etb) else None
    match body:
        case Resp1() | Resp2():
            yield body.barcode, body.seq
        case Teach():
            yield body.barcode, 0
        case Move() | Xmove():
            for element in body.path:
                yield element.barcode, element.seq
        case _:
            return


def frame_rows(frame: Frame, codec: Codec, language: Language = "en") -> Iterator[Row]:
    """Give a packet's fields from first to last, status words bit by bit, then what is wrong with them."""
    kind = type(frame).__name__.upper()
    yield Row("TYPE", kind, said(wording.PACKETS[kind], language))
    yield Row("DEV_ID", codec.dialect.show_dev_id(frame.dev_id), f"0x{frame.dev_id:08X}")
    owner = wording.BY_VEHICLE if frame.cmd_id >> 63 else wording.BY_CONTROLLER
    yield Row("CMD_ID", f"{frame.cmd_id:016X}", said(owner, language))
    if isinstance(frame, Enq | Etb):
        yield Row("CMD", f"{frame.code:04X}", _message_name(codec.message(frame.code), language))
        yield Row("FORM", frame.body.form.value)
        yield from _body_rows(frame.body, codec.dialect, language)
    for problem in codec.problems(frame):
        yield Row("!", problem, said(wording.PROBLEM, language))


def _message_name(message: Message | None, language: Language) -> str:
    if message is None:
        return said(wording.UNKNOWN_CODE, language)
    korean = f", {wording.NAMES[message.kind][1]}" if language == "ko" and message.kind is not None else ""
    modes = "/".join(mode.name for mode in sorted(message.modes))
    return f"{message.name}{korean} ({message.sender}, {modes})"


def _body_rows(body: Body, dialect: Dialect, language: Language) -> Iterator[Row]:
    if isinstance(body, Raw):
        yield Row("DATA", body.data.hex(" ").upper(), said(wording.UNITS["data"], language))
        if body.sub:
            yield Row("SUB", body.sub.hex(" ").upper())
        return
    values = {one.name: getattr(body, one.name) for one in fields(body)}
    for name, value in sorted(values.items(), key=lambda pair: isinstance(pair[1], list)):
        if isinstance(value, Status1):
            yield Row("STATUS1", f"{value.word:08X}")
            yield from status1_rows(value, language, depth=1)
        elif isinstance(value, Status2):
            yield Row("STATUS2", f"{value.word:08X}")
            yield from status2_rows(value, language, depth=1)
        elif isinstance(value, list):
            for element in value:
                yield _element_row(element, dialect, language)
        elif value is not None:
            yield _field_row(body, name, value, language)


def _field_row(body: Body, name: str, value: object, language: Language) -> Row:
    label = _LABELS.get(name, name.upper().replace("_", " "))
    values = wording.FIELDS.get((body.form.value, name))
    if values is not None and isinstance(value, int):
        return Row(label, str(value), said(values.get(value, wording.UNDEFINED), language))
    if isinstance(body, Jog) and body.opt in (3, 4):
        return Row(label, str(value))
    unit = wording.UNITS.get(name)
    return Row(label, repr(value) if isinstance(value, str) else str(value), said(unit, language) if unit else "")


_LABELS: Mapping[str, str] = MappingProxyType({"pos": "TEACHING POS", "zone": "ZONE ID", "seq": "SEQ"})


def _element_row(element: Element, dialect: Dialect, language: Language) -> Row:
    action = said(wording.ACTIONS.get(element.action, wording.UNDEFINED), language)
    sensor = said(wording.UNITS["sensor"], language)
    distances = f", DIST_ACT {element.dist_act} mm, DIST_NEXT {element.dist_next} mm" if dialect.has_dist else ""
    return Row(
        f"SEQ {element.seq}",
        f"{element.barcode}",
        f"{element.action} {action}, {element.speed} %, {sensor} {element.sensor}{distances}",
        depth=1,
    )


def status1_rows(status: Status1, language: Language = "en", *, depth: int = 0) -> Iterator[Row]:
    """Give STATUS1 bit field by bit field (1.8)."""
    yield Row("F", str(int(status.foup)), said(wording.FOUP[int(status.foup)], language), depth)
    if status.rsv:
        yield Row("30-28", str(status.rsv), said(wording.RESERVED, language), depth)
    for name in AXES:
        value: int = getattr(status, name)
        yield Row(name.upper(), str(value), said(wording.NIBBLES[name].get(value, wording.UNDEFINED), language), depth)


def status2_rows(status: Status2, language: Language = "en", *, depth: int = 0) -> Iterator[Row]:
    """Give STATUS2 bit field by bit field (1.9)."""
    yield Row("MODE", str(int(status.mode)), said(wording.MODES.get(status.mode, wording.UNDEFINED), language), depth)
    yield Row("OPER", str(int(status.oper)), said(wording.OPERS[status.oper], language), depth)
    for name, (letter, off, on) in wording.FLAGS.items():
        is_set: bool = getattr(status, name)
        yield Row(letter, str(int(is_set)), said(on if is_set else off, language), depth)
    if status.rsv:
        yield Row("23-16", f"{status.rsv:02X}", said(wording.RESERVED, language), depth)
    meaning: Text = wording.ALARM_CODE if status.oper.name == "ALARM" else wording.PROCESS_CODE
    yield Row("CODE", f"{status.code:04X}", f"{said(meaning, language)} {status.code}", depth)


def garbled_row(garbled: Garbled, language: Language = "en") -> Row:
    """Return what is known about bytes that are no packet."""
    reason = Reason(garbled.reason)
    return Row("?", said(wording.GARBLED[reason.value], language), garbled.detail)
