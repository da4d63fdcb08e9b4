"""Transfer jobs: ordered, watched, changed, ended."""

from dataclasses import dataclass
from hashlib import blake2b
from typing import Annotated

from fastapi import APIRouter, Header, Query
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer, answer_of, answer_view, ask, items, location, missing, read
from app.api.declared import gives
from app.api.inputs import JobChange, JobEndIn, JobIn, Limit, PathId, QueryId, station_ids
from app.api.known_jobs import KnownJobs
from app.api.port import Controller
from app.api.problems import Problem
from app.api.whys import told
from app.domain.ids import Actor, CarrierId, JobId, StationId, VehicleId
from app.domain.job import Job, JobState
from app.domain.requests import AbortJob, CancelJob, ChangeJob, CreateJob
from app.domain.view import JobView, Topic
from app.fleet.views import view_of_event, view_of_job
from app.runtime.showing import encoded, shown

router = APIRouter(prefix="/jobs", tags=["jobs"])
HISTORY = 1000
"""Most events given with one job."""

IdempotencyKey = Annotated[
    str | None,
    Header(
        alias="Idempotency-Key",
        min_length=1,
        max_length=128,
        pattern=r"^[\x21-\x7e]+$",
        description="Where the body has no job_id: the same key gives the same job, for 7 days.",
    ),
]


@dataclass(frozen=True, slots=True)
class Ordered:
    """What became of an order: the job as JSON, 201 where it is new, and where it is found."""

    status: int
    body: bytes
    place: dict[str, str]


@router.post("", **gives("Job", 201, "The job; 201 new, 200 the one that was there.", Job=200))
async def create_job(body: JobIn, controller: Ctl, actor: Who, key: IdempotencyKey = None) -> Response:
    """Order a transfer."""
    # Declared here; app.api.orders answers before the routes are looked at.
    ordered = await create(body, controller, actor, key, KnownJobs(controller.reader))
    return answer(ordered.body, ordered.status, ordered.place)


async def create(body: JobIn, controller: Controller, actor: Actor, key: str | None, store: KnownJobs) -> Ordered:
    """Create the job or find it. Raises Problem: refused, or another body under the same id or key."""
    mark = fingerprint(body)
    name = body.job_id
    if name is None:
        known = None if key is None else await read(controller.reader.job_by_key, key)
    else:
        known = None if store.surely_not(name) else await store.job(JobId(name))
    if known is not None:
        return _again(controller, known, mark, f"Job id {name}" if name else f"Idempotency-Key {key}")
    request = CreateJob(
        actor=actor,
        job=JobId(name) if name else None,
        source=body.source,
        destination=StationId(body.destination),
        carrier=CarrierId(body.carrier) if body.carrier else None,
        priority=body.priority,
        fingerprint=mark,
        idempotency_key=key,
        vehicle=VehicleId(body.vehicle) if body.vehicle else None,
        fallbacks=station_ids(body.fallbacks),
    )
    if name is not None:
        store.note(name)
    accepted = await ask(controller, request)
    job = accepted.key
    raw = controller.model.raw(Topic.JOBS, job) or encoded(await _view(controller, job))
    return Ordered(201, raw, location("jobs", job)) if accepted.created else Ordered(200, raw, {})


def fingerprint(body: JobIn) -> str:
    """Return a digest of what was ordered; how it was written does not matter."""
    return blake2b(JobIn.__pydantic_serializer__.to_json(body), digest_size=16).hexdigest()


def _again(controller: Controller, known: Job, mark: str, name: str) -> Ordered:
    """Return the job that was accepted before. Raises Problem: that was another order."""
    if known.fingerprint != mark:
        remedy = "Send the same body as at first, or choose another id."
        raise Problem("conflict", f"{name} stands for another order already: job {known.id}.", remedy)
    raw = controller.model.raw(Topic.JOBS, known.id) or encoded(view_of_job(known))
    return Ordered(200, raw, location("jobs", known.id))


async def _present(controller: Controller, job: str) -> Response:
    """Return the job as it is now, live or ended."""
    raw = controller.model.raw(Topic.JOBS, job)
    return answer(raw) if raw is not None else answer_view(await _view(controller, job))


async def _view(controller: Controller, job: str) -> JobView:
    live = controller.model.get(Topic.JOBS, job)
    if isinstance(live, JobView):
        return live
    kept = await read(controller.reader.job, JobId(job))
    if kept is None:
        missing("job", job)
    return view_of_job(kept)


State = Annotated[JobState | None, Query(description="Only jobs in this state.")]
Before = Annotated[
    int | None, Query(ge=0, le=(1 << 53) - 1, description="Only jobs accepted before the one of this order.")
]


@router.get("", **gives("Job[]", description="Jobs, newest first."))
async def list_jobs(
    controller: Ctl,
    state: State = None,
    carrier: QueryId = None,
    vehicle: QueryId = None,
    after: Before = None,
    limit: Limit = 100,
) -> Response:
    """List jobs, ended ones too."""
    jobs = await read(
        controller.reader.jobs,
        state=state.value if state else None,
        carrier=carrier,
        vehicle=vehicle,
        after=after,
        limit=limit,
    )
    last = jobs[-1].order if len(jobs) == limit else None
    return items((shown(view_of_job(job)) for job in jobs), last)


@router.get("/{job}", **gives("JobWithHistory", description="The job and all its events."))
async def get_job(job: PathId, controller: Ctl) -> Response:
    """Show a job with its history."""
    view = await _view(controller, job)
    events = await read(controller.reader.events, 0, HISTORY, job=job)
    return answer_of({**shown(view), "history": [shown(view_of_event(event)) for event in events]})


@router.get("/{job}/why", **gives("JobWhy", description="What its assignments were chosen by, and what it waited for."))
async def get_why(job: PathId, controller: Ctl) -> Response:
    """Show why a job got its vehicles, and why it waited."""
    kept = await read(controller.reader.job, JobId(job))
    if kept is None:
        missing("job", job)
    why = await read(controller.reader.why, kept.order)
    events = await read(controller.reader.events, 0, HISTORY, job=job)
    return answer_of(told(kept, why, events))


NO_REASON = JobEndIn()


@router.post("/{job}/cancel", **gives("Job", description="The job as it is now."))
async def cancel_job(job: PathId, controller: Ctl, actor: Who, body: JobEndIn = NO_REASON) -> Response:
    """Cancel a job whose carrier is not aboard yet."""
    await ask(controller, CancelJob(actor, JobId(job), body.reason.strip()))
    return await _present(controller, job)


@router.post("/{job}/abort", **gives("Job", description="The job as it is now."))
async def abort_job(job: PathId, controller: Ctl, actor: Who, body: JobEndIn = NO_REASON) -> Response:
    """End a job whose carrier is aboard; the carrier stays aboard."""
    await ask(controller, AbortJob(actor, JobId(job), body.reason.strip()))
    return await _present(controller, job)


@router.patch("/{job}", **gives("Job", description="The job as it is now."))
async def change_job(job: PathId, body: JobChange, controller: Ctl, actor: Who) -> Response:
    """Change priority, destination or vehicle."""
    if not body.model_fields_set:
        raise Problem("invalid", "Nothing to change was named.", "Send priority, destination or vehicle.")
    destination = StationId(body.destination) if body.destination else None
    vehicle = VehicleId(body.vehicle) if body.vehicle else None
    any_vehicle = vehicle is None and "vehicle" in body.model_fields_set
    asked = ChangeJob(actor, JobId(job), body.priority, destination, vehicle, any_vehicle=any_vehicle)
    await ask(controller, asked)
    return await _present(controller, job)
