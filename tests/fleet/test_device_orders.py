"""What people ask of doors, buffers and chargers, and what keeps them from it (DOMAIN section 7)."""

from typing import Any

import pytest

from app.domain.device_requests import (
    CommandDevice,
    LiftDeviceLockout,
    LockOutDevice,
    PinDoor,
    SetDeviceService,
    UnpinDoor,
)
from app.domain.devices import DeviceAct, DeviceId
from app.domain.ids import Actor
from app.domain.records import AuditRow, DoorPosition, IntentState
from app.fleet.device_views import view_of_device
from tests.fleet.drives import KIM, go
from tests.fleet.hall import ToyHall
from tests.fleet.hall_plants import BUFFER1, CHARGER1, DOOR1, ring
from tests.fleet.script import V1, Script

LEE, PAK = Actor("lee"), Actor("pak")
OPEN, CLOSE = CommandDevice(KIM, DOOR1, DeviceAct.OPEN), CommandDevice(KIM, DOOR1, DeviceAct.CLOSE)


@pytest.fixture
def script() -> Script:
    script = Script(ring())
    script.obey()
    script.forget()
    return script


@pytest.fixture
def hall(script: Script) -> ToyHall:
    assert script.hall is not None
    return script.hall


def at(script: Script, barcode: str) -> None:
    while script.toys[V1].barcode != barcode:
        script.run(0.25)


# -- commands ------------------------------------------------------------------------------------------------------------


def test_a_person_opens_a_door_and_sees_what_became_of_it(script: Script, hall: ToyHall) -> None:
    reply = script.accept(OPEN)
    assert (reply.topic, reply.key) == ("devices", DOOR1)
    assert script.device(DOOR1).pending == "open"
    script.run(4)
    last = [i for i in script.kept_intents() if i.cmd_id == reply.cmd_id][-1]
    assert (last.kind, last.state, last.outcome, last.actor) == ("open", IntentState.DONE, "Status shows it", KIM)
    assert hall.door().is_open


def test_an_opened_door_stays_open_for_a_minute_and_closes_by_itself_then(script: Script) -> None:
    script.accept(OPEN)
    script.run(55)
    assert script.device(DOOR1).state == "open"
    script.run(15)
    assert script.device(DOOR1).state == "closed"


def test_a_persons_close_is_refused_while_somebody_is_granted_the_way_through(script: Script) -> None:
    go(script, "110")
    while "107" not in script.vehicle(V1).ahead:
        script.run(0.25)
    refusal = script.refuse(CLOSE)
    assert refusal.reason == "DOOR1 cannot close: V001 is granted the way through it"
    assert "lock the door out" in refusal.remedy


def test_a_persons_close_is_refused_while_somebody_is_in_the_door(script: Script) -> None:
    go(script, "107")
    at(script, "107")
    script.run(3)
    assert script.refuse(CLOSE).reason == "DOOR1 cannot close: V001 is in it"
    go(script, "108")
    at(script, "108")
    script.accept(CLOSE)


def test_each_kind_does_what_it_can_and_says_what_that_is(script: Script) -> None:
    lock = CommandDevice(KIM, DOOR1, DeviceAct.LOCK)
    assert script.refuse(lock).reason == "DOOR1 is a door and does not lock"
    assert script.refuse(lock).remedy == "it does open and close"
    charger = script.refuse(CommandDevice(KIM, CHARGER1, DeviceAct.OPEN))
    assert charger.remedy == "it does nothing: it has no packets of its own"
    assert script.refuse(CommandDevice(KIM, DeviceId("DOOR9"), DeviceAct.OPEN)).code == "not-found"


def test_a_silent_door_may_be_asked_to_open_and_nothing_else(script: Script, hall: ToyHall) -> None:
    hall.cut()
    assert script.refuse(CLOSE).reason == "DOOR1 is silent: cut"
    reply = script.accept(OPEN)
    last = [i for i in script.kept_intents() if i.cmd_id == reply.cmd_id][-1]
    assert (last.state, last.outcome) == (IntentState.NOT_SENT, "the link is down")


def test_whatever_is_asked_is_audited_once(script: Script) -> None:
    script.accept(OPEN)
    script.refuse(CommandDevice(LEE, DOOR1, DeviceAct.LOCK))
    rows = [(row.actor, row.action, row.target, row.accepted) for row in script.kept(AuditRow)]
    assert rows == [("kim", "CommandDevice", DOOR1, True), ("lee", "CommandDevice", DOOR1, False)]


# -- pins ----------------------------------------------------------------------------------------------------------------


def test_a_door_that_is_kept_closed_lets_nobody_through_and_says_who_wants_that(script: Script, hall: ToyHall) -> None:
    script.accept(PinDoor(KIM, DOOR1, DoorPosition.CLOSED, "cleaning"))
    go(script, "110")
    script.run(15)
    assert script.vehicle(V1).waiting == "V001 waits at 106 for door DOOR1 (kept closed by kim: cleaning)"
    assert script.refuse(OPEN).reason == "DOOR1 is kept closed by kim: cleaning"
    script.accept(UnpinDoor(LEE, DOOR1))
    at(script, "110")
    assert hall.violations == []


def test_a_door_that_is_kept_open_opens_and_stays_open_over_a_restart(script: Script) -> None:
    script.accept(PinDoor(KIM, DOOR1, DoorPosition.OPEN, "moving in"))
    script.run(90)
    assert script.device(DOOR1).state == "open"
    assert script.refuse(CLOSE).reason == "DOOR1 is kept open by kim: moving in"
    script.restart()
    script.obey()
    script.run(10)
    view = script.device(DOOR1)
    assert view.pin is not None
    assert (view.state, view.pin.owner, view.pin.position, view.pin.reason) == ("open", "kim", "open", "moving in")


def test_a_pin_is_its_owners_to_change_and_buffers_have_none(script: Script) -> None:
    pin = PinDoor(KIM, DOOR1, DoorPosition.OPEN, "moving in")
    assert script.refuse(UnpinDoor(KIM, DOOR1)).code == "conflict"
    script.accept(pin)
    assert script.refuse(PinDoor(LEE, DOOR1, DoorPosition.CLOSED, "draught")).reason == "DOOR1 is kept open by kim"
    script.accept(PinDoor(KIM, DOOR1, DoorPosition.CLOSED, "done"))
    script.run(6)
    assert script.device(DOOR1).state == "closed"
    assert script.refuse(PinDoor(KIM, BUFFER1, DoorPosition.OPEN, "x")).field == "device"


def test_a_door_cannot_be_kept_closed_while_somebody_is_in_it(script: Script) -> None:
    go(script, "107")
    at(script, "107")
    refusal = script.refuse(PinDoor(KIM, DOOR1, DoorPosition.CLOSED, "cleaning"))
    assert refusal.reason == "DOOR1 cannot close: V001 is in it"


# -- lockout and service -------------------------------------------------------------------------------------------------


def test_a_lockout_blocks_commands_and_grants_until_its_owner_lifts_it(script: Script, hall: ToyHall) -> None:
    script.accept(LockOutDevice(KIM, DOOR1, "motor"))
    go(script, "110")
    script.run(15)
    assert "locked out by kim: motor" in script.vehicle(V1).waiting
    for request in (OPEN, PinDoor(LEE, DOOR1, DoorPosition.OPEN, "x")):
        refusal = script.refuse(request)
        assert (refusal.reason, refusal.remedy) == ("DOOR1 is locked out by kim: motor", "lift the lockout first")
    assert script.refuse(LockOutDevice(LEE, DOOR1, "me too")).remedy == "ask kim"
    assert not hall.door().is_open
    script.accept(LiftDeviceLockout(KIM, DOOR1))
    at(script, "110")
    assert hall.violations == []


def test_a_lockout_is_lifted_by_two_others_together_and_outlives_a_restart(script: Script) -> None:
    assert script.refuse(LiftDeviceLockout(KIM, DOOR1)).code == "conflict"
    script.accept(LockOutDevice(KIM, DOOR1, "motor"))
    script.restart()
    script.obey()
    assert "lockout is kim's" in script.refuse(LiftDeviceLockout(LEE, DOOR1)).reason
    assert script.refuse(LiftDeviceLockout(LEE, DOOR1)).code == "not-now"
    script.accept(LiftDeviceLockout(PAK, DOOR1))
    assert script.device(DOOR1).lockout is None


def test_a_lockout_stops_who_is_granted_the_way_and_can_still_stop(script: Script, hall: ToyHall) -> None:
    go(script, "110")
    while "107" not in script.vehicle(V1).ahead:
        script.run(0.25)
    script.accept(LockOutDevice(KIM, DOOR1, "people"))
    script.run(20)
    assert script.toys[V1].barcode in {"105", "106"}
    assert hall.door().is_open


def test_out_of_service_a_door_is_left_to_people(script: Script, hall: ToyHall) -> None:
    script.accept(SetDeviceService(KIM, DOOR1, "new controller"))
    go(script, "110")
    script.run(15)
    assert "out of service: new controller" in script.vehicle(V1).waiting
    script.accept(OPEN)
    script.run(4)
    assert hall.door().is_open
    assert script.toys[V1].barcode == "106"
    script.accept(SetDeviceService(KIM, DOOR1, ""))
    at(script, "110")
    assert hall.violations == []


def test_a_charger_is_shown_with_its_place_and_its_service(script: Script) -> None:
    view = script.device(CHARGER1)
    assert (view.kind, view.barcode, view.link, view.state, view.alarm) == ("charger", "105", None, None, "")
    script.accept(SetDeviceService(KIM, CHARGER1, "no current"))
    assert (script.device(CHARGER1).service, script.device(CHARGER1).out_of_service) == ("out_of_service", "no current")
    assert script.fleet.devices.all[CHARGER1].barred == "out of service: no current"


def test_who_charges_at_a_charger_is_shown(script: Script) -> None:
    devices, books = script.fleet.devices, script.fleet.books
    devices.charging(CHARGER1, V1)
    assert view_of_device(devices.all[CHARGER1], books).vehicles == ("V001",)
    devices.charging(CHARGER1, None)
    assert view_of_device(devices.all[CHARGER1], books).vehicles == ()


def test_every_decision_is_a_durable_event_under_the_devices_name(script: Script) -> None:
    decisions: list[Any] = [
        LockOutDevice(KIM, DOOR1, "motor"),
        LiftDeviceLockout(KIM, DOOR1),
        PinDoor(KIM, DOOR1, DoorPosition.OPEN, "air"),
        UnpinDoor(LEE, DOOR1),
        SetDeviceService(KIM, DOOR1, "old"),
        SetDeviceService(KIM, DOOR1, ""),
    ]
    for decision in decisions:
        script.accept(decision)
    told = [(str(e.vehicle), e.detail) for e in script.history() if e.event == "DeviceChanged"]
    assert told == [
        (DOOR1, "DOOR1 is locked out (motor) by kim"),
        (DOOR1, "DOOR1 is locked out no more by kim"),
        (DOOR1, "DOOR1 is kept open (air) by kim"),
        (DOOR1, "DOOR1 is given back to the vehicles by lee"),
        (DOOR1, "DOOR1 is taken out of service (old) by kim"),
        (DOOR1, "DOOR1 is in service by kim"),
    ]
