"""A vehicle of few lines for the tests of the session: it decodes what we send and answers what a test tells it to."""

from app.domain.commands import Command, Display, Move, Pickup, Place, Plain, Send, Simple, Xmove
from app.domain.events import Event
from app.domain.ids import CmdId, CmdIds, DevId, Epoch, VehicleId
from app.domain.layout import PulseSet, StationKind, StopAction, VehicleSpec
from app.domain.route import PathElement
from app.domain.units import Barcode, Millimetres, Percent, Pulses, Seconds
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT, Dialect
from app.protocols.itsc.framing import Decoder, Garbled
from app.protocols.itsc.messages import (
    Ack,
    Body,
    Code,
    Enq,
    Etb,
    Frame,
    Resp1,
    Resp2,
    Toward,
    status1,
    status2,
)
from app.protocols.itsc.session import Session, Timing

V = VehicleId("V012")
DRIVING1, DRIVING2 = 0x08111134, 0xEF002100
STANDING1, AUTO_IDLE, MANT_IDLE, SEMI_IDLE = 0x01111134, 0xCF000000, 0x0F000000, 0x4F000000
ALARMED, PAUSED = 0xDF000065, 0xFF002100
TOP = 1 << 63


def path(*barcodes: int, first: int = 0) -> tuple[PathElement, ...]:
    """Return a path over these barcodes, stopping at a port at the last."""
    return tuple(
        PathElement(
            Barcode(str(barcode)),
            first + i,
            StopAction.RUN if i + 1 < len(barcodes) else StopAction.PORT,
            Percent(60),
            3,
            Millimetres(1500 if i + 1 < len(barcodes) else 0),
        )
        for i, barcode in enumerate(barcodes)
    )


MOVE = Move(path(1201, 1202, 1203), Seconds(10.0), "FOUP1", "A", "B")
PICKUP = Pickup(StationKind.PORT, PulseSet(Pulses(-1520), Pulses(900), Pulses(1_170_000)), 5, Percent(80))
PLACE = Place(StationKind.SBFL, None, 0, Percent(50))
DISPLAY = Display("HELLO")


def xmove(amends: CmdId) -> Xmove:
    """Return an XMOVE that leads on from SEQ 2."""
    return Xmove(path(1203, 1204, 1205, first=2), Seconds(20.0), amends)


def simple(what: Plain) -> Simple:
    """Return a command without data."""
    return Simple(what)


class Bench:
    """A session and the other end of its line."""

    def __init__(
        self, dialect: Dialect = DEFAULT, timing: Timing | None = None, barcodes: set[str] | None = None
    ) -> None:
        self.ids = CmdIds(Epoch(7))
        self.codec = Codec(dialect)
        self.session = Session(VehicleSpec(V, DevId(12)), dialect, self.ids, timing or Timing(), barcodes)
        self.decoder = Decoder(self.codec, Toward.VEHICLE)
        self.now = Seconds(100.0)
        self.events: list[Event] = []
        self.own = TOP
        self.home: int | str = "1201" if dialect.barcode_format == "ascii" else 1201

    def connect(self, word1: int = STANDING1, word2: int = AUTO_IDLE, barcode: int | str = 1201, seq: int = 0) -> None:
        """Connect, answer the first poll, and forget all that this gave."""
        self.session.connected(self.now)
        self.answer_poll(word1, word2, barcode, seq)
        self.take()

    def heard(self) -> list[Frame]:
        """Return what the session sent since the last call."""
        frames: list[Frame] = []
        for item in self.decoder.feed(self.session.outgoing()):
            assert not isinstance(item, Garbled)
            frames.append(item)
        return frames

    def commands(self) -> list[Enq | Etb]:
        """Return the commands sent since the last call, polls left out."""
        return [each for each in self.heard() if isinstance(each, Enq | Etb) and each.code != Code.STATUS]

    def polls(self) -> list[int]:
        """Return the CMD_IDs of the polls sent since the last call."""
        return [each.cmd_id for each in self.heard() if isinstance(each, Enq) and each.code == Code.STATUS]

    def acks(self) -> list[int]:
        """Return the CMD_IDs acknowledged since the last call."""
        return [each.cmd_id for each in self.heard() if isinstance(each, Ack)]

    def take(self) -> list[Event]:
        """Return and forget the events."""
        self.heard()
        return self.session.events()

    def say(self, frame: Frame) -> bytes:
        """Let the vehicle send a packet; return its bytes."""
        data = self.codec.encode(frame, strict=False)
        self.session.received(data, self.now)
        return data

    def ack(self, cmd_id: int) -> None:
        """Let the vehicle acknowledge."""
        self.say(Ack(12, cmd_id))

    def status(
        self, word1: int = STANDING1, word2: int = AUTO_IDLE, barcode: int | str = 1201, seq: int = 0, cmd_id: int = 0
    ) -> int:
        """Let the vehicle send a STATUS, as an event unless a CMD_ID is given; return its CMD_ID."""
        if not cmd_id:
            self.own += 1
            cmd_id = self.own
        dist = 450 if self.codec.dialect.has_dist else None
        self.say(Enq(12, cmd_id, Code.STATUS, Resp2(status1(word1), status2(word2), barcode, seq, dist)))
        return cmd_id

    def answer_poll(
        self, word1: int = STANDING1, word2: int = AUTO_IDLE, barcode: int | str = 1201, seq: int = 0
    ) -> None:
        """Let the vehicle answer the newest poll."""
        polls = self.polls()
        assert polls, "no poll was sent"
        self.status(word1, word2, barcode, seq, polls[-1])

    def answer(
        self, cmd_id: int, code: int, result: int = 0, word2: int = AUTO_IDLE, barcode: int = 1203, seq: int = 2
    ) -> None:
        """Let the vehicle send RESP1."""
        dist = 0 if self.codec.dialect.has_dist else None
        self.say(Enq(12, cmd_id, code, Resp1(result, status2(word2), barcode, seq, dist)))

    def event(self, code: int, body: Body, cmd_id: int = 0) -> int:
        """Let the vehicle send an ENQ of its own; return its CMD_ID."""
        if not cmd_id:
            self.own += 1
            cmd_id = self.own
        self.say(Enq(12, cmd_id, code, body))
        return cmd_id

    def send(self, command: Command) -> CmdId:
        """Send a command under a new CMD_ID."""
        cmd_id = self.ids.next()
        self.session.send(Send(V, cmd_id, command), self.now)
        return cmd_id

    def until(self, moment: float, word1: int = STANDING1, word2: int = AUTO_IDLE, seq: int = 0) -> None:
        """Let time pass up to a moment, ticking at each deadline and answering every poll at once."""
        while self.session.deadline is not None and self.session.deadline <= moment:
            self.now = max(self.now, self.session.deadline)
            self.session.tick(self.now)
            for poll in self.polls():
                self.status(word1, word2, self.home, seq, poll)
        self.now = Seconds(moment)

    def silent_until(self, moment: float) -> list[Frame]:
        """Let time pass with nothing from the vehicle; return what the session sent."""
        frames: list[Frame] = []
        while self.session.deadline is not None and self.session.deadline <= moment:
            self.now = max(self.now, self.session.deadline)
            self.session.tick(self.now)
            frames += self.heard()
        self.now = Seconds(moment)
        return frames
