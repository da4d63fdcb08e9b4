"""An operator's work in a real browser, against the real server and its simulated vehicles; and who cannot use a mouse."""

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Page, expect

from tests.api.recordings import recorded
from tests.e2e.processes import answers, free_ports, quick_plant, running, wait_until
from tests.web.looks import faults
from tests.web.served import served
from tests.web.whole import whole
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]


@pytest.fixture
def plant(tmp_path: Path) -> Iterator[str]:
    """The small plant whose port P2 was never taught; gives the page's address."""
    file = quick_plant("small", tmp_path)
    text, found = re.subn(r"(P2: \{.*?), dest: \{.*?\}", r"\1", file.read_text(encoding="utf-8"))
    assert found == 1
    file.write_text(text, encoding="utf-8")
    (port,) = free_ports(1)
    url, log = f"http://127.0.0.1:{port}", tmp_path / "demo.log"
    with running("demo", "--plant", str(file), "--port", str(port), log=log):
        wait_until(lambda: answers(url), "the server", log)
        yield url
    assert "Traceback" not in log.read_text(encoding="utf-8")


def test_an_operator_posts_follows_closes_a_rail_and_reads_why(page: Page, plant: str) -> None:
    complaints, asked = [], []
    page.on("console", lambda said: complaints.append(said.text) if said.type in {"error", "warning"} else None)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))
    page.goto(plant)
    expect(page.locator(".link.live")).to_be_visible()
    page.get_by_label("Your name").fill("kim")
    for vehicle in ("V001", "V002"):
        expect(page.locator(".chip", has_text=vehicle)).to_contain_text(re.compile("idle|parked"))

    transfer(page, "P1", "B2")
    follow(page)
    close_a_rail_and_read_why(page)

    assert complaints == []
    assert {urlsplit(url).netloc for url in asked} == {urlsplit(plant).netloc}


def order(page: Page, source: str, destination: str) -> None:
    form = page.locator(".transfer")
    form.locator("select").nth(0).select_option(source)
    form.locator("select").nth(1).select_option(destination)
    form.get_by_role("button", name="Order", exact=True).click()


def room(page: Page, name: str) -> None:
    page.get_by_role("navigation", name="Rooms").get_by_role("button", name=name).click()


def transfer(page: Page, source: str, destination: str) -> None:
    """Post a job, look why it got its vehicle, and wait until it has ended."""
    order(page, source, destination)
    job = page.locator(".jobs .job").first
    job.get_by_title("All about this job").click()
    panel = page.locator(".panel")
    expect(panel.locator(".choice").first).to_contain_text("to the source")
    expect(panel.locator("h2")).to_contain_text("completed")
    expect(panel.locator(".phases span")).to_have_count(3)
    expect(panel.get_by_text(re.compile("queued .* fetching .* carrying"))).to_be_visible()


def follow(page: Page) -> None:
    """Find a vehicle by its name and keep it in the middle of the map."""
    page.keyboard.press("Escape")
    find = page.get_by_role("combobox", name="Find")
    find.fill("v00")
    expect(page.locator("#found [role=option]")).to_have_count(2)
    find.press("ArrowDown")
    find.press("Enter")
    expect(page.locator(".panel h2")).to_contain_text("V002")
    page.get_by_role("button", name="Follow").click()
    expect(page.get_by_role("button", name="Follow")).to_have_attribute("aria-pressed", "true")


def close_a_rail_and_read_why(page: Page) -> None:
    """Close a station after a look at what that does; a job for it waits and says why; then open it."""
    room(page, "Closures")
    form = page.get_by_role("form", name="Close")
    form.get_by_label("From barcode").fill("105")
    form.get_by_label("To barcode").fill("107")
    form.get_by_role("button", name="Look what it would do").click()
    expect(form.locator("[data-preview]")).to_contain_text("P2")
    form.get_by_label("Reason").fill("the rail is cleaned")
    form.get_by_role("button", name="Close", exact=True).click()
    closure = page.locator("[data-closure]")
    expect(closure).to_contain_text("the rail is cleaned")
    expect(closure).to_contain_text("closed")
    order(page, "B2", "P3")
    job = page.locator(".jobs .job").first
    expect(job).to_contain_text("closed")
    closure.get_by_role("button", name="Open").click()
    closure.get_by_role("button", name="Sure?").click()
    expect(closure).to_have_count(0)
    expect(job.locator(".state")).to_have_text("completed")


ROOMS = (
    "map",
    "vehicles",
    "jobs",
    "alarms",
    "closures",
    "stations",
    "teaching",
    "statistics",
    "walks",
    "access",
    "audit",
    "webhooks",
    "playback",
)
CHOSEN = ("", "vehicle=V001", "station=ETCH01-P1", "device=DOOR1", "drive=STK01-LIFT")


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_every_room_and_panel_is_accessible(page: Page, theme: str, tmp_path: Path) -> None:
    controller = whole()
    controller.playback = recorded(tmp_path)
    controller.happen("AlarmSet", vehicle="V001")
    with served(controller=controller) as server:
        page.add_init_script(f"localStorage.setItem('hoistway.theme', '{theme}')")
        found: dict[str, list[str]] = {}
        for place in [*ROOMS, *(f"map?{chosen}" for chosen in CHOSEN if chosen)]:
            page.goto("about:blank")
            page.goto(f"{server.url}#/{place}")
            expect(page.locator(".link.live, .then-at")).to_be_visible()
            page.evaluate("document.querySelectorAll('details').forEach((box) => { box.open = true; })")
            wrong = faults(page)
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
