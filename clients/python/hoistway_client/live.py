"""The live stream: a copy of the plant's state that is always whole, every event once, and commands.

``async for`` gives :class:`Changed` and :class:`Happened`. A gap in the numbers, a lost connection or a mark of the server
lead to a fresh snapshot by itself; events go on after the last one given.
"""

import asyncio
import itertools
import json
import ssl
from collections import deque
from collections.abc import AsyncIterator, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, cast

from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

from hoistway_client.models import Event
from hoistway_client.transport import SHOWN, NoController, Problem, Untrusted

FIRST_PAUSE, LONGEST_PAUSE = 0.5, 15.0
Body = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Changed:
    """An object is new, different, or gone (``value`` None). ``snapshot``: it was told because everything was."""

    topic: str
    key: str
    value: Mapping[str, Any] | None
    snapshot: bool = False


@dataclass(frozen=True, slots=True)
class Happened:
    """A durable event."""

    event: Event


class Live(AsyncIterator[Changed | Happened]):
    """One watcher. ``state`` is topic -> key -> object, as of the last item given or later; ``last_event`` what to resume after.

    Use it as an async context manager and iterate over it; commands are answered only while somebody iterates.
    """

    def __init__(
        self,
        url: str,
        *,
        key: str | None = None,
        actor: str | None = None,
        topics: Iterable[str] = (),
        after: int | None = None,
    ) -> None:
        self.state: dict[str, dict[str, Mapping[str, Any]]] = {}
        self.last_event = after
        self.resyncs = 0
        self._url = url.rstrip("/").replace("http", "ws", 1) + "/api/v1/live"
        self._topics = ",".join(topics)
        self._headers = {"Authorization": f"Bearer {key}"} if key else {}
        self._actor = actor
        self._seq: int | None = None
        self._socket: ClientConnection | None = None
        self._items: deque[Changed | Happened] = deque()
        self._numbers = itertools.count(1)
        self._asked: dict[int, asyncio.Future[Body]] = {}

    async def __aenter__(self) -> "Live":
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    async def close(self) -> None:
        """Watch no more."""
        socket, self._socket = self._socket, None
        if socket is not None:
            await socket.close()
        self._forget()

    async def command(self, name: str, target: str = "", body: Body | None = None) -> Body:
        """Give a command by name (``vehicle.hold``) and return its reply. Raises Problem; ConnectionError: nobody knows."""
        if self._socket is None:
            raise ConnectionError("there is no connection: iterate over the stream")
        number = next(self._numbers)
        future: asyncio.Future[Body] = asyncio.get_running_loop().create_future()
        self._asked[number] = future
        said: dict[str, Any] = {"id": number, "command": {"name": name, "target": target}}
        if body is not None:
            said["command"]["body"] = body
        if self._actor:
            said["actor"] = self._actor
        await self._socket.send(json.dumps(said))
        return await future

    async def __anext__(self) -> Changed | Happened:
        pause = FIRST_PAUSE
        while not self._items:
            try:
                if self._socket is None:
                    self._socket = await self._connected()
                self._take(json.loads(await self._socket.recv()))
                if self._gap:
                    await self._socket.send('{"resync": true}')
            except InvalidStatus as refused:
                status = refused.response.status_code
                if status < 400:
                    raise self._no_controller(status, bytes(refused.response.body or b"")) from None
                if status < 500 and status != 429:
                    raise Problem(status, "refused", "", f"the server answered {status}") from None
            except ssl.SSLCertVerificationError as wrong:
                remedy = "Set SSL_CERT_FILE to a file with the authority's certificate."
                why = f"the server's certificate is not trusted ({wrong.verify_message})"
                raise Untrusted(f"GET {self._url}", why, remedy) from wrong
            except (OSError, ConnectionClosed, TimeoutError):
                pass
            else:
                continue
            self._lose()
            await asyncio.sleep(pause)
            pause = min(2 * pause, LONGEST_PAUSE)
        return self._items.popleft()

    def _no_controller(self, status: int, body: bytes) -> NoController:
        text = body.decode(errors="replace")[:SHOWN]
        why = f"the answer ({status}) is no live stream of a controller: {text!r}"
        return NoController(f"GET {self._url}", why, "Is that the controller's address?", status, text)

    async def _connected(self) -> ClientConnection:
        query = [f"topics={self._topics}"] if self._topics else []
        query += [] if self.last_event is None else [f"after={self.last_event}"]
        where = self._url + ("?" + "&".join(query) if query else "")
        return await connect(
            where, additional_headers=self._headers, compression=None, max_size=None, proxy=None, open_timeout=10
        )

    def _take(self, frame: Body) -> None:
        """Take one frame of the server."""
        self._gap = False
        match frame["type"]:
            case "snapshot":
                self._snapshot(frame)
            case "change" if self._seq is not None:
                if frame["seq"] != self._seq + 1:
                    self._seq, self._gap = None, True
                    self.resyncs += 1
                    return
                self._seq = frame["seq"]
                for change in frame["changes"]:
                    self._change(change["topic"], change["key"], change["value"])
            case "event":
                for event in frame["events"]:
                    self._event(cast(Event, event))
            case "resync":
                self._seq = None
                self.resyncs += 1
            case "reply" | "error":
                self._answer(frame)
            case _:
                pass

    _gap = False

    def _snapshot(self, frame: Body) -> None:
        """Tell only what differs from what was told before: also what has gone meanwhile."""
        self._seq = frame["seq"]
        if self.last_event is None:
            self.last_event = frame["last_event"]
        objects: dict[str, dict[str, Mapping[str, Any]]] = frame["objects"]
        for topic in {*self.state, *objects}:
            before, now = self.state.get(topic, {}), objects.get(topic, {})
            for key in [key for key in before if key not in now]:
                self._change(topic, key, None, snapshot=True)
            for key, value in now.items():
                if before.get(key) != value:
                    self._change(topic, key, value, snapshot=True)

    def _change(self, topic: str, key: str, value: Mapping[str, Any] | None, *, snapshot: bool = False) -> None:
        objects = self.state.setdefault(topic, {})
        if value is None:
            objects.pop(key, None)
        else:
            objects[key] = value
        self._items.append(Changed(topic, key, value, snapshot))

    def _event(self, event: Event) -> None:
        if self.last_event is None or event["seq"] > self.last_event:
            self.last_event = event["seq"]
            self._items.append(Happened(event))

    def _answer(self, frame: Body) -> None:
        future = self._asked.pop(frame.get("id") or 0, None)
        said = frame.get("problem")
        problem = None if said is None else Problem.of(int(said["status"]), said)
        if future is not None and not future.done():
            if problem is not None:
                future.set_exception(problem)
            else:
                future.set_result(frame)
        elif problem is not None and "id" not in frame:
            raise problem

    def _lose(self) -> None:
        self._socket, self._seq = None, None
        self._forget()

    def _forget(self) -> None:
        for future in self._asked.values():
            if not future.done():
                future.set_exception(ConnectionError("the connection was lost: look at what became of the command"))
        self._asked.clear()
