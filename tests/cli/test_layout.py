"""``hoistway layout``."""

import json
import re
import sys
from pathlib import Path
from random import Random
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


BROKEN = """
barcodes:
  101..105: {from: [0, 0], to: [4000, 0]}
  106: [4000, 2000]
  107: nowhere
track:
  - {through: [101..105, 106, 107, 999]}
  - {thru: [106, 101]}
stations:
  P1: {kind: port, at: 103, look_down: 1, speed: 50}
  P2: {kind: port, at: 888, look_down: 1, speed: 50}
zones:
  Z: {barcodes: [101, 777]}
vehicles:
  V1: {dev_id: 1, address: "127.0.0.1:17001", start: 555}
"""


def test_of_a_plant_file_with_errors_what_can_be_drawn_is_and_its_errors_are_named(tmp_path: Path) -> None:
    file, picture = written(tmp_path, "broken.yaml", BROKEN), tmp_path / "broken.svg"
    result = run("render", file, "-o", picture)
    assert result.exit_code == 1
    checked = run("check", file).stdout.splitlines()
    assert f"{file}:7:36: error: unknown barcode 999" in checked
    assert [line for line in checked if line not in result.stderr.splitlines()] == []
    assert result.stderr.splitlines()[-1] == f"hoistway: {file} has errors: only what is understood is drawn"
    drawn = picture.read_text(encoding="utf-8")
    assert ">P1<" in drawn
    assert not [name for name in ("P2", "V1", "107", "888") if f">{name}<" in drawn]


@pytest.mark.parametrize("seed", range(20))
def test_whatever_line_is_missing_the_rest_is_drawn(seed: int, tmp_path: Path) -> None:
    lines = SMALL.with_name("demo.yaml").read_text(encoding="utf-8").splitlines(keepends=True)
    chance = Random(seed)
    kept = "".join(line for line in lines if chance.random() > 0.05 or not line.startswith("  "))
    file, picture = written(tmp_path, "torn.yaml", kept), tmp_path / "torn.svg"
    result = run("render", file, "-o", picture)
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exc_info
    assert "errors: only what is understood is drawn" in result.stderr
    assert picture.stat().st_size > 10_000


@pytest.mark.parametrize(
    ("name", "text", "what"),
    [
        ("list.csv", RING, "a list (CSV)"),
        ("list.txt", "Barcode list of hall 3\n\n" + RING.replace(",", ";"), "a list (CSV)"),
        ("hall.xml", OPENTCS, "XML"),
        ("hall.lif", '{"metaInformation": {}, "layouts": []}', "a layout in JSON"),
    ],
)
def test_a_layout_that_is_no_plant_file_is_told_what_it_is(tmp_path: Path, name: str, text: str, what: str) -> None:
    file = written(tmp_path, name, text)
    for words in (("check", str(file)), ("render", str(file), "-o", str(tmp_path / "a.svg"))):
        result = run(*words)
        assert result.exit_code == 1
        assert f"{file}:1:1: error: this is no plant file, but {what}" in result.output
        assert "hoistway layout import FILE -o plant.yaml" in result.output
        assert result.output.count("error") == 1
    assert not (tmp_path / "a.svg").exists()


def test_a_list_in_another_alphabet_is_told_how_it_becomes_a_plant_file(tmp_path: Path) -> None:
    (tmp_path / "list.csv").write_bytes("바코드,x,y\n1,0,0\n".encode("cp949"))
    result = run("render", tmp_path / "list.csv", "-o", tmp_path / "a.svg")
    assert result.exit_code == 1
    assert "hoistway layout import FILE -o plant.yaml" in result.output


def test_a_picture_speaks_the_language_of_the_command_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    hall = SMALL.with_name("demo.yaml")
    monkeypatch.setenv("HOISTWAY_LANG", "ko")
    assert run("render", hall, "-o", tmp_path / "a.svg", "--no-labels").exit_code == 0
    drawn = (tmp_path / "a.svg").read_text(encoding="utf-8")
    words = [word for text in re.findall("<text[^>]*>([^<]*)", drawn) for word in re.findall("[A-Za-z]{3,}", text)]
    assert words == ["demo", "AGV"]
    assert "일방통행 트랙" in drawn
    assert "스테이션 40개" in drawn
    # The package has a function of the module's name.
    monkeypatch.setattr(sys.modules["app.plant.picture.png"], "WIDE_FONTS", ())
    result = run("render", hall, "-o", tmp_path / "a.png")
    assert (result.exit_code, "한글" in result.stderr) == (0, True)


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
