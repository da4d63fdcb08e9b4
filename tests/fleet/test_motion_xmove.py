"""XMOVE: the rolling horizon, and every way in which an amendment can end (PROTOCOLS 6.2)."""

from dataclasses import replace

import pytest

from app.domain.commands import Move, Send, Xmove
from app.domain.layout import StopAction
from app.domain.records import IntentState
from app.domain.units import Barcode
from app.fleet.motion import LAST_SEQ
from app.fleet.vehicle import Stage
from tests.fleet.drives import RUN, drive_on, driving, extended, go, last_intent, motions, names, path_of
from tests.fleet.script import V1, V2, Script, words

# -- XMOVE ----------------------------------------------------------------------------------------------------------------


def test_an_xmove_goes_on_from_the_present_stop_element_before_the_vehicle_brakes_for_it(ready: Script) -> None:
    move, xmove = extended(ready)
    end = path_of(move)[-1]
    first = path_of(xmove)[0]
    assert (first.barcode, first.seq, first.action) == (end.barcode, end.seq, StopAction.RUN)
    assert [e.seq for e in path_of(xmove)] == [end.seq + n for n in range(len(path_of(xmove)))]
    assert path_of(xmove)[-1].action is not StopAction.RUN
    assert ready.vehicle(V1).barcode != end.barcode
    assert isinstance(xmove.command, Xmove)
    assert xmove.command.amends == move.cmd_id
    intent = next(i for i in ready.intents(V1) if i.cmd_id == xmove.cmd_id)
    assert (intent.amends, intent.path) == (move.cmd_id, tuple(names(path_of(xmove))))


def creeping(ready: Script, taken: str = "105") -> Send:
    """V001 has a MOVE up to what V002 holds, and nobody obeys by itself."""
    ready.toys[V1].linked = ready.toys[V2].linked = False
    ready.fleet.books.traffic.hold(V2, [Barcode(taken)])
    go(ready, "108")
    move = ready.last(Move, V1)
    ready.acknowledge(move)
    return move


def let_go(ready: Script, taken: str = "105") -> None:
    """V002 has left it."""
    ready.fleet.books.traffic.release(V2, [Barcode(taken)])
    ready.fleet.motion.lead(ready.vehicle(V1), ready.vehicle(V1).rest)
    ready.report(V2, ready.vehicle(V2).barcode or "")


def test_a_vehicle_that_creeps_goes_on_without_a_stop_if_it_need_not_brake_yet(ready: Script) -> None:
    move = creeping(ready)
    assert names(path_of(move)) == ["103", "104"]
    ready.wait(0.5)
    let_go(ready)
    xmove = ready.last(Xmove, V1)
    assert isinstance(xmove.command, Xmove)
    assert xmove.command.amends == move.cmd_id
    assert names(path_of(xmove)) == ["104", "105", "106", "107", "108"]


def test_a_vehicle_that_brakes_already_is_sent_nothing_until_it_stands(ready: Script) -> None:
    move = creeping(ready)
    ready.wait(1)
    let_go(ready)
    assert motions(ready) == [move]
    drive_on(ready, path_of(move)[1:])
    ready.answer(move, "104", words(), seq=1)
    assert names(path_of(ready.last(Move, V1))) == ["104", "105", "106", "107", "108"]


def test_a_vehicle_whose_reads_come_slowly_is_not_believed_to_be_past_the_next_barcode(ready: Script) -> None:
    move = creeping(ready, "108")
    assert names(path_of(move)) == ["103", "104", "105", "106", "107"]
    ready.wait(20)
    let_go(ready, "108")
    assert isinstance(motions(ready)[-1].command, Xmove)


def test_no_second_xmove_leaves_while_one_is_not_answered(ready: Script) -> None:
    move, _ = extended(ready)
    sent = len(motions(ready))
    drive_on(ready, path_of(move)[-2:-1])
    assert len(motions(ready)) == sent


def test_no_xmove_leaves_before_the_move_is_acknowledged(ready: Script) -> None:
    ready.toys[V1].linked = ready.toys[V2].linked = False
    go(ready, "115")
    drive_on(ready, path_of(ready.last(Move, V1))[1:-1])
    assert len(motions(ready)) == 1


def test_an_accepted_xmove_makes_one_path_and_the_move_ends_at_the_new_end(ready: Script) -> None:
    move, xmove = extended(ready)
    ready.answer(xmove, ready.vehicle(V1).barcode or "", RUN)
    assert last_intent(ready, xmove) is IntentState.DONE
    drive = ready.vehicle(V1).drive
    assert drive is not None
    assert drive.end == path_of(xmove)[-1]
    assert [e.seq for e in drive.path] == list(range(len(drive.path)))
    kept = next(i for i in ready.intents(V1) if i.cmd_id == move.cmd_id)
    assert kept.path == tuple(names(drive.path))


def test_a_refused_xmove_waits_for_the_stop_and_then_a_fresh_move_follows(ready: Script) -> None:
    move, xmove = extended(ready)
    ready.answer(xmove, ready.vehicle(V1).barcode or "", RUN, ok=False)
    assert last_intent(ready, xmove) is IntentState.FAILED
    sent = len(motions(ready))
    rest = [e for e in path_of(move) if e.seq > names(path_of(move)).index(ready.vehicle(V1).barcode or "")]
    drive_on(ready, rest)
    ready.wait(5)
    assert len(motions(ready)) == sent
    ready.answer(move, rest[-1].barcode, words(), seq=rest[-1].seq)
    fresh = ready.last(Move, V1)
    assert fresh.cmd_id != move.cmd_id
    assert path_of(fresh)[0].barcode == rest[-1].barcode
    assert path_of(fresh)[0].seq == 0


def test_an_xmove_that_was_not_sent_is_as_good_as_refused(ready: Script) -> None:
    move, xmove = extended(ready)
    ready.not_sent(xmove)
    assert last_intent(ready, xmove) is IntentState.NOT_SENT
    assert ready.vehicle(V1).stage is Stage.READY
    end = path_of(move)[-1]
    drive_on(ready, [e for e in path_of(move) if e.seq >= end.seq - 1])
    ready.answer(move, end.barcode, words(), seq=end.seq)
    assert path_of(ready.last(Move, V1))[0].barcode == end.barcode


@pytest.mark.parametrize("taken", [True, False])
def test_an_xmove_without_an_answer_is_known_by_where_the_vehicle_stops(ready: Script, *, taken: bool) -> None:
    move, xmove = extended(ready)
    ready.unanswered(xmove)
    assert last_intent(ready, xmove) is IntentState.UNKNOWN
    way = {e.seq: e for e in (*path_of(move), *path_of(xmove))}
    last = path_of(xmove if taken else move)[-1]
    now = names(list(way.values())).index(ready.vehicle(V1).barcode or "")
    drive_on(ready, [e for seq, e in sorted(way.items()) if now < seq <= last.seq])
    ready.answer(move, last.barcode, words(), seq=last.seq)
    assert last_intent(ready, move) is IntentState.DONE
    assert last_intent(ready, xmove) is (IntentState.SETTLED_DONE if taken else IntentState.SETTLED_NOT_DONE)


def test_an_xmove_without_an_answer_is_known_by_a_status_at_the_old_end_too(ready: Script) -> None:
    move, xmove = extended(ready)
    ready.unanswered(xmove)
    end = path_of(move)[-1]
    drive_on(ready, [e for e in path_of(move) if e.seq >= end.seq - 1])
    ready.wait(1)
    ready.report(V1, end.barcode, words(), seq=end.seq)
    assert last_intent(ready, move) is IntentState.DONE
    assert last_intent(ready, xmove) is IntentState.SETTLED_NOT_DONE


def test_while_an_xmove_may_still_be_answered_a_status_at_the_old_end_ends_nothing(ready: Script) -> None:
    move, xmove = extended(ready)
    end = path_of(move)[-1]
    drive_on(ready, [e for e in path_of(move) if e.seq >= end.seq - 1])
    ready.wait(1)
    ready.report(V1, end.barcode, words(), seq=end.seq)
    assert {move.cmd_id, xmove.cmd_id} <= {i.cmd_id for i in ready.intents(V1)}


def test_a_late_yes_to_an_xmove_is_taken(ready: Script) -> None:
    _, xmove = extended(ready)
    ready.unanswered(xmove)
    ready.answer(xmove, ready.vehicle(V1).barcode or "", RUN)
    drive = ready.vehicle(V1).drive
    assert drive is not None
    assert drive.end == path_of(xmove)[-1]


def test_a_yes_to_an_xmove_after_its_move_has_ended_changes_nothing(ready: Script) -> None:
    move, xmove = extended(ready)
    end = path_of(move)[-1]
    drive_on(ready, [e for e in path_of(move) if e.seq >= end.seq - 1])
    ready.answer(move, end.barcode, words(), seq=end.seq)
    fresh = ready.vehicle(V1).drive
    ready.answer(xmove, end.barcode, words())
    ready.not_sent(xmove)
    assert ready.vehicle(V1).drive is fresh


def test_a_path_that_has_come_very_far_is_not_extended_but_begun_anew(ready: Script) -> None:
    move = driving(ready)
    drive = ready.vehicle(V1).drive
    assert drive is not None
    drive.path = (*drive.path[:-1], replace(drive.path[-1], seq=LAST_SEQ + 1))
    for element in path_of(move)[1:-1]:
        ready.wait(1)
        ready.report(V1, element.barcode, RUN, polled=False)
    assert [s.cmd_id for s in motions(ready)] == [move.cmd_id]


def test_what_a_refused_xmove_was_to_use_is_free_once_the_vehicle_stands_without_an_errand(ready: Script) -> None:
    move, xmove = extended(ready)
    ready.answer(xmove, ready.vehicle(V1).barcode or "", RUN, ok=False)
    ready.fleet.motion.drop(ready.vehicle(V1))
    assert names(path_of(xmove))[-1] in ready.fleet.books.traffic.held(V1)
    end = path_of(move)[-1]
    drive_on(ready, [e for e in path_of(move) if e.seq >= end.seq - 1])
    ready.answer(move, end.barcode, words(), seq=end.seq)
    assert set(ready.fleet.books.traffic.held(V1)) == set(ready.vehicle(V1).trail)
