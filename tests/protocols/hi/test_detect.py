from pathlib import Path

import pytest
import typer

from app.cli.detect import detect
from app.protocols.hi.codec import encode
from app.protocols.hi.detect import detected, fits_of_stream, preset_of, surviving
from app.protocols.hi.dialects import DIALECTS, Bcc, Dialect
from app.protocols.hi.messages import Frame, Role

FRAMES = [
    Frame(Role.SLAVE, 1, "ACK", ("2",)),
    Frame(Role.MASTER, 1, "SSQ"),
    Frame(Role.SLAVE, 1, "SET", ("1C", "0123")),
]


@pytest.mark.parametrize("form", Bcc)
def test_a_few_packets_prove_the_form(form: Bcc) -> None:
    packets = [encode(frame, Dialect(bcc=form)) for frame in FRAMES]
    assert surviving(packets) == [form]
    assert DIALECTS[preset_of(form)].bcc is form
    fits = fits_of_stream(b"\xff\x02" + b"".join(packets))
    assert (fits[0].form, fits[0].frames, fits[0].dropped) == (form, 3, 2)


def test_no_packets_and_rubbish_prove_nothing() -> None:
    assert surviving([]) == surviving([b"\xff"]) == surviving([encode(FRAMES[0]) * 2]) == []
    assert fits_of_stream(b"\xff" * 20) == []


def test_the_command_tells_what_is_left(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "capture"
    file.write_text("".join(f"{encode(frame, DIALECTS['bcc-byte']).hex(' ')}\n" for frame in FRAMES), encoding="utf-8")
    detect("hi", file)
    assert capsys.readouterr().out.splitlines() == [
        "3 packets, 4 forms of BCC tried, 1 left:",
        "  bcc byte  (dialect bcc-byte)",
    ]
    file.write_text("ff" + "".join(encode(frame).hex() for frame in FRAMES), encoding="utf-8")
    detect("hi", file)
    assert "  bcc nibble  (dialect default): 3 packets, 38 bytes fit, 1 do not" in capsys.readouterr().out
    file.write_text("ff ff", encoding="utf-8")
    with pytest.raises(typer.Exit):
        detect("hi", file)
    assert "not HI" in capsys.readouterr().out


def test_two_forms_may_be_left() -> None:
    # The one raw byte is a digit that is also the low digit of the sum.
    frames = [Frame(Role.MASTER, 1, "SET", ("1" * n,)) for n in range(1, 60)]
    frame = next(frame for frame in frames if encode(frame) == encode(frame, DIALECTS["bcc-raw"]))
    text, fits = detected([encode(frame)])
    assert fits
    assert "more than one is left" in text
