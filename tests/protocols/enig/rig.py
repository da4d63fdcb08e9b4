"""What ENIG's tests stand on: a small hall, a scripted host that writes everything down, and a whole link in virtual time."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TypeVar

from app.domain.devices import (
    AgvMode,
    AgvStatus,
    AliasName,
    DeviceCommand,
    DeviceEvent,
    DeviceId,
    DeviceKind,
    DeviceNumber,
    DeviceRequest,
    DeviceRequestId,
    DeviceSpec,
)
from app.domain.layout import Edge
from app.domain.ports import Endpoint
from app.domain.units import Barcode, Millimetres, Seconds
from app.protocols.enig.codec import codec_of
from app.protocols.enig.dialects import DEFAULT, Dialect
from app.protocols.enig.framing import Decoder
from app.protocols.enig.messages import AgvReport, Body, Frame, Toward
from app.protocols.enig.session import LinkSession
from app.protocols.enig.simulator import Hall, SimulatedAgv, SimulatedBuffer, SimulatedDoor, SimulatedLink, Tape

AGV1, AGV2, BUFFER1, BUFFER2, DOOR = (DeviceNumber(number) for number in (11, 12, 21, 22, 30))
T = TypeVar("T")


def tag(text: str) -> Barcode:
    """A tag."""
    return Barcode(text)


def edge(start: str, end: str, length: int = 1000) -> Edge:
    """A piece of tape, two seconds long at normal speed."""
    return Edge(tag(start), tag(end), Millimetres(length))


def small_tape() -> Tape:
    """A line 0001-0002-0003-0004, from 0002 a branch to the charger 0009 (C1) and back, and the way round from 0004.

    B1 is at 0003, B2 at 0004.
    """
    return Tape(
        [
            edge("0001", "0002"),
            edge("0002", "0003"),
            edge("0003", "0004"),
            edge("0002", "0009", 500),
            edge("0009", "0002", 500),
            edge("0004", "0001", 3000),
        ],
        {"B1": tag("0003"), "B2": tag("0004"), "C1": tag("0009")},
    )


def agv(
    number: DeviceNumber = AGV1, start: str = "0001", tape: Tape | None = None, hall: Hall | None = None
) -> SimulatedAgv:
    """An AGV at the beginning of the line."""
    return SimulatedAgv(number, tape or small_tape(), tag(start), hall=hall)


@dataclass
class Host:
    """A host reduced to a script: it sends what a test says and writes down what it hears."""

    link: SimulatedLink
    dialect: Dialect = DEFAULT
    now: Seconds = Seconds(0.0)
    heard: list[tuple[float, DeviceNumber, Body]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._codec = codec_of(self.dialect)
        self._decoder = Decoder(self._codec, Toward.HOST)
        self._last: dict[DeviceNumber, Body] = {}
        self.link.connected(self.now)

    def send(self, number: int, body: Body) -> None:
        """Send a command."""
        self.raw(self._codec.encode(self._codec.packet(number, body), Toward.DEVICE, strict=False))

    def raw(self, data: bytes) -> None:
        """Send bytes."""
        self.link.received(data, self.now)
        self._listen()

    def wait(self, seconds: float) -> None:
        """Let time pass."""
        until = Seconds(self.now + seconds)
        self._listen()
        while (due := self.link.deadline) is not None and due <= until:
            self.now = max(self.now, due)
            self.link.tick(self.now)
            self._listen()
        self.now = until
        self.link.tick(self.now)
        self._listen()

    def _listen(self) -> None:
        while packet := self.link.outgoing():
            (item,) = self._decoder.feed(packet)
            assert isinstance(item, Frame)
            assert self._codec.problems(item, Toward.HOST) == ()
            self.heard.append((self.now, DeviceNumber(item.device), item.body))

    def told(self) -> list[Body]:
        """Return and forget what was heard, without a Status that says nothing new."""
        bodies: list[Body] = []
        for _, number, body in self.heard:
            if body.name != "Status" or self._last.get(number) != body:
                bodies.append(body)
            if body.name == "Status":
                self._last[number] = body
        self.heard.clear()
        return bodies

    def story(self) -> list[str]:
        """Return and forget what an AGV has told, in short: R runs, S stands, E error, then I in position; tags; complete."""
        return [_short(body) for body in self.told()]


def _short(body: Body) -> str:
    if isinstance(body, AgvReport):
        return "SRE"[body.run] + "I" * body.inposition + f" {body.tag}/{body.path}"
    return f"{body.name} {getattr(body, 'tag', getattr(body, 'state', ''))}"


SPECS = {
    "AGV1": (AGV1, DeviceKind.AGV),
    "AGV2": (AGV2, DeviceKind.AGV),
    "BUF1": (BUFFER1, DeviceKind.BUFFER),
    "DOOR": (DOOR, DeviceKind.DOOR),
}
PLACES = {AliasName("B1"): tag("0003"), AliasName("B2"): tag("0004")}


def specs(*names: str) -> list[DeviceSpec]:
    """Devices by their names here."""
    return [DeviceSpec(DeviceId(name), *SPECS[name]) for name in names or SPECS]


class World:
    """A hall with two AGVs, a buffer and a door on one link, and the real session at its other end, in virtual time.

    ``behind`` puts something around the link (a bad line). The door stands between 0002 and 0003, the buffer at 0003.
    """

    def __init__(self, *, dialect: Dialect = DEFAULT, places: bool = True, latency: float = 0.0) -> None:
        self.now = Seconds(0.0)
        self.door = SimulatedDoor(DOOR)
        self.buffer = SimulatedBuffer(BUFFER1, cart=True)
        hall = Hall({(tag("0002"), tag("0003")): self.door}, {tag("0003"): self.buffer})
        self.agv = agv(hall=hall)
        self.agv2 = agv(AGV2, "0004", hall=hall)
        self.link = SimulatedLink([self.agv, self.agv2, self.buffer, self.door], dialect)
        self.line: Endpoint = self.link
        self.session = LinkSession(specs(), dialect, places=PLACES if places else None)
        self.latency = latency
        self._wire: list[tuple[float, bool, bytes]] = []
        self.log: list[tuple[float, DeviceEvent]] = []
        self.sent: list[tuple[float, bytes]] = []
        self._last = 0

    def connect(self, wait: float = 1.0) -> "World":
        """Connect, and let every device report."""
        self.session.connected(self.now)
        self.line.connected(self.now)
        self.wait(wait)
        return self

    def cut(self, reason: str = "cut") -> None:
        """Cut the line."""
        self._wire.clear()
        self.session.disconnected(self.now, reason)
        self.line.disconnected(self.now, reason)
        self._pump()

    def closing(self) -> bool:
        """Whether the session asks for the line to be closed."""
        return self.session.wants_close

    def auto(self) -> "World":
        """Turn the AGVs to auto and let that be known."""
        for one in (self.agv, self.agv2):
            one.set_mode(AgvMode.AUTO, self.now)
        self.wait(0.5)
        return self

    def ask(self, device: str, command: DeviceCommand) -> DeviceRequestId:
        """Send a command and return its id."""
        self._last += 1
        number = DeviceRequestId(self._last)
        self.session.send(DeviceRequest(number, DeviceId(device), command), self.now)
        self._pump()
        return number

    def wait(self, seconds: float) -> None:
        """Let time pass."""
        until = self.now + seconds
        self._pump()
        while (due := self._next()) is not None and due <= until:
            self.now = Seconds(max(self.now, due))
            self.line.tick(self.now)
            if (at := self.session.deadline) is not None and at <= self.now:
                self.session.tick(self.now)
            self._pump()
        self.now = Seconds(until)

    def _next(self) -> float | None:
        times = [self.line.deadline, self.session.deadline, *(when for when, _, _ in self._wire[:1])]
        return min((time for time in times if time is not None), default=None)

    def _pump(self) -> None:
        moved = True
        while moved:
            moved = False
            if data := self.session.outgoing():
                self.sent.append((self.now, data))
                self._wire.append((self.now + self.latency, True, data))
                moved = True
            while data := self.line.outgoing():
                self._wire.append((self.now + self.latency, False, data))
                moved = True
            while self._wire and self._wire[0][0] <= self.now:
                _, down, data = self._wire.pop(0)
                (self.line if down else self.session).received(data, self.now)
                moved = True
        self.log += [(self.now, event) for event in self.session.events()]

    def of(self, *kinds: type[T]) -> list[T]:
        """Return the events of some kinds so far."""
        return [event for _, event in self.log if isinstance(event, kinds)]

    def about(self, request: DeviceRequestId) -> list[tuple[float, str]]:
        """Return what became of a request: when, rounded to tenths, and the event's name."""
        return [
            (round(when, 1), type(event).__name__.removeprefix("Device"))
            for when, event in self.log
            if getattr(event, "request", None) == request
        ]

    def end(self, request: DeviceRequestId) -> str:
        """Return how a request has ended, with its reason if it has one."""
        endings = ("DeviceDone", "DeviceNotSent", "DeviceNotAccepted", "DeviceFailed", "DeviceUnknown")
        ends = [e for _, e in self.log if getattr(e, "request", None) == request and type(e).__name__ in endings]
        assert len(ends) <= 1, "a request ends once"
        if not ends:
            return ""
        said = getattr(ends[0], "reason", getattr(ends[0], "why", ""))
        return f"{type(ends[0]).__name__.removeprefix('Device')}{': ' if said else ''}{said}"

    def transmissions(self, packet: Iterable[int]) -> list[float]:
        """Return when a command byte has gone out: (id, cmd)."""
        number, cmd = packet
        return [round(when, 1) for when, data in self.sent if data[2] == number and data[3] == cmd]

    def status(self, device: str = "AGV1") -> AgvStatus:
        """Return what the session believes of an AGV."""
        status = self.session.status(DeviceId(device))
        assert isinstance(status, AgvStatus)
        return status
