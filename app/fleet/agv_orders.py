"""Requests about one AGV: what ENIG can say, in which mode, and what is not granted to anybody (COMMANDS section 1, E21)."""

from collections.abc import Mapping

from app.domain.commands import Direct, Plain, Simple
from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMove,
    AgvMoveAlias,
    AgvMoveAuto,
    AgvMoveManual,
    AgvRun,
    AgvSetCurrent,
    DeviceAct,
    DeviceCommand,
    LiftAction,
)
from app.domain.errors import NoRoute, Refusal
from app.domain.events import Unanswered
from app.domain.layout import StopAction
from app.domain.requests import Accepted, CommandAgv, CommandVehicle, DisplayOnVehicle, MoveVehicle, Reply
from app.domain.units import Barcode
from app.domain.vehicle import Mode
from app.domain.view import Topic
from app.fleet.books import Books
from app.fleet.devices import Devices
from app.fleet.motion import Motion
from app.fleet.orders import VehicleOrders
from app.fleet.recovery import Recovery
from app.fleet.refusals import standstill
from app.fleet.vehicle import Drive, Errand, Purpose, VehicleNow
from app.planning.kinematics import elements
from app.planning.ways import Ways

PLAIN = frozenset({Plain.STATUS, Plain.STOP, Plain.STOP_BY_HOST, Plain.ALARM_CLEAR})
"""The commands without data that AGVs have too: both stops are Stop, ALARM CLEAR is Reset."""
AT_THE_AGV = "the mode is changed at the AGV alone (ENIG has no command for it)"


class AgvOrders:
    """Answers what only AGVs are asked, and what they are asked in another way than hoists."""

    def __init__(
        self, books: Books, motion: Motion, recovery: Recovery, orders: VehicleOrders, devices: Devices
    ) -> None:
        self._books = books
        self._motion = motion
        self._recovery = recovery
        self._orders = orders
        self._devices = devices
        self._ways = Ways(books.track)

    def _accepted(self, vehicle: VehicleNow, cmd_id: int | None = None) -> Accepted:
        self._books.touch(vehicle)
        return Accepted(Topic.VEHICLES, vehicle.id, cmd_id=cmd_id)

    # -- what hoists have too -----------------------------------------------------------------------------------------

    def command(self, vehicle: VehicleNow, request: CommandVehicle) -> Reply:
        """Send a command without data. Stop does not change an AGV's mode; it is held, lest it drive on at once."""
        what = request.what
        if what not in PLAIN:
            return Refusal(
                "invalid",
                f"{vehicle.id} is an AGV: {what.value} is a hoist's command",
                f"AGVs take stop, alarm_clear and the agv_ commands; {AT_THE_AGV}",
                "command",
            )
        if refusal := self._orders.out_of_reach(vehicle, Simple(what)):
            return refusal
        if what is Plain.STATUS:  # it reports each second
            return self._accepted(vehicle)
        if what is Plain.ALARM_CLEAR and _run(vehicle) is not AgvRun.ERROR:
            return Refusal("not-now", f"{vehicle.id} reports no error to reset", "leave it as it is")
        intent = self._books.open_intent(vehicle, what.value, Simple(what), request.actor)
        if what in {Plain.STOP, Plain.STOP_BY_HOST}:
            self._recovery.hold(vehicle, f"stopped by {request.actor}", "release it when it may go on")
        return self._accepted(vehicle, intent.cmd_id)

    def display(self, vehicle: VehicleNow, request: DisplayOnVehicle) -> Reply:
        """ENIG has no display."""
        return Refusal(
            "invalid",
            f"{vehicle.id} is an AGV, and has no display: {request.text!r} is not shown",
            "send display to a hoist",
        )

    def move(self, vehicle: VehicleNow, request: MoveVehicle) -> Reply:
        """Send an AGV to a tag, under grants; it knows one kind of stop."""
        if request.action is not StopAction.STOP:
            reason = f"{vehicle.id} is an AGV: it has no stop {request.action.name.lower()}"
            return Refusal("invalid", reason, "leave action out, or send stop", "action")
        return self._orders.move(vehicle, request)

    # -- ENIG's own ---------------------------------------------------------------------------------------------------

    def direct(self, vehicle: VehicleNow, request: CommandAgv) -> Reply:
        """Send one of ENIG's commands, or say why not. Its outcome is the intent's: Status decides, or a person."""
        command = request.command
        if not vehicle.is_agv:
            return Refusal(
                "invalid", f"{vehicle.id} is a hoist: agv_ commands are for AGVs", "send it a hoist's", "command"
            )
        if refusal := self._orders.out_of_reach(vehicle, Direct(command)):
            return refusal
        if refusal := self._against(vehicle, command):
            return refusal
        if isinstance(command, AgvMoveAlias):
            return self._to_alias(vehicle, request, command)
        if isinstance(command, AgvMoveAuto):
            self._give_floor(vehicle, request)
        kind, body = named(command)
        intent = self._books.open_intent(vehicle, kind, Direct(command), request.actor, body=body)
        if command is DeviceAct.MARK_STOP and vehicle.mode is Mode.AUTO:
            self._recovery.hold(vehicle, f"stopped by {request.actor}", "release it when it may go on")
        return self._accepted(vehicle, intent.cmd_id)

    def _against(self, vehicle: VehicleNow, command: DeviceCommand) -> Refusal | None:
        """Return what in the AGV's state forbids a command (PROTOCOLS 5.3)."""
        running = _run(vehicle) is AgvRun.RUN
        match command:
            case DeviceAct.MARK_STOP:
                return None if running else Refusal("not-now", f"{vehicle.id} stands", "send it to an AGV that drives")
            case AgvLift(action=LiftAction.STOP) | AgvCharge(on=False):
                return None
            case AgvMoveManual():
                return self._not_in(vehicle, Mode.MANT) or self._in_error(vehicle)
            case AgvMoveAuto():
                return self._not_in(vehicle, Mode.AUTO) or self._busy(vehicle) or self._not_alone(vehicle)
            case AgvSetCurrent(tag=tag):
                return self._strange_tag(tag) or self._busy(vehicle)
            case AgvCharge():
                return self._not_in(vehicle, Mode.AUTO) or self._busy(vehicle) or self._no_charger(vehicle)
            case AgvMoveAlias():
                return self._not_in(vehicle, Mode.AUTO) or self._busy(vehicle)
            case AgvMove():
                return Refusal("invalid", "an AGV is sent to a tag by move", "send move with the barcode", "command")
            case AgvLift():
                return self._busy(vehicle)
            case DeviceAct():
                return Refusal("invalid", f"{command.value} is no AGV's command here", "send stop or alarm_clear")

    def _not_in(self, vehicle: VehicleNow, mode: Mode) -> Refusal | None:
        if vehicle.mode is mode:
            return None
        wanted, is_ = ("auto", "manual") if mode is Mode.AUTO else ("manual", "auto")
        return Refusal("not-now", f"{vehicle.id} is in {is_}", f"switch it to {wanted} at the AGV: {AT_THE_AGV}")

    def _in_error(self, vehicle: VehicleNow) -> Refusal | None:
        if _run(vehicle) is not AgvRun.ERROR:
            return None
        remedy = f"see what is wrong, then POST /api/v1/vehicles/{vehicle.id}/recover"
        return Refusal("not-now", f"{vehicle.id} is in error", remedy)

    def _busy(self, vehicle: VehicleNow) -> Refusal | None:
        if refusal := self._in_error(vehicle):
            return refusal
        if vehicle.job:
            return Refusal("conflict", f"{vehicle.id} is on job {vehicle.job}", "cancel the job, or let it end")
        if not vehicle.at_rest or vehicle.order or _run(vehicle) is AgvRun.RUN:
            return Refusal("conflict", f"{vehicle.id} does not stand still", "stop it, or wait")
        return None

    def _strange_tag(self, tag: Barcode) -> Refusal | None:
        if tag in self._books.track.floor:
            return None
        return Refusal("invalid", f"there is no tag {tag} on the floor of AGVs", "see GET /api/v1/layout", "tag")

    def _no_charger(self, vehicle: VehicleNow) -> Refusal | None:
        at = {charger.barcode: charger.id for charger in self._books.plant.chargers}
        if vehicle.barcode in at and vehicle.in_position:
            charger = self._devices.all[at[vehicle.barcode]]
            return (
                Refusal("not-now", f"{charger.id} is {charger.barred}", "lift that first") if charger.barred else None
            )
        reason = f"{vehicle.id} stands at no charger: told to charge, it would drive to one on a way of its own"
        return Refusal("not-now", reason, f"send move to one of {', '.join(sorted(at)) or 'none'} first")

    def _not_alone(self, vehicle: VehicleNow) -> Refusal | None:
        """MoveAuto follows the tape until it is stopped: no stretch can be granted for it but the whole floor."""
        books = self._books
        if vehicle.barcode is None:
            return Refusal("not-now", f"it is not known where {vehicle.id} is", "wait until it has reported")
        area = books.track.areas[books.track.area(vehicle.barcode)]
        held = {v for barcode in area for v in books.traffic.holders(barcode)} - {vehicle.id}
        others = sorted(held | set(self._motion.missing(vehicle)) - {vehicle.id})
        if not others:
            return None
        reason = f"MoveAuto follows the tape until it is stopped, and {', '.join(others)} may be on the same floor"
        return Refusal(
            "conflict", reason, "send move to a tag; or let the others be taken off the floor (verdict off_rail)"
        )

    def _give_floor(self, vehicle: VehicleNow, request: CommandAgv) -> None:
        """It may be anywhere until a person says that it stands (COMMANDS section 1: a person for manual moves)."""
        books = self._books
        if vehicle.barcode is not None:
            area = sorted(books.track.areas[books.track.area(vehicle.barcode)])
            books.traffic.hold(vehicle.id, (*area, *books.traffic.held(vehicle.id)))
            books.save_vehicle(vehicle, held=books.traffic.held(vehicle.id))
        why = f"{request.actor} lets it follow the tape"
        self._recovery.hold(vehicle, why, "stop it, then release it with verdict go_on where it stands", doubt=why)

    def _to_alias(self, vehicle: VehicleNow, request: CommandAgv, command: AgvMoveAlias) -> Reply:
        """MoveAlias hides its path: only onto track that is granted whole, and that is the AGV's own way."""
        books, goal = self._books, self._books.plant.aliases.get(command.alias)
        if goal is None:
            known = ", ".join(sorted(books.plant.aliases)) or "none"
            return Refusal("invalid", f"there is no alias {command.alias}", f"known are: {known}", "alias")
        if refusal := self._orders.unfit(vehicle) or standstill(books, vehicle):
            return refusal
        self._motion.drop(vehicle)
        here = vehicle.barcode
        try:
            path = tuple(books.router.route(here, goal)) if here is not None else ()
        except NoRoute as why:
            return Refusal("no-route", why.message, "see GET /api/v1/layout", "alias")
        if here is None or vehicle.toward or self._ways.sure(path) != len(path) - 1:
            reason = f"{vehicle.id} may choose another way to {command.alias} than the one that would be granted"
            return Refusal("conflict", reason, f"send move to {goal}: it leads there tag by tag", "alias")
        if obstacle := self._obstacle(vehicle, path):
            reason = f"the way to {command.alias} is not free: {obstacle}"
            return Refusal("conflict", reason, f"wait, or send move to {goal}: it goes as far as it may", "alias")
        vehicle.ahead += books.traffic.claim(vehicle.id, path[1:], goal_included=True).granted
        kind, body = named(command)
        intent = books.open_intent(vehicle, kind, Direct(command), request.actor, path=path, body=body)
        vehicle.errand = Errand(goal, StopAction.STOP, Purpose.PERSON)
        vehicle.drive = Drive(intent.cmd_id, elements(books.track, path, StopAction.STOP, vehicle.spec), intent)
        return self._accepted(vehicle, intent.cmd_id)

    def _obstacle(self, vehicle: VehicleNow, path: tuple[Barcode, ...]) -> str:
        """Return what keeps a path from being granted whole, as a clause; empty if nothing does."""
        passages, traffic = self._motion.passages, self._books.traffic
        if door := next(passages.shut_on(path), None):
            return f"{door.id} is {passages.against(door)}"
        blocked = next((b for at in path[1:] if (b := traffic.obstacle(vehicle.id, at))), None)
        return f"{blocked.at} ({blocked.by or blocked.note})" if blocked else ""

    # -- what became of it --------------------------------------------------------------------------------------------

    def unanswered(self, vehicle: VehicleNow, event: Unanswered) -> None:
        """What a manual move came to cannot be told by Status: a person decides."""
        command = event.command.command if isinstance(event.command, Direct) else None
        if isinstance(command, AgvMoveManual | AgvMoveAuto):
            reason = f"it is not known what became of {named(command)[0]}: {event.why.value}"
            self._recovery.hold(vehicle, reason, "look where it stands, then release it with verdict go_on")


def _run(vehicle: VehicleNow) -> AgvRun | None:
    agv = vehicle.status.condition.agv if vehicle.status else None
    return agv.run if agv else None


def named(command: DeviceCommand) -> tuple[str, Mapping[str, object]]:
    """Return a command's kind and what else it says, as its intent keeps them."""
    match command:
        case AgvMove(tag=tag) | AgvSetCurrent(tag=tag):
            return ("agv_move" if isinstance(command, AgvMove) else "agv_set_current"), {"tag": tag}
        case AgvMoveAlias(alias=alias):
            return "agv_move_alias", {"alias": alias}
        case AgvMoveManual(direction=way, speed=speed):
            return "agv_move_manual", {"direction": way.name.lower(), "speed": speed.name.lower()}
        case AgvMoveAuto(forward=forward, steering=steering, speed=speed):
            body = {"forward": forward, "steering": steering.name.lower(), "speed": speed.name.lower()}
            return "agv_move_auto", body
        case AgvLift(action=action):
            return "agv_lift", {"action": action.name.lower()}
        case AgvCharge(on=on):
            return "agv_charge", {"on": on}
        case DeviceAct():
            return f"agv_{command.value}", {}
