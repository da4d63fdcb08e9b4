"""Closures: nobody comes in, those inside drive out, and every reason has to be lifted (DOMAIN sections 1 and 7)."""

from datetime import datetime

import pytest

from app.domain.closures import (
    ClosedPlace,
    ClosePlace,
    Closure,
    ClosurePurpose,
    ClosureState,
    OpenPlace,
    PlaceKind,
)
from app.domain.commands import Move, Plain
from app.domain.ids import Actor, JobId, StationId
from app.domain.job import JobState
from app.domain.layout import StopAction
from app.domain.records import AuditRow
from app.domain.requests import CommandVehicle, HandleOnce, MoveVehicle, ReleaseVehicle, Verdict
from app.domain.units import Barcode, Timestamp
from app.domain.view import ClosureView, StationView, Topic
from app.fleet.closure_preview import ClosurePreview, preview, survey
from app.plant import read
from tests.fleet.drives import KIM, go
from tests.fleet.script import FOUP1, P1, P3, UTC, V1, V2, Script, small

LEE, ANN = Actor("lee"), Actor("ann")
TWO_WAYS = """
name: two-ways
barcodes: {201..209: {from: [0, 0], to: [8000, 0]}, 211..219: {from: [0, 2000], to: [8000, 2000]}, 221: [6000, 1000]}
track:
  - {through: [201..209]}
  - {through: [209, 219, 218, 217, 216, 215, 214, 213, 212, 211, 201]}
  - {through: [207, 221, 217], length: 1500}
stations:
  A: {kind: sbfl, at: 202}
  B: {kind: sbfl, at: 208}
  C: {kind: sbfl, at: 216}
vehicle_defaults: {length: 500, max_speed: 1000}
vehicles:
  V001: {dev_id: 1, address: "127.0.0.1:17101", start: 201}
carriers: {FOUP0001: A}
"""


def stretch(start: str, end: str) -> ClosedPlace:
    return ClosedPlace(PlaceKind.STRETCH, (start, end))


def barcode(*names: str) -> ClosedPlace:
    return ClosedPlace(PlaceKind.BARCODE, names)


def shut(script: Script, place: ClosedPlace, actor: Actor = KIM, **more: object) -> int:
    """Close a place and return the closure's number."""
    reply = script.accept(ClosePlace(actor, place, "rail change", **more))  # type: ignore[arg-type]
    assert reply.created
    return int(reply.key)


def now(script: Script, number: int) -> Closure:
    """Return a closure as last kept."""
    return next(row for row in reversed(script.kept(Closure)) if row.number == number)


def shown(script: Script, number: int) -> ClosureView:
    view = script.model[Topic.CLOSURES][str(number)]
    assert isinstance(view, ClosureView)
    return view


def forked() -> Script:
    plant, _ = read(TWO_WAYS, "two-ways.yaml")
    script = Script(plant)
    script.fill(StationId("A"), FOUP1)
    script.obey()
    script.forget()
    return script


def places(script: Script, seconds: float) -> set[str]:
    """Return where V001 was seen while so much time went by."""
    seen = set()
    for _ in range(int(seconds * 4)):
        script.run(0.25)
        seen.add(script.toys[V1].barcode)
    return {str(place) for place in seen}


def test_a_closed_rail_is_not_driven(ready: Script) -> None:
    shut(ready, barcode("106"))
    ready.refuse(MoveVehicle(KIM, V1, Barcode("106")))
    ready.order("P1", "P3")
    ready.run(60)
    assert ready.toys[V1].barcode in {"103", "104", "105"}
    held = ready.fleet.books.traffic.inside([Barcode("106")])
    assert held == ()
    assert ready.job("J1").state is not JobState.COMPLETED


def test_an_empty_place_is_closed_at_once_and_a_used_one_drains_first(ready: Script) -> None:
    empty = shut(ready, barcode("108"))
    assert shown(ready, empty).state == "closed"
    used = shut(ready, stretch("115", "117"))
    assert shown(ready, used).state == "draining"
    assert shown(ready, used).inside == ("V002",)
    assert shown(ready, used).waiting == ("V002, which is idle there",)
    assert shown(ready, used).barcodes == ("115", "116", "117")
    assert shown(ready, used).stations == ("B2",)
    ready.run(30)
    assert shown(ready, used).state == "closed"
    assert shown(ready, used).inside == ()
    assert ready.fleet.books.traffic.inside(map(Barcode, ("115", "116", "117"))) == ()
    told = [e for e in ready.events() if e.startswith("Place")]
    assert told == ["PlaceClosing", "PlaceClosed", "PlaceClosing", "PlaceClosed"]


def test_who_is_driving_through_drives_out_and_nobody_follows(ready: Script) -> None:
    go(ready, "110")
    while ready.toys[V1].barcode != "106":
        ready.run(0.25)
    number = shut(ready, stretch("106", "108"))
    ready.order("B1", "P2")
    ready.run(40)
    assert ready.toys[V1].barcode == "110"
    assert shown(ready, number).state == "closed"
    assert ready.fleet.books.traffic.inside(map(Barcode, ("106", "107", "108"))) == ()
    assert ready.job("J1").reason.startswith("P2 is closed by kim")


def test_routes_lead_round_a_closure_also_for_who_is_on_the_way() -> None:
    script = forked()
    go(script, "216")
    script.run(0.5)
    shut(script, barcode("221"))
    assert "221" not in places(script, 30)
    assert script.toys[V1].barcode == "216"


def test_an_edge_is_closed_without_its_barcodes() -> None:
    script = forked()
    number = shut(script, ClosedPlace(PlaceKind.EDGE, ("207", "208")))
    assert shown(script, number).state == "closed"
    assert script.refuse(MoveVehicle(KIM, V1, Barcode("208"))).code == "no-route"
    shut(script, barcode("221"))
    go(script, "207")
    script.run(20)
    assert script.toys[V1].barcode == "207"


def test_a_vehicle_on_a_closed_edge_is_inside_until_it_has_left_it(ready: Script) -> None:
    go(ready, "110")
    while ready.toys[V1].barcode != "106":
        ready.run(0.25)
    number = shut(ready, ClosedPlace(PlaceKind.EDGE, ("105", "106")))
    assert shown(ready, number).inside == ("V001",)
    ready.run(20)
    assert shown(ready, number).state == "closed"


def test_jobs_to_a_closed_station_wait_and_say_why(ready: Script) -> None:
    number = shut(ready, ClosedPlace(PlaceKind.STATION, (P3,)))
    ready.order("P1", "P3")
    ready.run(20)
    assert ready.job("J1").reason == f"P3 is closed by kim: rail change (closure {number})"
    assert ready.job("J1").vehicle is None
    view = ready.model[Topic.STATIONS][P3]
    assert isinstance(view, StationView)
    assert view.closures == (number,)
    ready.accept(OpenPlace(LEE, number))
    ready.run_until("J1")
    assert ready.job("J1").state is JobState.COMPLETED


def test_the_rail_below_a_closed_station_stays_in_use(ready: Script) -> None:
    shut(ready, ClosedPlace(PlaceKind.STATION, (P1,)))
    go(ready, "105")
    ready.run(10)
    assert ready.toys[V1].barcode == "105"


def test_a_station_drains_while_a_vehicle_handles_there(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run_to("acquiring")
    ready.run(1)
    number = shut(ready, ClosedPlace(PlaceKind.STATION, (P1,)))
    assert shown(ready, number).inside == ("V001",)
    ready.run(10)
    assert ready.job("J1").leg.value == "to_destination"
    assert shown(ready, number).state == "closed"


def test_a_person_cannot_handle_at_a_closed_station_either(ready: Script) -> None:
    ready.accept(MoveVehicle(KIM, V1, Barcode("104"), StopAction.PORT))
    ready.run(5)
    shut(ready, ClosedPlace(PlaceKind.STATION, (P1,)))
    refusal = ready.refuse(HandleOnce(KIM, V1, P1, pickup=True))
    assert refusal.reason.startswith("P1 is closed by kim")


def test_a_loaded_vehicle_goes_to_the_fall_back_of_a_closed_destination(ready: Script) -> None:
    ready.order("P1", "P3", fallbacks=(StationId("B2"),))
    ready.run_to("to_destination")
    shut(ready, ClosedPlace(PlaceKind.STATION, (P3,)))
    ready.run_until("J1")
    assert (ready.job("J1").state, ready.job("J1").destination) == (JobState.COMPLETED, "B2")


def test_a_job_to_a_place_cut_off_is_accepted_and_waits(ready: Script) -> None:
    shut(ready, barcode("107"))
    ready.order("P1", "P3")
    ready.run(30)
    assert not ready.job("J1").state.terminal


def test_overlapping_reasons_must_all_be_lifted(ready: Script) -> None:
    first, second = shut(ready, stretch("105", "107")), shut(ready, barcode("106"), LEE)
    ready.accept(OpenPlace(KIM, first))
    go_refused = ready.refuse(MoveVehicle(KIM, V1, Barcode("106")))
    assert go_refused.code == "no-route"
    ready.accept(OpenPlace(KIM, second))
    go(ready, "106")
    ready.run(10)
    assert ready.toys[V1].barcode == "106"
    assert list(ready.fleet.books.closed) == []


def test_a_traffic_closure_expires_by_itself_and_one_for_work_never(ready: Script) -> None:
    refusal = ready.refuse(ClosePlace(KIM, barcode("106"), "x", ClosurePurpose.WORK, Timestamp(UTC + ready.now + 60)))
    assert (refusal.field, refusal.remedy) == ("expires", "leave expires out, and open it when everybody is out")
    assert ready.refuse(ClosePlace(KIM, barcode("106"), "x", expires=Timestamp(UTC))).field == "expires"
    end = Timestamp(UTC + ready.now + 60)
    number = shut(ready, barcode("106"), expires=end)
    said = ready.kept(AuditRow)[-1].detail.partition("expires ")[2]
    assert abs(datetime.fromisoformat(said).timestamp() - end) < 1
    ready.run(58)
    assert now(ready, number).state is ClosureState.CLOSED
    ready.run(4)
    assert (now(ready, number).state, now(ready, number).ended_by) == (ClosureState.EXPIRED, "hoistway")
    assert str(number) not in ready.model[Topic.CLOSURES]
    go(ready, "106")


def test_work_is_opened_by_its_owner_or_by_two_others_together(ready: Script) -> None:
    one = shut(ready, barcode("106"), purpose=ClosurePurpose.WORK)
    refusal = ready.refuse(OpenPlace(LEE, one))
    assert refusal.reason == "closure 1 is kim's, for people at work; your wish to open it is noted"
    ready.refuse(OpenPlace(LEE, one))
    assert shown(ready, one).releases == ("lee",)
    ready.accept(OpenPlace(ANN, one))
    two = shut(ready, barcode("106"), purpose=ClosurePurpose.WORK)
    ready.accept(OpenPlace(KIM, two))
    assert ready.refuse(OpenPlace(KIM, two)).code == "not-found"


def test_where_people_work_nothing_stirs(ready: Script) -> None:
    """A vehicle that is put into the place by hand is not driven out, and takes no command that moves it."""
    number = shut(ready, stretch("105", "107"), purpose=ClosurePurpose.WORK)
    assert shown(ready, number).state == "closed"
    ready.toys[V1].cut()
    ready.toys[V1].barcode = Barcode("106")
    ready.obey(V1)
    ready.run(5)
    if ready.vehicle(V1).record.hold:
        ready.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "it was carried there"))
        ready.run(5)
    assert ready.vehicle(V1).barcode == "106"
    ready.forget()
    refusal = ready.refuse(MoveVehicle(KIM, V1, Barcode("110")))
    assert "closed for people at work by kim" in refusal.reason
    assert ready.refuse(CommandVehicle(KIM, V1, Plain.SERVO_ON)).remedy == "open that first"
    ready.run(20)
    assert ready.toys[V1].barcode == "106"
    assert not [s for s in ready.sends if isinstance(s.command, Move) and s.vehicle == V1]
    assert shown(ready, number).inside == ("V001",)
    ready.accept(OpenPlace(KIM, number))
    go(ready, "110")
    ready.run(10)
    assert ready.toys[V1].barcode == "110"


def test_a_move_decided_before_people_were_there_does_not_leave(ready: Script) -> None:
    go(ready, "110")
    move = ready.last(Move, V1)
    books = ready.fleet.books
    number = shut(ready, barcode("103"), purpose=ClosurePurpose.WORK)
    assert shown(ready, number).state == "draining"
    assert ready.fleet.objection(move) == ""
    ready.run(10)
    assert shown(ready, number).state == "closed"
    assert books.closures.barring(ready.vehicle(V1)) == ""


def test_closures_outlive_a_restart(ready: Script) -> None:
    closed, drains = shut(ready, barcode("106")), shut(ready, barcode("116"), purpose=ClosurePurpose.WORK)
    gone = shut(ready, barcode("112"))
    ready.accept(OpenPlace(KIM, gone))
    ready.restart()
    assert shown(ready, closed).reason == "rail change"
    ready.obey()
    assert ready.refuse(MoveVehicle(KIM, V1, Barcode("106"))).code == "no-route"
    ready.run(30)
    assert shown(ready, drains).state == "closed"
    assert str(gone) not in ready.model[Topic.CLOSURES]
    assert shut(ready, barcode("108")) == gone + 1


def test_an_idle_vehicle_gives_way_to_no_closed_place(ready: Script) -> None:
    shut(ready, stretch("105", "112"))
    found = ready.fleet.books.closures
    assert found.at(Barcode("108"))
    assert not found.at(Barcode("104"))


@pytest.mark.parametrize(
    ("place", "words"),
    [
        (barcode("999"), "there is no barcode 999"),
        (ClosedPlace(PlaceKind.ZONE, ("west",)), "there is no zone west"),
        (ClosedPlace(PlaceKind.STATION, ("P9",)), "there is no station P9"),
        (ClosedPlace(PlaceKind.EDGE, ("103", "105")), "no edge leads from 103 to 105"),
    ],
)
def test_a_place_that_is_not_there_cannot_be_closed(ready: Script, place: ClosedPlace, words: str) -> None:
    refusal = ready.refuse(ClosePlace(KIM, place, "x"))
    assert refusal.reason == words
    assert refusal.remedy
    assert isinstance(preview(survey(ready.fleet.books), place), type(refusal))


def test_a_zone_is_closed_by_its_name(ready: Script) -> None:
    number = shut(ready, ClosedPlace(PlaceKind.ZONE, ("east-curve",)))
    assert shown(ready, number).barcodes == ("109", "110", "111")


def looked(script: Script, place: ClosedPlace) -> ClosurePreview:
    found = preview(survey(script.fleet.books), place)
    assert isinstance(found, ClosurePreview)
    return found


def test_a_preview_says_what_gets_longer_and_changes_nothing() -> None:
    script = forked()
    before = len(script.records)
    found = looked(script, barcode("221"))
    assert len(script.records) == before
    assert (found.stations, found.cut_off, found.shut_in) == ((), (), ())
    routes = found.routes
    assert (routes.pairs, routes.lost) == (6, 0)
    assert routes.longer >= 1
    worst = routes.worst[0]
    assert (worst.start, worst.goal) == ("202", "216")
    assert worst.after > worst.before
    assert routes.mean_after > routes.mean_before


def test_a_preview_names_stations_jobs_and_vehicles(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.order("B1", "P2", "J2")
    ready.run(3)
    found = looked(ready, stretch("105", "107"))
    assert found.stations == ("P2",)
    assert found.cut_off == ("P1", "P3", "B1", "B2")
    touched = {one.job: one.why for one in found.jobs}
    assert touched[JobId("J2")] == "its destination P2 would be closed"
    assert touched[JobId("J1")].endswith("would be cut off")
    assert looked(ready, barcode(ready.toys[V2].barcode)).inside == (V2,)


def test_a_preview_of_an_oval_cut_open_cuts_all_off() -> None:
    script = Script(small())
    script.obey()
    found = looked(script, barcode("118"))
    assert found.routes.lost > 0
    assert found.cut_off == tuple(station.id for station in script.plant.stations)
    assert found.shut_in == (V1, V2)
