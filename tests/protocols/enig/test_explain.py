import json
from typing import Any

import pytest

from app.cli.decode import decode
from app.protocols.enig import wording
from app.protocols.enig.codec import Codec
from app.protocols.enig.dialects import DEFAULT, DIALECTS, DialectError
from app.protocols.enig.explain import explain, show
from app.protocols.enig.messages import BY_CLASS, AgvReport, Frame, MoveAlias, MoveManual, Raw, Toward

CODEC = Codec()
ALIAS = CODEC.encode(CODEC.packet(11, MoveAlias("B1")), Toward.DEVICE)


def raw(device: int, cmd: int, data: bytes = b"") -> bytes:
    return CODEC.encode(Frame(device, cmd, Raw(data)), Toward.DEVICE, strict=False)


def test_a_packet_is_explained_field_by_field() -> None:
    said = show(ALIAS + b"\xff", "default", "en", json=False)
    assert said.splitlines() == [
        "@0  02 03 0B 6B 42 31 49 4B 03",
        "  [host to device]",
        "    ID          11        AGV",
        "    CMD         107       MoveAlias (drive to a destination)",
        "    alias       'B1'",
        "",
        "@9  FF",
        "  no packet starts here: byte FF starts no packet",
    ]


def test_a_packet_is_explained_in_korean() -> None:
    packet = CODEC.encode(CODEC.packet(11, AgvReport(mode=1, cart=2)), Toward.HOST)
    said = show(packet, "enig.default", "ko", json=False)
    assert "[장비에서 호스트로]" in said
    assert "mode        1         자동" in said
    assert "cart        2         알 수 없음" in said


def test_a_target_is_shown_with_who_it_is() -> None:
    codec = Codec(DIALECTS["acs-id"])
    packet = codec.encode(codec.packet(11, MoveAlias("B1")), Toward.DEVICE)
    said = show(packet, "acs-id", "en", json=False)
    assert "ID          0         host (ACS)" in said
    assert "Target      11        AGV" in said


def test_unknown_commands_and_values_are_named() -> None:
    said = show(raw(99, 3, b"\1\2"), "default", "en", json=False)
    assert "ID          99        no device of this dialect" in said
    assert "CMD         3         unknown command" in said
    assert "DATA        01 02" in said
    assert "[host to device]" in said
    assert "[device to host]" in said
    frame = CODEC.packet(11, MoveManual(9, 0))
    said = show(CODEC.encode(frame, Toward.DEVICE, strict=False), "default", "en", json=False)
    assert "direction   9         undefined" in said
    assert "!           direction  problem" in said


def test_a_program_gets_json() -> None:
    told: dict[str, Any] = json.loads(show(ALIAS + b"\0", "enig.default", "en", json=True))
    first, rubbish = told["pieces"]
    assert told["dialect"] == "default"
    assert first["readings"][0]["frame"]["fields"] == {"alias": "B1"}
    assert first["readings"][0]["rows"][0] == {"name": "ID", "value": "11", "meaning": "AGV"}
    assert rubbish == {
        "offset": 9,
        "hex": "00",
        "garbled": {"reason": "noise", "detail": "byte 00 starts no packet"},
    }


def test_another_dialect_is_suggested() -> None:
    assert explain(ALIAS, DIALECTS["crc-be"]).hints == ("dialect default makes sense of 1 packets in it",)
    assert explain(ALIAS, DEFAULT).hints == ()
    with pytest.raises(DialectError, match="did you mean 'target'"):
        show(ALIAS, "targt", "en", json=False)


def test_every_command_and_every_listed_value_has_its_words() -> None:
    assert set(wording.NAMES) == {row.name for row in BY_CLASS.values()}
    records = {cls.__name__ for cls in BY_CLASS}
    assert {record for record, _ in wording.VALUES} <= records


def test_the_command_explains_a_packet(capsys: pytest.CaptureFixture[str]) -> None:
    decode("enig", [ALIAS.hex(" ")], lang="ko")
    assert "대상 별칭까지 이동" in capsys.readouterr().out
