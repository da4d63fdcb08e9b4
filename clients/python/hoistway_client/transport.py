"""How calls travel: keys, names, problems; one class that waits, one for asyncio."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import TracebackType
from typing import Any
from urllib.parse import quote

import httpx

TIMEOUT = 40.0
"""Seconds: the server itself answers within 30, that it cannot if need be."""


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


def problem_of(answer: httpx.Response) -> Problem:
    """Return what an answer says is wrong."""
    try:
        body = answer.json()
    except ValueError:
        body = {}
    body = body if isinstance(body, dict) else {}
    return Problem.of(answer.status_code, {"code": "unknown", "detail": answer.text[:200], **body})


def path(part: object) -> str:
    """Return a part of a path as it travels."""
    return quote(str(part), safe=":+@")


def _headers(key: str | None, actor: str | None) -> list[tuple[bytes, bytes]]:
    """Return what each request says; names of people travel as UTF-8."""
    headers = [(b"authorization", f"Bearer {key}".encode())] if key else []
    return [*headers, *([(b"x-actor", actor.encode())] if actor else [])]


def _given(values: Mapping[str, Any] | None) -> dict[str, Any]:
    return {name: value for name, value in (values or {}).items() if value is not None}


def _answer(answer: httpx.Response) -> Any:
    if answer.status_code >= 400:
        raise problem_of(answer)
    return answer.json() if answer.content else None


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
        return _answer(self._http.request(method, where, json=body, params=_given(params), headers=_given(headers)))


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
        return _answer(
            await self._http.request(method, where, json=body, params=_given(params), headers=_given(headers))
        )
