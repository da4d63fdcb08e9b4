"""Which vehicle does which job, and when (DOMAIN section 6)."""

from dataclasses import replace

import pytest

from app.domain.commands import Move
from app.domain.ids import CarrierId, JobId, VehicleId
from app.domain.job import Job, JobState
from app.domain.layout import PulseSet
from app.domain.requests import (
    AbortJob,
    CancelJob,
    HoldVehicle,
    LockVehicle,
    MoveVehicle,
    ReleaseVehicle,
    Verdict,
    WriteDest,
)
from app.domain.units import Barcode, Pulses
from app.planning.dispatch import RULES
from tests.fleet.script import B1, B2, FOUP1, FOUP2, HOST, P1, P2, P3, V1, V2, Script, small

J1, J2 = JobId("J1"), JobId("J2")
FAR = PulseSet(Pulses(1_000_000), Pulses(0), Pulses(0))


@pytest.fixture
def alone() -> Script:
    """The small plant with V001 only, idle at 103."""
    plant = small()
    script = Script(replace(plant, vehicles=plant.vehicles[:1]))
    script.world.update({P1: FOUP1, B1: FOUP2})
    return script.obey()


def assigned(script: Script) -> list[tuple[str | None, str | None]]:
    """Return who was assigned to what, in order."""
    return [(e.vehicle, e.job) for e in script.history() if e.event == "VehicleAssigned"]


def test_the_nearest_vehicle_is_sent(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run(1)
    assert ready.job("J1").vehicle == V1
    ready.order("B1", "B2", job="J2")
    ready.run(1)
    assert ready.job("J2").vehicle == V2


def test_one_assignment_is_made_over_all_vehicles_and_jobs(ready: Script) -> None:
    """V001 at 108 is behind P1 and before B1: whichever job comes first, it must be V002 that goes to P1."""
    ready.accept(MoveVehicle(HOST, V1, Barcode("108")))
    ready.run(10)
    ready.order("P1", "P3", job="J1")
    ready.order("B1", "B2", job="J2")
    ready.run(1)
    assert (ready.job("J1").vehicle, ready.job("J2").vehicle) == (V2, V1)


def test_the_candidates_and_their_ways_are_kept_with_the_assignment(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run(1)
    event = next(e for e in ready.history() if e.event == "VehicleAssigned")
    assert event.detail == "to the source: V001 0 s, V002 5 s"


def test_the_wished_vehicle_is_waited_for(ready: Script) -> None:
    ready.order("P1", "P3", job="J1", vehicle=V2)
    ready.order("B1", "B2", job="J2", vehicle=V2)
    ready.run(2)
    assert ready.job("J2").reason == "no vehicle is free: V002 is asked for, and is on job J1"
    ready.run_until("J1", "J2", at_most=600)
    assert {v for v, _ in assigned(ready)} == {V2}


def test_a_job_without_a_free_vehicle_says_so(ready: Script) -> None:
    ready.accept(HoldVehicle(HOST, V1, "x"))
    ready.accept(HoldVehicle(HOST, V2, "x"))
    ready.order()
    ready.run(2)
    assert ready.job("J1").reason == "no vehicle is free"


def test_more_urgent_jobs_come_first_then_older_ones(alone: Script) -> None:
    ready = alone
    ready.world[P2] = CarrierId("LOT7")
    ready.order("P1", "P3", job="A", priority=40)
    ready.order("B1", "B2", job="B", priority=60)
    ready.order("P2", "P3", job="C", priority=50)
    ready.run(400)
    ends = [e.job for e in ready.history() if e.event == "TransferCompleted"]
    assert ends[0] == "B"
    assert ends[1] == "C"
    assert ready.job("A").reason == "P3 is occupied by a carrier"


def test_a_hot_lot_takes_a_vehicle_that_has_not_picked_up_yet(alone: Script) -> None:
    ready = alone
    ready.order("B1", "P2", job="J1")
    ready.run_to("to_source")
    ready.run(2)
    ready.order("P1", "P3", job="J2", priority=90)
    ready.run(2)
    assert ready.job("J2").vehicle == V1
    assert ready.job("J1").state is JobState.QUEUED
    ready.run_until("J1", "J2", at_most=600)
    assert [e.job for e in ready.history() if e.event == "TransferCompleted"] == ["J2", "J1"]


def test_a_vehicle_with_its_carrier_aboard_is_not_taken_away(alone: Script) -> None:
    ready = alone
    ready.order("P1", "P3", job="J1")
    ready.run_to("acquiring")
    ready.order("B1", "B2", job="J2", priority=99)
    ready.run(30)
    assert next(e.job for e in ready.history() if e.event == "TransferCompleted") == "J1"


def test_a_vehicle_that_becomes_free_nearer_by_more_than_a_switch_costs_takes_a_job_over(
    ready: Script, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.fleet.dispatch.RULES", replace(RULES, switch=0.1))
    ready.world[B2] = CarrierId("LOT7")
    ready.accept(MoveVehicle(HOST, V1, Barcode("112")))
    ready.order("B2", "P3", job="J1")
    ready.run(3)
    assert ready.job("J1").vehicle == V2
    ready.run(9)
    assert ready.job("J1").vehicle == V1
    assert ready.events("J1").count("VehicleAssigned") == 2
    assert ready.events("J1").count("TransferInitiated") == 1
    assert "VehicleUnassigned" in ready.events("J1")
    ready.run_until("J1")


def test_a_gain_smaller_than_a_switch_changes_nothing(ready: Script) -> None:
    ready.accept(HoldVehicle(HOST, V1, "x"))
    ready.order("P1", "P3", job="J1")
    ready.run_to("to_source")
    ready.accept(ReleaseVehicle(HOST, V1, Verdict.GO_ON, "fine"))
    ready.run(3)
    assert ready.job("J1").vehicle == V2


def test_nobody_starves_within_a_class(alone: Script) -> None:
    """A far job waits while near ones keep coming; its age brings its turn."""
    ready = alone
    ready.order("B1", "B2", job="FAR")
    here, there = P1, P3
    for number in range(12):
        if JobId("FAR") not in ready.fleet.books.jobs:
            break
        ready.order(here, there, job=f"N{number}")
        here, there = there, here
        ready.run_until(f"N{number}", at_most=900)
    ready.run_until("FAR", at_most=600)
    assert number < 11
    assert ready.job("FAR").state is JobState.COMPLETED


def test_a_loaded_vehicle_gets_no_other_job(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.order("B1", "B2", job="J2", vehicle=V1)
    ready.run(2)
    assert ready.job("J2").vehicle is None


def test_a_loaded_vehicle_without_a_job_is_not_sent_to_fetch(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, J1))
    ready.order("B1", "B2", job="J2", vehicle=V1)
    ready.run(2)
    assert ready.job("J2").reason == "no vehicle is free: V001 is asked for, and is loaded"


def test_a_hopeless_job_keeps_no_station_from_others(ready: Script) -> None:
    ready.accept(LockVehicle(HOST, V2, "x"))
    ready.order("P1", "P3", job="J1", vehicle=V2)
    ready.order("P1", "P3", job="J2")
    ready.run_until("J2")
    assert ready.job("J1").state is JobState.QUEUED
    assert ready.job("J2").state is JobState.COMPLETED


def test_a_job_beyond_the_axes_of_every_vehicle_says_so(ready: Script) -> None:
    ready.accept(WriteDest(HOST, P3, FAR))
    ready.order()
    ready.run(2)
    assert ready.job("J1").reason == "no vehicle can serve both stations: see their DEST, OFFSET and limits"


def test_vehicles_are_sent_only_once_they_are_settled(script: Script) -> None:
    script.order()
    script.run(3)
    assert script.sends == []
    script.obey()
    assert script.job("J1").vehicle


def test_a_reason_is_saved_once_and_not_again_each_second(ready: Script) -> None:
    ready.accept(HoldVehicle(HOST, V1, "x"))
    ready.accept(HoldVehicle(HOST, V2, "x"))
    ready.order()
    ready.run(30)
    assert len(ready.kept(Job)) == 2


def test_a_cancelled_job_frees_its_vehicle_for_the_next_at_once(ready: Script) -> None:
    ready.order("B1", "B2", job="J1", vehicle=V1)
    ready.run_to("to_source")
    ready.run(3)
    ready.accept(CancelJob(HOST, J1))
    ready.order("B1", "P3", job="J2", vehicle=V1)
    ready.run_until("J2")
    assert ready.world == {P1: FOUP1, P3: FOUP2}
    moves = [s for s in ready.sends if isinstance(s.command, Move)]
    assert moves
    assert B1 not in ready.world
    assert B2 not in ready.world


def test_a_wish_for_a_vehicle_that_left_the_plant_waits(ready: Script) -> None:
    ready.order(vehicle=V2)
    ready.restart(plant=replace(ready.plant, vehicles=ready.plant.vehicles[:1]))
    ready.toys.pop(VehicleId("V002"))
    ready.obey(V1)
    ready.run(3)
    assert ready.job("J1").reason == "no vehicle can serve both stations: see their DEST, OFFSET and limits"
