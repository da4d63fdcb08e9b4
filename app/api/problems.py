"""Problems by RFC 9457: one table from codes to statuses, and the ways into it."""

import dataclasses
import re
from collections.abc import Mapping, Sequence
from http import HTTPStatus

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.responses import Response
from starlette.routing import Match, Mount
from starlette.types import Scope
from starlette.websockets import WebSocket

from app.domain.errors import HoistwayError, Refusal
from app.runtime.showing import encode
from app.texts import Language, language_of, text, told

MEDIA_TYPE = "application/problem+json"
TYPE_PREFIX = "/api/v1/problems/"
REASON_BYTES = 123
METHODS = ("DELETE", "GET", "HEAD", "PATCH", "POST", "PUT")

CLOSE = {"Connection": "close"}
"""What comes after a refusal before a body is read would be the rest of that body."""

CODES: dict[str, tuple[int, str]] = {
    "malformed": (400, "The request cannot be read"),
    "unauthorised": (401, "Nobody who is known here asks"),
    "forbidden": (403, "The caller's roles do not allow this"),
    "foreign-origin": (403, "A page from elsewhere may not do this"),
    "not-found": (404, "There is no such object"),
    "no-such-path": (404, "There is no such path"),
    "method": (405, "The path does not have this method"),
    "conflict": (409, "It contradicts what is there"),
    "not-now": (409, "Not possible in the present state"),
    "stale": (412, "Somebody else changed it meanwhile"),
    "too-large": (413, "The body is too large"),
    "media-type": (415, "The body is not JSON"),
    "misdirected": (421, "This server does not answer to that host name"),
    "invalid": (422, "The request says something that cannot be"),
    "no-route": (422, "The track does not connect these places"),
    "cannot-encode": (422, "The vehicle's protocol cannot say this"),
    "too-many": (429, "Too many at the same time"),
    "internal": (500, "A defect of this server"),
    "store": (503, "The database cannot be used just now"),
    "plant-held": (503, "Another controller holds this plant"),
    "unavailable": (503, "The controller does not answer just now"),
}
"""Stable code -> status and title. The codes of refusals and of our own errors are among them."""

USUAL: dict[str, str] = {
    "malformed": "Send a body that is JSON in UTF-8.",
    "method": "The paths and their methods are listed at /api/docs.",
    "too-large": "Send less at a time.",
    "invalid": "Correct it: /api/docs says what may stand there.",
}
"""What helps where a problem does not say it better."""


@dataclasses.dataclass(eq=False)
class Problem(Exception):
    """Ends a request with a problem. ``code`` is one of :data:`CODES`."""

    code: str
    detail: str
    remedy: str = ""
    field: str = ""
    errors: Sequence[Mapping[str, object]] = ()
    headers: Mapping[str, str] = dataclasses.field(default_factory=dict)

    @property
    def status(self) -> int:
        """The HTTP status."""
        return CODES[self.code][0]

    def body(self, language: Language = "en") -> dict[str, object]:
        """Return the members of the problem, in a language as far as the catalogue of texts has it."""
        usual = self.code if self.code in USUAL else "other"
        members: dict[str, object] = {
            "type": TYPE_PREFIX + self.code,
            "title": text("problems", self.code, language),
            "status": self.status,
            "detail": told(self.detail, language),
            "code": self.code,
            "remedy": told(self.remedy, language) or text("remedies", usual, language),
        }
        if self.field:
            members["field"] = self.field
        if self.errors:
            members["errors"] = [_error_in(error, language) for error in self.errors]
        return members

    def brief(self) -> str:
        """Return the detail as the reason of a closed WebSocket: at most 123 bytes of UTF-8 (RFC 6455 5.5.1)."""
        return self.detail.encode()[:REASON_BYTES].decode(errors="ignore")

    def response(self, language: Language = "en") -> Response:
        """Return it as a response."""
        headers = {**self.headers, "Content-Language": language}
        return Response(encode(self.body(language)), self.status, headers, MEDIA_TYPE)


def language_in(scope: Scope) -> Language:
    """Return the language that a caller prefers: the header Accept-Language."""
    accepted = next((value for name, value in scope["headers"] if name == b"accept-language"), b"")
    return language_of(accepted.decode("latin-1")) if accepted else "en"


def refused(refusal: Refusal) -> Problem:
    """Return a refusal of the controller as a problem."""
    code = refusal.code if refusal.code in CODES else "invalid"
    return Problem(code, refusal.reason, refusal.remedy, refusal.field)


def ours(error: HoistwayError) -> Problem:
    """Return an error of our own as a problem."""
    code = error.code if error.code in CODES else "internal"
    return Problem(code, error.message, error.remedy)


def install(app: FastAPI) -> None:
    """Make every error of the application a problem."""
    app.add_exception_handler(Problem, _own)
    app.add_exception_handler(RequestValidationError, _validation)
    app.add_exception_handler(HTTPException, _http)
    app.add_exception_handler(HoistwayError, _ours)
    app.add_exception_handler(Exception, defect)


OF_A_RECORDING = (
    "This is a recording: GET /api/v1/history?at=TIME shows what it has of a moment, "
    "GET /api/v1/history/span from when to when."
)
_ELSEWHERE = re.compile(r"^GET \S+ lists them\.$|hoistway serve")
"""Remedies that help with a controller alone."""


async def _own(request: Request, error: Exception) -> Response:
    assert isinstance(error, Problem)
    controller = getattr(request.app.state, "controller", None)
    if getattr(controller, "recording", False) and _ELSEWHERE.search(error.remedy):
        error = dataclasses.replace(error, remedy=OF_A_RECORDING)
    return error.response(language_in(request.scope))


async def _ours(request: Request, error: Exception) -> Response:
    assert isinstance(error, HoistwayError)
    return ours(error).response(language_in(request.scope))


async def defect(request: Request, _error: Exception) -> Response:
    """Answer what no other handler takes. The server closes the connection then, and says so."""
    remedy = "Report it with the server's log of this moment; nothing is known of the request's effect."
    answer = Problem("internal", "The request met a defect of this server.", remedy).response(
        language_in(request.scope)
    )
    answer.headers["connection"] = "close"
    return answer


_BY_STATUS = {400: "malformed", 401: "unauthorised", 404: "no-such-path", 405: "method", 413: "too-large"}


async def _http(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    code = _BY_STATUS.get(error.status_code)
    headers = {name.lower(): value for name, value in (error.headers or {}).items()}
    if code is None:
        title = HTTPStatus(error.status_code).phrase
        body = encode({"type": "about:blank", "title": title, "status": error.status_code, "detail": str(error.detail)})
        return Response(body, error.status_code, headers, MEDIA_TYPE)
    detail, remedy = str(error.detail), ""
    if code == "no-such-path":
        detail, remedy = f"There is no {request.url.path}.", "The paths are listed at /api/docs."
    elif code == "method":
        detail = f"{request.url.path} does not have {request.method}."
        headers["allow"] = ", ".join(_methods(request))
        remedy = f"It has {headers['allow']}."
    return Problem(code, detail, remedy, headers=headers).response(language_in(request.scope))


async def no_stream(socket: WebSocket) -> None:
    """Refuse a WebSocket at a path that has none, with a problem."""
    problem = Problem(
        "no-such-path", f"There is no stream at {socket.url.path}.", "The live stream is at /api/v1/live."
    )
    if "websocket.http.response" in socket.scope.get("extensions", {}):
        await socket.send_denial_response(problem.response(language_in(socket.scope)))
    else:
        await socket.close(1008, problem.brief())


def _methods(request: Request) -> list[str]:
    """Return every method that the path of a request has; the framework's own word is that of one route alone."""
    routes = [route for route in request.app.routes if not isinstance(route, Mount)]
    found = [
        method
        for method in METHODS
        if any(route.matches({**request.scope, "method": method})[0] is Match.FULL for route in routes)
    ]
    return found or ["GET", "HEAD"]


async def _validation(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)
    return problem_of(error.errors(), request.headers.get("content-type", "")).response(language_in(request.scope))


def problem_of(errors: Sequence[Mapping[str, object]], content_type: str) -> Problem:
    """Return what pydantic found wrong as a problem that names each field."""
    body_ignored = any(e["loc"] == ("body",) for e in errors) and not is_json(content_type)
    if body_ignored and content_type:
        remedy = "Send the header Content-Type: application/json."
        return Problem("media-type", f"The body came as {content_type[:80]!r}.", remedy)
    if any(e["type"] == "json_invalid" for e in errors):
        return Problem("malformed", f"The body is not JSON: {_why_not_json(errors)}.")
    found = [{"field": _place(e), "message": message_of(e)} for e in errors]
    first = found[0]
    detail = f"{first['field']}: {first['message']}" if first["field"] else first["message"]
    return Problem("invalid", detail, field=first["field"], errors=found)


def _error_in(error: Mapping[str, object], language: Language) -> dict[str, object]:
    """Return one of several errors in a language; what is said of a field may be known together with its name alone."""
    found = dict(error)
    place, message = str(found.get("field", "")), str(found.get("message", ""))
    whole = told(f"{place}: {message}", language) if place else ""
    known = whole.startswith(f"{place}: ") and whole != f"{place}: {message}"
    found["message"] = whole.removeprefix(f"{place}: ") if known else told(message, language)
    if remedy := found.get("remedy"):
        found["remedy"] = told(str(remedy), language)
    return found


def is_json(content_type: str) -> bool:
    """Whether a Content-Type says JSON."""
    kind = content_type.partition(";")[0].strip().lower()
    return kind == "application/json" or (kind.startswith("application/") and kind.endswith("+json"))


def _place(error: Mapping[str, object]) -> str:
    loc = error["loc"]
    assert isinstance(loc, tuple)
    discriminator = _context(error).get("discriminator")
    parts = [*loc[1:], str(discriminator).strip("'")] if discriminator else loc[1:]
    return ".".join(str(part) for part in parts)


def message_of(error: Mapping[str, object]) -> str:
    """Return what is wrong with a field, in words for people."""
    message = str(error["msg"]).removeprefix("Value error, ")
    return {
        "extra_forbidden": "there is no such field",
        "missing": "is required" if _place(error) else "a body in JSON is required",
        "model_type": "a JSON object is required" if _place(error) else "the body has to be a JSON object",
        "model_attributes_type": "a JSON object is required" if _place(error) else "the body has to be a JSON object",
        "timezone_aware": "has no zone: say it, such as 2026-07-01T08:30:00Z or 2026-07-01T17:30:00+09:00",
        "union_tag_not_found": "is required",
        "union_tag_invalid": f"is none of {_context(error).get('expected_tags')}",
        "string_pattern_mismatch": "holds a character that is not allowed here (control characters never are)",
    }.get(str(error["type"]), message)


def _why_not_json(errors: Sequence[Mapping[str, object]]) -> str:
    first = next(e for e in errors if e["type"] == "json_invalid")
    return str(_context(first).get("error", first["msg"]))


def _context(error: Mapping[str, object]) -> Mapping[str, object]:
    context = error.get("ctx")
    return context if isinstance(context, Mapping) else {}
