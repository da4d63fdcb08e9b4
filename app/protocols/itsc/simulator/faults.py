"""A bad line around a simulated vehicle, or any other endpoint (PROTOCOLS 5.1, "Fault injection")."""

from collections.abc import Callable

from app.domain.ports import Endpoint
from app.domain.units import Seconds
from app.protocols.itsc.codec import SHORT_SIZE, Codec
from app.protocols.itsc.framing import Decoder, Garbled
from app.protocols.itsc.messages import Toward
from app.wire.faults import Lane


class Faulty:
    """An endpoint behind a bad line; itself an :class:`app.domain.ports.Endpoint`.

    ``silent`` swallows everything both ways while it is True. ``close`` hangs up after what was sent, ``reset`` without.
    """

    def __init__(self, inner: Endpoint, outgoing: Lane, incoming: Lane) -> None:
        self.inner = inner
        self.out_lane = outgoing
        self.in_lane = incoming
        self.silent = False
        self._now = 0.0
        self._closing = False

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next."""
        times = [t for t in (self.inner.deadline, self.out_lane.deadline, self.in_lane.deadline) if t is not None]
        return Seconds(min(times)) if times else None

    @property
    def wants_close(self) -> bool:
        """Whether either the endpoint or the fault ends the connection."""
        return self._closing or self.inner.wants_close

    def close(self) -> None:
        """End the connection once everything is sent."""
        self._closing = True

    def reset(self) -> None:
        """End the connection and lose what is on its way."""
        while self.inner.outgoing():
            pass
        self.out_lane.clear()
        self.in_lane.clear()
        self._closing = True

    def connected(self, now: Seconds) -> None:
        """The line is up, with nothing left on it from before."""
        self._now, self._closing = now, False
        self.out_lane.clear()
        self.in_lane.clear()
        self.inner.connected(now)

    def received(self, data: bytes, now: Seconds) -> None:
        """Bytes came; each call counts as one packet."""
        if not self.silent:
            self.in_lane.put(data, now)
        self.tick(now)

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down."""
        self._now, self._closing = now, False
        self.inner.disconnected(now, reason)

    def tick(self, now: Seconds) -> None:
        """Deliver what is late, and let the endpoint live on."""
        self._now = now
        while (at := self.in_lane.deadline) is not None and at <= now:
            self.inner.received(self.in_lane.take(now), Seconds(at))
        self.inner.tick(now)
        self._collect()

    def outgoing(self) -> bytes:
        """Return and forget the next piece to send; empty if none."""
        self._collect()
        return self.out_lane.take(self._now)

    def _collect(self) -> None:
        while packet := self.inner.outgoing():
            if not self.silent:
                self.out_lane.put(packet, self._now)


def foreign_dev_id(codec: Codec) -> Callable[[bytes], bytes]:
    """Return what gives an iTSC packet of a vehicle the next DEV_ID, and a fitting CRC."""

    def forge(packet: bytes) -> bytes:
        frame = next(iter(Decoder(codec, Toward.CONTROLLER).feed(packet)), None)
        if frame is None or isinstance(frame, Garbled) or len(packet) < SHORT_SIZE:
            return packet
        frame.dev_id = frame.dev_id + 1 & 0xFFFFFFFF
        return codec.encode(frame, strict=False)

    return forge
