"""PROTOCOLS section 8, S1 to S19: modes, MOVE, XMOVE, stops. Against the simulated vehicle, with a scripted controller."""

import pytest

from app.domain.units import Barcode, Seconds
from app.protocols.itsc.messages import Ack, Action, Code, Element, Enq, Mode, Move, Oper, Resp2
from tests.scenarios.rig import Rig, path


@pytest.mark.parametrize("mode", [Mode.MANT, Mode.SEMI, Mode.AUTO])
def test_s1_status_is_acknowledged_then_answered_under_the_same_id_in_any_mode(rig: Rig, mode: Mode) -> None:
    rig.ready(mode)
    begun = rig.now
    asked = rig.send(Code.STATUS)
    rig.run(1)
    assert [type(heard.frame) for heard in rig.heard] == [Ack, Enq]
    (answer,) = rig.answers(asked)
    assert isinstance(answer.body, Resp2)
    assert answer.body.status2.mode is mode
    assert all(heard.at - begun < 0.0051 for heard in rig.heard)


def test_s2_move_in_mant_is_refused_and_nothing_moves(rig: Rig) -> None:
    rig.ready(Mode.MANT)
    move = rig.move(1201, 1202)
    rig.run(5)
    assert rig.order() == [f"ack {move}", f"answer {move}"]
    assert rig.result(move) == 1
    assert rig.vehicle.place(Seconds(rig.now)) == ("1201", 0, None)


def test_s3_servo_off_in_auto_is_refused(rig: Rig) -> None:
    assert rig.do(Code.SERVO_OFF) == 1
    assert rig.status().status2.servos_on


def test_s4_stop_by_host_in_semi_is_done_and_the_mode_stays(rig: Rig) -> None:
    rig.ready(Mode.SEMI)
    assert rig.do(Code.STOP_BY_HOST) == 0
    assert rig.status().status2.mode is Mode.SEMI
    assert not rig.events()


def test_s5_move_in_semi_is_refused(rig: Rig) -> None:
    rig.ready(Mode.SEMI)
    assert rig.do(Code.MOVE, Move(path(1201, 1202))) == 1


def test_s6_auto_is_answered_and_then_reported(fresh: Rig) -> None:
    assert fresh.do(Code.SERVO_ON) == 0
    assert fresh.do(Code.SEARCH_HOME) == 0
    fresh.heard.clear()
    auto = fresh.send(Code.AUTO)
    fresh.run(1)
    assert fresh.order() == [f"ack {auto}", f"answer {auto}", "event"]
    assert fresh.result(auto) == 0
    assert fresh.events()[0].status2.mode is Mode.AUTO


def test_s7_auto_without_all_axes_at_home_is_refused(fresh: Rig) -> None:
    assert fresh.do(Code.AUTO) == 1
    assert fresh.status().status2.mode is Mode.MANT


def test_s8_stop_leads_to_mant_and_is_reported(rig: Rig) -> None:
    stop = rig.send(Code.STOP)
    rig.run(1)
    assert rig.order() == [f"ack {stop}", f"answer {stop}", "event"]
    assert rig.result(stop) == 0
    assert rig.events()[0].status2.mode is Mode.MANT


def test_s9_a_move_reports_each_step_and_is_answered_on_arrival(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(10)
    assert rig.order() == [f"ack {move}", "event", "event", f"answer {move}"]
    assert [(event.seq, event.barcode) for event in rig.events()] == [(1, 1202), (2, 1203)]
    assert rig.events()[0].status1.word == 0x08111134
    assert rig.events()[0].status2.word == 0xEF002100
    answer = rig.answer(move)
    assert (answer.result, answer.seq, answer.barcode) == (0, 2, 1203)
    status = rig.status()
    assert status.status1.trav == 1
    assert status.status2.oper is Oper.IDLE
    assert status.status2.code == 0


def test_s10_a_second_move_is_refused_and_the_first_goes_on(rig: Rig) -> None:
    first = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    assert rig.do(Code.MOVE, Move(path(1201, 1202))) == 1
    rig.run(10)
    assert rig.result(first) == 0
    assert rig.status().barcode == 1203


def test_s11_an_xmove_at_seq_0_leads_the_move_to_another_end(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.3)
    xmove = rig.xmove(1, 1301, 1302)
    rig.run(0.01)
    assert rig.result(xmove) == 0
    assert rig.result(move) is None
    rig.run(10)
    answer = rig.answer(move)
    assert (answer.result, answer.seq, answer.barcode) == (0, 2, 1302)


def test_s12_an_xmove_from_an_earlier_seq_goes_on_behind_the_present_one(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.until(lambda: len(rig.events()) == 1)
    xmove = rig.xmove(0, 1201, 1202, 1203, 1204)
    rig.run(10)
    assert rig.result(xmove) == 0
    assert [(event.seq, event.barcode) for event in rig.events()] == [(1, 1202), (2, 1203), (3, 1204)]
    assert rig.answer(move).barcode == 1204


def test_s13_an_xmove_after_arrival_is_refused(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.until(lambda: rig.result(move) == 0)
    xmove = rig.xmove(2, 1203, 1204)
    rig.run(5)
    assert rig.result(xmove) == 1
    assert rig.status().barcode == 1203


def test_s14_an_xmove_within_braking_distance_is_refused_and_the_move_ends_normally(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    # 80 % of 3 m/s brakes in 0.96 m at 3 m/s².
    rig.until(lambda: rig.vehicle.place(Seconds(rig.now))[:1] == ("1202",))
    rig.run(0.46)
    assert rig.vehicle.place(Seconds(rig.now))[1] > 2000 - 960
    xmove = rig.xmove(2, 1203, 1204)
    rig.run(5)
    assert rig.result(xmove) == 1
    assert (rig.answer(move).result, rig.answer(move).barcode) == (0, 1203)


def test_s15_stop_by_host_fails_the_move_then_is_answered_and_the_path_is_gone(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    stop = rig.send(Code.STOP_BY_HOST)
    rig.run(5)
    assert rig.order() == [f"ack {move}", f"ack {stop}", f"answer {move}", f"answer {stop}"]
    assert (rig.result(move), rig.result(stop)) == (1, 0)
    status = rig.status()
    assert (status.status2.mode, status.status2.oper, status.status1.trav) == (Mode.AUTO, Oper.IDLE, 0)
    xmove = rig.xmove(1, 1202, 1203)
    rig.run(1)
    assert rig.result(xmove) == 1


def test_s16_after_a_stop_a_new_move_starts_at_the_new_place_with_seq_0(rig: Rig) -> None:
    rig.move(1201, 1202, 1203)
    rig.until(lambda: len(rig.events()) == 1)
    rig.do(Code.STOP_BY_HOST)
    assert rig.vehicle.place(Seconds(rig.now))[0] == "1202"
    move = rig.move(1202, 1203, 1204)
    rig.run(0.01)
    assert rig.status().seq == 0
    rig.run(10)
    assert (rig.answer(move).result, rig.answer(move).seq, rig.answer(move).barcode) == (0, 2, 1204)


def _wrong_moves() -> dict[str, Move]:
    running = [Element(1201, 0, 3, Action.RUN, 80), Element(1202, 1, 3, Action.RUN, 80)]
    return {
        "SEQ from 1": Move(path(1201, 1202, first=1)),
        "last is run": Move(running),
        "speed 0": Move(path(1201, 1202, speed=0)),
        "COUNT": Move(path(1201, 1202), count=3),
        "LENGTH": Move(path(1201, 1202), length=64 + 12),
    }


@pytest.mark.parametrize("wrong", _wrong_moves())
def test_s17_an_unsound_move_is_refused(rig: Rig, wrong: str) -> None:
    assert rig.do(Code.MOVE, _wrong_moves()[wrong]) == 1
    assert rig.status().status2.oper is Oper.IDLE


def test_s18_a_broken_sub_packet_is_not_acknowledged_and_its_repetition_is_carried_out_once(rig: Rig) -> None:
    packet = rig.packet(Code.MOVE, Move(path(1201, 1202)))
    rig.raw(packet[:-1] + bytes([packet[-1] ^ 1]))
    rig.run(1)
    assert not rig.heard
    rig.raw(packet)
    rig.run(5)
    assert rig.order() == ["ack 1", "event", "answer 1"]


def test_s19_a_move_sent_twice_is_acknowledged_twice_and_carried_out_once(rig: Rig) -> None:
    packet = rig.packet(Code.MOVE, Move(path(1201, 1202)))
    rig.raw(packet)
    rig.run(0.2)
    rig.raw(packet)
    rig.run(5)
    assert rig.order() == ["ack 1", "ack 1", "event", "answer 1"]
    rig.raw(packet)
    rig.run(5)
    assert rig.order()[4:] == ["ack 1", "answer 1"]
    first, again = rig.answers(1)
    assert first == again
    assert rig.vehicle.place(Seconds(rig.now))[0] == Barcode("1202")


def test_nothing_is_acknowledged_of_a_header_whose_sub_packet_has_not_come(rig: Rig) -> None:
    packet = rig.packet(Code.MOVE, Move(path(1201, 1202)))
    rig.raw(packet[:33])
    rig.run(0.1)
    assert not rig.heard
    rig.raw(packet[33:])
    rig.run(0.01)
    assert rig.order() == ["ack 1"]
