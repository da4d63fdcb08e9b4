"""``POST /jobs`` without the framework's work per request: the one call that hosts make all day.

It stands between the guard and the routes, and answers as the route of the same path declares. Durable jobs are looked up for
many orders at once, as they are committed.
"""

import asyncio
from collections.abc import Sequence

from pydantic import ValidationError
from starlette.datastructures import Headers
from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Receive, Scope, Send

from app.api.calls import actor_named
from app.api.inputs import JobIn
from app.api.jobs import create
from app.api.port import Controller, Reader
from app.api.problems import Problem, is_json, ours, problem_of
from app.domain.errors import HoistwayError
from app.domain.ids import JobId
from app.domain.job import Job

PATH = "/api/v1/jobs"
BATCH = 500
"""Most jobs looked up by one statement."""


class Lookup:
    """Finds jobs that the store has, one statement for all that are asked for while the last one runs."""

    def __init__(self, reader: Reader) -> None:
        self.reader = reader
        self._waiting: list[tuple[JobId, asyncio.Future[Job | None]]] = []
        self._running: asyncio.Task[None] | None = None

    async def job(self, job: JobId) -> Job | None:
        """Return the job, ended or not. Raises StoreError."""
        future: asyncio.Future[Job | None] = asyncio.get_running_loop().create_future()
        self._waiting.append((job, future))
        if self._running is None:
            self._running = asyncio.create_task(self._run())
        return await future

    async def _run(self) -> None:
        batch: list[tuple[JobId, asyncio.Future[Job | None]]] = []
        try:
            while self._waiting:
                batch, self._waiting = self._waiting[:BATCH], self._waiting[BATCH:]
                await self._answer(batch)
        finally:
            self._running = None
            for _, future in batch:
                future.cancel()

    async def _answer(self, batch: Sequence[tuple[JobId, asyncio.Future[Job | None]]]) -> None:
        names = [name for name, _ in batch]
        try:
            found = await asyncio.get_running_loop().run_in_executor(None, self.reader.jobs_named, names)
        except HoistwayError as error:
            for _, future in batch:
                if not future.done():
                    future.set_exception(error)
            return
        jobs = {job.id: job for job in found}
        for name, future in batch:
            if not future.done():
                future.set_result(jobs.get(name))


class Orders:
    """ASGI middleware that answers ``POST /api/v1/jobs``."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app
        self._lookup: Lookup | None = None

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer an order, pass on anything else."""
        if scope["type"] != "http" or scope["path"] != PATH or scope["method"] != "POST":
            await self.app(scope, receive, send)
            return
        try:
            body = await _body(receive)
            if body is None:
                return
            response = await self._order(scope, body)
        except Problem as problem:
            response = problem.response()
        except HoistwayError as error:
            response = ours(error).response()
        except HTTPException as error:
            response = Problem("too-large", str(error.detail)).response()
        await response(scope, receive, send)

    async def _order(self, scope: Scope, body: bytes) -> ASGIApp:
        headers = Headers(scope=scope)
        kind = headers.get("content-type", "")
        order = _read(body, kind)
        client = scope.get("client")
        actor = actor_named(headers.get("x-actor"), client[0] if client else "unknown")
        key = headers.get("idempotency-key")
        if key is not None and not (0 < len(key) <= 128 and key.isascii() and key.isprintable() and " " not in key):
            detail = "Idempotency-Key has 1 to 128 printable ASCII characters without blanks."
            raise Problem("invalid", detail, field="Idempotency-Key")
        controller: Controller = scope["app"].state.controller
        if self._lookup is None or self._lookup.reader is not controller.reader:
            self._lookup = Lookup(controller.reader)
        return await create(order, controller, actor, key, self._lookup.job)


def _read(body: bytes, kind: str) -> JobIn:
    if not is_json(kind):
        raise Problem(
            "media-type", f"The body came as {kind[:80]!r}.", "Send the header Content-Type: application/json."
        )
    try:
        return JobIn.model_validate_json(body)
    except ValidationError as error:
        found = [{**e, "loc": ("body", *e["loc"])} for e in error.errors(include_url=False)]
        raise problem_of(found, kind) from None


async def _body(receive: Receive) -> bytes | None:
    """Return the whole body; None if the caller has gone."""
    message = await receive()
    if message["type"] == "http.request" and not message.get("more_body", False):
        body: bytes = message.get("body", b"")
        return body
    parts: list[bytes] = []
    while message["type"] == "http.request":
        parts.append(message.get("body", b""))
        if not message.get("more_body", False):
            return b"".join(parts)
        message = await receive()
    return None
