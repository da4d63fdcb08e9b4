"""Chromium without a screen, driven over its DevTools protocol: enough to open a page, ask it, and take a picture."""

import base64
import itertools
import json
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from websockets.sync.client import ClientConnection, connect

NAMES = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--mute-audio",
    "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--remote-debugging-port=0",
)  # fmt: skip


_NUMBERS = itertools.count(1)
PATIENCE = 120.0
"""Seconds that a page, or Chromium itself, may take on a machine that has more to do. Our choice."""


class PageError(AssertionError):
    """The page did not do what was expected of it."""


def installed() -> str | None:
    """Return where Chromium is, or None."""
    return next((path for name in NAMES if (path := shutil.which(name))), None)


class Page:
    """One tab. ``requests`` are the addresses it asked for, ``complaints`` its errors and warnings, so far."""

    def __init__(self, wire: ClientConnection, width: int, height: int) -> None:
        self.requests: list[str] = []
        self.complaints: list[str] = []
        self._wire = wire
        self._session: str | None = None
        self._past = self.call("Target.createBrowserContext")["browserContextId"]
        target = self.call("Target.createTarget", url="about:blank", browserContextId=self._past)["targetId"]
        self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def call(self, method: str, *, within: float = PATIENCE, **params: Any) -> dict[str, Any]:
        """Call a DevTools method; return its result. Raises PageError, TimeoutError: no answer ``within`` seconds."""
        number = next(_NUMBERS)
        message: dict[str, Any] = {"id": number, "method": method, "params": params}
        if self._session is not None:
            message["sessionId"] = self._session
        self._wire.send(json.dumps(message))
        while True:
            answer: dict[str, Any] = json.loads(self._wire.recv(timeout=within))
            if answer.get("id") == number:
                break
            if answer.get("sessionId") == self._session:
                self._heard(answer)
        if "error" in answer:
            raise PageError(f"{method}: {answer['error']['message']}")
        result: dict[str, Any] = answer["result"]
        return result

    def open(self, url: str) -> None:
        """Go to an address."""
        self.call("Page.navigate", url=url)

    def ask(self, expression: str, within: float = PATIENCE) -> Any:
        """Return the value of an expression in the page, awaited. Raises PageError: it threw."""
        result = self.call(
            "Runtime.evaluate", within=within, expression=expression, awaitPromise=True, returnByValue=True
        )
        if "exceptionDetails" in result:
            raise PageError(f"{expression}: {json.dumps(result['exceptionDetails'])[:500]}")
        return result["result"].get("value")

    def until(self, condition: str, within: float = PATIENCE) -> None:
        """Return once an expression in the page is true. Raises PageError: not ``within`` so many seconds."""
        watch = f"""new Promise((done) => {{
          const end = Date.now() + {within * 1000};
          const look = () => {{
            let good = false;
            try {{ good = Boolean({condition}); }} catch (error) {{ good = false; }}
            if (good || Date.now() > end) done(good); else setTimeout(look, 50);
          }};
          look();
        }})"""
        if not self.ask(watch, within + 30):
            text = self.ask("document.body ? document.body.innerText.slice(0, 1500) : ''")
            raise PageError(f"not within {within} s: {condition}\n{text}\n{self.complaints}")

    def close(self) -> None:
        """Close the tab, and forget all that it kept."""
        self._session = None
        self.call("Target.disposeBrowserContext", browserContextId=self._past)

    def picture(self) -> bytes:
        """Return the page as PNG."""
        return base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])

    def _heard(self, event: dict[str, Any]) -> None:
        params = event.get("params", {})
        match event.get("method"):
            case "Network.requestWillBeSent":
                self.requests.append(params["request"]["url"])
            case "Network.webSocketCreated":
                self.requests.append(params["url"])
            case "Runtime.exceptionThrown":
                self.complaints.append(json.dumps(params["exceptionDetails"])[:500])
            case "Runtime.consoleAPICalled" if params["type"] in {"error", "warning", "assert"}:
                self.complaints.append(json.dumps(params["args"])[:500])
            case "Log.entryAdded" if params["entry"]["level"] in {"error", "warning"}:
                self.complaints.append(f"{params['entry']['text']} {params['entry'].get('url', '')}")


@contextmanager
def chromium(width: int = 1280, height: int = 800, flags: Sequence[str] = ()) -> Iterator[ClientConnection]:
    """Give the wire to a fresh Chromium. Raises FileNotFoundError: there is none."""
    path = installed()
    if path is None:
        raise FileNotFoundError("Chromium is not installed (Debian: apt-get install chromium)")
    with tempfile.TemporaryDirectory(prefix="hoistway-chromium-", ignore_cleanup_errors=True) as profile:
        command = [path, *FLAGS, *flags, f"--user-data-dir={profile}", f"--window-size={width},{height}", "about:blank"]
        log = Path(profile) / "log"
        with (
            log.open("wb") as discarded,
            subprocess.Popen(command, stdout=discarded, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL) as process,
        ):
            try:
                with connect(_address(process), max_size=None, compression=None) as wire:
                    yield wire
            finally:
                process.terminate()
                assert process.stderr is not None
                process.stderr.read()


@contextmanager
def new_tab(wire: ClientConnection, width: int = 1280, height: int = 800) -> Iterator[Page]:
    """Give an empty tab without a past, in a Chromium under way."""
    page = Page(wire, width, height)
    try:
        yield page
    finally:
        page.close()


@contextmanager
def browser(width: int = 1280, height: int = 800, flags: Sequence[str] = ()) -> Iterator[Page]:
    """Give one empty tab of a fresh Chromium. Raises FileNotFoundError: there is none."""
    with chromium(width, height, flags) as wire:
        yield Page(wire, width, height)


def _address(process: subprocess.Popen[bytes]) -> str:
    assert process.stderr is not None
    for line in process.stderr:
        _, found, address = line.decode(errors="replace").partition("DevTools listening on ")
        if found:
            return address.strip()
    raise PageError("Chromium did not start")
