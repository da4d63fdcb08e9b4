"""One delivery over HTTP: to an address that is allowed, without redirects, bounded in time; of an answer that refuses it the
first letters are read."""

import asyncio
import errno
import os
import socket
import ssl
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Protocol

import httpx

from app.runtime.webhooks.targets import Targets

WITHIN = 10.0
"""Seconds for a delivery as a whole. Our choice."""
CONNECT_WITHIN = 5.0
SHOWN = 200
"""Bytes of an answer that say why an event is not taken. Our choice."""


class Unreachable(Exception):
    """A delivery got no answer; the message says why."""


@dataclass(frozen=True, slots=True)
class Answer:
    """What a receiver said: its status, how many seconds it wants to be left alone, if it says so, and how a refusal begins."""

    status: int
    retry_after: float | None = None
    words: str = field(default="", compare=False)

    @property
    def refusal(self) -> str:
        """Why the event does not count as taken; empty: it does."""
        if 200 <= self.status < 300:
            return ""
        return f"answered {self.status}: {self.words}" if self.words else f"answered {self.status}"


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
        except (httpx.HTTPError, OSError) as wrong:
            raise Unreachable(_why(wrong, httpx.URL(url))) from wrong

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
            words = "" if answer.is_success else await _beginning(answer)
            return Answer(answer.status_code, _seconds(answer.headers.get("retry-after", "")), words)
        finally:
            await answer.aclose()


async def _beginning(answer: httpx.Response) -> str:
    """Return how an answer begins, in letters that can be shown; empty where it is packed, or nothing comes."""
    found = b""
    if "content-encoding" not in answer.headers:
        with suppress(httpx.HTTPError):
            async for some in answer.aiter_raw():
                found += some
                if len(found) >= SHOWN:
                    break
    text = found[:SHOWN].decode(errors="replace")
    return " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())


def _why(wrong: Exception, url: httpx.URL) -> str:
    """Return what kept a delivery from being answered."""
    causes = list(_causes(wrong))
    for cause in causes:
        if isinstance(cause, socket.gaierror):
            return f"the name {url.host} is not found ({cause.strerror})"
        if isinstance(cause, ssl.SSLCertVerificationError):
            return f"its certificate is not trusted ({cause.verify_message})"
        if isinstance(cause, ssl.SSLError):
            return f"TLS is not agreed on ({cause.reason or cause})"
    if isinstance(wrong, httpx.ConnectTimeout):
        return f"no connection within {CONNECT_WITHIN:.0f} s"
    if isinstance(wrong, httpx.TimeoutException):
        return f"no answer within {WITHIN:.0f} s"
    number = next((cause.errno for cause in causes if isinstance(cause, OSError) and cause.errno), None)
    if number == errno.ECONNREFUSED:
        return f"{url.netloc.decode()} refuses the connection"
    if isinstance(wrong, httpx.ConnectError) and number is not None:
        return f"{url.netloc.decode()} cannot be reached ({os.strerror(number)})"
    if isinstance(wrong, httpx.RemoteProtocolError | httpx.ReadError | httpx.WriteError):
        return "the connection ended without an answer"
    return str(wrong) or type(wrong).__name__


def _causes(wrong: BaseException | None) -> Iterator[BaseException]:
    while wrong is not None:
        yield wrong
        if isinstance(wrong, BaseExceptionGroup):
            yield from (inner for one in wrong.exceptions for inner in _causes(one))
        wrong = wrong.__cause__ or wrong.__context__


def _seconds(text: str) -> float | None:
    return float(text) if text.isascii() and text.isdigit() and len(text) < 7 else None
