"""Who may call at all: host names, origins, the access key, the size of bodies."""

from collections.abc import AsyncIterator

import httpx
import pytest
from fastapi import FastAPI
from pydantic import SecretStr

from app.api import application
from app.api.callers import TICKETS, Tickets
from app.settings import Settings
from tests.api.scripted import Scripted
from tests.api.sockets import Socket

pytestmark = pytest.mark.anyio
KEY = "0123456789abcdef"
BEARER = {"Authorization": f"Bearer {KEY}"}


def calls(app: FastAPI, host: str = "localhost") -> httpx.AsyncClient:
    transport = httpx.ASGITransport(app, raise_app_exceptions=False)
    return httpx.AsyncClient(transport=transport, base_url=f"http://{host}")


@pytest.fixture
def locked(controller: Scripted) -> FastAPI:
    return application(controller, Settings(access_key=SecretStr(KEY)))


@pytest.fixture
def opened(controller: Scripted) -> FastAPI:
    settings = Settings(allowed_hosts=("tc.fab",), allowed_origins=("https://mes.fab/",), body_limit=1024)
    return application(controller, settings)


@pytest.mark.parametrize(
    ("host", "status"),
    [
        ("localhost", 200),
        ("localhost:8080", 200),
        ("127.0.0.1", 200),
        ("[::1]:8080", 200),
        ("TC.fab", 200),
        ("evil.example", 421),
        ("127.0.0.1.evil.example", 421),
    ],
)
async def test_without_a_key_only_names_of_this_machine_are_answered(opened: FastAPI, host: str, status: int) -> None:
    async with calls(opened, host) as client:
        answer = await client.get("/api/v1/vehicles")
        assert answer.status_code == status
        if status == 421:
            assert answer.json()["code"] == "misdirected"


@pytest.mark.parametrize(
    ("origin", "status"),
    [
        ("http://localhost", 200),
        ("https://mes.fab", 200),
        ("http://evil.example", 403),
        ("null", 403),
        ("http://localhost:99", 403),
    ],
)
async def test_a_foreign_page_may_not_change_anything(opened: FastAPI, origin: str, status: int) -> None:
    async with calls(opened) as client:
        answer = await client.post("/api/v1/controller/resume", headers={"Origin": origin})
        assert answer.status_code == status
        assert (await client.get("/api/v1/controller", headers={"Origin": origin})).status_code == 200


async def test_a_foreign_page_may_not_watch(opened: FastAPI) -> None:
    async with Socket(opened, headers={"origin": "http://evil.example"}) as socket:
        assert await socket.message() == {
            "type": "websocket.close",
            "code": 1008,
            "reason": "A page of 'http://evil.example' may not call this server.",
        }


async def test_with_a_key_every_call_under_the_api_needs_it(locked: FastAPI) -> None:
    async with calls(locked, "tc.fab") as client:
        for headers in ({}, {"Authorization": "Bearer wrong"}, {"Authorization": f"Basic {KEY}"}):
            answer = await client.get("/api/v1/vehicles", headers=headers)
            assert answer.status_code == 401
            assert answer.headers["www-authenticate"].startswith("Bearer")
            assert answer.json()["code"] == "unauthorised"
        assert (await client.get("/api/v1/vehicles", headers=BEARER)).status_code == 200
        assert (await client.get("/api/v1/nowhere")).status_code == 401


@pytest.mark.parametrize("path", ["/healthz", "/readyz", "/api/openapi.json", "/api/docs"])
async def test_probes_and_descriptions_are_open(locked: FastAPI, path: str) -> None:
    async with calls(locked) as client:
        assert (await client.get(path)).status_code == 200


async def test_a_ticket_opens_the_live_stream_once(locked: FastAPI) -> None:
    async with calls(locked) as client:
        assert (await client.post("/api/v1/live/ticket")).status_code == 401
        ticket = (await client.post("/api/v1/live/ticket", headers=BEARER)).json()["ticket"]
    async with Socket(locked, query=f"topics=jobs&ticket={ticket}") as socket:
        await socket.accepted()
    async with Socket(locked, query=f"ticket={ticket}") as socket:
        assert (await socket.message())["type"] == "websocket.close"
    async with Socket(locked, headers={"authorization": f"Bearer {KEY}"}) as socket:
        await socket.accepted()


def test_a_ticket_is_good_for_half_a_minute_and_the_oldest_makes_room() -> None:
    now = [0.0]
    tickets = Tickets(lambda: now[0])
    first, late = tickets.give(), tickets.give()
    now[0] = 30.0
    assert tickets.take(first)
    now[0] = 30.1
    assert not tickets.take(late)
    oldest = tickets.give()
    newest = [tickets.give() for _ in range(TICKETS)]
    assert not tickets.take(oldest)
    assert tickets.take(newest[-1])


async def test_a_large_body_is_refused_before_it_is_read(opened: FastAPI) -> None:
    async def pieces() -> AsyncIterator[bytes]:
        for _ in range(3):
            yield b" " * 1000

    async with calls(opened) as client:
        declared = await client.post("/api/v1/jobs", content=b" " * 1025)
        chunked = await client.post("/api/v1/jobs", content=pieces(), headers={"Content-Type": "application/json"})
        odd = await client.post("/api/v1/jobs", content=pieces(), headers={"Content-Length": "9" * 30})
        for answer in (declared, chunked, odd):
            assert answer.status_code == 413
            assert answer.json()["code"] == "too-large"
