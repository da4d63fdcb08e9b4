"""Packets to bytes, and the sum that guards them (PROTOCOLS 2.2)."""

import re

from app.domain.errors import EncodeError
from app.protocols.hi.dialects import DEFAULT, Bcc, Dialect
from app.protocols.hi.messages import LAST_DRIVE, Frame, Role

STX, ETX, ETB = 0x02, 0x03, 0x17
LONGEST = 256
"""Characters from M or S to ``#``, on receiving and on sending. Our choice: no listed packet has more than 22."""

_FIELD = re.compile(r"[ -~]+")
_COMMAND = re.compile("[A-Z]{3}")


def bcc(body: bytes, form: Bcc) -> bytes:
    """Return the sum of all bytes from M or S to ``#`` in the form in which it is sent (H1, H22)."""
    total = sum(body)
    match form:
        case Bcc.NIBBLE:
            return b"%X" % (total & 0xF)
        case Bcc.BYTE:
            return b"%02X" % (total & 0xFF)
        case Bcc.WORD:
            return b"%04X" % (total & 0xFFFF)
        case Bcc.RAW:
            return bytes([total & 0xFF])


def encode(frame: Frame, dialect: Dialect = DEFAULT) -> bytes:
    """Return a packet's bytes. Raises: EncodeError: it breaks the grammar; whether the data fit the command is not looked at."""
    _check(frame)
    body = f"{frame.role.value}{frame.id:X}{frame.cmd}@{'&'.join(frame.data)}#".encode("ascii")
    if len(body) > LONGEST:
        raise EncodeError(f"the packet has {len(body)} characters; {LONGEST} are the most")
    return bytes([STX]) + body + bcc(body, dialect.bcc) + bytes([ETB if frame.more else ETX])


def _check(frame: Frame) -> None:
    lowest = 0 if frame.role is Role.MASTER else 1
    if not lowest <= frame.id <= LAST_DRIVE:
        raise EncodeError(f"id {frame.id} is not from {lowest} to {LAST_DRIVE}")
    if not _COMMAND.fullmatch(frame.cmd):
        raise EncodeError(f"command {frame.cmd!r} is not three capital letters")
    for text in frame.data:
        if not _FIELD.fullmatch(text) or set(text) & set("@&#"):
            raise EncodeError(f"data field {text!r} is not printable ASCII without @, & and #")
