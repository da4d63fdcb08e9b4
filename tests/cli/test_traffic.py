"""``hoistway bench traffic``: its parts on a small fab."""

from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli.bench import commands
from app.cli.traffic import report
from app.cli.traffic.report import FULL, PARTS, Extent, Report
from app.plant.fab import SIZES

SMALL = replace(Extent(), pairs=20, networks=3, fleets=(8,), seeds=(1,), minutes=2)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> Report:
    monkeypatch.setattr(report, "FAB", SIZES["1k"])
    monkeypatch.setattr(report, "BACKLOGGED", 8)
    return Report(SMALL)


def lines(small: Report, name: str) -> list[str]:
    return list(PARTS[name](small))


def test_routes_cost_what_networkx_says(small: Report) -> None:
    assert lines(small, "routes") == ["20 routes, 0 dearer than networkx's [equal costs: reached]"]
    assert small.failed == []


def test_the_rule_is_tried_on_random_networks(small: Report) -> None:
    (line,) = lines(small, "rules")
    assert line.startswith("of 3 networks locked up: none ")
    assert line.endswith("[none with the rule: reached]")


def test_a_sweep_tries_every_mode_and_finds_the_fleet_that_delivers_most(small: Report) -> None:
    found = lines(small, "sweep")
    assert [line.split("  ")[0] for line in found] == ["no rule", "admission", "+ congestion", "all"]
    assert small.found["peak"] == 8
    assert small.found["peak_per_hour"] > 0


def test_rules_of_dispatch_are_compared_and_a_missed_goal_is_said_to_be_missed(small: Report) -> None:
    found = lines(small, "dispatch")
    assert [line.split()[0] for line in found] == ["random", "nearest", "assignment", "assignment", "its"]
    assert small.failed == [line.split("[")[1].removesuffix(": MISSED]") for line in found if line.endswith("MISSED]")]


def test_a_part_that_is_not_there_is_refused_with_those_that_are() -> None:
    asked = CliRunner().invoke(commands, ["traffic", "--only", "sweeep"])
    assert asked.exit_code == 2
    assert "sweeep" in asked.output
    assert "routes" in asked.output


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        (["traffic", "--fleet", "50000"], "70000 vehicles do not fit"),
        (["traffic", "--only", "soak", "--peak", "30000"], "42000 vehicles do not fit"),
        (["agree", "--vehicles", "5000"], "5000 vehicles do not fit"),
        (["agree", "--size", "7k"], "there is no size 7k; there are 1k"),
    ],
)
def test_what_cannot_be_run_is_refused_before_it_begins(asked: list[str], said: str) -> None:
    found = CliRunner().invoke(commands, asked)
    assert found.exit_code == 2
    assert said in found.output


def test_a_file_that_cannot_be_written_is_said_before_an_hour_is_spent(tmp_path: Path) -> None:
    found = CliRunner().invoke(commands, ["traffic", "--only", "routes", "--json", str(tmp_path / "none" / "x.json")])
    assert found.exit_code == 1
    assert "cannot be written" in found.output


def test_fleets_seeds_and_minutes_can_be_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(report, "FAB", SIZES["1k"])
    asked = CliRunner().invoke(
        commands, ["traffic", "--only", "sweep", "--fleet", "5", "--fleet", "9", "--seeds", "1", "--minutes", "4"]
    )
    assert [line.split("vehicles")[0].split()[-1] for line in asked.output.splitlines()] == ["5", "9"] * 4


def test_the_full_extent_soaks_and_drills_for_eight_hours() -> None:
    assert (FULL.soak, FULL.drill, FULL.fleets) == (8.0, 8.0, Extent().fleets)
