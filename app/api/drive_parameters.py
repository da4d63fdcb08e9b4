"""Parameters of drives: as last known, read, written, watched."""

from fastapi import APIRouter
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_of, answer_view, items, told, version_expected
from app.api.declared import gives
from app.api.drive_inputs import PathNumber, ReadIn, Wait, WatchIn, WriteIn, parameter
from app.api.drives import unit_of
from app.api.inputs import PathId
from app.api.operations import TAKEN, taken
from app.api.problems import Problem
from app.domain import drive_requests as r
from app.domain.drive import DriveId, Parameter, RawValue
from app.domain.drive_records import DriveRecord
from app.domain.ids import Actor
from app.domain.units import Seconds
from app.domain.view import ParameterView, Topic
from app.fleet.drive import DriveNow, view_of_parameter
from app.runtime.showing import shown

router = APIRouter(prefix="/drives/{drive}/parameters", tags=["drives"])
watches = APIRouter(prefix="/drives/{drive}/watches", tags=["drives"])
readings = APIRouter(prefix="/drives/{drive}", tags=["drives"])


@router.get("", **gives("Parameter[]", description="By number: those that the catalogue names, and those read so far."))
async def list_parameters(drive: PathId, controller: Ctl) -> Response:
    """List parameters as last known, each with the moment of its reading."""
    unit_of(controller, drive)
    views = [view for view in controller.model.all(Topic.PARAMETERS) if isinstance(view, ParameterView)]
    mine = sorted((view for view in views if view.drive == drive), key=lambda view: view.number)
    return items(shown(view) for view in mine)


@router.get("/{number}", **gives("Parameter", description="As last known; its ETag serves If-Match of a write."))
async def get_parameter(drive: PathId, number: PathNumber, controller: Ctl) -> Response:
    """Show one parameter as last known. ``raw`` null: it was not read yet."""
    unit = unit_of(controller, drive)
    view = controller.model.get(Topic.PARAMETERS, f"{drive}/{number.upper()}")
    if not isinstance(view, ParameterView):
        unknown = DriveNow(unit, controller.plant.catalogue_of(unit), DriveRecord(unit.id))
        view = view_of_parameter(unknown, parameter(number))
    headers = {} if view.raw is None else {"ETag": f'"{view.raw}"'}
    return answer_view(view, headers=headers)


@readings.post("/read", **TAKEN)
async def read_parameters(drive: PathId, body: ReadIn, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Read parameters from the drive; ``{}`` reads all 256, which takes 8 to 33 s. The operation shows how far it is."""
    return await taken(controller, r.ReadDrive(actor, DriveId(drive), body.numbers()), wait)


@router.post("/{number}/read", **TAKEN)
async def read_parameter(drive: PathId, number: PathNumber, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Read one parameter from the drive."""
    return await taken(controller, r.ReadDrive(actor, DriveId(drive), (parameter(number),)), wait)


@router.put("/{number}", **TAKEN)
async def write_parameter(
    drive: PathId,
    number: PathNumber,
    body: WriteIn,
    request: Request,
    controller: Ctl,
    actor: Who,
    wait: Wait = 0.0,
) -> Response:
    """Write a parameter and read it back; with If-Match only if the drive has what you saw."""
    expected = version_expected(request)
    asked = written(actor, drive, number, body, None if expected is None else RawValue(expected))
    return await taken(controller, asked, wait)


def written(actor: Actor, drive: str, number: str, body: WriteIn, expected: RawValue | None = None) -> r.WriteDrive:
    """Return the request for a write."""
    raw = None if body.raw is None else RawValue(body.raw)
    return r.WriteDrive(actor, DriveId(drive), parameter(number), raw, body.value, body.raw_access, expected)


def watch_name(drive: str, name: str) -> str:
    """Return what a watch over REST is called; those of sockets have names of their own."""
    return f"rest/{drive}/{name}"


@watches.put("/{watch}", **gives("Watch", description="Polled until then; the live topic `parameters` shows them."))
async def watch_parameters(drive: PathId, watch: PathId, body: WatchIn, controller: Ctl) -> Response:
    """Poll parameters for some seconds; the same again goes on, with others it changes. The name is yours."""
    told(
        controller,
        r.WatchDrive(watch_name(drive, watch), DriveId(drive), body.numbers(), Seconds(body.seconds)),
    )
    numbers: list[Parameter] = list(body.numbers())
    return answer_of(
        {"watch": watch, "drive": drive, "parameters": [f"{n:02X}" for n in numbers], "seconds": body.seconds}
    )


@watches.delete("/{watch}", **gives(None, 204, "It is over."))
async def unwatch_parameters(drive: PathId, watch: PathId, controller: Ctl) -> Response:
    """Poll them no more."""
    try:
        told(controller, r.UnwatchDrive(watch_name(drive, watch)))
    except Problem:
        raise Problem("not-found", f"{drive} has no watch {watch}.", "It may be over.") from None
    return Response(status_code=204)
