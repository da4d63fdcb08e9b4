"""Words to the service manager over its datagram socket (sd_notify(3)): ready, alive, stopping. Without one they go nowhere."""

import asyncio
import os
import socket
from collections.abc import Callable, Mapping
from typing import Protocol

from structlog.typing import FilteringBoundLogger

from app.domain.units import Seconds
from app.runtime.telemetry import logger

FEEDS = 4
"""How often the watchdog is fed within its time. Our choice; sd_watchdog_enabled(3) asks for two at least."""


class Heart(Protocol):
    """What has to live for the watchdog to be fed."""

    def silent_for(self) -> Seconds:
        """Return for how long the part that makes decisions durable has not stirred."""
        ...


class Notifier:
    """One service manager, or none. ``environ`` has NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID as systemd sets them."""

    def __init__(self, environ: Mapping[str, str], pid: int | None = None) -> None:
        self._address = environ.get("NOTIFY_SOCKET", "")
        self._log: FilteringBoundLogger = logger(part="notify")
        mine = environ.get("WATCHDOG_PID", "") in ("", str(os.getpid() if pid is None else pid))
        text = environ.get("WATCHDOG_USEC", "")
        self.within: Seconds | None = (
            Seconds(int(text) / 1e6) if mine and self._address and text.isdigit() and int(text) else None
        )
        """The watchdog's time; None if nobody watches."""
        self._timer: asyncio.TimerHandle | None = None

    def ready(self, status: str) -> None:
        """Requests are answered from now on."""
        self._say(f"READY=1\nSTATUS={status}")

    def stopping(self) -> None:
        """The end has begun."""
        self.rest()
        self._say("STOPPING=1")

    def feed(self, heart: Heart, told: Callable[[str], None] = lambda reason: None) -> None:
        """Feed the watchdog from now on, on the loop, while the heart beats: a loop that stands still feeds nobody.

        ``told`` hears once why it is not fed any more.
        """
        self.rest()
        if self.within is None:
            return
        silent = heart.silent_for()
        if silent < self.within / 2:
            self._say("WATCHDOG=1")
        else:
            told(f"nothing was made durable or tried for {silent:.0f} s")
            told = _nothing
        self._timer = asyncio.get_running_loop().call_later(self.within / FEEDS, self.feed, heart, told)

    def rest(self) -> None:
        """Feed no more."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _say(self, words: str) -> None:
        if not self._address:
            return
        # A leading @ stands for the NUL of an abstract address.
        address = "\0" + self._address[1:] if self._address.startswith("@") else self._address
        try:
            with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM | socket.SOCK_CLOEXEC) as wire:
                wire.settimeout(0.0)
                wire.sendto(words.encode(), address)
        except OSError as why:
            self._log.warning("the service manager does not listen", reason=str(why))


def _nothing(reason: str) -> None:
    """Tell nobody: it has been told."""
