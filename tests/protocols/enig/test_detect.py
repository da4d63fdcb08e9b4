from pathlib import Path

import pytest
import typer

from app.cli.detect import detect
from app.protocols.enig.codec import Codec
from app.protocols.enig.detect import VARIANTS, Fit, Variant, detected, fits_of_stream, surviving
from app.protocols.enig.dialects import DEFAULT, DIALECTS, CrcFrom
from app.protocols.enig.messages import AgvReport, MoveAlias, MoveComplete, Stop, Toward


def captured(variant: Variant) -> list[bytes]:
    codec = Codec(variant.on(DEFAULT))
    return [
        codec.encode(codec.packet(11, MoveAlias("B1")), Toward.DEVICE),
        codec.encode(codec.packet(11, MoveComplete("0042")), Toward.HOST),
        codec.encode(codec.packet(11, AgvReport(mode=1, run=1, tag="0042")), Toward.HOST),
    ]


@pytest.mark.parametrize("variant", VARIANTS)
def test_three_packets_leave_the_one_variant_that_wrote_them(variant: Variant) -> None:
    assert surviving(captured(variant)) == [variant]
    assert variant.on(DEFAULT) == DIALECTS[variant.preset]


def test_what_is_no_whole_packet_fits_nothing() -> None:
    packets = captured(VARIANTS[0])
    assert surviving([]) == []
    assert surviving([*packets, packets[0][:-1]]) == []
    assert surviving([*packets, packets[0][:-1] + b"\4"]) == []
    assert surviving([*packets, b"\2\0\3"]) == []


def test_a_stream_that_holds_noise_is_searched() -> None:
    variant = Variant(CrcFrom.ID, "big")
    fit, *_ = fits_of_stream(b"\xff" + b"".join(captured(variant)) + b"\2\7")
    assert fit == Fit(variant, 3, 39, 3)


def test_the_answer_is_told_in_words() -> None:
    variant = Variant(CrcFrom.CMD, "little")
    packets = captured(variant)
    said, fits = detected(packets)
    assert fits
    assert said == "3 packets, 10 variants tried, 1 left:\n  crc from CMD, low byte first  (dialect crc-cmd)"
    said, fits = detected([b"".join(packets)])
    assert fits
    assert "crc from CMD, low byte first  (dialect crc-cmd): 3 packets, 39 bytes fit, 0 do not" in said
    assert detected([bytes(20)]) == ("none of the 10 variants fits: not ENIG, or another CRC", False)


def test_more_survivors_than_one_ask_for_more_packets() -> None:
    # Without DATA and covering DATA alone, the CRC is FFFF: its order does not show.
    codec = Codec(Variant(CrcFrom.DATA, "big").on(DEFAULT))
    said, fits = detected([codec.encode(codec.packet(11, Stop()), Toward.DEVICE)])
    assert fits
    assert "2 left" in said
    assert "capture more packets" in said


def test_the_command_reads_a_capture_and_fails_on_what_is_not_enig(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "capture.txt"
    file.write_text("\n".join(packet.hex(" ") for packet in captured(VARIANTS[0])), encoding="utf-8")
    detect("enig", file)
    assert "1 left:\n  crc from STX, high byte first" in capsys.readouterr().out
    file.write_text("ff " * 20, encoding="utf-8")
    with pytest.raises(typer.Exit):
        detect("enig", file)
