"""When in doubt: settle by STATUS, hold for a person, count the fleet after a restart (COMMANDS section 3)."""

from collections.abc import Iterable

from app.domain.devices import AgvStatus
from app.domain.ids import Actor
from app.domain.job import JobEvent
from app.domain.records import Hold, Intent, IntentState, Provenance
from app.domain.units import Barcode, Seconds
from app.domain.vehicle import Condition, Mode, Oper, VehicleStatus
from app.fleet.books import SYSTEM, Books
from app.fleet.halting import halt
from app.fleet.motion import Motion
from app.fleet.vehicle import HANDLINGS, Stage, VehicleNow

QUIESCE = Seconds(1.0)
"""Waited before the first STATUS that counts: longer than the longest delay of a link (our choice)."""
ALARM = "alarm"
"""How the reason of every hold begins that is for an alarm, or for a recovery from one that stopped."""
LOOK = "look where it stands, bring it to a barcode it reads, then release it with verdict go_on"


class Recovery:
    """Settles what is in doubt."""

    def __init__(self, books: Books, motion: Motion) -> None:
        self._books = books
        self._motion = motion

    # -- settlement ---------------------------------------------------------------------------------------------------

    def begin(self, vehicle: VehicleNow) -> None:
        """From now on the vehicle is asked, and nothing else is sent, until its answers settle it."""
        vehicle.stage = Stage.SETTLING
        vehicle.stage_since = self._books.now
        vehicle.quiet_until = Seconds(self._books.now + QUIESCE)
        vehicle.agreed = None
        self._books.touch(vehicle)

    def observe(self, vehicle: VehicleNow, status: VehicleStatus, asked_at: Seconds) -> bool:
        """Take a polled STATUS into the settlement. Returns whether the vehicle has become ready."""
        if vehicle.stage is not Stage.SETTLING or asked_at < vehicle.quiet_until:
            return False
        first, vehicle.agreed = vehicle.agreed, status
        vehicle.waiting = self.unrest(vehicle, status)
        if status.condition.oper is Oper.ALARM and not vehicle.recovery:
            self._alarm(vehicle, status)
        if not vehicle.waiting and first != status:
            self._books.effects.polls.append(vehicle.id)
        if vehicle.waiting or first != status:
            return False
        return self._settle(vehicle, status)

    def unrest(self, vehicle: VehicleNow, status: VehicleStatus) -> str:
        """Return why a vehicle that reports this is not at rest at a known place, empty if it is (COMMANDS 3.2)."""
        condition = status.condition
        checks = (
            (condition.oper is Oper.ALARM, f"is in ALARM {condition.code}"),
            (condition.oper in {Oper.RUN, Oper.PAUSE}, f"is in {condition.oper.name}"),
            (condition.travelling, "is driving"),
            (condition.doubt, condition.doubt),
            (not condition.servos_on, "has its servos off: send SERVO ON, SEARCH HOME, AUTO"),
            (not condition.home_known, "has not found its home position: send SEARCH HOME"),
            (not (condition.at_rest and condition.homed), "has an axis that is not at home"),
            (not condition.recognised, "reads no barcode: bring it to one by hand"),
            (status.barcode not in self._books.track, self._strange(status)),
        )
        return next((f"{vehicle.id} {words}" for applies, words in checks if applies), "")

    def _strange(self, status: VehicleStatus) -> str:
        return f"reports barcode {status.barcode}, which is not on the map (is its dialect right?)"

    def _alarm(self, vehicle: VehicleNow, status: VehicleStatus) -> None:
        alarm = f"{ALARM} {self._books.named_alarm(status.condition.code)}"
        if vehicle.handlings:
            vehicle.failed_handling = alarm
        if not vehicle.record.hold:
            remedy = f"clear the cause, then POST /api/v1/vehicles/{vehicle.id}/recover"
            self.hold(vehicle, alarm, remedy)
        vehicle.accounted = vehicle.accounted or self._plausible(vehicle, status)
        self._strike_off(vehicle)

    def _settle(self, vehicle: VehicleNow, status: VehicleStatus) -> bool:
        """Two STATUS agree, and the vehicle is at rest. Decide what was open; hold on a contradiction."""
        trusted, vehicle.trusted = vehicle.trusted, False
        if not trusted and (strange := self._strange_place(vehicle, status)):
            self.hold(vehicle, *strange)
            return False
        self._account(vehicle, status)
        if not trusted and (strange := self._strange_load(vehicle, status.condition)):
            self.hold(vehicle, *strange)
            return False
        if not trusted and vehicle.record.hold:
            return False
        self._close_moves(vehicle, status)
        if trusted:
            self._believe(vehicle, status.condition)
        vehicle.stage, vehicle.stage_since, vehicle.waiting = Stage.READY, self._books.now, ""
        return True

    def _plausible(self, vehicle: VehicleNow, status: VehicleStatus) -> bool:
        """Whether the vehicle can have come to this place on what it held."""
        held = self._books.traffic.held(vehicle.id)
        return not held or status.barcode in held or status.barcode == vehicle.barcode

    def _strange_place(self, vehicle: VehicleNow, status: VehicleStatus) -> tuple[str, str] | None:
        """Return reason and remedy if it cannot be where it reports to be (COMMANDS 3.4)."""
        record = vehicle.record
        if record.off_rail:
            return (
                f"it was said to be off the rail ({record.off_rail}), and reports from barcode {status.barcode}",
                "release it with verdict go_on if it stands on the rail again",
            )
        if vehicle.doubt:
            return vehicle.doubt, LOOK
        if misplaced := self._misplaced(vehicle, status):
            return misplaced, LOOK
        if not self._plausible(vehicle, status):
            return (
                (
                    f"it reports barcode {status.barcode}, which cannot be reached from the track it held"
                    f" ({', '.join(self._books.traffic.held(vehicle.id)) or 'none'})"
                ),
                "look where it stands; release it with verdict go_on if the barcode is right",
            )
        return None

    def _misplaced(self, vehicle: VehicleNow, status: VehicleStatus) -> str:
        """Return why its barcode does not fit its SEQ on the MOVE that is open, empty if it does (COMMANDS 3.3)."""
        moves = [i for i in vehicle.opened.values() if i.path]
        if status.seq == 0 or status.barcode in {vehicle.barcode, *(i.path[0] for i in moves)}:
            return ""
        at = {i.path[n] for i in moves if 0 <= (n := status.seq - _first_seq(i)) < len(i.path)}
        if not at or status.barcode in at:
            return ""
        return f"it reports barcode {status.barcode} at SEQ {status.seq}, where its path has {' or '.join(sorted(at))}"

    def _strange_load(self, vehicle: VehicleNow, condition: Condition) -> tuple[str, str] | None:
        """Return reason and remedy if its FOUP bit is not what no open PICKUP or PLACE can explain."""
        if handlings := vehicle.handlings:
            placing = any(intent.kind == "place" for intent in handlings)
            return self._strange_drop(vehicle, condition) if placing else None
        believed = self.believed_loaded(vehicle)
        if condition.loaded and not believed:
            return (
                f"it carries a {vehicle.burden} that no job or record accounts for",
                "see what it carries, PUT /api/v1/carriers/ID for it, then release the vehicle with verdict go_on",
            )
        if believed and not condition.loaded:
            return (
                f"it should carry {vehicle.record.carrier or f'a {vehicle.burden}'}, and its {vehicle.burden} bit is 0",
                "find the carrier, correct its place, then release the vehicle with verdict go_on (its job will fail)",
            )
        return None

    def _strange_drop(self, vehicle: VehicleNow, condition: Condition) -> tuple[str, str] | None:
        """A PLACE that ended in an alarm with F = 0: put down, or fallen? F cannot tell."""
        if condition.loaded or not vehicle.failed_handling:
            return None
        return (
            f"its PLACE ended in {vehicle.failed_handling}, and its {vehicle.burden} bit is 0",
            "see that the carrier stands where it should, then release the vehicle with verdict go_on",
        )

    def _believe(self, vehicle: VehicleNow, condition: Condition) -> None:
        """A person vouched for what the vehicle reports: its FOUP bit counts, our books follow."""
        if vehicle.handlings:
            return
        lost = vehicle.record.carrier if not condition.loaded else None
        aboard = vehicle.record.carrier if condition.loaded else None
        self._books.save_vehicle(vehicle, believed_loaded=condition.loaded, carrier=aboard)
        if lost:
            self._books.put_carrier(lost, None, Provenance.PERSON)

    def believed_loaded(self, vehicle: VehicleNow) -> bool:
        """Whether by our books a FOUP is aboard."""
        return bool(vehicle.record.believed_loaded)

    def _account(self, vehicle: VehicleNow, status: VehicleStatus) -> None:
        """Its place is known: it holds what it covers there (in MANT, all it can reach by itself)."""
        clashes = self._motion.place(vehicle, status.barcode)
        if not status.condition.at_tag:
            vehicle.stopped = None
        if status.condition.mode is not Mode.AUTO:
            self.widen(vehicle)
        self._stop_who_drives_there(vehicle, status.barcode, clashes)
        vehicle.accounted = True
        self._strike_off(vehicle)

    def _stop_who_drives_there(self, vehicle: VehicleNow, barcode: Barcode, clashes: Iterable[Barcode]) -> None:
        """It was put on track that another has been granted: who is on the way there is stopped and held."""
        books = self._books
        for at in clashes:
            for other in (books.vehicles[name] for name in sorted(books.traffic.holders(at) - {vehicle.id})):
                if other.drive and other.linked and not other.drive.recalled:
                    why = f"{vehicle.id} reports from {barcode}, on track that {other.id} has been granted ({at})"
                    halt(books, other, SYSTEM, why)
                    if not other.record.hold:
                        self.hold(other, why, "see that its way is free, then release it")

    def widen(self, vehicle: VehicleNow) -> None:
        """Out of AUTO it can be moved without us: hold what it can reach, both ways, as far as nobody else has it."""
        books = self._books
        if vehicle.barcode is None:
            return
        reach = books.track.reach(vehicle.barcode, vehicle.spec.reach)
        free = sorted(b for b in reach if not books.traffic.holders(b))
        held = (*free, *books.traffic.held(vehicle.id))
        books.traffic.hold(vehicle.id, held)
        books.save_vehicle(vehicle, barcode=vehicle.barcode, held=held)

    def moved_by_hand(self, vehicle: VehicleNow, barcode: Barcode) -> None:
        """Out of AUTO it reads another barcode: believed as far as it could be moved there from where it was."""
        if barcode not in self._books.traffic.held(vehicle.id):
            came = f"{vehicle.id} reports barcode {barcode}, which it could not be moved to from {vehicle.barcode}"
            self.doubt(vehicle, barcode, came)
            self._stop_by_hand(vehicle)
            self._stop_who_drives_there(vehicle, barcode, self._books.track.covered(barcode, vehicle.spec.length))
            return
        self._stop_who_drives_there(vehicle, barcode, self._motion.place(vehicle, barcode))
        self.widen(vehicle)

    def _stop_by_hand(self, vehicle: VehicleNow) -> None:
        """An AGV that still drives on our MoveManual, off what it holds, might meet another: it is stopped (our choice)."""
        running = vehicle.status is not None and vehicle.status.condition.oper is Oper.RUN
        if vehicle.is_agv and running:
            halt(self._books, vehicle, SYSTEM, "it drives where it may not")

    def doubt(self, vehicle: VehicleNow, barcode: Barcode, why: str) -> None:
        """Its place is not believed: it holds what it held and where it says to be, until a person vouches for the place."""
        self.claim_too(vehicle, barcode)
        self.hold(vehicle, why, LOOK, doubt=why)
        if vehicle.stage is Stage.READY:
            self.begin(vehicle)

    def doubt_backup(self, vehicle: VehicleNow) -> None:
        """Our books are a restored backup: nothing they say of this vehicle is believed (COMMANDS 3.8)."""
        why = "the database is a restored backup, and may have missed where it went and what it carries"
        remedy = "compare its place, load and job with the plant, correct them, then release it with verdict go_on"
        self.hold(vehicle, why, remedy, doubt=why)

    def claim_too(self, vehicle: VehicleNow, barcode: Barcode) -> None:
        """It may be there, besides all that it holds."""
        books = self._books
        if barcode in books.track:
            books.traffic.hold(vehicle.id, books.track.covered(barcode, vehicle.spec.length))
            books.save_vehicle(vehicle, held=books.traffic.held(vehicle.id))

    def _strike_off(self, vehicle: VehicleNow) -> None:
        """The roll-call no longer waits for it, once its place is known."""
        if vehicle.accounted and vehicle.id in self._books.roll_call:
            freed = self._books.roll_call.strike_off(vehicle.id)
            self._books.show_controller()
            if freed:
                self._wake_all_in(frozenset(freed))

    def _wake_all_in(self, areas: frozenset[int]) -> None:
        track = self._books.track
        for other in self._books.vehicles.values():
            if other.barcode is not None and track.area(other.barcode) in areas:
                self._books.wake(other.id)

    def strike_off(self, vehicle: VehicleNow) -> None:
        """A named person has said where it is."""
        vehicle.accounted = True
        self._strike_off(vehicle)

    def _close_moves(self, vehicle: VehicleNow, status: VehicleStatus) -> None:
        """Every open command but PICKUP and PLACE is settled by what the vehicle says."""
        if vehicle.drive:
            at_end = status.barcode == vehicle.drive.end.barcode
            state = IntentState.SETTLED_DONE if at_end else IntentState.SETTLED_NOT_DONE
            self._motion.finish(vehicle, state, f"by STATUS at {status.barcode}")
        for intent in list(vehicle.opened.values()):
            if intent.kind in HANDLINGS:
                continue
            done = self._shows(intent, status)
            state = IntentState.SETTLED_DONE if done else IntentState.SETTLED_NOT_DONE
            self._books.close_intent(vehicle, intent.cmd_id, state, f"by STATUS: {self._said(status)}")

    def _said(self, status: VehicleStatus) -> str:
        condition = status.condition
        return f"{condition.mode.name}, {condition.oper.name}, barcode {status.barcode}, F = {int(condition.loaded)}"

    def _shows(self, intent: Intent, status: VehicleStatus) -> bool:
        """Whether the effect of a command is visible in a STATUS."""
        condition = status.condition
        if intent.kind in {"move", "xmove"}:
            return bool(intent.path) and intent.path[-1] == status.barcode
        visible = {
            "servo_on": condition.servos_on,
            "servo_off": not condition.servos_on,
            "search_home": condition.home_known and condition.homed,
            "go_home": condition.homed,
            "alarm_clear": condition.oper is not Oper.ALARM,
            "auto": condition.mode is Mode.AUTO,
            "stop": condition.mode is Mode.MANT or (condition.agv is not None and not condition.travelling),
            "stop_by_host": not condition.travelling,
        }
        return visible.get(intent.kind, False) or (condition.agv is not None and _agv_shows(intent, condition.agv))

    # -- holds --------------------------------------------------------------------------------------------------------

    def hold(self, vehicle: VehicleNow, reason: str, remedy: str, doubt: str = "") -> None:
        """Nothing is sent to the vehicle any more until a named person decides; a doubt stays until then."""
        if vehicle.record.hold and vehicle.record.hold.reason == reason:
            return
        self._books.save_vehicle(vehicle, hold=Hold(reason, remedy, self._books.utc, doubt or vehicle.doubt))
        self._books.event(
            JobEvent.VEHICLE_HELD, job=self._books.job_of(vehicle), vehicle=vehicle.id, detail=f"{reason}; {remedy}"
        )

    def release(self, vehicle: VehicleNow, actor: Actor, reason: str) -> None:
        """A person has decided: what the vehicle says next is believed."""
        self._books.save_vehicle(vehicle, hold=None, off_rail="")
        self._books.event(JobEvent.VEHICLE_RELEASED, vehicle=vehicle.id, detail=f"{actor}: {reason}")
        vehicle.trusted = True
        if vehicle.linked:
            self.begin(vehicle)

    def link_lost(self, vehicle: VehicleNow, reason: str) -> None:
        """The vehicle is silent. What it holds, it holds (COMMANDS 3.1)."""
        vehicle.linked, vehicle.link_reason, vehicle.link_since = False, reason, self._books.now
        vehicle.stage, vehicle.stage_since = Stage.ABSENT, self._books.now
        vehicle.agreed, vehicle.trusted, vehicle.waiting = None, False, ""
        self._books.touch(vehicle)

    def unreachable(self, vehicle: VehicleNow, reason: str) -> None:
        """An attempt to reach the vehicle has failed: one that was not heard of since the start is silent for that reason."""
        if vehicle.seen is None and not vehicle.linked and vehicle.link_reason != reason:
            vehicle.link_reason = reason
            self._books.touch(vehicle)


def _agv_shows(intent: Intent, agv: AgvStatus) -> bool:
    """Whether the effect of one of ENIG's own commands is visible in a Status; that of a manual move never is."""
    shown: dict[str, dict[str, object]] = {
        "agv_set_current": {"tag": agv.tag},
        "agv_lift": {"action": agv.lift.name.lower()},
        "agv_charge": {"on": agv.charging},
    }
    wanted = shown.get(intent.kind)
    reached = intent.kind == "agv_move_alias" and agv.arrived and intent.path[-1:] == (agv.tag,)
    return reached or (wanted is not None and wanted.items() <= dict(intent.body).items())


def _first_seq(intent: Intent) -> int:
    """SEQ of the first element of a MOVE or XMOVE."""
    first = intent.body.get("first_seq", 0)
    return first if isinstance(first, int) else 0
