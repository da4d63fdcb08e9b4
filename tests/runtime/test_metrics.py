"""Figures: histograms, phases of jobs, and what a running controller shows."""

import asyncio
from dataclasses import replace
from pathlib import Path

from prometheus_client.metrics_core import Metric

from app.domain.ids import JobId, StationId
from app.domain.job import JobEvent
from app.domain.view import EventView, JobView, Topic, Update
from app.fleet.circles import IN_A_CIRCLE
from app.fleet.waits import CAUSES
from app.planning.blocking import BlockReason
from app.runtime.metrics import Spread, families, line_families
from app.runtime.metrics.jobs import JobFigures
from tests.api.scripted import PLANT
from tests.runtime.peers import run, until
from tests.runtime.test_controller import JOB, controlled, in_pieces, linked, plant_in, simulated

E = JobEvent


def happened(name: JobEvent, at: float, job: str | None = "J1", *, vehicle: str = "V001", **more: str) -> Update:
    event = EventView(
        1, at, name.value, 0, job, None, vehicle, None, None, more.get("result", ""), more.get("detail", "")
    )
    return Update(Topic.EVENTS, "1", event)


def accepted(at: float, name: str = "J1") -> JobView:
    ends = {"source": "P1", "destination": "P2", "carrier": None, "vehicle": None, "wish": None, "fallbacks": ()}
    words = {"reason": "", "result": "", "actor": "mes", "state": "queued", "leg": "none"}
    times = {"created": at, "assigned": None, "picked": None, "ended": None}
    return JobView(id=name, order=1, priority=50, **ends, **words, **times)  # type: ignore[arg-type]


def figures() -> JobFigures:
    return JobFigures(PLANT)


def total(jobs: JobFigures, phase: str) -> tuple[int, float]:
    spread = jobs.phases[phase]
    return spread.number, spread.total


def value(found: list[Metric], name: str, **labels: str) -> float:
    return next(
        sample.value for family in found for sample in family.samples if sample.name == name and sample.labels == labels
    )


def test_a_spread_counts_each_value_under_the_first_bound_that_holds_it() -> None:
    spread = Spread((1, 2.5, 10))
    for seen in (0.0, 1.0, 1.1, 10.0, 11.0):
        spread.see(seen)
    assert spread.buckets() == [("1", 2), ("2.5", 3), ("10", 4), ("+Inf", 5)]
    assert (spread.number, round(spread.total, 6)) == (5, 23.1)


def test_the_phases_of_a_delivery_go_from_one_e82_event_to_another() -> None:
    jobs = figures()
    jobs.take([Update(Topic.JOBS, "J1", accepted(100.0))])
    for name, at in (
        (E.TRANSFER_INITIATED, 103.0),
        (E.VEHICLE_ASSIGNED, 103.0),
        (E.VEHICLE_ACQUIRE_STARTED, 110.0),
        (E.VEHICLE_ACQUIRE_COMPLETED, 121.0),
        (E.VEHICLE_DEPOSIT_STARTED, 150.0),
        (E.VEHICLE_DEPOSIT_COMPLETED, 162.0),
    ):
        jobs.take([happened(name, at)])
    assert not jobs.ended
    jobs.take([happened(E.TRANSFER_COMPLETED, 162.5, result="completed")])
    assert jobs.ended["completed"] == 1
    expected = {"queued": 3, "to_source": 7, "acquiring": 11, "to_destination": 29, "depositing": 12, "whole": 62.5}
    assert {name: total(jobs, name) for name in expected} == {name: (1, seen) for name, seen in expected.items()}


def test_a_job_that_was_given_to_another_vehicle_counts_from_the_last_one() -> None:
    jobs = figures()
    jobs.take([Update(Topic.JOBS, "J1", accepted(0.0))])
    jobs.take([happened(E.VEHICLE_ASSIGNED, 2.0), happened(E.VEHICLE_ASSIGNED, 30.0)])
    jobs.take([happened(E.TRANSFER_COMPLETED, 90.0, result="completed")])
    assert (total(jobs, "queued"), total(jobs, "acquiring")) == ((1, 30.0), (0, 0.0))


def test_a_job_that_failed_is_counted_but_not_timed() -> None:
    jobs = figures()
    jobs.take([Update(Topic.JOBS, "J1", accepted(0.0)), happened(E.TRANSFER_COMPLETED, 5.0, result="failed")])
    jobs.take([happened(E.TRANSFER_CANCEL_COMPLETED, 6.0, "J2", result="cancelled")])
    assert (jobs.ended["failed"], jobs.ended["cancelled"], jobs.ended["completed"]) == (1, 1, 0)
    assert total(jobs, "whole") == (0, 0.0)
    assert not jobs._marks


def test_a_job_from_before_the_start_is_timed_by_what_is_kept_of_it() -> None:
    jobs = figures()
    jobs.begin([replace(accepted(10.0), assigned=20.0, picked=40.0)])
    jobs.take([happened(E.VEHICLE_DEPOSIT_STARTED, 60.0), happened(E.VEHICLE_DEPOSIT_COMPLETED, 70.0)])
    jobs.take([happened(E.TRANSFER_COMPLETED, 70.0, result="completed")])
    assert [total(jobs, name)[1] for name in ("queued", "to_destination", "depositing", "whole")] == [10, 20, 10, 60]


def test_alarms_are_told_apart_by_the_kind_of_what_has_them() -> None:
    jobs = figures()
    jobs.take(
        [
            happened(E.ALARM_SET, 1.0, None),
            happened(E.ALARM_CLEARED, 2.0, None),
            happened(E.ALARM_SET, 3.0, None, detail=f"V001, V002 {IN_A_CIRCLE} (...)"),
            happened(E.ALARM_SET, 3.0, None, vehicle="ghost"),
            happened(E.DRIVE_ERROR_SET, 4.0, None),
            happened(E.EMERGENCY_SET, 5.0, None),
        ]
    )
    assert jobs.alarms == {"hoist": 1, "circle": 1, "other": 1, "drive": 1, "emergency": 1}


def test_every_refusal_of_traffic_is_a_cause_of_waiting() -> None:
    assert set(CAUSES) >= {why.value for why in BlockReason} - {"no_stop"}


def test_a_running_controller_shows_its_deliveries_commits_and_lines(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "metrics")
        plant = plant_in(directory)
        async with simulated(plant) as floor, controlled(plant, directory) as controller:
            await linked(controller)
            await controller.ask(JOB)
            await until(lambda: floor.truth.at.get(StationId("P2")) == "FOUP0001")
            await until(lambda: controller.model.get(Topic.JOBS, "J1") is None)
            await until(lambda: controller.figures.lateness.number > 0)
            found = list(families(controller, "1.2.3", controller.utc()))
            assert value(found, "hoistway_jobs_ended_total", state="completed") == 1
            assert value(found, "hoistway_job_phase_seconds_count", phase="whole") == 1
            assert value(found, "hoistway_job_phase_seconds_count", phase="acquiring") == 1
            assert value(found, "hoistway_events_total", event="TransferCompleted") == 1
            assert value(found, "hoistway_commit_seconds_count") > 5
            assert value(found, "hoistway_commit_records_sum") > 15
            assert value(found, "hoistway_vehicles_linked") == len(plant.vehicles)
            assert value(found, "hoistway_links_up", wire="itsc") == len(plant.vehicles)
            assert value(found, "hoistway_database_trouble") == 0
            assert value(found, "hoistway_vehicles_waiting", cause="emergency") == 0
            assert {family.name for family in found} >= {"process_cpu_seconds", "python_gc_collections"}
            lines = list(line_families(controller))
            assert value(lines, "hoistway_line_frames_total", line="V001", wire="itsc", direction="in") > 10
            job = await asyncio.to_thread(controller.reader.job, JobId("J1"))
            assert job is not None
            assert job.picked is not None
            spread = controller.figures.jobs.phases["whole"]
            assert abs(spread.total - ((job.ended or 0.0) - job.created)) < 0.05

    run(scenario)
