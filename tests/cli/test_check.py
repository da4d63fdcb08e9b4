"""``hoistway check`` and ``hoistway schema``."""

import json
from pathlib import Path

import jsonschema
import pytest
import typer
from typer.testing import CliRunner, Result

from app.cli import plainly
from app.cli.check import check
from app.cli.schema import schema

PLANTS = Path(__file__).parents[2] / "plants"
LOOP = "barcodes: {1: [0, 0], 2: [1000, 0], 3: [0, 1000]}\ntrack: [{through: [1..3, 1]}]\n"


def run(*arguments: str) -> Result:
    app = typer.Typer()
    app.command()(check)
    app.command()(schema)
    return CliRunner().invoke(app, arguments)


def test_a_sound_plant_is_summed_up_and_exits_0() -> None:
    result = run("check", str(PLANTS / "small.yaml"))
    assert result.exit_code == 0
    assert "small.yaml: 0 errors, 0 warnings" in result.stdout
    assert (
        "small: 18 barcodes, 18 edges, 5 stations, 1 zone, 2 vehicles, 2 carriers; 0.022 km of track" in result.stdout
    )


def test_an_error_is_shown_with_place_and_remedy_and_exits_1(tmp_path: Path) -> None:
    file = tmp_path / "hall.yaml"
    file.write_text(LOOP + "parking: [1, 33]\n", encoding="utf-8")
    result = run("check", str(file))
    assert result.exit_code == 1
    assert f"{file}:3:14: error: unknown barcode 33\n    did you mean 3?\n" in result.stdout
    assert f"{file}: 1 error, 2 warnings" in result.stdout
    assert "km of track" not in result.stdout


def test_warnings_alone_exit_0(tmp_path: Path) -> None:
    file = tmp_path / "hall.yaml"
    file.write_text(LOOP, encoding="utf-8-sig")
    result = run("check", str(file))
    assert result.exit_code == 0
    assert f"{file}:1:1: warning: the plant has no vehicle" in result.stdout


def test_json_gives_findings_and_counts(tmp_path: Path) -> None:
    file = tmp_path / "hall.yaml"
    file.write_text(LOOP, encoding="utf-8")
    told = json.loads(run("check", "--json", str(file)).stdout)
    assert told["plant"]["barcodes"] == 3
    assert told["plant"]["kilometres"] == 0.003
    assert told["findings"][0] == {
        "line": 1,
        "column": 1,
        "severity": "warning",
        "path": "vehicles",
        "message": "the plant has no vehicle",
        "remedy": "give at least one under vehicles",
    }
    file.write_text("track: 1\n", encoding="utf-8")
    result = run("check", "--json", str(file))
    assert (result.exit_code, json.loads(result.stdout)["plant"]) == (1, None)


@pytest.mark.parametrize("content", [None, b"\xff\xfe"], ids=["no such file", "no text"])
def test_a_file_that_cannot_be_read_exits_2(tmp_path: Path, content: bytes | None) -> None:
    file = tmp_path / "hall.yaml"
    if content is not None:
        file.write_bytes(content)
    result = run("check", str(file))
    assert result.exit_code == 2
    assert f"{file} cannot be read: " in result.stdout


@pytest.mark.parametrize(
    ("name", "content"), [("list.csv", "바코드;X\n1;2\n".encode("cp949")), ("list.xlsx", b"PK\x03\x04\xff")]
)
def test_a_list_that_cannot_be_read_is_told_how_it_becomes_a_plant_file(
    tmp_path: Path, name: str, content: bytes
) -> None:
    file = tmp_path / name
    file.write_bytes(content)
    result = run("check", str(file))
    assert result.exit_code == 2
    said, remedy = result.stdout.splitlines()
    assert said.startswith(f"{file} cannot be read: it is not UTF-8")
    assert remedy == "    make a plant file of it: hoistway layout import FILE -o plant.yaml"


def test_a_catalogue_that_cannot_be_read_exits_2(tmp_path: Path) -> None:
    file = tmp_path / "hall.yaml"
    text = (PLANTS / "hall.yaml").read_text(encoding="utf-8")
    file.write_text(text.replace("model: demo", "model: odd"), encoding="utf-8")
    (tmp_path / "catalogues").mkdir()
    (tmp_path / "catalogues" / "odd.yaml").write_bytes(b"\xff\xfe")
    result = run("check", str(file))
    assert result.exit_code == 2
    assert "odd.yaml cannot be read: it is not UTF-8" in result.output


def test_the_schema_of_a_plant_file_is_printed() -> None:
    result = run("schema", "plant")
    assert result.stdout == (PLANTS / "plant.schema.json").read_text(encoding="utf-8")
    jsonschema.Draft202012Validator.check_schema(json.loads(result.stdout))


def test_an_unknown_kind_of_file_is_refused_with_the_nearest() -> None:
    result = run("schema", "plants")
    assert (result.exit_code, result.stdout) == (2, "unknown kind of file 'plants'; did you mean 'plant'?\n")


def test_a_file_that_cannot_be_read_is_named_with_the_reason(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "hall.yaml"
    assert run("check", str(file)).stdout == f"{file} cannot be read: No such file or directory\n"
    file.write_text("name: Süd", encoding="latin-1")
    assert "cannot be read: it is not UTF-8: invalid" in run("check", str(file)).stdout
    monkeypatch.setattr(plainly, "TEXT_LIMIT", 1 << 20)
    file.write_bytes(b"#" * ((1 << 20) + 1))
    result = run("check", str(file))
    assert (result.exit_code, result.stdout) == (2, f"{file} cannot be read: it is larger than 1 MB\n")
