import asyncio
import socket
from typing import cast

import pytest

from app.domain.units import Seconds
from app.runtime.lines import UNSENT_LIMIT, Line
from app.runtime.sockets import READ, SLICE, Sockets
from tests.runtime.peers import Echo, run, until

MUCH = 50 * READ


def now() -> Seconds:
    return Seconds(asyncio.get_running_loop().time())


class Hall:
    """Lines whose connections are taken over, each served at one port, and what their peers hold."""

    def __init__(self, slice_of: float = SLICE) -> None:
        self.sockets = Sockets(slice_of)
        self.echoes: list[Echo] = []
        self.lines: list[Line] = []

    def add(self) -> Line:
        self.echoes.append(Echo())
        self.lines.append(Line(self.echoes[-1], now, sockets=self.sockets))
        return self.lines[-1]

    async def serve(self) -> None:
        self.server = await asyncio.get_running_loop().create_server(self.add, "127.0.0.1", 0)
        self.address = self.server.sockets[0].getsockname()

    async def dial(self) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
        count = len(self.lines)
        peer = await asyncio.open_connection(*self.address)
        await until(lambda: len(self.lines) > count and self.lines[-1].up)
        return peer

    async def close(self) -> None:
        self.server.close()
        self.sockets.close()
        await until(lambda: not any(line.up for line in self.lines))


@pytest.mark.parametrize("slice_of", [SLICE, -1.0], ids=["in a slice", "some a turn"])
def test_many_connections_are_answered_each_by_its_own(slice_of: float) -> None:
    async def scenario() -> None:
        hall = Hall(slice_of)
        await hall.serve()
        peers = [await hall.dial() for _ in range(40)]
        for number, (_, writer) in reversed(list(enumerate(peers))):
            writer.write(b"v%02d" % number)
        for number, (reader, _) in enumerate(peers):
            assert await reader.readexactly(3) == b"V%02d" % number
        assert [echo.notes[1] for echo in hall.echoes] == [f"v{number:02}" for number in range(40)]
        await hall.close()
        for _, writer in peers:
            writer.close()

    run(scenario)


def test_what_is_more_than_one_reading_comes_whole_and_in_order() -> None:
    async def scenario() -> None:
        hall = Hall()
        await hall.serve()
        reader, writer = await hall.dial()
        sent = b"".join(b"%05d" % number for number in range(MUCH // 5))
        writer.write(sent)
        assert await reader.readexactly(len(sent)) == sent
        assert max(map(len, hall.echoes[0].notes)) <= READ
        await hall.close()
        writer.close()

    run(scenario)


class Talker(asyncio.Protocol):
    """Holds what it was given to write to."""

    def __init__(self, sockets: Sockets) -> None:
        self.sockets = sockets
        self.notes: list[str] = []

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.to = self.sockets.take(cast(asyncio.Transport, transport), self, UNSENT_LIMIT)
        self.notes.append("made")

    def pause_writing(self) -> None:
        self.notes.append("paused")

    def connection_lost(self, exc: Exception | None) -> None:
        self.notes.append("lost")


def test_what_the_peer_does_not_take_yet_is_sent_when_it_does_and_a_close_waits_for_that() -> None:
    async def scenario() -> None:
        loop, sockets = asyncio.get_running_loop(), Sockets()
        talker, sent, got = Talker(sockets), b"", b""
        server = await loop.create_server(lambda: talker, "127.0.0.1", 0)
        peer = socket.create_connection(server.sockets[0].getsockname())
        peer.settimeout(0)
        await until(lambda: bool(talker.notes))
        # Until the kernel takes no more.
        while not talker.to.get_write_buffer_size():
            piece = b"%08d" % len(sent) * (UNSENT_LIMIT // 16)
            sent += piece
            talker.to.write(piece)
        assert talker.notes == ["made"]
        talker.to.write(bytes(UNSENT_LIMIT))
        sent += bytes(UNSENT_LIMIT)
        assert talker.notes == ["made", "paused"]
        talker.to.close()
        talker.to.write(b"too late")
        assert talker.to.is_closing()
        while piece := await loop.sock_recv(peer, 1 << 20):
            got += piece
        assert got == sent
        await until(lambda: talker.notes == ["made", "paused", "lost"])
        peer.close()
        sockets.close()
        server.close()

    run(scenario)


def test_a_peer_that_resets_the_connection_is_gone_with_the_reason() -> None:
    async def scenario() -> None:
        hall = Hall()
        await hall.serve()
        peer = socket.create_connection(hall.address)
        await until(lambda: bool(hall.lines) and hall.lines[0].up)
        peer.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
        peer.close()
        await until(lambda: not hall.lines[0].up)
        assert hall.echoes[0].notes == ["connected", "disconnected"]
        await hall.close()

    run(scenario)


def test_an_endpoint_that_fails_loses_its_connection_and_no_other_does() -> None:
    async def scenario() -> None:
        told: list[object] = []
        asyncio.get_running_loop().set_exception_handler(lambda _, context: told.append(context.get("exception")))
        hall = Hall()
        await hall.serve()
        (first, out), (second, beside) = await hall.dial(), await hall.dial()
        out.write(b"\xff")  # no text, which this endpoint does not expect
        assert await first.read() == b""
        beside.write(b"on")
        assert await second.readexactly(2) == b"ON"
        assert [type(error) for error in told] == [UnicodeDecodeError]
        await hall.close()
        out.close()
        beside.close()

    run(scenario)


def test_where_nothing_can_be_taken_over_the_transport_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenario() -> None:
        hall = Hall()
        await hall.serve()
        reader, writer = await hall.dial()
        writer.write(b"abc")
        assert await reader.readexactly(3) == b"ABC"
        hall.lines[0].stop()
        await hall.close()
        writer.close()

    monkeypatch.delattr("select.epoll", raising=False)
    run(scenario)
