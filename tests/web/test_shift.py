"""An operator's work in a real browser, against the real server and its simulated vehicles; and who cannot use a mouse."""

import re
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.api.receptions import PASSWORD
from tests.api.recordings import recorded
from tests.e2e.processes import COMMAND, GENEROUS, HTTP, answers, free_ports, quick_plant, running, wait_until
from tests.web.hands import press_twice
from tests.web.looks import faults
from tests.web.served import served
from tests.web.staffed import log_in
from tests.web.whole import whole
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]


@dataclass(frozen=True)
class Site:
    """Where the page is, and where the hands at the simulated hoists are."""

    url: str
    hands: str


@pytest.fixture
def plant(tmp_path: Path) -> Iterator[Site]:
    """The small plant, where kim may log in, and whose port P2 was never taught."""
    file = quick_plant("small", tmp_path)
    text, found = re.subn(r"(P2: \{.*?), dest: \{.*?\}", r"\1", file.read_text(encoding="utf-8"))
    assert found == 1
    file.write_text(text, encoding="utf-8")
    port, hands = free_ports(2)
    database = f"sqlite:///{tmp_path}/plant.db"
    site, log = Site(f"http://127.0.0.1:{port}", f"http://127.0.0.1:{hands}"), tmp_path / "demo.log"
    roles = ("--role", "operator", "--role", "maintenance")
    made = ("users", "add", "kim", *roles, "--database", database, "--password-stdin")
    subprocess.run([*COMMAND, *made], input=PASSWORD, text=True, check=True, capture_output=True, timeout=GENEROUS)
    at = ("--plant", str(file), "--port", str(port), "--operator", str(hands), "--database", database)
    with running("demo", *at, log=log):
        wait_until(lambda: answers(site.url), "the server", log)
        yield site
    assert "Traceback" not in log.read_text(encoding="utf-8")


def test_an_operators_shift(page: Page, plant: Site) -> None:
    complaints, asked = [], []
    page.goto(plant.url)
    log_in(page, "kim")
    expect(page.locator(".link.live")).to_be_visible()
    # From here on: until somebody has logged in, the browser says of each refusal that it was one.
    page.on("console", lambda said: complaints.append(said.text) if said.type in {"error", "warning"} else None)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))
    for vehicle in ("V001", "V002"):
        expect(page.locator(".chip", has_text=vehicle)).to_contain_text(re.compile("idle|parked"))

    transfer(page, "P1", "B2")
    follow(page)
    close_a_rail_and_read_why(page)
    recover_an_alarm(page, plant.hands)
    teach_and_approve(page)
    play_back(page)

    assert complaints == []
    assert {urlsplit(url).netloc for url in asked if not url.startswith("blob:")} == {urlsplit(plant.url).netloc}


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
    expect(panel.locator(".phases span")).to_have_count(5)
    expect(
        panel.get_by_text(re.compile("queued .* fetching .* picking up .* carrying .* putting down"))
    ).to_be_visible()


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
    press_twice(closure, "Open")
    expect(closure).to_have_count(0)
    expect(job.locator(".state")).to_have_text("completed")


def choose(page: Page, vehicle: str) -> Locator:
    """Choose a vehicle on the map's strip, and open what can be asked of it; return its panel."""
    room(page, "Map")
    chip = page.locator(".chip", has_text=vehicle)
    if chip.get_attribute("aria-pressed") != "true":
        chip.click()
    panel = page.locator(".panel", has=page.locator("h2", has_text=vehicle))
    panel.locator("details.acts", has_text="Commands").evaluate("(box) => { box.open = true; }")
    return panel


def recover_an_alarm(page: Page, hands: str) -> None:
    """A hoist has an alarm: say that one knows of it, look what helps, recover it, and see that it works again."""
    # Not on its way: a hoist that stops somewhere with an alarm may be held besides, until a person has looked.
    room(page, "Map")
    expect(page.locator(".chip", has_text="V002")).to_contain_text("idle")
    HTTP.post(f"{hands}/hoists/V002/alarm", json={"alarm": 105}).raise_for_status()
    room(page, "Alarms")
    alarm = page.locator('[data-alarm="vehicle V002"]')
    expect(alarm).to_contain_text("105")
    alarm.get_by_label("Note").fill("I am on my way")
    alarm.get_by_role("button", name="Acknowledge").click()
    expect(alarm).to_contain_text(re.compile("kim .* I am on my way"))
    panel = choose(page, "V002")
    expect(panel.locator("h2")).to_contain_text("held")
    expect(panel.locator(".note", has_text="alarm 105").first).to_be_visible()
    press_twice(panel, "Recover from the alarm")
    expect(page.locator(".chip", has_text="V002")).to_contain_text(re.compile("idle|parked|moving"))
    room(page, "Alarms")
    expect(alarm).to_have_count(0)


def teach_and_approve(page: Page) -> None:
    """Teach the port that was never taught, approve it, and send a carrier there."""
    room(page, "Teaching")
    teaching = page.get_by_role("region", name="Teaching")
    teaching.get_by_role("button", name="Sessions").click()
    teaching.locator("input[name=station]").fill("P2")
    teaching.locator("input[name=vehicle]").fill("V001")
    teaching.get_by_role("button", name="Open a session").click()
    expect(teaching.locator("[data-session]")).to_contain_text("106")
    panel = choose(page, "V001")
    panel.get_by_label("Move to barcode").fill("106")
    panel.get_by_label("Stops for").select_option("port")
    press_twice(panel, "Move")
    expect(panel.locator("dt:text-is('Place') + dd")).to_have_text("106")
    expect(panel.locator("h2")).to_contain_text("idle")
    press_twice(panel.locator("[data-commands]"), "Stop (to MANT)")
    expect(panel.locator("dt:text-is('Mode') + dd")).to_contain_text("MANT")
    room(page, "Teaching")
    teaching.get_by_role("button", name="Sessions").click()
    teaching.locator("tbody td").first.click()
    teaching.locator("[data-session]").get_by_role("button", name="Teach DEST").click()
    teaching.get_by_role("button", name="Proposals").click()
    proposal = teaching.locator("[data-proposal]")
    expect(proposal).to_contain_text("P2")
    press_twice(proposal, "Approve")
    expect(proposal).to_contain_text(re.compile("approved.*kim"))
    teaching.get_by_role("button", name="Sessions").click()
    teaching.locator("tbody td").first.click()
    teaching.get_by_role("button", name="Close the session").click()
    expect(teaching.locator("[data-session]")).to_contain_text("closed")
    order(page, "P3", "P2")
    expect(page.locator(".jobs .job").first.locator(".state")).to_have_text("completed")


def play_back(page: Page) -> None:
    """Look at all that again: what happened is listed, the alarm is where it was, and one click leads back."""
    room(page, "Playback")
    listed = page.locator(".past-events li")
    for words in ("Place closed", "Place opened", "Alarm set", "Alarm cleared", "Teaching approved"):
        expect(listed.filter(has_text=words).first).to_be_visible()
    listed.filter(has_text=re.compile("Alarm set V002")).get_by_role("button").click()
    mode = page.locator(".panel dt:text-is('Mode') + dd")
    page.get_by_role("button", name="Play", exact=True).click()
    expect(mode).to_contain_text("ALARM · 0x0069")
    page.locator(".play").click()
    listed.filter(has_text="Place closed").get_by_role("button").last.click()
    expect(page.locator(".panel h2")).to_contain_text("V002")
    expect(mode).not_to_contain_text("ALARM")
    page.get_by_role("button", name="Back to live").click()
    expect(page.locator(".link.live")).to_be_visible()


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
