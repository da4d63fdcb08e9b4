"""Why-records to rows and back, as ``rows`` does for the other records. One JSON body: it is read whole, by its job alone."""

from dataclasses import replace
from typing import Any

from app.domain.ids import JobId
from app.domain.why import Candidate, Choice, Wait, Why
from app.store.columns import Found, Row, as_json


def why_row(why: Why) -> Row:
    """Columns of ``job_whys``."""
    choices = [
        [
            c.at,
            c.vehicle,
            c.seconds,
            c.priority,
            c.hot,
            c.waited,
            c.switch,
            [[o.vehicle, o.seconds, o.why_not] for o in c.candidates],
            c.before,
            c.saved,
        ]
        for c in why.choices
    ]
    waits = [[w.since, w.reason, w.until] for w in why.waits]
    return why.order, why.job, as_json(choices), as_json(waits), why.left_out


def why(row: Found) -> Why:
    """Undo :func:`why_row`."""
    choices = tuple(_choice(*one) for one in row.choices)
    return Why(row.number, JobId(row.job), choices, tuple(Wait(*wait) for wait in row.waits), row.left_out)


def _choice(*columns: Any) -> Choice:
    *first, others, before, saved = columns
    found = Choice(*first)
    return replace(found, candidates=tuple(Candidate(*other) for other in others), before=before, saved=saved)
