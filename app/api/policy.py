"""Who may call what: one table by route, and one by name of a command over the live stream.

A route without a row stops the start-up, and so does a row without a route. To add a route, add its row.
"""

import re
from collections.abc import Collection, Iterable, Mapping

from fastapi.routing import iter_route_contexts
from starlette.routing import BaseRoute, Mount, WebSocketRoute

from app.api.problems import Problem
from app.domain.access import Caller, Scope, who_may
from app.domain.errors import HoistwayError

API = "/api/v1"
LIVE = "LIVE"
"""Stands for the method in the row of a WebSocket."""
FILES = "FILES"
"""Stands for the method in the row of a folder of files."""

ROUTES: Mapping[str, Scope] = {
    "POST /jobs": Scope.JOBS,
    "GET /jobs": Scope.READ,
    "GET /jobs/{job}": Scope.READ,
    "PATCH /jobs/{job}": Scope.JOBS,
    "GET /jobs/{job}/why": Scope.READ,
    "POST /jobs/{job}/cancel": Scope.JOBS,
    "POST /jobs/{job}/abort": Scope.JOBS,
    "GET /events": Scope.READ,
    "GET /events/stream": Scope.READ,
    "GET /vehicles": Scope.READ,
    "GET /vehicles/{vehicle}": Scope.READ,
    "GET /vehicles/{vehicle}/frames": Scope.READ,
    "GET /vehicles/{vehicle}/commands": Scope.READ,
    "POST /vehicles/{vehicle}/commands": Scope.VEHICLES,
    "GET /vehicles/{vehicle}/commands/{command}": Scope.READ,
    "POST /vehicles/{vehicle}/recover": Scope.VEHICLES,
    "POST /vehicles/{vehicle}/hold": Scope.VEHICLES,
    "POST /vehicles/{vehicle}/release": Scope.VEHICLES,
    "PUT /vehicles/{vehicle}/service": Scope.VEHICLES,
    "POST /vehicles/{vehicle}/lockout": Scope.UPKEEP,
    "DELETE /vehicles/{vehicle}/lockout": Scope.UPKEEP,
    "GET /vehicles/{vehicle}/offset": Scope.READ,
    "PUT /vehicles/{vehicle}/offset": Scope.TEACHING,
    "POST /vehicles/{vehicle}/offset/rollback": Scope.TEACHING,
    "GET /stations": Scope.READ,
    "GET /stations/{station}": Scope.READ,
    "PUT /stations/{station}": Scope.PLACES,
    "PATCH /stations/{station}": Scope.PLACES,
    "GET /stations/{station}/dest": Scope.READ,
    "PUT /stations/{station}/dest": Scope.TEACHING,
    "POST /stations/{station}/dest/rollback": Scope.TEACHING,
    "GET /carriers": Scope.READ,
    "GET /carriers/{carrier}": Scope.READ,
    "PUT /carriers/{carrier}": Scope.PLACES,
    "DELETE /carriers/{carrier}": Scope.PLACES,
    "GET /drives": Scope.READ,
    "GET /drives/{drive}": Scope.READ,
    "GET /drives/{drive}/frames": Scope.READ,
    "GET /drives/{drive}/operations": Scope.READ,
    "GET /drives/{drive}/catalogue": Scope.READ,
    "POST /drives/{drive}/status": Scope.DRIVES,
    "POST /drives/{drive}/keys": Scope.DRIVES,
    "PUT /drives/{drive}/inputs": Scope.DRIVES,
    "POST /drives/{drive}/lockout": Scope.UPKEEP,
    "DELETE /drives/{drive}/lockout": Scope.UPKEEP,
    "GET /drives/{drive}/parameters": Scope.READ,
    "GET /drives/{drive}/parameters/{number}": Scope.READ,
    "PUT /drives/{drive}/parameters/{number}": Scope.DRIVES,
    "POST /drives/{drive}/parameters/{number}/read": Scope.DRIVES,
    "PUT /drives/{drive}/watches/{watch}": Scope.DRIVES,
    "DELETE /drives/{drive}/watches/{watch}": Scope.DRIVES,
    "POST /drives/{drive}/read": Scope.DRIVES,
    "POST /drives/{drive}/backups": Scope.DRIVES,
    "GET /drives/{drive}/backups": Scope.READ,
    "GET /drives/{drive}/backups/{backup}": Scope.READ,
    "POST /drives/{drive}/compare": Scope.DRIVES,
    "POST /drives/{drive}/restore": Scope.DRIVES,
    "POST /drives/{drive}/jog": Scope.DRIVES,
    "POST /drives/{drive}/jog/{jog}": Scope.DRIVES,
    "GET /drives/{drive}/jog/{jog}": Scope.READ,
    "DELETE /drives/{drive}/jog/{jog}": Scope.DRIVES,
    "GET /operations": Scope.READ,
    "GET /operations/{operation}": Scope.READ,
    "POST /operations/{operation}/cancel": Scope.DRIVES,
    "GET /links": Scope.READ,
    "GET /links/{link}": Scope.READ,
    "GET /links/{link}/frames": Scope.READ,
    "POST /links/{link}/stop": Scope.STOP_DRIVES,
    "GET /teaching/sessions": Scope.READ,
    "POST /teaching/sessions": Scope.TEACHING,
    "GET /teaching/sessions/{session}": Scope.READ,
    "POST /teaching/sessions/{session}/start": Scope.TEACHING,
    "POST /teaching/sessions/{session}/close": Scope.TEACHING,
    "GET /teaching/proposals": Scope.READ,
    "GET /teaching/proposals/{proposal}": Scope.READ,
    "POST /teaching/proposals/{proposal}/approve": Scope.TEACHING,
    "POST /teaching/proposals/{proposal}/reject": Scope.TEACHING,
    "POST /teaching/proposals/{proposal}/assign": Scope.TEACHING,
    "GET /teaching/events": Scope.READ,
    "GET /teaching/targets/{station}/{vehicle}": Scope.READ,
    "GET /teaching/compare/stations/{station}/{old}/{new}": Scope.READ,
    "GET /teaching/compare/vehicles/{vehicle}/{old}/{new}": Scope.READ,
    "GET /teaching/compare/offsets/{vehicle}/{other}": Scope.READ,
    "GET /teaching/drift": Scope.READ,
    "GET /teaching/dests": Scope.READ,
    "GET /teaching/offsets": Scope.READ,
    "POST /teaching/dests/import": Scope.TEACHING,
    "POST /teaching/offsets/import": Scope.TEACHING,
    "GET /devices": Scope.READ,
    "GET /devices/{device}": Scope.READ,
    "GET /devices/{device}/frames": Scope.READ,
    "GET /devices/{device}/commands": Scope.READ,
    "POST /devices/{device}/commands": Scope.DEVICES,
    "GET /devices/{device}/commands/{command}": Scope.READ,
    "PUT /devices/{device}/pin": Scope.UPKEEP,
    "DELETE /devices/{device}/pin": Scope.UPKEEP,
    "POST /devices/{device}/lockout": Scope.UPKEEP,
    "DELETE /devices/{device}/lockout": Scope.UPKEEP,
    "PUT /devices/{device}/service": Scope.UPKEEP,
    "GET /controller": Scope.READ,
    "POST /controller/pause": Scope.CONTROL,
    "POST /controller/resume": Scope.CONTROL,
    "POST /controller/emergency": Scope.SIGNAL,
    "POST /controller/emergency/release": Scope.CONTROL,
    "POST /controller/stop": Scope.SIGNAL,
    "GET /zones": Scope.READ,
    "GET /zones/{zone}": Scope.READ,
    "POST /zones/{zone}/pause": Scope.CONTROL,
    "POST /zones/{zone}/stop": Scope.SIGNAL,
    "POST /zones/{zone}/resume": Scope.CONTROL,
    "GET /closures": Scope.READ,
    "POST /closures": Scope.CLOSURES,
    "POST /closures/preview": Scope.READ,
    "GET /closures/history": Scope.READ,
    "GET /closures/{closure}": Scope.READ,
    "POST /closures/{closure}/open": Scope.CLOSURES,
    "GET /alarms": Scope.READ,
    "GET /alarms/active": Scope.READ,
    "GET /alarms/pareto": Scope.READ,
    "GET /alarms/reliability": Scope.READ,
    "GET /alarms/{alarm}": Scope.READ,
    "POST /alarms/acknowledge": Scope.ALARMS,
    "POST /alarms/{alarm}/acknowledge": Scope.ALARMS,
    "GET /walks": Scope.READ,
    "POST /walks": Scope.PLACES,
    "GET /walks/history": Scope.READ,
    "GET /walks/{walk}": Scope.READ,
    "GET /walks/{walk}/places": Scope.READ,
    "PUT /walks/{walk}/places/{station}": Scope.PLACES,
    "POST /walks/{walk}/places": Scope.PLACES,
    "POST /walks/{walk}/accept": Scope.PLACES,
    "POST /walks/{walk}/abandon": Scope.PLACES,
    "GET /statistics": Scope.READ,
    "GET /statistics/report": Scope.READ,
    "GET /statistics/{table}.{kind}": Scope.READ,
    "GET /history": Scope.READ,
    "GET /history/span": Scope.READ,
    "GET /history/changes": Scope.READ,
    "GET /history/heat": Scope.READ,
    "GET /history/pieces": Scope.READ,
    "GET /history/events": Scope.READ,
    "GET /history/export": Scope.READ_AUDIT,
    "POST /stations/{station}/stage": Scope.JOBS,
    "POST /vehicles/{vehicle}/park": Scope.VEHICLES,
    "GET /layout": Scope.READ,
    "GET /layout/routes": Scope.READ,
    "GET /layout/versions": Scope.READ,
    "POST /layout/versions": Scope.LAYOUT,
    "GET /layout/versions/{version}": Scope.READ,
    "GET /layout/versions/{version}/file": Scope.READ,
    "GET /layout/versions/{version}/catalogues/{model}": Scope.READ,
    "GET /layout/versions/{version}/findings": Scope.READ,
    "GET /layout/versions/{version}/diff": Scope.READ,
    "GET /layout/versions/{version}/impact": Scope.READ,
    "POST /layout/versions/{version}/activate": Scope.LAYOUT,
    "POST /layout/versions/{version}/reject": Scope.LAYOUT,
    "GET /audit": Scope.READ_AUDIT,
    "GET /problems": Scope.PUBLIC,
    "GET /problems/{code}": Scope.PUBLIC,
    "GET /audit/check": Scope.READ_AUDIT,
    "POST /live/ticket": Scope.READ,
    "LIVE /live": Scope.READ,
    "POST /session": Scope.PUBLIC,
    "GET /session": Scope.SELF,
    "GET /session/required": Scope.PUBLIC,
    "GET /session/calls": Scope.SELF,
    "DELETE /session": Scope.SELF,
    "POST /session/renew": Scope.SELF,
    "PUT /session/password": Scope.SELF,
    "GET /users": Scope.ADMIN,
    "POST /users": Scope.ADMIN,
    "GET /users/{user}": Scope.ADMIN,
    "PATCH /users/{user}": Scope.ADMIN,
    "GET /keys": Scope.ADMIN,
    "POST /keys": Scope.ADMIN,
    "GET /keys/{key}": Scope.ADMIN,
    "DELETE /keys/{key}": Scope.ADMIN,
    "GET /webhooks": Scope.WEBHOOKS,
    "POST /webhooks": Scope.WEBHOOKS,
    "GET /webhooks/{webhook}": Scope.WEBHOOKS,
    "PATCH /webhooks/{webhook}": Scope.WEBHOOKS,
    "DELETE /webhooks/{webhook}": Scope.WEBHOOKS,
    "POST /webhooks/{webhook}/secret": Scope.WEBHOOKS,
    "POST /webhooks/{webhook}/replay": Scope.WEBHOOKS,
    "POST /webhooks/{webhook}/ping": Scope.WEBHOOKS,
    "GET /webhooks/{webhook}/deliveries": Scope.WEBHOOKS,
}
"""Method and path under ``/api/v1`` -> what it is about. Every route has its row."""

OUTSIDE: Mapping[str, Scope] = {
    "GET /": Scope.PUBLIC,
    "FILES /assets": Scope.PUBLIC,
    "GET /docs": Scope.PUBLIC,
    "GET /api/docs": Scope.PUBLIC,
    "FILES /api/docs/files": Scope.PUBLIC,
    "GET /api/openapi.json": Scope.PUBLIC,
    "GET /healthz": Scope.PUBLIC,
    "GET /readyz": Scope.PUBLIC,
    "GET /metrics": Scope.METRICS,
    "GET /metrics/lines": Scope.METRICS,
    "LIVE /{path:path}": Scope.PUBLIC,
}
"""The same for whole paths elsewhere. Some are there only if their files are."""

COMMANDS: Mapping[str, Scope] = {
    "controller.pause": Scope.CONTROL,
    "controller.resume": Scope.CONTROL,
    "controller.emergency": Scope.SIGNAL,
    "controller.emergency.release": Scope.CONTROL,
    "controller.stop": Scope.SIGNAL,
    "zone.pause": Scope.CONTROL,
    "zone.stop": Scope.SIGNAL,
    "zone.resume": Scope.CONTROL,
    "closure.close": Scope.CLOSURES,
    "closure.open": Scope.CLOSURES,
    "alarm.acknowledge": Scope.ALARMS,
    "walk.start": Scope.PLACES,
    "walk.enter": Scope.PLACES,
    "walk.accept": Scope.PLACES,
    "walk.abandon": Scope.PLACES,
    "station.stage": Scope.JOBS,
    "vehicle.park": Scope.VEHICLES,
    "job.cancel": Scope.JOBS,
    "job.abort": Scope.JOBS,
    "job.change": Scope.JOBS,
    "vehicle.command": Scope.VEHICLES,
    "vehicle.recover": Scope.VEHICLES,
    "vehicle.hold": Scope.VEHICLES,
    "vehicle.release": Scope.VEHICLES,
    "vehicle.service": Scope.VEHICLES,
    "vehicle.lockout": Scope.UPKEEP,
    "vehicle.unlock": Scope.UPKEEP,
    "device.command": Scope.DEVICES,
    "device.pin": Scope.UPKEEP,
    "device.unpin": Scope.UPKEEP,
    "device.lockout": Scope.UPKEEP,
    "device.unlock": Scope.UPKEEP,
    "device.service": Scope.UPKEEP,
    "drive.status": Scope.DRIVES,
    "drive.key": Scope.DRIVES,
    "drive.inputs": Scope.DRIVES,
    "drive.lockout": Scope.UPKEEP,
    "drive.unlock": Scope.UPKEEP,
    "drive.read": Scope.DRIVES,
    "drive.write": Scope.DRIVES,
    "drive.backup": Scope.DRIVES,
    "drive.compare": Scope.DRIVES,
    "drive.restore": Scope.DRIVES,
    "drive.jog": Scope.DRIVES,
    "drive.jog.keep": Scope.DRIVES,
    "drive.jog.release": Scope.DRIVES,
    "drive.watch": Scope.DRIVES,
    "drive.unwatch": Scope.DRIVES,
    "link.stop": Scope.STOP_DRIVES,
}
"""Name of a command over the live stream -> what it is about."""


class PolicyError(HoistwayError):
    """The table does not say who may call what; the server does not start."""

    code = "policy"


def row_of(methods: Collection[str] | None, path: str, route: BaseRoute) -> list[str]:
    """Return the names of a route's rows in :data:`ROUTES` or :data:`OUTSIDE`."""
    if isinstance(route, WebSocketRoute):
        methods = (LIVE,)
    elif isinstance(route, Mount):
        methods = (FILES,)
    where = path.removeprefix(API) if path.startswith(API + "/") else path
    return [f"{method} {where}" for method in sorted(methods or ()) if method != "HEAD"]


class Policy:
    """The tables above for the routes of an application. Raises PolicyError: a route has no row, or a row no route."""

    def __init__(self, routes: Iterable[BaseRoute], commands: Collection[str]) -> None:
        self._ways: dict[str, list[tuple[re.Pattern[str], Scope]]] = {}
        self._plain: dict[tuple[str, str], Scope] = {}
        unused, missing = set(ROUTES), []
        for context in iter_route_contexts(list(routes)):
            path, pattern = str(context.path), context.path_regex
            table = ROUTES if path.startswith(API + "/") else OUTSIDE
            for name in row_of(context.methods, path, context.original_route):
                unused.discard(name)
                if name in table:
                    self._ways.setdefault(name.partition(" ")[0], []).append((pattern, table[name]))
                    if "{" not in path:
                        self._plain.setdefault((name.partition(" ")[0], path), table[name])
                else:
                    missing.append(name)
        _complain(missing, sorted(unused), set(commands) ^ set(COMMANDS))
        self._plain = {key: scope for key, scope in self._plain.items() if self._first(*key) is scope}

    def of(self, kind: str, method: str, path: str) -> Scope | None:
        """Return what a request is about; None: there is no such route. It is found as the application finds the route."""
        method = LIVE if kind == "websocket" else "GET" if method == "HEAD" else method
        return self._plain.get((method, path)) or self._first(method, path) or self._file(method, path)

    def _first(self, method: str, path: str) -> Scope | None:
        return next((scope for pattern, scope in self._ways.get(method, ()) if pattern.match(path)), None)

    def _file(self, method: str, path: str) -> Scope | None:
        return None if method == LIVE else self._first(FILES, path)


def _complain(missing: Collection[str], unused: Collection[str], commands: Collection[str]) -> None:
    """Raise PolicyError if the tables and the routes differ."""
    found = {
        "routes without a row in ROUTES or OUTSIDE": missing,
        "rows without a route in ROUTES": unused,
        "commands and rows without the other in COMMANDS": sorted(commands),
    }
    said = "; ".join(f"{what}: {', '.join(names)}" for what, names in found.items() if names)
    if said:
        remedy = "Write into app/api/policy.py which scope each has, and into tests/api/test_policy.py which roles may."
        raise PolicyError(f"it is not said who may call what: {said}", remedy=remedy)


def forbidden(caller: Caller, scope: Scope, what: str) -> Problem:
    """Return why a caller may not do what is in a scope."""
    roles = " or ".join(who_may(scope))
    own = ", ".join(sorted(caller.roles)) or "none"
    remedy = "Log in as somebody who may, use a key with such a role, or ask an administrator for the role."
    return Problem("forbidden", f"{what} needs the role {roles}; {caller.name} has {own}.", remedy)
