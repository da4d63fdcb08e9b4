"""Logging in and out, who am I, a new password. Tokens are shown once and travel in the header Authorization alone."""

import math
from typing import Annotated

from fastapi import APIRouter
from pydantic import Field, StringConstraints
from starlette.requests import Request
from starlette.responses import Response

from app.api.access_inputs import Password, fitting
from app.api.callers import Callers, caller_of, credential_of
from app.api.calls import Ctl, answer_of, items
from app.api.declared import gives
from app.api.inputs import TEXT_PATTERN, Strict
from app.api.policy import ROUTES
from app.api.port import Controller
from app.api.problems import Problem, refused
from app.domain.access import Caller, Role, Scope, who_may
from app.domain.errors import Refusal
from app.runtime.reception import Given, Reception, Wait
from app.runtime.showing import iso

router = APIRouter(prefix="/session", tags=["session"])
SECRET = {"Cache-Control": "no-store"}
Known = Annotated[
    str, Field(min_length=1, max_length=1000, pattern=TEXT_PATTERN, json_schema_extra={"format": "password"})
]
"""A password that somebody may have."""


class LogInIn(Strict):
    """Name and password of a person."""

    name: Annotated[str, StringConstraints(strict=True, min_length=1, max_length=64, pattern=TEXT_PATTERN)]
    password: Known


class NewPasswordIn(Strict):
    """The old password, and the new one."""

    old: Known
    new: Password


def reception_of(controller: Controller) -> Reception:
    """Return who keeps users and keys. Raises Problem: nobody does."""
    if controller.reception is None:
        raise Problem("not-now", "This server keeps nobody who may log in.", "Keep the plant in a database.")
    return controller.reception


def shown_roles(roles: frozenset[Role]) -> list[str]:
    """Return roles in the order of :class:`Role`."""
    return [role.value for role in Role if role in roles]


def _address(request: Request) -> str:
    return request.client.host if request.client else "unknown"


def _caller(request: Request) -> Caller:
    caller = caller_of(request.scope)
    if caller is None:
        raise Problem("conflict", "Nobody has to log in here, so nobody has.", "Add a user first: POST /api/v1/users.")
    return caller


def _given(given: Given | Refusal | Wait, status: int) -> Response:
    if isinstance(given, Given):
        shown = {"token": given.token, "expires": iso(given.session.expires), "until": iso(given.until)}
        return answer_of(
            {**shown, "name": given.session.user, "roles": shown_roles(given.roles)}, status, headers=SECRET
        )
    raise _why(given)


def _why(reply: Refusal | Wait) -> Problem:
    if isinstance(reply, Refusal):
        return refused(reply)
    seconds = math.ceil(reply.seconds)
    headers = {"Retry-After": str(seconds)}
    return Problem("too-many", "Too many attempts went wrong.", f"Try again in {seconds} s.", headers=headers)


@router.post("", **gives("Session", 201, "The token, shown once."))
async def log_in(body: LogInIn, request: Request, controller: Ctl) -> Response:
    """Log in with name and password. The token goes into the header ``Authorization: Bearer TOKEN``."""
    return _given(await reception_of(controller).log_in(body.name, body.password, _address(request)), 201)


@router.get("", **gives("Caller"))
async def who_am_i(request: Request) -> Response:
    """Show who calls, and what they may."""
    caller = caller_of(request.scope)
    return answer_of(
        {
            "open": caller is None,
            "name": None if caller is None else caller.name,
            "person": caller is not None and caller.person,
            "roles": shown_roles(frozenset(Role) if caller is None else caller.roles),
            "scopes": [scope.value for scope in Scope if caller is None or scope in caller.scopes],
        }
    )


@router.get("/required", **gives("Required"))
async def show_required(request: Request) -> Response:
    """Show whether callers have to say who they are: a page asks for a log-in then, before it asks for anything else."""
    callers: Callers = request.app.state.callers
    return answer_of({"required": callers.closed})


@router.get("/calls", **gives("Call[]", description="Every call of the API; `next` is null."))
async def list_calls(request: Request) -> Response:
    """List every call with the roles that may, and whether the caller may: what a page shows as buttons that can be pressed."""
    caller = caller_of(request.scope)
    return items(
        {
            "call": call,
            "roles": [role.value for role in who_may(scope)],
            "allowed": caller is None or scope in caller.scopes,
        }
        for call, scope in ROUTES.items()
        if scope is not Scope.PUBLIC
    )


@router.post("/renew", **gives("Session", 200, "A new token, shown once."))
async def renew_session(request: Request, controller: Ctl) -> Response:
    """Give a new token for this one, which ends half a minute later."""
    caller = _caller(request)
    token = credential_of(request.headers.get("authorization", ""))
    return _given(await reception_of(controller).renew(caller, token, _address(request)), 200)


@router.delete("", **gives(None, 204, "Logged out."))
async def log_out(request: Request, controller: Ctl) -> Response:
    """Log out: the token, and those that it was renewed from, are good no longer."""
    if refusal := await reception_of(controller).log_out(_caller(request)):
        raise refused(refusal)
    return Response(status_code=204)


@router.put("/password", **gives(None, 204, "The new password holds; other sessions of this person have ended."))
async def change_password(body: NewPasswordIn, request: Request, controller: Ctl) -> Response:
    """Have a new password."""
    caller = _caller(request)
    fitting(body.new, caller.name, "new")
    if reply := await reception_of(controller).change_password(caller, body.old, body.new, _address(request)):
        raise _why(reply)
    return Response(status_code=204)
