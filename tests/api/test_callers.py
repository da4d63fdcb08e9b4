"""Who calls: names in the audit, tickets, how often one may ask."""

import httpx
import pytest
from fastapi import FastAPI
from pydantic import SecretStr

from app.api import application
from app.api.calls import actor_named, is_person
from app.api.rates import ROOM, Rates
from app.domain.access import GRANTS, Caller, Role, Scope, who_may
from app.domain.ids import Actor
from app.domain.lockout import Lockout
from app.domain.units import Timestamp
from app.settings import Settings
from tests.api.scripted import Scripted
from tests.api.test_policy import Everybody

pytestmark = pytest.mark.anyio
KIM = Caller("kim", frozenset({Role.OPERATOR}), person=True)
LINE = Caller("line-7", frozenset({Role.MAINTENANCE}), person=False)


def test_a_person_who_logged_in_is_the_actor_whatever_the_header_says() -> None:
    assert actor_named("lee", "10.0.0.1", KIM) == actor_named(None, "10.0.0.1", KIM) == "kim"


def test_a_machine_acts_on_behalf_of_whom_it_names() -> None:
    assert actor_named(None, "10.0.0.1", LINE) == "line-7"
    assert actor_named("lee", "10.0.0.1", LINE) == "line-7 (for lee)"
    assert actor_named("line-7", "10.0.0.1", LINE) == "line-7"


def test_only_who_logged_in_or_is_named_counts_as_a_person() -> None:
    assert is_person(KIM, None)
    assert is_person(LINE, "lee")
    assert not is_person(LINE, " ")
    assert not is_person(None, None)


def test_one_machine_that_speaks_for_two_does_not_lift_a_lockout_of_another() -> None:
    locked = Lockout(Actor("kim"), "hand in the gripper", Timestamp(0.0))
    locked = locked.wished_away_by(Actor("line-7 (for lee)")).wished_away_by(Actor("line-7 (for park)"))
    assert not locked.lifted_by(Actor("line-7 (for park)"))
    assert locked.wished_away_by(Actor("choi")).lifted_by(Actor("choi"))


def test_a_caller_may_what_any_of_its_roles_may_and_an_administrator_everything() -> None:
    both = Caller("x", frozenset({Role.MES, Role.MAINTENANCE}), person=False)
    assert both.scopes == GRANTS[Role.MES] | GRANTS[Role.MAINTENANCE]
    assert Caller("m", frozenset(), person=False, besides=frozenset({Scope.METRICS})).scopes == {Scope.METRICS}
    assert all(Role.ADMIN in who_may(scope) for scope in Scope)


def test_a_bucket_holds_a_burst_and_fills_again() -> None:
    now = [0.0]
    rates = Rates(10.0, 3.0, lambda: now[0])
    assert [rates.wait("a") for _ in range(4)] == [0.0, 0.0, 0.0, pytest.approx(0.1)]
    assert rates.wait("b") == 0.0
    now[0] = 0.05
    assert rates.wait("a") == pytest.approx(0.05)
    now[0] = 0.1
    assert rates.wait("a") == 0.0
    now[0] = 99.0
    assert [bool(rates.wait("a")) for _ in range(4)] == [False, False, False, True]


def test_a_flood_of_names_is_forgotten_and_refuses_nobody() -> None:
    now = [0.0]
    rates = Rates(1.0, 2.0, lambda: now[0])
    assert not any(rates.wait(name) for name in range(ROOM + 1))
    assert len(rates._left) == 1
    now[0] = 1.5
    assert not any(rates.wait(-name) for name in range(1, ROOM))
    now[0] = 2.0
    assert rates.wait("last") == 0.0
    assert 0 not in rates._left


async def test_an_address_that_asks_too_often_waits_before_anybody_looks_at_its_key(controller: Scripted) -> None:
    app = application(controller, Settings(address_rate=1, access_key=SecretStr("k" * 16)))
    transport = httpx.ASGITransport(app, client=("10.0.0.9", 1))
    async with httpx.AsyncClient(transport=transport, base_url="http://tc.fab/api/v1") as client:
        assert [(await client.get("/jobs")).status_code for _ in range(3)] == [401, 401, 429]
        answer = await client.post("/jobs", json={})
    assert answer.json()["code"] == "too-many"
    assert answer.headers["retry-after"] == "1"
    assert answer.headers["connection"] == "close"


async def test_a_key_that_asks_too_often_waits_and_others_do_not(controller: Scripted) -> None:
    app = application(controller, Settings(caller_rate=1))
    app.state.callers.register = Everybody()
    async with calls(app) as client:

        async def asks(role: str) -> int:
            return (await client.get("/jobs", headers={"Authorization": f"Bearer {role}"})).status_code

        assert [await asks("viewer") for _ in range(3)] == [200, 200, 429]
        assert await asks("mes") == 200


def calls(app: FastAPI) -> httpx.AsyncClient:
    return httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://localhost/api/v1")


async def test_the_audit_has_the_name_that_was_shown(controller: Scripted) -> None:
    app = application(controller, Settings())
    app.state.callers.register = Everybody()
    async with calls(app) as client:
        headers = {"Authorization": "Bearer operator", "X-Actor": "lee"}
        await client.post("/controller/pause", json={"reason": "x"}, headers=headers)
        await client.post("/jobs", json={"source": "P1", "destination": "P2"}, headers=headers)
    assert [request.actor for request in controller.seen] == ["a-operator (for lee)"] * 2


async def test_a_ticket_lets_in_only_whom_it_was_given(controller: Scripted) -> None:
    app = application(controller, Settings())
    everybody = app.state.callers.register = Everybody()
    async with calls(app) as client:
        answer = await client.post("/live/ticket", headers={"Authorization": "Bearer viewer"})
    ticket = answer.json()["ticket"]
    scope = {"type": "websocket", "path": "/api/v1/live", "query_string": f"ticket={ticket}".encode()}
    everybody.forget("viewer")
    refused = app.state.callers.refusal(scope, None)
    assert refused is not None
    assert refused.code == "unauthorised"
