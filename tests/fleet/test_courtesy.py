"""Every wait has a reason, and idle vehicles go out of the way (DOMAIN section 5, TRAFFIC section 5)."""

from dataclasses import replace

import pytest

from app.domain.errors import NoRoute
from app.domain.ids import Actor, JobId, ZoneId
from app.domain.layout import StopAction, Zone
from app.domain.requests import AbortJob, HandleOnce, HoldVehicle, MoveVehicle, ReleaseVehicle, Verdict, WriteStation
from app.domain.units import Barcode
from app.domain.view import Topic, VehicleView
from app.planning.blocking import Blocked, BlockReason
from tests.fleet.script import HOST, P1, P3, V1, V2, Script, small, words

KIM = Actor("kim")
A5 = Barcode("105")


def waiting(script: Script, vehicle: str = "V001") -> str:
    """Return the sentence shown for a vehicle."""
    view = script.model[Topic.VEHICLES][vehicle]
    assert isinstance(view, VehicleView)
    return view.waiting


def place(script: Script, first: str, second: str) -> Script:
    """Have V001 stand at ``first`` and V002 at ``second``."""
    script.toys[V1].barcode, script.toys[V2].barcode = Barcode(first), Barcode(second)
    return script.obey()


# -- sentences --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("make", "ending"),
    [
        (lambda s: s.accept(HoldVehicle(KIM, V2, "noise")), "V002, which is on hold: held by kim: noise"),
        (lambda s: s.toys[V2].cut(), "V002, which is silent (line cut)"),
    ],
)
def test_a_wait_names_the_place_the_other_and_what_it_does(script: Script, make: object, ending: str) -> None:
    place(script, "103", "106")
    assert callable(make)
    make(script)
    script.accept(MoveVehicle(KIM, V1, Barcode("108")))
    script.run(6)
    assert waiting(script) == f"V001 waits at 104 for 105 held by {ending}"


def test_a_wait_for_a_handling_names_station_and_time(script: Script) -> None:
    place(script, "103", "106")
    script.world[small().stations[1].id] = script.world.pop(P1)
    script.accept(MoveVehicle(KIM, V2, Barcode("106"), StopAction.PORT))
    script.run(4)
    script.accept(HandleOnce(KIM, V2, small().stations[1].id, pickup=True))
    script.accept(MoveVehicle(KIM, V1, Barcode("108")))
    script.run(3)
    assert waiting(script).startswith("V001 waits at 104 for 105 held by V002, which is picking up at P2 (")
    assert waiting(script).endswith(" s)")


def test_a_wait_for_an_alarm_or_a_settlement_says_so(script: Script) -> None:
    place(script, "103", "106")
    script.accept(MoveVehicle(KIM, V1, Barcode("108")))
    script.toys[V2].mode = 0
    script.run(5)
    assert waiting(script).endswith("held by V002, which is being asked where it is") or "V002" in waiting(script)
    script.toys[V2].alarm = 101
    script.run(5)
    assert "V002, which is on hold: alarm 101" in waiting(script)


def test_a_wait_for_a_vehicle_that_waits_or_moves_itself_says_so(script: Script) -> None:
    place(script, "102", "107")
    script.accept(HoldVehicle(KIM, V2, "x"))
    doing = script.fleet._courtesy.doing
    assert doing(V1) == "V001, which is idle there"
    script.accept(MoveVehicle(KIM, V1, Barcode("108")))
    script.run(1)
    assert doing(V1) == "V001, which is moving"
    script.run(8)
    assert doing(V1) == "V001, which waits itself"
    script.toys[V1].alarm = 101
    script.report(V1, "104", words(oper=1, code=101))
    assert "V001, which" in doing(V1)


def test_a_wait_for_a_zone_names_it() -> None:
    plant = small()
    zone = Zone(ZoneId("bay"), frozenset(Barcode(str(b)) for b in range(105, 109)))
    script = Script(replace(plant, zones=(*plant.zones, zone)))
    place(script, "103", "107")
    script.accept(HoldVehicle(KIM, V2, "x"))
    script.accept(MoveVehicle(KIM, V1, Barcode("112")))
    script.run(5)
    assert waiting(script).startswith("V001 waits at 104 for 105 in zone bay held by V002")


@pytest.mark.parametrize(
    ("blocked", "sentence"),
    [
        (
            Blocked(A5, V2, BlockReason.FULL),
            ": no slot is free in the queue from 105 on; first goes V002, which is idle there",
        ),
        (
            Blocked(A5, V2, BlockReason.CIRCLE),
            ": the last slot in the queue from 105 on could close a circle of full queues; first goes V002, which is idle there",
        ),
        (Blocked(A5, None, BlockReason.METER, ZoneId("spine")), ": zone spine takes in no more for now"),
        (
            Blocked(A5, V2, BlockReason.TURN),
            ": others have waited longer for the queue from 105 on; first goes V002, which is idle there",
        ),
    ],
)
def test_a_wait_for_a_queue_says_who_goes_first(script: Script, blocked: Blocked, sentence: str) -> None:
    place(script, "103", "116")
    vehicle = script.fleet.books.vehicles[V1]
    script.fleet._courtesy.explain(vehicle, blocked)
    assert vehicle.waiting == f"V001 waits at 103{sentence}"


def test_an_idle_vehicle_at_the_head_of_a_full_queue_is_sent_on(script: Script) -> None:
    place(script, "103", "110")
    books = script.fleet.books
    script.accept(MoveVehicle(KIM, V1, Barcode("106")))
    assert books.vehicles[V2].errand is None
    script.fleet._courtesy.explain(books.vehicles[V1], Blocked(A5, V2, BlockReason.FULL))
    assert books.vehicles[V2].errand is not None
    script.run(20)
    assert script.vehicle(V2).barcode != "110"


def test_a_wait_for_a_closure_says_why_it_is_closed(script: Script) -> None:
    place(script, "103", "116")
    script.fleet.books.traffic.close([Barcode("105")], "rail work")
    script.accept(MoveVehicle(KIM, V1, Barcode("108")))
    script.run(4)
    assert waiting(script) == "V001 waits at 104: 105 is closed (rail work)"


def test_a_wait_for_the_roll_call_names_who_is_missing(script: Script) -> None:
    script.order(vehicle=V1)
    script.obey(V1)
    script.run(3)
    assert script.job("J1").vehicle == V1
    assert waiting(script) == "V001 waits at 103: the roll-call still misses V002"
    script.obey(V2)
    script.run_until("J1")
    assert waiting(script) == ""


def test_a_wait_ends_with_its_cause(script: Script) -> None:
    place(script, "103", "106")
    script.accept(HoldVehicle(KIM, V2, "noise"))
    script.accept(MoveVehicle(KIM, V1, Barcode("108")))
    script.run(5)
    assert waiting(script)
    script.accept(ReleaseVehicle(KIM, V2, Verdict.GO_ON, "fine"))
    script.run(30)
    assert waiting(script) == ""
    assert script.vehicle(V1).barcode == "108"


# -- giving way -------------------------------------------------------------------------------------------------------


def test_an_idle_vehicle_in_the_way_is_sent_to_a_parking_place_off_the_way(script: Script) -> None:
    place(script, "103", "106")
    script.accept(MoveVehicle(KIM, V1, Barcode("107")))
    script.run(30)
    assert script.vehicle(V1).barcode == "107"
    assert script.vehicle(V2).barcode == "112"
    move = next(i for i in script.kept_intents() if i.vehicle == V2 and i.kind == "move")
    assert move.body["purpose"] == "give_way"


def test_a_vehicle_that_gives_way_takes_a_job_at_once(script: Script) -> None:
    place(script, "103", "106")
    script.world.update({P1: script.world.get(P1, script.plant.carriers[0][0])})
    script.accept(MoveVehicle(KIM, V1, Barcode("107")))
    script.run(4)
    script.order("P1", "P3", vehicle=V2)
    script.run_until("J1", at_most=600)


def test_a_vehicle_that_is_barred_handling_or_on_an_errand_is_not_sent_away(script: Script) -> None:
    place(script, "103", "106")
    script.accept(HoldVehicle(KIM, V2, "x"))
    script.accept(MoveVehicle(KIM, V1, Barcode("108")))
    script.run(15)
    assert script.vehicle(V2).barcode == "106"
    assert script.vehicle(V2).errand is None


def test_a_loaded_vehicle_that_waits_for_its_destination_gives_way_again_and_again(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(WriteStation(HOST, P3, present=True))
    ready.run(15)
    for _ in range(2):
        for barcode in ("104", "108", "114", "117"):
            ready.accept(MoveVehicle(KIM, V2, Barcode(barcode)))
            ready.run(45)
            assert ready.vehicle(V2).barcode == barcode, waiting(ready, "V002")
    assert ready.job("J1").vehicle == V1
    ready.accept(WriteStation(HOST, P3, present=False))
    ready.run_until("J1")


def test_a_loaded_vehicle_without_a_job_gives_way_too(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, JobId("J1")))
    ready.run(10)
    ready.accept(MoveVehicle(KIM, V2, Barcode("115")))
    ready.run(60)
    assert ready.vehicle(V2).barcode == "115"


def test_where_there_is_no_place_off_the_way_nobody_is_sent_anywhere(script: Script) -> None:
    place(script, "103", "106")
    everywhere = Zone(ZoneId("all"), frozenset(p.barcode for p in script.plant.points), 9, no_stop=True)
    crowded = Script(replace(script.plant, zones=(everywhere,)))
    place(crowded, "103", "106")
    vehicles = crowded.fleet.books.vehicles
    assert crowded.fleet._courtesy.refuge(vehicles[V1], vehicles[V2]) is None
    crowded.fleet._courtesy.ask_way(vehicles[V1], vehicles[V2])
    assert vehicles[V2].errand is None


def test_a_vehicle_whose_place_is_not_known_has_no_refuge(script: Script) -> None:
    vehicles = script.fleet.books.vehicles
    assert script.fleet._courtesy.refuge(vehicles[V1], vehicles[V2]) is None


def test_the_nearest_place_serves_where_there_is_no_parking() -> None:
    plant = small()
    script = Script(replace(plant, points=tuple(replace(p, park=False) for p in plant.points)))
    place(script, "102", "105")
    script.accept(MoveVehicle(KIM, V1, Barcode("106")))
    script.run(30)
    assert (script.vehicle(V1).barcode, script.vehicle(V2).barcode) == ("106", "108")


def test_a_vehicle_that_finds_no_way_out_stays(script: Script, monkeypatch: pytest.MonkeyPatch) -> None:
    place(script, "103", "106")

    def none(start: Barcode, goal: Barcode) -> tuple[Barcode, ...]:
        raise NoRoute(f"no route from {start} to {goal}")

    vehicles = script.fleet.books.vehicles
    monkeypatch.setattr(script.fleet.books.router, "route", none)
    script.fleet._courtesy.ask_way(vehicles[V1], vehicles[V2])
    assert vehicles[V2].errand is None
