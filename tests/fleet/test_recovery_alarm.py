"""Alarm recovery as one command: the sequence, its condition, and everything that can stop it (PROTOCOLS 6.2)."""

import pytest

from app.domain.commands import Move, Plain, Send, Simple
from app.domain.device_requests import RaiseEmergency
from app.domain.errors import Refusal
from app.domain.events import Unknown
from app.domain.ids import Actor
from app.domain.records import EmergencyKind, IntentState
from app.domain.requests import CommandVehicle, HoldVehicle, LockVehicle, MoveVehicle, RecoverAlarm, Request
from app.domain.units import Barcode
from app.domain.vehicle import Condition
from app.fleet.vehicle import Stage
from tests.fleet.script import V1, Script, words

KIM = Actor("kim")
RECOVER, CONFIRMED = RecoverAlarm(KIM, V1), RecoverAlarm(KIM, V1, confirmed=True)


def state(
    *,
    servos: bool = True,
    found: bool = True,
    home: bool = True,
    mode: int = 0,
    alarm: bool = False,
    oper: int = 0,
    axes: int = 0x111134,
    trav: int = 0,
) -> Condition:
    """Return a condition, by default of a vehicle in MANT that wants for nothing; ``alarm`` is ALARM 300."""
    flags = 8 | home << 2 | found << 1 | servos
    return words(mode=mode, flags=flags, oper=1 if alarm else oper, code=300 * alarm, axes=axes, trav=trav)


IN_ALARM = state(mode=3, alarm=True)


def alarmed(ready: Script, condition: Condition | None = None) -> Script:
    """V001 is in ALARM 300 and on hold for it."""
    ready.toys[V1].linked = False
    for _ in range(3):
        ready.wait(1.1)
        ready.report(V1, "103", condition or IN_ALARM)
    assert hold(ready) == "alarm 300 (no name under alarm_codes)"
    ready.forget()
    return ready


def hold(script: Script) -> str:
    """Return why V001 is on hold."""
    held = script.vehicle(V1).record.hold
    return held.reason if held else ""


def sent(script: Script) -> list[Plain]:
    """Return the plain commands sent to V001."""
    return [s.command.what for s in script.sends if isinstance(s.command, Simple) and s.vehicle == V1]


def obeyed(script: Script, then: Condition, *, ok: bool = True) -> Send:
    """The last command is answered, and the next STATUS shows this."""
    send = script.sends[-1]
    script.acknowledge(send)
    script.answer(send, "103", then, ok=ok)
    script.wait(0.5)
    script.report(V1, "103", then)
    return send


def test_an_alarm_holds_the_vehicle_and_says_how_to_recover_it(ready: Script) -> None:
    alarmed(ready)
    record = ready.vehicle(V1).record
    assert record.hold is not None
    assert record.hold.remedy == "clear the cause, then POST /api/v1/vehicles/V001/recover"
    assert ready.vehicle(V1).waiting == "V001 is in ALARM 300"


def test_an_alarm_with_a_name_in_the_plant_file_is_named(ready: Script) -> None:
    ready.toys[V1].linked = False
    for _ in range(3):
        ready.wait(1.1)
        ready.report(V1, "103", words(oper=1, code=0x65))
    assert hold(ready) == "alarm 101 wrong barcode"
    alarm = next(e for e in ready.history() if e.event == "AlarmSet")
    assert (alarm.vehicle, alarm.detail) == (V1, "101 wrong barcode")


def test_the_whole_sequence_in_its_order_each_step_on_a_fresh_status(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    assert sent(ready) == []
    assert ready.polls == [V1]
    ready.report(V1, "103", IN_ALARM)
    obeyed(ready, state(alarm=True))
    obeyed(ready, state(servos=False, found=False, home=False, axes=0x111134))
    obeyed(ready, state(found=False, home=False))
    obeyed(ready, state())
    obeyed(ready, state(mode=3))
    assert sent(ready) == [Plain.STOP, Plain.ALARM_CLEAR, Plain.SERVO_ON, Plain.SEARCH_HOME, Plain.AUTO]
    assert hold(ready) == ""
    assert {"AlarmCleared", "VehicleReleased"} <= set(ready.events())
    ready.stand(V1, "103", link=False)
    assert ready.vehicle(V1).stage is Stage.READY


def test_go_home_takes_the_place_of_search_home_where_the_home_position_is_known(ready: Script) -> None:
    alarmed(ready, state(alarm=True))
    ready.accept(RECOVER)
    ready.report(V1, "103", state(alarm=True))
    obeyed(ready, state(home=False))
    obeyed(ready, state())
    obeyed(ready, state(mode=3))
    assert sent(ready) == [Plain.ALARM_CLEAR, Plain.GO_HOME, Plain.AUTO]


def test_a_vehicle_that_stands_in_auto_with_an_axis_away_from_home_is_recovered_too(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    ready.stand(V1, "103", state(mode=3, home=False), link=False)
    ready.forget()
    ready.accept(RECOVER)
    ready.report(V1, "103", state(mode=3, home=False))
    assert sent(ready) == [Plain.STOP]


def test_a_vehicle_in_semi_is_brought_to_mant_first(ready: Script) -> None:
    alarmed(ready, state(mode=1, alarm=True))
    ready.accept(RECOVER)
    ready.report(V1, "103", state(mode=1, alarm=True))
    assert sent(ready) == [Plain.STOP]


@pytest.mark.parametrize(
    ("axes", "named"),
    [
        (0x110134, "LIFT stop"),
        (0x111534, "SLID "),
        (0x011134, "SHFT stop"),
        (0x111114, "GRIP "),
        (0x118134, "LIFT "),
    ],
    ids=["lift", "slid", "shft", "grip", "driving"],
)
def test_homing_with_an_axis_out_needs_a_person_who_has_looked(ready: Script, axes: int, named: str) -> None:
    alarmed(ready, state(mode=3, axes=axes, alarm=True))
    refused = ready.refuse(RECOVER)
    assert named in refused.reason
    assert refused.field == "confirmed"
    assert sent(ready) == []
    ready.accept(CONFIRMED)
    ready.report(V1, "103", state(mode=3, axes=axes, alarm=True))
    obeyed(ready, state(axes=axes, home=False, alarm=True))
    obeyed(ready, state(axes=axes, home=False))
    assert sent(ready) == [Plain.STOP, Plain.ALARM_CLEAR, Plain.GO_HOME]


def test_an_axis_that_goes_astray_during_the_recovery_stops_it_before_homing(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", state(axes=0x110134, home=False))
    assert sent(ready) == []
    assert "not homed, because LIFT stop" in hold(ready)


def test_asking_twice_begins_once(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    assert sent(ready) == [Plain.STOP]


def test_while_it_runs_other_commands_wait(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    assert "recovery" in ready.refuse(CommandVehicle(KIM, V1, Plain.SERVO_OFF)).reason
    assert isinstance(ready.ask(MoveVehicle(KIM, V1, Barcode("104"))), Refusal)


def test_a_step_that_ends_abnormally_stops_the_sequence_and_says_which(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    obeyed(ready, state(alarm=True))
    obeyed(ready, state(alarm=True), ok=False)
    assert hold(ready) == "alarm recovery stopped: alarm_clear ended abnormally (no reason given)"
    ready.stand(V1, "103", state(alarm=True), link=False)
    assert hold(ready).startswith("alarm recovery stopped")
    assert ready.vehicle(V1).recovery is None


@pytest.mark.parametrize("why", [Unknown.NO_ACK, Unknown.NO_ANSWER])
def test_a_step_without_an_answer_stops_the_sequence(ready: Script, why: Unknown) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    ready.unanswered(ready.sends[-1], why)
    assert hold(ready) == f"alarm recovery stopped: {why.value}"


def test_a_step_that_could_not_be_sent_stops_the_sequence(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    ready.not_sent(ready.sends[-1], "a stop is under way")
    assert hold(ready) == "alarm recovery stopped: a stop is under way"


def test_a_lost_link_stops_the_sequence(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    ready.link_down(V1)
    assert hold(ready) == "alarm recovery stopped: the link was lost"
    assert ready.vehicle(V1).recovery is None


def test_a_sequence_without_any_status_is_given_up_after_a_minute(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.wait(59)
    assert ready.vehicle(V1).recovery
    ready.wait(3)
    assert hold(ready) == "alarm recovery stopped: nothing came of it for 60 s"


def test_a_vehicle_that_answers_on_acceptance_is_waited_for_and_told_nothing_twice(ready: Script) -> None:
    alarmed(ready)
    ready.accept(CONFIRMED)
    ready.report(V1, "103", state(servos=False))
    send = ready.sends[-1]
    ready.answer(send, "103", state(servos=False))
    for _ in range(3):
        ready.wait(0.5)
        ready.report(V1, "103", state(servos=False))
    assert sent(ready) == [Plain.SERVO_ON]
    ready.report(V1, "103", state(home=False))
    ready.answer(ready.sends[-1], "103", state(home=False))
    ready.report(V1, "103", state(home=False, oper=2))
    assert sent(ready) == [Plain.SERVO_ON, Plain.GO_HOME]
    ready.report(V1, "103", state())
    assert sent(ready) == [Plain.SERVO_ON, Plain.GO_HOME, Plain.AUTO]


def test_a_vehicle_that_still_works_is_waited_for(ready: Script) -> None:
    alarmed(ready)
    ready.accept(CONFIRMED)
    ready.report(V1, "103", words(oper=2, trav=8))
    assert sent(ready) == []
    ready.report(V1, "103", IN_ALARM)
    assert sent(ready) == [Plain.STOP]


def test_an_answer_to_somebody_elses_command_does_not_drive_the_sequence(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.stand(V1, "103", state(), link=False)
    ready.accept(CommandVehicle(KIM, V1, Plain.SERVO_OFF))
    foreign = ready.sends[-1]
    ready.accept(RECOVER)
    ready.answer(foreign, "103", state(servos=False))
    ready.report(V1, "103", state())
    assert sent(ready)[-1] is Plain.AUTO
    ready.unanswered(foreign)
    assert ready.vehicle(V1).recovery


def test_a_doubted_place_is_not_believed_because_its_alarm_is_cleared(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, Barcode("109")))
    ready.toys[V1].linked = False
    ready.acknowledge(ready.last(Move))
    ready.report(V1, "107", state(mode=3, trav=8, alarm=True), seq=2, polled=False)
    doubt = hold(ready)
    ready.answer(ready.last(Move), "107", IN_ALARM, ok=False, seq=2)
    ready.wait(1.1)
    ready.report(V1, "107", IN_ALARM, seq=2)
    ready.accept(RECOVER)
    ready.report(V1, "107", words(), seq=2)
    assert hold(ready) == doubt
    for _ in range(3):
        ready.wait(1.1)
        ready.report(V1, "107", words(), seq=2)
    assert ready.vehicle(V1).stage is Stage.SETTLING


def test_every_command_of_the_sequence_is_a_durable_intent_in_the_persons_name(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    obeyed(ready, state(alarm=True))
    stop = next(i for i in ready.kept_intents() if i.kind == "stop")
    assert (stop.actor, stop.state) == (KIM, IntentState.OPEN)
    assert [i.state for i in ready.kept_intents() if i.kind == "stop"][-1] is IntentState.DONE


def test_what_a_person_holds_stays_held_when_its_alarm_is_recovered(ready: Script) -> None:
    ready.accept(HoldVehicle(KIM, V1, "a screw is loose"))
    ready.toys[V1].linked = False
    ready.wait(1.1)
    ready.report(V1, "103", state(alarm=True))
    ready.accept(RECOVER)
    ready.report(V1, "103", state(alarm=True))
    obeyed(ready, state())
    obeyed(ready, state(mode=3))
    assert "AlarmCleared" in ready.events()
    assert hold(ready) == "held by kim: a screw is loose"


def test_a_recovery_that_stops_leaves_the_hold_of_a_person_to_that_person(ready: Script) -> None:
    ready.accept(HoldVehicle(KIM, V1, "a screw is loose"))
    ready.toys[V1].linked = False
    for _ in range(2):
        ready.wait(1.1)
        ready.report(V1, "103", state(alarm=True))
        ready.accept(RECOVER)
        ready.report(V1, "103", state(alarm=True))
        obeyed(ready, state(alarm=True), ok=False)
    assert hold(ready).startswith("held by kim: a screw is loose; alarm recovery stopped: alarm_clear ended abnormally")
    assert hold(ready).count("stopped") == 1


def test_a_vehicle_that_wants_for_nothing_is_not_recovered(ready: Script) -> None:
    assert ready.refuse(RECOVER).remedy == "nothing needs to be done"
    ready.accept(HoldVehicle(KIM, V1, "a screw is loose"))
    refusal = ready.refuse(CONFIRMED)
    assert refusal.reason == "V001 is in AUTO, homed and without an alarm"
    assert refusal.remedy == "POST /api/v1/vehicles/V001/release"
    assert hold(ready) == "held by kim: a screw is loose"
    assert "AlarmCleared" not in ready.events()


def test_a_lockout_ends_the_sequence_before_its_next_command(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    ready.accept(LockVehicle(Actor("lee"), V1, "belt"))
    obeyed(ready, state(alarm=True))
    ready.wait(5.0)
    ready.report(V1, "103", state(servos=False))
    assert sent(ready) == [Plain.STOP]
    assert hold(ready) == "alarm recovery stopped: locked out by lee"


def test_an_emergency_ends_the_sequence_and_none_begins(ready: Script) -> None:
    alarmed(ready)
    ready.accept(RECOVER)
    ready.report(V1, "103", IN_ALARM)
    ready.accept(RaiseEmergency(KIM, EmergencyKind.FIRE, "smoke"))
    obeyed(ready, state(alarm=True))
    assert sent(ready) == [Plain.STOP]
    refusal = ready.refuse(RECOVER)
    assert (refusal.reason, refusal.remedy) == ("nothing moves: fire", "release the emergency first")
    for what in (Plain.SERVO_ON, Plain.SEARCH_HOME, Plain.AUTO):
        assert ready.refuse(CommandVehicle(KIM, V1, what)).reason == "nothing moves: fire"


@pytest.mark.parametrize("comes", [LockVehicle(KIM, V1, "belt"), RaiseEmergency(KIM, EmergencyKind.FIRE, "smoke")])
def test_a_command_decided_just_before_people_came_does_not_leave(ready: Script, comes: Request) -> None:
    ready.toys[V1].linked = False
    ready.report(V1, "103", state(servos=False))
    ready.accept(CommandVehicle(KIM, V1, Plain.SERVO_ON))
    ready.accept(CommandVehicle(KIM, V1, Plain.STOP))
    servo, stop = ready.sends[-2:]
    ready.accept(comes)
    assert ready.fleet.objection(servo) in {"locked out by kim: belt", "fire"}
    assert ready.fleet.objection(stop) == ""
