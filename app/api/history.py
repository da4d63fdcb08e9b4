"""Playback: the plant as it was at a moment, what changed in a period, and an incident as one file (DOMAIN section 1)."""

from collections.abc import Iterator
from itertools import islice
from typing import Annotated, Any

from fastapi import APIRouter, Query
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_of, items, read
from app.api.declared import gives
from app.api.inputs import Limit, Moment, QueryId
from app.api.periods import Begin, End, Period, period
from app.api.port import Controller
from app.api.problems import Problem
from app.domain.units import Timestamp
from app.fleet.views import view_of_event
from app.runtime.incident import Incident, written
from app.runtime.playback import Playback
from app.runtime.showing import encode, iso, shown

router = APIRouter(prefix="/history", tags=["history"])
HOUR = 3600.0
MOST_EXPORTED = 500_000
"""So many changes, and so many events, go into one file. Our choice."""
At = Annotated[Moment, Query(description="A moment; ISO 8601 with a zone.")]
Place = Annotated[
    int, Query(ge=0, le=(1 << 53) - 1, description="Only what comes after this place; go on with `next`.")
]
Most = Annotated[int, Query(ge=1, le=20_000, description="At most this many.")]
AfterPiece = Annotated[int | None, Query(ge=0, le=(1 << 53) - 1, description="Only pieces numbered above this.")]
OfNote = Annotated[bool, Query(description="Only what a person would look for: alarms, closures, pauses, what failed.")]
Newest = Annotated[bool, Query(description="The newest before `to` instead of the first after `from`.")]
EVENTS_OF_NOTE = frozenset(
    {
        "AlarmSet",
        "AlarmCleared",
        "VehicleBrokenDown",
        "VehicleMended",
        "VehicleHeld",
        "VehicleReleased",
        "VehicleRemoved",
        "VehicleInstalled",
        "PlaceClosing",
        "PlaceClosed",
        "PlaceOpened",
        "ZonePaused",
        "ZoneResumed",
        "EmergencySet",
        "EmergencyReleased",
        "ControllerPaused",
        "ControllerAuto",
        "DriveErrorSet",
        "DriveErrorCleared",
        "DriveOffline",
        "TransferAbortCompleted",
        "TransferAbortFailed",
        "TransferCancelFailed",
        "TeachingApproved",
    }
)
"""Our choice."""
PIECES: dict[int | str, dict[str, Any]] = {
    200: {"description": "A line of JSON, then the pieces.", "content": {"application/octet-stream": {}}}
}
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
    source = _playback(controller).source
    incident = None if source is None else {"by": source.by, "made": iso(source.made)}
    return answer_of({"from": begin, "to": end, "bytes": span.size, "incident": incident})


@router.get("/heat", **gives("Heat"))
async def show_heat(controller: Ctl, begin: Begin = None, end: End = None) -> Response:
    """Show where vehicles waited and where many came by in a period (by default the last hour), by barcode.

    It is counted by the five minutes: `from` and `to` in the answer say from when to when, and are null where nothing was.
    """
    asked = period(begin, end, controller.utc(), HOUR)
    found = await read(_playback(controller).heat, asked.begin, asked.end)
    if found is None:
        return answer_of({"from": None, "to": None, "waiting": {}, "traffic": {}})
    times = {"from": iso(Timestamp(found.begin)), "to": iso(Timestamp(found.end))}
    return answer_of({**times, "waiting": found.waiting, "traffic": found.traffic})


@router.get("/changes", **gives("PlaybackChange[]", description="Changes after `from` up to `to`, in order."))
async def list_changes(
    controller: Ctl, begin: Begin = None, end: End = None, after: Place = 0, limit: Most = 5000
) -> Response:
    """List what changed in a period (by default the last hour). Of a vehicle a change has only the fields that are other now."""
    asked = period(begin, end, controller.utc(), HOUR)
    changes = await read(lambda: list(_playback(controller).changes(asked.begin, asked.end, after, limit)))
    made = [{"at": iso(at), "topic": topic, "key": key, "value": value} for _, (at, topic, key, value) in changes]
    return answer_of({"items": made, "next": changes[-1][0] if len(changes) == limit else None})


@router.get("/pieces", responses=PIECES, response_class=Response)
async def read_pieces(controller: Ctl, begin: Begin = None, end: End = None, after: AfterPiece = None) -> Response:
    """Give the recording of a period as it is kept, for a player: a line of JSON, then the pieces one after the other.

    The line lists them (`id`, `kind`, `begin`, `end` in UTC seconds, `size` in bytes) and has `more`. Each is JSON under
    zlib: of the kind `state` objects by topic and key, of the kind `changes` a list of [moment, topic, key, value]. The
    first is the newest state that is not after `from`; with `after` they go on after that piece.
    """
    asked = period(begin, end, controller.utc(), HOUR)
    found, more = await read(_playback(controller).pieces, asked.begin, asked.end, after)
    listed = [
        {"id": one.id, "kind": one.kind, "begin": one.begin, "end": one.end, "size": len(one.body)} for one in found
    ]
    head = encode({"items": listed, "more": more})
    return Response(b"".join((head, b"\n", *(one.body for one in found))), media_type="application/octet-stream")


@router.get("/events", **gives("Event[]", description="Events, oldest first."))
async def list_past_events(
    controller: Ctl,
    begin: Begin = None,
    end: End = None,
    *,
    of_note: OfNote = False,
    newest: Newest = False,
    job: QueryId = None,
    vehicle: QueryId = None,
    limit: Limit = 100,
) -> Response:
    """List the events of a period (by default the last hour): the first, or the newest. All of them: `GET /events`."""
    _playback(controller)
    asked = period(begin, end, controller.utc(), HOUR)
    named = EVENTS_OF_NOTE if of_note else None
    found = await read(
        lambda: controller.reader.happened(
            asked.begin, asked.end, named=named, job=job, vehicle=vehicle, newest=newest, limit=limit
        )
    )
    return items(shown(view_of_event(event)) for event in found)


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
    events = list(islice(_events(controller, Period(first, asked.end)), MOST_EXPORTED + 1))
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
