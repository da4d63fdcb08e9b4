"""Counts HTTP calls by route, and tells the log of those that were refused. Plain ASGI; a call costs it some microseconds."""

import time
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

import msgspec
from prometheus_client.metrics_core import Metric
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from structlog.typing import FilteringBoundLogger

from app.api.callers import caller_of
from app.api.problems import MEDIA_TYPE, METHODS
from app.runtime.metrics import Spread
from app.runtime.metrics.shapes import alone, counters, histograms
from app.runtime.telemetry import logger

SECONDS = (0.001, 0.005, 0.01, 0.05, 0.1, 0.5, 1.0, 5.0, 30.0)
"""Upper bounds of the time until an answer begins, s. Our choice."""
NO_ROUTE = "(none)"
"""The label of calls for what is not there: their paths are the callers' invention."""
LINES = 60
"""Most refused calls that the log tells of in a minute: hostile callers must not fill it. Our choice."""
_PROBLEM = (b"content-type", MEDIA_TYPE.encode())


class Refused(msgspec.Struct):
    """What the log says of a problem."""

    code: str = ""
    detail: str = ""
    field: str = ""


_refused = msgspec.json.Decoder(Refused)


class CountedCalls:
    """ASGI middleware before all others. Routes are templates (``/api/v1/jobs/{job}``), so that labels are bounded."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._answers: Counter[tuple[str, str, int]] = Counter()
        self._seconds: dict[tuple[str, str], Spread] = {}
        self._problems: Counter[str] = Counter()
        self._log: FilteringBoundLogger = logger(part="api")
        self._lines = LINES
        self._since = now()
        self._left_out = 0
        self._now = now

    async def __call__(self, app: ASGIApp, route: str, scope: Scope, receive: Receive, send: Send) -> None:
        """Let ``app`` answer; ``route`` is its template where that is known before."""
        began = time.perf_counter()
        status = 0

        async def noted(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = message["status"]
                self._count(scope, route, status, time.perf_counter() - began)
                if status >= 400:
                    problem = _PROBLEM in message["headers"]
                    status = status if problem else 0
            elif status >= 400 and message.get("body"):
                self._refuse(scope, status, message["body"])
                status = 0
            await send(message)

        await app(scope, receive, noted)

    def _count(self, scope: Scope, route: str, status: int, seconds: float) -> None:
        method = scope["method"] if scope["method"] in METHODS else "other"
        name = route or route_of(scope)
        self._answers[method, name, status] += 1
        spread = self._seconds.get((method, name))
        if spread is None:
            spread = self._seconds[method, name] = Spread(SECONDS)
        spread.see(seconds)

    def _refuse(self, scope: Scope, status: int, body: Any) -> None:
        """Count a problem by its code, and write it down."""
        try:
            problem = _refused.decode(body)
        except (msgspec.DecodeError, TypeError):
            return
        self._problems[problem.code] += 1
        if not self._may_tell():
            self._left_out += 1
            return
        left_out, self._left_out = self._left_out, 0
        client, caller = scope.get("client"), caller_of(scope)
        self._log.info(
            "call refused",
            method=scope["method"],
            path=plain(scope["path"][:200]),
            status=status,
            code=problem.code,
            detail=problem.detail,
            field=problem.field or None,
            address=client[0] if client else None,
            caller=caller.name if caller else None,
            **({"left_out": str(left_out)} if left_out else {}),
            **_about(scope),
        )

    def _may_tell(self) -> bool:
        if self._now() - self._since >= 60.0:
            self._since, self._lines = self._now(), LINES
        self._lines -= 1
        return self._lines >= 0

    def families(self) -> Iterator[Metric]:
        """Give what was counted."""
        answers = {(method, route, str(status)): float(n) for (method, route, status), n in self._answers.items()}
        yield counters("http_requests", "Answers by route and status.", ["method", "route", "code"], answers)
        yield histograms(
            "http_request_seconds", "Time until an answer begins.", ["method", "route"], self._seconds.items()
        )
        yield counters("http_problems", "Refused calls, by the code of the problem.", ["code"], alone(self._problems))


def route_of(scope: Scope) -> str:
    """Return the template of the route that took a request. A route knows its path within its router: the rest stands before."""
    template = getattr(scope.get("route"), "path", None)
    if template is None:
        mounted = str(scope.get("root_path") or "")
        return mounted or (str(scope["path"]) if "endpoint" in scope else NO_ROUTE)
    parts = scope["path"].split("/")
    before = len(parts) - len(template.split("/")) + 1
    return "/".join(parts[:before]) + str(template)


def _about(scope: Scope) -> dict[str, str]:
    """Return the job and the vehicle that a call is about, as the log names them."""
    named = scope.get("path_params") or {}
    return {
        name: plain(str(named[name])[:64]) for name in ("job", "vehicle", "device", "drive", "station") if name in named
    }


def plain(text: str) -> str:
    """Return a caller's text for a log: what could command a terminal is written as its escape."""
    return "".join(sign if sign.isprintable() else sign.encode("unicode_escape").decode() for sign in text)
