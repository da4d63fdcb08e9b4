"""A fleet that is larger than its track carries: who is given a job, and what the others' jobs say."""

from dataclasses import replace

import numpy as np
import pytest

from app.domain.view import ControllerView, Topic
from app.planning.dispatch import NOBODY, Jobs, Vehicles, dispatch
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


def test_after_a_restart_no_fewer_may_be_on_their_way_than_there_were() -> None:
    assert Restraint(1000).most == 150
    assert Restraint(1000, under_way=420).most == 420
    assert Restraint(100, under_way=42).most == 100


def test_people_are_told_how_many_may_be_on_their_way() -> None:
    for restrain, told in ((True, 2), (False, None)):
        script = ready(restrain=restrain)
        script.run(2)
        (view,) = script.model[Topic.CONTROLLER].values()
        assert isinstance(view, ControllerView)
        assert view.restrained_to == told


def test_agvs_are_not_kept_back_for_hoists() -> None:
    fleet = Vehicles(np.zeros(3), np.full(3, NOBODY), np.zeros(3, np.bool_), np.array([False, False, True]))
    plan = dispatch(fleet, Jobs.waiting(np.zeros(3)), lambda rows, columns: np.ones((len(rows), len(columns))), most=1)
    given = sorted(plan.vehicle.tolist())
    assert given[0] == NOBODY
    assert given[2] == 2, "the AGV"
    assert given[1] in {0, 1}
    plan = dispatch(fleet, Jobs.waiting(np.zeros(3)), lambda rows, columns: np.ones((len(rows), len(columns))), most=0)
    assert sorted(plan.vehicle.tolist()) == [NOBODY, NOBODY, 2]
