"""``hoistway bench traffic``: its parts on a small fab."""

from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli.bench import commands
from app.cli.traffic import report
from app.cli.traffic.report import FULL, PARTS, Extent, Report
from app.cli.traffic.table import BEGIN, END, Kept, table
from app.cli.traffic.trials import Outcome
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
    assert [line.split("  ")[0] for line in found[:-1]] == ["no rule", "admission", "+ congestion", "all"]
    assert found[-1] == "0 of 3 runs with a rule locked up [no lock-up: reached]"
    assert small.found["peak"] == 8
    assert small.found["peak_per_hour"] > 0


def test_a_fleet_larger_than_the_peak_is_held_against_what_the_sweep_found_as_most(small: Report) -> None:
    small.found["peak_per_hour"], small.peak = 5.0, 1e6
    small.extent = replace(SMALL, peak=5, soak=1.0)
    (line,) = lines(small, "soak")
    assert line.startswith("7 vehicles for 1 h: ")
    assert line.endswith(
        "of the peak of 1,000,000/h: 0% in the last hour, 0% in the worst after the first [90 % of peak: MISSED]"
    )
    assert small.found["soak"]["hours"][0] > 0
    assert small.failed == ["90 % of peak"]


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
    tried = [line for line in asked.output.splitlines() if "/h (" in line]
    assert [line.split("vehicles")[0].split()[-1] for line in tried] == ["5", "9"] * 4


def test_parts_run_one_by_one_make_one_table_that_says_whether_each_goal_is_met(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(report, "FAB", SIZES["1k"])
    monkeypatch.setattr(report, "Extent", lambda: SMALL)
    json, page = tmp_path / "found.json", tmp_path / "page.md"
    page.write_text(f"Before.\n{BEGIN}old\n{END}After.\n")
    both = ["--json", str(json), "--table", str(page)]
    assert CliRunner().invoke(commands, ["traffic", "--only", "rules", *both]).exit_code == 0
    asked = CliRunner().invoke(commands, ["traffic", "--only", "routes", *both])
    assert asked.exit_code == 0
    head, rules, routes = page.read_text().split("|---|---|---|---|\n")[0], *page.read_text().splitlines()[4:6]
    assert head.startswith(f"Before.\n{BEGIN}| what | found | goal | met |\n")
    assert rules.endswith("| none with the rule | yes |")
    assert routes == "| routes of 20 random pairs against networkx's | 0 dearer | equal costs | yes |"
    assert page.read_text().endswith(f"{END}After.\n")
    assert asked.output.endswith(f"{rules}\n{routes}\n")


def test_a_file_of_findings_reads_back_and_has_rows_of_numbers_on_one_line(tmp_path: Path) -> None:
    file = tmp_path / "found.json"
    kept = Kept(file, ())
    kept.found |= {"soak": {"per_minute": list(range(480)), "hours": [8.5, 7.0]}, "goals": {"soak": []}}
    kept.keep()
    assert Kept(file, ()).found == kept.found
    assert len(file.read_text().splitlines()) == 9


def test_a_part_run_again_replaces_what_was_found_before(small: Report) -> None:
    for _ in range(2):
        small.begin("routes")
        lines(small, "routes")
    assert len(small.found["goals"]["routes"]) == 1


def test_the_table_shows_deliveries_by_fleet_with_lock_ups_and_missed_goals() -> None:
    runs = [{"locked": 3, "stalled": False}, {"locked": 0, "stalled": False}]
    found = {
        "sweep": [
            {"mode": "no rule", "vehicles": 400, "per_hour": 12.4, "runs": runs},
            {"mode": "all", "vehicles": 1000, "per_hour": 8000.0, "runs": [{"locked": 0, "stalled": True}]},
        ],
        "goals": {"sweep": [{"what": "w", "found": "f", "goal": "g", "met": False}]},
    }
    assert table(found).splitlines() == [
        "| deliveries an hour | 400 vehicles | 1,000 vehicles |",
        "|---|---|---|",
        "| no rule | 12, 1 of 2 locked up | – |",
        "| all | – | 8,000, 1 of 1 at a standstill |",
        "",
        "| what | found | goal | met |",
        "|---|---|---|---|",
        "| w | f | g | no |",
    ]


@pytest.mark.parametrize(
    ("option", "text", "said"),
    [
        ("--json", "no json", "has no JSON in it"),
        ("--json", "[1]", "has no findings of"),
        ("--table", "A chapter.\n", "no place for the table"),
    ],
)
def test_a_file_with_something_else_in_it_is_left_as_it_is(option: str, text: str, said: str, tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text(text)
    found = CliRunner().invoke(commands, ["traffic", "--only", "routes", option, str(file)])
    assert found.exit_code == 1
    assert said in found.output
    assert file.read_text() == text


def test_the_full_extent_soaks_and_drills_for_eight_hours() -> None:
    assert (FULL.soak, FULL.drill, FULL.drills, FULL.fleets) == (8.0, 8.0, (1, 2, 3), Extent().fleets)


def test_a_run_without_a_delivery_at_its_end_is_at_a_standstill_unless_it_is_locked_up() -> None:
    def outcome(per_minute: tuple[int, ...], locked: int) -> Outcome:
        return Outcome(9, 60.0 * len(per_minute), per_minute, locked, 0, 0, 0.0, 1.0)

    assert outcome((9, 3, 0, 0, 0, 0, 0), 0).stalled
    assert not outcome((9, 3, 0, 0, 0, 0, 1), 0).stalled
    assert not outcome((9, 3, 1, 0, 0, 0, 0), 0).stalled
    assert not outcome((9, 3, 0, 0, 0, 0, 0), 4).stalled
