"""From an errand to claims, MOVE and XMOVE, and what becomes of them (PROTOCOLS 6.2, TRAFFIC section 2)."""

from dataclasses import replace

import pytest

from app.domain.commands import Move, Plain, Send
from app.domain.events import Unknown
from app.domain.ids import StationId
from app.domain.layout import StopAction
from app.domain.records import IntentState
from app.domain.requests import CommandVehicle, ReleaseVehicle, Verdict
from app.domain.units import Barcode, Millimetres
from app.domain.vehicle import Condition
from app.fleet.vehicle import Stage
from tests.fleet.drives import KIM, RUN, drive_on, driving, go, last_intent, motions, names, path_of
from tests.fleet.script import FOUP1, V1, V2, Script, small, stopped_at, words

# -- MOVE ------------------------------------------------------------------------------------------------------------------


def test_a_move_leads_from_where_it_stands_to_the_end_of_what_is_granted_and_stops_there(ready: Script) -> None:
    move = path_of(driving(ready))
    held = ready.fleet.books.traffic.held(V1)
    assert move[0].barcode == "103"
    assert [e.seq for e in move] == list(range(len(move)))
    assert [e.action for e in move] == [StopAction.RUN] * (len(move) - 1) + [StopAction.STOP]
    assert set(names(move)) <= set(held)
    assert move[-1].barcode != "116"


def test_a_path_to_the_goal_ends_with_the_stop_that_was_asked_for(ready: Script) -> None:
    go(ready, "106", action=StopAction.PORT)
    assert [e.action.name for e in path_of(ready.last(Move))] == ["RUN", "RUN", "RUN", "PORT"]


def test_the_intent_of_a_move_holds_its_whole_path(ready: Script) -> None:
    move = driving(ready)
    intent = ready.intents(V1)[0]
    assert intent.path == tuple(names(path_of(move)))
    assert intent.body == {"action": "STOP", "goal": "116", "purpose": "person"}


def test_a_path_is_never_longer_than_the_vehicle_can_take() -> None:
    plant = small()
    plant = replace(plant, vehicles=tuple(replace(v, max_count=3) for v in plant.vehicles))
    script = Script(plant)
    script.obey()
    go(script, "107")
    assert names(path_of(script.last(Move))) == ["103", "104", "105"]
    script.run(20)
    assert script.toys[V1].barcode == "107"


def test_a_vehicle_shows_carrier_and_stations_of_its_job_by_their_display_names(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1, carrier=FOUP1)
    ready.run_to("to_destination")
    move = ready.last(Move, V1).command
    assert isinstance(move, Move)
    assert (move.foup_id, move.source, move.destination) == ("FOUP0001", "P1", "LOADER-3")


def test_a_job_from_a_vehicle_shows_the_vehicle_as_its_source(ready: Script) -> None:
    ready.toys[V1].aboard = FOUP1
    ready.run(5)
    ready.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "FOUP0001 is aboard"))
    ready.run(5)
    ready.order("V001", "P3")
    ready.run(2)
    move = ready.last(Move, V1).command
    assert isinstance(move, Move)
    assert move.source == "V001"


def test_what_the_vehicle_has_passed_is_free_and_who_waits_for_it_goes_on(ready: Script) -> None:
    ready.toys[V2].cut()
    ready.accept(ReleaseVehicle(KIM, V2, Verdict.STANDS_AT, "seen", Barcode("101")))
    ready.stand(V2, "101")
    move = driving_only(ready)
    go(ready, "104", V2)
    assert motions(ready, V2) == []
    assert ready.vehicle(V2).waiting == "V002 waits at 101 for 102 held by V001, which is moving"
    drive_on(ready, path_of(move)[1:2])
    assert set(ready.fleet.books.traffic.held(V1)) == {"103", "104", "105", "106", "107", "108"}
    assert names(path_of(ready.last(Move, V2))) == ["101", "102"]


def driving_only(ready: Script) -> Send:
    """V001 has its MOVE to 108."""
    ready.toys[V1].linked = False
    go(ready, "108")
    move = ready.last(Move, V1)
    ready.acknowledge(move)
    return move


def test_a_vehicle_on_a_loop_keeps_what_lies_ahead_of_it_though_it_has_been_there() -> None:
    plant = small()
    script = Script(replace(plant, vehicles=tuple(replace(v, max_speed=Millimetres(6000)) for v in plant.vehicles[:1])))
    script.obey()
    go(script, "102")
    script.run(60)
    assert script.toys[V1].barcode == "102"


# -- how a MOVE ends -------------------------------------------------------------------------------------------------------


def test_result_0_at_the_end_ends_the_move(ready: Script) -> None:
    go(ready, "104")
    ready.toys[V1].linked = False
    move = ready.last(Move)
    ready.answer(move, "104", words(), seq=1)
    assert last_intent(ready, move) is IntentState.DONE
    assert ready.vehicle(V1).barcode == "104"


def test_a_status_that_shows_it_standing_at_the_end_ends_the_move_too(ready: Script) -> None:
    """Its RESP1 was lost."""
    go(ready, "104")
    ready.toys[V1].linked = False
    move = ready.last(Move)
    ready.acknowledge(move)
    ready.wait(1)
    ready.report(V1, "104", words(), seq=1)
    assert last_intent(ready, move) is IntentState.DONE


@pytest.mark.parametrize(
    "state",
    [RUN, words(oper=3), words(flags=7), words(oper=1, code=300), words(mode=0), words(oper=2)],
    ids=["driving", "paused", "no barcode", "alarm", "mant", "at work"],
)
def test_a_status_that_shows_anything_else_does_not_end_it(ready: Script, state: Condition) -> None:
    go(ready, "104")
    ready.toys[V1].linked = False
    move = ready.last(Move)
    ready.acknowledge(move)
    ready.wait(1)
    ready.report(V1, "104", state, seq=1)
    assert move.cmd_id in {i.cmd_id for i in ready.intents(V1)}


def test_a_status_asked_before_the_vehicle_had_the_move_does_not_end_it(ready: Script) -> None:
    """It stands at the end of its former path, which had as many elements."""
    go(ready, "104", action=StopAction.PORT)
    ready.toys[V1].linked = False
    ready.report(V1, "104", words(), seq=1)
    assert ready.intents(V1)


def test_result_0_from_elsewhere_does_not_end_it(ready: Script) -> None:
    go(ready, "105")
    ready.toys[V1].linked = False
    move = ready.last(Move)
    ready.answer(move, "104", words(), seq=1)
    assert last_intent(ready, move) is IntentState.OPEN


def test_a_vehicle_that_answers_on_acceptance_is_followed_to_its_end_by_status(ready: Script) -> None:
    go(ready, "105")
    ready.toys[V1].linked = False
    move = ready.last(Move)
    ready.answer(move, "103", words(oper=2))
    assert last_intent(ready, move) is IntentState.OPEN
    sent = len(ready.sends)
    drive_on(ready, path_of(move)[1:])
    assert len(ready.sends) == sent
    ready.report(V1, "105", words(), seq=2)
    assert last_intent(ready, move) is IntentState.DONE


def test_one_that_answers_on_acceptance_and_stands_elsewhere_is_asked_and_sent_on(ready: Script) -> None:
    go(ready, "106")
    ready.toys[V1].linked = False
    move = ready.last(Move)
    ready.answer(move, "103", words(oper=2))
    ready.wait(1)
    ready.report(V1, "104", words(), seq=1)
    assert ready.vehicle(V1).stage is Stage.SETTLING
    ready.stand(V1, "104", link=False)
    assert last_intent(ready, move) is IntentState.SETTLED_NOT_DONE
    assert names(path_of(ready.last(Move))) == ["104", "105", "106"]


def test_a_move_of_one_element_that_was_answered_while_at_work_is_not_over(ready: Script) -> None:
    """It stands at P1 without having stopped there as at a port, and answers on acceptance."""
    go(ready, "104")
    ready.run(4)
    go(ready, "104", action=StopAction.PORT)
    ready.toys[V1].linked = False
    move = ready.last(Move)
    assert names(path_of(move)) == ["104"]
    ready.answer(move, "104", words(oper=2))
    assert last_intent(ready, move) is IntentState.OPEN
    ready.wait(1)
    ready.report(V1, "104", stopped_at(StopAction.PORT))
    assert last_intent(ready, move) is IntentState.DONE


def test_a_move_without_an_answer_is_never_sent_again_before_a_status_has_decided(ready: Script) -> None:
    move = driving(ready)
    for why in (Unknown.NO_ANSWER,):
        ready.unanswered(move, why)
        ready.wait(30)
        ready.report(V1, "104", RUN, seq=1)
        ready.report(V1, "104", RUN, seq=1)
    assert motions(ready) == [move]
    assert last_intent(ready, move) is IntentState.UNKNOWN


def test_a_late_answer_ends_an_unknown_move_and_the_vehicle_is_asked_all_the_same(ready: Script) -> None:
    go(ready, "104")
    ready.toys[V1].linked = False
    move = ready.last(Move)
    ready.unanswered(move)
    ready.answer(move, "104", words(), seq=1)
    assert last_intent(ready, move) is IntentState.DONE
    assert ready.vehicle(V1).stage is Stage.SETTLING


def test_a_move_that_ends_abnormally_is_followed_by_a_question_not_by_a_move(ready: Script) -> None:
    move = driving(ready)
    ready.answer(move, "103", words(), ok=False, reason="refused")
    assert last_intent(ready, move) is IntentState.FAILED
    assert motions(ready) == [move]
    ready.stand(V1, "103", link=False)
    assert len(motions(ready)) == 2


@pytest.mark.parametrize("sent", [True, False], ids=["it is refused", "it cannot be sent"])
def test_after_three_moves_in_vain_the_vehicle_waits_for_a_person(ready: Script, *, sent: bool) -> None:
    driving(ready)
    for _ in range(3):
        move = ready.last(Move, V1)
        if sent:
            ready.answer(move, "103", words(), ok=False, reason="the path does not begin here")
        else:
            ready.not_sent(move, "COUNT 101 is more than 100")
        ready.stand(V1, "103", link=False)
    hold = ready.vehicle(V1).record.hold
    assert hold is not None
    assert hold.reason.startswith("MOVE ended abnormally 3 times" if sent else "MOVE could not be sent 3 times")
    assert len(motions(ready)) == 3


def test_a_move_that_succeeds_begins_the_count_anew(ready: Script) -> None:
    driving(ready, "105")
    for _ in range(2):
        ready.answer(ready.last(Move, V1), "103", words(), ok=False)
        ready.stand(V1, "103", link=False)
    ready.answer(ready.last(Move, V1), "105", words(), seq=2)
    go(ready, "107")
    for _ in range(2):
        ready.answer(ready.last(Move, V1), "105", words(), ok=False)
        ready.stand(V1, "105", link=False)
    assert ready.vehicle(V1).record.hold is None


# -- obstacles, keys, stops ------------------------------------------------------------------------------------------------


def test_a_pause_by_an_obstacle_lasts_as_long_as_it_lasts(ready: Script) -> None:
    go(ready, "107")
    ready.run(2)
    ready.toys[V1].paused = True
    ready.run(600)
    assert ready.vehicle(V1).stage is Stage.READY
    assert len(motions(ready)) == 1
    ready.toys[V1].paused = False
    ready.run(10)
    assert ready.toys[V1].barcode == "107"


@pytest.mark.parametrize("after", [0.3, 2.0, 6.0], ids=["standing", "driving", "at its end"])
def test_the_key_turned_to_mant_asks_the_vehicle_and_back_in_auto_it_goes_on(ready: Script, after: float) -> None:
    go(ready, "107")
    ready.run(after)
    toy = ready.toys[V1]
    toy._halt()
    toy.mode = 0
    ready.run(8)
    assert ready.vehicle(V1).drive is None
    assert not ready.vehicle(V1).fit
    sent = len(ready.sends)
    ready.run(20)
    assert len(ready.sends) == sent
    toy.mode = 3
    ready.run(20)
    assert toy.barcode == "107"


def test_the_key_turned_while_handling_is_settled_by_f_and_back_in_auto_the_job_goes_on(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("acquiring")
    ready.toys[V1].mode = 0
    ready.run(15)
    assert ready.job("J1").carrier == FOUP1
    ready.toys[V1].mode = 3
    ready.run_until("J1")
    assert ready.job("J1").state.value == "completed"


@pytest.mark.parametrize("leg", ["to_source", "acquiring", "to_destination", "depositing"])
def test_a_line_lost_on_any_leg_of_a_job_costs_nothing_but_time(ready: Script, leg: str) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to(leg)
    ready.run(0.5)
    ready.toys[V1].cut()
    ready.run(6)
    ready.toys[V1].connect()
    ready.run_until("J1")
    assert ready.job("J1").state.value == "completed"
    assert len([s for s in ready.sends if type(s.command).__name__ == "Pickup"]) == 1


@pytest.mark.parametrize("leg", ["to_source", "acquiring", "to_destination", "depositing"])
def test_a_restart_on_any_leg_of_a_job_costs_nothing_but_time(ready: Script, leg: str) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to(leg)
    ready.run(0.5)
    ready.restart()
    ready.obey()
    ready.run_until("J1")
    assert ready.job("J1").state.value == "completed"
    assert ready.world[StationId("P3")] == FOUP1


def test_stop_by_host_ends_the_move_and_it_goes_on_once_released(ready: Script) -> None:
    go(ready, "107")
    ready.run(2)
    ready.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    ready.run(10)
    assert ready.vehicle(V1).record.hold
    at = ready.toys[V1].barcode
    assert at != "107"
    ready.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "go on"))
    ready.run(15)
    assert ready.toys[V1].barcode == "107"


def test_a_vehicle_that_strays_is_held_at_once(ready: Script) -> None:
    driving(ready)
    ready.report(V1, "115", RUN, seq=1, polled=False)
    hold = ready.vehicle(V1).record.hold
    assert hold is not None
    assert hold.reason == "V001 reports barcode 115, which is not on the track it holds"


def test_a_stop_position_does_not_outlive_the_place(ready: Script) -> None:
    """It stood at P1 as at a port; pushed to P2 it has to stop there anew before it may handle."""
    go(ready, "104", action=StopAction.PORT)
    ready.run(4)
    ready.toys[V1].cut()
    ready.toys[V1].barcode, ready.toys[V1].trav = Barcode("106"), 0
    ready.accept(ReleaseVehicle(KIM, V1, Verdict.STANDS_AT, "pushed it", Barcode("106")))
    ready.toys[V1].connect()
    ready.run(4)
    assert ready.vehicle(V1).stopped is None
    go(ready, "106", action=StopAction.PORT)
    assert names(path_of(ready.last(Move, V1))) == ["106"]


# -- length ----------------------------------------------------------------------------------------------------------------


def test_a_vehicle_longer_than_a_piece_of_track_frees_behind_it_only_what_its_tail_has_left() -> None:
    plant = small()
    script = Script(replace(plant, vehicles=tuple(replace(v, length=Millimetres(2500)) for v in plant.vehicles[:1])))
    script.obey()
    assert set(script.fleet.books.traffic.held(V1)) == {"101", "102", "103"}
    go(script, "105")
    while script.toys[V1].barcode != "104":
        script.run(0.25)
    script.run(0.25)
    assert {"102", "103"} <= set(script.fleet.books.traffic.held(V1))
    assert "101" not in script.fleet.books.traffic.held(V1)
