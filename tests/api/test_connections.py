"""Bounds of a connection, on a loop and a transport that the test moves by hand."""

import asyncio
from collections.abc import Callable, Coroutine, Iterable, Iterator
from typing import Any

import pytest
from starlette.types import ASGIApp, Receive, Scope, Send
from uvicorn import Config
from uvicorn.server import ServerState

from app.api.connections import COPIED, HEAD_LIMIT, PATIENCE, Connection, bounded

LINE = b"POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\n"


class Timer:
    """One call to come."""

    def __init__(self, at: float, call: Callable[[], None]) -> None:
        self.at = at
        self.call = call
        self.cancelled = False

    def cancel(self) -> None:
        self.cancelled = True


class Loop:
    """Time goes on when the test says so; tasks wait."""

    def __init__(self) -> None:
        self.now = 100.0
        self.timers: list[Timer] = []
        self.tasks: list[Coroutine[Any, Any, None]] = []

    def time(self) -> float:
        return self.now

    def call_later(self, seconds: float, call: Callable[[], None]) -> Timer:
        self.timers.append(Timer(self.now + seconds, call))
        return self.timers[-1]

    def create_task(self, run: Coroutine[Any, Any, None], **_: object) -> "Loop":
        self.tasks.append(run)
        return self

    def add_done_callback(self, _done: object) -> None:
        pass

    def wait(self, seconds: float) -> None:
        until = self.now + seconds
        while due := sorted((timer for timer in self.timers if timer.at <= until), key=lambda timer: timer.at):
            self.timers.remove(due[0])
            self.now = due[0].at
            if not due[0].cancelled:
                due[0].call()
        self.now = until

    def run(self) -> None:
        """Run the oldest request to its end; it has all it waits for."""
        with pytest.raises(StopIteration):
            self.tasks.pop(0).send(None)


class Wire(asyncio.Transport):
    """Keeps what was written."""

    def __init__(self) -> None:
        super().__init__()
        self.writes: list[bytes] = []
        self.closed = self.aborted = False

    def get_extra_info(self, name: str, default: Any = None) -> Any:
        return {"peername": ("127.0.0.1", 5), "sockname": ("127.0.0.1", 80)}.get(name, default)

    def write(self, data: bytes | bytearray | memoryview) -> None:
        self.writes.append(bytes(data))

    def writelines(self, pieces: Iterable[bytes | bytearray | memoryview]) -> None:
        self.write(b"".join(pieces))

    @property
    def written(self) -> bytes:
        return b"".join(self.writes)

    def is_closing(self) -> bool:
        return self.closed

    def close(self) -> None:
        self.closed = True

    def abort(self) -> None:
        self.closed = self.aborted = True

    def pause_reading(self) -> None:
        pass

    def resume_reading(self) -> None:
        pass


async def _app(_scope: Scope, receive: Receive, send: Send) -> None:
    while (await receive()).get("more_body"):
        pass
    await send({"type": "http.response.start", "status": 204, "headers": []})
    await send({"type": "http.response.body"})


def _answering(headers: list[tuple[bytes, bytes]], *bodies: bytes) -> ASGIApp:
    async def app(_scope: Scope, _receive: Receive, send: Send) -> None:
        await send({"type": "http.response.start", "status": 200, "headers": headers})
        for left, body in reversed(list(enumerate(reversed(bodies)))):
            await send({"type": "http.response.body", "body": body, "more_body": left > 0})

    return app


class Server:
    """Makes connections of one server."""

    def __init__(self, most: int = 2, app: ASGIApp = _app) -> None:
        self.loop = Loop()
        self._state = ServerState()
        self._protocol = bounded(most)
        self._config = Config(app, http=self._protocol, ws="websockets-sansio", log_config=None)

    def connected(self) -> tuple[Connection, Wire]:
        connection = self._protocol(self._config, self._state, {}, self.loop)  # type: ignore[arg-type]
        wire = Wire()
        connection.connection_made(wire)
        return connection, wire


@pytest.fixture
def server() -> Iterator[Server]:
    server = Server()
    yield server
    for task in server.loop.tasks:
        task.close()


@pytest.mark.parametrize(
    "endless",
    [
        LINE + b"X: ",
        b"GET /",
        b"GET /?",
        LINE + b"Transfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\nTrailer: ",
    ],
)
def test_a_head_without_end_is_cut_off(server: Server, endless: bytes) -> None:
    connection, wire = server.connected()
    connection.data_received(endless)
    sent = 0
    while not wire.is_closing():
        connection.data_received(b"x" * 4096)
        sent += 4096
    assert sent <= HEAD_LIMIT + 4096


def test_a_body_is_not_counted_as_head(server: Server) -> None:
    connection, wire = server.connected()
    connection.data_received(LINE + b"Content-Length: 1000000\r\n\r\n")
    for _ in range(100):
        connection.data_received(b" " * 10_000)
    assert not wire.is_closing()
    server.loop.run()
    connection.data_received(LINE + b"Content-Length: 0\r\n\r\n")
    server.loop.run()
    assert wire.written.count(b"204") == 2


@pytest.mark.parametrize("begun", [b"", b"GET / HT", LINE + b"Content-Length: 5\r\n\r\n{"])
def test_a_request_that_does_not_come_in_is_given_up(server: Server, begun: bytes) -> None:
    connection, wire = server.connected()
    connection.data_received(begun)
    for _ in range(20):
        server.loop.wait(PATIENCE / 60)
        connection.data_received(b"")
    assert not wire.is_closing()
    server.loop.wait(PATIENCE)
    assert wire.is_closing()
    assert b" 408 " in wire.written
    assert b"application/problem+json" in wire.written


def test_an_answer_may_take_as_long_as_it_will(server: Server) -> None:
    connection, wire = server.connected()
    connection.data_received(LINE + b"Content-Length: 0\r\n\r\n\r\n")
    server.loop.wait(10 * PATIENCE)
    assert not wire.is_closing()
    server.loop.run()
    assert b"204" in wire.written


@pytest.mark.parametrize("length", [3, COPIED + 1])
def test_an_answer_of_known_length_leaves_in_one_piece(length: int) -> None:
    body = b"x" * length
    server = Server(app=_answering([(b"content-length", b"%d" % length), (b"etag", b'"1"')], body))
    connection, wire = server.connected()
    for _ in range(2):
        connection.data_received(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
        server.loop.run()
    head = b'HTTP/1.1 200 OK\r\ncontent-length: %d\r\netag: "1"\r\n\r\n' % length
    assert wire.writes == [head + body] * 2
    assert not wire.closed


def test_what_is_sent_in_parts_or_ends_the_connection_is_sent_as_it_comes() -> None:
    server = Server(app=_answering([(b"content-length", b"4")], b"ab", b"cd"))
    connection, wire = server.connected()
    connection.data_received(b"GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
    server.loop.run()
    assert wire.written.endswith(b"connection: close\r\n\r\nabcd")
    assert wire.closed


def test_an_answer_to_head_has_no_body() -> None:
    server = Server(app=_answering([(b"content-length", b"4")], b"abcd"))
    connection, wire = server.connected()
    connection.data_received(b"HEAD / HTTP/1.1\r\nHost: localhost\r\n\r\n")
    server.loop.run()
    assert wire.written == b"HTTP/1.1 200 OK\r\ncontent-length: 4\r\n\r\n"


@pytest.mark.parametrize("value", [b"a\r\nset-cookie: b", b"a\0", b"a\n"])
def test_a_head_that_would_be_read_as_another_is_not_sent(value: bytes) -> None:
    server = Server(app=_answering([(b"content-length", b"2"), (b"location", value)], b"ok"))
    connection, wire = server.connected()
    connection.data_received(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
    server.loop.run()
    assert value not in wire.written
    assert b"200" not in wire.written


def test_blank_lines_do_not_keep_an_idle_connection_open(server: Server) -> None:
    connection, wire = server.connected()
    connection.data_received(LINE + b"Content-Length: 0\r\n\r\n")
    server.loop.run()
    for _ in range(20):
        connection.data_received(b"\r\n") if not wire.is_closing() else None
        server.loop.wait(PATIENCE / 10)
    assert wire.is_closing()


def test_a_peer_that_reads_nothing_is_dropped(server: Server) -> None:
    connection, wire = server.connected()
    connection.data_received(LINE + b"Content-Length: 0\r\n\r\n")
    connection.pause_writing()
    server.loop.wait(PATIENCE / 2)
    connection.resume_writing()
    server.loop.wait(PATIENCE)
    assert not wire.is_closing()
    connection.pause_writing()
    server.loop.wait(2 * PATIENCE)
    assert wire.aborted


def test_one_connection_too_many_is_told_so(server: Server) -> None:
    first = server.connected()
    assert not server.connected()[1].closed
    connection, wire = server.connected()
    assert wire.is_closing()
    assert b" 503 " in wire.written
    connection.connection_lost(None)
    first[0].connection_lost(None)
    assert not server.connected()[1].closed


def test_a_request_that_is_none_is_a_problem(server: Server) -> None:
    connection, wire = server.connected()
    connection.data_received(b"\x16\x03\x01\x02\x00\x01")
    assert wire.is_closing()
    assert b" 400 " in wire.written
    assert b"application/problem+json" in wire.written


def test_a_websocket_request_that_the_library_would_not_answer_is_answered(server: Server) -> None:
    connection, wire = server.connected()
    connection.data_received(
        b"GET /api/v1/live?topics=" + b"vehicles," * 1000 + b" HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\n"
        b"Connection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
    )
    assert wire.is_closing()
    assert b" 431 " in wire.written
