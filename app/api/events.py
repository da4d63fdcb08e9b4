"""Durable events: in pages, and as a stream of Server-Sent Events for curl."""

import asyncio
from collections.abc import AsyncIterator, Callable, Sequence
from typing import Annotated

from fastapi import APIRouter, Header, Query
from starlette.requests import HTTPConnection, Request
from starlette.responses import Response, StreamingResponse

from app.api.callers import Callers, caller_of
from app.api.calls import Ctl, items, read
from app.api.declared import gives
from app.api.inputs import After, Limit, QueryId
from app.api.port import Controller
from app.api.problems import Problem
from app.domain.view import EventView, Topic
from app.fleet.views import view_of_event
from app.runtime.hub import Replay, Subscription
from app.runtime.showing import encoded, shown

router = APIRouter(prefix="/events", tags=["events"])
HEARTBEAT = 15.0
"""Seconds of silence after which a comment shows that the stream is alive. Our choice."""


def replay_of(controller: Controller) -> Replay:
    """Return how a subscription reads older events."""

    async def replay(after: int, limit: int) -> Sequence[EventView]:
        return [view_of_event(event) for event in await read(controller.reader.events, after, limit)]

    return replay


def admit(connection: HTTPConnection, controller: Controller) -> None:
    """Let one more watch. Raises Problem: too many do already."""
    if controller.hub.watchers >= connection.app.state.settings.watchers:
        raise Problem("too-many", f"{controller.hub.watchers} watch already.", "Close a page, or raise `watchers`.")


@router.get("", **gives("Event[]", description="Events, oldest first."))
async def list_events(
    controller: Ctl, after: After = 0, limit: Limit = 100, job: QueryId = None, vehicle: QueryId = None
) -> Response:
    """List events above a number; go on with ``after`` = ``next``. A page that is not full has them all.

    A number that no event has yet is refused: it is of another database, and nothing would come for a long time.
    """
    await _known(controller, after, "after")
    events = await read(controller.reader.events, after, limit, job=job, vehicle=vehicle)
    last = events[-1].seq if len(events) == limit else None
    return items((shown(view_of_event(event)) for event in events), last)


async def _known(controller: Controller, after: int, field: str) -> None:
    """Refuse a number that no event has yet, unless it was just kept and is not published so far. Raises Problem."""
    newest = controller.model.last_event
    if after > newest and not await read(controller.reader.events, after - 1, 1):
        remedy = "If the database is another one than before, begin with after=0."
        raise Problem("conflict", f"There is no event {after} yet: the newest is {newest}.", remedy, field)


LastId = Annotated[
    str | None, Header(alias="Last-Event-ID", pattern=r"^[0-9]{1,15}$", description="Resume above this number.")
]
From = Annotated[
    int | None,
    Query(
        ge=0,
        le=(1 << 53) - 1,
        description="Start above this number, else with the next event. One that no event has yet is refused.",
    ),
]


@router.get(
    "/stream",
    responses={
        200: {"description": "Server-Sent Events; the id is the event's number.", "content": {"text/event-stream": {}}}
    },
    response_class=StreamingResponse,
)
async def stream_events(
    request: Request, controller: Ctl, after: From = None, last_event_id: LastId = None
) -> StreamingResponse:
    """Follow events: ``curl -N .../events/stream``. None is left out; a client that reconnects resumes by itself."""
    admit(request, controller)
    start = int(last_event_id) if last_event_id else after
    if start is not None:
        await _known(controller, start, "Last-Event-ID" if last_event_id else "after")
    subscription = controller.hub.subscribe([Topic.EVENTS], after=start, replay=replay_of(controller))
    headers = {"Cache-Control": "no-store", "X-Accel-Buffering": "no"}
    callers: Callers = request.app.state.callers
    give_back = callers.watch(caller_of(request.scope), subscription.close)
    callers.following[subscription.close] = None

    def over() -> None:
        give_back()
        callers.following.pop(subscription.close, None)

    return StreamingResponse(_lines(subscription, over), media_type="text/event-stream", headers=headers)


async def _lines(subscription: Subscription, take_back: Callable[[], None]) -> AsyncIterator[bytes]:
    waiting: asyncio.Future[object] | None = None
    try:
        yield b": events\n\n"
        while True:
            waiting = waiting or asyncio.ensure_future(anext(subscription, None))
            done, _ = await asyncio.wait({waiting}, timeout=HEARTBEAT)
            if not done:
                yield b": alive\n\n"
                continue
            frame, waiting = waiting.result(), None
            if frame is None:
                return
            for event in getattr(frame, "events", ()):
                yield b"id: %d\nevent: %b\ndata: %b\n\n" % (event.seq, event.event.encode(), encoded(event))
    finally:
        take_back()
        subscription.close()
        if waiting is not None:
            waiting.cancel()
