"""The wire below the operations: one question out, and its answer told from everything else (PROTOCOLS 2.3)."""

from collections import deque
from dataclasses import dataclass
from enum import Enum, auto
from typing import Literal

from app.domain.drive import DriveEvent, DriveLineGarbled, DriveLineId
from app.domain.units import Seconds
from app.protocols.hi.codec import encode
from app.protocols.hi.dialects import Dialect
from app.protocols.hi.framing import Assembler, Decoder, Garbled
from app.protocols.hi.messages import (
    ALL_DRIVES,
    Ack,
    Cmd,
    Frame,
    Number,
    Refused,
    Role,
    Setting,
    Ssa,
    content_of,
    frame_of,
)
from app.protocols.hi.session.steps import Ask
from app.protocols.hi.session.timing import Timing

FRAMES_KEPT = 32
"""Our choice: what the line's panel shows."""

Way = Literal["in", "out"]


class No(Enum):
    """The two answers that say that a request was not taken."""

    NAK = auto()
    BUSY = auto()


Answer = Ack | Setting | Ssa | No
_STORING = frozenset({Cmd.SED, Cmd.DSK})
_ACKED = frozenset({Cmd.RUN, Cmd.SRK, Cmd.UPP, Cmd.DWN, Cmd.DSK, Cmd.SED, Cmd.INP})


@dataclass(slots=True)
class Figures:
    """How the line is doing since the session began. ``strays`` are packets that answer nothing that was asked."""

    sent: int = 0
    answered: int = 0
    timeouts: int = 0
    naks: int = 0
    busies: int = 0
    garbled: int = 0
    strays: int = 0


class Line:
    """Sends a question and hears its answer. ``asked`` is the open question, ``due`` when it is given up.

    ``free_at`` is when we may speak again. Complaints go to ``events``.
    """

    def __init__(self, name: DriveLineId, dialect: Dialect, timing: Timing, events: list[DriveEvent]) -> None:
        self.name = name
        self.figures = Figures()
        self.frames: deque[tuple[Seconds, Way, bytes]] = deque(maxlen=FRAMES_KEPT)
        self.asked: Ask | None = None
        self.due = Seconds(0.0)
        self.free_at = Seconds(0.0)
        self._dialect, self._timing, self._events = dialect, timing, events
        self._decoder, self._assembler = Decoder(dialect), Assembler()
        self._heard_some = False
        self._packet = b""
        self._out = b""
        self._stored_at: Seconds | None = None

    def packet(self, ask: Ask) -> bytes:
        """Return the bytes of a question. Raises: EncodeError: it cannot be said in this dialect."""
        return encode(frame_of(Role.MASTER, ask.address, ask.cmd, ask.content, self._dialect), self._dialect)

    def ask(self, ask: Ask, now: Seconds) -> None:
        """Send a question."""
        self._silence(now)
        self._packet = self.packet(ask)
        self._out += self._packet
        self._heard_some = False
        self.asked = ask
        size = len(self._packet)
        timing = self._timing
        wait = timing.told_all(size, ask.cmd) if ask.address == ALL_DRIVES else timing.answer(size)
        self.due = Seconds(now + wait)
        if ask.cmd in _STORING:
            self._stored_at = now
        self.figures.sent += 1
        self.frames.append((now, "out", self._packet))

    def all_hear_at(self, ask: Ask) -> Seconds:
        """Return from when on no drive misses this because it stores what it was told before (H9). Our choice.

        One drive would say BSY; of a request to all drives nobody would know. Stop is always heard.
        """
        if self._stored_at is None or ask.address != ALL_DRIVES or ask.cmd is Cmd.SRK:
            return Seconds(0.0)
        return Seconds(self._stored_at + self._timing.all_write)

    def outgoing(self) -> bytes:
        """Return and forget the bytes to send."""
        out, self._out = self._out, b""
        return out

    def close(self, now: Seconds, *, settled: bool) -> None:
        """The question is answered or given up. Not ``settled``: an earlier answer to it may still come, and is waited for."""
        self.asked = None
        rest = now if settled else max(now, self.due)
        self.free_at = Seconds(rest + self._timing.gap)

    def reset(self) -> None:
        """Forget all: another connection."""
        self._decoder.flush()
        self._assembler.flush()
        self.asked = None
        self._out = b""
        self._stored_at = None
        self.free_at = Seconds(0.0)

    def take(self, data: bytes, now: Seconds) -> list[Answer]:
        """Take bytes and return the answers in them to the open question: one, or none."""
        if self.asked is not None and not self._heard_some:
            self._heard_some = True
            self.due = max(self.due, Seconds(now + self._timing.rest_of_answer))
        if self.asked is None:
            self.free_at = max(self.free_at, Seconds(now + self._timing.gap))
        return self._sift(self._decoder.feed(data), now)

    def give_up_waiting(self, now: Seconds) -> list[Answer]:
        """The time is over: return what is found behind a broken head."""
        return self._sift(self._decoder.flush(), now)

    def _silence(self, now: Seconds) -> None:
        self._sift([*self._decoder.flush(), *self._assembler.flush()], now)

    def _sift(self, items: list[Frame | Garbled], now: Seconds) -> list[Answer]:
        answers: list[Answer] = []
        for item in items:
            if isinstance(item, Garbled):
                self._complain(item.reason.value, f"{item.detail}; {item.dropped} bytes dropped")
                continue
            packet = encode(item, self._dialect)
            if item.role is Role.MASTER:
                # Two-wire adapters give back what is sent.
                if packet != self._packet:
                    self._stray(item, "another master is on the line")
                continue
            self.frames.append((now, "in", packet))
            for whole in self._assembler.add(item):
                answer = self._answer(whole) if isinstance(whole, Frame) and not answers else None
                if answer is not None:
                    answers.append(answer)
                elif isinstance(whole, Frame):
                    self._stray(whole, "it answers nothing that was asked")
        return answers

    def _answer(self, frame: Frame) -> Answer | None:
        """Return what a frame answers to the open question; None if it does not fit it."""
        ask = self.asked
        if ask is None or frame.id != ask.address:
            return None
        content = content_of(frame, self._dialect)
        if isinstance(content, Refused):
            return No.NAK if frame.cmd == Cmd.NAK else No.BUSY
        if isinstance(content, Ack):
            return content if ask.cmd in _ACKED else None
        if isinstance(content, Ssa):
            return content if ask.cmd is Cmd.SSQ else None
        if isinstance(content, Setting) and isinstance(ask.content, Number) and ask.content.number == content.number:
            return content
        return None

    def _stray(self, frame: Frame, why: str) -> None:
        self.figures.strays += 1
        shown = f"{frame.role.value}{frame.id:X} {frame.cmd} {'&'.join(frame.data)}".rstrip()
        self._events.append(DriveLineGarbled(self.name, "stray packet", f"{shown}: {why}"))

    def _complain(self, reason: str, detail: str) -> None:
        self.figures.garbled += 1
        self._events.append(DriveLineGarbled(self.name, reason, detail))
