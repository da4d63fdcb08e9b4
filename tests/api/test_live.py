"""The live stream over a WebSocket."""

import asyncio

import httpx
import pytest
from fastapi import FastAPI

from app.api import application, events
from app.domain import requests as r
from app.settings import Settings
from tests.api.scripted import ACTOR, Scripted
from tests.api.sockets import Socket

pytestmark = pytest.mark.anyio


@pytest.fixture
def app(controller: Scripted) -> FastAPI:
    return application(controller, Settings(watchers=2))


async def settle() -> None:
    for _ in range(10):
        await asyncio.sleep(0)


async def test_a_watcher_gets_the_state_then_changes_and_events(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=controller,events") as socket:
        await socket.accepted()
        snapshot = await socket.frame()
        assert snapshot["type"] == "snapshot"
        assert snapshot["objects"]["controller"]["controller"]["state"] == "auto"
        await controller.ask(r.PauseController(ACTOR, "tea"))
        controller.happen("ControllerPausing")
        controller.hub.flush()
        change, event = await socket.frame(), await socket.frame()
        assert change["seq"] == snapshot["seq"] + 1
        assert change["changes"][0]["value"]["reason"] == "tea"
        assert [e["event"] for e in event["events"]] == ["ControllerPausing"]
    assert controller.hub.watchers == 0


async def test_without_topics_a_watcher_gets_all_but_commands(app: FastAPI) -> None:
    async with Socket(app) as socket:
        await socket.accepted()
        snapshot = await socket.frame()
        assert sorted(snapshot["objects"]) == [
            "alarms",
            "carriers",
            "closures",
            "controller",
            "devices",
            "drives",
            "jobs",
            "stations",
            "teaching",
            "vehicles",
            "walks",
        ]
        assert snapshot["objects"]["vehicles"]["V001"]["bits"][0] == {"name": "MODE", "value": 3, "meaning": "AUTO"}


async def test_events_resume_after_a_number(app: FastAPI, controller: Scripted) -> None:
    for _ in range(3):
        controller.happen("Transferring")
    async with Socket(app, query="topics=events&after=1") as socket:
        await socket.accepted()
        assert (await socket.frame())["last_event"] == 3
        assert [e["seq"] for e in (await socket.frame())["events"]] == [2, 3]


async def test_a_watcher_can_ask_for_a_resync_and_for_other_topics(app: FastAPI) -> None:
    async with Socket(app, query="topics=jobs") as socket:
        await socket.accepted()
        await socket.frame()
        socket.say('{"resync": true}')
        assert [(await socket.frame())["type"], (await socket.frame())["type"]] == ["resync", "snapshot"]
        socket.say('{"topics": ["carriers"]}')
        assert (await socket.frame())["type"] == "resync"
        assert list((await socket.frame())["objects"]) == ["carriers"]


@pytest.mark.parametrize(
    "said", ["", "{", "null", "{}", '{"resync": 1}', '{"topics": ["?"]}', '{"topics": 5}', '{"x": 1}', '"' + "a" * 5000]
)
async def test_what_is_not_understood_gets_an_error_and_the_stream_goes_on(
    app: FastAPI, controller: Scripted, said: str
) -> None:
    async with Socket(app, query="topics=controller") as socket:
        await socket.accepted()
        await socket.frame()
        socket.say(said)
        error = await socket.frame()
        assert error["type"] == "error"
        assert error["problem"]["detail"]
        await controller.ask(r.ResumeController(ACTOR))
        controller.hub.flush()
        assert (await socket.frame())["type"] == "change"


@pytest.mark.parametrize(
    ("query", "field"), [("topics=nonsense", "topics"), ("after=-1", "after"), ("after=", "after")]
)
async def test_a_wrong_question_is_answered_and_closed(app: FastAPI, query: str, field: str) -> None:
    async with Socket(app, query=query) as socket:
        await socket.accepted()
        assert (await socket.frame())["problem"]["field"] == field
        assert (await socket.message())["code"] == 1008


async def test_the_reason_of_a_closing_fits_its_frame_in_any_alphabet(app: FastAPI) -> None:
    async with Socket(app, query="topics=" + "%F0%9F%98%80" * 60) as socket:
        await socket.accepted()
        assert (await socket.frame())["problem"]["field"] == "topics"
        reason = (await socket.message())["reason"]
        assert len(reason.encode()) <= 123
        assert reason.endswith("\U0001f600")


async def test_only_so_many_may_watch(app: FastAPI) -> None:
    async with Socket(app) as one, Socket(app) as two:
        await one.accepted()
        await two.accepted()
        await two.frame()
        async with Socket(app) as three:
            await three.accepted()
            assert (await three.frame())["problem"]["code"] == "too-many"


async def test_server_sent_events_carry_number_name_and_body(app: FastAPI, controller: Scripted) -> None:
    for name in ("TransferInitiated", "VehicleAssigned"):
        controller.happen(name, "J1")
    chunks = await _stream(app, controller, {"last-event-id": "1"})
    assert chunks[0] == ": events\n\n"
    number, name, data = chunks[1].strip().split("\n")
    assert (number, name) == ("id: 2", "event: VehicleAssigned")
    assert data.startswith('data: {"seq":2,"ts":"2026-01-01T00:00:00.000Z"')
    assert controller.hub.watchers == 0


async def _stream(app: FastAPI, controller: Scripted, headers: dict[str, str]) -> list[str]:
    """Return the first two pieces of the event stream, then hang up."""
    pieces: asyncio.Queue[str] = asyncio.Queue()
    gone = asyncio.Event()

    async def receive() -> dict[str, object]:
        await gone.wait()
        return {"type": "http.disconnect"}

    async def send(message: dict[str, object]) -> None:
        body = message.get("body", b"")
        assert isinstance(body, bytes)
        if body:
            pieces.put_nowait(body.decode())

    raw = [(name.encode(), value.encode()) for name, value in ({"host": "localhost"} | headers).items()]
    path = "/api/v1/events/stream"
    scope = {
        "type": "http",
        "asgi": {"version": "3.0"},
        "method": "GET",
        "path": path,
        "query_string": b"",
        "headers": raw,
        "scheme": "http",
        "server": ("localhost", 80),
    }
    task = asyncio.ensure_future(app(scope, receive, send))  # type: ignore[arg-type]
    async with asyncio.timeout(60):
        got = [await pieces.get(), await pieces.get()]
    gone.set()
    await task
    return got


async def test_events_are_listed_in_pages_by_job_and_vehicle(client: httpx.AsyncClient, controller: Scripted) -> None:
    for job, vehicle in (("J1", None), ("J1", "V001"), ("J2", "V001")):
        controller.happen("Transferring", job, vehicle)
    page = (await client.get("/events", params={"limit": 2})).json()
    assert [e["seq"] for e in page["items"]] == [1, 2]
    assert page["next"] == 2
    rest = (await client.get("/events", params={"after": 2})).json()
    assert ([e["seq"] for e in rest["items"]], rest["next"]) == ([3], None)
    some = (await client.get("/events", params={"job": "J1", "vehicle": "V001"})).json()
    assert [e["seq"] for e in some["items"]] == [2]


async def test_a_silent_stream_of_events_shows_that_it_is_alive(
    app: FastAPI, controller: Scripted, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(events, "HEARTBEAT", 0.0)
    assert await _stream(app, controller, {}) == [": events\n\n", ": alive\n\n"]


async def test_a_stream_of_events_ends_by_itself_when_the_server_stops(app: FastAPI, controller: Scripted) -> None:
    sent: list[dict[str, object]] = []
    begun = asyncio.Event()

    async def receive() -> dict[str, object]:
        await asyncio.Event().wait()
        raise AssertionError

    async def send(message: dict[str, object]) -> None:
        sent.append(message)
        begun.set()

    scope: dict[str, object] = {"type": "http", "asgi": {"version": "3.0"}, "method": "GET"}
    scope |= {"path": "/api/v1/events/stream"}
    scope |= {"query_string": b"", "headers": [(b"host", b"localhost")], "scheme": "http", "server": ("localhost", 80)}
    task = asyncio.ensure_future(app(scope, receive, send))  # type: ignore[arg-type]
    await begun.wait()
    app.state.callers.leave()
    async with asyncio.timeout(60):
        await task
    assert sent[-1] == {"type": "http.response.body", "body": b"", "more_body": False}
    assert controller.hub.watchers == 0
    assert not app.state.callers.following


async def test_too_many_streams_of_events_are_refused(app: FastAPI) -> None:
    async with Socket(app) as one, Socket(app) as two:
        await one.accepted()
        await two.accepted()
        await two.frame()
        transport = httpx.ASGITransport(app)
        async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
            answer = await client.get("/api/v1/events/stream")
            assert (answer.status_code, answer.json()["code"]) == (429, "too-many")
