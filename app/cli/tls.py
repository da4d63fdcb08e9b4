"""The server's certificate: looked at before the start, and taken anew when its file changes."""

import asyncio
import ssl
from pathlib import Path
from typing import TypedDict

import uvicorn
from structlog.typing import FilteringBoundLogger

from app.cli.plainly import CannotStart, said
from app.settings import Settings

LOOK = 60.0
"""Seconds between two looks at the files. Our choice."""


class Files(TypedDict, total=False):
    """The server's own names for what it needs."""

    ssl_certfile: str
    ssl_keyfile: str | None


def files_of(settings: Settings) -> Files:
    """Return what the server needs to speak TLS; nothing where it does not."""
    if settings.tls_certificate is None:
        return Files()
    key = settings.tls_key
    return Files(ssl_certfile=str(settings.tls_certificate), ssl_keyfile=None if key is None else str(key))


def checked(settings: Settings) -> None:
    """Look whether certificate and key can be read and belong together. Raises CannotStart."""
    if settings.tls_certificate is not None:
        take(ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER), settings.tls_certificate, settings.tls_key)


def take(context: ssl.SSLContext, certificate: Path, key: Path | None) -> None:
    """Let new connections see the certificate that the files hold now. Raises CannotStart; the old one stays then."""
    try:
        for file in (certificate, key):
            if file is not None:
                file.read_bytes()
        context.load_cert_chain(certificate, key, password=_none)
    except ssl.SSLError as wrong:
        remedy = (
            "It takes PEM: the certificate, then those between it and the root; and its own key, without a password."
        )
        raise CannotStart(
            f"tls_certificate {certificate} cannot be used: {wrong.reason or wrong}", remedy=remedy
        ) from None
    except OSError as wrong:
        raise CannotStart(f"{wrong.filename or certificate} cannot be read: {said(wrong)}") from None


def _none() -> str:
    """Give no password: without this the library would ask at the terminal."""
    return ""


class Seen:
    """The files as they were when they were last taken."""

    def __init__(self, *files: Path | None) -> None:
        self._files = [file for file in files if file is not None]
        self._last = self._now()

    def changed(self) -> bool:
        """Whether one of them is another since this was last asked."""
        now = self._now()
        before, self._last = self._last, now
        return now != before

    def _now(self) -> list[tuple[int, int] | None]:
        return [_mark(file) for file in self._files]


def _mark(file: Path) -> tuple[int, int] | None:
    try:
        state = file.stat()
    except OSError:
        return None
    return state.st_mtime_ns, state.st_ino


async def renewed(config: uvicorn.Config, settings: Settings, log: FilteringBoundLogger, every: float = LOOK) -> None:
    """Take the certificate anew whenever its files change: whoever renews it need not restart the controller."""
    certificate, key = settings.tls_certificate, settings.tls_key
    if certificate is None:
        return
    files = Seen(certificate, key)
    while True:
        await asyncio.sleep(every)
        if not files.changed() or config.ssl is None:
            continue
        if (trouble := _trouble(config.ssl, certificate, key)) is None:
            log.info("the certificate was taken anew", file=str(certificate))
        else:
            log.error("the certificate is not taken anew", reason=trouble, goes_on="with the one before")


def _trouble(context: ssl.SSLContext, certificate: Path, key: Path | None) -> str | None:
    try:
        take(context, certificate, key)
    except CannotStart as wrong:
        return wrong.message
    return None
