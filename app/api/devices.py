"""Doors, buffers and chargers: what they are and do, commands to them, and what people decide about them."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import (
    Ctl,
    Person,
    Who,
    answer_view,
    ask,
    items,
    listing,
    live_object,
    missing,
    read,
)
from app.api.declared import gives
from app.api.device_inputs import DeviceCommandIn, PinIn
from app.api.inputs import Limit, PathId, ReasonIn, ServiceIn
from app.api.intents import command_of, commands_of, taken
from app.api.link_frames import frames_of_link
from app.api.port import Controller
from app.domain import device_requests as requests
from app.domain.devices import DeviceId
from app.domain.view import DeviceView, Topic

router = APIRouter(prefix="/devices", tags=["devices"])


def device_named(controller: Controller, device: str) -> DeviceView:
    """Return the device of that name as it is now. Raises Problem: there is none."""
    view = controller.model.get(Topic.DEVICES, device)
    return view if isinstance(view, DeviceView) else missing("device", device)


@router.get("", **gives("Device[]", description="All doors, buffers and chargers; up to 100 ms old."))
async def list_devices(request: Request, controller: Ctl) -> Response:
    """List doors, buffers and chargers as they are now."""
    return listing(request, controller.model.page(Topic.DEVICES))


@router.get("/{device}", **gives("Device"))
async def get_device(device: PathId, request: Request, controller: Ctl) -> Response:
    """Show one device: its state, who is in it or waits for it, what is wrong with it."""
    return live_object(request, controller, Topic.DEVICES, device)


@router.get("/{device}/frames", **gives("Frame[]", description="The last traffic on its link, oldest first."))
async def get_device_frames(
    device: PathId, controller: Ctl, lang: Annotated[Literal["en", "ko"], Query()] = "en"
) -> Response:
    """Show the last bytes on a device's link, explained: its own and those of the others there. A charger has none."""
    view = device_named(controller, device)
    link = next((link for link in controller.plant.links if link.id == view.link), None)
    if link is None:
        return items([])
    return items(await read(frames_of_link, link, list(controller.link_frames(link.id)), lang))


@router.get("/{device}/commands", **gives("Command[]", description="Its commands, newest first."))
async def list_device_commands(device: PathId, controller: Ctl, limit: Limit = 100) -> Response:
    """List what a device was asked and what became of it."""
    return await commands_of(controller, device_named(controller, device).id, limit)


@router.get("/{device}/commands/{command}", **gives("Command"))
async def get_device_command(device: PathId, command: PathId, controller: Ctl) -> Response:
    """Show one command by its 16 hex digits."""
    return await command_of(controller, "device", device, command)


@router.post("/{device}/commands", **gives("DeviceTaken", 202, "Under way; Location says where to look."))
async def command_device(device: PathId, body: DeviceCommandIn, controller: Ctl, actor: Who) -> Response:
    """Open or close a door, lock or unlock a buffer."""
    asked = ask(controller, requests.CommandDevice(actor, DeviceId(device), body.act()))
    return await taken("device", device, asked)


async def _decided(controller: Controller, device: str, request: requests.DeviceOrder) -> Response:
    await ask(controller, request)
    return answer_view(device_named(controller, device))


@router.put("/{device}/pin", **gives("Device"))
async def pin_door(device: PathId, body: PinIn, controller: Ctl, actor: Person) -> Response:
    """Keep a door open or closed, whatever vehicles want."""
    return await _decided(controller, device, requests.PinDoor(actor, DeviceId(device), body.kept(), body.reason))


@router.delete("/{device}/pin", **gives("Device"))
async def unpin_door(device: PathId, controller: Ctl, actor: Person) -> Response:
    """Give a door back to the vehicles."""
    return await _decided(controller, device, requests.UnpinDoor(actor, DeviceId(device)))


@router.post("/{device}/lockout", **gives("Device"))
async def lock_out_device(device: PathId, body: ReasonIn, controller: Ctl, actor: Person) -> Response:
    """People are at the device: no remote command and no grant there until they say so."""
    return await _decided(controller, device, requests.LockOutDevice(actor, DeviceId(device), body.reason))


@router.delete("/{device}/lockout", **gives("Device"))
async def lift_device_lockout(device: PathId, controller: Ctl, actor: Person) -> Response:
    """Lift a lockout: its owner alone, or two others together."""
    return await _decided(controller, device, requests.LiftDeviceLockout(actor, DeviceId(device)))


@router.put("/{device}/service", **gives("Device"))
async def set_device_service(device: PathId, body: ServiceIn, controller: Ctl, actor: Who) -> Response:
    """Take a device out of service, or put it back: a charger, a buffer or a door that vehicles are not to use."""
    return await _decided(controller, device, requests.SetDeviceService(actor, DeviceId(device), body.why_not()))
