"""Which queued jobs can begin now, looked at by urgency and a few at a time (DOMAIN sections 2 and 6)."""

from collections.abc import Callable, Iterator

from app.domain.ids import JobId
from app.domain.job import Job, JobState, Leg
from app.fleet.backlog import rank_of
from app.fleet.books import Books
from app.fleet.obstacles import (
    against_driving,
    against_fetching,
    against_picking_up,
    against_putting_down,
    bringer,
    brought_first,
    in_line,
)
from app.fleet.overdue import Overdue
from app.fleet.prospects import Prospects
from app.fleet.reasons import Reasons

ENOUGH = 150
"""So many jobs that can begin are found by urgency before those farther behind have their turn (our choice)."""
MOST_URGENT = 400
"""So many jobs are looked at for that, besides all hot lots (our choice: about 8 ms, in slices)."""
IN_TURN = 100
"""And so many of those behind them, in turn: what keeps many urgent ones from beginning keeps no other (our choice)."""
LOOKED_AT_ONCE = 40
"""So many are looked at before others may do something (our choice: about 1 ms)."""


class Look:
    """One look at the queue. ``ready``: the jobs whose source is full and destination free, as far as is known, one job
    per station end; ``coming``: the seconds until the carrier is there, at least, of those among them whose carrier is
    being brought.
    """

    def __init__(
        self,
        books: Books,
        reasons: Reasons,
        prospects: Prospects,
        overdue: Overdue,
        say: Callable[[Job, str], None],
    ) -> None:
        self.ready: list[Job] = []
        self.coming: dict[JobId, float] = {}
        self.seen = 0
        """So many of the queue, by urgency, have been looked at."""
        self._books = books
        self._reasons = reasons
        self._prospects = prospects
        self._overdue = overdue
        self._say = say
        active = books.backlog.under_way.values()
        self._sources: set[str] = {job.source for job in active if job.leg in {Leg.TO_SOURCE, Leg.ACQUIRING}}
        self._emptied: set[str] = {job.source for job in active if job.leg is Leg.ACQUIRING}
        self._destinations: dict[str, Job] = {job.destination: job for job in active}
        self._served = set(self._destinations)
        self._looked_at: set[JobId] = set()

    def by_urgency(self) -> Iterator[None]:
        """Look at jobs by urgency until enough can begin; give after each slice.

        Hot lots are looked at however many there are: no job of lower urgency goes before one that can begin.
        """
        backlog = self._books.backlog
        while jobs := backlog.urgent(self.seen, LOOKED_AT_ONCE):
            if not jobs[0].hot and (self.seen >= MOST_URGENT or len(self.ready) >= ENOUGH):
                return
            self.seen += len(jobs)
            self.at(jobs)
            yield

    def at(self, jobs: list[Job]) -> None:
        """Look at these jobs, each once, though the queue may move between two slices; those that cannot begin say why."""
        for job in jobs:
            if job.id in self._looked_at:
                continue
            self._looked_at.add(job.id)
            why, expected, lasting = self._against(job)
            self._overdue.note(job, lasting=lasting)
            if why:
                self._say(job, why)
                continue
            if expected is not None:
                self.coming[job.id] = expected
            self._sources.add(job.source)
            self._destinations[job.destination] = job
            self.ready.append(job)

    def _against(self, job: Job) -> tuple[str, float | None, bool]:
        """Return why a job cannot begin, or in how many seconds its carrier is there, if it is being brought.

        Besides, whether what keeps it is none of the jobs and vehicles, but something that people or the host must mend.
        """
        books = self._books
        first = "" if job.source in books.vehicles else brought_first(books, job.source, job.order)
        expected = self._expected(job) if first and job.source in self._served else None
        others = first if first and expected is None else self._taken(job)
        if others:
            return others, expected, False
        why = against_picking_up(books, job) if expected is None else against_fetching(books, job)
        why = why or self._blocked(job) or self._reasons.hopeless(job)
        return why or against_driving(books, job), expected, bool(why)

    def _taken(self, job: Job) -> str:
        """Return which other job comes first at one of its ends."""
        holder = self._destinations.get(job.destination)
        if holder is not None:
            before = 2 if holder.state is JobState.QUEUED else 1
            if self._books.backlog.behind(job.destination, rank_of(job), before):
                return in_line(job.destination)
            return f"{job.destination} is the destination of {holder.id} already"
        if job.source in self._sources:
            return f"another job is being fetched from {job.source}"
        return ""

    def _expected(self, job: Job) -> float | None:
        """Return the seconds until the job's carrier is at its source, if it is on its way there; None: nobody knows."""
        first = bringer(self._books, job)
        vehicle = self._books.vehicle_of(first) if first else None
        return self._prospects.until_put_down(vehicle, first) if vehicle and first else None

    def _blocked(self, job: Job) -> str:
        """Return why the carrier could not be put down (it is not refused: hosts order ahead, DOMAIN section 2)."""
        books = self._books
        blocked = against_putting_down(books, job.destination, job.id)
        elsewhere = any(f in books.specs and not against_putting_down(books, f, job.id) for f in job.fallbacks)
        return "" if job.destination in self._emptied or elsewhere else blocked
