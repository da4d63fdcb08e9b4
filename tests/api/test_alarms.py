"""Alarms over REST: lists, acknowledging, sums."""

from dataclasses import replace

import httpx
import pytest

from app.domain.alarms import AcknowledgeAlarm
from tests.api.scripted import NOW, Scripted

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}


async def test_alarms_are_listed_shown_and_acknowledged_by_a_named_person(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    controller.alarm()
    (active,) = (await client.get("/alarms/active")).json()["items"]
    assert (active["source"], active["begun"], active["ended"]) == ("V001", "2026-01-01T00:00:00.000Z", None)
    assert (await client.get("/alarms/1")).json() == active
    assert (await client.post("/alarms/1/acknowledge", json={})).json()["field"] == "X-Actor"
    seen = (await client.post("/alarms/1/acknowledge", json={"note": "a wheel"}, headers=KIM)).json()
    assert (seen["acknowledged_by"], seen["acknowledged"]) == ("kim", "2026-01-01T00:00:00.000Z")
    assert (await client.get("/alarms/7")).status_code == 404


async def test_alarms_of_one_cause_are_acknowledged_together_and_answered_one_by_one(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    first = controller.alarm()
    second = replace(first, number=2, source="V002")
    controller.reader.wrong[2] = second
    asked = {"alarms": [2, 9, 1, 2], "note": "the switch of bay 2"}
    assert (await client.post("/alarms/acknowledge", json=asked)).json()["field"] == "X-Actor"
    answers = (await client.post("/alarms/acknowledge", json=asked, headers=KIM)).json()["items"]
    assert [(row["alarm"], row["acknowledged"], row["code"]) for row in answers] == [
        (2, True, None),
        (9, False, "not-found"),
        (1, True, None),
    ]
    assert [controller.reader.wrong[n].acknowledged_by for n in (1, 2)] == ["kim", "kim"]
    asked_one_by_one = [request for request in controller.seen if isinstance(request, AcknowledgeAlarm)]
    assert {(one.alarm, one.note) for one in asked_one_by_one} == {(n, "the switch of bay 2") for n in (1, 2, 9)}
    assert (await client.post("/alarms/acknowledge", json={"alarms": []}, headers=KIM)).status_code == 422


async def test_a_list_is_asked_for_by_period_and_kind(client: httpx.AsyncClient, controller: Scripted) -> None:
    asked = {"from": "2026-01-01T00:00:00+09:00", "to": "2026-01-01T00:00:00Z", "kind": "hold", "active": "false"}
    assert (await client.get("/alarms", params=asked)).status_code == 200
    assert controller.reader.asked_for["begin"] == NOW - 9 * 3600
    assert controller.reader.asked_for["end"] == NOW
    assert (controller.reader.asked_for["kind"], controller.reader.asked_for["active"]) == ("hold", False)
    assert (await client.get("/alarms", params={"kind": "other"})).status_code == 422
    assert (await client.get("/alarms", params={"from": "2026-01-01"})).status_code == 422


async def test_sums_are_of_the_last_week_unless_said_otherwise(client: httpx.AsyncClient, controller: Scripted) -> None:
    (row,) = (await client.get("/alarms/pareto", params={"by": "both"})).json()["items"]
    assert (row["source"], row["code"], row["times"], row["minutes"], row["share"]) == ("V001", "101", 3, 1.5, 1.0)
    assert controller.reader.asked_for == {"begin": NOW - 7 * 86400, "end": NOW}
    (by_code,) = (await client.get("/alarms/pareto")).json()["items"]
    assert by_code["source"] is None
    later = {"from": "2026-01-02T00:00:00Z"}
    assert (await client.get("/alarms/pareto", params=later)).json()["detail"] == "from lies in the future."


async def test_reliability_has_a_row_for_every_vehicle(client: httpx.AsyncClient) -> None:
    asked = {"from": "2025-12-31T22:00:00Z"}
    first, second = (await client.get("/alarms/reliability", params=asked)).json()["items"]
    assert first == {
        "vehicle": "V001",
        "failures": 1,
        "down_minutes": 30.0,
        "mtbf_hours": 1.5,
        "mttr_minutes": 30.0,
        "availability": 0.75,
    }
    assert (second["failures"], second["mtbf_hours"], second["availability"]) == (0, None, 1.0)


@pytest.mark.parametrize("number", ["0.5", "2026", "20260701", "1.7e9", "-5", "1782000000000"])
async def test_a_moment_that_is_a_number_is_refused_since_it_could_be_anything(
    number: str, client: httpx.AsyncClient
) -> None:
    answer = await client.get("/alarms", params={"to": number})
    assert answer.status_code == 422
    assert answer.json()["field"] == "to"
    assert "ISO 8601, such as 2026-07-01T08:30:00Z" in answer.json()["detail"]
