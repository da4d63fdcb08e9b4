"""Requests about one vehicle: commands, moves, one-shots, and what named persons decide about it."""

from dataclasses import replace

from app.domain.commands import Command, Display, Plain, Simple
from app.domain.errors import NoRoute, Refusal
from app.domain.job import JobEvent
from app.domain.layout import Station, StopAction
from app.domain.records import HELD_BY, STOPPED_BY, Lockout
from app.domain.requests import (
    Accepted,
    CommandVehicle,
    DisplayOnVehicle,
    HandleOnce,
    HoldVehicle,
    LockVehicle,
    MoveVehicle,
    RecoverAlarm,
    ReleaseVehicle,
    Reply,
    SetService,
    UnlockVehicle,
    Verdict,
)
from app.domain.vehicle import Mode, Oper
from app.domain.view import Topic
from app.fleet.alarms import Alarms
from app.fleet.books import Books
from app.fleet.halting import halt
from app.fleet.harmless import harmless
from app.fleet.kinds import no_servant
from app.fleet.missions import Missions
from app.fleet.motion import Motion
from app.fleet.obstacles import against_putting_down
from app.fleet.recovery import Recovery
from app.fleet.refusals import in_emergency, no_link, no_station, not_lifted, standstill
from app.fleet.rollcall import named
from app.fleet.targets import target_for
from app.fleet.vehicle import Errand, HandleOrder, Purpose, Stage, VehicleNow

MANT_ONLY = frozenset(
    {
        Plain.SERVO_ON,
        Plain.SERVO_OFF,
        Plain.SEARCH_HOME,
        Plain.GO_HOME,
        Plain.SYSTEM_RESET,
        Plain.ALARM_CLEAR,
        Plain.AUTO,
        Plain.PORT_DEST_TEACHING,
        Plain.PORT_OFFSET_TEACHING,
    }
)


class VehicleOrders:
    """Answers requests about one vehicle."""

    def __init__(self, books: Books, motion: Motion, missions: Missions, recovery: Recovery, alarms: Alarms) -> None:
        self._books = books
        self._motion = motion
        self._missions = missions
        self._recovery = recovery
        self._alarms = alarms

    def _accepted(self, vehicle: VehicleNow, cmd_id: int | None = None) -> Accepted:
        self._books.touch(vehicle)
        return Accepted(Topic.VEHICLES, vehicle.id, cmd_id=cmd_id)

    # -- commands -----------------------------------------------------------------------------------------------------

    def command(self, vehicle: VehicleNow, request: CommandVehicle) -> Reply:
        """Send a command without data. Its outcome is the intent's."""
        if refusal := self.unready(vehicle, request.what):
            return refusal
        if request.what is Plain.STATUS:
            self._books.effects.polls.append(vehicle.id)
            return self._accepted(vehicle)
        intent = self._books.open_intent(vehicle, request.what.value, Simple(request.what), request.actor)
        if request.what is Plain.STOP_BY_HOST:
            self._recovery.hold(vehicle, f"{STOPPED_BY}{request.actor}", "release it when it may go on")
        return self._accepted(vehicle, intent.cmd_id)

    def unready(self, vehicle: VehicleNow, what: Plain) -> Refusal | None:
        """Return why a command cannot be sent now, with what would help."""
        if refusal := self.out_of_reach(vehicle, Simple(what)):
            return refusal
        mode = vehicle.mode
        if what in MANT_ONLY and mode is not Mode.MANT:
            return Refusal(
                "not-now",
                f"{vehicle.id} is in {mode.name if mode is not None else 'no mode'}, and {what.value} needs MANT",
                "send stop first: it brings the vehicle to MANT",
            )
        if what is Plain.STOP_BY_HOST and mode not in {Mode.AUTO, Mode.SEMI}:
            return Refusal("not-now", f"{vehicle.id} is in MANT: stop_by_host needs AUTO or SEMI", "send stop")
        return None

    def out_of_reach(self, vehicle: VehicleNow, command: Command) -> Refusal | None:
        """Return why a person's command cannot go to a vehicle now, whatever its mode is."""
        passes = harmless(command)
        if refusal := None if passes else self._at_work(vehicle) or in_emergency(self._books):
            return refusal
        if not vehicle.linked or vehicle.status is None:
            return no_link(vehicle)
        if vehicle.recovery and not passes:
            return Refusal("not-now", f"an alarm recovery of {vehicle.id} is under way", "wait for its end")
        return None

    def _at_work(self, vehicle: VehicleNow) -> Refusal | None:
        """Refusal of what may set a vehicle moving while people are at it, or where it is."""
        if refusal := self._locked_out(vehicle):
            return refusal
        closed = self._books.closures.barring(vehicle)
        return Refusal("not-now", f"{vehicle.id} stands where {closed}", "open that first") if closed else None

    def _locked_out(self, vehicle: VehicleNow) -> Refusal | None:
        lock = vehicle.record.lockout
        return Refusal("not-now", f"{vehicle.id} is {lock}", "lift the lockout first") if lock else None

    def display(self, vehicle: VehicleNow, request: DisplayOnVehicle) -> Reply:
        """Show a text on the vehicle."""
        if refusal := self.unready(vehicle, Plain.STOP_BY_HOST):
            return replace(
                refusal, reason=refusal.reason.replace("stop_by_host", "display"), remedy="switch it to AUTO"
            )
        if refusal := self._locked_out(vehicle):
            return refusal
        command = Display(request.text, request.alarm)
        body = {"text": request.text, "alarm": request.alarm}
        return self._accepted(
            vehicle, self._books.open_intent(vehicle, "display", command, request.actor, body=body).cmd_id
        )

    def unfit(self, vehicle: VehicleNow) -> Refusal | None:
        """Return why a vehicle cannot be moved or made to handle for a person now."""
        if vehicle.barred:
            return Refusal("not-now", f"{vehicle.id} is {vehicle.barred}", "lift that first")
        if refusal := self._at_work(vehicle):
            return refusal
        if not vehicle.linked:
            return no_link(vehicle)
        if vehicle.job:
            return Refusal("conflict", f"{vehicle.id} is on job {vehicle.job}", "cancel the job, or let it end")
        if vehicle.mode is not Mode.AUTO:
            remedy = (
                "switch it to auto at the AGV"
                if vehicle.is_agv
                else "send servo_on, search_home and auto, or recover it"
            )
            return Refusal("not-now", f"{vehicle.id} is not in AUTO", remedy)
        if vehicle.oper is Oper.ALARM:
            return Refusal("not-now", f"{vehicle.id} has an alarm", f"POST /api/v1/vehicles/{vehicle.id}/recover")
        if vehicle.stage is not Stage.READY or vehicle.recovery:
            return Refusal(
                "not-now", vehicle.waiting or f"{vehicle.id} is being asked where it is", "try again shortly"
            )
        if vehicle.handling or vehicle.order:
            return Refusal("conflict", f"{vehicle.id} is handling a carrier", "wait for its end")
        if missing := self._motion.missing(vehicle):
            return Refusal(
                "not-now",
                f"the roll-call still misses {named(missing)}",
                "connect them, or POST /api/v1/vehicles/ID/release with verdict off_rail or stands_at; "
                "with go_on for one that is connected and on hold",
            )
        return None

    def move(self, vehicle: VehicleNow, request: MoveVehicle) -> Reply:
        """Send a vehicle to a barcode, under grants."""
        if request.barcode not in self._books.track:
            return Refusal("invalid", f"there is no barcode {request.barcode}", "see GET /api/v1/layout", "barcode")
        if request.action is StopAction.RUN:
            return Refusal("invalid", "a path ends in a stop", "leave action out, or name a stop", "action")
        if refusal := self.unfit(vehicle):
            return refusal
        try:
            self._motion.send(vehicle, Errand(request.barcode, request.action, Purpose.PERSON))
        except NoRoute as why:
            shut = "end what closes it: kept_off in GET /api/v1/controller lists it"
            remedy = "see GET /api/v1/layout" if why.closed is None else shut
            return Refusal("no-route", self._books.closed.explain(why), remedy, "barcode")
        return self._accepted(vehicle)

    def handle(self, vehicle: VehicleNow, request: HandleOnce) -> Reply:
        """One PICKUP or PLACE where the vehicle stands."""
        station = self._books.specs.get(request.station)
        if station is None:
            return replace(no_station(request.station), code="invalid", field="station")
        if refusal := self.unfit(vehicle):
            return refusal
        if refusal := no_servant(vehicle, station) or self._misplaced(vehicle, station):
            return refusal
        target = target_for(self._books, vehicle, station, request.target)
        if isinstance(target, Refusal):
            return target
        if vehicle.loaded is request.pickup:
            what, instead = ("loaded", "place") if vehicle.loaded else ("empty", "pickup")
            return Refusal("not-now", f"{vehicle.id} is {what}", f"it can only {instead} now")
        obstacle = self._books.closures.against(station) or self._books.buffer_trouble.get(station.id, "")
        if not request.pickup:
            obstacle = against_putting_down(self._books, station.id, None)
        if obstacle:
            return Refusal("conflict", obstacle, f"if it is not so, PUT /api/v1/stations/{station.id}", "station")
        vehicle.order = HandleOrder(station.id, request.pickup, request.actor, request.target)
        self._motion.drop(vehicle)
        self._missions.proceed(vehicle)
        return self._accepted(vehicle, vehicle.handling.cmd_id if vehicle.handling else None)

    def _misplaced(self, vehicle: VehicleNow, station: Station) -> Refusal | None:
        """Return why the vehicle cannot handle at this station from where it is."""
        if refusal := standstill(self._books, vehicle):
            return refusal
        tagged = vehicle.status is not None and vehicle.status.condition.at_tag
        if vehicle.barcode != station.barcode or not vehicle.at_rest or not tagged:
            return Refusal(
                "not-now",
                f"{vehicle.id} is not stopped at {station.id} (barcode {station.barcode}) but at {vehicle.barcode}",
                f"send move to {station.barcode} with action {station.kind.stop_action.name.lower()} first",
            )
        return None

    # -- decisions of people ------------------------------------------------------------------------------------------

    def recover(self, vehicle: VehicleNow, request: RecoverAlarm) -> Reply:
        """Start the alarm recovery of PROTOCOLS 6.2."""
        if refusal := self._at_work(vehicle) or in_emergency(self._books):
            return refusal
        if not vehicle.linked or vehicle.status is None:
            return no_link(vehicle)
        if vehicle.recovery:
            return self._accepted(vehicle)
        if not self._alarms.has_work(vehicle, vehicle.status):
            held = f"POST /api/v1/vehicles/{vehicle.id}/release" if vehicle.record.hold else "nothing needs to be done"
            return Refusal("not-now", f"{vehicle.id} is in AUTO, homed and without an alarm", held)
        unsafe = self._alarms.unsafe_to_home(vehicle.status)
        if unsafe and not request.confirmed:
            return Refusal(
                "not-now",
                f"homing {vehicle.id} now could drop a carrier: {unsafe}",
                'let a person look at the vehicle, then send {"confirmed": true}',
                "confirmed",
            )
        self._alarms.start(vehicle, request.actor, confirmed=request.confirmed)
        return self._accepted(vehicle)

    def hold(self, vehicle: VehicleNow, request: HoldVehicle) -> Reply:
        """Nothing more is sent to the vehicle until released; what it was told, it finishes."""
        self._recovery.hold(vehicle, f"{HELD_BY}{request.actor}: {request.reason}", "release it when it may go on")
        return self._accepted(vehicle)

    def release(self, vehicle: VehicleNow, request: ReleaseVehicle) -> Reply:
        """A named person decides about a held or absent vehicle."""
        decide = {
            Verdict.GO_ON: self._go_on,
            Verdict.OFF_RAIL: self._off_rail,
            Verdict.STANDS_AT: self._stands_at,
        }[request.verdict]
        return decide(vehicle, request) or self._accepted(vehicle)

    def _go_on(self, vehicle: VehicleNow, request: ReleaseVehicle) -> Refusal | None:
        if vehicle.oper is Oper.ALARM:
            return Refusal(
                "not-now", f"{vehicle.id} still has an alarm", f"POST /api/v1/vehicles/{vehicle.id}/recover", "verdict"
            )
        if not vehicle.record.hold and not vehicle.record.off_rail:
            return Refusal("conflict", f"{vehicle.id} is not on hold", "nothing to release", "verdict")
        self._recovery.release(vehicle, request.actor, request.reason)
        return None

    def _off_rail(self, vehicle: VehicleNow, request: ReleaseVehicle) -> Refusal | None:
        if vehicle.linked:
            return Refusal(
                "conflict",
                f"{vehicle.id} is connected and reports",
                "switch it off and take it off the rail first",
                "verdict",
            )
        self._missions.abandon(vehicle, f"{vehicle.id} was taken off the rail")
        self._motion.vacate(vehicle)
        self._books.save_vehicle(
            vehicle, off_rail=f"said by {request.actor}: {request.reason}", hold=None, barcode=None, held=()
        )
        self._books.event(JobEvent.VEHICLE_REMOVED, vehicle=vehicle.id, detail=f"{request.actor}: {request.reason}")
        self._recovery.strike_off(vehicle)
        return None

    def _stands_at(self, vehicle: VehicleNow, request: ReleaseVehicle) -> Refusal | None:
        if request.barcode is None or request.barcode not in self._books.track:
            return Refusal("invalid", f"there is no barcode {request.barcode}", "see GET /api/v1/layout", "barcode")
        if vehicle.linked:
            return Refusal(
                "conflict", f"{vehicle.id} is connected and reports its place itself", "use go_on", "verdict"
            )
        vehicle.drive = None
        self._motion.place(vehicle, request.barcode)
        self._books.event(
            JobEvent.VEHICLE_RELEASED,
            vehicle=vehicle.id,
            detail=f"{request.actor}: stands at {request.barcode}: {request.reason}",
        )
        self._recovery.strike_off(vehicle)
        return None

    def service(self, vehicle: VehicleNow, request: SetService) -> Reply:
        """Out of service with a reason, or back."""
        if request.reason:
            self._missions.give_back(vehicle, f"{vehicle.id} was taken out of service")
        self._books.save_vehicle(vehicle, out_of_service=request.reason)
        self._books.event(
            JobEvent.VEHICLE_REMOVED if request.reason else JobEvent.VEHICLE_INSTALLED,
            vehicle=vehicle.id,
            detail=f"{request.actor}: {request.reason}" if request.reason else f"{request.actor}: in service",
        )
        self._books.wake(vehicle.id)
        return self._accepted(vehicle)

    def lock(self, vehicle: VehicleNow, request: LockVehicle) -> Reply:
        """Maintenance lockout: nothing is granted, and nothing sent but what reads or stops.

        A driving vehicle is stopped where it is: a person may be about to step to it. A handling ends: an open gripper
        over a port is no safer.
        """
        if vehicle.record.lockout:
            owner = vehicle.record.lockout.owner
            return Refusal("conflict", f"{vehicle.id} is locked out by {owner} already", f"ask {owner}")
        self._missions.give_back(vehicle, f"{vehicle.id} is locked out by {request.actor}")
        self._alarms.break_off(vehicle, f"locked out by {request.actor}")
        self._books.save_vehicle(vehicle, lockout=Lockout(request.actor, request.reason, self._books.utc))
        why = f"locked out: {request.reason}"
        stop = halt(self._books, vehicle, request.actor, why) if vehicle.moves else None
        return self._accepted(vehicle, stop.cmd_id if stop else None)

    def unlock(self, vehicle: VehicleNow, request: UnlockVehicle) -> Reply:
        """Lifted by its owner, or by two others together."""
        lock = vehicle.record.lockout
        if lock is None:
            return Refusal("conflict", f"{vehicle.id} is not locked out", "nothing to lift")
        wished = lock.wished_away_by(request.actor)
        if not wished.lifted_by(request.actor):
            self._books.save_vehicle(vehicle, lockout=wished)
            return not_lifted(lock)
        self._books.save_vehicle(vehicle, lockout=None)
        if vehicle.linked:
            self._recovery.begin(vehicle)
        return self._accepted(vehicle)
