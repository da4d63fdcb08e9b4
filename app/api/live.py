"""The live stream: a snapshot, then numbered changes and every event (``openapi/asyncapi.yaml``)."""

import asyncio
from collections.abc import Iterable

import msgspec
from fastapi import APIRouter, WebSocket
from starlette.requests import Request
from starlette.responses import Response
from starlette.websockets import WebSocketDisconnect

from app.api.calls import Ctl, answer_of
from app.api.declared import gives
from app.api.events import admit, replay_of
from app.api.guard import TICKET_LIFE, Tickets
from app.api.port import Controller
from app.api.problems import Problem
from app.domain.view import Topic
from app.runtime.hub import Subscription
from app.runtime.showing import encode

router = APIRouter(prefix="/live", tags=["live"])
DEFAULT = frozenset(Topic) - {Topic.COMMANDS}
WORDS_LIMIT = 4096
"""Longest message that a watcher may send, characters."""


class Words(msgspec.Struct, forbid_unknown_fields=True):
    """What a watcher may say."""

    resync: bool = False
    topics: list[str] | None = None


@router.post("/ticket", **gives("Ticket", 201, "Good once."))
async def give_ticket(request: Request) -> Response:
    """Give a ticket for ``/api/v1/live?ticket=...``: browsers cannot send the access key with a WebSocket."""
    tickets: Tickets = request.app.state.tickets
    return answer_of({"ticket": tickets.give(), "expires_in": TICKET_LIFE}, 201)


def topics_of(names: Iterable[str]) -> frozenset[Topic]:
    """Return topics by their names; none means the usual. Raises Problem: an unknown one."""
    wanted = [name for name in names if name]
    unknown = [name for name in wanted if name not in set(Topic)]
    if unknown:
        known = ", ".join(Topic)
        raise Problem("invalid", f"There is no topic {unknown[0][:40]!r}.", f"There are {known}.", "topics")
    return frozenset(Topic(name) for name in wanted) or DEFAULT


def _started(socket: WebSocket, controller: Controller) -> Subscription:
    admit(socket, controller)
    topics = topics_of(socket.query_params.get("topics", "").split(","))
    text = socket.query_params.get("after")
    if text is not None and not (text.isascii() and text.isdigit() and len(text) <= 15):
        raise Problem("invalid", "after is the number of an event.", "Send the seq of the last event seen.", "after")
    return controller.hub.subscribe(topics, after=int(text) if text else None, replay=replay_of(controller))


@router.websocket("")
async def live(socket: WebSocket, controller: Ctl) -> None:
    """Send the stream until the watcher goes."""
    await socket.accept()
    try:
        subscription = _started(socket, controller)
    except Problem as problem:
        await socket.send_text(_error(problem))
        await socket.close(1008, problem.brief())
        return
    sender = asyncio.create_task(_send(socket, subscription))
    try:
        await _listen(socket, subscription)
    except WebSocketDisconnect:
        pass
    finally:
        subscription.close()
        sender.cancel()
        await asyncio.gather(sender, return_exceptions=True)


async def _send(socket: WebSocket, subscription: Subscription) -> None:
    send = socket.send
    try:
        async for frame in subscription:
            await send({"type": "websocket.send", "text": frame.text})
    except (WebSocketDisconnect, RuntimeError):
        subscription.close()


async def _listen(socket: WebSocket, subscription: Subscription) -> None:
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        problem = _heard(message.get("text") or message.get("bytes") or b"", subscription)
        if problem is not None:
            await socket.send_text(_error(problem))


def _heard(said: str | bytes, subscription: Subscription) -> Problem | None:
    remedy = 'Send {"resync": true} or {"topics": ["vehicles"]}.'
    try:
        if len(said) > WORDS_LIMIT:
            return Problem("too-large", f"A message has at most {WORDS_LIMIT} characters.", remedy)
        words = msgspec.json.decode(said, type=Words)
        if words.topics is not None:
            subscription.select(topics_of(words.topics))
        elif words.resync:
            subscription.resync()
        else:
            return Problem("invalid", "The message asks for nothing.", remedy)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        return Problem("invalid", f"The message is not understood: {error}", remedy)
    except Problem as problem:
        return problem
    return None


def _error(problem: Problem) -> str:
    return encode({"type": "error", "problem": problem.body()}).decode()
