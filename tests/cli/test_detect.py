from pathlib import Path

import pytest
import typer

from app.cli.detect import detect
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DIALECTS

ARC = Codec(DIALECTS["crc-arc"])


def capture(tmp_path: Path, text: str) -> Path:
    file = tmp_path / "capture.txt"
    file.write_text(text, encoding="utf-8")
    return file


def test_a_capture_with_a_packet_on_each_line_names_the_survivor(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = "\n".join(f"{ARC.ack(1, i).hex(' ')}  # ACK {i}" for i in range(3))
    detect("itsc", capture(tmp_path, f"# captured by hand\n\n{lines}\n"))
    assert capsys.readouterr().out.splitlines() == [
        "3 packets, 24 variants tried, 1 left:",
        "  crc arc, covers TYPE, low byte first  (dialect crc-arc)",
    ]


def test_more_survivors_than_one_ask_for_more_packets(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # Where both bytes of the CRC are the same, their order does not show.
    packet = next(ack for i in range(1 << 20) if (ack := ARC.ack(1, i))[-1] == ack[-2])
    detect("itsc", capture(tmp_path, packet.hex()))
    out = capsys.readouterr().out
    assert "2 left" in out
    assert "capture more packets" in out


def test_a_stream_is_searched_for_packets(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    stream = b"\xff" + b"".join(ARC.ack(1, i) for i in range(3))
    detect("itsc", capture(tmp_path, "\n".join(stream.hex()[i : i + 32] for i in range(0, 92, 32))))
    assert (
        "crc arc, covers TYPE, low byte first  (dialect crc-arc): 3 packets, 45 bytes fit, 1 do not"
        in capsys.readouterr().out
    )


def test_a_capture_that_fits_nothing_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit) as left:
        detect("itsc", capture(tmp_path, "ff" * 40))
    assert left.value.exit_code == 1
    assert "none of the 24 variants fits" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "complaint"), [("05\n0g", "line 2: 'g' at position 2"), ("# nothing\n", "holds no bytes")]
)
def test_a_capture_that_cannot_be_read_is_refused(
    text: str, complaint: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(typer.Exit) as left:
        detect("itsc", capture(tmp_path, text))
    assert left.value.exit_code == 2
    assert complaint in capsys.readouterr().err


def test_a_file_that_is_missing_or_binary_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "raw").write_bytes(b"\xff\xfe")
    for protocol, file, complaint in (
        ("itsc", tmp_path / "missing", "cannot be read"),
        ("itsc", tmp_path / "raw", "is no text"),
        ("isc", tmp_path / "raw", "did you mean 'itsc'"),
    ):
        with pytest.raises(typer.Exit):
            detect(protocol, file)
        assert complaint in capsys.readouterr().err
