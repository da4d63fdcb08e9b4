"""``hoistway bench hoists``: what its parts make of what they see."""

import types
from dataclasses import replace

from app.cli.bench import generated, kept_back
from app.cli.hoists.load import nameless
from app.cli.hoists.report import missed, report
from app.cli.hoists.run import Found
from app.cli.hoists.sampling import LOOP, Sampler


def found(**lines: float) -> Found:
    usual = dict.fromkeys(
        ("connections", "frames_in", "frames_out", "garbled", "resends", "duplicates", "lost_polls"), 0.0
    )
    controller = {
        "process": {"user": 3.0, "kernel": 1.0, "rss": 100.0},
        "threads": {"MainThread": 3.5, "hoistway-writer": 0.5},
        "parts": {"fleet": 2.0, "dispatch": 1.5},
        "late": {"p50": 0.1, "p99": 1.0, "max": 2.0},
        "late_own": {"p50": 0.1, "p99": 0.5, "max": 0.9},
        "waited": 2.5,
        "lines": usual | lines,
    }
    floors = ({"user": 1.0, "kernel": 1.0, "rss": 50.0, "late": {"p50": 0.2, "p99": 3.0, "max": 9.0}},)
    return Found(
        100, 10.0, controller, floors, 20, 0, 0, 0, {"move done": 5, "xmove settled_not_done": 1}, {"a circle": 3}
    )


def test_lost_polls_and_commands_without_an_answer_are_missed_deadlines() -> None:
    assert missed(found()) == 1
    assert missed(found(lost_polls=2, resends=1)) == 4


def test_the_report_gives_cpu_by_part_and_for_each_vehicle() -> None:
    text = "\n".join(report(found()))
    assert "20 delivered (7,200 an hour)" in text
    assert "4000 µs a vehicle and second" in text
    assert "plant         20.0 % of a processor" in text
    assert "alarm       3 times: a circle" in text
    assert "plant late    p50 0.2 ms, p99 3.0 ms, max 9.0 ms" in text
    assert "had no processor for 25.0 % of the time" in text
    assert "without the waiting for a processor p50 0.1 ms, p99 0.5 ms, max 0.9 ms" in text


def test_a_sample_belongs_to_the_part_of_the_innermost_module_that_has_one() -> None:
    inner = types.ModuleType("app.planning.routing")
    exec("import sys\ndef here(): return sys._getframe()", inner.__dict__)
    assert Sampler()._part(inner.here()) == "planning"
    assert Sampler()._part(None) == LOOP


def test_a_small_fab_has_its_hoists_on_the_track() -> None:
    plant = generated(20, 1)
    assert len(plant.hoists) == 20
    assert len(plant.carriers) * 2 in range(len(plant.stations) // 2, len(plant.stations) + 2)


def test_a_generated_fleet_that_its_track_does_not_carry_is_kept_back_and_parks() -> None:
    many, few = generated(60, 1), replace(generated(60, 1), vehicles=generated(60, 1).vehicles[:10])
    assert (kept_back(many).restrain, kept_back(many).idle.park) == (True, True)
    assert kept_back(few) == few


def test_alarms_of_one_kind_are_counted_together_whoever_is_named() -> None:
    first = "V0001, V0002 wait for each other in a circle (V0001 waits at 101 for 102 held by V0002; V0002 waits)"
    second = "V0013, V0500, V0002 wait for each other in a circle (V0013 waits; V0500 waits; V0002 waits at 7)"
    assert nameless(first) == nameless(second) == "… wait for each other in a circle"
