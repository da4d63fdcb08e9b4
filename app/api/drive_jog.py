"""Jogging: an axis moves as long as the caller says again and again that the key is held."""

import asyncio
from collections.abc import Callable
from typing import NoReturn

from fastapi import APIRouter
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_of, ask, location, told
from app.api.declared import gives
from app.api.drive_inputs import JogIn, PathCount, Wait
from app.api.inputs import PathId
from app.api.operations import TAKEN, answer_operation, ended, operation_of
from app.api.port import Controller
from app.api.problems import Problem
from app.domain import drive_requests as r
from app.domain.drive import DriveId
from app.domain.requests import Accepted
from app.domain.view import OperationView, Topic
from app.fleet.drive_orders import JOG_HOLD

router = APIRouter(prefix="/drives/{drive}/jog", tags=["drives"])


@router.post("", **gives("Jog", 202, "Begun. Say within `hold` seconds that the key is held, again and again."))
async def jog_drive(drive: PathId, body: JogIn, controller: Ctl, actor: Who) -> Response:
    """Begin to jog. The axis stops by itself if the caller does not say in time that the key is still held."""
    return await begun(controller, r.JogDrive(actor, DriveId(drive), body.turn()), lambda jog: None)


async def begun(controller: Controller, request: r.JogDrive, bind: Callable[[int], None]) -> Response:
    """Begin to jog, and let ``bind`` know the jog's number. If the caller has gone before it begins, it never does."""
    asked = asyncio.ensure_future(ask(controller, request))
    try:
        accepted = await asyncio.shield(asked)
    except asyncio.CancelledError:
        asked.add_done_callback(lambda done: _let_go(controller, done))
        raise
    bind(int(accepted.key))
    where = location("drives", request.drive, "jog", accepted.key)
    return answer_of(_held(request.drive, accepted.key), 202, where)


def _let_go(controller: Controller, asked: "asyncio.Future[Accepted]") -> None:
    if not asked.cancelled() and asked.exception() is None:
        controller.tell(r.ReleaseDriveJog(int(asked.result().key)))


def _held(drive: str, jog: str) -> dict[str, object]:
    return {"drive": drive, "jog": jog, "hold": float(JOG_HOLD)}


async def _jog(controller: Controller, drive: str, jog: int) -> OperationView:
    view = await operation_of(controller, jog)
    return view if view.drive == drive and view.kind == "jog" else _no_jog(drive, jog)


def _no_jog(drive: str, jog: int) -> NoReturn:
    raise Problem("not-found", f"{drive} has no jog {jog}.", f"GET /api/v1/drives/{drive}/operations lists them.")


def keep(controller: Controller, drive: str, jog: int) -> None:
    """Say that the key is still held. Raises Problem: the jog is over, or another drive's."""
    view = controller.model.get(Topic.OPERATIONS, str(jog))
    if isinstance(view, OperationView) and view.drive != drive:
        _no_jog(drive, jog)
    told(controller, r.KeepDriveJog(jog))


@router.post("/{jog}", **gives("Jog", description="It goes on for `hold` seconds more."))
async def keep_jog(drive: PathId, jog: PathCount, controller: Ctl) -> Response:
    """Say that the key is still held: five times a second or so. Waits for no disk."""
    keep(controller, drive, jog)
    return answer_of(_held(drive, str(jog)))


@router.get("/{jog}", **gives("Operation"))
async def get_jog(drive: PathId, jog: PathCount, controller: Ctl) -> Response:
    """Show a jog: whether the axis moves (``result.moving``), and why it ended (``result.ended``)."""
    view = await _jog(controller, drive, jog)
    answer = answer_operation(view)
    answer.status_code = 200
    return answer


@router.delete("/{jog}", **TAKEN)
async def release_jog(drive: PathId, jog: PathCount, controller: Ctl, wait: Wait = 0.0) -> Response:
    """Let go of the key; the axis is stopped. Waits for no disk."""
    told(controller, r.ReleaseDriveJog(jog))
    return answer_operation(await ended(controller, jog, wait))
