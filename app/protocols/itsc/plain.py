"""Frames as plain dictionaries, in the shape that the test vectors use (PROTOCOLS section 7)."""

from collections.abc import Callable, Mapping
from dataclasses import fields
from types import MappingProxyType
from typing import Any, cast

from app.domain.errors import EncodeError
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.messages import (
    NOTHING,
    Ack,
    Body,
    Disp,
    Element,
    Enq,
    Etb,
    Frame,
    Infr,
    Jog,
    Mode,
    Move,
    Mzone,
    Nak,
    Nothing,
    Oper,
    Port,
    Raw,
    Req,
    Resp1,
    Resp2,
    Sbuf,
    Status1,
    Status2,
    Stid,
    Teach,
    Xmove,
)
from app.wire.names import unknown

Plain = dict[str, Any]

_BODIES: Mapping[str, type[Any]] = MappingProxyType(
    {
        cls.form.value: cls
        for cls in (Nothing, Port, Sbuf, Disp, Teach, Move, Xmove, Resp1, Resp2, Req, Mzone, Stid, Jog, Infr, Raw)
    }
)
_FLAGS = {"r": "at_barcode", "h": "all_home", "f": "home_known", "s": "servos_on"}
_STATUS1 = tuple(field.name for field in fields(Status1))
_STATUS2 = ("mode", "oper", *_FLAGS, "rsv", "code")
_TEXTS = frozenset({"foup_id", "source", "destination", "text", "stid"})
_OPTIONAL = frozenset({"length", "count", "dist"})


def to_plain(frame: Frame, codec: Codec) -> Plain:
    """Return a frame as a dictionary; ``problems`` are those of this codec's dialect."""
    if isinstance(frame, Ack | Nak):
        return {"type": type(frame).__name__.upper(), "dev_id": frame.dev_id, "cmd_id": f"{frame.cmd_id:016x}"}
    return {
        "type": type(frame).__name__.upper(),
        "dev_id": frame.dev_id,
        "cmd_id": f"{frame.cmd_id:016x}",
        "code": f"0x{frame.code:04X}",
        "form": frame.body.form.value,
        "fields": body_to_plain(frame.body, codec.dialect),
        "problems": list(codec.problems(frame)),
    }


def body_to_plain(body: Body, dialect: Dialect) -> Plain:
    """Return a body's content by field name; fields that the dialect does not have are left out."""
    if isinstance(body, Raw):
        return {"data": (body.data + body.sub).hex()}
    return {
        field.name: _value_to_plain(getattr(body, field.name), dialect)
        for field in fields(body)
        if dialect.has_dist or field.name != "dist"
    }


def _value_to_plain(value: Any, dialect: Dialect) -> Any:
    if isinstance(value, Status1):
        return status1_to_plain(value)
    if isinstance(value, Status2):
        return status2_to_plain(value)
    if isinstance(value, list):
        return [_element_to_plain(element, dialect) for element in value]
    return value


def _element_to_plain(element: Element, dialect: Dialect) -> Plain:
    names = ("barcode", "seq", "sensor", "action", "speed")
    return {name: getattr(element, name) for name in (*names, *(("dist_act", "dist_next") if dialect.has_dist else ()))}


def status1_to_plain(status: Status1) -> Plain:
    """Return STATUS1's bit fields as numbers."""
    return {field.name: int(getattr(status, field.name)) for field in fields(status)}


def status2_to_plain(status: Status2) -> Plain:
    """Return STATUS2's bit fields as numbers, under the source's letters."""
    flags = {letter: int(getattr(status, name)) for letter, name in _FLAGS.items()}
    return {"mode": int(status.mode), "oper": int(status.oper), **flags, "rsv": status.rsv, "code": status.code}


def from_plain(plain: Mapping[str, Any]) -> Frame:
    """Return the frame that a dictionary describes.

    Raises: EncodeError: it describes none, or a field is missing or unknown; the message says which.
    """
    try:
        return _frame_from_plain(plain)
    except KeyError as missing:
        raise EncodeError(f"the frame has no {missing.args[0]!r}") from None
    except (TypeError, ValueError, AttributeError) as wrong:
        raise EncodeError(f"no frame: {wrong}") from None


def _frame_from_plain(plain: Mapping[str, Any]) -> Frame:
    dev_id, cmd_id = _whole("dev_id", plain["dev_id"]), _number("cmd_id", plain["cmd_id"])
    match plain["type"]:
        case "ACK":
            return Ack(dev_id, cmd_id)
        case "NAK":
            return Nak(dev_id, cmd_id)
        case "ENQ":
            body = body_from_plain(plain["form"], plain["fields"])
            return Enq(dev_id, cmd_id, _number("code", plain["code"]), body)
        case "ETB":
            body = body_from_plain(plain["form"], plain["fields"])
            return Etb(dev_id, cmd_id, _number("code", plain["code"]), _with_header(body))
        case other:
            raise EncodeError(unknown("packet type", str(other), ("ENQ", "ACK", "NAK", "ETB")))


def _number(name: str, value: Any) -> int:
    return int(value, 16) if isinstance(value, str) else _whole(name, value)


def _whole(name: str, value: Any) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise EncodeError(f"{name} {value!r} is no whole number")
    return value


def body_from_plain(form: str, content: Mapping[str, Any]) -> Body:
    """Return the body of a form's name and fields. Raises: EncodeError, KeyError, TypeError, ValueError: it is none."""
    cls = _BODIES.get(form)
    if cls is None:
        raise EncodeError(unknown("form", str(form), _BODIES))
    if cls is Nothing:
        if content:
            raise EncodeError(f"{form} has no fields, but {content!r} is given")
        return NOTHING
    if cls is Raw:
        return Raw(bytes.fromhex(content["data"]))
    return cast("Body", cls(**{name: _value_from_plain(name, value) for name, value in content.items()}))


def _value_from_plain(name: str, value: Any) -> Any:
    read = _READERS.get(name)
    if read is not None:
        return read(value)
    if name in _TEXTS:
        if not isinstance(value, str):
            raise EncodeError(f"{name} {value!r} is no text")
        return value
    absent = value is None and name in _OPTIONAL
    characters = name == "barcode" and isinstance(value, str)
    return value if absent or characters else _whole(name, value)


def _path(elements: Any) -> list[Element]:
    return [Element(**{name: _value_from_plain(name, value) for name, value in e.items()}) for e in elements]


def _status1(content: Any) -> Status1:
    values = _bits(content, _STATUS1)
    return Status1(_flag("foup", values.pop("foup")), **values)


def _status2(content: Any) -> Status2:
    values = _bits(content, _STATUS2)
    flags = {name: _flag(letter, values[letter]) for letter, name in _FLAGS.items()}
    mode, oper = Mode(values["mode"]), Oper(values["oper"])
    return Status2(mode=mode, oper=oper, **flags, rsv=values["rsv"], code=values["code"])


def _bits(content: Any, names: tuple[str, ...]) -> dict[str, int]:
    for name in content:
        if name not in names:
            raise EncodeError(unknown("status field", str(name), names))
    return {name: _whole(name, content[name]) for name in names}


def _flag(name: str, value: int) -> bool:
    if value not in (0, 1):
        raise EncodeError(f"{name} {value} is neither 0 nor 1")
    return bool(value)


_READERS: Mapping[str, Callable[[Any], Any]] = MappingProxyType(
    {"path": _path, "status1": _status1, "status2": _status2}
)


def _with_header(body: Body) -> Body:
    """Return raw data divided into the header's 16 bytes and the sub data; the header's may be left out."""
    if not isinstance(body, Raw):
        return body
    length = body.data[:4]
    given = len(body.data) - 16 in (int.from_bytes(length, "big"), int.from_bytes(length, "little"))
    return Raw(body.data[:16], body.data[16:]) if given else Raw(b"", body.data)
