"""Queries: a name that a route does not have, and one that is given twice, are refused: else a misspelt filter gives all."""

import re
from collections.abc import Iterable, Iterator
from typing import get_origin
from urllib.parse import parse_qsl

from fastapi.dependencies.models import Dependant
from fastapi.routing import APIRoute, iter_route_contexts
from starlette.routing import BaseRoute
from starlette.types import ASGIApp, Receive, Scope, Send

from app.api.callers import SAFE
from app.api.policy import API
from app.api.problems import CLOSE, Problem, language_in
from app.wire.names import nearest


class Names:
    """What may stand in the query of each route under the API's path, and whether more than once."""

    def __init__(self, routes: Iterable[BaseRoute]) -> None:
        self._ways: dict[str, list[tuple[re.Pattern[str], dict[str, bool]]]] = {}
        for context in iter_route_contexts(list(routes)):
            if isinstance(context.original_route, APIRoute) and str(context.path).startswith(API + "/"):
                names = dict(_names(context.original_route.dependant))
                for method in context.methods or ():
                    self._ways.setdefault(method, []).append((context.path_regex, names))

    def of(self, method: str, path: str) -> dict[str, bool] | None:
        """Return them; None: there is no such route. It is found as the application finds the route."""
        ways = self._ways.get("GET" if method == "HEAD" else method, ())
        return next((names for pattern, names in ways if pattern.match(path)), None)


class Queries:
    """ASGI middleware: refuses a query that the route does not have. A request without one costs nothing."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on, or answer with a problem."""
        problem = self._problem(scope) if scope.get("query_string") and scope["type"] == "http" else None
        if problem is None:
            await self._app(scope, receive, send)
        else:
            await problem.response(language_in(scope))(scope, receive, send)

    def _problem(self, scope: Scope) -> Problem | None:
        known: Names = scope["app"].state.queries
        names = known.of(scope["method"], scope["path"])
        problem = None if names is None else wrong(scope["query_string"], names)
        if problem is not None and scope["method"] not in SAFE:
            problem.headers = CLOSE
        return problem


def wrong(query: bytes, names: dict[str, bool]) -> Problem | None:
    """Return what is wrong with the names in a query; their values are the route's own business."""
    seen: set[str] = set()
    for name, _ in parse_qsl(query.decode("latin-1"), keep_blank_values=True):
        if name not in names:
            close = nearest(name, names)
            known = f"There are {', '.join(sorted(names))}." if names else "There are none here."
            remedy = f"Did you mean {close}?" if close else known
            return Problem("invalid", f"There is no parameter {name[:40]!r}.", remedy, name[:40])
        if name in seen and not names[name]:
            return Problem("invalid", f"{name} is given more than once.", "Give it once.", name)
        seen.add(name)
    return None


def _names(dependant: Dependant) -> Iterator[tuple[str, bool]]:
    for field in dependant.query_params:
        yield field.alias, get_origin(field.field_info.annotation) in {list, set, tuple}
    for inner in dependant.dependencies:
        yield from _names(inner)
