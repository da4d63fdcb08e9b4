"""HTTP connections with the bounds that the server's own do not have: how many, how long a head, how slow a peer.

An answer that is known as a whole leaves in one piece: head and body in two are two calls of the system, and two segments.
"""

import re
from asyncio import BaseTransport, TimerHandle, Transport
from http import HTTPStatus
from typing import Any, cast

from starlette.types import Message
from uvicorn.protocols.http.httptools_impl import STATUS_LINE, HttpToolsProtocol, RequestResponseCycle

from app.api.problems import MEDIA_TYPE
from app.runtime.showing import encode

HEAD_LIMIT = 1 << 16
"""Most bytes of one request besides its body: its head, and what chunks and trailers add. Our choice."""
LINE_LIMIT = 8000
HEADERS_LIMIT = 120
"""Longest line and most headers of a request for a WebSocket; beyond 8192 and 128 the library does not answer."""
PATIENCE = 30.0
"""Seconds that a request may take to come in whole, and a peer to read something of what waits for it. Our choice."""
COPIED = 1 << 14
"""Bytes up to which a body is joined to its head; a longer one is handed on beside it, without a copy. Our choice."""
_FRAMING = frozenset({b"connection", b"transfer-encoding"})
_UNSENDABLE = re.compile(rb"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")
"""What no head may hold; the server refuses such answers."""


class _Whole:
    """The ``send`` of one request: holds the head back until its body comes, and writes both at once."""

    __slots__ = ("_connection", "_cycle", "_head", "_send")

    def __init__(self, connection: "Connection", cycle: RequestResponseCycle) -> None:
        self._connection = connection
        self._cycle = cycle
        self._send = cycle.send
        self._head: Message | None = None

    async def __call__(self, message: Message) -> None:
        head, self._head = self._head, None
        if head is not None:
            if message["type"] == "http.response.body" and self._written(head, message):
                return
            await self._send(cast(Any, head))
        elif message["type"] == "http.response.start" and _has_length(message) and not self._cycle.response_started:
            self._head = message
            return
        await self._send(cast(Any, message))

    def _written(self, head: Message, message: Message) -> bool:
        """Write an answer in one piece; False: it is none of the plain ones, and the server's own way has to do it."""
        cycle = self._cycle
        if cycle.disconnected or cycle.flow.write_paused or not cycle.keep_alive:
            return False
        if message.get("more_body", False) or cycle.scope["method"] == "HEAD":
            return False
        body = message.get("body", b"")
        parts = [STATUS_LINE[head["status"]]]
        for name, value in (*cycle.default_headers, *head["headers"]):
            if name in _FRAMING or (name == b"content-length" and int(value) != len(body)):
                return False
            parts += (name, b": ", value, b"\r\n")
        parts.append(b"\r\n")
        text = b"".join(parts)
        if text.count(b"\n") != len(parts) // 4 + 2 or _UNSENDABLE.search(text):
            return False
        self._connection.write(text, body)
        cycle.response_started = cycle.response_complete = True
        cycle.waiting_for_100_continue = False
        cycle.message_event.set()
        cycle.on_response()
        return True


def _has_length(head: Message) -> bool:
    return any(name == b"content-length" for name, _ in head.get("headers", ()))


class Connection(HttpToolsProtocol):
    """One connection, of at most ``most`` at a time. Make a subclass by :func:`bounded`."""

    most: int
    _looking: TimerHandle | None = None
    _head = 0
    _since: float | None = None
    _stalled: float | None = None

    def connection_made(self, transport: BaseTransport) -> None:
        super().connection_made(cast(Transport, transport))
        self._since = self.loop.time()
        self._look_later()
        if len(self.connections) > self.most:
            self._end(503, f"{self.most} connections are open already.", "Close some, or raise `connections`.")

    def connection_lost(self, exc: Exception | None) -> None:
        super().connection_lost(exc)
        if self._looking is not None:
            self._looking.cancel()

    def data_received(self, data: bytes) -> None:
        if self._since is None:
            self._since = self.loop.time()
        self._head += len(data)
        super().data_received(data)
        if self._head > HEAD_LIMIT and self.parser is not None:
            self._end(
                431, f"The head of the request is larger than {HEAD_LIMIT} bytes.", "Send fewer or shorter headers."
            )

    def on_body(self, body: bytes) -> None:
        self._head -= len(body)
        super().on_body(body)

    def on_message_complete(self) -> None:
        self._head, self._since = 0, None
        super().on_message_complete()

    def write(self, head: bytes, body: bytes) -> None:
        """Write an answer."""
        if len(body) <= COPIED:
            self.transport.write(head + body)
        else:
            self.transport.writelines((head, body))

    def _start_asgi_task(self, cycle: RequestResponseCycle, app: Any) -> None:
        cycle.send = cast(Any, _Whole(self, cycle))  # type: ignore[method-assign]
        super()._start_asgi_task(cycle, app)

    def handle_websocket_upgrade(self) -> None:
        lines = [len(self.url) + 20, *(len(name) + len(value) + 4 for name, value in self.headers)]
        if max(lines) > LINE_LIMIT or len(lines) > HEADERS_LIMIT:
            detail = f"A line of the head is longer than {LINE_LIMIT} bytes, or there are over {HEADERS_LIMIT}."
            self._end(431, detail, "Send fewer or shorter headers.")
            return
        super().handle_websocket_upgrade()
        if self._looking is not None:
            self._looking.cancel()

    def pause_writing(self) -> None:
        self._stalled = self.loop.time()
        super().pause_writing()

    def resume_writing(self) -> None:
        self._stalled = None
        super().resume_writing()

    def send_400_response(self, msg: str) -> None:
        self._end(400, msg, "Speak HTTP/1.1, without TLS: a proxy in front can add that.")

    @property
    def _cycle(self) -> RequestResponseCycle | None:
        """The newest request whose head is whole."""
        return cast(RequestResponseCycle | None, self.cycle)

    def _look_later(self) -> None:
        self._looking = self.loop.call_later(PATIENCE / 3, self._look)

    def _look(self) -> None:
        """End what takes too long."""
        before = self.loop.time() - PATIENCE
        if self.transport.is_closing() or (self._stalled is not None and self._stalled <= before):
            self.transport.abort()
            return
        if self._since is not None and self._since <= before and not self._answering():
            self._end(408, f"The request did not come in whole within {PATIENCE:.0f} s.", "Send it again, faster.")
        self._look_later()

    def _answering(self) -> bool:
        """Whether a request that came whole waits for its answer."""
        cycle = self._cycle
        return bool(self.pipeline) or (cycle is not None and not cycle.response_complete and not cycle.more_body)

    def _end(self, status: int, detail: str, remedy: str = "") -> None:
        """Say why, unless an answer is under way, and close."""
        if self.transport.is_closing():
            return
        cycle = self._cycle
        under_way = cycle is not None and cycle.response_started and not cycle.response_complete
        if not under_way and not self._answering():
            phrase = HTTPStatus(status).phrase
            body = encode(
                {"type": "about:blank", "title": phrase, "status": status, "detail": detail, "remedy": remedy}
            )
            head = f"HTTP/1.1 {status} {phrase}\r\ncontent-type: {MEDIA_TYPE}\r\ncontent-length: {len(body)}\r\n"
            self.transport.write(head.encode() + b"connection: close\r\n\r\n" + body)
        self.transport.close()


def bounded(connections: int) -> type[Connection]:
    """Return the protocol of a server that takes so many connections."""
    return type("Connection", (Connection,), {"most": connections})
