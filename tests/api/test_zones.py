"""Zones over REST: paused, stopped, resumed; and everything stopped at once."""

import httpx
import pytest

from app.domain.ids import ZoneId
from app.domain.requests import PauseZone, ResumeZone, StopAll
from tests.api.scripted import Scripted

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}


async def test_a_zone_is_paused_stopped_and_resumed(client: httpx.AsyncClient, controller: Scripted) -> None:
    (zone,) = (await client.get("/zones")).json()["items"]
    assert (zone["id"], zone["state"], zone["pause"], zone["vehicles"]) == ("Z1", "auto", None, [])
    paused = (await client.post("/zones/Z1/pause", json={"reason": "look"}, headers=KIM)).json()
    assert paused["state"] == "paused"
    assert paused["pause"] == {
        "zone": "Z1",
        "owner": "kim",
        "reason": "look",
        "since": "2026-01-01T00:00:00.000Z",
        "stopped": False,
    }
    stopped = (await client.post("/zones/Z1/stop", json={"reason": "smoke"}, headers=KIM)).json()
    assert stopped["state"] == "stopped"
    assert (await client.get("/controller")).json()["pauses"] == [stopped["pause"]]
    assert (await client.post("/zones/Z1/resume", headers=KIM)).json()["state"] == "auto"
    kim = controller.seen[0].actor
    assert controller.seen == [
        PauseZone(kim, ZoneId("Z1"), "look"),
        PauseZone(kim, ZoneId("Z1"), "smoke", stop=True),
        ResumeZone(kim, ZoneId("Z1")),
    ]
    assert (await client.get("/zones/Z9")).status_code == 404
    assert (await client.post("/zones/Z9/pause", json={"reason": "x"})).status_code == 404


async def test_everything_is_stopped_by_one_request(client: httpx.AsyncClient, controller: Scripted) -> None:
    answer = await client.post("/controller/stop", json={"reason": "somebody shouts"}, headers=KIM)
    assert (answer.status_code, answer.json()["state"]) == (200, "pausing")
    assert isinstance(controller.seen[-1], StopAll)
    assert (await client.post("/controller/stop", json={})).status_code == 422
