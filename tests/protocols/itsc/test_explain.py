import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.protocols.itsc import wording
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT, DIALECTS, Dialect
from app.protocols.itsc.explain import Explanation, Row, explain, frame_rows, garbled_row, status1_rows, status2_rows
from app.protocols.itsc.framing import Garbled, Reason
from app.protocols.itsc.messages import (
    NOTHING,
    Ack,
    Code,
    Element,
    Enq,
    Etb,
    Frame,
    Jog,
    Move,
    Port,
    Raw,
    Resp1,
    Resp2,
    Status1,
    Status2,
    Teach,
    Toward,
    status1,
    status2,
)
from tests.protocols.itsc.frames import a_move, frames

CODEC = Codec()
MOVING = Resp2(status1(0x08111134), status2(0xEF002100), 1203, 7)


def ways(explanation: Explanation) -> list[list[str]]:
    return [[reading.direction for reading in piece.readings] for piece in explanation.pieces]


def read(frame: Frame, dialect: Dialect = DEFAULT) -> Explanation:
    return explain(Codec(dialect).encode(frame, strict=False), dialect)


def meanings(rows: tuple[Row, ...]) -> dict[str, str]:
    return {row.name: row.meaning for row in rows}


def test_every_field_and_bit_of_a_status_is_named() -> None:
    (piece,) = read(Enq(1, 1 << 63, Code.STATUS, MOVING)).pieces
    (reading,) = piece.readings
    assert [row.name for row in reading.rows] == [
        "TYPE", "DEV_ID", "CMD_ID", "CMD", "FORM", "STATUS1", "F", "TRAV", "SHFT", "ROTA", "LIFT", "SLID", "GRIP", "SFTB",
        "STATUS2", "MODE", "OPER", "R", "H", "F", "S", "CODE", "BARCODE", "SEQ",
    ]  # fmt: skip
    said = meanings(reading.rows)
    assert (said["TRAV"], said["GRIP"], said["MODE"]) == ("driving", "closed", "AUTO")
    assert said["CODE"] == "process code 8448"
    assert said["CMD_ID"] == "given by the vehicle"


def test_korean_is_given_where_it_is_asked_for() -> None:
    rows = tuple(frame_rows(Enq(1, 1, Code.STATUS, MOVING), CODEC, "ko"))
    said = meanings(rows)
    assert (said["TRAV"], said["SFTB"]) == ("구동 중", "올림")
    assert said["CMD"].startswith("STATUS, 상태")


def test_reserved_bits_and_unknown_values_are_shown_as_numbers() -> None:
    first = {row.name: row for row in status1_rows(Status1(rsv=5, trav=15))}
    assert (first["30-28"].value, first["TRAV"].value, first["TRAV"].meaning) == ("5", "15", "undefined")
    second = {row.name: row for row in status2_rows(status2(0x90AB03E9))}
    assert (second["23-16"].value, second["MODE"].meaning) == ("AB", "undefined")
    assert second["CODE"].meaning == "alarm code 1001"


def test_an_answer_and_a_request_are_told_apart_by_what_they_say() -> None:
    assert ways(read(Enq(1, 1, Code.STATUS, MOVING))) == [["VEH>TC"]]
    assert ways(read(Enq(1, 1, Code.PICKUP_FROM_PORT, Port(-1520, 900, 1170000, 5, 80)))) == [["TC>VEH"]]
    assert ways(read(Enq(1, 1, Code.PICKUP_FROM_PORT, Resp1(0, status2(0xCF000000), 1203, 2)))) == [["VEH>TC"]]
    assert ways(read(Enq(1, 1, Code.LIFT_DEST_TEACHING, Teach(5, 1203)))) == [["VEH>TC"]]
    assert ways(read(a_move())) == [["TC>VEH"]]
    assert ways(read(Ack(1, 1))) == [["both"]]


def test_both_ways_are_shown_where_either_makes_sense() -> None:
    assert ways(read(Enq(1, 1, Code.PICKUP_FROM_SBFL, Resp1(0, Status2(), 0, 80)))) == [["TC>VEH", "VEH>TC"]]


def test_both_ways_are_shown_with_their_problems_where_neither_does() -> None:
    (piece,) = read(Enq(1, 1, Code.PICKUP_FROM_PORT, Port(7, 0, 0, 99, 0))).pieces
    assert [reading.direction for reading in piece.readings] == ["TC>VEH", "VEH>TC"]
    assert Row("!", "LKDN 99 is outside 0..15", "problem") in piece.readings[0].rows


def test_zeros_are_a_request_and_a_hint_says_what_else() -> None:
    explanation = read(Enq(1, 1, Code.STATUS, NOTHING))
    assert ways(explanation) == [["TC>VEH"]]
    assert explanation.hints == ("from the vehicle the same bytes would be RESP2 with every field 0",)


def test_a_path_is_listed_after_what_stands_before_it() -> None:
    (reading,) = read(Etb(1, 2, Code.MOVE, Move([Element(1203, 0, 4, 2, 20)], "FOUP1"))).pieces[0].readings
    assert [row.name for row in reading.rows][5:] == ["FOUP ID", "SOURCE", "DESTINATION", "LENGTH", "COUNT", "SEQ 0"]
    assert reading.rows[-1].meaning == "2 stop to the PORT position, 20 %, obstacle sensor area 4"


def test_the_slides_distances_are_shown() -> None:
    (reading,) = read(a_move(Element(1203, 0, 4, 1, 20, 5, 6)), DIALECTS["slides"]).pieces[0].readings
    assert reading.rows[-1].meaning.endswith("DIST_ACT 5 mm, DIST_NEXT 6 mm")


def test_raw_data_is_shown_as_bytes() -> None:
    (reading,) = read(Enq(1, 1, 0x9999, Raw(bytes(range(16))))).pieces[0].readings
    assert reading.direction == "both"
    assert meanings(reading.rows)["CMD"] == "unknown code"
    sub = tuple(frame_rows(Etb(1, 1, 0x9999, Raw(bytes(16), b"\xab")), CODEC))
    assert Row("SUB", "AB") in sub


def test_a_jog_at_speed_has_no_pulses() -> None:
    jog = Codec(Dialect(jog_code=0x2050))
    assert Row("VALUE", "0") in tuple(frame_rows(Enq(1, 1, 0x2050, Jog(3, 0)), jog))
    rows = tuple(frame_rows(Enq(1, 1, 0x2050, Jog(9, 7)), jog))
    assert Row("VALUE", "7", "pulses") in rows
    assert Row("OPT", "9", "undefined") in rows
    assert Row("CMD", "2050", "JOG (TC, MANT)") in tuple(frame_rows(Enq(1, 1, 0x2050, Jog(1, 0)), jog, "ko"))


def test_rubbish_is_one_piece_and_says_why() -> None:
    explanation = explain(CODEC.ack(1, 1)[:-1] + b"\0\xff", DEFAULT)
    (piece,) = explanation.pieces
    assert piece.garbled == Garbled(Reason.CRC, "ACK: CRC 5C00, expected 5C65", 16)
    assert garbled_row(piece.garbled).value == "the CRC does not fit"


def test_status_of_the_slides_read_as_document_b_suggests_the_slides() -> None:
    data = Codec(DIALECTS["slides"]).encode(Enq(1, 1, Code.STATUS, Resp2(MOVING.status1, MOVING.status2, 1203, 7, 450)))
    hints = explain(data + b"\0" + CODEC.ack(1, 1), DEFAULT).hints
    assert hints == ("dialect slides makes more sense of it (barcode 1203 SEQ 7): try --dialect slides",)


def test_a_path_of_document_b_read_as_slides_suggests_document_b() -> None:
    hints = explain(CODEC.encode(a_move(Element(1203, 0, 4, 2, 20))), DIALECTS["slides"]).hints
    assert "dialect default makes more sense of it (barcode 1203 SEQ 0): try --dialect default" in hints


def test_another_crc_is_suggested_by_preset_or_by_its_parameters() -> None:
    modbus = Codec(DIALECTS["crc-modbus"]).ack(1, 2)
    assert explain(modbus, DEFAULT).hints == ("dialect crc-modbus makes more sense of it: try --dialect crc-modbus",)
    odd = Codec(Dialect(crc="arc", crc_covers_type=False)).ack(1, 2)
    assert explain(odd, DEFAULT).hints == ("the CRC fits with crc arc, crc_covers_type False, crc_order big",)
    assert explain(b"\xff" * 20, DEFAULT).hints == ()


@given(data=st.binary(max_size=120), name=st.sampled_from(sorted(DIALECTS)), language=st.sampled_from(["en", "ko"]))
def test_explaining_never_fails_and_covers_every_byte(data: bytes, name: str, language: wording.Language) -> None:
    explanation = explain(data, DIALECTS[name], language)
    assert b"".join(piece.data for piece in explanation.pieces) == data


@given(data=st.data())
def test_every_frame_is_explained_whole(data: st.DataObject) -> None:
    name = data.draw(st.sampled_from(sorted(DIALECTS)))
    frame = data.draw(frames(DIALECTS[name], data.draw(st.sampled_from(Toward))))
    written = Codec(DIALECTS[name]).encode(frame)
    (piece,) = explain(written, DIALECTS[name], "ko").pieces
    assert piece.data == written
    assert frame in [reading.frame for reading in piece.readings] or written[15:31] == bytes(16)


@pytest.mark.parametrize("code", Code)
def test_every_message_has_a_korean_name(code: Code) -> None:
    assert all(wording.NAMES[code])
