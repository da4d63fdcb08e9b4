"""What each operation on a drive amounts to, question by question (PROTOCOLS 2.3, H24; COMMANDS section 1).

A task is a generator: it yields what is to be asked next, gets how that ended sent back, and returns its verdict.
"""

from collections.abc import Callable, Generator, Iterable
from dataclasses import dataclass, field

from app.domain.drive import (
    AskStatus,
    DriveCommand,
    DriveDone,
    DriveFailed,
    DriveId,
    DriveMode,
    DriveResult,
    DriveStatus,
    DriveUnknown,
    JogEnd,
    Parameter,
    RawValue,
    ReadParameter,
    Setting,
    Turn,
    WriteParameter,
)
from app.domain.drive_records import OperationState
from app.domain.drive_requests import Values
from app.domain.units import Seconds
from app.fleet.drive import DriveNow, hexed, named, said

GIVE_UP_AFTER = 3
"""So many parameters on end that cannot be read mean that it is no use. Our choice; one that comes back in between counts."""
BACK_WITHIN = Seconds(15.0)
"""How long a task waits for a drive that went offline: it is probed every 5 s (PROTOCOLS H10). Our choice."""

End = DriveDone | DriveFailed | DriveUnknown


@dataclass(frozen=True, slots=True)
class HoldKey:
    """Jog until ``until``, or longer where the caller says so in time."""

    turn: Turn
    until: Seconds


@dataclass(frozen=True, slots=True)
class AwaitOnline:
    """Wait until the drive answers again, for so long at most; nothing is sent. Done: it is back."""

    within: Seconds = BACK_WITHIN


@dataclass(frozen=True, slots=True)
class Ask:
    """Ask this of a drive, or of all on the line (``drive`` None)."""

    drive: DriveId | None
    command: DriveCommand | HoldKey | AwaitOnline

    @property
    def reads(self) -> bool:
        """Whether it changes nothing, so that it need not be kept before it is sent."""
        return isinstance(self.command, AskStatus | ReadParameter | AwaitOnline)


@dataclass(frozen=True, slots=True)
class Change:
    """A parameter has another value than before, by our doing."""

    parameter: Parameter
    before: RawValue
    after: RawValue


@dataclass(slots=True)
class Work:
    """What a task fills in while it goes: see :class:`app.domain.drive_records.DriveOperation`. ``changes`` are taken out."""

    total: int = 1
    done: int = 0
    result: dict[str, object] = field(default_factory=dict)
    changes: list[Change] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Verdict:
    """How an operation ended."""

    state: OperationState
    reason: str = ""
    remedy: str = ""


DONE = Verdict(OperationState.DONE)
Task = Generator[Ask, End, Verdict]


def failed(reason: str, remedy: str = "") -> Verdict:
    """Return that it did not take effect."""
    return Verdict(OperationState.FAILED, reason, remedy)


def verdict_of(end: End) -> Verdict:
    """Return what the end of a single question makes of the whole."""
    if isinstance(end, DriveFailed):
        return failed(end.reason, end.remedy)
    if isinstance(end, DriveUnknown):
        return Verdict(OperationState.UNKNOWN, end.reason, "look at the drive's status, and decide")
    return DONE


def told(result: DriveResult) -> dict[str, object]:
    """Return what a question gave, for people."""
    match result:
        case DriveMode():
            return {"mode": result.name.lower()}
        case DriveStatus():
            return {"mode": result.mode.name.lower(), "code": result.code, "meaning": result.meaning}
        case Setting():
            return {"values": {hexed(result.parameter): result.value}}
        case JogEnd():
            return {"ended": result.value}
        case None:
            return {}


def once(work: Work, ask: Ask) -> Task:
    """Ask one thing."""
    end = yield ask
    work.done = 1
    if isinstance(end, DriveDone):
        work.result |= told(end.result)
    elif isinstance(end, DriveUnknown) and end.status is not None:
        work.result |= told(end.status)
    return verdict_of(end)


def read(work: Work, drive: DriveNow, parameters: Iterable[Parameter]) -> Task:
    """Read parameters. What cannot be read is named; the rest counts."""
    trouble = yield from _read(work, drive, parameters, work.result)
    missing = work.result.get("missing")
    if trouble is None and isinstance(missing, dict) and missing:
        what = f"{len(missing)} of {work.total} parameters gave no value: {', '.join(missing)}"
        return failed(what, "the drive may not have them: see its manual, or read them again")
    return trouble or DONE


def _read(
    work: Work, drive: DriveNow, parameters: Iterable[Parameter], into: dict[str, object]
) -> Generator[Ask, End, Verdict | None]:
    values: dict[str, int] = {}
    missing: dict[str, str] = {}
    into["values"], into["missing"] = values, missing
    on_end, first = 0, ""
    for number in parameters:
        end = yield Ask(drive.id, ReadParameter(number))
        work.done += 1
        if isinstance(end, DriveDone) and isinstance(end.result, Setting):
            values[hexed(number)] = end.result.value
            on_end = 0
            continue
        missing[hexed(number)] = "" if isinstance(end, DriveDone) else end.reason
        on_end += 1
        first = first if on_end > 1 else missing[hexed(number)]
        if drive.online is False:
            # A number that a drive does not have may be all that is wrong: it refuses that one, and goes on with the next.
            back = yield Ask(drive.id, AwaitOnline())
            if not isinstance(back, DriveDone):
                return failed(f"{drive.id} went offline: {first}", "see to the drive and its line, then ask again")
            on_end = 0
        if on_end >= GIVE_UP_AFTER:
            return failed(
                f"{drive.id} did not give {on_end} parameters on end: {first}",
                "see to the drive and its line, then ask again",
            )
    if not values:
        return failed(
            f"{drive.id} gave no value: {next(iter(missing.values()), '')}", "see to the drive, then ask again"
        )
    return None


def back_up(work: Work, drive: DriveNow, keep: Callable[[tuple[RawValue | None, ...]], None]) -> Task:
    """Read everything and keep it; a parameter without a value leaves a hole."""
    numbers = [Parameter(number) for number in range(256)]
    trouble = yield from _read(work, drive, numbers, work.result)
    if trouble is not None:
        return trouble
    values = _values(work.result)
    keep(tuple(values.get(number) for number in numbers))
    return DONE


def _values(result: dict[str, object]) -> dict[Parameter, RawValue]:
    values = result["values"]
    return {Parameter(int(key, 16)): raw for key, raw in values.items()} if isinstance(values, dict) else {}


def write(
    work: Work,
    drive: DriveNow,
    parameter: Parameter,
    value: RawValue,
    expected: RawValue | None,
    moving: Callable[[], bool | None],
) -> Task:
    """Write a parameter: look whether the drive runs and what the value was, write, read back."""
    before = yield from _before(drive, parameter, moving)
    if isinstance(before, Verdict):
        return before
    work.result["before"] = before
    if expected is not None and before != expected:
        return failed(
            f"parameter {named(drive, parameter)} is {said(drive, parameter, before)}, not {expected:04d} as you saw it",
            "look at it again, then decide",
        )
    verdict = yield from _set(work, drive, parameter, before, value)
    work.done = 1
    return verdict


def _before(
    drive: DriveNow, parameter: Parameter, moving: Callable[[], bool | None]
) -> Generator[Ask, End, RawValue | Verdict]:
    """Return the value before. Two statuses around it show whether the axis moves (its distance differs)."""
    value = RawValue(0)
    for command in (AskStatus(), ReadParameter(parameter), AskStatus()):
        end = yield Ask(drive.id, command)
        if not isinstance(end, DriveDone):
            remedy = end.remedy if isinstance(end, DriveFailed) else ""
            return failed(f"nothing was written: {end.reason}", remedy or "see to the drive, then ask again")
        if isinstance(end.result, Setting):
            value = end.result.value
    spec = drive.catalogue.get(parameter)
    if moving() and not (spec and spec.while_running):
        return running(drive, parameter)
    return value


def running(drive: DriveNow, parameter: Parameter) -> Verdict:
    """Return that a parameter is not to be written now."""
    return failed(
        f"{drive.id} is running, and parameter {named(drive, parameter)} may not be written while it runs",
        f'stop it first: POST /api/v1/drives/{drive.id}/keys {{"key": "stop_reset"}}',
    )


def _set(
    work: Work, drive: DriveNow, parameter: Parameter, before: RawValue, value: RawValue
) -> Generator[Ask, End, Verdict]:
    """Write; where the answer was lost, what the drive says now decides (COMMANDS: read first)."""
    if before == value:
        work.result["after"] = before
        return DONE
    end = yield Ask(drive.id, WriteParameter(parameter, value))
    verdict = verdict_of(end)
    after: RawValue | None = value
    if not isinstance(end, DriveDone):
        after = yield from _look(drive, parameter)
    if after is None:
        back = yield Ask(drive.id, AwaitOnline())
        after = (yield from _look(drive, parameter)) if isinstance(back, DriveDone) else None
    if after is None:
        return verdict
    work.result["after"] = after
    if after != before:
        work.changes.append(Change(parameter, before, after))
    if after == value:
        return DONE
    if after == before:
        remedy = verdict.remedy or "it may be read-only or out of range: see the drive's manual"
        return failed(f"parameter {named(drive, parameter)} has still {said(drive, parameter, after)}", remedy)
    remedy = verdict.remedy or "look at the drive, then write again"
    return failed(f"parameter {named(drive, parameter)} reads back as {said(drive, parameter, after)}", remedy)


def _look(drive: DriveNow, parameter: Parameter) -> Generator[Ask, End, RawValue | None]:
    """Return a parameter as two readings agree on it, None if they do not or there are none.

    One broken answer in sixteen passes for a good one (PROTOCOLS 2.2), and here no second opinion is left. Our choice.
    """
    found = []
    for _ in range(2):
        end = yield Ask(drive.id, ReadParameter(parameter))
        found.append(end.result.value if isinstance(end, DriveDone) and isinstance(end.result, Setting) else None)
    return found[0] if found[0] == found[1] else None


def compare(work: Work, drive: DriveNow, values: Values, other: DriveNow | None) -> Task:
    """Read a drive, and another one if there is one, and tell where they differ."""
    there = dict(values)
    if other is not None:
        numbers = [Parameter(number) for number in range(256)]
        work.total = 2 * len(numbers)
        theirs: dict[str, object] = {}
        trouble = yield from _read(work, other, numbers, theirs)
        if trouble is not None:
            return trouble
        there = _values(theirs)
    else:
        work.total = len(there)
    mine: dict[str, object] = {}
    trouble = yield from _read(work, drive, list(there), mine)
    if trouble is not None:
        return trouble
    here = _values(mine)
    work.result["missing"] = mine["missing"]
    work.result["differences"] = [
        row(drive, number, here[number], there[number])
        for number in sorted(there)
        if number in here and here[number] != there[number]
    ]
    return DONE


def row(drive: DriveNow, number: Parameter, here: RawValue, there: RawValue) -> dict[str, object]:
    """Return a difference for people."""
    spec = drive.catalogue.get(number)
    return {
        "parameter": hexed(number),
        "name": spec.name if spec else "",
        "here": here,
        "there": there,
        "here_text": said(drive, number, here),
        "there_text": said(drive, number, there),
    }


def restore(work: Work, drive: DriveNow, values: Values, moving: Callable[[], bool | None], *, dry_run: bool) -> Task:
    """Write what differs; each row says what becomes of it. An axis that runs is not restored."""
    mine: dict[str, object] = {}
    work.total = len(values)
    end = yield Ask(drive.id, AskStatus())
    if not isinstance(end, DriveDone):
        return failed(f"nothing was written: {end.reason}", "see to the drive, then ask again")
    trouble = yield from _read(work, drive, [number for number, _ in values], mine)
    if trouble is not None:
        return trouble
    here, wanted = _values(mine), dict(values)
    rows = [
        row(drive, number, here[number], wanted[number]) | {"fate": _fate(drive, number, wanted[number])}
        for number in sorted(wanted)
        if number in here and here[number] != wanted[number]
    ]
    work.result["rows"], work.result["missing"] = rows, mine["missing"]
    to_write = [line for line in rows if line["fate"] == "write"]
    work.total += len(to_write)
    if dry_run:
        work.total = work.done
        return DONE
    if to_write and moving():
        return failed(f"{drive.id} is running", "stop it first, then restore")
    return (yield from _write_rows(work, drive, to_write, here))


def _fate(drive: DriveNow, number: Parameter, value: RawValue) -> str:
    spec = drive.catalogue.get(number)
    if spec is None:
        return "write"
    if spec.read_only:
        return "skip: read-only"
    if not spec.lowest <= value <= spec.highest:
        return f"skip: not {spec.range}"
    return "write"


def _write_rows(
    work: Work, drive: DriveNow, rows: list[dict[str, object]], here: dict[Parameter, RawValue]
) -> Generator[Ask, End, Verdict]:
    wrong: list[str] = []
    for line in rows:
        number = Parameter(int(str(line["parameter"]), 16))
        value = line["there"]
        assert isinstance(value, int)
        line["fate"] = "being written"
        one = Work()
        verdict = yield from _through(work, _set(one, drive, number, here[number], RawValue(value)), one)
        work.done += 1
        line["fate"] = "written" if verdict is DONE else f"{verdict.state}: {verdict.reason}"
        if verdict.state is OperationState.UNKNOWN:
            reason = f"parameter {named(drive, number)}: {verdict.reason}; the rest was not written"
            return Verdict(OperationState.UNKNOWN, reason, "compare the drive with the backup")
        if verdict is not DONE:
            wrong.append(named(drive, number))
    if wrong:
        return failed(f"not restored: {', '.join(wrong)}", "compare the drive with the backup")
    return DONE


def _through(work: Work, inner: Generator[Ask, End, Verdict], one: Work) -> Generator[Ask, End, Verdict]:
    """Go through with one write of many; what it changes is the whole's."""
    verdict = yield from inner
    work.changes += one.changes
    return verdict
