"""Why a job went as it did: its assignments with the candidates, and its waits, as one answer."""

from app.domain.job import Job, JobState
from app.domain.why import Choice, Wait, Why
from app.runtime.showing import iso

Json = dict[str, object]


def told(job: Job, why: Why | None) -> Json:
    """Return the answer to "why was this lot late"."""
    known = why or Why(job.order, job.id)
    assigned = _assigned(job, known)
    return {
        "job": job.id,
        "state": job.state.value,
        "reason": job.reason,
        "created": iso(job.created),
        "queued": _between(job.created, assigned),
        "fetching": _between(assigned, job.picked),
        "carrying": _between(job.picked, job.ended),
        "assignments": [_assignment(choice) for choice in known.choices],
        "waits": [_wait(wait) for wait in known.waits],
        "left_out": known.left_out,
    }


def _assigned(job: Job, why: Why) -> float | None:
    """Return when the job got the vehicle that it has or had last; None: it waits for one, perhaps again."""
    if job.state is JobState.QUEUED:
        return None
    return max((choice.at for choice in why.choices), default=job.assigned)


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
