"""Zones of the plant: who is in them, and pausing, stopping and resuming one (DOMAIN section 1)."""

from fastapi import APIRouter
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_of, ask, items, missing
from app.api.declared import gives
from app.api.inputs import PathId, ReasonIn
from app.api.port import Controller
from app.domain.ids import ZoneId
from app.domain.layout import Zone
from app.domain.requests import PauseZone, Request, ResumeZone
from app.domain.view import ControllerView, Topic, VehicleView
from app.runtime.showing import shown

router = APIRouter(prefix="/zones", tags=["zones"])


@router.get("", **gives("Zone[]", description="All zones of the plant."))
async def list_zones(controller: Ctl) -> Response:
    """List the plant's zones with who holds track in them, and whether they are paused."""
    return items(_view(controller, zone) for zone in controller.plant.zones)


@router.get("/{zone}", **gives("Zone"))
async def get_zone(zone: PathId, controller: Ctl) -> Response:
    """Show one zone."""
    return _shown(controller, zone)


@router.post("/{zone}/pause", **gives("Zone"))
async def pause_zone(zone: PathId, body: ReasonIn, controller: Ctl, actor: Who) -> Response:
    """Begin no movement in a zone and let nobody in; what moves there comes to rest at the end of its grant."""
    return await _asked(controller, zone, PauseZone(actor, ZoneId(zone), body.reason))


@router.post("/{zone}/stop", **gives("Zone"))
async def stop_zone(zone: PathId, body: ReasonIn, controller: Ctl, actor: Who) -> Response:
    """Pause a zone, and stop what drives there where it is. Vehicles keep AUTO."""
    return await _asked(controller, zone, PauseZone(actor, ZoneId(zone), body.reason, stop=True))


@router.post("/{zone}/resume", **gives("Zone"))
async def resume_zone(zone: PathId, controller: Ctl, actor: Who) -> Response:
    """Let vehicles go on in a zone."""
    return await _asked(controller, zone, ResumeZone(actor, ZoneId(zone)))


async def _asked(controller: Controller, zone: str, request: Request) -> Response:
    await ask(controller, request)
    return _shown(controller, zone)


def _shown(controller: Controller, name: str) -> Response:
    zone = next((zone for zone in controller.plant.zones if zone.id == name), None)
    return answer_of(_view(controller, zone)) if zone is not None else missing("zone", name)


def _view(controller: Controller, zone: Zone) -> dict[str, object]:
    states = (view for view in controller.model.all(Topic.CONTROLLER) if isinstance(view, ControllerView))
    pause = next((p for view in states for p in view.pauses if p.zone == zone.id), None)
    vehicles = (view for view in controller.model.all(Topic.VEHICLES) if isinstance(view, VehicleView))
    inside = [view.id for view in vehicles if not zone.barcodes.isdisjoint((*view.covered, *view.granted))]
    return {
        "id": zone.id,
        "name": zone.name,
        "capacity": zone.capacity,
        "no_stop": zone.no_stop,
        "state": "auto" if pause is None else "stopped" if pause.stopped else "paused",
        "pause": None if pause is None else shown(pause),
        "vehicles": inside,
    }
