"""The one master of a drive line (PROTOCOLS 2.3, 6.1, 6.2; COMMANDS section 1)."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from app.domain import drive as domain
from app.domain.drive import DriveEvent, DriveId, DriveLineId, DriveRequest, DriveRequestId, DriveSpec, Key
from app.domain.errors import EncodeError
from app.domain.units import Seconds
from app.protocols.hi.dialects import DEFAULT, Dialect
from app.protocols.hi.messages import ALL_DRIVES, Cmd
from app.protocols.hi.session import scripts
from app.protocols.hi.session.drives import Drive, Drives, DriveView
from app.protocols.hi.session.line import Answer, Figures, Line, No, Way
from app.protocols.hi.session.queue import Operation, Priority, Queue
from app.protocols.hi.session.requests import end_of, moves, on_the_wire, script_for, script_for_all
from app.protocols.hi.session.steps import (
    Ask,
    Failed,
    Heard,
    Missed,
    Outcome,
    Pause,
    Repeat,
    Verdict,
    Woken,
)
from app.protocols.hi.session.steps import Unknown as Doubtful
from app.protocols.hi.session.timing import Timing

_READS = frozenset({Cmd.SET, Cmd.SSQ})


class LineSession:
    """An :class:`app.domain.ports.Endpoint` that asks the drives of one line, one at a time, and tells what it learns.

    A request ends in exactly one of DriveDone, DriveFailed, DriveUnknown. A Stop key goes out before everything that waits,
    and ends what would make its drive move. A drive that does not answer five times is offline until it answers again.
    """

    def __init__(
        self,
        line: DriveLineId,
        drives: Iterable[DriveSpec],
        dialect: Dialect = DEFAULT,
        timing: Timing | None = None,
    ) -> None:
        """Raises: ValueError: two drives have one name or address, or an address is not from 1 to 15."""
        self.line, self.timing = line, timing or Timing()
        self._drives = Drives(drives, self.timing.poll)
        self._events: list[DriveEvent] = []
        self._wire = Line(line, dialect, self.timing, self._events)
        self._queue = Queue()
        self._open: Operation | None = None
        self._up = False

    # Endpoint

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next; None while the line is down."""
        if not self._up:
            return None
        if self._open is not None:
            return self._wire.due
        times = [] if self._queue.due is None else [self._queue.due]
        waiting = None if self._queue.jog else self._drives.due()
        if waiting is not None:
            times.append(waiting.poll_at)
        return max(self._wire.free_at, min(times)) if times else None

    @property
    def wants_close(self) -> bool:
        """Never: a silent line may have drives that are switched off."""
        return False

    def connected(self, now: Seconds) -> None:
        """The line is up; all drives are asked for their status."""
        self._up = True
        self._wire.reset()
        self._drives.forget(now)
        self._events.append(domain.DriveLineUp(self.line))
        self._advance(now)

    def received(self, data: bytes, now: Seconds) -> None:
        """Take bytes; never raises."""
        if self._up:
            for answer in self._wire.take(data, now):
                self._answered(answer, now)
            self._advance(now)

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down: what was not answered is unknown, what was not sent has failed."""
        if not self._up:
            return
        self._up = False
        if self._open is not None:
            self._doubt(self._open)
        self._open = None
        self._wire.reset()
        for operation in self._queue:
            self._break_off(operation, f"the line is down: {reason}")
        self._drives.forget(now)
        self._events.append(domain.DriveLineDown(self.line, reason))

    def tick(self, now: Seconds) -> None:
        """Do what is due."""
        if self._up:
            self._advance(now)

    def outgoing(self) -> bytes:
        """Return and forget the bytes to send."""
        return self._wire.outgoing()

    # For whoever asks

    def events(self) -> list[DriveEvent]:
        """Return and forget what has happened, in order."""
        events = self._events.copy()
        self._events.clear()
        return events

    @property
    def drives(self) -> Mapping[DriveId, DriveView]:
        """What is known of each drive."""
        return MappingProxyType({drive.spec.id: drive.view for drive in self._drives})

    @property
    def figures(self) -> Figures:
        """How the line is doing, to be read only."""
        return self._wire.figures

    @property
    def last_frames(self) -> list[tuple[Seconds, Way, bytes]]:
        """The last packets of the line, oldest first: when, ``in`` or ``out``, bytes."""
        return list(self._wire.frames)

    def request(self, request: DriveRequest, now: Seconds) -> None:
        """Take a request; an event tells how it ended, at once if it cannot even be begun."""
        drive = None if request.drive is None else self._drives.named(request.drive)
        stops = request.command == domain.PressKey(Key.STOP_RESET)
        refused = self._refusal(request.drive, drive, stops=stops)
        if refused is None and drive is None:
            refused = self._refusal_for_all(request.command)
        if refused is None:
            refused = self._unsayable(request.command)
        if refused is not None:
            self._events.append(end_of(request.drive, request.id, refused))
            return
        if stops:
            self._end_motion(drive)
        if drive is None:
            script = script_for_all(request.command, self._answering)
        else:
            script = script_for(request.command, drive.spec.address, self.timing.retries + 1)
        rank = Priority.STOP if stops else Priority.REQUEST
        self._begin(Operation(script, drive, rank, request.id, moves=moves(request.command)), now)

    def jog(self, jog: domain.Jog, now: Seconds) -> None:
        """Begin to jog: JogBegan, then the keys, then Stop/Reset once the caller has let go or has not said more in time."""
        drive = self._drives.named(jog.drive)
        refused = self._refusal(jog.drive, drive)
        if refused is None and self._queue.jog is not None:
            refused = Failed("another jog has the line", "wait until it is over")
        if refused is not None or drive is None:
            self._events.append(end_of(jog.drive, jog.id, refused or Failed("there is no such drive")))
            return
        hold = scripts.Hold(jog.until)
        began = domain.JogBegan(jog.drive, jog.id)
        script = scripts.jog(drive.spec.address, jog.turn, hold, self.timing, lambda: self._events.append(began))
        self._begin(Operation(script, drive, Priority.JOG, jog.id, hold=hold), now)

    def keep_jogging(self, request: DriveRequestId, until: Seconds) -> bool:
        """Move the moment at which a jog ends by itself; return whether it is still under way."""
        jog = self._queue.jog
        if jog is None or jog.request != request or jog.hold is None or jog.hold.released:
            return False
        jog.hold.until = until
        return True

    def release_jog(self, request: DriveRequestId, now: Seconds) -> None:
        """End a jog; one that is over already stays over."""
        jog = self._queue.jog
        if jog is not None and jog.request == request:
            self._release(jog, now)
            self._advance(now)

    # What may be asked

    def _refusal(self, name: DriveId | None, drive: Drive | None, *, stops: bool = False) -> Failed | None:
        if name is not None and drive is None:
            return Failed(f"drive {name} is not on line {self.line}")
        if not self._up:
            return Failed(f"line {self.line} is down")
        if drive is not None and drive.online is False and not stops:
            return Failed("the drive is offline", "switch it on and check its cable and its id")
        return None

    def _refusal_for_all(self, command: domain.DriveCommand) -> Failed | None:
        if isinstance(command, domain.AskStatus | domain.ReadParameter):
            return Failed("only one drive at a time can answer", "ask them one by one")
        broken = [drive.spec.id for drive in self._drives if drive.in_error] if moves(command) else []
        return Failed(f"in error: {', '.join(broken)}", "reset them first") if broken else None

    def _unsayable(self, command: domain.DriveCommand) -> Failed | None:
        try:
            self._wire.packet(Ask(ALL_DRIVES, *on_the_wire(command)))
        except EncodeError as wrong:
            return Failed(wrong.message)
        return None

    def _answering(self) -> list[tuple[str, int]]:
        return [(drive.spec.id, drive.spec.address) for drive in self._drives if drive.online is not False]

    # The life of an operation

    def _begin(self, operation: Operation, now: Seconds) -> None:
        self._queue.add(operation)
        self._turn_to(operation, next(operation.script), now)
        self._advance(now)

    def _turn_to(self, operation: Operation, step: Ask | Pause, now: Seconds) -> None:
        if isinstance(step, Ask):
            operation.look_at(step, now)
        else:
            operation.look_at(None, step.until)

    def _go_on(self, operation: Operation, outcome: Outcome, now: Seconds) -> None:
        try:
            step = operation.script.send(outcome)
        except StopIteration as stop:
            self._end(operation, stop.value)
        else:
            self._turn_to(operation, step, now)

    def _end(self, operation: Operation, verdict: Verdict | None) -> None:
        self._queue.remove(operation)
        operation.script.close()
        if operation.rank is Priority.POLL and operation.drive is not None:
            operation.drive.polling = False
        elif operation.request is not None and verdict is not None:
            name = None if operation.drive is None else operation.drive.spec.id
            self._events.append(end_of(name, operation.request, verdict))

    def _break_off(self, operation: Operation, reason: str) -> None:
        self._end(operation, Doubtful(reason) if operation.doubt else Failed(reason))

    def _end_motion(self, drive: Drive | None) -> None:
        """A person stops a drive, or all: nothing that was asked before may make it move afterwards."""
        for operation in self._queue:
            if not _concerns(operation, drive):
                continue
            if operation.hold is not None:
                operation.hold.released = True
            elif operation.moves and operation is self._open:
                operation.withdrawn = True
            elif operation.moves:
                self._break_off(operation, "Stop/Reset was pressed")

    def _release(self, jog: Operation, now: Seconds) -> None:
        if jog.hold is not None:
            jog.hold.released = True
        if jog.ask is None:
            jog.ready_at = now

    # The line

    def _advance(self, now: Seconds) -> None:
        while True:
            if self._open is not None:
                if now < self._wire.due:
                    return
                self._time_is_up(self._open, now)
            elif now < self._wire.free_at or (operation := self._next(now)) is None:
                return
            elif operation.ask is None:
                self._go_on(operation, Woken(now), now)
            elif now < (heard_at := self._wire.all_hear_at(operation.ask)):
                operation.ready_at = heard_at
            else:
                self._open = operation
                self._wire.ask(operation.ask, now)

    def _next(self, now: Seconds) -> Operation | None:
        ready = self._queue.next(now)
        drive = None if self._queue.jog else self._drives.due()
        if drive is None or drive.poll_at > now:
            return ready
        # Requests on end, such as reading all parameters, must not make the line blind. Our choice: after twice the time.
        overdue = drive.poll_at + self.timing.poll < now
        if ready is not None and (ready.priority < Priority.REQUEST or not overdue):
            return ready
        asks = scripts.probe if drive.online is False else scripts.poll
        poll = Operation(asks(drive.spec.address), drive, Priority.POLL)
        drive.polling = True
        self._queue.add(poll)
        self._turn_to(poll, next(poll.script), now)
        return poll

    def _close(self, now: Seconds, *, settled: bool) -> None:
        self._open = None
        self._wire.close(now, settled=settled)

    def _answered(self, answer: Answer, now: Seconds) -> None:
        operation = self._open
        if operation is None or operation.ask is None:
            return
        self._wire.figures.answered += 1
        self._close(now, settled=not operation.maybe)
        self._events += self._drives.heard(operation.ask, answer, now)
        if answer is No.NAK:
            self._wire.figures.naks += 1
            self._failed(operation, operation.ask, now)
        elif answer is No.BUSY:
            self._wire.figures.busies += 1
            self._busy(operation, operation.ask, now)
        elif operation.withdrawn and operation.ask.cmd is Cmd.SSQ:
            self._break_off(operation, "Stop/Reset was pressed")
        else:
            self._go_on(operation, Heard(answer), now)

    def _busy(self, operation: Operation, ask: Ask, now: Seconds) -> None:
        """Ask again after T1, which is no failure (H9, H10)."""
        operation.busy += 1
        if operation.withdrawn:
            self._break_off(operation, "Stop/Reset was pressed")
        elif ask.repeat is Repeat.NEVER or operation.busy > self.timing.busy_repeats:
            self._go_on(operation, Missed(f"the drive is busy: BSY to {ask.cmd}", operation.maybe), now)
        else:
            operation.ready_at = Seconds(now + self.timing.busy_repeat)

    def _time_is_up(self, operation: Operation, now: Seconds) -> None:
        ask = operation.ask
        for answer in self._wire.give_up_waiting(now):
            self._answered(answer, now)
        if self._open is not operation or ask is None:
            return
        if ask.address == ALL_DRIVES:
            self._close(now, settled=True)
            self._drives.ask_all(now)
            self._go_on(operation, Woken(now), now)
            return
        self._wire.figures.timeouts += 1
        self._doubt(operation)
        self._close(now, settled=True)
        self._failed(operation, ask, now)

    def _doubt(self, operation: Operation) -> None:
        operation.maybe = True
        operation.doubt |= operation.ask is not None and operation.ask.cmd not in _READS

    def _failed(self, operation: Operation, ask: Ask, now: Seconds) -> None:
        """Send the question again, or give it up (H10)."""
        operation.failures += 1
        given_up = operation.failures > self.timing.retries
        once = ask.repeat is Repeat.NEVER or (ask.repeat is Repeat.REFUSED and operation.maybe)
        if operation.withdrawn:
            self._break_off(operation, "Stop/Reset was pressed")
        elif given_up or once:
            what = "no answer" if operation.maybe else "NAK"
            reason = f"{what} to {ask.cmd} in {operation.failures} transmission{'s' * (operation.failures > 1)}"
            drive = self._drives.at(ask.address)
            if drive is not None:
                self._missed(drive, operation, reason if given_up else "", now)
            self._go_on(operation, Missed(reason, operation.maybe), now)
        else:
            operation.ready_at = now

    def _missed(self, drive: Drive, operation: Operation, reason: str, now: Seconds) -> None:
        if drive.online is False or operation.rank is Priority.POLL:
            drive.poll_at = Seconds(now + self.timing.probe)
        if not reason or drive.online is False:
            return
        drive.online = False
        drive.poll_at = Seconds(now + self.timing.probe)
        self._events.append(domain.DriveOffline(drive.spec.id, reason))
        for other in self._queue:
            if other is not operation and other.drive is drive and other.priority is Priority.REQUEST:
                self._break_off(other, f"the drive went offline: {reason}")


def _concerns(operation: Operation, drive: Drive | None) -> bool:
    """Whether an operation makes a drive (None: any) move, be it alone or with all the others."""
    return drive is None or operation.drive is None or operation.drive is drive
