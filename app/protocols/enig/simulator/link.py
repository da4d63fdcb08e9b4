"""The devices' end of a link: several of them on one line (PROTOCOLS E23, 5.3)."""

from collections import Counter
from collections.abc import Iterable

from app.domain.devices import DeviceNumber
from app.domain.units import Seconds
from app.protocols.enig.codec import codec_of
from app.protocols.enig.dialects import DEFAULT, Dialect
from app.protocols.enig.framing import Decoder, Garbled
from app.protocols.enig.messages import BY_CLASS, Frame, Toward
from app.protocols.enig.simulator.device import SimulatedDevice
from app.protocols.enig.simulator.options import FLUSH_AFTER


class SimulatedLink:
    """An :class:`app.domain.ports.Endpoint` with devices on it, which live on without a connection.

    Whoever owns it calls ``tick`` at ``deadline``, connected or not. Packets for other ids, with a bad CRC, of a wrong size
    or with values that the table does not list are met with silence. ``outgoing`` gives one packet at a call.
    ``strict_target`` makes the devices deaf to commands that do not have the dialect's Target byte (E3).
    """

    def __init__(
        self, devices: Iterable[SimulatedDevice], dialect: Dialect = DEFAULT, *, strict_target: bool = False
    ) -> None:
        """Raises: ValueError: two devices have the same number."""
        self.devices: dict[DeviceNumber, SimulatedDevice] = {}
        for device in devices:
            if device.number in self.devices:
                raise ValueError(f"two devices have the number {device.number}")
            self.devices[device.number] = device
        self._codec = codec_of(dialect)
        self._strict_target = strict_target
        self._decoder = Decoder(self._codec, Toward.DEVICE)
        self._flush_at: Seconds | None = None
        self._up = False
        self._out: list[bytes] = []
        self._lost: Counter[str] = Counter()

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next, connected or not."""
        return min((time for time in (self._flush_at, self._next()) if time is not None), default=None)

    def _next(self) -> Seconds | None:
        times = [device.deadline for device in self.devices.values()]
        return min((time for time in times if time is not None), default=None)

    def _tick_devices(self, now: Seconds) -> None:
        for device in self.devices.values():
            device.tick(now)

    @property
    def wants_close(self) -> bool:
        """Never: devices do not hang up."""
        return False

    def connected(self, now: Seconds) -> None:
        """A host has connected: it hears from now on."""
        self.tick(now)
        self._up = True
        self._decoder, self._flush_at = Decoder(self._codec, Toward.DEVICE), None

    def disconnected(self, now: Seconds, reason: str = "") -> None:
        """The line is down; what the devices do goes on."""
        self.tick(now)
        self._up, self._flush_at = False, None
        self._out.clear()

    def received(self, data: bytes, now: Seconds) -> None:
        """Take bytes; never raises."""
        self.tick(now)
        if not self._up:
            return
        for item in self._decoder.feed(data):
            self._take(item, now)
        self._flush_at = Seconds(now + FLUSH_AFTER) if self._decoder.pending else None
        self._collect()

    def tick(self, now: Seconds) -> None:
        """Let everything happen that is due."""
        # Step by step, since one device's doing may be another's business.
        while (when := self._next()) is not None and when < now:
            self._tick_devices(when)
        self._tick_devices(now)
        if self._flush_at is not None and now >= self._flush_at:
            self._flush_at = None
            for item in self._decoder.flush():
                self._take(item, now)
        self._collect()

    def outgoing(self) -> bytes:
        """Return and forget the next packet; empty if there is none."""
        self._collect()
        return self._out.pop(0) if self._out else b""

    def lose(self, name: str, count: int = 1) -> None:
        """Lose the next packets with this name (``Status``, ``MoveComplete``, ``TagReceived``) on their way to the host."""
        self._lost[name] += count

    def _take(self, item: Frame | Garbled, now: Seconds) -> None:
        if isinstance(item, Garbled) or self._codec.problems(item, Toward.DEVICE):
            return
        device = self.devices.get(DeviceNumber(item.device))
        if device is None or (self._strict_target and not self._has_its_target(item)):
            return
        device.take(item.body, now)

    def _has_its_target(self, frame: Frame) -> bool:
        row = BY_CLASS[type(frame.body)]
        return (frame.target is not None) is (row.target and self._codec.dialect.target == "include")

    def _collect(self) -> None:
        """Put what the devices have said on the line, in order of time."""
        said = [(when, device.number, body) for device in self.devices.values() for when, body in device.said()]
        for _, number, body in sorted(said, key=lambda entry: entry[0]):
            if self._lost[str(body.name)] > 0:
                self._lost[str(body.name)] -= 1
            elif self._up:
                self._out.append(self._codec.encode(self._codec.packet(number, body), Toward.HOST))
