"""A vehicle is sent before the carrier is there, or kept for one that is soon free (DOMAIN sections 2 and 6)."""

from dataclasses import replace

import pytest

from app.domain.ids import CarrierId
from app.domain.job import JobState, Leg
from app.domain.requests import AbortJob
from app.domain.units import Seconds
from app.planning.dispatch import RULES
from tests.fleet.script import B1, B2, HOST, P3, V1, V2, Script


def ordered_ahead(ready: Script) -> Script:
    """J1 takes a carrier from P1 to P3 on V001; J2 was ordered ahead and takes it on from P3 to P2."""
    ready.order("P1", "P3", job="J1", vehicle=V1)
    ready.order("P3", "P2", job="J2", vehicle=V2)
    return ready


def test_a_vehicle_sets_out_to_where_a_carrier_is_being_brought(ready: Script) -> None:
    ordered_ahead(ready)
    ready.run_to("to_destination")
    ready.run(1)
    while ready.job("J1").state is not JobState.COMPLETED:
        ready.run(0.25)
        if ready.job("J2").vehicle == V2:
            break
    assert ready.job("J1").state is not JobState.COMPLETED, "it was sent only when the carrier was there"
    assert ready.job("J2").leg is Leg.TO_SOURCE
    ready.run_until("J1", "J2", at_most=600)
    assert ready.job("J2").state is JobState.COMPLETED
    assert ready.events("J2").count("VehicleAssigned") == 1


def test_until_then_the_job_says_who_brings_its_carrier(ready: Script) -> None:
    ordered_ahead(ready)
    ready.run(2)
    assert ready.job("J2").reason == "J1 brings a carrier to P3 first"
    assert ready.job("J2").vehicle is None


def test_a_vehicle_that_is_there_too_early_lets_the_one_that_brings_the_carrier_pass(ready: Script) -> None:
    """V002 stands before P3 with nothing to fetch yet; V001 with the carrier comes up behind it on the only way."""
    ordered_ahead(ready)
    ready.run_to("to_destination")
    while ready.job("J2").vehicle is None:
        ready.run(0.25)
    ready.toys[V1].paused = True
    ready.run(40)
    ready.toys[V1].paused = False
    ready.run_until("J1", "J2", at_most=900)
    assert ready.world.keys() >= {B1}
    assert {ready.job("J1").state, ready.job("J2").state} == {JobState.COMPLETED}


def test_a_staged_vehicle_is_free_again_where_the_carrier_is_not_coming(ready: Script) -> None:
    ordered_ahead(ready)
    ready.run_to("to_destination")
    while ready.job("J2").vehicle is None:
        ready.run(0.25)
    ready.fleet.books.save_station(replace(ready.station(P3), present=False))
    ready.accept(AbortJob(HOST, ready.job("J1").id))
    ready.run(2)
    assert ready.job("J2").state is JobState.QUEUED
    assert ready.job("J2").vehicle is None
    assert ready.vehicle(V2).job is None


def test_a_job_is_kept_for_a_vehicle_that_is_nearly_free_beside_it(
    ready: Script, monkeypatch: pytest.MonkeyPatch
) -> None:
    """V001 puts down at P3, one barcode before B2; V002 has gone on, and would have to come all the way round."""
    monkeypatch.setattr("app.fleet.prospects.HANDLING", Seconds(2.0))
    monkeypatch.setattr("app.fleet.dispatch.RULES", replace(RULES, unsure=0.0))
    ready.world[B2] = CarrierId("LOT7")
    ready.order("P1", "P3", job="J1", vehicle=V1)
    ready.run_to("depositing")
    ready.order("B2", "P1", job="J2")
    ready.run(0.5)
    assert ready.vehicle(V2).available
    assert ready.job("J2").reason == "it waits for V001, which will soon be free nearby"
    ready.run_until("J1", "J2", at_most=600)
    assert ready.job("J2").vehicle == V1
    assert ready.events("J2").count("VehicleAssigned") == 1
