"""Ready frames written past the server's messages: what a slow, a leaving and a compressing watcher gets of them."""

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any, cast

import pytest
from uvicorn import Config
from uvicorn.server import ServerState

from app.api import application
from app.api.streams import Stream
from app.domain import requests as r
from app.runtime.hub import CHANGES_KEPT
from app.settings import Settings
from tests.api.scripted import ACTOR, Scripted

pytestmark = pytest.mark.anyio
REQUEST = (  # names in small letters, as the HTTP side hands them over
    b"GET /api/v1/live?topics=controller HTTP/1.1\r\nhost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
)


class Wire(asyncio.Transport):
    """A transport that keeps what is written to it."""

    def __init__(self) -> None:
        super().__init__({"peername": ("127.0.0.1", 5000), "sockname": ("127.0.0.1", 80)})
        self.written = bytearray()
        self.closed = False

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Keep bytes."""
        self.written += data

    def is_closing(self) -> bool:
        """Whether it was closed."""
        return self.closed

    def close(self) -> None:
        """Close."""
        self.closed = True

    def pause_reading(self) -> None:
        """Nothing is read."""

    def resume_reading(self) -> None:
        """Nothing is read."""

    def messages(self) -> list[dict[str, Any]]:
        """Return and forget the text messages that were written whole, without extensions."""
        data, found = bytes(self.written), []
        self.written.clear()
        if data.startswith(b"HTTP/1.1 101"):
            data = data.partition(b"\r\n\r\n")[2]
        while data:
            assert data[0] == 0x81, "one whole text frame"
            size, head = data[1], 2
            if size >= 126:
                head = 4 if size == 126 else 10
                size = int.from_bytes(data[2:head])
            found.append(json.loads(data[head : head + size]))
            data = data[head + size :]
        return found


async def settle() -> None:
    for _ in range(20):
        await asyncio.sleep(0)


@asynccontextmanager
async def watching(controller: Scripted, *, deflate: bool = False) -> AsyncIterator[tuple[Stream, Wire]]:
    """Give a watcher's connection after its handshake."""
    app = application(controller, Settings(watchers=2))
    config = Config(app, loop="none", lifespan="off", ws_per_message_deflate=deflate, ws_ping_interval=None)
    config.load()
    stream, wire = Stream(config, ServerState(), {}), Wire()
    stream.connection_made(wire)
    extension = b"Sec-WebSocket-Extensions: permessage-deflate\r\n" if deflate else b""
    stream.data_received(REQUEST + extension + b"\r\n")
    await settle()
    try:
        yield stream, wire
    finally:
        stream.writable.set()
        stream.connection_lost(None)
        await settle()


async def change(controller: Scripted, reason: str) -> None:
    await controller.ask(r.PauseController(ACTOR, reason))
    controller.hub.flush()
    await settle()


def reasons(messages: list[dict[str, Any]]) -> list[str]:
    """Return what each message says of the controller; the type of those that say nothing of it."""
    found = []
    for message in messages:
        if message["type"] == "change":
            found.append(message["changes"][-1]["value"]["reason"])
        elif message["type"] == "snapshot":
            found.append("all: " + next(iter(message["objects"]["controller"].values()))["reason"])
        else:
            found.append(message["type"])
    return found


async def test_a_slow_watcher_is_written_nothing_and_gets_the_newest_state_when_it_takes_again(
    controller: Scripted,
) -> None:
    async with watching(controller) as (stream, wire):
        assert [message["type"] for message in wire.messages()] == ["snapshot"]
        await change(controller, "tea")
        assert reasons(wire.messages()) == ["tea"]
        stream.pause_writing()
        for n in range(CHANGES_KEPT + 20):
            await change(controller, f"slow {n}")
        assert not stream.write_frame(b"\x81\x00")
        assert wire.written == b""
        stream.resume_writing()
        await settle()
        caught_up = reasons(wire.messages())
        assert caught_up[-2:] == ["resync", f"all: slow {CHANGES_KEPT + 19}"] or caught_up[-1].endswith(
            f"slow {CHANGES_KEPT + 19}"
        )
        assert len(caught_up) <= CHANGES_KEPT + 3
        await change(controller, "quick again")
        assert reasons(wire.messages()) == ["quick again"]


async def test_a_watcher_that_was_slow_for_a_moment_gets_each_change_in_order(controller: Scripted) -> None:
    async with watching(controller) as (stream, wire):
        numbers = [message["seq"] for message in wire.messages()]
        framed = cast(Any, stream.conn)
        framed.send_text = lambda _: pytest.fail("it was framed again")
        stream.pause_writing()
        await change(controller, "one")
        await change(controller, "two")
        stream.resume_writing()
        await change(controller, "three")
        messages = wire.messages()
        assert reasons(messages) == ["one", "two", "three"]
        numbers += [message["seq"] for message in messages]
        assert numbers == list(range(numbers[0], numbers[0] + 4))


async def test_frames_are_not_written_past_a_watcher_that_compresses(controller: Scripted) -> None:
    async with watching(controller, deflate=True) as (stream, wire):
        assert b"permessage-deflate" in wire.written
        wire.written.clear()
        assert not stream.write_frame(b"\x81\x00")
        await change(controller, "tea")
        assert wire.written[0] & 0x40, "it came compressed, as a message of the server"


async def test_nothing_is_written_to_a_watcher_that_is_leaving_or_has_left(controller: Scripted) -> None:
    async with watching(controller) as (stream, wire):
        assert stream.write_frame(b"\x81\x00")
        await cast(Any, stream.send)({"type": "websocket.close", "code": 1001, "reason": "bye"})
        assert not stream.write_frame(b"\x81\x00")
    wire.written.clear()
    assert not stream.write_frame(b"\x81\x00")
    assert wire.written == b""
