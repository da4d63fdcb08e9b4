"""People who may log in and keys of machines, for administrators."""

from fastapi import APIRouter
from starlette.requests import Request
from starlette.responses import Response

from app.api.access_inputs import MachineKeyIn, Roles, UserChange, UserIn, fitting
from app.api.callers import Callers
from app.api.calls import Ctl, Who, answer_of, items, location, missing
from app.api.declared import gives
from app.api.inputs import PathId
from app.api.problems import Problem, refused
from app.api.sessions import SECRET, reception_of, shown_roles
from app.domain.access import Key, Role, User
from app.domain.errors import Refusal
from app.domain.units import Timestamp
from app.runtime.reception import Reception
from app.runtime.showing import iso

users = APIRouter(prefix="/users", tags=["users"])
keys = APIRouter(prefix="/keys", tags=["keys"])
DAY = 86_400.0

Json = dict[str, object]


def _when(at: Timestamp | None) -> str | None:
    return None if at is None else iso(at)


def _user(user: User) -> Json:
    return {
        "name": user.name,
        "roles": shown_roles(user.roles),
        "created": iso(user.created),
        "created_by": user.created_by,
        "disabled": user.disabled,
        "logged_in": _when(user.logged_in),
    }


def _key(key: Key, now: Timestamp) -> Json:
    over = key.expires is not None and key.expires <= now
    return {
        "name": key.name,
        "roles": shown_roles(key.roles),
        "created": iso(key.created),
        "created_by": key.created_by,
        "expires": _when(key.expires),
        "revoked": _when(key.revoked),
        "used": _when(key.used),
        "state": "revoked" if key.revoked is not None else "expired" if over else "active",
    }


def _now(desk: Reception) -> Timestamp:
    return desk.access.clock.utc()


def _first_is_admin(request: Request, roles: Roles) -> None:
    """From the first user or key on, everybody has to say who they are: somebody must be able to add the others."""
    callers: Callers = request.app.state.callers
    if not callers.closed and Role.ADMIN not in roles:
        detail = "The first user or key has to have the role admin: from then on everybody has to log in."
        raise Problem("conflict", detail, "Add an administrator first.", "roles")


def _accepted(refusal: Refusal | None) -> None:
    if refusal is not None:
        raise refused(refusal)


@users.get("", **gives("User[]", description="All people, by name; `next` is null."))
async def list_users(controller: Ctl) -> Response:
    """List the people who may log in, and those who may not any more."""
    desk = reception_of(controller)
    return items(map(_user, desk.users))


@users.post("", **gives("User", 201))
async def add_user(body: UserIn, request: Request, controller: Ctl, actor: Who) -> Response:
    """Add a person. From the first one on, everybody has to log in."""
    desk = reception_of(controller)
    _first_is_admin(request, body.roles)
    fitting(body.password, body.name)
    _accepted(await desk.add_user(body.name, frozenset(body.roles), body.password, actor))
    return answer_of(_user(_known(desk, body.name)), 201, location("users", body.name))


@users.get("/{user}", **gives("User"))
async def get_user(user: PathId, controller: Ctl) -> Response:
    """Show a person."""
    desk = reception_of(controller)
    return answer_of(_user(_known(desk, user)))


@users.patch("/{user}", **gives("User", description="The person as they are now."))
async def change_user(user: PathId, body: UserChange, controller: Ctl, actor: Who) -> Response:
    """Change roles, disable or enable, give a new password; the last two log the person out."""
    desk = reception_of(controller)
    if not body.model_fields_set:
        raise Problem("invalid", "Nothing to change was named.", "Send roles, disabled or password.")
    if body.password is not None:
        fitting(body.password, user)
    roles = None if body.roles is None else frozenset(body.roles)
    change = {"roles": roles, "disabled": body.disabled, "password": body.password}
    _accepted(await desk.change_user(user, actor, **change))  # type: ignore[arg-type]
    return answer_of(_user(_known(desk, user)))


def _known(desk: Reception, name: str) -> User:
    return desk.user(name) or missing("user", name)


@keys.get("", **gives("Key[]", description="All keys, by name; `next` is null."))
async def list_keys(controller: Ctl) -> Response:
    """List keys, those that have ended too. No key itself is ever shown again."""
    desk = reception_of(controller)
    now = _now(desk)
    return items(_key(key, now) for key in desk.keys)


@keys.post("", **gives("NewKey", 201, "The key, shown once."))
async def add_key(body: MachineKeyIn, request: Request, controller: Ctl, actor: Who) -> Response:
    """Make a key for a machine: 256 random bits, of which a digest is kept."""
    desk = reception_of(controller)
    _first_is_admin(request, body.roles)
    expires = None if body.days is None else Timestamp(_now(desk) + body.days * DAY)
    made = await desk.add_key(body.name, frozenset(body.roles), expires, actor)
    if isinstance(made, Refusal):
        raise refused(made)
    key = desk.key(body.name) or missing("key", body.name)
    return answer_of({**_key(key, _now(desk)), "key": made}, 201, SECRET | location("keys", body.name))


@keys.get("/{key}", **gives("Key"))
async def get_key(key: PathId, controller: Ctl) -> Response:
    """Show what is known of a key."""
    desk = reception_of(controller)
    return answer_of(_key(desk.key(key) or missing("key", key), _now(desk)))


@keys.delete("/{key}", **gives("Key", description="The key as it is now."))
async def revoke_key(key: PathId, controller: Ctl, actor: Who) -> Response:
    """End a key for ever; what it holds open is cut."""
    desk = reception_of(controller)
    _accepted(await desk.revoke_key(key, actor))
    return answer_of(_key(desk.key(key) or missing("key", key), _now(desk)))
