"""Fire and earthquake: told by a named person or host, released by a named person (DOMAIN section 7)."""

from fastapi import APIRouter
from starlette.responses import Response

from app.api.calls import Ctl, Person, answer_view, ask, missing
from app.api.declared import gives
from app.api.device_inputs import EmergencyIn
from app.api.port import Controller
from app.domain.device_requests import RaiseEmergency, ReleaseEmergency
from app.domain.view import Topic

router = APIRouter(prefix="/controller/emergency", tags=["controller"])


def _now(controller: Controller) -> Response:
    views = controller.model.all(Topic.CONTROLLER)
    return answer_view(views[0]) if views else missing("controller", controller.plant.name)


@router.post("", **gives("Controller"))
async def raise_emergency(body: EmergencyIn, controller: Ctl, actor: Person) -> Response:
    """Stop everything where it is, open or close doors as configured, until somebody releases it. Safe to repeat."""
    await ask(controller, RaiseEmergency(actor, body.emergency(), body.reason))
    return _now(controller)


@router.post("/release", **gives("Controller"))
async def release_emergency(body: EmergencyIn, controller: Ctl, actor: Person) -> Response:
    """A named person says that it is over; the controller stays paused until it is resumed."""
    await ask(controller, ReleaseEmergency(actor, body.emergency(), body.reason))
    return _now(controller)
