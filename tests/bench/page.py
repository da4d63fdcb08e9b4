"""The map of a whole fab in Chromium without a GPU: 1,000 vehicles that report ten times a second, and the same played back."""

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from tests.bench import past
from tests.bench.measuring import Row, Skipped, child, line_of
from tools.chromium import Page, browser, installed

VEHICLES = 1_000
GOAL = 30.0
"""Frames a second (issue 6)."""
WARM, MEASURE = 4.0, 8.0
"""Seconds."""
PAN = """new Promise((done) => {
  const canvas = document.querySelector('.map .touch');
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const send = (kind, x, y) => canvas.dispatchEvent(
    new PointerEvent(kind, { clientX: left + x, clientY: top + y, bubbles: true, pointerId: 1, isPrimary: true }));
  canvas.setPointerCapture = () => undefined;
  const begun = performance.now();
  let frames = 0, all = 0, counted = 0;
  send('pointerdown', width / 2, height / 2);
  const step = (now) => {
    const seconds = (now - begun) / 1000;
    all += 1;
    if (seconds > WARM && !counted) counted = now;
    else if (counted) frames += 1;
    if (seconds > WARM + MEASURE) {
      const span = (now - counted) / 1000;
      send('pointerup', width / 2, height / 2);
      return done({ frames: frames / span, all });
    }
    // Round and round by more than the map is wide, 700 px/s.
    send('pointermove', width / 2 + 560 * Math.sin(seconds * 1.25), height / 2 + 300 * Math.cos(seconds * 1.25));
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
})""".replace("WARM", str(WARM)).replace("MEASURE", str(MEASURE))
ZOOM = """(() => { const c = document.querySelector('.map .touch'); const b = c.getBoundingClientRect();
  for (let i = 0; i < TIMES; i++) c.dispatchEvent(new WheelEvent('wheel',
    { deltaY: -200, clientX: b.left + b.width / 2, clientY: b.top + b.height / 2, bubbles: true, cancelable: true })); })()"""


def measured(page: Page, closer: int) -> tuple[float, float]:
    """Return frames a second while the map is moved, so much closer, and the ms that the page's thread ran for each."""
    page.ask(ZOOM.replace("TIMES", str(closer)))
    before = _ran(page)
    found: dict[str, float] = page.ask(PAN, within=120)
    return found["frames"], (_ran(page) - before) / found["all"] * 1000


def _ran(page: Page) -> float:
    """Return the seconds of CPU that the page's own thread has had: scripts, styles, and drawing without a GPU."""
    metrics = page.call("Performance.getMetrics")["metrics"]
    return next(float(metric["value"]) for metric in metrics if metric["name"] == "TaskDuration")


def rows() -> Iterator[Row]:
    """Measure the whole fab at once, from nearer, and its past. Frames want the machine for themselves; CPU for each does not."""
    if installed() is None:
        raise Skipped("Chromium is not installed")
    with _served() as url, _opened() as page:
        page.open(url)
        page.until("document.querySelector('.link.live') && document.querySelector('.front').dataset.pictures > 20", 60)
        for name, closer in (("the whole fab", 0), ("a few bays", 5), ("one bay", 4)):
            frames, cost = measured(page, closer)
            yield Row(f"page: panning {name}", frames, GOAL, None, "frames/s", 1.0, "higher")
            yield Row(f"page: the page's thread for a frame, panning {name}", cost, 1000 / GOAL, None, "ms", 1.0)
    with _served("--recorded", past.RECORDED) as url, _opened() as page:
        yield from past.rows(page, url, lambda: _ran(page), lambda closer: measured(page, closer))


@contextmanager
def _served(*more: object) -> Iterator[str]:
    """Serve the fab beside us; give its address."""
    command = (sys.executable, "-m", "tests.web.fab", "--vehicles", VEHICLES, *more)
    with child(*map(str, command), stdout=subprocess.PIPE) as server:
        yield line_of(server.stdout).strip()


@contextmanager
def _opened() -> Iterator[Page]:
    with browser(1280, 800) as page:
        page.call("Performance.enable", timeDomain="threadTicks")
        yield page
