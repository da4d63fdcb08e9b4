"""A fleet that is larger than its track carries: who is given a job, and what the others' jobs say."""

from dataclasses import replace

import pytest

from app.planning.restraint import Restraint
from tests.fleet.script import B1, FOUP1, FOUP2, P1, Script, small


@pytest.fixture
def room(monkeypatch: pytest.MonkeyPatch) -> dict[str, int]:
    """Return how many may be on their way, to be changed."""
    most = {"most": 1}

    def look(self: Restraint, standing: int, driving: int, under_way: int, seconds: float) -> int:
        return max(0, most["most"] - under_way)

    monkeypatch.setattr(Restraint, "look", look)
    monkeypatch.setattr(Restraint, "most", property(lambda self: most["most"]))
    return most


def ready(restrain: bool) -> Script:
    script = Script(replace(small(), restrain=restrain))
    script.world.update({P1: FOUP1, B1: FOUP2})
    return script.obey()


def test_no_more_vehicles_are_given_jobs_than_the_track_carries_and_the_other_job_says_so(room: dict[str, int]) -> None:
    script = ready(restrain=True)
    script.order("P1", "P3", job="J1")
    script.order("B1", "B2", job="J2")
    script.run(5)
    given = [script.job(name).vehicle for name in ("J1", "J2")]
    assert given[0] is not None
    assert given[1] is None
    assert script.job("J2").reason == "the track carries no more just now: 1 vehicles may be on their way with jobs"
    room["most"] = 2
    script.run(5)
    assert script.job("J2").vehicle not in {None, given[0]}
    script.run_until("J1", "J2", at_most=600)


def test_a_job_that_was_kept_back_begins_once_another_has_ended(room: dict[str, int]) -> None:
    script = ready(restrain=True)
    script.order("P1", "P3", job="J1")
    script.order("B1", "B2", job="J2")
    script.run_until("J1", "J2", at_most=900)


def test_where_the_plant_does_not_say_so_nobody_is_kept_back(room: dict[str, int]) -> None:
    script = ready(restrain=False)
    script.order("P1", "P3", job="J1")
    script.order("B1", "B2", job="J2")
    script.run(5)
    assert {script.job("J1").vehicle, script.job("J2").vehicle} == set(script.fleet.books.vehicles)
