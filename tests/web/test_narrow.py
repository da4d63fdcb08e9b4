"""The page on a small screen: nothing is squeezed letter by letter, and no button lies outside its box."""

from collections.abc import Iterator
from dataclasses import replace

import pytest
from playwright.sync_api import Browser, expect

from app.domain.ids import Actor, CarrierId, JobId, StationId
from app.domain.requests import CreateJob
from app.domain.view import JobView, Topic, Update
from tests.web.served import Served
from tests.web.staffed import Staffed, staffed
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]
ROOMS = ("vehicles", "jobs", "alarms", "stations", "walks", "teaching", "layouts", "access", "audit", "webhooks")
SQUEEZED = """() => {
  const found = [];
  const letters = document.createElement('canvas').getContext('2d');
  for (const cell of document.querySelectorAll('table.list td, table.list button')) {
    const box = cell.getBoundingClientRect();
    if (!box.width) continue;
    const look = getComputedStyle(cell);
    letters.font = `${look.fontWeight} ${look.fontSize} ${look.fontFamily}`;
    const room = cell.clientWidth - parseFloat(look.paddingLeft) - parseFloat(look.paddingRight);
    for (const word of cell.innerText.split(/\\s+/)) {
      if (word.length < 24 && letters.measureText(word).width > room + 2) found.push(`${word} in ${Math.round(room)}`);
    }
  }
  for (const button of document.querySelectorAll('button, input, select')) {
    const box = button.getBoundingClientRect();
    const around = button.closest('.head, form, .filters');
    if (!around || !box.width) continue;
    const limit = around.getBoundingClientRect();
    const outside = box.right > limit.right + 1 || box.left < limit.left - 1;
    if (outside) found.push(`${button.textContent || button.ariaLabel} lies outside`);
  }
  return found;
}"""
"""Words that are wider than the cell or button they stand in, and what lies outside its box."""


@pytest.fixture(scope="module")
def plant(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Staffed]:
    with staffed(chromium, tmp_path_factory.mktemp("narrow")) as plant:
        fill(plant.server)
        yield plant


def fill(server: Served) -> None:
    """Let there be a job that waits for a long reason, and things to read in every room."""
    controller = server.controller
    order = CreateJob(Actor("kim"), JobId("MES-2026-000017"), "P1", StationId("P2"), CarrierId("FOUP0001"), 50, "x")
    server.wait(controller.ask(order))
    job = controller.model.get(Topic.JOBS, "MES-2026-000017")
    assert isinstance(job, JobView)
    waits = replace(job, vehicle="V001", state="waiting", reason="V001 waits at 1001 for 1002 held by V002")
    server.show([Update(Topic.JOBS, job.id, waits)])
    server.place("V001", "1001", activity="waiting", job=job.id, waiting=waits.reason)
    server.do(controller.alarm)


@pytest.mark.parametrize("language", ["en", "ko"])
@pytest.mark.parametrize(("width", "height"), [(1024, 768), (1280, 800)])
def test_no_word_is_broken_and_no_button_lies_outside(plant: Staffed, language: str, width: int, height: int) -> None:
    with plant.at_work("kim", language=language) as page:
        page.set_viewport_size({"width": width, "height": height})
        for room in ROOMS:
            page.evaluate("room => { location.hash = '#/' + room }", room)
            expect(page.locator(".room, .left > *").first).to_be_visible()
            page.wait_for_load_state("networkidle")
            assert page.evaluate(SQUEEZED) == [], room


@pytest.mark.parametrize(("width", "height"), [(1024, 768), (800, 600)])
def test_a_transfer_is_ordered_in_any_room_of_a_narrow_screen(plant: Staffed, width: int, height: int) -> None:
    with plant.at_work("kim", "alarms") as page:
        page.set_viewport_size({"width": width, "height": height})
        opener = page.get_by_role("button", name="New transfer")
        form = page.locator("form.transfer")
        expect(form).to_be_hidden()
        opener.click()
        expect(form.locator("select").first).to_be_focused()
        form.locator("select").first.select_option("P1")
        form.locator("select").last.select_option("P2")
        form.get_by_role("button", name="Order", exact=True).click()
        expect(form.locator(".outcome .problem, .outcome .done:not(:empty)")).to_be_in_viewport()
        page.keyboard.press("Escape")
        expect(form).to_be_hidden()
        expect(opener).to_be_focused()
        assert opener.get_attribute("aria-expanded") == "false"
        opener.click()
        page.get_by_role("button", name="Jobs", exact=True).click()
        expect(form).to_be_hidden()
        for name in page.locator("nav.rooms button").all():
            expect(name).to_be_in_viewport(ratio=1)


@pytest.mark.parametrize("language", ["en", "ko"])
def test_whether_what_is_shown_is_live_is_seen_on_the_narrowest_screen(plant: Staffed, language: str) -> None:
    with plant.at_work("kim", language=language) as page:
        page.set_viewport_size({"width": 800, "height": 600})
        expect(page.locator("header .link")).to_be_in_viewport(ratio=1)
        for button in page.locator("header button:visible, .map-tools button:visible").all():
            expect(button).to_be_in_viewport(ratio=1)


def test_the_form_has_its_place_beside_the_table_where_there_is_room(plant: Staffed) -> None:
    with plant.at_work("kim", "alarms") as page:
        expect(page.locator("form.transfer")).to_be_visible()
        expect(page.get_by_role("button", name="New transfer")).to_be_hidden()
