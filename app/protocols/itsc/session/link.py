"""How a link is doing: its life, its polls, its figures, what it remembers of the packets received (PROTOCOLS 6.1, I23)."""

import struct
from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, IntEnum, auto
from typing import Literal

from app.domain.units import Seconds

SEEN_KEPT = 64
"""So many packets are remembered (I23)."""
FRAMES_KEPT = 32
"""Our choice: what the vehicle's panel shows of the line."""
POLLS_KEPT = 4
"""Our choice: so many unanswered polls are remembered, so that a late answer is known for what it is."""


class Link(Enum):
    """Life of a connection: DOWN, ASKING (nothing but STATUS until its first answer), UP, CLOSING (silent: to be closed)."""

    DOWN = auto()
    ASKING = auto()
    UP = auto()
    CLOSING = auto()

    @property
    def alive(self) -> bool:
        """Whether anything may be sent and received."""
        return self is Link.ASKING or self is Link.UP


@dataclass(frozen=True, slots=True)
class LinkQuality:
    """Figures of a line since the session began; the round trip of a poll in milliseconds, None before the first.

    ``garbled`` counts runs of bytes that were no packet and packets that did not fit, ``lost_polls`` polls without an
    answer in time, ``connections`` how often the line came up.
    """

    connections: int
    frames_in: int
    frames_out: int
    garbled: int
    resends: int
    duplicates: int
    polls: int
    lost_polls: int
    round_trip_last: float | None
    round_trip_mean: float | None


class Seen:
    """The packets received lately, each as the 64 bits of its hash: the packets themselves would take four times the memory.

    That one is taken for another happens once in 10^17 packets; the CRC lets one broken packet in 65,536 pass.
    """

    __slots__ = ("_kept", "_next")

    def __init__(self) -> None:
        self._kept = array("q")
        self._next = 0

    def __len__(self) -> int:
        return len(self._kept)

    def __contains__(self, packet: bytes) -> bool:
        return hash(packet) in self._kept

    def add(self, packet: bytes) -> None:
        """Remember a packet, in the place of the oldest if there are enough."""
        self._kept[self._next : self._next + 1] = array("q", (hash(packet),))
        self._next = (self._next + 1) % SEEN_KEPT

    def clear(self) -> None:
        """Forget all: another connection, another memory."""
        del self._kept[:]
        self._next = 0


Way = Literal["in", "out"]
Kept = tuple[int, Seconds, Way, bytes]
"""A number to sort by, the moment, the way, the packet."""


class Taped(IntEnum):
    """What an entry of a tape stands for, and what its bytes are: the rest follows from them."""

    OUT = 0
    """A packet sent, all of it."""
    IN = 1
    """A packet received, all of it."""
    ASKED = 2
    """A poll sent: its CMD_ID."""
    ANSWERED = 3
    """A STATUS and the ACK sent for it: the STATUS from CMD_ID up to its CRC."""


class Tape:
    """The last packets of a line, as bytes one after the other: read when a person looks, forgotten otherwise.

    Polls and their answers are most of them, and are kept without what can be told from the rest.
    """

    __slots__ = ("_count", "_tape")

    def __init__(self) -> None:
        self._count = 0
        self._tape = bytearray()

    def __iter__(self) -> Iterator[tuple[int, Seconds, Taped, bytes]]:
        at = 0
        while at < len(self._tape):
            number, when, kind, size = _HEAD.unpack_from(self._tape, at)
            at += _HEAD.size + size
            yield number, Seconds(when), Taped(kind), bytes(self._tape[at - size : at])

    def append(self, number: int, when: Seconds, kind: Taped, content: bytes) -> None:
        """Remember what a kind says, and forget the oldest packets if there are enough without them."""
        self._count += _PACKETS[kind]
        while True:
            _, _, oldest, size = _HEAD.unpack_from(self._tape) if self._tape else (0, 0, Taped.OUT, 0)
            if self._count - _PACKETS[oldest] < FRAMES_KEPT:
                break
            self._count -= _PACKETS[oldest]
            del self._tape[: _HEAD.size + size]
        self._tape += _HEAD.pack(number, when, kind, len(content)) + content


_HEAD = struct.Struct("<QdBI")
_PACKETS = (1, 1, 1, 2)
"""How many packets each kind stands for."""


class Polls:
    """The STATUS questions of a link: when the next is due, which are open, how long answers take."""

    __slots__ = ("_last", "_sum", "_times", "due", "lost", "open", "sent")

    def __init__(self) -> None:
        self.open: dict[int, Seconds] = {}
        self.due = Seconds(0.0)
        self.sent = self.lost = self._times = 0
        self._last = self._sum = 0.0

    def asked(self, cmd_id: int, now: Seconds, answer: Seconds) -> None:
        """Note a question; the next one is due when its answer is late."""
        if self.open and now >= self.due:
            self.lost += 1
        if len(self.open) >= POLLS_KEPT:
            del self.open[next(iter(self.open))]
        self.open[cmd_id] = now
        self.sent += 1
        self.due = Seconds(now + answer)

    def answered(self, cmd_id: int, now: Seconds, interval: Seconds) -> Seconds:
        """Note the answer to an open question; earlier ones are forgotten. Return when it was asked."""
        asked = self.open[cmd_id]
        for earlier in [each for each, when in self.open.items() if when < asked or each == cmd_id]:
            del self.open[earlier]
        if not self.open:
            self.due = Seconds(max(asked + interval, now))
        self._last = (now - asked) * 1000.0
        self._sum += self._last
        self._times += 1
        return asked

    def refused(self, cmd_id: int, interval: Seconds) -> None:
        """Note a NAK: the question is asked anew, under another CMD_ID, at the next turn."""
        asked = self.open.pop(cmd_id)
        self.lost += 1
        self.due = min(self.due, Seconds(asked + interval))

    @property
    def round_trip_last(self) -> float | None:
        """Milliseconds from the newest answered question to its answer."""
        return self._last if self._times else None

    @property
    def round_trip_mean(self) -> float | None:
        """The same, mean of all."""
        return self._sum / self._times if self._times else None
