"""The controller as a whole, the layout for drawing, and the kinds of problems."""

import zlib
from itertools import pairwise
from typing import Annotated

from fastapi import APIRouter, Query
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_of, answer_view, ask, items, missing, tagged
from app.api.declared import gives
from app.api.inputs import ID_PATTERN, PathId, ReasonIn
from app.api.port import Controller
from app.api.problems import CODES
from app.domain import requests
from app.domain.layout import LinkSpec, Plant
from app.domain.units import Barcode
from app.domain.view import Topic
from app.runtime.showing import encode

MOST_ROUTES = 8
"""Our choice: so many alternatives take some milliseconds of the event loop in a whole fab."""

controller_routes = APIRouter(prefix="/controller", tags=["controller"])
layout = APIRouter(prefix="/layout", tags=["layout"])
problems = APIRouter(prefix="/problems", tags=["problems"])


def _now(controller: Controller) -> Response:
    views = controller.model.all(Topic.CONTROLLER)
    return answer_view(views[0]) if views else missing("controller", controller.plant.name)


@controller_routes.get("", **gives("Controller"))
async def get_controller(controller: Ctl) -> Response:
    """Show the controller's state, and what it still waits for after a start."""
    return _now(controller)


@controller_routes.post("/pause", **gives("Controller"))
async def pause(body: ReasonIn, controller: Ctl, actor: Who) -> Response:
    """Begin no new movement; what moves comes to rest."""
    await ask(controller, requests.PauseController(actor, body.reason))
    return _now(controller)


@controller_routes.post("/stop", **gives("Controller"))
async def stop_all(body: ReasonIn, controller: Ctl, actor: Who) -> Response:
    """Stop every vehicle that moves where it is, and begin no new movement. Vehicles keep AUTO; resume to go on."""
    await ask(controller, requests.StopAll(actor, body.reason))
    return _now(controller)


@controller_routes.post("/resume", **gives("Controller"))
async def resume(controller: Ctl, actor: Who) -> Response:
    """Go on."""
    await ask(controller, requests.ResumeController(actor))
    return _now(controller)


@layout.get("", **gives("Layout", description="Track, stations, zones and devices for drawing."))
async def get_layout(request: Request, controller: Ctl) -> Response:
    """Show the layout; it changes with the plant file only."""
    state = request.app.state
    if getattr(state, "layout", None) is None:
        body = encode({**_drawn(controller.plant), "version": controller.version})
        state.layout = (f'"{zlib.crc32(body):08x}"', body)
    etag, body = state.layout
    return tagged(request, etag, body)


@layout.get("/routes", **gives("RouteView[]", description="Quickest first; `next` is null."))
async def list_routes(
    controller: Ctl,
    start: Annotated[
        str, Query(alias="from", pattern=ID_PATTERN, max_length=64, description="A station or a barcode.")
    ],
    goal: Annotated[str, Query(alias="to", pattern=ID_PATTERN, max_length=64, description="A station or a barcode.")],
    most: Annotated[int, Query(alias="k", ge=1, le=MOST_ROUTES, description="At most this many.")] = 1,
) -> Response:
    """Show the quickest routes between two places as they would be planned now: around closures, with the present delays."""
    plant = controller.plant
    barcodes = {str(station.id): station.barcode for station in plant.stations}
    lengths = {(edge.start, edge.end): edge.length for edge in plant.edges}
    ends = (barcodes.get(start, Barcode(start)), barcodes.get(goal, Barcode(goal)))
    return items(
        {
            "barcodes": route.barcodes,
            "length": sum(lengths[edge] for edge in pairwise(route.barcodes)),
            "seconds": round(route.seconds, 3),
            "free_flow_seconds": round(route.free_flow, 3),
            "version": route.version,
        }
        for route in controller.routes(*ends, most)
    )


def _drawn(plant: Plant) -> dict[str, object]:
    return {
        "name": plant.name,
        "points": [{"barcode": p.barcode, "x": p.x, "y": p.y, "park": p.park} for p in plant.points],
        "edges": [
            {
                "start": e.start,
                "end": e.end,
                "length": e.length,
                "speed": e.speed,
                "sensor": e.sensor,
                "curve": e.curve,
            }
            for e in plant.edges
        ],
        "stations": [
            {"id": s.id, "kind": s.kind.value, "barcode": s.barcode, "display": s.display, "buffer": s.buffer}
            for s in plant.stations
        ],
        "zones": [
            {
                "id": z.id,
                "name": z.name,
                "barcodes": sorted(z.barcodes),
                "capacity": z.capacity,
                "no_stop": z.no_stop,
                "soft": None if z.meter is None else {"share": z.meter.share, "patience": z.meter.patience},
            }
            for z in plant.zones
        ],
        "vehicles": [
            {
                "id": v.id,
                "kind": v.kind.value,
                "link": v.link,
                "length": v.length,
                "max_speed": v.max_speed,
                "curve_speed": v.curve_speed,
            }
            for v in plant.vehicles
        ],
        **_devices(plant),
    }


def _devices(plant: Plant) -> dict[str, object]:
    return {
        "links": [{"id": n.id, "protocol": n.wire.value, "address": _address(n)} for n in plant.links],
        "doors": [
            {
                "id": d.id,
                "link": d.link,
                "number": d.number,
                "passages": sorted(d.passages),
                "normally_open": d.normally_open,
            }
            for d in plant.doors
        ],
        "buffers": [{"id": b.id, "link": b.link, "number": b.number} for b in plant.buffers],
        "chargers": [{"id": c.id, "barcode": c.barcode, "alias": c.alias} for c in plant.chargers],
        "drives": [
            {"id": d.id, "name": d.name, "line": d.link, "address": d.address, "model": d.model} for d in plant.drives
        ],
    }


def _address(link: LinkSpec) -> str:
    return f"{link.host}:{link.port}" if link.serial is None else link.serial.device


@problems.get("", **gives("ProblemKind[]", description="All kinds of problems."))
async def list_problems() -> Response:
    """List the stable codes of problems."""
    return items({"code": code, "status": status, "title": title} for code, (status, title) in CODES.items())


@problems.get("/{code}", **gives("ProblemKind"))
async def get_problem(code: PathId) -> Response:
    """Show one kind of problem: what a problem's ``type`` leads to."""
    if code not in CODES:
        missing("problem", code)
    status, title = CODES[code]
    return answer_of({"code": code, "status": status, "title": title})
