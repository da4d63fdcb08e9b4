"""Audit walks over REST."""

import httpx
import pytest

from app.domain.walks import AcceptWalk, EnterSights, Sight, StartWalk
from tests.api.scripted import Scripted

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}


async def test_a_walk_is_begun_entered_compared_and_accepted(client: httpx.AsyncClient, controller: Scripted) -> None:
    begun = await client.post("/walks", json={"reason": "outage"}, headers=KIM)
    assert (begun.status_code, begun.headers["location"]) == (201, "/api/v1/walks/1")
    assert (begun.json()["state"], begun.json()["entered"]) == ("open", 0)
    (place,) = (await client.get("/walks/1/places")).json()["items"]
    assert (place["station"], place["finding"]) == ("L3", "not_seen")
    entered = await client.put("/walks/1/places/L3", json={"present": True, "carrier": "F1"}, headers=KIM)
    assert entered.json()["entered"] == 1
    (place,) = (await client.get("/walks/1/places", params={"finding": "differs"})).json()["items"]
    assert (place["seen"], place["now"], place["by"]) == (True, None, "kim")
    assert (await client.get("/walks/1/places", params={"finding": "moved"})).json()["items"] == []
    accepted = await client.post("/walks/1/accept", json={"partial": True}, headers=KIM)
    assert (accepted.json()["state"], accepted.json()["ended_by"]) == ("accepted", "kim")
    assert (await client.get("/walks")).json()["items"] == []
    assert (await client.get("/walks/history")).json()["items"] == [accepted.json()]
    kim = controller.seen[0].actor
    assert controller.seen == [
        StartWalk(kim, "outage"),
        EnterSights(kim, 1, (Sight("L3", present=True, carrier="F1"),)),  # type: ignore[arg-type]
        AcceptWalk(kim, 1, partial=True),
    ]


async def test_a_named_person_walks_and_unknown_walks_are_not_found(client: httpx.AsyncClient) -> None:
    assert (await client.post("/walks", json={"reason": "x"})).json()["field"] == "X-Actor"
    assert (await client.get("/walks/7")).status_code == 404
    assert (await client.get("/walks/7/places")).status_code == 404
    sights = {"sights": [{"station": "L3", "present": False}]}
    assert (await client.post("/walks/7/places", json=sights, headers=KIM)).status_code == 404
    assert (await client.post("/walks/7/abandon", json={"reason": "x"}, headers=KIM)).status_code == 404
