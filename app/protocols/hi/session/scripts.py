"""What each request amounts to on the line, step by step (PROTOCOLS 2.3, 6.1, H17, H24; COMMANDS section 1)."""

from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from app.domain import drive as told
from app.domain.drive import DriveMode, DriveStatus, Hundredths, JogEnd, Key, Parameter, RawValue, Turn
from app.domain.units import Seconds
from app.protocols.hi.messages import ALL_DRIVES, NOTHING, Ack, Cmd, Content, Inputs, Mode, Number, Setting, Ssa
from app.protocols.hi.session.steps import (
    Ask,
    Done,
    Failed,
    Heard,
    Missed,
    Outcome,
    Pause,
    Repeat,
    Script,
    Step,
    Unknown,
    Verdict,
    Woken,
)
from app.protocols.hi.session.timing import Timing

KEYS: Mapping[Key, Cmd] = MappingProxyType(
    {Key.RUN: Cmd.RUN, Key.STOP_RESET: Cmd.SRK, Key.UP: Cmd.UPP, Key.DOWN: Cmd.DWN, Key.DATA_SET: Cmd.DSK}
)
_MOVING = frozenset({Key.RUN, Key.UP, Key.DOWN})
_RESET = "press Stop/Reset once its cause is gone"


def status_of(content: Ssa) -> DriveStatus:
    """Return what the wire says in the words of the business."""
    return DriveStatus(
        DriveMode(content.mode),
        content.output,
        content.status,
        content.meaning,
        None if content.direction is None else Turn(content.direction),
        None if content.distance_centi is None else Hundredths(content.distance_centi),
    )


def poll(address: int) -> Script:
    """Ask for the status, for whoever watches."""
    yield Ask(address, Cmd.SSQ)
    return None


def probe(address: int) -> Script:
    """Ask once for the status of a drive that does not answer."""
    yield Ask(address, Cmd.SSQ, repeat=Repeat.NEVER)
    return None


def ask_status(address: int) -> Script:
    """Ask for the status, for one who wants to know."""
    status = yield from _look(address)
    return status if isinstance(status, Failed) else Done(status)


def _look(address: int) -> Generator[Step, Outcome, DriveStatus | Failed]:
    outcome = yield Ask(address, Cmd.SSQ)
    if isinstance(outcome, Heard) and isinstance(outcome.content, Ssa):
        return status_of(outcome.content)
    return Failed(_why(outcome))


def _why(outcome: Outcome) -> str:
    return outcome.reason if isinstance(outcome, Missed) else "the drive did not answer"


def _in_error(status: DriveStatus) -> Failed:
    return Failed(f"the drive is in error {status.code:02d} {status.meaning}", _RESET)


def _after_ack(mode: int) -> Verdict:
    if mode == Mode.ERROR:
        return Failed("the drive took the command in mode error, where nothing moves", _RESET)
    return Done(DriveMode(mode))


def stop(address: int) -> Script:
    """Press Stop/Reset: sent again until it is acknowledged, since a second stop stops no more than the first."""
    outcome = yield Ask(address, Cmd.SRK)
    match outcome:
        case Heard(Ack(Mode.ERROR)):
            return Failed("the drive is still in error after Stop/Reset", "remove the cause, then press it again")
        case Heard(Ack(mode)):
            return Done(DriveMode(mode))
        case _:
            return _missed(outcome)


def _missed(outcome: Outcome) -> Verdict:
    maybe = isinstance(outcome, Missed) and outcome.maybe
    return Unknown(_why(outcome)) if maybe else Failed(_why(outcome))


def press(address: int, key: Key, tries: int) -> Script:
    """Press a key that must not be pressed twice by mistake: after a lost answer the state decides, or a person."""
    before = yield from _look(address)
    if isinstance(before, Failed):
        return before
    if key in _MOVING and before.mode is DriveMode.ERROR:
        return _in_error(before)
    for _ in range(tries):
        outcome = yield Ask(address, KEYS[key], repeat=Repeat.REFUSED)
        if isinstance(outcome, Heard) and isinstance(outcome.content, Ack):
            return _after_ack(outcome.content.mode)
        lost = _missed(outcome)
        if not isinstance(lost, Unknown):
            return lost
        after = yield from _look(address)
        if isinstance(after, Failed):
            return Unknown(f"{lost.reason}; then {after.reason}")
        taken = was_taken(key, before.mode, after.mode)
        if taken:
            return _after_ack(after.mode)
        if taken is None:
            return Unknown(f"{lost.reason}; the status does not show whether the key was taken", after)
    return Failed(f"the drive did not take the key in {tries} transmissions")


def was_taken(key: Key, before: DriveMode, after: DriveMode) -> bool | None:
    """Return whether the modes before and after show that a key was taken; None if they do not show it."""
    setting = {DriveMode.PARAMETER_SELECT, DriveMode.PARAMETER_VALUE}
    if key is Key.DATA_SET and {before, after} <= setting:
        return before is not after
    if key is Key.RUN and after is DriveMode.ERROR:
        return True
    if key is Key.RUN and before is not DriveMode.MONITORING:
        return {DriveMode.MONITORING: True, before: False}.get(after)
    return None


def set_inputs(address: int, inputs: Inputs) -> Script:
    """Set the inputs; those that make it move only where the drive is not in error."""
    if inputs.run or inputs.home:
        before = yield from _look(address)
        if isinstance(before, Failed):
            return before
        if before.mode is DriveMode.ERROR:
            return _in_error(before)
    outcome = yield Ask(address, Cmd.INP, inputs)
    if isinstance(outcome, Heard) and isinstance(outcome.content, Ack):
        moving = inputs.run or inputs.home
        return _after_ack(outcome.content.mode) if moving else Done(DriveMode(outcome.content.mode))
    return _missed(outcome)


def read(address: int, number: int) -> Script:
    """Read a parameter."""
    value = yield from _value(address, number)
    return value if isinstance(value, Failed) else Done(_setting(number, value))


def _value(address: int, number: int) -> Generator[Step, Outcome, int | Failed]:
    outcome = yield Ask(address, Cmd.SET, Number(number))
    if isinstance(outcome, Heard) and isinstance(outcome.content, Setting):
        return outcome.content.value
    return Failed(_why(outcome))


def _setting(number: int, value: int) -> told.Setting:
    return told.Setting(Parameter(number), RawValue(value))


def write(address: int, number: int, value: int) -> Script:
    """Write a parameter and read it back (H24)."""
    outcome = yield Ask(address, Cmd.SED, Setting(number, value))
    if not isinstance(outcome, Heard):
        return _missed(outcome)
    wrong = yield from _read_back(address, number, value)
    return Done(_setting(number, value)) if wrong is None else wrong


def _read_back(address: int, number: int, value: int) -> Generator[Step, Outcome, Failed | Unknown | None]:
    found = yield from _value(address, number)
    if found != value and not isinstance(found, Failed):
        # The BCC lets one broken answer in sixteen pass (PROTOCOLS 2.2), so a difference is looked at twice. Our choice.
        found = yield from _value(address, number)
    if isinstance(found, Failed):
        return Unknown(f"written, but not read back: {found.reason}")
    if found == value:
        return None
    return Failed(
        f"parameter {number:02X} reads back as {found:04d}, not {value:04d}",
        "it is out of range or read-only, or another parameter was written: compare them all",
    )


def tell_all(cmd: Cmd, content: Content = NOTHING) -> Script:
    """Tell all drives at once; none of them answers (2.3)."""
    yield Ask(ALL_DRIVES, cmd, content, Repeat.NEVER)
    return Done(None)


def write_all(number: int, value: int, drives: Callable[[], Sequence[tuple[str, int]]]) -> Script:
    """Write a parameter of all drives at once, and read it back from each that answers; ``drives`` gives names, addresses."""
    yield Ask(ALL_DRIVES, Cmd.SED, Setting(number, value), Repeat.NEVER)
    wrong = []
    for name, address in drives():
        found = yield from _read_back(address, number, value)
        if found is not None:
            wrong.append(f"{name}: {found.reason}")
    return Failed("; ".join(wrong), "write them one by one") if wrong else Done(None)


@dataclass(slots=True)
class Hold:
    """The caller's hand on a jog key: it must say again before ``until`` that it is still there."""

    until: Seconds
    released: bool = False

    @property
    def end(self) -> JogEnd:
        """Why the jog is over."""
        return JogEnd.RELEASED if self.released else JogEnd.CALLER_GONE


def jog(address: int, turn: Turn, hold: Hold, timing: Timing, began: Callable[[], None]) -> Script:
    """Send the key every 50 ms as long as it is held, then Stop/Reset (H17).

    In another mode the same key would change a parameter, so after a lost answer the mode is asked before the next one.
    """
    fault = yield from _check_jog(address)
    if fault is not None:
        return fault
    if hold.released:
        return Done(JogEnd.RELEASED)
    began()
    fault = yield from _keys(address, Cmd.UPP if turn is Turn.CW else Cmd.DWN, hold, timing)
    stopped = yield from stop(address)
    if isinstance(stopped, Unknown):
        return Unknown(f"the jog has ended, but {stopped.reason}")
    if fault is not None:
        return fault
    if isinstance(stopped, Failed):
        return stopped
    return Done(hold.end)


def _check_jog(address: int) -> Generator[Step, Outcome, Failed | None]:
    status = yield from _look(address)
    if isinstance(status, Failed):
        return status
    if status.mode is DriveMode.ERROR:
        return _in_error(status)
    if status.mode is not DriveMode.JOG:
        return Failed(f"the drive is in mode {status.mode}, not in jog", "set it to jog at its panel")
    return None


def _keys(address: int, key: Cmd, hold: Hold, timing: Timing) -> Generator[Step, Outcome, Failed | None]:
    at, misses = Seconds(0.0), 0
    while misses <= timing.busy_repeats:
        woken = yield Pause(at)
        if not isinstance(woken, Woken) or hold.released or woken.now >= hold.until:
            return None
        at = Seconds(woken.now + timing.jog)
        outcome = yield Ask(address, key, repeat=Repeat.NEVER)
        match outcome:
            case Heard(Ack(Mode.JOG)):
                misses = 0
            case Heard(Ack(mode)):
                return Failed(f"the drive went to mode {mode} while jogging")
            case _:
                misses += 1
                fault = yield from _check_jog(address)
                if fault is not None:
                    return fault
    return Failed(f"the drive did not take {misses} jog keys on end")
