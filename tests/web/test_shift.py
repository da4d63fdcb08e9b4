"""An operator's shift in a real browser, against the real server and its simulated vehicles; and who cannot use a mouse."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect, sync_playwright

from tests.e2e.processes import GENEROUS
from tests.web.served import served
from tests.web.whole import whole
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]
FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-dev-shm-usage",
)
AXE = Path(__file__).parent / "axe" / "axe.min.js"
PATIENCE = GENEROUS * 500


@pytest.fixture
def page() -> Iterator[Page]:
    with sync_playwright() as play:
        chromium = play.chromium.launch(executable_path=installed(), args=list(FLAGS))
        try:
            context = chromium.new_context(
                viewport={"width": 1440, "height": 1000}, locale="en-GB", reduced_motion="reduce"
            )
            page = context.new_page()
            page.set_default_timeout(PATIENCE)
            expect.set_options(timeout=PATIENCE)
            yield page
        finally:
            chromium.close()


ROOMS = ("map", "vehicles", "jobs", "alarms", "closures", "stations", "teaching", "statistics")
CHOSEN = ("", "vehicle=V001", "station=ETCH01-P1", "device=DOOR1", "drive=STK01-LIFT")


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_every_room_and_panel_is_accessible(page: Page, theme: str) -> None:
    with served(controller=whole()) as server:
        page.add_init_script(f"localStorage.setItem('hoistway.theme', '{theme}')")
        found: dict[str, list[str]] = {}
        for place in [*ROOMS, *(f"map?{chosen}" for chosen in CHOSEN if chosen)]:
            page.goto("about:blank")
            page.goto(f"{server.url}#/{place}")
            expect(page.locator(".link.live")).to_be_visible()
            page.evaluate("document.querySelectorAll('details').forEach((box) => { box.open = true; })")
            page.evaluate(AXE.read_text(encoding="utf-8"))
            result = page.evaluate("axe.run(document, { resultTypes: ['violations'] })")
            wrong = [
                f"{rule['id']}: {node['html'][:120]}: {node['failureSummary'][:300]}"
                for rule in result["violations"]
                for node in rule["nodes"][:3]
            ]
            if wrong:
                found[place] = wrong
        assert found == {}


def test_the_map_can_be_moved_zoomed_and_left_by_key(page: Page) -> None:
    with served(controller=whole()) as server:
        page.goto(server.url)
        expect(page.locator(".link.live")).to_be_visible()
        chart = page.get_by_role("application")
        chart.focus()
        ground = page.locator(".map canvas").first
        before = ground.evaluate("(canvas) => canvas.style.transform")
        page.keyboard.press("ArrowRight")
        expect(ground).not_to_have_css("transform", "none")
        page.wait_for_function(
            "(before) => document.querySelector('.map canvas').style.transform !== before", arg=before
        )
        page.keyboard.press("/")
        expect(page.get_by_role("combobox", name="Find")).to_be_focused()
