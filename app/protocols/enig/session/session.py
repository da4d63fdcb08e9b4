"""The session: one ENIG link with the devices on it, over any number of connections (PROTOCOLS 3, 6.1, 6.2, E9, E23)."""

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

from app.domain.devices import (
    AliasName,
    DeviceEvent,
    DeviceGarbled,
    DeviceId,
    DeviceNumber,
    DeviceRequest,
    DeviceSpec,
    DeviceStatus,
    MoveCompleted,
    TagRead,
)
from app.domain.errors import EncodeError
from app.domain.units import Barcode, Seconds
from app.protocols.enig.codec import codec_of
from app.protocols.enig.dialects import Dialect, DialectError
from app.protocols.enig.framing import Cut, Decoder, Garbled
from app.protocols.enig.messages import AgvReport, BufferReport, DoorReport, MoveComplete, TagReceived, Toward
from app.protocols.enig.session.conditions import status_of
from app.protocols.enig.session.device import Device, goal_of, not_sent
from app.protocols.enig.session.requests import body_of
from app.protocols.enig.session.timing import Timing

Way = Literal["in", "out"]
FRAMES_KEPT = 32
"""Our choice: what a device's panel shows of the line."""


@dataclass(frozen=True, slots=True)
class LinkQuality:
    """Figures of the link since the session began."""

    connections: int
    frames_in: int
    frames_out: int
    garbled: int
    resends: int


class LinkSession:
    """Our end of a link that carries one or more devices; an ``app.domain.ports.Endpoint``. Gives ``events()``.

    ``places`` are the tags of the destinations with a name, where they are known: a MoveAlias to one of them is checked
    against the tag that the AGV reports. ``last_frames`` are (when, "in" or "out", bytes), newest last.
    """

    def __init__(
        self,
        devices: Iterable[DeviceSpec],
        dialect: Dialect,
        timing: Timing = Timing(),  # noqa: B008  (frozen)
        places: Mapping[AliasName, Barcode] | None = None,
    ) -> None:
        """Raises: DialectError: a device's number is not one of its kind's in this dialect, or two are the same."""
        self.dialect, self.timing = dialect, timing
        self.last_frames: deque[tuple[Seconds, Way, bytes]] = deque(maxlen=FRAMES_KEPT)
        self.wants_close = False
        """Whether the link is silent and should be closed."""
        self._codec = codec_of(dialect)
        self._decoder = Decoder(self._codec, Toward.HOST)
        self._places = dict(places or {})
        self._events: list[DeviceEvent] = []
        self._out = b""
        self._up = False
        self._heard = Seconds(0.0)
        self._flush_at: Seconds | None = None
        self._strangers: set[int] = set()
        self._connections = self._frames_in = self._frames_out = self._garbled = 0
        self._devices: dict[DeviceId, Device] = {}
        self._by_number: dict[DeviceNumber, Device] = {}
        for spec in devices:
            self._add(spec)

    def _add(self, spec: DeviceSpec) -> None:
        kind = self._codec.class_of(spec.number)
        if kind is None or kind.value != spec.kind.value:
            raise DialectError(f"{spec.id}: number {spec.number} is no {spec.kind.value}'s in this dialect")
        if spec.number in self._by_number or spec.id in self._devices:
            raise DialectError(f"{spec.id}: two devices of this link have this name, or the number {spec.number}")
        device = Device(spec, self.timing, self._events.append, self._emit)
        self._devices[spec.id] = self._by_number[spec.number] = device

    # What is known

    @property
    def up(self) -> bool:
        """Whether the link is connected; each device has to report by itself."""
        return self._up

    @property
    def link(self) -> LinkQuality:
        """Figures of the link."""
        resends = sum(device.resends for device in self._devices.values())
        return LinkQuality(self._connections, self._frames_in, self._frames_out, self._garbled, resends)

    def status(self, device: DeviceId) -> DeviceStatus | None:
        """Return the last Status of a device of this link; None before the first. It may be old: see ``fresh``."""
        return self._devices[device].status

    def status_at(self, device: DeviceId) -> Seconds | None:
        """Return when the last Status of a device came."""
        return self._devices[device].status_at

    def fresh(self, device: DeviceId) -> bool:
        """Return whether a device has reported within the last 5 s on this connection."""
        return self._devices[device].fresh

    def events(self) -> list[DeviceEvent]:
        """Return and forget what has happened, in order."""
        events = self._events.copy()
        self._events.clear()
        return events

    # Endpoint

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next."""
        if not self._up or self.wants_close:
            return None
        times = [device.deadline for device in self._devices.values()]
        times += [self._flush_at, Seconds(self._heard + self.timing.silence)]
        return min(time for time in times if time is not None)

    def connected(self, now: Seconds) -> None:
        """The line is up: the devices report by themselves, there is nothing to ask."""
        self._lose("connected anew")
        self._up, self.wants_close, self._heard = True, False, now
        self._connections += 1
        for device in self._devices.values():
            device.connected(now)

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down: commands under way are unknown, each said so."""
        self._lose(reason)
        self._up = self.wants_close = False

    def received(self, data: bytes, now: Seconds) -> None:
        """Take bytes. Never raises, whatever they are."""
        if not self._up or self.wants_close:
            return
        for item in self._decoder.cut(data):
            self._take(item, now)
        self._flush_at = Seconds(now + self.timing.flush) if self._decoder.pending else None

    def tick(self, now: Seconds) -> None:
        """Do what is due: give up half packets, silent devices, commands without effect, a silent line."""
        if not self._up or self.wants_close:
            return
        if self._flush_at is not None and now >= self._flush_at:
            self._flush_at = None
            for item in self._decoder.cut(b"", idle=True):
                self._take(item, now)
        for device in self._devices.values():
            device.tick(now)
        if now >= self._heard + self.timing.silence:
            self._lose(f"no valid packet for {self.timing.silence:g} s")
            self.wants_close = True

    def outgoing(self) -> bytes:
        """Return and forget the bytes to send."""
        out, self._out = self._out, b""
        return out

    def send(self, request: DeviceRequest, now: Seconds) -> None:
        """Send a command whose intent is durable, or say why not (DeviceNotSent: nothing has been sent)."""
        device = self._devices.get(request.device)
        if device is None:
            self._events.append(not_sent(request, f"{request.device} is not on this link"))
            return
        try:
            frame = self._codec.packet(device.spec.number, body_of(request.command))
            packet = self._codec.encode(frame, Toward.DEVICE)
        except EncodeError as wrong:
            self._events.append(not_sent(request, wrong.message, wrong.remedy))
            return
        refusal = device.refusal(request.command, up=self._up and not self.wants_close)
        if refusal is not None:
            self._events.append(not_sent(request, *refusal))
            return
        device.begin(request, packet, goal_of(request.command, self._places), now)

    def _emit(self, packet: bytes, now: Seconds) -> None:
        self._out += packet
        self._frames_out += 1
        self.last_frames.append((now, "out", packet))

    def _lose(self, reason: str) -> None:
        for device in self._devices.values():
            device.lost(reason)
        self._decoder = Decoder(self._codec, Toward.HOST)
        self._strangers.clear()
        self._out = b""
        self._flush_at = None

    def _take(self, item: Cut | Garbled, now: Seconds) -> None:
        if isinstance(item, Garbled):
            self._complain(None, item.reason.value, f"{item.detail}; {item.dropped} bytes dropped")
            return
        self._heard = now
        self._frames_in += 1
        self.last_frames.append((now, "in", item.data))
        frame = item.frame
        device = self._by_number.get(DeviceNumber(frame.device))
        if device is None:
            if frame.device not in self._strangers:
                # It reports each second: once on a connection is enough.
                self._strangers.add(frame.device)
                self._complain(None, "foreign device", f"device {frame.device} is not configured on this link")
        elif wrong := self._codec.problems(frame, Toward.HOST):
            detail = f"CMD {frame.cmd}: {', '.join(wrong)}: {item.data.hex(' ').upper()}"
            self._complain(device.spec.id, "unfit packet", detail)
        else:
            self._take_body(device, item, now)

    def _take_body(self, device: Device, item: Cut, now: Seconds) -> None:
        body = item.frame.body
        if isinstance(body, AgvReport | BufferReport | DoorReport):
            device.reported(status_of(body), now)
        elif isinstance(body, TagReceived):
            self._events.append(TagRead(device.spec.id, Barcode(body.tag)))
        elif isinstance(body, MoveComplete):
            self._events.append(MoveCompleted(device.spec.id, Barcode(body.tag)))
            device.completed(Barcode(body.tag), now)

    def _complain(self, device: DeviceId | None, reason: str, detail: str) -> None:
        self._garbled += 1
        self._events.append(DeviceGarbled(device, reason, detail))
