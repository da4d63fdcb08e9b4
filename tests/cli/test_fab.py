"""``hoistway fab``."""

from pathlib import Path

from typer.testing import CliRunner, Result

from app.cli import app
from app.plant import read


def run(*words: str) -> Result:
    return CliRunner().invoke(app, ["fab", "--size", "1k", *words])


def test_a_fab_is_written_that_the_checker_accepts(tmp_path: Path) -> None:
    file = tmp_path / "fab.yaml"
    assert run(str(file), "--seed", "3", "--vehicles", "20", "--carriers", "0.5").exit_code == 0
    plant, findings = read(file.read_text(encoding="utf-8"), str(file))
    assert (plant.name, len(plant.vehicles), findings) == ("fab-1k", 20, [])
    checked = CliRunner().invoke(app, ["check", str(file)])
    assert checked.exit_code == 0
    assert "0 errors, 0 warnings" in checked.stdout


def test_statistics_are_printed_without_a_file() -> None:
    result = run("--statistics")
    assert result.exit_code == 0
    figures = {line[:14].strip(): line[14:] for line in result.stdout.splitlines()}
    assert (figures["fab"], figures["bays"], figures["merges"], figures["parts"]) == ("fab-1k", "4", "56", "1")


def test_nothing_asked_for_is_said() -> None:
    result = run()
    assert result.exit_code == 1
    assert "Name a file to write, or ask for --statistics." in result.output


def test_an_unknown_size_is_named_with_the_nearest() -> None:
    result = CliRunner().invoke(app, ["fab", "--size", "10kk", "--statistics"])
    assert result.exit_code == 2
    assert "10k" in result.output


def test_more_vehicles_than_fit_are_refused(tmp_path: Path) -> None:
    result = run(str(tmp_path / "fab.yaml"), "--vehicles", "5000")
    assert result.exit_code == 1
    assert "5000 vehicles do not fit" in result.output
    assert not list(tmp_path.iterdir())


def test_a_file_that_cannot_be_written_is_said_in_words(tmp_path: Path) -> None:
    result = run(str(tmp_path / "missing" / "fab.yaml"))
    assert result.exit_code == 1
    assert "cannot be written: No such file or directory" in result.output
