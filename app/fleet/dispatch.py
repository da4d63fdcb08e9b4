"""Which vehicle does which job: one assignment over all vehicles that carry nothing and all jobs not picked up (DOMAIN 6)."""

from collections import deque
from dataclasses import replace

from app.domain.errors import Refusal
from app.domain.ids import JobId, StationId, VehicleId
from app.domain.job import Job, JobEvent, JobState, JobStep, Leg
from app.domain.records import ControllerState
from app.domain.units import Seconds
from app.domain.why import Choice, Why
from app.fleet.backlog import rank_of
from app.fleet.books import Books
from app.fleet.choices import Choices
from app.fleet.missions import Missions
from app.fleet.obstacles import (
    against_fetching,
    against_picking_up,
    against_putting_down,
    bringer,
    brought_first,
    in_line,
)
from app.fleet.prospects import Asked, Prospects
from app.fleet.servants import Servants
from app.fleet.targets import target_for
from app.fleet.vehicle import VehicleNow
from app.planning.dispatch import NOBODY, RULES, Plan, dispatch

RETHINK_EVERY = Seconds(1.0)
"""Assignments once made are thought over at most so often; new jobs and idle vehicles wait for nothing (our choice)."""
RETHOUGHT = 100
"""So many of them at once, in turn (our choice: about 1 ms)."""
MOST_URGENT = 150
"""So many queued jobs are looked at each time, the most urgent (our choice: about 1 ms)."""
IN_TURN = 100
"""And so many of those behind them, in turn: what keeps many urgent ones from beginning keeps no other (our choice)."""
SAID_AT_ONCE = 50
"""So many jobs say at once that they wait for something else now; the others say it the next time (our choice: about 1 ms)."""
GIVEN_AT_ONCE = 10
"""So many idle vehicles get their job at once; those left get it in the next ticks (our choice: about 3 ms)."""
IN_ONE_GO = 100
"""With more vehicles, looking at the jobs, planning, and giving are ticks of their own (our choice)."""


class Dispatch:
    """Gives jobs to vehicles, and other ones where that saves more than a switch costs."""

    def __init__(self, books: Books, missions: Missions) -> None:
        self._books = books
        self._missions = missions
        self._servants = Servants(books)
        self._prospects = Prospects(books)
        self._names = tuple(books.vehicles)
        self._rows = {name: row for row, name in enumerate(books.vehicles)}
        self._rethink_at = books.now
        self._turn = 0
        self._engaged_from = 0
        self._queue_from = MOST_URGENT
        self._words = 0
        self._pending: deque[tuple[VehicleNow, Job, int]] = deque()
        self._choices: Choices | None = None
        self._looked: tuple[list[Job], dict[JobId, float]] | None = None

    @property
    def pending(self) -> bool:
        """Whether ``go_on`` has something to do: decided, but not carried out yet."""
        return self._looked is not None or bool(self._pending)

    def run(self) -> None:
        """Assign what can be assigned now; a job that cannot begin says why."""
        books = self._books
        self._pending.clear()
        self._looked = None
        self._words = SAID_AT_ONCE
        queued = self._to_be_looked_at()
        if books.controller.state is not ControllerState.AUTO:
            for job in queued:
                self._say(job, f"the controller is {books.controller.state.value}")
            return
        ready, coming = self._that_can_begin(queued)
        for job in ready:
            holder = books.vehicles.get(VehicleId(job.source))
            if holder and holder.available:
                self._assign(holder, job)
        self._looked = ready, coming
        if len(books.vehicles) <= IN_ONE_GO:
            self._plan()

    def go_on(self) -> None:
        """Do the next piece of what ``run`` began: the plan, then idle vehicles get their jobs, some at a time."""
        if self._looked is not None:
            self._plan()
            return
        books, choices = self._books, self._choices
        for _ in range(min(GIVEN_AT_ONCE, len(self._pending))):
            vehicle, job, column = self._pending.popleft()
            can = vehicle.available and not self.loaded(vehicle) and books.controller.state is ControllerState.AUTO
            if choices is not None and can and books.backlog.queued.get(job.id) is job:
                self._assign(vehicle, job, choices.named(column), choices.of(column))
        if not self._pending:
            self._choices = None

    def _plan(self) -> None:
        """Assign the jobs that were found able to begin, as far as they are still as they were."""
        if self._looked is None:
            return
        (ready, coming), self._looked = self._looked, None
        queued = self._books.backlog.queued
        ready = [job for job in ready if queued.get(job.id) is job]
        awaited = self._fetch([job for job in ready if job.source in self._books.specs], coming)
        self._explain(ready, coming, awaited)

    def _to_be_looked_at(self) -> list[Job]:
        """Return the most urgent jobs of the queue, and some of those behind them in turn; by urgency."""
        backlog = self._books.backlog
        count = len(backlog.queued)
        if count <= MOST_URGENT + IN_TURN:
            return backlog.urgent(0, count)
        if self._queue_from >= count:
            self._queue_from = MOST_URGENT
        begin, self._queue_from = self._queue_from, self._queue_from + IN_TURN
        return backlog.urgent(0, MOST_URGENT) + backlog.urgent(begin, IN_TURN)

    def loaded(self, vehicle: VehicleNow) -> bool:
        """Whether the vehicle has a FOUP aboard, by its own word or by our books."""
        return bool(vehicle.loaded) or bool(vehicle.record.believed_loaded)

    # -- which jobs ---------------------------------------------------------------------------------------------------

    def _that_can_begin(self, queued: list[Job]) -> tuple[list[Job], dict[JobId, float]]:
        """Return the jobs whose source is full and destination free, as far as is known, one job per station end.

        Among them are those whose carrier is being brought; the second answer is the seconds until it is there, at least.
        """
        if not queued:
            return [], {}
        active = self._books.backlog.under_way.values()
        sources: set[str] = {job.source for job in active if job.leg in {Leg.TO_SOURCE, Leg.ACQUIRING}}
        emptied: set[str] = {job.source for job in active if job.leg is Leg.ACQUIRING}
        destinations: dict[str, Job] = {job.destination: job for job in active}
        served = set(destinations)
        ready, coming = [], {}
        for job in queued:
            first = "" if job.source in self._books.vehicles else brought_first(self._books, job.source, job.order)
            expected = self._expected(job) if first and job.source in served else None
            why = first if first and expected is None else self._taken(job, sources, destinations)
            if not why and expected is None:
                why = against_picking_up(self._books, job)
            elif not why:
                why = against_fetching(self._books, job)
            why = why or self._blocked(job, emptied) or self._hopeless(job)
            if why:
                self._say(job, why)
                continue
            if expected is not None:
                coming[job.id] = expected
            sources.add(job.source)
            destinations[job.destination] = job
            ready.append(job)
        return ready, coming

    def _taken(self, job: Job, sources: set[str], destinations: dict[str, Job]) -> str:
        """Return which other job comes first at one of its ends."""
        holder = destinations.get(job.destination)
        if holder is not None:
            before = 2 if holder.state is JobState.QUEUED else 1
            if self._books.backlog.behind(job.destination, rank_of(job), before):
                return in_line(job.destination)
            return f"{job.destination} is the destination of {holder.id} already"
        if job.source in sources:
            return f"another job is being fetched from {job.source}"
        return ""

    def _expected(self, job: Job) -> float | None:
        """Return the seconds until the job's carrier is at its source, if it is on its way there; None: nobody knows."""
        first = bringer(self._books, job)
        vehicle = self._books.vehicle_of(first) if first else None
        return self._prospects.until_put_down(vehicle, first) if vehicle and first else None

    def _hopeless(self, job: Job) -> str:
        """Return why no vehicle will do this job for now; it does not keep its ends from others then."""
        only = self._only(job)
        if only:
            able = self._able(only, job)
            return self._nobody(job) if only.barred or not only.linked or not able else ""
        if job.wish or not (self._servants.of(job.source) & self._servants.of(job.destination)).any():
            return "no vehicle can serve both stations: see their DEST, OFFSET and limits"
        return ""

    def _only(self, job: Job) -> VehicleNow | None:
        """Return the one vehicle that may do this job, if there is just one."""
        vehicles = self._books.vehicles
        return vehicles.get(VehicleId(job.source)) or (vehicles.get(job.wish) if job.wish else None)

    def _blocked(self, job: Job, emptied: set[str]) -> str:
        """Return why the carrier could not be put down (it is not refused: hosts order ahead, DOMAIN section 2)."""
        books = self._books
        blocked = against_putting_down(books, job.destination, job.id)
        elsewhere = any(f in books.specs and not against_putting_down(books, f, job.id) for f in job.fallbacks)
        return "" if job.destination in emptied or elsewhere else blocked

    def _say(self, job: Job, why: str) -> None:
        if job.reason == why:
            return
        if self._words:
            self._words -= 1
            self._books.save_job(replace(job, reason=why))
        else:
            self._books.jobs_changed = True

    def _explain(self, ready: list[Job], coming: dict[JobId, float], awaited: dict[JobId, VehicleId]) -> None:
        """Jobs that could begin and got no vehicle say so."""
        given = {job.id for _, job, _ in self._pending}
        for job in ready:
            now = self._books.backlog.queued.get(job.id)
            if now and now.id not in given:
                self._say(now, self._why_queued(now, coming, awaited))

    def _why_queued(self, job: Job, coming: dict[JobId, float], awaited: dict[JobId, VehicleId]) -> str:
        if job.id in awaited:
            return f"it waits for {awaited[job.id]}, which will soon be free nearby"
        first = bringer(self._books, job) if job.id in coming else None
        return f"{first.id} brings a carrier to {job.source} first" if first else self._nobody(job)

    def _nobody(self, job: Job) -> str:
        """Return why no vehicle does this job now. The words change only when the cause does: they are kept."""
        only = self._only(job)
        if only is None:
            return "no vehicle is free"
        asked = "has the carrier aboard" if only.id == job.source else "is asked for"
        return f"no vehicle is free: {only.id} {asked}, and {self._engaged(only) or self._unserved(only, job)}"

    def _unserved(self, vehicle: VehicleNow, job: Job) -> str:
        """Return why the vehicle cannot serve one of the job's stations, with the missing axis named."""
        for place in (job.source, job.destination):
            station = self._books.specs.get(StationId(place))
            why = target_for(self._books, vehicle, station) if station else None
            if isinstance(why, Refusal):
                return f"cannot serve {place}: {why.reason}"
        return "cannot serve both stations"

    def _engaged(self, vehicle: VehicleNow) -> str:
        states = (
            (vehicle.barred, f"is {vehicle.barred}"),
            (not vehicle.linked, "is not connected"),
            (vehicle.job, f"is on job {vehicle.job}"),
            (vehicle.teaching is not None, f"is used for teaching (session {vehicle.teaching})"),
            (not vehicle.fit, "is not ready"),
            (self.loaded(vehicle), "is loaded"),
            (vehicle.kept, vehicle.kept),
        )
        return next((words for applies, words in states if applies), "")

    # -- which vehicle ------------------------------------------------------------------------------------------------

    def _fetch(self, queued: list[Job], coming: dict[JobId, float]) -> dict[JobId, VehicleId]:
        """Assign vehicles to jobs at stations, and think over assignments whose carrier is not picked up yet.

        Returns the jobs that are kept for a vehicle that will soon be free.
        """
        books = self._books
        idle = [v for v in books.vehicles.values() if v.job is None and v.available and not self.loaded(v)]
        engaged = self._engaged_ones()
        jobs = queued + [books.jobs[v.job] for v in engaged if v.job]
        prospects = [self._prospects.of(vehicle) for vehicle in idle + engaged]
        if queued:
            prospects += self._prospects.soon_free()
        if not prospects or not jobs:
            return {}
        asked = Asked(books, self._servants, self._rows, prospects, jobs, coming)
        plan = dispatch(asked.fleet, asked.waiting, asked.times, RULES, self._turn)
        self._carry_out(asked, plan)
        there = [(job, int(row)) for job, row in zip(jobs, plan.vehicle, strict=True) if row != NOBODY]
        return {job.id: prospects[row].vehicle.id for job, row in there if prospects[row].soon}

    def _carry_out(self, asked: Asked, plan: Plan) -> None:
        """Give the plan's jobs to vehicles that did not have them; those that had them give them back first."""
        books = self._books
        self._choices = choices = Choices(books, asked, plan, self._engaged)
        new: list[tuple[VehicleNow, Job, Choice, str]] = []
        room = GIVEN_AT_ONCE if len(books.vehicles) <= IN_ONE_GO else 0
        for column, row in enumerate(plan.vehicle.tolist()):
            if row == NOBODY or asked.prospects[row].soon:
                continue
            vehicle, job = asked.prospects[row].vehicle, asked.jobs[column]
            fresh = vehicle.job is None and job.vehicle is None
            if fresh and not room:
                self._pending.append((vehicle, job, column))
            elif job.vehicle != vehicle.id:
                room -= fresh
                new.append((vehicle, job, choices.of(column), choices.named(column)))
        for vehicle, job, _, _ in new:
            self._missions.give_back(vehicle, f"{vehicle.id} does {job.id} first")
            if job.vehicle:
                self._missions.give_back(books.vehicles[job.vehicle], f"{vehicle.id} is nearer than {job.vehicle}")
        for vehicle, job, choice, named in new:
            self._assign(vehicle, books.jobs[job.id], named, choice)

    def _engaged_ones(self) -> list[VehicleNow]:
        """Return the vehicles whose assignment is thought over now, some in turn: none if that was just done."""
        books = self._books
        if books.now < self._rethink_at:
            return []
        share = min(1.0, RETHOUGHT / max(len(books.vehicles), 1))
        self._rethink_at = Seconds(books.now + RETHINK_EVERY * share)
        self._turn += 1
        found: list[VehicleNow] = []
        names, begin = self._names, self._engaged_from
        for at in range(len(names)):
            vehicle = books.vehicles[names[(begin + at) % len(names)]]
            if self._can_switch(vehicle):
                if len(found) == RETHOUGHT:
                    self._engaged_from = (begin + at) % len(names)
                    break
                found.append(vehicle)
        else:
            self._engaged_from = 0
        return sorted(found, key=lambda vehicle: self._rows[vehicle.id])

    def _can_switch(self, vehicle: VehicleNow) -> bool:
        """Whether the vehicle is only on its way to fetch a carrier."""
        job = self._books.job_of(vehicle)
        return job is not None and job.state is JobState.WAITING and not vehicle.handling and vehicle.fit

    def _able(self, vehicle: VehicleNow, job: Job) -> bool:
        """Whether this vehicle may and can serve both ends."""
        if job.wish and job.wish != vehicle.id:
            return False
        row = self._rows[vehicle.id]
        return bool(self._servants.of(job.source)[row] and self._servants.of(job.destination)[row])

    def _assign(self, vehicle: VehicleNow, job: Job, named: str = "", choice: Choice | None = None) -> None:
        books = self._books
        aboard = job.source == vehicle.id
        first = job.assigned is None
        there = books.stations.get(StationId(job.source))
        job = replace(
            job.after(JobStep.ASSIGNED),
            vehicle=vehicle.id,
            leg=Leg.TO_DESTINATION if aboard else Leg.TO_SOURCE,
            assigned=job.assigned or books.utc,
            carrier=job.carrier or (there.carrier if there else None),
            reason="",
        )
        if aboard:
            job = replace(job.after(JobStep.ACQUIRING), carrier=job.carrier or vehicle.record.carrier)
        vehicle.job = job.id
        books.save_job(job)
        if choice:
            books.keep_why((books.whys.get(job.id) or Why(job.order, job.id)).chosen(choice))
        if first:
            books.event(JobEvent.TRANSFER_INITIATED, job=job)
        books.event(JobEvent.VEHICLE_ASSIGNED, job=job, detail=named)
        if aboard:
            books.event(JobEvent.TRANSFERRING, job=job)
        self._missions.proceed(vehicle)
        books.wake(vehicle.id)
