"""What routes share: the controller, who asks, and how answers are made."""

import re
import unicodedata
import zlib
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Annotated, Any, NoReturn, TypeVar
from urllib.parse import quote

from fastapi import Depends, Header
from fastapi.concurrency import run_in_threadpool
from starlette.requests import HTTPConnection, Request
from starlette.responses import Response

from app.api.callers import caller_of
from app.api.port import Controller
from app.api.problems import Problem, refused
from app.domain import requests
from app.domain.access import Caller
from app.domain.drive_requests import Word
from app.domain.errors import Refusal
from app.domain.ids import Actor
from app.domain.view import Topic, View
from app.runtime.controller import ANSWER_WITHIN
from app.runtime.hub import Page
from app.runtime.showing import encode, shown

JSON = "application/json"
MAX_ACTOR = 64

T = TypeVar("T")


async def _controller(connection: HTTPConnection) -> Controller:
    controller: Controller = connection.app.state.controller
    return controller


Ctl = Annotated[Controller, Depends(_controller)]


async def _actor(
    request: Request,
    _x_actor: Annotated[
        str | None, Header(alias="X-Actor", description="Who asks: a person's or a host's name, kept in the audit.")
    ] = None,
) -> Actor:
    return actor_of(request)


async def _person(
    request: Request,
    _x_actor: Annotated[str | None, Header(alias="X-Actor", description="The person who decides; required.")] = None,
) -> Actor:
    if not is_person(caller_of(request.scope), request.headers.get("x-actor")):
        raise Problem("invalid", "A named person has to decide this.", "Send the header X-Actor: NAME.", "X-Actor")
    return actor_of(request)


Who = Annotated[Actor, Depends(_actor)]
Person = Annotated[Actor, Depends(_person)]


def actor_of(request: Request) -> Actor:
    """Return who asks."""
    address = request.client.host if request.client else "unknown"
    return actor_named(request.headers.get("x-actor"), address, caller_of(request.scope))


def is_person(caller: Caller | None, given: str | None) -> bool:
    """Return whether a named person asks: somebody who logged in, or whoever the header X-Actor names."""
    return (caller is not None and caller.person) or bool(given and given.strip())


@lru_cache(maxsize=1000)
def actor_named(given: str | None, address: str, caller: Caller | None = None) -> Actor:
    """Return who asks: a person who logged in; a machine, on behalf of whom the header X-Actor names (UTF-8 read as Latin-1).

    Where nobody has to say who they are, the header alone; without it, the caller's address stands for the name.
    """
    if caller is not None and caller.person:
        return caller.acting("")
    if given is None or not given.strip():
        return Actor(f"anonymous@{address}") if caller is None else caller.acting("")
    try:
        name = given.strip().encode("latin-1").decode("utf-8")
    except UnicodeDecodeError:
        name = given.strip()
    hidden = not name.isascii() and any(unicodedata.category(letter) in {"Cc", "Cf", "Cs"} for letter in name)
    if len(name) > MAX_ACTOR or hidden or (name.isascii() and not name.isprintable()):
        raise Problem(
            "invalid",
            f"X-Actor is a name of at most {MAX_ACTOR} printable characters.",
            "Send a shorter or plainer one.",
            "X-Actor",
        )
    return Actor(name) if caller is None else caller.acting(name)


async def ask(controller: Controller, request: requests.Request) -> requests.Accepted:
    """Put a request to the controller. Raises Problem for a refusal, or if no answer comes in time."""
    try:
        reply = await controller.ask(request)
    except TimeoutError:
        detail = controller.trouble or f"The controller gave no answer within {ANSWER_WITHIN:.0f} s."
        remedy = "Look at the object before asking again; a job is safe to post again under the same id or key."
        raise Problem("unavailable", detail, remedy) from None
    if isinstance(reply, Refusal):
        if controller.trouble and reply.code == "not-now":
            raise Problem("unavailable", controller.trouble, reply.remedy)
        raise refused(reply)
    return reply


def told(controller: Controller, word: Word) -> requests.Accepted:
    """Tell the controller what takes effect at once and changes nothing that is kept. Raises Problem for a refusal."""
    reply = controller.tell(word)
    if isinstance(reply, Refusal):
        raise refused(reply)
    return reply


async def read(call: Callable[..., T], *args: Any, **kwargs: Any) -> T:
    """Ask the store's reading side, in a thread."""
    return await run_in_threadpool(call, *args, **kwargs)


def answer(body: bytes, status: int = 200, headers: dict[str, str] | None = None) -> Response:
    """Return JSON."""
    return Response(body, status, headers, JSON)


def answer_of(value: object, status: int = 200, headers: dict[str, str] | None = None) -> Response:
    """Return anything that encodes to JSON."""
    return answer(encode(value), status, headers)


def answer_view(view: View, status: int = 200, headers: dict[str, str] | None = None) -> Response:
    """Return one view."""
    return answer(encode(shown(view)), status, headers)


def location(*parts: str) -> dict[str, str]:
    """Return the header that says where an object is; ids may hold letters that no header can."""
    return {"Location": "/".join(("/api/v1", *(part if _PLAIN(part) else quote(part, safe=":+@") for part in parts)))}


_PLAIN = re.compile(r"[A-Za-z0-9_.~:+@-]*").fullmatch


def listing(request: Request, page: Page) -> Response:
    """Return a list of the read model, or 304 if the caller has it."""
    return tagged(request, page.etag, page.body)


def tagged(request: Request, etag: str, body: bytes) -> Response:
    """Return a body under its ETag, or 304 if the caller has it."""
    headers = {"ETag": etag, "Cache-Control": "no-cache"}
    have = {tag.strip().removeprefix("W/") for tag in request.headers.get("if-none-match", "").split(",")}
    if etag in have or "*" in have:
        return Response(status_code=304, headers=headers)
    return answer(body, headers=headers)


def live_object(request: Request, controller: Controller, topic: Topic, key: str) -> Response:
    """Return one object of the read model under an ETag. Raises Problem: there is none."""
    raw = controller.model.raw(topic, key)
    if raw is None:
        missing(topic.value.rstrip("s"), key)
    return tagged(request, f'"{zlib.crc32(raw):08x}"', raw)


def items(views: Iterable[dict[str, object]], after: object = None) -> Response:
    """Return a page of history; ``next`` is what to send as ``after`` for more, null at the end."""
    return answer_of({"items": list(views), "next": after})


def missing(kind: str, key: str) -> NoReturn:
    """Say that there is none. Raises Problem always."""
    raise Problem("not-found", f"There is no {kind} {key}.", f"GET /api/v1/{kind}s lists them.")


def version_expected(request: Request) -> int | None:
    """Return the version that If-Match names, None if the caller does not check. Raises Problem: it names none."""
    given = request.headers.get("if-match")
    if given is None or given.strip() == "*":
        return None
    text = given.strip().removeprefix("W/").strip('"')
    if not (text.isascii() and text.isdigit() and len(text) < 10):
        raise Problem("invalid", 'If-Match is the ETag of what was read, such as "3".', field="If-Match")
    return int(text)
