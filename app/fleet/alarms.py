"""Alarm recovery as one command (PROTOCOLS 6.2): what it may do, what it sends, and how it ends."""

from app.domain.commands import Plain, Simple
from app.domain.events import Answered, Unknown
from app.domain.ids import Actor, CmdId
from app.domain.job import JobEvent
from app.domain.units import Seconds
from app.domain.vehicle import Mode, Oper, VehicleStatus
from app.fleet.books import Books
from app.fleet.recovery import ALARM, LOOK, Recovery
from app.fleet.vehicle import AlarmRecovery, Stage, VehicleNow

STOPPED = f"{ALARM} recovery stopped"
PATIENCE = Seconds(60.0)
"""After so long without the STATUS it needs, an alarm recovery gives up (our choice)."""


class Alarms:
    """Recovers vehicles from alarms, and from whatever else keeps them out of AUTO."""

    def __init__(self, books: Books, recovery: Recovery) -> None:
        self._books = books
        self._recovery = recovery

    def unsafe_to_home(self, status: VehicleStatus) -> str:
        """Return which axis forbids homing without a person at the vehicle, empty if none does. An AGV is not homed."""
        if status.condition.agv is not None:
            return ""
        safe = {"lift": {1}, "slid": {1}, "shft": {1}, "grip": {3}}
        values = {name: (value, meaning) for name, value, meaning in status.condition.details}
        bad = [f"{axis.upper()} {values[axis][1]}" for axis, good in safe.items() if values[axis][0] not in good]
        return ", ".join(bad)

    def has_work(self, vehicle: VehicleNow, status: VehicleStatus) -> bool:
        """Whether there is anything to recover a vehicle from: an alarm, what keeps it out of AUTO, or a hold for either."""
        return self._next_command(status) is not None or _is_ours(vehicle)

    def start(self, vehicle: VehicleNow, actor: Actor, *, confirmed: bool) -> None:
        """Begin the sequence: STOP, ALARM CLEAR, SERVO ON, SEARCH HOME or GO HOME, AUTO, each where needed."""
        vehicle.recovery = AlarmRecovery(actor, confirmed, self._books.now)
        vehicle.stage = Stage.SETTLING
        self._books.effects.polls.append(vehicle.id)
        self._books.touch(vehicle)

    def step(self, vehicle: VehicleNow, status: VehicleStatus, asked_at: Seconds) -> None:
        """With a fresh STATUS, send the next command of the sequence, or end it."""
        recovery = vehicle.recovery
        if recovery is None or recovery.waiting is not None or asked_at < recovery.since:
            return
        if status.condition.oper is Oper.RUN:
            return
        what = self._next_command(status)
        if what is None:
            self._end(vehicle, "")
            return
        if what is recovery.done:
            return
        unsafe = "" if recovery.confirmed else self.unsafe_to_home(status)
        if what in {Plain.SEARCH_HOME, Plain.GO_HOME} and unsafe:
            self._end(vehicle, f"not homed, because {unsafe}; let a person look, and confirm")
            return
        recovery.since = self._books.now
        recovery.waiting = self._books.open_intent(vehicle, what.value, Simple(what), recovery.actor).cmd_id

    def _next_command(self, status: VehicleStatus) -> Plain | None:
        condition = status.condition
        if condition.agv is not None:  # Reset is all that ENIG has; the mode is changed at the AGV alone (E21)
            return Plain.ALARM_CLEAR if condition.oper is Oper.ALARM else None
        if condition.mode is Mode.AUTO:
            fine = condition.servos_on and condition.home_known and condition.all_home
            return None if fine and condition.oper is not Oper.ALARM else Plain.STOP
        if condition.mode is not Mode.MANT:
            return Plain.STOP
        needed = (
            (condition.oper is Oper.ALARM, Plain.ALARM_CLEAR),
            (not condition.servos_on, Plain.SERVO_ON),
            (not condition.home_known, Plain.SEARCH_HOME),
            (not condition.all_home, Plain.GO_HOME),
        )
        return next((what for applies, what in needed if applies), Plain.AUTO)

    def answered(self, vehicle: VehicleNow, answer: Answered) -> None:
        """A command of the sequence was answered."""
        recovery = vehicle.recovery
        if recovery is None or recovery.waiting != answer.cmd_id:
            return
        recovery.waiting, recovery.since = None, self._books.now
        if not answer.ok:
            what = answer.command.what.value if isinstance(answer.command, Simple) else "the command"
            self._end(vehicle, f"{what} ended abnormally ({answer.reason or 'no reason given'})")
            return
        recovery.done = answer.command.what if isinstance(answer.command, Simple) else None
        self._books.effects.polls.append(vehicle.id)

    def unanswered(self, vehicle: VehicleNow, cmd_id: CmdId, why: Unknown | str) -> None:
        """A command of the sequence got no answer, or was not sent."""
        if vehicle.recovery and vehicle.recovery.waiting == cmd_id:
            self._end(vehicle, str(why))

    def tick(self, vehicle: VehicleNow) -> None:
        """Give an alarm recovery up that hears nothing."""
        recovery = vehicle.recovery
        if recovery and recovery.waiting is None and self._books.now > recovery.since + PATIENCE:
            self._end(vehicle, f"nothing came of it for {PATIENCE:.0f} s")

    def _end(self, vehicle: VehicleNow, failure: str) -> None:
        recovery, vehicle.recovery = vehicle.recovery, None
        if recovery is None:
            return
        if failure:
            self._stop(vehicle, failure, f"mend the cause, then POST /api/v1/vehicles/{vehicle.id}/recover again")
            self._recovery.begin(vehicle)
            return
        if vehicle.doubt:
            self._recovery.hold(vehicle, vehicle.doubt, LOOK)
        elif _is_ours(vehicle):
            self._books.save_vehicle(vehicle, hold=None)
            self._books.event(
                JobEvent.VEHICLE_RELEASED, vehicle=vehicle.id, detail=f"{recovery.actor}: alarm recovered"
            )
        self._recovery.begin(vehicle)

    def _stop(self, vehicle: VehicleNow, failure: str, remedy: str) -> None:
        """Hold the vehicle for a failure; a hold for another reason stays, and is named first."""
        hold = vehicle.record.hold
        other = "" if hold is None or _is_ours(vehicle) else f"{hold.reason.partition(f'; {STOPPED}')[0]}; "
        self._recovery.hold(vehicle, f"{other}{STOPPED}: {failure}", remedy)

    def break_off(self, vehicle: VehicleNow, why: str) -> None:
        """People have come to the vehicle, or an emergency: nothing more of the sequence is sent."""
        if vehicle.recovery:
            self._end(vehicle, why)

    def link_lost(self, vehicle: VehicleNow) -> None:
        """The sequence does not go on by itself once the vehicle is back."""
        if vehicle.recovery:
            vehicle.recovery = None
            self._stop(
                vehicle, "the link was lost", f"POST /api/v1/vehicles/{vehicle.id}/recover again once it is back"
            )

    def note_failure(self, vehicle: VehicleNow, answer: Answered) -> None:
        """Remember why a handling ended abnormally, if an alarm says so (I46)."""
        if answer.condition.oper is Oper.ALARM:
            vehicle.failed_handling = f"alarm {self._books.named_alarm(answer.condition.code)}"


def _is_ours(vehicle: VehicleNow) -> bool:
    """Whether a vehicle is on hold for an alarm: only that is lifted by its recovery, all else by a named person."""
    return vehicle.record.hold is not None and vehicle.record.hold.reason.startswith(ALARM)
