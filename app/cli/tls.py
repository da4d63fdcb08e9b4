"""The server's certificate: looked at before the start, and taken anew when its file changes."""

import asyncio
import ssl
from pathlib import Path

from structlog.typing import FilteringBoundLogger

from app.cli.plainly import CannotStart, said
from app.settings import Settings

LOOK = 60.0
"""Seconds between two looks at the files. Our choice."""


def context_of(settings: Settings) -> ssl.SSLContext | None:
    """Return what the server speaks TLS by; None: it does not. Raises CannotStart: certificate and key cannot be used."""
    if settings.tls_certificate is None:
        return None
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    take(context, settings.tls_certificate, settings.tls_key)
    return context


def take(context: ssl.SSLContext, certificate: Path, key: Path | None) -> None:
    """Let new connections see the certificate that the files hold now. Raises CannotStart: the context is lost then."""
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
        """Whether one of them is another than when they were last taken."""
        return self._now() != self._last

    def taken(self) -> None:
        """Note that they are taken as they are now."""
        self._last = self._now()

    def _now(self) -> list[tuple[int, int] | None]:
        return [_mark(file) for file in self._files]


def _mark(file: Path) -> tuple[int, int] | None:
    try:
        state = file.stat()
    except OSError:
        return None
    return state.st_mtime_ns, state.st_ino


async def renewed(
    context: ssl.SSLContext | None, settings: Settings, log: FilteringBoundLogger, every: float = LOOK
) -> None:
    """Take the certificate anew whenever its files change: whoever renews it need not restart the controller."""
    certificate, key = settings.tls_certificate, settings.tls_key
    if certificate is None or context is None:
        return
    files, told = Seen(certificate, key), None
    while True:
        await asyncio.sleep(every)
        if not files.changed():
            continue
        if (trouble := _trouble(context, certificate, key)) is None:
            files.taken()
            log.info("the certificate was taken anew", file=str(certificate))
        elif trouble != told:
            log.error("the certificate is not taken anew", reason=trouble, goes_on="with the one before")
        told = trouble


def _trouble(context: ssl.SSLContext, certificate: Path, key: Path | None) -> str | None:
    """Take the files, if a context of their own does: one that fails has lost the certificate that it had."""
    try:
        take(ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER), certificate, key)
        take(context, certificate, key)
    except CannotStart as wrong:
        return wrong.message
    return None
