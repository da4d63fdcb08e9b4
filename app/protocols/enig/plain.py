"""Frames as plain dictionaries, in the shape that the test vectors use (PROTOCOLS section 7)."""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from app.domain.errors import EncodeError
from app.protocols.enig.codec import Codec
from app.protocols.enig.messages import BY_CLASS, Body, Frame, Raw, Toward
from app.wire.names import unknown

Plain = dict[str, Any]


def to_plain(frame: Frame, data: bytes, codec: Codec, toward: Toward) -> Plain:
    """Return a frame as a dictionary; ``data`` is its DATA on the wire. ``id`` is the ID byte."""
    kind = codec.class_of(frame.device)
    return {
        "id": frame.id,
        "cmd": frame.cmd,
        "data": data.hex(),
        "class": "?" if kind is None else kind.value,
        "name": None if (row := codec.message(frame.device, toward, frame.cmd)) is None else row.name,
        "fields": fields_to_plain(frame),
        "problems": list(codec.problems(frame, toward)),
    }


def fields_to_plain(frame: Frame) -> Plain:
    """Return the content by field name, with the Target if there is one."""
    if isinstance(frame.body, Raw):
        return {"data": frame.body.data.hex()}
    content = {field.name: getattr(frame.body, field.name) for field in fields(frame.body)}
    return content if frame.target is None else {**content, "target": frame.target}


def from_plain(plain: Mapping[str, Any], codec: Codec, toward: Toward) -> Frame:
    """Return the frame that a dictionary describes: by ``id``, ``name`` (or ``cmd`` without one) and ``fields``.

    Raises: EncodeError: it describes none, or a field is missing or unknown; the message says which.
    """
    try:
        return _frame_from_plain(plain, codec, toward)
    except KeyError as missing:
        raise EncodeError(f"the frame has no {missing.args[0]!r}") from None
    except (TypeError, ValueError, AttributeError) as wrong:
        raise EncodeError(f"no frame: {wrong}") from None


def _frame_from_plain(plain: Mapping[str, Any], codec: Codec, toward: Toward) -> Frame:
    number, name = _whole("id", plain["id"]), plain.get("name")
    content = dict(plain.get("fields") or {})
    target = _whole("target", content.pop("target")) if "target" in content else None
    if name is None or (set(content) == {"data"} and "cmd" in plain):
        return Frame(number, _whole("cmd", plain["cmd"]), Raw(bytes.fromhex(content["data"])))
    row = codec.named(Frame(number, 0, Raw(b""), target).device, toward, name)
    if plain.get("cmd", row.cmd) != row.cmd:
        raise EncodeError(f"CMD of {name} is {row.cmd}, not {plain['cmd']!r}")
    known = [field.name for field in fields(row.cls)]
    for key in content:
        if key not in known:
            raise EncodeError(unknown(f"field of {name}:", str(key), known))
    body: Body = row.cls(**{key: _value(key, content[key]) for key in known})
    return Frame(number, BY_CLASS[type(body)].cmd, body, target)


def _value(name: str, value: Any) -> Any:
    if name not in ("tag", "alias"):
        return _whole(name, value)
    if not isinstance(value, str):
        raise EncodeError(f"{name} {value!r} is no text")
    return value


def _whole(name: str, value: Any) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise EncodeError(f"{name} {value!r} is no whole number")
    return value
