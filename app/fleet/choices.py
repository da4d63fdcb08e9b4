"""Why this vehicle: what an assignment was chosen by, in words and figures that are kept with the job (DOMAIN section 6)."""

from collections.abc import Callable
from functools import cached_property

import numpy as np

from app.domain.ids import StationId
from app.domain.job import Job
from app.domain.why import Candidate, Choice
from app.fleet.books import Books
from app.fleet.prospects import Asked
from app.fleet.vehicle import VehicleNow
from app.planning.dispatch import NOBODY, RULES, Floats, Indices, Plan, worth_of_waiting

CANDIDATES_NAMED = 5
"""So many vehicles that could do the job are named with an assignment (our choice)."""
OTHERS_NAMED = 3
"""And so many of the nearest that could not, with the reason."""
FAR = float("inf")


class Choices:
    """Explains the assignments of one plan. ``engaged`` says why a vehicle is not thought of, empty if it could be."""

    def __init__(self, books: Books, asked: Asked, plan: Plan, engaged: Callable[[VehicleNow], str]) -> None:
        self._books = books
        self._asked = asked
        self._plan = plan
        self._engaged = engaged
        self._row = {int(row): at for at, row in enumerate(plan.rows)}
        self._column = {int(column): at for at, column in enumerate(plan.columns)}
        self._does: dict[int, Job] = {
            int(row): asked.jobs[column] for column, row in enumerate(plan.vehicle.tolist()) if row != NOBODY
        }

    def of(self, column: int) -> Choice:
        """Return why the plan's vehicle got this job. Before it is carried out."""
        job, row = self._asked.jobs[column], int(self._plan.vehicle[column])
        arrival = self._plan.arrival[:, self._column[column]]
        seconds = float(arrival[self._row[row]])
        before = self._holder(column)
        gain = FAR if before is None else float(arrival[self._row[before]]) - seconds
        vehicle = self._asked.prospects[row].vehicle
        changes = before is not None or vehicle.job is not None
        age = self._asked.waiting.age[column : column + 1]
        return Choice(
            at=self._books.utc,
            vehicle=vehicle.id,
            seconds=round(seconds, 1),
            priority=job.priority,
            hot=job.hot,
            waited=round(float(worth_of_waiting(age)[0]), 1),
            switch=RULES.switch if changes else 0.0,
            candidates=tuple(self._near(arrival, row, seconds)) + tuple(self._others(job)),
            before=None if before is None else self._asked.prospects[before].vehicle.id,
            saved=round(gain, 1) if gain < FAR else None,
        )

    def named(self, column: int) -> str:
        """Return the nearest vehicles that could do a job with their ways to it, as one line."""
        arrival = self._plan.arrival[:, self._column[column]]
        near = [(self._asked.prospects[int(self._plan.rows[at])], arrival[at]) for at in _nearest(arrival)]
        told = ((f"{seconds:.0f}", prospect.vehicle.id) for prospect, seconds in near if not prospect.soon)
        return "to the source: " + ", ".join(f"{name} {seconds} s" for seconds, name in told)

    def _holder(self, column: int) -> int | None:
        """Return the row of the vehicle that had the job until now."""
        held = np.flatnonzero(self._asked.fleet.job == column)
        return int(held[0]) if len(held) and int(held[0]) in self._row else None

    def _near(
        self, arrival: "np.ndarray[tuple[int], np.dtype[np.float64]]", row: int, seconds: float
    ) -> list[Candidate]:
        found = []
        for at in _nearest(arrival):
            other = int(self._plan.rows[at])
            if other != row:
                why_not = self._why_not(other, float(arrival[at]), seconds)
                vehicle = self._asked.prospects[other].vehicle
                found.append(Candidate(vehicle.id, round(float(arrival[at]), 1), why_not))
        return found

    def _why_not(self, row: int, arrival: float, seconds: float) -> str:
        prospect, does = self._asked.prospects[row], self._does.get(row)
        if prospect.soon:
            return f"is on job {prospect.vehicle.job} for {prospect.offset:.0f} s more"
        if does is not None:
            kept = does.vehicle == prospect.vehicle.id
            return f"keeps {does.id}" if kept else f"does {does.id}"
        return "is farther" if arrival >= seconds else "would have had to be switched for too little"

    @cached_property
    def _left(self) -> tuple[list[VehicleNow], Floats]:
        """The vehicles that were not thought of, with where they are."""
        books = self._books
        thought = {prospect.vehicle.id for prospect in self._asked.prospects}
        left = [v for v in books.vehicles.values() if v.id not in thought and v.barcode in books.track]
        points = [books.track.point(v.barcode) for v in left if v.barcode is not None]
        return left, np.array([[p.x, p.y] for p in points], np.float64).reshape(len(points), 2)

    def _others(self, job: Job) -> list[Candidate]:
        """Return the nearest vehicles that were not thought of, by the way as the crow flies, with the reason and the drive."""
        books, source = self._books, self._books.specs[StationId(job.source)].barcode
        left, places = self._left
        if not left:
            return []
        goal = books.track.point(source)
        away = places - (goal.x, goal.y)
        nearest: Indices = np.argsort((away**2).sum(axis=1), kind="stable")[:OTHERS_NAMED]
        found = []
        for at in nearest.tolist():
            vehicle = left[at]
            time = books.router.time(vehicle.barcode, source) if vehicle.barcode else FAR
            why_not = self._engaged(vehicle) or "is not free"
            found.append(Candidate(vehicle.id, round(time, 1) if time < FAR else None, why_not))
        return found


def _nearest(arrival: "np.ndarray[tuple[int], np.dtype[np.float64]]") -> list[int]:
    """Return the places of the least finite times, least first."""
    order = np.argsort(arrival, kind="stable")[:CANDIDATES_NAMED]
    return [at for at in order.tolist() if arrival[at] < FAR]
