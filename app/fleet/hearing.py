"""What sessions tell of vehicles, and what it means for the command under way, the place, the job."""

from app.domain.alarms import AlarmKind
from app.domain.commands import Move, Send
from app.domain.events import (
    Acknowledged,
    Answered,
    Event,
    Garbled,
    LinkDown,
    LinkUp,
    NotSent,
    Reported,
    Taught,
    Unanswered,
    Unknown,
)
from app.domain.job import JobEvent
from app.domain.records import IntentState
from app.domain.vehicle import Mode, Oper, VehicleStatus
from app.fleet.agv_orders import AgvOrders
from app.fleet.alarms import Alarms
from app.fleet.books import Books
from app.fleet.missions import MAX_MISSES, Missions
from app.fleet.motion import Motion, OffPath
from app.fleet.objections import barrier
from app.fleet.recovery import Recovery
from app.fleet.teaching import Teaching
from app.fleet.vehicle import Stage, VehicleNow


class Hearing:
    """Takes the events of vehicles' sessions, and passes on to who decides."""

    def __init__(
        self,
        books: Books,
        motion: Motion,
        missions: Missions,
        recovery: Recovery,
        alarms: Alarms,
        agv_orders: AgvOrders,
        teaching: Teaching,
    ) -> None:
        self._books = books
        self._motion = motion
        self._missions = missions
        self._recovery = recovery
        self._alarms = alarms
        self._agv_orders = agv_orders
        self._teaching = teaching

    def take(self, vehicle: VehicleNow, event: Event) -> None:
        """Take one event of a session."""
        match event:
            case Reported():  # nearly all
                self._reported(vehicle, event)
            case LinkUp():
                self._link_up(vehicle)
            case LinkDown(reason=reason):
                self._alarms.link_lost(vehicle)
                self._teaching.lost(vehicle, reason)
                self._recovery.link_lost(vehicle, reason)
            case Acknowledged():
                self._acknowledged(vehicle, event)
            case Answered():
                self._answered(vehicle, event)
            case Unanswered():
                self._unanswered(vehicle, event)
            case NotSent():
                self._not_sent(vehicle, event)
            case Taught():
                self._teaching.take(vehicle, event)
            case Garbled():
                self._books.touch(vehicle)

    def _link_up(self, vehicle: VehicleNow) -> None:
        vehicle.linked, vehicle.link_reason, vehicle.link_since = True, "", self._books.now
        self._recovery.begin(vehicle)

    def _reported(self, vehicle: VehicleNow, event: Reported) -> None:
        before, vehicle.status, vehicle.seen = vehicle.status, event.status, self._books.now
        self._books.touch(vehicle)
        self._mind_alarm(vehicle, event.status)
        self._note_changes(vehicle, before, event.status)
        self._follow(vehicle, event.status)
        if not event.polled:
            return
        if vehicle.recovery:
            self._alarms.step(vehicle, event.status, event.asked_at)
        elif vehicle.stage is Stage.SETTLING:
            if self._recovery.observe(vehicle, event.status, event.asked_at):
                self._missions.settle_handling(vehicle)
                self._books.wake(vehicle.id)
        else:
            self._confirm(vehicle, event)

    def _confirm(self, vehicle: VehicleNow, event: Reported) -> None:
        """A polled STATUS of a ready vehicle: does it show what we wait for, does it agree with what we believe?"""
        drive = vehicle.drive
        if drive and drive.completed_by(event.status, event.asked_at):
            self._motion.finish(vehicle, IntentState.DONE, f"STATUS: standing at {event.status.barcode}")
        elif drive and drive.broken_off_by(event.status, event.asked_at):
            self._recovery.begin(vehicle)
        self._missions.confirm(vehicle, event.status, event.asked_at)
        if (event.status.condition.oper is Oper.ALARM and not vehicle.record.hold) or (
            vehicle.handling is None
            and (event.status.condition.doubt or vehicle.loaded is not self._recovery.believed_loaded(vehicle))
        ):
            self._recovery.begin(vehicle)

    def _mind_alarm(self, vehicle: VehicleNow, status: VehicleStatus) -> None:
        """Keep what alarm it has; one from before a restart may be over. Each that begins is told, and that it ended."""
        alarms, condition = self._books.alarms, status.condition
        if condition.oper is not Oper.ALARM and not alarms.about(AlarmKind.VEHICLE, vehicle.id):
            return
        before = alarms.codes(AlarmKind.VEHICLE, vehicle.id)
        if condition.oper is Oper.ALARM:
            remedy = f"clear the cause, then POST /api/v1/vehicles/{vehicle.id}/recover"
            cause = f"alarm {self._books.named_alarm(condition.code)}"
            alarms.begin_only(AlarmKind.VEHICLE, vehicle.id, str(condition.code), cause, remedy, vehicle.job)
        else:
            alarms.end(AlarmKind.VEHICLE, vehicle.id, "it reports no alarm any more")
        after = alarms.codes(AlarmKind.VEHICLE, vehicle.id)
        for name, codes in ((JobEvent.ALARM_CLEARED, before - after), (JobEvent.ALARM_SET, after - before)):
            for code in codes:
                self._books.event(name, vehicle=vehicle.id, detail=self._books.named_alarm(int(code)))

    def _note_changes(self, vehicle: VehicleNow, before: VehicleStatus | None, now: VehicleStatus) -> None:
        """Leaving AUTO means that the vehicle may be moved without us."""
        if before is None:
            return
        was, is_ = before.condition, now.condition
        if was.mode is Mode.AUTO and is_.mode is not Mode.AUTO and vehicle.accounted:
            self._recovery.widen(vehicle)
        if vehicle.stage is Stage.READY and was.mode is not is_.mode and not vehicle.recovery:
            self._recovery.begin(vehicle)

    def _follow(self, vehicle: VehicleNow, status: VehicleStatus) -> None:
        """Follow the barcodes it reports along what it holds."""
        if vehicle.barcode is None or not status.condition.recognised or status.barcode == vehicle.barcode:
            return
        if vehicle.trusted:
            return
        if vehicle.doubt:
            self._recovery.claim_too(vehicle, status.barcode)
            return
        if status.condition.mode is not Mode.AUTO:
            if vehicle.accounted and vehicle.drive is None and status.barcode in self._books.track:
                self._recovery.moved_by_hand(vehicle, status.barcode)
            return
        try:
            self._motion.report(vehicle, status.barcode, status.seq)
        except OffPath as why:
            self._recovery.doubt(vehicle, status.barcode, str(why))
            return
        self._books.wake(vehicle.id)

    def _acknowledged(self, vehicle: VehicleNow, event: Acknowledged) -> None:
        drive = vehicle.drive
        if drive and drive.cmd_id == event.cmd_id:
            drive.acknowledged = self._books.now
            self._books.wake(vehicle.id)

    def _answered(self, vehicle: VehicleNow, event: Answered) -> None:
        drive, handling = vehicle.drive, vehicle.handling
        if drive and event.cmd_id == drive.cmd_id:
            drive.acknowledged = drive.acknowledged or self._books.now
            self._follow_answer(vehicle, event)
            if self._motion.answer(vehicle, drive, event):
                self._moved(vehicle, event, recalled=drive.recalled)
        elif drive and drive.amendment and event.cmd_id == drive.amendment.cmd_id:
            if event.ok:
                self._motion.amended(vehicle, drive, drive.amendment)
            else:
                self._motion.not_amended(
                    vehicle, drive, IntentState.FAILED, event.reason or "it is stopping, or stands"
                )
        elif handling and event.cmd_id == handling.cmd_id:
            self._handled(vehicle, event)
        else:
            state = IntentState.DONE if event.ok else IntentState.FAILED
            self._books.close_intent(
                vehicle, event.cmd_id, state, vehicle.done_by if event.ok else event.reason or "RESULT 1"
            )
            self._alarms.answered(vehicle, event)
            self._teaching.answered(vehicle, event.cmd_id, "" if event.ok else event.reason or "RESULT 1")

    def _follow_answer(self, vehicle: VehicleNow, event: Answered) -> None:
        """RESP1 brings the place too; a barcode that was not reported before is followed now."""
        if event.condition.recognised and event.barcode in vehicle.ahead:
            self._follow(vehicle, VehicleStatus(event.condition, event.barcode, event.seq))

    def _moved(self, vehicle: VehicleNow, event: Answered, *, recalled: bool) -> None:
        """The MOVE is over. After an abnormal end the vehicle is asked before anything else is sent."""
        if event.ok:
            vehicle.missed = 0
            return
        if not recalled:
            self._missed(vehicle, f"ended abnormally {MAX_MISSES} times ({event.reason or 'no reason given'})")
        if vehicle.stage is Stage.READY:
            self._recovery.begin(vehicle)

    def _missed(self, vehicle: VehicleNow, what: str) -> None:
        """Another MOVE came to nothing: after some in a row a person has to look."""
        vehicle.missed += 1
        if vehicle.missed >= MAX_MISSES and not vehicle.record.hold:
            vehicle.missed = 0
            self._recovery.hold(vehicle, f"MOVE {what}", "look at the vehicle and its way, then release it")

    def _handled(self, vehicle: VehicleNow, event: Answered) -> None:
        handling = vehicle.handling
        if handling is None:
            return
        if event.ok:
            handling.answered = self._books.now
            self._books.effects.polls.append(vehicle.id)
            return
        # Broken off after the gripper moved, it is done all the same: F decides once the vehicle is at rest.
        self._alarms.note_failure(vehicle, event)
        self._books.close_intent(vehicle, event.cmd_id, IntentState.UNKNOWN, event.reason or "RESULT 1")
        self._recovery.begin(vehicle)

    def _unanswered(self, vehicle: VehicleNow, event: Unanswered) -> None:
        """Unknown is not failed: the vehicle is asked, and nothing else is sent (PROTOCOLS 6.2)."""
        drive = vehicle.drive
        if drive and drive.amendment and drive.amendment.cmd_id == event.cmd_id:
            self._motion.not_amended(vehicle, drive, IntentState.UNKNOWN, event.why.value)
            return
        self._books.close_intent(vehicle, event.cmd_id, IntentState.UNKNOWN, event.why.value)
        self._alarms.unanswered(vehicle, event.cmd_id, event.why)
        self._agv_orders.unanswered(vehicle, event)
        self._teaching.answered(vehicle, event.cmd_id, event.why.value)
        if vehicle.linked and vehicle.stage is Stage.READY and event.why is not Unknown.LINK_LOST:
            self._recovery.begin(vehicle)

    def _not_sent(self, vehicle: VehicleNow, event: NotSent) -> None:
        """Nothing left: the intent is closed, and what hung on it is thought over."""
        barred = barrier(self._books, self._motion.passages, Send(event.vehicle, event.cmd_id, event.command))
        drive, handling = vehicle.drive, vehicle.handling
        if drive and drive.amendment and drive.amendment.cmd_id == event.cmd_id:
            self._motion.not_amended(vehicle, drive, IntentState.NOT_SENT, event.reason)
            return
        if drive and drive.cmd_id == event.cmd_id:
            self._motion.finish(vehicle, IntentState.NOT_SENT, event.reason)
        elif handling and handling.cmd_id == event.cmd_id:
            self._missions.close_handling(vehicle, IntentState.NOT_SENT, event.reason)
        else:
            self._books.close_intent(vehicle, event.cmd_id, IntentState.NOT_SENT, event.reason)
            self._alarms.unanswered(vehicle, event.cmd_id, event.reason)
            return
        if vehicle.linked and vehicle.stage is Stage.READY:
            if vehicle.fit and isinstance(event.command, Move) and not barred:
                self._missed(vehicle, f"could not be sent {MAX_MISSES} times ({event.reason})")
            self._recovery.begin(vehicle)
