"""The driving half of a simulated AGV: what it does once it has accepted a command (PROTOCOLS 5.3)."""

from collections import deque
from dataclasses import dataclass, field

from app.domain.devices import AgvRun, AgvSpeed, CartState, DeviceNumber, LiftState, Steering
from app.domain.units import Barcode, Seconds
from app.protocols.enig.messages import AgvReport, MoveComplete, TagReceived
from app.protocols.enig.simulator.device import SimulatedDevice
from app.protocols.enig.simulator.drive import Drive, Piece
from app.protocols.enig.simulator.hall import Hall
from app.protocols.enig.simulator.options import AgvOptions
from app.protocols.enig.simulator.tape import Tape

_LAST_PATH = 255


@dataclass(slots=True)
class Task:
    """Where it is going: along ``way`` to ``goal``, and to charge there; or without a goal along the tape."""

    goal: Barcode | None = None
    way: deque[Piece] = field(default_factory=deque)
    charge: bool = False
    forward: bool = True
    steering: Steering = Steering.STRAIGHT
    speed: AgvSpeed = AgvSpeed.NORMAL


class Running(SimulatedDevice):
    """What drives and lifts; see SimulatedAgv, which adds what it accepts."""

    def __init__(self, number: DeviceNumber, tape: Tape, start: Barcode, options: AgvOptions, hall: Hall) -> None:
        self.report = AgvReport()
        """Its Status, to be read only."""
        self._options, self._hall = options, hall
        self._task: Task | None = None
        self._misread: Barcode | None = None
        self._missed = False
        self._drive = Drive(tape, start, self._after)
        super().__init__(number, self.report, options.status_every)

    def _set_off(self, steering: Steering) -> None:
        """Begin to drive: charge off first."""
        if self.report.charge:
            self.report.charge = 0
            self._report()
        self._task = None
        self.report.inposition, self.report.run, self.report.direction = 0, int(AgvRun.RUN), int(steering)

    def _drive_to(self, goal: Barcode, way: tuple[Piece, ...], *, charge: bool) -> None:
        """Drive to a tag. At the present one, or where it believes to be there already, it is there at once."""
        present = self._drive.piece is None and (not way or self.report.tag == goal)
        self._set_off(Steering.STRAIGHT)
        self.report.path = self.report.path % _LAST_PATH + 1
        self._task = task = Task(goal, deque(way), charge)
        if not present:
            self._go_on(task)
            return
        if self.report.tag != goal:
            self._read(goal)
        self._arrive()

    def _wander(self, task: Task) -> None:
        self._task = task
        self._go_on(task)

    def _go_on(self, task: Task) -> None:
        """Drive the next piece of tape."""
        now = self._agenda.now
        if task.goal is not None:
            piece: Piece | None = task.way.popleft()
        else:
            piece = self._drive.onward(now, forward=task.forward, steering=task.steering)
        if piece is None:
            # The end of the tape: a person sees it, an automatic drive is lost.
            self._halt()
            self.report.run = int(AgvRun.ERROR if self.report.mode else AgvRun.STOP)
        elif piece.done == 0 and not self._hall.passable(piece.edge.start, piece.edge.end, Seconds(now)):
            self._halt()
            self.report.run = int(AgvRun.ERROR)
        else:
            self._drive.go(piece, self._options.speeds[task.speed], now, lambda tag: self._reached(tag, task))

    def _reached(self, tag: Barcode, task: Task) -> None:
        """A mark is under the AGV, and mostly its tag can be read."""
        read = self._read_here(tag)
        if task.goal is not None and not task.way:
            if read == task.goal:
                self._arrive()
            else:
                self._halt()
                self.report.run = int(AgvRun.ERROR)
        elif self.report.direction == Steering.MARK_STOP:
            self._halt()
        else:
            self._go_on(task)

    def _read_here(self, tag: Barcode) -> Barcode | None:
        read = None if self._missed else (self._misread or tag)
        self._missed, self._misread = False, None
        if read is not None:
            self._read(read)
        return read

    def _read(self, tag: Barcode) -> None:
        self.report.tag = tag
        self._say(TagReceived(tag))

    def _arrive(self) -> None:
        charge = self._task is not None and self._task.charge
        self._task = None
        self.report.run, self.report.inposition = int(AgvRun.STOP), 1
        self._report()
        self._say(MoveComplete(self.report.tag))
        self.report.charge = int(charge)

    def _freeze(self) -> None:
        self._drive.halt(self._agenda.now)

    def _halt(self) -> None:
        """Stop, and forget where it was going; an error stays."""
        self._drive.halt(self._agenda.now)
        self._task = None
        if self.report.run == AgvRun.RUN:
            self.report.run = int(AgvRun.STOP)

    def _move_cart(self, end: LiftState) -> None:
        """The lift is at an end: standing before a buffer, it takes the cart there or leaves its own."""
        if self._task is not None or self._drive.piece is not None:
            return
        now, tag, cart = Seconds(self._agenda.now), self._drive.at, self.report.cart
        if end is LiftState.UP and cart == CartState.NONE and self._hall.take_cart(tag, now):
            self.report.cart = int(CartState.PRESENT)
        elif end is LiftState.DOWN and cart == CartState.PRESENT and self._hall.put_cart(tag, now):
            self.report.cart = int(CartState.NONE)
