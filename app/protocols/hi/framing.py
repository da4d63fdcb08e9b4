"""The stream of bytes cut into HI packets, and continued packets put together (PROTOCOLS 2.2, 6.3, H11).

The head-candidate rule: wait until the packet that seems to stand at the head is complete; a valid one is delivered, of
anything else the first byte is dropped, and the search goes on behind it. A packet that can no longer become one is dropped
at once, so a second STX ends a packet whose end was lost.
"""

import re
from dataclasses import dataclass
from enum import StrEnum

from app.protocols.hi.codec import ETB, ETX, LONGEST, STX, bcc
from app.protocols.hi.dialects import DEFAULT, Dialect
from app.protocols.hi.messages import Frame, Role

MOST_PARTS = 8
"""Packets that one continued packet may have (H11)."""

_FIELDS = rb"[ -\"$%'-?A-~]+(?:&[ -\"$%'-?A-~]+)*"
_WHOLE = re.compile(rb"\x02((?:M[0-9A-F]|S[1-9A-F])[A-Z]{3}@(?:" + _FIELDS + rb")?#)")
_LETTERS = rb"(?:[A-Z](?:[A-Z](?:[A-Z](?:@(?:" + _FIELDS + rb"&?)?)?)?)?)?"
_BEGUN = re.compile(rb"\x02(?:M(?:[0-9A-F]" + _LETTERS + rb")?|S(?:[1-9A-F]" + _LETTERS + rb")?)?")


class Reason(StrEnum):
    """Why bytes were dropped."""

    NOISE = "noise"
    FORMAT = "format"
    BCC = "bcc"
    TRUNCATED = "truncated"


@dataclass(slots=True)
class Garbled:
    """A run of bytes that were no packet: what was wrong first in it, in words too, and how many were dropped.

    ``of`` is the packet as it was read where nothing but its BCC was wrong.
    """

    reason: Reason
    detail: str
    dropped: int
    of: Frame | None = None


Candidate = tuple[Frame, int] | Garbled | None
"""A frame and its size; what is wrong and how much to drop; None if it is not complete."""


class Decoder:
    """Cuts one line into frames of either role. No sequence of bytes makes it raise; it holds at most one packet."""

    __slots__ = ("_dialect", "_held")

    def __init__(self, dialect: Dialect = DEFAULT) -> None:
        self._dialect = dialect
        self._held = b""

    @property
    def pending(self) -> int:
        """How many bytes wait for the rest of their packet; the caller flushes after silence."""
        return len(self._held)

    def feed(self, data: bytes) -> list[Frame | Garbled]:
        """Take bytes as they arrive and return what they complete, in order."""
        return self._cut(self._held + data, idle=False)

    def flush(self) -> list[Frame | Garbled]:
        """Give up waiting, since the line is idle: return what the pending bytes hold behind their broken head."""
        return self._cut(self._held, idle=True)

    def _cut(self, data: bytes, *, idle: bool) -> list[Frame | Garbled]:
        out: list[Frame | Garbled] = []
        run: Garbled | None = None
        at = 0
        while at < len(data):
            found = self._candidate(data, at)
            if found is None:
                if not idle:
                    break
                found = Garbled(Reason.TRUNCATED, f"{len(data) - at} bytes of a packet, then silence", 1)
            if isinstance(found, Garbled):
                at += found.dropped
                run = found if run is None else _joined(run, found)
                continue
            if run is not None:
                out.append(run)
                run = None
            out.append(found[0])
            at += found[1]
        if run is not None:
            out.append(run)
        self._held = data[at:]
        return out

    def _candidate(self, data: bytes, at: int) -> Candidate:
        if data[at] != STX:
            start = data.find(STX, at)
            size = (len(data) if start < 0 else start) - at
            return Garbled(Reason.NOISE, f"byte {data[at]:02X} starts no packet", size)
        whole = _WHOLE.match(data, at, at + 1 + LONGEST)
        if whole is None:
            left = len(data) - at
            if left <= LONGEST and _BEGUN.fullmatch(data, at):
                return None
            return Garbled(Reason.FORMAT, "STX without a packet of the specified form behind it", 1)
        end = whole.end() + self._dialect.bcc.size
        return self._checked(whole[1], data[whole.end() : end], data[end]) if end < len(data) else None

    def _checked(self, body: bytes, sent: bytes, last: int) -> Candidate:
        if last not in (ETX, ETB):
            return Garbled(Reason.FORMAT, f"the packet ends in {last:02X}, neither ETX nor ETB", 1)
        frame = _frame(body, more=last == ETB)
        expected = bcc(body, self._dialect.bcc)
        if sent != expected:
            return Garbled(Reason.BCC, f"BCC {sent.hex(' ').upper()}, expected {expected.hex(' ').upper()}", 1, frame)
        return frame, len(body) + len(sent) + 2


def _joined(first: Garbled, more: Garbled) -> Garbled:
    told = more if first.reason is Reason.NOISE and more.reason is not Reason.NOISE else first
    return Garbled(told.reason, told.detail, first.dropped + more.dropped, told.of)


def _frame(body: bytes, *, more: bool) -> Frame:
    text = body.decode("ascii")
    data = text[6:-1]
    return Frame(Role(text[0]), int(text[1], 16), text[2:5], tuple(data.split("&")) if data else (), more)


class Assembler:
    """Puts continued packets together: fields of consecutive packets of one role, id and command (H11)."""

    __slots__ = ("_parts",)

    def __init__(self) -> None:
        self._parts: list[Frame] = []

    def add(self, frame: Frame) -> list[Frame | Garbled]:
        """Take a packet and return what it completes, after what it shows to be broken off."""
        out: list[Frame | Garbled] = []
        first = self._parts[0] if self._parts else None
        if first is not None and (first.role, first.id, first.cmd) != (frame.role, frame.id, frame.cmd):
            out += self.flush()
        self._parts.append(frame)
        if not frame.more:
            data = tuple(text for part in self._parts for text in part.data)
            self._parts = []
            out.append(Frame(frame.role, frame.id, frame.cmd, data))
        elif len(self._parts) >= MOST_PARTS:
            out += self.flush()
        return out

    def flush(self) -> list[Frame | Garbled]:
        """Give the parts up that were to be continued."""
        count, self._parts = len(self._parts), []
        return [Garbled(Reason.TRUNCATED, f"{count} packets that were to be continued", 0)] if count else []
