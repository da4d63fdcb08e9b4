"""Who may call what: every route and every command, by everybody. The tables below are written by hand."""

from collections.abc import Iterator
from typing import Any

import pytest
from fastapi import FastAPI
from fastapi.routing import iter_route_contexts
from starlette.responses import Response
from starlette.routing import Route

from app.api.application import application
from app.api.commands import COMMANDS
from app.api.policy import Policy, PolicyError, row_of
from app.domain.access import Caller, Role
from app.settings import Settings
from tests.api.scripted import Scripted
from tests.api.sockets import Socket

pytestmark = pytest.mark.anyio

OPEN = "open"
ALL = "viewer operator maintenance mes admin"
PLANT = "operator maintenance admin"
ORDERS = "operator mes admin"
DESK = "operator admin"
UPKEEP = "maintenance admin"
ADMIN = "admin"
HOSTS = "mes admin"
SIGNAL = "operator maintenance mes admin"

MAY: dict[str, str] = {
    "GET /": OPEN,
    "FILES /assets": OPEN,
    "GET /docs": OPEN,
    "GET /api/docs": OPEN,
    "FILES /api/docs/files": OPEN,
    "GET /api/openapi.json": OPEN,
    "GET /healthz": OPEN,
    "GET /readyz": OPEN,
    "GET /metrics": ALL,
    "GET /webhooks": HOSTS,
    "POST /webhooks": HOSTS,
    "GET /webhooks/{webhook}": HOSTS,
    "PATCH /webhooks/{webhook}": HOSTS,
    "DELETE /webhooks/{webhook}": HOSTS,
    "POST /webhooks/{webhook}/secret": HOSTS,
    "POST /webhooks/{webhook}/replay": HOSTS,
    "POST /webhooks/{webhook}/ping": HOSTS,
    "GET /webhooks/{webhook}/deliveries": HOSTS,
    "GET /metrics/lines": ALL,
    "LIVE /{path:path}": OPEN,
    "GET /problems": OPEN,
    "GET /problems/{code}": OPEN,
    "POST /jobs": ORDERS,
    "GET /jobs": ALL,
    "GET /jobs/{job}": ALL,
    "PATCH /jobs/{job}": ORDERS,
    "GET /jobs/{job}/why": ALL,
    "POST /jobs/{job}/cancel": ORDERS,
    "POST /jobs/{job}/abort": ORDERS,
    "GET /events": ALL,
    "GET /events/stream": ALL,
    "GET /vehicles": ALL,
    "GET /vehicles/{vehicle}": ALL,
    "GET /vehicles/{vehicle}/frames": ALL,
    "GET /vehicles/{vehicle}/commands": ALL,
    "POST /vehicles/{vehicle}/commands": PLANT,
    "GET /vehicles/{vehicle}/commands/{command}": ALL,
    "POST /vehicles/{vehicle}/recover": PLANT,
    "POST /vehicles/{vehicle}/hold": PLANT,
    "POST /vehicles/{vehicle}/release": PLANT,
    "PUT /vehicles/{vehicle}/service": PLANT,
    "POST /vehicles/{vehicle}/lockout": UPKEEP,
    "DELETE /vehicles/{vehicle}/lockout": UPKEEP,
    "GET /vehicles/{vehicle}/offset": ALL,
    "PUT /vehicles/{vehicle}/offset": UPKEEP,
    "POST /vehicles/{vehicle}/offset/rollback": UPKEEP,
    "GET /stations": ALL,
    "GET /stations/{station}": ALL,
    "PUT /stations/{station}": ORDERS,
    "PATCH /stations/{station}": ORDERS,
    "GET /stations/{station}/dest": ALL,
    "PUT /stations/{station}/dest": UPKEEP,
    "POST /stations/{station}/dest/rollback": UPKEEP,
    "GET /carriers": ALL,
    "GET /carriers/{carrier}": ALL,
    "PUT /carriers/{carrier}": ORDERS,
    "DELETE /carriers/{carrier}": ORDERS,
    "GET /drives": ALL,
    "GET /drives/{drive}": ALL,
    "GET /drives/{drive}/frames": ALL,
    "GET /drives/{drive}/operations": ALL,
    "GET /drives/{drive}/catalogue": ALL,
    "POST /drives/{drive}/status": UPKEEP,
    "POST /drives/{drive}/keys": UPKEEP,
    "PUT /drives/{drive}/inputs": UPKEEP,
    "POST /drives/{drive}/lockout": UPKEEP,
    "DELETE /drives/{drive}/lockout": UPKEEP,
    "GET /drives/{drive}/parameters": ALL,
    "GET /drives/{drive}/parameters/{number}": ALL,
    "PUT /drives/{drive}/parameters/{number}": UPKEEP,
    "POST /drives/{drive}/parameters/{number}/read": UPKEEP,
    "PUT /drives/{drive}/watches/{watch}": UPKEEP,
    "DELETE /drives/{drive}/watches/{watch}": UPKEEP,
    "POST /drives/{drive}/read": UPKEEP,
    "POST /drives/{drive}/backups": UPKEEP,
    "GET /drives/{drive}/backups": ALL,
    "GET /drives/{drive}/backups/{backup}": ALL,
    "POST /drives/{drive}/compare": UPKEEP,
    "POST /drives/{drive}/restore": UPKEEP,
    "POST /drives/{drive}/jog": UPKEEP,
    "POST /drives/{drive}/jog/{jog}": UPKEEP,
    "GET /drives/{drive}/jog/{jog}": ALL,
    "DELETE /drives/{drive}/jog/{jog}": UPKEEP,
    "GET /operations": ALL,
    "GET /operations/{operation}": ALL,
    "POST /operations/{operation}/cancel": UPKEEP,
    "GET /links": ALL,
    "GET /links/{link}": ALL,
    "GET /links/{link}/frames": ALL,
    "POST /links/{link}/stop": PLANT,
    "GET /teaching/sessions": ALL,
    "POST /teaching/sessions": UPKEEP,
    "GET /teaching/sessions/{session}": ALL,
    "POST /teaching/sessions/{session}/start": UPKEEP,
    "POST /teaching/sessions/{session}/close": UPKEEP,
    "GET /teaching/proposals": ALL,
    "GET /teaching/proposals/{proposal}": ALL,
    "POST /teaching/proposals/{proposal}/approve": UPKEEP,
    "POST /teaching/proposals/{proposal}/reject": UPKEEP,
    "POST /teaching/proposals/{proposal}/assign": UPKEEP,
    "GET /teaching/events": ALL,
    "GET /teaching/targets/{station}/{vehicle}": ALL,
    "GET /teaching/compare/stations/{station}/{old}/{new}": ALL,
    "GET /teaching/compare/vehicles/{vehicle}/{old}/{new}": ALL,
    "GET /teaching/compare/offsets/{vehicle}/{other}": ALL,
    "GET /teaching/drift": ALL,
    "GET /teaching/dests": ALL,
    "GET /teaching/offsets": ALL,
    "POST /teaching/dests/import": UPKEEP,
    "POST /teaching/offsets/import": UPKEEP,
    "GET /devices": ALL,
    "GET /devices/{device}": ALL,
    "GET /devices/{device}/frames": ALL,
    "GET /devices/{device}/commands": ALL,
    "POST /devices/{device}/commands": PLANT,
    "GET /devices/{device}/commands/{command}": ALL,
    "PUT /devices/{device}/pin": UPKEEP,
    "DELETE /devices/{device}/pin": UPKEEP,
    "POST /devices/{device}/lockout": UPKEEP,
    "DELETE /devices/{device}/lockout": UPKEEP,
    "PUT /devices/{device}/service": UPKEEP,
    "GET /controller": ALL,
    "POST /controller/pause": DESK,
    "POST /controller/resume": DESK,
    "POST /controller/emergency": SIGNAL,
    "POST /controller/emergency/release": DESK,
    "POST /controller/stop": SIGNAL,
    "GET /zones": ALL,
    "GET /zones/{zone}": ALL,
    "POST /zones/{zone}/pause": DESK,
    "POST /zones/{zone}/stop": SIGNAL,
    "POST /zones/{zone}/resume": DESK,
    "GET /closures": ALL,
    "POST /closures": PLANT,
    "POST /closures/preview": ALL,
    "GET /closures/history": ALL,
    "GET /closures/{closure}": ALL,
    "POST /closures/{closure}/open": PLANT,
    "GET /alarms": ALL,
    "GET /alarms/active": ALL,
    "GET /alarms/pareto": ALL,
    "GET /alarms/reliability": ALL,
    "GET /alarms/{alarm}": ALL,
    "POST /alarms/acknowledge": PLANT,
    "POST /alarms/{alarm}/acknowledge": PLANT,
    "GET /walks": ALL,
    "POST /walks": ORDERS,
    "GET /walks/history": ALL,
    "GET /walks/{walk}": ALL,
    "GET /walks/{walk}/places": ALL,
    "PUT /walks/{walk}/places/{station}": ORDERS,
    "POST /walks/{walk}/places": ORDERS,
    "POST /walks/{walk}/accept": ORDERS,
    "POST /walks/{walk}/abandon": ORDERS,
    "GET /statistics": ALL,
    "GET /statistics/report": ALL,
    "GET /statistics/{table}.{kind}": ALL,
    "GET /history": ALL,
    "GET /history/span": ALL,
    "GET /history/changes": ALL,
    "GET /history/heat": ALL,
    "GET /history/pieces": ALL,
    "GET /history/events": ALL,
    "GET /history/export": PLANT,
    "POST /stations/{station}/stage": ORDERS,
    "POST /vehicles/{vehicle}/park": PLANT,
    "GET /layout": ALL,
    "GET /layout/routes": ALL,
    "GET /layout/versions": ALL,
    "POST /layout/versions": UPKEEP,
    "GET /layout/versions/{version}": ALL,
    "GET /layout/versions/{version}/file": ALL,
    "GET /layout/versions/{version}/catalogues/{model}": ALL,
    "GET /layout/versions/{version}/findings": ALL,
    "GET /layout/versions/{version}/diff": ALL,
    "GET /layout/versions/{version}/impact": ALL,
    "POST /layout/versions/{version}/activate": UPKEEP,
    "POST /layout/versions/{version}/reject": UPKEEP,
    "GET /audit": PLANT,
    "GET /audit/check": PLANT,
    "POST /live/ticket": ALL,
    "LIVE /live": ALL,
    "POST /session": OPEN,
    "GET /session": ALL,
    "GET /session/required": OPEN,
    "GET /session/calls": ALL,
    "DELETE /session": ALL,
    "POST /session/renew": ALL,
    "PUT /session/password": ALL,
    "GET /users": ADMIN,
    "POST /users": ADMIN,
    "GET /users/{user}": ADMIN,
    "PATCH /users/{user}": ADMIN,
    "GET /keys": ADMIN,
    "POST /keys": ADMIN,
    "GET /keys/{key}": ADMIN,
    "DELETE /keys/{key}": ADMIN,
}
"""Row -> the roles that may; ``open``: everybody, known or not."""

MAY_SAY: dict[str, str] = {
    "controller.pause": DESK,
    "controller.resume": DESK,
    "controller.emergency": SIGNAL,
    "controller.emergency.release": DESK,
    "controller.stop": SIGNAL,
    "zone.pause": DESK,
    "zone.stop": SIGNAL,
    "zone.resume": DESK,
    "closure.close": PLANT,
    "closure.open": PLANT,
    "alarm.acknowledge": PLANT,
    "walk.start": ORDERS,
    "walk.enter": ORDERS,
    "walk.accept": ORDERS,
    "walk.abandon": ORDERS,
    "station.stage": ORDERS,
    "vehicle.park": PLANT,
    "job.cancel": ORDERS,
    "job.abort": ORDERS,
    "job.change": ORDERS,
    "vehicle.command": PLANT,
    "vehicle.recover": PLANT,
    "vehicle.hold": PLANT,
    "vehicle.release": PLANT,
    "vehicle.service": PLANT,
    "vehicle.lockout": UPKEEP,
    "vehicle.unlock": UPKEEP,
    "device.command": PLANT,
    "device.pin": UPKEEP,
    "device.unpin": UPKEEP,
    "device.lockout": UPKEEP,
    "device.unlock": UPKEEP,
    "device.service": UPKEEP,
    "drive.status": UPKEEP,
    "drive.key": UPKEEP,
    "drive.inputs": UPKEEP,
    "drive.lockout": UPKEEP,
    "drive.unlock": UPKEEP,
    "drive.read": UPKEEP,
    "drive.write": UPKEEP,
    "drive.backup": UPKEEP,
    "drive.compare": UPKEEP,
    "drive.restore": UPKEEP,
    "drive.jog": UPKEEP,
    "drive.jog.keep": UPKEEP,
    "drive.jog.release": UPKEEP,
    "drive.watch": UPKEEP,
    "drive.unwatch": UPKEEP,
    "link.stop": PLANT,
}


class Everybody:
    """One known machine for each role: its key is the role's name."""

    closed = True

    def __init__(self) -> None:
        self.forbidden: list[tuple[str, str]] = []
        self._known = {role.value.encode(): Caller(f"a-{role}", frozenset({role}), person=False) for role in Role}

    def caller(self, credential: bytes) -> Caller | None:
        return self._known.get(credential)

    def still(self, caller: Caller) -> bool:
        return caller in self._known.values()

    def forbid(self, caller: Caller, what: str) -> None:
        self.forbidden.append((caller.name, what))

    def forget(self, credential: str) -> None:
        del self._known[credential.encode()]


@pytest.fixture
def app(controller: Scripted) -> FastAPI:
    app = application(controller, Settings())
    app.state.callers.register = Everybody()
    return app


def rows(app: FastAPI) -> Iterator[tuple[str, str, str]]:
    """Give each row that the application's routes need: its name, method and a path of that route."""
    for context in iter_route_contexts(list(app.routes)):
        path = str(context.path)
        for name in row_of(context.methods, path, context.original_route):
            method = name.partition(" ")[0]
            sample = path + "/none" if method == "FILES" else path.replace("{path:path}", "none/such")
            yield (
                name,
                "GET" if method == "FILES" else method,
                "x".join(part.rpartition("}")[2] for part in sample.split("{")),
            )


async def answer(app: FastAPI, method: str, path: str, key: str | None) -> tuple[int, bytes]:
    """Return status and body of an answer; the caller goes away once it has sent its request, so that streams end."""
    headers = [(b"host", b"localhost"), (b"content-type", b"application/json")]
    if key is not None:
        headers.append((b"authorization", f"Bearer {key}".encode()))
    scope: dict[str, Any] = {
        "type": "http",
        "method": method,
        "path": path,
        "raw_path": path.encode(),
        "query_string": b"",
    }
    scope |= {"headers": headers, "client": ("127.0.0.1", 1), "server": ("localhost", 80), "scheme": "http"}
    scope |= {"http_version": "1.1", "asgi": {"version": "3.0", "spec_version": "2.3"}, "root_path": ""}
    coming: list[dict[str, Any]] = [{"type": "http.request", "body": b"{}"}]
    status, body = 0, b""

    async def receive() -> dict[str, Any]:
        return coming.pop() if coming else {"type": "http.disconnect"}

    async def send(message: Any) -> None:
        nonlocal status, body
        status = message.get("status", status)
        body += message.get("body", b"")

    await app(scope, receive, send)
    return status, body


async def passes(app: FastAPI, method: str, path: str, key: str | None) -> bool:
    """Return whether a request gets past the guard."""
    if method == "LIVE":
        headers = {} if key is None else {"authorization": f"Bearer {key}"}
        async with Socket(app, path, headers=headers, answers=True) as socket:
            return (await socket.message()).get("status") not in (401, 403)
    status, body = await answer(app, method, path, key)
    if status not in (401, 403):
        return True
    assert (b'"code":"unauthorised"' if status == 401 else b'"code":"forbidden"') in body
    return False


async def test_every_route_is_open_to_the_roles_written_here_and_to_nobody_else(app: FastAPI) -> None:
    wrong, seen = [], set()
    for name, method, path in rows(app):
        seen.add(name)
        if name not in MAY:
            wrong.append(f"{name} is a new route: write into MAY which roles may call it")
            continue
        may = {*ALL.split(), "nobody"} if MAY[name] == OPEN else set(MAY[name].split())
        for who in (*Role, "nobody", "stranger"):
            let_in = await passes(app, method, path, None if who == "nobody" else str(who))
            if let_in != (who in may or MAY[name] == OPEN):
                wrong.append(f"{name} is {'open' if let_in else 'closed'} to {who}, and MAY says otherwise")
    wrong += [f"{name} is in MAY, and no route" for name in MAY if name not in seen]
    assert not wrong, "\n".join(wrong)


async def test_every_command_is_open_to_the_roles_written_here_and_to_nobody_else(app: FastAPI) -> None:
    assert set(MAY_SAY) == set(COMMANDS), "write into MAY_SAY which roles may give the new command"
    wrong = []
    for role in Role:
        async with Socket(app, query="topics=carriers", headers={"authorization": f"Bearer {role}"}) as socket:
            await socket.accepted()
            await socket.frame()
            for name, may in MAY_SAY.items():
                socket.say(f'{{"id": "{name}", "actor": "kim", "command": {{"name": "{name}", "target": "x"}}}}')
                reply = await socket.frame()
                while reply["type"] not in ("reply", "error"):
                    reply = await socket.frame()
                let_in = reply.get("problem", {}).get("code") != "forbidden"
                if let_in != (role in may.split()):
                    wrong.append(f"{name} is {'open' if let_in else 'closed'} to {role}, and MAY_SAY says otherwise")
    assert not wrong, "\n".join(wrong)


async def test_a_refusal_names_the_roles_that_may(app: FastAPI) -> None:
    status, body = await answer(app, "POST", "/api/v1/jobs", "viewer")
    assert status == 403
    assert b"POST /api/v1/jobs needs the role operator or mes or admin; a-viewer has viewer." in body


async def test_a_path_that_is_none_tells_strangers_nothing(app: FastAPI) -> None:
    assert (await answer(app, "GET", "/api/v1/nowhere", None))[0] == 401
    assert (await answer(app, "GET", "/api/v1/nowhere", "viewer"))[0] == 404
    assert (await answer(app, "DELETE", "/api/v1/jobs", "viewer"))[0] == 405
    assert (await answer(app, "GET", "/nowhere", None))[0] == 404


async def ok(_request: object) -> Response:
    return Response()


def test_a_route_without_a_row_stops_the_start_up(app: FastAPI) -> None:
    app.router.routes.append(Route("/api/v1/back/door", ok, methods=["POST"]))
    with pytest.raises(PolicyError, match="routes without a row in ROUTES or OUTSIDE: POST /back/door") as stopped:
        Policy(app.routes, COMMANDS)
    assert "app/api/policy.py" in stopped.value.remedy


def test_a_row_without_a_route_stops_the_start_up(app: FastAPI) -> None:
    kept = [route for route in app.routes if getattr(route, "path", None) is not None]
    with pytest.raises(PolicyError, match=r"rows without a route in ROUTES: DELETE /carriers/\{carrier\}"):
        Policy(kept, COMMANDS)


def test_a_command_without_a_row_stops_the_start_up(app: FastAPI) -> None:
    with pytest.raises(PolicyError, match=r"COMMANDS: plant\.explode"):
        Policy(app.routes, [*COMMANDS, "plant.explode"])
