"""Vehicles that give RESP1 when they accept a command (PROTOCOLS I19), and vehicles that answer strangely."""

from dataclasses import replace

import pytest

from app.domain.commands import Pickup, Place, Plain
from app.domain.ids import Actor, CarrierId, JobId, StationId
from app.domain.job import JobState
from app.domain.layout import StopAction
from app.domain.records import IntentState
from app.domain.requests import CommandVehicle, CreateJob, RecoverAlarm
from app.fleet.vehicle import Stage
from app.protocols.itsc.messages import Code, Mode
from app.protocols.itsc.simulator import Options, RespTiming
from tests.control.bench import V1 as LONE
from tests.control.bench import Bench, line_plant
from tests.fleet.script import P1, V1, Script, stopped_at, words

HOST = Actor("host")
AT_PORT = stopped_at(StopAction.PORT)
WORKING = words(oper=2, trav=1, axes=0x118134, flags=0xB)


@pytest.fixture
def picking(ready: Script) -> Script:
    """V001 has the PICKUP of J1 at P1 (104), and nobody obeys by itself."""
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("acquiring")
    ready.toys[V1].linked = False
    return ready


@pytest.fixture
def early() -> Bench:
    """A real session with a vehicle that answers on acceptance; a carrier stands at P1."""
    plant = replace(line_plant(), carriers=((CarrierId("F1"), StationId("P1")),))
    return Bench(plant, Options(resp_timing=RespTiming.ACCEPTANCE))


def test_result_0_while_it_still_works_decides_nothing(picking: Script) -> None:
    picking.answer(picking.last(Pickup), "104", WORKING)
    for _ in range(5):
        picking.wait(1)
        picking.report(V1, "104", WORKING)
    assert picking.vehicle(V1).record.hold is None
    assert picking.intents(V1)
    picking.report(V1, "104", stopped_at(StopAction.PORT, loaded=True))
    assert picking.intents(V1)[0].kind == "move"
    assert picking.job("J1").leg.value == "to_destination"


def test_f_1_with_the_lifter_still_down_is_not_done_yet(picking: Script) -> None:
    down = words(oper=2, loaded=True, trav=1, axes=0x110134, flags=0xB)
    picking.answer(picking.last(Pickup), "104", WORKING)
    picking.report(V1, "104", down)
    assert picking.job("J1").leg.value == "acquiring"


def test_one_that_stands_idle_with_an_axis_out_after_result_0_is_settled(picking: Script) -> None:
    picking.answer(picking.last(Pickup), "104", AT_PORT)
    picking.report(V1, "104", words(loaded=True, trav=1, axes=0x110134, flags=0xB))
    assert picking.vehicle(V1).stage is Stage.SETTLING
    picking.stand(V1, "104", stopped_at(StopAction.PORT, loaded=True), link=False)
    assert picking.job("J1").leg.value == "to_destination"


def test_an_alarm_after_result_0_holds_the_vehicle_and_f_decides_after_the_recovery(picking: Script) -> None:
    picking.answer(picking.last(Pickup), "104", WORKING)
    for _ in range(3):
        picking.wait(1.1)
        picking.report(V1, "104", words(oper=1, code=201, trav=1))
    hold = picking.vehicle(V1).record.hold
    assert hold is not None
    assert hold.reason.startswith("alarm 201")
    picking.accept(RecoverAlarm(HOST, V1))
    picking.report(V1, "104", AT_PORT)
    picking.stand(V1, "104", AT_PORT, link=False)
    assert picking.job("J1").state is JobState.FAILED
    assert picking.station(P1).present is not True
    kept = [i for i in picking.kept_intents() if i.kind == "pickup"]
    assert kept[-1].state is IntentState.SETTLED_NOT_DONE


def test_result_1_for_a_place_that_was_refused_leaves_the_carrier_aboard(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("depositing")
    ready.toys[V1].linked = False
    first = ready.last(Place)
    ready.answer(first, "114", words(trav=1), ok=False, reason="refused")
    ready.stand(V1, "114", stopped_at(StopAction.PORT, loaded=True), link=False)
    assert ready.last(Place).cmd_id != first.cmd_id
    assert ready.vehicle(V1).record.believed_loaded


def test_a_whole_job_with_a_vehicle_that_answers_on_acceptance(early: Bench) -> None:
    early.accept(CreateJob(HOST, JobId("J1"), "P1", StationId("B1"), None, 50, "x"))
    early.run(40.0)
    assert early.truth.at == {StationId("B1"): "F1"}
    assert len(early.sent(Code.PICKUP_FROM_PORT)) == len(early.sent(Code.PLACE_TO_SBFL)) == 1
    states = [intent.state for kind in ("move", "pickup", "place") for intent in early.intents(kind)]
    assert set(states) == {IntentState.DONE}
    assert early.hold == ""


def test_a_whole_recovery_with_a_vehicle_that_answers_on_acceptance(early: Bench) -> None:
    early.vehicle.power_cycle(early.now)
    early.run(4.0)
    early.connect()
    early.run(3.0)
    early.accept(RecoverAlarm(HOST, LONE, confirmed=True))
    early.run(15.0)
    assert early.vehicle.state.mode is Mode.AUTO
    assert early.known.fit
    assert len(early.sent(Code.SERVO_ON, Code.SEARCH_HOME, Code.GO_HOME, Code.AUTO)) == 3


def test_a_pick_up_stopped_half_way_is_settled_and_ends_as_f_says(early: Bench) -> None:
    early.accept(CreateJob(HOST, JobId("J1"), "P1", StationId("B1"), None, 50, "x"))
    early.until(lambda: early.vehicle.state.foup)
    early.accept(CommandVehicle(HOST, LONE, Plain.STOP))
    early.run(5.0)
    assert early.known.stage is Stage.SETTLING
    assert early.sent(Code.MOVE)[1:] == []
    early.accept(RecoverAlarm(HOST, LONE, confirmed=True))
    early.run(40.0)
    assert early.truth.at == {StationId("B1"): "F1"}
    assert len(early.sent(Code.PICKUP_FROM_PORT)) == 1
