"""Alarms as history: each begins once, is kept, and ends once; who has seen it is kept with it (DOMAIN section 8)."""

import pytest

from app.domain.alarms import AcknowledgeAlarm, Alarm, AlarmKind, reliability
from app.domain.device_requests import RaiseEmergency, ReleaseEmergency
from app.domain.devices import DeviceBack, DeviceStale
from app.domain.ids import Actor
from app.domain.records import EmergencyKind
from app.domain.requests import HoldVehicle, ReleaseVehicle, Verdict
from app.domain.view import AlarmView, Topic
from tests.fleet.drives import KIM
from tests.fleet.hall_plants import DOOR1, ring
from tests.fleet.script import V1, V2, Script

LEE = Actor("lee")


def active(script: Script) -> list[AlarmView]:
    """Return the alarms of machines: who stands in a ring cuts its stations off besides (test_cutoff)."""
    views = script.model[Topic.ALARMS].values()
    return [view for view in views if isinstance(view, AlarmView) and view.kind != AlarmKind.TRAFFIC]


def kept(script: Script) -> list[Alarm]:
    return [alarm for alarm in script.kept(Alarm) if alarm.kind is not AlarmKind.TRAFFIC]


def last(script: Script) -> Alarm:
    return kept(script)[-1]


def test_an_alarm_of_a_vehicle_begins_with_its_code_and_ends_when_it_is_gone(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run(3)
    ready.toys[V1].stop_with(101)
    ready.run(3)
    (view,) = active(ready)
    assert (view.kind, view.source, view.code, view.job) == ("vehicle", "V001", "101", "J1")
    assert view.cause == "alarm 101 wrong barcode"
    assert view.remedy == "clear the cause, then POST /api/v1/vehicles/V001/recover"
    ready.run(20)
    assert len({row.number for row in kept(ready)}) == 1
    ready.toys[V1].alarm = 0
    ready.run(5)
    assert active(ready) == []
    assert (last(ready).ended is not None, last(ready).outcome) == (True, "it reports no alarm any more")


def test_another_code_is_another_alarm(ready: Script) -> None:
    ready.toys[V1].stop_with(101)
    ready.run(3)
    ready.toys[V1].alarm = 202
    ready.run(3)
    assert [view.code for view in active(ready)] == ["202"]
    ended = [row for row in kept(ready) if row.ended is not None]
    assert [(row.code, row.outcome) for row in ended] == [("101", "another one has begun")]


def test_an_alarm_outlives_a_restart_as_the_same_one_and_ends_if_it_is_over_by_then(ready: Script) -> None:
    ready.toys[V1].stop_with(101)
    ready.toys[V2].stop_with(202)
    ready.run(3)
    before = [view.id for view in active(ready)]
    ready.restart()
    ready.toys[V2].alarm = 0
    ready.obey()
    ready.run(3)
    assert [view.id for view in active(ready)] == before[:1]


def test_a_line_that_is_back_soon_is_no_alarm_and_one_that_stays_away_is(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.wait(8)
    ready.toys[V1].connect()
    ready.run(5)
    assert kept(ready) == []
    ready.toys[V1].cut()
    ready.wait(12)
    (view,) = active(ready)
    assert (view.kind, view.source, view.cause) == ("link", "V001", "not connected: line cut")
    ready.toys[V1].connect()
    ready.run(5)
    assert last(ready).outcome == "it is connected again"


def test_a_vehicle_said_to_be_off_the_rail_is_an_alarm_no_more(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.wait(12)
    ready.accept(ReleaseVehicle(KIM, V1, Verdict.OFF_RAIL, "taken away"))
    ready.wait(20)
    assert active(ready) == []


def test_a_hold_for_a_doubt_is_an_alarm_and_one_by_a_person_is_none(ready: Script) -> None:
    ready.accept(HoldVehicle(KIM, V1, "look at it"))
    assert active(ready) == []
    ready.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "fine"))
    ready.run(5)
    ready.fleet.recovery.hold(ready.vehicle(V1), "it is not where it can be", "look")
    ready.wait(1)
    (view,) = active(ready)
    assert (view.kind, view.code, view.cause, view.remedy) == ("hold", "held", "it is not where it can be", "look")
    ready.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "seen"))
    assert (active(ready), last(ready).outcome) == ([], "released")


def test_a_door_in_error_and_a_fire_are_alarms() -> None:
    script = Script(ring())
    script.obey()
    script.accept(RaiseEmergency(KIM, EmergencyKind.FIRE, "smoke"))
    assert [(view.kind, view.code) for view in active(script)] == [("plant", "fire")]
    script.accept(ReleaseEmergency(LEE, EmergencyKind.FIRE, "toast"))
    assert last(script).outcome == "fire is over: toast (lee)"
    script.hear_device(DeviceStale(DOOR1, "cut"))
    script.wait(12)
    assert [(view.kind, view.source, view.code) for view in active(script)] == [("device", "DOOR1", "is silent")]
    script.hear_device(DeviceBack(DOOR1))
    script.wait(1)
    assert active(script) == []


def test_who_first_acknowledges_is_kept_whether_it_has_ended_or_not(ready: Script) -> None:
    ready.toys[V1].stop_with(101)
    ready.run(3)
    (view,) = active(ready)
    ready.accept(AcknowledgeAlarm(KIM, view.id, "a wheel"))
    ready.accept(AcknowledgeAlarm(LEE, view.id, "me too"))
    (seen,) = active(ready)
    assert (seen.acknowledged_by, seen.note) == ("kim", "a wheel")
    ready.toys[V1].alarm = 0
    ready.run(5)
    assert (last(ready).acknowledged_by, last(ready).ended is not None) == ("kim", True)
    ready.toys[V2].stop_with(101)
    ready.run(3)
    number = active(ready)[0].id
    ready.toys[V2].alarm = 0
    ready.run(5)
    ready.accept(AcknowledgeAlarm(LEE, number))
    assert (last(ready).number, last(ready).acknowledged_by) == (number, "lee")
    assert last(ready).ended is not None
    ready.restart()
    old = last(ready)
    ready.accept(AcknowledgeAlarm(LEE, number, known=old))
    assert ready.refuse(AcknowledgeAlarm(LEE, 99)).code == "not-found"


@pytest.mark.parametrize(
    ("spans", "failures", "down"),
    [
        ([], 0, 0.0),
        ([(10.0, 20.0)], 1, 10.0),
        ([(10.0, 30.0), (20.0, 40.0)], 1, 30.0),
        ([(10.0, 40.0), (20.0, 30.0), (50.0, 60.0)], 2, 40.0),
        ([(-50.0, 10.0), (90.0, None)], 2, 20.0),
    ],
)
def test_failures_that_overlap_are_one(spans: list[tuple[float, float | None]], failures: int, down: float) -> None:
    found = reliability(spans, 0.0, 100.0)
    assert (found.failures, found.down) == (failures, down)
    assert found.to_repair == (down / failures if failures else None)
    assert found.between == ((100.0 - down) / failures if failures else None)


def test_who_is_refused_once_is_no_alarm(ready: Script) -> None:
    ready.fleet.watch.refused("10.0.0.9 claims to be V001, which is connected already")
    ready.run(3)
    assert active(ready) == []


def test_who_is_refused_again_is_an_alarm_until_it_gives_up(ready: Script) -> None:
    for _ in range(3):
        ready.fleet.watch.refused("10.0.0.9 claims to be V001, which is connected already")
        ready.run(60)
    (view,) = active(ready)
    assert (view.kind, view.source, view.code) == ("plant", "small", "stranger")
    assert "10.0.0.9 claims to be V001" in view.cause
    assert "intruder" in view.remedy
    ready.run(120)
    assert active(ready) == []
    assert last(ready).outcome == "nobody has been refused for a while"


def test_two_who_are_refused_once_each_are_no_alarm_and_one_from_long_ago_does_not_count(ready: Script) -> None:
    ready.fleet.watch.refused("10.0.0.8 is not the address of any vehicle that may dial in")
    ready.fleet.watch.refused("10.0.0.9 is not the address of any vehicle that may dial in")
    ready.run(200)
    ready.fleet.watch.refused("10.0.0.9 is not the address of any vehicle that may dial in")
    ready.run(3)
    assert active(ready) == []


def test_a_start_forgets_who_was_refused_before_it(ready: Script) -> None:
    for _ in range(2):
        ready.fleet.watch.refused("10.0.0.9 claims to be V001, which is connected already")
        ready.run(60)
    ready.restart()
    ready.run(3)
    assert active(ready) == []
