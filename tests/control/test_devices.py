"""Commands to devices through the whole controller: durable before the first byte, and looked at once more before they leave."""

from pathlib import Path

from app.control import Control
from app.domain.device_requests import CommandDevice
from app.domain.devices import DeviceAct
from app.domain.ids import Actor, VehicleId
from app.domain.records import Intent, IntentState, Record
from app.domain.units import Barcode, Seconds, Timestamp
from app.plant import read
from app.protocols.enig.simulator import SimulatedLink
from app.sim.halls import SimulatedHalls
from app.sim.memory import MemoryLedger
from tests.fleet.hall_plants import DOOR1, HALL, ring

KIM = Actor("kim")
PLANTS = Path(__file__).parents[2] / "plants"


class HallBench:
    """A controller and its hall on one table; bytes pass at once, commits when the test says so."""

    def __init__(self) -> None:
        self.now = Seconds(0.0)
        self.kept: list[Record] = []
        self.far = SimulatedHalls(ring(), {}, self.now)
        self.control = Control(ring(), MemoryLedger().load(), self.now, Timestamp(0.0))
        self.near = self.control.endpoint(HALL)
        line = self.far.lines[HALL]
        assert isinstance(line, SimulatedLink)
        self.line = line
        self.line.connected(self.now)
        self.near.connected(self.now)
        self.run(1.5)

    def run(self, seconds: float) -> None:
        end = self.now + seconds
        while self.now < end:
            self.now = Seconds(self.now + 0.1)
            self.line.tick(self.now)
            self.control.tick(self.now)
            self.near.tick(self.now)
            self.commit()
            self.exchange()

    def commit(self) -> None:
        for transaction in self.control.transactions():
            self.kept += transaction.records
            self.control.committed(transaction.number, self.now)

    def exchange(self) -> bytes:
        sent = b""
        while True:
            out, back = self.near.outgoing(), self.line.outgoing()
            if not out and not back:
                return sent
            sent += out
            self.line.received(out, self.now)
            self.near.received(back, self.now)

    def last(self) -> Intent:
        return next(r for r in reversed(self.kept) if isinstance(r, Intent))


def test_no_byte_leaves_before_the_intent_is_durable() -> None:
    bench = HallBench()
    bench.control.ask(CommandDevice(KIM, DOOR1, DeviceAct.OPEN), bench.now)
    assert bench.exchange() == b""
    bench.commit()
    assert bench.exchange().hex() == "02011e016e5803"
    bench.run(4)
    assert (bench.last().kind, bench.last().state) == ("open", IntentState.DONE)
    assert bench.control.link_frames(HALL)[0][1] in {"in", "out"}


def test_a_close_that_somebody_has_overtaken_while_it_was_written_down_does_not_leave() -> None:
    bench = HallBench()
    bench.control.fleet.books.roll_call.clear()
    bench.control.ask(CommandDevice(KIM, DOOR1, DeviceAct.OPEN), bench.now)
    bench.run(4)
    bench.control.ask(CommandDevice(KIM, DOOR1, DeviceAct.CLOSE), bench.now)
    bench.control.fleet.books.traffic.hold(VehicleId("V001"), [Barcode("107")])
    bench.commit()
    assert bench.exchange() == b""
    bench.commit()
    assert (bench.last().kind, bench.last().state) == ("close", IntentState.NOT_SENT)
    assert bench.last().outcome == "V001 may be in it"
    assert bench.far.doors[DOOR1].is_open


def test_a_link_that_was_never_reached_says_why_and_one_that_was_why_it_was_lost() -> None:
    plant, _ = read((PLANTS / "hall.yaml").read_text(encoding="utf-8"), "hall.yaml")
    control = Control(plant, MemoryLedger().load(), Seconds(0.0), Timestamp(0.0))
    hall, axes = (link.id for link in plant.links)
    control.unreachable(hall, "Connection refused", Seconds(0.5))
    control.unreachable(hall, "no answer in 3 s", Seconds(4.0))
    assert {link.id: link.reason for link in control.links()} == {hall: "no answer in 3 s", axes: "not connected yet"}
    assert {vehicle.link_reason for vehicle in control.fleet.books.vehicles.values()} == {"no answer in 3 s"}
    bench = HallBench()
    bench.near.disconnected(bench.now, "the connection was closed")
    bench.control.unreachable(HALL, "Connection refused", bench.now)
    assert [link.reason for link in bench.control.links()] == ["the connection was closed"]
