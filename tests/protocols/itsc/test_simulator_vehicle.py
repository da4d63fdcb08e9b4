"""The simulated vehicle's rules beyond the scenarios: link, options, dialects, operator."""

import pytest

from app.domain.layout import Axis, StationKind
from app.domain.units import Barcode, Pulses, Seconds
from app.protocols.itsc.dialects import DIALECTS
from app.protocols.itsc.messages import (
    NOTHING,
    Ack,
    Action,
    Code,
    Element,
    Enq,
    Etb,
    Mode,
    Move,
    Nak,
    Oper,
    Raw,
    Resp2,
    Sbuf,
    Xmove,
)
from app.protocols.itsc.simulator import Options, Places, RespTiming, SimulatedVehicle, Track
from tests.scenarios.rig import DEV_ID, PORT, Rig, edge, make_rig, path, small_track, spec


@pytest.fixture
def rig() -> Rig:
    """A vehicle in AUTO at 1201."""
    return make_rig().ready()


def now(rig: Rig) -> Seconds:
    return Seconds(rig.now)


# Start-up and homing


def test_the_first_status_answer_is_the_source_s_example_byte_for_byte() -> None:
    rig = make_rig()
    rig.vehicle.received(rig.packet(Code.STATUS), Seconds(0))
    rig.vehicle.tick(Seconds(0.005))
    assert rig.vehicle.outgoing().hex() == "06000000010000000000000001" + "5c65"
    assert rig.vehicle.outgoing().hex() == (
        "05000000010000000000000001" + "7030" + "0b11bb34" + "00000000" * 3 + "0e63"
    )
    assert rig.vehicle.outgoing() == b""


def test_from_start_up_to_driving_in_the_source_s_own_words() -> None:
    rig = make_rig()
    assert rig.do(Code.SERVO_ON) == 0
    assert [(event.barcode, event.status2.at_barcode) for event in rig.events()] == [(1201, True)]
    assert rig.status().status1.word == 0x00111134
    search = rig.send(Code.SEARCH_HOME)
    rig.run(1)
    status = rig.status()
    assert (status.status1.word, status.status2.oper, status.status2.all_home) == (0x00888834, Oper.RUN, False)
    rig.until(lambda: rig.result(search) == 0)
    assert rig.do(Code.AUTO) == 0
    rig.move(1201, 1202)
    rig.run(0.3)
    status = rig.status()
    assert (status.status1.word, status.status2.word) == (0x08111134, 0xEF002100)


def test_servo_on_takes_half_a_second_search_home_two_and_go_home_one() -> None:
    rig = make_rig()
    for code, seconds in ((Code.SERVO_ON, 0.5), (Code.SEARCH_HOME, 2.0), (Code.GO_HOME, 1.0)):
        begun = rig.now
        assert rig.do(code) == 0
        assert rig.now - begun == pytest.approx(0.005 + seconds)


def test_servo_off_shows_servos_not_ready_and_keeps_what_is_known(rig: Rig) -> None:
    rig.ready(Mode.MANT)
    assert rig.do(Code.SERVO_OFF) == 0
    status = rig.status()
    assert status.status1.word == 0x0B11BB34
    assert (status.status2.servos_on, status.status2.home_known, status.status2.all_home) == (False, True, False)
    for code in (Code.SEARCH_HOME, Code.GO_HOME, Code.AUTO):
        assert rig.do(code) == 1


def test_firmware_of_document_b_shows_rota_not_ready_without_servos() -> None:
    assert make_rig(options=Options(rota_servo_codes=True)).status().status1.word == 0x0B1BBB34


def test_servo_on_in_alarm_is_refused_and_an_alarm_meanwhile_fails_it() -> None:
    rig = make_rig()
    servo = rig.send(Code.SERVO_ON)
    rig.run(0.1)
    rig.vehicle.raise_alarm(9, now(rig))
    rig.run(1)
    assert rig.result(servo) == 1
    assert rig.do(Code.SERVO_ON) == 1
    assert not rig.status().status2.servos_on


def test_servo_off_or_another_servo_on_meanwhile_fails_a_servo_on() -> None:
    rig = make_rig()
    first = rig.send(Code.SERVO_ON)
    rig.run(0.1)
    second = rig.send(Code.SERVO_ON)
    rig.run(0.1)
    assert (rig.result(first), rig.result(second)) == (1, None)
    assert rig.do(Code.SERVO_OFF) == 0
    rig.run(2)
    assert rig.result(second) == 1
    assert not rig.status().status2.servos_on


def test_servo_on_with_servos_on_reads_no_barcode_again(rig: Rig) -> None:
    rig.ready(Mode.MANT)
    assert rig.do(Code.SERVO_ON) == 0
    assert not rig.events()


def test_go_home_needs_a_known_home_and_alarms_forbid_homing() -> None:
    rig = make_rig()
    rig.do(Code.SERVO_ON)
    assert rig.do(Code.GO_HOME) == 1
    assert rig.do(Code.AUTO) == 1
    rig.vehicle.raise_alarm(9, now(rig))
    assert rig.do(Code.SEARCH_HOME) == 1


def test_stop_ends_a_homing_where_the_axes_are() -> None:
    rig = make_rig()
    rig.do(Code.SERVO_ON)
    home = rig.send(Code.SEARCH_HOME)
    rig.run(1)
    rig.heard.clear()
    stop = rig.send(Code.STOP)
    rig.run(1)
    assert rig.order() == [f"ack {stop}", f"answer {home}", f"answer {stop}"]
    assert (rig.result(home), rig.result(stop)) == (1, 0)
    status = rig.status()
    assert (status.status1.word, status.status2.home_known, status.status2.oper) == (0x00000034, False, Oper.IDLE)


def test_everything_but_the_allowed_commands_is_refused_while_busy() -> None:
    rig = make_rig()
    rig.do(Code.SERVO_ON)
    rig.send(Code.SEARCH_HOME)
    rig.run(0.1)
    for code in (Code.SERVO_OFF, Code.ALARM_CLEAR, Code.AUTO, Code.GO_HOME, Code.PORT_DEST_TEACHING):
        assert rig.do(code, within=0.1) == 1
        assert "busy" in rig.vehicle.last_refusal
    reset = rig.send(Code.SYSTEM_RESET)
    rig.run(0.1)
    assert (len(rig.answers(reset)), rig.closed) == (1, 0)
    assert rig.vehicle.working is Code.SEARCH_HOME


def test_stop_by_host_of_a_standing_vehicle_only_answers(rig: Rig) -> None:
    stop = rig.send(Code.STOP_BY_HOST)
    rig.run(1)
    assert rig.order() == [f"ack {stop}", f"answer {stop}"]


# The link


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


# Options and dialects


def test_a_vehicle_that_answers_at_acceptance_says_so_once() -> None:
    rig = make_rig(options=Options(resp_timing=RespTiming.ACCEPTANCE)).ready()
    move = rig.move(1201, 1202)
    rig.run(0.1)
    assert rig.order() == [f"ack {move}", f"answer {move}"]
    rig.run(10)
    assert (len(rig.answers(move)), rig.result(move)) == (1, 0)
    assert rig.do(Code.STOP) == 0
    assert len(rig.answers(rig.last_id)) == 1
    assert rig.do(Code.MOVE, Move(path(1202, 1203))) == 1


def test_alarm_events_report_a_change_of_oper() -> None:
    rig = make_rig(options=Options(alarm_events=True)).ready()
    rig.vehicle.raise_alarm(55, now(rig))
    rig.run(0.1)
    assert [event.status2.oper for event in rig.events()] == [Oper.ALARM]


def test_firmware_of_document_b_knows_only_one_stop_tag() -> None:
    rig = make_rig(options=Options(stop_tag_only=True)).ready()
    assert rig.do(Code.MOVE, Move(path(1201, 1202, stop=Action.STOP_SBFL))) == 0
    assert rig.status().status1.trav == 1
    assert rig.do(Code.PICKUP_FROM_SBFR, Sbuf(100)) == 0


@pytest.mark.parametrize(
    ("stop", "trav"),
    [
        (Action.STOP, 0),
        (Action.STOP_PORT, 1),
        (Action.STOP_SBFL, 2),
        (Action.STOP_SBFR, 4),
        (Action.STOP_PORT_UNPREPARED, 1),
    ],
)
def test_each_stop_shows_its_tag(rig: Rig, stop: Action, trav: int) -> None:
    assert rig.do(Code.MOVE, Move(path(1201, 1202, stop=stop))) == 0
    assert rig.status().status1.trav == trav


@pytest.mark.parametrize("name", DIALECTS)
def test_a_move_runs_in_every_dialect(name: str) -> None:
    rig = make_rig(dialect=DIALECTS[name]).ready()
    elements = path(1201, 1202, 1203)
    if DIALECTS[name].barcode_format == "ascii":
        elements = [Element(str(e.barcode), e.seq, e.sensor, e.action, e.speed) for e in elements]
    assert rig.do(Code.MOVE, Move(elements)) == 0
    assert str(rig.status().barcode) == "1203"


def test_the_slides_report_millimetres_from_the_barcode() -> None:
    rig = make_rig(dialect=DIALECTS["slides"]).ready()
    rig.move(1201, 1202)
    rig.run(0.5)
    past = rig.vehicle.place(now(rig))[1]
    answer = rig.status()
    assert answer.dist is not None
    assert 0 <= answer.dist - past < 20


def test_distance_is_answered_with_raw_data(rig: Rig) -> None:
    asked = rig.send(Code.DISTANCE)
    rig.run(0.1)
    assert rig.answers(asked)[0].body == Raw(bytes(16))


def test_in_an_ascii_dialect_no_barcode_is_no_text() -> None:
    assert make_rig(dialect=DIALECTS["ascii-barcode"]).status().barcode == ""


def test_a_barcode_that_the_dialect_cannot_write_is_a_mistake_of_the_plant() -> None:
    for dialect, barcode in (("default", "B1"), ("slides", "4294967296"), ("ascii-barcode", "1234567")):
        with pytest.raises(ValueError, match="does not fit"):
            make_rig(track=Track([edge("1201", barcode)]), dialect=DIALECTS[dialect])
    with pytest.raises(ValueError, match="no barcode of the track"):
        make_rig(start="9999")
    with pytest.raises(ValueError, match="no barcode of the track"):
        SimulatedVehicle(spec(), small_track())


# Driving


def test_a_path_may_begin_at_the_next_barcode(rig: Rig) -> None:
    move = rig.move(1202, 1203)
    rig.until(lambda: rig.result(move) == 0)
    assert [(event.seq, event.barcode) for event in rig.events()] == [(0, 1202), (1, 1203)]


def test_a_path_that_begins_elsewhere_is_refused(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1203, 1204))) == 1


def test_a_path_of_one_element_at_the_present_barcode_is_done_at_once(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1201))) == 0
    assert rig.status().status1.trav == 1
    assert not rig.events()


def test_a_path_longer_than_the_vehicle_allows_is_refused() -> None:
    vehicle = SimulatedVehicle(spec(max_count=2), small_track(), start=Barcode("1201"))
    rig = Rig(vehicle).ready()
    assert rig.do(Code.MOVE, Move(path(1201, 1202, 1203))) == 1
    move = rig.move(1201, 1202)
    rig.run(0.1)
    xmove = rig.xmove(1, 1202, 1203, 1204)
    rig.until(lambda: rig.result(move) == 0)
    assert rig.result(xmove) == 1


def between_marks(rig: Rig) -> Rig:
    """Stop between 1201 and 1202."""
    rig.move(1201, 1202, 1203)
    rig.run(0.5)
    assert rig.do(Code.STOP_BY_HOST) == 0
    place = rig.vehicle.place(now(rig))
    assert place[0] == "1201"
    assert 200 < place[1] < 600
    assert place[2] == "1202"
    return rig


@pytest.mark.parametrize(
    ("barcodes", "result"), [((1201, 1202), 0), ((1202, 1203), 0), ((1201,), 1), ((1201, 1301), 1)]
)
def test_from_between_two_barcodes_only_the_way_ahead_is_open(rig: Rig, barcodes: tuple[int, ...], result: int) -> None:
    between_marks(rig)
    assert rig.do(Code.MOVE, Move(path(*barcodes))) == result


def test_one_barcode_named_twice_counts_twice_in_one_event(rig: Rig) -> None:
    elements = [*path(1201, 1202), *path(1202, 1203, first=2)]
    elements[1] = Element(1202, 1, 3, Action.RUN, 80)
    move = rig.send(Code.MOVE, Move(elements))
    rig.until(lambda: rig.result(move) == 0)
    assert [(event.seq, event.barcode) for event in rig.events()] == [(2, 1202), (3, 1203)]


def test_a_stop_in_the_middle_of_a_path_is_a_short_stand(rig: Rig) -> None:
    elements = path(1201, 1202, 1203)
    elements[1] = Element(1202, 1, 3, Action.STOP, 80)
    begun = rig.now
    assert rig.do(Code.MOVE, Move(path(1201, 1202, 1203))) == 0
    smooth = rig.now - begun
    rig.vehicle.push_to(Barcode("1201"), now(rig))
    begun = rig.now
    assert rig.do(Code.MOVE, Move(elements)) == 0
    assert rig.now - begun > smooth + 0.5
    assert rig.status().seq == 2


def test_curves_are_taken_at_one_metre_a_second(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1302, 1303, speed=100)
    rig.until(lambda: len(rig.events()) == 1)
    early = rig.vehicle.place(now(rig))
    rig.run(1)
    late = rig.vehicle.place(now(rig))
    assert late[1] - early[1] == pytest.approx(1000)
    rig.until(lambda: rig.result(move) == 0)


def test_a_path_that_leaves_the_rail_ends_in_alarm_101_at_the_wrong_barcode(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1204)
    rig.until(lambda: rig.result(move) == 1)
    status = rig.status()
    assert (status.status2.oper, status.status2.code, status.barcode) == (Oper.ALARM, 101, 1203)
    barcode, past, ahead = rig.vehicle.place(now(rig))
    assert (barcode, ahead) == ("1203", "1204")
    assert past > 0


def test_a_path_beyond_the_end_of_the_rail_ends_in_alarm_101_there(rig: Rig) -> None:
    rig.vehicle.push_to(Barcode("1205"), now(rig))
    move = rig.move(1205, 1206, 1201)
    rig.until(lambda: rig.result(move) == 1)
    assert rig.vehicle.place(now(rig)) == ("1206", 0, None)
    assert rig.status().status2.code == 101


def test_a_vehicle_that_reads_a_wrong_barcode_at_the_end_of_the_rail_rolls_no_farther() -> None:
    rig = make_rig(track=Track([edge("1201", "1202", 3000), edge("1202", "1203", 100)])).ready()
    move = rig.move(1201, 1202, 9999, speed=100)
    rig.until(lambda: rig.result(move) == 1)
    assert rig.vehicle.place(now(rig))[0] == "1203"


def test_a_misread_barcode_ends_a_move_in_alarm_101(rig: Rig) -> None:
    rig.vehicle.misread_next(Barcode("777"))
    move = rig.move(1201, 1202, 1203)
    rig.until(lambda: rig.result(move) == 1)
    assert (rig.answer(move).barcode, rig.answer(move).status2.code) == (777, 101)
    assert rig.vehicle.place(now(rig))[0] == "1202"
    with pytest.raises(ValueError, match="does not fit"):
        rig.vehicle.misread_next(Barcode("x"))


def test_an_obstacle_pauses_a_move_and_its_going_resumes_it(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.vehicle.block_sensor(now(rig))
    rig.run(5)
    status = rig.status()
    assert (status.status2.oper, status.status1.trav) == (Oper.PAUSE, 0)
    xmove = rig.xmove(2, 1203, 1204)
    rig.run(1)
    assert rig.result(xmove) == 1
    rig.vehicle.unblock_sensor(now(rig))
    rig.run(0.1)
    assert rig.status().status1.trav == 8
    rig.until(lambda: rig.result(move) == 0)
    assert rig.status().barcode == 1203


def test_an_obstacle_that_goes_while_braking_costs_only_speed(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.8)
    rig.vehicle.block_sensor(now(rig))
    rig.run(0.2)
    rig.vehicle.unblock_sensor(now(rig))
    rig.until(lambda: rig.result(move) == 0)


def test_an_obstacle_before_a_standing_vehicle_pauses_the_next_move_at_its_place(rig: Rig) -> None:
    rig.vehicle.block_sensor(now(rig))
    move = rig.move(1201, 1202)
    rig.run(5)
    assert rig.status().status2.oper is Oper.PAUSE
    assert rig.vehicle.place(now(rig)) == ("1201", 0, None)
    assert rig.do(Code.STOP_BY_HOST) == 0
    assert rig.result(move) == 1
    rig.vehicle.unblock_sensor(now(rig))
    assert rig.status().status2.oper is Oper.IDLE


def test_an_obstacle_seen_while_a_stop_is_under_way_changes_nothing(rig: Rig) -> None:
    rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.send(Code.STOP_BY_HOST)
    rig.run(0.05)
    rig.vehicle.block_sensor(now(rig))
    rig.vehicle.unblock_sensor(now(rig))
    rig.until(lambda: rig.result(rig.last_id) == 0)


def test_two_stops_are_answered_in_order_after_the_move(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.heard.clear()
    by_host = rig.send(Code.STOP_BY_HOST)
    rig.run(0.05)
    stop = rig.send(Code.STOP)
    xmove = rig.xmove(1, 1202, 1203)
    rig.run(5)
    assert rig.order() == [
        f"ack {by_host}",
        f"ack {stop}",
        f"ack {xmove}",
        f"answer {xmove}",
        f"answer {move}",
        f"answer {by_host}",
        f"answer {stop}",
        "event",
    ]
    assert (rig.result(xmove), rig.result(move)) == (1, 1)


@pytest.mark.parametrize(
    ("first", "barcodes"),
    [(1, (1205, 1206)), (0, (1201,)), (5, (1206,)), (1, (1301, 1302)), (2, (1205, 1206))],
    ids=["not ahead", "nothing new", "gap", "branch passed", "too far"],
)
def test_an_xmove_that_does_not_lead_on_is_refused_and_the_old_path_stays(
    rig: Rig, first: int, barcodes: tuple[int, ...]
) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.9)
    assert rig.vehicle.place(now(rig))[1] > 500
    xmove = rig.xmove(first, *barcodes)
    rig.run(10)
    if (first, barcodes[0]) == (2, 1205):
        assert rig.result(xmove) == 0
        assert rig.answer(move).status2.code == 101
    else:
        assert rig.result(xmove) == 1
        assert (rig.answer(move).result, rig.answer(move).barcode) == (0, 1203)


def test_an_xmove_may_append_behind_the_stop_which_is_then_a_short_stand(rig: Rig) -> None:
    move = rig.move(1201, 1202)
    rig.run(0.3)
    xmove = rig.xmove(2, 1203)
    rig.until(lambda: rig.result(move) == 0)
    assert rig.result(xmove) == 0
    assert rig.status().barcode == 1203


def test_an_xmove_to_a_stop_nearer_than_the_braking_distance_is_refused(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    while rig.vehicle.place(now(rig))[1] < 1500:
        rig.run(0.01)
    xmove = rig.xmove(1, 1202)
    rig.until(lambda: rig.result(move) is not None)
    assert (rig.result(xmove), rig.result(move)) == (1, 0)


def test_an_xmove_without_a_move_is_refused(rig: Rig) -> None:
    assert rig.do(Code.XMOVE, Xmove(path(1202, first=1))) == 1


# Operator


def test_the_key_changes_the_mode_which_is_reported_and_fails_a_running_job(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.vehicle.panel_mode(Mode.MANT, now(rig))
    rig.vehicle.panel_mode(Mode.MANT, now(rig))
    rig.run(5)
    assert [event.status2.mode for event in rig.events()] == [Mode.MANT]
    assert rig.result(move) == 1


def test_a_vehicle_pushed_to_a_barcode_reads_it_with_servos_on(rig: Rig) -> None:
    rig.vehicle.push_to(Barcode("1204"), now(rig))
    rig.run(0.1)
    assert [event.barcode for event in rig.events()] == [1204]
    with pytest.raises(ValueError, match="no barcode"):
        rig.vehicle.push_to(Barcode("9"), now(rig))


def test_a_vehicle_pushed_without_servos_reads_its_barcode_at_servo_on() -> None:
    rig = make_rig()
    rig.vehicle.push_to(Barcode("1204"), now(rig))
    status = rig.status()
    assert (status.barcode, status.status2.at_barcode) == (0, False)
    rig.do(Code.SERVO_ON)
    assert rig.status().barcode == 1204


def test_a_vehicle_pushed_away_during_a_move_ends_in_alarm_101(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.vehicle.push_to(Barcode("1301"), now(rig))
    rig.run(1)
    assert (rig.answer(move).result, rig.answer(move).status2.code) == (1, 101)


def test_a_lost_foup_is_alarm_202_and_fails_a_move(rig: Rig) -> None:
    rig.vehicle.insert_foup(now(rig))
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    assert rig.status().status1.foup
    rig.vehicle.lose_foup(now(rig))
    rig.run(5)
    assert (rig.answer(move).result, rig.answer(move).status2.code) == (1, 202)
    assert not rig.status().status1.foup
    rig.vehicle.insert_foup(now(rig))
    rig.vehicle.remove_foup(now(rig))
    assert not rig.status().status1.foup


def test_an_alarm_during_a_pickup_leaves_the_axes_where_they_are(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1201))) == 0
    pickup = rig.send(Code.PICKUP_FROM_PORT, PORT)
    rig.run(2.255)
    rig.vehicle.raise_alarm(7, now(rig))
    rig.run(1)
    assert rig.result(pickup) == 1
    assert rig.status().status1.word == 0x01000113
    assert rig.vehicle.state.pulses[Axis.LIFT] == pytest.approx(585_000, abs=1)
    assert rig.do(Code.STOP) == 0
    assert rig.do(Code.ALARM_CLEAR) == 0
    assert rig.do(Code.AUTO) == 1
    assert rig.do(Code.GO_HOME) == 0
    assert rig.status().status1.word == 0x01111134
    assert rig.do(Code.AUTO) == 0


def test_a_vehicle_told_to_refuse_refuses_the_next_command_but_answers_status(rig: Rig) -> None:
    rig.vehicle.refuse_next()
    assert rig.status().status2.mode is Mode.AUTO
    assert rig.do(Code.MOVE, Move(path(1201, 1202))) == 1
    assert rig.do(Code.MOVE, Move(path(1201, 1202))) == 0


def test_a_single_teaching_event_needs_mant(rig: Rig) -> None:
    with pytest.raises(ValueError, match="MANT"):
        rig.vehicle.teach_single(Code.LIFT_DEST_TEACHING, now(rig))
    rig.vehicle.panel_mode(Mode.MANT, now(rig))
    with pytest.raises(ValueError, match="STATUS is no teaching event"):
        rig.vehicle.teach_single(Code.STATUS, now(rig))


def test_a_renumbered_teaching_code_is_used() -> None:
    rig = make_rig(dialect=type(DIALECTS["default"])(teach_shft_dest=0x20A0)).ready(Mode.MANT)
    assert rig.do(Code.PORT_DEST_TEACHING) == 0
    assert [code for code, _, _ in rig.taught()] == [0x20A0, 0x2072, 0x2074]


def test_a_power_cycle_loses_path_and_memory_but_neither_foup_nor_place(rig: Rig) -> None:
    rig.vehicle.insert_foup(now(rig))
    packet = rig.packet(Code.MOVE, Move(path(1201, 1202, 1203)))
    rig.raw(packet)
    rig.run(0.5)
    where = rig.vehicle.place(now(rig))
    rig.vehicle.power_cycle(now(rig))
    rig.run(0.01)
    assert rig.closed == 1
    rig.run(3)
    rig.connect()
    status = rig.status()
    assert (status.status1.word, status.status2.word, status.barcode) == (0x8B11BB34, 0, 0)
    assert rig.vehicle.place(now(rig)) == where
    rig.do(Code.SERVO_ON)
    assert not rig.status().status2.at_barcode
    assert rig.do(Code.PORT_DEST_TEACHING) == 1
    assert rig.do(Code.SEARCH_HOME) == 0
    assert rig.do(Code.AUTO) == 0
    assert rig.do(Code.MOVE, Move(path(1202, 1203))) == 0


def test_a_power_cycle_in_a_pickup_shows_axes_that_are_not_at_home(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1201))) == 0
    rig.send(Code.PICKUP_FROM_PORT, PORT)
    rig.run(2.7)
    rig.vehicle.power_off(now(rig))
    assert not rig.vehicle.accepting
    rig.cut()
    rig.vehicle.power_on(now(rig))
    rig.run(4)
    rig.connect()
    assert rig.status().status1.word == 0x0B00BB03
    rig.do(Code.SERVO_ON)
    assert rig.status().status1.word == 0x00000103


def test_without_power_nothing_more_is_sent() -> None:
    vehicle = make_rig().vehicle
    vehicle.connected(Seconds(0))
    vehicle.make_ready(Seconds(0))
    vehicle.power_off(Seconds(0))
    assert vehicle.wants_close
    assert vehicle.outgoing() == b""


def test_a_restart_may_number_its_events_anew(rig: Rig) -> None:
    rig.vehicle.panel_mode(Mode.MANT, now(rig))
    rig.run(0.1)
    first = rig.heard[-1].frame
    rig.vehicle.power_cycle(now(rig))
    rig.run(4)
    rig.connect()
    rig.vehicle.panel_mode(Mode.AUTO, now(rig))
    rig.run(0.1)
    again = rig.heard[-1].frame
    assert isinstance(first, Enq)
    assert isinstance(again, Enq)
    assert again.cmd_id == 1 << 63 | 1


def test_answers_still_unacknowledged_are_lost_by_a_restart(rig: Rig) -> None:
    rig.acknowledges = lambda _: False
    asked = rig.send(Code.STATUS)
    rig.run(0.1)
    rig.vehicle.power_cycle(now(rig))
    rig.run(4)
    rig.connect()
    rig.run(5)
    assert len(rig.answers(asked)) == 1


def test_places_in_memory_know_what_was_taken_and_put() -> None:
    places = Places()
    there = Barcode("1"), StationKind.PORT
    assert places.full(*there) is None
    assert places.take(spec().id, *there, None)
    assert not places.take(spec().id, *there, None)
    assert places.put(spec().id, *there, None)
    assert places.full(*there) is True
    assert not places.put(spec().id, *there, None)


def test_the_path_is_there_until_a_stop(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1201, 1202))) == 0
    assert rig.vehicle.path == ("1201", "1202")
    assert rig.do(Code.STOP_BY_HOST) == 0
    assert not rig.vehicle.path


def test_axes_jogged_to_0_are_at_home(rig: Rig) -> None:
    rig.vehicle.jog(Axis.LIFT, Pulses(5), now(rig))
    assert not rig.status().status2.all_home
    rig.vehicle.jog(Axis.LIFT, Pulses(0), now(rig))
    assert rig.status().status2.all_home
    assert isinstance(rig.heard[0].frame, Ack)
