"""The session's link: polls, silence, ACKs of what the vehicle sends, duplicates, resynchronising, first contact."""

from binascii import crc_hqx

import pytest

from app.domain.events import Event, Garbled, LinkDown, LinkUp, Reported
from app.domain.ids import CmdIds, DevId, Epoch
from app.domain.layout import VehicleSpec
from app.domain.units import Seconds
from app.domain.vehicle import Mode
from app.protocols.itsc.dialects import DIALECTS, Dialect
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import (
    Ack,
    Code,
    Enq,
    Etb,
    Nak,
    Raw,
    Resp1,
    Resp2,
    Teach,
    Toward,
    Xmove,
    status1,
    status2,
)
from app.protocols.itsc.session import Session
from app.protocols.itsc.session.link import Tape, Taped
from tests.protocols.itsc.session_peer import (
    AUTO_IDLE,
    DRIVING1,
    DRIVING2,
    MANT_IDLE,
    STANDING1,
    TOP,
    Bench,
    V,
)


def reported(bench: Bench) -> list[Reported]:
    return [event for event in bench.take() if isinstance(event, Reported)]


def garbled(bench: Bench) -> list[Garbled]:
    return [event for event in bench.take() if isinstance(event, Garbled)]


def test_a_new_session_is_down_and_wants_nothing() -> None:
    session = Bench().session
    assert not session.up
    assert session.deadline is None
    assert not session.wants_close
    assert session.outgoing() == b""
    assert session.events() == []
    assert session.link.round_trip_last is None
    assert session.link.round_trip_mean is None


def test_status_is_asked_at_once_after_connecting() -> None:
    bench = Bench()
    bench.session.connected(bench.now)
    packet = bytes.fromhex("050000000c00000007000000017030") + bytes(16)
    assert bench.session.outgoing() == packet + crc_hqx(packet, 0xFFFF).to_bytes(2, "big")
    assert not bench.session.up


def test_the_first_status_answer_brings_the_link_up_and_is_acknowledged() -> None:
    bench = Bench()
    bench.session.connected(bench.now)
    (poll,) = bench.polls()
    bench.now = Seconds(100.25)
    bench.status(cmd_id=poll)
    assert bench.acks() == [poll]
    up, status = bench.session.events()
    assert up == LinkUp(V)
    assert isinstance(status, Reported)
    assert (status.polled, status.asked_at) == (True, 100.0)
    assert status.status.barcode == "1201"
    assert status.status.condition.mode is Mode.AUTO
    assert bench.session.up
    assert bench.session.status == status.status
    assert bench.session.status_at == 100.25
    assert bench.session.link.round_trip_last == pytest.approx(250.0)
    assert bench.session.link.round_trip_mean == pytest.approx(250.0)


def test_an_event_before_the_first_answer_is_reported_but_does_not_bring_the_link_up() -> None:
    bench = Bench()
    bench.session.connected(bench.now)
    bench.status()
    assert not bench.session.up
    assert [event.polled for event in reported(bench)] == [False]


def test_status_is_polled_each_second_under_a_new_id() -> None:
    bench = Bench()
    bench.connect()
    polls = []
    for _ in range(3):
        assert bench.session.deadline is not None
        bench.now = bench.session.deadline
        bench.session.tick(bench.now)
        (poll,) = bench.polls()
        polls.append((bench.now, poll))
        bench.status(cmd_id=poll)
        bench.heard()
    assert [when for when, _ in polls] == [101.0, 102.0, 103.0]
    assert len({poll for _, poll in polls}) == 3


def test_every_polled_answer_is_reported_even_if_nothing_changed() -> None:
    bench = Bench()
    bench.connect()
    bench.until(103.5)
    assert [event.asked_at for event in reported(bench)] == [101.0, 102.0, 103.0]


def test_a_poll_without_answer_is_asked_again_after_two_seconds_under_a_new_id() -> None:
    bench = Bench()
    bench.connect()
    bench.until(100.9)
    sent = bench.silent_until(103.1)
    assert [type(frame) for frame in sent] == [Enq, Enq]
    first, second = (frame.cmd_id for frame in sent)
    assert first != second
    assert bench.session.link.lost_polls == 1


def test_a_late_answer_to_an_earlier_poll_says_when_it_was_asked() -> None:
    bench = Bench()
    bench.connect()
    sent = bench.silent_until(103.1)
    bench.status(cmd_id=sent[0].cmd_id)
    assert [event.asked_at for event in reported(bench)] == [101.0]
    bench.status(cmd_id=sent[1].cmd_id, seq=1)
    assert [event.asked_at for event in reported(bench)] == [103.0]


def test_an_answer_to_a_poll_that_a_newer_answer_has_overtaken_is_ignored() -> None:
    bench = Bench()
    bench.connect()
    sent = bench.silent_until(103.1)
    bench.status(cmd_id=sent[1].cmd_id)
    bench.take()
    bench.status(cmd_id=sent[0].cmd_id, seq=9)
    assert [event.reason for event in garbled(bench)] == ["unasked answer"]
    assert bench.session.status is not None
    assert bench.session.status.seq == 0


def test_only_a_few_open_polls_are_remembered() -> None:
    bench = Bench()
    bench.connect()
    for _ in range(8):
        bench.silent_until(bench.now + 2.0)
        bench.ack(1)
    assert len(bench.session._polls) == 4


def test_a_nak_of_a_poll_asks_anew_at_the_next_turn_and_not_in_a_loop() -> None:
    bench = Bench()
    bench.connect()
    sent = bench.silent_until(101.0)
    bench.say(Nak(12, sent[0].cmd_id))
    assert bench.heard() == []
    again = bench.silent_until(102.0)
    assert [type(frame) for frame in again] == [Enq]
    assert again[0].cmd_id != sent[0].cmd_id


def test_three_and_a_half_seconds_without_a_valid_packet_take_the_link_down() -> None:
    bench = Bench()
    bench.connect()
    bench.silent_until(103.4)
    states = [(bench.session.up, bench.session.wants_close)]
    bench.silent_until(103.5)
    states.append((bench.session.up, bench.session.wants_close))
    assert states == [(True, False), (False, True)]
    assert bench.session.deadline is None
    assert LinkDown(V, "no valid packet for 3.5 s") in bench.session.events()
    bench.session.disconnected(bench.now, "closed")
    assert not bench.session.wants_close
    assert bench.session.events() == []


def test_a_vehicle_that_never_answers_is_closed_without_a_link_down() -> None:
    bench = Bench()
    bench.session.connected(bench.now)
    bench.silent_until(104.0)
    assert bench.session.wants_close
    assert bench.session.events() == []


def test_what_arrives_while_closing_or_down_is_ignored() -> None:
    bench = Bench()
    bench.connect()
    bench.silent_until(104.0)
    bench.take()
    bench.status()
    bench.session.tick(Seconds(110.0))
    assert (bench.session.events(), bench.session.outgoing()) == ([], b"")
    bench.session.disconnected(bench.now, "closed")
    bench.status()
    assert (bench.session.events(), bench.session.outgoing()) == ([], b"")


def test_losing_the_connection_takes_the_link_down_with_its_reason() -> None:
    bench = Bench()
    bench.connect()
    bench.session.disconnected(bench.now, "reset by peer")
    assert bench.session.events() == [LinkDown(V, "reset by peer")]
    assert bench.session.status is not None


def test_connecting_twice_is_a_lost_connection_first() -> None:
    bench = Bench()
    bench.connect()
    bench.session.connected(bench.now)
    assert bench.session.events() == [LinkDown(V, "connected anew")]
    assert len(bench.polls()) == 1
    assert bench.session.link.connections == 2


def test_an_event_is_acknowledged_at_once_and_reported() -> None:
    bench = Bench()
    bench.connect()
    event = bench.status(DRIVING1, DRIVING2, 1202, 1)
    assert bench.session.outgoing() == bench.codec.ack(12, event)
    (told,) = reported(bench)
    assert (told.polled, told.status.barcode, told.status.seq) == (False, "1202", 1)
    assert told.status is bench.session.status


def test_an_event_that_changes_nothing_is_acknowledged_but_not_reported() -> None:
    bench = Bench()
    bench.connect()
    bench.now = Seconds(100.5)
    event = bench.status()
    assert bench.acks() == [event]
    assert bench.session.events() == []
    assert bench.session.status_at == 100.5


def test_a_repeated_event_is_acknowledged_again_and_ignored() -> None:
    bench = Bench()
    bench.connect()
    event = bench.status(barcode=1202)
    bench.status(barcode=1203)
    bench.take()
    bench.status(barcode=1202, cmd_id=event)
    assert bench.acks() == [event]
    assert bench.session.events() == []
    assert bench.session.status is not None
    assert bench.session.status.barcode == "1203"
    assert bench.session.link.duplicates == 1


def test_the_same_id_with_another_payload_is_no_duplicate() -> None:
    bench = Bench()
    bench.connect()
    event = bench.status(barcode=1202)
    bench.status(barcode=1203, cmd_id=event)
    assert [told.status.barcode for told in reported(bench)] == ["1202", "1203"]


def test_the_same_id_and_data_under_another_code_are_no_duplicate() -> None:
    bench = Bench()
    bench.connect()
    body = Resp2(status1(STANDING1), status2(AUTO_IDLE), 7, 0)
    status = bench.codec.encode(Enq(12, TOP + 9, Code.STATUS, body))
    bench.session.received(status, bench.now)
    bench.session.received(bench.codec.encode(Enq(12, TOP + 9, 0x6F99, Raw(status[15:31])), strict=False), bench.now)
    assert bench.session.link.duplicates == 0
    assert [event.reason for event in garbled(bench)] == ["unfit packet"]


def test_a_tape_tells_numbers_and_contents_beyond_what_it_keeps_of_them() -> None:
    tape, number = Tape(), (1 << 32) - 1
    kinds = [(Taped.OUT, b"\x05" * 40), (Taped.ASKED, b"\x01" * 8), (Taped.ANSWERED, b"\x02" * 24), (Taped.IN, b"\x06")]
    for n, (kind, content) in enumerate(kinds):
        tape.append(number + n, Seconds(float(n)), kind, content)
    told = [(number + n, Seconds(float(n)), kind, content) for n, (kind, content) in enumerate(kinds)]
    assert list(tape.packets(number + 7)) == told


def test_the_same_packet_on_another_connection_is_no_duplicate() -> None:
    bench = Bench()
    bench.connect()
    event = bench.status(barcode=1202)
    bench.session.disconnected(bench.now, "gone")
    bench.connect()
    bench.status(barcode=1202, cmd_id=event)
    assert [told.status.barcode for told in reported(bench)] == ["1202"]


@pytest.mark.parametrize("split", [False, True])
def test_the_last_64_events_are_remembered_and_memory_stays_bounded(split: bool) -> None:
    bench = Bench()
    bench.connect()
    sent = []
    for i in range(300):
        frame = Enq(12, TOP + 5000 + i, Code.STATUS, Resp2(status1(STANDING1), status2(AUTO_IDLE), i, 0))
        data = bench.codec.encode(frame)
        sent.append(data)
        for piece in (data[:7], data[7:]) if split else (data,):
            bench.session.received(piece, bench.now)
    bench.take()
    for data in sent[-64:]:
        bench.session.received(data, bench.now)
    assert bench.session.events() == []
    assert bench.session.link.duplicates == 64
    assert len(bench.session._seen) <= 64


def test_a_duplicate_is_known_whether_it_came_whole_or_in_pieces() -> None:
    bench = Bench()
    bench.connect()
    data = bench.codec.encode(Enq(12, TOP + 9, Code.STATUS, Resp2(status1(STANDING1), status2(AUTO_IDLE), 7, 0)))
    for byte in data:
        bench.session.received(bytes([byte]), bench.now)
    bench.session.received(data, bench.now)
    assert len(reported(bench)) == 1
    assert bench.session.link.duplicates == 1


def test_two_packets_in_one_piece_are_both_taken() -> None:
    bench = Bench()
    bench.connect()
    body = Resp2(status1(STANDING1), status2(AUTO_IDLE), 7, 0)
    both = b"".join(bench.codec.encode(Enq(12, TOP + i, Code.STATUS, body)) for i in (9, 10))
    bench.session.received(both, bench.now)
    assert bench.acks() == [TOP + 9, TOP + 10]


def test_two_events_before_the_owner_writes_are_both_acknowledged() -> None:
    bench = Bench()
    bench.connect()
    first, second = bench.status(barcode=1), bench.status(barcode=2)
    assert bench.acks() == [first, second]


def test_a_foreign_dev_id_is_not_acknowledged_and_not_a_sign_of_life() -> None:
    bench = Bench()
    bench.connect()
    bench.now = Seconds(103.4)
    bench.say(Enq(13, TOP + 1, Code.STATUS, Resp2(status1(STANDING1), status2(AUTO_IDLE), 7, 0)))
    bench.say(Ack(13, 5))
    assert bench.session.outgoing() == b""
    told = garbled(bench)
    assert [event.reason for event in told] == ["foreign DEV_ID"] * 2
    assert "12" in told[0].detail
    assert "13" in told[0].detail
    bench.silent_until(103.5)
    assert bench.session.wants_close


def test_noise_before_a_packet_is_told_and_the_packet_taken() -> None:
    bench = Bench()
    bench.connect()
    data = bench.codec.encode(Enq(12, TOP + 9, Code.STATUS, Resp2(status1(STANDING1), status2(AUTO_IDLE), 7, 0)))
    bench.session.received(b"\xff\xfe" + data, bench.now)
    told = bench.session.events()
    assert [type(event) for event in told] == [Garbled, Reported]
    assert bench.session.link.garbled == 1


def test_a_broken_crc_is_told_and_not_acknowledged() -> None:
    bench = Bench()
    bench.connect()
    data = bytearray(bench.codec.encode(Enq(12, TOP, Code.STATUS, Resp2(status1(1), status2(AUTO_IDLE), 7, 0))))
    data[20] ^= 1
    bench.session.received(bytes(data), bench.now)
    bench.silent_until(100.3)
    assert {event.reason for event in garbled(bench)} <= {"crc", "truncated", "noise"}
    assert bench.session.outgoing() == b""


def test_half_a_packet_is_given_up_after_200_ms_of_silence() -> None:
    bench = Bench()
    bench.connect()
    body = Resp2(status1(STANDING1), status2(AUTO_IDLE), 7, 0)
    whole = bench.codec.encode(Enq(12, TOP + 9, Code.STATUS, body))
    # An ETB head that claims a sub packet swallows what follows until the line is idle.
    lie = bench.codec.encode(Etb(12, 3, Code.XMOVE, Xmove([], length=6000, count=500)), strict=False)[:33]
    bench.session.received(lie + whole, bench.now)
    assert bench.session.events() == []
    assert bench.session.deadline == pytest.approx(100.2)
    bench.silent_until(100.25)
    told = bench.session.events()
    assert [type(event) for event in told] == [Garbled, Reported]


def test_new_bytes_put_the_flush_off() -> None:
    bench = Bench()
    bench.connect()
    bench.session.received(b"\x05", bench.now)
    bench.now = Seconds(100.15)
    bench.session.received(b"\x00", bench.now)
    assert bench.session.deadline == pytest.approx(100.35)


def test_bytes_left_from_an_old_connection_do_not_spoil_the_next() -> None:
    bench = Bench()
    bench.connect()
    bench.session.received(b"\x05\x00\x00", bench.now)
    bench.session.disconnected(bench.now, "gone")
    bench.connect()
    bench.status(barcode=9)
    assert [told.status.barcode for told in reported(bench)] == ["9"]


def test_an_etb_from_the_vehicle_is_no_packet_for_us() -> None:
    bench = Bench()
    bench.connect()
    bench.say(Etb(12, 3, Code.XMOVE, Xmove([])))
    assert [event.reason for event in garbled(bench)] == ["unfit packet"]


def test_an_unknown_code_is_acknowledged_and_told() -> None:
    bench = Bench()
    bench.connect()
    for data in (bytes(range(16)), bytes(16)):
        cmd_id = bench.event(0x3456, Raw(data))
        assert bench.acks() == [cmd_id]
        told = garbled(bench)
        assert [event.reason for event in told] == ["unfit packet"]
        assert "0x3456" in told[0].detail


def test_a_listed_code_that_answers_nothing_is_acknowledged_and_told() -> None:
    bench = Bench()
    bench.connect()
    cmd_id = bench.event(Code.DISTANCE, Raw(bytes(16)))
    assert bench.acks() == [cmd_id]
    assert [event.reason for event in garbled(bench)] == ["unfit packet"]


@pytest.mark.parametrize("code", [Code.STATUS, Code.MOVE])
def test_a_packet_for_another_epoch_is_acknowledged_logged_and_ignored(code: Code) -> None:
    bench = Bench()
    bench.connect()
    other = (6 << 32) + 5
    if code is Code.STATUS:
        bench.status(barcode=5, cmd_id=other)
    else:
        bench.say(Enq(12, other, code, Resp1(0, status2(AUTO_IDLE), 5, 0)))
    assert bench.acks() == [other]
    assert [event.reason for event in garbled(bench)] == ["another epoch"]
    assert bench.session.status is not None
    assert bench.session.status.barcode == "1201"


def test_a_vehicle_that_invents_ids_without_the_top_bit_answers_the_oldest_poll() -> None:
    bench = Bench()
    bench.session.connected(bench.now)
    bench.status(cmd_id=55)
    assert bench.session.up
    bench.take()
    bench.status(cmd_id=56, barcode=3)
    assert [told.polled for told in reported(bench)] == [False]


def test_without_ack_answers_nothing_is_acknowledged() -> None:
    bench = Bench(Dialect(ack_answers=False))
    bench.connect()
    bench.status(barcode=5)
    assert bench.acks() == []
    assert bench.session.status is not None
    assert bench.session.status.barcode == "5"


@pytest.mark.parametrize("name", DIALECTS)
def test_every_dialect_takes_events_and_answers_alike(name: str) -> None:
    dialect = DIALECTS[name]
    bench = Bench(dialect)
    barcode: int | str = "1202" if dialect.barcode_format == "ascii" else 1202
    bench.connect(barcode=barcode)
    event = bench.status(DRIVING1, DRIVING2, barcode, 4)
    assert bench.acks() == [event]
    assert bench.session.status is not None
    assert (bench.session.status.barcode, bench.session.status.seq) == ("1202", 4)
    assert bench.session.status.dist == (450 if dialect.has_dist else None)
    bench.until(101.5, DRIVING1, DRIVING2, 4)
    assert bench.session.up


def test_a_barcode_off_the_map_suggests_the_dialect_that_would_fit() -> None:
    bench = Bench(DIALECTS["slides"], barcodes={"1203"})
    bench.session.connected(bench.now)
    bench.status(barcode=0, seq=1203, cmd_id=bench.polls()[0])
    assert "barcode 0 is not on the map" in bench.session.hint
    # Document B: 00 00 00 00 04 B3 | 01 C2 is barcode 1203 and SEQ 450.
    assert "1203" in bench.session.hint
    assert "dialect default" in bench.session.hint


def test_the_sources_slides_status_read_as_document_b_suggests_slides() -> None:
    bench = Bench(barcodes={"1203"})
    bench.session.connected(bench.now)
    bench.status(DRIVING1, DRIVING2, 0x04B30007 >> 16 << 16 | 7, 450, bench.polls()[0])
    assert bench.session.hint.startswith("barcode 78839815 is not on the map")
    bench2 = Bench(barcodes={"1203"})
    bench2.session.connected(bench2.now)
    bench2.status(DRIVING1, DRIVING2, 0x000004B30007, 450, bench2.polls()[0])
    assert bench2.session.hint.endswith("try dialect slides")


def test_a_barcode_on_the_map_or_none_recognised_gives_no_hint() -> None:
    bench = Bench(barcodes={"1201"})
    bench.connect()
    assert bench.session.hint == ""
    bench = Bench(barcodes={"1201"})
    bench.connect(0x0B11BB34, 0, 0)
    assert bench.session.hint == ""
    bench = Bench(barcodes={"1201"})
    bench.connect(barcode=99)
    assert bench.session.hint.endswith("check the dialect and the layout")


def test_the_last_frames_are_kept_both_ways_and_bounded() -> None:
    bench = Bench()
    bench.connect(word2=MANT_IDLE)
    event = bench.status(barcode=1202)
    (_, way_in, data), (_, way_out, ack) = list(bench.session.last_frames)[-2:]
    assert (way_in, way_out, ack) == ("in", "out", bench.codec.ack(12, event))
    assert data[13:15] == b"\x70\x30"
    for i in range(40):
        bench.status(barcode=i)
    assert len(bench.session.last_frames) == 32
    assert bench.session.link.frames_in == 42
    assert bench.session.link.frames_out == 43


def test_the_last_frames_stand_in_the_order_of_the_line() -> None:
    bench = Bench()
    bench.connect()
    first = bench.status(barcode=1202)
    for byte in bench.codec.encode(Enq(12, TOP + 77, Code.STATUS, Resp2(status1(STANDING1), status2(AUTO_IDLE), 7, 0))):
        bench.session.received(bytes([byte]), bench.now)
    last = bench.status(barcode=1203)
    ids = [int.from_bytes(packet[5:13], "big") for _, _, packet in bench.session.last_frames]
    poll = ids[0]
    assert ids == [poll, poll, poll, first, first, TOP + 77, TOP + 77, last, last]
    assert [way for _, way, _ in bench.session.last_frames] == ["out", *["in", "out"] * 4]


def test_polls_and_their_answers_are_given_back_as_they_were_on_the_line() -> None:
    bench = Bench()
    line: list[tuple[str, bytes]] = []
    bench.connect()
    bench.session.outgoing()
    for n in range(15):
        bench.session.ask(bench.now)
        poll = bench.session.outgoing()
        (asked,) = Decoder(bench.codec, Toward.VEHICLE).feed(poll)
        assert isinstance(asked, Enq)
        answer = bench.codec.encode(
            Enq(12, asked.cmd_id, Code.STATUS, Resp2(status1(STANDING1), status2(AUTO_IDLE), 1000 + n, 0))
        )
        bench.session.received(answer, bench.now)
        line += [("out", poll), ("in", answer), ("out", bench.session.outgoing())]
    assert [(way, packet) for _, way, packet in bench.session.last_frames] == line[-32:]
    assert bench.session.link.frames_in == 16
    assert bench.session.link.frames_out == 32


def test_an_answer_to_a_poll_that_comes_again_within_64_others_is_known() -> None:
    bench = Bench()
    bench.connect()
    answers = []
    for n in range(64):
        bench.session.ask(bench.now)
        (asked,) = Decoder(bench.codec, Toward.VEHICLE).feed(bench.session.outgoing()[-33:])
        assert isinstance(asked, Enq)
        body = Resp2(status1(STANDING1), status2(AUTO_IDLE), 1000 + n, 0)
        answers.append(bench.codec.encode(Enq(12, asked.cmd_id, Code.STATUS, body)))
        bench.session.received(answers[-1], bench.now)
    bench.session.outgoing()
    bench.session.received(answers[0], bench.now)
    assert bench.session.link.duplicates == 1
    assert len(bench.session.outgoing()) == 15
    assert bench.session.status is not None
    assert bench.session.status.barcode == "1063"


def test_events_and_a_duplicate_in_one_piece_are_taken_in_order() -> None:
    bench = Bench()
    bench.connect()
    body = [Resp2(status1(STANDING1), status2(AUTO_IDLE), barcode, 0) for barcode in (7, 8, 9)]
    packets = [bench.codec.encode(Enq(12, TOP + n, Code.STATUS, each)) for n, each in enumerate(body, 5)]
    bench.session.received(b"".join([*packets, packets[1]]), bench.now)
    assert bench.acks() == [TOP + 5, TOP + 6, TOP + 7, TOP + 6]
    assert [told.status.barcode for told in reported(bench)] == ["7", "8", "9"]
    assert bench.session.link.duplicates == 1


def test_sessions_of_two_epochs_never_ask_under_the_same_id() -> None:
    spec = VehicleSpec(V, DevId(12))
    polls = set()
    for epoch in (1, 2):
        session = Session(spec, DIALECTS["default"], CmdIds(Epoch(epoch)))
        session.connected(Seconds(0.0))
        polls.add(session.outgoing())
    assert len(polls) == 2


def test_what_is_taken_at_once_is_told_and_acknowledged_as_by_the_long_way() -> None:
    told: list[Event] = []
    bench, other = Bench(), Bench()
    for each in (bench, other):
        each.connect()
        each.session.events()
        each.session.outgoing()
    bench.session._pass_on = lambda events, _now: told.extend(events)
    body = Resp2(status1(STANDING1), status2(AUTO_IDLE), 77, 3)
    event = bench.codec.encode(Enq(12, TOP + 900, Code.STATUS, body))
    ack = bench.session.at_once(event, bench.now)
    for byte in event:
        other.session.received(bytes([byte]), other.now)
    assert ack == other.session.outgoing()
    assert told == other.session.events() != []
    assert bench.session.status == other.session.status
    assert bench.session.last_frames == other.session.last_frames
    assert bench.session.outgoing() == b""


def test_what_is_no_new_status_event_is_not_taken_at_once() -> None:
    bench = Bench()
    assert bench.session.at_once(b"", bench.now) == b""
    bench.connect()
    body = Resp2(status1(STANDING1), status2(AUTO_IDLE), 77, 3)
    event, later = (bench.codec.encode(Enq(12, TOP + n, Code.STATUS, body)) for n in (900, 901))
    foreign = bench.codec.encode(Enq(13, TOP + 902, Code.STATUS, body))
    taught = bench.codec.encode(Enq(12, TOP + 903, Code.LIFT_DEST_TEACHING, Teach(5, 1201)))
    assert bench.session.at_once(event, bench.now)
    for data in (event, later[:-1] + b"?", later + later, later[:20], foreign, taught):
        before = bench.session.link
        assert bench.session.at_once(data, bench.now) == b""
        assert bench.session.link == before
