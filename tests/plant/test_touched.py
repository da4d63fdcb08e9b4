"""What a changed plant would break of what is under way."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.domain.closures import ClosedPlace, Closure, ClosurePurpose, PlaceKind
from app.domain.devices import DeviceId
from app.domain.drive import DriveId
from app.domain.drive_records import DriveRecord
from app.domain.ids import Actor, CarrierId, CmdId, Epoch, JobId, StationId, VehicleId
from app.domain.job import Job
from app.domain.layout import Plant, PulseSet
from app.domain.lockout import Lockout
from app.domain.records import (
    CarrierRecord,
    DeviceRecord,
    Intent,
    IntentState,
    Kept,
    Provenance,
    StationDest,
    StationRecord,
    VehicleRecord,
)
from app.domain.teaching import TeachingSession
from app.domain.units import Barcode, Pulses, Timestamp
from app.domain.versions import Leaving
from app.plant import read
from app.plant.touched import leaving, touched

SMALL = (Path(__file__).parents[2] / "plants" / "small.yaml").read_text(encoding="utf-8")
NOW = Timestamp(0.0)
KIM = Actor("kim")


def plant(*changes: tuple[str, str]) -> Plant:
    text = SMALL
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    return read(text, "small")[0]


NO_P3 = plant(
    ("  P3:\n    kind: port\n    at: 114\n    dest: {shft: -900, rota: 150, lift: 40500}\n    display: LOADER-3\n", "")
)
NO_V002 = replace(plant(), vehicles=plant().vehicles[:1])
NO_118 = plant(("  118: [0", "  218: [0"), ("117, 118, 101", "117, 218, 101"))


def job(**more: Any) -> Job:
    given: dict[str, Any] = {"id": JobId("J1"), "order": 1, "carrier": None, "source": "P1", "destination": "P3"}
    return Job(**given | {"priority": 50, "created": NOW, "actor": KIM, "fingerprint": ""} | more)


def told(new: Plant, **kept: Any) -> list[tuple[str, str]]:
    return [(one.what, one.name) for one in touched(plant(), new, Kept(epoch=Epoch(1), **kept))]


def test_nothing_under_way_breaks_nothing() -> None:
    assert told(NO_P3) == told(NO_V002) == told(NO_118) == []


def test_a_job_to_a_station_that_goes_is_named() -> None:
    assert told(NO_P3, jobs=(job(),)) == [("job", "J1")]
    assert told(NO_P3, jobs=(job(destination=StationId("P2")),)) == []
    assert told(NO_118, jobs=(job(),)) == []


def test_a_job_from_aboard_a_vehicle_stays() -> None:
    assert told(NO_P3, jobs=(job(source=VehicleId("V001"), destination=StationId("P2")),)) == []


def test_a_job_of_a_vehicle_that_goes_is_named() -> None:
    assert told(NO_V002, jobs=(job(vehicle=VehicleId("V002")),)) == [("job", "J1")]
    assert told(NO_V002, jobs=(job(wish=VehicleId("V002")),)) == [("job", "J1")]


def test_a_job_to_a_station_without_a_way_is_named() -> None:
    cut = replace(plant(), edges=tuple(edge for edge in plant().edges if edge.start != "113"))
    assert set(told(cut, jobs=(job(),))) == {("job", "J1")}


def test_a_carrier_at_a_station_that_goes_is_named() -> None:
    there = CarrierRecord(CarrierId("F1"), StationId("P3"), Provenance.HOST, NOW)
    assert told(NO_P3, carriers=(there,)) == [("carrier", "F1")]
    assert told(NO_P3, carriers=(replace(there, place=None), replace(there, place=VehicleId("V001")))) == []


def test_a_vehicle_on_the_rail_must_be_in_the_new_plant() -> None:
    record = VehicleRecord(VehicleId("V002"), Barcode("116"), (Barcode("116"),))
    assert told(NO_V002, vehicles=(record,)) == [("vehicle", "V002")]
    assert told(NO_V002, vehicles=(replace(record, off_rail="taken off by kim"),)) == []
    assert told(NO_118, vehicles=(record,)) == []


@pytest.mark.parametrize("where", ["barcode", "held", "path"])
def test_a_vehicle_at_a_barcode_that_goes_is_named(where: str) -> None:
    at = Barcode("118")
    record = VehicleRecord(VehicleId("V001"), Barcode("103"), (Barcode("103"),))
    intent = Intent(CmdId(1), VehicleId("V001"), "move", IntentState.OPEN, NOW, KIM, path=(Barcode("117"), at))
    match where:
        case "barcode":
            assert told(NO_118, vehicles=(replace(record, barcode=at),)) == [("vehicle", "V001")]
        case "held":
            assert told(NO_118, vehicles=(replace(record, held=(at,)),)) == [("vehicle", "V001")]
        case _:
            assert told(NO_118, vehicles=(record,), intents=(intent,)) == [("vehicle", "V001")]
            done = replace(intent, state=IntentState.DONE)
            assert told(NO_118, vehicles=(record,), intents=(done,)) == []


def test_a_vehicle_under_way_on_track_that_goes_is_named() -> None:
    cut = replace(plant(), edges=tuple(edge for edge in plant().edges if edge.start != "104"))
    path = (Barcode("103"), Barcode("104"), Barcode("105"))
    record = VehicleRecord(VehicleId("V001"), Barcode("103"), (Barcode("103"),))
    intent = Intent(CmdId(1), VehicleId("V001"), "move", IntentState.UNKNOWN, NOW, KIM, path=path)
    assert told(cut, vehicles=(record,), intents=(intent,)) == [("vehicle", "V001")]


def test_a_port_taught_at_another_barcode_must_be_out_of_service() -> None:
    moved = plant(("at: 106", "at: 107"))
    dest = StationDest(StationId("P2"), 1, PulseSet(Pulses(1), Pulses(2), Pulses(3)), KIM, "rest", NOW)
    assert told(moved, dests=(dest,)) == [("station", "P2")]
    closed = StationRecord(StationId("P2"), out_of_service="moved")
    assert told(moved, dests=(dest,), stations=(closed,)) == []
    assert told(NO_P3, dests=(dest,)) == []


def test_a_teaching_session_and_a_closure_must_have_their_places() -> None:
    session = TeachingSession(3, StationId("P3"), VehicleId("V001"), KIM, NOW)
    assert told(NO_P3, sessions=(session,)) == [("teaching session", "3")]
    belt = Closure(
        7, ClosedPlace(PlaceKind.BARCODE, ("118",)), (Barcode("118"),), "belt", KIM, ClosurePurpose.WORK, NOW
    )
    port = replace(belt, number=8, place=ClosedPlace(PlaceKind.STATION, ("P3",)), barcodes=())
    zone = replace(belt, number=9, place=ClosedPlace(PlaceKind.ZONE, ("east-curve",)), barcodes=(Barcode("109"),))
    assert told(NO_118, closures=(belt, port, zone)) == [("closure", "7")]
    assert told(NO_P3, closures=(belt, port, zone)) == [("closure", "8")]
    assert told(replace(plant(), zones=()), closures=(belt, port, zone)) == [("closure", "9")]


def test_a_lockout_does_not_go_with_its_machine() -> None:
    hall = read((Path(__file__).parents[2] / "plants" / "hall.yaml").read_text(encoding="utf-8"), "hall")[0]
    bare = replace(hall, doors=(), drives=())
    work = Lockout(KIM, "new belt", NOW)
    locked = Kept(
        epoch=Epoch(1),
        devices=(DeviceRecord(DeviceId("DOOR1"), lockout=work), DeviceRecord(DeviceId("BUFFER1"), lockout=work)),
        drives=(DriveRecord(DriveId("AX1"), work),),
    )
    assert [one.name for one in touched(hall, bare, locked)] == ["DOOR1", "AX1"]
    free = replace(locked, devices=(DeviceRecord(DeviceId("DOOR1")),), drives=(DriveRecord(DriveId("AX1")),))
    assert touched(hall, bare, free) == []


def test_another_address_to_listen_at_needs_a_restart() -> None:
    dialling = replace(plant(), listen=("127.0.0.1", 9000))
    listening = replace(dialling, vehicles=tuple(replace(v, listen=True, port=0) for v in plant().vehicles))
    moved = replace(listening, listen=("127.0.0.1", 9001))
    assert told(dialling) == []
    assert told(listening) == [("plant", "listen")]
    assert touched(listening, listening, Kept(epoch=Epoch(1))) == []
    assert touched(listening, plant(), Kept(epoch=Epoch(1))) == []
    assert [one.name for one in touched(listening, moved, Kept(epoch=Epoch(1)))] == ["listen"]


def test_what_jobs_cannot_name_any_more_is_told_before_the_plant_comes() -> None:
    new = plant(("  P2: {", "  P7: {"))
    new = replace(new, vehicles=new.vehicles[:1])
    gone = frozenset({"P2", plant().vehicles[1].id})
    assert leaving(plant(), new, 3) == Leaving(3, gone, frozenset())
    apart = replace(plant(), edges=tuple(edge for edge in plant().edges if edge.end != plant().stations[1].barcode))
    assert plant().stations[1].id in leaving(plant(), apart, 3).cut_off
