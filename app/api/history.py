"""Playback: the plant as it was at a moment, what changed in a period, and an incident as one file (DOMAIN section 1)."""

from collections.abc import Iterator
from typing import Annotated, Any

from fastapi import APIRouter, Query
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_of, read
from app.api.declared import gives
from app.api.inputs import Moment
from app.api.periods import Begin, End, Period, period
from app.api.port import Controller
from app.api.problems import Problem
from app.domain.units import Timestamp
from app.fleet.views import view_of_event
from app.runtime.incident import Incident, written
from app.runtime.playback import Playback
from app.runtime.showing import iso, shown

router = APIRouter(prefix="/history", tags=["history"])
HOUR = 3600.0
MOST_EXPORTED = 500_000
"""So many changes, and so many events, go into one file. Our choice."""
At = Annotated[Moment, Query(description="A moment; ISO 8601 with a zone.")]
Place = Annotated[
    int, Query(ge=0, le=(1 << 53) - 1, description="Only what comes after this place; go on with `next`.")
]
Most = Annotated[int, Query(ge=1, le=20_000, description="At most this many.")]
FILE: dict[int | str, dict[str, Any]] = {200: {"description": "The file.", "content": {"application/gzip": {}}}}


def _playback(controller: Controller) -> Playback:
    if controller.playback is None:
        remedy = "Set playback_days to more than 0, and start the server again."
        raise Problem("not-now", "Nothing is recorded for playback.", remedy)
    return controller.playback


@router.get("", **gives("Moment"))
async def show_moment(at: At, controller: Ctl) -> Response:
    """Show the plant as it was at a moment: vehicles, jobs, stations, carriers, devices, closures, alarms."""
    found = await read(_playback(controller).state, at.timestamp())
    if found is None:
        raise Problem("not-found", "Nothing was recorded by then.", "GET /api/v1/history/span says since when.", "at")
    return answer_of({"at": iso(found.at), "objects": found.objects})


@router.get("/span", **gives("Span"))
async def show_span(controller: Ctl) -> Response:
    """Show from when to when there is playback, and how large it is."""
    span = await read(_playback(controller).span)
    begin, end = (None if moment is None else iso(moment) for moment in (span.begin, span.end))
    return answer_of({"from": begin, "to": end, "bytes": span.size})


@router.get("/changes", **gives("PlaybackChange[]", description="Changes after `from` up to `to`, in order."))
async def list_changes(
    controller: Ctl, begin: Begin = None, end: End = None, after: Place = 0, limit: Most = 5000
) -> Response:
    """List what changed in a period (by default the last hour). Of a vehicle a change has only the fields that are other now."""
    asked = period(begin, end, controller.utc(), HOUR)
    changes = await read(lambda: list(_playback(controller).changes(asked.begin, asked.end, after, limit)))
    items = [{"at": iso(at), "topic": topic, "key": key, "value": value} for _, (at, topic, key, value) in changes]
    return answer_of({"items": items, "next": changes[-1][0] if len(changes) == limit else None})


@router.get("/export", responses=FILE, response_class=Response)
async def export_incident(controller: Ctl, actor: Who, begin: Begin = None, end: End = None) -> Response:
    """Give an incident as one file, which `hoistway replay FILE` opens elsewhere: the plant, its state, changes and events."""
    asked = period(begin, end, controller.utc(), HOUR)
    body = await read(lambda: written(_incident(controller, asked, actor)))
    name = f'attachment; filename="incident-{iso(asked.begin)[:19].replace(":", "")}Z.hoistway.gz"'
    return Response(body, headers={"Content-Disposition": name}, media_type="application/gzip")


def _incident(controller: Controller, asked: Period, actor: str) -> Incident:
    playback = _playback(controller)
    start = playback.state(asked.begin)
    first = asked.begin
    if start is None:
        span = playback.span()
        start = playback.state(span.begin) if span.begin is not None and span.begin < asked.end else None
        if start is None:
            raise Problem("not-found", "Nothing was recorded in that time.", "See GET /api/v1/history/span.", "from")
        first = start.at
    changes = [change for _, change in playback.changes(first, asked.end, limit=MOST_EXPORTED + 1)]
    events = list(_events(controller, Period(first, asked.end)))
    if max(len(changes), len(events)) > MOST_EXPORTED:
        raise Problem("invalid", f"More than {MOST_EXPORTED:,} changes in that time.", "Ask for less.", "from")
    made = Timestamp(controller.utc())
    return Incident(controller.plant, first, asked.end, made, actor, start.objects, changes, events)


def _events(controller: Controller, asked: Period) -> Iterator[dict[str, object]]:
    """Give the durable events of a period."""
    after = controller.reader.first_event(asked.begin) - 1
    while page := controller.reader.events(after, 1000):
        for event in page:
            if event.at >= asked.end:
                return
            yield shown(view_of_event(event))
        after = page[-1].seq
