"""What stands before every route: host name, origin, access key, size of the body. Plain ASGI, one pass."""

import hmac
import secrets
import time
from collections.abc import Callable

from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api.problems import Problem
from app.settings import Settings, is_loopback

METRICS = "/metrics"
SAFE = frozenset({"GET", "HEAD", "OPTIONS"})
TICKET_LIFE = 30.0
"""Seconds in which a ticket for the live stream can be used, once. Our choice."""
TICKETS = 1000
"""Most unused tickets at a time; the oldest goes."""
HOSTS_KEPT = 100
"""So many spellings of our own name are known again at once. Our choice."""


class Tickets:
    """One-time tickets: a browser cannot send a header with a WebSocket, and a key must not stand in a URL."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._until: dict[str, float] = {}

    def give(self) -> str:
        """Return a new ticket."""
        while len(self._until) >= TICKETS:
            self._until.pop(next(iter(self._until)))
        ticket = secrets.token_urlsafe(24)
        self._until[ticket] = self._now() + TICKET_LIFE
        return ticket

    def take(self, ticket: str) -> bool:
        """Whether the ticket is good; it is used up then."""
        until = self._until.pop(ticket, None)
        return until is not None and self._now() <= until


class Guard:
    """ASGI middleware; what it lets through has passed all four checks."""

    def __init__(self, app: ASGIApp, settings: Settings, tickets: Tickets) -> None:
        self.app = app
        self.limit = settings.body_limit
        """Largest body, bytes."""
        self._tickets = tickets
        self._known_hosts: set[bytes] = set()
        self._key = settings.access_key.get_secret_value().encode() if settings.access_key else None
        self._metrics_key = settings.metrics_key.get_secret_value().encode() if settings.metrics_key else None
        self._hosts = frozenset(host.lower() for host in settings.allowed_hosts)
        self._origins = frozenset(origin.rstrip("/").lower() for origin in settings.allowed_origins)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Check, then pass on, or answer with a problem."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        problem = self.refusal(scope)
        if problem is None and scope["type"] == "http":
            receive = self._bounded(receive)
        if problem is None:
            await self.app(scope, receive, send)
        elif scope["type"] == "http" or "websocket.http.response" in scope.get("extensions", {}):
            await problem.response()(scope, receive, send)
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
        return (
            self._host(host or b"")
            or (None if origin is None else self._origin(scope, origin, host or b""))
            or (None if self._key is None else self._access(scope, access or b""))
            or (None if length is None or scope["type"] != "http" else self._size(length))
        )

    def _host(self, host: bytes) -> Problem | None:
        """Without a key, only a name of this machine: a foreign name that resolves to it is DNS rebinding."""
        if self._key is not None or host in self._known_hosts:
            return None
        name = _host_name(host.decode("latin-1"))
        if name in self._hosts or is_loopback(name):
            if len(self._known_hosts) < HOSTS_KEPT:
                self._known_hosts.add(host)
            return None
        remedy = "Use localhost or 127.0.0.1, add the name to allowed_hosts, or set access_key."
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

    def _access(self, scope: Scope, header: bytes) -> Problem | None:
        """The page, its parts, the descriptions and the probes are open; everything under ``/api/v1`` wants the key.

        So does ``/metrics``, which takes the key for it as well.
        """
        if self._key is None or not scope["path"].startswith(("/api/v1", METRICS)):
            return None
        scheme, _, given = header.partition(b" ")
        if scheme.lower() == b"bearer" and hmac.compare_digest(given.strip(), self._key):
            return None
        scraped = self._metrics_key if scope["path"].startswith(METRICS) else None
        if scheme.lower() == b"bearer" and scraped is not None and hmac.compare_digest(given.strip(), scraped):
            return None
        if scope["type"] == "websocket" and self._ticket(scope):
            return None
        remedy = "Send the header Authorization: Bearer KEY."
        return Problem(
            "unauthorised",
            "This server wants an access key, and this is not it." if given else "This server wants an access key.",
            remedy,
            headers={"WWW-Authenticate": 'Bearer realm="hoistway"'},
        )

    def _ticket(self, scope: Scope) -> bool:
        for part in scope["query_string"].decode("latin-1").split("&"):
            name, _, value = part.partition("=")
            if name == "ticket" and self._tickets.take(value):
                return True
        return False

    def _size(self, length: bytes) -> Problem | None:
        if length.isdigit() and len(length) < 20 and int(length) <= self.limit:
            return None
        return Problem("too-large", f"The body is larger than {self.limit} bytes.", "Send it in parts.")

    def _bounded(self, receive: Receive) -> Receive:
        limit, seen = self.limit, 0

        async def bounded() -> Message:
            nonlocal seen
            message = await receive()
            if message["type"] == "http.request":
                seen += len(message.get("body", b""))
                if seen > limit:
                    raise HTTPException(413, f"The body is larger than {limit} bytes.")
            return message

        return bounded


def _host_name(host: str) -> str:
    if host.startswith("["):
        return host.partition("]")[0].strip("[").lower()
    return host.partition(":")[0].lower()
