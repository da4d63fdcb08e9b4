"""A vehicle on its job: what stops it, what it does then, and how it goes on."""

from dataclasses import replace

import pytest

from app.domain.commands import Move, Pickup, Place
from app.domain.errors import NoRoute
from app.domain.ids import Actor, CarrierId, JobId, StationId
from app.domain.job import JobState
from app.domain.layout import PulseSet, StopAction
from app.domain.records import ControllerState, IntentState, Provenance
from app.domain.requests import (
    AbortJob,
    Accepted,
    CancelJob,
    ChangeJob,
    HoldVehicle,
    LockVehicle,
    MoveVehicle,
    PauseController,
    ReleaseVehicle,
    Request,
    ResumeController,
    SetService,
    UnlockVehicle,
    Verdict,
    WriteDest,
    WriteStation,
)
from app.domain.units import Barcode, Pulses
from app.domain.view import Topic, VehicleView
from app.fleet.obstacles import PLACED_COUNTS_FOR
from tests.fleet.script import B1, B2, FOUP1, FOUP2, HOST, P1, P2, P3, V1, V2, Script, small, transfer, words

J1 = JobId("J1")
KIM = Actor("kim")
FAR = PulseSet(Pulses(1_000_000), Pulses(0), Pulses(0))


def go_on(script: Script) -> None:
    """Let a named person release V001."""
    script.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "looked at it"))


# -- destinations that cannot be used ---------------------------------------------------------------------------------


def test_a_loaded_vehicle_waits_for_an_occupied_destination_and_says_so(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(WriteStation(HOST, P3, present=True))
    ready.run(15)
    assert ready.job("J1").reason == "its destination cannot be used: P3 is occupied by a carrier"
    assert not [s for s in ready.sends if isinstance(s.command, Place)]
    ready.accept(WriteStation(HOST, P3, present=False))
    ready.run_until("J1")
    assert ready.world[P3] == FOUP1


@pytest.mark.parametrize(
    ("written", "words"),
    [
        ({"out_of_service": "broken"}, "P2 is out of service: broken"),
        ({"reserved": "another host"}, "P2 is reserved: another host"),
        ({"present": True}, "P2 is occupied by a carrier"),
    ],
)
def test_a_loaded_vehicle_goes_on_to_the_fall_back_of_the_job(
    ready: Script, written: dict[str, object], words: str
) -> None:
    ready.order("P1", "P2", fallbacks=(B2,), vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(replace(WriteStation(HOST, P2), **written))  # type: ignore[arg-type]
    ready.run_until("J1")
    assert ready.world[B2] == FOUP1
    updated = next(e for e in ready.history("J1") if e.event == "TransferUpdated")
    assert updated.detail == f"{words}; going on to the fall-back B2"
    assert ready.job("J1").destination == B2


def test_the_fall_backs_of_the_plant_serve_after_those_of_the_job(ready: Script) -> None:
    del ready.world[B1]
    ready.accept(WriteStation(HOST, B1, present=False))
    ready.order("P1", "P2", fallbacks=(StationId("B1"),), vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(WriteStation(HOST, P2, present=True))
    ready.run_until("J1")
    assert ready.world[B1] == FOUP1


def test_a_fall_back_that_is_full_engaged_or_out_of_reach_for_the_axes_is_passed_over(ready: Script) -> None:
    ready.order("B1", "B2", job="J2", vehicle=V2)
    ready.order("P1", "P2", fallbacks=(P1, B2, StationId("B1"), P3), vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(WriteStation(HOST, P1, out_of_service="x"))
    ready.accept(WriteStation(HOST, P2, present=True))
    ready.run_until("J1", "J2")
    assert ready.world[P3] == FOUP1
    assert ready.world[B2] == FOUP2


def test_a_fall_back_whose_pulses_are_out_of_limits_is_passed_over(ready: Script) -> None:
    ready.order("P1", "P2", fallbacks=(P3, B2), vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(WriteDest(HOST, P3, FAR))
    ready.accept(WriteStation(HOST, P2, present=True))
    ready.run_until("J1")
    assert ready.world[B2] == FOUP1


def test_a_job_with_a_free_fall_back_begins_although_its_destination_is_full(ready: Script) -> None:
    ready.order("P1", "B1", fallbacks=(B2,))
    ready.run_until("J1")
    assert ready.world == {B1: FOUP2, B2: FOUP1}


def test_a_destination_that_was_only_ever_filled_by_us_counts_as_unknown_after_an_hour(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_until("J1")
    del ready.world[P3]
    ready.order("B1", "P3", job="J2", vehicle=V1)
    ready.run(2)
    assert ready.job("J2").reason == "P3 is occupied by FOUP0001"
    for toy in ready.toys.values():
        toy.cut()
    ready.wait(PLACED_COUNTS_FOR, step=60)
    ready.obey()
    ready.run_until("J2")
    assert ready.world[P3] == FOUP2
    assert ready.fleet.books.carriers[FOUP1].place is None


# -- sources that cannot be used --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("written", "words"),
    [({"out_of_service": "cleaning"}, "P1 is out of service: cleaning"), ({"present": False}, "P1 is empty")],
)
def test_a_job_whose_source_is_closed_or_emptied_on_the_way_goes_back_into_the_queue(
    ready: Script, written: dict[str, object], words: str
) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.accept(replace(WriteStation(HOST, P1), **written))  # type: ignore[arg-type]
    ready.run(3)
    job = ready.job("J1")
    assert (job.state, job.vehicle, job.reason) == (JobState.QUEUED, None, words)
    assert ready.events("J1")[-1] == "VehicleUnassigned"
    assert not [s for s in ready.sends if isinstance(s.command, Pickup)]


def test_a_source_whose_pulses_no_vehicle_may_be_sent_is_not_fetched_from(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.accept(WriteDest(HOST, P1, FAR))
    ready.run(8)
    assert ready.job("J1").state is JobState.QUEUED
    assert not [s for s in ready.sends if isinstance(s.command, Pickup)]
    why = "SHFT 1000010 for P1 is outside -20000..20000 of V001"
    assert ready.job("J1").reason == f"no vehicle is free: V001 is asked for, and cannot serve P1: {why}"
    ready.order("P1", "B2", job="J2")
    ready.run(2)
    assert "DEST, OFFSET and limits" in ready.job("J2").reason


def test_a_destination_whose_pulses_the_vehicle_may_not_be_sent_is_waited_for_without_noise(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(WriteDest(HOST, P3, FAR))
    ready.run(40)
    assert ready.job("J1").reason == ("V001 cannot put down: SHFT 1000010 for P3 is outside -20000..20000 of V001")
    assert ready.events("J1").count("VehicleArrived") == 1
    ready.accept(WriteDest(HOST, P3, PulseSet(Pulses(1), Pulses(2), Pulses(3))))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_a_vehicle_without_offset_is_not_given_a_job_at_a_port() -> None:
    plant = small()
    script = Script(replace(plant, vehicles=(replace(plant.vehicles[0], offset=None), plant.vehicles[1])))
    script.world.update({P1: FOUP1, B1: FOUP2})
    script.obey()
    script.order("P1", "P2", job="A")
    script.order("B1", "B2", job="B", vehicle=V1)
    script.run_until("A", "B")
    assert (script.job("A").vehicle, script.job("B").vehicle) == (V2, V1)
    assert script.refuse(transfer("P1", "P2", job="C", vehicle=V1)).reason == "V001 has no OFFSET (SHFT, ROTA, LIFT)"


# -- handling that goes wrong -----------------------------------------------------------------------------------------


def test_a_pick_up_that_ends_abnormally_without_alarm_is_tried_three_times(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.toys[V1].reject_handling = True
    ready.run_until("J1")
    assert len([s for s in ready.sends if isinstance(s.command, Pickup)]) == 3
    job = ready.job("J1")
    assert (job.state, job.result) == (JobState.FAILED, "PICKUP refused by the vehicle")
    assert ready.history("J1")[-1].result == "failed"
    assert ready.station(P1).present is None
    assert ready.vehicle(V1).available


def test_a_pick_up_that_is_refused_once_is_tried_again_and_succeeds(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("acquiring")
    ready.toys[V1].handling = None
    ready.answer(ready.last(Pickup), "104", ok=False)
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED
    assert ready.events("J1").count("CarrierInstalled") == 1


def test_a_fetch_that_was_tried_before_and_finds_its_source_closed_fails(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("acquiring")
    ready.toys[V1].handling = None
    ready.accept(WriteStation(HOST, P1, out_of_service="closed"))
    ready.answer(ready.last(Pickup), "104", ok=False)
    ready.run_until("J1")
    assert ready.job("J1").result == "P1 is out of service: closed"


def test_a_pick_up_where_nothing_is_fails_the_job_with_the_alarm_once_it_is_recovered(ready: Script) -> None:
    del ready.world[P1]
    ready.order(vehicle=V1)
    ready.run_to("acquiring")
    ready.run(20)
    job = ready.job("J1")
    assert (job.state, job.reason) == (JobState.PAUSED, "V001 cannot go on: on hold: alarm 201 no carrier found")
    ready.toys[V1].alarm = 0
    ready.run(2)
    go_on(ready)
    ready.run_until("J1")
    assert ready.job("J1").result == "alarm 201 no carrier found"
    assert ready.station(P1).present is None


def test_an_alarm_on_the_way_does_not_fail_a_later_pick_up(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.toys[V1].stop_with(101)
    ready.run(14)
    assert ready.job("J1").state is JobState.QUEUED
    ready.toys[V1].alarm = 0
    ready.run(2)
    go_on(ready)
    ready.run_to("acquiring")
    ready.toys[V1].handling = None
    ready.answer(ready.last(Pickup), "104", ok=False)
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_a_put_down_that_is_refused_three_times_holds_the_vehicle_until_the_destination_is_changed(
    ready: Script,
) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.toys[V1].reject_handling = True
    ready.run(60)
    hold = ready.vehicle(V1).record.hold
    assert hold is not None
    assert hold.reason == "PLACE at P3 was refused 3 times"
    assert ready.job("J1").state is JobState.PAUSED
    ready.toys[V1].reject_handling = False
    go_on(ready)
    ready.run(5)
    ready.accept(ChangeJob(HOST, J1, destination=B2)) if ready.job("J1").leg.value != "depositing" else None
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_result_0_without_the_foup_bit_is_an_alarm_of_ours(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.toys[V1].misgrip = True
    ready.run(15)
    hold = ready.vehicle(V1).record.hold
    assert hold is not None
    assert hold.reason == "PICKUP at P1 was answered RESULT 0, but the FOUP bit is 0"
    assert [i.state for i in ready.kept_intents() if i.kind == "pickup"][-1] is IntentState.FAILED


def test_a_job_whose_carrier_is_gone_fails_after_a_person_has_looked(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.run(2)
    ready.toys[V1].aboard = None
    ready.run(15)
    assert ready.job("J1").state is JobState.PAUSED
    go_on(ready)
    ready.run_until("J1")
    assert ready.job("J1").result == "the carrier is no longer aboard"
    assert ready.job("J1").state is JobState.FAILED


def test_a_vehicle_that_turns_out_to_be_loaded_gives_its_job_back(ready: Script) -> None:
    ready.order("B1", "P3", vehicle=V1)
    ready.run_to("to_source")
    ready.run(1)
    ready.toys[V1].aboard = CarrierId("GHOST")
    ready.run(14)
    go_on(ready)
    ready.run(5)
    assert ready.job("J1").state is JobState.QUEUED
    assert ready.job("J1").reason == "no vehicle is free: V001 is asked for, and is loaded"


# -- interruptions ----------------------------------------------------------------------------------------------------


def test_a_job_that_is_not_picked_up_goes_to_another_vehicle_ten_seconds_after_the_link_is_lost(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.accept(ChangeJob(HOST, J1, priority=51))
    ready.toys[V1].cut()
    ready.run(9)
    assert ready.job("J1").vehicle == V1
    ready.run(4)
    assert ready.job("J1").vehicle is None
    assert ready.job("J1").reason == "no vehicle is free: V001 is asked for, and is not connected"


def test_a_job_whose_carrier_is_aboard_is_paused_while_its_vehicle_cannot_go_on_and_resumed(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(HoldVehicle(KIM, V1, "a noise"))
    ready.run(15)
    job = ready.job("J1")
    assert (job.state, job.reason) == (JobState.PAUSED, "V001 cannot go on: on hold: held by kim: a noise")
    go_on(ready)
    ready.run_until("J1")
    events = ready.events("J1")
    assert events.index("TransferPaused") < events.index("TransferResumed") < events.index("VehicleDepositStarted")
    assert ready.job("J1").state is JobState.COMPLETED


def test_a_paused_job_says_what_keeps_its_vehicle_now_not_what_kept_it_first(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.toys[V1].cut()
    ready.run(15)
    assert ready.job("J1").reason.startswith("V001 cannot go on: it is not connected")
    ready.accept(HoldVehicle(KIM, V1, "a noise"))
    ready.toys[V1].connect()
    ready.run(15)
    job = ready.job("J1")
    assert (job.state, job.reason) == (JobState.PAUSED, "V001 cannot go on: on hold: held by kim: a noise")
    assert ready.events("J1").count("TransferPaused") == 1


def test_a_short_interruption_does_not_pause_a_job(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.toys[V1].cut()
    ready.run(2)
    ready.toys[V1].connect()
    ready.run_until("J1")
    assert "TransferPaused" not in ready.events("J1")


def test_a_lockout_takes_a_job_that_is_not_picked_up_from_the_vehicle_at_once(ready: Script) -> None:
    ready.order()
    vehicle = ready.run_to("to_source").vehicle
    assert vehicle is not None
    ready.accept(LockVehicle(KIM, vehicle, "belt"))
    ready.run(2)
    other = V2 if vehicle == V1 else V1
    assert ready.job("J1").vehicle in {other, None}
    ready.accept(UnlockVehicle(KIM, vehicle))
    ready.run_until("J1")


def test_out_of_service_takes_a_job_that_is_not_picked_up_from_the_vehicle_at_once(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.accept(SetService(KIM, V1, "cleaning"))
    assert ready.job("J1").state is JobState.QUEUED
    assert ready.job("J1").reason == "V001 was taken out of service"
    ready.accept(SetService(KIM, V1, ""))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


# -- the controller's own pause ---------------------------------------------------------------------------------------


def test_pausing_becomes_paused_once_everything_stands_and_nothing_begins_until_resumed(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.run(1)
    ready.accept(PauseController(KIM, "drill"))
    assert ready.fleet.books.controller.state.value == ControllerState.PAUSING.value
    ready.accept(PauseController(KIM, "drill again"))
    ready.order("B1", "B2", job="J2", vehicle=V2)
    ready.forget()
    ready.run(60)
    assert ready.fleet.books.controller.state.value == ControllerState.PAUSED.value
    assert ready.sends == []
    assert ready.job("J2").reason == "the controller is paused"
    assert ready.events().count("ControllerPaused") == 1
    ready.accept(ResumeController(KIM))
    ready.run_until("J1", "J2")


def test_a_pause_while_handling_waits_for_the_handling_and_no_other_begins(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("acquiring")
    ready.accept(PauseController(KIM, "drill"))
    assert ready.fleet.books.controller.state.value == ControllerState.PAUSING.value
    ready.run(10)
    assert ready.fleet.books.controller.state.value == ControllerState.PAUSED.value
    assert ready.job("J1").leg.value == "to_destination"


def test_no_handling_begins_while_the_controller_is_paused(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.accept(PauseController(KIM, "drill"))
    ready.run(30)
    assert not [s for s in ready.sends if isinstance(s.command, Pickup)]
    ready.accept(ResumeController(KIM))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_pausing_and_resuming_without_need_changes_nothing(ready: Script) -> None:
    ready.accept(ResumeController(KIM))
    assert ready.events() == []
    ready.accept(PauseController(KIM, "drill"))
    assert ready.events() == ["ControllerPausing", "ControllerPaused"]


def test_a_waiting_vehicle_says_that_the_controller_is_paused(ready: Script) -> None:
    ready.accept(PauseController(KIM, "drill"))
    ready.accept(MoveVehicle(KIM, V1, Barcode("106")))
    ready.run(2)
    view = ready.model[Topic.VEHICLES]["V001"]
    assert isinstance(view, VehicleView)
    assert view.waiting == "V001 waits at 103: the controller is paused"


# -- places -----------------------------------------------------------------------------------------------------------


def test_two_stations_at_one_barcode_need_a_stop_of_their_own_kind(ready: Script) -> None:
    plant = small()
    second = replace(next(s for s in plant.stations if s.id == B2), id=StationId("B3"), barcode=Barcode("104"))
    script = Script(replace(plant, stations=(*plant.stations, second)))
    script.world.update({P1: FOUP1, B1: FOUP2})
    script.obey()
    script.order("P1", "B3", vehicle=V1)
    script.run_until("J1")
    assert script.world[StationId("B3")] == FOUP1
    stops = [s.command.path[-1].action for s in script.sends if isinstance(s.command, Move)]
    assert stops[-1] is StopAction.SBFR


def test_a_vehicle_that_finds_no_way_says_so_and_goes_once_there_is_one(
    ready: Script, monkeypatch: pytest.MonkeyPatch
) -> None:
    ready.order(vehicle=V1)
    ready.run_to("acquiring")

    def none(start: Barcode, goal: Barcode) -> tuple[Barcode, ...]:
        raise NoRoute(f"no route from {start} to {goal}: closed")

    with monkeypatch.context() as patch:
        patch.setattr(ready.fleet.books.router, "route", none)
        ready.run(10)
        assert ready.job("J1").reason == "V001 finds no way: no route from 104 to 114: closed"
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_a_vehicle_that_was_pushed_away_from_its_source_goes_there_again(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.toys[V1].mode = 0
    ready.run(2)
    ready.toys[V1].moving, ready.toys[V1].barcode = None, Barcode("102")
    ready.report(V1, "102", words(mode=0))
    ready.toys[V1].mode = 3
    ready.run(5)
    go_on(ready)
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED
    assert P2 not in ready.world


# -- ports and their queues -------------------------------------------------------------------------------------------


def test_a_loaded_vehicle_lets_the_one_through_that_empties_its_destination(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("to_destination")
    ready.world[P3] = CarrierId("LOT7")
    ready.run(5)
    ready.accept(WriteStation(HOST, P3, carrier="LOT7"))
    ready.run(20)
    assert ready.job("J1").reason == "its destination cannot be used: P3 is occupied by LOT7"
    ready.order("P3", "B2", job="J2", vehicle=V2)
    ready.run_until("J1", "J2", at_most=600)
    assert ready.world == {P3: FOUP1, B2: CarrierId("LOT7"), B1: FOUP2}


def test_a_vehicle_that_a_person_vouches_to_be_loaded_gives_its_job_back_at_once(ready: Script) -> None:
    ready.order("B1", "P3", vehicle=V1)
    ready.run_to("to_source")
    ready.toys[V1].mode = 0
    ready.run(14)
    ready.toys[V1].aboard, ready.toys[V1].mode = CarrierId("GHOST"), 3
    ready.order("B1", "P2", job="J2", vehicle=V1)
    ready.run(4)
    go_on(ready)
    ready.run(3)
    assert ready.job("J1").vehicle is None
    assert ready.vehicle(V1).record.believed_loaded


def test_a_station_that_was_believed_to_hold_another_carrier_loses_it(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("acquiring")
    ready.accept(WriteStation(HOST, P1, carrier="LOT7"))
    ready.run_until("J1")
    assert ready.fleet.books.carriers[CarrierId("LOT7")].place is None
    assert ready.station(P3).carrier == FOUP1


def test_a_vehicle_that_the_plant_file_takes_out_of_service_gets_no_job() -> None:
    plant = small()
    script = Script(replace(plant, vehicles=(replace(plant.vehicles[0], in_service=False), plant.vehicles[1])))
    script.world.update({P1: FOUP1, B1: FOUP2})
    script.obey()
    script.order("P1", "P3")
    script.run(3)
    assert script.job("J1").vehicle == V2


@pytest.mark.parametrize("leg", ["none", "to_source", "acquiring", "to_destination", "depositing"])
def test_every_request_about_a_job_is_carried_out_or_refused_in_every_state(leg: str) -> None:
    """COMMANDS section 4 as a table: what is allowed on which leg; nothing in between."""
    before = leg in {"none", "to_source"}
    expected: dict[Request, bool] = {
        CancelJob(HOST, J1): before,
        AbortJob(HOST, J1): not before,
        ChangeJob(HOST, J1, priority=9): True,
        ChangeJob(HOST, J1, destination=B2): leg != "depositing",
        ChangeJob(HOST, J1, vehicle=V2): before,
    }
    for paused in (False, True):
        for request, allowed in expected.items():
            script = Script()
            script.world.update({P1: FOUP1, B1: FOUP2})
            script.obey()
            if leg == "none":
                script.accept(HoldVehicle(KIM, V1, "x"))
            script.order(vehicle=V1)
            script.run_to(leg)
            if paused and not before:
                script.accept(HoldVehicle(KIM, V1, "x"))
                script.toys[V1].cut()
                script.run(12)
                assert script.job("J1").state is JobState.PAUSED
            assert isinstance(script.ask(request), Accepted) is allowed, (leg, paused, request)


def test_nothing_is_put_down_where_a_pick_up_failed_until_somebody_has_said_what_stands_there(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.toys[V1].reject_handling = True
    ready.run_until("J1")
    (told,) = [event for event in ready.history() if event.event == "PortStateChanged"]
    assert (told.destination, told.carrier, told.detail) == (P1, FOUP1, "not known: a pick-up failed there")
    ready.toys[V1].reject_handling = False
    ready.order("B1", "P1", job="J2")
    ready.run(60)
    why = "FOUP0001 may stand at P1, where a pick-up failed: look, then PATCH /api/v1/stations/P1 with present"
    assert (ready.job("J2").state, ready.job("J2").reason) == (JobState.QUEUED, why)
    ready.accept(WriteStation(HOST, P1, present=False))
    del ready.world[P1]
    ready.run_until("J2")
    assert ready.station(P1).carrier == FOUP2


def test_a_carrier_that_cannot_be_where_it_was_believed_to_be_is_told_of(ready: Script) -> None:
    ready.order("P1", "P3", job="J1")
    ready.run_to("depositing")
    books = ready.fleet.books
    books.put_carrier(CarrierId("LOT9"), StationId("P3"), Provenance.HOST)
    ready.run_until("J1")
    (told,) = [event for event in ready.history() if event.event == "CarrierLocationChanged"]
    vehicle = ready.job("J1").vehicle
    assert (told.carrier, told.detail) == ("LOT9", f"nobody knows where it is: {vehicle} put FOUP0001 down at P3")
    assert books.carriers[CarrierId("LOT9")].place is None
