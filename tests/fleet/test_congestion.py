"""Ways by the traffic: what hoists are seen to take over track weighs the ways of others, where the plant wants it."""

from dataclasses import replace

import pytest

from app.domain.ids import JobId, VehicleId
from app.domain.units import Barcode, Seconds
from app.fleet.congestion import WEIGH_EVERY
from app.planning.traverses import Smoothing, Traverses
from app.plant import read
from tests.fleet.branching import PLANT, V1, V2, branching, controller, driven, go
from tests.fleet.script import Script

SHORT = [Barcode(b) for b in ("104", "105", "106", "107", "110")]


@pytest.fixture(autouse=True)
def _trusting(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let one vehicle be enough, and a little slower count."""
    trusting = Smoothing(doubt=0.1, most=4.0, power=1.0)
    monkeypatch.setattr("app.fleet.congestion.Traverses", lambda free: Traverses(free, trusting))


def held_up(script: Script, seconds: float = 28.0) -> None:
    """Let V001 drive from the dead end's mouth round to the short branch, where something stands before it for a while."""
    script.accept(go("112", V1))
    script.run(20)
    script.accept(go("111", V1))
    while script.toys[V1].barcode != "106":
        script.run(0.25)
    script.toys[V1].paused = True
    script.run(seconds)
    script.toys[V1].paused = False
    script.run(15)


def short_branch(script: Script) -> float:
    return script.fleet.books.router.along(SHORT)


def test_where_hoists_are_held_up_costs_more_and_is_driven_round() -> None:
    script = branching()
    free = short_branch(script)
    held_up(script)
    assert short_branch(script) > 2 * free
    assert controller(script).weighed >= 1
    assert controller(script).slow_track >= 1
    script.forget()
    script.accept(go("111", V2))
    script.run(40)
    assert "203" in driven(script, V2)


def test_where_many_have_waited_for_long_costs_more_though_nobody_has_got_over_it() -> None:
    script = branching()
    free = short_branch(script)
    queues = script.fleet.books.traffic.queues
    assert queues is not None
    for name, at in (("V001", "106"), ("V002", "107"), ("V003", "105")):
        script.fleet.books.traffic.hold(VehicleId(name), [Barcode(at)])
        script.vehicle(VehicleId(name)).job = JobId("J0")
    assert queues.load(queues.buffers.at(Barcode("106"))) == queues.buffers.capacity[queues.buffers.at(Barcode("106"))]
    for _ in range(40):
        script.now = Seconds(script.now + WEIGH_EVERY)
        script.fleet.books.now = script.now
        script.fleet._flow._congestion.run()
    assert short_branch(script) > 2 * free


def test_it_is_forgotten_once_others_get_on_there() -> None:
    script = branching()
    free = short_branch(script)
    held_up(script)
    script.run(900)
    assert short_branch(script) < 1.5 * free
    assert controller(script).slow_track == 0


def test_a_hoist_that_stands_for_its_own_sake_slows_nothing() -> None:
    script = branching()
    free = short_branch(script)
    script.run(60)
    script.accept(go("112", V1))
    script.run(60)
    assert short_branch(script) == free
    assert controller(script).weighed == 0


@pytest.mark.parametrize(
    ("traffic", "weighs"),
    [
        ("", True),
        ("traffic: {restrain: true}", False),
        ("traffic: {restrain: true, congestion: true}", True),
        ("traffic: {congestion: false}", False),
    ],
)
def test_the_plant_file_says_whether_and_a_fleet_that_is_kept_back_keeps_to_its_ways(
    traffic: str, weighs: bool
) -> None:
    script = branching(f"{PLANT}{traffic}\n")
    free = short_branch(script)
    held_up(script)
    assert (short_branch(script) > free) is weighs


def test_ways_are_weighed_anew_at_most_every_so_often_and_only_for_something() -> None:
    script = branching()
    held_up(script)
    weighed = controller(script).weighed
    script.run(WEIGH_EVERY * 3)
    assert controller(script).weighed <= weighed + 3
    plant, _ = read(PLANT, "branching.yaml")
    quiet = Script(replace(plant, congestion=True)).obey()
    quiet.run(100)
    assert quiet.fleet.books.traffic_state.weighed == 0
