"""What people's requests are on the wire, and which script carries each out (PROTOCOLS 2.4)."""

from collections.abc import Callable, Sequence
from typing import assert_never

from app.domain.drive import (
    AskStatus,
    DriveCommand,
    DriveDone,
    DriveFailed,
    DriveId,
    DriveRequestId,
    DriveUnknown,
    Key,
    PressKey,
    ReadParameter,
    SetInputs,
    WriteParameter,
)
from app.protocols.hi.messages import NOTHING, Cmd, Content, Inputs, Number, Setting
from app.protocols.hi.session import scripts
from app.protocols.hi.session.steps import Done, Failed, Script, Verdict


def on_the_wire(command: DriveCommand) -> tuple[Cmd, Content]:
    """Return the command and its content."""
    match command:
        case PressKey(key):
            return scripts.KEYS[key], NOTHING
        case AskStatus():
            return Cmd.SSQ, NOTHING
        case ReadParameter(number):
            return Cmd.SET, Number(number)
        case WriteParameter(number, value):
            return Cmd.SED, Setting(number, value)
        case SetInputs():
            return Cmd.INP, _inputs(command)
    assert_never(command)


def _inputs(command: SetInputs) -> Inputs:
    return Inputs(
        run=int(command.run),
        home=int(command.home),
        r_limit=int(command.right_limit),
        l_limit=int(command.left_limit),
        steps=command.step,
    )


def moves(command: DriveCommand) -> bool:
    """Return whether a command can make an axis move, now or when it is repeated."""
    match command:
        case PressKey(key):
            return key is not Key.STOP_RESET
        case SetInputs(run, home):
            return run or home
        case AskStatus() | ReadParameter() | WriteParameter():
            return False
    assert_never(command)


def script_for(command: DriveCommand, address: int, tries: int) -> Script:
    """Return what carries a command out on one drive; ``tries`` is how often anything is transmitted at most."""
    match command:
        case PressKey(Key.STOP_RESET):
            return scripts.stop(address)
        case PressKey(key):
            return scripts.press(address, key, tries)
        case AskStatus():
            return scripts.ask_status(address)
        case ReadParameter(number):
            return scripts.read(address, number)
        case WriteParameter(number, value):
            return scripts.write(address, number, value)
        case SetInputs():
            return scripts.set_inputs(address, _inputs(command))
    assert_never(command)


def script_for_all(command: DriveCommand, answering: Callable[[], Sequence[tuple[str, int]]]) -> Script:
    """Return what tells all drives at once; ``answering`` gives name and address of those that a write is read back from."""
    if isinstance(command, WriteParameter):
        return scripts.write_all(command.parameter, command.value, answering)
    return scripts.tell_all(*on_the_wire(command))


def end_of(drive: DriveId | None, request: DriveRequestId, verdict: Verdict) -> DriveDone | DriveFailed | DriveUnknown:
    """Return the event that tells how a request ended."""
    if isinstance(verdict, Done):
        return DriveDone(drive, request, verdict.result)
    if isinstance(verdict, Failed):
        return DriveFailed(drive, request, verdict.reason, verdict.remedy)
    return DriveUnknown(drive, request, verdict.reason, verdict.status)
