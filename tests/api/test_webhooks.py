"""Routes about webhooks."""

from typing import Any

import httpx
import pytest

from tests.api.scripted import Scripted

pytestmark = pytest.mark.anyio
URL = "https://mes.fab/hooks"


async def added(client: httpx.AsyncClient, **more: Any) -> dict[str, Any]:
    answer = await client.post("/webhooks", json={"url": URL, **more})
    assert answer.status_code == 201, answer.text
    assert answer.headers["location"] == f"/api/v1/webhooks/{answer.json()['id']}"
    found: dict[str, Any] = answer.json()
    return found


async def test_the_secret_is_shown_when_it_is_made_and_never_again(client: httpx.AsyncClient) -> None:
    first = await added(client, note="line 3")
    assert first["secret"].startswith("whsec_")
    assert len(first["secret"]) > 40
    for path in ("/webhooks", "/webhooks/1"):
        assert first["secret"] not in (await client.get(path)).text
    second = await client.post("/webhooks/1/secret", json={})
    assert second.json()["secret"] not in (first["secret"], "")
    changed = await client.patch("/webhooks/1", json={"note": "x"})
    assert "secret" not in changed.json()


@pytest.mark.parametrize(
    "url",
    [
        "https://elsewhere.example/x",
        "http://127.0.0.1/",
        "http://169.254.169.254/latest/meta-data",
        "https://me:word@mes.fab/x",
        "file:///etc/passwd",
        "https://mes.fab/\u00e9",
        "https://mes.fab/\r\nx: y",
    ],
)
async def test_a_url_that_the_settings_do_not_name_is_refused(client: httpx.AsyncClient, url: str) -> None:
    answer = await client.post("/webhooks", json={"url": url})
    assert (answer.status_code, answer.json()["code"], answer.json()["field"]) == (422, "invalid", "url")
    await added(client)
    assert (await client.patch("/webhooks/1", json={"url": url})).status_code == 422


@pytest.mark.parametrize(
    ("url", "remedy"),
    [
        ("https://elsewhere.example/x", "in HOISTWAY_WEBHOOK_TARGETS, or as webhook_targets in the settings file"),
        ("http://127.0.0.1/", "in HOISTWAY_WEBHOOK_TARGETS, or as webhook_targets in the settings file"),
        ("https://me:word@mes.fab/x", "Write a URL of http or https"),
        ("https://mes.fab/x#y", "Write a URL of http or https"),
    ],
)
async def test_a_url_that_is_refused_is_told_what_to_set_or_to_write(
    client: httpx.AsyncClient, url: str, remedy: str
) -> None:
    assert remedy in (await client.post("/webhooks", json={"url": url})).json()["remedy"]


async def test_an_event_that_there_is_not_is_refused_with_the_nearest_that_there_is(client: httpx.AsyncClient) -> None:
    answer = await client.post("/webhooks", json={"url": URL, "events": ["TransferComplete"]})
    assert answer.status_code == 422
    assert "did you mean TransferCompleted" in answer.json()["detail"]


async def test_a_webhook_can_be_replayed_pinged_and_removed(client: httpx.AsyncClient, controller: Scripted) -> None:
    await added(client, events=["TransferCompleted"])
    for _ in range(3):
        controller.happen("TransferCompleted", "J1")
    shown = (await client.get("/webhooks/1")).json()
    assert (shown["events"], shown["state"], shown["behind"]) == (["TransferCompleted"], "active", 3)
    assert (await client.post("/webhooks/1/replay", json={"after": 2})).json()["position"] == 2
    assert (await client.post("/webhooks/1/ping")).json()["taken"] is True
    (delivery,) = (await client.get("/webhooks/1/deliveries")).json()["items"]
    assert (delivery["seq"], delivery["status"], delivery["taken"]) == (7, None, False)
    assert (await client.delete("/webhooks/1")).status_code == 204
    for method, path in (("GET", ""), ("PATCH", ""), ("DELETE", ""), ("POST", "/ping"), ("GET", "/deliveries")):
        body = {"note": "x"} if method == "PATCH" else None
        answer = await client.request(method, f"/webhooks/1{path}", json=body)
        assert (answer.status_code, answer.json()["code"]) == (404, "not-found")
