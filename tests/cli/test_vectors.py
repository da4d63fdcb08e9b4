import json
from pathlib import Path
from typing import Any

import pytest
import typer

from app.cli.vectors import Malformed, check, load, vectors
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DIALECTS
from app.protocols.itsc.messages import Element, Enq, Etb, Raw, Xmove

HERE = Path(__file__).parents[1] / "vectors"
SAMPLE = load(HERE / "itsc.json")
BY_ID = {vector["id"]: vector for vector in SAMPLE["vectors"]}


@pytest.mark.parametrize("vector", SAMPLE["vectors"], ids=list(BY_ID))
def test_each_sample_vector_passes(vector: dict[str, Any]) -> None:
    assert list(check(vector, SAMPLE["dialects"])) == []


def test_the_sample_of_all_protocols_runs_and_says_what_it_skipped(capsys: pytest.CaptureFixture[str]) -> None:
    vectors(HERE / "sample.json")
    out = capsys.readouterr().out.splitlines()
    assert out[-1].endswith("skipped")
    assert " 0 failed, " in out[-1]
    assert out[-1].startswith(f"{154 - int(out[-1].split()[-2])} passed")


def altered(name: str, **changes: Any) -> dict[str, Any]:
    return {**BY_ID[name], **changes}


def fields_of(name: str, **changes: Any) -> list[dict[str, Any]]:
    (frame,) = BY_ID[name]["frames"]
    return [{**frame, "fields": {**frame["fields"], **changes}}]


WRONG = [
    (altered("i028", frames=fields_of("i028", seq=8)), "fed whole: frames[0].fields.seq: expected 8, got 7"),
    (altered("i028", frames=fields_of("i028", extra=8)), "fields.extra: expected 8, got (nothing)"),
    (altered("i028", frames=[]), "frames: expected 0, got 1"),
    (altered("i028", frames=[{**BY_ID["i028"]["frames"][0], "problems": ["x"]}]), 'problems: expected ["x"], got []'),
    (altered("i001", fields={**BY_ID["i001"]["fields"], "trav": 1}), "fields.trav: expected 1, got 11"),
    (altered("i001", layout="STATUS3"), "unknown layout 'STATUS3'"),
    (altered("i062", fields={"opt": 2, "value": 500}), "written again: expected 00000002fffffe0c"),
    (altered("i062", form="JOGG"), "unknown form 'JOGG'; did you mean 'JOG'"),
    (altered("i107", value="29b2"), "expected 29b2, got 29b1"),
    (altered("i107", algorithm="ccitt"), "unknown crc 'ccitt'"),
    (altered("i161", object={**BY_ID["i010"]["frames"][0]}), "expected a refusal to send, got 05"),
    (altered("i010", kind="vallid"), "unknown kind 'vallid'; did you mean 'valid'"),
    (altered("i010", dialect="itsc.slide"), "unknown dialect 'itsc.slide'; did you mean 'itsc.slides'"),
    (altered("i010", hex="0g"), 'malformed vector: "0g" is no hexadecimal text'),
    (altered("i010", direction="up"), "malformed vector, or refused"),
    ({key: value for key, value in BY_ID["i010"].items() if key != "hex"}, "malformed vector: no 'hex'"),
    (altered("i001", hex="0b11"), "a status word has 4 bytes, not 2"),
    (
        altered("i086", kind="concatenated", hex=BY_ID["i086"]["hex"] + "ff", frames=BY_ID["i010"]["frames"]),
        "frames[0]",
    ),
]


@pytest.mark.parametrize(("vector", "complaint"), WRONG)
def test_a_vector_that_fails_says_what_was_expected_and_what_came(vector: dict[str, Any], complaint: str) -> None:
    assert any(complaint in failure for failure in check(vector, SAMPLE["dialects"]))


def test_frames_that_are_not_written_again_to_the_same_bytes_fail() -> None:
    trailing = altered("i010", hex=BY_ID["i010"]["hex"] + "ff")
    assert "1 bytes are missing" in "".join(check(trailing, SAMPLE["dialects"]))
    assert list(check({**trailing, "roundtrip": False}, SAMPLE["dialects"])) == []
    leading = altered("i010", hex="ff" + BY_ID["i010"]["hex"])
    assert "written again: expected ff05" in "".join(check(leading, SAMPLE["dialects"]))
    bits = altered("i001", roundtrip=False)
    assert list(check(bits, SAMPLE["dialects"])) == []


RAW_ETB = {
    "id": "x",
    "protocol": "itsc",
    "kind": "semantic",
    "hex": "1700000001000000000000000112340000000300000000000000000000000096126162635149",
}


@pytest.mark.parametrize("data", ["616263", "00000003" + "00" * 12 + "616263"])
def test_the_raw_data_of_an_etb_may_be_given_with_or_without_its_header(data: str) -> None:
    written = Codec().encode(Etb(1, 1, 0x1234, Raw(b"", b"abc")), strict=False)
    frame = {
        "type": "ETB",
        "dev_id": 1,
        "cmd_id": "0000000000000001",
        "code": "0x1234",
        "form": "RAW",
        "problems": ["x"],
    }
    vector = {**RAW_ETB, "hex": written.hex(), "frames": [{**frame, "fields": {"data": data}}]}
    assert list(check(vector, {})) == []


def with_frame(name: str, **changes: Any) -> dict[str, Any]:
    (frame,) = BY_ID[name]["frames"]
    return altered(name, frames=[{**frame, **changes}])


@pytest.mark.parametrize(
    "vector",
    [
        with_frame("i010", cmd_id=0x100, code=0x7030),
        with_frame("i010", cmd_id="0x100", code="7030"),
        altered("i010", hex=BY_ID["i010"]["hex"].upper()),
        altered("i110", value="0x906E"),
    ],
)
def test_a_number_may_be_spelled_in_another_way(vector: dict[str, Any]) -> None:
    assert list(check(vector, SAMPLE["dialects"])) == []


def test_another_number_is_not_another_spelling() -> None:
    for wrong in ({"cmd_id": 0x101}, {"cmd_id": "101"}, {"code": "0x7031"}, {"code": None}):
        assert list(check(with_frame("i010", **wrong), SAMPLE["dialects"]))


def framed(written: bytes, dialect: str, kind: str = "valid", **frame: Any) -> dict[str, Any]:
    common = {"dev_id": 1, "cmd_id": "0000000000000001", "problems": []}
    vector = {"id": "x", "protocol": "itsc", "dialect": dialect, "kind": kind, "hex": written.hex()}
    return {**vector, "frames": [{**common, **frame}]}


def test_a_barcode_of_characters_may_be_given_as_the_number_they_show() -> None:
    for text, number in (("001201", 1201), ("1201", 1201)):
        written = Codec(DIALECTS["ascii-barcode"]).encode(Etb(1, 1, 0x1045, Xmove([Element(text, 0, 1, 1, 50)])))
        element = {"barcode": number, "seq": 0, "sensor": 1, "action": 1, "speed": 50}
        fields = {"length": 12, "count": 1, "path": [element]}
        vector = framed(written, "itsc.ascii-barcode", type="ETB", code="0x1045", form="XMOVE", fields=fields)
        assert list(check(vector, SAMPLE["dialects"])) == []
        element["barcode"] = number + 1
        assert "barcode: expected 1202" in "".join(check(vector, SAMPLE["dialects"]))


@pytest.mark.parametrize("problems", [[], ["unknown code"]])
def test_an_unknown_code_may_be_given_with_or_without_a_problem(problems: list[str]) -> None:
    written = Codec().encode(Enq(1, 1, 0x9999, Raw(bytes(range(16)))), strict=False)
    fields = {"data": bytes(range(16)).hex()}
    vector = framed(written, "itsc.default", type="ENQ", code="0x9999", form="RAW", fields=fields, problems=problems)
    assert list(check(vector, SAMPLE["dialects"])) == []


def test_max_sub_of_a_vector_bounds_its_decoder() -> None:
    small = altered("i079", max_sub=75)
    assert "frames: expected 1, got 0" in "".join(check(small, SAMPLE["dialects"]))


@pytest.mark.parametrize(
    "answer",
    [
        [["ccitt-false", "type", "big"]],
        [["ccitt-false", True, "big"]],
        [["type", "big"]],
        [{"crc": "ccitt-false", "crc_covers_type": True, "crc_order": "big"}],
    ],
)
def test_a_detection_may_be_answered_in_several_wordings(answer: list[Any]) -> None:
    packets = [BY_ID["i023"]["hex"], BY_ID["i025"]["hex"], BY_ID["i028"]["hex"]]
    vector = {"id": "d", "protocol": "itsc", "kind": "detect", "frames_hex": packets, "answer": answer}
    assert list(check(vector, SAMPLE["dialects"])) == []
    assert list(check({**vector, "answer": [["arc", "type", "big"]]}, SAMPLE["dialects"]))


def run(file: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    with pytest.raises(typer.Exit) as left:
        vectors(file)
    return left.value.exit_code, capsys.readouterr().out


def test_a_failure_is_printed_with_its_id_and_the_command_fails(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "v.json"
    file.write_text(
        json.dumps({"format": 1, "vectors": [WRONG[0][0], BY_ID["i010"], {**BY_ID["i010"], "protocol": "new"}]})
    )
    code, out = run(file, capsys)
    assert code == 1
    assert out.splitlines() == [
        "i028 (valid, itsc.default): fed whole: frames[0].fields.seq: expected 8, got 7",
        "skipped 1 of protocol 'new': not in this build",
        "1 passed, 1 failed, 1 skipped",
    ]


MALFORMED = [
    (altered("i010", kind="vallid"), "unknown kind 'vallid'"),
    (altered("i010", hex=None), "'hex' is null"),
    (altered("i010", hex="0"), "is no hexadecimal text"),
    (altered("i010", dialect=["itsc.default"]), "is no name of an object"),
    (altered("i010", dialect=None), "is no name of an object"),
    (altered("i010", frames={}), "'frames' is {}"),
    (altered("i010", frames=[3]), "frames[0] is 3"),
    (with_frame("i010", problems=3), "frames[0] is"),
    (altered("i161", object=None), "'object' is null"),
    (altered("i059", fields=3), "'fields' is 3"),
    (altered("i107", algorithm=3), "'algorithm' is 3"),
    ({"id": "d", "protocol": "itsc", "kind": "detect", "frames_hex": ["x"], "answer": []}, "is no hexadecimal text"),
    ({"id": "d", "protocol": "itsc", "kind": "detect", "frames_hex": [5], "answer": []}, "5 is no hexadecimal text"),
]


@pytest.mark.parametrize(("vector", "complaint"), MALFORMED)
def test_a_malformed_vector_fails_and_blames_the_file(
    vector: dict[str, Any], complaint: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "v.json"
    file.write_text(json.dumps({"dialects": SAMPLE["dialects"], "vectors": [vector, BY_ID["i010"]]}))
    code, out = run(file, capsys)
    assert code == 2
    assert complaint in out
    assert out.splitlines()[-1] == "1 passed, 1 failed, 0 skipped"


def test_a_failure_of_the_build_outweighs_a_malformed_vector(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "v.json"
    file.write_text(json.dumps({"dialects": SAMPLE["dialects"], "vectors": [MALFORMED[0][0], WRONG[0][0]]}))
    assert run(file, capsys)[0] == 1


def test_a_file_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    (tmp_path / "v.json").write_text('{"vectors": []}', encoding="utf-8-sig")
    assert load(tmp_path / "v.json")["vectors"] == []


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("{", "is not JSON"),
        ("[]", "has no list 'vectors'"),
        ('{"vectors": [], "dialects": []}', "'dialects' is no object"),
        ('{"vectors": [], "format": 2}', "has format 2"),
        ('{"vectors": [3]}', "vectors[0] is no object"),
        ('{"vectors": [{"id": "a", "protocol": "itsc"}]}', "vectors[0] has no text 'kind'"),
    ],
)
def test_a_file_that_holds_no_vectors_is_refused(
    text: str, complaint: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "v.json"
    file.write_text(text)
    code, out = run(file, capsys)
    assert code == 2
    assert complaint in out


def test_a_file_nested_beyond_all_reason_is_refused(tmp_path: Path) -> None:
    (tmp_path / "v.json").write_text("[" * 100_000)
    with pytest.raises(Malformed, match="is nested too deeply"):
        load(tmp_path / "v.json")


def test_a_file_that_cannot_be_read_is_refused(tmp_path: Path) -> None:
    with pytest.raises(Malformed, match="cannot be read"):
        load(tmp_path / "missing.json")
    (tmp_path / "latin.json").write_bytes(b'{"\xe9": 1}')
    with pytest.raises(Malformed, match="is not UTF-8"):
        load(tmp_path / "latin.json")
