import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.cli.decode import decode
from app.protocols.hi.codec import encode
from app.protocols.hi.dialects import DEFAULT, DIALECTS
from app.protocols.hi.explain import explain
from app.protocols.hi.messages import Frame, Role
from tests.protocols.hi.frames import known_frames

STATUS = "02 53 31 53 53 41 40 32 26 35 26 30 32 26 30 26 31 32 33 34 35 36 23 34 03"


def shown(capsys: pytest.CaptureFixture[str], text: str, **options: str) -> list[str]:
    decode("hi", [text], **options)  # type: ignore[arg-type]
    return [" ".join(line.split()) for line in capsys.readouterr().out.splitlines()]


def test_a_status_is_explained_line_by_line(capsys: pytest.CaptureFixture[str]) -> None:
    lines = shown(capsys, STATUS + " FF")
    assert lines[0] == f"@0 {STATUS}"
    assert "X 2 monitoring" in lines
    assert "FF 02 index" in lines
    assert "K 0 CW" in lines
    assert "GGGGgg 123456 1234.56 mm" in lines
    assert lines[-3:-1] == ["@25 FF", "no packet starts here: byte FF starts no packet"]


@pytest.mark.parametrize(
    ("frame", "line"),
    [
        (Frame(Role.MASTER, 0, "SRK"), "ID 0 all drives, none answers"),
        (Frame(Role.MASTER, 1, "SET", ("1C",)), "YY 1C parameter number, hexadecimal: 28"),
        (Frame(Role.SLAVE, 1, "SET", ("1C", "0123")), "CCC SET a parameter's value"),
        (Frame(Role.MASTER, 1, "INP", ("1", "0", "0", "1", "C")), "e C step select, IN3 to IN0: 12"),
        (Frame(Role.MASTER, 1, "SED", ("01",)), "data 01 does not fit the command"),
        (Frame(Role.MASTER, 1, "ZZZ", ("01",)), "data 01"),
        (Frame(Role.MASTER, 1, "ZZZ"), "CCC ZZZ not in the command table"),
        (Frame(Role.SLAVE, 1, "NAK"), "CCC NAK not taken: the checksum was wrong"),
        (Frame(Role.SLAVE, 1, "SET", ("01", "0005"), more=True), "ETB 17 continued in the next packet"),
    ],
)
def test_what_each_field_means(frame: Frame, line: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert line in shown(capsys, encode(frame).hex())


def test_a_packet_is_explained_in_korean(capsys: pytest.CaptureFixture[str]) -> None:
    assert "X 2 모니터링" in shown(capsys, STATUS, lang="ko")


def test_another_dialect_is_suggested(capsys: pytest.CaptureFixture[str]) -> None:
    assert "* dialect bcc-raw makes more sense of it" in shown(capsys, "024d305044544023c803")
    assert "BCC C8 fits" in shown(capsys, "024d305044544023c803", dialect="hi.bcc-raw")


def test_a_program_gets_json(capsys: pytest.CaptureFixture[str]) -> None:
    decode("hi", [STATUS + "02"], json=True)
    told = json.loads(capsys.readouterr().out)
    packet, rubbish = told["pieces"]
    assert (told["protocol"], told["dialect"]) == ("hi", "default")
    assert packet["frame"]["fields"]["distance_centi"] == 123456
    assert packet["rows"][0] == {"name": "M/S", "value": "S", "meaning": "from the drive"}
    assert rubbish["garbled"]["reason"] == "truncated"


@given(data=st.data(), name=st.sampled_from(sorted(DIALECTS)), language=st.sampled_from(["en", "ko"]))
def test_every_packet_can_be_explained(data: st.DataObject, name: str, language: str) -> None:
    frame = data.draw(known_frames(DIALECTS[name]))
    told = explain(encode(frame, DIALECTS[name]), DIALECTS[name], "ko" if language == "ko" else "en")
    assert told.hints == ()
    assert [piece.found for piece in told.pieces] == [frame]


@given(data=st.binary(max_size=60))
def test_every_byte_belongs_to_one_piece(data: bytes) -> None:
    assert b"".join(piece.data for piece in explain(data, DEFAULT).pieces) == data
