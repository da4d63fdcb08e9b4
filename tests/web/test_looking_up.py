"""What people look up on the page without changing anything: a model's catalogue, backups, what failed, figures of a period."""

import time
from collections.abc import Iterator
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import Browser, expect

from app.domain.alarms import Alarm, AlarmKind
from app.domain.units import Timestamp
from tests.api.scripted import NOW
from tests.e2e.processes import wait_until
from tests.web.hands import press_twice
from tests.web.looks import faults
from tests.web.staffed import Staffed, staffed
from tests.web.test_panels import opened
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]


@pytest.fixture(scope="module")
def plant(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Staffed]:
    with staffed(chromium, tmp_path_factory.mktemp("looking-up")) as plant:
        yield plant


def test_a_drives_model_and_what_its_backups_have_can_be_read(plant: Staffed) -> None:
    plant.server.controller.drives.keep_backup()
    with plant.at_work("vic", "map?drive=D1") as page:
        panel = page.locator(".panel")
        catalogue = opened(panel, "Catalogue of the model")
        acceleration = catalogue.locator("[data-spec='1C']")
        expect(acceleration).to_contain_text("Acceleration")
        expect(acceleration).to_contain_text("0.1 … 60 s")
        expect(catalogue.locator("[data-spec='1D']")).to_contain_text("0: CW, 1: CCW")
        kept = opened(panel, "Backups and comparison").locator("[data-backup='1']")
        kept.locator("summary").click()
        assert faults(page) == []
        expect(kept.locator("tr", has_text="1C")).to_contain_text("Acceleration")


def test_how_vehicles_held_out_leads_to_what_failed(plant: Staffed, monkeypatch: pytest.MonkeyPatch) -> None:
    controller = plant.server.controller
    monkeypatch.setattr(controller, "utc", lambda: Timestamp(time.time()))  # the page asks by its own clock
    wrong = controller.reader.wrong
    for number, source in ((1, "V001"), (2, "V002")):
        begun, ended = Timestamp(NOW - 3600), Timestamp(NOW - 1800)
        wrong[number] = Alarm(number, AlarmKind.VEHICLE, source, "101", "bumper", "look", begun, ended=ended)
    with plant.at_work("vic", "alarms") as page:
        page.get_by_role("button", name="Reliability").click()
        row = page.locator("[data-row=V001]")
        expect(row).to_contain_text("168.00")
        assert faults(page) == []
        row.get_by_role("button", name="History").click()
        expect(page.get_by_label("Name", exact=True)).to_have_value("V001")
        expect(page.locator("[data-row='1']")).to_contain_text("bumper")
        reader = plant.server.controller.reader
        wait_until(lambda: reader.asked_for.get("source") == "V001", "the request")


def test_a_period_of_ones_own_is_reckoned_saved_in_the_form_wanted_and_printed(plant: Staffed) -> None:
    with plant.at_work("vic", "statistics") as page:
        page.get_by_role("button", name="Other", exact=True).click()
        report = page.get_by_role("button", name="Report", exact=False).first
        expect(report).to_be_disabled()
        assert faults(page) == []
        page.locator("input[name=begin]").fill("2026-01-01T06:00")
        with page.expect_response(lambda answer: "/statistics?" in answer.url) as reckoned:
            page.locator("input[name=end]").fill("2026-01-01T14:00")
        assert "interval=480" in reckoned.value.url
        assert reckoned.value.status == 200
        expect(page.locator("[data-row=P2]")).to_contain_text("… is occupied by …")
        expect(page.locator("[data-row='LOT-9']")).to_contain_text("no vehicle is free")
        assert faults(page) == []
        with page.expect_download() as saving:
            page.get_by_role("button", name="Vehicles ⤓").click()
        assert saving.value.suggested_filename == "vehicles.csv"
        printed = page.expect_request(lambda asked: "/statistics/report?" in asked.url)
        with printed as asked, page.expect_popup() as opening:
            page.get_by_role("button", name="Print", exact=True).click()
        zone = page.evaluate("Intl.DateTimeFormat().resolvedOptions().timeZone")
        assert parse_qs(urlsplit(asked.value.url).query)["tz"] == [zone]
        expect(opening.value.locator("h1")).to_be_visible()
        page.get_by_label("Files as").select_option("parquet")
        with page.expect_response(lambda answer: "vehicles.parquet" in answer.url):
            page.get_by_role("button", name="Vehicles ⤓").click()


def test_values_in_force_stand_where_they_are_saved_to_files(plant: Staffed) -> None:
    with plant.at_work("mia", "map?station=P2") as page:
        taught = opened(page.locator(".panel"), "DEST")
        opened(taught, "Write by hand")
        for axis, value in (("SHFT", "11"), ("ROTA", "-21"), ("LIFT", "31")):
            taught.get_by_label(axis, exact=True).fill(value)
        press_twice(taught, "Write")
        expect(taught.locator("[data-version='1']")).to_contain_text("-21")
        page.goto(f"{plant.server.url}#/teaching")
        page.get_by_role("button", name="Files", exact=True).click()
        expect(page.locator("[data-row=P2]")).to_contain_text("-21")
        expect(page.locator("[data-row=P2]")).to_contain_text("mia")
        assert faults(page) == []
