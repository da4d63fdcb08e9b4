"""Axis drives: what they are and say, keys and inputs, and who has locked them out."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Person, Who, answer_of, answer_view, ask, items, listing, live_object, missing, read
from app.api.declared import gives
from app.api.drive_inputs import Before, InputsIn, KeyIn, Wait
from app.api.inputs import Limit, PathId, ReasonIn
from app.api.link_frames import frames_of_link
from app.api.operations import TAKEN, listed, taken
from app.api.port import Controller
from app.domain import drive_requests as r
from app.domain.drive import DriveId
from app.domain.layout import DriveUnit
from app.domain.view import Topic

router = APIRouter(prefix="/drives", tags=["drives"])
Language = Annotated[Literal["en", "ko"], Query()]


def unit_of(controller: Controller, drive: str) -> DriveUnit:
    """Return the drive of that name. Raises Problem: there is none."""
    unit = controller.plant.drive(DriveId(drive))
    return unit if unit is not None else missing("drive", drive)


@router.get("", **gives("Drive[]", description="All drives; up to 100 ms old."))
async def list_drives(request: Request, controller: Ctl) -> Response:
    """List drives: status, error with its meaning and remedy, whether they move."""
    return listing(request, controller.model.page(Topic.DRIVES))


@router.get("/{drive}", **gives("Drive"))
async def get_drive(drive: PathId, request: Request, controller: Ctl) -> Response:
    """Show one drive."""
    return live_object(request, controller, Topic.DRIVES, drive)


@router.get("/{drive}/frames", **gives("Frame[]", description="The last traffic on its line, oldest first."))
async def get_drive_frames(drive: PathId, controller: Ctl, lang: Language = "en") -> Response:
    """Show the last packets on the drive's line, explained; all drives of a line are heard there."""
    link = controller.plant.link(unit_of(controller, drive).link)
    assert link is not None
    return items(await read(frames_of_link, link, list(controller.link_frames(link.id)), lang))


@router.get("/{drive}/operations", **gives("Operation[]", description="Its operations, newest first."))
async def list_drive_operations(drive: PathId, controller: Ctl, after: Before = None, limit: Limit = 100) -> Response:
    """List what was asked of a drive and what came of it."""
    unit_of(controller, drive)
    return await listed(controller, drive=drive, line=None, after=after, limit=limit)


@router.get("/{drive}/catalogue", **gives("Catalogue"))
async def get_catalogue(drive: PathId, controller: Ctl) -> Response:
    """Show what is known of the parameters of the drive's model."""
    unit = unit_of(controller, drive)
    catalogue = controller.plant.catalogue_of(unit)
    parameters = [
        {
            "number": f"{spec.number:02X}",
            "name": spec.name,
            "unit": spec.unit,
            "scale": spec.scale,
            "lowest": spec.scaled(spec.lowest),
            "highest": spec.scaled(spec.highest),
            "default": None if spec.default is None else spec.scaled(spec.default),
            "read_only": spec.read_only,
            "while_running": spec.while_running,
            "description": spec.description,
            "choices": {str(raw): word for raw, word in spec.choices.items()},
        }
        for spec in catalogue.parameters.values()
    ]
    return answer_of({"model": unit.model, "description": catalogue.description, "parameters": parameters})


@router.post("/{drive}/status", **TAKEN)
async def ask_drive(drive: PathId, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Ask the drive for its status now."""
    return await taken(controller, r.AskDriveStatus(actor, DriveId(drive)), wait)


@router.post("/{drive}/keys", **TAKEN)
async def press_key(drive: PathId, body: KeyIn, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Press a key of the drive's panel once. ``stop_reset`` stops it, and resets an error."""
    return await taken(controller, r.PressDriveKey(actor, DriveId(drive), body.pressed()), wait)


@router.put("/{drive}/inputs", **TAKEN)
async def set_inputs(drive: PathId, body: InputsIn, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Set all inputs of the drive."""
    return await taken(controller, r.SetDriveInputs(actor, DriveId(drive), body.inputs()), wait)


async def _decided(controller: Controller, drive: str, request: r.DriveOrder) -> Response:
    await ask(controller, request)
    view = controller.model.get(Topic.DRIVES, drive)
    return answer_view(view) if view is not None else missing("drive", drive)


@router.post("/{drive}/lockout", **gives("Drive"))
async def lock_drive(drive: PathId, body: ReasonIn, controller: Ctl, actor: Person) -> Response:
    """People are at the axis: nothing but status and stop until they say so. An axis that may move is stopped."""
    return await _decided(controller, drive, r.LockDrive(actor, DriveId(drive), body.reason))


@router.delete("/{drive}/lockout", **gives("Drive"))
async def unlock_drive(drive: PathId, controller: Ctl, actor: Person) -> Response:
    """Lift a lockout: its owner alone, or two others together."""
    return await _decided(controller, drive, r.UnlockDrive(actor, DriveId(drive)))
