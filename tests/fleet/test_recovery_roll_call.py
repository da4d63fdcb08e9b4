"""Who may be where after a restart, in silence, or in MANT: claims and the roll-call (COMMANDS sections 2 and 3)."""

from dataclasses import replace

import pytest

from app.domain.commands import Move, Plain, Simple, Xmove
from app.domain.events import Unknown
from app.domain.ids import DevId, JobId, VehicleId
from app.domain.layout import Edge, Plant, Point, StopAction, VehicleSpec
from app.domain.requests import Accepted, CancelJob, HoldVehicle, Verdict
from app.domain.units import Barcode, Millimetres
from app.domain.vehicle import Condition
from tests.fleet.decisions import KIM, go, held, moved, release, track_of
from tests.fleet.script import FOUP1, P1, V1, V2, Script, small, stopped_at, transfer, words

AT_PORT = stopped_at(StopAction.PORT)
LOADED_AT_PORT = stopped_at(StopAction.PORT, loaded=True)


# -- silence --------------------------------------------------------------------------------------------------------------


def test_a_silent_vehicle_keeps_its_whole_claim_and_others_wait_for_it(ready: Script) -> None:
    ready.accept(go("108"))
    ready.acknowledge(ready.last(Move))
    claim = track_of(ready)
    ready.toys[V1].cut()
    ready.accept(go("104", V2))
    ready.run(120)
    assert track_of(ready) == claim
    assert ready.vehicle(V2).waiting.endswith("held by V001, which is silent (line cut)")


def test_a_xmove_without_an_answer_leaves_the_union_of_both_paths_claimed(ready: Script) -> None:
    ready.accept(go("115"))
    ready.accept(go("101", V2))
    ready.toys[V1].linked = False
    move = ready.last(Move, V1)
    ready.acknowledge(move)
    assert isinstance(move.command, Move)
    end = move.command.path[-1]
    for at in move.command.path[1:-2]:
        ready.report(V1, at.barcode, words(oper=2, trav=8), seq=at.seq, polled=False)
    amendment = ready.last(Xmove, V1)
    assert isinstance(amendment.command, Xmove)
    new = {element.barcode for element in amendment.command.path}
    ready.unanswered(amendment, Unknown.NO_ACK)
    assert track_of(ready) >= new | {end.barcode}
    ready.restart()
    assert track_of(ready) >= new | {e.barcode for e in move.command.path}
    ready.stand(V1, end.barcode, words())
    assert track_of(ready) & (new - {end.barcode}) == set()
    assert not [i for i in ready.intents(V1) if i.kind == "xmove"]


# -- roll-call ------------------------------------------------------------------------------------------------------------


def restarted(ready: Script) -> Script:
    """Return the plant after a restart, V001 ready, V002 not heard of yet, and an order that V001 could serve."""
    ready.restart()
    ready.stand(V1, "103")
    ready.order("P1", "P3")
    ready.wait(30)
    return ready


def test_after_a_restart_nobody_moves_while_a_vehicle_of_the_area_is_absent(ready: Script) -> None:
    restarted(ready)
    assert ready.sends == []
    assert ready.fleet.motion.missing(ready.vehicle(V1)) == (V2,)


@pytest.mark.parametrize("state", [words(oper=2, trav=8), words(flags=0x7)])
def test_nor_while_it_reports_but_is_not_settled(ready: Script, state: Condition) -> None:
    restarted(ready)
    ready.stand(V2, "116", state)
    assert not [s for s in ready.sends if s.vehicle == V1]
    ready.stand(V2, "116", link=False)
    assert moved(ready)


def test_a_vehicle_at_an_unlikely_place_is_not_counted_until_a_person_vouches_for_it(ready: Script) -> None:
    restarted(ready)
    ready.stand(V2, "111")
    assert held(ready, V2)
    assert not ready.sends
    ready.accept(release(vehicle=V2))
    ready.stand(V2, "111", link=False)
    assert moved(ready)


def test_a_vehicle_with_a_strange_load_at_its_place_is_counted(ready: Script) -> None:
    restarted(ready)
    ready.stand(V2, "116", words(loaded=True))
    assert held(ready, V2)
    assert moved(ready)


def test_a_person_may_say_that_the_missing_vehicle_is_off_the_rail(ready: Script) -> None:
    restarted(ready)
    ready.accept(release(Verdict.OFF_RAIL, vehicle=V2))
    ready.wait(2)
    assert moved(ready)
    assert track_of(ready, V2) == set()
    ready.stand(V2, "116")
    assert "said to be off the rail" in held(ready, V2)
    ready.accept(release(vehicle=V2))
    ready.stand(V2, "116", link=False)
    assert held(ready, V2) == ""
    assert not ready.vehicle(V2).record.off_rail
    assert track_of(ready, V2) >= {"116"}


def test_a_person_may_say_where_the_missing_vehicle_stands(ready: Script) -> None:
    restarted(ready)
    ready.accept(release(Verdict.STANDS_AT, "111", V2))
    ready.wait(2)
    assert track_of(ready, V2) == {"111"}
    assert moved(ready)
    ready.restart()
    assert track_of(ready, V2) == {"111"}


def test_the_roll_call_counts_every_area_for_itself() -> None:
    plant = two_areas()
    script = Script(plant)
    script.fill(P1, FOUP1)
    for vehicle, at in ((V1, "103"), (V2, "116"), (VehicleId("V003"), "902")):
        script.stand(vehicle, at)
    script.restart()
    script.stand(V1, "103")
    script.stand(V2, "116")
    assert list(script.fleet.books.roll_call) == ["V003"]
    script.order("P1", "P3", vehicle=V1)
    script.wait(3)
    assert moved(script)


def test_a_vehicle_never_seen_before_may_be_anywhere_and_is_waited_for() -> None:
    script = Script()
    script.stand(V1, "103")
    script.accept(replace(transfer(), vehicle=V1))
    script.wait(5)
    assert script.sends == []


def two_areas() -> Plant:
    """Return the small plant with another loop, 901 to 903, that is joined to nothing, and V003 on it."""
    plant = small()
    points = [
        Point(Barcode(str(n)), Millimetres(30_000 + 1000 * (n % 2)), Millimetres(1000 * n - 900_000))
        for n in (901, 902, 903)
    ]
    ring = [("901", "902"), ("902", "903"), ("903", "901")]
    edges = [Edge(Barcode(a), Barcode(b), Millimetres(2000)) for a, b in ring]
    third = VehicleSpec(
        id=VehicleId("V003"), dev_id=DevId(3), length=Millimetres(1100), start=Barcode("902"), offset=None
    )
    return replace(
        plant,
        points=(*plant.points, *points),
        edges=(*plant.edges, *edges),
        vehicles=(*plant.vehicles, third),
    )


# -- claims after a restart -----------------------------------------------------------------------------------------------


def test_after_a_restart_a_vehicle_claims_where_it_stood_and_every_open_path(ready: Script) -> None:
    ready.accept(go("108"))
    move = ready.last(Move, V1)
    assert isinstance(move.command, Move)
    ready.restart()
    assert track_of(ready) == {"102", "103", *(e.barcode for e in move.command.path)}
    assert track_of(ready, V2) >= {"116"}


def test_after_a_restart_in_mant_a_vehicle_claims_what_it_could_reach_by_itself_both_ways(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.report(V1, "103", words(mode=0))
    reach = {"118", "101", "102", "103", "104", "105", "106"}
    assert track_of(ready) >= {"101", "102", "103", "104", "105", "106"}
    ready.restart()
    assert {"101", "102", "103", "104", "105", "106"} <= track_of(ready) <= reach
    ready.stand(V1, "105", words(mode=0))
    assert held(ready) == ""


def test_what_another_vehicle_holds_is_not_within_reach(ready: Script) -> None:
    ready.accept(go("105"))
    ready.run(10)
    ready.toys[V2].linked = False
    ready.stand(V2, "102", words(mode=0), link=False)
    assert held(ready, V2)
    ready.accept(release(vehicle=V2))
    ready.stand(V2, "102", words(mode=0), link=False)
    assert track_of(ready, V2) & track_of(ready, V1) == set()


def test_a_vehicle_moved_by_hand_in_mant_takes_its_reach_with_it_and_gives_the_rest_back(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.stand(V1, "103", words(mode=0), link=False)
    ready.report(V1, "105", words(mode=0))
    assert ready.vehicle(V1).barcode == "105"
    assert {"103", "104", "105", "106", "107", "108"} <= track_of(ready)
    assert "101" not in track_of(ready)
    ready.stand(V1, "105", link=False)
    assert track_of(ready) == {"104", "105"}


def test_a_vehicle_that_reads_a_barcode_in_mant_that_it_could_not_be_moved_to_is_held(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.stand(V1, "103", words(mode=0), link=False)
    ready.report(V1, "110", words(mode=0))
    assert held(ready) == "V001 reports barcode 110, which it could not be moved to from 103"
    assert {"103", "110"} <= track_of(ready)


def test_a_vehicle_at_a_doubtful_place_holds_what_it_would_cover_there_too(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.stand(V1, "103", words(mode=0), link=False)
    ready.report(V1, "108", words(mode=0))
    assert {"102", "103", "107", "108"} <= track_of(ready)


def test_two_vehicles_that_report_one_place_are_both_believed_and_nobody_is_granted_it(ready: Script) -> None:
    ready.toys[V1].linked = False
    ready.stand(V1, "116", link=False)
    ready.accept(release())
    ready.stand(V1, "116", link=False)
    assert "116" in track_of(ready, V1)
    assert "116" in track_of(ready, V2)
    sent = len(ready.sends)
    ready.accept(go("101"))
    ready.accept(go("102", V2))
    ready.wait(5)
    assert [s for s in ready.sends[sent:] if isinstance(s.command, Move)]


def test_a_person_is_told_when_the_verdict_does_not_fit(ready: Script) -> None:
    assert ready.refuse(release()).code == "conflict"
    assert ready.refuse(release(Verdict.OFF_RAIL)).code == "conflict"
    assert ready.refuse(release(Verdict.STANDS_AT, "103")).code == "conflict"
    ready.toys[V1].cut()
    assert ready.refuse(release(Verdict.STANDS_AT, "9999")).field == "barcode"
    assert ready.refuse(release(Verdict.STANDS_AT)).field == "barcode"
    assert isinstance(ready.ask(release(Verdict.STANDS_AT, "103")), Accepted)


@pytest.mark.parametrize(("to", "at"), [("108", "107"), ("107", "106"), ("105", "104")])
def test_a_vehicle_pushed_onto_track_that_another_drives_to_stops_the_other(ready: Script, to: str, at: str) -> None:
    ready.toys[V2].cut()
    ready.accept(release(Verdict.STANDS_AT, "111", V2))
    ready.stand(V2, "111", words(mode=0))
    ready.toys[V1].linked = False
    ready.accept(go("107"))
    move = ready.last(Move, V1)
    ready.acknowledge(move)
    ready.report(V2, to, words(mode=0))
    stop = ready.last(Simple, V1)
    assert stop.command == Simple(Plain.STOP_BY_HOST)
    assert held(ready) == f"V002 reports from {to}, on track that V001 has been granted ({at})"
    sent = len(ready.sends)
    ready.report(V2, to, words(mode=0))
    assert len(ready.sends) == sent


def test_one_that_is_on_hold_and_still_drives_is_stopped_for_a_vehicle_on_its_track_too(ready: Script) -> None:
    ready.toys[V2].cut()
    ready.accept(release(Verdict.STANDS_AT, "111", V2))
    ready.stand(V2, "111", words(mode=0))
    ready.toys[V1].linked = False
    ready.accept(go("107"))
    ready.acknowledge(ready.last(Move, V1))
    ready.accept(HoldVehicle(KIM, V1, "wheel"))
    ready.report(V2, "107", words(mode=0))
    assert ready.last(Simple, V1).command == Simple(Plain.STOP_BY_HOST)
    assert held(ready) == "held by kim: wheel"


def test_a_job_taken_from_a_silent_or_doubted_vehicle_frees_nothing_of_its_claim(ready: Script) -> None:
    ready.order("B1", "P3", vehicle=V1)
    ready.run(2)
    ready.toys[V1].linked = False
    ready.report(V1, "105", words(oper=2, trav=8), seq=3, polled=False)
    assert held(ready)
    ready.answer(ready.last(Move, V1), "105", words(), ok=False)
    claim = track_of(ready)
    ready.accept(CancelJob(KIM, JobId("J1")))
    assert ready.job("J1").state.value == "cancelled"
    assert track_of(ready) == claim >= {"104", "105", "106", "107", "108"}
