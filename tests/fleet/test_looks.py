"""Who is looked at again though nothing is heard of it, and who is not."""

from app.domain.ids import DevId, JobId, VehicleId
from app.domain.layout import VehicleSpec
from app.domain.records import VehicleRecord
from app.domain.units import Seconds
from app.fleet.looks import LOOK_EVERY, Looks
from app.fleet.vehicle import VehicleNow

V1 = VehicleId("V001")


def vehicle() -> VehicleNow:
    return VehicleNow(VehicleSpec(V1, DevId(1), "127.0.0.1", 20001), VehicleRecord(V1))


def test_a_vehicle_without_anything_to_do_costs_no_look() -> None:
    looks = Looks()
    looks.mind(vehicle(), Seconds(0.0))
    assert looks.deadline == float("inf")
    assert looks.due(Seconds(100.0)) == []


def test_one_with_a_job_is_looked_at_once_a_while_has_passed() -> None:
    looks, one = Looks(), vehicle()
    one.job = JobId("J1")
    looks.mind(one, Seconds(0.0))
    assert looks.due(Seconds(LOOK_EVERY - 0.1)) == []
    assert looks.due(LOOK_EVERY) == [V1]
    assert looks.due(Seconds(9.0)) == []


def test_what_it_reports_does_not_put_its_look_off_but_a_look_does() -> None:
    looks, one = Looks(), vehicle()
    one.job = JobId("J1")
    looks.mind(one, Seconds(0.0))
    looks.mind(one, Seconds(0.9))
    assert looks.due(LOOK_EVERY) == [V1]
    looks.mind(one, LOOK_EVERY)
    looks.looked(one, Seconds(1.5))
    assert looks.due(Seconds(2.0)) == []
    assert looks.due(Seconds(2.5)) == [V1]


def test_one_whose_job_ends_before_is_not_looked_at() -> None:
    looks, one = Looks(), vehicle()
    one.job = JobId("J1")
    looks.mind(one, Seconds(0.0))
    one.job = None
    looks.mind(one, Seconds(0.5))
    assert looks.due(Seconds(5.0)) == []
