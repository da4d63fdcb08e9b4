"""Why a job went as it did: its assignments with the candidates, and its waits, as one answer."""

from collections.abc import Iterable

from app.domain.job import Job, JobState
from app.domain.records import HistoryEvent
from app.domain.statistics import MARKS, spent
from app.domain.why import Choice, Wait, Why
from app.runtime.showing import iso

Json = dict[str, object]


def told(job: Job, why: Why | None, events: Iterable[HistoryEvent]) -> Json:
    """Return the answer to "why was this lot late", by what is kept of it and its events; phases as in the statistics."""
    known = why or Why(job.order, job.id)
    return {
        "job": job.id,
        "state": job.state.value,
        "reason": job.reason,
        "created": iso(job.created),
        **_phases(job, events),
        "assignments": [_assignment(choice) for choice in known.choices],
        "waits": [_wait(wait) for wait in known.waits],
        "left_out": known.left_out,
    }


def _phases(job: Job, events: Iterable[HistoryEvent]) -> Json:
    """Return the seconds of each phase; none before the job got the vehicle that it has or had last."""
    names = {event.value: name for name, event in MARKS.items()}
    marks: dict[str, float | None] = {names[one.event]: one.at for one in events if one.event in names}
    if job.state is JobState.QUEUED:
        marks = {}
    found = spent(job.created, marks, job.ended)
    return {phase.value: None if seconds is None else round(seconds, 1) for phase, seconds in found.items()}


def _between(begin: float | None, end: float | None) -> float | None:
    return None if begin is None or end is None else round(end - begin, 1)


def _assignment(choice: Choice) -> Json:
    return {
        "at": iso(choice.at),
        "vehicle": choice.vehicle,
        "seconds": choice.seconds,
        "priority": choice.priority,
        "hot": choice.hot,
        "waited": choice.waited,
        "switch": choice.switch,
        "before": choice.before,
        "saved": choice.saved,
        "candidates": [
            {"vehicle": other.vehicle, "seconds": other.seconds, "why_not": other.why_not}
            for other in choice.candidates
        ],
    }


def _wait(wait: Wait) -> Json:
    return {
        "since": iso(wait.since),
        "until": None if wait.until is None else iso(wait.until),
        "seconds": _between(wait.since, wait.until),
        "reason": wait.reason,
    }
