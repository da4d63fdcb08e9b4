"""How the fleet looks to people and hosts."""

from dataclasses import replace

import pytest

from app.domain.commands import Plain
from app.domain.ids import Actor, JobId
from app.domain.records import StationRecord
from app.domain.requests import (
    CommandVehicle,
    HoldVehicle,
    LockVehicle,
    MoveVehicle,
    RecoverAlarm,
    ReleaseVehicle,
    SetService,
    Verdict,
)
from app.domain.units import Barcode
from app.domain.view import CommandView, ControllerView, EventView, JobView, StationView, Topic, VehicleView
from app.fleet.views import activity_of, view_of_station
from tests.fleet.script import UTC, V1, V2, Script, small, words

KIM = Actor("kim")


def shown(script: Script, vehicle: str = "V001") -> VehicleView:
    """Return a vehicle as people see it."""
    view = script.model[Topic.VEHICLES][vehicle]
    assert isinstance(view, VehicleView)
    return view


def test_everything_is_shown_at_the_start(script: Script) -> None:
    script.wait(0.2)
    model = script.model
    assert set(model[Topic.VEHICLES]) == {"V001", "V002"}
    assert set(model[Topic.STATIONS]) == {"P1", "P2", "P3", "B1", "B2"}
    assert set(model[Topic.CARRIERS]) == {"FOUP0001", "FOUP0002"}
    controller = model[Topic.CONTROLLER]["small"]
    assert isinstance(controller, ControllerView)
    assert (controller.state, controller.epoch, controller.started) == ("auto", 1, UTC)
    assert controller.waiting_for == ("V001", "V002")
    assert (shown(script).state, shown(script).activity, shown(script).mode) == ("removed", "absent", None)
    assert shown(script).link.reason == "not connected yet"
    assert shown(script).address == "127.0.0.1:47001" or shown(script).address.startswith("127.0.0.1:")


def test_a_listening_vehicle_shows_under_which_name_it_is_awaited() -> None:
    plant = small()
    vehicle = replace(plant.vehicles[0], listen=True)
    script = Script(replace(plant, vehicles=(vehicle,), listen=("127.0.0.1", 1)))
    script.wait(0.2)
    assert shown(script).address == "listening for DEV_ID 1"


def test_an_idle_vehicle_shows_its_place_its_words_and_all_its_bits(ready: Script) -> None:
    view = shown(ready)
    assert (view.state, view.activity, view.mode, view.oper) == ("not_assigned", "idle", "auto", "idle")
    assert (view.barcode, view.loaded, view.status1, view.status2) == ("103", False, "00111134", "CF000000")
    assert {bit.name: bit.meaning for bit in view.bits}["grip"] == "close"
    assert view.covered
    assert view.covered[0] == "103"
    assert view.seen is not None
    assert view.service == "in_service"


def test_state_and_activity_follow_a_job(ready: Script) -> None:
    ready.order("B1", "B2", vehicle=V1)
    ready.run(3)
    assert (shown(ready).state, shown(ready).activity, shown(ready).goal) == ("enroute", "moving", "B1")
    assert shown(ready).granted
    assert shown(ready).job == "J1"
    ready.run_to("acquiring")
    ready.run(1)
    assert (shown(ready).state, shown(ready).activity) == ("acquiring", "acquiring")
    ready.run_to("to_destination")
    ready.run(1.25)
    assert (shown(ready).goal, shown(ready).carrier, shown(ready).loaded) == ("B2", "FOUP0002", True)
    ready.run_to("depositing")
    ready.run(1)
    assert (shown(ready).state, shown(ready).activity) == ("depositing", "depositing")


def test_a_handling_being_settled_still_shows_as_handling(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("acquiring")
    ready.restart()
    ready.toys[V1].connect()
    ready.run(0.5)
    assert (shown(ready).state, shown(ready).activity) == ("acquiring", "settling")


def test_what_keeps_a_vehicle_from_working_is_its_activity(ready: Script) -> None:
    ready.accept(HoldVehicle(KIM, V1, "noise"))
    assert (shown(ready).activity, shown(ready).waiting) == ("held", "on hold: held by kim: noise")
    hold = shown(ready).hold
    assert hold is not None
    assert hold.remedy == "release it when it may go on"
    ready.accept(LockVehicle(KIM, V1, "belt"))
    assert shown(ready).activity == "locked_out"
    ready.accept(SetService(KIM, V2, "worn"))
    assert (shown(ready, "V002").service, shown(ready, "V002").waiting) == ("out_of_service", "out of service: worn")


def test_alarms_obstacles_and_recoveries_are_activities(ready: Script) -> None:
    ready.order("B1", "B2", vehicle=V1)
    ready.run_to("to_source")
    ready.run(2)
    ready.toys[V1].paused = True
    ready.run(1.5)
    assert shown(ready).activity == "paused"
    ready.toys[V1].paused = False
    ready.toys[V1].stop_with(0x65)
    ready.run(1.25)
    assert (shown(ready).oper, shown(ready).code, shown(ready).code_name) == ("alarm", 0x65, "wrong barcode")
    assert shown(ready).activity in {"alarm", "held"}
    ready.accept(RecoverAlarm(KIM, V1, confirmed=True))
    assert shown(ready).activity == "recovering"
    names = [e.event for e in ready.history() if e.vehicle == V1]
    assert "AlarmSet" in names


def test_a_vehicle_off_the_rail_says_who_said_so(script: Script) -> None:
    script.accept(ReleaseVehicle(KIM, V1, Verdict.OFF_RAIL, "in the workshop"))
    script.wait(0.2)
    view = shown(script)
    assert (view.state, view.activity) == ("removed", "off_rail")
    assert view.waiting == "off the rail: said by kim: in the workshop"


def test_a_vehicle_sent_by_a_person_shows_the_barcode_as_its_goal(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, Barcode("108")))
    ready.run(2)
    assert shown(ready).goal == "108"


def test_a_busy_vehicle_that_does_not_move_is_busy(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.vehicle(V1).job = JobId("J1")
    assert activity_of(ready.vehicle(V1)) == "busy"


def test_process_codes_are_named_too(ready: Script) -> None:
    ready.report(V1, "103", words(code=0x2100))
    ready.wait(0.2)
    assert shown(ready).code_name == "moving"


def test_a_vehicle_is_shown_at_most_ten_times_a_second_unless_something_is_decided(ready: Script) -> None:
    ready.wait(0.2)
    ready.forget()
    for code in range(20):
        ready.now = type(ready.now)(ready.now + 0.01)
        ready.report(V1, "103", words(code=code))
        ready.tick()
    vehicles = [u for u in ready.updates if u.topic is Topic.VEHICLES]
    assert 1 <= len(vehicles) <= 3


def test_a_vehicle_that_looks_the_same_is_not_shown_again(script: Script) -> None:
    script.stand(V1, "103")
    script.wait(1)
    script.forget()
    script.fleet.books.touch(script.vehicle(V1))
    script.wait(1)
    assert [u for u in script.updates if u.topic is Topic.VEHICLES] == []


def test_a_job_is_shown_until_it_ends_and_its_events_are_numbered(ready: Script) -> None:
    job = ready.order(vehicle=V1)
    ready.run(2)
    view = ready.model[Topic.JOBS]["J1"]
    assert isinstance(view, JobView)
    assert (view.id, view.vehicle, view.wish, view.created) == ("J1", "V001", "V001", job.created)
    ready.run_until("J1")
    assert "J1" not in ready.model[Topic.JOBS]
    events = [view for view in ready.model[Topic.EVENTS].values() if isinstance(view, EventView)]
    assert [event.seq for event in events] == list(range(1, len(events) + 1))
    assert events[-1].ceid == 107


def test_an_open_command_is_shown(ready: Script) -> None:
    ready.accept(CommandVehicle(KIM, V1, Plain.STOP))
    (view,) = ready.model[Topic.COMMANDS].values()
    assert isinstance(view, CommandView)
    assert (view.kind, view.state, view.actor, len(view.cmd_id)) == ("stop", "open", "kim", 16)


@pytest.mark.parametrize(("station", "target", "version"), [("P1", (1200, -300, 41000), 1), ("B1", None, None)])
def test_a_station_shows_its_dest(
    script: Script, station: str, target: tuple[int, int, int] | None, version: int | None
) -> None:
    view = script.model[Topic.STATIONS][station]
    assert isinstance(view, StationView)
    assert (view.target, view.target_version, view.provenance, view.verified) == (target, version, "plant", False)


def test_a_station_that_nobody_ever_said_anything_of_has_no_moment_of_knowing(script: Script) -> None:
    spec = next(station for station in script.plant.stations if station.id == "P1")
    view = view_of_station(spec, StationRecord(spec.id), None)
    assert (view.present, view.at) == (None, None)
    assert (view.target, view.missing) == (None, ("shft", "rota", "lift"))


def test_a_side_buffer_lacks_no_pulses(script: Script) -> None:
    spec = next(station for station in script.plant.stations if station.id == "B1")
    assert view_of_station(spec, StationRecord(spec.id), None).missing == ()
