"""What people ask about drives: accepted as an operation, or refused with what would help (DOMAIN section 7)."""

from collections.abc import Callable, Mapping
from dataclasses import replace

from app.domain.catalogue import HIGHEST_RAW, ParameterSpec
from app.domain.drive import (
    AskStatus,
    DriveCommand,
    DriveId,
    DriveMode,
    Key,
    Parameter,
    PressKey,
    RawValue,
)
from app.domain.drive_errors import explained
from app.domain.drive_records import DriveBackup, OperationKind
from app.domain.drive_requests import (
    AskDriveStatus,
    BackUpDrive,
    CancelDriveOperation,
    CompareDrive,
    DriveOrder,
    JogDrive,
    KeepDriveJog,
    LockDrive,
    PressDriveKey,
    ReadDrive,
    ReleaseDriveJog,
    RestoreDrive,
    SetDriveInputs,
    StopDriveLine,
    UnlockDrive,
    WriteDrive,
)
from app.domain.errors import Refusal
from app.domain.ids import Actor
from app.domain.layout import Wire
from app.domain.links import LinkSend
from app.domain.lockout import Lockout
from app.domain.requests import Accepted, Reply
from app.domain.units import Seconds
from app.domain.view import Topic
from app.fleet import drive_tasks as tasks
from app.fleet.books import SYSTEM, Books
from app.fleet.drive import DriveNow, hexed, named
from app.fleet.drive_operations import Operations
from app.fleet.drive_tasks import Ask, HoldKey, Task, Work
from app.fleet.refusals import in_emergency, not_lifted

JOG_HOLD = Seconds(0.5)
"""A jog ends so long after the caller has last said that the key is held. Our choice: two lost messages of five a second."""
MOST_OPEN = 8
"""Operations under way on one drive at a time. Our choice."""


def no_drive(name: str) -> Refusal:
    """Refusal for a drive that the plant does not have."""
    return Refusal("not-found", f"there is no drive {name}", "see GET /api/v1/drives")


class DriveOrders:
    """Answers requests about drives."""

    def __init__(
        self,
        books: Books,
        drives: Mapping[DriveId, DriveNow],
        operations: Operations,
        show: Callable[[DriveNow], None],
    ) -> None:
        self._books, self._drives, self._operations, self._show = books, drives, operations, show

    def answer(self, request: DriveOrder) -> Reply:
        """Accept or refuse."""
        if isinstance(request, StopDriveLine):
            return self._stop_line(request)
        if isinstance(request, CancelDriveOperation):
            return self._cancel(request)
        drive = self._drives.get(request.drive)
        if drive is None:
            return no_drive(request.drive)
        match request:
            case LockDrive():
                return self._lock(drive, request)
            case UnlockDrive():
                return self._unlock(drive, request)
            case AskDriveStatus():
                task, work = self._single(drive, AskStatus())
                return self._refusal(drive, harmless=True) or self._begin(
                    OperationKind.STATUS, drive, request.actor, task, work
                )
            case PressDriveKey():
                return self._key(drive, request)
            case ReadDrive() | BackUpDrive() | CompareDrive():
                return self._refusal(drive) or self._reading(drive, request)
            case SetDriveInputs() | WriteDrive() | RestoreDrive() | JogDrive():
                return self._refusal(drive, changes=True) or self._changing(drive, request)

    def look(self, drive: DriveNow, parameters: tuple[Parameter, ...]) -> None:
        """Ask a drive itself what an earlier process may have written (COMMANDS: after any doubt the machine is asked)."""
        self._reading(drive, ReadDrive(SYSTEM, drive.id, parameters))

    def keep_jog(self, word: KeepDriveJog) -> tuple[Reply, list[LinkSend]]:
        """The key is still held."""
        return self._word(word.operation, Seconds(self._books.now + JOG_HOLD))

    def release_jog(self, word: ReleaseDriveJog) -> tuple[Reply, list[LinkSend]]:
        """The key is let go."""
        return self._word(word.operation, None)

    # -- what is asked of the line ------------------------------------------------------------------------------------

    def _reading(self, drive: DriveNow, request: ReadDrive | BackUpDrive | CompareDrive) -> Reply:
        match request:
            case ReadDrive(parameters=parameters):
                work = Work(total=len(parameters))
                body: dict[str, object] = {"parameters": [hexed(number) for number in parameters]}
                if len(parameters) == 256:
                    body = {"parameters": "all"}
                task = tasks.read(work, drive, parameters)
                return self._begin(OperationKind.READ, drive, request.actor, task, work, body)
            case BackUpDrive():
                return self._back_up(drive, request)
            case CompareDrive():
                return self._compare(drive, request)

    def _changing(self, drive: DriveNow, request: SetDriveInputs | WriteDrive | RestoreDrive | JogDrive) -> Reply:
        match request:
            case SetDriveInputs():
                inputs = request.inputs
                task, work = self._single(drive, inputs)
                body: dict[str, object] = {
                    "run": inputs.run,
                    "home": inputs.home,
                    "right_limit": inputs.right_limit,
                    "left_limit": inputs.left_limit,
                    "step": inputs.step,
                }
                refusal = self._stays(drive) if inputs.run or inputs.home else None
                return refusal or self._begin(OperationKind.INPUTS, drive, request.actor, task, work, body)
            case WriteDrive():
                return self._write(drive, request)
            case RestoreDrive():
                return self._restore(drive, request)
            case JogDrive():
                return self._jog(drive, request)

    def _begin(
        self,
        kind: OperationKind,
        drive: DriveNow,
        actor: Actor,
        task: Task,
        work: Work,
        body: Mapping[str, object] | None = None,
    ) -> Accepted:
        return self._operations.begin(kind, drive.spec.link, drive, actor, task, work, body or {})

    def _single(self, drive: DriveNow, command: DriveCommand | HoldKey) -> tuple[Task, Work]:
        work = Work()
        return tasks.once(work, Ask(drive.id, command)), work

    def _key(self, drive: DriveNow, request: PressDriveKey) -> Reply:
        stops = request.key is Key.STOP_RESET
        refusal = self._refusal(drive, harmless=stops, changes=not stops)
        if refusal is None and request.key in {Key.RUN, Key.UP, Key.DOWN}:
            refusal = self._stays(drive)
        if refusal is not None:
            return refusal
        if stops:
            self._break_off(drive, f"{request.actor} pressed stop")
        task, work = self._single(drive, PressKey(request.key))
        return self._begin(OperationKind.KEY, drive, request.actor, task, work, {"key": request.key.value})

    def _stop_line(self, request: StopDriveLine) -> Reply:
        """All drives of a line at once: it goes out before everything that waits, and none of them answers."""
        link = self._books.plant.link(request.line)
        if link is None or link.wire is not Wire.HI:
            return Refusal("not-found", f"there is no drive line {request.line}", "see GET /api/v1/links")
        for drive in self._drives.values():
            if drive.spec.link == request.line:
                self._break_off(drive, f"{request.actor} stopped all drives of {request.line}")
        work = Work()
        task = tasks.once(work, Ask(None, PressKey(Key.STOP_RESET)))
        return self._operations.begin(OperationKind.STOP_ALL, request.line, None, request.actor, task, work, {})

    def _break_off(self, drive: DriveNow, reason: str) -> None:
        """What is being done to a drive ends, if it changes or moves something."""
        if drive.operation is not None:
            self._operations.break_off(drive.operation, tasks.failed(reason))

    def _write(self, drive: DriveNow, request: WriteDrive) -> Reply:
        spec = drive.catalogue.get(request.parameter)
        found = _raw_of(drive, spec, request)
        if isinstance(found, Refusal):
            return found
        known = drive.values.get(request.parameter)
        if request.expected is not None and known is not None and known.value != request.expected:
            return Refusal("stale", f"it is {known.value:04d} now, not {request.expected:04d}", "read it again", "")
        if drive.moving(self._books.now) and not (spec and spec.while_running):
            refused = tasks.running(drive, request.parameter)
            return Refusal("not-now", refused.reason, refused.remedy)
        work = Work()
        task = tasks.write(work, drive, request.parameter, found, request.expected, self._moving(drive))
        body = {"parameter": hexed(request.parameter), "name": spec.name if spec else "", "raw": found}
        if spec:
            body["value"] = spec.scaled(found)
        return self._begin(OperationKind.WRITE, drive, request.actor, task, work, body)

    def _moving(self, drive: DriveNow) -> Callable[[], bool | None]:
        return lambda: drive.moving(self._books.now)

    def _back_up(self, drive: DriveNow, request: BackUpDrive) -> Reply:
        work = Work(total=256)
        number = self._operations.next_number

        def keep(values: tuple[RawValue | None, ...]) -> None:
            backup = DriveBackup(
                number, drive.id, drive.spec.model, self._books.utc, request.actor, request.note, values
            )
            self._books.effects.records.append(backup)
            work.result["backup"] = number

        task = tasks.back_up(work, drive, keep)
        return self._begin(OperationKind.BACKUP, drive, request.actor, task, work, {"note": request.note})

    def _compare(self, drive: DriveNow, request: CompareDrive) -> Reply:
        other = None
        if request.other is not None:
            other = self._drives.get(request.other)
            if other is None:
                return no_drive(request.other)
            if other is drive:
                return Refusal("invalid", f"{drive.id} is compared with itself", "name another drive", "drive")
            if refusal := self._refusal(other):
                return refusal
        work = Work()
        task = tasks.compare(work, drive, request.values, other)
        return self._begin(OperationKind.COMPARE, drive, request.actor, task, work, {"with": request.what})

    def _restore(self, drive: DriveNow, request: RestoreDrive) -> Reply:
        if request.model != drive.spec.model:
            ours, theirs = (model or "a model without a name" for model in (drive.spec.model, request.model))
            return Refusal("conflict", f"{request.what} is of {theirs}, {drive.id} is {ours}", "take another backup")
        if not request.dry_run and drive.moving(self._books.now):
            return Refusal("not-now", f"{drive.id} is running", "stop it first, then restore")
        work = Work()
        task = tasks.restore(work, drive, request.values, self._moving(drive), dry_run=request.dry_run)
        body = {"from": request.what, "dry_run": request.dry_run}
        return self._begin(OperationKind.RESTORE, drive, request.actor, task, work, body)

    def _jog(self, drive: DriveNow, request: JogDrive) -> Reply:
        status = drive.status
        jogs = [one for one in self._operations.on_line(drive.spec.link) if one.kind is OperationKind.JOG]
        if jogs:
            return Refusal(
                "not-now",
                f"{jogs[0].actor} jogs {jogs[0].drive}, and one axis of line {drive.spec.link} can be jogged at a time",
                "wait until that is over",
            )
        if refusal := self._stays(drive):
            return refusal
        if status is not None and status.mode is not DriveMode.JOG:
            mode = status.mode.name.lower()
            return Refusal("not-now", f"{drive.id} is in mode {mode}, not in jog", "set it to jog at its panel")
        until = Seconds(self._books.now + JOG_HOLD)
        task, work = self._single(drive, HoldKey(request.turn, until))
        work.result["hold"] = float(JOG_HOLD)
        body = {"direction": request.turn.name.lower()}
        return self._begin(OperationKind.JOG, drive, request.actor, task, work, body)

    def _word(self, number: int, until: Seconds | None) -> tuple[Reply, list[LinkSend]]:
        jog = self._operations.get(number)
        request = self._operations.request_of(number)
        if jog is None or request is None or jog.kind is not OperationKind.JOG:
            gone = Refusal("not-now", f"jog {number} is over", f"see GET /api/v1/operations/{number}, or begin another")
            return gone, []
        order = self._operations.hold(number, until)
        return Accepted(Topic.OPERATIONS, str(number)), [] if order is None else [order]

    def _cancel(self, request: CancelDriveOperation) -> Reply:
        operation = self._operations.get(request.operation)
        if operation is None:
            return Refusal("not-now", f"operation {request.operation} is not under way", "see GET /api/v1/operations")
        if operation.kind is OperationKind.JOG:
            return Refusal("conflict", "a jog is released, not cancelled", f"DELETE its jog {request.operation}")
        self._operations.break_off(request.operation, tasks.failed(f"cancelled by {request.actor}"))
        return Accepted(Topic.OPERATIONS, str(request.operation))

    # -- lockouts -----------------------------------------------------------------------------------------------------

    def _lock(self, drive: DriveNow, request: LockDrive) -> Reply:
        """What is being done to it ends, and an axis that may move is stopped: a person may be about to step to it."""
        lock = drive.record.lockout
        if lock:
            return Refusal("conflict", f"{drive.id} is locked out by {lock.owner} already", f"ask {lock.owner}")
        self._save(drive, Lockout(request.actor, request.reason, self._books.utc))
        reason = f"{drive.id} was locked out by {request.actor}"
        for operation in self._operations.of_drive(drive.id):
            self._operations.break_off(operation.number, tasks.failed(reason))
        self._halt(drive, request.actor, "lockout")
        return Accepted(Topic.DRIVES, drive.id)

    def halt_all(self, actor: Actor, why: str) -> None:
        """A fire or an earthquake is told: what changes or moves a drive ends, and every axis that may move is stopped."""
        for drive in self._drives.values():
            self._break_off(drive, why)
            self._halt(drive, actor, why)

    def _halt(self, drive: DriveNow, actor: Actor, why: str) -> None:
        """Stop an axis that may move."""
        if drive.online and (drive.moving(self._books.now) is not False or drive.operation is not None):
            task, work = self._single(drive, PressKey(Key.STOP_RESET))
            self._begin(OperationKind.KEY, drive, actor, task, work, {"key": "stop_reset", "for": why})

    def _unlock(self, drive: DriveNow, request: UnlockDrive) -> Reply:
        lock = drive.record.lockout
        if lock is None:
            return Refusal("conflict", f"{drive.id} is not locked out", f"see GET /api/v1/drives/{drive.id}")
        wished = lock.wished_away_by(request.actor)
        if not wished.lifted_by(request.actor):
            self._save(drive, wished)
            return not_lifted(lock)
        self._save(drive, None)
        return Accepted(Topic.DRIVES, drive.id)

    def _save(self, drive: DriveNow, lockout: Lockout | None) -> None:
        drive.record = replace(drive.record, lockout=lockout)
        self._books.effects.records.append(drive.record)
        self._show(drive)

    # -- refusals -----------------------------------------------------------------------------------------------------

    def _stays(self, drive: DriveNow) -> Refusal | None:
        """Return why an axis is not set moving now."""
        return in_emergency(self._books) or _in_error(drive)

    def _refusal(self, drive: DriveNow, *, harmless: bool = False, changes: bool = False) -> Refusal | None:
        """Return why nothing of the kind can be asked of a drive now. ``harmless``: it reads its status, or stops it."""
        lock = drive.record.lockout
        if lock and not harmless:
            return Refusal("not-now", f"{drive.id} is {lock}", "lift it first")
        if drive.online is None and drive.reason:
            remedy = f"see GET /api/v1/links/{drive.spec.link}"
            return Refusal("not-now", f"line {drive.spec.link} of {drive.id} is not connected: {drive.reason}", remedy)
        if drive.online is False and not harmless:
            remedy = "switch it on, see to its cable and its id"
            return Refusal("not-now", f"{drive.id} is offline: {drive.reason}", remedy)
        if changes and drive.operation is not None and (other := self._operations.get(drive.operation)):
            remedy = f"wait for operation {other.number}, or cancel it"
            return Refusal("not-now", f"{other.actor} is at {drive.id}: {other.kind.value}", remedy)
        if not harmless and len(self._operations.of_drive(drive.id)) >= MOST_OPEN:
            return Refusal("not-now", f"{MOST_OPEN} operations of {drive.id} are under way", "wait, or cancel one")
        return None


def _in_error(drive: DriveNow) -> Refusal | None:
    """Return that a drive in error is not told to move (PROTOCOLS 2.3)."""
    status = drive.status
    if status is None or status.mode is not DriveMode.ERROR:
        return None
    meaning, remedy = explained(status.code)
    return Refusal("not-now", f"{drive.id} is in error {status.code:02d} {status.meaning}: {meaning}", remedy)


def _raw_of(drive: DriveNow, spec: ParameterSpec | None, request: WriteDrive) -> RawValue | Refusal:
    """Return what is to be written, or why it is not."""
    number = request.parameter
    if spec is None:
        return _unnamed(drive, number, request)
    if spec.read_only:
        return Refusal("invalid", f"parameter {named(drive, number)} is read-only", "leave it", "parameter")
    raw = request.raw
    if request.value is not None:
        raw = spec.raw(request.value)
        if raw is None:
            step = f"{spec.scale:g} {spec.unit}".rstrip()
            reason = f"parameter {named(drive, number)} goes in steps of {step}: {request.value:g} is none of them"
            nearest = f"send {spec.scaled(round(request.value / spec.scale)):g}"
            return Refusal("invalid", reason, nearest, "value")
    if raw is None or not spec.lowest <= raw <= spec.highest:
        given = "" if raw is None else f", not {spec.shown(raw)} (raw {raw})"
        field = "value" if request.value is not None else "raw"
        return Refusal(
            "invalid", f"parameter {named(drive, number)} is {spec.range}{given}", "stay in that range", field
        )
    return raw


def _unnamed(drive: DriveNow, number: Parameter, request: WriteDrive) -> RawValue | Refusal:
    catalogue = f"catalogue {drive.catalogue.model}" if drive.catalogue.model else "no catalogue"
    what = f"parameter {hexed(number)} of {drive.id} is in {catalogue}"
    if drive.catalogue.model:
        what = f"parameter {hexed(number)} of {drive.id} is not in {catalogue}"
    if request.raw is None:
        return Refusal("invalid", f"{what}: it has a raw value alone", "send raw instead of value", "value")
    if not request.raw_access:
        remedy = "send raw_access: true if you know what it does"
        return Refusal("invalid", f"{what}: nobody says what it may be", remedy, "raw_access")
    if not 0 <= request.raw <= HIGHEST_RAW:
        return Refusal("invalid", f"a raw value is from 0 to {HIGHEST_RAW}", "stay in that range", "raw")
    return request.raw
