"""One delivery over HTTP: to an address that is allowed, without redirects, bounded in time, its answer not read."""

import asyncio
import ssl
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Protocol

import httpx

from app.runtime.webhooks.targets import Targets

WITHIN = 10.0
"""Seconds for a delivery as a whole. Our choice."""
CONNECT_WITHIN = 5.0


class Unreachable(Exception):
    """A delivery got no answer; the message says why."""


@dataclass(frozen=True, slots=True)
class Answer:
    """What a receiver said: its status, and how many seconds it wants to be left alone, if it says so."""

    status: int
    retry_after: float | None = None


class Post(Protocol):
    """Delivers."""

    async def __call__(self, url: str, headers: dict[str, str], body: bytes) -> Answer:
        """Deliver once. Raises Unreachable."""
        ...


class Sender:
    """Delivers by HTTP; an async context manager. ``authorities``: a file of certificates to trust instead of the system's."""

    def __init__(self, targets: Targets, version: str, authorities: Path | None = None) -> None:
        self.targets = targets
        self._version = version
        self._trusted = None if authorities is None else ssl.create_default_context(cafile=str(authorities))
        self._opened: httpx.AsyncClient | None = None

    async def __aenter__(self) -> "Sender":
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    async def close(self) -> None:
        """Close all connections."""
        if self._opened is not None:
            await self._opened.aclose()
            self._opened = None

    @property
    def _client(self) -> httpx.AsyncClient:
        """The client, made for the first delivery: reading the system's certificates takes its time."""
        if self._opened is None:
            self._opened = httpx.AsyncClient(
                verify=self._trusted or ssl.create_default_context(),
                trust_env=False,
                follow_redirects=False,
                timeout=httpx.Timeout(WITHIN, connect=CONNECT_WITHIN),
            )
        return self._opened

    async def __call__(self, url: str, headers: dict[str, str], body: bytes) -> Answer:
        """Deliver once. Raises Unreachable."""
        try:
            async with asyncio.timeout(WITHIN):
                return await self._post(httpx.URL(url), headers, body)
        except TimeoutError:
            raise Unreachable(f"no answer within {WITHIN:.0f} s") from None
        except httpx.HTTPError as wrong:
            raise Unreachable(str(wrong) or type(wrong).__name__) from wrong
        except OSError as wrong:
            raise Unreachable(wrong.strerror or str(wrong)) from wrong

    async def _post(self, url: httpx.URL, headers: dict[str, str], body: bytes) -> Answer:
        """Connect to the address that was looked at: a name asked twice may give another one the second time."""
        address = await self.targets.address(str(url))
        named = {
            "Host": url.netloc.decode(),
            "Content-Type": "application/json",
            "User-Agent": f"hoistway/{self._version}",
            **headers,
        }
        pinned = url.copy_with(host=address)
        client = self._client
        request = client.build_request(
            "POST", pinned, content=body, headers=named, extensions={"sni_hostname": url.host}
        )
        answer = await client.send(request, stream=True)
        try:
            return Answer(answer.status_code, _seconds(answer.headers.get("retry-after", "")))
        finally:
            await answer.aclose()


def _seconds(text: str) -> float | None:
    return float(text) if text.isascii() and text.isdigit() and len(text) < 7 else None
