from dataclasses import replace

import pytest

from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.messages import (
    MESSAGES,
    NOTHING,
    Ack,
    Body,
    Code,
    Disp,
    Element,
    Enq,
    Etb,
    Form,
    Infr,
    Jog,
    Mode,
    Move,
    Nak,
    Port,
    Raw,
    Req,
    Resp1,
    Resp2,
    Sbuf,
    Stid,
    Teach,
    Xmove,
    messages_of,
    problems,
)
from app.protocols.itsc.status import Oper, Status1, Status2, status1, status2

MODE_OF_BIT = {12: Mode.AUTO, 13: Mode.MANT, 14: Mode.SEMI}
RUN = Element(1201, 0, 3, 0, 80)
STOP = Element(1202, 1, 3, 1, 80)


@pytest.mark.parametrize("code", Code)
def test_the_top_nibble_of_each_code_names_the_modes_of_its_row(code: Code) -> None:
    named = {mode for bit, mode in MODE_OF_BIT.items() if code >> bit & 1}
    assert MESSAGES[code].modes == named
    assert code >> 15 == 0
    assert code >> 8 & 15 == 0


def test_every_code_has_one_row_and_stands_for_itself() -> None:
    assert set(MESSAGES) == set(Code)
    assert all(row.kind == code == row.code for code, row in MESSAGES.items())


def test_only_auto_and_stop_change_the_mode() -> None:
    after = {row.kind: row.mode_after for row in MESSAGES.values() if row.mode_after is not None}
    assert after == {Code.AUTO: Mode.AUTO, Code.STOP: Mode.MANT}


def test_only_teaching_comes_from_the_vehicle_of_itself() -> None:
    assert {row.name for row in MESSAGES.values() if row.from_vehicle} == {
        f"{axis} {what} TEACHING" for axis in ("SHFT", "ROTA", "LIFT") for what in ("DEST", "OFFSET")
    }


def test_a_dialect_may_number_the_teaching_messages_otherwise() -> None:
    table = messages_of(Dialect(teach_shft_dest=0x2170))
    assert table[0x2170].kind is Code.SHFT_DEST_TEACHING
    assert table[0x2170].code == 0x2170
    assert 0x2070 not in table


def test_a_format_without_a_message_gets_one_when_the_dialect_gives_it_a_code() -> None:
    row = messages_of(Dialect(jog_code=0x2050))[0x2050]
    assert (row.kind, row.name, row.request, row.modes) == (None, "JOG", Form.JOG, frozenset({Mode.MANT}))
    assert problems(Enq(1, 1, 0x2050, Jog(1, 5)), messages_of(Dialect(jog_code=0x2050))) == ()


def test_the_source_s_status_words_decode_to_the_source_s_meanings() -> None:
    assert status1(0x0B11BB34) == Status1(trav=11, shft=1, rota=1, lift=11, slid=11, grip=3, sftb=4)
    assert status1(0x8FFFFFFF).foup
    assert status2(0xEF002100) == Status2(Mode.AUTO, Oper.RUN, True, True, True, True, 0, 0x2100)  # noqa: FBT003
    assert status2(0x80000000).mode is Mode.UNDEFINED


@pytest.mark.parametrize("word", [0, 0x0B11BB34, 0xF0000000, 0xFFFFFFFF, 0x70FF1234])
def test_a_status_word_comes_back_from_its_fields(word: int) -> None:
    assert status1(word).word == word
    assert status2(word).word == word


def test_the_same_status_word_gives_the_same_object() -> None:
    assert status1(0x12345678) is status1(0x12345678)
    assert status2(0x12345678) is status2(0x12345678)


def test_a_peer_that_sends_ever_new_status_words_does_not_fill_the_memory() -> None:
    from app.protocols.itsc.status import KNOWN_STATUS1, KNOWN_STATUS2

    for word in range(5000):
        status1(word)
        status2(word)
    assert max(len(KNOWN_STATUS1), len(KNOWN_STATUS2)) <= 4096


@pytest.mark.parametrize("wrong", [Status1(trav=16), Status1(rsv=8), Status2(rsv=256), Status2(code=0x10000)])
def test_a_status_field_too_wide_for_its_bits_is_refused(wrong: Status1 | Status2) -> None:
    with pytest.raises(ValueError, match="does not fit"):
        _ = wrong.word


@pytest.mark.parametrize(
    ("element", "complaint"),
    [(replace(RUN, sensor=16), "sensor"), (replace(RUN, action=16), "action"), (replace(RUN, speed=256), "speed")],
)
def test_a_travel_condition_too_wide_for_its_bits_is_refused(element: Element, complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint):
        _ = element.trav_cond


@pytest.mark.parametrize(
    "frame", [Ack(1, 1), Nak(1, 1), Enq(1, 1, Code.STATUS, NOTHING), Enq(1, 1, Code.DISTANCE, Raw(bytes(16)))]
)
def test_a_sound_packet_has_no_problems(frame: Ack | Nak | Enq) -> None:
    assert problems(frame) == ()


def test_an_unknown_code_is_a_problem_and_says_its_number() -> None:
    assert problems(Enq(1, 1, 0x9999, Raw(bytes(16)))) == ("unknown code 0x9999",)


@pytest.mark.parametrize(
    ("frame", "complaint"),
    [
        (Enq(1, 1, Code.MOVE, Move([replace(STOP, seq=0)])), "MOVE needs an ETB packet"),
        (Enq(1, 1, Code.MOVE, Raw(bytes(16))), "MOVE needs an ETB packet"),
        (Etb(1, 1, Code.STATUS, Raw(bytes(16))), "STATUS does not travel in an ETB packet"),
        (Etb(1, 1, Code.STATUS, Xmove([STOP])), "XMOVE is no format of STATUS"),
        (Enq(1, 1, Code.STATUS, Sbuf(1)), "SBUF is no format of STATUS"),
    ],
)
def test_data_in_the_wrong_packet_is_a_problem(frame: Enq | Etb, complaint: str) -> None:
    assert complaint in problems(frame)


@pytest.mark.parametrize(
    ("path", "complaint"),
    [
        ([], "the path is empty"),
        ([replace(STOP, seq=3)], "the first SEQ is 3, not 0"),
        ([RUN, replace(STOP, seq=0)], "SEQ 0 follows 0"),
        ([RUN, replace(STOP, seq=2)], "SEQ 2 follows 0"),
        ([RUN], "the last element is not a stop"),
        ([replace(RUN, action=6)], "SEQ 0: action 6 is outside 0..5"),
        ([replace(RUN, speed=0), STOP], "SEQ 0: speed 0 is outside 1..100"),
        ([replace(RUN, speed=101), STOP], "SEQ 0: speed 101 is outside 1..100"),
        ([replace(RUN, barcode="é"), STOP], "SEQ 0: BARCODE 'é' is not printable ASCII"),
    ],
)
def test_a_path_that_cannot_be_driven_is_a_problem(path: list[Element], complaint: str) -> None:
    assert complaint in problems(Etb(1, 1, Code.MOVE, Move(path)))


def test_a_path_may_stop_on_the_way_and_show_one_barcode_twice() -> None:
    path = [replace(STOP, seq=0), replace(STOP, seq=1), replace(STOP, seq=2, action=5)]
    assert problems(Etb(1, 1, Code.MOVE, Move(path))) == ()


def test_an_xmove_may_begin_at_any_seq_and_never_wraps() -> None:
    assert problems(Etb(1, 1, Code.XMOVE, Xmove([replace(STOP, seq=65535)]))) == ()
    wrapped = Xmove([replace(RUN, seq=65535), replace(STOP, seq=0)])
    assert problems(Etb(1, 1, Code.XMOVE, wrapped)) == ("SEQ 0 follows 65535",)


def test_length_and_count_must_agree_with_the_path() -> None:
    move = Move([replace(STOP, seq=0)], length=88, count=2)
    assert problems(Etb(1, 1, Code.MOVE, move)) == ("LENGTH 88 does not fit 1 elements (76)", "COUNT 2, but 1 elements")


@pytest.mark.parametrize(
    ("code", "body", "complaint"),
    [
        (Code.PICKUP_FROM_PORT, Port(0, 0, 0, 16, 50), "LKDN 16 is outside 0..15"),
        (Code.PLACE_TO_PORT, Port(0, 0, 0, 0, 0), "SPD 0 is outside 1..100"),
        (Code.PLACE_TO_SBFL, Sbuf(101), "SPD 101 is outside 1..100"),
        (Code.DISPLAY_BY_HOST, Disp(0, 2, ""), "OPT 2 is outside 0..1"),
        (Code.DISPLAY_BY_HOST, Disp(0, 1, "\x07"), "text '\\x07' is not printable ASCII"),
        (Code.MOVE, Resp1(2, Status2(), 1, 1), "RESULT 2 is outside 0..1"),
        (Code.STATUS, Resp2(Status1(), Status2(), "ÿ", 0), "BARCODE 'ÿ' is not printable ASCII"),
        (Code.LIFT_DEST_TEACHING, Teach(0, "ÿ"), "BARCODE 'ÿ' is not printable ASCII"),
        (0x2001, Req(2, 2), "OPT2 2 is outside 0..1"),
        (0x2001, Jog(5, 0), "OPT 5 is outside 1..4"),
        (0x2001, Jog(3, 1), "VALUE 1 is outside 0..0"),
        (0x2001, Infr(6), "OPT 6 is outside 0..5"),
        (0x2001, Stid("가"), "STID '가' is not printable ASCII"),
    ],
)
def test_a_value_outside_what_the_source_allows_is_a_problem(code: int, body: Body, complaint: str) -> None:
    assert complaint in problems(Enq(1, 1, code, body))
