"""Playback of a whole fab in Chromium without a GPU: frames while it plays and is moved about, and how soon a moment is seen."""

import statistics
from collections.abc import Callable, Iterator

from tests.bench.measuring import Row
from tools.chromium import Page

RECORDED = 320
"""Seconds of the past: enough for what is played at the quickest pace."""
GOAL = 30.0
"""Frames a second (issue 6)."""
WARM, MEASURE = 2.0, 8.0
"""Seconds."""
NEAR, FAR = 100.0, 1000.0
"""How soon a moment is to be seen, ms: a second further on in what was fetched, and anywhere else. Our choice: what is felt
to come at once, and what does not interrupt a thought."""
TIMES = 15
LOOK = """new Promise((done) => {
  const begun = performance.now();
  let frames = 0, all = 0, counted = 0;
  const step = (now) => {
    const seconds = (now - begun) / 1000;
    all += 1;
    if (seconds > WARM && !counted) counted = now;
    else if (counted) frames += 1;
    if (seconds > WARM + MEASURE) return done({ frames: frames / ((now - counted) / 1000), all });
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
})""".replace("WARM", str(WARM)).replace("MEASURE", str(MEASURE))
PRESS = (
    """[...document.querySelectorAll('.transport button')].find((one) => one.textContent.trim() === 'LABEL').click()"""
)
SEEN = "document.querySelector('.front').dataset.moment"
SCRUB = """new Promise((done) => {
  const canvas = document.querySelector('.front');
  const slider = document.querySelector('.scrubber input');
  const goal = TO;
  const begun = performance.now();
  slider.value = String(goal);
  slider.dispatchEvent(new InputEvent('input', { bubbles: true }));
  const look = () => Math.abs(Number(canvas.dataset.moment) - goal) < 0.5
    ? done(performance.now() - begun) : performance.now() - begun > 20000 ? done(null) : requestAnimationFrame(look);
  requestAnimationFrame(look);
})"""


def rows(
    page: Page, url: str, thread: Callable[[], float], panned: Callable[[int], tuple[float, float]]
) -> Iterator[Row]:
    """Measure playback of a fab whose past is recorded. ``thread``: seconds that the page's own thread has run."""
    page.open(f"{url}#/playback")
    page.until(f"document.querySelector('.scrubber input') && Number({SEEN}) > 0", 60)
    begin, end = (float(page.ask(f"document.querySelector('.scrubber input').{name}")) for name in ("min", "max"))
    yield from _scrubbed(page, begin, end)
    for pace in (1, 16):
        _at(page, begin + 5)
        page.ask(PRESS.replace("LABEL", f"×{pace}"))
        page.ask(PRESS.replace("LABEL", "▶"))
        yield from _shown(f"playing at ×{pace}", *_looked(page, thread))
        page.ask(PRESS.replace("LABEL", "❚❚"))
    yield from _shown("panning what was", *panned(0))
    _at(page, begin + 5)
    page.ask(PRESS.replace("LABEL", "×1"))
    page.ask(PRESS.replace("LABEL", "▶"))
    yield from _shown("panning what was, a few bays, at ×1", *panned(5))


def _at(page: Page, moment: float) -> float:
    """Go to a moment; return after how many ms it was to be seen."""
    took: float | None = page.ask(SCRUB.replace("TO", str(int(moment))), within=60)
    if took is None:
        raise RuntimeError("the moment was never shown")
    return took


def _scrubbed(page: Page, begin: float, end: float) -> Iterator[Row]:
    near = [_at(page, begin + 10 + second) for second in range(TIMES)]
    yield Row("page: a second on in playback, to be seen", statistics.median(near), NEAR, None, "ms", 1.0)
    stride = (end - begin - 40) / TIMES
    far = [_at(page, begin + 20 + (number * 7 % TIMES) * stride) for number in range(TIMES)]
    yield Row("page: anywhere else in playback, to be seen", statistics.median(far), FAR, None, "ms", 1.0)


def _looked(page: Page, thread: Callable[[], float]) -> tuple[float, float]:
    before = thread()
    found: dict[str, float] = page.ask(LOOK, within=120)
    return found["frames"], (thread() - before) / found["all"] * 1000


def _shown(what: str, frames: float, cost: float) -> Iterator[Row]:
    yield Row(f"page: {what}", frames, GOAL, None, "frames/s", 1.0, "higher")
    yield Row(f"page: the page's thread for a frame, {what}", cost, 1000 / GOAL, None, "ms", 1.0)
