"""A simulated AGV: what it accepts, and what a person at it does (PROTOCOLS 5.3)."""

from collections.abc import Callable
from dataclasses import fields

from app.domain.devices import AgvMode, AgvRun, AgvSpeed, CartState, DeviceNumber, LiftAction, LiftState, Steering
from app.domain.units import Barcode, Seconds
from app.protocols.enig.messages import (
    AgvReport,
    Body,
    Charge,
    Lift,
    MarkStop,
    Move,
    MoveAlias,
    MoveAuto,
    MoveManual,
    Reset,
    SetCurrent,
    Stop,
    is_tag,
)
from app.protocols.enig.simulator.drive import length_of
from app.protocols.enig.simulator.hall import Hall
from app.protocols.enig.simulator.options import AgvOptions
from app.protocols.enig.simulator.running import Running, Task
from app.protocols.enig.simulator.tape import Tape


class SimulatedAgv(Running):
    """An AGV on its tape. What it does not accept it ignores, as ENIG has no refusal: ``last_ignored`` says why."""

    def __init__(
        self,
        number: DeviceNumber,
        tape: Tape,
        start: Barcode,
        *,
        options: AgvOptions = AgvOptions(),  # noqa: B008  (frozen)
        hall: Hall | None = None,
    ) -> None:
        """Put the AGV on a tag, which it has not read. Raises: ValueError: no tag of the tape, or one that is no TagID."""
        if start not in tape:
            raise ValueError(f"{start} is no tag of the tape to start from")
        for tag in tape.tags:
            if not is_tag(tag):
                raise ValueError(f"{tag!r} is no TagID: four printable ASCII characters")
        super().__init__(number, tape, start, options, hall or Hall())
        self.last_ignored = ""
        self._tape = tape
        self._lifting: tuple[LiftState, Callable[[], None]] | None = None

    def place(self, now: Seconds) -> tuple[Barcode, float, Barcode | None]:
        """Return the tag behind, millimetres from it, and the tag ahead (None: it stands on the first). ``tick`` first."""
        return self._drive.place(now)

    # Operator and faults

    def set_mode(self, mode: AgvMode, now: Seconds) -> None:
        """Turn the key at the AGV (E21); what drives stops. Our choice."""
        self.tick(now)
        if mode != self.report.mode:
            self._halt()
            self.report.mode = int(mode)
        self._settle()

    def raise_error(self, now: Seconds) -> None:
        """Let it stop in error until Reset."""
        self.tick(now)
        self._halt()
        self.report.run = int(AgvRun.ERROR)
        self._settle()

    def set_cart(self, cart: CartState, now: Seconds) -> None:
        """Put a cart on it by hand, or take it off."""
        self.tick(now)
        self.report.cart = int(cart)
        self._settle()

    def push_to(self, tag: Barcode, now: Seconds) -> None:
        """Push it to a tag by hand: it stops and reads nothing. Raises: ValueError: no tag of the tape."""
        if tag not in self._tape:
            raise ValueError(f"{tag} is no tag of the tape")
        self.tick(now)
        self._halt()
        self._drive.put(tag)
        self._settle()

    def misread_next(self, tag: Barcode) -> None:
        """Let the next tag be read as another; an AGV that does not find its destination stops in error."""
        self._misread = tag

    def miss_next(self) -> None:
        """Let the next tag not be read."""
        self._missed = True

    def _restart(self) -> None:
        """Back to the start-up state; carts and the lift stay."""
        self._task = self._lifting = None
        fresh = AgvReport(cart=self.report.cart, lift=self.report.lift)
        for field in fields(fresh):
            setattr(self.report, field.name, getattr(fresh, field.name))

    # Commands

    def _obey(self, body: Body) -> None:
        self.last_ignored = ""
        match body:
            case Move() | MoveAlias():
                self._move(Barcode(body.tag) if isinstance(body, Move) else self._tape.places.get(body.alias))
            case Stop():
                self._halt()
            case Reset():
                self._reset()
            case SetCurrent():
                self._set_current(Barcode(body.tag))
            case MoveManual():
                self._move_manual(body)
            case MarkStop():
                self._mark_stop()
            case MoveAuto():
                self._move_auto(body)
            case Lift():
                self._lift(LiftAction(body.action))
            case Charge():
                self._charge(on=bool(body.action))
            case _:
                self.last_ignored = "an AGV does not do this"

    def _accepts(self, condition: bool, *, otherwise: str) -> bool:
        if not condition:
            self.last_ignored = otherwise
        return condition

    def _may_drive(self, mode: AgvMode) -> bool:
        right_mode = self._accepts(self.report.mode == mode, otherwise=f"it is not in {mode.name.lower()}")
        return right_mode and self._accepts(self.report.run != AgvRun.ERROR, otherwise="it is in error")

    def _reset(self) -> None:
        if self._accepts(self.report.run == AgvRun.ERROR, otherwise="there is no error"):
            self.report.run = int(AgvRun.STOP)

    def _set_current(self, tag: Barcode) -> None:
        if self._accepts(self.report.run == AgvRun.STOP, otherwise="it does not stand still"):
            self.report.tag = tag

    def _mark_stop(self) -> None:
        if self._accepts(self.report.run == AgvRun.RUN, otherwise="it does not run"):
            self.report.direction = int(Steering.MARK_STOP)

    def _move(self, goal: Barcode | None, *, charge: bool = False) -> None:
        if not self._may_drive(AgvMode.AUTO):
            return
        way = None if goal is None else self._drive.route(goal, self._agenda.now)
        if goal is None or way is None:
            self.last_ignored = "the destination is unknown"
            return
        self._drive.halt(self._agenda.now)
        self._drive_to(goal, way, charge=charge)

    def _move_manual(self, body: MoveManual) -> None:
        if not self._may_drive(AgvMode.MANUAL):
            return
        self._drive.halt(self._agenda.now)
        self._set_off(Steering.STRAIGHT)
        if body.direction in (0, 1):
            # The other two turn it on the spot, which no tag shows.
            self._wander(Task(forward=body.direction == 1, speed=AgvSpeed(body.speed)))

    def _move_auto(self, body: MoveAuto) -> None:
        if not self._may_drive(AgvMode.AUTO):
            return
        self._drive.halt(self._agenda.now)
        self._set_off(Steering(body.magnet))
        self._wander(Task(forward=bool(body.motor), steering=Steering(body.magnet), speed=AgvSpeed(body.speed)))

    def _charge(self, *, on: bool) -> None:
        if not on:
            self.report.charge = 0
            if self._task is not None:
                self._task.charge = False
            return
        if not self._accepts(self.report.run != AgvRun.RUN, otherwise="it does not stand still"):
            return
        ways = {tag: self._drive.route(tag, self._agenda.now) for tag in self._tape.chargers}
        lengths = {tag: length_of(way) for tag, way in ways.items() if way is not None}
        self._move(min(lengths, key=lambda tag: lengths[tag], default=None), charge=True)

    def _lift(self, action: LiftAction) -> None:
        wanted = LiftState.UP if action is LiftAction.UP else LiftState.DOWN
        if self._lifting is not None:
            under_way, cancel = self._lifting
            if action is not LiftAction.STOP and under_way is wanted:
                return
            cancel()
            self._lifting = None
        if action is not LiftAction.STOP and self.report.lift != wanted:
            self.report.lift = int(LiftState.UNKNOWN)
            self._lifting = wanted, self._after(self._options.lift_time, lambda: self._lifted(wanted))

    def _lifted(self, end: LiftState) -> None:
        self._lifting = None
        self.report.lift = int(end)
        self._move_cart(end)
