"""How a link is doing: its life, its polls, its figures, what it remembers of the packets received (PROTOCOLS 6.1, I23)."""

from dataclasses import dataclass
from enum import Enum, auto

from app.domain.units import Seconds

SEEN_KEPT = 64
"""At least as many packets are remembered (I23), at most twice as many."""
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
    """The packets received lately: two generations, so that forgetting costs nothing per packet."""

    __slots__ = ("before", "latest")

    def __init__(self) -> None:
        self.latest: set[bytes] = set()
        self.before: set[bytes] = set()

    def __contains__(self, packet: bytes) -> bool:
        return packet in self.latest or packet in self.before

    def add(self, packet: bytes) -> None:
        """Remember a packet."""
        self.latest.add(packet)
        if len(self.latest) >= SEEN_KEPT:
            self.turn()

    def turn(self) -> None:
        """Forget the older generation: the newer one is full."""
        self.before, self.latest = self.latest, set()

    def clear(self) -> None:
        """Forget all: another connection, another memory."""
        self.latest.clear()
        self.before.clear()


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
