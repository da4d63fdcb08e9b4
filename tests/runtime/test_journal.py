"""The log of jobs: names, ids, and how bad."""

import json

import pytest
import structlog

from app.domain.job import JobEvent
from app.runtime.journal import Journal
from tests.runtime.test_metrics import happened

E = JobEvent


@pytest.fixture
def said() -> structlog.testing.LogCapture:
    return structlog.testing.LogCapture()


@pytest.fixture
def journal(said: structlog.testing.LogCapture) -> Journal:
    return Journal(structlog.wrap_logger(None, processors=[said]).bind(plant="demo"))


def test_each_event_of_a_job_is_a_line_with_the_ids_of_job_and_vehicle(
    journal: Journal, said: structlog.testing.LogCapture
) -> None:
    journal.take([happened(E.VEHICLE_ASSIGNED, 1.0), happened(E.TRANSFER_COMPLETED, 2.0, result="completed")])
    assert [(line["event"], line["log_level"]) for line in said.entries] == [
        ("VehicleAssigned", "info"),
        ("TransferCompleted", "info"),
    ]
    for line in said.entries:
        assert (line["plant"], line["job"], line["vehicle"], line["seq"]) == ("demo", "J1", "V001", 1)
    assert said.entries[1]["result"] == "completed"
    assert "carrier" not in said.entries[0]


def test_a_job_that_failed_and_what_is_noteworthy_are_warnings(
    journal: Journal, said: structlog.testing.LogCapture
) -> None:
    journal.take([happened(E.TRANSFER_COMPLETED, 2.0, result="failed", detail="PICKUP refused")])
    journal.take([happened(E.ALARM_SET, 3.0, None, detail="E12"), happened(E.PORT_CHANGED, 4.0, None)])
    assert [(line["event"], line["log_level"], line["detail"]) for line in said.entries] == [
        ("TransferCompleted", "warning", "PICKUP refused"),
        ("AlarmSet", "warning", "E12"),
    ]
    assert json.dumps(said.entries)
