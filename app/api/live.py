"""The live stream: a snapshot, then numbered changes and every event (``openapi/asyncapi.yaml``)."""

import asyncio
import secrets
from collections.abc import Iterable
from contextlib import suppress

import msgspec
from fastapi import APIRouter, WebSocket
from starlette.requests import Request
from starlette.responses import Response
from starlette.websockets import WebSocketDisconnect

from app.api.callers import TICKET_LIFE, Callers, caller_of
from app.api.calls import Ctl, answer_of
from app.api.commands import COMMANDS
from app.api.declared import gives
from app.api.events import admit, replay_of
from app.api.port import Controller
from app.api.problems import Problem
from app.api.queries import wrong
from app.api.spoken import Order, Speaker, Spoken, Voice, error
from app.api.streams import WIRE, WRITABLE
from app.domain.view import Topic
from app.runtime.hub import Subscription
from app.texts import LANGUAGES, Language

router = APIRouter(prefix="/live", tags=["live"])
DEFAULT = frozenset(Topic) - {Topic.COMMANDS, Topic.OPERATIONS, Topic.PARAMETERS}
WORDS_LIMIT = 4096
"""Longest message that a watcher may send, characters."""


class Words(msgspec.Struct, forbid_unknown_fields=True):
    """What a watcher may say."""

    resync: bool = False
    topics: list[str] | None = None
    id: int | str | None = None
    command: Order | None = None
    actor: str | None = None


@router.post("/ticket", **gives("Ticket", 201, "Good once."))
async def give_ticket(request: Request) -> Response:
    """Give a ticket for ``/api/v1/live?ticket=...``: browsers cannot send a key with a WebSocket."""
    callers: Callers = request.app.state.callers
    return answer_of({"ticket": callers.tickets.give(caller_of(request.scope)), "expires_in": TICKET_LIFE}, 201)


def topics_of(names: Iterable[str]) -> frozenset[Topic]:
    """Return topics by their names; none means the usual. Raises Problem: an unknown one."""
    wanted = [name for name in names if name]
    unknown = [name for name in wanted if name not in set(Topic)]
    if unknown:
        known = ", ".join(Topic)
        raise Problem("invalid", f"There is no topic {unknown[0][:40]!r}.", f"There are {known}.", "topics")
    return frozenset(Topic(name) for name in wanted) or DEFAULT


QUERY = dict.fromkeys(("topics", "after", "ticket", "language"), False)
"""What may stand in the address, once each."""


def _language(socket: WebSocket) -> Language:
    """Return the language of refusals: English, unless the address says another (browsers cannot send headers here)."""
    return next((known for known in LANGUAGES if known == socket.query_params.get("language")), "en")


def _started(socket: WebSocket, controller: Controller) -> Subscription:
    admit(socket, controller)
    if problem := wrong(socket.scope["query_string"], QUERY):
        raise problem
    if (language := socket.query_params.get("language")) not in {None, *LANGUAGES}:
        raise Problem(
            "invalid", f"There is no language {str(language)[:40]!r}.", f"There are {', '.join(LANGUAGES)}.", "language"
        )
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
        await socket.send_text(error(problem, language=_language(socket)))
        await socket.close(1008, problem.brief())
        return
    subscription.direct = socket.scope.get("extensions", {}).get(WIRE)
    sender = asyncio.create_task(_send(socket, subscription))
    spoken = _spoken(socket, controller, subscription)
    callers: Callers = socket.app.state.callers
    take_back = callers.watch(caller_of(socket.scope), lambda: _end(socket, subscription))
    try:
        await _listen(socket, subscription, spoken)
    except WebSocketDisconnect:
        pass
    finally:
        take_back()
        subscription.close()
        await spoken.close()
        sender.cancel()
        await asyncio.gather(sender, return_exceptions=True)


_ENDING: set[asyncio.Task[None]] = set()
"""Streams that are being closed, kept until they are."""


def _end(socket: WebSocket, subscription: Subscription) -> None:
    """Close the stream of a watcher who may not watch any more."""

    async def close() -> None:
        with suppress(WebSocketDisconnect, RuntimeError):
            await socket.close(1008, "You have to say who you are again.")

    subscription.close()
    task = asyncio.create_task(close())
    _ENDING.add(task)
    task.add_done_callback(_ENDING.discard)


async def _send(socket: WebSocket, subscription: Subscription) -> None:
    send, direct = socket.send, subscription.direct
    writable = socket.scope.get("extensions", {}).get(WRITABLE)
    try:
        async for frame in subscription:
            if direct is not None and writable is not None:
                await writable()
                if direct(frame.wire):  # what waited is not framed again for each watcher
                    continue
            await send({"type": "websocket.send", "text": frame.text})
    except (WebSocketDisconnect, RuntimeError):
        subscription.close()


def _spoken(socket: WebSocket, controller: Controller, subscription: Subscription) -> Spoken:
    """Return what carries out the commands that come over this socket."""

    async def reply(text: str) -> None:
        try:
            await socket.send_text(text)
        except (WebSocketDisconnect, RuntimeError):
            subscription.close()

    address = socket.client.host if socket.client else "unknown"
    speaker = Speaker(controller, f"live/{secrets.token_hex(8)}")
    voice = Voice(socket.app.state.callers, caller_of(socket.scope), socket.headers.get("x-actor"), address)
    return Spoken(COMMANDS, speaker, voice, reply, _language(socket))


async def _listen(socket: WebSocket, subscription: Subscription, spoken: Spoken) -> None:
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        problem, number = _heard(message.get("text") or message.get("bytes") or b"", subscription, spoken)
        if problem is not None:
            await socket.send_text(error(problem, number, _language(socket)))


def _heard(said: str | bytes, subscription: Subscription, spoken: Spoken) -> tuple[Problem | None, int | str | None]:
    """Take what a watcher says; return what is wrong with it, and the id that it has."""
    remedy = 'Send {"resync": true}, {"topics": ["vehicles"]} or {"id": 1, "command": {...}}.'
    try:
        if len(said) > WORDS_LIMIT:
            return Problem("too-large", f"A message has at most {WORDS_LIMIT} characters.", remedy), None
        words = msgspec.json.decode(said, type=Words)
        if words.command is not None:
            return spoken.take(words.id, words.command, words.actor), words.id
        if words.topics is not None:
            subscription.select(topics_of(words.topics))
        elif words.resync:
            subscription.resync()
        else:
            return Problem("invalid", "The message asks for nothing.", remedy), words.id
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as wrong:
        return Problem("invalid", f"The message is not understood: {wrong}", remedy), None
    except Problem as problem:
        return problem, None
    return None, None
