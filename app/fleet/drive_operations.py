"""Operations on drives, from their acceptance to their end: each is kept, shown, and ends in one visible way."""

from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from math import inf

from app.domain.drive import (
    DriveDone,
    DriveFailed,
    DriveId,
    DriveRequest,
    DriveRequestId,
    DriveUnknown,
    Jog,
    JogBegan,
    JogEnd,
    KeepJogging,
    Key,
    Parameter,
    PressKey,
    ReleaseJog,
    SetInputs,
    Setting,
)
from app.domain.drive_records import DriveOperation, DriveValue, OperationKind, OperationState
from app.domain.ids import Actor, LinkId
from app.domain.job import JobEvent
from app.domain.links import LinkSend
from app.domain.requests import Accepted
from app.domain.units import Seconds
from app.domain.view import Topic
from app.fleet.books import SYSTEM, Books
from app.fleet.drive import DriveNow, named, said, view_of_operation
from app.fleet.drive_tasks import Ask, AwaitOnline, End, HoldKey, Task, Verdict, Work, failed

SHOWN_ENDED = 100
"""How many ended operations the live model still shows. Our choice; the database has them all."""


@dataclass(slots=True)
class Running:
    """An operation under way. ``waits_for``: the request whose end is awaited. ``broken_off``: why nothing more is asked.

    ``read``: what it has read so far, kept at its end.
    """

    record: DriveOperation
    task: Task
    work: Work
    waits_for: DriveRequestId | None = None
    asked: Ask | None = None
    broken_off: Verdict | None = None
    read: dict[tuple[str, int], DriveValue] = field(default_factory=dict)


class Operations:
    """All operations under way. ``Begin`` one, tell it how questions ended; it asks the next, keeps and shows itself."""

    def __init__(
        self,
        books: Books,
        drives: Mapping[DriveId, DriveNow],
        show: Callable[[DriveNow], None],
        open_ones: tuple[DriveOperation, ...],
        next_number: int,
    ) -> None:
        self._books, self._drives, self._show_drive = books, drives, show
        self._next_number = next_number
        self._requests = 0
        self._running: dict[int, Running] = {}
        self._waiting: dict[DriveRequestId, int] = {}
        self._awaited: dict[DriveRequestId, tuple[DriveId, Seconds]] = {}
        self._ended: deque[int] = deque()
        self._doubts: dict[DriveId, list[Parameter]] = {}
        for operation in open_ones:
            verdict = _after_restart(operation)
            self._close(operation, verdict)
            if verdict.state is OperationState.UNKNOWN and operation.drive is not None:
                self._doubts.setdefault(operation.drive, []).extend(_written_last(operation))

    def doubts(self, drive: DriveId) -> tuple[Parameter, ...]:
        """Return and forget the parameters of which nobody knows whether an earlier process wrote them."""
        return tuple(dict.fromkeys(self._doubts.pop(drive, [])))

    def new_request(self) -> DriveRequestId:
        """Return an identity that no request of this process had."""
        self._requests += 1
        return DriveRequestId(self._requests)

    @property
    def next_number(self) -> int:
        """The number that the next operation will have."""
        return self._next_number

    def get(self, number: int) -> DriveOperation | None:
        """Return an operation under way."""
        running = self._running.get(number)
        return running.record if running else None

    def of_drive(self, drive: DriveId) -> list[DriveOperation]:
        """Return what is under way on a drive."""
        return [running.record for running in self._running.values() if running.record.drive == drive]

    def on_line(self, line: LinkId) -> list[DriveOperation]:
        """Return what is under way on a line."""
        return [running.record for running in self._running.values() if running.record.line == line]

    def begin(
        self,
        kind: OperationKind,
        line: LinkId,
        drive: DriveNow | None,
        actor: Actor,
        task: Task,
        work: Work,
        body: Mapping[str, object],
    ) -> Accepted:
        """Accept an operation and ask its first question."""
        record = DriveOperation(
            self._next_number,
            kind,
            OperationState.RUNNING,
            self._books.utc,
            actor,
            line,
            drive.id if drive else None,
            body,
            total=work.total,
        )
        self._next_number += 1
        running = self._running[record.number] = Running(record, task, work)
        if drive is not None and kind.changes:
            drive.operation = record.number
            self._show_drive(drive)
        self._keep(running)
        self._go_on(running, None)
        return Accepted(Topic.OPERATIONS, str(record.number), created=True)

    def request_of(self, number: int) -> DriveRequestId | None:
        """Return the request that an operation waits for."""
        running = self._running.get(number)
        return running.waits_for if running else None

    def hold(self, number: int, until: Seconds | None) -> LinkSend | None:
        """Return what tells the line that a jog goes on until then, or (None) ends. One that has not left never will then."""
        running = self._running[number]
        if running.waits_for is None:
            return None
        if until is not None:
            return LinkSend(running.record.line, KeepJogging(running.waits_for, until))
        self.break_off(number, failed("the key was let go before it could begin"))
        return LinkSend(running.record.line, ReleaseJog(running.waits_for))

    def break_off(self, number: int, verdict: Verdict) -> None:
        """Ask nothing more for an operation. It ends with what it waits for, since that may be on its way."""
        running = self._running.get(number)
        if running is None or running.broken_off is not None:
            return
        running.broken_off = verdict
        if running.waits_for in self._awaited:
            drive, _ = self._awaited.pop(running.waits_for)
            self.ended(DriveFailed(drive, running.waits_for, verdict.reason))

    @property
    def deadline(self) -> Seconds:
        """When ``tick`` wants to be called next; infinite if nothing is to be done."""
        return min((until for _, until in self._awaited.values()), default=Seconds(inf))

    def tick(self) -> None:
        """Give up waiting for drives that do not come back."""
        for request, (drive, until) in list(self._awaited.items()):
            if until <= self._books.now and request in self._awaited:
                del self._awaited[request]
                self.ended(DriveFailed(drive, request, f"{drive} did not answer again"))

    def back(self, drive: DriveId) -> None:
        """A drive answers again."""
        for request, (awaited, _) in list(self._awaited.items()):
            if awaited == drive and request in self._awaited:
                del self._awaited[request]
                self.ended(DriveDone(drive, request, None))

    def objection(self, request: DriveRequestId) -> str:
        """Return why a request must not leave any more now that it is durable; empty if it may."""
        running = self._running.get(self._waiting.get(request, 0))
        return running.broken_off.reason if running is not None and running.broken_off is not None else ""

    def began(self, event: JogBegan) -> None:
        """An axis begins to move."""
        running = self._running.get(self._waiting.get(event.request, 0))
        if running is not None:
            drive = self._drives[event.drive]
            drive.jogging = True
            drive.told_to_move(self._books.now)
            self._show_drive(drive)
            running.work.result["moving"] = True
            self._show(running)

    def ended(self, event: End) -> bool:
        """A question ended; return whether it was an operation's."""
        number = self._waiting.pop(event.request, None)
        running = self._running.get(number or 0)
        if running is None:
            return False
        running.waits_for = None
        self._take_over(running, event)
        self._go_on(running, event)
        return True

    # -- going on -----------------------------------------------------------------------------------------------------

    def _take_over(self, running: Running, event: End) -> None:
        """Learn what a question's end says of the drive."""
        asked = running.asked
        if isinstance(event, DriveDone) and isinstance(event.result, Setting) and event.drive is not None:
            setting = event.result
            value = DriveValue(event.drive, setting.parameter, setting.value, self._books.utc)
            running.read[event.drive, setting.parameter] = value
        if asked is not None and asked.drive is not None and isinstance(asked.command, HoldKey):
            self._drives[asked.drive].jogging = False
        if asked is None or not isinstance(event, DriveDone | DriveUnknown):
            return
        command = asked.command
        told = [self._drives[asked.drive]] if asked.drive else self._on(running.record.line)
        for drive in told:
            stopped = command == PressKey(Key.STOP_RESET) or isinstance(command, HoldKey)
            if stopped and isinstance(event, DriveDone):
                drive.stopped()
            elif _moves(command):
                drive.told_to_move(self._books.now)
            self._show_drive(drive)

    def _on(self, line: LinkId) -> list[DriveNow]:
        return [drive for drive in self._drives.values() if drive.spec.link == line]

    def _go_on(self, running: Running, end: End | None) -> None:
        try:
            asked = next(running.task) if end is None else running.task.send(end)
        except StopIteration as over:
            self._note_changes(running)
            self._end(running, running.broken_off if _did_not_leave(running, end) else over.value, end)
            return
        self._note_changes(running)
        if running.broken_off is not None:
            running.task.close()
            self._end(running, running.broken_off, end)
            return
        self._ask(running, asked)

    def _ask(self, running: Running, asked: Ask) -> None:
        request = self.new_request()
        running.waits_for, running.asked = request, asked
        self._waiting[request] = running.record.number
        if asked.reads:
            self._show(running)
        else:
            self._keep(running)
        if isinstance(asked.command, AwaitOnline) and asked.drive is not None:
            self._awaited[request] = asked.drive, Seconds(self._books.now + asked.command.within)
            return
        line = running.record.line if asked.drive is None else self._drives[asked.drive].spec.link
        self._books.effects.link_sends.append(LinkSend(line, _order(request, asked)))

    def _note_changes(self, running: Running) -> None:
        """A parameter changed by our doing: for the history, and as known from now on."""
        drive = self._drives.get(running.record.drive) if running.record.drive else None
        changes, running.work.changes = running.work.changes, []
        if drive is None:
            return
        for change in changes:
            value = DriveValue(drive.id, change.parameter, change.after, self._books.utc)
            drive.values[change.parameter] = value
            running.read[drive.id, change.parameter] = value
            before, after = said(drive, change.parameter, change.before), said(drive, change.parameter, change.after)
            self._books.event(
                JobEvent.DRIVE_WRITTEN,
                source=drive.id,
                result=after,
                detail=f"{named(drive, change.parameter)}: {before} -> {after}, by {running.record.actor}",
            )

    def _end(self, running: Running, verdict: Verdict | None, end: End | None) -> None:
        record = running.record
        if isinstance(end, DriveUnknown) and running.broken_off is not None:
            verdict = Verdict(OperationState.UNKNOWN, end.reason, "look at the drive's status, and decide")
        del self._running[record.number]
        self._books.effects.records += running.read.values()
        drive = self._drives.get(record.drive) if record.drive else None
        if drive is not None and drive.operation == record.number:
            drive.operation = None
        self._close(self._present(running), verdict or failed("it was broken off"))
        if drive is not None:
            self._show_drive(drive)

    def _close(self, operation: DriveOperation, verdict: Verdict) -> None:
        books = self._books
        closed = replace(operation, state=verdict.state, closed=books.utc, reason=verdict.reason, remedy=verdict.remedy)
        books.effects.records.append(closed)
        books.show(Topic.OPERATIONS, str(closed.number), view_of_operation(closed))
        if closed.kind is OperationKind.JOG:
            outcome = str(closed.result.get("ended") or f"{closed.state.value}: {closed.reason}")
            target, detail = closed.drive or closed.line, f"operation {closed.number}, {outcome}"
            who = closed.actor if outcome == JogEnd.RELEASED else SYSTEM
            books.audit(who, "JogEnd", target, detail, accepted=True)
        self._ended.append(closed.number)
        if len(self._ended) > SHOWN_ENDED:
            books.show(Topic.OPERATIONS, str(self._ended.popleft()), None)

    # -- keeping and showing ------------------------------------------------------------------------------------------

    def _present(self, running: Running) -> DriveOperation:
        work = running.work
        running.record = replace(running.record, done=work.done, total=work.total, result=_copied(work.result))
        return running.record

    def _keep(self, running: Running) -> None:
        """Make it durable before what it asks next is sent."""
        self._books.effects.records.append(self._present(running))
        self._show(running)

    def _show(self, running: Running) -> None:
        record = self._present(running)
        self._books.show(Topic.OPERATIONS, str(record.number), view_of_operation(record))


def _did_not_leave(running: Running, end: End | None) -> bool:
    """Whether the last request was held back because the operation was broken off."""
    cut = running.broken_off
    return cut is not None and isinstance(end, DriveFailed) and end.reason == cut.reason


def _order(request: DriveRequestId, asked: Ask) -> DriveRequest | Jog:
    if isinstance(asked.command, HoldKey):
        assert asked.drive is not None
        return Jog(request, asked.drive, asked.command.turn, asked.command.until)
    assert not isinstance(asked.command, AwaitOnline)
    return DriveRequest(request, asked.drive, asked.command)


def _moves(command: object) -> bool:
    if isinstance(command, PressKey):
        return command.key is Key.RUN
    return isinstance(command, SetInputs) and (command.run or command.home)


def _copied(value: dict[str, object]) -> dict[str, object]:
    """Return a copy that later steps do not change."""
    return {key: _copy(inner) for key, inner in value.items()}


def _copy(value: object) -> object:
    if isinstance(value, dict):
        return dict(value)
    if isinstance(value, list):
        return [dict(item) if isinstance(item, dict) else item for item in value]
    return value


def _after_restart(operation: DriveOperation) -> Verdict:
    if operation.kind.reads_only:
        return failed("the controller was started again while it was under way", "ask again")
    if operation.kind in {OperationKind.WRITE, OperationKind.RESTORE} and not _written_last(operation):
        return failed("the controller was started again before anything was written", "ask again")
    reason = "the controller was started again while it was under way; what was sent may have taken effect"
    return Verdict(OperationState.UNKNOWN, reason, "look at the drive, and compare it with a backup")


def _written_last(operation: DriveOperation) -> list[Parameter]:
    """Return the parameters that may have been written without anybody knowing; kept before the write left."""
    if operation.kind is OperationKind.WRITE and "before" in operation.result:
        return [Parameter(int(str(operation.body["parameter"]), 16))]
    rows = operation.result.get("rows")
    if operation.kind is not OperationKind.RESTORE or not isinstance(rows, list):
        return []
    return [Parameter(int(row["parameter"], 16)) for row in rows if row["fate"] == "being written"]
