"""The log of jobs: names, ids, and how bad."""

import json
from pathlib import Path

import pytest
import structlog

from app.domain.job import JobEvent
from app.domain.view import EventView, Topic, Update
from app.plant import read
from app.runtime.journal import Journal
from tests.runtime.test_metrics import happened

E = JobEvent
FILE = Path(__file__).parents[2] / "plants" / "demo.yaml"
PLANT, _ = read(FILE.read_text(encoding="utf-8"), "demo")


@pytest.fixture
def said() -> structlog.testing.LogCapture:
    return structlog.testing.LogCapture()


@pytest.fixture
def journal(said: structlog.testing.LogCapture) -> Journal:
    return Journal(structlog.wrap_logger(None, processors=[said]).bind(plant="demo"), PLANT)


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


@pytest.mark.parametrize(
    ("name", "about", "told"),
    [
        (E.ALARM_SET, {"vehicle": "V001"}, {"vehicle": "V001"}),
        (E.ALARM_SET, {"vehicle": "AGV1", "job": "J1"}, {"vehicle": "AGV1", "job": "J1"}),
        (E.ALARM_SET, {"vehicle": "DOOR1"}, {"door": "DOOR1"}),
        (E.ALARM_CLEARED, {"vehicle": "BUFFER1"}, {"buffer": "BUFFER1"}),
        (E.ALARM_SET, {"vehicle": "CHARGER1"}, {"charger": "CHARGER1"}),
        (E.ALARM_SET, {"source": "ETCH01-P1"}, {"station": "ETCH01-P1"}),
        (E.VEHICLE_HELD, {"vehicle": "V001", "job": "J1", "source": "SBA-R1"}, {"vehicle": "V001", "job": "J1"}),
        (E.ALARM_SET, {"source": "webhook-3"}, {"webhook": "webhook-3"}),
        (E.ALARM_SET, {"job": "J1"}, {"job": "J1"}),
        (E.DRIVE_OFFLINE, {"source": "AX1"}, {"drive": "AX1"}),
        (E.EMERGENCY_SET, {}, {}),
    ],
)
def test_what_is_noteworthy_is_told_of_what_it_is_about_by_its_kind(
    journal: Journal, said: structlog.testing.LogCapture, name: JobEvent, about: dict[str, str], told: dict[str, str]
) -> None:
    vehicle, source, job = (about.get(part) for part in ("vehicle", "source", "job"))
    event = EventView(7, 1.0, name.value, 0, job, None, vehicle, source, None, "", "why")
    journal.take([Update(Topic.EVENTS, "7", event)])
    (line,) = said.entries
    of_all = {"event": name.value, "log_level": "warning", "plant": "demo", "seq": 7, "detail": "why"}
    assert line == {**of_all, **told}
