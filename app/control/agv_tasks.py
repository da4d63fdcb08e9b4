"""The fleet's commands to an AGV as sequences of ENIG's, and what a Status must show at their end (COMMANDS section 1)."""

from collections import deque
from dataclasses import dataclass, field

from app.domain.commands import Direct, Move, Pickup, Place, Plain, Send, Simple
from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMoveAlias,
    AgvStatus,
    CartState,
    DeviceAct,
    DeviceCommand,
    DeviceRequestId,
    LiftAction,
    LiftState,
)
from app.domain.units import Barcode, Seconds

UP, DOWN = AgvLift(LiftAction.UP), AgvLift(LiftAction.DOWN)
_ACTS = {
    Plain.STOP: DeviceAct.STOP,
    Plain.STOP_BY_HOST: DeviceAct.STOP,
    Plain.ALARM_CLEAR: DeviceAct.RESET,
}


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a command ended; ``reason`` where it was not as asked."""

    ok: bool
    reason: str = ""


@dataclass(slots=True, eq=False)
class Task:
    """A command under way. ``steps`` are still to be sent, one after the other; ``request`` is the one sent last.

    ``waits``: it has not shown to have taken that. ``stopped``: a Stop was sent before all of it was. ``ended`` is when the
    last of them ended; a Status has the last word then.
    """

    send: Send
    steps: deque[DeviceCommand]
    request: DeviceRequestId | None = None
    waits: bool = False
    stopped: bool = False
    ended: Seconds | None = None

    def judged(self, status: AgvStatus) -> Outcome:
        """Return what this Status says of the ended task. A denial may be a Status that was on its way."""
        return Outcome(ok=True)


@dataclass(slots=True, eq=False)
class Journey(Task):
    """A MOVE with its amendments: ``way`` are the granted tags, ``at`` the index of the last one read.

    ``aim`` is the index that the AGV was told last (None: nothing yet); ``under_way``: it has not arrived there.
    """

    way: list[Barcode] = field(default_factory=list)
    at: int = 0
    aim: int | None = None
    under_way: bool = False
    acknowledged: bool = False

    @property
    def ends(self) -> bool:
        """Whether it is told no more of its way."""
        return self.ended is not None or self.stopped

    @property
    def at_its_aim_short_of_the_end(self) -> bool:
        """Whether the AGV has come as far as it was told, or has been told nothing, and there is more."""
        return self.aim is None or self.aim < len(self.way) - 1

    def passed(self, tag: Barcode) -> None:
        """Note a tag that lies on the way to where it was told to go."""
        if self.aim is not None and tag in self.way[self.at + 1 : self.aim + 1]:
            self.at = self.way.index(tag, self.at + 1)

    def judged(self, status: AgvStatus) -> Outcome:
        """Move Complete is only a hint (PROTOCOLS E27): Status must show it in position, at the tag."""
        if status.arrived and status.tag == self.way[-1]:
            return Outcome(ok=True)
        return Outcome(ok=False, reason=f"Status does not show it in position at {self.way[-1]}, but at {status.tag}")


@dataclass(slots=True, eq=False)
class Handling(Task):
    """PICKUP and PLACE: the lift's whole way, then LiftSt and CartSt must agree.

    ``way_back`` brings the lift to where it harms nothing if no cart has moved: the AGV may be driven then.
    """

    pickup: bool = False
    way_back: tuple[DeviceCommand, ...] = ()
    outcome: Outcome | None = None

    def judged(self, status: AgvStatus) -> Outcome:
        """CartSt decides."""
        if self.outcome is not None:
            return self.outcome
        wanted = CartState.PRESENT if self.pickup else CartState.NONE
        if status.cart is wanted and status.lift is (LiftState.UP if self.pickup else LiftState.DOWN):
            return Outcome(ok=True)
        cart = {
            CartState.NONE: "no cart is on it",
            CartState.PRESENT: "a cart is on it",
            CartState.UNKNOWN: "it does not know whether a cart is on it",
        }[status.cart]
        return Outcome(ok=False, reason=f"its lift is {status.lift.name.lower()}, and {cart}")


def task_of(send: Send, status: AgvStatus) -> Task | None:
    """Return a command as a task of an AGV in this state; None: ENIG has no such command."""
    match send.command:
        case Move(path=path):
            return Journey(send, deque(_ready_to_drive(status)), way=[element.barcode for element in path])
        case Pickup():
            steps = [UP] if status.lift is LiftState.DOWN else [DOWN, UP]
            return Handling(send, deque(steps), pickup=True, way_back=(DOWN,))
        case Place():
            steps = [DOWN] if status.lift is LiftState.UP else [UP, DOWN]
            return Handling(send, deque(steps), way_back=(UP,))
        case Simple(what=what) if what in _ACTS:
            return Task(send, deque([_ACTS[what]]))
        case Direct(command=AgvMoveAlias() as command):
            return Task(send, deque([*_ready_to_drive(status), command]))
        case Direct(command=command):
            return Task(send, deque([command]))
        case _:
            return None


def _ready_to_drive(status: AgvStatus) -> list[DeviceCommand]:
    """Return what must come before driving: charging ends, and the lift stands as the cart wants it (our choice)."""
    steps: list[DeviceCommand] = [AgvCharge(on=False)] if status.charging else []
    if status.lift is LiftState.UP and status.cart is CartState.NONE:
        steps.append(DOWN)
    if status.lift is LiftState.DOWN and status.cart is CartState.PRESENT:
        steps.append(UP)
    return steps
