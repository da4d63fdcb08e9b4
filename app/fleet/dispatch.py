"""Which vehicle does which job: one assignment over all idle vehicles and all jobs that can begin (DOMAIN section 6)."""

from dataclasses import replace

from app.domain.errors import Refusal
from app.domain.ids import StationId, VehicleId
from app.domain.job import Job, JobEvent, JobState, JobStep, Leg
from app.domain.layout import StationKind
from app.domain.records import ControllerState
from app.domain.units import Barcode
from app.fleet.books import Books
from app.fleet.missions import Missions
from app.fleet.vehicle import VehicleNow
from app.planning.dispatch import assign, cost

AT_MOST = 500
"""So many jobs are looked at in one assignment, the most urgent and oldest first (DOMAIN section 6, TRAFFIC section 6)."""


class Dispatch:
    """Gives queued jobs to idle vehicles."""

    def __init__(self, books: Books, missions: Missions) -> None:
        self._books = books
        self._missions = missions

    def run(self) -> None:
        """Assign what can be assigned now; a job that cannot begin says why."""
        books = self._books
        queued = [job for job in books.jobs.values() if job.state is JobState.QUEUED]
        if not queued or books.controller.state is not ControllerState.AUTO:
            return
        queued.sort(key=lambda job: (-job.priority, job.order))
        ready = self._that_can_begin(queued)[:AT_MOST]
        carriers = [v for v in books.vehicles.values() if v.available]
        vehicles = [v for v in carriers if not self.loaded(v)]
        stations = [job for job in ready if job.source in books.specs]
        pairs = assign(self._costs(vehicles, stations)) if vehicles and stations else []
        for row, column in pairs:
            self._assign(vehicles[row], stations[column])
        for job in ready:
            holder = books.vehicles.get(VehicleId(job.source))
            if holder in carriers:
                self._assign(holder, job)
        self._explain(ready)

    def loaded(self, vehicle: VehicleNow) -> bool:
        """Whether the vehicle has a FOUP aboard, by its own word or by our books."""
        return bool(vehicle.loaded) or bool(vehicle.record.believed_loaded)

    # -- which jobs ---------------------------------------------------------------------------------------------------

    def _that_can_begin(self, queued: list[Job]) -> list[Job]:
        """Return the jobs whose source is full and destination free, as far as is known, one job per station end."""
        active = [job for job in self._books.jobs.values() if job.state is not JobState.QUEUED]
        sources: set[str] = {job.source for job in active if job.leg in {Leg.TO_SOURCE, Leg.ACQUIRING}}
        destinations = {job.destination: job for job in active}
        ready = []
        for job in queued:
            why = self._obstacle(job, sources, destinations)
            if why:
                self._say(job, why)
                continue
            sources.add(job.source)
            destinations[job.destination] = job
            ready.append(job)
        return ready

    def _obstacle(self, job: Job, sources: set[str], destinations: dict[StationId, Job]) -> str:
        """Return why a job cannot begin yet (it is not refused: hosts order ahead, DOMAIN section 2)."""
        if job.destination in destinations:
            return f"{job.destination} is the destination of {destinations[job.destination].id} already"
        if job.source in sources:
            return f"another job is being fetched from {job.source}"
        if why := self._source_obstacle(job):
            return why
        blocked = self._missions.obstacle_at(job.destination, job.id)
        if (
            blocked
            and not self._being_emptied(job.destination)
            and not any(f in self._books.specs and not self._missions.obstacle_at(f, job.id) for f in job.fallbacks)
        ):
            return blocked
        return ""

    def _being_emptied(self, station: StationId) -> bool:
        return any(job.source == station and job.leg is Leg.ACQUIRING for job in self._books.jobs.values())

    def _source_obstacle(self, job: Job) -> str:
        books = self._books
        if job.source in books.vehicles:
            aboard = books.vehicles[VehicleId(job.source)].record
            return "" if aboard.believed_loaded else f"nothing is aboard {job.source}"
        record = books.stations[StationId(job.source)]
        if record.out_of_service:
            return f"{job.source} is out of service: {record.out_of_service}"
        if record.present is False:
            return f"{job.source} is empty"
        if job.carrier and record.carrier and record.carrier != job.carrier:
            return f"{job.source} holds {record.carrier}, not {job.carrier}"
        if record.present is None and job.carrier in books.carriers:
            place = books.carriers[job.carrier].place
            if place is not None and place != job.source:
                return f"{job.carrier} is at {place}, not at {job.source}"
        return ""

    def _say(self, job: Job, why: str) -> None:
        if job.reason != why:
            self._books.save_job(replace(job, reason=why))

    def _explain(self, ready: list[Job]) -> None:
        """Jobs that could begin and got no vehicle say so."""
        for job in ready:
            now = self._books.jobs.get(job.id)
            if now and now.state is JobState.QUEUED:
                wish = f" ({job.wish} is asked for)" if job.wish else ""
                self._say(now, f"no vehicle is free{wish}")

    # -- which vehicle ------------------------------------------------------------------------------------------------

    def _costs(self, vehicles: list[VehicleNow], jobs: list[Job]) -> list[list[float]]:
        """Return the cost of each vehicle (row) for each job (column); infinite where it cannot do it."""
        books = self._books
        starts = [self._start(v) for v in vehicles]
        goals = [books.specs[StationId(job.source)].barcode for job in jobs]
        times = books.router.times(starts, goals)
        return [
            [
                cost(time, books.utc - job.created, job.priority) if self._able(vehicle, job) else float("inf")
                for time, job in zip(row, jobs, strict=True)
            ]
            for vehicle, row in zip(vehicles, times, strict=True)
        ]

    def _start(self, vehicle: VehicleNow) -> Barcode:
        start = vehicle.ahead[-1] if vehicle.ahead else vehicle.barcode
        if start is None:
            raise ValueError(f"{vehicle.id} is idle without a place")
        return start

    def _able(self, vehicle: VehicleNow, job: Job) -> bool:
        """Whether this vehicle may and can serve both ends."""
        if job.wish and job.wish != vehicle.id:
            return False
        ends = [self._books.specs[StationId(s)] for s in (job.source, job.destination) if s in self._books.specs]
        ports = [s for s in ends if s.kind is StationKind.PORT]
        return not any(isinstance(self._missions.target(vehicle, port), Refusal) for port in ports)

    def _assign(self, vehicle: VehicleNow, job: Job) -> None:
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
        books.event(JobEvent.VEHICLE_ASSIGNED, job=job)
        if aboard:
            books.event(JobEvent.TRANSFERRING, job=job)
        self._missions.proceed(vehicle)
        books.wake(vehicle.id)
