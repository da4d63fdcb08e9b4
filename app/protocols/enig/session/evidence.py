"""What a Status proves about a command: there is no acknowledgement, so this is all there is (PROTOCOLS E9, 5.3, 6.2)."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum, auto
from types import MappingProxyType
from typing import Any

from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMode,
    AgvMove,
    AgvMoveAlias,
    AgvMoveAuto,
    AgvMoveManual,
    AgvRun,
    AgvSetCurrent,
    AgvStatus,
    BufferState,
    DeviceAct,
    DeviceCommand,
    DeviceRequestId,
    DeviceStatus,
    DoorState,
    LiftAction,
    LiftState,
    Steering,
)
from app.domain.units import Barcode, Seconds
from app.protocols.enig.session.requests import Axis
from app.protocols.enig.session.timing import Timing


class Phase(Enum):
    """Life of an order: ASKED, TAKEN (begun by the device's own word); then it is no more."""

    ASKED = auto()
    TAKEN = auto()


class Verdict(Enum):
    """What a Status proves, besides a failure in words."""

    NOTHING = auto()
    TAKEN = auto()
    DONE = auto()


Judgement = Verdict | str
"""A verdict, or why the command has failed."""

NOTHING, TAKEN, DONE = Verdict


@dataclass(slots=True, eq=False)
class Order:
    """A command under way.

    ``goal`` is the tag of a Move, None if unknown. ``before`` is the Status before the last transmission, at ``sent_at``.
    ``due`` is when it is judged unconfirmed, or TAKEN work overdue; None while the next Status must come first.
    ``crossed``: it overtook a command whose effect had not shown, so that what it finds need not be what stays.
    ``standing`` is since when an AGV that had begun stands out of position.
    """

    id: DeviceRequestId
    command: DeviceCommand
    axis: Axis
    packet: bytes
    goal: Barcode | None
    before: DeviceStatus | None
    first_at: Seconds
    sent_at: Seconds
    due: Seconds | None
    resends: int
    crossed: bool = False
    phase: Phase = Phase.ASKED
    standing: Seconds | None = field(default=None)


@dataclass(frozen=True, slots=True)
class Look:
    """One Status looked at for one order. ``fresh``: it cannot have been sent before the command arrived."""

    order: Order
    now: Seconds
    fresh: bool
    timing: Timing

    def is_new(self, shows: Callable[[Any], bool], status: DeviceStatus) -> bool:
        """Return whether a Status shows something that it did not show before, or still shows it after the transit time."""
        order = self.order
        changed = order.before is not None and not order.crossed and not shows(order.before)
        return shows(status) and (self.fresh or changed)


def judge(look: Look, status: DeviceStatus) -> Judgement:
    """Return what a Status proves about an order."""
    match status:
        case BufferState():
            return _lock(look, status)
        case DoorState():
            return _door(look, status)
        case _:
            command = look.order.command
            key = command if isinstance(command, DeviceAct) else type(command)
            return _AGV[key](look, status)


def completes(look: Look, tag: Barcode) -> bool:
    """Return whether a Move Complete with this tag is the end of an order (E25, E27)."""
    order = look.order
    if not isinstance(order.command, AgvMove | AgvMoveAlias):
        return False
    if order.goal is None:
        # One that was sent before the command arrived comes before the Status that shows the command taken.
        return order.phase is Phase.TAKEN
    return tag == order.goal and (order.phase is Phase.TAKEN or look.fresh)


def _drive(look: Look, status: AgvStatus) -> Judgement:
    """Judge Move and MoveAlias: taken when it runs, by the next CurrentPath where it counts; done when it has arrived."""
    order = look.order
    if order.phase is Phase.TAKEN:
        return _under_way(look, status)
    counted = _is_counted(order, status)
    if status.arrived and (counted or look.is_new(lambda s: s.arrived and s.tag == order.goal, status)):
        return _arrival(order, status)
    return TAKEN if _starts(look, status) else NOTHING


def _is_counted(order: Order, status: AgvStatus) -> bool:
    """Return whether the AGV has taken a destination since: it counts (E15)."""
    return isinstance(order.before, AgvStatus) and status.path not in (0, order.before.path)


def _starts(look: Look, status: AgvStatus) -> bool:
    """Return whether it runs for this command; one that ran before shows it by CurrentPath, if it counts at all."""
    if status.run is not AgvRun.RUN or status.mode is not AgvMode.AUTO:
        return False
    stood = isinstance(look.order.before, AgvStatus) and look.order.before.run is not AgvRun.RUN
    return stood or _is_counted(look.order, status) or (not status.path and look.fresh)


def _arrival(order: Order, status: AgvStatus) -> Judgement:
    away = order.goal is not None and status.tag != order.goal
    return f"it reports to be in position at tag {status.tag}, not {order.goal}" if away else DONE


def _under_way(look: Look, status: AgvStatus) -> Judgement:
    order = look.order
    if status.run is AgvRun.ERROR:
        return f"the AGV reports an error, last tag {status.tag}"
    if status.arrived:
        return _arrival(order, status)
    return _stopped_short(look, status, look.timing.standing)


def _stopped_short(look: Look, status: AgvStatus, patience: Seconds) -> Judgement:
    order = look.order
    if status.mode is AgvMode.MANUAL:
        return f"the AGV was turned to manual, last tag {status.tag}"
    if status.run is AgvRun.RUN:
        order.standing = None
        return NOTHING
    order.standing = look.now if order.standing is None else order.standing
    return NOTHING if look.now < order.standing + patience else f"it stands, last tag {status.tag}"


def _charge(look: Look, status: AgvStatus) -> Judgement:
    order = look.order
    on = isinstance(order.command, AgvCharge) and order.command.on
    if look.is_new(lambda s: s.charging is on, status):
        return DONE
    if not on:
        return NOTHING
    if order.phase is Phase.TAKEN:
        error = status.run is AgvRun.ERROR
        return "the AGV reports an error" if error else _stopped_short(look, status, look.timing.docking)
    return TAKEN if _starts(look, status) else NOTHING


def _stop(look: Look, status: AgvStatus) -> Judgement:
    return DONE if look.is_new(lambda s: s.run is not AgvRun.RUN, status) else NOTHING


def _mark_stop(look: Look, status: AgvStatus) -> Judgement:
    if look.is_new(lambda s: s.run is not AgvRun.RUN, status):
        return DONE
    waits = look.order.phase is Phase.ASKED and status.steering is Steering.MARK_STOP
    return TAKEN if waits and look.is_new(lambda s: s.steering is Steering.MARK_STOP, status) else NOTHING


def _reset(look: Look, status: AgvStatus) -> Judgement:
    return DONE if look.is_new(lambda s: s.run is not AgvRun.ERROR, status) else NOTHING


def _set_current(look: Look, status: AgvStatus) -> Judgement:
    return DONE if look.is_new(lambda s: s.tag == look.order.goal, status) else NOTHING


def _manual(look: Look, status: AgvStatus) -> Judgement:
    runs = look.is_new(lambda s: s.run is AgvRun.RUN and s.mode is AgvMode.MANUAL, status)
    return DONE if runs else NOTHING


def _follow(look: Look, status: AgvStatus) -> Judgement:
    command = look.order.command
    steering = command.steering if isinstance(command, AgvMoveAuto) else None

    def follows(s: AgvStatus) -> bool:
        return s.run is AgvRun.RUN and s.mode is AgvMode.AUTO and s.steering is steering

    return DONE if look.is_new(follows, status) else NOTHING


def _lift(look: Look, status: AgvStatus) -> Judgement:
    order, command = look.order, look.order.command
    action = command.action if isinstance(command, AgvLift) else LiftAction.STOP
    if action is LiftAction.STOP:
        # LiftSt is 2 both while it moves and where it was stopped; standing at an end is what it was stopped for.
        return DONE if look.fresh and (status.lift is not LiftState.UNKNOWN or _is_at_rest(look)) else NOTHING
    wanted = LiftState.UP if action is LiftAction.UP else LiftState.DOWN
    if look.is_new(lambda s: s.lift is wanted, status):
        return DONE
    if status.lift is LiftState.UNKNOWN:
        begun = isinstance(order.before, AgvStatus) and order.before.lift is not LiftState.UNKNOWN
        return TAKEN if begun and order.phase is Phase.ASKED else NOTHING
    return f"the lift is {status.lift.name.lower()} again" if order.phase is Phase.TAKEN else NOTHING


def _is_at_rest(look: Look) -> bool:
    return look.now >= look.order.first_at + look.timing.lifting


def _lock(look: Look, status: BufferState) -> Judgement:
    """Judge Lock and UnLock: Status says that the buffer is busy with it, never that it is locked."""
    order = look.order
    ended = status in (BufferState.NO_CART, BufferState.CART)
    if order.phase is Phase.TAKEN:
        if status is BufferState.ERROR:
            return "the buffer reports an error"
        return DONE if ended else NOTHING
    if status is not BufferState.BUSY:
        order.before = status
        return NOTHING
    return NOTHING if order.before is BufferState.BUSY else TAKEN


def _door(look: Look, status: DoorState) -> Judgement:
    order = look.order
    opens = order.command is DeviceAct.OPEN
    wanted, other = (DoorState.OPEN, DoorState.CLOSED) if opens else (DoorState.CLOSED, DoorState.OPEN)
    if order.phase is Phase.TAKEN:
        if status in (DoorState.ERROR, other):
            return f"the door reports {status.name.lower()}"
        return DONE if status is wanted else NOTHING
    if look.is_new(lambda s: s is wanted, status):
        return DONE
    if status is not DoorState.BUSY:
        order.before = status
        return NOTHING
    begun = look.fresh if order.before is None else order.before is not DoorState.BUSY
    return TAKEN if begun else NOTHING


_AGV: Mapping[type[Any] | DeviceAct, Callable[[Look, AgvStatus], Judgement]] = MappingProxyType(
    {
        AgvMove: _drive,
        AgvMoveAlias: _drive,
        AgvSetCurrent: _set_current,
        AgvMoveManual: _manual,
        AgvMoveAuto: _follow,
        AgvLift: _lift,
        AgvCharge: _charge,
        DeviceAct.STOP: _stop,
        DeviceAct.RESET: _reset,
        DeviceAct.MARK_STOP: _mark_stop,
    }
)


def obstacle(command: DeviceCommand, status: DeviceStatus) -> tuple[str, str] | None:
    """Return what in a Status explains that a command has no effect, and the remedy; None if nothing does (5.3)."""
    if not isinstance(status, AgvStatus):
        error = status.name == "ERROR"
        return ("it reports an error", "see what is wrong at the device") if error else None
    drives = isinstance(command, AgvMove | AgvMoveAlias | AgvMoveAuto | AgvMoveManual | AgvCharge)
    if drives and status.run is AgvRun.ERROR and command != AgvCharge(on=False):
        return "the AGV is in error", "see what is wrong at the AGV, then Reset"
    if isinstance(command, AgvSetCurrent) and status.run is not AgvRun.STOP:
        return "the AGV does not stand still", "stop it first"
    return None


def is_busy(command: DeviceCommand, status: DeviceStatus) -> bool:
    """Return whether a device is at work on what the command is for, perhaps for another reason."""
    if isinstance(command, AgvLift) and isinstance(status, AgvStatus):
        return command.action is not LiftAction.STOP and status.lift is LiftState.UNKNOWN
    return status in (DoorState.BUSY, BufferState.BUSY) and isinstance(command, DeviceAct)
