"""Scenarios S9 to S19 from the controller's side: the real session and fleet against a simulated vehicle, through bytes."""

import pytest

from app.domain.commands import Plain
from app.domain.ids import Actor
from app.domain.layout import StopAction
from app.domain.records import IntentState
from app.domain.requests import CommandVehicle, MoveVehicle, ReleaseVehicle, Verdict
from app.domain.units import Barcode
from app.protocols.itsc.messages import Code, Enq, Mode, Move, Resp2, Xmove
from app.wire.faults import Fault
from tests.control.bench import V1, Bench, line_plant

KIM = Actor("kim")
STOP_AT_PORT = 2


@pytest.fixture
def bench() -> Bench:
    """V1 in AUTO, idle at 1201, of a plant whose vehicles take three elements at a time."""
    return Bench()


@pytest.fixture
def short() -> Bench:
    """The same, but paths of at most four elements: longer ways need XMOVE."""
    return Bench(line_plant(max_count=5))


def go(bench: Bench, barcode: str, action: StopAction = StopAction.STOP) -> None:
    """Send the vehicle to a barcode."""
    bench.accept(MoveVehicle(KIM, V1, Barcode(barcode), action))


def paths(bench: Bench) -> list[list[tuple[int, int]]]:
    """Return SEQ and barcode of every path sent, each transmission."""
    return [
        [(e.seq, int(e.barcode)) for e in frame.body.path]
        for frame in bench.sent(Code.MOVE, Code.XMOVE)
        if isinstance(frame.body, Move | Xmove)
    ]


def seqs(bench: Bench) -> list[int]:
    """Return the SEQ of each unasked STATUS, in order."""
    return [
        h.frame.body.seq
        for h in bench.line
        if h.way == "<" and isinstance(h.frame, Enq) and isinstance(h.frame.body, Resp2) and h.frame.cmd_id >> 63
    ]


def test_s9_a_move_to_a_port_is_acknowledged_followed_by_seq_and_answered_on_arrival(bench: Bench) -> None:
    go(bench, "1203", StopAction.PORT)
    bench.run(10.0)
    (move,) = bench.sent(Code.MOVE)
    assert isinstance(move.body, Move)
    assert [(e.seq, e.barcode) for e in move.body.path] == [(0, 1201), (1, 1202), (2, 1203)]
    assert move.body.path[-1].action == STOP_AT_PORT
    assert bench.acks(move.cmd_id) == 1
    assert seqs(bench) == [1, 2]
    assert bench.answers(Code.MOVE) == [0]
    (intent,) = bench.intents("move")
    assert intent.state is IntentState.DONE
    assert bench.known.barcode == "1203"
    assert bench.known.status is not None
    assert bench.known.status.seq == 2
    assert bench.known.stopped is StopAction.PORT


def test_s10_while_a_move_runs_no_second_one_is_sent_and_another_goal_is_reached_by_xmove(bench: Bench) -> None:
    go(bench, "1203")
    bench.until(lambda: bench.vehicle.state.driving)
    go(bench, "1204")
    bench.run(15.0)
    assert len(bench.sent(Code.MOVE)) + len(bench.sent(Code.XMOVE)) == 2
    assert all(answer == 0 for answer in bench.answers(Code.MOVE) + bench.answers(Code.XMOVE))
    assert bench.vehicle.place(bench.now)[0] == "1204"


def test_s11_an_xmove_is_answered_at_once_and_the_move_at_the_new_end(short: Bench) -> None:
    go(short, "1207")
    short.run(20.0)
    (move,) = short.sent(Code.MOVE)
    first = short.sent(Code.XMOVE)[0]
    assert isinstance(move.body, Move)
    assert isinstance(first.body, Xmove)
    assert first.body.path[0].seq == move.body.path[-1].seq
    assert first.body.path[0].barcode == move.body.path[-1].barcode
    order = [
        h.frame.code
        for h in short.line
        if h.way == "<" and isinstance(h.frame, Enq) and h.frame.code in {Code.MOVE, Code.XMOVE}
    ]
    assert order[0] == Code.XMOVE
    assert order[-1] == Code.MOVE
    assert set(short.answers(Code.XMOVE)) == {0}
    assert short.answers(Code.MOVE) == [0]
    assert short.vehicle.place(short.now)[0] == "1207"
    assert {i.state for i in short.intents("xmove")} == {IntentState.DONE}


def test_s12_the_vehicle_goes_on_in_the_new_list_with_seq_rising_by_one(short: Bench) -> None:
    go(short, "1210")
    short.run(30.0)
    assert seqs(short) == list(range(1, 10))
    assert all(p == list(range(p[0], p[0] + len(p))) for p in [[s for s, _ in path] for path in paths(short)])
    assert short.vehicle.place(short.now)[0] == "1210"


def test_s13_a_vehicle_that_has_arrived_is_sent_a_fresh_move_not_an_xmove(bench: Bench) -> None:
    go(bench, "1203")
    bench.run(10.0)
    go(bench, "1205")
    bench.run(10.0)
    assert bench.sent(Code.XMOVE) == []
    assert paths(bench)[-1][0] == (0, 1203)


def test_s14_a_refused_xmove_lets_the_move_end_and_a_fresh_move_follows(short: Bench) -> None:
    go(short, "1209")
    short.until(lambda: short.vehicle.state.driving)
    short.vehicle.refuse_next()
    short.run(40.0)
    assert short.answers(Code.XMOVE)[0] == 1
    assert short.answers(Code.MOVE)[0] == 0
    refused, *_ = short.intents("xmove")
    assert refused.state is IntentState.FAILED
    moves = short.sent(Code.MOVE)
    assert len(moves) == 2
    assert isinstance(moves[1].body, Move)
    assert moves[1].body.path[0].seq == 0
    assert short.vehicle.place(short.now)[0] == "1209"
    assert short.hold == ""


def test_s15_stop_by_host_ends_the_move_the_mode_stays_and_the_vehicle_waits_for_a_person(bench: Bench) -> None:
    go(bench, "1205")
    bench.until(lambda: bench.vehicle.state.driving)
    bench.run(1.0)
    bench.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    bench.run(5.0)
    assert bench.answers(Code.MOVE) == [1]
    assert bench.answers(Code.STOP_BY_HOST) == [0]
    assert bench.vehicle.state.mode is Mode.AUTO
    assert bench.vehicle.path == ()
    assert bench.hold == "stopped by kim"
    (intent,) = bench.intents("move")
    assert intent.state is IntentState.FAILED
    assert len(bench.sent(Code.MOVE)) == 1


def test_s16_released_it_goes_on_from_the_new_place_by_a_move_that_begins_at_seq_0(bench: Bench) -> None:
    go(bench, "1205")
    bench.until(lambda: bench.vehicle.state.driving)
    bench.run(1.0)
    bench.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    bench.run(5.0)
    bench.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "nobody is there"))
    bench.run(15.0)
    assert len(bench.sent(Code.MOVE)) == 2
    assert paths(bench)[-1][0][0] == 0
    assert bench.vehicle.place(bench.now)[0] == "1205"


def test_s18_a_move_whose_sub_packet_is_damaged_is_sent_again_and_runs_once(bench: Bench) -> None:
    bench.lane_in.strike(Fault.CORRUPT, lambda packet: packet[13:15] == int(Code.MOVE).to_bytes(2, "big"))
    go(bench, "1203")
    bench.run(12.0)
    moves = bench.sent(Code.MOVE)
    assert len(moves) == 2
    assert len({m.cmd_id for m in moves}) == 1
    assert bench.acks(moves[0].cmd_id) == 1
    assert bench.answers(Code.MOVE) == [0]
    assert seqs(bench) == [1, 2]


def test_s19_a_move_that_arrives_twice_is_acknowledged_twice_and_runs_once(bench: Bench) -> None:
    bench.spoil(Fault.DUPLICATE, Code.MOVE)
    go(bench, "1203")
    bench.run(12.0)
    (move,) = bench.sent(Code.MOVE)
    assert bench.acks(move.cmd_id) == 2
    assert bench.answers(Code.MOVE) == [0]
    assert seqs(bench) == [1, 2]
    assert len(bench.intents("move")) == 1
