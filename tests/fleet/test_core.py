"""The fleet as a whole: what it takes in, what it tells, and when it wants to be woken."""

from dataclasses import replace

import pytest

from app.domain.commands import Display, Move, Plain, Send, Simple, Xmove
from app.domain.events import Acknowledged, Garbled, Taught, TeachingKind
from app.domain.ids import Actor, CmdId, CmdIds, Epoch, VehicleId
from app.domain.layout import Axis
from app.domain.records import AuditRow, HistoryEvent, IntentState, Kept, TeachingEvent
from app.domain.requests import CommandVehicle, HoldVehicle, LockVehicle, MoveVehicle, PauseController
from app.domain.units import Barcode, Pulses, Seconds, Timestamp
from app.domain.view import LinkView, Topic, VehicleView
from app.fleet import Fleet
from tests.fleet.script import HOST, V1, V2, Script, small, words

KIM = Actor("kim")


def moved(ready: Script) -> Send:
    """V001 is told to go to 107, and nobody obeys by itself any more."""
    ready.toys[V1].linked = False
    ready.accept(MoveVehicle(KIM, V1, Barcode("107")))
    return ready.last(Move, V1)


# -- what must not leave any more -----------------------------------------------------------------------------------------


def test_nothing_speaks_against_a_command_that_was_just_decided(ready: Script) -> None:
    assert ready.fleet.objection(moved(ready)) == ""


def test_a_command_that_was_settled_while_it_was_being_written_does_not_leave(ready: Script) -> None:
    move = moved(ready)
    ready.link_down(V1)
    ready.stand(V1, "103")
    assert ready.fleet.objection(move) == "it was settled before it could be sent"


def test_a_motion_does_not_leave_while_its_vehicle_is_being_asked(ready: Script) -> None:
    move = moved(ready)
    ready.link_down(V1)
    ready.link_up(V1)
    assert ready.fleet.objection(move) == "V001 is being asked where it is"
    ready.wait(1.5)
    ready.report(V1, "103", words(oper=2, trav=8))
    assert ready.fleet.objection(move) == "V001 is in RUN"


def test_a_motion_does_not_leave_to_a_vehicle_that_was_barred_meanwhile(ready: Script) -> None:
    move = moved(ready)
    ready.accept(LockVehicle(KIM, V1, "somebody is at it"))
    assert ready.fleet.objection(move) == "locked out by kim: somebody is at it"


def test_a_stop_or_a_text_leaves_whatever_the_vehicle_is_at(ready: Script) -> None:
    move = moved(ready)
    ready.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    assert ready.fleet.objection(ready.last(Simple, V1)) == ""
    assert ready.fleet.objection(move).startswith("on hold: stopped by kim")
    assert ready.fleet.objection(Send(V1, CmdId(7), Display("HELLO"))) == "it was settled before it could be sent"


# -- alarms ---------------------------------------------------------------------------------------------------------------


def test_each_alarm_is_an_event_when_it_comes_and_one_that_names_it_when_it_goes_or_another_comes(
    ready: Script,
) -> None:
    ready.toys[V1].linked = False
    ready.forget()
    for code, oper in ((300, 1), (300, 1), (301, 1), (0, 0), (0, 0)):
        ready.report(V1, "103", words(oper=oper, code=code))
    told = [(e.event, e.detail) for e in ready.history() if e.event.startswith("Alarm")]
    each = [
        (name, f"{code} (no name under alarm_codes)")
        for code in ("300", "301")
        for name in ("AlarmSet", "AlarmCleared")
    ]
    assert told == each


def test_an_alarm_while_idle_is_found_by_the_next_poll_and_holds_the_vehicle(ready: Script) -> None:
    ready.toys[V1].alarm = 300
    ready.run(5)
    assert ready.vehicle(V1).record.hold
    ready.order("P1", "P3")
    ready.run_to("to_source")
    assert ready.job("J1").vehicle == V2


# -- teaching ---------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "code", "axis"),
    [
        (TeachingKind.SHFT_DEST, 0x2070, Axis.SHFT),
        (TeachingKind.ROTA_DEST, 0x2072, Axis.ROTA),
        (TeachingKind.LIFT_OFFSET, 0x2075, Axis.LIFT),
        (None, 0x2079, None),
    ],
)
def test_a_teaching_event_is_kept_raw_before_it_is_acknowledged(
    ready: Script, kind: TeachingKind | None, code: int, axis: Axis | None
) -> None:
    ready.hear(Taught(V1, kind, code, Pulses(-1520), Barcode("103"), CmdId(1 << 63), 5))
    (kept,) = ready.kept(TeachingEvent)
    assert (kept.vehicle, kept.code, kept.axis, kept.position, kept.barcode) == (V1, code, axis, -1520, "103")
    assert ready.stored == [(V1, 5)]


def test_teaching_events_of_two_connections_are_told_apart(ready: Script) -> None:
    taught = Taught(V1, TeachingKind.LIFT_DEST, 0x2074, Pulses(1), Barcode("103"), CmdId(1 << 63), 1)
    ready.hear(taught)
    ready.toys[V1].cut()
    ready.run(1)
    ready.link_up(V1)
    ready.hear(replace(taught, connection=1))
    first, second = ready.kept(TeachingEvent)
    assert first.connection != second.connection


# -- what is shown ----------------------------------------------------------------------------------------------------------


def test_a_vehicle_is_shown_at_most_ten_times_a_second_unless_something_is_decided(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.wait(1)
    ready.forget()
    for n in range(20):
        ready.now = Seconds(ready.now + 0.01)
        ready.report(V1, "103", words(), seq=n)
    shown = [u for u in ready.updates if u.topic is Topic.VEHICLES]
    assert 1 <= len(shown) <= 3
    assert ready.fleet.deadline <= ready.now + 0.1
    ready.wait(0.2, step=0.05)
    view = ready.model[Topic.VEHICLES][V1]
    assert isinstance(view, VehicleView)


def test_bytes_that_are_no_packet_change_the_picture_of_the_link_only(ready: Script) -> None:
    ready.hear(Garbled(V1, "crc", "12 bytes dropped"))
    assert ready.records == []
    assert ready.sends == []


def test_an_ack_to_anything_but_the_move_under_way_says_nothing(ready: Script) -> None:
    move = moved(ready)
    ready.hear(Acknowledged(V1, CmdId(1)))
    drive = ready.vehicle(V1).drive
    assert drive is not None
    assert drive.acknowledged is None
    ready.acknowledge(move)
    assert drive.acknowledged == ready.now


# -- people -----------------------------------------------------------------------------------------------------------------


def test_every_request_leaves_one_audit_row_with_who_what_and_whether_it_was_accepted(ready: Script) -> None:
    ready.accept(HoldVehicle(KIM, V1, "to look at it"))
    ready.refuse(HoldVehicle(KIM, VehicleId("V999"), "to look at it"))
    ready.accept(PauseController(HOST, "end of shift"))
    rows = ready.kept(AuditRow)
    assert [(row.actor, row.action, row.target, row.accepted) for row in rows] == [
        ("kim", "HoldVehicle", "V001", True),
        ("kim", "HoldVehicle", "V999", False),
        ("host", "PauseController", ready.plant.name, True),
    ]


def test_events_are_numbered_without_a_gap_over_restarts(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run_to("to_destination")
    ready.restart()
    ready.obey()
    ready.run_until("J1")
    numbers = [record.seq for record in ready.kept(HistoryEvent)]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))


def test_command_ids_of_two_lives_never_meet(ready: Script) -> None:
    first = moved(ready).cmd_id
    ready.restart()
    ready.stand(V1, "103")
    ready.stand(V2, "116")
    ready.wait(2)
    ready.accept(MoveVehicle(KIM, V1, Barcode("105")))
    assert ready.last(Move, V1).cmd_id >> 32 == (first >> 32) + 1


# -- time -------------------------------------------------------------------------------------------------------------------


def test_nothing_happens_before_the_deadline(ready: Script) -> None:
    ready.run(2)
    ready.fleet.tick(Seconds(ready.now))
    ready.fleet.take()
    ready.fleet.tick(ready.now)
    assert ready.fleet.take().empty


def test_a_fresh_plant_takes_carriers_and_teaching_from_its_file() -> None:
    plant = small()
    fleet = Fleet(
        plant,
        Kept(Epoch(1)),
        CmdIds(Epoch(1)),
        Seconds(0.0),
        Timestamp(0.0),
        lambda _: LinkView(up=False, since=0.0, reason=""),
    )
    assert set(fleet.books.carriers) == {"FOUP0001", "FOUP0002"}
    assert set(fleet.books.dests) == {"P1", "P2", "P3"}
    assert set(fleet.books.offsets) == {"V001", "V002"}


def test_an_xmove_of_unknown_outcome_is_not_lost_with_the_line(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, Barcode("115")))
    ready.accept(MoveVehicle(KIM, V2, Barcode("101")))
    while not any(isinstance(s.command, Xmove) for s in ready.sends):
        ready.run(0.25)
    ready.toys[V1].cut()
    kinds = {i.kind: i.state for i in ready.intents(V1)}
    assert kinds == {"move": IntentState.UNKNOWN, "xmove": IntentState.UNKNOWN} or kinds == {
        "move": IntentState.UNKNOWN
    }
    ready.run(20)
    ready.toys[V1].connect()
    ready.run(30)
    assert ready.toys[V1].barcode == "115"
    assert not ready.intents(V1)
