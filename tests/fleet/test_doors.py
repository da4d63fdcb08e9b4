"""Doors across the track: opened before, closed behind, never on a vehicle (DOMAIN section 7, scenario S56)."""

import pytest

from app.domain.commands import Move, Plain, Simple
from app.domain.device_requests import CommandDevice
from app.domain.devices import DeviceAct, DeviceNotAccepted, DeviceRequest, DeviceRequestId
from app.domain.ids import CmdId
from app.domain.layout import Plant
from app.domain.records import Intent, IntentState
from app.domain.requests import CommandVehicle
from app.domain.units import Barcode, Seconds
from app.fleet.devices import RETRY
from app.protocols.enig.messages import Close, Open
from tests.fleet.drives import KIM, go, names, path_of
from tests.fleet.hall import ToyHall
from tests.fleet.hall_plants import BUFFER1, DOOR1, ring, two_way
from tests.fleet.script import V1, V2, Script

OPEN = CommandDevice(KIM, DOOR1, DeviceAct.OPEN)


def begun(plant: Plant | None = None) -> tuple[Script, ToyHall]:
    """Return a fleet with its hall, all connected and settled."""
    script = Script(plant or ring())
    script.obey()
    script.forget()
    assert script.hall is not None
    return script, script.hall


def asked(script: Script, state: IntentState | None = None) -> list[str]:
    """Return what the door was asked in order, each once; of a state as last kept, or of any."""
    last: dict[CmdId, Intent] = {i.cmd_id: i for i in script.kept_intents() if str(i.vehicle) == DOOR1}
    return [intent.kind for intent in last.values() if state in {None, intent.state}]


def stopped(script: Script) -> bool:
    return any(s.command == Simple(Plain.STOP_BY_HOST) for s in script.sends)


def run_to(script: Script, barcode: str, vehicle: str = V1) -> None:
    """Let time pass until a toy is at a barcode."""
    for _ in range(400):
        if script.toys[V1 if vehicle == V1 else V2].barcode == barcode:
            return
        script.run(0.25)
    raise AssertionError(f"it does not come to {barcode}")


# -- before and behind ---------------------------------------------------------------------------------------------------


def test_a_door_opens_before_a_vehicle_which_does_not_stop_for_it_and_closes_behind() -> None:
    script, hall = begun()
    go(script, "110")
    run_to(script, "106")
    assert script.toys[V1].moving is not None
    assert script.now < 9
    run_to(script, "110")
    script.run(6)
    assert asked(script, IntentState.DONE) == ["open", "close"]
    assert script.device("DOOR1").state == "closed"
    assert hall.violations == []


def test_a_door_that_nobody_comes_near_stays_closed() -> None:
    script, _ = begun()
    go(script, "104")
    script.run(10)
    assert asked(script) == []


def test_nothing_is_granted_through_a_door_before_its_status_says_open() -> None:
    script, hall = begun()
    hall.door().obstruct(script.now)
    go(script, "110")
    script.run(15)
    assert script.toys[V1].barcode == "106"
    assert "107" not in script.fleet.books.traffic.held(V1)
    view = script.device("DOOR1")
    assert (view.state, view.waiting) == ("error", ("V001",))
    assert script.vehicle(V1).waiting.startswith("V001 waits at 106 for door DOOR1 (error, ")


def test_a_wait_says_what_the_door_does_and_for_how_long() -> None:
    script, hall = begun()
    go(script, "106")
    run_to(script, "106")
    script.run(8)
    assert script.device("DOOR1").state == "closed"
    go(script, "110")
    script.run(1.5)
    assert script.vehicle(V1).waiting == "V001 waits at 106 for door DOOR1 (opening, 1 s)"
    assert hall.violations == []


def test_a_stuck_door_is_an_alarm_and_when_a_person_has_cleared_it_the_vehicle_goes_on() -> None:
    script, hall = begun()
    hall.door().obstruct(script.now)
    go(script, "110")
    script.run(5)
    assert script.device("DOOR1").alarm == "reports an error (255)"
    assert script.device("DOOR1").remedy == "see what is in its way at the door, then open or close it"
    hall.door().clear(script.now)
    script.run(RETRY + 5)
    run_to(script, "110")
    assert script.device("DOOR1").alarm == ""
    told = [(e.event, str(e.vehicle)) for e in script.history() if e.event.startswith("Alarm")]
    assert told == [("AlarmSet", DOOR1), ("AlarmCleared", DOOR1)]
    assert hall.violations == []


def test_a_door_in_error_is_never_asked_to_close_by_us() -> None:
    script, hall = begun()
    hall.door().obstruct(script.now)
    script.run(60)
    assert asked(script) == []


def test_a_normally_open_door_is_left_open() -> None:
    script, hall = begun(ring(normally_open=True))
    go(script, "110")
    run_to(script, "110")
    script.run(30)
    assert asked(script) == []
    assert script.device("DOOR1").state == "open"
    assert hall.violations == []


def test_a_door_that_closes_is_opened_again_for_the_next_vehicle() -> None:
    script, hall = begun()
    go(script, "110")
    run_to(script, "110")
    while script.device("DOOR1").pending != "close":
        script.run(0.25)
    go(script, "111")
    script.run(1)
    go(script, "104", V2)
    run_to(script, "104", V2)
    go(script, "108", V2)
    run_to(script, "108", V2)
    script.run(8)
    assert hall.violations == []
    assert script.device("DOOR1").pending == ""


def test_an_open_that_overtakes_a_close_leaves_neither_unsettled() -> None:
    script, hall = begun()
    go(script, "106")
    run_to(script, "106")
    go(script, "107")
    run_to(script, "107")
    go(script, "112")
    while script.device("DOOR1").pending != "close":
        script.run(0.25)
    script.accept(OPEN)
    assert "open" in script.device("DOOR1").pending
    script.run(5)
    assert script.device("DOOR1").pending == ""
    assert script.device("DOOR1").state == "open"
    assert asked(script, IntentState.SETTLED_NOT_DONE) == ["close"]
    assert hall.violations == []


# -- length and both ways ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("length", [0, 1000, 3000, 5000])
def test_a_door_on_two_way_track_lets_through_either_way_and_stays_open_for_the_whole_length(length: int) -> None:
    script, hall = begun(two_way(length))
    for goal in ("209", "202"):
        go(script, goal)
        run_to(script, goal)
        script.run(10)
        assert script.device("DOOR1").state == "closed", goal
    assert hall.violations == []
    assert asked(script, IntentState.DONE) == ["open", "close"] * 2


def test_a_door_stays_open_while_a_vehicle_stands_with_its_tail_in_it() -> None:
    script, hall = begun(two_way())
    go(script, "206")
    run_to(script, "206")
    script.run(30)
    assert script.device("DOOR1").state == "open"
    assert script.device("DOOR1").vehicles == ("V001",)
    go(script, "207")
    run_to(script, "207")
    script.run(6)
    assert script.device("DOOR1").state == "closed"
    assert hall.violations == []


def test_a_vehicle_that_came_to_the_door_from_its_own_side_does_not_keep_it_open() -> None:
    script, _ = begun(two_way())
    go(script, "205")
    run_to(script, "205")
    script.accept(OPEN)
    script.run(70)
    assert script.device("DOOR1").state == "closed"


# -- restart -------------------------------------------------------------------------------------------------------------


def test_a_door_found_open_after_a_restart_closes_if_nobody_needs_it() -> None:
    script, hall = begun()
    script.accept(OPEN)
    script.run(4)
    assert script.device("DOOR1").state == "open"
    script.restart()
    script.obey()
    script.run(8)
    assert script.device("DOOR1").state == "closed"
    assert hall.violations == []


@pytest.mark.parametrize("barcode", ["104", "105", "106", "107", "108"])
def test_a_restart_while_a_vehicle_is_at_the_door_never_closes_it_on_the_vehicle(barcode: str) -> None:
    script, hall = begun()
    go(script, "110")
    run_to(script, barcode)
    script.restart(0.5)
    hall.connect()
    script.run(6)
    script.obey(V1)
    script.obey(V2)
    go(script, "110")
    run_to(script, "110")
    script.run(8)
    assert hall.violations == []
    assert script.device("DOOR1").state == "closed"


def test_a_vehicle_found_standing_in_a_door_after_a_restart_keeps_it_open() -> None:
    script, hall = begun(two_way())
    go(script, "206")
    run_to(script, "206")
    script.run(3)
    script.restart()
    script.obey()
    script.run(30)
    assert script.device("DOOR1").state == "open"
    assert script.device("DOOR1").vehicles == ("V001",)
    assert hall.violations == []


def test_before_every_vehicle_has_said_where_it_is_no_door_closes() -> None:
    script = Script(ring())
    assert script.hall
    script.hall.connect()
    script.hall.door().take(Open(), script.now)
    script.run(10)
    assert script.device("DOOR1").state == "open"
    assert script.device("DOOR1").vehicles == ("V001", "V002")
    script.obey()
    script.run(8)
    assert script.device("DOOR1").state == "closed"


def test_what_a_lost_line_leaves_open_is_settled_by_status() -> None:
    script, hall = begun()
    go(script, "110")
    run_to(script, "110")
    while script.device("DOOR1").pending != "close":
        script.run(0.25)
    hall.cut()
    script.run(4)
    assert asked(script, IntentState.UNKNOWN) == ["close"]
    hall.connect()
    script.run(4)
    assert asked(script, IntentState.SETTLED_DONE) == ["close"]
    assert script.device("DOOR1").pending == ""


def test_a_close_that_a_killed_controller_left_open_bars_the_door_until_it_is_settled() -> None:
    script, hall = begun()
    go(script, "110")
    run_to(script, "110")
    while script.device("DOOR1").pending != "close":
        script.run(0.25)
    script.restart(0.1)
    assert script.device("DOOR1").pending == "close"
    script.obey()
    script.run(3)
    settled = [
        i.outcome for i in script.kept_intents() if str(i.vehicle) == DOOR1 and i.state is IntentState.SETTLED_DONE
    ]
    assert settled == ["by Status: closed"]
    assert hall.violations == []


# -- when it fails -------------------------------------------------------------------------------------------------------


def test_a_vehicle_that_can_still_stop_is_stopped_before_a_door_that_falls_silent_and_goes_on_when_it_is_back() -> None:
    script, hall = begun()
    go(script, "110")
    while "107" not in script.vehicle(V1).ahead:
        script.run(0.25)
    assert script.toys[V1].barcode == "104"
    hall.cut()
    script.run(8)
    assert stopped(script)
    assert script.vehicle(V1).record.hold is None
    assert script.toys[V1].barcode == "106"
    assert "for door DOOR1 (silent: cut" in script.vehicle(V1).waiting
    hall.connect()
    run_to(script, "110")
    script.run(8)
    assert script.device("DOOR1").state == "closed"
    assert hall.violations == []


def test_a_vehicle_that_cannot_stop_any_more_keeps_its_grant_and_people_are_told() -> None:
    script, hall = begun()
    go(script, "110")
    run_to(script, "106")
    hall.cut()
    script.run(0.5)
    assert not stopped(script)
    run_to(script, "108")
    hall.connect()
    script.run(10)
    assert script.toys[V1].barcode == "110"


def test_somebody_who_can_no_longer_be_stopped_before_a_door_in_error_is_named() -> None:
    script, _ = begun()
    go(script, "110")
    run_to(script, "106")
    door = script.fleet.devices.all[DOOR1]
    door.fresh, door.reason = False, "silent"
    script.fleet.doors.mind([door])
    assert door.trouble == ("is not open, and V001 cannot be stopped before it any more", "look at DOOR1 and V001")


def test_being_stopped_for_a_door_is_never_held_against_a_vehicle() -> None:
    script, hall = begun()
    for _ in range(4):
        go(script, "110")
        while "107" not in script.vehicle(V1).ahead:
            script.run(0.25)
        hall.cut()
        script.run(8)
        assert script.vehicle(V1).record.hold is None
        hall.connect()
        run_to(script, "110")
        go(script, "103")
        run_to(script, "103")
        script.run(5)
    assert stopped(script)
    assert hall.violations == []


def test_a_vehicle_stopped_by_a_person_inside_a_door_keeps_it_open() -> None:
    script, _ = begun()
    go(script, "110")
    run_to(script, "106")
    assert script.toys[V1].moving
    script.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    script.run(30)
    assert script.vehicle(V1).ahead == []
    assert script.device("DOOR1").vehicles == ("V001",)
    assert script.device("DOOR1").state == "open"


def test_a_door_that_somebody_closes_by_hand_bars_the_way_and_is_opened_again() -> None:
    script, hall = begun()
    go(script, "110")
    while "107" not in script.vehicle(V1).ahead:
        script.run(0.25)
    hall.door().take(Close(), script.now)
    script.run(1)
    assert stopped(script)
    run_to(script, "110")
    assert hall.violations == []


def test_a_move_through_a_door_that_fails_while_it_is_written_down_does_not_leave() -> None:
    script, hall = begun()
    script.accept(OPEN)
    script.run(4)
    go(script, "105")
    run_to(script, "105")
    script.forget()
    go(script, "110")
    move = script.last(Move, V1)
    assert "107" in names(path_of(move))
    assert script.fleet.objection(move) == ""
    hall.cut()
    assert script.fleet.objection(move) == "DOOR1 on its way is silent: cut"


def test_a_close_does_not_leave_if_somebody_has_come_into_the_door_meanwhile() -> None:
    script, _ = begun()
    script.accept(OPEN)
    script.run(4)
    intent = script.fleet.devices.ask(script.fleet.devices.all[DOOR1], DeviceAct.CLOSE, KIM)
    request = DeviceRequest(DeviceRequestId(intent.cmd_id), DOOR1, DeviceAct.CLOSE)
    assert script.fleet.device_objection(request) == ""
    script.fleet.books.traffic.hold(V1, [Barcode("107")])
    assert script.fleet.device_objection(request) == "V001 may be in it"


def test_a_door_that_does_not_do_what_it_is_told_is_an_alarm_and_asked_again_later() -> None:
    script, _ = begun()
    door = script.fleet.devices.all[DOOR1]
    go(script, "105")
    intent = script.fleet.devices.ask(door, DeviceAct.OPEN, KIM)
    script.hear_device(DeviceNotAccepted(DOOR1, DeviceRequestId(intent.cmd_id), "Status shows no effect", "look"))
    assert script.device("DOOR1").alarm == "does not open: Status shows no effect"
    assert script.fleet.devices.may_ask(door, DeviceAct.OPEN) is False
    script.fleet.books.now = Seconds(script.now + RETRY)
    assert script.fleet.devices.may_ask(door, DeviceAct.OPEN) is True


def test_a_door_that_has_never_been_heard_is_an_alarm_after_a_while() -> None:
    script = Script(ring())
    script.run(3)
    assert script.device("DOOR1").alarm == ""
    script.run(5)
    assert script.device("DOOR1").alarm == "is silent: not connected yet"
    assert script.device(BUFFER1).alarm == "is silent: not connected yet"
