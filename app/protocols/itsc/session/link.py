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
    """A STATUS and the ACK sent for it: CMD_ID and data of the STATUS."""


class Tape:
    """The last packets of a line, as bytes one after the other: read when a person looks, forgotten otherwise.

    Polls and their answers are most of them, and are kept without what can be told from the rest.
    """

    __slots__ = ("_count", "_tape")

    def __init__(self) -> None:
        self._count = 0
        self._tape = b""

    def packets(self, numbered: int) -> Iterator[tuple[int, Seconds, Taped, bytes]]:
        """Give (number, moment, kind, content), oldest first, if so many are numbered now: of a number 32 bits are kept."""
        at = 0
        while at < len(self._tape):
            low, when, kind = _HEAD.unpack_from(self._tape, at)
            start, size = self._content(at)
            at = start + size
            yield numbered - (numbered - low) % (1 << 32), Seconds(when), Taped(kind), self._tape[start:at]

    def append(self, number: int, when: Seconds, kind: Taped, content: bytes) -> None:
        """Remember what a kind says, and forget the oldest packets if there are enough without them."""
        self._count += _PACKETS[kind]
        first = 0
        while (
            first < len(self._tape) and self._count - (oldest := _PACKETS[self._tape[first + _KIND_AT]]) >= FRAMES_KEPT
        ):
            self._count -= oldest
            first = sum(self._content(first))
        head = _HEAD.pack(number % (1 << 32), when, kind)
        if kind not in _SIZES:
            head += _SIZE.pack(len(content))
        self._tape = self._tape[first:] + head + content

    def _content(self, at: int) -> tuple[int, int]:
        """Return where the content of the entry that begins here begins, and how long it is."""
        start = at + _HEAD.size
        if (size := _SIZES.get(self._tape[at + _KIND_AT])) is not None:
            return start, size
        return start + _SIZE.size, _SIZE.unpack_from(self._tape, start)[0]


_HEAD = struct.Struct("<IdB")
_KIND_AT = 12
_SIZE = struct.Struct("<I")
_SIZES: dict[int, int] = {Taped.ASKED: 8, Taped.ANSWERED: 24}
"""How long the content of a kind is, where it is always the same."""
_PACKETS = (1, 1, 1, 2)
"""How many packets each kind stands for."""


class Polls:
    """The STATUS questions of a link: when the next is due, which are open, how long answers take."""

    __slots__ = ("_last", "_open", "_sum", "_times", "due", "lost", "sent")

    def __init__(self) -> None:
        self._open: tuple[tuple[int, Seconds], ...] = ()
        self.due = Seconds(0.0)
        self.sent = self.lost = self._times = 0
        self._last = self._sum = 0.0

    def __contains__(self, cmd_id: int) -> bool:
        """Whether the question with this CMD_ID is open."""
        return any(each == cmd_id for each, _ in self._open)

    def __len__(self) -> int:
        return len(self._open)

    def oldest(self, otherwise: int) -> int:
        """Return the CMD_ID of the oldest open question."""
        return self._open[0][0] if self._open else otherwise

    def asked(self, cmd_id: int, now: Seconds, answer: Seconds) -> None:
        """Note a question; the next one is due when its answer is late."""
        if self._open and now >= self.due:
            self.lost += 1
        self._open = (*self._open[1 - POLLS_KEPT :], (cmd_id, now))
        self.sent += 1
        self.due = Seconds(now + answer)

    def answered(self, cmd_id: int, now: Seconds, interval: Seconds) -> Seconds:
        """Note the answer to an open question; earlier ones are forgotten. Return when it was asked."""
        asked = self._moment(cmd_id)
        self._open = tuple([entry for entry in self._open if entry[1] >= asked and entry[0] != cmd_id])
        if not self._open:
            self.due = Seconds(max(asked + interval, now))
        self._last = (now - asked) * 1000.0
        self._sum += self._last
        self._times += 1
        return asked

    def refused(self, cmd_id: int, interval: Seconds) -> None:
        """Note a NAK: the question is asked anew, under another CMD_ID, at the next turn."""
        asked = self._moment(cmd_id)
        self._open = tuple([entry for entry in self._open if entry[0] != cmd_id])
        self.lost += 1
        self.due = min(self.due, Seconds(asked + interval))

    def forget(self) -> None:
        """Forget the open questions: the connection is gone."""
        self._open = ()

    def _moment(self, cmd_id: int) -> Seconds:
        return next(when for each, when in self._open if each == cmd_id)

    @property
    def round_trip_last(self) -> float | None:
        """Milliseconds from the newest answered question to its answer."""
        return self._last if self._times else None

    @property
    def round_trip_mean(self) -> float | None:
        """The same, mean of all."""
        return self._sum / self._times if self._times else None
