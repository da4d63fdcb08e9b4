"""Closures: a rail, a station, a zone that vehicles are kept out of, and what closing one would do (DOMAIN sections 1 and 7)."""

from fastapi import APIRouter
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Person, answer_of, ask, items, listing, location, missing, read
from app.api.closure_inputs import ClosureIn, OpenIn, PreviewIn
from app.api.declared import gives
from app.api.inputs import Limit, Older
from app.api.port import Controller
from app.api.problems import Problem, refused
from app.api.teaching_inputs import Number
from app.domain.closures import Closure, OpenPlace
from app.domain.errors import Refusal
from app.domain.layout import Plant
from app.domain.units import Barcode
from app.domain.view import ClosureView, Topic
from app.fleet.closure_preview import ClosurePreview, preview
from app.fleet.views import view_of_closure
from app.runtime.showing import shown

router = APIRouter(prefix="/closures", tags=["closures"])
JOBS_NAMED = 100
"""So many of the jobs that a closure would touch are named. Our choice."""


@router.get("", **gives("Closure[]", description="What is closed now; up to 100 ms old."))
async def list_closures(request: Request, controller: Ctl) -> Response:
    """List the closures in force: each is one reason, and a place opens with the last of its reasons."""
    return listing(request, controller.model.page(Topic.CLOSURES))


@router.post("", **gives("Closure", 201, "It is closed, or drains."))
async def close_place(body: ClosureIn, controller: Ctl, actor: Person) -> Response:
    """Close a place: nobody comes in, those inside drive out, then its state is closed. It outlives restarts."""
    accepted = await ask(controller, body.asked(actor, controller.utc()))
    return await _shown(controller, int(accepted.key), 201)


@router.post("/preview", **gives("ClosurePreview"))
async def preview_closure(body: PreviewIn, controller: Ctl) -> Response:
    """Show what closing a place would do, and change nothing: stations, vehicles, jobs, and how much longer routes get."""
    found = await read(preview, controller.survey(), body.place.place())
    if isinstance(found, Refusal):
        raise refused(found)
    return answer_of(_previewed(controller.plant, found))


@router.get("/history", **gives("Closure[]", description="All closures, newest first."))
async def list_past_closures(controller: Ctl, after: Older = None, limit: Limit = 100) -> Response:
    """List closures, over or not; go on with ``after`` = ``next``."""
    rows = await read(controller.reader.closures, after, limit)
    last = rows[-1].number if len(rows) == limit else None
    return items((shown(_view(controller, row)) for row in rows), last)


@router.get("/{closure}", **gives("Closure"))
async def get_closure(closure: Number, controller: Ctl) -> Response:
    """Show one closure, over or not: who is still inside, and what they wait for."""
    return await _shown(controller, closure)


@router.post("/{closure}/open", **gives("Closure"))
async def open_place(closure: Number, body: OpenIn, controller: Ctl, actor: Person) -> Response:
    """End a closure. One for people's work is opened by its owner alone, or by two others together."""
    await ask(controller, OpenPlace(actor, closure, body.reason))
    return await _shown(controller, closure)


async def open_named(closure: str, body: OpenIn, controller: Ctl, actor: Person) -> Response:
    """End a closure that is named in text, as over the live stream."""
    if not (closure.isascii() and closure.isdigit() and len(closure) < 16):
        raise Problem("invalid", "The target is the number of a closure.", "See GET /api/v1/closures.", "target")
    return await open_place(int(closure), body, controller, actor)


async def _shown(controller: Controller, number: int, status: int = 200) -> Response:
    live = controller.model.get(Topic.CLOSURES, str(number))
    headers = location("closures", str(number)) if status == 201 else None
    if live is not None:
        return answer_of(shown(live), status, headers)
    row = await read(controller.reader.closure, number)
    return answer_of(shown(_view(controller, row)), status, headers) if row else missing("closure", str(number))


def _view(controller: Controller, row: Closure) -> ClosureView:
    live = controller.model.get(Topic.CLOSURES, str(row.number))
    if isinstance(live, ClosureView):
        return live
    served = (s.id for s in controller.plant.stations if s.barcode in row.barcodes or s.id == row.station)
    return view_of_closure(row, tuple(served))


def _previewed(plant: Plant, found: ClosurePreview) -> dict[str, object]:
    names: dict[Barcode, str] = {}
    for station in plant.stations:
        names.setdefault(station.barcode, station.id)
    routes = found.routes
    return {
        "place": str(found.place),
        "barcodes": found.barcodes,
        "stations": found.stations,
        "cut_off": found.cut_off,
        "inside": found.inside,
        "shut_in": found.shut_in,
        "jobs_touched": len(found.jobs),
        "jobs": [{"job": one.job, "why": one.why} for one in found.jobs[:JOBS_NAMED]],
        "routes": {
            "compared": routes.pairs,
            "longer": routes.longer,
            "lost": routes.lost,
            "mean_seconds": round(routes.mean_before, 2),
            "mean_seconds_after": round(routes.mean_after, 2),
            "worst": [
                {
                    "from": names[one.start],
                    "to": names[one.goal],
                    "seconds": round(one.before, 2),
                    "seconds_after": round(one.after, 2),
                }
                for one in routes.worst
            ],
        },
    }
