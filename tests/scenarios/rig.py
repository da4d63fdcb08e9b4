"""A controller reduced to a script: it sends what a test says, acknowledges what it hears, and writes everything down."""

from collections.abc import Callable
from dataclasses import dataclass

from app.domain.ids import DevId, VehicleId
from app.domain.layout import Edge, VehicleSpec
from app.domain.units import Barcode, Millimetres, Seconds
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT, Dialect
from app.protocols.itsc.framing import Decoder, Garbled
from app.protocols.itsc.messages import (
    NOTHING,
    SUB_FORMS,
    Ack,
    Action,
    Body,
    Code,
    Element,
    Enq,
    Etb,
    Frame,
    Mode,
    Move,
    Port,
    Resp1,
    Resp2,
    Teach,
    Toward,
    Xmove,
)
from app.protocols.itsc.simulator import Options, Places, SimulatedVehicle, Track

DEV_ID = 1
EVENT = 1 << 63


def edge(start: str, end: str, length: int = 2000, *, curve: bool = False) -> Edge:
    """A piece of rail."""
    return Edge(Barcode(start), Barcode(end), Millimetres(length), curve=curve)


def small_track() -> Track:
    """A main line 1201-1206 and a branch 1301-1303 that leaves it behind 1201 and again behind 1202."""
    return Track(
        [
            edge("1201", "1202"),
            edge("1202", "1203"),
            edge("1203", "1204"),
            edge("1204", "1205"),
            edge("1205", "1206"),
            edge("1201", "1301"),
            edge("1202", "1302", curve=True),
            edge("1301", "1302"),
            edge("1302", "1303"),
        ]
    )


def spec(**changes: object) -> VehicleSpec:
    """Vehicle V1 with DEV_ID 1."""
    return VehicleSpec(**({"id": VehicleId("V1"), "dev_id": DevId(DEV_ID)} | changes))  # type: ignore[arg-type]


def path(
    *barcodes: int, stop: int = Action.STOP_PORT, first: int = 0, speed: int = 80, sensor: int = 3
) -> list[Element]:
    """A path over the barcodes whose last element stops."""
    last = len(barcodes) - 1
    return [
        Element(barcode, first + i, sensor, stop if i == last else int(Action.RUN), speed)
        for i, barcode in enumerate(barcodes)
    ]


PORT = Port(shft=-1520, rota=900, lift=1_170_000, lkdn=5, spd=80)


@dataclass
class Heard:
    """A packet from the vehicle."""

    at: float
    frame: Frame | Garbled


class Rig:
    """One vehicle and its scripted controller, in virtual time. Every ENQ that ``acknowledges`` is acknowledged at once."""

    def __init__(
        self,
        vehicle: SimulatedVehicle,
        dialect: Dialect = DEFAULT,
    ) -> None:
        self.vehicle = vehicle
        self.codec = Codec(dialect)
        self.now = 0.0
        self.heard: list[Heard] = []
        self.acknowledges: Callable[[Enq], bool] = lambda _: True
        self.last_id = 0
        self.up = False
        self.closed = 0
        self._decoder = Decoder(self.codec, Toward.CONTROLLER)
        self.connect()

    def connect(self) -> None:
        """Connect, whether the vehicle likes it or not."""
        self._decoder = Decoder(self.codec, Toward.CONTROLLER)
        self.up = True
        self.vehicle.connected(Seconds(self.now))
        self._pump()

    def cut(self) -> None:
        """Cut the line."""
        self.up = False
        self.vehicle.disconnected(Seconds(self.now), "cut")

    def raw(self, data: bytes) -> None:
        """Send bytes as they are."""
        self.vehicle.received(data, Seconds(self.now))
        self._pump()

    def packet(self, code: int, body: Body = NOTHING, cmd_id: int | None = None) -> bytes:
        """Make a command's packet; without an id under a new one, which ``last_id`` then is."""
        if cmd_id is None:
            self.last_id += 1
            cmd_id = self.last_id
        kind = Etb if body.form in SUB_FORMS else Enq
        return self.codec.encode(kind(DEV_ID, cmd_id, code, body), strict=False)

    def send(self, code: int, body: Body = NOTHING, cmd_id: int | None = None) -> int:
        """Send a command and return its CMD_ID."""
        self.raw(self.packet(code, body, cmd_id))
        return self.last_id if cmd_id is None else cmd_id

    def do(self, code: int, body: Body = NOTHING, *, within: float = 20.0) -> int:
        """Send a command and live on until it is answered; return RESULT."""
        cmd_id = self.send(code, body)
        self.until(lambda: self.result(cmd_id) is not None, within)
        result = self.result(cmd_id)
        assert result is not None
        return result

    def move(self, *barcodes: int, stop: int = Action.STOP_PORT, speed: int = 80) -> int:
        """Send a MOVE and return its CMD_ID."""
        return self.send(Code.MOVE, Move(path(*barcodes, stop=stop, speed=speed), "FOUP1", "A", "B"))

    def xmove(self, first: int, *barcodes: int, stop: int = Action.STOP_PORT) -> int:
        """Send an XMOVE from a SEQ on and return its CMD_ID."""
        return self.send(Code.XMOVE, Xmove(path(*barcodes, stop=stop, first=first)))

    def run(self, seconds: float) -> None:
        """Let time pass."""
        self._live(self.now + seconds, lambda: False)

    def until(self, reached: Callable[[], bool], within: float = 60.0) -> None:
        """Let time pass until something is so. Fails if it is not in time."""
        self._live(self.now + within, reached)
        assert reached(), f"not within {within} s; last refusal: {self.vehicle.last_refusal!r}"

    def status(self) -> Resp2:
        """Ask STATUS and return the answer."""
        cmd_id = self.send(Code.STATUS)
        self.run(0.01)
        body = self.answers(cmd_id)[-1].body
        assert isinstance(body, Resp2)
        return body

    def acks(self, cmd_id: int) -> int:
        """How often the vehicle acknowledged a command."""
        return sum(isinstance(h.frame, Ack) and h.frame.cmd_id == cmd_id for h in self.heard)

    def answers(self, cmd_id: int) -> list[Enq]:
        """The answers to a command, repetitions too."""
        return [h.frame for h in self.heard if isinstance(h.frame, Enq) and h.frame.cmd_id == cmd_id]

    def answer(self, cmd_id: int) -> Resp1:
        """The one RESP1 to a command."""
        (answer,) = self.answers(cmd_id)
        assert isinstance(answer.body, Resp1)
        return answer.body

    def result(self, cmd_id: int) -> int | None:
        """RESULT of a command; None before its answer."""
        bodies = [answer.body for answer in self.answers(cmd_id)]
        return next((body.result for body in bodies if isinstance(body, Resp1)), None)

    def events(self, since: int = 0) -> list[Resp2]:
        """The STATUS events among what was heard from some packet on."""
        enqs = [h.frame for h in self.heard[since:] if isinstance(h.frame, Enq)]
        return [enq.body for enq in enqs if enq.cmd_id & EVENT and isinstance(enq.body, Resp2)]

    def taught(self) -> list[tuple[int, int, object]]:
        """The teaching events: code, position, barcode; repetitions too."""
        enqs = [h.frame for h in self.heard if isinstance(h.frame, Enq)]
        return [(enq.code, enq.body.pos, enq.body.barcode) for enq in enqs if isinstance(enq.body, Teach)]

    def order(self) -> list[str]:
        """Everything heard, in short: ``ack 1``, ``answer 1``, ``event``."""
        return [_short(h.frame) for h in self.heard]

    def ready(self, mode: Mode = Mode.AUTO) -> "Rig":
        """Make the vehicle ready in a mode, and forget what was heard until then."""
        self.vehicle.make_ready(Seconds(self.now), mode)
        self.run(0.1)
        self.heard.clear()
        return self

    def _live(self, end: float, reached: Callable[[], bool]) -> None:
        self._pump()
        while not reached():
            deadline = self.vehicle.deadline
            if deadline is None or deadline > end:
                self.now = end
                self.vehicle.tick(Seconds(end))
                self._pump()
                return
            self.now = max(self.now, deadline)
            self.vehicle.tick(Seconds(self.now))
            self._pump()

    def _pump(self) -> None:
        while packet := self.vehicle.outgoing():
            if not self.up:
                continue
            for frame in self._decoder.feed(packet):
                self.heard.append(Heard(self.now, frame))
                if isinstance(frame, Enq) and self.acknowledges(frame):
                    self.vehicle.received(self.codec.ack(frame.dev_id, frame.cmd_id), Seconds(self.now))
        if self.vehicle.wants_close and self.up:
            self.closed += 1
            self.cut()


def _short(frame: Frame | Garbled) -> str:
    if isinstance(frame, Garbled):
        return "garbled"
    if isinstance(frame, Ack):
        return f"ack {frame.cmd_id}"
    if frame.cmd_id & EVENT:
        return "event"
    return f"answer {frame.cmd_id}"


def make_rig(
    *,
    start: str = "1201",
    options: Options | None = None,
    dialect: Dialect = DEFAULT,
    places: Places | None = None,
    track: Track | None = None,
) -> Rig:
    """A rig in the start-up state; ``ready`` makes more of it."""
    vehicle = SimulatedVehicle(
        spec(), track or small_track(), dialect=dialect, surroundings=places, options=options, start=Barcode(start)
    )
    return Rig(vehicle, dialect)
