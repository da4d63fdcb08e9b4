"""Idle hoists go to parking places, where the plant file wants it."""

from dataclasses import replace

import pytest

from app.domain.ids import VehicleId
from app.domain.layout import IdleRules
from app.domain.units import Barcode, Seconds
from app.domain.view import Topic, VehicleView
from app.fleet.vehicle import Purpose
from tests.fleet.script import FOUP1, P1, V1, V2, Script, small

RULES = IdleRules(park=True, after=Seconds(20.0))


def begun(rules: IdleRules = RULES, first: str = "103", second: str = "116") -> Script:
    """Return two idle hoists that stand at these places; 102, 108 and 112 are for parking."""
    script = Script(replace(small(), idle=rules))
    script.toys[V1].barcode, script.toys[V2].barcode = Barcode(first), Barcode(second)
    return script.obey()


def parks(script: Script, vehicle: VehicleId) -> list[object]:
    """Return where a vehicle was told to park, in order."""
    moves = (i for i in script.kept_intents() if i.vehicle == vehicle and i.kind == "move")
    return [i.body["goal"] for i in moves if i.body["purpose"] == "park"]


def test_an_idle_hoist_is_sent_after_its_time_and_not_before() -> None:
    script = begun()
    script.run(14)
    assert not parks(script, V1) + parks(script, V2)
    script.run(10)
    assert parks(script, V1)
    assert parks(script, V2)


def test_two_hoists_do_not_get_one_place_and_one_that_is_parked_stays() -> None:
    script = begun()
    script.run(90)
    places = {script.vehicle(name).barcode for name in (V1, V2)}
    assert len(places) == 2
    assert places <= {"102", "108", "112"}
    for name in (V1, V2):
        view = script.model[Topic.VEHICLES][name]
        assert isinstance(view, VehicleView)
        assert view.parked
        assert script.vehicle(name).errand is None
    before = len(script.kept_intents())
    script.run(90)
    assert len(script.kept_intents()) == before


def test_a_hoist_on_its_way_to_park_takes_a_job_at_once() -> None:
    script = begun()
    script.run(22)
    errands = [script.vehicle(name).errand for name in (V1, V2)]
    assert any(errand and errand.purpose is Purpose.PARK for errand in errands)
    script.world[P1] = FOUP1
    script.order(vehicle=V1)
    script.run(1)
    assert script.job("J1").vehicle == V1
    errand = script.vehicle(V1).errand
    assert errand is not None
    assert errand.purpose is Purpose.SOURCE
    script.run_until("J1")


@pytest.mark.parametrize("rules", [IdleRules(), replace(RULES, farthest=Seconds(0.5))])
def test_nobody_goes_anywhere_unless_it_is_wanted_and_near_enough(rules: IdleRules) -> None:
    script = begun(rules)
    script.run(90)
    assert (script.vehicle(V1).barcode, script.vehicle(V2).barcode) == ("103", "116")
    view = script.model[Topic.VEHICLES][V1]
    assert isinstance(view, VehicleView)
    assert not view.parked
