"""Catalogue files: read, and every mistake named by line and remedy."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli import app
from app.domain.catalogue import ParameterSpec
from app.domain.drive import Parameter, RawValue
from app.plant import UnusablePlant
from app.plant.catalogue import read_catalogue

ROOT = Path(__file__).parents[2]
GOOD = """\
description: An axis
parameters:
  "1C": {name: Acceleration, unit: s, scale: 0.01, min: 0.1, max: 60, default: 1.5, description: from rest}
  "0A": {name: Direction, min: 0, max: 1, choices: {"0": CW, "1": CCW}, while_running: true}
  "F0": {name: Version, min: 0, max: 99.9, scale: 0.1, read_only: true}
"""


def findings_of(text: str) -> list[tuple[int, str]]:
    with pytest.raises(UnusablePlant) as unusable:
        read_catalogue(text, "m")
    return [(finding.line, finding.message) for finding in unusable.value.findings]


def test_a_catalogue_is_read_with_its_values_as_the_drive_has_them() -> None:
    catalogue, findings = read_catalogue(GOOD, "axis-1")
    assert findings == []
    assert (catalogue.model, catalogue.description) == ("axis-1", "An axis")
    acceleration = catalogue.get(0x1C)
    assert acceleration == ParameterSpec(
        Parameter(0x1C),
        "Acceleration",
        "s",
        0.01,
        2,
        RawValue(10),
        RawValue(6000),
        RawValue(150),
        description="from rest",
    )
    assert acceleration is not None
    assert (acceleration.scaled(235), acceleration.raw(2.35), acceleration.raw(2.355)) == (2.35, 235, None)
    assert acceleration.range == "0.10 s to 60.00 s (raw 10 to 6000)"
    direction = catalogue.get(0x0A)
    assert direction is not None
    assert (direction.shown(1), direction.shown(7), direction.while_running) == ("CCW", "7", True)
    assert catalogue.get(0x99) is None


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ('  "1c": {name: x, min: 0, max: 1}', "'1c' is no parameter number"),
        ('  "100": {name: x, min: 0, max: 1}', "'100' is no parameter number"),
        ('  "10": {name: x, min: 0}', "parameters.10 has no max"),
        ('  "10": {name: x, min: 0, max: 1, scael: 2}', "unknown key 'scael' in parameters.10"),
        ('  "10": {name: x, min: a, max: 1}', "parameters.10.min: expected a number, got text 'a'"),
        ('  "10": {name: x, min: 5, max: 1}', "min 5 of 10 is above its max 1"),
        ('  "10": {name: x, min: 0, max: 1, default: 2}', "the default of 10 is not from 0 to 1"),
        ('  "10": {name: x, min: 0, max: 0.5}', "max 0.5 lies between two steps of 1"),
        ('  "10": {name: x, min: 0, max: 100, scale: 0.001}', "max 100 is 100000 on the wire, which carries 0 to 9999"),
        ('  "10": {name: x, min: -5, max: 1}', "min -5 is -5 on the wire, which carries 0 to 9999"),
        ('  "10": {name: x, min: 0, max: 1, scale: 0}', "the scale of 10 is not above 0"),
        (
            '  "10": {name: x, min: 0, max: 1, read_only: true, while_running: true}',
            "10 is read-only, so it is not written while running",
        ),
        ('  "10": {name: x, min: 0, max: 1, choices: {"7": on}}', "choice '7' is no raw value from 0 to 1"),
    ],
)
def test_each_mistake_is_named_at_its_line(line: str, message: str) -> None:
    found = findings_of(GOOD + line + "\n")
    assert found == [(6, found[0][1])]
    assert found[0][1].startswith(message)


def test_what_is_no_catalogue_at_all_is_refused() -> None:
    assert findings_of("description: x\n") == [(1, "the catalogue has no parameters")]
    assert findings_of("")[0][1] == "the file is empty"
    assert "this is no YAML" in findings_of("{")[0][1]


def test_two_parameters_with_one_name_are_a_warning() -> None:
    _, findings = read_catalogue(GOOD + '  "10": {name: Version, min: 0, max: 1}\n', "m")
    assert [finding.message for finding in findings] == ["10 and F0 are both called Version"]


def test_every_catalogue_that_comes_with_hoistway_is_sound() -> None:
    files = sorted((ROOT / "app/catalogues").glob("*.yaml"))
    assert files
    for file in files:
        catalogue, findings = read_catalogue(file.read_text(encoding="utf-8"), file.stem)
        assert findings == []
        assert all(spec.default is not None or spec.read_only for spec in catalogue.parameters.values())


def hall(directory: Path, model: str) -> Path:
    text = (ROOT / "plants/hall.yaml").read_text(encoding="utf-8")
    file = directory / "hall.yaml"
    file.write_text(text.replace("model: demo", f"model: {model}"), encoding="utf-8")
    return file


def test_check_reads_the_catalogues_that_a_plant_needs(tmp_path: Path) -> None:
    runner = CliRunner()
    assert runner.invoke(app, ["check", str(hall(tmp_path, "demo"))]).exit_code == 0
    missing = runner.invoke(app, ["check", str(hall(tmp_path, "axis-9"))])
    assert missing.exit_code == 0
    assert "there is no catalogue axis-9: its drives have raw access only" in missing.output
    (tmp_path / "catalogues").mkdir()
    (tmp_path / "catalogues/axis-9.yaml").write_text(GOOD.replace("scale: 0.01", "scale: 0"), encoding="utf-8")
    wrong = runner.invoke(app, ["check", str(hall(tmp_path, "axis-9"))])
    assert wrong.exit_code == 1
    assert "catalogues/axis-9.yaml:3:" in wrong.output.replace("\n", "")
    served = runner.invoke(app, ["serve", "--plant", str(hall(tmp_path, "axis-9"))])
    assert served.exit_code != 0
    assert "hoistway check" in served.output
    as_json = runner.invoke(app, ["check", str(hall(tmp_path, "axis-9")), "--json"])
    assert '"axis-9.yaml' in as_json.output or "axis-9.yaml" in as_json.output


def test_a_catalogue_beside_the_plant_goes_before_our_own(tmp_path: Path) -> None:
    from app.cli.running import plant_of

    (tmp_path / "catalogues").mkdir()
    (tmp_path / "catalogues/demo.yaml").write_text(GOOD, encoding="utf-8")
    plant = plant_of(hall(tmp_path, "demo"))
    assert plant.catalogue_of(plant.drives[0]).description == "An axis"
    assert plant_of(ROOT / "plants/hall.yaml").catalogues[0].description == "Axis drive of the demo plant"
