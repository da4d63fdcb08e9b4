"""A vehicle that does what it is told, in a few lines: drives a barcode per second, handles in four."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from app.domain.commands import Move, Pickup, Place, Plain, Send, Simple, Xmove
from app.domain.events import Acknowledged, Answered, LinkUp, Reported
from app.domain.ids import CarrierId, VehicleId, epoch_of
from app.domain.layout import StopAction, VehicleSpec
from app.domain.route import PathElement
from app.domain.units import Barcode, Seconds
from app.domain.vehicle import Condition, VehicleStatus
from app.protocols.itsc.condition import condition

if TYPE_CHECKING:
    from tests.fleet.script import Script

TAGS = {
    StopAction.RUN: 0,
    StopAction.STOP: 0,
    StopAction.PORT: 1,
    StopAction.SBFL: 2,
    StopAction.SBFR: 4,
    StopAction.PORT_BARE: 1,
}
BARCODE_EVERY = 1.0
HANDLE_FOR = 4.0
POLL_EVERY = 1.0


class Toy:
    """One obedient vehicle. Settable: ``alarm`` (a code: it is in ALARM), ``mode``, ``refuse`` (answers RESULT 1), ``paused``,
    ``misgrip`` (RESULT 0, but F stays). It keeps going while the line is down.
    """

    def __init__(self, script: "Script", spec: VehicleSpec, at: Barcode) -> None:
        self.script = script
        self.spec = spec
        self._stations = script.plant.stations
        self.barcode = at
        self.linked = False
        self.aboard: CarrierId | str | None = None
        self.trav = 0
        self.mode = 3
        self.alarm = 0
        self.refuse = False
        self.paused = False
        self.misgrip = False
        self.reject_handling = False
        self.seq = 0
        self.path: tuple[PathElement, ...] = ()
        self.moving: Send | None = None
        self.handling: Send | None = None
        self.due = Seconds(0.0)
        self._polled = Seconds(0.0)
        self._unsaid: list[Callable[[], None]] = []

    @property
    def id(self) -> VehicleId:
        """Its name."""
        return self.spec.id

    @property
    def condition(self) -> Condition:
        """What it would say of itself now."""
        busy = self.moving or self.handling
        oper = 1 if self.alarm else 3 if self.paused and busy else 2 if busy else 0
        axes = 0x118134 if self.handling else 0x111134
        trav = 8 if self.moving else self.trav
        flags = 0xB if self.handling else 0xF
        return condition(
            bool(self.aboard) << 31 | trav << 24 | axes, self.mode << 30 | oper << 28 | flags << 24 | self.alarm
        )

    def connect(self) -> None:
        """The line is there."""
        self.linked = True
        self.script.hear(LinkUp(self.id))

    def cut(self) -> None:
        """The line is gone; it drives on."""
        self.linked = False
        self._unsaid.clear()
        self.script.link_down(self.id)

    def take(self, send: Send) -> None:
        """Take a command off the line; one that comes while the line is down is lost."""
        if not self.linked:
            return
        self._say(lambda: self.script.hear(Acknowledged(self.id, send.cmd_id)))
        match send.command:
            case Move(path=path):
                self._begin_move(send, path)
            case Xmove(path=path):
                self._extend(send, path)
            case Pickup() | Place():
                self._begin_handling(send)
            case Simple(what=what):
                self._obey(send, what)
            case _:
                self._answer(send)

    def step(self, *, polled: bool) -> None:
        """A quarter of a second has passed."""
        now = self.script.now
        if self.moving and not self.paused and now >= self.due:
            self._drive()
        if self.handling and not self.paused and now >= self.due:
            self._handle()
        if not self.linked:
            self._unsaid.clear()
            return
        unsaid, self._unsaid = self._unsaid, []
        for say in unsaid:
            say()
        if polled or now >= self._polled + POLL_EVERY:
            self._polled = now
            self._report(polled=True)

    # -- motion -------------------------------------------------------------------------------------------------------

    def _begin_move(self, send: Send, path: tuple[PathElement, ...]) -> None:
        if (
            self.refuse
            or self.moving
            or self.handling
            or self.alarm
            or self.mode != 3
            or path[0].barcode != self.barcode
        ):
            self._answer(send, ok=False)
            return
        self.moving, self.path, self.seq, self.trav = send, path, path[0].seq, 0
        self.due = Seconds(self.script.now + BARCODE_EVERY)

    def _extend(self, send: Send, path: tuple[PathElement, ...]) -> None:
        if self.refuse or not self.moving or not self.seq <= path[0].seq <= self.path[-1].seq:
            self._answer(send, ok=False)
            return
        self.path = (*(e for e in self.path if e.seq < path[0].seq), *path)
        self._answer(send)

    def _drive(self) -> None:
        rest = [e for e in self.path if e.seq > self.seq]
        if rest:
            self.barcode, self.seq = rest[0].barcode, rest[0].seq
            self.due = Seconds(self.script.now + BARCODE_EVERY)
            self._say(lambda: self._report(polled=False))
        if self.moving and self.seq == self.path[-1].seq:
            send, self.moving = self.moving, None
            self.trav = TAGS[self.path[-1].action]
            self._answer(send)

    def stop_with(self, alarm: int) -> None:
        """Stop where it is, in alarm; what was under way ends abnormally."""
        under_way, self.moving, self.handling, self.alarm = self.moving or self.handling, None, None, alarm
        if under_way:
            self._answer(under_way, ok=False)

    # -- handling -----------------------------------------------------------------------------------------------------

    def _begin_handling(self, send: Send) -> None:
        pickup = isinstance(send.command, Pickup)
        refuse = self.refuse or self.reject_handling
        at_stop = (
            bool(self.trav & TAGS[send.command.at.stop_action]) if isinstance(send.command, Pickup | Place) else False
        )
        if (
            refuse
            or self.alarm
            or self.mode != 3
            or self.moving
            or self.handling
            or not at_stop
            or pickup == bool(self.aboard)
        ):
            self._answer(send, ok=False)
            return
        self.handling, self.due = send, Seconds(self.script.now + HANDLE_FOR)

    def _handle(self) -> None:
        send, self.handling = self.handling, None
        if send is None or not isinstance(send.command, Pickup | Place):
            return
        if not self.misgrip:
            self._exchange(pickup=isinstance(send.command, Pickup), at=send.command.at.value)
        self._answer(send, ok=not self.alarm)

    def _exchange(self, *, pickup: bool, at: str) -> None:
        world = self.script.world
        station = next(s.id for s in self._stations if s.barcode == self.barcode and s.kind.value == at)
        if pickup:
            if station not in world:
                self.alarm = 201
                return
            self.aboard = world.pop(station)
            return
        assert station not in world, f"{self.id} puts down at {station}, which is full"
        assert self.aboard is not None
        world[station], self.aboard = CarrierId(self.aboard), None

    # -- the rest -----------------------------------------------------------------------------------------------------

    def _obey(self, send: Send, what: Plain) -> None:
        if what is Plain.STOP:
            self._halt()
            self.mode = 0
        elif what is Plain.STOP_BY_HOST:
            self._halt()
        elif what is Plain.ALARM_CLEAR:
            self.alarm = 0
        elif what is Plain.AUTO:
            self.mode = 3
        self._answer(send)

    def _halt(self) -> None:
        if self.moving:
            self._answer(self.moving, ok=False)
            self.moving = None

    def _say(self, say: Callable[[], None]) -> None:
        """Say it at the next step, unless another controller runs by then: a session drops what answers another epoch."""
        fleet = self.script.fleet
        self._unsaid.append(lambda: say() if self.script.fleet is fleet else None)

    def _answer(self, send: Send, *, ok: bool = True) -> None:
        state, barcode, seq = self.condition, self.barcode, self.seq
        if epoch_of(send.cmd_id) == self.script.fleet.books.epoch:
            self._say(
                lambda: self.script.hear(Answered(self.id, send.cmd_id, send.command, ok, "", state, barcode, seq))
            )

    def _report(self, *, polled: bool) -> None:
        status = VehicleStatus(self.condition, self.barcode, self.seq)
        self.script.hear(Reported(self.id, status, polled, self.script.now))
