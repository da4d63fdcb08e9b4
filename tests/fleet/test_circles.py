"""Circles of hoists that wait for each other are told, counted, and resolved where there is another way."""

from app.domain.ids import Actor, VehicleId
from app.domain.requests import MoveVehicle, ReleaseVehicle, Verdict
from app.domain.units import Barcode
from app.domain.view import ControllerView, Topic
from app.plant import read
from tests.fleet.script import Script

KIM = Actor("kim")
GOALS = {"V001": "302", "V002": "302", "V003": "102", "V004": "302"}
PLANT = """
name: knot
barcodes:
  101..102: {from: [0, 0], to: [1500, 0]}
  105..106: {from: [3000, 1500], to: [3000, 3000]}
  201..203: {from: [3000, -1500], to: [6000, -1500]}
  301..302: {from: [6000, 3000], to: [7500, 3000]}
track:
  - {through: [101, 102]}
  - {through: [102, 105], length: 1500}
  - {through: [105, 106]}
  - {through: [106, 101], length: 1500}
  - {through: [106, 301], length: 1500}
  - {through: [301, 302]}
  - {through: [302, 101], length: 9000}
  - {through: [201, 202, 203]}
  - {through: [203, 301], length: 6000}
BRANCH
vehicle_defaults: {length: 1100, max_count: 100, max_speed: 3000, curve_speed: 1000}
vehicles:
  V001: {dev_id: 1, address: "127.0.0.1:17101", start: 102}
  V002: {dev_id: 2, address: "127.0.0.1:17102", start: 101}
  V003: {dev_id: 3, address: "127.0.0.1:17103", start: 106}
  V004: {dev_id: 4, address: "127.0.0.1:17104", start: 105}
"""


def knot(*, branch: bool) -> Script:
    """Two full buffers put down by hand, 101 to 102 and 105 to 106: each vehicle wants the place of the next."""
    way_in = "  - {through: [102, 201], length: 3000}" if branch else "  - {through: [302, 201], length: 3000}"
    plant, _ = read(PLANT.replace("BRANCH", way_in), "knot.yaml")
    script = Script(plant).obey()
    for name, goal in GOALS.items():
        script.accept(MoveVehicle(KIM, VehicleId(name), Barcode(goal)))
    return script


def controller(script: Script) -> ControllerView:
    view = script.model[Topic.CONTROLLER]["knot"]
    assert isinstance(view, ControllerView)
    return view


def alarms(script: Script) -> list[tuple[str, str]]:
    return [(e.event, e.detail) for e in script.history() if e.event in {"AlarmSet", "AlarmCleared"}]


def test_a_circle_is_told_with_its_vehicles_and_resolved_by_the_other_branch() -> None:
    script = knot(branch=True)
    script.run(60)
    told = alarms(script)
    assert [name for name, _ in told] == ["AlarmSet", "AlarmCleared"]
    assert told[0][1] == told[1][1]
    assert "V001 waits at 102 for 105 held by V004" in told[0][1]
    assert all(name in told[0][1] for name in GOALS)
    view = controller(script)
    assert (view.circles, view.circles_found, view.circles_resolved) == ((), 1, 1)
    assert any(i.vehicle == "V001" and "201" in i.path for i in script.kept_intents()), "by the other branch"


def test_a_circle_without_another_way_stays_told_once_with_what_a_person_can_do() -> None:
    script = knot(branch=False)
    script.run(60)
    assert [name for name, _ in alarms(script)] == ["AlarmSet"]
    view = controller(script)
    assert (view.circles_found, view.circles_resolved) == (1, 0)
    assert "move V001 by hand, or take it off the rail" in view.circles[0]
    assert script.vehicle(VehicleId("V001")).barcode == "102"


def test_a_person_who_takes_one_off_the_rail_ends_the_circle() -> None:
    script = knot(branch=False)
    script.run(20)
    script.toys[VehicleId("V001")].cut()
    script.run(5)
    script.accept(ReleaseVehicle(KIM, VehicleId("V001"), Verdict.OFF_RAIL, "carried off"))
    script.run(10)
    view = controller(script)
    assert (view.circles, view.circles_found, view.circles_resolved) == ((), 1, 1)
