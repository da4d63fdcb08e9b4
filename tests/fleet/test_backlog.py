"""The jobs that have not ended, in order; and how a backlog is thought over a piece at a time."""

from dataclasses import replace

import pytest

from app.domain.ids import Actor, JobId, StationId
from app.domain.job import Job, JobState, Leg
from app.domain.requests import CancelJob, HoldVehicle
from app.domain.units import Seconds, Timestamp
from app.fleet import beginnings
from app.fleet import dispatch as module
from app.fleet.backlog import Backlog, rank_of
from tests.fleet.script import HOST, V1, V2, Script


def job(name: str, order: int, priority: int = 50, source: str = "P1", destination: str = "P3") -> Job:
    """Return a queued job."""
    ends = StationId(source), StationId(destination)
    return Job(JobId(name), order, None, *ends, priority, Timestamp(0.0), Actor("host"), "")


def test_the_queue_is_by_urgency_then_by_acceptance_whatever_changes() -> None:
    low, high, late = job("A", 1), job("B", 2, 90), job("C", 3)
    backlog = Backlog([low, high, late])
    assert backlog.urgent(0, 9) == [high, low, late]
    raised = replace(late, priority=95)
    backlog.note(late, raised)
    assert backlog.urgent(0, 2) == [raised, high]
    backlog.note(high, replace(high, state=JobState.WAITING))
    assert backlog.urgent(0, 9) == [raised, low]


def test_a_job_is_behind_others_to_its_destination_until_they_are_gone() -> None:
    first, second, third = (job(name, order) for order, name in enumerate("ABC"))
    backlog = Backlog([first, second, third])
    assert backlog.behind("P3", rank_of(third), 2)
    backlog.note(first, replace(first, state=JobState.WAITING))
    assert not backlog.behind("P3", rank_of(third), 2)
    assert backlog.earliest_to("P3") == (0, "A")
    backlog.note(replace(first, state=JobState.WAITING), replace(first, state=JobState.CANCELLED))
    assert backlog.earliest_to("P3") == (1, "B")


def test_who_brings_a_carrier_is_known_until_it_is_put_down_or_goes_elsewhere() -> None:
    waiting = job("A", 1)
    backlog = Backlog([waiting])
    brings = replace(waiting, state=JobState.TRANSFERRING, leg=Leg.TO_DESTINATION)
    backlog.note(waiting, brings)
    assert backlog.bringing("P3") == [brings]
    elsewhere = replace(brings, destination=StationId("P2"))
    backlog.note(brings, elsewhere)
    assert (backlog.bringing("P3"), backlog.bringing("P2")) == ([], [elsewhere])
    backlog.note(elsewhere, replace(elsewhere, state=JobState.COMPLETED))
    assert backlog.bringing("P2") == []


def test_a_job_behind_others_says_so_when_it_is_accepted_and_is_not_kept_again(ready: Script) -> None:
    for name in "ABC":
        ready.order("P1", "P3", job=name)
    assert ready.job("C").reason == "other jobs to P3 come first"
    ready.forget()
    ready.run(2)
    assert [kept.id for kept in ready.kept(Job) if kept.id == "C"] == []


def test_urgent_jobs_that_cannot_begin_keep_no_other_from_being_looked_at(
    ready: Script, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(beginnings, "MOST_URGENT", 2)
    monkeypatch.setattr(beginnings, "LOOKED_AT_ONCE", 1)
    monkeypatch.setattr(module, "IN_TURN", 1)
    for n in range(5):
        ready.order("P2", "P3", job=f"blocked{n}", priority=60)
    ready.order("P1", "B2", job="able")
    ready.run(5)
    assert ready.job("able").vehicle is not None


@pytest.mark.parametrize("ticks", range(8))
def test_a_hot_lot_never_waits_for_its_turn_among_others(
    ready: Script, monkeypatch: pytest.MonkeyPatch, ticks: int
) -> None:
    for name in ("ENOUGH", "MOST_URGENT", "LOOKED_AT_ONCE"):
        monkeypatch.setattr(beginnings, name, 1)
    monkeypatch.setattr(module, "IN_TURN", 1)
    for n in range(4):
        ready.order("P2", "P3", job=f"hot{n}", priority=95)
        ready.order("P2", "P3", job=f"usual{n}")
    ready.run(ticks, step=1.0)
    ready.order("P1", "B2", job="low", priority=1)
    ready.order("B1", "B2", job="hot", priority=91)
    ready.run(2)
    assert ready.job("hot").vehicle is not None
    assert ready.job("low").vehicle is None


def test_a_more_urgent_job_goes_first_behind_hundreds_that_cannot_begin(ready: Script) -> None:
    for n in range(300):
        ready.order("P2", "P3", job=f"blocked{n}", priority=60)
    ready.order("P1", "B2", job="low", priority=1)
    ready.order("B1", "B2", job="able", priority=55)
    ready.run(1)
    assert (ready.job("able").vehicle is None, ready.job("low").vehicle) == (False, None)


@pytest.mark.parametrize("slices", range(1, 10))
@pytest.mark.parametrize("what", ["cancel", "hold"])
def test_what_happens_between_two_slices_goes_before_what_was_weighed(
    ready: Script, monkeypatch: pytest.MonkeyPatch, slices: int, what: str
) -> None:
    monkeypatch.setattr(module, "IN_ONE_GO", 0)
    monkeypatch.setattr(module, "SEEN_AT_ONCE", 1)
    ready.order("P1", "P3", job="J1")
    ready.now = Seconds(ready.now + 1.0)
    for _ in range(slices):
        ready.tick()
    given = ready.job("J1").vehicle
    if what == "cancel":
        ready.ask(CancelJob(HOST, JobId("J1")))
    else:
        ready.ask(HoldVehicle(HOST, V1, "a look"))
        ready.ask(HoldVehicle(HOST, V2, "a look"))
    while ready.fleet.deadline <= ready.now:
        ready.tick()
    if what == "cancel":
        assert ready.job("J1").state.terminal or given
        assert given or ready.vehicle(V1).job is ready.vehicle(V2).job is None
    else:
        assert ready.job("J1").vehicle == given


def test_a_new_thought_waits_for_the_end_of_the_last_one(ready: Script, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "IN_ONE_GO", 0)
    ready.order("P1", "P3", job="J1")
    for _ in range(40):  # so slow that each slice comes when the next thought is due
        ready.now = Seconds(ready.now + 1.0)
        ready.tick()
    assert ready.job("J1").vehicle is not None


def test_idle_vehicles_get_their_jobs_in_slices_that_come_at_once(
    ready: Script, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "IN_ONE_GO", 0)
    monkeypatch.setattr(module, "GIVEN_AT_ONCE", 1)
    ready.order("P1", "P3", job="J1")
    ready.order("B1", "B2", job="J2")
    ready.now = Seconds(ready.now + 1.0)
    given = []
    while ready.fleet.deadline <= ready.now:
        ready.tick()
        given.append(sum(ready.job(name).vehicle is not None for name in ("J1", "J2")))
    assert given[-1] == 2
    assert 1 in given


def test_dispatch_pauses_longer_with_thousands_of_jobs(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run(2)
    few = _pause(ready)
    for n in range(2_500):
        ready.fleet.books.save_job(job(f"X{n}", 100 + n))
    ready.run(2)
    assert few == pytest.approx(0.1)
    assert _pause(ready) == pytest.approx(2_502 * 50e-6)


def _pause(script: Script) -> float:
    """Return the seconds from a think to the next one that an order asks for at once."""
    fleet = script.fleet
    script.now = Seconds(script.now + 2.0)
    script.tick()
    script.order("B1", "B2", job=f"again{script.now}")
    return fleet._next_thought - fleet._last_thought
