"""Vehicles: what they are and do, commands to them, and what people decide about them."""

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
    version_expected,
)
from app.api.declared import gives
from app.api.frames import explained
from app.api.inputs import (
    DisplayCommand,
    Limit,
    MoveCommand,
    PathId,
    PlainCommand,
    ReasonIn,
    RecoverIn,
    ReleaseIn,
    ServiceIn,
    Target,
    TransferCommand,
)
from app.api.intents import command_of, commands_of, taken
from app.api.port import Controller
from app.api.problems import Problem
from app.api.stations import versions
from app.api.vehicle_commands import CommandIn, VehicleCommand
from app.domain import requests
from app.domain.ids import Actor, StationId, VehicleId
from app.domain.layout import VehicleSpec
from app.domain.units import Barcode
from app.domain.view import Topic

router = APIRouter(prefix="/vehicles", tags=["vehicles"])


def spec_of(controller: Controller, vehicle: str) -> VehicleSpec:
    """Return the vehicle of that name. Raises Problem: there is none."""
    spec = controller.plant.vehicle(VehicleId(vehicle))
    return spec if spec is not None else missing("vehicle", vehicle)


@router.get("", **gives("Vehicle[]", description="All vehicles; up to 100 ms old."))
async def list_vehicles(request: Request, controller: Ctl) -> Response:
    """List vehicles as they are now."""
    return listing(request, controller.model.page(Topic.VEHICLES))


@router.get("/{vehicle}", **gives("Vehicle"))
async def get_vehicle(vehicle: PathId, request: Request, controller: Ctl) -> Response:
    """Show one vehicle with every bit of its status."""
    return live_object(request, controller, Topic.VEHICLES, vehicle)


@router.get("/{vehicle}/frames", **gives("Frame[]", description="The last traffic on its line, oldest first."))
async def get_frames(
    vehicle: PathId, controller: Ctl, lang: Annotated[Literal["en", "ko"], Query()] = "en"
) -> Response:
    """Show the last bytes on a vehicle's line, explained."""
    spec = spec_of(controller, vehicle)
    return items(await read(explained, controller.plant, spec, list(controller.frames(spec.id)), lang))


@router.get("/{vehicle}/commands", **gives("Command[]", description="Its commands, newest first."))
async def list_commands(vehicle: PathId, controller: Ctl, limit: Limit = 100) -> Response:
    """List what was sent to a vehicle and what became of it."""
    return await commands_of(controller, spec_of(controller, vehicle).id, limit)


@router.get("/{vehicle}/commands/{command}", **gives("Command"))
async def get_command(vehicle: PathId, command: PathId, controller: Ctl) -> Response:
    """Show one command by its 16 hex digits."""
    return await command_of(controller, "vehicle", vehicle, command)


@router.post("/{vehicle}/commands", **gives("Taken", 202, "Under way; Location says where to look."))
async def command_vehicle(vehicle: PathId, body: CommandIn, controller: Ctl, actor: Who) -> Response:
    """Send a command to a vehicle."""
    return await _taken(controller, vehicle, _worded(VehicleId(vehicle), body, actor))


def _worded(vehicle: VehicleId, body: VehicleCommand, actor: Actor) -> requests.Request:
    match body:
        case PlainCommand():
            return requests.CommandVehicle(actor, vehicle, body.plain())
        case DisplayCommand():
            return requests.DisplayOnVehicle(actor, vehicle, body.text, body.alarm)
        case MoveCommand():
            return requests.MoveVehicle(actor, vehicle, Barcode(body.barcode), body.stop_action())
        case TransferCommand():
            target = body.target.pulses() if body.target else None
            pickup = body.command == "pickup"
            return requests.HandleOnce(actor, vehicle, StationId(body.station), pickup, target)
        case _:
            return requests.CommandAgv(actor, vehicle, body.worded())


async def _taken(controller: Controller, vehicle: str, request: requests.Request) -> Response:
    return await taken("vehicle", vehicle, ask(controller, request))


@router.post("/{vehicle}/recover", **gives("Taken", 202, "Under way; Location says where to look."))
async def recover_vehicle(vehicle: PathId, body: RecoverIn, controller: Ctl, actor: Who) -> Response:
    """Recover from an alarm: clear, servo on, home, auto, as far as each is safe."""
    return await _taken(controller, vehicle, requests.RecoverAlarm(actor, VehicleId(vehicle), body.confirmed))


async def _decided(controller: Controller, vehicle: str, request: requests.Request) -> Response:
    await ask(controller, request)
    view = controller.model.get(Topic.VEHICLES, vehicle)
    return answer_view(view) if view is not None else missing("vehicle", vehicle)


@router.post("/{vehicle}/park", **gives("Vehicle"))
async def park_vehicle(vehicle: PathId, controller: Ctl, actor: Who) -> Response:
    """Send a vehicle to the nearest free parking place."""
    return await _decided(controller, vehicle, requests.ParkVehicle(actor, VehicleId(vehicle)))


@router.post("/{vehicle}/hold", **gives("Vehicle"))
async def hold_vehicle(vehicle: PathId, body: ReasonIn, controller: Ctl, actor: Who) -> Response:
    """Send nothing more to a vehicle until it is released."""
    return await _decided(controller, vehicle, requests.HoldVehicle(actor, VehicleId(vehicle), body.reason))


@router.post("/{vehicle}/release", **gives("Vehicle"))
async def release_vehicle(vehicle: PathId, body: ReleaseIn, controller: Ctl, actor: Person) -> Response:
    """A named person decides about a held or absent vehicle."""
    if (body.barcode is not None) != (body.verdict == "stands_at"):
        detail = "stands_at needs the barcode, and only stands_at has one."
        raise Problem("invalid", detail, "Send barcode with stands_at, or leave it out.", "barcode")
    barcode = Barcode(body.barcode) if body.barcode else None
    asked = requests.ReleaseVehicle(actor, VehicleId(vehicle), body.decided(), body.reason, barcode)
    return await _decided(controller, vehicle, asked)


@router.post("/{vehicle}/lockout", **gives("Vehicle"))
async def lock_vehicle(vehicle: PathId, body: ReasonIn, controller: Ctl, actor: Person) -> Response:
    """People are at the vehicle: no remote command and no movement until they say so."""
    return await _decided(controller, vehicle, requests.LockVehicle(actor, VehicleId(vehicle), body.reason))


@router.delete("/{vehicle}/lockout", **gives("Vehicle"))
async def unlock_vehicle(vehicle: PathId, controller: Ctl, actor: Person) -> Response:
    """Lift a lockout: its owner alone, or two others together."""
    return await _decided(controller, vehicle, requests.UnlockVehicle(actor, VehicleId(vehicle)))


@router.put("/{vehicle}/service", **gives("Vehicle"))
async def set_service(vehicle: PathId, body: ServiceIn, controller: Ctl, actor: Who) -> Response:
    """Take a vehicle out of service, or put it back."""
    return await _decided(controller, vehicle, requests.SetService(actor, VehicleId(vehicle), body.why_not()))


@router.get(
    "/{vehicle}/offset", **gives("PulsesVersion[]", description="All versions, oldest first; ETag: the newest.")
)
async def list_offsets(vehicle: PathId, controller: Ctl) -> Response:
    """Show a vehicle's OFFSET and its history."""
    spec = spec_of(controller, vehicle)
    return versions(await read(controller.reader.offsets, spec.id))


@router.put("/{vehicle}/offset", **gives("Vehicle"))
async def write_offset(vehicle: PathId, body: Target, request: Request, controller: Ctl, actor: Person) -> Response:
    """Write a new version of a vehicle's OFFSET, as a named person; with If-Match only if nobody else did meanwhile."""
    expected = version_expected(request)
    return await _decided(controller, vehicle, requests.WriteOffset(actor, VehicleId(vehicle), body.pulses(), expected))
