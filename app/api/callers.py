"""Who a request comes from: the key of the settings, a machine's key, a person's session, or a ticket for the live stream."""

import hmac
import math
import secrets
import time
from collections.abc import Callable
from typing import Protocol, cast

from starlette.types import Scope

from app.api.policy import Policy, forbidden
from app.api.problems import Problem
from app.api.rates import Rates
from app.domain.access import Caller, Role
from app.domain.access import Scope as About
from app.settings import Settings, is_loopback

CALLER = "hoistway.caller"
"""Where a request's scope has its :class:`Caller`; it is not there where nobody has to say who they are."""
SHARED = "access-key"
"""The name in the audit of whoever brings the key of the settings."""
SCRAPER = "metrics-key"
"""The name of whoever brings the key for the metrics alone."""
TICKET_LIFE = 30.0
"""Seconds in which a ticket for the live stream can be used, once. Our choice."""
TICKETS = 1000
"""Most unused tickets at a time; the oldest goes."""
LONGEST = 512
"""Longest credential that is looked at, bytes. Our choice."""
SAFE = frozenset({"GET", "HEAD", "OPTIONS"})
CHALLENGE = {"WWW-Authenticate": 'Bearer realm="hoistway"'}


class Tickets:
    """One-time tickets: a browser cannot send a header with a WebSocket, and a key must not stand in a URL."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._until: dict[str, tuple[float, Caller | None]] = {}

    def give(self, caller: Caller | None = None) -> str:
        """Return a new ticket for a caller."""
        while len(self._until) >= TICKETS:
            self._until.pop(next(iter(self._until)))
        ticket = secrets.token_urlsafe(24)
        self._until[ticket] = self._now() + TICKET_LIFE, caller
        return ticket

    def take(self, ticket: str) -> Caller | bool | None:
        """Return whose ticket it is, True if that is not known, None if it is not good; it is used up then."""
        until, caller = self._until.pop(ticket, (-math.inf, None))
        return (caller or True) if self._now() <= until else None


class Register(Protocol):
    """The people and machines that are known (``app.runtime.access``)."""

    @property
    def closed(self) -> bool:
        """Whether there is anybody, so that everybody has to say who they are."""
        ...

    def caller(self, credential: bytes) -> Caller | None:
        """Return whose key or session it is; None: nobody's, or it has ended."""
        ...

    def still(self, caller: Caller) -> bool:
        """Return whether what a caller showed is still good."""
        ...

    def forbid(self, caller: Caller, what: str) -> None:
        """Note that somebody asked for what their roles do not allow."""
        ...


class Callers:
    """Finds who calls, and whether they may. One for the whole application; ``register`` and ``policy`` come later."""

    def __init__(self, settings: Settings, now: Callable[[], float] = time.monotonic) -> None:
        self.tickets = Tickets()
        self.register: Register | None = None
        self.policy: Policy | None = None
        self._fixed: list[tuple[bytes, Caller]] = []
        if settings.access_key is not None:
            shared = Caller(SHARED, frozenset({Role.ADMIN}), person=False)
            self._fixed.append((settings.access_key.get_secret_value().encode(), shared))
        self.following: dict[Callable[[], None], None] = {}
        """What ends the answers that would go on for ever: called when the server stops, which waits for answers to end."""
        self._watched: dict[int, tuple[Caller | None, Callable[[], None]]] = {}
        closed = bool(self._fixed)
        if settings.metrics_key is not None:
            scraper = Caller(SCRAPER, frozenset(), person=False, besides=frozenset({About.METRICS}))
            self._fixed.append((settings.metrics_key.get_secret_value().encode(), scraper))
        self._required = closed or settings.access == "required"
        self._of_address = Rates(settings.address_rate, 2.0 * settings.address_rate, now)
        self._of_caller = Rates(settings.caller_rate, 2.0 * settings.caller_rate, now)

    @property
    def closed(self) -> bool:
        """Whether callers have to say who they are."""
        return self._required or (self.register is not None and self.register.closed)

    def too_fast_from(self, scope: Scope) -> Problem | None:
        """Return why an address has to wait; this machine's own is not counted: a proxy, or the page beside the server."""
        client = scope.get("client")
        if client is None or is_loopback(client[0]):
            return None
        return _slower(self._of_address.wait(client[0]), f"The address {client[0]}")

    def too_fast(self, scope: Scope) -> Problem | None:
        """Return why a caller has to wait."""
        caller: Caller | None = scope.get(CALLER)
        return None if caller is None else _slower(self._of_caller.wait((caller.name, caller.held)), caller.name)

    def refusal(self, scope: Scope, header: bytes | None) -> Problem | None:
        """Return why a request is not let in: nobody known sent it, or their roles do not allow it. Notes who it is."""
        assert self.policy is not None
        kind, path = scope["type"], scope["path"]
        method = scope.get("method", "")
        about = self.policy.of(kind, method, path)
        if about is About.PUBLIC or (about is None and not path.startswith("/api/v1")):
            return None
        caller = self._caller(header or b"", scope)
        if caller is None:
            return _unknown(given=bool(header))
        scope[CALLER] = caller
        if about is None or about in caller.scopes:
            return None
        return self.forbidden(caller, about, f"{method or 'WebSocket'} {path}", asked=method not in SAFE)

    def forbidden(self, caller: Caller, about: About, what: str, *, asked: bool) -> Problem:
        """Return why a caller may not do something; ``asked`` for a change, it is written into the audit."""
        if asked and self.register is not None:
            self.register.forbid(caller, what)
        return forbidden(caller, about, what)

    def watch(self, caller: Caller | None, end: Callable[[], None]) -> Callable[[], None]:
        """Call ``end`` once a caller who was let in would not be any more; return what takes that back."""
        watched = (caller, end)
        self._watched[id(watched)] = watched

        def take_back() -> None:
            self._watched.pop(id(watched), None)

        return take_back

    def leave(self) -> None:
        """Let the answers that would go on for ever end: the server stops."""
        for end in list(self.following):
            end()

    def look(self) -> None:
        """End what those hold open who would not be let in now."""
        for number, (caller, end) in list(self._watched.items()):
            if not self.still(caller):
                self._watched.pop(number, None)
                end()

    def still(self, caller: Caller | None) -> bool:
        """Return whether somebody who was let in would be let in now."""
        if caller is None:
            return not self.closed
        return any(caller is one for _, one in self._fixed) or (
            self.register is not None and self.register.still(caller)
        )

    def _caller(self, header: bytes, scope: Scope) -> Caller | None:
        if given := credential_of(header):
            for secret, caller in self._fixed:
                if hmac.compare_digest(given, secret):
                    return caller
            return None if self.register is None else self.register.caller(given)
        return self._by_ticket(scope) if scope["type"] == "websocket" else None

    def _by_ticket(self, scope: Scope) -> Caller | None:
        for part in scope["query_string"].decode("latin-1").split("&"):
            name, _, value = part.partition("=")
            if name == "ticket":
                caller = self.tickets.take(value)
                if isinstance(caller, Caller) and self.still(caller):
                    return caller
        return None


def credential_of(header: bytes | str) -> bytes:
    """Return the key or token of a header Authorization; empty: it has none, or one too long to be any of ours."""
    if isinstance(header, str):
        header = header.encode("latin-1")
    scheme, _, given = header.partition(b" ")
    given = given.strip()
    return given if scheme.lower() == b"bearer" and len(given) <= LONGEST else b""


def caller_of(scope: Scope) -> Caller | None:
    """Return who a request comes from; None: nobody had to say."""
    return cast("Caller | None", scope.get(CALLER))


def _slower(wait: float, who: str) -> Problem | None:
    if not wait:
        return None
    seconds = math.ceil(wait)
    remedy = f"Wait {seconds} s, and ask less often."
    return Problem("too-many", f"{who} asks too often.", remedy, headers={"Retry-After": str(seconds)})


def _unknown(*, given: bool) -> Problem:
    detail = "This is no key or session that is good now." if given else "This server wants to know who calls."
    remedy = "Log in (POST /api/v1/session), or send the header Authorization: Bearer KEY."
    return Problem("unauthorised", detail, remedy, headers=CHALLENGE)
