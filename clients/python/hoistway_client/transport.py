"""How calls travel: keys, names, problems; one class that waits, one for asyncio."""

import ssl
from collections.abc import Mapping
from dataclasses import dataclass
from types import TracebackType
from typing import Any
from urllib.parse import quote

import httpx

TIMEOUT = 40.0
"""Seconds: the server itself answers within 30, that it cannot if need be."""
SHOWN = 200
"""Letters that are shown of what is no controller's answer."""


@dataclass(eq=False)
class Problem(Exception):
    """Why not (RFC 9457). ``code`` is stable; ``remedy`` says what would help; ``status`` is that of HTTP."""

    status: int
    code: str
    title: str
    detail: str
    remedy: str = ""
    field: str = ""
    body: Mapping[str, Any] | None = None

    @classmethod
    def of(cls, status: int, body: Mapping[str, Any]) -> "Problem":
        """Return a problem from its members."""
        code, title, detail, remedy, field = (
            str(body.get(name, "")) for name in ("code", "title", "detail", "remedy", "field")
        )
        return cls(status, code, title, detail, remedy, field, body)

    def __str__(self) -> str:
        """Return it as people read it."""
        return f"{self.status} {self.code}: {self.detail} {self.remedy}".strip()


def problem_of(answer: httpx.Response, asked: str) -> "Problem | NoController":
    """Return what an answer says is wrong; one that says nothing of it is no controller's."""
    try:
        body = answer.json()
    except ValueError:
        body = None
    if not isinstance(body, dict) or "code" not in body:
        return foreign(asked, answer)
    return Problem.of(answer.status_code, body)


class Unreachable(Exception):
    """No answer of a controller came. ``asked`` is what was asked (``GET https://…``), ``why`` what stood in the way, ``remedy``
    what would help. Whether a change was made nobody knows: ask again with the same ``job_id`` or ``idempotency_key``.
    """

    def __init__(self, asked: str, why: str, remedy: str) -> None:
        super().__init__(f"{asked}: {why}. {remedy}")
        self.asked, self.why, self.remedy = asked, why, remedy


class NotConnected(Unreachable):
    """Nobody could be connected to: wrong address, server away, no way there. Nothing was asked of it, so nothing was done."""


class Untrusted(NotConnected):
    """TLS could not be agreed on: the server's certificate is not trusted, or it does not speak TLS."""


class TimedOut(Unreachable):
    """The answer did not come in time."""


class NoController(Unreachable):
    """What answers is no controller: a proxy's page, another program. ``status`` is that of HTTP, ``text`` how it begins."""

    def __init__(self, asked: str, why: str, remedy: str, status: int, text: str) -> None:
        super().__init__(asked, why, remedy)
        self.status, self.text = status, text


def unreachable(asked: str, error: httpx.TransportError) -> Unreachable:
    """Return what an error of the connection means."""
    if isinstance(error, httpx.ConnectTimeout | httpx.PoolTimeout):
        return NotConnected(asked, "no connection in time", "Is the address right, and no firewall in between?")
    if isinstance(error, httpx.TimeoutException):
        remedy = "Ask again with the same job_id or idempotency_key: nobody knows whether it was done."
        return TimedOut(asked, "no answer in time", remedy)
    tls = _tls_error(error) if isinstance(error, httpx.ConnectError) else None
    if isinstance(tls, ssl.SSLCertVerificationError):
        remedy = (
            "Set SSL_CERT_FILE to a file with the authority's certificate, or call the server by the name in its own."
        )
        return Untrusted(asked, f"the server's certificate is not trusted ({tls.verify_message})", remedy)
    if tls is not None:
        return Untrusted(
            asked, f"TLS was not agreed on ({tls.reason or tls})", "Does it speak TLS? Else write http://."
        )
    if isinstance(error, httpx.ConnectError | httpx.UnsupportedProtocol):
        return NotConnected(asked, str(error) or "no connection", "Does the server run, and is the address right?")
    remedy = "Ask again with the same job_id or idempotency_key: nobody knows whether it was done."
    return Unreachable(asked, str(error) or "the connection was lost", remedy)


def _tls_error(error: BaseException) -> ssl.SSLError | None:
    seen: BaseException | None = error
    while seen is not None and not isinstance(seen, ssl.SSLError):
        seen = seen.__cause__ or seen.__context__
    return seen


def asked_of(http: httpx.Client | httpx.AsyncClient, method: str, where: str) -> str:
    """Return what is asked, for people: without what could be secret in a query."""
    return f"{method} {str(http.base_url).rstrip('/')}{where}"


def path(part: object) -> str:
    """Return a part of a path as it travels."""
    return quote(str(part), safe=":+@")


def _headers(key: str | None, actor: str | None) -> list[tuple[bytes, bytes]]:
    """Return what each request says; names of people travel as UTF-8."""
    headers = [(b"authorization", f"Bearer {key}".encode())] if key else []
    return [*headers, *([(b"x-actor", actor.encode())] if actor else [])]


def _given(values: Mapping[str, Any] | None) -> dict[str, Any]:
    return {name: value for name, value in (values or {}).items() if value is not None}


def _answer(asked: str, answer: httpx.Response) -> Any:
    if answer.status_code >= 400:
        raise problem_of(answer, asked)
    if 300 <= answer.status_code < 400:
        why = f"it leads elsewhere ({answer.status_code} {answer.headers.get('location', '')})".replace(" )", ")")
        raise NoController(asked, why, "Name the controller's own address.", answer.status_code, answer.text[:SHOWN])
    try:
        return answer.json() if answer.content else None
    except ValueError:
        raise foreign(asked, answer) from None


def foreign(asked: str, answer: httpx.Response) -> NoController:
    """Return that something else than a controller answers."""
    kind = answer.headers.get("content-type", "no type").partition(";")[0]
    why = f"the answer ({answer.status_code}, {kind}) is no JSON of a controller: {answer.text[:SHOWN]!r}"
    remedy = "Is that the controller's address? A proxy in between may have answered."
    return NoController(asked, why, remedy, answer.status_code, answer.text[:SHOWN])


class Synchronous:
    """A connection to one controller: ``with Hoistway("http://127.0.0.1:8080", key=..., actor="mes") as hoistway``."""

    def __init__(
        self,
        url: str,
        *,
        key: str | None = None,
        actor: str | None = None,
        timeout: float = TIMEOUT,
        transport: httpx.BaseTransport | None = None,
    ) -> None:
        self.url = url.rstrip("/")
        self.key = key
        self._http = httpx.Client(base_url=self.url, headers=_headers(key, actor), timeout=timeout, transport=transport)

    def __enter__(self) -> "Synchronous":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Close all connections."""
        self._http.close()

    def _call(
        self,
        method: str,
        where: str,
        body: object = None,
        params: Mapping[str, Any] | None = None,
        headers: Mapping[str, Any] | None = None,
    ) -> Any:
        asked = asked_of(self._http, method, where)
        try:
            answer = self._http.request(method, where, json=body, params=_given(params), headers=_given(headers))
        except httpx.TransportError as error:
            raise unreachable(asked, error) from error
        return _answer(asked, answer)


class Asynchronous:
    """The same for asyncio: ``async with AsyncHoistway(...) as hoistway``."""

    def __init__(
        self,
        url: str,
        *,
        key: str | None = None,
        actor: str | None = None,
        timeout: float = TIMEOUT,
        transport: httpx.AsyncBaseTransport | None = None,
    ) -> None:
        self.url = url.rstrip("/")
        self.key = key
        self._http = httpx.AsyncClient(
            base_url=self.url, headers=_headers(key, actor), timeout=timeout, transport=transport
        )

    async def __aenter__(self) -> "Asynchronous":
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    async def close(self) -> None:
        """Close all connections."""
        await self._http.aclose()

    async def _call(
        self,
        method: str,
        where: str,
        body: object = None,
        params: Mapping[str, Any] | None = None,
        headers: Mapping[str, Any] | None = None,
    ) -> Any:
        asked = asked_of(self._http, method, where)
        try:
            answer = await self._http.request(method, where, json=body, params=_given(params), headers=_given(headers))
        except httpx.TransportError as error:
            raise unreachable(asked, error) from error
        return _answer(asked, answer)
