"""One device of a link: what it last said, and the commands whose effect it has still to show (PROTOCOLS E9, E14, 6.1)."""

from collections.abc import Callable, Mapping

from app.domain.devices import (
    AgvMove,
    AgvMoveAlias,
    AgvSetCurrent,
    AliasName,
    DeviceAct,
    DeviceBack,
    DeviceCommand,
    DeviceDone,
    DeviceDoubt,
    DeviceEvent,
    DeviceFailed,
    DeviceNotAccepted,
    DeviceNotSent,
    DeviceReported,
    DeviceRequest,
    DeviceSpec,
    DeviceStale,
    DeviceStatus,
    DeviceTaken,
    DeviceUnknown,
)
from app.domain.units import Barcode, Seconds
from app.protocols.enig.session.evidence import (
    Judgement,
    Look,
    Order,
    Phase,
    Verdict,
    completes,
    is_busy,
    judge,
    obstacle,
)
from app.protocols.enig.session.requests import BLIND, Axis, axis_of, may_repeat, name_of, wrong_mode
from app.protocols.enig.session.timing import Timing

Tell = Callable[[DeviceEvent], None]
Emit = Callable[[bytes, Seconds], None]


class Device:
    """A device as the session knows it. ``status`` is kept when it is stale: see ``fresh``."""

    __slots__ = (
        "_emit",
        "_tell",
        "_timing",
        "_watched_from",
        "fresh",
        "orders",
        "resends",
        "spec",
        "status",
        "status_at",
    )

    def __init__(self, spec: DeviceSpec, timing: Timing, tell: Tell, emit: Emit) -> None:
        self.spec, self._timing, self._tell, self._emit = spec, timing, tell, emit
        self.status: DeviceStatus | None = None
        self.status_at: Seconds | None = None
        self.fresh = False
        self.orders: list[Order] = []
        self.resends = 0
        self._watched_from: Seconds | None = None

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next."""
        times = [order.due for order in self.orders if order.due is not None]
        if self._watched_from is not None:
            times.append(Seconds(self._watched_from + self._timing.stale))
        return min(times, default=None)

    def connected(self, now: Seconds) -> None:
        """The link is up: the first Status is due."""
        self._watched_from = now

    def lost(self, reason: str) -> None:
        """The link is down."""
        self._watched_from = None
        self._doubt(DeviceDoubt.LINK_LOST)
        if self.fresh:
            self.fresh = False
            self._tell(DeviceStale(self.spec.id, reason))

    def reported(self, status: DeviceStatus, now: Seconds) -> None:
        """A Status has come."""
        if not self.fresh:
            self._tell(DeviceBack(self.spec.id))
        if not self.fresh or status != self.status:
            self._tell(DeviceReported(self.spec.id, status, now))
        self.fresh, self.status, self.status_at, self._watched_from = True, status, now, now
        for order in list(self.orders):
            self._judged(order, judge(self._look(order, now), status), now)
        self._tick_orders(now)

    def completed(self, tag: Barcode, now: Seconds) -> None:
        """Move Complete has come."""
        for order in list(self.orders):
            if completes(self._look(order, now), tag):
                self._judged(order, Verdict.DONE, now)

    def tick(self, now: Seconds) -> None:
        """Do what is due."""
        if self._watched_from is not None and now >= self._watched_from + self._timing.stale:
            self._watched_from, self.fresh = None, False
            self._doubt(DeviceDoubt.STALE, but=BLIND)
            self._tell(DeviceStale(self.spec.id, f"no Status for {self._timing.stale:g} s"))
        self._tick_orders(now)

    def refusal(self, command: DeviceCommand, *, up: bool) -> tuple[str, str] | None:
        """Return why a command is not sent now, and the remedy; None if it may go."""
        if not up:
            return "the link is down", "connect it"
        if not self.fresh:
            return None if command in BLIND else ("it has not reported for a while", "see whether it is switched on")
        if wrong := wrong_mode(command, self.status):
            return wrong
        order = self._in_the_way(command)
        return None if order is None else (f"{name_of(order.command)} is under way", "wait until it has ended")

    def _in_the_way(self, command: DeviceCommand) -> Order | None:
        """Return what must have shown its effect first, lest the one be taken for the other's: locks and drives."""
        axis = axis_of(command)
        stops = isinstance(command, DeviceAct) and axis is Axis.MOTION
        for order in self.orders:
            unseen = order.phase is Phase.ASKED and axis is Axis.MOTION and not stops
            if order.axis is axis and (unseen or axis is Axis.LOCK):
                return order
        return None

    def begin(self, request: DeviceRequest, packet: bytes, goal: Barcode | None, now: Seconds) -> None:
        """Send a command."""
        axis = axis_of(request.command)
        overtaken = [order for order in self.orders if order.axis is axis and not self._goes_on(order)]
        for order in overtaken:
            self._end(order, DeviceUnknown(self.spec.id, order.id, DeviceDoubt.OVERTAKEN))
        self.orders.append(
            Order(
                request.id,
                request.command,
                axis,
                packet,
                goal,
                self.status if self.fresh else None,
                first_at=now,
                sent_at=now,
                due=Seconds(now + self._timing.confirm),
                resends=self._timing.resends if may_repeat(request.command) else 0,
                crossed=bool(overtaken),
            )
        )
        self._emit(packet, now)

    def _goes_on(self, order: Order) -> bool:
        # A drive that has begun goes on until the later command is seen to have been taken.
        return order.phase is Phase.TAKEN and order.axis is Axis.MOTION

    def _look(self, order: Order, now: Seconds) -> Look:
        return Look(order, now, now >= order.sent_at + self._timing.transit, self._timing)

    def _judged(self, order: Order, judgement: Judgement, now: Seconds) -> None:
        match judgement:
            case Verdict.NOTHING:
                return
            case Verdict.TAKEN:
                self._take(order, now)
            case Verdict.DONE:
                self._overtake(order)
                self._end(order, DeviceDone(self.spec.id, order.id))
            case reason:
                self._end(order, DeviceFailed(self.spec.id, order.id, str(reason)))

    def _take(self, order: Order, now: Seconds) -> None:
        self._overtake(order)
        order.phase = Phase.TAKEN
        # How long a drive takes is the caller's business; all other work must end.
        order.due = None if order.axis is Axis.MOTION else Seconds(now + self._timing.work)
        self._tell(DeviceTaken(self.spec.id, order.id))

    def _overtake(self, order: Order) -> None:
        for older in self.orders[: self.orders.index(order)]:
            if older.axis is order.axis:
                self._end(older, DeviceFailed(self.spec.id, older.id, f"overtaken by {name_of(order.command)}"))

    def _tick_orders(self, now: Seconds) -> None:
        for order in list(self.orders):
            if order.due is None:
                # Only an ASKED order without a due time waits for a Status; it was looked at when that came.
                self._conclude(order, now)
            elif now >= order.due:
                self._overdue(order, now)

    def _overdue(self, order: Order, now: Seconds) -> None:
        if order.phase is Phase.TAKEN:
            reason = f"it has not ended within {self._timing.work:g} s"
            self._end(order, DeviceFailed(self.spec.id, order.id, reason))
        elif order.resends and not self._explained(order):
            order.resends -= 1
            self.resends += 1
            order.before = self.status if self.fresh else None
            order.sent_at, order.due = now, Seconds(now + self._timing.confirm)
            self._emit(order.packet, now)
        elif self._watched_from is None:
            self._end(order, DeviceUnknown(self.spec.id, order.id, DeviceDoubt.STALE))
        else:
            order.due = None
            self._conclude(order, now)

    def _explained(self, order: Order) -> tuple[str, str] | None:
        """Return what in a Status since the command explains that nothing has happened."""
        if self.status is None or not self._heard_since(order):
            return None
        return wrong_mode(order.command, self.status) or obstacle(order.command, self.status)

    def _heard_since(self, order: Order) -> bool:
        return self.fresh and self.status_at is not None and self.status_at >= order.sent_at + self._timing.transit

    def _conclude(self, order: Order, now: Seconds) -> None:
        """End an order that shows no effect, as soon as there is a Status to say so."""
        if order.phase is Phase.TAKEN or self.status is None or not self._heard_since(order):
            return
        if not self._explained(order) and is_busy(order.command, self.status):
            self._take(order, now)
            return
        reason, remedy = self._explained(order) or (
            "Status shows no effect",
            "see whether the device does what it is told",
        )
        self._end(order, DeviceNotAccepted(self.spec.id, order.id, reason, remedy))

    def _doubt(self, why: DeviceDoubt, but: frozenset[DeviceAct] = frozenset()) -> None:
        for order in [order for order in self.orders if order.command not in but]:
            self._end(order, DeviceUnknown(self.spec.id, order.id, why))

    def _end(self, order: Order, event: DeviceDone | DeviceFailed | DeviceNotAccepted | DeviceUnknown) -> None:
        self.orders.remove(order)
        self._tell(event)


def not_sent(request: DeviceRequest, reason: str, remedy: str = "") -> DeviceNotSent:
    """Return that a request was refused before the first byte."""
    return DeviceNotSent(request.device, request.id, reason, remedy)


def goal_of(command: DeviceCommand, places: Mapping[AliasName, Barcode]) -> Barcode | None:
    """Return the tag that a command is about, if it is known."""
    match command:
        case AgvMove() | AgvSetCurrent():
            return command.tag
        case AgvMoveAlias():
            return places.get(command.alias)
        case _:
            return None
