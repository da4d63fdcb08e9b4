"""The vehicles and jobs of one assignment as arrays: who can be sent or waited for, how far each is, who cannot (DOMAIN 6)."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from app.domain.ids import JobId, StationId, VehicleId
from app.domain.job import Job, Leg
from app.domain.units import Barcode, Seconds
from app.fleet.books import Books
from app.fleet.servants import Servants
from app.fleet.vehicle import VehicleNow
from app.planning.dispatch import NOBODY, Flags, Floats, Indices, Jobs, Vehicles

SOON = Seconds(30.0)
"""A vehicle that will be free within so long is thought of already (our choice)."""
HANDLING = Seconds(10.0)
"""What a PICKUP or PLACE is expected to take (TRAFFIC section 4); one that takes thrice as long is not reckoned with."""
NEAR = 400
"""So many barcodes at most may lie before a vehicle that will soon be free (our choice)."""


@dataclass(frozen=True, slots=True)
class Prospect:
    """A vehicle that may be sent or waited for: where it can turn to another goal, and the seconds to there.

    ``soon``: it is not free yet.
    """

    vehicle: VehicleNow
    start: Barcode
    offset: float
    soon: bool = False


class Prospects:
    """Finds out when vehicles are where they can turn, and when carriers come."""

    def __init__(self, books: Books) -> None:
        self._books = books

    def of(self, vehicle: VehicleNow) -> Prospect:
        """Return where a vehicle without a carrier can turn: the end of what it is granted."""
        if vehicle.barcode is None:
            raise ValueError(f"{vehicle.id} is idle without a place")
        if not vehicle.ahead:
            return Prospect(vehicle, vehicle.barcode, 0.0)
        graph = self._books.track.graph
        way = pairwise((vehicle.barcode, *vehicle.ahead))
        return Prospect(vehicle, vehicle.ahead[-1], sum(graph.edges[edge]["time"] for edge in way))

    def soon_free(self) -> list[Prospect]:
        """Return the vehicles that put their carrier down soon, with the seconds until they have."""
        found = []
        for vehicle in self._books.vehicles.values():
            job = self._books.job_of(vehicle)
            if job is None or job.leg not in {Leg.TO_DESTINATION, Leg.DEPOSITING}:
                continue
            left = self.until_put_down(vehicle, job)
            if left is not None and left <= SOON:
                found.append(Prospect(vehicle, self._books.specs[job.destination].barcode, left, soon=True))
        return found

    def until_put_down(self, vehicle: VehicleNow, job: Job) -> float | None:
        """Return the seconds until the carrier of a job is at its destination; None: nobody knows.

        Known is it of a vehicle that can go on, for a job that is not about to end otherwise, and at full speed.
        """
        now = self._books.now
        if not vehicle.fit or vehicle.waiting or job.reason or vehicle.barcode is None or vehicle.order:
            return None
        if (handling := vehicle.handling) is not None:
            gone = now - handling.started
            return max(0.0, HANDLING - gone) if gone < 3 * HANDLING and not handling.pickup else None
        if job.leg is not Leg.TO_DESTINATION or len(vehicle.ahead) + len(vehicle.rest) > NEAR:
            return None
        time = self._books.router.time(vehicle.barcode, self._books.specs[job.destination].barcode)
        return time + HANDLING if time < float("inf") else None


class Asked:
    """One assignment's question, and what its indices mean."""

    def __init__(
        self,
        books: Books,
        servants: Servants,
        rows: dict[VehicleId, int],
        prospects: Sequence[Prospect],
        jobs: Sequence[Job],
        coming: dict[JobId, float],
    ) -> None:
        self.prospects = prospects
        self.jobs = jobs
        self._books = books
        self._servants = servants
        self._rows = rows
        self._places: Indices = np.array([rows[p.vehicle.id] for p in prospects], np.intp)
        column = {job.id: at for at, job in enumerate(jobs)}
        held = [NOBODY if p.soon or p.vehicle.job is None else column[p.vehicle.job] for p in prospects]
        self.fleet = Vehicles(
            offset=np.array([p.offset for p in prospects], np.float64),
            job=np.array(held, np.intp),
            soon=np.array([p.soon for p in prospects], np.bool_),
            exempt=np.array([p.vehicle.is_agv for p in prospects], np.bool_),
        )
        self.waiting = Jobs(
            priority=np.array([job.priority for job in jobs], np.intp),
            age=np.array([books.utc - job.created for job in jobs], np.float64),
            ready=np.array([coming.get(job.id, 0.0) for job in jobs], np.float64),
            hot=np.array([job.hot for job in jobs], np.bool_),
        )

    def times(self, rows: Indices, columns: Indices) -> Floats:
        """Return the drive of each vehicle to each source; infinite: it cannot do the job."""
        jobs = [self.jobs[column] for column in columns.tolist()]
        starts = [self.prospects[row].start for row in rows.tolist()]
        goals = [self._books.specs[StationId(job.source)].barcode for job in jobs]
        times = self._books.router.table(starts, goals)
        places = self._places[rows]
        for at, job in enumerate(jobs):
            times[~self._able(job)[places], at] = np.inf
        return times

    def _able(self, job: Job) -> Flags:
        able = self._servants.of(job.source) & self._servants.of(job.destination)
        if job.wish:
            able = able & (np.arange(len(able)) == self._rows.get(job.wish, NOBODY))
        return able
