"""A controller that has not answered yet, or does not answer any more, is never shown as an empty plant."""

import re

import pytest
from playwright.sync_api import Page, Route, expect

from tests.web.served import served
from tests.web.whole import whole
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]

ROOMS = (
    "map",
    "vehicles",
    "jobs",
    "alarms",
    "closures",
    "stations",
    "walks",
    "teaching",
    "statistics",
    "playback",
    "layouts",
    "audit",
)
NEVER = re.compile(r"Nothing is known|choose|Choose|Nothing is known of that moment")
UNKNOWN = re.compile(r"Not known since|Nothing is known|choose|Choose|Nothing is known of that moment")


def claims(page: Page, room: str) -> list[str]:
    """Return what the lists of a room say where they are empty."""
    page.evaluate("room => { location.hash = '#/' + room }", room)
    expect(page.locator("nav.rooms [aria-current=page]")).to_have_count(1)
    return page.locator(".nothing").all_text_contents()


def no_counts(page: Page) -> list[str]:
    """Return the counts that are told: of nothing known there is none."""
    told = page.locator(".counts b, .room .head h2, .closing h2.sub").all_text_contents()
    return [words for words in told if re.search(r"\d", words)]


def test_a_page_whose_server_never_answered_knows_nothing_and_goes_on_by_itself(page: Page) -> None:
    def dead(route: Route) -> None:
        route.abort("connectionrefused")

    with served(controller=whole()) as server:
        page.route("**/api/v1/**", dead)
        page.goto(server.url)
        expect(page.locator("[data-away=never]")).to_contain_text("has not answered yet")
        for room in ROOMS:
            said = claims(page, room)
            assert said, room
            assert all(NEVER.search(words) for words in said), (room, said)
            assert no_counts(page) == [], room
            assert "1970" not in page.inner_text("body"), room
        page.unroute("**/api/v1/**")
        expect(page.locator("[data-away]")).to_have_count(0)
        page.evaluate("location.hash = '#/vehicles'")
        expect(page.locator("tr[data-row=V001]")).to_be_visible()


def test_what_a_killed_server_told_stays_marked_as_old_and_is_live_again_when_it_is_back(page: Page) -> None:
    with served(controller=whole()) as first:
        port = first.port
        page.goto(first.url)
        expect(page.locator(".link.live")).to_be_visible()
        expect(page.locator(".chip", has_text="V001")).to_be_visible()
    expect(page.locator("[data-away=since]")).to_contain_text(
        re.compile(r"does not answer since \d\d:\d\d:\d\d \(\d+ s ago\)")
    )
    expect(page.locator("header .pill")).to_contain_text(re.compile(r"\d\d:\d\d:\d\d"))
    expect(page.locator(".page.old .chip", has_text="V001")).to_be_visible()
    for room in ROOMS:
        said = claims(page, room)
        assert all(UNKNOWN.search(words) for words in said), (room, said)
        assert "1970" not in page.inner_text("body"), room
    page.evaluate("location.hash = '#/walks'")
    expect(page.locator(".room .nothing").first).to_contain_text("Not known since")
    with served(port, controller=whole()):
        expect(page.locator("[data-away]")).to_have_count(0)
        expect(page.locator(".page.old")).to_have_count(0)
        expect(page.locator(".room .nothing").first).to_contain_text("No walk")
