"""The jobs that have not ended, by what dispatch asks of them: the queue by urgency, and who brings what where."""

from bisect import bisect_left, insort
from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import islice
from typing import TypeAlias, TypeVar

from app.domain.ids import JobId
from app.domain.job import Job, JobState, Leg

Rank: TypeAlias = tuple[int, int, JobId]
"""The less, the sooner: priority (negative), number of acceptance, job."""

_Entry = TypeVar("_Entry", Rank, tuple[int, JobId])

BRINGING = frozenset({Leg.TO_DESTINATION, Leg.DEPOSITING})


class Backlog:
    """All jobs not ended, kept in order as they change: nothing here looks through all of them."""

    def __init__(self, jobs: Iterable[Job]) -> None:
        self.queued: dict[JobId, Job] = {}
        """The jobs that no vehicle has, as they are now."""
        self.under_way: dict[JobId, Job] = {}
        """All others that have not ended."""
        self._brought: dict[str, dict[JobId, Job]] = {}
        self._queue: list[Rank] = []
        self._waiting_at: Counter[str] = Counter()
        self._to: dict[str, list[tuple[int, JobId]]] = {}
        self._line: dict[str, list[Rank]] = {}
        for job in jobs:
            self.note(None, job)

    def note(self, before: Job | None, job: Job) -> bool:
        """Take a job as it is now, and as it was: None, if it is new. Returns whether it has come into the queue."""
        if before is None or before.state.terminal:
            if not job.state.terminal:
                _put_in(self._to.setdefault(job.destination, []), (job.order, job.id))
        elif job.state.terminal or before.destination != job.destination:
            _take_out(self._to, before.destination, (before.order, before.id))
            if not job.state.terminal:
                _put_in(self._to.setdefault(job.destination, []), (job.order, job.id))
        self._note_under_way(job)
        return self._note_queue(job)

    def _note_under_way(self, job: Job) -> None:
        before = self.under_way.get(job.id)
        if (
            before is not None
            and before.leg in BRINGING
            and (job.leg, job.destination)
            != (
                before.leg,
                before.destination,
            )
        ):
            self._brought[before.destination].pop(job.id)
        if job.state.terminal or job.state is JobState.QUEUED:
            self.under_way.pop(job.id, None)
            self._brought.get(job.destination, {}).pop(job.id, None)
            return
        self.under_way[job.id] = job
        if job.leg in BRINGING:
            self._brought.setdefault(job.destination, {})[job.id] = job

    def _note_queue(self, job: Job) -> bool:
        before = self.queued.get(job.id)
        same = before is not None and rank_of(before) == rank_of(job) and _ends(before) == _ends(job)
        if same and job.state is JobState.QUEUED:
            self.queued[job.id] = job
            return False
        if before is not None:
            self._waiting_at.subtract(_ends(before))
            _take_out(self._line, before.destination, rank_of(before))
            del self._queue[bisect_left(self._queue, rank_of(before))]
            del self.queued[before.id]
        if job.state is not JobState.QUEUED:
            return False
        self.queued[job.id] = job
        _put_in(self._queue, rank_of(job))
        _put_in(self._line.setdefault(job.destination, []), rank_of(job))
        self._waiting_at.update(_ends(job))
        return before is None

    # -- what dispatch asks -------------------------------------------------------------------------------------------

    def urgent(self, first: int, most: int) -> list[Job]:
        """Return queued jobs by urgency, from the ``first`` on, at most so many."""
        return [self.queued[name] for _, _, name in islice(self._queue, first, first + most)]

    def waits_at(self, place: str) -> bool:
        """Whether a queued job begins or ends at a place, or may."""
        return self._waiting_at[place] > 0

    def earliest_to(self, place: str) -> tuple[int, JobId] | None:
        """Return which job to a place was accepted first, with its number of acceptance."""
        found = self._to.get(place)
        return found[0] if found else None

    def behind(self, destination: str, rank: Rank, others: int) -> bool:
        """Whether so many queued jobs to a destination come before one of this rank."""
        line = self._line.get(destination, ())
        return len(line) >= others and line[others - 1] < rank

    def bringing(self, place: str) -> Sequence[Job]:
        """Return the jobs whose carrier is on its way to a place, the first accepted first."""
        return sorted(self._brought.get(place, {}).values(), key=lambda job: job.order)


def rank_of(job: Job) -> Rank:
    """Return where a job stands in the queue."""
    return (-job.priority, job.order, job.id)


def _ends(job: Job) -> tuple[str, ...]:
    """Return the places that keep a job from beginning while they are not ready."""
    return (job.source, job.destination, *job.fallbacks)


def _put_in(entries: list[_Entry], entry: _Entry) -> None:
    """Put an entry where it belongs: mostly at the end, since what comes later is mostly accepted later."""
    if not entries or entries[-1] < entry:
        entries.append(entry)
    else:
        insort(entries, entry)


def _take_out(lists: dict[str, list[_Entry]], place: str, entry: _Entry) -> None:
    entries = lists[place]
    del entries[bisect_left(entries, entry)]
    if not entries:
        del lists[place]
