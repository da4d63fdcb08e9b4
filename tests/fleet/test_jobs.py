"""The life of a transfer job (DOMAIN section 2, COMMANDS sections 4 and 5)."""

from dataclasses import replace

import pytest

from app.domain.commands import Move, Pickup, Place
from app.domain.errors import Refusal
from app.domain.ids import Actor, CarrierId, JobId, StationId, VehicleId
from app.domain.job import Job, JobState
from app.domain.layout import Edge, Point, PulseSet, Station, StationKind
from app.domain.records import AuditRow, Provenance
from app.domain.requests import (
    AbortJob,
    CancelJob,
    ChangeJob,
    PauseController,
    ReleaseVehicle,
    Request,
    SetService,
    Verdict,
    WriteDest,
    WriteStation,
)
from app.domain.units import Barcode, Millimetres, Pulses
from app.domain.versions import Leaving
from tests.fleet.script import B1, B2, FOUP1, FOUP2, HOST, P1, P2, P3, V1, V2, Script, small, transfer

J1 = JobId("J1")
NORMAL = [
    "TransferInitiated",
    "VehicleAssigned",
    "VehicleDeparted",
    "VehicleArrived",
    "Transferring",
    "VehicleAcquireStarted",
    "CarrierInstalled",
    "VehicleAcquireCompleted",
    "VehicleDeparted",
    "VehicleArrived",
    "VehicleDepositStarted",
    "CarrierRemoved",
    "VehicleDepositCompleted",
    "VehicleUnassigned",
    "TransferCompleted",
]


# -- the normal way ---------------------------------------------------------------------------------------------------


def test_a_transfer_tells_the_events_of_e82_in_their_normal_order(ready: Script) -> None:
    ready.order(vehicle="V001")
    ready.run_until("J1")
    assert ready.events("J1") == NORMAL


def test_every_event_carries_what_the_host_needs(ready: Script) -> None:
    ready.order(vehicle="V001")
    ready.run_until("J1")
    arrived = [e.detail for e in ready.history("J1") if e.event == "VehicleArrived"]
    assert arrived == ["P1", "P3"]
    installed = next(e for e in ready.history("J1") if e.event == "CarrierInstalled")
    assert (installed.carrier, installed.vehicle, installed.source) == (FOUP1, V1, "P1")
    end = ready.history("J1")[-1]
    assert (end.result, end.ceid, end.carrier, end.vehicle) == ("completed", 107, FOUP1, V1)
    assert (end.source, end.destination) == ("P1", "P3")


def test_the_commands_of_a_job_are_move_pickup_move_place_in_that_order(ready: Script) -> None:
    ready.order(vehicle="V001")
    ready.run_until("J1")
    kinds = [type(send.command) for send in ready.sends if isinstance(send.command, Move | Pickup | Place)]
    assert [kind for i, kind in enumerate(kinds) if i == 0 or kind is not kinds[i - 1]] == [Move, Pickup, Move, Place]


def test_the_target_of_a_port_is_dest_plus_offset_and_its_versions_are_kept_with_the_intent(ready: Script) -> None:
    ready.order(vehicle="V001")
    ready.run_until("J1")
    pickup = ready.last(Pickup)
    assert isinstance(pickup.command, Pickup)
    assert pickup.command.target == PulseSet(Pulses(1210), Pulses(-304), Pulses(41120))
    intent = next(i for i in ready.kept_intents() if i.cmd_id == pickup.cmd_id)
    assert intent.body["dest_version"] == intent.body["offset_version"] == 1
    assert intent.body["target"] == [1210, -304, 41120]
    assert intent.job == "J1"


def test_a_side_buffer_is_handled_without_target(ready: Script) -> None:
    ready.order("B1", "B2")
    ready.run_until("J1")
    for kind in (Pickup, Place):
        command = ready.last(kind).command
        assert isinstance(command, Pickup | Place)
        assert command.target is None
    assert ready.job("J1").state is JobState.COMPLETED


def test_the_display_shows_carrier_source_and_destination(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run_to("to_source")
    ready.run(0.5)
    move = ready.last(Move).command
    assert isinstance(move, Move)
    assert (move.foup_id, move.source, move.destination) == (FOUP1, "P1", "LOADER-3")


def test_times_of_a_job_are_kept_in_their_order(ready: Script) -> None:
    ready.order()
    ready.run_until("J1")
    job = ready.job("J1")
    assert job.assigned is not None
    assert job.picked is not None
    assert job.ended is not None
    assert job.created <= job.assigned < job.picked < job.ended


def test_the_carrier_and_the_ports_follow_the_foup_bit_with_provenance(ready: Script) -> None:
    ready.order()
    ready.run_to("to_destination")
    assert (ready.station(P1).present, ready.station(P1).provenance) == (False, Provenance.PICKED)
    holder = ready.job("J1").vehicle
    assert ready.fleet.books.carriers[FOUP1].place == holder
    ready.run_until("J1")
    assert (ready.station(P3).present, ready.station(P3).carrier) == (True, FOUP1)
    assert ready.station(P3).provenance is Provenance.PLACED
    assert ready.fleet.books.carriers[FOUP1].place == P3
    assert ready.world == {P3: FOUP1, B1: FOUP2}


def test_a_carrier_that_the_host_names_is_taken_over_where_none_was_known(script: Script) -> None:
    script.world[P2] = CarrierId("LOT7")
    script.obey()
    script.order("P2", "P3", carrier=CarrierId("LOT7"))
    script.run_until("J1")
    assert script.station(P3).carrier == "LOT7"


# -- names and idempotency --------------------------------------------------------------------------------------------


def test_a_job_without_a_name_is_called_by_its_number(ready: Script) -> None:
    assert ready.order(job=None).id == "HW-1"
    assert ready.order("B1", "B2", job=None).id == "HW-2"


def test_numbers_of_jobs_go_on_after_a_restart(ready: Script) -> None:
    ready.order(job=None)
    ready.restart()
    assert ready.order("B1", "B2", job=None).id == "HW-2"


def test_the_same_body_under_the_same_id_gives_the_same_job(ready: Script) -> None:
    ready.order()
    again = ready.accept(transfer())
    assert (again.key, again.created) == ("J1", False)
    assert len([job for job in ready.kept(Job) if job.state is JobState.QUEUED and not job.reason]) == 1


def test_the_same_body_gives_the_same_job_after_it_has_ended(ready: Script) -> None:
    ready.order()
    ready.accept(CancelJob(HOST, J1))
    assert ready.accept(transfer()).created is False
    assert ready.job("J1").state is JobState.CANCELLED


def test_another_body_under_the_same_id_is_refused(ready: Script) -> None:
    ready.order()
    refusal = ready.refuse(transfer("B1", "B2"))
    assert (refusal.code, refusal.field) == ("conflict", "job_id")
    assert refusal.remedy


def test_later_changes_do_not_change_what_the_same_body_means(ready: Script) -> None:
    ready.order()
    ready.accept(ChangeJob(HOST, J1, destination=B2))
    assert ready.accept(transfer()).key == "J1"
    assert ready.job("J1").destination == B2


def test_an_idempotency_key_serves_where_there_is_no_id(ready: Script) -> None:
    first = ready.accept(transfer(job=None, idempotency_key="k"))
    again = ready.accept(transfer(job=None, idempotency_key="k"))
    assert (again.key, again.created) == (first.key, False)
    refusal = ready.refuse(transfer("B1", "B2", job=None, idempotency_key="k"))
    assert (refusal.code, refusal.field) == ("conflict", "Idempotency-Key")


def test_an_idempotency_key_is_known_after_a_restart(ready: Script) -> None:
    first = ready.accept(transfer(job=None, idempotency_key="k"))
    ready.restart()
    assert ready.accept(transfer(job=None, idempotency_key="k")).key == first.key


def test_only_so_many_ended_jobs_are_remembered(ready: Script, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.fleet.books.REMEMBERED", 1)
    for name in ("A", "B"):
        ready.order(job=name, idempotency_key=name)
        ready.accept(CancelJob(HOST, JobId(name)))
    assert list(ready.fleet.books.ended) == ["B"]
    assert list(ready.fleet.books.by_key) == ["B"]


# -- refused at once --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("changes", "field", "code"),
    [
        ({"source": "P9"}, "source", "invalid"),
        ({"destination": "P9"}, "destination", "invalid"),
        ({"destination": "V001"}, "destination", "invalid"),
        ({"destination": "P1"}, "destination", "invalid"),
        ({"fallbacks": (StationId("P9"),)}, "fallbacks", "invalid"),
        ({"fallbacks": (P3,)}, "fallbacks", "invalid"),
        ({"fallbacks": (B2, B2)}, "fallbacks", "invalid"),
        ({"vehicle": VehicleId("V009")}, "vehicle", "invalid"),
        ({"source": "V001", "vehicle": V2}, "vehicle", "invalid"),
        ({"carrier": CarrierId("A" * 17)}, "carrier", "invalid"),
        ({"carrier": CarrierId("FOUP-Ä")}, "carrier", "invalid"),
        ({"carrier": CarrierId("FOUP\n")}, "carrier", "invalid"),
        ({"job": JobId("HW-77")}, "job_id", "invalid"),
    ],
)
def test_what_is_wrong_with_an_order_is_refused_at_once_and_named(
    ready: Script, changes: dict[str, object], field: str, code: str
) -> None:
    refusal = ready.refuse(replace(transfer(), **changes))  # type: ignore[arg-type]
    assert (refusal.code, refusal.field) == (code, field)
    assert ready.kept(Job) == []
    row = ready.kept(AuditRow)[-1]
    assert (row.accepted, row.action) == (False, "CreateJob")
    assert refusal.reason in row.detail


def test_a_port_that_was_never_taught_is_refused_with_its_missing_axes() -> None:
    plant = small()
    untaught = tuple(replace(s, dest=None) if s.id == P3 else s for s in plant.stations)
    script = Script(replace(plant, stations=untaught))
    refusal = script.refuse(transfer("P1", "P3"))
    assert (refusal.code, refusal.field) == ("not-now", "destination")
    assert refusal.reason == "P3 has no DEST (SHFT, ROTA, LIFT)"
    assert script.refuse(transfer("P3", "P1")).field == "source"
    script.accept(WriteDest(HOST, P3, PulseSet(Pulses(1), Pulses(2), Pulses(3))))
    assert script.accept(transfer("P1", "P3")).created


def island() -> Script:
    """Return the small plant with a station P7 on track that is not connected."""
    plant = small()
    points = (*plant.points, Point(Barcode("900"), Millimetres(0), Millimetres(90_000)), *_second())
    edges = (*plant.edges, Edge(Barcode("900"), Barcode("901"), Millimetres(1000)))
    station = Station(StationId("P7"), StationKind.SBFL, Barcode("901"))
    return Script(replace(plant, points=points, edges=edges, stations=(*plant.stations, station)))


def _second() -> tuple[Point, ...]:
    return (Point(Barcode("901"), Millimetres(1000), Millimetres(90_000)),)


def test_an_order_without_a_route_is_refused() -> None:
    refusal = island().refuse(transfer("P1", "P7"))
    assert (refusal.code, refusal.field) == ("no-route", "destination")


def test_an_order_whose_source_no_vehicle_can_reach_waits_and_says_so() -> None:
    script = island().obey()
    script.world[StationId("P8")] = FOUP1
    script.order("P1", "P3")
    script.run(2)
    assert script.job("J1").vehicle


# -- not refused: it waits, and says why ------------------------------------------------------------------------------


def test_a_job_from_an_empty_source_waits_until_the_host_says_that_it_is_full(ready: Script) -> None:
    ready.accept(WriteStation(HOST, P2, present=False))
    ready.order("P2", "P3")
    ready.run(2)
    assert ready.job("J1").reason == "P2 is empty"
    ready.world[P2] = CarrierId("LOT7")
    ready.accept(WriteStation(HOST, P2, present=True))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_of_a_carrier_that_is_not_at_its_source_it_is_said_where_it_is(ready: Script) -> None:
    ready.accept(WriteStation(HOST, P2, present=False))
    ready.order("P2", "P3", carrier=FOUP1)
    ready.run(2)
    assert ready.job("J1").reason == "P2 is empty: FOUP0001 is at P1"
    ready.accept(ChangeJob(HOST, J1, destination=B2))
    assert ready.job("J1").reason == ""


def test_what_stands_at_a_station_can_be_made_unknown_again(ready: Script) -> None:
    ready.accept(WriteStation(HOST, P1, forgotten=True))
    record = ready.fleet.books.stations[P1]
    assert (record.present, record.carrier, record.doubted) == (None, None, False)
    assert ready.fleet.books.carriers[FOUP1].place is None


def test_a_job_to_a_full_destination_waits_until_it_is_free(ready: Script) -> None:
    ready.order("P1", "B1")
    ready.run(2)
    assert ready.job("J1").reason == "B1 is occupied by FOUP0002"
    del ready.world[B1]
    ready.accept(WriteStation(HOST, B1, present=False))
    ready.run_until("J1")
    assert ready.station(B1).carrier == FOUP1


def test_a_job_to_a_destination_that_is_just_being_emptied_begins(ready: Script) -> None:
    ready.order("B1", "B2", job="J2")
    ready.order("P1", "B1", job="J1")
    ready.run(2)
    assert ready.job("J1").reason == "B1 is occupied by FOUP0002"
    ready.run_to("acquiring", "J2")
    ready.run(2)
    assert ready.job("J1").vehicle
    ready.run_until("J1", "J2")
    assert ready.world == {B1: FOUP1, B2: FOUP2}


@pytest.mark.parametrize("station", [P1, P3])
def test_a_job_waits_for_a_station_that_is_out_of_service(ready: Script, station: StationId) -> None:
    ready.accept(WriteStation(HOST, station, out_of_service="cleaning"))
    ready.order()
    ready.run(2)
    assert ready.job("J1").reason == f"{station} is out of service: cleaning"
    ready.accept(WriteStation(HOST, station, out_of_service=""))
    ready.run(2)
    assert ready.job("J1").vehicle


def test_a_reserved_destination_is_for_the_job_it_is_reserved_for(ready: Script) -> None:
    ready.accept(WriteStation(HOST, P3, reserved="J2"))
    ready.order(job="J1")
    ready.run(2)
    assert ready.job("J1").reason == "P3 is reserved: J2"
    ready.order("B1", "P3", job="J2")
    ready.run_until("J2")
    ready.run(2)
    assert ready.station(P3).reserved == ""
    assert ready.job("J1").reason == f"P3 is occupied by {FOUP2}"


def test_a_source_that_holds_another_carrier_is_not_fetched_from(ready: Script) -> None:
    ready.order(carrier=FOUP2)
    ready.run(2)
    assert ready.job("J1").reason == "P1 holds FOUP0001, not FOUP0002"


def test_a_carrier_that_is_known_to_be_elsewhere_is_waited_for(ready: Script) -> None:
    ready.order("P2", "P3", carrier=FOUP1)
    ready.run(2)
    assert ready.job("J1").reason == "FOUP0001 is at P1, not at P2"


def test_chained_jobs_of_one_carrier_are_accepted_and_done_in_order(ready: Script) -> None:
    ready.order("P1", "P3", job="A", carrier=FOUP1)
    ready.order("P3", "P2", job="B", carrier=FOUP1, priority=99)
    ready.order("P2", "B2", job="C", carrier=FOUP1)
    ready.run_until("A", "B", "C", at_most=600)
    ends = [e.job for e in ready.history() if e.event == "TransferCompleted"]
    assert ends == ["A", "B", "C"]
    assert ready.world[B2] == FOUP1


def test_chained_jobs_without_a_carrier_name_are_done_in_order_too(ready: Script) -> None:
    ready.order("P1", "P3", job="A")
    ready.order("P3", "P2", job="B", priority=99)
    ready.run(2)
    assert ready.job("B").reason == "A brings a carrier to P3 first"
    ready.run_until("A", "B", at_most=600)
    assert ready.world[P2] == FOUP1


def test_a_full_source_is_emptied_before_the_earlier_job_that_fills_it(ready: Script) -> None:
    ready.order("P1", "B1", job="A")
    ready.order("B1", "B2", job="B")
    ready.run_until("A", "B", at_most=600)
    assert ready.world == {B1: FOUP1, B2: FOUP2}


def test_two_jobs_to_one_destination_go_one_after_the_other(ready: Script) -> None:
    ready.order("P1", "P3", job="A")
    ready.order("B1", "P3", job="B")
    ready.run(2)
    assert ready.job("B").reason == "P3 is the destination of A already"


def test_two_jobs_from_one_source_go_one_after_the_other(ready: Script) -> None:
    ready.order("P1", "P3", job="A")
    ready.order("P1", "P2", job="B")
    ready.run(2)
    assert ready.job("B").reason == "another job is being fetched from P1"


# -- cancel -----------------------------------------------------------------------------------------------------------


def test_a_queued_job_is_cancelled_at_once(script: Script) -> None:
    script.order()
    script.accept(CancelJob(HOST, J1))
    job = script.job("J1")
    assert (job.state, job.result) == (JobState.CANCELLED, "cancelled by host")
    assert script.events("J1") == ["TransferCancelInitiated", "TransferCancelCompleted"]


def test_why_a_job_was_cancelled_or_aborted_is_kept_with_it(ready: Script) -> None:
    ready.order(job="J0")
    ready.accept(CancelJob(HOST, JobId("J0"), "wrong lot"))
    assert ready.job("J0").result == "cancelled by host: wrong lot"
    ready.order()
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, J1, "the tool is down"))
    told = [event.detail for event in ready.history("J1") if event.event == "TransferAbortInitiated"]
    assert told == ["aborted by host: the tool is down"]


def test_a_job_is_cancelled_while_its_vehicle_is_on_the_way_and_the_vehicle_takes_another(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.accept(CancelJob(HOST, J1))
    assert ready.events("J1")[-3:] == ["TransferCancelInitiated", "VehicleUnassigned", "TransferCancelCompleted"]
    assert ready.vehicle(V1).job is None
    ready.order(job="J2", vehicle=V1)
    ready.run_until("J2")
    assert ready.job("J2").state is JobState.COMPLETED


def test_a_job_whose_carrier_is_aboard_or_being_picked_up_is_not_cancelled(ready: Script) -> None:
    ready.order()
    for leg in ("acquiring", "to_destination", "depositing"):
        ready.run_to(leg)
        refusal = ready.refuse(CancelJob(HOST, J1))
        assert (refusal.code, refusal.remedy) == ("conflict", "POST /api/v1/jobs/J1/abort")


def test_a_job_that_is_not_there_or_has_ended_is_neither_cancelled_nor_aborted_nor_changed(ready: Script) -> None:
    for request in (CancelJob(HOST, J1), AbortJob(HOST, J1), ChangeJob(HOST, J1, priority=3)):
        assert ready.refuse(request).code == "not-found"
    ready.order()
    ready.accept(CancelJob(HOST, J1))
    for request in (CancelJob(HOST, J1), AbortJob(HOST, J1), ChangeJob(HOST, J1, priority=3)):
        refusal = ready.refuse(request)
        assert (refusal.code, refusal.reason) == ("conflict", "job J1 has ended: cancelled")


# -- abort ------------------------------------------------------------------------------------------------------------


def test_a_job_that_was_not_picked_up_is_not_aborted(ready: Script) -> None:
    ready.order()
    ready.run_to("to_source")
    refusal = ready.refuse(AbortJob(HOST, J1))
    assert (refusal.code, refusal.remedy) == ("conflict", "POST /api/v1/jobs/J1/cancel")


def test_an_abort_leaves_the_carrier_aboard_and_the_host_orders_it_from_the_vehicle(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, J1))
    job = ready.job("J1")
    assert job.state is JobState.ABORTED
    assert "order vehicle -> place" in job.result
    assert ready.events("J1")[-3:] == ["TransferAbortInitiated", "VehicleUnassigned", "TransferAbortCompleted"]
    ready.run(20)
    assert ready.vehicle(V1).record.carrier == FOUP1
    ready.order("V001", "P2", job="J2")
    ready.run_until("J2")
    assert ready.job("J2").carrier == FOUP1
    assert ready.world[P2] == FOUP1


def test_an_abort_while_picking_up_waits_until_the_pick_up_is_over(ready: Script) -> None:
    ready.order()
    ready.run_to("acquiring")
    ready.accept(AbortJob(HOST, J1))
    assert ready.job("J1").state is JobState.ABORTING
    assert ready.accept(AbortJob(HOST, J1)).key == "J1"
    assert ready.refuse(ChangeJob(HOST, J1, priority=3)).code == "conflict"
    ready.run_until("J1")
    job = ready.job("J1")
    assert job.state is JobState.ABORTED
    assert job.result == "aborted; the carrier is aboard: order vehicle -> place for it"
    assert "CarrierInstalled" in ready.events("J1")


def test_an_abort_while_a_pick_up_fails_leaves_nothing_aboard(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("acquiring")
    ready.accept(AbortJob(HOST, J1))
    ready.toys[V1].misgrip = True
    ready.toys[V1].handling = None
    ready.answer(ready.last(Pickup), "104", ok=False)
    ready.run_until("J1")
    assert ready.job("J1").result == "aborted; nothing is aboard"


def test_an_abort_that_comes_too_late_fails_and_the_job_is_completed(ready: Script) -> None:
    ready.order()
    ready.run_to("depositing")
    ready.accept(AbortJob(HOST, J1))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED
    assert "TransferAbortFailed" in ready.events("J1")
    assert ready.events("J1")[-1] == "TransferCompleted"
    assert ready.world[P3] == FOUP1


def test_an_abort_while_a_put_down_fails_leaves_the_carrier_aboard(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("depositing")
    ready.accept(AbortJob(HOST, J1))
    ready.toys[V1].handling = None
    ready.answer(ready.last(Place), "114", ready.toys[V1].condition, ok=False)
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.ABORTED
    assert "the carrier is aboard" in ready.job("J1").result


def test_an_abort_of_a_job_whose_vehicle_was_taken_off_the_rail_does_not_wait_for_it(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("acquiring")
    ready.toys[V1].cut()
    ready.accept(ReleaseVehicle(Actor("kim"), V1, Verdict.OFF_RAIL, "carried away"))
    ready.run(15)
    assert ready.job("J1").state is JobState.PAUSED
    ready.accept(AbortJob(HOST, J1))
    assert ready.job("J1").state is JobState.ABORTED
    assert "look where the carrier is" in ready.job("J1").result


def test_an_abort_under_way_ends_when_the_vehicle_is_taken_off_the_rail(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("acquiring")
    ready.toys[V1].cut()
    ready.accept(AbortJob(HOST, J1))
    ready.run(15)
    assert ready.job("J1").state is JobState.ABORTING
    ready.accept(ReleaseVehicle(Actor("kim"), V1, Verdict.OFF_RAIL, "carried away"))
    assert ready.job("J1").state is JobState.ABORTED


# -- change -----------------------------------------------------------------------------------------------------------


def test_a_job_for_one_vehicle_may_be_given_back_to_all(ready: Script) -> None:
    ready.order(job="J0", vehicle=V1)
    ready.run_to("to_source", "J0")
    ready.order("B1", "B2", vehicle=V1)
    ready.run(2)
    assert ready.job("J1").vehicle is None
    ready.accept(ChangeJob(HOST, J1, any_vehicle=True))
    assert ready.job("J1").wish is None
    assert ready.history("J1")[-1].detail == "vehicle V001 -> any"
    ready.run_until("J1")
    assert "V002" in {event.vehicle for event in ready.history("J1")}


def test_a_change_says_what_changed(ready: Script) -> None:
    ready.accept(PauseController(HOST, "look"))
    ready.order()
    ready.accept(ChangeJob(HOST, J1, priority=80, destination=B2, vehicle=V2))
    job = ready.job("J1")
    assert (job.priority, job.destination, job.wish) == (80, B2, V2)
    assert ready.history("J1")[-1].event == "TransferUpdated"
    assert ready.history("J1")[-1].detail == "priority 50 -> 80, destination P3 -> B2, vehicle any -> V002"
    ready.accept(ChangeJob(HOST, J1, priority=80))
    assert ready.history("J1")[-1].detail == "nothing changed"


@pytest.mark.parametrize("leg", ["to_source", "acquiring", "to_destination"])
def test_the_destination_may_be_changed_on_every_leg_before_the_put_down(ready: Script, leg: str) -> None:
    ready.order()
    ready.run_to(leg)
    ready.run(2)
    ready.accept(ChangeJob(HOST, J1, destination=B2))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED
    assert ready.world[B2] == FOUP1


def test_the_destination_of_a_carrier_being_put_down_is_not_changed(ready: Script) -> None:
    ready.order()
    ready.run_to("depositing")
    refusal = ready.refuse(ChangeJob(HOST, J1, destination=B2))
    assert (refusal.code, refusal.field) == ("conflict", "destination")
    ready.accept(ChangeJob(HOST, J1, priority=7, destination=P3))
    ready.run_until("J1")
    assert ready.world[P3] == FOUP1


def test_a_carrier_that_is_aboard_may_go_back_to_its_source(ready: Script) -> None:
    ready.order()
    ready.run_to("to_source")
    assert ready.refuse(ChangeJob(HOST, J1, destination=P1)).field == "destination"
    ready.run_to("to_destination")
    ready.accept(ChangeJob(HOST, J1, destination=P1))
    ready.run_until("J1")
    assert ready.world[P1] == FOUP1


def test_a_bad_change_changes_nothing(ready: Script) -> None:
    ready.order()
    for change, field in (
        (ChangeJob(HOST, J1, priority=9, destination=StationId("P9")), "destination"),
        (ChangeJob(HOST, J1, priority=9, vehicle=VehicleId("V009")), "vehicle"),
    ):
        assert ready.refuse(change).field == field
    assert ready.job("J1").priority == 50


def test_another_vehicle_takes_over_a_job_that_is_not_picked_up(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_source")
    ready.accept(ChangeJob(HOST, J1, vehicle=V2))
    ready.run_until("J1")
    names = [(e.event, e.vehicle) for e in ready.history("J1") if e.event.startswith("VehicleA")]
    assert ("VehicleAssigned", V1) in names
    assert ready.history("J1")[-1].vehicle == V2


def test_the_vehicle_of_a_carrier_aboard_is_not_changed(ready: Script) -> None:
    ready.order()
    ready.run_to("to_destination")
    assert ready.refuse(ChangeJob(HOST, J1, vehicle=V2)).field == "vehicle"


# -- vehicle to place -------------------------------------------------------------------------------------------------


def test_a_job_from_a_vehicle_waits_until_something_is_aboard(ready: Script) -> None:
    ready.order("V001", "P2")
    ready.run(2)
    assert ready.job("J1").reason == "nothing is aboard V001"
    refusal = ready.refuse(ChangeJob(HOST, J1, vehicle=V2))
    assert (refusal.code, refusal.field) == ("invalid", "vehicle")
    ready.accept(ChangeJob(HOST, J1, vehicle=V1))


def test_a_job_from_a_vehicle_goes_straight_to_its_destination(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, J1))
    ready.forget()
    ready.order("V001", "P2", job="J2")
    ready.run_until("J2")
    expected = ["TransferInitiated", "VehicleAssigned", "Transferring", *NORMAL[8:]]
    assert ready.events("J2") == expected


def test_a_job_from_a_vehicle_that_carries_something_else_waits(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, J1))
    ready.order("V001", "P2", job="J2", carrier=FOUP2)
    ready.run(2)
    assert ready.job("J2").reason == "V001 carries FOUP0001, not FOUP0002"


def test_a_job_from_a_vehicle_says_why_the_vehicle_does_not_take_it(ready: Script) -> None:
    ready.order(vehicle=V1)
    ready.run_to("to_destination")
    ready.accept(AbortJob(HOST, J1))
    ready.accept(SetService(HOST, V1, "worn belt"))
    ready.order("V001", "P2", job="J2")
    ready.run(2)
    said = "no vehicle is free: V001 has the carrier aboard, and is out of service: worn belt"
    assert ready.job("J2").reason == said


# -- restarts ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("leg", ["to_source", "acquiring", "to_destination", "depositing"])
def test_a_job_goes_on_after_a_restart_on_every_leg_and_nothing_is_done_twice(ready: Script, leg: str) -> None:
    ready.order()
    ready.run_to(leg)
    ready.run(1)
    ready.restart()
    ready.obey()
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED
    assert ready.world == {P3: FOUP1, B1: FOUP2}
    picked = [s for s in ready.events("J1") if s == "CarrierInstalled"]
    assert len(picked) == 1


def test_a_job_whose_station_or_vehicle_has_left_the_plant_fails(ready: Script) -> None:
    ready.order("P1", "P2", job="A", vehicle=V1)
    ready.order("B1", "P3", job="B", vehicle=V2)
    ready.run_to("acquiring", "A")
    plant = small()
    fewer = tuple(s for s in plant.stations if s.id not in {P1, P3})
    ready.restart(plant=replace(plant, stations=fewer, vehicles=plant.vehicles[:1], carriers=()))
    assert ready.job("A").result == "P1 is no longer in the plant"
    assert ready.job("B").result == "P3, V002 is no longer in the plant"
    assert ready.job("B").state is JobState.FAILED
    ready.obey(V1)
    ready.run(10)
    assert ready.vehicle(V1).record.carrier == FOUP1


# -- a plant that is to come ----------------------------------------------------------------------------------------------


def refused(script: Script, request: Request) -> str:
    reply = script.ask(request)
    assert isinstance(reply, Refusal), reply
    assert (reply.code, "versions/7/reject" in reply.remedy) == ("not-now", True)
    return f"{reply.field}: {reply.reason}"


def test_no_new_job_needs_what_goes_with_the_plant_that_is_awaited(ready: Script) -> None:
    before = ready.order("P1", "P2")
    ready.order("P1", "P3", "J2")
    ready.fleet.books.leaving = Leaving(7, frozenset({"P2", "V002"}), frozenset({"P3"}))
    goes, cut_off = "is not in version 7 of the plant, which is to become active", "cannot be reached in version 7"
    assert refused(ready, transfer("B1", "P2", "J3")) == f"destination: P2 {goes}"
    assert refused(ready, transfer("P2", "B1", "J3")) == f"source: P2 {goes}"
    assert refused(ready, transfer("P1", "B1", "J3", vehicle=V2)) == f"vehicle: V002 {goes}"
    assert cut_off in refused(ready, transfer("B1", "P3", "J3"))
    assert refused(ready, ChangeJob(HOST, J1, destination=P3)).startswith("destination: P3 cannot")
    assert refused(ready, ChangeJob(HOST, JobId("J2"), vehicle=V2)) == f"vehicle: V002 {goes}"
    assert ready.order("P1", "P2") == before, "the same order again is the same job"
    ready.fleet.books.leaving = None
    ready.order("P2", "P3", "J3")


def test_what_is_known_to_be_at_a_station_that_goes_may_be_fetched(ready: Script) -> None:
    ready.fleet.books.leaving = Leaving(7, frozenset({"P1", "V001"}), frozenset())
    assert ready.order("P1", "P3").source == P1
    ready.accept(WriteStation(HOST, P1, present=False))
    reply = ready.ask(transfer("P1", "B1", "J2"))
    assert isinstance(reply, Refusal)
    assert reply.remedy.startswith(
        "if a carrier is there, say so first: PUT /api/v1/carriers/ID; else name another one"
    )


def test_jobs_accepted_before_go_on_to_their_end(ready: Script) -> None:
    ready.order("P1", "P3", vehicle="V001")
    ready.fleet.books.leaving = Leaving(7, frozenset({"P1", "P3", "V001"}), frozenset())
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


@pytest.mark.parametrize(
    ("source", "destination", "vehicle", "field", "remedy"),
    [
        ("p1", "B2", None, "source", "did you mean P1?"),
        ("v001", "B2", None, "source", "did you mean V001?"),
        ("P1", "b-2", None, "destination", "did you mean B2?"),
        ("P1", "B2", "V1", "vehicle", "did you mean V001?"),
        ("P1", "NOPE", None, "destination", "see GET /api/v1/stations"),
        ("P1", "B2", "crane", "vehicle", "see GET /api/v1/vehicles"),
    ],
)
def test_a_wrong_name_in_an_order_is_refused_with_the_one_that_was_surely_meant(
    ready: Script, source: str, destination: str, vehicle: str | None, field: str, remedy: str
) -> None:
    wished = None if vehicle is None else VehicleId(vehicle)
    refusal = ready.refuse(transfer(source, destination, vehicle=wished))
    assert (refusal.field, refusal.remedy) == (field, remedy)
