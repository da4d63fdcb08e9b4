"""A vehicle that stands for good closes what it bars for the ways of others, until it goes on."""

import pytest

from app.domain.ids import VehicleId
from app.domain.requests import LockVehicle, PauseController, ReleaseVehicle, ResumeController, SetService, Verdict
from app.fleet.breakdowns import AT_ONCE, GRACE, OBSTACLE_GRACE
from app.plant import read
from tests.fleet.branching import KIM, PLANT, V1, V2, V3, branching, controller, driven, go, go_on, hold
from tests.fleet.script import Script

BROKEN = "VehicleBrokenDown"
MENDED = "VehicleMended"


@pytest.fixture
def script() -> Script:
    return branching()


def closed(script: Script) -> set[object]:
    return set(script.fleet.books.closed)


def test_a_vehicle_that_is_held_closes_what_it_stands_on_after_a_while_and_is_driven_round(script: Script) -> None:
    script.accept(hold())
    script.run(GRACE - 2)
    assert closed(script) == set()
    script.run(4)
    assert closed(script) == {"106"}
    script.accept(go("111"))
    script.run(40)
    assert script.vehicle(V2).barcode == "111"
    assert "203" in driven(script)
    assert "105" not in driven(script)


def test_it_opens_again_once_the_vehicle_can_go_on_and_that_is_told(script: Script) -> None:
    script.accept(hold())
    script.run(GRACE + 2)
    script.accept(go_on())
    script.run(5)
    assert closed(script) == set()
    told = [(e.event, e.vehicle, e.detail) for e in script.history() if e.event in {BROKEN, MENDED}]
    assert told == [
        (BROKEN, V1, "V001 stands there, on hold: held by kim: it rattles; ways lead round 106"),
        (MENDED, V1, "V001 can go on"),
    ]


def test_a_short_hold_closes_nothing_and_its_time_is_not_added_to_the_next(script: Script) -> None:
    for _ in range(3):
        script.accept(hold())
        script.run(GRACE - 3)
        script.accept(go_on())
        script.run(5)
    assert BROKEN not in script.events()


def test_an_obstacle_of_some_seconds_closes_nothing_one_that_stays_does(script: Script) -> None:
    script.accept(go("111", V1))
    script.run(2)
    toy = script.toys[V1]
    toy.paused = True
    script.run(OBSTACLE_GRACE - 3)
    assert closed(script) == set()
    script.run(6)
    assert script.vehicle(V1).barcode in closed(script)
    toy.paused = False
    script.run(20)
    assert closed(script) == set()
    assert script.vehicle(V1).barcode == "111"


def test_a_vehicle_in_alarm_out_of_service_locked_out_or_out_of_auto_closes_its_place_too(script: Script) -> None:
    for broken in ("alarm", "service", "lockout", "mant"):
        each = branching()
        if broken == "alarm":
            each.toys[V1].alarm = 77
        elif broken == "mant":
            each.toys[V1].mode = 0
        else:
            asked = SetService(KIM, V1, "worn") if broken == "service" else LockVehicle(KIM, V1, "a person is there")
            each.accept(asked)
        each.run(GRACE + 3)
        assert "106" in closed(each), broken
        words = {"alarm": "in alarm 77", "service": "out of service: worn", "lockout": "locked out", "mant": "in MANT"}
        assert words[broken] in controller(each).kept_off[0], broken


def test_a_vehicle_taken_from_auto_bars_all_that_it_can_be_moved_to_by_hand_and_can_be_sent_from_there(
    script: Script,
) -> None:
    toy = script.toys[V1]
    toy.mode = 0
    script.run(GRACE + 3)
    assert closed(script) == set(script.fleet.books.traffic.held(V1))
    assert len(closed(script)) > 1
    toy.mode = 3
    script.run(5)
    assert closed(script) == set()
    script.accept(go("111", V1))
    script.run(20)
    assert script.vehicle(V1).barcode == "111"


def test_a_silent_vehicle_closes_all_it_may_be_on_while_others_are_heard(script: Script) -> None:
    script.accept(go("111", V1))
    script.run(1)
    held = set(script.fleet.books.traffic.held(V1))
    script.toys[V1].cut()
    script.run(GRACE + 3)
    assert closed(script) == held
    script.toys[V1].connect()
    script.run(8)
    assert closed(script) == set()


def test_where_nobody_is_heard_nothing_is_closed(script: Script) -> None:
    for toy in script.toys.values():
        toy.cut()
    script.run(5 * GRACE)
    assert closed(script) == set()


def test_after_a_start_nothing_is_closed_for_vehicles_that_have_not_reported_yet(script: Script) -> None:
    script.restart()
    script.obey(V2, V3)
    script.run(5 * GRACE)
    assert closed(script) == set()
    assert BROKEN not in script.events()


def test_after_a_start_a_vehicle_that_is_still_held_closes_its_place_again(script: Script) -> None:
    script.accept(hold())
    script.run(GRACE + 2)
    script.restart()
    assert closed(script) == set()
    script.obey()
    script.run(GRACE + 5)
    assert closed(script) == {"106"}


def test_a_vehicle_taken_off_the_rail_closes_nothing_any_more(script: Script) -> None:
    script.accept(hold())
    script.toys[V1].cut()
    script.run(GRACE + 2)
    assert closed(script) == {"106"}
    script.accept(ReleaseVehicle(KIM, V1, Verdict.OFF_RAIL, "carried off"))
    assert closed(script) == set()
    assert "V001 is off the rail" in [e.detail for e in script.history()]


def test_nothing_closes_while_the_controller_is_paused(script: Script) -> None:
    script.accept(PauseController(KIM, "shift change"))
    script.accept(hold())
    script.run(3 * GRACE)
    assert closed(script) == set()
    script.accept(ResumeController(KIM))
    script.run(3)
    assert closed(script) == {"106"}


def test_a_zone_that_it_fills_alone_is_closed_as_a_whole() -> None:
    zones = "zones:\n  narrow: {barcodes: [105, 106, 107], capacity: 1}\nstations:"
    script = branching(PLANT.replace("stations:", zones))
    script.accept(hold())
    script.run(GRACE + 2)
    assert closed(script) == {"105", "106", "107"}


def test_many_that_fall_silent_at_once_are_closed_a_few_at_a_time() -> None:
    more = AT_ONCE + 5
    barcodes = "barcodes:\n  401..440: {from: [0, 20000], to: [78000, 20000]}\n  441..480: {from: [78000, 23000], to: [0, 23000]}"
    track = "track:\n  - {through: [401..480, 401]}"
    text = PLANT.replace("barcodes:", barcodes).replace("track:", track)
    for n in range(more + 1):
        text += f'  W{n:03}: {{dev_id: {n + 10}, address: "127.0.0.1:{17200 + n}", start: {401 + 4 * n}}}\n'
    script = branching(text)
    for n in range(more):
        script.toys[VehicleId(f"W{n:03}")].cut()
    script.run(GRACE + 0.75)
    seen = {len(closed(script))}
    for _ in range(20):
        script.run(0.25)
        seen.add(len(closed(script)))
    assert sorted(seen)[-1] == more
    assert any(0 < count < more for count in seen)


def test_those_that_close_nothing_do_not_stand_before_those_that_do() -> None:
    spare = AT_ONCE + 2
    text = PLANT + "".join(
        f'  W{n:03}: {{dev_id: {n + 10}, address: "127.0.0.1:{17200 + n}", in_service: false}}\n' for n in range(spare)
    )
    plant, _ = read(text, "branching.yaml")
    script = Script(plant).obey(V1, V2, V3)
    script.run(GRACE + 2)
    script.accept(hold())
    script.run(GRACE + 2)
    assert closed(script) == {"106"}


def test_what_is_closed_is_shown_with_its_reason_until_it_is_open(script: Script) -> None:
    script.accept(hold())
    script.run(GRACE + 2)
    assert controller(script).kept_off == ("106: V001 stands there, on hold: held by kim: it rattles",)
    assert controller(script).closed_places == 1
    script.accept(go_on())
    script.run(5)
    assert (controller(script).kept_off, controller(script).closed_places) == ((), 0)
