"""What a vehicle does for its job: to the source, pick up, to the destination, put down; and one-shots for a person.

Every step is decided from durable facts (the job's leg, settled commands) and the vehicle's own FOUP bit, so that a restart
goes on where it was.
"""

from dataclasses import replace

from app.domain.commands import Pickup, Place
from app.domain.errors import NoRoute, Refusal
from app.domain.ids import StationId
from app.domain.job import Job, JobEvent, JobState, JobStep, Leg
from app.domain.layout import PulseSet, Station
from app.domain.records import IntentState, Provenance
from app.domain.units import Seconds
from app.domain.vehicle import Oper, VehicleStatus
from app.fleet.books import SYSTEM, Books
from app.fleet.buffers import Buffers
from app.fleet.custody import carrier_moved
from app.fleet.kinds import serves
from app.fleet.motion import Motion
from app.fleet.obstacles import (
    against_driving,
    against_fetching,
    against_picking_up,
    against_putting_down,
    bringer,
    brought_first,
)
from app.fleet.recovery import Recovery
from app.fleet.targets import target_for
from app.fleet.vehicle import Errand, Handling, Purpose, VehicleNow

MAX_MISSES = 3
"""So often a handling or a move may end abnormally without an alarm before the vehicle is held (our choice)."""
NO_PLACE = "its destination cannot be used"
"""How the reason of a job begins that waits for a place to put its carrier down."""

STANDS_BY = "its vehicle stands by"
"""How the reason of a job begins whose carrier is not there yet."""


class Missions:
    """Takes vehicles through their jobs, one step at a time."""

    def __init__(self, books: Books, motion: Motion, recovery: Recovery, buffers: Buffers) -> None:
        self._books = books
        self._motion = motion
        self._recovery = recovery
        self._buffers = buffers

    # -- the next step ------------------------------------------------------------------------------------------------

    def proceed(self, vehicle: VehicleNow) -> None:
        """Take the next step if nothing is under way."""
        if not vehicle.fit or vehicle.handling:
            return
        self._resume(vehicle)
        if vehicle.errand and vehicle.errand.purpose in {Purpose.BACK_OUT, Purpose.GIVE_WAY}:
            if self._motion.arrived(vehicle):
                # It may be asked to give way again from here, also with a job that it cannot go on with.
                self._motion.drop(vehicle)
            elif vehicle.errand.purpose is Purpose.BACK_OUT:
                return
        if vehicle.drive:
            self._redirect(vehicle)
            return
        if vehicle.order:
            self._handle_for_person(vehicle)
            return
        job = self._books.job_of(vehicle)
        if job:
            self._go_on_with(vehicle, job)
        elif vehicle.errand and self._motion.arrived(vehicle):
            self._motion.drop(vehicle)

    def _redirect(self, vehicle: VehicleNow) -> None:
        """While it drives: its job, or the job's destination, may have changed."""
        job = self._books.job_of(vehicle)
        if job is None:
            return
        if job.leg is Leg.TO_DESTINATION:
            usable = self._usable_destination(vehicle, job)
            if usable:
                self._head_for(vehicle, usable, pickup=False)
        elif job.leg is Leg.TO_SOURCE and self._usable_source(vehicle, job):
            self._head_for(vehicle, job, pickup=True)

    def _head_for(self, vehicle: VehicleNow, job: Job, *, pickup: bool) -> Station | None:
        """Make the station of this leg the vehicle's errand, if it is not already; None: there is no way."""
        station = self._books.specs[StationId(job.source if pickup else job.destination)]
        purpose = Purpose.SOURCE if pickup else Purpose.DESTINATION
        errand = Errand(station.barcode, station.kind.stop_action, purpose)
        if vehicle.errand != errand:
            self._send(vehicle, job, errand)
        return station if vehicle.errand == errand else None

    def _go_on_with(self, vehicle: VehicleNow, job: Job) -> None:
        if job.state is JobState.ABORTING:
            self._end_abort(vehicle, job)
            return
        match job.leg:
            case Leg.NONE:
                pass
            case Leg.TO_SOURCE:
                self._go_and(vehicle, job, pickup=True)
            case Leg.ACQUIRING:
                self._after_acquiring(vehicle, job)
            case Leg.TO_DESTINATION:
                self._go_and(vehicle, job, pickup=False)
            case Leg.DEPOSITING:
                self._after_depositing(vehicle, job)

    def _go_and(self, vehicle: VehicleNow, job: Job, *, pickup: bool) -> None:
        """Go to the station of this leg, and handle there once arrived."""
        if vehicle.loaded is pickup:
            self._cannot(vehicle, job, pickup=pickup)
            return
        usable = self._usable_source(vehicle, job) if pickup else self._usable_destination(vehicle, job)
        if usable is None:
            return
        station = self._head_for(vehicle, usable, pickup=pickup)
        if station and self._motion.arrived(vehicle) and not self._books.stilled(vehicle):
            if pickup and self._usable_source(vehicle, usable) is None:  # It was sent to where it stands, ahead of it.
                return
            if why := self._buffers.lend(vehicle, station):
                self._wait(usable, why)
            else:
                self._start_handling(vehicle, usable, station, pickup=pickup)

    def _usable_source(self, vehicle: VehicleNow, job: Job) -> Job | None:
        """Return the job if its source still has what it wants, or will have; else it goes back into the queue.

        A vehicle that is there before the carrier stands by: whoever brings it must get past (``Courtesy``).
        """
        obstacle = against_picking_up(self._books, job) or brought_first(self._books, job.source, job.order)
        if not obstacle and (
            cut_off := self._cut_off(vehicle, StationId(job.source)) or against_driving(self._books, job)
        ):
            if job.allows(JobStep.UNASSIGNED):
                self.give_back(vehicle, cut_off)
            else:
                self._wait(job, cut_off)
            return None
        if not obstacle:
            return self._wait(job, "") if job.reason.startswith(STANDS_BY) else job
        first = None if against_fetching(self._books, job) else bringer(self._books, job)
        if first is None:
            self.give_back(vehicle, obstacle)
            return None
        errand = vehicle.errand
        if errand and errand.purpose is Purpose.SOURCE and self._motion.arrived(vehicle):
            job = self._wait(job, f"{STANDS_BY}: {first.id} brings a carrier to {job.source} first")
            self._motion.drop(vehicle)
        return None if job.reason.startswith(STANDS_BY) else job

    def _cannot(self, vehicle: VehicleNow, job: Job, *, pickup: bool) -> None:
        """The load is not what this leg needs; a person has vouched for it, otherwise the vehicle were held."""
        if pickup:
            self.give_back(vehicle, f"{vehicle.id} is loaded already")
        else:
            self.end(vehicle, job, JobStep.FAIL, "the carrier is no longer aboard", JobEvent.TRANSFER_COMPLETED)

    def _send(self, vehicle: VehicleNow, job: Job, errand: Errand) -> None:
        try:
            self._motion.send(vehicle, errand)
        except NoRoute as why:
            self._wait(job, f"{vehicle.id} finds no way: {self._books.closed.explain(why)}")
            return
        if vehicle.barcode == errand.goal and vehicle.status:
            tags = {kind.stop_action for kind in vehicle.status.condition.tags}
            vehicle.stopped = errand.action if errand.action in tags else vehicle.stopped
        if not self._motion.arrived(vehicle):
            self._books.event(JobEvent.VEHICLE_DEPARTED, job=job)
        self._wait(job, "")

    def _wait(self, job: Job, reason: str) -> Job:
        if job.reason == reason:
            return job
        return self._books.save_job(replace(job, reason=reason))

    # -- where to put it down -----------------------------------------------------------------------------------------

    def _usable_destination(self, vehicle: VehicleNow, job: Job) -> Job | None:
        """Return the job with a destination that can be used now; None: it has to wait, and says so."""
        obstacle = against_putting_down(self._books, job.destination, job.id)
        obstacle = obstacle or self._cut_off(vehicle, job.destination)
        if not obstacle:
            return self._wait(job, "") if job.reason.startswith(NO_PLACE) else job
        fallback = self._fallback(vehicle, job)
        if fallback:
            changed = self._books.save_job(replace(job, destination=fallback, reason=""))
            self._books.event(
                JobEvent.TRANSFER_UPDATED, job=changed, detail=f"{obstacle}; going on to the fall-back {fallback}"
            )
            return changed
        self._wait(job, f"{NO_PLACE}: {obstacle}")
        errand = vehicle.errand
        if errand and (errand.purpose is Purpose.DESTINATION or self._motion.arrived(vehicle)):
            self._motion.drop(vehicle)
        return None

    def _cut_off(self, vehicle: VehicleNow, station: StationId) -> str:
        """Return why this vehicle cannot come to a station from where it can turn, for what is closed now."""
        start = vehicle.ahead[-1] if vehicle.ahead else vehicle.barcode
        why = self._books.no_way.why(start, self._books.specs[station].barcode) if start is not None else ""
        return f"{vehicle.id} finds no way: {why}" if why else ""

    def _fallback(self, vehicle: VehicleNow, job: Job) -> StationId | None:
        """Return the first fall-back of the job or the plant that this vehicle can use and no other job is going to."""
        books = self._books
        engaged = {other.destination for other in books.jobs.values() if other.vehicle and other.id != job.id}
        for fallback in (*job.fallbacks, *books.specs[job.destination].fallbacks):
            spec = books.specs.get(fallback)
            if spec is None or fallback in engaged or against_putting_down(books, fallback, job.id):
                continue
            if self._cut_off(vehicle, fallback):
                continue
            if serves(vehicle, spec) and not isinstance(target_for(self._books, vehicle, spec), Refusal):
                return fallback
        return None

    # -- handling -----------------------------------------------------------------------------------------------------

    def _start_handling(self, vehicle: VehicleNow, job: Job, station: Station, *, pickup: bool) -> None:
        target = target_for(self._books, vehicle, station)
        if isinstance(target, Refusal):
            why = f"{vehicle.id} cannot {'pick up' if pickup else 'put down'}: {target.reason}"
            if pickup:
                self.give_back(vehicle, why)
            else:
                self._wait(job, why)
            return
        self._books.event(JobEvent.VEHICLE_ARRIVED, job=job, detail=station.id)
        leg = Leg.ACQUIRING if pickup else Leg.DEPOSITING
        if pickup:
            job = job.after(JobStep.ACQUIRING) if job.allows(JobStep.ACQUIRING) else job
            self._books.event(JobEvent.TRANSFERRING, job=job)
        job = self._books.save_job(replace(job, leg=leg, reason=""))
        self._books.event(JobEvent.VEHICLE_ACQUIRE_STARTED if pickup else JobEvent.VEHICLE_DEPOSIT_STARTED, job=job)
        self._handle(vehicle, station, target, job, pickup=pickup)

    def _handle(
        self, vehicle: VehicleNow, station: Station, target: PulseSet | None, job: Job | None, *, pickup: bool
    ) -> None:
        books = self._books
        vehicle.failed_handling = ""
        actor = job.actor if job else vehicle.order.actor if vehicle.order else SYSTEM
        make = Pickup if pickup else Place
        dest, offset = books.dests.get(station.id), books.offsets.get(vehicle.id)
        body = {
            "station": station.id,
            "target": [target.shft, target.rota, target.lift] if target else None,
            "dest_version": dest.version if dest and target else None,
            "offset_version": offset.version if offset and target else None,
        }
        command = make(station.kind, target, station.look_down, station.speed)
        kind = "pickup" if pickup else "place"
        intent = books.open_intent(vehicle, kind, command, actor, job=job.id if job else None, body=body)
        vehicle.handling = Handling(intent.cmd_id, intent, pickup, station.id, job.id if job else None, books.now)

    def confirm(self, vehicle: VehicleNow, status: VehicleStatus, asked_at: Seconds) -> None:
        """A polled STATUS after RESULT 0: done if F agrees, else an alarm of ours (PROTOCOLS 6.2).

        A vehicle that answers on acceptance (I19) is still at it then: F counts once it is at rest.
        """
        handling, condition = vehicle.handling, status.condition
        if handling is None or handling.answered is None or asked_at < handling.answered:
            return
        if condition.oper is not Oper.IDLE or not (condition.at_rest and condition.homed):
            if condition.oper is Oper.IDLE:
                self._recovery.begin(vehicle)
            return
        if condition.loaded is handling.pickup:
            agrees = "" if vehicle.is_agv else " and F agrees"
            self.close_handling(vehicle, IntentState.DONE, f"{vehicle.done_by}{agrees}")
            return
        what = "PICKUP" if handling.pickup else "PLACE"
        self.close_handling(vehicle, IntentState.FAILED, f"RESULT 0, but F = {int(condition.loaded)}")
        self._recovery.hold(
            vehicle,
            f"{what} at {handling.station} was answered RESULT 0, but the {vehicle.burden} bit is {int(condition.loaded)}",
            "look whether the carrier is aboard or at the station, correct it, then release the vehicle",
        )

    def close_handling(self, vehicle: VehicleNow, state: IntentState, outcome: str) -> None:
        """The PICKUP or PLACE is over: write down what it did to carrier and station."""
        handling = vehicle.handling
        if handling is None:
            return
        vehicle.handling = None
        self._books.close_intent(vehicle, handling.cmd_id, state, outcome)
        self._buffers.give_back(vehicle, handling.station)
        if state in {IntentState.DONE, IntentState.SETTLED_DONE}:
            vehicle.missed = 0
            vehicle.trips += not handling.pickup
            carrier_moved(self._books, vehicle, handling.station, handling.job, pickup=handling.pickup)
        vehicle.order = None
        self._books.wake(vehicle.id)

    def settle_handling(self, vehicle: VehicleNow) -> None:
        """The vehicle is settled: an open PICKUP or PLACE is decided by F (COMMANDS 3.3)."""
        for intent in vehicle.handlings:
            pickup = intent.kind == "pickup"
            if vehicle.handling is None or vehicle.handling.cmd_id != intent.cmd_id:
                station = StationId(str(intent.body.get("station")))
                vehicle.handling = Handling(intent.cmd_id, intent, pickup, station, intent.job, self._books.now)
            done = vehicle.loaded is pickup
            state = IntentState.SETTLED_DONE if done else IntentState.SETTLED_NOT_DONE
            before = f"{intent.outcome}; " if intent.outcome else ""
            self.close_handling(vehicle, state, f"{before}by STATUS: F = {int(bool(vehicle.loaded))}")

    def _after_acquiring(self, vehicle: VehicleNow, job: Job) -> None:
        """The pick-up of this job is settled: F says what came of it."""
        if vehicle.loaded:
            self._books.event(JobEvent.VEHICLE_ACQUIRE_COMPLETED, job=job)
            job = self._books.save_job(replace(job, leg=Leg.TO_DESTINATION))
            vehicle.errand = None
            self._go_on_with(vehicle, job)
        else:
            self._again_or_fail(vehicle, job, Leg.TO_SOURCE)

    def _after_depositing(self, vehicle: VehicleNow, job: Job) -> None:
        if vehicle.loaded:
            self._again_or_fail(vehicle, job, Leg.TO_DESTINATION)
            return
        self._books.event(JobEvent.VEHICLE_DEPOSIT_COMPLETED, job=job)
        self.end(vehicle, job, JobStep.COMPLETE, "completed", JobEvent.TRANSFER_COMPLETED)

    def _again_or_fail(self, vehicle: VehicleNow, job: Job, leg: Leg) -> None:
        """A handling ended abnormally, and nothing moved. After an alarm the job fails (nothing aboard) or waits held."""
        why, vehicle.failed_handling = vehicle.failed_handling, ""
        vehicle.missed += 1
        if leg is Leg.TO_SOURCE and (why or vehicle.missed >= MAX_MISSES):
            vehicle.missed = 0
            self._forget_presence(StationId(job.source))
            self.end(vehicle, job, JobStep.FAIL, why or "PICKUP refused by the vehicle", JobEvent.TRANSFER_COMPLETED)
        elif vehicle.missed >= MAX_MISSES:
            vehicle.missed = 0
            self._recovery.hold(
                vehicle,
                f"PLACE at {job.destination} was refused {MAX_MISSES} times",
                "look at the vehicle and the station, change the job's destination if need be, then release the vehicle",
            )
        else:
            vehicle.errand = None
            self._go_on_with(vehicle, self._books.save_job(replace(job, leg=leg)))

    def _forget_presence(self, station: StationId) -> None:
        """A pick-up failed there: what we believed of the station counts no more, and nothing is put down there."""
        books, record = self._books, self._books.stations.get(station)
        if record:
            books.save_station(replace(record, present=None, provenance=Provenance.INFERRED, at=books.utc))
            detail = "not known: a pick-up failed there"
            books.event(JobEvent.PORT_CHANGED, destination=station, carrier=record.carrier, detail=detail)

    # -- ends ---------------------------------------------------------------------------------------------------------

    def end(self, vehicle: VehicleNow | None, job: Job, step: JobStep, result: str, event: JobEvent) -> Job:
        """End a job and free its vehicle."""
        ended = replace(job.after(step), result=result, reason="", leg=Leg.NONE, ended=self._books.utc)
        if vehicle:
            self.unassign(vehicle, ended)
        self._books.save_job(ended)
        self._books.event(
            event, job=ended, vehicle=vehicle.id if vehicle else None, result=ended.state.value, detail=result
        )
        return ended

    def unassign(self, vehicle: VehicleNow, job: Job) -> None:
        """The vehicle is no longer on this job."""
        vehicle.job = None
        vehicle.missed = 0
        self._motion.drop(vehicle)
        self._books.event(JobEvent.VEHICLE_UNASSIGNED, job=job, vehicle=vehicle.id)

    def give_back(self, vehicle: VehicleNow, why: str) -> None:
        """The vehicle cannot fetch its job's carrier: the job goes back into the queue (waiting -> queued).

        One that was tried already (transferring) has no way back there: it fails, or is aborted if that was asked for.
        """
        job = self._books.job_of(vehicle)
        if job is None or job.leg is not Leg.TO_SOURCE:
            return
        if job.allows(JobStep.UNASSIGNED):
            self.unassign(vehicle, job)
            self._books.save_job(replace(job.after(JobStep.UNASSIGNED), leg=Leg.NONE, vehicle=None, reason=why))
        elif job.state is JobState.ABORTING:
            self._end_abort(vehicle, job)
        else:
            self.end(vehicle, job, JobStep.FAIL, why, JobEvent.TRANSFER_COMPLETED)

    def abandon(self, vehicle: VehicleNow, why: str) -> None:
        """The vehicle is gone from the rail: a job it was to fetch goes to another, an abort no longer waits for it."""
        job = self._books.job_of(vehicle)
        if job and job.state is JobState.ABORTING:
            told = f"aborted; {why}: look where the carrier is"
            self.end(vehicle, job, JobStep.ABORT_DONE, told, JobEvent.TRANSFER_ABORT_COMPLETED)
        else:
            self.give_back(vehicle, why)

    def interrupt(self, vehicle: VehicleNow, why: str) -> None:
        """The vehicle cannot go on for long: its job goes to another, or, once the pick-up began, is paused and says why."""
        job = self._books.job_of(vehicle)
        if job is None:
            return
        if job.leg is Leg.TO_SOURCE:
            self.give_back(vehicle, f"given back by {vehicle.id}: {why}")
            return
        reason = f"{vehicle.id} cannot go on: {why}"
        if job.allows(JobStep.PAUSE):
            job = self._books.save_job(replace(job.after(JobStep.PAUSE), reason=reason))
            self._books.event(JobEvent.TRANSFER_PAUSED, job=job, detail=reason)
        elif job.state is JobState.PAUSED and job.reason != reason:
            self._books.save_job(replace(job, reason=reason))

    def _resume(self, vehicle: VehicleNow) -> None:
        """The vehicle can go on again, and its job with it."""
        job = self._books.job_of(vehicle)
        if job and job.allows(JobStep.RESUME):
            job = self._books.save_job(replace(job.after(JobStep.RESUME), reason=""))
            self._books.event(JobEvent.TRANSFER_RESUMED, job=job)

    def _end_abort(self, vehicle: VehicleNow, job: Job) -> None:
        """An abort was asked for while a handling was under way, which is settled now (COMMANDS section 4)."""
        if job.leg is Leg.DEPOSITING and not vehicle.loaded:
            job = self._books.save_job(job.after(JobStep.ABORT_FAILED))
            self._books.event(JobEvent.TRANSFER_ABORT_FAILED, job=job, detail="the carrier was put down already")
            self._after_depositing(vehicle, job)
            return
        aboard = "the carrier is aboard: order vehicle -> place for it" if vehicle.loaded else "nothing is aboard"
        self.end(vehicle, job, JobStep.ABORT_DONE, f"aborted; {aboard}", JobEvent.TRANSFER_ABORT_COMPLETED)

    # -- one-shots ----------------------------------------------------------------------------------------------------

    def _handle_for_person(self, vehicle: VehicleNow) -> None:
        order = vehicle.order
        if order is None or self._books.stilled(vehicle):
            return
        station = self._books.specs[order.station]
        target = target_for(self._books, vehicle, station, order.target)
        closed = self._books.closures.against(station)
        if isinstance(target, Refusal) or closed or station.id in self._books.buffer_trouble:
            vehicle.order = None
            return
        if self._buffers.lend(vehicle, station):
            return
        self._handle(vehicle, station, target, None, pickup=order.pickup)
