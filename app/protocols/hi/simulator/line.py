"""The drives' end of a line: several drives hear the same bytes, at most one answers (PROTOCOLS 2.3, 5.2)."""

import heapq
from collections.abc import Iterable, Mapping
from itertools import count
from types import MappingProxyType

from app.domain.units import Seconds
from app.protocols.hi.codec import encode
from app.protocols.hi.dialects import DEFAULT, Dialect
from app.protocols.hi.framing import Assembler, Decoder, Garbled, Reason
from app.protocols.hi.messages import Frame
from app.protocols.hi.simulator.drive import SimulatedDrive

FLUSH_AFTER = Seconds(0.03)
"""Silence after which an incomplete packet is given up. Our choice: longer than the longest packet takes."""


class SimulatedLine:
    """An :class:`app.domain.ports.Endpoint` with drives at its far end. ``outgoing`` gives one packet at a call.

    The drives live on without a connection. Raises: ValueError: two drives have one id.
    """

    def __init__(self, drives: Iterable[SimulatedDrive], dialect: Dialect = DEFAULT) -> None:
        self._drives: dict[int, SimulatedDrive] = {}
        for drive in drives:
            if drive.id in self._drives:
                raise ValueError(f"two drives have id {drive.id}")
            self._drives[drive.id] = drive
        self._dialect = dialect
        self._decoder, self._assembler = Decoder(dialect), Assembler()
        self._up = False
        self._now = Seconds(0.0)
        self._flush_at: Seconds | None = None
        self._answers: list[tuple[float, int, bytes]] = []
        self._order = count()

    @property
    def drives(self) -> Mapping[int, SimulatedDrive]:
        """The drives by id."""
        return MappingProxyType(self._drives)

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next."""
        times = [Seconds(self._answers[0][0])] if self._answers else []
        if self._flush_at is not None:
            times.append(self._flush_at)
        return min(times, default=None)

    @property
    def wants_close(self) -> bool:
        """Never: drives do not hang up."""
        return False

    def connected(self, now: Seconds) -> None:
        """A master is there; nothing of an earlier one is left."""
        self._clear(now)
        self._up = True

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is cut; what the drives do goes on."""
        self._clear(now)
        self._up = False

    def received(self, data: bytes, now: Seconds) -> None:
        """Take bytes; never raises."""
        if not self._up:
            return
        self.tick(now)
        for item in self._decoder.feed(data):
            self._take(item, now)
        self._flush_at = Seconds(now + FLUSH_AFTER) if self._decoder.pending else None

    def tick(self, now: Seconds) -> None:
        """Let everything happen that is due."""
        self._now = max(self._now, now)
        if self._flush_at is not None and self._flush_at <= now:
            self._flush_at = None
            for item in self._decoder.flush():
                self._take(item, now)

    def outgoing(self) -> bytes:
        """Return and forget the next packet whose turnaround is over; empty if there is none."""
        if self._answers and self._answers[0][0] <= self._now:
            return heapq.heappop(self._answers)[2]
        return b""

    def _clear(self, now: Seconds) -> None:
        self._now = max(self._now, now)
        self._decoder.flush()
        self._assembler.flush()
        self._answers.clear()
        self._flush_at = None

    def _take(self, item: Frame | Garbled, now: Seconds) -> None:
        if isinstance(item, Garbled):
            broken = item.of
            if item.reason is Reason.BCC and broken is not None:
                for drive in self._drives.values():
                    self._say(drive, drive.take_broken(broken, now), now)
            return
        for whole in self._assembler.add(item):
            if isinstance(whole, Frame):
                for drive in self._drives.values():
                    self._say(drive, drive.take(whole, now), now)

    def _say(self, drive: SimulatedDrive, answer: Frame | None, now: Seconds) -> None:
        if answer is not None:
            at = now + drive.options.t2 + drive.mischief.late
            heapq.heappush(self._answers, (at, next(self._order), encode(answer, self._dialect)))
