"""Connections: dialling a peer until it answers, and serving a simulated device over TCP."""

import asyncio
import errno
import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, cast

from structlog.typing import FilteringBoundLogger

from app.runtime.lines import FLOODED, Line, nothing
from app.runtime.telemetry import logger

CONNECT_TIMEOUT = 3.0
"""Seconds for a peer to accept. Our choice."""
FIRST_PAUSE, LONGEST_PAUSE = 0.5, 5.0
"""Seconds between two attempts to connect; doubled after each that brought no byte, or far too many. Our choice."""


class Way(Protocol):
    """How a peer is reached. ``str`` names it for people."""

    async def connect(self, line: Line) -> None:
        """Connect the line. Raises OSError: the peer is not there."""
        ...


@dataclass(frozen=True, slots=True)
class Tcp:
    """A peer at a TCP address: a device, or a serial server with the device behind it."""

    host: str
    port: int

    def __str__(self) -> str:
        return f"{self.host}:{self.port}"

    async def connect(self, line: Line) -> None:
        """Connect the line. Raises OSError: nobody answers there."""
        loop = asyncio.get_running_loop()
        transport, dialled = await loop.create_connection(_Dialled, self.host, self.port)
        dialled.hand_over(transport, line)


class _Dialled(asyncio.Protocol):
    """A connection that is being made. A line has it once it is whole: when an attempt is given up at that moment, uvloop tells
    of the connection, but never of its end, and whoever waits for the line to be cut would wait for ever.
    """

    def __init__(self) -> None:
        self._unread = bytearray()
        self._lost: Exception | None = None

    def data_received(self, data: bytes) -> None:
        """Keep what comes before the line is there."""
        self._unread += data

    def connection_lost(self, exc: Exception | None) -> None:
        """Note that the peer has gone before the line was there."""
        self._lost = exc or ConnectionResetError(errno.ECONNRESET, os.strerror(errno.ECONNRESET))

    def hand_over(self, transport: asyncio.Transport, line: Line) -> None:
        """Give the connection to its line. Raises OSError: it is gone already."""
        if self._lost is not None:
            raise self._lost
        transport.set_protocol(line)
        line.connection_made(transport)
        if self._unread:
            line.data_received(bytes(self._unread))


class Dialler:
    """Keeps one line connected to one peer for as long as it runs; ``failed`` is told why it cannot, once for each reason."""

    def __init__(self, line: Line, way: Way, name: str, failed: Callable[[str], None] = lambda _: None) -> None:
        self._line = line
        self._failed = failed
        self._way = way
        self._log: FilteringBoundLogger = logger(line=name, address=str(way))
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begin to dial."""
        self._task = asyncio.get_running_loop().create_task(self._keep_connected())

    async def stop(self) -> None:
        """Stop dialling and cut the connection."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)
            self._task = None
        self._line.stop()

    async def _keep_connected(self) -> None:
        pause = FIRST_PAUSE
        told = ""
        while True:
            trouble = await self._connect()
            if trouble:
                if trouble != told:
                    self._log.warning("cannot connect", reason=trouble)
                    self._failed(trouble)
                told = trouble
            else:
                told = ""
                self._log.info("connected")
                await self._line.disconnected()
                if self._line.flooded:
                    self._log.warning("cut off", reason=FLOODED)
                else:
                    self._log.info("disconnected")
                if self._line.heard and not self._line.flooded:
                    pause = FIRST_PAUSE
            await asyncio.sleep(pause)
            pause = min(2 * pause, LONGEST_PAUSE)

    async def _connect(self) -> str:
        """Return why there is no connection, or nothing if there is one."""
        try:
            # Not wait_for: before Python 3.12 it loses a cancellation that comes at the moment of the answer.
            async with asyncio.timeout(CONNECT_TIMEOUT):
                await self._way.connect(self._line)
        except TimeoutError:
            return f"no answer in {CONNECT_TIMEOUT:g} s"
        except OSError as error:
            return error.strerror or str(error)
        return ""


class DeviceServer:
    """A simulated device behind a TCP port: one controller at a time, and its physical time goes on without one.

    While ``refuses(now)`` holds, nobody listens at the port, as after a SYSTEM RESET (PROTOCOLS 5.1).
    """

    def __init__(self, line: Line, host: str, port: int, refuses: Callable[[], bool] = lambda: False) -> None:
        self._line = line
        self._host, self._port = host, port
        self._refuses = refuses
        self._server: asyncio.Server | None = None
        self._opening: asyncio.Task[None] | None = None
        self._watch: asyncio.TimerHandle | None = None

    @property
    def port(self) -> int:
        """Return the port that is served, which the system chose if it was given as 0."""
        return self._port

    async def start(self) -> None:
        """Listen. Raises OSError: the address cannot be used."""
        await self._listen()
        self._line.flush()
        self._line.after = self._look
        self._follow()

    async def stop(self) -> None:
        """Stop listening and cut the connection."""
        self._line.after = nothing
        if self._watch is not None:
            self._watch.cancel()
            self._watch = None
        if self._opening is not None:
            self._opening.cancel()
            await asyncio.gather(self._opening, return_exceptions=True)
        self._deafen()
        self._line.stop()

    def _follow(self) -> None:
        """Look now and then: a device may change its mind without an input to its line."""
        self._look()
        self._watch = asyncio.get_running_loop().call_later(_LOOK_AGAIN, self._follow)

    def _look(self) -> None:
        """Close and open the port as the device wants."""
        if self._refuses():
            self._deafen()
        elif self._server is None and (self._opening is None or self._opening.done()):
            self._opening = asyncio.get_running_loop().create_task(self._listen())

    async def _listen(self) -> None:
        loop = asyncio.get_running_loop()
        self._server = await loop.create_server(self._protocol, self._host, self._port, reuse_address=True)
        self._port = self._server.sockets[0].getsockname()[1]

    def _deafen(self) -> None:
        if self._server is not None:
            self._server.close()
            self._server = None

    def _protocol(self) -> asyncio.Protocol:
        return _Arrival(self._take)

    def _take(self, transport: asyncio.Transport) -> None:
        if self._line.up or self._refuses():
            transport.abort()
        else:
            transport.set_protocol(self._line)
            self._line.connection_made(transport)


_LOOK_AGAIN = 0.5
"""Seconds between two looks, besides one after each input, whether a simulated device refuses connections. Our choice."""


class _Arrival(asyncio.Protocol):
    """A new connection; who gets it is decided once it is there, so that two at the same moment cannot both get it."""

    def __init__(self, take: Callable[[asyncio.Transport], None]) -> None:
        self._take = take

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Give the connection away."""
        self._take(cast(asyncio.Transport, transport))
