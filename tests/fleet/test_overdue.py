"""A job that waits for what no driving puts right becomes an alarm after a while."""

from dataclasses import replace

import pytest

from app.domain.alarms import AlarmKind
from app.domain.ids import CarrierId, JobId
from app.domain.requests import CancelJob, HoldVehicle, WriteStation
from app.domain.units import Seconds
from tests.fleet.script import FOUP1, HOST, P1, P3, V1, V2, Script, small

J1 = JobId("J1")
OTHER = CarrierId("OTHER")


def overdue(script: Script) -> list[str]:
    """Return the causes of the alarms about jobs that there are now."""
    return [alarm.cause for alarm in script.fleet.books.alarms.live.values() if alarm.kind is AlarmKind.JOB]


def told(script: Script) -> list[tuple[str, str | None]]:
    return [(e.event, e.job) for e in script.history() if e.event in {"AlarmSet", "AlarmCleared"}]


@pytest.fixture
def wrong(ready: Script) -> Script:
    """J1 wants OTHER from P1, which holds FOUP1."""
    ready.accept(WriteStation(HOST, P1, present=True, carrier=FOUP1))
    ready.order("P1", "P3", carrier=OTHER)
    return ready


def test_a_job_for_another_carrier_than_stands_there_is_an_alarm_after_ten_minutes(wrong: Script) -> None:
    wrong.run(590)
    assert overdue(wrong) == []
    wrong.run(20)
    assert overdue(wrong) == [f"J1 waits for long: {P1} holds {FOUP1}, not OTHER"]
    assert told(wrong) == [("AlarmSet", J1)]


def test_it_ends_when_the_right_carrier_stands_there(wrong: Script) -> None:
    wrong.run(610)
    wrong.world[P1] = OTHER
    wrong.accept(WriteStation(HOST, P1, present=True, carrier=OTHER))
    wrong.run(5)
    assert overdue(wrong) == []
    assert told(wrong) == [("AlarmSet", J1), ("AlarmCleared", J1)]


def test_it_ends_with_the_job(wrong: Script) -> None:
    wrong.run(610)
    wrong.accept(CancelJob(HOST, J1))
    wrong.run(5)
    assert overdue(wrong) == []
    assert told(wrong) == [("AlarmSet", J1), ("AlarmCleared", J1)]


def test_waiting_for_a_vehicle_is_none(ready: Script) -> None:
    for vehicle in (V1, V2):
        ready.accept(HoldVehicle(HOST, vehicle, "lunch"))
    ready.order("P1", "P3")
    ready.run(700)
    assert ready.job("J1").vehicle is None
    assert overdue(ready) == []


def test_a_plant_says_how_long_or_never() -> None:
    for seconds, expected in ((30.0, 1), (0.0, 0)):
        script = Script(replace(small(), overdue=Seconds(seconds))).obey()
        script.accept(WriteStation(HOST, P3, out_of_service="being painted"))
        script.order("P1", "P3")
        script.run(700)
        assert len(overdue(script)) == expected
