"""Vehicles sent to a station before its lot is ready, or to a parking place (DOMAIN section 1)."""

from app.domain.closures import ClosedPlace, ClosePlace, PlaceKind
from app.domain.ids import StationId
from app.domain.layout import StopAction
from app.domain.requests import HoldVehicle, ParkVehicle, StageVehicle
from tests.fleet.drives import KIM, go
from tests.fleet.script import B1, HOST, P1, P2, P3, V1, V2, Script


def test_the_nearest_free_vehicle_is_sent_and_stands_ready_to_pick_up(ready: Script) -> None:
    assert ready.accept(StageVehicle(HOST, P2)).key == "V001"
    ready.run(10)
    assert ready.toys[V1].barcode == "106"
    assert ready.vehicle(V1).stopped is StopAction.PORT
    assert ready.vehicle(V1).available


def test_a_staged_vehicle_takes_the_job_for_its_station_and_gives_way_to_others(ready: Script) -> None:
    ready.accept(StageVehicle(HOST, P1, V1))
    ready.run(5)
    ready.order("P1", "P3")
    ready.run(2)
    assert ready.job("J1").vehicle == V1
    ready.run_until("J1")
    ready.accept(StageVehicle(HOST, P2, V1))
    ready.run(40)
    go(ready, "108", V2)
    ready.run(60)
    assert ready.toys[V2].barcode == "108"


def test_who_cannot_go_there_is_refused_with_the_reason(ready: Script) -> None:
    assert ready.refuse(StageVehicle(HOST, StationId("P9"))).code == "not-found"
    ready.accept(HoldVehicle(KIM, V1, "look"))
    assert "held by kim" in ready.refuse(StageVehicle(HOST, P1, V1)).reason
    ready.accept(HoldVehicle(KIM, V2, "look"))
    assert ready.refuse(StageVehicle(HOST, P1)).reason == "no vehicle is free that can go to P1"
    ready.accept(ClosePlace(KIM, ClosedPlace(PlaceKind.STATION, (P3,)), "x"))
    assert ready.refuse(StageVehicle(HOST, P3)).reason.startswith("P3 is closed by kim")


def test_a_vehicle_is_parked_at_the_nearest_place_that_is_free(ready: Script) -> None:
    ready.accept(ParkVehicle(KIM, V1))
    ready.run(10)
    assert ready.toys[V1].barcode == "108"
    ready.accept(ParkVehicle(KIM, V2))
    ready.run(15)
    assert ready.toys[V2].barcode == "102"
    ready.accept(ParkVehicle(KIM, V1))
    ready.run(10)
    assert ready.toys[V1].barcode == "108"


def test_a_vehicle_on_a_job_is_not_parked(ready: Script) -> None:
    ready.order("B1", "B2")
    ready.run(2)
    busy = ready.job("J1").vehicle
    assert busy is not None
    assert ready.refuse(ParkVehicle(KIM, busy)).code == "conflict"
    assert ready.station(B1).present
