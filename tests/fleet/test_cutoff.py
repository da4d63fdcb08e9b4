"""What nobody can reach for what is closed is named; jobs to there wait and say why, and go on once it is open."""

from app.domain.alarms import Alarm, AlarmKind
from app.domain.job import Job, JobState
from app.domain.requests import CreateJob
from app.domain.units import Barcode
from app.fleet.breakdowns import GRACE
from app.fleet.closed import Reason
from tests.fleet.branching import PLANT, V1, V2, V3, branching, controller, go, go_on, hold
from tests.fleet.script import FOUP1, HOST, P1, P2, Script, transfer

WHY = "106 is closed (V001 stands there, on hold: held by kim: it rattles)"
WORKS = Reason("works", "the floor is cleaned")


def broken(text: str = PLANT) -> Script:
    """Return the plant after V001 has stood on hold at 106, before P2, for long."""
    script = branching(text)
    script.fill(P1, FOUP1)
    script.accept(hold())
    script.run(GRACE + 2)
    return script


def alarms(script: Script) -> list[Alarm]:
    """Return the alarms of what is cut off, as they are last kept."""
    found = {alarm.number: alarm for alarm in script.kept(Alarm) if alarm.kind is AlarmKind.TRAFFIC}
    return list(found.values())


def reason(script: Script, job: str = "J1") -> str:
    return script.job(job).reason


def test_a_station_that_nobody_can_reach_is_an_alarm_with_its_name_and_cause_until_it_can() -> None:
    script = broken()
    assert controller(script).cut_off == (f"P2: {WHY}",)
    script.accept(go_on())
    script.run(6)
    assert controller(script).cut_off == ()
    told = [(e.event, e.source, e.detail) for e in script.history() if e.event in {"AlarmSet", "AlarmCleared"}]
    assert told == [
        ("AlarmSet", "P2", f"P2 cannot be reached: {WHY}"),
        ("AlarmCleared", "P2", "P2 can be reached again"),
    ]
    (alarm,) = alarms(script)
    assert (alarm.source, alarm.code, alarm.cause) == ("P2", "cut-off", f"P2 cannot be reached: {WHY}")
    assert (alarm.ended is not None, alarm.outcome) == (True, "they can be reached again")


def test_stations_cut_off_for_one_cause_are_one_alarm_that_has_those_of_now() -> None:
    script = branching()
    books = script.fleet.books
    script.accept(go("112", V1))
    script.run(20)
    books.closed.shut(WORKS, Barcode("106"))
    script.run(6)
    (alarm,) = alarms(script)
    assert alarm.cause == "P2 cannot be reached: 106 is closed (the floor is cleaned)"
    books.closed.shut(WORKS, Barcode("104"))
    books.closed.lift(WORKS, Barcode("106"))
    script.run(6)
    first, second = alarms(script)
    assert first.outcome == "they can be reached again"
    assert "104 is closed (the floor is cleaned)" in second.cause
    assert second.ended is None


def test_what_is_cut_off_stays_so_while_nobody_is_heard_who_could_drive_there() -> None:
    script = broken()
    for toy in script.toys.values():
        toy.cut()
    script.wait(30)
    assert controller(script).cut_off == (f"P2: {WHY}",)
    assert [alarm.ended for alarm in alarms(script)] == [None]


def test_a_job_to_there_is_accepted_waits_with_the_reason_and_is_done_once_the_way_is_open() -> None:
    script = broken()
    job: Job = script.order("P1", "P2")
    script.run(5)
    assert reason(script) == f"P2 cannot be reached: {WHY}"
    assert script.job("J1").state is JobState.QUEUED
    script.run(120)
    assert script.job(job.id).state is JobState.QUEUED
    script.accept(go_on())
    script.run_until("J1")
    assert script.job("J1").state is JobState.COMPLETED


def test_a_job_from_there_waits_too_and_others_are_done_meanwhile() -> None:
    script = broken()
    script.order("P2", "P3")
    script.order("P1", "P4", job="J2")
    script.run_until("J2")
    assert script.job("J2").state is JobState.COMPLETED
    assert reason(script) == f"P2 cannot be reached: {WHY}"


def test_a_vehicle_whose_destination_is_cut_off_under_way_says_so_and_takes_its_carrier_there_later() -> None:
    script = branching()
    script.fill(P1, FOUP1)
    script.order("P1", "P2")
    script.run_to("to_destination")
    script.accept(hold())
    script.run(GRACE + 12)
    job = script.job("J1")
    assert job.reason.startswith("its destination cannot be used: V002 finds no way")
    assert WHY in job.reason
    script.accept(go_on())
    script.run(3)
    script.accept(go("111", V1))
    script.run_until("J1")
    assert script.job("J1").state is JobState.COMPLETED


def test_it_goes_on_to_a_fall_back_that_can_be_reached() -> None:
    fallback = PLANT.replace("P2: {kind: port, at: 106,", "P2: {kind: port, at: 106, fallbacks: [P4],")
    script = branching(fallback)
    script.fill(P1, FOUP1)
    script.order("P1", "P2")
    script.accept(hold())
    script.run_until("J1")
    job = script.job("J1")
    assert (job.state, job.destination) == (JobState.COMPLETED, "P4")


def test_a_vehicle_that_cannot_reach_the_source_any_more_gives_its_job_back() -> None:
    script = branching()
    script.fill(P2, FOUP1)
    script.order("P2", "P3", vehicle=V2)
    script.run_to("to_source")
    script.fleet.books.closed.shut(WORKS, Barcode("105"))
    script.run(3)
    assert script.job("J1").state is JobState.QUEUED
    assert script.job("J1").vehicle is None
    script.fleet.books.closed.lift(WORKS, Barcode("105"))
    script.run_until("J1")
    assert script.job("J1").state is JobState.COMPLETED


def test_no_way_from_the_source_to_the_destination_is_a_reason_though_both_can_be_reached() -> None:
    script = branching()
    script.accept(go("302", V3))
    script.run(40)
    script.fleet.books.closed.shut(WORKS, Barcode("301"))
    script.fill(P1, FOUP1)
    script.accept(transfer("P1", "P4"))
    script.run(3)
    assert controller(script).cut_off == (), "V003 stands there"
    assert reason(script) == "no way leads from 102 to 302: 301 is closed (the floor is cleaned)"


def test_nothing_is_begun_to_where_nobody_gets_away_from_again() -> None:
    script = branching()
    script.accept(go("112", V1))
    script.run(20)
    script.fleet.books.closed.shut(WORKS, Barcode("107"))
    script.fill(P1, FOUP1)
    script.order("P1", "P2")
    script.run(5)
    told = "nobody gets away from P2 again: no way leads from 106 to 102: 107 is closed (the floor is cleaned)"
    assert (script.job("J1").vehicle, reason(script)) == (None, told)
    script.fleet.books.closed.lift(WORKS, Barcode("107"))
    script.run_until("J1")


def test_where_nobody_can_drive_round_at_all_a_job_is_begun_though_nobody_gets_back() -> None:
    script = branching()
    script.accept(go("112", V1))
    script.run(20)
    script.fleet.books.closed.shut(WORKS, Barcode("113"))
    script.fill(P1, FOUP1)
    script.order("P1", "P2")
    script.run_until("J1")
    assert script.job("J1").state is JobState.COMPLETED


def test_what_the_track_never_connects_is_refused_all_the_same() -> None:
    island = PLANT.replace(
        "barcodes:", "barcodes:\n  901..903: {from: [0, 30000], to: [6000, 30000]}\n  904: [3000, 33000]"
    )
    island = island.replace("track:", "track:\n  - {through: [901..904, 901]}")
    island = island.replace("stations:", "stations:\n  P9: {kind: port, at: 902, dest: {shft: 0, rota: 0, lift: 1}}")
    script = broken(island)
    request: CreateJob = transfer("P1", "P9")
    assert script.refuse(request).code == "no-route"
    assert controller(script).cut_off == (f"P2: {WHY}",), "nobody could ever reach P9"
    assert request.actor == HOST
