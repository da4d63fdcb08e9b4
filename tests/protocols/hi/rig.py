"""A master and its drives on one line, in virtual time, each character 1.042 ms long; and a script in the master's place."""

from collections.abc import Callable, Sequence
from random import Random

from app.domain.drive import (
    DriveAddress,
    DriveCommand,
    DriveDone,
    DriveEvent,
    DriveFailed,
    DriveId,
    DriveLineId,
    DriveRequest,
    DriveRequestId,
    DriveSpec,
    DriveUnknown,
    Jog,
    JogBegan,
    Turn,
)
from app.domain.ports import Endpoint
from app.domain.units import Seconds
from app.protocols.hi.codec import encode
from app.protocols.hi.dialects import DEFAULT, Dialect
from app.protocols.hi.framing import Decoder, Garbled
from app.protocols.hi.messages import NOTHING, Cmd, Content, Frame, Role, content_of, frame_of
from app.protocols.hi.session import LineSession, Timing
from app.protocols.hi.simulator import Options, SimulatedDrive, SimulatedLine
from app.wire.faults import Fault, Lane

CHARACTER = 0.00104167
"""9600 8N1 (PROTOCOLS 2.1)."""

End = DriveDone | DriveFailed | DriveUnknown


class Cable:
    """One direction: packets arrive whole when their last character has; ``lane`` may do things to them first."""

    def __init__(self, seed: int) -> None:
        self.lane = Lane(Random(seed), delay=(0.02, 0.3))
        self.free_at = 0.0
        self._under_way: list[tuple[float, bytes]] = []

    def put(self, packet: bytes, now: float) -> None:
        self.free_at = max(now, self.free_at) + len(packet) * CHARACTER
        self._under_way.append((self.free_at, packet))

    @property
    def deadline(self) -> float | None:
        times = [at for at, _ in self._under_way[:1]]
        if self.lane.deadline is not None:
            times.append(self.lane.deadline)
        return min(times, default=None)

    def arrived(self, now: float) -> list[bytes]:
        while self._under_way and self._under_way[0][0] <= now:
            at, packet = self._under_way.pop(0)
            self.lane.put(packet, at)
        pieces = []
        while piece := self.lane.take(now):
            pieces.append(piece)
        return pieces

    def clear(self) -> None:
        self._under_way.clear()
        self.lane.clear()


class Bench:
    """The real session and simulated drives D1, D2 … with the ids 1, 2 …"""

    def __init__(
        self,
        drives: int = 1,
        *,
        dialect: Dialect = DEFAULT,
        timing: Timing | None = None,
        options: Options | None = None,
        seed: int = 1,
        watch: Sequence[int] | None = None,
    ) -> None:
        self.drives = {i: SimulatedDrive(i, dialect, options) for i in range(1, drives + 1)}
        self.line = SimulatedLine(self.drives.values(), dialect)
        specs = [DriveSpec(DriveId(f"D{i}"), DriveAddress(i)) for i in watch or self.drives]
        self.session = LineSession(DriveLineId("L1"), specs, dialect, timing)
        self.out, self.back = Cable(seed), Cable(seed + 1)
        self.now = 0.0
        self.up = False
        self.echo = False
        self.sent: list[tuple[float, bytes]] = []
        self.events: list[tuple[float, DriveEvent]] = []
        self.dialect = dialect
        self._requests = 0
        self.connect()

    def connect(self) -> None:
        self.up = True
        self.line.connected(Seconds(self.now))
        self.session.connected(Seconds(self.now))
        self._pump()

    def cut(self) -> None:
        self.up = False
        self.out.clear()
        self.back.clear()
        self.line.disconnected(Seconds(self.now), "cut")
        self.session.disconnected(Seconds(self.now), "unplugged")
        self._pump()

    def ask(self, command: DriveCommand, drive: int | None = 1) -> DriveRequestId:
        """Enter a request and return its id."""
        self._requests += 1
        name = None if drive is None else DriveId(f"D{drive}")
        self.session.request(DriveRequest(DriveRequestId(self._requests), name, command), Seconds(self.now))
        self._pump()
        return DriveRequestId(self._requests)

    def do(self, command: DriveCommand, drive: int | None = 1, within: float = 10.0) -> End:
        """Enter a request and live on until it has ended."""
        request = self.ask(command, drive)
        self.until(lambda: self.end(request) is not None, within)
        return self.ended(request)

    def jog(self, turn: Turn, until: float, drive: int = 1) -> DriveRequestId:
        self._requests += 1
        request = DriveRequestId(self._requests)
        self.session.jog(Jog(request, DriveId(f"D{drive}"), turn, Seconds(until)), Seconds(self.now))
        self._pump()
        return request

    def end(self, request: DriveRequestId) -> End | None:
        ends = [event for _, event in self.events if isinstance(event, End) and event.request == request]
        assert len(ends) <= 1, f"a request ends once: {ends}"
        return ends[0] if ends else None

    def ended(self, request: DriveRequestId) -> End:
        end = self.end(request)
        assert end is not None, "the request has not ended"
        return end

    def began(self, request: DriveRequestId) -> bool:
        return any(isinstance(event, JogBegan) and event.request == request for _, event in self.events)

    def of(self, *kinds: type[DriveEvent]) -> list[DriveEvent]:
        """The events of these kinds, in order."""
        return [event for _, event in self.events if isinstance(event, kinds)]

    def commands(self, cmd: Cmd, drive: int | None = None) -> list[float]:
        """When the master sent this command."""
        frames = [(at, frame) for at, packet in self.sent for frame in Decoder(self.dialect).feed(packet)]
        return [
            at
            for at, frame in frames
            if isinstance(frame, Frame) and frame.cmd == cmd and (drive is None or frame.id == drive)
        ]

    def run(self, seconds: float) -> None:
        """Let time pass."""
        self._live(self.now + seconds, lambda: False)

    def until(self, reached: Callable[[], bool], within: float = 10.0) -> None:
        """Let time pass until something is so. Fails if it is not in time."""
        self._live(self.now + within, reached)
        assert reached(), f"not within {within} s; events: {self.events[-5:]}"

    def settle(self) -> None:
        """Let all drives be heard once, and forget what was told until then."""
        self.until(lambda: all(view.online is not None for view in self.session.drives.values()))
        self.run(0.01)
        self.forget()

    def forget(self) -> None:
        self.events.clear()
        self.sent.clear()

    def _live(self, end: float, reached: Callable[[], bool]) -> None:
        steps = 0
        self._pump()
        while not reached():
            steps += 1
            assert steps < 200_000, "time stands still"
            ends: list[Endpoint] = [self.session, self.line]
            times = [
                at for at in (*(e.deadline for e in ends), self.out.deadline, self.back.deadline) if at is not None
            ]
            at = min(times, default=end)
            if at > end:
                self.now = end
                return
            self.now = max(self.now, at)
            for piece in self.out.arrived(self.now):
                self.line.received(piece, Seconds(self.now))
            for piece in self.back.arrived(self.now):
                self.session.received(piece, Seconds(self.now))
            for endpoint in ends:
                endpoint.tick(Seconds(self.now))
            self._pump()

    def _pump(self) -> None:
        while packet := self.session.outgoing():
            self.sent.append((self.now, packet))
            self.out.put(packet, self.now)
            if self.echo:
                self.back.put(packet, self.now)
        while answer := self.line.outgoing():
            if self.up:
                self.back.put(answer, self.now)
        self.events += [(self.now, event) for event in self.session.events()]


class Script:
    """What a test says to simulated drives in the master's place, byte for byte."""

    def __init__(self, drives: int = 1, *, dialect: Dialect = DEFAULT, options: Options | None = None) -> None:
        self.drives = {i: SimulatedDrive(i, dialect, options) for i in range(1, drives + 1)}
        self.line = SimulatedLine(self.drives.values(), dialect)
        self.drive = self.drives[1]
        self.dialect = dialect
        self.now = Seconds(0.0)
        self.line.connected(Seconds(0.0))

    def say(self, cmd: Cmd, content: Content = NOTHING, drive: int = 1) -> tuple[str, Content | None] | None:
        """Send a command; return the answer's command and content, None if there is no answer within 100 ms."""
        return self.raw(encode(frame_of(Role.MASTER, drive, cmd, content, self.dialect), self.dialect))

    def raw(self, data: bytes, wait: float = 0.1) -> tuple[str, Content | None] | None:
        """Send bytes; the answer ends the waiting."""
        self.line.received(data, self.now)
        end = Seconds(self.now + wait)
        while (at := self.line.deadline) is not None and at <= end:
            self.now = max(self.now, at)
            self.line.tick(self.now)
            packet = self.line.outgoing()
            if packet:
                (frame,) = Decoder(self.dialect).feed(packet)
                assert not isinstance(frame, Garbled)
                return frame.cmd, content_of(frame, self.dialect)
        self.now = Seconds(end)
        return None

    def wait(self, seconds: float) -> None:
        """Let time pass."""
        self.now = Seconds(self.now + seconds)
        self.line.tick(self.now)


def strike(cable: Cable, fault: Fault, cmd: Cmd, times: int = 1) -> None:
    """Let a fault befall the next packets with a command."""
    for _ in range(times):
        cable.lane.strike(fault, lambda packet: cmd.value.encode() in packet)
