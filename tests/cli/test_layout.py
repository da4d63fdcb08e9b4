"""``hoistway layout``."""

import json
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from app.cli import app
from app.cli.layout_versions import rows_of
from app.domain.ids import Actor, StationId
from app.domain.layout import PulseSet
from app.domain.records import StationDest
from app.domain.units import Pulses, Timestamp
from app.plant import read
from app.store.ledger import SqlLedger
from tests.plant.exchange.layouts import OPENTCS, RING


def run(*words: str | Path) -> Result:
    return CliRunner().invoke(app, ["layout", *map(str, words)])


def written(tmp_path: Path, name: str, text: str) -> Path:
    file = tmp_path / name
    file.write_text(text, encoding="utf-8")
    return file


def test_an_import_writes_over_another_file_only_by_force(tmp_path: Path) -> None:
    source, target = written(tmp_path, "ring.csv", RING), written(tmp_path, "plant.yaml", "name: mine\n")
    refused = run("import", source, "-o", target)
    assert refused.exit_code == 2
    assert f"{target} is there already" in refused.output
    assert "--force" in refused.output
    assert target.read_text(encoding="utf-8") == "name: mine\n"
    assert run("import", source, "-o", target, "--force").exit_code == 0
    made = target.read_text(encoding="utf-8")
    assert "barcodes:" in made
    assert run("import", source, "-o", target).exit_code == 0, "the same again loses nothing"
    assert target.read_text(encoding="utf-8") == made


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


SMALL = Path(__file__).parents[2] / "plants" / "small.yaml"


def test_a_plant_is_exported_and_what_is_lost_said(tmp_path: Path) -> None:
    for name, form in (("a.geojson", "geojson"), ("a.graphml", "graphml"), ("a.lif.json", "lif")):
        result = run("export", SMALL, "-o", tmp_path / name)
        assert result.exit_code == 0, result.output
        assert f"{name}: {form}, 18 barcodes, 18 edges, 5 stations" in result.stdout
        assert "left out: 2 vehicles" in result.stdout
    result = run("export", SMALL, "-o", tmp_path / "b.json", "--format", "node-link", "--links")
    assert result.exit_code == 0
    assert "links" in json.loads((tmp_path / "b.json").read_text(encoding="utf-8"))
    assert run("export", SMALL, "-o", tmp_path / "b.json").exit_code == 1
    assert "is no place" in run("export", SMALL, "-o", tmp_path / "a.geojson", "--origin", "Seoul").output


def test_a_plant_is_drawn(tmp_path: Path) -> None:
    for name in ("a.svg", "a.png"):
        result = run("render", SMALL, "-o", tmp_path / name, "--width", "700", "--dark")
        assert result.exit_code == 0, result.output
        assert "700 x " in result.stdout
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert "neither .svg nor .png" in run("render", SMALL, "-o", tmp_path / "a.gif").output
    assert "cannot be written" in run("render", SMALL, "-o", tmp_path / "no" / "a.svg").output


def test_a_layout_is_checked_beyond_its_mistakes(tmp_path: Path) -> None:
    result = run("check", SMALL)
    assert result.exit_code == 0
    assert "dense barcodes: 101, 102, 103, 104, 105 and 3 more" in result.stdout
    told = json.loads(run("check", SMALL, "--json").stdout)
    assert told["figures"]["barcodes"] == 18
    bad = written(tmp_path, "bad.yaml", "barcodes: {1: [0, 0], 2: [1000, 0]}\ntrack: [{through: [1, 2]}]\n")
    assert run("check", bad).exit_code == 1
    assert run("check", tmp_path / "none.yaml").exit_code == 2


def test_two_plants_are_compared(tmp_path: Path) -> None:
    text = SMALL.read_text(encoding="utf-8")
    new = written(tmp_path, "new.yaml", text.replace("at: 106", "at: 107"))
    result = run("diff", SMALL, new)
    assert result.exit_code == 1
    assert "station P2 changed: barcode 106 → 107" in result.stdout
    assert "breaks: station P2: it is served from 107 instead of 106" in result.stdout
    told = json.loads(run("diff", SMALL, new, "--json").stdout)
    assert told["changes"][0]["name"] == told["breaks"][0]["name"] == "P2"
    assert run("diff", SMALL, SMALL).stdout == "no difference\n"
    bad = written(tmp_path, "bad.yaml", "barcodes: {}\n")
    assert run("diff", SMALL, bad).exit_code == 2


def test_what_is_under_way_in_a_database_is_named(tmp_path: Path) -> None:
    new = written(tmp_path, "new.yaml", SMALL.read_text(encoding="utf-8").replace("at: 106", "at: 107"))
    missing = run("diff", SMALL, new, "--database", f"sqlite:///{tmp_path / 'none.db'}")
    assert missing.exit_code == 2
    assert "it holds no plant" in missing.stdout
    database = f"sqlite:///{tmp_path / 'plant.db'}"
    ledger = SqlLedger(database, "small", "test", lambda: Timestamp(0.0))
    ledger.load()
    pulses = PulseSet(Pulses(1), Pulses(2), Pulses(3))
    ledger.commit([StationDest(StationId("P2"), 1, pulses, Actor("kim"), "rest", Timestamp(0.0))])
    ledger.close()
    result = run("diff", SMALL, new, "--database", database)
    assert result.exit_code == 1
    assert "breaks: station P2: its DEST was taught at 106" in result.stdout


STAGED: dict[str, Any] = {
    "number": 7, "state": "staged", "at": "2026-03-01T08:00:00Z", "actor": "Kim", "reason": "bay 3",
    "activated": None, "activated_by": None, "why": "", "asked": None, "asked_by": None, "asked_why": "",
    "note": "", "rejected": None,
}  # fmt: skip


@pytest.mark.parametrize(
    ("more", "lines"),
    [
        ({}, ["    7  staged   2026-03-01 08:00Z  Kim                   bay 3"]),
        (
            {"state": "active", "activated": "2026-03-02T09:30:00Z", "activated_by": "Lee", "why": "bay 3 opens"},
            [
                "    7  active   2026-03-02 09:30Z  Lee                   bay 3 opens",
                "       staged by Kim at 2026-03-01 08:00Z: bay 3",
            ],
        ),
        (
            {"state": "awaited", "asked": "2026-03-02T09:00:00Z", "asked_by": "Lee", "asked_why": "when it is quiet"},
            [
                "    7  awaited  2026-03-02 09:00Z  Lee                   when it is quiet",
                "       staged by Kim at 2026-03-01 08:00Z: bay 3",
            ],
        ),
        (
            {"state": "rejected", "rejected": "2026-03-03T10:00:00Z", "note": "Lee: the door is missing"},
            [
                "    7  rejected 2026-03-03 10:00Z  Lee                   the door is missing",
                "       staged by Kim at 2026-03-01 08:00Z: bay 3",
            ],
        ),
        (
            {"note": "Lee took the wish back: not today"},
            [
                "    7  staged   2026-03-01 08:00Z  Kim                   bay 3",
                "       Lee took the wish back: not today",
            ],
        ),
    ],
    ids=["staged", "active", "awaited", "rejected", "taken back"],
)
def test_a_version_says_why_it_is_as_it_is_and_then_why_it_was_staged(more: dict[str, Any], lines: list[str]) -> None:
    assert list(rows_of(STAGED | more)) == lines
