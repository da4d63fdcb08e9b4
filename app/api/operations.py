"""Operations on drives: what was asked, how far it is, and how it ended."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, Query
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_view, ask, items, live_object, location, missing, read
from app.api.declared import gives
from app.api.drive_inputs import Before, PathCount, Wait
from app.api.inputs import Limit, QueryId
from app.api.port import Controller
from app.domain import drive_requests as r
from app.domain.drive_records import OperationState
from app.domain.view import OperationView, Topic
from app.fleet.drive import view_of_operation
from app.runtime.showing import shown

router = APIRouter(prefix="/operations", tags=["drives"])


async def operation_of(controller: Controller, number: int) -> OperationView:
    """Return an operation, under way or ended. Raises Problem: there is none."""
    live = controller.model.get(Topic.OPERATIONS, str(number))
    if isinstance(live, OperationView):
        return live
    kept = await read(controller.reader.operation, number)
    return view_of_operation(kept) if kept is not None else missing("operation", str(number))


async def ended(controller: Controller, number: int, wait: float) -> OperationView:
    """Return an operation once it has ended, or as it is after so many seconds."""
    try:
        async with asyncio.timeout(wait):
            while (view := await operation_of(controller, number)).state == OperationState.RUNNING:
                await controller.hub.changed(Topic.OPERATIONS, str(number))
    except TimeoutError:
        view = await operation_of(controller, number)
    return view


def answer_operation(view: OperationView) -> Response:
    """Return an operation: 202 while it is under way, 200 with its end; Location says where to look."""
    status = 202 if view.state == OperationState.RUNNING else 200
    return answer_view(view, status, location("operations", view.id))


async def taken(controller: Controller, request: r.DriveOrder, wait: float) -> Response:
    """Ask for an operation, and wait so many seconds for its end."""
    accepted = await ask(controller, request)
    return answer_operation(await ended(controller, int(accepted.key), wait))


TAKEN = gives(
    "Operation", 202, "The operation; 200 if it has ended already. Location says where to look.", Operation=200
)
"""What routes declare that begin an operation."""


async def listed(
    controller: Controller, *, drive: str | None, line: str | None, after: int | None, limit: int
) -> Response:
    """Return a page of operations."""
    rows = await read(controller.reader.operations, drive=drive, line=line, after=after, limit=limit)
    last = rows[-1].number if len(rows) == limit else None
    return items((shown(view_of_operation(row)) for row in rows), last)


@router.get("", **gives("Operation[]", description="Operations, newest first."))
async def list_operations(
    controller: Ctl,
    drive: QueryId = None,
    line: QueryId = None,
    after: Before = None,
    limit: Limit = 100,
) -> Response:
    """List what was asked of drives and what came of it."""
    return await listed(controller, drive=drive, line=line, after=after, limit=limit)


Awaited = Annotated[float, Query(ge=0, le=60, description="Seconds to wait for its end before answering.")]


@router.get("/{operation}", **gives("Operation"))
async def get_operation(operation: PathCount, request: Request, controller: Ctl, wait: Awaited = 0.0) -> Response:
    """Show an operation; ``wait`` for its end if you like."""
    if wait:
        return answer_view(await ended(controller, operation, wait))
    if controller.model.raw(Topic.OPERATIONS, str(operation)) is not None:
        return live_object(request, controller, Topic.OPERATIONS, str(operation))
    return answer_view(await operation_of(controller, operation))


@router.post("/{operation}/cancel", **TAKEN)
async def cancel_operation(operation: PathCount, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Ask nothing more of the drive for it; what was sent already is not undone."""
    await operation_of(controller, operation)
    return await taken(controller, r.CancelDriveOperation(actor, operation), wait)
