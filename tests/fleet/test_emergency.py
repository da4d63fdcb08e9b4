"""Fire and earthquake: all stops, doors do as configured, and a named person ends it (DOMAIN section 7)."""

import pytest

from app.domain.commands import Move, Plain, Simple
from app.domain.device_requests import CommandDevice, RaiseEmergency, ReleaseEmergency
from app.domain.devices import DeviceAct
from app.domain.ids import Actor
from app.domain.layout import OnEmergency
from app.domain.records import EmergencyKind
from app.domain.requests import ResumeController
from tests.fleet.drives import KIM, go
from tests.fleet.hall_plants import DOOR1, ring
from tests.fleet.script import FOUP1, P1, V1, V2, Script

PANEL = Actor("fire-panel")
FIRE = RaiseEmergency(PANEL, EmergencyKind.FIRE, "smoke in bay 2")
QUAKE = RaiseEmergency(PANEL, EmergencyKind.EARTHQUAKE, "magnitude 5")
OVER = ReleaseEmergency(KIM, EmergencyKind.FIRE, "false alarm, seen")


def begun(on_emergency: OnEmergency = OnEmergency.LEAVE) -> Script:
    script = Script(ring(on_emergency=on_emergency))
    script.fill(P1, FOUP1)
    script.obey()
    script.forget()
    return script


def test_everything_that_moves_is_stopped_and_nothing_else_begins() -> None:
    script = begun()
    go(script, "105")
    go(script, "116", V2)
    script.run(1.5)
    script.accept(FIRE)
    stops = {s.vehicle for s in script.sends if s.command == Simple(Plain.STOP_BY_HOST)}
    assert stops == {V1, V2}
    script.run(10)
    places = {name: toy.barcode for name, toy in script.toys.items()}
    script.forget()
    script.order("P1", "P3")
    script.run(30)
    assert {name: toy.barcode for name, toy in script.toys.items()} == places
    assert not [s for s in script.sends if isinstance(s.command, Move)]
    assert script.fleet.books.controller.reason == "fire: smoke in bay 2 (fire-panel)"
    assert script.vehicle(V1).record.hold is None


def test_a_waiting_vehicle_says_what_was_told_and_by_whom() -> None:
    script = begun()
    go(script, "105")
    script.run(1.5)
    script.accept(FIRE)
    script.run(5)
    assert script.vehicle(V1).waiting == f"V001 waits at {script.toys[V1].barcode}: fire, told by fire-panel"


def test_it_outlives_a_restart_and_needs_a_named_release_before_anybody_resumes() -> None:
    script = begun()
    script.accept(FIRE)
    script.restart()
    script.obey()
    refusal = script.refuse(ResumeController(KIM))
    assert refusal.reason == "fire told by fire-panel: smoke in bay 2"
    assert script.refuse(ReleaseEmergency(KIM, EmergencyKind.EARTHQUAKE, "x")).reason == "no earthquake is told"
    script.accept(OVER)
    assert script.fleet.books.controller.state.value == "paused"
    script.accept(ResumeController(KIM))
    go(script, "105")
    script.run(10)
    assert script.toys[V1].barcode == "105"
    told = [e for e in script.events() if e.startswith(("Emergency", "Controller"))]
    assert told == ["EmergencySet", "ControllerPaused", "EmergencyReleased", "ControllerAuto"]


def test_overlapping_emergencies_are_all_to_be_released() -> None:
    script = begun()
    script.accept(FIRE)
    script.accept(QUAKE)
    script.accept(FIRE)
    assert len(script.fleet.books.controller.emergencies) == 2
    script.accept(OVER)
    assert script.refuse(ResumeController(KIM)).reason == "earthquake told by fire-panel: magnitude 5"
    script.accept(ReleaseEmergency(KIM, EmergencyKind.EARTHQUAKE, "over"))
    script.accept(ResumeController(KIM))


@pytest.mark.parametrize(("configured", "state"), [("open", "open"), ("close", "closed"), ("leave", "closed")])
def test_doors_do_as_the_plant_says(configured: str, state: str) -> None:
    script = begun(OnEmergency(configured))
    script.accept(FIRE)
    script.run(10)
    assert script.device(DOOR1).state == state


def test_a_door_that_is_to_open_in_a_fire_cannot_be_closed_by_anybody() -> None:
    script = begun(OnEmergency.OPEN)
    script.accept(FIRE)
    script.run(5)
    refusal = script.refuse(CommandDevice(KIM, DOOR1, DeviceAct.CLOSE))
    assert (refusal.reason, refusal.remedy) == ("DOOR1 is kept open: fire", "release the emergency first")


def test_a_fire_door_does_not_close_on_a_vehicle() -> None:
    script = begun(OnEmergency.CLOSE)
    assert script.hall
    go(script, "110")
    while script.toys[V1].barcode != "106":
        script.run(0.25)
    script.accept(FIRE)
    script.run(30)
    assert script.device(DOOR1).state == "open"
    assert script.device(DOOR1).vehicles == ("V001",)
    assert script.hall.violations == []


def test_a_move_decided_just_before_does_not_leave() -> None:
    script = begun()
    go(script, "105")
    move = script.last(Move, V1)
    script.accept(FIRE)
    assert script.fleet.objection(move) == "fire"
