"""The session's commands: ACK, resends, answers, refusals before the first byte, teaching (PROTOCOLS 1.5, 6.1, 6.2)."""

from dataclasses import replace

import pytest

from app.domain.commands import Command, Display, Move, Pickup, Place, Plain, Send
from app.domain.events import (
    Acknowledged,
    Answered,
    Event,
    Garbled,
    LinkDown,
    NotSent,
    Reported,
    Taught,
    TeachingKind,
    Unanswered,
    Unknown,
)
from app.domain.ids import CmdId
from app.domain.layout import StationKind
from app.domain.units import Barcode, Percent, Seconds
from app.domain.vehicle import Mode, Oper
from app.protocols.itsc.dialects import DIALECTS, Dialect
from app.protocols.itsc.messages import Code, Enq, Etb, Nak, Nothing, Raw, Resp1, Teach, status2
from app.protocols.itsc.session import Timing
from tests.protocols.itsc.session_peer import (
    ALARMED,
    AUTO_IDLE,
    DISPLAY,
    DRIVING1,
    DRIVING2,
    MANT_IDLE,
    MOVE,
    PAUSED,
    PICKUP,
    PLACE,
    SEMI_IDLE,
    STANDING1,
    TOP,
    Bench,
    V,
    path,
    simple,
    xmove,
)


@pytest.fixture
def bench() -> Bench:
    bench = Bench()
    bench.connect()
    return bench


def ends(events: list[Event]) -> list[Answered | Unanswered | NotSent]:
    return [event for event in events if isinstance(event, Answered | Unanswered | NotSent)]


def not_sent(bench: Bench, command: Command) -> NotSent:
    cmd_id = bench.send(command)
    assert bench.session.outgoing() == b""
    (event,) = bench.session.events()
    assert isinstance(event, NotSent)
    assert (event.vehicle, event.cmd_id, event.command) == (V, cmd_id, command)
    return event


# -- life of a command -------------------------------------------------------------------------------------------------


def test_a_command_is_acknowledged_and_answered(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    (frame,) = bench.commands()
    assert (frame.cmd_id, frame.code) == (cmd_id, Code.MOVE)
    bench.ack(cmd_id)
    assert bench.session.events() == [Acknowledged(V, cmd_id)]
    bench.answer(cmd_id, Code.MOVE)
    (answered,) = ends(bench.session.events())
    assert isinstance(answered, Answered)
    assert (answered.ok, answered.reason, answered.barcode, answered.seq) == (True, "", "1203", 2)
    assert answered.condition.mode is Mode.AUTO
    assert answered.command is MOVE


def test_an_answer_is_acknowledged_and_status_asked_at_once(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.ack(cmd_id)
    bench.heard()
    bench.answer(cmd_id, Code.MOVE)
    ack, poll = bench.heard()
    assert ack.cmd_id == cmd_id
    assert isinstance(poll, Enq)
    assert poll.code == Code.STATUS


def test_the_answer_updates_mode_place_and_seq(bench: Bench) -> None:
    cmd_id = bench.send(simple(Plain.STOP))
    bench.answer(cmd_id, Code.STOP, 0, MANT_IDLE, 1207, 5)
    status = bench.session.status
    assert status is not None
    assert (status.barcode, status.seq, status.condition.mode) == ("1207", 5, Mode.MANT)
    assert status.condition.status1 == STANDING1


def test_an_event_equal_to_the_one_before_an_answer_is_told_again(bench: Bench) -> None:
    bench.status(DRIVING1, DRIVING2, 1202, 1)
    cmd_id = bench.send(simple(Plain.STOP_BY_HOST))
    bench.answer(cmd_id, Code.STOP_BY_HOST)
    bench.take()
    bench.status(DRIVING1, DRIVING2, 1202, 1)
    assert [type(event) for event in bench.session.events()] == [Reported]


def test_a_command_without_ack_is_sent_again_after_one_second(bench: Bench) -> None:
    bench.send(MOVE)
    first = bench.session.outgoing()
    assert bench.session.deadline == 101.0
    bench.now = Seconds(101.0)
    bench.session.tick(bench.now)
    assert first in bench.session.outgoing()
    assert bench.session.link.resends == 1


def test_after_four_transmissions_without_ack_the_command_is_unknown(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    (first,) = bench.commands()
    sent: list[Enq | Etb] = []
    while bench.now < 110.0:
        moment = bench.session.deadline
        assert moment is not None
        bench.now = moment
        bench.session.tick(bench.now)
        for frame in bench.heard():
            assert isinstance(frame, Enq | Etb)
            if frame.code == Code.STATUS:
                bench.status(cmd_id=frame.cmd_id)
            else:
                sent.append(frame)
        bench.heard()
        if ended := ends(bench.session.events()):
            assert ended == [Unanswered(V, cmd_id, MOVE, Unknown.NO_ACK)]
            break
    assert bench.now == 104.0
    assert sent == [first] * 3


def test_an_answer_before_the_ack_counts_as_ack_too(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.answer(cmd_id, Code.MOVE)
    events = bench.session.events()
    assert [type(event) for event in events] == [Acknowledged, Answered]
    bench.ack(cmd_id)
    assert bench.session.events() == []
    bench.until(104.5)
    assert ends(bench.session.events()) == []


def test_a_second_ack_says_nothing_new(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.ack(cmd_id)
    bench.ack(cmd_id)
    bench.ack(CmdId(99))
    assert bench.session.events() == [Acknowledged(V, cmd_id)]


def test_a_nak_sends_the_same_bytes_again_now_but_not_for_ever(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    first = bench.session.outgoing()
    for _ in range(3):
        bench.say(Nak(12, cmd_id))
        assert bench.session.outgoing() == first
    bench.say(Nak(12, cmd_id))
    assert bench.session.outgoing() == b""
    assert ends(bench.session.events()) == [Unanswered(V, cmd_id, MOVE, Unknown.NO_ACK)]


def test_a_nak_after_the_ack_or_of_nothing_is_ignored(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.ack(cmd_id)
    bench.heard()
    bench.say(Nak(12, cmd_id))
    bench.say(Nak(12, 4711))
    assert bench.session.outgoing() == b""


def test_a_duplicated_answer_is_acknowledged_and_ends_the_command_once(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.answer(cmd_id, Code.MOVE)
    bench.answer(cmd_id, Code.MOVE)
    assert len(ends(bench.session.events())) == 1
    assert bench.acks() == [cmd_id, cmd_id]


def test_an_answer_without_our_id_ends_the_oldest_command_with_that_code(bench: Bench) -> None:
    first = bench.send(DISPLAY)
    second = bench.send(DISPLAY)
    for own in (TOP + 77, 78):
        bench.answer(CmdId(own), Code.DISPLAY_BY_HOST)
    assert [event.cmd_id for event in ends(bench.session.events())] == [first, second]


def test_an_answer_under_another_code_does_not_fit(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.ack(cmd_id)
    bench.answer(cmd_id, Code.XMOVE)
    told = bench.take()
    assert [event.reason for event in told if isinstance(event, Garbled)] == ["unfit answer"]
    assert ends(told) == []


def test_an_answer_with_an_undefined_result_does_not_fit(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.ack(cmd_id)
    bench.answer(cmd_id, Code.MOVE, result=7)
    told = bench.take()
    assert [event.reason for event in told if isinstance(event, Garbled)] == ["unfit answer"]
    assert ends(told) == []


@pytest.mark.parametrize("cmd_id", [(7 << 32) + 4000, TOP + 3])
def test_an_answer_to_nothing_is_told_and_ignored(bench: Bench, cmd_id: int) -> None:
    bench.answer(CmdId(cmd_id), Code.MOVE)
    assert [event.reason for event in bench.session.events() if isinstance(event, Garbled)] == ["unasked answer"]
    assert bench.acks() == [cmd_id]


def test_an_answer_to_a_finished_command_does_not_end_another(bench: Bench) -> None:
    first = bench.send(DISPLAY)
    bench.answer(first, Code.DISPLAY_BY_HOST)
    bench.send(DISPLAY)
    bench.session.events()
    bench.answer(first, Code.DISPLAY_BY_HOST, result=1)
    assert ends(bench.session.events()) == []


def test_a_refusal_names_the_alarm(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.answer(cmd_id, Code.MOVE, 1, ALARMED)
    (answered,) = ends(bench.session.events())
    assert isinstance(answered, Answered)
    assert (answered.ok, answered.reason) == (False, "alarm 101 (0x0065)")
    assert answered.condition.oper is Oper.ALARM


def test_a_refusal_without_alarm_tells_what_is_known_of_the_vehicle(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.answer(cmd_id, Code.MOVE, 1, 0xC0000000)
    (answered,) = ends(bench.session.events())
    assert isinstance(answered, Answered)
    for word in ("AUTO", "IDLE", "servos off", "home not known", "not all devices at home"):
        assert word in answered.reason


@pytest.mark.parametrize(
    ("command", "code", "mode", "seconds"),
    [
        (MOVE, Code.MOVE, AUTO_IDLE, 50.0),
        (xmove(CmdId(1)), Code.XMOVE, AUTO_IDLE, 2.0),
        (PICKUP, Code.PICKUP_FROM_PORT, AUTO_IDLE, 120.0),
        (PLACE, Code.PLACE_TO_SBFL, AUTO_IDLE, 120.0),
        (DISPLAY, Code.DISPLAY_BY_HOST, AUTO_IDLE, 2.0),
        (simple(Plain.STOP), Code.STOP, AUTO_IDLE, 10.0),
        (simple(Plain.SEARCH_HOME), Code.SEARCH_HOME, MANT_IDLE, 60.0),
        (simple(Plain.GO_HOME), Code.GO_HOME, MANT_IDLE, 60.0),
        (simple(Plain.PORT_DEST_TEACHING), Code.PORT_DEST_TEACHING, MANT_IDLE, 30.0),
        (simple(Plain.SERVO_ON), Code.SERVO_ON, MANT_IDLE, 10.0),
    ],
)
def test_an_acknowledged_command_without_answer_is_unknown_after_its_time(
    command: Command, code: Code, mode: int, seconds: float
) -> None:
    bench = Bench()
    bench.connect(word2=mode)
    cmd_id = bench.send(command)
    bench.now = Seconds(100.5)
    bench.ack(cmd_id)
    assert [frame.code for frame in bench.commands()] == [code]
    bench.until(100.5 + seconds - 0.01, word2=mode)
    assert ends(bench.session.events()) == []
    bench.until(100.5 + seconds, word2=mode)
    assert ends(bench.session.events()) == [Unanswered(V, cmd_id, command, Unknown.NO_ANSWER)]


def test_a_late_answer_of_the_same_connection_is_given_too(bench: Bench) -> None:
    cmd_id = bench.send(DISPLAY)
    bench.ack(cmd_id)
    bench.until(103.0)
    bench.take()
    bench.answer(cmd_id, Code.DISPLAY_BY_HOST)
    (answered,) = bench.take()
    assert isinstance(answered, Answered)
    bench.answer(cmd_id, Code.DISPLAY_BY_HOST, 1)
    assert ends(bench.take()) == []


def test_so_many_commands_given_up_are_remembered_and_no_more(bench: Bench) -> None:
    first = bench.send(DISPLAY)
    for _ in range(64):
        bench.send(DISPLAY)
    bench.until(110.0)
    bench.take()
    bench.answer(first, Code.DISPLAY_BY_HOST)
    assert ends(bench.take()) == []


def test_a_late_answer_of_an_earlier_connection_is_ignored(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.session.disconnected(bench.now, "gone")
    assert bench.session.events() == [Unanswered(V, cmd_id, MOVE, Unknown.LINK_LOST), LinkDown(V, "gone")]
    bench.connect()
    bench.answer(cmd_id, Code.MOVE)
    assert ends(bench.session.events()) == []


def test_a_command_is_never_sent_again_on_another_connection(bench: Bench) -> None:
    bench.send(MOVE)
    bench.session.disconnected(bench.now, "gone")
    bench.connect()
    assert [frame for frame in bench.silent_until(103.4) if isinstance(frame, Etb)] == []


def test_a_silent_link_makes_what_is_under_way_unknown(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.ack(cmd_id)
    bench.session.events()
    bench.silent_until(104.0)
    events = bench.session.events()
    assert [type(event) for event in events] == [Unanswered, LinkDown]


# -- MOVE and XMOVE ----------------------------------------------------------------------------------------------------


def test_a_rising_seq_gives_the_move_its_time_again(bench: Bench) -> None:
    bench.session.timing = Timing()
    cmd_id = bench.send(MOVE)
    bench.ack(cmd_id)
    bench.until(140.0, DRIVING1, DRIVING2, 0)
    bench.status(DRIVING1, DRIVING2, 1202, 1)
    bench.until(189.0, DRIVING1, DRIVING2, 1)
    assert ends(bench.session.events()) == []
    bench.until(190.5, DRIVING1, DRIVING2, 1)
    assert [type(event) for event in ends(bench.session.events())] == [Unanswered]


def test_a_move_does_not_time_out_while_the_vehicle_pauses(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.ack(cmd_id)
    bench.until(1000.0, STANDING1, PAUSED)
    assert ends(bench.session.events()) == []
    bench.until(1055.0, DRIVING1, DRIVING2)
    assert [type(event) for event in ends(bench.session.events())] == [Unanswered]


def test_status_under_the_moves_id_is_its_acceptance_and_a_status(bench: Bench) -> None:
    cmd_id = bench.send(MOVE)
    bench.status(DRIVING1, DRIVING2, 1201, 0, cmd_id)
    events = bench.take()
    assert [type(event) for event in events] == [Acknowledged, Reported]
    bench.answer(cmd_id, Code.MOVE)
    assert [event.cmd_id for event in ends(bench.take())] == [cmd_id]
    bench.status(DRIVING1, DRIVING2, 1202, 1, cmd_id)
    assert [type(event) for event in bench.take()] == [Reported]


def test_status_under_a_given_up_commands_id_is_only_a_status(bench: Bench) -> None:
    cmd_id = bench.send(DISPLAY)
    bench.until(110.0)
    bench.take()
    bench.status(DRIVING1, DRIVING2, 1201, 0, cmd_id)
    assert [type(event) for event in bench.take()] == [Reported]


def test_an_xmove_may_be_sent_while_its_move_runs_and_gives_it_time(bench: Bench) -> None:
    move = bench.send(MOVE)
    bench.ack(move)
    bench.until(140.0, DRIVING1, DRIVING2)
    change = bench.send(xmove(move))
    (frame,) = bench.commands()
    assert frame.code == Code.XMOVE
    bench.answer(change, Code.XMOVE, barcode=1202, seq=0)
    bench.until(209.0, DRIVING1, DRIVING2)
    assert [event.cmd_id for event in ends(bench.session.events())] == [change]
    bench.until(211.0, DRIVING1, DRIVING2)
    assert [event.cmd_id for event in ends(bench.session.events())] == [move]


def test_an_xmove_before_the_moves_ack_does_not_put_its_resend_off(bench: Bench) -> None:
    move = bench.send(MOVE)
    bench.send(xmove(move))
    bench.heard()
    bench.now = Seconds(101.0)
    bench.session.tick(bench.now)
    assert Code.MOVE in [frame.code for frame in bench.commands()]


def test_an_xmove_without_an_open_move_is_sent_for_vehicles_that_answer_on_acceptance(bench: Bench) -> None:
    move = bench.send(MOVE)
    bench.answer(move, Code.MOVE)
    bench.heard()
    bench.send(xmove(move))
    assert [frame.code for frame in bench.commands()] == [Code.XMOVE]


@pytest.mark.parametrize("what", [Plain.STOP, Plain.STOP_BY_HOST])
def test_a_stop_is_sent_while_a_move_runs_and_forbids_motion_until_answered(bench: Bench, what: Plain) -> None:
    move = bench.send(MOVE)
    stop = bench.send(simple(what))
    assert len(bench.commands()) == 2
    bench.session.events()
    bench.answer(move, Code.MOVE, 1)
    bench.take()
    assert "has not yet answered STOP" in not_sent(bench, MOVE).reason
    bench.answer(stop, Code[what.name])
    bench.take()
    bench.send(MOVE)
    assert [frame.code for frame in bench.commands()] == [Code.MOVE]


# -- particular commands -----------------------------------------------------------------------------------------------


def test_system_reset_is_done_when_acknowledged(bench: Bench) -> None:
    bench.status(STANDING1, MANT_IDLE)
    bench.take()
    cmd_id = bench.send(simple(Plain.SYSTEM_RESET))
    bench.ack(cmd_id)
    acknowledged, answered = bench.session.events()
    assert acknowledged == Acknowledged(V, cmd_id)
    assert isinstance(answered, Answered)
    assert answered.ok
    bench.session.disconnected(bench.now, "closed by peer")
    assert bench.session.events() == [LinkDown(V, "closed by peer")]


def test_a_persons_status_command_is_answered_and_reported(bench: Bench) -> None:
    cmd_id = bench.send(simple(Plain.STATUS))
    bench.ack(cmd_id)
    bench.now = Seconds(100.5)
    bench.status(barcode=1209, cmd_id=cmd_id)
    acknowledged, reported, answered = bench.session.events()
    assert acknowledged == Acknowledged(V, cmd_id)
    assert isinstance(reported, Reported)
    assert (reported.polled, reported.asked_at) == (True, 100.0)
    assert isinstance(answered, Answered)
    assert (answered.ok, answered.barcode) == (True, "1209")


def test_a_persons_status_command_is_never_sent_again(bench: Bench) -> None:
    cmd_id = bench.send(simple(Plain.STATUS))
    bench.heard()
    bench.say(Nak(12, cmd_id))
    assert bench.heard() == []
    bench.until(103.0)
    assert ends(bench.take()) == [Unanswered(V, cmd_id, simple(Plain.STATUS), Unknown.NO_ANSWER)]


@pytest.mark.parametrize(
    ("command", "code"),
    [
        (Pickup(StationKind.SBFL, None, 0, Percent(10)), Code.PICKUP_FROM_SBFL),
        (Pickup(StationKind.SBFR, None, 0, Percent(10)), Code.PICKUP_FROM_SBFR),
        (PICKUP, Code.PICKUP_FROM_PORT),
        (Place(StationKind.PORT, PICKUP.target, 5, Percent(10)), Code.PLACE_TO_PORT),
        (Place(StationKind.SBFL, None, 0, Percent(10)), Code.PLACE_TO_SBFL),
        (Place(StationKind.SBFR, None, 0, Percent(10)), Code.PLACE_TO_SBFR),
    ],
)
def test_transfers_go_under_the_code_of_their_station(bench: Bench, command: Command, code: Code) -> None:
    bench.send(command)
    assert [frame.code for frame in bench.commands()] == [code]


def test_packets_are_those_of_the_worked_examples() -> None:
    bench = Bench()
    bench.connect()
    bench.session.send(Send(V, CmdId(3), PICKUP), bench.now)
    assert bench.session.outgoing()[13:31].hex() == "1046fffffa10000003840011da5000000550"
    bench = Bench()
    bench.connect()
    bench.session.send(Send(V, CmdId(4), Display("ZONE BLOCKED", 0x87D1)), bench.now)
    assert bench.session.outgoing()[13:31].hex() == "50c287d10001" + b"ZONE BLOCKED".hex()


def test_the_slides_dialect_sends_the_distances() -> None:
    bench = Bench(DIALECTS["slides"])
    bench.connect()
    bench.send(MOVE)
    packet = bench.session.outgoing()
    assert packet[33 + 64 : 33 + 76].hex() == "000004b10000" + "303c" + "0000" + "05dc"


def test_ascii_barcodes_go_out_as_characters() -> None:
    bench = Bench(DIALECTS["ascii-barcode"])
    bench.connect(barcode="A1")
    bench.send(Move((replace(path(1)[0], barcode=Barcode("A1-7")),), Seconds(1.0)))
    assert b"A1-7\0\0" in bench.session.outgoing()


# -- refusals before the first byte ------------------------------------------------------------------------------------


def test_nothing_is_sent_without_a_connection() -> None:
    event = not_sent(Bench(), MOVE)
    assert event.reason == "vehicle V012 is not connected"
    assert event.remedy


def test_nothing_is_sent_before_the_first_status_of_a_connection() -> None:
    bench = Bench()
    bench.connect()
    bench.session.disconnected(bench.now, "gone")
    bench.session.connected(bench.now)
    bench.take()
    for command in (MOVE, simple(Plain.STOP)):
        assert "has not yet answered STATUS" in not_sent(bench, command).reason


def test_a_stale_status_decides_nothing_but_a_stop_still_goes(bench: Bench) -> None:
    bench.silent_until(102.5)
    bench.ack(CmdId(9))
    bench.silent_until(103.1)
    bench.take()
    assert not_sent(bench, MOVE).reason == "the newest STATUS of vehicle V012 is 3.1 s old"
    for what in (Plain.STOP, Plain.STOP_BY_HOST):
        bench.send(simple(what))
    assert [frame.code for frame in bench.commands()] == [Code.STOP, Code.STOP_BY_HOST]
    bench.send(simple(Plain.STATUS))
    assert len(bench.polls()) == 1


@pytest.mark.parametrize(
    ("mode", "command", "reason", "remedy"),
    [
        (MANT_IDLE, MOVE, "vehicle V012 is in MANUAL", "switch it to AUTO"),
        (SEMI_IDLE, PICKUP, "vehicle V012 is in SEMI", "switch it to AUTO"),
        (MANT_IDLE, DISPLAY, "vehicle V012 is in MANUAL", "switch it to AUTO or SEMI"),
        (AUTO_IDLE, simple(Plain.SERVO_OFF), "vehicle V012 is in AUTO", "switch it to MANUAL"),
        (MANT_IDLE, simple(Plain.STOP_BY_HOST), "vehicle V012 is in MANUAL", "switch it to AUTO or SEMI"),
        (0x8F000000, MOVE, "vehicle V012 is in an undefined mode", "switch it to AUTO"),
    ],
)
def test_a_command_of_another_mode_is_not_sent(mode: int, command: Command, reason: str, remedy: str) -> None:
    bench = Bench()
    bench.connect(word2=mode)
    event = not_sent(bench, command)
    assert (event.reason, event.remedy) == (reason, remedy)


@pytest.mark.parametrize("mode", [AUTO_IDLE, MANT_IDLE, SEMI_IDLE, 0x8F000000])
def test_stop_goes_in_every_mode(mode: int) -> None:
    bench = Bench()
    bench.connect(word2=mode)
    bench.send(simple(Plain.STOP))
    assert [frame.code for frame in bench.commands()] == [Code.STOP]


@pytest.mark.parametrize("second", [MOVE, PICKUP, PLACE])
@pytest.mark.parametrize("first", [MOVE, PICKUP, PLACE])
def test_one_motion_at_a_time(bench: Bench, first: Command, second: Command) -> None:
    bench.send(first)
    bench.heard()
    event = not_sent(bench, second)
    assert event.reason.startswith("vehicle V012 has not yet answered ")
    bench.send(DISPLAY)
    assert [frame.code for frame in bench.commands()] == [Code.DISPLAY_BY_HOST]


def test_no_second_xmove_before_the_first_is_answered(bench: Bench) -> None:
    move = bench.send(MOVE)
    bench.send(xmove(move))
    bench.heard()
    assert "XMOVE" in not_sent(bench, xmove(move)).reason


def test_no_xmove_while_a_pickup_runs(bench: Bench) -> None:
    bench.send(PICKUP)
    bench.heard()
    assert "PICKUP FROM PORT" in not_sent(bench, xmove(CmdId(1))).reason


def test_a_path_longer_than_the_vehicle_takes_is_not_sent(bench: Bench) -> None:
    event = not_sent(bench, Move(path(*range(1, 202)), Seconds(1.0)))
    assert "201 elements" in event.reason
    assert "at most 200" in event.reason


@pytest.mark.parametrize(
    ("command", "word"),
    [
        (Move(path(1, first=1), Seconds(1.0)), "SEQ"),
        (Move((replace(path(1)[0], barcode=Barcode("0012")),), Seconds(1.0)), "leading zeros"),
        (Move((replace(path(1)[0], barcode=Barcode("B7")),), Seconds(1.0)), "B7"),
        (Pickup(StationKind.PORT, None, 0, Percent(10)), "target pulses"),
        (Pickup(StationKind.PORT, PICKUP.target, 16, Percent(10)), "LKDN"),
        (Display("HELLO", 12), "0x000C"),
        (Display("THIRTEEN CHARS"), "text"),
    ],
)
def test_what_the_protocol_cannot_say_is_not_sent(bench: Bench, command: Command, word: str) -> None:
    assert word in not_sent(bench, command).reason


# -- teaching ----------------------------------------------------------------------------------------------------------


def taught(bench: Bench) -> Taught:
    (event,) = bench.session.events()
    assert isinstance(event, Taught)
    return event


def test_a_teaching_event_is_acknowledged_only_when_stored(bench: Bench) -> None:
    cmd_id = bench.event(Code.LIFT_DEST_TEACHING, Teach(1_170_000, 1203))
    assert bench.session.outgoing() == b""
    event = taught(bench)
    assert (event.kind, event.code, event.position) == (TeachingKind.LIFT_DEST, 0x2074, 1_170_000)
    assert (event.barcode, event.cmd_id) == ("1203", cmd_id)
    bench.session.stored(event.receipt, bench.now)
    assert bench.acks() == [cmd_id]


def test_a_repeat_before_it_is_stored_is_neither_acknowledged_nor_told_again(bench: Bench) -> None:
    cmd_id = bench.event(Code.SHFT_DEST_TEACHING, Teach(-5, 1203))
    event = taught(bench)
    bench.event(Code.SHFT_DEST_TEACHING, Teach(-5, 1203), cmd_id)
    assert (bench.session.outgoing(), bench.session.events()) == (b"", [])
    bench.session.stored(event.receipt, bench.now)
    bench.event(Code.SHFT_DEST_TEACHING, Teach(-5, 1203), cmd_id)
    assert bench.acks() == [cmd_id, cmd_id]
    assert bench.session.events() == []
    bench.session.stored(event.receipt, bench.now)
    assert bench.session.outgoing() == b""


def test_a_receipt_of_an_earlier_connection_acknowledges_nothing(bench: Bench) -> None:
    bench.event(Code.ROTA_OFFSET_TEACHING, Teach(1, 1203))
    event = taught(bench)
    bench.session.disconnected(bench.now, "gone")
    bench.connect()
    bench.session.stored(event.receipt, bench.now)
    assert bench.session.outgoing() == b""


def test_all_six_kinds_of_teaching_are_known_also_under_configured_codes() -> None:
    bench = Bench(Dialect(teach_shft_dest=0x3330))
    bench.connect()
    codes = [0x3330, 0x2071, 0x2072, 0x2073, 0x2074, 0x2075]
    for code in codes:
        bench.event(code, Teach(code, 1))
    events = bench.session.events()
    assert [event.kind for event in events if isinstance(event, Taught)] == list(TeachingKind)


@pytest.mark.parametrize("name", ["default", "slides"])
def test_an_unknown_code_in_the_shape_of_teaching_is_taught_without_a_kind(name: str) -> None:
    bench = Bench(DIALECTS[name])
    bench.connect()
    data = bench.codec.encode_body(Teach(77, 1203))
    cmd_id = bench.event(0x2078, Raw(data))
    event = taught(bench)
    assert (event.kind, event.code, event.position, event.barcode) == (None, 0x2078, 77, "1203")
    bench.session.stored(event.receipt, bench.now)
    assert bench.acks() == [cmd_id]


def test_teaching_events_that_wait_for_the_store_are_bounded(bench: Bench) -> None:
    for i in range(80):
        bench.event(Code.LIFT_DEST_TEACHING, Teach(i, 1))
    events = bench.session.events()
    assert len(events) == 64
    assert isinstance(events[0], Taught)
    bench.session.stored(events[0].receipt, bench.now)
    bench.event(Code.LIFT_DEST_TEACHING, Teach(79, 1), bench.own)
    assert len(bench.session.events()) == 1


def test_a_port_teaching_runs_its_three_events_and_its_answer() -> None:
    bench = Bench()
    bench.connect(word2=MANT_IDLE)
    cmd_id = bench.send(simple(Plain.PORT_DEST_TEACHING))
    bench.ack(cmd_id)
    bench.take()
    for code in (Code.SHFT_DEST_TEACHING, Code.ROTA_DEST_TEACHING, Code.LIFT_DEST_TEACHING):
        bench.event(code, Teach(5, 1203))
        bench.session.stored(taught(bench).receipt, bench.now)
        assert len(bench.acks()) == 1
    bench.answer(cmd_id, Code.PORT_DEST_TEACHING, 0, MANT_IDLE)
    assert len(ends(bench.session.events())) == 1


def test_a_system_reset_does_not_expect_an_answer_packet() -> None:
    bench = Bench()
    bench.connect(word2=MANT_IDLE)
    bench.event(Code.SYSTEM_RESET, Nothing())
    assert [type(event) for event in bench.session.events()] == [Garbled]


def test_an_answer_before_any_status_is_understood() -> None:
    bench = Bench()
    bench.session.connected(bench.now)
    bench.say(Enq(12, TOP + 1, Code.MOVE, Resp1(0, status2(AUTO_IDLE), 5, 0)))
    assert [type(event) for event in bench.session.events()] == [Garbled]
