"""Alarms of one cause are one row, acknowledged and released at once; counts say the same everywhere."""

from dataclasses import replace

import pytest
from playwright.sync_api import Page, expect

from app.domain.alarms import AcknowledgeAlarm, Alarm, AlarmKind
from app.domain.errors import Refusal
from app.domain.requests import ReleaseVehicle, Reply, Request
from app.domain.view import ControllerView, HoldView, LockoutView, Topic, Update, VehicleView
from app.fleet.views import view_of_alarm
from tests.api.scripted import NOW, Scripted
from tests.web.hands import press_twice
from tests.web.looks import faults
from tests.web.served import Served, served
from tests.web.whole import whole
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]
HOISTS = tuple(f"V{number:03}" for number in range(1, 11))
DOUBT = "it is not known what became of its last command"


def wrong(server: Served, *alarms: Alarm) -> None:
    """Let there be these alarms."""
    server.controller.reader.wrong |= {alarm.number: alarm for alarm in alarms}
    server.show([Update(Topic.ALARMS, str(alarm.number), view_of_alarm(alarm)) for alarm in alarms])


def change(server: Served, vehicle: str, **more: object) -> None:
    """Let a vehicle look otherwise."""
    now = server.controller.model.get(Topic.VEHICLES, vehicle)
    assert isinstance(now, VehicleView)
    server.show([Update(Topic.VEHICLES, vehicle, replace(now, **more))])  # type: ignore[arg-type]


def enter(page: Page, server: Served, room: str = "alarms") -> None:
    page.goto(f"{server.url}#/{room}")
    expect(page.locator(".link.live")).to_be_visible()
    page.get_by_label("Your name").first.fill("kim")


def test_hoists_that_lost_one_line_are_one_row_acknowledged_with_one_note(page: Page) -> None:
    silent = [
        Alarm(
            n,
            AlarmKind.LINK,
            hoist,
            "silent",
            f"not connected: no answer of 10.0.0.{n}",
            "look at its line and power",
            NOW,
        )
        for n, hoist in enumerate(HOISTS, 1)
    ]
    with served(controller=whole()) as server:
        wrong(server, *silent, Alarm(90, AlarmKind.VEHICLE, "V003", "101", "bumper", "look", NOW))
        enter(page, server)
        row = page.locator("[data-group=link]")
        expect(row).to_have_attribute("data-count", "10")
        expect(row).to_contain_text("10 × not connected: no answer of –")
        expect(row.locator(".names")).to_contain_text("V010")
        expect(page.locator("ul.alarms > li")).to_have_count(2)
        row.locator("summary").click()
        expect(row.locator("[data-alarm]")).to_have_count(10)
        assert faults(page) == []
        row.get_by_label("Note, or the reason of a release").fill("the switch of bay 1")
        row.get_by_role("button", name="Acknowledge all 10").click()
        expect(row.locator("[data-outcomes]")).to_have_text("10 of 10 done")
        expect(row).to_contain_text("All acknowledged")
        asked = [one for one in server.controller.seen if isinstance(one, AcknowledgeAlarm)]
        assert {(one.alarm, one.note, one.actor) for one in asked} == {
            (n, "the switch of bay 1", "kim") for n in range(1, 11)
        }


class Wary(Scripted):
    """Refuses to release one of those that are held."""

    def _reply(self, request: Request) -> Reply:
        if isinstance(request, ReleaseVehicle) and request.vehicle == "V002":
            return Refusal("not-now", "V002 still has an alarm", "recover it", "verdict")
        return super()._reply(request)


def test_vehicles_held_for_one_cause_are_released_together_and_each_is_answered(page: Page) -> None:
    with served(controller=whole(Wary)) as server:
        hold = HoldView(DOUBT, "look where it stands, then release it with verdict go_on", NOW)
        for n, hoist in enumerate(HOISTS[:4], 1):
            change(server, hoist, hold=hold, activity="held")
            wrong(server, Alarm(n, AlarmKind.HOLD, hoist, "held", DOUBT, hold.remedy, NOW))
        change(server, "V004", oper="alarm")
        wrong(
            server,
            Alarm(5, AlarmKind.HOLD, "V005", "held", "it stands at 1234, which it cannot have reached", "look", NOW),
        )
        enter(page, server)
        row = page.locator("[data-group=hold]")
        expect(row).to_have_attribute("data-count", "4")
        row.get_by_label("Note, or the reason of a release").fill("looked at them all")
        press_twice(row, "Release 3 vehicles: their reports are right")
        expect(row.locator("[data-outcomes]")).to_contain_text("2 of 3 done")
        expect(row.locator("[data-outcomes]")).to_contain_text("V002: V002 still has an alarm")
        asked = [one for one in server.controller.seen if isinstance(one, ReleaseVehicle)]
        assert [(one.vehicle, one.reason) for one in asked] == [(hoist, "looked at them all") for hoist in HOISTS[:3]]


def test_bar_title_and_playback_count_the_same_alarms_and_say_what_they_count(page: Page) -> None:
    with served(controller=whole()) as server:
        wrong(server, Alarm(1, AlarmKind.LINK, "V001", "silent", "not connected: off", "look", NOW))
        wrong(server, Alarm(2, AlarmKind.TRAFFIC, "V002", "circle", "V002, V003 wait for each other", "look", NOW))
        change(server, "V004", lockout=LockoutView("lee", "a wheel", NOW))
        (now,) = server.controller.model.all(Topic.CONTROLLER)
        assert isinstance(now, ControllerView)
        circle = replace(now, circles=("V002, V003 wait for each other",), trouble="the database does not answer")
        kept = replace(circle, kept_off=("1002: a", "1003, 1004: b"), closed_places=3)
        server.show([Update(Topic.CONTROLLER, "controller", kept)])
        enter(page, server)
        expect(page.locator("nav.rooms .badge")).to_have_text("! 3")
        expect(page.locator("nav.rooms .badge")).to_have_attribute(
            "title", "Alarms there are now, one for each machine and code; not acknowledged yet: 2"
        )
        expect(page.locator(".room .head h2")).to_have_text("Alarms 3")
        expect(page.locator("ul.alarms > li[data-alarm]")).to_have_count(4)
        expect(page.locator("ul.alarms > li.sub")).to_have_text("No alarms, but kept back or not heard: 1")
        head = page.locator("header .kept")
        expect(head).to_have_text("Routes keep off 2")
        head.click()
        listed = page.locator("h2.sub", has_text="Routes keep off")
        expect(listed).to_have_text("Routes keep off 2")
        title = (
            "Reasons for which routes keep off something, closures by people among them: 2, about 3 places of the track"
        )
        expect(listed).to_have_attribute("title", title)
        assert (head.get_attribute("title") or "").splitlines()[0] == title
        expect(page.locator("h2.sub", has_text="Closures by people")).to_have_text("Closures by people 0")
        page.evaluate("location.hash = '#/playback'")
        expect(page.locator(".past-banner .bad")).to_have_text("! 3 alarms now")
