"""Parameters that somebody watches live: polled one at a time, as long as somebody does."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf

from app.domain.drive import DriveId, DriveRequest, DriveRequestId, Parameter, ReadParameter
from app.domain.drive_requests import WatchDrive
from app.domain.errors import Refusal
from app.domain.ids import LinkId
from app.domain.links import LinkSend
from app.domain.requests import Accepted
from app.domain.units import Seconds
from app.domain.view import Topic
from app.fleet.books import Books
from app.fleet.drive import DriveNow, view_of_parameter
from app.fleet.drive_operations import Operations

MOST_WATCHED = 16
"""Parameters in one watch. Our choice: all are read again within about two seconds at 9600 bps."""
MOST_WATCHES = 64
"""Watches at a time. Our choice."""
PAUSE = Seconds(0.05)
"""Rest of a line between two polls of watched parameters. Our choice."""
PAUSE_WHEN_BUSY = Seconds(1.0)
"""The same while somebody's operation is under way on the line: that goes first. Our choice."""


@dataclass(frozen=True, slots=True)
class Watch:
    """Somebody watches parameters of a drive until a moment."""

    drive: DriveId
    parameters: tuple[Parameter, ...]
    until: Seconds


class Watches:
    """Who watches what. At most one question of a line is open for all of them; each has its turn."""

    def __init__(self, books: Books, drives: Mapping[DriveId, DriveNow], operations: Operations) -> None:
        self._books, self._drives, self._operations = books, drives, operations
        self._watches: dict[str, Watch] = {}
        self._open: dict[DriveRequestId, LinkId] = {}
        self._due: dict[LinkId, Seconds] = {}
        self._last: dict[tuple[DriveId, Parameter], Seconds] = {}

    def begin(self, word: WatchDrive) -> Accepted | Refusal:
        """Watch, or watch on, or watch something else."""
        drive = self._drives[word.drive]
        if not 1 <= len(word.parameters) <= MOST_WATCHED:
            return Refusal(
                "invalid", f"one to {MOST_WATCHED} parameters can be watched at once", "watch fewer", "parameters"
            )
        if word.watch not in self._watches and len(self._watches) >= MOST_WATCHES:
            return Refusal("not-now", f"{MOST_WATCHES} watch parameters already", "end one of those watches")
        until = Seconds(inf) if word.seconds is None else Seconds(self._books.now + word.seconds)
        before = self._watches.get(word.watch)
        self._watches[word.watch] = Watch(word.drive, word.parameters, until)
        self._show(before)
        self._show(self._watches[word.watch])
        self._due.setdefault(drive.spec.link, self._books.now)
        self.tick()
        return Accepted(Topic.DRIVES, word.drive)

    def end(self, watch: str) -> bool:
        """Watch no more; return whether it was watched."""
        before = self._watches.pop(watch, None)
        self._show(before)
        return before is not None

    def watched(self, drive: DriveId, parameter: Parameter) -> bool:
        """Whether somebody watches a parameter."""
        return any(watch.drive == drive and parameter in watch.parameters for watch in self._watches.values())

    @property
    def deadline(self) -> Seconds:
        """When ``tick`` wants to be called next; infinite if nobody watches."""
        times = [watch.until for watch in self._watches.values()]
        times += [due for line, due in self._due.items() if line not in self._open.values()]
        return min(times, default=Seconds(inf))

    def tick(self) -> None:
        """End what is over, and ask what is due."""
        now = self._books.now
        for name in [name for name, watch in self._watches.items() if watch.until <= now]:
            self.end(name)
        for line, due in list(self._due.items()):
            if due <= now and line not in self._open.values():
                self._ask(line)

    def ended(self, request: DriveRequestId) -> bool:
        """A question ended; return whether it was for a watch."""
        line = self._open.pop(request, None)
        if line is None:
            return False
        busy = bool(self._operations.on_line(line))
        self._due[line] = Seconds(self._books.now + (PAUSE_WHEN_BUSY if busy else PAUSE))
        return True

    def _ask(self, line: LinkId) -> None:
        """Ask for the watched parameter of the line that was asked longest ago."""
        pairs = {
            (watch.drive, parameter)
            for watch in self._watches.values()
            for parameter in watch.parameters
            if self._drives[watch.drive].spec.link == line
        }
        if not pairs:
            del self._due[line]
            return
        answering = [pair for pair in pairs if self._answers(self._drives[pair[0]])]
        if not answering:
            self._due[line] = Seconds(self._books.now + PAUSE_WHEN_BUSY)
            return
        pair = min(answering, key=lambda one: (self._last.get(one, -inf), one))
        self._last[pair] = self._books.now
        request = self._operations.new_request()
        self._open[request] = line
        order = DriveRequest(request, pair[0], ReadParameter(pair[1]))
        self._books.effects.link_sends.append(LinkSend(line, order))

    @staticmethod
    def _answers(drive: DriveNow) -> bool:
        return drive.online is True and drive.record.lockout is None

    def _show(self, watch: Watch | None) -> None:
        """Show that parameters are watched, or no longer."""
        if watch is None:
            return
        drive = self._drives[watch.drive]
        for number in watch.parameters:
            view = view_of_parameter(drive, number, watched=self.watched(watch.drive, number))
            self._books.show(Topic.PARAMETERS, f"{drive.id}/{view.number}", view)
