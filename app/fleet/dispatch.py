"""Which vehicle does which job: one assignment over all vehicles that carry nothing and all jobs not picked up (DOMAIN 6).

Where there are many vehicles it is thought over in slices: between two of them, the world may change. What was weighed is
looked at again before it is carried out.
"""

from collections import deque
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from app.domain.ids import JobId, StationId, VehicleId
from app.domain.job import Job, JobEvent, JobState, JobStep, Leg
from app.domain.records import ControllerState
from app.domain.units import Seconds
from app.domain.why import Choice, Why
from app.fleet.beginnings import IN_TURN, LOOKED_AT_ONCE, Look
from app.fleet.books import Books
from app.fleet.choices import Choices
from app.fleet.missions import Missions
from app.fleet.obstacles import bringer
from app.fleet.overdue import Overdue
from app.fleet.prospects import Asked, Prospect, Prospects
from app.fleet.reasons import Reasons
from app.fleet.restraint import KeptBack
from app.fleet.servants import Servants
from app.fleet.vehicle import VehicleNow
from app.planning.dispatch import NOBODY, RULES, Floats, Plan, assigned, considered, unassigned

RETHINK_EVERY = Seconds(1.0)
"""Assignments once made are thought over at most so often; new jobs and idle vehicles wait for nothing (our choice)."""
RETHOUGHT = 100
"""So many of them at once, in turn (our choice: about 1 ms)."""
SAID_AT_ONCE = 50
"""So many jobs say at once that they wait for something else now; the others say it the next time (our choice: about 1 ms)."""
GIVEN_AT_ONCE = 10
"""So many idle vehicles get their job at once; those left get it in the next ticks (our choice)."""
GIVEN_IN_A_SLICE = 4
"""And so many where there are many vehicles, and each assignment has more to choose from (our choice: about 2 ms)."""
IN_ONE_GO = 100
"""With more vehicles, all is done in slices (our choice)."""
SEEN_AT_ONCE = 400
"""So many vehicles are looked at before others may do something (our choice: about 1 ms)."""


class Dispatch:
    """Gives jobs to vehicles, and other ones where that saves more than a switch costs."""

    def __init__(self, books: Books, missions: Missions) -> None:
        self._books = books
        self._missions = missions
        self._servants = Servants(books)
        self._prospects = Prospects(books)
        self._names = tuple(books.vehicles)
        self._rows = {name: row for row, name in enumerate(books.vehicles)}
        self._reasons = Reasons(books, self._servants, self._rows)
        self.overdue = Overdue(books)
        self._kept_back = KeptBack(books)
        self._held: set[JobId] = set()
        self._rethink_at = books.now
        self._turn = 0
        self._engaged_from = 0
        self._queue_from = 0
        self._words = 0
        self._pending: deque[tuple[VehicleNow, Job, int]] = deque()
        self._choices: Choices | None = None
        self._thought: Iterator[None] | None = None

    @property
    def pending(self) -> bool:
        """Whether ``go_on`` has something to do: not thought to the end, or not carried out yet."""
        return self._thought is not None or bool(self._pending)

    def run(self) -> None:
        """Assign what can be assigned now; a job that cannot begin says why."""
        self._pending.clear()
        self._words = SAID_AT_ONCE
        self._thought = self._think()
        self._go_on_thinking()
        while not self._sliced and self._go_on_thinking():
            pass

    def go_on(self) -> None:
        """Do the next piece of what ``run`` began; idle vehicles get their jobs at its end, some at a time."""
        if self._go_on_thinking():
            return
        books, choices = self._books, self._choices
        for _ in range(min(self._at_once, len(self._pending))):
            vehicle, job, column = self._pending.popleft()
            can = self._idle(vehicle) and books.controller.state is ControllerState.AUTO
            if choices is not None and can and books.backlog.queued.get(job.id) is job:
                self._assign(vehicle, job, choices.named(column), choices.of(column))
        if not self._pending:
            self._choices = None

    def _go_on_thinking(self) -> bool:
        """Think on until the next slice ends; return whether there was anything to think over."""
        if self._thought is None:
            return False
        if next(self._thought, self) is self:
            self._thought = None
        return True

    @property
    def _sliced(self) -> bool:
        return len(self._books.vehicles) > IN_ONE_GO

    @property
    def _at_once(self) -> int:
        return min(GIVEN_IN_A_SLICE, GIVEN_AT_ONCE) if self._sliced else GIVEN_AT_ONCE

    def _think(self) -> Iterator[None]:
        """Look at jobs and vehicles, weigh, assign, explain; give after each slice."""
        books = self._books
        look = Look(books, self._reasons, self._prospects, self.overdue, self._say)
        if books.controller.state is not ControllerState.AUTO:
            for job in books.backlog.urgent(0, IN_TURN):
                self._say(job, f"the controller is {books.controller.state.value}")
            return
        yield from look.by_urgency()
        for jobs in self._in_turn(look.seen):
            look.at(jobs)
            yield
        for job in look.ready:
            holder = books.vehicles.get(VehicleId(job.source))
            if holder and holder.available and self._still_queued(job):
                self._assign(holder, job)
        yield from self._fetch(look)

    def _in_turn(self, seen: int) -> Iterator[list[Job]]:
        """Give slices of the queue behind the most urgent, which were seen already: others at each look, in turn."""
        backlog = self._books.backlog
        count = len(backlog.queued)
        if not seen < self._queue_from < count:
            self._queue_from = seen
        begin, end = self._queue_from, min(self._queue_from + IN_TURN, count)
        self._queue_from = end
        for first in range(begin, end, LOOKED_AT_ONCE):
            yield backlog.urgent(first, min(LOOKED_AT_ONCE, end - first))

    def _still_queued(self, job: Job) -> bool:
        return self._books.backlog.queued.get(job.id) is job

    def _idle(self, vehicle: VehicleNow) -> bool:
        """Whether a job at a station may be given to a vehicle now."""
        free = vehicle.job is None and vehicle.available and not self._books.closures.paused_at(vehicle.barcode)
        return free and not self._reasons.loaded(vehicle)

    def _say(self, job: Job, why: str) -> None:
        if job.reason == why:
            return
        if self._words:
            self._words -= 1
            self._books.save_job(replace(job, reason=why))
        else:
            self._books.jobs_changed = True

    def _explain(self, look: Look, awaited: dict[JobId, VehicleId]) -> None:
        """Jobs that could begin and got no vehicle say so."""
        given = {job.id for _, job, _ in self._pending}
        for job in look.ready:
            now = self._books.backlog.queued.get(job.id)
            if now and now.id not in given:
                self._say(now, self._why_queued(now, look.coming, awaited))

    def _why_queued(self, job: Job, coming: dict[JobId, float], awaited: dict[JobId, VehicleId]) -> str:
        if job.id in self._held:
            return self._kept_back.why()
        if job.id in awaited:
            return f"it waits for {awaited[job.id]}, which will soon be free nearby"
        first = bringer(self._books, job) if job.id in coming else None
        return f"{first.id} brings a carrier to {job.source} first" if first else self._reasons.nobody(job)

    # -- which vehicle ------------------------------------------------------------------------------------------------

    def _fetch(self, look: Look) -> Iterator[None]:
        """Assign vehicles to jobs at stations, and think over assignments whose carrier is not picked up yet."""
        books = self._books
        prospects: list[Prospect] = []
        for begin in range(0, len(self._names), SEEN_AT_ONCE):
            some = (books.vehicles[name] for name in self._names[begin : begin + SEEN_AT_ONCE])
            prospects += [self._prospects.of(vehicle) for vehicle in some if self._idle(vehicle)]
            yield
        engaged = self._engaged_ones()
        prospects += [self._prospects.of(vehicle) for vehicle in engaged]
        queued = [job for job in look.ready if job.source in books.specs and self._still_queued(job)]
        jobs = queued + [books.jobs[v.job] for v in engaged if v.job]
        if queued:
            prospects += self._prospects.soon_free()
        awaited: dict[JobId, VehicleId] = {}
        self._held.clear()
        if prospects and jobs:
            yield
            asked = Asked(books, self._servants, self._rows, prospects, jobs, look.coming)
            yield
            rows, columns = considered(asked.fleet, asked.waiting, self._turn)
            driven: list[Floats] = []
            for begin in range(0, len(rows) if len(columns) else 0, SEEN_AT_ONCE):
                driven.append(asked.times(rows[begin : begin + SEEN_AT_ONCE], columns))
                yield
            table = np.concatenate(driven) if driven else None
            plan = unassigned(asked.fleet, asked.waiting, (rows, columns), table)
            room = self._kept_back.room()
            assigned(plan, asked.fleet, asked.waiting, RULES, room)
            self._hold_back(asked, plan, room)
            self._carry_out(asked, plan)
            there = [(job, int(row)) for job, row in zip(jobs, plan.vehicle, strict=True) if row != NOBODY]
            awaited = {job.id: prospects[row].vehicle.id for job, row in there if prospects[row].soon}
            yield
        self._explain(look, awaited)

    def _hold_back(self, asked: Asked, plan: Plan, room: int) -> None:
        """Note the jobs that get nobody because no more vehicles may set out, though some are idle."""
        idle = sum(p.vehicle.job is None and not p.soon and not p.vehicle.is_agv for p in asked.prospects)
        if idle > room:
            self._held.update(asked.jobs[column].id for column in np.flatnonzero(plan.vehicle == NOBODY).tolist())

    def _carry_out(self, asked: Asked, plan: Plan) -> None:
        """Give the plan's jobs to vehicles that did not have them; those that had them give them back first."""
        books = self._books
        self._choices = choices = Choices(books, asked, plan, self._reasons.engaged)
        new: list[tuple[VehicleNow, Job, Choice, str]] = []
        room, may_set_out = 0 if self._sliced else GIVEN_AT_ONCE, self._kept_back.room()
        for column, row in enumerate(plan.vehicle.tolist()):
            if row == NOBODY or asked.prospects[row].soon:
                continue
            vehicle, job = asked.prospects[row].vehicle, asked.jobs[column]
            if job.vehicle == vehicle.id or not self._as_weighed(asked, row, job):
                continue
            fresh = vehicle.job is None and job.vehicle is None
            kept_back = fresh and not vehicle.is_agv
            if kept_back and not may_set_out:
                self._held.add(job.id)
                continue
            may_set_out -= kept_back
            if fresh and not room:
                self._pending.append((vehicle, job, column))
            else:
                room -= fresh
                new.append((vehicle, job, choices.of(column), choices.named(column)))
        for vehicle, job, _, _ in new:
            self._missions.give_back(vehicle, f"{vehicle.id} does {job.id} first")
            if job.vehicle:
                self._missions.give_back(books.vehicles[job.vehicle], f"{vehicle.id} is nearer than {job.vehicle}")
        for vehicle, job, choice, named in new:
            self._assign(vehicle, books.jobs[job.id], named, choice)

    def _as_weighed(self, asked: Asked, row: int, job: Job) -> bool:
        """Whether a vehicle and a job are as they were when they were weighed: what comes in between goes before."""
        books, vehicle, column = self._books, asked.prospects[row].vehicle, int(asked.fleet.job[row])
        if books.jobs.get(job.id) is not job or books.controller.state is not ControllerState.AUTO:
            return False
        holder = books.vehicle_of(job)
        if holder is not None and not self._can_switch(holder):
            return False
        if column == NOBODY:
            return self._idle(vehicle)
        return vehicle.job == asked.jobs[column].id and self._can_switch(vehicle)

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
