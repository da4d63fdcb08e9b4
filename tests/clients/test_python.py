"""The Python client: up to date, and right against the application and a scripted server."""

import asyncio
import json
import ssl
import subprocess
import sys
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from typing import Any

import httpx
import pytest
import trustme
from fastapi import FastAPI
from hoistway_client import (
    AsyncHoistway,
    Changed,
    Happened,
    Hoistway,
    Live,
    NoController,
    NotConnected,
    Problem,
    TimedOut,
    Unreachable,
    Untrusted,
)
from hoistway_client import client as clients
from hoistway_client import live as living
from websockets.asyncio.server import ServerConnection, serve

from tests.api.conftest import controller, described_app, served  # noqa: F401
from tests.api.scripted import Scripted
from tools.client import FOLDER, texts

pytestmark = pytest.mark.anyio
Json = dict[str, Any]


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


def test_what_is_made_from_the_description_is_up_to_date() -> None:
    for name, text in texts().items():
        assert (FOLDER / name).read_text(encoding="utf-8") == text, "run `python -m tools.client`"


def test_the_command_compares() -> None:
    done = subprocess.run([sys.executable, "-m", "tools.client", "--check"], check=False)
    assert done.returncode == 0


async def test_calls_travel_as_the_api_wants_them(served: FastAPI, controller: Scripted) -> None:  # noqa: F811
    transport = httpx.ASGITransport(served)
    async with AsyncHoistway("http://localhost", actor="검사", transport=transport) as hoistway:
        job = await hoistway.create_job({"job_id": "LOT-1", "source": "P1", "destination": "P2"}, idempotency_key="k")
        assert (job["id"], job["state"]) == ("LOT-1", "queued")
        assert controller.seen[-1].actor == "검사"
        assert (await hoistway.get_job("LOT-1"))["source"] == "P1"
        page = await hoistway.list_jobs(limit=10)
        assert [one["id"] for one in page["items"]] == ["LOT-1"]
        with pytest.raises(Problem) as refused:
            await hoistway.get_job("a b")
        assert refused.value.code in {"not-found", "invalid"}
        with pytest.raises(Problem) as refused:
            await hoistway.create_job({"source": "P1", "destination": "nowhere"})
        assert (refused.value.status, refused.value.code, refused.value.field) == (422, "invalid", "destination")
        assert refused.value.remedy
        made = await hoistway.add_webhook({"url": "https://mes.fab/hooks"})
        assert made["secret"].startswith("whsec_")
        await hoistway.remove_webhook(made["id"])
        assert controller.subscribed == {}


def test_events_go_on_after_a_lost_connection_and_none_comes_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clients, "FIRST_PAUSE", 0.0)
    asked: list[str] = []

    def answer(request: httpx.Request) -> httpx.Response:
        asked.append(str(request.url.query, "ascii"))
        if len(asked) == 2:
            raise httpx.ConnectError("gone")
        if len(asked) == 3:
            return httpx.Response(503, json={"code": "unavailable", "detail": "x"})
        seqs = [1, 2] if len(asked) == 1 else [2, 3]
        lines = [f'id: {seq}\nevent: X\ndata: {{"seq": {seq}}}\n\n' for seq in seqs]
        headers = {"Content-Type": "text/event-stream; charset=utf-8"}
        return httpx.Response(200, text=": events\n\n" + "".join(lines), headers=headers)

    with Hoistway("http://h", transport=httpx.MockTransport(answer)) as hoistway:
        stream = hoistway.events(0)
        assert [next(stream)["seq"] for _ in range(3)] == [1, 2, 3]
    assert asked == ["after=0", "after=2", "after=2", "after=2"]


def test_a_refusal_ends_the_events() -> None:
    transport = httpx.MockTransport(
        lambda request: httpx.Response(401, json={"code": "unauthorised", "detail": "who?"})
    )
    with Hoistway("http://h", transport=transport) as hoistway, pytest.raises(Problem, match="who"):
        next(hoistway.events(0))


PAGE = "<html><body>502 Bad Gateway</body></html>"


def playing(answer: httpx.Response | httpx.TransportError) -> Hoistway:
    """A client to whom everything is answered so."""

    def play(_request: httpx.Request) -> httpx.Response:
        if isinstance(answer, httpx.TransportError):
            raise answer
        return answer

    return Hoistway("http://tc.fab:8080", transport=httpx.MockTransport(play))


@pytest.mark.parametrize(
    ("error", "kind", "why"),
    [
        (httpx.ConnectError("Connection refused"), NotConnected, "Connection refused"),
        (httpx.ConnectTimeout(""), NotConnected, "no connection in time"),
        (httpx.UnsupportedProtocol("no http"), NotConnected, "no http"),
        (httpx.ReadTimeout(""), TimedOut, "no answer in time"),
        (httpx.RemoteProtocolError("Server disconnected"), Unreachable, "Server disconnected"),
        (httpx.ReadError(""), Unreachable, "the connection was lost"),
    ],
)
def test_what_keeps_an_answer_away_is_an_error_of_the_clients_own(
    error: httpx.TransportError, kind: type[Unreachable], why: str
) -> None:
    with playing(error) as hoistway, pytest.raises(Unreachable) as none:
        hoistway.get_job("J1")
    assert type(none.value) is kind
    assert (none.value.asked, none.value.why) == ("GET http://tc.fab:8080/api/v1/jobs/J1", why)
    assert none.value.remedy in str(none.value)
    assert none.value.__cause__ is error


@pytest.mark.parametrize(
    ("answer", "status", "why"),
    [
        (httpx.Response(200, html=PAGE), 200, "the answer (200, text/html) is no JSON of a controller: '<html>"),
        (httpx.Response(502, html=PAGE), 502, "the answer (502, text/html) is no JSON of a controller: '<html>"),
        (
            httpx.Response(404, json={"message": "no"}),
            404,
            "the answer (404, application/json) is no JSON of a controller",
        ),
        (httpx.Response(302, headers={"Location": "/login"}), 302, "it leads elsewhere (302 /login)"),
    ],
    ids=["page", "gateway", "other", "elsewhere"],
)
def test_a_proxys_page_is_no_controllers_answer(answer: httpx.Response, status: int, why: str) -> None:
    with playing(answer) as hoistway, pytest.raises(NoController) as none:
        hoistway.list_jobs()
    assert (none.value.status, none.value.text) == (status, answer.text)
    assert none.value.why.startswith(why)


def test_another_program_ends_the_events_and_a_server_that_is_away_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clients, "FIRST_PAUSE", 0.0)
    with playing(httpx.Response(200, html=PAGE)) as hoistway, pytest.raises(NoController, match="Bad Gateway"):
        next(hoistway.events(0))
    with playing(httpx.ConnectError("away")) as hoistway:
        assert list(hoistway.events(0, forever=False)) == []


async def test_a_server_that_is_not_there_and_one_that_is_not_trusted_say_so() -> None:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    trustme.CA().issue_cert("127.0.0.1").configure_cert(context)
    server = await asyncio.start_server(lambda _reader, writer: writer.close(), "127.0.0.1", 0, ssl=context)
    port = server.sockets[0].getsockname()[1]
    async with server, AsyncHoistway(f"https://127.0.0.1:{port}") as hoistway:
        with pytest.raises(Untrusted, match=r"certificate is not trusted \(.*\)\. Set SSL_CERT_FILE"):
            await hoistway.list_jobs()
        async with Live(f"https://127.0.0.1:{port}") as live:
            with pytest.raises(Untrusted, match="certificate is not trusted"):
                await anext(live)
    async with AsyncHoistway(f"http://127.0.0.1:{port}") as hoistway:
        with pytest.raises(NotConnected, match=f"GET http://127.0.0.1:{port}/api/v1/jobs: ") as away:
            await hoistway.list_jobs()
    assert away.value.remedy == "Does the server run, and is the address right?"


async def test_a_server_without_tls_is_told_from_one_that_is_not_trusted() -> None:
    def answer(_reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(b"HTTP/1.1 400 No\r\n\r\n")
        writer.close()

    server = await asyncio.start_server(answer, "127.0.0.1", 0)
    port = server.sockets[0].getsockname()[1]
    async with server, AsyncHoistway(f"https://127.0.0.1:{port}") as hoistway:
        with pytest.raises(Untrusted, match=r"TLS was not agreed on .* Else write http://"):
            await hoistway.list_jobs()


class Server:
    """Plays the live stream: each connection gets one script of frames; a str is what has to be heard, None cuts."""

    def __init__(self, *scripts: Sequence[Json | str | None]) -> None:
        self.scripts = list(scripts)
        self.paths: list[str] = []

    @asynccontextmanager
    async def open(self) -> AsyncIterator[str]:
        async with serve(self._play, "127.0.0.1", 0) as server:
            yield f"http://127.0.0.1:{next(iter(server.sockets)).getsockname()[1]}"

    async def _play(self, socket: ServerConnection) -> None:
        assert socket.request is not None
        self.paths.append(socket.request.path)
        for step in self.scripts.pop(0):
            if step is None:
                await socket.close()
                return
            if isinstance(step, str):
                assert step in str(await socket.recv())
            else:
                await socket.send(json.dumps(step))
        await socket.wait_closed()


def snapshot(seq: int, last: int, **vehicles: Json) -> Json:
    return {"type": "snapshot", "seq": seq, "last_event": last, "objects": {"vehicles": vehicles}}


def change(seq: int, key: str, value: Json | None) -> Json:
    return {"type": "change", "seq": seq, "changes": [{"topic": "vehicles", "key": key, "value": value}]}


def happened(*seqs: int) -> Json:
    return {"type": "event", "events": [{"seq": seq} for seq in seqs]}


async def taken(live: Live, number: int) -> list[Changed | Happened]:
    async with asyncio.timeout(60):
        return [await anext(live) for _ in range(number)]


async def test_the_copy_follows_the_changes_and_a_gap_leads_to_a_fresh_snapshot() -> None:
    script: list[Json | str | None] = [
        snapshot(5, 10, V1={"n": 1}, V2={"n": 1}),
        change(6, "V1", {"n": 2}),
        change(8, "V9", {"n": 9}),
        '"resync": true',
        {"type": "resync"},
        change(9, "V9", {"n": 8}),
        snapshot(9, 10, V1={"n": 2}, V3={"n": 1}),
        change(10, "V3", None),
    ]
    async with Server(script).open() as url, Live(url, topics=["vehicles"]) as live:
        items = await taken(live, 6)
        assert items == [
            Changed("vehicles", "V1", {"n": 1}, snapshot=True),
            Changed("vehicles", "V2", {"n": 1}, snapshot=True),
            Changed("vehicles", "V1", {"n": 2}),
            Changed("vehicles", "V2", None, snapshot=True),
            Changed("vehicles", "V3", {"n": 1}, snapshot=True),
            Changed("vehicles", "V3", None),
        ]
        assert live.state == {"vehicles": {"V1": {"n": 2}}}
        assert live.resyncs == 2


async def test_after_a_lost_connection_events_go_on_where_they_were(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(living, "FIRST_PAUSE", 0.0)
    server = Server([snapshot(0, 3), happened(4, 5), None], [snapshot(0, 7), happened(5, 6), happened(7)])
    async with server.open() as url, Live(url, topics=["vehicles", "events"]) as live:
        items = await taken(live, 4)
        assert [item.event["seq"] for item in items if isinstance(item, Happened)] == [4, 5, 6, 7]
    assert server.paths == ["/api/v1/live?topics=vehicles,events", "/api/v1/live?topics=vehicles,events&after=5"]


async def test_a_command_is_answered_by_its_number_or_by_its_problem() -> None:
    problem = {"type": "x", "title": "t", "status": 409, "code": "not-now", "detail": "V1 is away", "remedy": "wait"}
    script: list[Json | str | None] = [
        snapshot(0, 0, V1={}),
        '"vehicle.hold"',
        {"type": "reply", "id": 1, "status": 200, "location": None, "body": {"id": "V1"}},
        '"actor": "kim"',
        {"type": "error", "id": 2, "problem": problem},
        "{}",
    ]
    async with Server(script).open() as url, Live(url, actor="kim") as live:
        await taken(live, 1)
        reading = asyncio.ensure_future(anext(live))
        reply = await live.command("vehicle.hold", "V1", {"reason": "look"})
        assert reply["body"] == {"id": "V1"}
        with pytest.raises(Problem, match="V1 is away"):
            await live.command("vehicle.release", "V1", {})
        reading.cancel()
        await asyncio.gather(reading, return_exceptions=True)


async def test_what_is_asked_when_the_connection_goes_is_not_known() -> None:
    async with Server([snapshot(0, 0, V1={}), "vehicle.hold", None], []).open() as url, Live(url) as live:
        with pytest.raises(ConnectionError):
            await live.command("vehicle.hold", "V1", {})
        await taken(live, 1)
        reading = asyncio.ensure_future(anext(live))
        with pytest.raises(ConnectionError, match="look at what became"):
            await live.command("vehicle.hold", "V1", {})
        reading.cancel()
        await asyncio.gather(reading, return_exceptions=True)
