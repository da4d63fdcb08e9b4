"""Takes the README's picture: starts the demo with work to do, opens the page, waits until it is busy.

``python -m tools.screenshot [--out FILE] [--size 1680x1050] [--url URL]``; with ``--url`` of a server that runs already.
"""

import argparse
import re
import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path

from tools.chromium import Page, PageError, browser

ROOT = Path(__file__).parents[1]
BUSY = """document.querySelector('.link.live')
  && [...document.querySelectorAll('.job.over .state.good')].length >= 3
  && document.querySelectorAll('.job .state.go').length >= 3
  && document.querySelectorAll('.chip .box').length >= 3"""
CHOOSE = """(() => {
  const loaded = [...document.querySelectorAll('.chip')].find((chip) => chip.querySelector('.box'));
  loaded?.click();
  return new Promise((done) => setTimeout(done, 1500));
})()"""
GRACE = 20


@contextmanager
def demo() -> Iterator[str]:
    """Run the demo at free ports; give its URL."""
    with tempfile.TemporaryDirectory() as directory:
        plant = Path(directory) / "demo.yaml"
        text = (ROOT / "plants" / "demo.yaml").read_text(encoding="utf-8")
        plant.write_text(re.sub(r"127\.0\.0\.1:\d+", lambda _: f"127.0.0.1:{_free()}", text), encoding="utf-8")
        command = [sys.executable, "-m", "app.cli", "demo", "--workload", "--port", "0", "--plant", str(plant)]
        with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
            try:
                yield _url(process)
            finally:
                process.send_signal(signal.SIGINT)
                process.wait(GRACE)


_given: set[int] = set()


def _free() -> int:
    while True:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port: int = probe.getsockname()[1]
        if port not in _given:
            _given.add(port)
            return port


def _url(process: subprocess.Popen[str]) -> str:
    assert process.stdout is not None
    for line in process.stdout:
        found = re.search(r"http://\S+", line)
        if found:
            return found[0]
    raise SystemExit("The demo did not start; its own words stand above.")


def picture(page: Page, url: str) -> bytes:
    """Return the page at its busiest, with a loaded vehicle chosen, as PNG."""
    page.open(url)
    page.until(BUSY, within=180)
    page.ask(CHOOSE)
    return page.picture()


def main() -> None:
    """Take the picture."""
    parser = argparse.ArgumentParser(description="Take the README's picture of the operator page.")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "screenshot.png")
    parser.add_argument("--size", default="1680x1050", help="width and height in pixels")
    parser.add_argument("--url", help="a server that runs already; without it the demo is started")
    given = parser.parse_args()
    width, height = map(int, given.size.split("x"))
    with nullcontext(given.url) if given.url else demo() as url, browser(width, height) as page:
        try:
            image = picture(page, url)
        except PageError as why:
            raise SystemExit(
                f"The page did not get busy: is there work? Try: hoistway workload --url {url}\n{why}"
            ) from None
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_bytes(image)


if __name__ == "__main__":
    main()
