"""The clients: every call of the API, and events that go on where they were."""

import json
import time
from collections.abc import Iterator
from typing import Self, cast

import httpx

from hoistway_client.calls import AsyncCalls, Calls
from hoistway_client.models import Event
from hoistway_client.transport import NoController, Problem, Untrusted, asked_of, foreign, problem_of, unreachable

FIRST_PAUSE, LONGEST_PAUSE = 0.5, 15.0
"""Seconds between attempts to connect."""
EVENTS = "/api/v1/events/stream"
SILENT = 40.0
"""Seconds of silence after which a stream counts as dead: the server says that it is alive every 15 s."""


class Hoistway(Calls):
    """One controller, for programs that wait."""

    def __enter__(self) -> Self:
        return self

    def events(self, after: int | None = None, *, forever: bool = True) -> Iterator[Event]:
        """Give every durable event above ``after``, in order, each once; then those that come, through lost connections.

        Keep the ``seq`` of the last one dealt with, and begin with it next time. Without ``after``: from the next event on.
        ``forever`` False: end where the stream ends. Raises Problem if the server refuses, NoController if
        another program answers, Untrusted if its certificate cannot be trusted; a server that is away is waited for.
        """
        pause = FIRST_PAUSE
        while True:
            try:
                for event in self._stream(after):
                    pause = FIRST_PAUSE
                    if after is None or event["seq"] > after:
                        after = event["seq"]
                        yield event
            except httpx.TransportError as error:
                lost = unreachable(asked_of(self._http, "GET", EVENTS), error)
                if isinstance(lost, Untrusted) or isinstance(error, httpx.UnsupportedProtocol):
                    raise lost from error
            except (Problem, NoController) as problem:
                if problem.status < 500:
                    raise
            if not forever:
                return
            time.sleep(pause)
            pause = min(2 * pause, LONGEST_PAUSE)

    def _stream(self, after: int | None) -> Iterator[Event]:
        params = {} if after is None else {"after": after}
        timeout = httpx.Timeout(10.0, read=SILENT)
        with self._http.stream("GET", EVENTS, params=params, timeout=timeout) as answer:
            if answer.status_code >= 400:
                answer.read()
                raise problem_of(answer, asked_of(self._http, "GET", EVENTS))
            if not answer.headers.get("content-type", "").startswith("text/event-stream"):
                answer.read()
                raise foreign(asked_of(self._http, "GET", EVENTS), answer)
            for line in answer.iter_lines():
                if line.startswith("data: "):
                    yield cast(Event, json.loads(line[6:]))


class AsyncHoistway(AsyncCalls):
    """One controller, for asyncio. Its live stream is :class:`hoistway_client.Live`."""

    async def __aenter__(self) -> Self:
        return self
