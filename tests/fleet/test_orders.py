"""What people and hosts ask about vehicles, stations, carriers, taught values and the controller."""

from dataclasses import replace

import pytest

from app.domain.commands import Display, Move, Pickup, Place, Plain, Simple
from app.domain.errors import NoRoute
from app.domain.ids import Actor, CarrierId, JobId, StationId, VehicleId
from app.domain.layout import PulseSet, StopAction
from app.domain.records import AuditRow, CarrierGone, Provenance, StationDest, VehicleOffset
from app.domain.requests import (
    AbortJob,
    CancelJob,
    CommandVehicle,
    DisplayOnVehicle,
    HandleOnce,
    HoldVehicle,
    LockVehicle,
    MoveVehicle,
    PauseController,
    RecoverAlarm,
    ReleaseVehicle,
    Request,
    SetService,
    UnlockVehicle,
    Verdict,
    WriteCarrier,
    WriteDest,
    WriteOffset,
    WriteStation,
)
from app.domain.units import Barcode, Pulses
from app.domain.view import CarrierView, StationView, Topic, VehicleView
from tests.fleet.script import B1, FOUP1, FOUP2, HOST, P1, P2, P3, V1, V2, Script, small, transfer, words

J1 = JobId("J1")
KIM, LEE, PARK = Actor("kim"), Actor("lee"), Actor("park")
NOBODY = VehicleId("V009")
PULSES = PulseSet(Pulses(1), Pulses(2), Pulses(3))
AT = Barcode("106")


# -- commands ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "request_",
    [
        CommandVehicle(KIM, NOBODY, Plain.STATUS),
        DisplayOnVehicle(KIM, NOBODY, "HELLO"),
        MoveVehicle(KIM, NOBODY, AT),
        HandleOnce(KIM, NOBODY, P1, pickup=True),
        RecoverAlarm(KIM, NOBODY),
        HoldVehicle(KIM, NOBODY, "x"),
        ReleaseVehicle(KIM, NOBODY, Verdict.GO_ON, "x"),
        SetService(KIM, NOBODY, "x"),
        LockVehicle(KIM, NOBODY, "x"),
        UnlockVehicle(KIM, NOBODY),
        WriteOffset(KIM, NOBODY, PULSES),
    ],
)
def test_a_vehicle_that_the_plant_does_not_have_is_not_found(ready: Script, request_: Request) -> None:
    refusal = ready.refuse(request_)
    assert (refusal.code, refusal.remedy) == ("not-found", "see GET /api/v1/vehicles")


def test_status_asks_the_vehicle_at_once(ready: Script) -> None:
    reply = ready.accept(CommandVehicle(KIM, V1, Plain.STATUS))
    assert reply.cmd_id is None
    assert ready.polls == [V1]


def test_a_command_is_an_intent_whose_outcome_is_kept(ready: Script) -> None:
    reply = ready.accept(CommandVehicle(KIM, V1, Plain.STOP))
    send = ready.last(Simple)
    assert reply.cmd_id == send.cmd_id
    ready.answer(send, "103")
    closed = ready.kept_intents()[-1]
    assert (closed.kind, closed.state.value, closed.actor, closed.outcome) == ("stop", "done", "kim", "RESULT 0")
    assert f"{send.cmd_id:016x}" not in ready.model[Topic.COMMANDS]


def test_a_command_that_ends_abnormally_says_why(ready: Script) -> None:
    ready.accept(CommandVehicle(KIM, V1, Plain.STOP))
    ready.answer(ready.last(Simple), "103", ok=False, reason="it is moving")
    assert (ready.kept_intents()[-1].state.value, ready.kept_intents()[-1].outcome) == ("failed", "it is moving")


@pytest.mark.parametrize(
    "what",
    [
        Plain.SERVO_ON,
        Plain.SERVO_OFF,
        Plain.SEARCH_HOME,
        Plain.GO_HOME,
        Plain.SYSTEM_RESET,
        Plain.ALARM_CLEAR,
        Plain.AUTO,
    ],
)
def test_commands_for_mant_are_refused_in_auto_and_sent_in_mant(ready: Script, what: Plain) -> None:
    refusal = ready.refuse(CommandVehicle(KIM, V1, what))
    assert refusal.reason == f"V001 is in AUTO, and {what.value} needs MANT"
    assert "stop" in refusal.remedy
    ready.report(V1, "103", words(mode=0))
    assert ready.accept(CommandVehicle(KIM, V1, what)).cmd_id is not None


def test_stop_by_host_holds_the_vehicle_and_needs_auto_or_semi(ready: Script) -> None:
    ready.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    hold = ready.vehicle(V1).record.hold
    assert hold is not None
    assert hold.reason == "stopped by kim"
    ready.report(V2, "116", words(mode=0))
    assert ready.refuse(CommandVehicle(KIM, V2, Plain.STOP_BY_HOST)).remedy == "send stop"


def test_nothing_is_sent_to_a_vehicle_that_is_not_connected(script: Script) -> None:
    for request in (
        CommandVehicle(KIM, V1, Plain.STOP),
        DisplayOnVehicle(KIM, V1, "HELLO"),
        MoveVehicle(KIM, V1, AT),
        RecoverAlarm(KIM, V1),
    ):
        refusal = script.refuse(request)
        assert (refusal.code, refusal.remedy) == ("not-now", "look at its line and power") or "AUTO" in refusal.remedy
        assert "not connected" in refusal.reason


def test_a_text_is_shown_in_auto_only(ready: Script) -> None:
    ready.accept(DisplayOnVehicle(KIM, V1, "HELLO", 0x8001))
    command = ready.last(Display).command
    assert command == Display("HELLO", 0x8001)
    ready.report(V2, "116", words(mode=0))
    refusal = ready.refuse(DisplayOnVehicle(KIM, V2, "HELLO"))
    assert (refusal.reason, refusal.remedy) == ("V002 is in MANT: display needs AUTO or SEMI", "switch it to AUTO")


# -- moves for a person -----------------------------------------------------------------------------------------------


def test_a_vehicle_goes_to_a_barcode_under_grants_and_is_free_again(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, AT))
    assert not ready.vehicle(V1).available
    ready.run(8)
    assert ready.vehicle(V1).barcode == AT
    assert ready.vehicle(V1).available
    intent = next(i for i in ready.kept_intents() if i.kind == "move")
    assert intent.body["purpose"] == "person"


def test_a_vehicle_that_stands_there_already_does_not_move(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, Barcode("103")))
    ready.run(2)
    assert ready.sends == []
    assert ready.vehicle(V1).available


def test_a_move_to_nowhere_is_refused(ready: Script) -> None:
    assert ready.refuse(MoveVehicle(KIM, V1, Barcode("999"))).field == "barcode"
    assert ready.refuse(MoveVehicle(KIM, V1, AT, StopAction.RUN)).field == "action"


def test_a_move_without_a_route_is_refused(ready: Script, monkeypatch: pytest.MonkeyPatch) -> None:
    def none(start: Barcode, goal: Barcode) -> tuple[Barcode, ...]:
        raise NoRoute(f"no route from {start} to {goal}")

    monkeypatch.setattr(ready.fleet.books.router, "route", none)
    refusal = ready.refuse(MoveVehicle(KIM, V1, AT))
    assert (refusal.code, refusal.reason) == ("no-route", "no route from 103 to 106")


def test_a_vehicle_on_a_job_is_not_sent_elsewhere(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    refusal = ready.refuse(MoveVehicle(KIM, V1, AT))
    assert (refusal.code, refusal.reason) == ("conflict", "V001 is on job J1")


def test_a_vehicle_that_is_barred_in_mant_in_alarm_or_unsettled_is_not_moved(ready: Script) -> None:
    ready.report(V1, "103", words(mode=0))
    assert "not in AUTO" in ready.refuse(MoveVehicle(KIM, V1, AT)).reason
    ready.report(V1, "103", words(oper=1, code=101))
    assert ready.refuse(MoveVehicle(KIM, V1, AT)).remedy == "POST /api/v1/vehicles/V001/recover"
    ready.report(V1, "103", words())
    assert "being asked where it is" in ready.refuse(MoveVehicle(KIM, V1, AT)).reason or ready.vehicle(V1).record.hold
    ready.accept(HoldVehicle(KIM, V2, "look"))
    assert ready.refuse(MoveVehicle(KIM, V2, AT)).reason == "V002 is on hold: held by kim: look"


def test_nobody_moves_while_the_roll_call_misses_a_vehicle(script: Script) -> None:
    script.obey(V1)
    refusal = script.refuse(MoveVehicle(KIM, V1, AT))
    assert refusal.reason == "the roll-call still misses V002"
    assert "off_rail or stands_at" in refusal.remedy


# -- one-shots --------------------------------------------------------------------------------------------------------


def at(script: Script, barcode: str, action: StopAction = StopAction.PORT) -> Script:
    """Bring V001 to a stop."""
    script.accept(MoveVehicle(KIM, V1, Barcode(barcode), action))
    script.run(20)
    assert script.vehicle(V1).barcode == barcode
    return script


def test_a_person_may_pick_up_and_put_down_without_a_job(ready: Script) -> None:
    at(ready, "104")
    reply = ready.accept(HandleOnce(KIM, V1, P1, pickup=True))
    assert reply.cmd_id == ready.last(Pickup).cmd_id
    assert ready.refuse(MoveVehicle(KIM, V1, AT)).reason == "V001 is handling a carrier"
    ready.run(8)
    assert ready.vehicle(V1).record.carrier == FOUP1
    at(ready, "106")
    ready.accept(HandleOnce(KIM, V1, P2, pickup=False, target=PULSES))
    command = ready.last(Place).command
    assert isinstance(command, Place)
    assert command.target == PULSES
    ready.run(8)
    assert ready.world[P2] == FOUP1
    assert ready.vehicle(V1).available
    assert [e.job for e in ready.history() if e.event in {"CarrierInstalled", "CarrierRemoved"}] == [None, None]


def test_a_one_shot_needs_the_vehicle_stopped_there(ready: Script) -> None:
    refusal = ready.refuse(HandleOnce(KIM, V1, P1, pickup=True))
    assert refusal.remedy == "send move to 104 with action port first"
    at(ready, "104", StopAction.STOP)
    assert ready.refuse(HandleOnce(KIM, V1, P1, pickup=True)).code == "not-now"


def test_a_one_shot_at_an_unknown_station_with_wrong_load_or_pulses_is_refused(ready: Script) -> None:
    assert ready.refuse(HandleOnce(KIM, V1, StationId("P9"), pickup=True)).field == "station"
    at(ready, "104")
    assert ready.refuse(HandleOnce(KIM, V1, P1, pickup=False)).reason == "V001 is empty"
    far = PulseSet(Pulses(999_999), Pulses(0), Pulses(0))
    assert "outside" in ready.refuse(HandleOnce(KIM, V1, P1, pickup=True, target=far)).reason
    ready.accept(HoldVehicle(KIM, V1, "look"))
    assert "on hold" in ready.refuse(HandleOnce(KIM, V1, P1, pickup=True)).reason


def test_a_one_shot_put_down_onto_a_carrier_is_refused(ready: Script) -> None:
    at(ready, "104")
    ready.accept(HandleOnce(KIM, V1, P1, pickup=True))
    ready.run(8)
    ready.accept(WriteStation(HOST, P1, present=True))
    refusal = ready.refuse(HandleOnce(KIM, V1, P1, pickup=False))
    assert (refusal.code, refusal.reason) == ("conflict", "P1 is occupied by a carrier")


def test_no_one_shot_while_the_controller_is_paused(ready: Script) -> None:
    at(ready, "104")
    ready.accept(PauseController(KIM, "drill"))
    assert ready.refuse(HandleOnce(KIM, V1, P1, pickup=True)).reason == "the controller is paused"


def test_a_one_shot_that_is_refused_by_the_vehicle_leaves_it_free(ready: Script) -> None:
    at(ready, "104")
    ready.toys[V1].reject_handling = True
    ready.accept(HandleOnce(KIM, V1, P1, pickup=True))
    ready.run(6)
    assert ready.vehicle(V1).available
    assert ready.vehicle(V1).record.carrier is None


# -- service and lockout ----------------------------------------------------------------------------------------------


def test_a_vehicle_out_of_service_gets_no_job_until_it_is_back(ready: Script) -> None:
    ready.accept(SetService(KIM, V1, "worn belt"))
    ready.accept(SetService(KIM, V2, "worn belt"))
    ready.order()
    ready.run(3)
    assert ready.job("J1").vehicle is None
    assert [e.event for e in ready.history() if e.vehicle == V1] == ["VehicleRemoved"]
    ready.accept(SetService(KIM, V1, ""))
    assert ready.history()[-1].event == "VehicleInstalled"
    ready.run_until("J1")


def test_a_lockout_lets_nothing_through_but_reading_and_stopping(ready: Script) -> None:
    ready.accept(LockVehicle(KIM, V1, "belt"))
    ready.accept(CommandVehicle(LEE, V1, Plain.STATUS))
    ready.accept(CommandVehicle(LEE, V1, Plain.STOP))
    ready.report(V1, "103", words(mode=0))
    for what in (Plain.SERVO_ON, Plain.SEARCH_HOME, Plain.AUTO):
        refusal = ready.refuse(CommandVehicle(LEE, V1, what))
        assert (refusal.reason, refusal.remedy) == ("V001 is locked out by kim: belt", "lift the lockout first")
    ready.report(V1, "103", words())
    assert "locked out" in ready.refuse(DisplayOnVehicle(LEE, V1, "HELLO")).reason
    assert "locked out" in ready.refuse(MoveVehicle(LEE, V1, AT)).reason
    assert "locked out" in ready.refuse(RecoverAlarm(LEE, V1)).reason


def test_a_lockout_stops_a_driving_vehicle_where_it_is(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, Barcode("110")))
    ready.run(1)
    assert ready.vehicle(V1).drive
    accepted = ready.accept(LockVehicle(KIM, V1, "belt"))
    stop = next(send for send in ready.sends if send.cmd_id == accepted.cmd_id)
    assert stop.command == Simple(Plain.STOP_BY_HOST)
    ready.forget()
    ready.run(20)
    assert not ready.vehicle(V1).drive
    assert not ready.sends


def test_the_audit_says_in_words_what_was_asked(ready: Script) -> None:
    ready.accept(LockVehicle(KIM, V1, "belt"))
    row = ready.kept(AuditRow)[-1]
    assert (row.actor, row.action, row.target, row.detail) == (
        "kim",
        "LockVehicle",
        "V001",
        "vehicle V001, reason belt",
    )


def test_a_lockout_is_lifted_by_its_owner_alone(ready: Script) -> None:
    assert ready.refuse(UnlockVehicle(KIM, V1)).code == "conflict"
    ready.accept(LockVehicle(KIM, V1, "belt"))
    refusal = ready.refuse(LockVehicle(LEE, V1, "wheel"))
    assert (refusal.code, refusal.remedy) == ("conflict", "ask kim")
    ready.accept(UnlockVehicle(KIM, V1))
    ready.run(3)
    assert ready.vehicle(V1).available


def test_a_lockout_is_lifted_by_two_others_together_but_not_by_one_twice(ready: Script) -> None:
    ready.accept(LockVehicle(KIM, V1, "belt"))
    ready.refuse(UnlockVehicle(LEE, V1))
    refusal = ready.refuse(UnlockVehicle(LEE, V1))
    assert refusal.remedy == "kim alone can lift it, or one more person with you"
    view = ready.model[Topic.VEHICLES]["V001"]
    assert isinstance(view, VehicleView)
    assert view.lockout is not None
    assert view.lockout.releases == ("lee",)
    ready.accept(UnlockVehicle(PARK, V1))
    assert ready.vehicle(V1).record.lockout is None


def test_a_lockout_survives_a_restart(ready: Script) -> None:
    ready.accept(LockVehicle(KIM, V1, "belt"))
    ready.restart()
    ready.obey()
    lock = ready.vehicle(V1).record.lockout
    assert lock is not None
    assert lock.owner == KIM
    assert not ready.vehicle(V1).available


def test_a_lockout_of_an_absent_vehicle_may_be_lifted(script: Script) -> None:
    script.accept(LockVehicle(KIM, V1, "belt"))
    script.accept(UnlockVehicle(KIM, V1))
    assert script.vehicle(V1).record.lockout is None


# -- stations ---------------------------------------------------------------------------------------------------------


def test_a_host_writes_what_is_at_a_port_and_all_of_it_is_shown(ready: Script) -> None:
    ready.now = type(ready.now)(100.0)
    ready.accept(WriteStation(HOST, P2, present=True, carrier="LOT7", reserved="J9", out_of_service="dirty"))
    view = ready.model[Topic.STATIONS]["P2"]
    assert isinstance(view, StationView)
    assert (view.present, view.carrier, view.reserved, view.out_of_service) == (True, "LOT7", "J9", "dirty")
    assert (view.provenance, view.verified) == ("host", True)
    assert view.at == ready.fleet.books.utc
    event = ready.history()[-1]
    assert (event.event, event.destination, event.carrier) == ("PortStateChanged", "P2", "LOT7")
    assert event.detail == "occupied, reserved: J9, out of service: dirty"
    carrier = ready.model[Topic.CARRIERS]["LOT7"]
    assert isinstance(carrier, CarrierView)
    assert (carrier.place, carrier.verified) == ("P2", True)


def test_what_is_not_written_stays_and_keeps_its_provenance(ready: Script) -> None:
    ready.accept(WriteStation(HOST, P1, reserved="J9"))
    record = ready.station(P1)
    assert (record.present, record.carrier, record.reserved) == (True, FOUP1, "J9")
    assert record.provenance is Provenance.PLANT
    ready.accept(WriteStation(HOST, P1, reserved=""))
    assert ready.station(P1).reserved == ""


def test_a_person_who_looked_is_another_provenance(ready: Script) -> None:
    ready.accept(WriteStation(KIM, P1, present=True, by_person=True))
    assert ready.station(P1).provenance is Provenance.PERSON


def test_an_emptied_port_leaves_its_carrier_nowhere(ready: Script) -> None:
    ready.accept(WriteStation(HOST, P1, present=False))
    assert (ready.station(P1).present, ready.station(P1).carrier) == (False, None)
    assert ready.fleet.books.carriers[FOUP1].place is None
    assert ready.history()[-1].detail == "empty"


def test_a_carrier_may_be_named_away_without_being_moved(ready: Script) -> None:
    ready.accept(WriteStation(HOST, P1, carrier=""))
    assert (ready.station(P1).present, ready.station(P1).carrier) == (True, None)


def test_another_carrier_at_a_port_leaves_the_former_one_nowhere(ready: Script) -> None:
    ready.accept(WriteStation(HOST, P1, carrier="FOUP0002"))
    assert ready.fleet.books.carriers[FOUP1].place is None
    assert ready.fleet.books.carriers[FOUP2].place == P1
    assert (ready.station(B1).present, ready.station(B1).carrier) == (False, None)


def test_a_carrier_written_to_a_port_is_no_longer_aboard(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, J1))
    ready.accept(WriteStation(HOST, P2, carrier="FOUP0001"))
    assert ready.vehicle(V1).record.carrier is None


def test_contradictory_or_unknown_stations_are_refused(ready: Script) -> None:
    assert ready.refuse(WriteStation(HOST, StationId("P9"), present=True)).code == "not-found"
    assert ready.refuse(WriteStation(HOST, P1, present=False, carrier="X")).field == "carrier"
    assert ready.refuse(WriteStation(HOST, P1, carrier="X" * 17)).field == "carrier"
    assert ready.station(P1).carrier == FOUP1


# -- carriers ---------------------------------------------------------------------------------------------------------


def test_a_carrier_is_installed_moved_and_removed(ready: Script) -> None:
    lot = CarrierId("LOT7")
    assert ready.accept(WriteCarrier(HOST, lot, "P2")).created
    assert ready.station(P2).carrier == lot
    assert not ready.accept(WriteCarrier(HOST, lot, "P3")).created
    assert (ready.station(P2).present, ready.station(P3).carrier) == (False, lot)
    ready.accept(WriteCarrier(HOST, lot, None))
    assert ready.kept(CarrierGone)[-1].carrier == lot
    assert ready.station(P3).present is False
    assert "LOT7" not in ready.model[Topic.CARRIERS]
    assert [e.event for e in ready.history()] == ["CarrierLocationChanged"] * 3
    assert ready.refuse(WriteCarrier(HOST, lot, None)).code == "not-found"


def test_a_carrier_is_not_written_to_where_another_is_or_nothing_could_be(ready: Script) -> None:
    assert ready.refuse(WriteCarrier(HOST, FOUP1, "B1")).reason == "B1 holds FOUP0002"
    assert ready.refuse(WriteCarrier(HOST, FOUP1, "P9")).field == "place"
    assert ready.refuse(WriteCarrier(HOST, CarrierId("Ü"), "P2")).field == "carrier"
    assert ready.refuse(WriteCarrier(HOST, FOUP1, "V001")).reason == "V001 says that nothing is aboard (FOUP bit 0)"


def test_a_carrier_aboard_is_named_moved_between_records_and_taken_out(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, J1))
    assert ready.refuse(WriteCarrier(HOST, FOUP2, "V001")).reason == "V001 carries FOUP0001"
    ready.accept(WriteCarrier(HOST, FOUP1, "P2"))
    assert ready.vehicle(V1).record.carrier is None
    lot = CarrierId("LOT7")
    assert ready.accept(WriteCarrier(KIM, lot, "V001", by_person=True)).created
    assert ready.vehicle(V1).record.carrier == lot
    ready.accept(WriteCarrier(KIM, lot, "V001", by_person=True))
    ready.accept(WriteCarrier(KIM, lot, None))
    assert ready.vehicle(V1).record.carrier is None


def test_a_carrier_is_aboard_one_vehicle_only(script: Script) -> None:
    lot = CarrierId("LOT7")
    script.accept(WriteCarrier(KIM, lot, "V001"))
    script.accept(WriteCarrier(KIM, lot, "V002"))
    assert (script.vehicle(V1).record.carrier, script.vehicle(V2).record.carrier) == (None, lot)


def test_a_carrier_that_a_job_is_about_is_not_removed(ready: Script) -> None:
    ready.order(carrier=FOUP1)
    refusal = ready.refuse(WriteCarrier(HOST, FOUP1, None))
    assert (refusal.code, refusal.reason) == ("conflict", "FOUP0001 is ordered by job J1")
    ready.accept(CancelJob(HOST, J1))
    ready.accept(WriteCarrier(HOST, FOUP1, None))


# -- taught values ----------------------------------------------------------------------------------------------------


def test_every_dest_and_offset_is_a_new_version(ready: Script) -> None:
    ready.accept(WriteDest(KIM, P1, PULSES, expected=1))
    dest = ready.kept(StationDest)[-1]
    assert (dest.version, dest.pulses, dest.actor, dest.source) == (2, PULSES, "kim", "rest")
    view = ready.model[Topic.STATIONS]["P1"]
    assert isinstance(view, StationView)
    assert (view.target, view.target_version) == ((1, 2, 3), 2)
    ready.accept(WriteOffset(KIM, V1, PULSES, expected=1))
    assert ready.kept(VehicleOffset)[-1].version == 2


def test_a_version_that_somebody_else_has_replaced_is_not_overwritten(ready: Script) -> None:
    for request in (WriteDest(KIM, P1, PULSES, expected=0), WriteOffset(KIM, V1, PULSES, expected=7)):
        refusal = ready.refuse(request)
        assert (refusal.code, refusal.field) == ("stale", "If-Match")


def test_dests_belong_to_ports_of_the_plant(ready: Script) -> None:
    assert ready.refuse(WriteDest(KIM, StationId("P9"), PULSES)).code == "not-found"
    assert ready.refuse(WriteDest(KIM, B1, PULSES)).field == "station"


def test_the_first_dest_of_a_port_is_version_1_and_new() -> None:
    plant = small()
    script = Script(replace(plant, stations=tuple(replace(s, dest=None) for s in plant.stations)))
    assert script.accept(WriteDest(KIM, P3, PULSES)).created
    assert script.fleet.books.dests[P3].version == 1


# -- audit ------------------------------------------------------------------------------------------------------------


def test_every_request_is_in_the_audit_with_who_what_and_whether(ready: Script) -> None:
    ready.accept(transfer())
    ready.refuse(CancelJob(LEE, JobId("J9")))
    ready.accept(HoldVehicle(KIM, V1, "look"))
    ready.accept(PauseController(KIM, "drill"))
    rows = [(row.actor, row.action, row.target, row.accepted) for row in ready.kept(AuditRow)]
    assert rows == [
        ("host", "CreateJob", "J1", True),
        ("lee", "CancelJob", "J9", False),
        ("kim", "HoldVehicle", "V001", True),
        ("kim", "PauseController", "small", True),
    ]


def test_a_vehicle_on_its_way_for_a_person_may_be_sent_elsewhere(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, AT))
    ready.run(1)
    ready.accept(MoveVehicle(KIM, V1, Barcode("108")))
    ready.run(20)
    assert ready.vehicle(V1).barcode == "108"
    assert [s for s in ready.sends if isinstance(s.command, Move)]
