"""``POST /jobs`` without the framework's work per request: the one call that hosts make all day.

It is answered before the routes, and as the route of the same path declares; everything else goes to them.
"""

from typing import cast

from pydantic import ValidationError
from starlette.datastructures import State
from starlette.types import Receive, Scope, Send

from app.api.callers import CALLER
from app.api.calls import actor_named
from app.api.guard import Guard
from app.api.inputs import JobIn
from app.api.jobs import Ordered, create
from app.api.known_jobs import KnownJobs
from app.api.port import Controller
from app.api.problems import CLOSE, Problem, is_json, language_in, ours, problem_of
from app.domain.errors import HoistwayError

PATH = "/api/v1/jobs"
JSON = b"application/json"
_HEAD = (b"content-type", JSON)


class Orders:
    """ASGI application of one call. ``state`` is that of the application, and has the controller."""

    def __init__(self, guard: Guard, state: State) -> None:
        self._guard = guard
        self._state = state
        self._known: KnownJobs | None = None

    @staticmethod
    def take(scope: Scope) -> bool:
        """Return whether this is the call; with a query, which it does not have, the routes say so."""
        whole = scope["type"] == "http" and scope["path"] == PATH and scope["method"] == "POST"
        return bool(whole and not scope["query_string"])

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer an order."""
        try:
            if problem := self._guard.refusal(scope):
                raise problem
            body = await self._body(receive)
            if body is None:
                return
            ordered = await self._order(scope, body)
        except Problem as problem:
            await problem.response(language_in(scope))(scope, receive, send)
        except HoistwayError as error:
            await ours(error).response(language_in(scope))(scope, receive, send)
        else:
            headers = [_HEAD, (b"content-length", b"%d" % len(ordered.body))]
            headers += [(name.lower().encode(), value.encode("latin-1")) for name, value in ordered.place.items()]
            await send({"type": "http.response.start", "status": ordered.status, "headers": headers})
            await send({"type": "http.response.body", "body": ordered.body})

    async def _order(self, scope: Scope, body: bytes) -> Ordered:
        kind, named, key = b"", None, None
        for name, value in scope["headers"]:
            if name == b"content-type":
                kind = kind or value
            elif name == b"x-actor":
                named = value.decode("latin-1") if named is None else named
            elif name == b"idempotency-key":
                key = value.decode("latin-1") if key is None else key
        order = _read(body, kind)
        client = scope.get("client")
        actor = actor_named(named, client[0] if client else "unknown", scope.get(CALLER))
        if key is not None and not (0 < len(key) <= 128 and key.isascii() and key.isprintable() and " " not in key):
            detail = "Idempotency-Key has 1 to 128 printable ASCII characters without blanks."
            raise Problem("invalid", detail, field="Idempotency-Key")
        controller: Controller = self._state.controller
        known = self._known
        if known is None or known.reader is not controller.reader:
            known = self._known = KnownJobs(controller.reader)
        return await create(order, controller, actor, key, known)

    async def _body(self, receive: Receive) -> bytes | None:
        """Return the whole body; None if the caller has gone. Raises Problem: it is larger than allowed."""
        message = await receive()
        parts: list[bytes] = []
        size = 0
        while message["type"] == "http.request":
            part = cast(bytes, message.get("body", b""))
            size += len(part)
            if size > self._guard.limit:
                raise Problem("too-large", f"The body is larger than {self._guard.limit} bytes.", headers=CLOSE)
            more = message.get("more_body", False)
            if not more and not parts:
                return part
            parts.append(part)
            if not more:
                return b"".join(parts)
            message = await receive()
        return None


def _read(body: bytes, content_type: bytes) -> JobIn:
    kind = "" if content_type == JSON else content_type.decode("latin-1")
    if content_type != JSON and not is_json(kind):
        raise Problem(
            "media-type", f"The body came as {kind[:80]!r}.", "Send the header Content-Type: application/json."
        )
    try:
        return JobIn.__pydantic_validator__.validate_json(body)  # type: ignore[no-any-return]
    except ValidationError as error:
        found = [{**e, "loc": ("body", *e["loc"])} for e in error.errors(include_url=False)]
        raise problem_of(found, kind or JSON.decode()) from None
