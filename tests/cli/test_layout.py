"""``hoistway layout``."""

import json
from pathlib import Path

from typer.testing import CliRunner, Result

from app.cli import app
from app.plant import read
from tests.plant.exchange.layouts import OPENTCS, RING


def run(*words: str | Path) -> Result:
    return CliRunner().invoke(app, ["layout", *map(str, words)])


def written(tmp_path: Path, name: str, text: str) -> Path:
    file = tmp_path / name
    file.write_text(text, encoding="utf-8")
    return file


def test_an_import_writes_a_plant_file_and_reports(tmp_path: Path) -> None:
    source, target = written(tmp_path, "ring.csv", RING), tmp_path / "plant.yaml"
    result = run("import", source, "-o", target, "--vehicles", "2", "--name", "ring")
    assert result.exit_code == 0, result.output
    plant, findings = read(target.read_text(encoding="utf-8"), "plant")
    assert (plant.name, len(plant.vehicles), [f.message for f in findings if f.is_error]) == ("ring", 2, [])
    assert "read: 6 barcodes, 6 pieces of track, 3 stations, 0 vehicles" in result.stdout
    assert "to supply: V001, V002: an address at this machine, for simulation" in result.stdout
    assert CliRunner().invoke(app, ["check", str(target)]).exit_code == 0


def test_what_needs_a_person_ends_with_one_and_is_written(tmp_path: Path) -> None:
    source, target = written(tmp_path, "ring.csv", RING.replace(",6,", ",66,")), tmp_path / "plant.yaml"
    result = run("import", source, "-o", target)
    assert result.exit_code == 1
    assert "wrong: row 6: leads to 66, which is nowhere given: left out" in result.stdout
    assert f"{target}:" in result.stdout
    assert "dead end: track leads to 5, but none leads on" in result.stdout
    assert target.exists()


def test_what_cannot_be_read_ends_with_two_and_nothing_is_written(tmp_path: Path) -> None:
    target = tmp_path / "plant.yaml"
    for source in (written(tmp_path, "cut.xml", OPENTCS[:700]), tmp_path / "missing.csv"):
        result = run("import", source, "-o", target)
        assert result.exit_code == 2
        assert source.name in result.stdout
        assert not target.exists()


def test_the_report_is_json_where_it_is_asked_for(tmp_path: Path) -> None:
    result = run("import", written(tmp_path, "hall.xml", OPENTCS), "--json")
    told = json.loads(result.stdout)
    assert told["read"]["points"] == 5
    assert told["plant"]["barcodes"] == 5
    renamed = next(note for note in told["notes"] if note["what"].startswith("renamed: AGVs"))
    assert (renamed["kind"], renamed["times"], renamed["where"][0]) == ("repaired", 5, "P-1 → 0001")


def test_names_of_a_persons_own_are_read_from_a_file(tmp_path: Path) -> None:
    names = written(tmp_path, "names.csv", "name,barcode\nP-1,0042\n")
    target = tmp_path / "plant.yaml"
    assert run("import", written(tmp_path, "hall.xml", OPENTCS), "-o", target, "--names", names).exit_code == 0
    assert '"0042": [0, 0]  # P-1' in target.read_text(encoding="utf-8")
    refused = run("import", tmp_path / "hall.xml", "--names", written(tmp_path, "bad.csv", "P-1,\n"))
    assert refused.exit_code == 1
    assert "row 1: write a name and a barcode" in refused.output


def test_a_wrong_format_is_said(tmp_path: Path) -> None:
    result = run("import", written(tmp_path, "ring.csv", RING), "--format", "lif")
    assert result.exit_code == 2
    assert "is no JSON" in result.stdout
    result = run("import", written(tmp_path, "hall.xml", OPENTCS), "--format", "lif")
    assert "this is no lif: it looks like xml" in result.stdout


def test_several_files_must_be_tables(tmp_path: Path) -> None:
    result = run("import", written(tmp_path, "ring.csv", RING), written(tmp_path, "hall.xml", OPENTCS))
    assert result.exit_code == 2
    assert "several files make one layout only where all are tables" in result.stdout
