"""Stop all; pause, stop and resume a zone (DOMAIN sections 1 and 7)."""

from pathlib import Path

from app.domain.commands import Move, Plain, Simple
from app.domain.ids import ZoneId
from app.domain.job import JobState
from app.domain.layout import StopAction
from app.domain.requests import HandleOnce, PauseController, PauseZone, ResumeController, ResumeZone, StopAll
from app.domain.units import Barcode
from app.domain.vehicle import Mode
from app.domain.view import ControllerView, Topic
from app.plant import read
from tests.fleet.drives import KIM, go
from tests.fleet.script import B1, FOUP1, FOUP2, P1, V1, V2, Script
from tests.fleet.test_closures import barcode, shut

SMALL = Path(__file__).parents[2] / "plants/small.yaml"
WEST = ZoneId("west")
STOP_ALL = StopAll(KIM, "somebody shouts")


def zoned() -> Script:
    """The small plant with a zone from 104 to 107 in which any number may be."""
    text = SMALL.read_text(encoding="utf-8")
    text = text.replace("zones:\n", "zones:\n  west: {barcodes: [104..107], capacity: 9}\n")
    plant, _ = read(text, "small.yaml")
    script = Script(plant)
    script.fill(P1, FOUP1)
    script.fill(B1, FOUP2)
    script.obey()
    script.forget()
    return script


def controller(script: Script) -> ControllerView:
    (view,) = script.model[Topic.CONTROLLER].values()
    assert isinstance(view, ControllerView)
    return view


def test_stop_all_stops_what_moves_keeps_auto_and_withholds_grants(ready: Script) -> None:
    go(ready, "110")
    go(ready, "102", V2)
    ready.run(1.5)
    ready.accept(STOP_ALL)
    stops = {s.vehicle for s in ready.sends if s.command == Simple(Plain.STOP_BY_HOST)}
    assert stops == {V1, V2}
    ready.run(10)
    where = {name: toy.barcode for name, toy in ready.toys.items()}
    assert controller(ready).state == "paused"
    assert controller(ready).reason == "kim: somebody shouts"
    ready.forget()
    ready.order("P1", "P3")
    ready.run(20)
    assert {name: toy.barcode for name, toy in ready.toys.items()} == where
    assert not [s for s in ready.sends if isinstance(s.command, Move)]
    assert all(ready.vehicle(name).mode is Mode.AUTO for name in (V1, V2))
    assert all(ready.vehicle(name).record.hold is None for name in (V1, V2))
    ready.accept(ResumeController(KIM))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_stop_all_lets_a_handling_end_and_stops_a_paused_plant_too(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run_to("acquiring")
    ready.run(1)
    ready.accept(PauseController(KIM, "slowly"))
    ready.accept(STOP_ALL)
    ready.run(10)
    assert ready.job("J1").leg.value == "to_destination"
    assert controller(ready).reason == "kim: slowly"
    ready.accept(ResumeController(KIM))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_in_a_paused_zone_what_moves_ends_its_grant_and_nobody_comes_in() -> None:
    script = zoned()
    go(script, "110")
    while script.toys[V1].barcode != "105":
        script.run(0.25)
    script.accept(PauseZone(KIM, WEST, "a tool is moved in"))
    granted = script.vehicle(V1).ahead[-1]
    go(script, "103", V2)
    script.run(20)
    assert script.toys[V1].barcode == granted
    assert not [s for s in script.sends if s.command == Simple(Plain.STOP_BY_HOST)]
    assert script.toys[V2].barcode == "103"
    go(script, "106", V2)
    script.run(10)
    assert script.toys[V2].barcode == "103"
    assert "zone west is paused by kim: a tool is moved in" in script.vehicle(V2).waiting
    script.accept(ResumeZone(KIM, WEST))
    script.run(20)
    assert script.toys[V1].barcode == "110"
    assert script.toys[V2].barcode == "106"


def test_in_a_stopped_zone_what_drives_is_stopped_where_it_is() -> None:
    script = zoned()
    go(script, "110")
    while script.toys[V1].barcode != "105":
        script.run(0.25)
    go(script, "101", V2)
    script.run(0.5)
    script.accept(PauseZone(KIM, WEST, "smoke", stop=True))
    assert {s.vehicle for s in script.sends if s.command == Simple(Plain.STOP_BY_HOST)} == {V1}
    script.run(15)
    assert script.toys[V1].barcode in {"105", "106"}
    assert "zone west is stopped by kim: smoke" in script.vehicle(V1).waiting
    assert script.toys[V2].barcode == "101"
    script.accept(ResumeZone(KIM, WEST))
    script.run(20)
    assert script.toys[V1].barcode == "110"


def test_nothing_is_picked_up_in_a_paused_zone_and_no_job_given_to_who_stands_there() -> None:
    script = zoned()
    go(script, "104", V1, StopAction.PORT)
    script.run(5)
    script.accept(PauseZone(KIM, WEST, "x"))
    refusal = script.refuse(HandleOnce(KIM, V1, P1, pickup=True))
    assert (refusal.reason, refusal.remedy) == ("zone west is paused by kim: x", "resume it first")
    script.order("P1", "P3", vehicle=V1)
    script.run(5)
    assert script.job("J1").vehicle is None
    script.accept(ResumeZone(KIM, WEST))
    script.run_until("J1")


def test_a_pause_outlives_a_restart_and_both_pauses_of_the_controller() -> None:
    script = zoned()
    script.accept(PauseZone(KIM, WEST, "x"))
    script.accept(PauseController(KIM, "y"))
    script.accept(ResumeController(KIM))
    script.restart()
    script.obey()
    assert [(p.zone, p.owner, p.stopped) for p in controller(script).pauses] == [("west", "kim", False)]
    go(script, "105")
    script.run(10)
    assert script.toys[V1].barcode == "103"
    script.accept(ResumeZone(KIM, WEST))
    script.run(5)
    assert script.toys[V1].barcode == "105"
    assert controller(script).pauses == ()


def test_a_zone_in_a_closed_place_opens_with_the_last_of_both() -> None:
    script = zoned()
    number = shut(script, barcode("106"))
    script.accept(PauseZone(KIM, WEST, "x"))
    traffic = script.fleet.books.traffic
    assert (
        traffic.closed[Barcode("106")]
        == f"closed by kim: rail change (closure {number}); zone west is paused by kim: x"
    )
    script.accept(ResumeZone(KIM, WEST))
    assert list(traffic.closed) == ["106"]


def test_a_zone_that_is_not_there_is_not_found(ready: Script) -> None:
    assert ready.refuse(PauseZone(KIM, WEST, "x")).code == "not-found"
    assert ready.refuse(ResumeZone(KIM, WEST)).code == "not-found"
