import json

import pytest
import typer

from app.cli.decode import decode

MOVING = "05 00000001 0000000000000001 7030 08111134 EF002100 0000000004B3 0007 7065"


def refused(capsys: pytest.CaptureFixture[str], protocol: str, text: str, **options: str) -> str:
    with pytest.raises(typer.Exit) as left:
        decode(protocol, [text], **options)  # type: ignore[arg-type]
    assert left.value.exit_code == 2
    return capsys.readouterr().err


def test_a_packet_is_explained_line_by_line(capsys: pytest.CaptureFixture[str]) -> None:
    decode("itsc", [*MOVING.split(), "FF"])
    out = capsys.readouterr().out
    assert "[vehicle to controller]" in out
    assert "TRAV   8                 driving" in out
    assert "@33  FF\n  no packet starts here: byte FF starts no packet" in out


def test_a_packet_is_explained_in_korean(capsys: pytest.CaptureFixture[str]) -> None:
    decode("itsc", [MOVING], lang="ko")
    assert "구동 중" in capsys.readouterr().out


def test_a_program_gets_json(capsys: pytest.CaptureFixture[str]) -> None:
    decode("itsc", [MOVING + "00"], json=True, dialect="itsc.default")
    told = json.loads(capsys.readouterr().out)
    first, rubbish = told["pieces"]
    assert told["dialect"] == "default"
    assert first["readings"][0]["frame"]["fields"]["barcode"] == 1203
    assert rubbish["garbled"]["reason"] == "noise"


def test_another_dialect_is_suggested(capsys: pytest.CaptureFixture[str]) -> None:
    decode("itsc", [MOVING], dialect="slides")
    assert "* dialect default makes more sense of it (barcode 1203 SEQ 7)" in capsys.readouterr().out


def test_what_cannot_be_read_is_refused_with_the_reason(capsys: pytest.CaptureFixture[str]) -> None:
    assert "'g' at position 5" in refused(capsys, "itsc", "05 0g")
    assert "no bytes were given" in refused(capsys, "itsc", " ")
    assert "did you mean 'itsc'" in refused(capsys, "itcs", "05")
    assert "did you mean 'slides'" in refused(capsys, "itsc", "05", dialect="slide")
    assert "known: en, ko" in refused(capsys, "itsc", "05", lang="fr")
