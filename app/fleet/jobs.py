"""Requests about jobs: create, cancel, abort, change (DOMAIN section 2, COMMANDS sections 4 and 5)."""

from dataclasses import replace
from math import inf

from app.domain.errors import NoRoute, Refusal
from app.domain.ids import CarrierId, JobId, StationId, VehicleId
from app.domain.job import Job, JobEvent, JobState, JobStep, Leg
from app.domain.layout import StationKind
from app.domain.requests import AbortJob, Accepted, CancelJob, ChangeJob, CreateJob, Reply
from app.domain.view import Topic
from app.fleet.backlog import Rank
from app.fleet.books import Books
from app.fleet.kinds import between_kinds
from app.fleet.missions import Missions
from app.fleet.obstacles import brought_first, in_line
from app.fleet.plant_orders import unfit_name
from app.fleet.refusals import leaves, meant
from app.fleet.targets import no_dest, no_offset

OUR_NAMES = "HW-"
"""Jobs without a name from the host are called HW-1, HW-2 ...; hosts may not use the prefix."""


class Jobs:
    """Answers requests about jobs."""

    def __init__(self, books: Books, missions: Missions) -> None:
        self._books = books
        self._missions = missions

    def end_impossible(self) -> None:
        """After a start with another plant file: a job whose places or vehicle are gone cannot go on (our choice: it fails)."""
        books = self._books
        for job in list(books.jobs.values()):
            ends: list[str] = [job.destination]
            if job.leg in {Leg.NONE, Leg.TO_SOURCE, Leg.ACQUIRING}:
                ends.append(job.source)
            gone = [name for name in ends if name not in books.specs and name not in books.vehicles]
            if job.vehicle and job.vehicle not in books.vehicles:
                gone.append(job.vehicle)
            if gone:
                vehicle = books.vehicle_of(job)
                why = f"{', '.join(gone)} is no longer in the plant"
                self._missions.end(vehicle, job, JobStep.FAIL, why, JobEvent.TRANSFER_COMPLETED)

    # -- create -------------------------------------------------------------------------------------------------------

    def create(self, request: CreateJob) -> Reply:
        """Accept a transfer, or say why not. The same id or key with the same body gives the same job."""
        if known := self._known(request):
            return self._same_or_conflict(known, request)
        if refusal := self._fault(request):
            return refusal
        order = self._books.new_order()
        name = request.job or JobId(f"{OUR_NAMES}{order}")
        job = Job(
            id=name,
            order=order,
            carrier=request.carrier or self._carrier_aboard(request.source),
            source=StationId(request.source),
            destination=request.destination,
            priority=request.priority,
            created=self._books.utc,
            actor=request.actor,
            fingerprint=request.fingerprint,
            idempotency_key=request.idempotency_key,
            wish=request.vehicle,
            fallbacks=request.fallbacks,
            reason=self._first_reason(request, (-request.priority, order, name)),
        )
        self._books.save_job(job)
        return Accepted(Topic.JOBS, job.id, created=True)

    def _first_reason(self, request: CreateJob, rank: Rank) -> str:
        """Return what a new job will wait for, where that is plain: kept with the job, it need not be kept again."""
        backlog = self._books.backlog
        first = backlog.earliest_to(request.source)
        queued = first is not None and first[1] in backlog.queued
        if queued and (why := brought_first(self._books, request.source, rank[1])):
            return why
        return in_line(request.destination) if backlog.behind(request.destination, rank, 2) else ""

    def _known(self, request: CreateJob) -> Job | None:
        books = self._books
        name = request.job or (books.by_key.get(request.idempotency_key) if request.idempotency_key else None)
        return (books.jobs.get(name) or books.ended.get(name)) if name else None

    def _same_or_conflict(self, known: Job, request: CreateJob) -> Reply:
        if known.fingerprint == request.fingerprint:
            return Accepted(Topic.JOBS, known.id)
        what = "job_id" if request.job else "Idempotency-Key"
        return Refusal(
            "conflict",
            f"job {known.id} was accepted with another body under this {what}",
            f"use a new {what} for a new job, or GET /api/v1/jobs/{known.id} to see the old one",
            what,
        )

    def _fault(self, request: CreateJob) -> Refusal | None:
        """Return what is wrong with a new job: refused at once (DOMAIN section 2)."""
        books = self._books
        if request.job and request.job.startswith(OUR_NAMES):
            return Refusal(
                "invalid", f"job_id must not begin with {OUR_NAMES}", "leave it out, or use your own", "job_id"
            )
        if refusal := self._unknown_ends(request.source, request.destination, request.fallbacks):
            return refusal
        if request.vehicle and request.vehicle not in books.vehicles:
            remedy = meant(request.vehicle, "see GET /api/v1/vehicles", books.vehicles)
            return Refusal("invalid", f"there is no vehicle {request.vehicle}", remedy, "vehicle")
        if request.source in books.vehicles and request.vehicle not in {None, request.source}:
            return Refusal("invalid", f"the carrier is aboard {request.source}", "leave vehicle out", "vehicle")
        if request.carrier and (refusal := unfit_name(request.carrier)):
            return refusal
        if refusal := self._leaves(request):
            return refusal
        others = (request.destination, *request.fallbacks)
        return (
            between_kinds(books, request.source, others, request.vehicle)
            or self._untaught(request.source, request.destination)
            or self._unfit(request)
            or self._no_route(request.source, request.destination)
        )

    def _unknown_ends(self, source: str, destination: str, fallbacks: tuple[StationId, ...]) -> Refusal | None:
        books = self._books
        see = "see GET /api/v1/stations"
        if source not in books.specs and source not in books.vehicles:
            remedy = meant(source, see, books.specs, books.vehicles)
            return Refusal("invalid", f"there is no station or vehicle {source}", remedy, "source")
        for name, field in ((destination, "destination"), *((f, "fallbacks") for f in fallbacks)):
            if name not in books.specs:
                return Refusal("invalid", f"there is no station {name}", meant(name, see, books.specs), field)
        if source == destination:
            return Refusal("invalid", "source and destination are the same station", "name another", "destination")
        return self._no_other_place(destination, fallbacks)

    def _no_other_place(self, destination: str, fallbacks: tuple[StationId, ...]) -> Refusal | None:
        """A fall-back that is no other place would let a host believe that it has one; back to the source is one."""
        other = "name other stations, or leave it out"
        for number, name in enumerate(fallbacks):
            if name == destination:
                return Refusal("invalid", f"fall-back {name} is the destination", other, "fallbacks")
            if name in fallbacks[:number]:
                return Refusal("invalid", f"fall-back {name} is named twice", other, "fallbacks")
        return None

    def _leaves(self, request: CreateJob) -> Refusal | None:
        """Return why a job would keep the plant that is awaited waiting. One that fetches what is known to be there may come."""
        books, source = self._books, request.source
        wished = request.vehicle if request.vehicle and request.vehicle != source else None
        if refusal := leaves(books, request.destination, "destination") or (
            wished and leaves(books, wished, "vehicle")
        ):
            return refusal
        if source in books.vehicles or books.stations[StationId(source)].present:
            return None
        refusal = leaves(books, source, "source")
        fetch = "if a carrier is there, say so first: PUT /api/v1/carriers/ID"
        return replace(refusal, remedy=f"{fetch}; else {refusal.remedy}") if refusal else None

    def _untaught(self, source: str, destination: str) -> Refusal | None:
        """Ports without DEST are refused with the missing axes named (DOMAIN section 3)."""
        for name, field in ((source, "source"), (destination, "destination")):
            spec = self._books.specs.get(StationId(name))
            if spec and spec.kind is StationKind.PORT and (refusal := no_dest(self._books, spec.id)):
                return replace(refusal, field=field)
        return None

    def _unfit(self, request: CreateJob) -> Refusal | None:
        """The one vehicle that may do the job lacks an OFFSET that a port needs: the missing axes are named."""
        only = self._books.vehicles.get(request.vehicle or VehicleId(request.source))
        ends = (self._books.specs.get(StationId(name)) for name in (request.source, request.destination))
        if only is None or not any(spec and spec.kind is StationKind.PORT for spec in ends):
            return None
        refusal = no_offset(self._books, only)
        return replace(refusal, field="vehicle" if request.vehicle else "source") if refusal else None

    def _no_route(self, source: str, destination: str) -> Refusal | None:
        books = self._books
        start = (
            books.vehicles[VehicleId(source)].barcode
            if source in books.vehicles
            else books.specs[StationId(source)].barcode
        )
        goal = books.specs[StationId(destination)].barcode
        if start is None or books.router.time(start, goal) < inf:  # a few look-ups; the way itself is of no use here
            return None
        try:
            books.router.route(start, goal)
        except NoRoute as why:
            if why.closed is None:  # hosts order ahead: what is closed opens again
                return Refusal("no-route", why.message, "see GET /api/v1/layout", "destination")
        return None

    def _carrier_aboard(self, source: str) -> CarrierId | None:
        """Return the carrier that the source vehicle has aboard, if the source is one and we know."""
        holder = self._books.vehicles.get(VehicleId(source))
        return holder.record.carrier if holder else None

    # -- cancel, abort, change ----------------------------------------------------------------------------------------

    def _find(self, name: JobId) -> Job | Refusal:
        job = self._books.jobs.get(name)
        if job:
            return job
        ended = self._books.ended.get(name)
        if ended:
            return Refusal("conflict", f"job {name} has ended: {ended.state.value}", "order a new job")
        return Refusal("not-found", f"there is no job {name} under way", "see GET /api/v1/jobs")

    def cancel(self, request: CancelJob) -> Reply:
        """Cancel before the carrier is being acquired."""
        job = self._find(request.job)
        if isinstance(job, Refusal):
            return job
        if not job.allows(JobStep.CANCEL):
            return Refusal(
                "conflict",
                f"job {job.id} is {job.state.value}: the carrier is aboard or being picked up",
                f"POST /api/v1/jobs/{job.id}/abort",
            )
        self._books.event(JobEvent.TRANSFER_CANCEL_INITIATED, job=job)
        job = self._books.save_job(job.after(JobStep.CANCEL))
        vehicle = self._books.vehicle_of(job)
        told = f"cancelled by {request.actor}{_because(request.reason)}"
        self._missions.end(vehicle, job, JobStep.CANCEL_DONE, told, JobEvent.TRANSFER_CANCEL_COMPLETED)
        return Accepted(Topic.JOBS, job.id)

    def abort(self, request: AbortJob) -> Reply:
        """Abort after the pick-up began; the carrier stays aboard. One being handled is waited for."""
        job = self._find(request.job)
        if isinstance(job, Refusal):
            return job
        if job.state is JobState.ABORTING:
            return Accepted(Topic.JOBS, job.id)
        if not job.allows(JobStep.ABORT):
            return Refusal(
                "conflict",
                f"job {job.id} is {job.state.value}: nothing was picked up",
                f"POST /api/v1/jobs/{job.id}/cancel",
            )
        told = f"aborted by {request.actor}{_because(request.reason)}"
        self._books.event(JobEvent.TRANSFER_ABORT_INITIATED, job=job, detail=told)
        job = self._books.save_job(job.after(JobStep.ABORT))
        vehicle = self._books.vehicle_of(job)
        if job.leg is Leg.TO_DESTINATION:
            told = "aborted; the carrier is aboard: order vehicle -> place for it"
            self._missions.end(vehicle, job, JobStep.ABORT_DONE, told, JobEvent.TRANSFER_ABORT_COMPLETED)
        elif job.leg is Leg.TO_SOURCE or vehicle is None or vehicle.record.off_rail:
            none = job.leg is Leg.TO_SOURCE
            told = "aborted; nothing is aboard" if none else "aborted without its vehicle: look where the carrier is"
            self._missions.end(vehicle, job, JobStep.ABORT_DONE, told, JobEvent.TRANSFER_ABORT_COMPLETED)
        else:
            self._books.wake(vehicle.id)
        return Accepted(Topic.JOBS, job.id)

    def change(self, request: ChangeJob) -> Reply:
        """Change priority, destination or wished vehicle; all or nothing."""
        job = self._find(request.job)
        if isinstance(job, Refusal):
            return job
        if job.state in {JobState.ABORTING, JobState.CANCELLING}:
            return Refusal("conflict", f"job {job.id} is {job.state.value}", "order a new job once it has ended")
        if refusal := self._bad_change(job, request):
            return refusal
        changed = replace(
            job,
            priority=job.priority if request.priority is None else request.priority,
            destination=request.destination or job.destination,
            wish=None if request.any_vehicle else request.vehicle or job.wish,
        )
        if job.state is JobState.QUEUED and (changed.destination, changed.wish) != (job.destination, job.wish):
            changed = replace(changed, reason="")
        self._books.save_job(changed)
        self._books.event(JobEvent.TRANSFER_UPDATED, job=changed, detail=self._difference(job, changed))
        vehicle = self._books.vehicle_of(changed)
        if vehicle and request.vehicle and request.vehicle != vehicle.id:
            self._missions.give_back(vehicle, f"{request.vehicle} is asked for")
        elif vehicle and changed.destination != job.destination:
            self._books.wake(vehicle.id)
        return Accepted(Topic.JOBS, job.id)

    def _bad_change(self, job: Job, request: ChangeJob) -> Refusal | None:
        if request.vehicle is not None:
            if request.vehicle not in self._books.vehicles:
                remedy = meant(request.vehicle, "see GET /api/v1/vehicles", self._books.vehicles)
                return Refusal("invalid", f"there is no vehicle {request.vehicle}", remedy, "vehicle")
            if refusal := leaves(self._books, request.vehicle, "vehicle"):
                return refusal
            if refusal := between_kinds(self._books, job.source, (), request.vehicle):
                return refusal
            if job.source in self._books.vehicles and request.vehicle != job.source:
                return Refusal("invalid", f"the carrier is aboard {job.source}", "leave vehicle out", "vehicle")
            if job.state not in {JobState.QUEUED, JobState.WAITING}:
                return Refusal(
                    "conflict",
                    f"the carrier is aboard {job.vehicle} or being picked up",
                    "leave vehicle out: only a job that is queued or waiting can get another",
                    "vehicle",
                )
        if request.destination is None or request.destination == job.destination:
            return None
        if job.leg is Leg.DEPOSITING:
            return Refusal(
                "conflict",
                f"the carrier is being put down at {job.destination}",
                "wait for its end, then order a job from there",
                "destination",
            )
        source: str = (job.vehicle or job.source) if job.leg is Leg.TO_DESTINATION else job.source
        return (
            self._unknown_ends(source, request.destination, ())
            or leaves(self._books, request.destination, "destination")
            or between_kinds(self._books, source, (request.destination,), None)
            or self._untaught(source, request.destination)
            or self._no_route(source, request.destination)
        )

    def _difference(self, before: Job, after: Job) -> str:
        pairs = (
            ("priority", before.priority, after.priority),
            ("destination", before.destination, after.destination),
            ("vehicle", before.wish or "any", after.wish or "any"),
        )
        return ", ".join(f"{name} {old} -> {new}" for name, old, new in pairs if old != new) or "nothing changed"


def _because(reason: str) -> str:
    return f": {reason}" if reason else ""
