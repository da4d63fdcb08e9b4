"""Lines: bytes between one socket and one endpoint, and the endpoint's only timer."""

import asyncio
import socket
import sys
from collections.abc import Callable
from contextvars import Context
from typing import cast

from app.domain.ports import Endpoint, Prompt
from app.domain.units import Seconds

USER_TIMEOUT = 5_000
"""ms until the kernel gives up on bytes that the peer does not acknowledge. Our choice; keepalive alone is too slow."""
UNSENT_LIMIT = 64 * 1024
"""Bytes waiting for a peer that takes none, after which the connection is cut. Our choice: none is ever sent so much."""
FLOOD = 64 * 1024
"""Bytes in one second beyond which a peer is cut off. Our choice: 2,000 packets; a vehicle sends some tens. Bytes that wait
would be old news when their turn comes, and each costs the other vehicles time."""
FLOODED = f"it sent more than {FLOOD} bytes in a second"
CLOSE_GRACE = 1.0
"""Seconds for the last bytes to leave before a connection that is being closed is cut. Our choice."""
_CONTEXT = Context()
_SHORTEST = 0.001
"""Timer resolution of the loop, s."""


def nothing() -> None:
    """Do nothing: for lines whose owner has nothing to do after an input."""


def tune(transport: asyncio.BaseTransport) -> None:
    """Set a TCP connection up for small packets and quick notice of a dead peer; leave other transports alone."""
    cast(asyncio.WriteTransport, transport).set_write_buffer_limits(high=UNSENT_LIMIT)
    sock = transport.get_extra_info("socket")
    if sock is None or sock.family not in {socket.AF_INET, socket.AF_INET6}:
        return
    sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    if sys.platform == "linux":
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, USER_TIMEOUT)
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPIDLE, 5)
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPINTVL, 2)
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPCNT, 3)


class Line(asyncio.Protocol):
    """One endpoint on the loop, connected or not; serves one connection after another, never two at a time.

    The timer is armed for the endpoint's deadline and left alone when the deadline moves back: it then fires early, finds
    nothing due and arms itself anew, which is cheaper than a new timer per packet. ``after`` is called after each input.
    ``may_send``, if given, is asked before each write; what may not be sent is dropped.
    """

    __slots__ = (
        "_armed",
        "_budget",
        "_budgeted",
        "_closing",
        "_endpoint",
        "_idle",
        "_loop",
        "_may_send",
        "_now",
        "_prompt",
        "_timer",
        "_transport",
        "after",
        "flooded",
        "heard",
    )

    def __init__(
        self,
        endpoint: Endpoint,
        now: Callable[[], Seconds],
        after: Callable[[], None] = nothing,
        may_send: Callable[[], bool] | None = None,
    ) -> None:
        self._may_send = may_send
        self._endpoint = endpoint
        self._prompt = endpoint if isinstance(endpoint, Prompt) else None
        self._now = now
        self.after = after
        """Called after each input."""
        self._loop = asyncio.get_running_loop()
        self._transport: asyncio.Transport | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._armed = 0.0
        self._closing: asyncio.TimerHandle | None = None
        self._idle: asyncio.Future[None] | None = None
        self._budget = FLOOD
        self._budgeted = 0.0
        self.heard = False
        """Whether bytes came in the present or last connection."""
        self.flooded = False
        """Whether the present or last connection is cut because too many came."""

    @property
    def up(self) -> bool:
        """Whether there is a connection."""
        return self._transport is not None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Begin a connection."""
        # Not isinstance: uvloop's transports are none of asyncio's classes.
        self._transport = cast(asyncio.Transport, transport)
        self.heard = self.flooded = False
        tune(transport)
        self._endpoint.connected(self._now())
        self.flush()
        self.after()

    def data_received(self, data: bytes) -> None:
        """Give the endpoint its bytes, as long as they are not too many."""
        self.heard = True
        now = self._now()
        self._budget -= len(data)
        if self._budget < 0 and not self._within_budget(len(data), now):
            return
        prompt, transport = self._prompt, self._transport
        if prompt is not None and transport is not None and (answer := prompt.at_once(data, now)):
            if self._may_send is None or self._may_send():
                transport.write(answer)
        else:
            self._endpoint.received(data, now)
            self.flush()
        self.after()

    def pause_writing(self) -> None:
        """Cut the connection of a peer that takes no bytes: what it does not take is bounded."""
        if self._transport is not None:
            self._transport.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        """End a connection."""
        self._transport = None
        if self._closing is not None:
            self._closing.cancel()
            self._closing = None
        self._endpoint.disconnected(self._now(), FLOODED if self.flooded else _why(exc))
        self.flush()
        self.after()
        if self._idle is not None and not self._idle.done():
            self._idle.set_result(None)

    def flush(self) -> None:
        """Write what the endpoint has to say, close if it wants to, and see to its timer."""
        endpoint, transport = self._endpoint, self._transport
        while data := endpoint.outgoing():
            if transport is not None and (self._may_send is None or self._may_send()):
                transport.write(data)
        if endpoint.wants_close and transport is not None and self._closing is None:
            transport.close()
            self._closing = self._loop.call_later(CLOSE_GRACE, transport.abort)
        deadline = endpoint.deadline
        if deadline is not None and (self._timer is None or deadline < self._armed):
            self._arm(deadline)

    async def disconnected(self) -> None:
        """Wait until there is no connection."""
        if self._transport is not None:
            self._idle = self._loop.create_future()
            await self._idle

    def stop(self) -> None:
        """Cut the connection and let the timer go; the endpoint hears of the cut once the loop runs again."""
        if self._transport is not None:
            self._transport.abort()
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _within_budget(self, count: int, now: Seconds) -> bool:
        """Begin a new second if the last one is over; otherwise cut the connection."""
        if now - self._budgeted >= 1.0 and count <= FLOOD:
            self._budgeted, self._budget = now, FLOOD - count
            return True
        self.flooded = True
        if self._transport is not None:
            self._transport.abort()
        return False

    def _arm(self, deadline: float) -> None:
        if self._timer is not None:
            self._timer.cancel()
        self._armed = deadline
        # In one context for all lines: each timer would make a copy of its own.
        self._timer = self._loop.call_later(max(deadline - self._now(), _SHORTEST), self._fire, context=_CONTEXT)

    def _fire(self) -> None:
        self._timer = None
        now = self._now()
        deadline = self._endpoint.deadline
        if deadline is not None and deadline <= now:
            self._endpoint.tick(now)
            self.flush()
            self.after()
        elif deadline is not None:
            self._arm(deadline)


def _why(error: Exception | None) -> str:
    if error is None:
        return "the connection was closed"
    return (error.strerror if isinstance(error, OSError) else None) or str(error)
