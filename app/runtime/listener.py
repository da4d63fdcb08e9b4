"""Vehicles that dial us: which line an incoming connection belongs to (PROTOCOLS 6.2)."""

import asyncio
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import count
from typing import cast

from structlog.typing import FilteringBoundLogger

from app.domain.ids import VehicleId
from app.domain.layout import VehicleSpec
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.framing import Decoder, Garbled
from app.protocols.itsc.messages import NOTHING, Code, Enq, Toward
from app.runtime.lines import Line, tune
from app.runtime.telemetry import logger

ASK_TIMEOUT = 1.0
"""Seconds for a vehicle to answer to its id. Our choice: the ACK time-out of PROTOCOLS 6.1."""
ROUNDS = 5
"""How often each id that is missing is tried before the connection is cut. Our choice."""
MOST_UNKNOWN = 64
"""Connections that may be unknown at one time; more are cut. Our choice."""
QUIET = 60.0
"""Seconds until the same refusal is reported again: who is refused comes back at once. Our choice."""
_PROBES: Iterator[int] = count(1)
"""CMD_IDs of epoch 0, which no controller ever has: an answer to a probe answers no command."""


@dataclass(slots=True)
class Expected:
    """A vehicle that may come: its line, how it speaks, and where it must come from (``spec.host``, empty: anywhere)."""

    spec: VehicleSpec
    line: Line
    codec: Codec


class Listener:
    """Accepts vehicles at one address and gives each connection to the line of its vehicle.

    A peer whose address belongs to exactly one vehicle is that vehicle. Otherwise STATUS is asked under each id that fits the
    address and is missing, one after the other, until DEV_ID of an answer or of the vehicle's own event names it. An address
    that nobody may come from, and a second claimant of an id that is connected, are cut and told to ``report``.
    """

    def __init__(
        self,
        host: str,
        port: int,
        expected: Sequence[Expected],
        report: Callable[[str], None],
        ask_timeout: float = ASK_TIMEOUT,
    ) -> None:
        self.ask_timeout = ask_timeout
        self._host, self.port = host, port
        self._expected: Mapping[VehicleId, Expected] = {one.spec.id: one for one in expected}
        self._report = report
        self._log: FilteringBoundLogger = logger(listener=f"{host}:{port}")
        self._server: asyncio.Server | None = None
        self._asking: set[Arrival] = set()
        self._told: dict[str, float] = {}

    async def start(self) -> None:
        """Listen. Raises OSError: the address cannot be used."""
        loop = asyncio.get_running_loop()
        self._server = await loop.create_server(lambda: Arrival(self), self._host, self.port, reuse_address=True)
        self.port = self._server.sockets[0].getsockname()[1]

    async def stop(self) -> None:
        """Stop listening and cut every connection."""
        if self._server is not None:
            self._server.close()
            self._server = None
        for arrival in tuple(self._asking):
            arrival.cut()
        for one in self._expected.values():
            one.line.stop()

    def arrived(self, arrival: "Arrival") -> None:
        """See who a new connection can be."""
        named = [one for one in self._expected.values() if one.spec.host == arrival.peer]
        candidates = named or [one for one in self._expected.values() if not one.spec.host]
        missing = [one for one in candidates if not one.line.up]
        if not candidates:
            self.refuse(arrival, f"{arrival.peer} is not the address of any vehicle that may dial in")
        elif not missing:
            ids = ", ".join(one.spec.id for one in candidates)
            self.refuse(arrival, f"{arrival.peer} claims to be {ids}, which is connected already")
        elif len(named) == 1:
            self.give(arrival, named[0], b"")
        elif len(self._asking) >= MOST_UNKNOWN:
            self.refuse(arrival, f"{MOST_UNKNOWN} connections are being asked who they are already")
        else:
            self._asking.add(arrival)
            arrival.ask(candidates)

    def named(self, arrival: "Arrival", dev_id: int, unread: bytes, candidates: Sequence[Expected]) -> None:
        """Take the word of an incoming vehicle for who it is."""
        for one in candidates:
            if one.spec.dev_id == dev_id:
                if one.line.up:
                    self.refuse(arrival, f"{arrival.peer} claims to be {one.spec.id}, which is connected already")
                else:
                    self.give(arrival, one, unread)
                return
        self.refuse(arrival, f"{arrival.peer} has DEV_ID {dev_id}, which no vehicle that may come from there has")

    def give(self, arrival: "Arrival", one: Expected, unread: bytes) -> None:
        """Hand the connection over to a vehicle's line, with the bytes that came but are not used up."""
        self._asking.discard(arrival)
        self._log.info("vehicle dialled in", vehicle=one.spec.id, peer=arrival.peer)
        transport = arrival.release()
        transport.set_protocol(one.line)
        one.line.connection_made(transport)
        if unread:
            one.line.data_received(unread)

    def refuse(self, arrival: "Arrival", reason: str) -> None:
        """Cut the connection and say why."""
        self._asking.discard(arrival)
        now = asyncio.get_running_loop().time()
        if now - self._told.get(reason, -QUIET) >= QUIET:
            if len(self._told) >= MOST_UNKNOWN:
                self._told.clear()
            self._told[reason] = now
            self._report(reason)
        arrival.cut()

    def forget(self, arrival: "Arrival") -> None:
        """Note that the peer went away before it was known."""
        self._asking.discard(arrival)


@dataclass(slots=True, eq=False)
class Arrival(asyncio.Protocol):
    """An incoming connection that is not known yet."""

    listener: Listener
    peer: str = ""
    _transport: asyncio.Transport | None = None
    _turn: asyncio.TimerHandle | None = None
    _turns: Iterator[Expected] = field(default_factory=lambda: iter(()))
    _candidates: Sequence[Expected] = ()
    _codec: Codec | None = None
    _decoder: Decoder | None = None
    _probe: int = 0

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Find out where it comes from."""
        tune(transport)
        self._transport = cast(asyncio.Transport, transport)
        address = transport.get_extra_info("peername")
        self.peer = str(address[0]) if address else ""
        self.listener.arrived(self)

    def ask(self, candidates: Sequence[Expected]) -> None:
        """Ask for the first of these that is missing, then the next."""
        self._candidates = candidates
        self._turns = (one for _ in range(ROUNDS) for one in candidates if not one.line.up)
        self._next()

    def data_received(self, data: bytes) -> None:
        """Look for a packet that says who it is from."""
        decoder = self._decoder
        if decoder is None:
            return
        for item in decoder.feed(data):
            if isinstance(item, Garbled):
                continue
            if isinstance(item, Enq) and item.cmd_id != self._probe:
                self.listener.named(self, item.dev_id, data, self._candidates)
                return
            if isinstance(item, Enq):
                self._acknowledge(item)
                self.listener.named(self, item.dev_id, b"", self._candidates)
                return

    def connection_lost(self, exc: Exception | None) -> None:
        """Give up."""
        self._rest()
        self._transport = None
        self.listener.forget(self)

    def release(self) -> asyncio.Transport:
        """Let the connection go to somebody else."""
        self._rest()
        assert self._transport is not None
        transport, self._transport = self._transport, None
        return transport

    def cut(self) -> None:
        """End the connection."""
        self._rest()
        if self._transport is not None:
            self._transport.abort()

    def _acknowledge(self, answer: Enq) -> None:
        if self._codec is not None and self._codec.dialect.ack_answers and self._transport is not None:
            self._transport.write(self._codec.ack(answer.dev_id, answer.cmd_id))

    def _rest(self) -> None:
        self._decoder = None
        if self._turn is not None:
            self._turn.cancel()
            self._turn = None

    def _next(self) -> None:
        self._turn = None
        one = next(self._turns, None)
        if one is None or self._transport is None:
            self.listener.refuse(self, f"{self.peer} answers to no id that is missing")
            return
        self._probe = next(_PROBES)
        self._codec = one.codec
        self._decoder = Decoder(one.codec, Toward.CONTROLLER)
        self._transport.write(one.codec.encode(Enq(one.spec.dev_id, self._probe, int(Code.STATUS), NOTHING)))
        self._turn = asyncio.get_running_loop().call_later(self.listener.ask_timeout, self._next)
