"""What stands before every route, in this order: host name, origin, rate of the address, who calls and what they may, size of the
body, rate of the caller. Plain ASGI, one pass; nothing of a body is read before."""

from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api.callers import SAFE, Callers
from app.api.problems import CLOSE, Problem, language_in
from app.settings import Settings, is_loopback

LAYOUTS = "/api/v1/layout/versions"
"""Where plant files are staged."""
HOSTS_KEPT = 100
"""So many spellings of our own name are known again at once. Our choice."""


class Guard:
    """ASGI middleware; what it lets through has passed all checks."""

    def __init__(self, app: ASGIApp, settings: Settings, callers: Callers) -> None:
        self.app = app
        self.limit = settings.body_limit
        """Largest body, bytes."""
        self._layouts = max(settings.layout_limit, settings.body_limit)
        self._callers = callers
        self._known_hosts: set[bytes] = set()
        self._hosts = frozenset(host.lower() for host in settings.allowed_hosts)
        self._origins = frozenset(origin.rstrip("/").lower() for origin in settings.allowed_origins)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Check, then pass on, or answer with a problem."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        problem = self.refusal(scope)
        if problem is None and scope["type"] == "http":
            receive = self._bounded(receive, self._limit(scope))
        if problem is None:
            await self.app(scope, receive, send)
        elif scope["type"] == "http" or "websocket.http.response" in scope.get("extensions", {}):
            await problem.response(language_in(scope))(scope, receive, send)
        else:
            await receive()
            await send({"type": "websocket.close", "code": 1008, "reason": problem.brief()})

    def refusal(self, scope: Scope) -> Problem | None:
        """Return why a request is not let through; a body is to be counted besides, as it comes."""
        host = origin = access = length = None
        for name, value in scope["headers"]:
            if name == b"host":
                host = value if host is None else host
            elif name == b"content-length":
                length = value if length is None else length
            elif name == b"origin":
                origin = value if origin is None else origin
            elif name == b"authorization":
                access = value if access is None else access
        callers, closed = self._callers, self._callers.closed
        problem = (
            (None if closed else self._host(host or b""))
            or (None if origin is None else self._origin(scope, origin, host or b""))
            or callers.too_fast_from(scope)
            or (callers.refusal(scope, access) if closed else None)
            or (None if length is None or scope["type"] != "http" else self._size(scope, length))
            or (callers.too_fast(scope) if closed else None)
        )
        if problem is not None and scope["type"] == "http" and scope["method"] not in SAFE:
            problem.headers = {**problem.headers, **CLOSE}
        return problem

    def _host(self, host: bytes) -> Problem | None:
        """Where nobody says who they are, only a name of this machine: a foreign name that resolves to it is DNS rebinding."""
        if host in self._known_hosts:
            return None
        name = _host_name(host.decode("latin-1"))
        if name in self._hosts or is_loopback(name):
            if len(self._known_hosts) < HOSTS_KEPT:
                self._known_hosts.add(host)
            return None
        remedy = "Use localhost or 127.0.0.1, add the name to allowed_hosts, or let people log in (docs/access.md)."
        return Problem("misdirected", f"This server does not answer to the name {name[:80]!r}.", remedy)

    def _origin(self, scope: Scope, given: bytes, host: bytes) -> Problem | None:
        """A browser names the page that calls: only our own page, or one named in the settings, may change or watch."""
        if scope["type"] == "http" and scope["method"] in SAFE:
            return None
        origin = given.decode("latin-1")
        same = {f"{scheme}://{host.decode('latin-1').lower()}" for scheme in ("http", "https")}
        if origin.lower() in same or origin.lower() in self._origins:
            return None
        detail = f"A page of {origin[:80]!r} may not call this server."
        return Problem("foreign-origin", detail, "Use the server's own page, or add the origin to allowed_origins.")

    def _size(self, scope: Scope, length: bytes) -> Problem | None:
        limit = self._limit(scope)
        if length.isdigit() and len(length) < 20 and int(length) <= limit:
            return None
        return Problem("too-large", f"The body is larger than {limit} bytes.", "Send it in parts.")

    def _limit(self, scope: Scope) -> int:
        """Return how large a body may be: a plant file is larger than anything else that people send."""
        return self._layouts if scope["path"] == LAYOUTS and scope["method"] == "POST" else self.limit

    def _bounded(self, receive: Receive, limit: int) -> Receive:
        seen = 0

        async def bounded() -> Message:
            nonlocal seen
            message = await receive()
            if message["type"] == "http.request":
                seen += len(message.get("body", b""))
                if seen > limit:
                    raise HTTPException(413, f"The body is larger than {limit} bytes.", CLOSE)
            return message

        return bounded


def _host_name(host: str) -> str:
    if host.startswith("["):
        return host.partition("]")[0].strip("[").lower()
    return host.partition(":")[0].lower()
