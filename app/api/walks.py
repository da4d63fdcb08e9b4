"""Audit walks along places: started, entered, compared, accepted by a named person (DOMAIN section 2)."""

from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Person, answer_of, answer_view, ask, items, listing, location, missing, read
from app.api.declared import gives
from app.api.inputs import Id, Limit, Older, PathId, Reason, Strict
from app.api.port import Controller
from app.api.problems import Problem
from app.api.teaching_inputs import Number
from app.domain.ids import CarrierId, StationId
from app.domain.view import StationView, Topic
from app.domain.walks import AbandonWalk, AcceptWalk, EnterSights, Finding, Sight, StartWalk, Walk, WalkPlace
from app.fleet.views import view_of_walk
from app.runtime.showing import iso, shown

router = APIRouter(prefix="/walks", tags=["walks"])


class WalkIn(Strict):
    """Why, and along which stations; none: every side buffer of the plant."""

    reason: Reason
    stations: Annotated[list[Id], Field(max_length=20_000)] = Field(
        default_factory=list, json_schema_extra={"default": []}
    )


class SightIn(Strict):
    """What stands at a place. ``carrier`` null though something is there: its id could not be read."""

    present: bool
    carrier: Id | None = None


class NamedSightIn(SightIn):
    """The same, with the place."""

    station: Id

    def sight(self) -> Sight:
        """Return it in the words of the business."""
        return Sight(StationId(self.station), self.present, CarrierId(self.carrier) if self.carrier else None)


class SightsIn(Strict):
    """What stands at several places: all are entered, or none."""

    sights: Annotated[list[NamedSightIn], Field(min_length=1, max_length=1000)]


class AcceptIn(Strict):
    """``partial``: also if places were not seen, or have changed since: those stay as they are."""

    partial: bool = False


class AbandonIn(Strict):
    """Why nothing is believed for it."""

    reason: Reason


@router.get("", **gives("Walk[]", description="Walks that are open; up to 100 ms old."))
async def list_walks(request: Request, controller: Ctl) -> Response:
    """List the audit walks that are under way."""
    return listing(request, controller.model.page(Topic.WALKS))


@router.post("", **gives("Walk", 201, "It has begun."))
async def start_walk(body: WalkIn, controller: Ctl, actor: Person) -> Response:
    """Begin a walk; what is believed of its places is written down. Vehicles go on meanwhile: what changes is marked moved."""
    accepted = await ask(controller, StartWalk(actor, body.reason, tuple(map(StationId, body.stations))))
    return await _shown(controller, int(accepted.key), 201)


@router.get("/history", **gives("Walk[]", description="All walks, newest first."))
async def list_past_walks(controller: Ctl, after: Older = None, limit: Limit = 100) -> Response:
    """List audit walks, ended or not; go on with ``after`` = ``next``."""
    rows = await read(controller.reader.walks, after, limit)
    views = [await _view(controller, row) for row in rows]
    return items(views, rows[-1].number if len(rows) == limit else None)


@router.get("/{walk}", **gives("Walk"))
async def get_walk(walk: Number, controller: Ctl) -> Response:
    """Show one walk, ended or not."""
    return await _shown(controller, walk)


@router.get("/{walk}/places", **gives("WalkPlace[]", description="Its places, by name."))
async def list_walk_places(
    walk: Number, controller: Ctl, finding: Annotated[Finding | None, Query(description="Only these.")] = None
) -> Response:
    """List the places of a walk: what was believed, what is believed now, what was seen, and what that comes to."""
    places = await read(controller.reader.walk_places, walk)
    if not places:
        missing("walk", str(walk))
    rows = (_place(controller, place) for place in places)
    return items(row for row in rows if finding is None or row["finding"] == finding.value)


@router.put("/{walk}/places/{station}", **gives("Walk"))
async def enter_sight(walk: Number, station: PathId, body: SightIn, controller: Ctl, actor: Person) -> Response:
    """Write down what stands at one place; a later entry replaces the one before."""
    carrier = CarrierId(body.carrier) if body.carrier else None
    await ask(controller, EnterSights(actor, walk, (Sight(StationId(station), body.present, carrier),)))
    return await _shown(controller, walk)


@router.post("/{walk}/places", **gives("Walk"))
async def enter_sights(walk: Number, body: SightsIn, controller: Ctl, actor: Person) -> Response:
    """Write down what stands at several places: all or nothing."""
    await ask(controller, EnterSights(actor, walk, tuple(one.sight() for one in body.sights)))
    return await _shown(controller, walk)


@router.post("/{walk}/accept", **gives("Walk"))
async def accept_walk(walk: Number, body: AcceptIn, controller: Ctl, actor: Person) -> Response:
    """A named person takes what was seen for true: its places and carriers are verified from now on."""
    await ask(controller, AcceptWalk(actor, walk, body.partial))
    return await _shown(controller, walk)


@router.post("/{walk}/abandon", **gives("Walk"))
async def abandon_walk(walk: Number, body: AbandonIn, controller: Ctl, actor: Person) -> Response:
    """End a walk; nothing is believed for it."""
    await ask(controller, AbandonWalk(actor, walk, body.reason))
    return await _shown(controller, walk)


def number_of(target: str) -> int:
    """Return the number of a walk that is named in text, as over the live stream. Raises Problem: it is none."""
    if not (target.isascii() and target.isdigit() and len(target) < 16):
        raise Problem("invalid", "The target is the number of a walk.", "See GET /api/v1/walks.", "target")
    return int(target)


async def _shown(controller: Controller, number: int, status: int = 200) -> Response:
    headers = location("walks", str(number)) if status == 201 else None
    live = controller.model.get(Topic.WALKS, str(number))
    if live is not None:
        return answer_view(live, status, headers)
    row = await read(controller.reader.walk, number)
    return answer_of(await _view(controller, row), status, headers) if row else missing("walk", str(number))


async def _view(controller: Controller, row: Walk) -> dict[str, object]:
    live = controller.model.get(Topic.WALKS, str(row.number))
    if live is not None:
        return shown(live)
    places = await read(controller.reader.walk_places, row.number)
    return shown(view_of_walk(row, len(places), sum(place.seen is not None for place in places)))


def _place(controller: Controller, place: WalkPlace) -> dict[str, object]:
    now = controller.model.get(Topic.STATIONS, place.station)
    station = now if isinstance(now, StationView) else None
    present, carrier, since = (station.present, station.carrier, station.at or 0.0) if station else (None, None, 0.0)
    return {
        "station": place.station,
        "believed": place.believed,
        "believed_carrier": place.believed_carrier,
        "now": present,
        "now_carrier": carrier,
        "seen": place.seen,
        "seen_carrier": place.seen_carrier,
        "by": place.by,
        "at": None if place.at is None else iso(place.at),
        "finding": place.finding(present, carrier, since).value,
    }
