"""A query is refused where the route does not have it, or it says something twice: else a misspelt filter gives all."""

import httpx
import pytest
from fastapi import FastAPI

from app.api.application import application
from app.api.queries import wrong
from app.settings import Settings
from tests.api.scripted import Scripted
from tests.api.sockets import Socket

pytestmark = pytest.mark.anyio


@pytest.fixture
def app(controller: Scripted) -> FastAPI:
    return application(controller, Settings())


@pytest.mark.parametrize(
    ("path", "detail", "remedy"),
    [
        ("/jobs?stat=queued", "There is no parameter 'stat'.", "Did you mean state?"),
        ("/alarms?form=2026-01-01T00:00:00Z", "There is no parameter 'form'.", "Did you mean from?"),
        ("/vehicles?x=1", "There is no parameter 'x'.", "There are none here."),
        ("/alarms?limit=1&limit=2", "limit is given more than once.", "Give it once."),
    ],
)
async def test_a_query_that_the_route_does_not_have_is_refused_by_name(
    client: httpx.AsyncClient, path: str, detail: str, remedy: str
) -> None:
    answer = await client.get(path)
    assert (answer.status_code, answer.json()["detail"], answer.json()["remedy"]) == (422, detail, remedy)


async def test_it_is_refused_for_an_order_too_and_nothing_is_done(client: httpx.AsyncClient) -> None:
    order = {"source": "P1", "destination": "P2", "carrier": "FOUP0001"}
    answer = await client.post("/jobs?dry_run=true", json=order)
    assert (answer.status_code, answer.json()["field"]) == (422, "dry_run")
    assert answer.headers["connection"] == "close"


async def test_it_is_refused_in_the_callers_language(client: httpx.AsyncClient) -> None:
    answer = await client.get("/vehicles?x=1", headers={"Accept-Language": "ko"})
    assert answer.json()["detail"] == "매개변수 'x' 없음."


@pytest.mark.parametrize("path", ["/alarms", "/audit", "/alarms/reliability"])
async def test_a_period_that_ends_before_it_begins_is_refused(client: httpx.AsyncClient, path: str) -> None:
    answer = await client.get(path, params={"from": "2026-01-02T00:00:00Z", "to": "2026-01-01T00:00:00Z"})
    assert (answer.status_code, answer.json()["detail"]) == (422, "from does not lie before to.")


async def test_how_vehicles_held_out_is_known_up_to_now_alone(client: httpx.AsyncClient) -> None:
    answer = await client.get(
        "/alarms/reliability", params={"from": "2030-01-01T00:00:00Z", "to": "2030-01-02T00:00:00Z"}
    )
    assert (answer.status_code, answer.json()["detail"]) == (422, "from lies in the future.")


@pytest.mark.parametrize("written", ["T06:00:00+09:00", "T06:00:00.5+0900", "T06:00+09:00"])
async def test_a_plus_that_nobody_escaped_is_still_the_sign_of_a_zone(client: httpx.AsyncClient, written: str) -> None:
    bare, escaped = [
        await client.get(f"/statistics?from=2025-12-31{zone}&to=2025-12-31T08:00:00Z")
        for zone in (written, written.replace("+", "%2B"))
    ]
    assert (bare.status_code, bare.json()["from"]) == (200, escaped.json()["from"])
    assert bare.json()["from"].startswith("2025-12-30T21:00:00")


async def test_a_blank_elsewhere_in_a_moment_is_no_sign(client: httpx.AsyncClient) -> None:
    assert (await client.get("/statistics?from=2025-12-31 06:00:00Z")).json()["from"] == "2025-12-31T06:00:00.000Z"
    assert (await client.get("/statistics?from=2025-12-31T06:00:00 z1")).status_code == 422


async def test_a_moment_without_a_zone_is_refused_with_one_that_has_it(client: httpx.AsyncClient) -> None:
    answer = (await client.get("/statistics?from=2025-12-31T06:00:00")).json()
    assert answer["detail"].startswith("from: has no zone: say it, such as 2026-07-01T08:30:00Z")
    korean = await client.get("/statistics?from=2025-12-31T06:00:00", headers={"Accept-Language": "ko"})
    assert "시간대가 없음. 예: 2026-07-01T08:30:00Z" in korean.json()["detail"]


@pytest.mark.parametrize(
    ("query", "detail"),
    [
        ("topic=jobs", "There is no parameter 'topic'."),
        ("topics=jobs&topics=events", "topics is given more than once."),
        ("language=de", "There is no language 'de'."),
        ("language=ko&topics=x", "항목 'x' 없음."),
    ],
)
async def test_the_live_stream_refuses_what_its_address_does_not_have(app: FastAPI, query: str, detail: str) -> None:
    async with Socket(app, query=query) as socket:
        await socket.accepted()
        assert (await socket.frame())["problem"]["detail"] == detail


async def test_refusals_over_the_live_stream_are_in_the_language_of_its_address(app: FastAPI) -> None:
    async with Socket(app, query="language=ko") as socket:
        await socket.accepted()
        await socket.frame()
        socket.say('{"id": 1, "command": {"name": "vehicle.hold", "body": {"reason": "look"}}, "actor": "kim"}')
        problem = (await socket.frame())["problem"]
        assert (problem["field"], problem["detail"]) == ("command.target", "이 명령은 대상 하나를 지정해야 합니다.")


async def test_what_may_be_given_more_than_once_may() -> None:
    assert wrong(b"a=1&a=2&b=", {"a": True, "b": False}) is None
    assert wrong(b"a=1&%61=2", {"a": False}) is not None, "the same name, written another way"


async def test_a_number_that_no_event_has_yet_is_refused_not_waited_for(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    controller.happen("VehicleDeparted", vehicle="V001")
    assert (await client.get("/events", params={"after": 1})).json()["items"] == []
    answer = await client.get("/events", params={"after": 99})
    assert (answer.status_code, answer.json()["field"]) == (409, "after")
    assert answer.json()["detail"] == "There is no event 99 yet: the newest is 1."
    stream = await client.get("/events/stream", params={"after": 99})
    assert (stream.status_code, stream.json()["field"]) == (409, "after")
    resumed = await client.get("/events/stream", headers={"Last-Event-ID": "99"})
    assert (resumed.status_code, resumed.json()["field"]) == (409, "Last-Event-ID")
    controller.model.last_event = 0  # it is kept, and not published yet
    assert (await client.get("/events", params={"after": 1})).json()["items"] == []
