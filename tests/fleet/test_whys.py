"""Why a lot was late: kept with its job, bounded, and after a restart too (DOMAIN section 6)."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from app.domain.ids import JobId, VehicleId
from app.domain.requests import HoldVehicle, MoveVehicle, ReleaseVehicle, Verdict
from app.domain.units import Barcode, Timestamp
from app.domain.why import MOST_CHOICES, MOST_WAITS, Choice, Why
from app.planning.dispatch import RULES, Floats
from tests.fleet.branching import branching, go_on, hold
from tests.fleet.script import FOUP1, HOST, P2, V1, V2, Script


def why(script: Script, job: str = "J1") -> Why:
    """Return what is kept of a job's why."""
    found = script.ledger.why(script.job(job).order)
    assert found is not None
    return found


def test_an_assignment_is_kept_with_the_vehicle_its_way_and_the_candidates(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run(1)
    (choice,) = why(ready).choices
    assert (choice.vehicle, choice.before, choice.saved, choice.hot) == (V1, None, None, False)
    (other,) = choice.candidates
    assert (other.vehicle, other.why_not) == (V2, "is farther")
    assert other.seconds is not None
    assert choice.seconds < other.seconds


def test_a_nearer_vehicle_that_could_not_be_sent_is_named_with_the_reason(ready: Script) -> None:
    ready.accept(HoldVehicle(HOST, V1, "wheel noise"))
    ready.order("P1", "P3")
    ready.run(1)
    (choice,) = why(ready).choices
    assert choice.vehicle == V2
    assert [(c.vehicle, c.why_not) for c in choice.candidates] == [(V1, "is on hold: held by host: wheel noise")]


def test_a_vehicle_that_another_job_needs_more_is_named_with_that_job(ready: Script) -> None:
    ready.order("P1", "P3", job="J1")
    ready.order("P2", "B2", job="J2")
    ready.run(2)
    chosen = {job: why(ready, job).choices[-1] for job in ("J1", "J2")}
    assert {chosen["J1"].vehicle, chosen["J2"].vehicle} == {V1, V2}
    later = next(choice for choice in chosen.values() if choice.vehicle == V2)
    assert [c.why_not.split()[0] for c in later.candidates] in (["does"], ["keeps"], ["is"])


def test_waits_are_kept_with_their_beginning_and_end(ready: Script) -> None:
    ready.accept(HoldVehicle(HOST, V1, "x"))
    ready.accept(HoldVehicle(HOST, V2, "x"))
    ready.order("P1", "P3")
    ready.run(20)
    (wait,) = why(ready).waits
    assert (wait.reason, wait.until) == ("no vehicle is free", None)
    ready.accept(ReleaseVehicle(HOST, V1, Verdict.GO_ON, "fine"))
    ready.run(5)
    (wait,) = why(ready).waits
    assert wait.until is not None
    assert 19 <= wait.until - wait.since <= 26


def test_a_change_of_vehicle_is_kept_with_what_it_saved(ready: Script) -> None:
    ready.accept(MoveVehicle(HOST, V1, Barcode("112")))
    ready.order("B2", "P3", job="J1")
    ready.world[ready.plant.stations[4].id] = ready.world[ready.plant.stations[0].id]
    ready.run(3)
    assert ready.job("J1").vehicle == V2
    ready.fleet.books.save_job(replace(ready.fleet.books.jobs[JobId("J1")], wish=V1))
    ready.run(12)
    assert ready.job("J1").vehicle == V1
    assert [c.vehicle for c in why(ready).choices] == [V2, V1]


def test_the_why_outlives_a_restart_and_goes_on(ready: Script) -> None:
    ready.order("P1", "P3")
    ready.run(1)
    before = why(ready)
    ready.restart()
    assert ready.fleet.books.whys[JobId("J1")] == before
    ready.obey()
    ready.accept(HoldVehicle(HOST, V1, "x"))
    ready.run(20)
    ready.accept(ReleaseVehicle(HOST, V1, Verdict.GO_ON, "fine"))
    ready.run_until("J1", at_most=600)
    after = why(ready)
    assert after.choices[0] == before.choices[0]
    assert len(after.waits) > len(before.waits)
    assert all(wait.until is not None for wait in after.waits)
    assert JobId("J1") not in ready.fleet.books.whys


def test_a_hot_lot_that_takes_a_vehicle_says_so_on_both_sides(ready: Script) -> None:
    ready.accept(HoldVehicle(HOST, V2, "x"))
    ready.order("B1", "P2", job="J1")
    ready.run_to("to_source")
    ready.order("P1", "P3", job="J2", priority=95)
    ready.run(2)
    (choice,) = why(ready, "J2").choices
    assert (choice.vehicle, choice.hot, choice.switch) == (V1, True, RULES.switch)
    assert why(ready, "J1").waits[0].reason == "V001 does J2 first"


def test_what_is_kept_is_bounded_and_has_the_first_and_the_latest() -> None:
    one = Why(1, JobId("J1"))
    for n in range(50):
        choice = Choice(Timestamp(float(n)), VehicleId(f"V{n}"), 1.0, 50, hot=False, waited=0.0, switch=0.0)
        one = one.waiting(f"reason {n}", Timestamp(float(n))).chosen(choice)
    assert [c.at for c in one.choices] == [0.0, *map(float, range(51 - MOST_CHOICES, 50))]
    assert [w.since for w in one.waits] == [0.0, *map(float, range(51 - MOST_WAITS, 50))]
    assert one.left_out == 50 - MOST_CHOICES + 50 - MOST_WAITS
    assert one.waiting("reason 49", Timestamp(99.0)) is one
    assert one.waiting("", Timestamp(60.0)).waits[-1].until == 60.0


def test_that_the_earlier_vehicle_could_not_get_there_any_more_is_no_number_and_is_kept(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    script = branching()
    script.fill(P2, FOUP1)
    script.accept(hold())
    script.order("P2", "P3")
    script.run(1)
    router, times = script.fleet.books.router, script.fleet.books.router.table

    def cut_off(starts: Sequence[Barcode], goals: Sequence[Barcode]) -> Floats:
        """Let nobody but V001 come anywhere: dispatch thinks before the vehicles that are cut off give their jobs back."""
        found = times(starts, goals)
        found[[start != script.vehicle(V1).barcode for start in starts]] = np.inf
        return found

    assert script.job("J1").vehicle == V2
    monkeypatch.setattr(router, "table", cut_off)
    script.accept(go_on())
    script.run(4)
    assert script.job("J1").vehicle == V1
    last = why(script).choices[-1]
    assert (last.vehicle, last.before, last.saved) == (V1, V2, None)
