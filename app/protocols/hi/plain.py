"""Frames as plain dictionaries, in the shape that the test vectors use (PROTOCOLS section 7)."""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from app.domain.errors import EncodeError
from app.protocols.hi.codec import encode
from app.protocols.hi.dialects import Dialect
from app.protocols.hi.messages import CONTENTS, Content, Frame, Role, Ssa, content_of, frame_of
from app.wire.names import unknown

Plain = dict[str, Any]


def to_plain(frame: Frame, dialect: Dialect) -> Plain:
    """Return a frame as a dictionary; ``fields`` is None where the data do not fit the command."""
    content = content_of(frame, dialect)
    return {
        "role": frame.role.value,
        "id": f"{frame.id:X}",
        "cmd": frame.cmd,
        "data": list(frame.data),
        "more": frame.more,
        "fields": None if content is None else content_to_plain(content),
    }


def content_to_plain(content: Content) -> Plain:
    """Return a content by field name; what it does not have is left out."""
    named = {field.name: getattr(content, field.name) for field in fields(content)}
    if isinstance(content, Ssa):
        named["meaning"] = content.meaning
    return {name: value for name, value in named.items() if value is not None}


def plain_to_bytes(plain: Mapping[str, Any], dialect: Dialect) -> bytes:
    """Return the bytes of the packet that a dictionary describes by ``data``, by ``fields``, or by both.

    Raises: EncodeError: it describes none, it breaks the grammar, a field is out of range, or the two differ.
    """
    try:
        role, drive = Role(plain["role"]), _id(plain["id"])
        cmd, more = str(plain["cmd"]), bool(plain.get("more"))
        content, data = plain.get("fields"), plain.get("data")
        if data is None:
            frame = frame_of(role, drive, cmd, _content(role, cmd, content or {}), dialect)
            frame.more = more
            return encode(frame, dialect)
        frame = Frame(role, drive, cmd, _texts(data), more)
        written = encode(frame, dialect)
        if content is not None and to_plain(frame, dialect)["fields"] != dict(content):
            raise EncodeError(f"the fields {content!r} are not what the data {data!r} say")
        return written
    except KeyError as missing:
        raise EncodeError(f"the frame has no {missing.args[0]!r}") from None
    except (TypeError, ValueError, AttributeError) as wrong:
        raise EncodeError(f"no frame: {wrong}") from None


def _id(text: Any) -> int:
    if not isinstance(text, str) or len(text) != 1 or text not in "0123456789ABCDEF":
        raise EncodeError(f"id {text!r} is not one of 0 to 9 and A to F")
    return int(text, 16)


def _texts(data: Any) -> tuple[str, ...]:
    if not isinstance(data, list) or not all(isinstance(text, str) for text in data):
        raise EncodeError(f"data {data!r} is no list of texts")
    return tuple(data)


def _content(role: Role, cmd: str, named: Mapping[str, Any]) -> Content:
    kind = CONTENTS.get((role, cmd))
    if kind is None:
        raise EncodeError(unknown(f"{role.value} command", cmd, [known for side, known in CONTENTS if side is role]))
    return kind(**{name: value for name, value in named.items() if name != "meaning"})
