"""Commands as packets: their content, which of them exclude each other, which may be sent again (COMMANDS section 1)."""

from collections.abc import Mapping
from enum import Enum, auto
from typing import assert_never

from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMode,
    AgvMove,
    AgvMoveAlias,
    AgvMoveAuto,
    AgvMoveManual,
    AgvSetCurrent,
    AgvStatus,
    DeviceAct,
    DeviceCommand,
    DeviceStatus,
)
from app.protocols.enig.messages import (
    Body,
    Charge,
    Close,
    Lift,
    Lock,
    MarkStop,
    Move,
    MoveAlias,
    MoveAuto,
    MoveManual,
    Open,
    Reset,
    SetCurrent,
    Stop,
    UnLock,
)

_ACTS: Mapping[DeviceAct, type[Stop | Reset | MarkStop | Lock | UnLock | Open | Close]] = {
    DeviceAct.STOP: Stop,
    DeviceAct.RESET: Reset,
    DeviceAct.MARK_STOP: MarkStop,
    DeviceAct.LOCK: Lock,
    DeviceAct.UNLOCK: UnLock,
    DeviceAct.OPEN: Open,
    DeviceAct.CLOSE: Close,
}


def body_of(command: DeviceCommand) -> Body:
    """Return the content of a command's packet."""
    match command:
        case AgvMove():
            return Move(command.tag)
        case AgvMoveAlias():
            return MoveAlias(command.alias)
        case AgvSetCurrent():
            return SetCurrent(command.tag)
        case AgvMoveManual():
            return MoveManual(int(command.direction), int(command.speed))
        case AgvMoveAuto():
            return MoveAuto(int(command.forward), int(command.steering), int(command.speed))
        case AgvLift():
            return Lift(int(command.action))
        case AgvCharge():
            return Charge(int(command.on))
        case DeviceAct():
            return _ACTS[command]()
    assert_never(command)


class Axis(Enum):
    """What a command works on: of two on the same axis the later one counts."""

    MOTION = auto()
    ERROR = auto()
    PLACE = auto()
    LIFT = auto()
    CHARGE = auto()
    LOCK = auto()
    DOOR = auto()


_AXES = {
    AgvMove: Axis.MOTION,
    AgvMoveAlias: Axis.MOTION,
    AgvMoveManual: Axis.MOTION,
    AgvMoveAuto: Axis.MOTION,
    AgvSetCurrent: Axis.PLACE,
    AgvLift: Axis.LIFT,
}
_ACT_AXES = {
    DeviceAct.STOP: Axis.MOTION,
    DeviceAct.MARK_STOP: Axis.MOTION,
    DeviceAct.RESET: Axis.ERROR,
    DeviceAct.LOCK: Axis.LOCK,
    DeviceAct.UNLOCK: Axis.LOCK,
    DeviceAct.OPEN: Axis.DOOR,
    DeviceAct.CLOSE: Axis.DOOR,
}


def axis_of(command: DeviceCommand) -> Axis:
    """Return what a command works on."""
    match command:
        case DeviceAct():
            return _ACT_AXES[command]
        case AgvCharge():
            return Axis.MOTION if command.on else Axis.CHARGE
        case _:
            return _AXES[type(command)]


_ONCE = (AgvMoveManual, AgvMoveAuto, AgvCharge)


def may_repeat(command: DeviceCommand) -> bool:
    """Return whether a command may go again without an effect seen: COMMANDS section 1, and E9 for Reset and SetCurrent.

    MarkStop is on neither list: once stopped at a mark, a second one would be for the next mark.
    """
    return command is not DeviceAct.MARK_STOP and not isinstance(command, _ONCE)


BLIND = frozenset({DeviceAct.STOP, DeviceAct.OPEN})
"""Our choice: what is sent to a device of which nothing is known: it can only make things safer."""


def name_of(command: DeviceCommand) -> str:
    """Return a command's name on the wire."""
    return str(body_of(command).name)


def wrong_mode(command: DeviceCommand, status: DeviceStatus | None) -> tuple[str, str] | None:
    """Return why an AGV in this mode does not take a command, and the remedy; None if it may (E21, 5.3)."""
    if not isinstance(status, AgvStatus):
        return None
    starts = isinstance(command, AgvMove | AgvMoveAlias | AgvMoveAuto) or command == AgvCharge(on=True)
    if starts and status.mode is AgvMode.MANUAL:
        return "the AGV is in manual", "switch it to auto at the AGV"
    if isinstance(command, AgvMoveManual) and status.mode is AgvMode.AUTO:
        return "the AGV is in auto", "switch it to manual at the AGV"
    return None
