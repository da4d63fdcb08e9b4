"""Our ends of the lines that carry several devices, as their owner feeds them: sessions, with what they tell passed on."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict

from app.control.agv import Agv
from app.domain.devices import DeviceEvent, DeviceId, DeviceKind, DeviceNumber, DeviceRequest, DeviceSpec
from app.domain.drive import DriveEvent, DriveLineId, DriveRequest, DriveSpec, Jog, KeepJogging, ReleaseJog
from app.domain.events import Event
from app.domain.layout import LinkSpec, Plant
from app.domain.links import LinkOrder
from app.domain.units import Seconds
from app.plant.dialects import drive_dialect_of, hall_dialect_of
from app.protocols.enig.session import LinkSession
from app.protocols.hi.session import LineSession
from app.protocols.itsc.session import Told

DevicesTold = Callable[[list[DeviceEvent], Seconds], None]
DrivesTold = Callable[[list[DriveEvent], Seconds], None]


def _to_nobody(events: Sequence[Event], now: Seconds) -> None:
    """For a link without AGVs."""


class Connection:
    """Since when a line is up or down, and why it is down."""

    def __init__(self) -> None:
        self.up = False
        self.since: Seconds | None = None
        self.reason = "not connected yet"

    def changed(self, now: Seconds, *, up: bool, reason: str = "") -> None:
        """It came up, or went down."""
        self.up, self.since, self.reason = up, now, reason

    def failed(self, reason: str) -> None:
        """An attempt to connect has failed: what was never up says why."""
        if self.since is None:
            self.reason = reason


class HallLink(LinkSession):
    """An ENIG link with the AGVs, buffers and doors on it: an ``app.domain.ports.Endpoint`` that tells after every input."""

    def __init__(
        self, plant: Plant, link: LinkSpec, told: DevicesTold, agvs: Iterable[Agv] = (), moved: Told = _to_nobody
    ) -> None:
        """``agvs`` are the AGVs on this link; what they have to say as vehicles goes to ``moved``."""
        super().__init__(devices_on(plant, link), hall_dialect_of(link), places=plant.aliases)
        self._pass_on = told
        self._agvs = {agv.device: agv for agv in agvs}
        self._moved = moved
        self.connection = Connection()

    def connected(self, now: Seconds) -> None:
        """The line is up."""
        self.connection.changed(now, up=True)
        super().connected(now)
        self.tell(now)

    def received(self, data: bytes, now: Seconds) -> None:
        """Bytes came."""
        super().received(data, now)
        self.tell(now)

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down."""
        self.connection.changed(now, up=False, reason=reason)
        super().disconnected(now, reason)
        self.tell(now)

    def tick(self, now: Seconds) -> None:
        """The deadline has passed."""
        super().tick(now)
        self.tell(now)

    @property
    def counts(self) -> dict[str, int]:
        """How the link is doing since the controller started."""
        link = self.link
        return {
            "connections": link.connections,
            "frames_in": link.frames_in,
            "frames_out": link.frames_out,
            "garbled": link.garbled,
            "resends": link.resends,
        }

    def order(self, order: LinkOrder, now: Seconds) -> None:
        """Send what is durable. What the session says of it at once is told with ``tell``."""
        if isinstance(order, DeviceRequest):
            self.send(order, now)

    def tell(self, now: Seconds) -> None:
        """Pass on what has happened, and send what AGVs on their way are to be told next."""
        told: list[DeviceEvent] = []
        moved: list[Event] = []
        while True:
            events = self.events()
            told += [event for event in events if event.device not in self._agvs]
            for name, agv in self._agvs.items():
                agv.take([event for event in events if event.device == name], now)
                if self.fresh(name):
                    agv.hear(self.status(name), self.status_at(name), now)
                moved += agv.events()
            requests = [request for agv in self._agvs.values() for request in agv.requests()]
            if not requests:
                break
            for request in requests:
                self.send(request, now)
        if told:
            self._pass_on(told, now)
        if moved:
            self._moved(moved, now)


class DriveLine(LineSession):
    """An HI line with its drives: an ``app.domain.ports.Endpoint`` that tells after every input."""

    def __init__(self, plant: Plant, link: LinkSpec, told: DrivesTold) -> None:
        drives = [DriveSpec(drive.id, drive.address) for drive in plant.drives_on(link.id)]
        super().__init__(DriveLineId(link.id), drives, drive_dialect_of(link))
        self._pass_on = told
        self.connection = Connection()

    def connected(self, now: Seconds) -> None:
        """The line is up."""
        self.connection.changed(now, up=True)
        super().connected(now)
        self.tell(now)

    def received(self, data: bytes, now: Seconds) -> None:
        """Bytes came."""
        super().received(data, now)
        self.tell(now)

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down."""
        self.connection.changed(now, up=False, reason=reason)
        super().disconnected(now, reason)
        self.tell(now)

    def tick(self, now: Seconds) -> None:
        """The deadline has passed."""
        super().tick(now)
        self.tell(now)

    @property
    def counts(self) -> dict[str, int]:
        """How the line is doing since the controller started."""
        return asdict(self.figures)

    def order(self, order: LinkOrder, now: Seconds) -> None:
        """Send what is durable. What the session says of it at once is told with ``tell``."""
        match order:
            case DriveRequest():
                self.request(order, now)
            case Jog():
                self.jog(order, now)
            case KeepJogging():
                self.keep_jogging(order.id, order.until)
            case ReleaseJog():
                self.release_jog(order.id, now)
            case DeviceRequest():
                pass

    def tell(self, now: Seconds) -> None:
        """Pass on what has happened."""
        if events := self.events():
            self._pass_on(events, now)


def devices_on(plant: Plant, link: LinkSpec) -> list[DeviceSpec]:
    """Return the devices of an ENIG link: its AGVs under their vehicle's name, its buffers and doors."""
    agvs = [DeviceSpec(DeviceId(agv.id), DeviceNumber(agv.dev_id), DeviceKind.AGV) for agv in plant.agvs_on(link.id)]
    buffers = [DeviceSpec(b.id, b.number, DeviceKind.BUFFER) for b in plant.buffers if b.link == link.id]
    doors = [DeviceSpec(d.id, d.number, DeviceKind.DOOR) for d in plant.doors if d.link == link.id]
    return [*agvs, *buffers, *doors]
