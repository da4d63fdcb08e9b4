"""Jobs that wait for what no driving puts right, such as a source that holds another carrier: after a while each is an alarm."""

from app.domain.alarms import AlarmKind
from app.domain.ids import JobId
from app.domain.job import Job, JobEvent
from app.domain.records import ControllerState
from app.domain.units import Seconds
from app.fleet.books import Books

CODE = "job-waits"


class Overdue:
    """Knows since when queued jobs wait like that. A plant says after how long that is an alarm (``overdue``; 0: never)."""

    def __init__(self, books: Books) -> None:
        self._books = books
        self._since: dict[JobId, Seconds] = {}
        self._next_look = books.now
        alarms = books.alarms.live.values()
        self._told = {JobId(alarm.source) for alarm in alarms if alarm.kind is AlarmKind.JOB}

    def note(self, job: Job, *, lasting: bool) -> None:
        """A queued job was looked at: what keeps it from beginning is ``lasting``, or there is nothing of the kind."""
        if lasting:
            self._since.setdefault(job.id, self._books.now)
        elif self._since.pop(job.id, None) is not None or job.id in self._told:
            self._end(job.id, "it waits for that no more")

    def tick(self) -> None:
        """Once a second: let alarms begin, and end those of jobs that wait no more."""
        books = self._books
        if books.now < self._next_look or books.controller.state is not ControllerState.AUTO:
            return
        self._next_look = Seconds(books.now + 1.0)
        queued = books.backlog.queued
        for name in [name for name in {*self._since, *self._told} if name not in queued]:
            self._since.pop(name, None)
            self._end(name, "it goes on" if name in books.jobs else "it has ended")
        after = books.plant.overdue
        for name, since in self._since.items():
            if after and books.now - since >= after:
                self._begin(queued[name])

    def _begin(self, job: Job) -> None:
        remedy = (
            f"mend that, give it another destination (PATCH /api/v1/jobs/{job.id}), "
            f"or cancel it (POST /api/v1/jobs/{job.id}/cancel)"
        )
        cause = f"{job.id} waits for long: {job.reason}"
        self._books.alarms.begin(AlarmKind.JOB, job.id, CODE, cause, remedy, job.id)
        if job.id not in self._told:
            self._told.add(job.id)
            self._books.event(JobEvent.ALARM_SET, job=job, detail=cause)

    def _end(self, name: JobId, outcome: str) -> None:
        if name in self._told:
            self._told.discard(name)
            self._books.alarms.end(AlarmKind.JOB, name, outcome)
            job = self._books.jobs.get(name) or self._books.ended.get(name)
            self._books.event(JobEvent.ALARM_CLEARED, job=job, source=None if job else name, detail=f"{name} {CODE}")
