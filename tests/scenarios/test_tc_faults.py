"""Scenarios S30 to S38 from the controller's side: the real session and fleet against a simulated vehicle, through bytes."""

import pytest

from app.domain.commands import Plain
from app.domain.ids import Actor
from app.domain.records import IntentState, TeachingEvent
from app.domain.requests import CommandVehicle, MoveVehicle, RecoverAlarm
from app.domain.units import Barcode
from app.fleet.vehicle import Stage
from app.protocols.itsc.messages import Code, Enq, Mode
from app.wire.faults import Fault
from tests.control.bench import V1, Bench

KIM = Actor("kim")
SHFT, ROTA, LIFT, LIFT_OFFSET = 0x2070, 0x2072, 0x2074, 0x2075


@pytest.fixture
def bench() -> Bench:
    """V1 in AUTO, idle at 1201."""
    return Bench()


@pytest.fixture
def manual(bench: Bench) -> Bench:
    """V1 in MANT, standing at 1201, homed."""
    bench.vehicle.panel_mode(Mode.MANT, bench.now)
    bench.run(3.0)
    bench.line.clear()
    return bench


def go(bench: Bench, barcode: str) -> None:
    """Send the vehicle to a barcode."""
    bench.accept(MoveVehicle(KIM, V1, Barcode(barcode)))


def command(bench: Bench, what: Plain) -> None:
    """Have a person send a command."""
    bench.accept(CommandVehicle(KIM, V1, what))


def events_with(bench: Bench, code: int) -> list[Enq]:
    """Return the packets from the vehicle with this code, each transmission."""
    return [h.frame for h in bench.line if h.way == "<" and isinstance(h.frame, Enq) and h.frame.code == code]


def taught(bench: Bench) -> list[TeachingEvent]:
    """Return the teaching events that are durable."""
    return [record for record in bench.kept if isinstance(record, TeachingEvent)]


def test_s30_teaching_whose_event_is_never_durable_is_never_acknowledged_and_fails(manual: Bench) -> None:
    """ROTA cannot be written; SHFT could."""
    manual.durable = False
    manual.control.ask(CommandVehicle(KIM, V1, Plain.PORT_DEST_TEACHING), manual.now)
    manual.pump()
    manual.commit()
    manual.run(0.1)
    manual.commit()
    assert [event.code for event in taught(manual)] == [SHFT]
    manual.pump()
    manual.run(8.0)
    assert len(events_with(manual, ROTA)) == 4
    assert events_with(manual, LIFT) == []
    assert manual.answers(Code.PORT_DEST_TEACHING) == [1]
    manual.durable = True
    manual.pump()
    (intent,) = manual.intents("port_dest_teaching")
    assert intent.state is IntentState.FAILED


def test_s31_a_teaching_event_that_comes_twice_is_stored_once(manual: Bench) -> None:
    for _ in range(2):
        manual.lane_in.strike(Fault.DROP, lambda packet: packet[0] == 6)
    manual.vehicle.teach_single(Code.LIFT_OFFSET_TEACHING, manual.now)
    manual.run(6.0)
    assert len(events_with(manual, LIFT_OFFSET)) >= 2
    (event,) = taught(manual)
    assert (event.code, event.barcode, event.vehicle) == (LIFT_OFFSET, "1201", V1)


def test_s32_an_alarm_while_idle_is_found_by_the_next_poll(bench: Bench) -> None:
    bench.run(1.0)
    bench.line.clear()
    bench.vehicle.raise_alarm(300, bench.now)
    bench.run(5.0)
    assert not [h for h in bench.line if isinstance(h.frame, Enq) and h.way == "<" and h.frame.cmd_id >> 63]
    assert bench.hold == "alarm 300 (no name under alarm_codes)"
    assert "AlarmSet" in bench.events()


def test_s33_an_alarm_while_moving_fails_the_move_and_holds_the_vehicle(bench: Bench) -> None:
    go(bench, "1205")
    bench.until(lambda: bench.vehicle.state.driving)
    bench.run(1.0)
    bench.vehicle.raise_alarm(300, bench.now)
    bench.run(8.0)
    assert bench.answers(Code.MOVE) == [1]
    (intent,) = bench.intents("move")
    assert intent.state is IntentState.FAILED
    assert "300" in intent.outcome
    assert bench.hold == "alarm 300 (no name under alarm_codes)"
    assert len(bench.sent(Code.MOVE)) == 1


def test_s34_alarm_clear_is_refused_in_auto_with_what_would_help_and_recovery_does_it_all(bench: Bench) -> None:
    bench.vehicle.raise_alarm(300, bench.now)
    bench.run(5.0)
    refused = bench.refuse(CommandVehicle(KIM, V1, Plain.ALARM_CLEAR))
    assert refused.remedy.startswith("send stop first")
    assert bench.sent(Code.ALARM_CLEAR) == []
    bench.accept(RecoverAlarm(KIM, V1))
    bench.run(10.0)
    assert [f.code for f in bench.sent(Code.STOP, Code.ALARM_CLEAR, Code.SERVO_ON, Code.SEARCH_HOME, Code.AUTO)] == [
        Code.STOP,
        Code.ALARM_CLEAR,
        Code.AUTO,
    ]
    assert bench.answers(Code.ALARM_CLEAR) == [0]
    assert bench.hold == ""
    assert bench.known.fit


def test_s34_alarm_clear_by_hand_after_stop(bench: Bench) -> None:
    bench.vehicle.raise_alarm(300, bench.now)
    bench.run(5.0)
    command(bench, Plain.STOP)
    bench.run(3.0)
    command(bench, Plain.ALARM_CLEAR)
    bench.run(3.0)
    assert bench.answers(Code.ALARM_CLEAR) == [0]


def test_an_alarm_whose_cause_remains_stops_the_recovery(bench: Bench) -> None:
    bench.vehicle.raise_alarm(300, bench.now, cause_remains=True)
    bench.run(5.0)
    bench.accept(RecoverAlarm(KIM, V1))
    bench.run(10.0)
    assert bench.hold.startswith("alarm recovery stopped: alarm_clear ended abnormally")
    assert bench.sent(Code.SEARCH_HOME, Code.GO_HOME, Code.AUTO) == []
    bench.vehicle.clear_cause()
    bench.accept(RecoverAlarm(KIM, V1))
    bench.run(10.0)
    assert bench.known.fit


def test_s35_after_a_system_reset_the_vehicle_is_dialled_again_and_waits_for_its_servos(manual: Bench) -> None:
    command(manual, Plain.SYSTEM_RESET)
    manual.run(1.0)
    assert not manual.linked
    (intent,) = manual.intents("system_reset")
    assert intent.state is IntentState.DONE
    manual.run(4.0)
    assert manual.vehicle.accepting
    manual.connect()
    manual.run(4.0)
    assert manual.known.stage is Stage.SETTLING
    assert "servos off" in manual.known.waiting
    assert manual.sent(Code.MOVE, Code.SERVO_ON, Code.AUTO) == []
    manual.accept(RecoverAlarm(KIM, V1, confirmed=True))
    manual.run(10.0)
    assert manual.known.fit


def test_s36_a_vehicle_that_arrives_while_the_line_is_cut_is_known_by_its_status(bench: Bench) -> None:
    go(bench, "1203")
    bench.until(lambda: bench.vehicle.state.driving)
    bench.cut()
    bench.run(8.0)
    assert bench.vehicle.place(bench.now)[0] == "1203"
    assert bench.intents("move")[-1].state is IntentState.UNKNOWN
    bench.connect()
    bench.run(5.0)
    (intent,) = bench.intents("move")
    assert intent.state is IntentState.SETTLED_DONE
    assert len(bench.sent(Code.MOVE)) == 1
    assert set(bench.control.fleet.books.traffic.held(V1)) == {"1203"}


def test_s36_a_line_cut_while_it_drives_and_back_before_it_arrives(bench: Bench) -> None:
    go(bench, "1207")
    bench.until(lambda: bench.vehicle.state.driving)
    bench.cut()
    bench.run(0.5)
    bench.connect()
    bench.run(30.0)
    assert bench.vehicle.place(bench.now)[0] == "1207"
    assert not bench.hold
    assert not bench.control.fleet.open_intents(V1)


def test_s37_a_lost_ack_brings_the_same_command_again_and_it_runs_once(bench: Bench) -> None:
    def acknowledges_a_move(packet: bytes) -> bool:
        moves = bench.sent(Code.MOVE)
        return packet[0] == 6 and bool(moves) and packet[5:13] == moves[-1].cmd_id.to_bytes(8, "big")

    bench.lane_out.strike(Fault.DROP, acknowledges_a_move)
    go(bench, "1203")
    bench.run(12.0)
    moves = bench.sent(Code.MOVE)
    assert len({m.cmd_id for m in moves}) == 1
    assert bench.answers(Code.MOVE) == [0]
    assert bench.vehicle.place(bench.now)[0] == "1203"
    assert bench.intents("move")[0].state is IntentState.DONE


def test_s38_a_lost_answer_is_made_up_for_by_status_and_no_second_move_is_sent(bench: Bench) -> None:
    bench.lose_answer(Code.MOVE)
    go(bench, "1203")
    bench.run(60.0)
    assert bench.answers(Code.MOVE) == []
    assert len(bench.sent(Code.MOVE)) == 1
    (intent,) = bench.intents("move")
    assert intent.state is IntentState.DONE
    assert "STATUS" in intent.outcome


def test_s38_a_move_that_is_never_carried_out_nor_answered_is_decided_by_status(bench: Bench) -> None:
    """The vehicle refuses, and its refusal is lost: it stands, idle, at the beginning of its path."""
    bench.vehicle.refuse_next()
    bench.lose_answer(Code.MOVE)
    go(bench, "1203")
    bench.run(30.0)
    assert len(bench.sent(Code.MOVE)) == 1
    bench.until(lambda: len(bench.intents("move")) == 2, at_most=60.0)
    first, _ = bench.intents("move")
    assert first.state is IntentState.SETTLED_NOT_DONE
    bench.run(10.0)
    assert bench.vehicle.place(bench.now)[0] == "1203"
