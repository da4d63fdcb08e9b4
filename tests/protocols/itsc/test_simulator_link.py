"""The simulated vehicle's end of the line."""

import pytest

from app.domain.units import Seconds
from app.protocols.itsc.messages import (
    NOTHING,
    Code,
    Enq,
    Etb,
    Mode,
    Move,
    Nak,
    Oper,
    Raw,
    Resp2,
)
from app.protocols.itsc.simulator import Options
from tests.scenarios.rig import DEV_ID, Rig, make_rig, path


@pytest.fixture
def rig() -> Rig:
    """A vehicle in AUTO at 1201."""
    return make_rig().ready()


def now(rig: Rig) -> Seconds:
    return Seconds(rig.now)


def test_the_ack_comes_after_its_delay() -> None:
    rig = make_rig(options=Options(ack_delay=Seconds(0.3)))
    rig.send(Code.STATUS)
    rig.run(0.29)
    assert not rig.heard
    rig.run(0.02)
    assert [heard.at for heard in rig.heard] == [0.3, 0.3]


def test_a_foreign_dev_id_and_a_broken_packet_meet_silence(rig: Rig) -> None:
    rig.raw(rig.codec.encode(Enq(2, 77, Code.STATUS, NOTHING)))
    rig.raw(rig.packet(Code.STATUS)[:-1] + b"\0")
    rig.run(5)
    assert not rig.heard


def test_an_unknown_code_an_event_s_code_and_a_misplaced_etb_are_refused(rig: Rig) -> None:
    for frame in (
        Enq(DEV_ID, 901, 0x1234, Raw(bytes(16))),
        Enq(DEV_ID, 902, Code.LIFT_DEST_TEACHING, NOTHING),
        Enq(DEV_ID, 903, Code.MOVE, Raw(bytes(16))),
        Etb(DEV_ID, 904, Code.STOP, Raw(bytes(4) + bytes(12), b"")),
    ):
        rig.raw(rig.codec.encode(frame, strict=False))
        rig.run(0.1)
        assert rig.acks(frame.cmd_id) == 1
        (answer,) = rig.answers(frame.cmd_id)
        assert answer.code == frame.code
    assert rig.result(903) == 1
    assert rig.status().status2.mode is Mode.AUTO


def test_an_unacknowledged_answer_is_sent_four_times_a_second_apart_under_one_id(rig: Rig) -> None:
    rig.acknowledges = lambda _: False
    begun = rig.now
    asked = rig.send(Code.STATUS)
    rig.run(30)
    times = [heard.at - begun for heard in rig.heard if isinstance(heard.frame, Enq)]
    assert times == [pytest.approx(0.005 + n) for n in range(4)]
    assert len(rig.answers(asked)) == 4


def test_a_nak_has_the_packet_sent_again_at_once(rig: Rig) -> None:
    rig.acknowledges = lambda _: False
    asked = rig.send(Code.STATUS)
    rig.run(0.1)
    rig.raw(rig.codec.encode(Nak(DEV_ID, asked)))
    rig.raw(rig.codec.encode(Nak(DEV_ID, 4711)))
    rig.raw(rig.codec.ack(DEV_ID, 4711))
    assert len(rig.answers(asked)) == 2
    rig.raw(rig.codec.ack(DEV_ID, asked))
    rig.run(10)
    assert len(rig.answers(asked)) == 2


def test_the_same_id_again_repeats_an_answer_that_still_waits_for_its_ack(rig: Rig) -> None:
    rig.acknowledges = lambda _: False
    packet = rig.packet(Code.STATUS)
    rig.raw(packet)
    rig.run(0.1)
    rig.raw(packet)
    rig.run(10)
    assert rig.acks(1) == 2
    assert len(rig.answers(1)) == 5


def test_only_the_last_64_ids_are_remembered(rig: Rig) -> None:
    first = rig.send(Code.STATUS)
    rig.run(0.1)
    for _ in range(63):
        rig.status()
    rig.vehicle.panel_mode(Mode.SEMI, now(rig))
    rig.send(Code.STATUS, cmd_id=first)
    rig.run(0.1)
    assert rig.answers(first)[-1] == rig.answers(first)[0]
    rig.status()
    rig.send(Code.STATUS, cmd_id=first)
    rig.run(0.1)
    again = rig.answers(first)[-1].body
    assert isinstance(again, Resp2)
    assert again.status2.mode is Mode.SEMI


@pytest.mark.parametrize("send_nak", [True, False])
def test_a_vehicle_may_complain_of_a_bad_crc(send_nak: bool) -> None:
    rig = make_rig(options=Options(send_nak=send_nak))
    packet = rig.packet(Code.STATUS)
    rig.raw(packet[:-1] + bytes([packet[-1] ^ 1]))
    rig.raw(b"\x05\0\0\0\x02" + packet[5:-1] + bytes([packet[-1] ^ 1]))
    assert [heard.frame for heard in rig.heard] == ([Nak(DEV_ID, 1)] if send_nak else [])


def test_half_a_packet_is_given_up_after_silence(rig: Rig) -> None:
    packet = rig.packet(Code.STATUS)
    rig.raw(b"\x05" + packet[:20])
    rig.raw(packet[20:])
    assert not rig.heard
    rig.run(1)
    assert rig.order() == ["ack 1", "answer 1"]


def test_a_long_half_packet_is_given_up_byte_by_byte_until_nothing_is_left(rig: Rig) -> None:
    rig.raw(b"\x05" * 30)
    rig.run(10)
    assert not rig.heard
    assert rig.vehicle.deadline is None


def test_half_a_packet_is_forgotten_with_its_line(rig: Rig) -> None:
    packet = rig.packet(Code.STATUS)
    rig.raw(packet[:20])
    rig.cut()
    rig.connect()
    rig.raw(packet)
    rig.run(1)
    assert rig.order() == ["ack 1", "answer 1"]


def test_an_answer_to_a_command_long_forgotten_is_sent_all_the_same() -> None:
    rig = make_rig(options=Options(remembered=2)).ready()
    move = rig.move(1201, 1202)
    for _ in range(3):
        rig.status()
    rig.until(lambda: rig.result(move) == 0)


def test_a_command_whose_line_is_cut_before_the_ack_is_carried_out_unheard() -> None:
    rig = make_rig(options=Options(ack_delay=Seconds(0.3))).ready()
    packet = rig.packet(Code.MOVE, Move(path(1201, 1202)))
    rig.raw(packet)
    rig.run(0.1)
    rig.cut()
    rig.raw(packet)
    rig.run(0.1)
    rig.connect()
    rig.run(0.2)
    assert not rig.heard
    assert rig.vehicle.working is Code.MOVE


def test_an_answer_missed_without_a_connection_is_given_when_asked_for_again(rig: Rig) -> None:
    packet = rig.packet(Code.MOVE, Move(path(1201, 1202)))
    rig.raw(packet)
    rig.run(0.1)
    rig.cut()
    rig.run(10)
    rig.connect()
    rig.raw(packet)
    rig.run(1)
    assert rig.order() == ["ack 1", "ack 1", "answer 1"]
    assert rig.result(1) == 0


def test_teaching_without_a_line_fails(rig: Rig) -> None:
    rig.ready(Mode.MANT).acknowledges = lambda _: False
    job = rig.send(Code.PORT_DEST_TEACHING)
    rig.run(0.1)
    rig.cut()
    rig.run(1)
    rig.connect()
    assert rig.vehicle.working is None
    assert rig.status().status2.oper is Oper.IDLE
    assert rig.result(job) is None


def test_a_stop_ends_a_teaching(rig: Rig) -> None:
    rig.ready(Mode.MANT).acknowledges = lambda enq: enq.code != 0x2070
    job = rig.send(Code.PORT_DEST_TEACHING)
    rig.run(0.1)
    assert rig.do(Code.STOP) == 0
    rig.run(10)
    assert rig.result(job) == 1
    assert {code for code, _, _ in rig.taught()} == {0x2070}
    taught = next(h.frame for h in rig.heard if isinstance(h.frame, Enq) and h.frame.code == 0x2070)
    rig.raw(rig.codec.ack(DEV_ID, taught.cmd_id))


def test_an_ack_after_a_stop_teaches_nothing_more(rig: Rig) -> None:
    rig.ready(Mode.MANT).acknowledges = lambda enq: enq.code != 0x2070
    rig.send(Code.PORT_DEST_TEACHING)
    rig.run(0.1)
    assert rig.do(Code.STOP) == 0
    taught = next(h.frame for h in rig.heard if isinstance(h.frame, Enq) and h.frame.code == 0x2070)
    rig.raw(rig.codec.ack(DEV_ID, taught.cmd_id))
    rig.run(5)
    assert len(rig.taught()) == 1
