"""Circles of hoists that wait for each other are told, counted, and resolved where there is another way."""

from math import cos, sin, tau

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


def train(hoists: int) -> str:
    """A ring with a siding, a train of hoists all round it, and two more elsewhere, of which one waits for the other."""
    ring = "\n".join(
        f"  {100 + i}: [{round(9000 * cos(tau * i / 40))}, {round(9000 * sin(tau * i / 40))}]" for i in range(40)
    )
    starts = [f"V{i:03d}: {{dev_id: {i}, start: {100 + 4 * (i - 1)}}}" for i in range(1, hoists + 1)]
    starts += ["V091: {dev_id: 91, start: 301}", "V092: {dev_id: 92, start: 304}"]
    vehicles = "\n".join(f"  {start[:-1]}, address: '127.0.0.1:{17101 + i}'}}" for i, start in enumerate(starts))
    return f"""
name: train
barcodes:
{ring}
  201..203: {{from: [12000, 0], to: [12000, 4000]}}
  301..306: {{from: [20000, 0], to: [20000, 9000]}}
track:
  - {{through: [{", ".join(str(100 + i) for i in range(40))}, 100]}}
  - {{through: [100, 201], length: 3000}}
  - {{through: [201, 202, 203]}}
  - {{through: [203, 110], length: 9000}}
  - {{through: [301, 302, 303, 304, 305, 306]}}
  - {{through: [306, 301], length: 9000}}
vehicle_defaults: {{length: 1100, max_count: 100, max_speed: 3000, curve_speed: 1000}}
vehicles:
{vehicles}
"""


def controller(script: Script) -> ControllerView:
    view = script.model[Topic.CONTROLLER][script.plant.name]
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


def test_a_train_all_round_a_ring_is_no_circle_though_each_waits_for_the_next_while_it_drives() -> None:
    plant, _ = read(train(9), "train.yaml")
    script = Script(plant).obey()
    script.toys[VehicleId("V092")].cut()
    script.accept(MoveVehicle(KIM, VehicleId("V091"), Barcode("305")))
    script.run(10)
    assert script.fleet.books.vehicles[VehicleId("V091")].waiting
    for i in range(1, 10):
        script.accept(MoveVehicle(KIM, VehicleId(f"V{i:03d}"), Barcode(str(100 + (4 * (i - 1) + 38) % 40))))
    nose_to_tail = False
    for _ in range(60):
        script.run(1)
        nose_to_tail |= bool(script.fleet.books.traffic.cycles())
    assert nose_to_tail
    assert controller(script).circles_found == 0
