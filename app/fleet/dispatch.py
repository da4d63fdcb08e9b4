"""Which vehicle does which job: one assignment over all vehicles that carry nothing and all jobs not picked up (DOMAIN 6)."""

from dataclasses import replace
from itertools import pairwise

from app.domain.errors import Refusal
from app.domain.ids import StationId, VehicleId
from app.domain.job import Job, JobEvent, JobState, JobStep, Leg
from app.domain.records import ControllerState
from app.domain.units import Barcode, Seconds
from app.fleet.books import Books
from app.fleet.kinds import serves
from app.fleet.missions import Missions
from app.fleet.obstacles import against_picking_up, against_putting_down
from app.fleet.targets import target_for
from app.fleet.vehicle import VehicleNow
from app.planning.dispatch import SWITCH, assign, cost

AT_MOST = 500
"""So many jobs are looked at in one assignment, the most urgent and oldest first (DOMAIN section 6, TRAFFIC section 6)."""
MOST_PAIRS = 20_000
"""With more pairs of vehicle and job than this, assignments once made are not thought over (our choice: about 50 ms)."""
RETHINK_EVERY = Seconds(1.0)
"""Assignments once made are thought over at most so often; new jobs and idle vehicles wait for nothing (our choice)."""
CANDIDATES_NAMED = 5
"""So many vehicles are named with the assignment (our choice)."""


class Dispatch:
    """Gives jobs to vehicles, and other ones where that saves more than a switch costs."""

    def __init__(self, books: Books, missions: Missions) -> None:
        self._books = books
        self._missions = missions
        self._served: dict[tuple[VehicleId, str], bool] = {}
        self._taught = books.taught
        self._rethink_at = books.now

    def run(self) -> None:
        """Assign what can be assigned now; a job that cannot begin says why."""
        books = self._books
        if self._taught != books.taught:
            self._served, self._taught = {}, books.taught
        queued = [job for job in books.jobs.values() if job.state is JobState.QUEUED]
        queued.sort(key=lambda job: (-job.priority, job.order))
        if books.controller.state is not ControllerState.AUTO:
            for job in queued:
                self._say(job, f"the controller is {books.controller.state.value}")
            return
        ready = self._that_can_begin(queued)
        for job in ready:
            holder = books.vehicles.get(VehicleId(job.source))
            if holder and holder.available:
                self._assign(holder, job)
        self._fetch([job for job in ready if job.source in books.specs][:AT_MOST])
        self._explain(ready)

    def loaded(self, vehicle: VehicleNow) -> bool:
        """Whether the vehicle has a FOUP aboard, by its own word or by our books."""
        return bool(vehicle.loaded) or bool(vehicle.record.believed_loaded)

    # -- which jobs ---------------------------------------------------------------------------------------------------

    def _that_can_begin(self, queued: list[Job]) -> list[Job]:
        """Return the jobs whose source is full and destination free, as far as is known, one job per station end."""
        if not queued:
            return []
        live = self._books.jobs.values()
        active = [job for job in live if job.state is not JobState.QUEUED]
        sources: set[str] = {job.source for job in active if job.leg in {Leg.TO_SOURCE, Leg.ACQUIRING}}
        emptied: set[str] = {job.source for job in active if job.leg is Leg.ACQUIRING}
        destinations = {job.destination: job for job in active}
        bringing: dict[str, Job] = {}
        for job in sorted(live, key=lambda job: -job.order):
            bringing[job.destination] = job
        ready = []
        for job in queued:
            why = (
                self._taken(job, sources, destinations, bringing) or self._obstacle(job, emptied) or self._hopeless(job)
            )
            if why:
                self._say(job, why)
                continue
            sources.add(job.source)
            destinations[job.destination] = job
            ready.append(job)
        return ready

    def _taken(self, job: Job, sources: set[str], destinations: dict[StationId, Job], bringing: dict[str, Job]) -> str:
        """Return which other job comes first at one of its ends. ``bringing``: the earliest job to each destination."""
        if job.destination in destinations:
            return f"{job.destination} is the destination of {destinations[job.destination].id} already"
        if job.source in sources:
            return f"another job is being fetched from {job.source}"
        first = bringing.get(job.source)
        known = job.source in self._books.stations and self._books.stations[StationId(job.source)].present
        if first and first.order < job.order and not known:
            return f"{first.id} brings a carrier to {job.source} first"
        return ""

    def _hopeless(self, job: Job) -> str:
        """Return why no vehicle will do this job for now; it does not keep its ends from others then."""
        only = self._only(job)
        if only:
            return self._nobody(job) if only.barred or not only.linked or not self._able(only, job) else ""
        if not any(self._able(vehicle, job) for vehicle in self._books.vehicles.values()):
            return "no vehicle can serve both stations: see their DEST, OFFSET and limits"
        return ""

    def _only(self, job: Job) -> VehicleNow | None:
        """Return the one vehicle that may do this job, if there is just one."""
        vehicles = self._books.vehicles
        return vehicles.get(VehicleId(job.source)) or (vehicles.get(job.wish) if job.wish else None)

    def _obstacle(self, job: Job, emptied: set[str]) -> str:
        """Return why a job cannot begin yet (it is not refused: hosts order ahead, DOMAIN section 2)."""
        books = self._books
        if why := against_picking_up(books, job):
            return why
        blocked = against_putting_down(books, job.destination, job.id)
        elsewhere = any(f in books.specs and not against_putting_down(books, f, job.id) for f in job.fallbacks)
        return "" if job.destination in emptied or elsewhere else blocked

    def _say(self, job: Job, why: str) -> None:
        if job.reason != why:
            self._books.save_job(replace(job, reason=why))

    def _explain(self, ready: list[Job]) -> None:
        """Jobs that could begin and got no vehicle say so."""
        for job in ready:
            now = self._books.jobs.get(job.id)
            if now and now.state is JobState.QUEUED:
                self._say(now, self._nobody(now))

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

    def _fetch(self, queued: list[Job]) -> None:
        """Assign vehicles to jobs at stations, and think over every assignment whose carrier is not picked up yet."""
        books = self._books
        vehicles = [v for v in books.vehicles.values() if v.available and not self.loaded(v)]
        engaged = self._engaged_ones(vehicles, queued)
        vehicles = vehicles + engaged
        jobs = queued + [books.jobs[v.job] for v in engaged if v.job]
        if not vehicles or not jobs:
            return
        times = self._times(vehicles, jobs)
        pairs = [(vehicles[row], jobs[column], column) for row, column in assign(self._costs(vehicles, jobs, times))]
        new = [(vehicle, job, column) for vehicle, job, column in pairs if job.vehicle != vehicle.id]
        for vehicle, job, _ in new:
            self._missions.give_back(vehicle, f"{vehicle.id} does {job.id} first")
            if job.vehicle:
                self._missions.give_back(books.vehicles[job.vehicle], f"{vehicle.id} is nearer than {job.vehicle}")
        for vehicle, job, column in new:
            why = self._candidates(vehicles, [row[column] for row in times])
            self._assign(vehicle, books.jobs[job.id], why)

    def _engaged_ones(self, idle: list[VehicleNow], queued: list[Job]) -> list[VehicleNow]:
        """Return the vehicles whose assignment is thought over now: none if that was just done, or if it would take long."""
        if self._books.now < self._rethink_at:
            return []
        engaged = [v for v in self._books.vehicles.values() if self._can_switch(v)]
        if (len(idle) + len(engaged)) * (len(queued) + len(engaged)) > MOST_PAIRS:
            return []
        self._rethink_at = Seconds(self._books.now + RETHINK_EVERY)
        return engaged

    def _can_switch(self, vehicle: VehicleNow) -> bool:
        """Whether the vehicle is only on its way to fetch a carrier."""
        job = self._books.job_of(vehicle)
        return job is not None and job.state is JobState.WAITING and vehicle.fit and not vehicle.handling

    def _times(self, vehicles: list[VehicleNow], jobs: list[Job]) -> list[list[float]]:
        """Return the driving time of each vehicle (row) to each job's source (column); infinite: it cannot do the job."""
        books = self._books
        goals = [books.specs[StationId(job.source)].barcode for job in jobs]
        starts = [self._start(vehicle) for vehicle in vehicles]
        times = books.router.times([barcode for barcode, _ in starts], goals)
        return [
            [before + time if self._able(vehicle, job) else float("inf") for time, job in zip(row, jobs, strict=True)]
            for vehicle, (_, before), row in zip(vehicles, starts, times, strict=True)
        ]

    def _costs(self, vehicles: list[VehicleNow], jobs: list[Job], times: list[list[float]]) -> list[list[float]]:
        now = self._books.utc
        worth = [cost(0.0, now - job.created, job.priority) for job in jobs]
        return [
            [
                time + bonus + SWITCH * (job.vehicle != vehicle.id and bool(job.vehicle or vehicle.job))
                for time, job, bonus in zip(row, jobs, worth, strict=True)
            ]
            for vehicle, row in zip(vehicles, times, strict=True)
        ]

    def _candidates(self, vehicles: list[VehicleNow], times: list[float]) -> str:
        """Return the nearest vehicles that could do a job, with their way to it: why this vehicle (DOMAIN section 6)."""
        able = sorted((time, vehicle.id) for time, vehicle in zip(times, vehicles, strict=True) if time < float("inf"))
        return "to the source: " + ", ".join(f"{name} {time:.0f} s" for time, name in able[:CANDIDATES_NAMED])

    def _start(self, vehicle: VehicleNow) -> tuple[Barcode, float]:
        """Return where the vehicle can turn to another goal, the end of what it is granted, and the seconds to there."""
        if vehicle.barcode is None:
            raise ValueError(f"{vehicle.id} is idle without a place")
        way = [vehicle.barcode, *vehicle.ahead]
        graph = self._books.track.graph
        return way[-1], sum(graph.edges[edge]["time"] for edge in pairwise(way))

    def _able(self, vehicle: VehicleNow, job: Job) -> bool:
        """Whether this vehicle may and can serve both ends."""
        if job.wish and job.wish != vehicle.id:
            return False
        return self._serves(vehicle, job.source) and self._serves(vehicle, job.destination)

    def _serves(self, vehicle: VehicleNow, place: str) -> bool:
        """Whether the vehicle's axes can be sent to this station, found once for what is taught: pairs are many."""
        known = self._served.get((vehicle.id, place))
        if known is None:
            station = self._books.specs.get(StationId(place))
            known = station is None or (
                serves(vehicle, station) and not isinstance(target_for(self._books, vehicle, station), Refusal)
            )
            self._served[vehicle.id, place] = known
        return known

    def _assign(self, vehicle: VehicleNow, job: Job, why: str = "") -> None:
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
        if first:
            books.event(JobEvent.TRANSFER_INITIATED, job=job)
        books.event(JobEvent.VEHICLE_ASSIGNED, job=job, detail=why)
        if aboard:
            books.event(JobEvent.TRANSFERRING, job=job)
        self._missions.proceed(vehicle)
        books.wake(vehicle.id)
