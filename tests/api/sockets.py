"""A WebSocket client that talks ASGI to the application, in the same loop."""

import asyncio
import json
from types import TracebackType
from typing import Any

from starlette.types import ASGIApp, Message


class Socket:
    """One connection; ``async with`` opens it. ``refused`` has the messages of a refusal."""

    def __init__(
        self,
        app: ASGIApp,
        path: str = "/api/v1/live",
        query: str = "",
        headers: dict[str, str] | None = None,
        *,
        answers: bool = False,
    ) -> None:
        self._app = app
        given = {"host": "localhost"} | (headers or {})
        self._scope = {
            "type": "websocket",
            "asgi": {"version": "3.0"},
            "http_version": "1.1",
            "scheme": "ws",
            "path": path,
            "raw_path": path.encode(),
            "query_string": query.encode(),
            "headers": [(name.encode(), value.encode("latin-1")) for name, value in given.items()],
            "client": ("127.0.0.1", 50000),
            "server": ("localhost", 80),
            "subprotocols": [],
            "extensions": {"websocket.http.response": {}} if answers else {},
        }
        self._in: asyncio.Queue[Message] = asyncio.Queue()
        self.out: asyncio.Queue[Message] = asyncio.Queue()
        self._task: asyncio.Future[None] | None = None

    async def __aenter__(self) -> "Socket":
        self._in.put_nowait({"type": "websocket.connect"})
        self._task = asyncio.ensure_future(self._app(self._scope, self._in.get, self._put))
        return self

    async def _put(self, message: Message) -> None:
        self.out.put_nowait(message)

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._in.put_nowait({"type": "websocket.disconnect", "code": 1001})
        assert self._task is not None
        await self._task

    async def message(self) -> Message:
        """Return the next ASGI message."""
        async with asyncio.timeout(60):
            return await self.out.get()

    async def accepted(self) -> "Socket":
        """Wait until the connection is accepted."""
        assert (await self.message())["type"] == "websocket.accept"
        return self

    async def frame(self) -> dict[str, Any]:
        """Return the next frame."""
        message = await self.message()
        assert message["type"] == "websocket.send", message
        frame: dict[str, Any] = json.loads(message["text"])
        return frame

    def say(self, text: str) -> None:
        """Send a text."""
        self._in.put_nowait({"type": "websocket.receive", "text": text})
