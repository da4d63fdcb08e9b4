"""Logging in, renewing, logging out; users and keys; what ends with them. Time is the test's."""

import asyncio
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from fastapi import FastAPI
from pydantic import SecretStr

from app.api import application
from app.domain.access import Role
from app.runtime.reception import LOG_IN_LIFE, OVERLAP, TOKEN_LIFE, Reception
from app.settings import Settings
from app.store.reading import Reader
from tests.api.receptions import PASSWORD, ROOT, START, Hand, reception, with_admin
from tests.api.scripted import Scripted
from tests.api.sockets import Socket

pytestmark = pytest.mark.anyio
KIM = {"name": "kim", "password": PASSWORD}
LEE = {"name": "lee", "password": "staple battery 2", "roles": ["operator"]}


@pytest.fixture
def clock() -> Hand:
    return Hand()


@pytest.fixture
async def desk(tmp_path: Path, clock: Hand) -> AsyncIterator[Reception]:
    async with reception(tmp_path, clock) as desk:
        yield desk


@pytest.fixture
def app(controller: Scripted, desk: Reception) -> FastAPI:
    controller.reception = desk
    return application(controller, Settings())


def calls(app: FastAPI, token: str = "", address: str = "127.0.0.1") -> httpx.AsyncClient:
    transport = httpx.ASGITransport(app, client=(address, 1))
    headers = {"Authorization": f"Bearer {token}"} if token else {}
    return httpx.AsyncClient(transport=transport, base_url="http://localhost/api/v1", headers=headers)


async def logged_in(app: FastAPI, body: dict[str, Any] = KIM, address: str = "127.0.0.1") -> httpx.AsyncClient:
    async with calls(app, address=address) as client:
        answer = await client.post("/session", json={key: body[key] for key in ("name", "password")})
    assert answer.status_code == 201, answer.text
    return calls(app, answer.json()["token"], address)


def audited(tmp_path: Path) -> list[tuple[str, str, str, bool]]:
    reader = Reader(f"sqlite:///{tmp_path}/access.db")
    rows = [(row.action, str(row.actor), row.target, row.accepted) for _, row in reader.audit()]
    reader.close()
    return rows


async def test_all_is_open_until_there_is_somebody_and_then_everybody_logs_in(app: FastAPI, desk: Reception) -> None:
    async with calls(app) as client:
        who = (await client.get("/session")).json()
        assert (who["open"], who["name"], who["roles"]) == (True, None, [role.value for role in Role])
        assert (await client.get("/session/required")).json() == {"required": False}
        assert (await client.get("/jobs")).status_code == 200
        refused = await client.post("/users", json=LEE)
        assert (refused.status_code, refused.json()["field"]) == (409, "roles")
        added = await client.post("/users", json=KIM | {"roles": ["admin"]}, headers={"X-Actor": "root"})
        assert (added.status_code, added.headers["location"]) == (201, "/api/v1/users/kim")
        assert added.json()["created_by"] == "root"
        assert PASSWORD not in added.text
        assert (await client.get("/session/required")).json() == {"required": True}
        assert (await client.get("/jobs")).status_code == 401
    async with await logged_in(app) as client:
        who = (await client.get("/session")).json()
        assert (who["open"], who["name"], who["person"], who["roles"]) == (False, "kim", True, ["admin"])
        assert (await client.get("/jobs")).status_code == 200


async def test_everybody_can_ask_which_calls_are_theirs(app: FastAPI, desk: Reception) -> None:
    async with calls(app) as client:
        rows = (await client.get("/session/calls")).json()["items"]
        assert all(row["allowed"] for row in rows)
    await with_admin(desk)
    async with await logged_in(app) as client:
        assert (await client.post("/users", json=LEE)).status_code == 201
    async with await logged_in(app, LEE) as client:
        rows = {row["call"]: row for row in (await client.get("/session/calls")).json()["items"]}
        assert rows["POST /jobs"] == {
            "call": "POST /jobs", "roles": ["operator", "mes", "admin"], "allowed": True
        }  # fmt: skip
        assert (rows["POST /users"]["roles"], rows["POST /users"]["allowed"]) == (["admin"], False)
        assert rows["GET /users"]["allowed"] is False
        assert "POST /session" not in rows


async def test_a_wrong_name_and_a_wrong_password_are_told_the_same_and_audited(
    app: FastAPI, desk: Reception, tmp_path: Path
) -> None:
    await with_admin(desk)
    async with calls(app, address="10.0.0.9") as client:
        answers = [await client.post("/session", json=KIM | wrong) for wrong in ({"name": "park"}, {"password": "x"})]
    assert [answer.status_code for answer in answers] == [401, 401]
    assert answers[0].json() == answers[1].json()
    await logged_in(app)
    assert audited(tmp_path)[1:] == [
        ("LogIn", "anonymous@10.0.0.9", "park", False),
        ("LogIn", "anonymous@10.0.0.9", "kim", False),
        ("LogIn", "kim", "kim", True),
    ]


async def test_attempts_are_slowed_down_and_the_right_password_too(app: FastAPI, desk: Reception, clock: Hand) -> None:
    await with_admin(desk)
    async with calls(app, address="10.0.0.9") as client:
        for _ in range(5):
            assert (await client.post("/session", json=KIM | {"password": "wrong"})).status_code == 401
        slowed = await client.post("/session", json=KIM)
        assert (slowed.status_code, slowed.json()["code"], slowed.headers["retry-after"]) == (429, "too-many", "1")
        clock.at += 1.0
        assert (await client.post("/session", json=KIM)).status_code == 201


async def test_a_token_ends_unless_it_is_renewed_and_a_log_in_ends_after_a_shift(
    app: FastAPI, desk: Reception, clock: Hand
) -> None:
    await with_admin(desk)
    client = await logged_in(app)
    clock.at += TOKEN_LIFE - 1
    answer = await client.post("/session/renew")
    assert answer.status_code == 200
    newer = calls(app, answer.json()["token"])
    clock.at += 1 - 0.5
    assert (await client.get("/session")).status_code == 200
    clock.at += 0.5
    assert (await client.get("/session")).status_code == 401
    while clock.at + TOKEN_LIFE - 10 < START + LOG_IN_LIFE:
        clock.at += TOKEN_LIFE - 10
        answer = await newer.post("/session/renew")
        assert answer.status_code == 200
        newer = calls(app, answer.json()["token"])
    clock.at = START + LOG_IN_LIFE
    assert (await newer.post("/session/renew")).status_code == 401
    await client.aclose()
    await newer.aclose()


async def test_an_old_token_is_good_for_half_a_minute_beside_the_new_one(
    app: FastAPI, desk: Reception, clock: Hand
) -> None:
    await with_admin(desk)
    async with await logged_in(app) as client:
        assert (await client.post("/session/renew")).status_code == 200
        clock.at += OVERLAP - 0.1
        assert (await client.get("/session")).status_code == 200
        clock.at += 0.2
        assert (await client.get("/session")).status_code == 401


async def test_logging_out_ends_all_that_the_log_in_opened_and_nothing_else(app: FastAPI, desk: Reception) -> None:
    await with_admin(desk)
    first, other = await logged_in(app), await logged_in(app)
    renewed = calls(app, (await first.post("/session/renew")).json()["token"])
    assert (await first.delete("/session")).status_code == 204
    assert [(await one.get("/session")).status_code for one in (first, renewed, other)] == [401, 401, 200]
    for one in (first, renewed, other):
        await one.aclose()


async def test_a_person_changes_the_password_and_is_logged_out_elsewhere(
    app: FastAPI, desk: Reception, tmp_path: Path
) -> None:
    await with_admin(desk)
    first, other = await logged_in(app), await logged_in(app)
    wrong = await first.put("/session/password", json={"old": "x", "new": "another horse 3"})
    assert (wrong.status_code, wrong.json()["field"]) == (422, "old")
    weak = await first.put("/session/password", json={"old": PASSWORD, "new": "kimkimkim1"})
    assert (weak.status_code, weak.json()["field"]) == (422, "new")
    assert (await first.put("/session/password", json={"old": PASSWORD, "new": "another horse 3"})).status_code == 204
    assert [(await one.get("/session")).status_code for one in (first, other)] == [200, 401]
    async with calls(app) as client:
        assert (await client.post("/session", json=KIM)).status_code == 401
        assert (await client.post("/session", json=KIM | {"password": "another horse 3"})).status_code == 201
    changes = [row for row in audited(tmp_path) if row[0] == "ChangePassword"]
    assert changes == [("ChangePassword", "kim", "kim", False), ("ChangePassword", "kim", "kim", True)]
    await first.aclose()
    await other.aclose()


async def test_roles_change_at_once_and_who_is_disabled_is_out(app: FastAPI, desk: Reception) -> None:
    await with_admin(desk)
    async with await logged_in(app) as kim:
        assert (await kim.post("/users", json=LEE)).status_code == 201
        async with await logged_in(app, LEE) as lee:
            assert (await lee.post("/controller/pause", json={"reason": "x"})).status_code == 200
            assert (await lee.get("/users")).status_code == 403
            assert (await kim.patch("/users/lee", json={"roles": ["viewer"]})).json()["roles"] == ["viewer"]
            assert (await lee.post("/controller/pause", json={"reason": "x"})).status_code == 403
            assert (await kim.patch("/users/lee", json={"disabled": True})).json()["disabled"]
            assert (await lee.get("/jobs")).status_code == 401
        last = await kim.patch("/users/kim", json={"disabled": True})
        assert (last.status_code, last.json()["code"]) == (409, "conflict")
        assert (await kim.patch("/users/nobody", json={"disabled": True})).status_code == 404
        assert (await kim.patch("/users/lee", json={})).status_code == 422


async def test_a_key_is_shown_once_counts_for_its_roles_and_ends(
    app: FastAPI, desk: Reception, clock: Hand, tmp_path: Path
) -> None:
    await with_admin(desk)
    async with await logged_in(app) as kim:
        made = await kim.post("/keys", json={"name": "mes-1", "roles": ["mes"], "days": 1})
        assert (made.status_code, made.headers["cache-control"]) == (201, "no-store")
        shown = made.json()["key"]
        assert shown.startswith("hwk_")
        assert len(shown) == 47
        assert shown not in (await kim.get("/keys")).text + (tmp_path / "access.db").read_bytes().decode("latin-1")
        again = await kim.post("/keys", json={"name": "mes-1", "roles": ["mes"]})
        assert (again.status_code, again.json()["field"]) == (409, "name")
        async with calls(app, shown) as mes:
            assert (await mes.get("/session")).json()["person"] is False
            assert (await mes.post("/jobs", json={"source": "P1", "destination": "P2"})).status_code == 201
            assert (await mes.post("/vehicles/V001/hold", json={"reason": "x"})).status_code == 403
            for way, path in (("POST", "/session/renew"), ("DELETE", "/session"), ("PUT", "/session/password")):
                body = {"old": "x", "new": "another horse 3"} if way == "PUT" else None
                assert (await mes.request(way, path, json=body)).status_code == 409
            clock.at += 86_400
            assert (await mes.get("/jobs")).status_code == 401
    async with await logged_in(app) as kim:
        assert (await kim.get("/keys/mes-1")).json()["state"] == "expired"
        shown = (await kim.post("/keys", json={"name": "mes-2", "roles": ["mes"]})).json()["key"]
        async with calls(app, shown) as mes:
            assert (await mes.get("/jobs")).status_code == 200
            assert (await kim.delete("/keys/mes-2")).json()["state"] == "revoked"
            assert (await mes.get("/jobs")).status_code == 401
        assert (await kim.delete("/keys/none")).status_code == 404


async def test_who_may_not_is_written_into_the_audit_once(app: FastAPI, desk: Reception, tmp_path: Path) -> None:
    await with_admin(desk)
    shown = await desk.add_key("mes-1", frozenset({Role.MES}), None, ROOT)
    async with calls(app, str(shown)) as mes:
        assert (await mes.post("/controller/pause", json={"reason": "x"})).status_code == 403
        assert (await mes.get("/users")).status_code == 403
    async with Socket(app, query="topics=carriers", headers={"authorization": f"Bearer {shown}"}) as socket:
        await socket.accepted()
        await socket.frame()
        socket.say('{"id": 1, "command": {"name": "controller.pause", "body": {"reason": "x"}}}')
        assert (await socket.frame())["problem"]["code"] == "forbidden"
    await desk.access.stop()
    assert [row for row in audited(tmp_path) if row[0] == "Forbidden"] == [
        ("Forbidden", "mes-1", "POST /api/v1/controller/pause", False),
        ("Forbidden", "mes-1", "controller.pause", False),
    ]


async def test_a_watcher_is_cut_when_the_key_ends_and_others_go_on(app: FastAPI, desk: Reception) -> None:
    await with_admin(desk)
    shown = [await desk.add_key(name, frozenset({Role.VIEWER}), None, ROOT) for name in ("one", "other")]
    async with (
        Socket(app, query="topics=carriers", headers={"authorization": f"Bearer {shown[0]}"}) as one,
        Socket(app, query="topics=carriers", headers={"authorization": f"Bearer {shown[1]}"}) as other,
    ):
        for socket in (one, other):
            await socket.accepted()
            await socket.frame()
        assert await desk.revoke_key("one", ROOT) is None
        assert await one.message() == {
            "type": "websocket.close",
            "code": 1008,
            "reason": "You have to say who you are again.",
        }
        other.say('{"resync": true}')
        assert (await other.frame())["type"] == "resync"


async def test_a_watcher_stays_when_the_token_is_renewed_and_is_cut_when_the_log_in_ends(
    app: FastAPI, desk: Reception, clock: Hand
) -> None:
    await with_admin(desk)
    async with await logged_in(app) as client:
        ticket = (await client.post("/live/ticket")).json()["ticket"]
        async with Socket(app, query=f"topics=carriers&ticket={ticket}") as socket:
            await socket.accepted()
            await socket.frame()
            clock.at += TOKEN_LIFE - 1
            assert (await client.post("/session/renew")).status_code == 200
            clock.at += 60
            desk.access.on_look()
            socket.say('{"resync": true}')
            assert [(await socket.frame())["type"] for _ in range(2)] == ["resync", "snapshot"]
            clock.at += TOKEN_LIFE
            desk.access.on_look()
            assert (await socket.message())["type"] == "websocket.close"


async def test_a_stream_of_events_ends_with_the_key(app: FastAPI, desk: Reception) -> None:
    await with_admin(desk)
    shown = await desk.add_key("one", frozenset({Role.VIEWER}), None, ROOT)
    hub = desk.access

    async with calls(app, str(shown)) as client:
        ended = client.build_request("GET", "/events/stream")
        sent = asyncio.ensure_future(client.send(ended))
        while not app.state.callers._watched:
            await asyncio.sleep(0)
        assert await desk.revoke_key("one", ROOT) is None
        answer = await sent
    assert answer.text.startswith(": events")
    assert hub.closed


async def test_the_key_of_the_settings_stays_good_beside_users(controller: Scripted, desk: Reception) -> None:
    controller.reception = await with_admin(desk)
    app = application(controller, Settings(access_key=SecretStr("k" * 16)))
    async with calls(app, "k" * 16) as client:
        assert (await client.get("/session")).json()["name"] == "access-key"
        assert (await client.get("/users")).status_code == 200


async def test_where_access_is_required_nobody_gets_in_before_there_is_somebody(
    controller: Scripted, desk: Reception
) -> None:
    controller.reception = desk
    app = application(controller, Settings(access="required", host="0.0.0.0"))
    async with calls(app) as client:
        assert (await client.get("/jobs")).status_code == 401
        assert (await client.post("/users", json=LEE | {"roles": ["admin"]})).status_code == 401
    await with_admin(desk)
    async with await logged_in(app) as client:
        assert (await client.get("/jobs")).status_code == 200


@pytest.mark.parametrize(
    ("path", "body", "field"),
    [
        ("/users", LEE | {"roles": ["king"]}, "roles.0"),
        ("/users", LEE | {"roles": []}, "roles"),
        ("/users", LEE | {"name": "a b"}, "name"),
        ("/users", LEE | {"password": "short"}, "password"),
        ("/users", LEE | {"password": "lee is my name"}, "password"),
        ("/users", LEE | {"password": "aaaaaaaaaaaa"}, "password"),
        ("/keys", {"name": "x" * 33, "roles": ["mes"]}, "name"),
        ("/keys", {"name": "mes", "roles": ["mes"], "days": 0}, "days"),
        ("/keys", {"name": "mes", "roles": ["mes"], "days": True}, "days"),
        ("/keys", {"name": "mes", "roles": ["mes"], "days": "3"}, "days"),
        ("/session", {"name": "kim"}, "password"),
    ],
)
async def test_what_cannot_be_is_refused_without_showing_a_password(
    path: str, body: dict[str, Any], field: str, app: FastAPI, desk: Reception
) -> None:
    await with_admin(desk)
    async with await logged_in(app) as client:
        answer = await client.post(path, json=body)
    assert (answer.status_code, answer.json()["field"]) == (422, field)
    assert body.get("password", "\0") not in answer.text
