"""PROTOCOLS section 8, S27 to S40: teaching, alarms, restart, lost links and packets, DISPLAY."""

import pytest

from app.domain.layout import Axis
from app.domain.units import Pulses, Seconds
from app.protocols.itsc.messages import Action, Code, Disp, Enq, Mode, Move, Oper, Port
from tests.scenarios.rig import EVENT, PORT, Rig, path


def taught_position(rig: Rig) -> Rig:
    """In MANT at 1201 with the three axes away from home, as a person leaves them for teaching."""
    rig.ready(Mode.MANT)
    for axis, pulses in zip(Axis, (-1520, 900, 1_170_000), strict=True):
        rig.vehicle.jog(axis, Pulses(pulses), Seconds(rig.now))
    return rig


@pytest.mark.parametrize(
    ("command", "codes"),
    [
        (Code.PORT_DEST_TEACHING, [0x2070, 0x2072, 0x2074]),
        (Code.PORT_OFFSET_TEACHING, [0x2071, 0x2073, 0x2075]),
    ],
)
def test_s27_s28_port_teaching_sends_three_positions_in_order_then_the_answer(
    rig: Rig, command: Code, codes: list[int]
) -> None:
    taught_position(rig)
    assert rig.do(command) == 0
    assert rig.taught() == list(zip(codes, (-1520, 900, 1_170_000), [1201] * 3, strict=True))
    assert rig.order() == ["ack 1", "event", "event", "event", "answer 1"]


def test_s27_each_position_waits_for_the_acknowledgement_of_the_one_before(rig: Rig) -> None:
    taught_position(rig).acknowledges = lambda _: False
    rig.send(Code.PORT_DEST_TEACHING)
    for code in (0x2070, 0x2072, 0x2074):
        rig.run(0.5)
        assert rig.taught()[-1][0] == code
        event = rig.heard[-1].frame
        assert isinstance(event, Enq)
        rig.raw(rig.codec.ack(1, event.cmd_id))
    rig.run(0.1)
    assert len(rig.taught()) == 3
    assert rig.result(1) == 0


def test_s29_port_teaching_in_auto_is_refused_without_an_event(rig: Rig) -> None:
    assert rig.do(Code.PORT_DEST_TEACHING) == 1
    assert not rig.taught()


def test_s30_a_position_never_acknowledged_is_sent_four_times_and_ends_the_teaching(rig: Rig) -> None:
    taught_position(rig).acknowledges = lambda enq: enq.code != 0x2072
    assert rig.do(Code.PORT_DEST_TEACHING) == 1
    assert [code for code, _, _ in rig.taught()] == [0x2070] + [0x2072] * 4
    times = [heard.at for heard in rig.heard if isinstance(heard.frame, Enq) and heard.frame.code == 0x2072]
    assert [round(later - times[0], 6) for later in times] == [0, 1, 2, 3]


def test_s31_a_person_sends_one_lift_offset_and_again_if_it_is_not_acknowledged(rig: Rig) -> None:
    taught_position(rig).acknowledges = lambda _: len(rig.taught()) > 1
    rig.vehicle.teach_single(Code.LIFT_OFFSET_TEACHING, Seconds(rig.now))
    rig.run(10)
    assert rig.taught() == [(0x2075, 1_170_000, 1201)] * 2
    ids = {heard.frame.cmd_id for heard in rig.heard if isinstance(heard.frame, Enq)}
    assert len(ids) == 1
    assert all(cmd_id & EVENT for cmd_id in ids)


def test_s32_an_alarm_of_an_idle_vehicle_shows_only_in_status(rig: Rig) -> None:
    rig.vehicle.raise_alarm(55, Seconds(rig.now))
    rig.run(10)
    assert not rig.heard
    status = rig.status().status2
    assert (status.oper, status.code) == (Oper.ALARM, 55)


def test_s33_an_alarm_while_moving_fails_the_move_with_the_alarm_code(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.vehicle.raise_alarm(55, Seconds(rig.now))
    rig.run(5)
    answer = rig.answer(move)
    assert (answer.result, answer.status2.oper, answer.status2.code) == (1, Oper.ALARM, 55)
    assert rig.status().status1.trav == 0


def test_s34_alarm_clear_needs_mant_which_stop_gives(rig: Rig) -> None:
    rig.vehicle.raise_alarm(55, Seconds(rig.now))
    assert rig.do(Code.ALARM_CLEAR) == 1
    assert rig.do(Code.STOP) == 0
    assert rig.do(Code.ALARM_CLEAR) == 0
    status = rig.status().status2
    assert (status.oper, status.code) == (Oper.IDLE, 0)


def test_s34_an_alarm_whose_cause_remains_is_not_cleared(rig: Rig) -> None:
    rig.vehicle.raise_alarm(55, Seconds(rig.now), cause_remains=True)
    rig.do(Code.STOP)
    assert rig.do(Code.ALARM_CLEAR) == 1
    assert rig.status().status2.oper is Oper.ALARM
    rig.vehicle.clear_cause()
    assert rig.do(Code.ALARM_CLEAR) == 0


def test_s35_system_reset_is_acknowledged_then_the_vehicle_restarts(rig: Rig) -> None:
    rig.ready(Mode.MANT)
    begun = rig.now
    reset = rig.send(Code.SYSTEM_RESET)
    rig.until(lambda: rig.closed == 1)
    assert rig.order() == [f"ack {reset}"]
    assert round(rig.now - begun, 6) == 0.105
    accepting = [rig.vehicle.accepting]
    rig.connect()
    assert rig.closed == 2
    for seconds in (2.9, 0.2):
        rig.run(seconds)
        accepting.append(rig.vehicle.accepting)
    assert accepting == [False, False, True]
    rig.connect()
    status = rig.status()
    assert (status.status1.word, status.status2.word, status.barcode) == (0x0B11BB34, 0, 0)


def test_s36_a_cut_link_does_not_stop_the_vehicle_and_nothing_is_replayed(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.cut()
    rig.run(10)
    rig.connect()
    rig.run(5)
    assert rig.order() == [f"ack {move}"]
    status = rig.status()
    assert (status.barcode, status.seq, status.status1.trav, status.status2.oper) == (1203, 2, 1, Oper.IDLE)


def test_s37_a_command_repeated_for_a_lost_ack_is_carried_out_once(rig: Rig) -> None:
    packet = rig.packet(Code.MOVE, Move(path(1201, 1202, stop=Action.STOP_PORT)))
    rig.raw(packet)
    rig.run(0.05)
    rig.heard.clear()
    rig.raw(packet)
    rig.run(5)
    assert rig.order() == ["ack 1", "event", "answer 1"]
    assert rig.do(Code.PICKUP_FROM_PORT, PORT) == 0


def test_s38_after_giving_up_its_answer_the_vehicle_tells_the_truth_in_status(rig: Rig) -> None:
    rig.acknowledges = lambda enq: enq.code != Code.MOVE
    move = rig.move(1201, 1202)
    rig.run(20)
    assert len(rig.answers(move)) == 4
    status = rig.status()
    assert (status.barcode, status.seq, status.status2.oper) == (1202, 1, Oper.IDLE)


@pytest.mark.parametrize("mode", [Mode.AUTO, Mode.SEMI])
def test_s39_display_with_an_alarm_is_shown_and_changes_nothing(rig: Rig, mode: Mode) -> None:
    rig.ready(mode)
    assert rig.do(Code.DISPLAY_BY_HOST, Disp(0x8001, 1, "ZONE BLOCKED")) == 0
    assert rig.status().status2.oper is Oper.IDLE
    assert (rig.vehicle.state.shown_text, rig.vehicle.state.shown_alarm) == ("ZONE BLOCKED", 0x8001)
    assert rig.do(Code.DISPLAY_BY_HOST, Disp(0x8001, 0, "HELLO")) == 0
    assert (rig.vehicle.state.shown_text, rig.vehicle.state.shown_alarm) == ("HELLO", None)


def test_s40_values_outside_their_range_are_refused(rig: Rig) -> None:
    assert rig.do(Code.DISPLAY_BY_HOST, Disp(1, 2, "")) == 1
    move = rig.move(1201, 1202)
    rig.until(lambda: rig.result(move) == 0)
    assert rig.do(Code.PICKUP_FROM_PORT, Port(0, 0, 0, 16, 80)) == 1
    assert rig.do(Code.PICKUP_FROM_PORT, Port(0, 0, 0, 15, 80)) == 0
