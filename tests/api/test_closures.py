"""Closures over REST and by name over the live stream."""

import httpx
import pytest

from app.domain.closures import ClosedPlace, ClosePlace, ClosurePurpose, OpenPlace, PlaceKind
from tests.api.scripted import NOW, Scripted

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}
ZONE = {"kind": "zone", "zone": "Z1"}


async def test_a_place_is_closed_shown_listed_and_opened(client: httpx.AsyncClient, controller: Scripted) -> None:
    closed = await client.post("/closures", json={"place": ZONE, "reason": "rail change"}, headers=KIM)
    assert (closed.status_code, closed.headers["location"]) == (201, "/api/v1/closures/1")
    assert closed.json()["state"] == "draining"
    assert closed.json()["since"] == "2026-01-01T00:00:00.000Z"
    assert (await client.get("/closures")).json()["items"] == [closed.json()]
    opened = await client.post("/closures/1/open", json={"reason": "done"}, headers=KIM)
    assert (opened.json()["state"], opened.json()["ended_by"]) == ("opened", "kim")
    assert (await client.get("/closures")).json()["items"] == []
    assert (await client.get("/closures/1")).json() == opened.json()
    assert (await client.get("/closures/history")).json() == {"items": [opened.json()], "next": None}
    assert controller.seen[-1] == OpenPlace(controller.seen[-1].actor, 1, "done")


@pytest.mark.parametrize(
    ("place", "worded"),
    [
        ({"kind": "barcode", "barcodes": ["1001", "1002"]}, ClosedPlace(PlaceKind.BARCODE, ("1001", "1002"))),
        ({"kind": "edge", "from": "1001", "to": "1002"}, ClosedPlace(PlaceKind.EDGE, ("1001", "1002"))),
        ({"kind": "stretch", "from": "1001", "to": "1003"}, ClosedPlace(PlaceKind.STRETCH, ("1001", "1003"))),
        ({"kind": "station", "station": "P1"}, ClosedPlace(PlaceKind.STATION, ("P1",))),
    ],
)
async def test_places_are_named_in_five_ways(
    client: httpx.AsyncClient, controller: Scripted, place: dict[str, object], worded: ClosedPlace
) -> None:
    body = {"place": place, "reason": "x", "purpose": "work"}
    assert (await client.post("/closures", json=body, headers=KIM)).status_code == 201
    asked = controller.seen[-1]
    assert isinstance(asked, ClosePlace)
    assert (asked.place, asked.purpose, asked.expires) == (worded, ClosurePurpose.WORK, None)


@pytest.mark.parametrize(
    ("more", "field"),
    [
        ({"expires": 1767225600}, "expires"),
        ({"expires": "2026-01-01T00:00:00"}, "expires"),
        ({"expires": "2030-01-01T00:00:00Z"}, "expires"),
        ({"expires": "2026-01-01T01:00:00Z", "minutes": 5}, "minutes"),
        ({"place": {"kind": "rail"}}, "place.kind"),
        ({"reason": ""}, "reason"),
    ],
)
async def test_what_cannot_be_is_refused_with_its_field(
    client: httpx.AsyncClient, more: dict[str, object], field: str
) -> None:
    answer = await client.post("/closures", json={"place": ZONE, "reason": "x", **more}, headers=KIM)
    assert (answer.status_code, answer.json()["field"]) == (422, field)


async def test_an_end_is_a_moment_or_minutes_from_now(client: httpx.AsyncClient, controller: Scripted) -> None:
    for more in ({"expires": "2026-01-01T01:00:00Z"}, {"minutes": 60}):
        await client.post("/closures", json={"place": ZONE, "reason": "x", **more}, headers=KIM)
        asked = controller.seen[-1]
        assert isinstance(asked, ClosePlace)
        assert asked.expires == NOW + 3600


async def test_a_named_person_closes_and_opens(client: httpx.AsyncClient) -> None:
    answer = await client.post("/closures", json={"place": ZONE, "reason": "x"})
    assert answer.json()["field"] == "X-Actor"
    assert (await client.post("/closures/9/open", json={}, headers=KIM)).status_code == 404
    assert (await client.get("/closures/9")).status_code == 404


async def test_a_preview_tells_what_would_happen_and_asks_nothing_of_the_controller(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    answer = await client.post("/closures/preview", json={"place": {"kind": "barcode", "barcodes": ["1002"]}})
    found = answer.json()
    assert (found["stations"], found["jobs_touched"]) == (["P2"], 1)
    assert found["jobs"] == [{"job": "J1", "why": "its destination P2 would be closed"}]
    assert found["cut_off"] == ["P1", "L3"]
    assert found["routes"]["lost"] > 0
    assert controller.seen == []
    unknown = await client.post("/closures/preview", json={"place": {"kind": "barcode", "barcodes": ["7"]}})
    assert (unknown.status_code, unknown.json()["detail"]) == (422, "there is no barcode 7")
