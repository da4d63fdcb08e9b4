"""Which operation has the line next: Stop first, then a jog, then requests in their order, then polls (PROTOCOLS 6.2)."""

from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum

from app.domain.drive import DriveRequestId
from app.domain.units import Seconds
from app.protocols.hi.messages import Cmd
from app.protocols.hi.session.drives import Drive
from app.protocols.hi.session.scripts import Hold
from app.protocols.hi.session.steps import Ask, Script


class Priority(IntEnum):
    """Who comes first; a Stop/Reset key always does."""

    STOP = 0
    JOG = 1
    REQUEST = 2
    POLL = 3


@dataclass(slots=True)
class Operation:
    """A script under way. ``drive`` is None for all drives; ``ask`` None while it pauses, until ``ready_at``.

    ``failures`` and ``busy`` count answers to the present ask, ``maybe``: one of its transmissions stayed without an answer;
    ``doubt``: so did a command of the operation that does something. ``moves``: Stop ends it. ``withdrawn``: Stop has.
    """

    script: Script
    drive: Drive | None
    rank: Priority
    request: DriveRequestId | None = None
    moves: bool = False
    hold: Hold | None = None
    ask: Ask | None = None
    ready_at: Seconds = Seconds(0.0)
    failures: int = 0
    busy: int = 0
    maybe: bool = False
    doubt: bool = False
    withdrawn: bool = False

    @property
    def priority(self) -> Priority:
        """Its place in the order, by what it asks now."""
        return Priority.STOP if self.ask is not None and self.ask.cmd is Cmd.SRK else self.rank

    @property
    def jogs(self) -> bool:
        """Whether it is a jog, to its last Stop."""
        return self.rank is Priority.JOG

    def look_at(self, ask: Ask | None, ready_at: Seconds) -> None:
        """Turn to the next step."""
        self.ask, self.ready_at = ask, ready_at
        self.failures = self.busy = 0
        self.maybe = False


class Queue:
    """The operations of a line, oldest first."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []

    def __iter__(self) -> Iterator[Operation]:
        return iter(list(self.operations))

    def add(self, operation: Operation) -> None:
        """Enter an operation."""
        self.operations.append(operation)

    def remove(self, operation: Operation) -> None:
        """Take an operation out."""
        self.operations.remove(operation)

    @property
    def jog(self) -> Operation | None:
        """The jog under way. While it lasts nothing but Stop keys comes between (2.6)."""
        return next((operation for operation in self.operations if operation.jogs), None)

    def eligible(self) -> list[Operation]:
        """Return what may have the line, ready or not, the first first."""
        allowed = list(self._stops_and_jog()) if self.jog else list(self._in_turn())
        return sorted(allowed, key=lambda operation: operation.priority)

    def _stops_and_jog(self) -> Iterator[Operation]:
        return (operation for operation in self.operations if operation.priority <= Priority.JOG)

    def _in_turn(self) -> Iterator[Operation]:
        """Give all but requests that must wait for an earlier one to the same drive, or to or for all drives."""
        waiting: set[int] = set()
        for operation in self.operations:
            if operation.priority is not Priority.REQUEST:
                yield operation
                continue
            key = 0 if operation.drive is None else operation.drive.spec.address
            if not (waiting if key == 0 else waiting & {0, key}):
                yield operation
            waiting.add(key)

    def next(self, now: Seconds) -> Operation | None:
        """Return the first that is ready."""
        return next((operation for operation in self.eligible() if operation.ready_at <= now), None)

    @property
    def due(self) -> Seconds | None:
        """When the next one is ready."""
        return min((operation.ready_at for operation in self.eligible()), default=None)
