"""The operator page, and orders whose body comes in pieces or not at all."""

import asyncio
import importlib
from collections.abc import AsyncIterator
from pathlib import Path

import httpx
import pytest
from fastapi import FastAPI

from app.settings import Settings
from tests.api.scripted import Scripted

pytestmark = pytest.mark.anyio
making = importlib.import_module("app.api.application")


async def test_the_page_is_served_with_its_parts_and_may_load_nothing_else(
    controller: Scripted, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "assets").mkdir()
    (tmp_path / "index.html").write_text("<title>Hoistway</title>")
    (tmp_path / "assets" / "page.js").write_text("1")
    monkeypatch.setattr(making, "PAGE", tmp_path)
    app = making.application(controller, Settings())
    transport = httpx.ASGITransport(app, raise_app_exceptions=False)
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
        page = await client.get("/")
        assert "Hoistway" in page.text
        assert page.headers["content-security-policy"].startswith("default-src 'self'")
        assert (await client.get("/assets/page.js")).text == "1"
        missing = await client.get("/assets/none.js")
        assert (missing.status_code, missing.json()["code"]) == (404, "no-such-path")


async def test_without_a_built_page_the_api_is_there_all_the_same(
    controller: Scripted, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(making, "PAGE", tmp_path)
    app = making.application(controller, Settings())
    async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://localhost") as client:
        assert (await client.get("/")).status_code == 404
        assert (await client.get("/api/v1/vehicles")).status_code == 200


async def test_an_order_may_come_in_pieces(client: httpx.AsyncClient) -> None:
    async def pieces() -> AsyncIterator[bytes]:
        yield b'{"source": "P1",'
        yield b' "destination": "P2"}'

    answer = await client.post("/jobs", content=pieces(), headers={"Content-Type": "application/json"})
    assert answer.status_code == 201


async def test_a_caller_that_hangs_up_before_its_order_is_whole_orders_nothing(
    served: FastAPI, controller: Scripted
) -> None:
    messages: list[dict[str, object]] = [
        {"type": "http.request", "body": b"{", "more_body": True},
        {"type": "http.disconnect"},
    ]
    sent: list[object] = []

    async def receive() -> dict[str, object]:
        return messages.pop(0)

    async def send(message: object) -> None:
        sent.append(message)

    scope = {
        "type": "http",
        "method": "POST",
        "path": "/api/v1/jobs",
        "query_string": b"",
        "headers": [(b"host", b"localhost"), (b"content-type", b"application/json")],
    }
    await served(scope, receive, send)
    await asyncio.sleep(0)
    assert not sent
    assert not controller.seen
