"""When in doubt the machine is asked: settlement, holds and roll-call (COMMANDS sections 2 and 3)."""

import pytest

from app.domain.commands import Move, Pickup, Place, Plain
from app.domain.errors import NoRoute
from app.domain.events import Reported, Unknown
from app.domain.layout import StopAction
from app.domain.records import Intent, IntentState
from app.domain.requests import CommandVehicle, HandleOnce, MoveVehicle
from app.domain.units import Barcode
from app.domain.vehicle import Condition, VehicleStatus
from app.fleet.vehicle import Stage
from tests.fleet.decisions import KIM, go, held, moved, picking, release, track_of
from tests.fleet.script import FOUP1, P1, P3, V1, V2, Script, stopped_at, words

MANT_COMMANDS = (
    Plain.SERVO_ON,
    Plain.SERVO_OFF,
    Plain.SEARCH_HOME,
    Plain.GO_HOME,
    Plain.ALARM_CLEAR,
    Plain.AUTO,
    Plain.STOP,
    Plain.PORT_DEST_TEACHING,
)
AT_PORT = stopped_at(StopAction.PORT)
LOADED_AT_PORT = stopped_at(StopAction.PORT, loaded=True)


def placing(script: Script) -> Script:
    """V001 is putting the carrier of J1 down at P3."""
    script.order("P1", "P3", vehicle=V1)
    script.run_to("depositing")
    return script


def intent(script: Script, kind: str) -> Intent:
    """Return the newest intent of a kind, as last kept."""
    return next(i for i in reversed(script.kept_intents()) if i.kind == kind)


# -- two STATUS that agree, at rest --------------------------------------------------------------------------------------

UNREST = {
    "it is in RUN": words(oper=2),
    "it is in PAUSE": words(oper=3),
    "it is driving": words(trav=8),
    "its servos are off": words(flags=0xE),
    "its home position is not known": words(flags=0xD),
    "it says that not all is home": words(flags=0xB),
    "it reads no barcode": words(flags=0x7),
    "its lifter is down": words(axes=0x110134),
    "its lifter is moving": words(axes=0x118134),
    "its shifter is out": words(axes=0x011134),
    "its hand is turned": words(axes=0x101134),
    "its slider is out": words(axes=0x111034),
    "its gripper is moving": words(axes=0x111184),
    "its safety bar is moving": words(axes=0x111138),
    "an axis reports an error": words(axes=0x119134),
}


@pytest.mark.parametrize("state", UNREST.values(), ids=UNREST.keys())
def test_two_equal_status_do_not_settle_a_vehicle_while(script: Script, state: Condition) -> None:
    script.stand(V1, "103", state)
    assert script.vehicle(V1).stage is Stage.SETTLING
    assert script.vehicle(V1).waiting.startswith("V001 ")
    script.stand(V1, "103", link=False)
    assert script.vehicle(V1).stage is Stage.READY
    assert script.vehicle(V1).waiting == ""


def test_a_barcode_that_is_not_on_the_map_does_not_settle_and_names_the_dialect(script: Script) -> None:
    script.stand(V1, "65536103")
    assert script.vehicle(V1).stage is Stage.SETTLING
    assert script.vehicle(V1).waiting == (
        "V001 reports barcode 65536103, which is not on the map (is its dialect right?)"
    )


def test_one_status_is_not_enough_and_the_next_is_asked_at_once(script: Script) -> None:
    script.link_up(V1)
    script.wait(1.5)
    script.report(V1, "103")
    assert script.vehicle(V1).stage is Stage.SETTLING
    assert script.polls == [V1]
    script.report(V1, "104")
    assert script.vehicle(V1).stage is Stage.SETTLING
    script.report(V1, "104")
    assert script.vehicle(V1).stage is Stage.READY


def test_a_status_asked_before_the_quiesce_time_or_told_unasked_does_not_count(script: Script) -> None:
    script.link_up(V1)
    early = script.now
    script.wait(1.5)
    for _ in range(3):
        script.hear(Reported(V1, VehicleStatus(words(), Barcode("103"), 0), polled=True, asked_at=early))
        script.report(V1, "103", polled=False)
    assert script.vehicle(V1).stage is Stage.SETTLING


def test_after_a_reconnect_nothing_is_sent_until_the_vehicle_is_settled(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.order("P1", "P3", vehicle=V1)
    ready.link_up(V1)
    ready.wait(0.9)
    ready.report(V1, "103")
    ready.report(V1, "103")
    assert not [s for s in ready.sends if s.vehicle == V1]
    ready.stand(V1, "103", link=False)
    ready.wait(2)
    assert moved(ready)


# -- what was open is decided by F and by the place -----------------------------------------------------------------------


def test_an_unanswered_pickup_with_f_1_is_done_and_the_job_goes_on(ready: Script) -> None:
    picking(ready)
    ready.toys[V1].linked = False
    ready.unanswered(ready.last(Pickup))
    assert intent(ready, "pickup").state is IntentState.UNKNOWN
    sent = len(ready.sends)
    ready.stand(V1, "104", words(oper=2, loaded=True, trav=1, axes=0x110134, flags=0xB), link=False)
    assert len(ready.sends) == sent
    ready.stand(V1, "104", LOADED_AT_PORT, link=False)
    assert intent(ready, "pickup").state is IntentState.SETTLED_DONE
    assert ready.job("J1").leg.value == "to_destination"
    assert isinstance(ready.sends[-1].command, Move)


def test_an_unanswered_pickup_with_f_0_is_not_done_and_gets_a_new_intent(ready: Script) -> None:
    picking(ready)
    ready.toys[V1].linked = False
    first = ready.last(Pickup)
    ready.unanswered(first, Unknown.NO_ACK)
    ready.stand(V1, "104", AT_PORT, link=False)
    again = ready.last(Pickup)
    assert again.cmd_id != first.cmd_id
    settled = next(i for i in reversed(ready.kept_intents()) if i.cmd_id == first.cmd_id)
    assert settled.state is IntentState.SETTLED_NOT_DONE
    assert "F = 0" in settled.outcome


@pytest.mark.parametrize(("loaded", "done"), [(False, True), (True, False)])
def test_an_unanswered_place_is_decided_by_f_the_other_way_round(ready: Script, *, loaded: bool, done: bool) -> None:
    placing(ready)
    ready.toys[V1].linked = False
    first = ready.last(Place)
    ready.unanswered(first)
    ready.stand(V1, "114", LOADED_AT_PORT if loaded else AT_PORT, link=False)
    assert (ready.job("J1").state.value == "completed") is done
    assert (ready.last(Place).cmd_id == first.cmd_id) is done
    assert ready.station(P3).carrier == (FOUP1 if done else None)


def test_a_pickup_that_ended_in_result_1_after_the_gripper_closed_is_done_by_f(ready: Script) -> None:
    picking(ready)
    ready.toys[V1].linked = False
    ready.answer(ready.last(Pickup), "104", words(trav=1, flags=0xB), ok=False, reason="broken off")
    ready.stand(V1, "104", LOADED_AT_PORT, link=False)
    done = intent(ready, "pickup")
    assert done.state is IntentState.SETTLED_DONE
    assert done.outcome == "broken off; by STATUS: F = 1"
    assert ready.job("J1").carrier == FOUP1


def test_a_place_that_ended_in_an_alarm_with_f_0_waits_for_a_person_who_has_seen_the_carrier(ready: Script) -> None:
    placing(ready)
    ready.toys[V1].linked = False
    ready.answer(ready.last(Place), "114", words(oper=1, code=300, trav=1), ok=False, reason="alarm 300")
    ready.stand(V1, "114", AT_PORT, link=False)
    assert held(ready) == "its PLACE ended in alarm 300 (no name under alarm_codes), and its FOUP bit is 0"
    assert ready.job("J1").state.value == "transferring"
    ready.accept(release())
    ready.stand(V1, "114", AT_PORT, link=False)
    assert ready.job("J1").state.value == "completed"
    assert ready.station(P3).carrier == FOUP1


def test_an_unanswered_move_is_done_if_the_vehicle_stands_at_its_end(ready: Script) -> None:
    ready.accept(go("106"))
    ready.toys[V1].linked = False
    ready.unanswered(ready.last(Move))
    ready.stand(V1, "106", link=False)
    assert intent(ready, "move").state is IntentState.SETTLED_DONE
    assert track_of(ready) == {"105", "106"}


def test_an_unanswered_move_that_went_half_its_way_is_not_done_and_a_fresh_one_leads_on(ready: Script) -> None:
    ready.accept(go("107"))
    ready.toys[V1].linked = False
    first = ready.last(Move)
    ready.unanswered(first)
    ready.stand(V1, "105", link=False)
    second = ready.last(Move)
    assert second.cmd_id != first.cmd_id
    assert isinstance(second.command, Move)
    assert (second.command.path[0].barcode, second.command.path[-1].barcode) == ("105", "107")


def test_while_a_vehicle_is_being_settled_what_it_held_stays_its_own(ready: Script) -> None:
    ready.accept(go("107"))
    ready.toys[V1].linked = False
    ready.unanswered(ready.last(Move))
    before = track_of(ready)
    ready.stand(V1, "105", words(oper=2, trav=8), link=False)
    assert track_of(ready) >= before - {"102", "103", "104"} >= {"105", "106", "107"}


# -- contradictions -------------------------------------------------------------------------------------------------------


def test_a_foup_that_nobody_accounts_for_holds_the_vehicle_until_a_person_says_go_on(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.stand(V1, "103", words(loaded=True))
    assert held(ready) == "it carries a FOUP that no job or record accounts for"
    assert ready.vehicle(V1).stage is Stage.SETTLING
    assert "VehicleHeld" in ready.events()
    ready.accept(release())
    ready.stand(V1, "103", words(loaded=True), link=False)
    assert held(ready) == ""
    assert ready.vehicle(V1).record.believed_loaded
    assert ready.vehicle(V1).stage is Stage.READY


def test_a_job_whose_foup_is_gone_holds_the_vehicle_and_fails_once_a_person_says_go_on(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("to_destination")
    ready.toys[V1].aboard = None
    ready.run(4)
    ready.run(40)
    assert held(ready) == "it should carry FOUP0001, and its FOUP bit is 0"
    assert ready.job("J1").state.value in {"transferring", "paused"}
    ready.accept(release())
    ready.run(10)
    assert ready.job("J1").state.value == "failed"
    assert ready.fleet.books.carriers[FOUP1].place is None


def test_a_vehicle_that_reports_from_beyond_its_claim_is_held_and_its_claim_stays(ready: Script) -> None:
    before = track_of(ready)
    ready.toys[V1].cut()
    ready.stand(V1, "107")
    assert "107" in held(ready)
    assert "107, which" in held(ready)
    assert track_of(ready) >= before
    assert "107" in track_of(ready)
    ready.accept(release())
    ready.stand(V1, "107", link=False)
    assert held(ready) == ""
    assert track_of(ready) == {"106", "107"}


def test_a_barcode_that_does_not_fit_its_seq_is_not_believed(ready: Script) -> None:
    """Misread: the path has 105 at SEQ 2."""
    ready.accept(go("109"))
    ready.toys[V1].linked = False
    ready.acknowledge(ready.last(Move))
    ready.report(V1, "104", words(oper=2, trav=8), seq=1, polled=False)
    assert ready.vehicle(V1).barcode == "104"
    ready.report(V1, "107", words(oper=2, trav=8), seq=2, polled=False)
    assert held(ready) == "V001 reports barcode 107 at SEQ 2, where its path has 105"
    assert ready.vehicle(V1).barcode == "104"
    assert track_of(ready) >= {"104", "105", "106", "107", "108", "109"}


def test_a_barcode_that_does_not_fit_its_seq_after_a_restart_is_not_believed_either(ready: Script) -> None:
    ready.accept(go("108"))
    ready.restart()
    ready.link_up(V1)
    for _ in range(2):
        ready.wait(1.2)
        ready.report(V1, "107", seq=2)
    assert held(ready) == "it reports barcode 107 at SEQ 2, where its path has 105"
    assert ready.vehicle(V1).stage is Stage.SETTLING


def test_a_doubted_place_stays_doubted_over_a_restart_and_a_change_of_place_widens_the_claim(ready: Script) -> None:
    ready.accept(go("109"))
    ready.toys[V1].linked = False
    ready.report(V1, "107", words(oper=2, trav=8), seq=2, polled=False)
    why = held(ready)
    ready.report(V1, "112", words(oper=2, trav=8), seq=3, polled=False)
    assert "112" in track_of(ready)
    ready.restart()
    ready.stand(V1, "107")
    assert held(ready) == why
    assert ready.vehicle(V1).stage is Stage.SETTLING


def test_a_hold_outlives_a_restart_and_only_a_person_ends_it(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.stand(V1, "103", words(loaded=True))
    ready.restart()
    ready.stand(V1, "103")
    assert held(ready)
    assert ready.vehicle(V1).stage is Stage.SETTLING
    ready.accept(release())
    ready.stand(V1, "103", link=False)
    assert ready.vehicle(V1).stage is Stage.READY


def test_dispatch_passes_a_held_vehicle_by_and_jobs_are_still_accepted(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.stand(V1, "103", words(loaded=True))
    ready.order("P1", "P3")
    ready.run_to("to_source")
    assert ready.job("J1").vehicle == V2


def test_a_word_given_before_the_vehicle_went_silent_again_does_not_count(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.stand(V1, "103", words(loaded=True))
    ready.accept(release())
    ready.link_down(V1)
    ready.stand(V1, "103", words(loaded=True))
    assert held(ready) == "it carries a FOUP that no job or record accounts for"


def test_a_word_given_while_the_vehicle_is_silent_counts_when_it_reports(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.stand(V1, "103", words(loaded=True))
    ready.link_down(V1)
    ready.accept(release())
    ready.stand(V1, "103", words(loaded=True))
    assert held(ready) == ""


def test_a_command_of_unknown_outcome_is_closed_by_what_the_status_shows(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.accept(go("104"))
    ready.not_sent(ready.last(Move))
    assert intent(ready, "move").state is IntentState.NOT_SENT
    assert ready.vehicle(V1).stage is Stage.SETTLING
    ready.stand(V1, "103", link=False)
    again = ready.last(Move)
    assert isinstance(again.command, Move)
    assert again.command.path[0].barcode == "103"


def test_an_order_of_a_person_is_taken_up_again_from_where_the_vehicle_was_settled(ready: Script) -> None:
    ready.accept(go("106"))
    ready.toys[V1].cut()
    ready.stand(V1, "105")
    move = ready.last(Move, V1)
    assert isinstance(move.command, Move)
    assert [e.barcode for e in move.command.path] == ["105", "106"]


def test_a_one_shot_of_a_person_is_settled_by_f_after_a_restart(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, Barcode("104"), StopAction.PORT))
    ready.run(5)
    ready.accept(HandleOnce(KIM, V1, P1, pickup=True))
    ready.restart()
    ready.stand(V1, "104", LOADED_AT_PORT)
    assert ready.station(P1).present is False
    assert ready.vehicle(V1).record.carrier == FOUP1


def test_what_a_person_sent_and_nobody_answered_is_settled_by_what_the_status_shows(ready: Script) -> None:
    ready.toys[V1].cut()
    ready.stand(V1, "103", words(mode=0))
    for what in MANT_COMMANDS:
        ready.accept(CommandVehicle(KIM, V1, what))
        ready.unanswered(ready.sends[-1])
        assert intent(ready, what.value).state is IntentState.UNKNOWN
        ready.stand(V1, "103", words(mode=0), link=False)
    states = {what: intent(ready, what.value).state for what in MANT_COMMANDS}
    shown = {Plain.SERVO_ON, Plain.SEARCH_HOME, Plain.GO_HOME, Plain.ALARM_CLEAR, Plain.STOP}
    assert {what for what, state in states.items() if state is IntentState.SETTLED_DONE} == shown
    assert set(states.values()) == {IntentState.SETTLED_DONE, IntentState.SETTLED_NOT_DONE}
    assert intent(ready, "stop").outcome == "by STATUS: MANT, IDLE, barcode 103, F = 0"


def test_an_unanswered_stop_by_host_is_settled_once_the_vehicle_is_released(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    ready.unanswered(ready.sends[-1])
    ready.accept(release())
    ready.stand(V1, "103", link=False)
    assert intent(ready, "stop_by_host").state is IntentState.SETTLED_DONE


def test_an_order_of_a_person_that_leads_nowhere_from_the_new_place_is_forgotten(
    ready: Script, monkeypatch: pytest.MonkeyPatch
) -> None:
    ready.accept(go("106"))
    ready.toys[V1].cut()

    def no_way(*_: object) -> None:
        raise NoRoute("no way leads there")

    monkeypatch.setattr(ready.fleet.books.router, "route", no_way)
    ready.stand(V1, "105")
    assert ready.vehicle(V1).errand is None
    assert ready.vehicle(V1).stage is Stage.READY
