"""A whole controller and simulated vehicles on one table: bytes pass at once, commits when the test says so."""

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from app.control import Control, Transaction
from app.domain.errors import Refusal
from app.domain.ids import DevId, StationId, VehicleId
from app.domain.layout import Edge, Plant, Point, PulseSet, Station, StationKind, VehicleSpec
from app.domain.records import HistoryEvent, Intent, Record
from app.domain.requests import Accepted, Reply, Request
from app.domain.units import Barcode, Millimetres, Percent, Pulses, Seconds, Timestamp
from app.domain.view import Update
from app.fleet.vehicle import VehicleNow
from app.plant.dialects import dialect_of
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import Ack, Code, Enq, Etb, Frame, Resp1, Toward
from app.protocols.itsc.simulator import Options, SimulatedVehicle, Track
from app.protocols.itsc.simulator.faults import Faulty
from app.sim.memory import MemoryLedger
from app.sim.truth import Truth
from app.wire.faults import Fault, Lane

V1 = VehicleId("V1")
UTC = 1_000_000_000.0
LINE = ("1201", "1202", "1203", "1204", "1205", "1206", "1207", "1208", "1209", "1210", "1301", "1302")
HOME = PulseSet(Pulses(0), Pulses(0), Pulses(0))


def line_plant(max_count: int = 100) -> Plant:
    """Return a loop of twelve barcodes, two metres apart, with a port at 1203, a side buffer at 1205, and V1 at 1201."""
    half = len(LINE) // 2
    spots = [(2000 * n, 0) for n in range(half)] + [(2000 * n, 2000) for n in reversed(range(half))]
    points = tuple(Point(Barcode(b), Millimetres(x), Millimetres(y)) for b, (x, y) in zip(LINE, spots, strict=True))
    ring = zip(LINE, (*LINE[1:], LINE[0]), strict=True)
    edges = tuple(Edge(Barcode(a), Barcode(b), Millimetres(2000)) for a, b in ring)
    stations = (
        Station(StationId("P1"), StationKind.PORT, Barcode("1203"), speed=Percent(50), dest=HOME),
        Station(StationId("B1"), StationKind.SBFL, Barcode("1205"), speed=Percent(50)),
    )
    vehicle = VehicleSpec(
        id=V1,
        dev_id=DevId(1),
        length=Millimetres(1000),
        max_count=max_count,
        start=Barcode("1201"),
        offset=HOME,
    )
    return Plant("line", points, edges, stations=stations, vehicles=(vehicle,), carriers=())


@dataclass
class Heard:
    """A packet on the line: when, ``>`` to the vehicle or ``<`` from it, and what it says."""

    when: float
    way: str
    frame: Frame


class Bench:
    """One vehicle and its controller. ``line`` is all that passed, ``kept`` all that is durable.

    ``durable`` False holds every commit back until ``commit`` is called.
    """

    def __init__(self, plant: Plant | None = None, options: Options | None = None, *, ready: bool = True) -> None:
        self.plant = plant or line_plant()
        self.now = Seconds(0.0)
        self.durable = True
        self.ledger = MemoryLedger()
        self.kept: list[Record] = []
        self.line: list[Heard] = []
        self.updates: list[Update] = []
        self.replies: dict[int, Reply] = {}
        self.waiting: list[Transaction] = []
        self.truth = Truth(self.plant)
        self.spec = self.plant.vehicles[0]
        dialect = dialect_of(self.plant, self.spec.dialect)
        self.vehicle = SimulatedVehicle(
            self.spec, Track.of(self.plant), dialect=dialect, surroundings=self.truth, options=options
        )
        self.lane_in, self.lane_out = Lane(Random(1)), Lane(Random(2))
        self.device = Faulty(self.vehicle, self.lane_out, self.lane_in)
        self._decoders = {
            way: Decoder(Codec(dialect), toward) for way, toward in ((">", Toward.VEHICLE), ("<", Toward.CONTROLLER))
        }
        self.linked = False
        self.control = self._begin()
        if ready:
            self.vehicle.make_ready(self.now)
            self.connect()
            self.run(4.0)
            self.line.clear()

    def _begin(self) -> Control:
        self.control = Control(self.plant, self.ledger.load(), self.now, Timestamp(UTC + self.now))
        self.pump()
        return self.control

    def restart(self) -> None:
        """Kill the controller and start another on what is durable."""
        self.cut()
        self.waiting.clear()
        self._begin()
        self.connect()

    # -- the line ---------------------------------------------------------------------------------------------------------

    def connect(self) -> None:
        """Plug the line in."""
        self.linked = True
        for decoder in self._decoders.values():
            decoder.flush()
        self.device.connected(self.now)
        self.control.endpoint(V1).connected(self.now)
        self.pump()

    def cut(self) -> None:
        """Lose the line."""
        self.linked = False
        self.device.disconnected(self.now, "cut")
        self.control.endpoint(V1).disconnected(self.now, "cut")
        self.pump()

    def pump(self) -> None:
        """Carry everything to where it belongs until nobody has anything to say."""
        while self._exchange() or self._carry():
            pass

    def _exchange(self) -> bool:
        end, moved = self.control.endpoint(V1), False
        while data := end.outgoing():
            moved = True
            if self.linked:
                self._note(">", data)
                self.device.received(data, self.now)
        while data := self.device.outgoing():
            moved = True
            if self.linked:
                self._note("<", data)
                end.received(data, self.now)
        return moved

    def _note(self, way: str, data: bytes) -> None:
        for frame in self._decoders[way].feed(data):
            if isinstance(frame, Ack | Enq | Etb):
                self.line.append(Heard(self.now, way, frame))

    def _carry(self) -> bool:
        self.waiting += self.control.transactions()
        if self.durable and self.waiting:
            self.commit()
            return True
        self.control.dirty()
        self.updates += self.control.updates()
        self.replies.update(self.control.replies())
        return False

    def commit(self) -> None:
        """Make everything that waits durable."""
        batch, self.waiting = self.waiting, []
        records = [record for transaction in batch for record in transaction.records]
        self.ledger.commit(records)
        self.kept += records
        self.control.committed(batch[-1].number, self.now)

    # -- time -------------------------------------------------------------------------------------------------------------

    def run(self, seconds: float) -> None:
        """Let time pass, from deadline to deadline."""
        end = self.now + seconds
        while (due := self._due()) <= end:
            self.now = Seconds(max(due, self.now))
            self.device.tick(self.now)
            if self.control.endpoint(V1).deadline is not None:
                self.control.endpoint(V1).tick(self.now)
            self.control.tick(self.now)
            self.pump()
            self._hang_up()
        self.now = Seconds(end)

    def _due(self) -> float:
        deadlines = (self.device.deadline, self.control.endpoint(V1).deadline, self.control.deadline)
        return max(min(d for d in deadlines if d is not None), self.now + 0.001)

    def _hang_up(self) -> None:
        if self.linked and (self.device.wants_close or self.control.endpoint(V1).wants_close):
            self.cut()

    def until(self, condition: Callable[[], bool], at_most: float = 120.0) -> None:
        """Let time pass until something is so."""
        end = self.now + at_most
        while not condition():
            assert self.now < end, "it does not happen"
            self.run(0.05)

    # -- requests and what came of them -----------------------------------------------------------------------------------

    def ask(self, request: Request) -> Reply:
        """Ask and return the reply."""
        ticket = self.control.ask(request, self.now)
        self.pump()
        return self.replies[ticket]

    def accept(self, request: Request) -> Accepted:
        """Ask for something that must be accepted."""
        reply = self.ask(request)
        assert isinstance(reply, Accepted), reply
        return reply

    def refuse(self, request: Request) -> Refusal:
        """Ask for something that must be refused."""
        reply = self.ask(request)
        assert isinstance(reply, Refusal), reply
        return reply

    @property
    def known(self) -> VehicleNow:
        """What the fleet knows of the vehicle."""
        return self.control.fleet.books.vehicles[V1]

    @property
    def hold(self) -> str:
        """Why the vehicle is on hold."""
        return self.known.record.hold.reason if self.known.record.hold else ""

    def intents(self, kind: str) -> list[Intent]:
        """Return the newest state of each intent of a kind, oldest first."""
        found = {r.cmd_id: r for r in self.kept if isinstance(r, Intent) and r.kind == kind}
        return list(found.values())

    def events(self) -> list[str]:
        """Return the durable events."""
        return [record.event for record in self.kept if isinstance(record, HistoryEvent)]

    def sent(self, *codes: Code) -> list[Enq | Etb]:
        """Return the commands with these codes on the line, each transmission."""
        return [h.frame for h in self.line if h.way == ">" and isinstance(h.frame, Enq | Etb) and h.frame.code in codes]

    def answers(self, code: Code) -> list[int]:
        """Return the RESULTs of RESP1 with this code, in order."""
        return [
            h.frame.body.result
            for h in self.line
            if h.way == "<" and isinstance(h.frame, Enq) and isinstance(h.frame.body, Resp1) and h.frame.code == code
        ]

    def acks(self, cmd_id: int, way: str = "<") -> int:
        """Return how often a packet was acknowledged."""
        return sum(1 for h in self.line if h.way == way and isinstance(h.frame, Ack) and h.frame.cmd_id == cmd_id)

    def spoil(self, fault: Fault, code: Code) -> None:
        """Let a fault befall the next packet to the vehicle with this code."""
        self.lane_in.strike(fault, lambda packet: packet[13:15] == int(code).to_bytes(2, "big"))

    def lose_answer(self, code: Code, times: int = 4) -> None:
        """Lose RESP1 with this code on its way from the vehicle, so many transmissions of it."""
        for _ in range(times):
            self.lane_out.strike(Fault.DROP, lambda packet: packet[13:15] == int(code).to_bytes(2, "big"))
