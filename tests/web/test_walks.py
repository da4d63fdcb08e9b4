"""Audit walks at the page: begun, entered at a place and from a file, compared, taken for true."""

from collections.abc import Iterator
from pathlib import Path
from typing import TypeVar

import pytest
from playwright.sync_api import Browser, expect

from app.domain.ids import Actor, CarrierId, StationId
from app.domain.walks import AbandonWalk, AcceptWalk, EnterSights, Sight, StartWalk
from tests.e2e.processes import wait_until
from tests.web.hands import press_twice
from tests.web.staffed import Staffed, staffed
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]


@pytest.fixture(scope="module")
def plant(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Staffed]:
    with staffed(chromium, tmp_path_factory.mktemp("walks")) as plant:
        yield plant


T = TypeVar("T")
LEE = Actor("lee")


def asked(plant: Staffed, kind: type[T]) -> list[T]:
    return [request for request in plant.server.controller.seen if isinstance(request, kind)]


def test_a_walk_is_begun_entered_at_a_place_and_from_a_file_and_taken_for_true(plant: Staffed, tmp_path: Path) -> None:
    with plant.at_work("lee", "walks") as page:
        form = page.get_by_role("form", name="Begin a walk")
        form.get_by_label("Reason").fill("after the outage")
        form.get_by_role("button", name="Begin a walk").click()
        walk = page.locator("[data-walk='1']")
        place = walk.locator("[data-row=L3]")
        expect(place).to_contain_text("not seen")
        expect(walk).to_contain_text("1 places were not seen")
        place.get_by_role("button", name="Empty").click()
        expect(walk.get_by_role("button", name="Empty")).to_have_attribute("aria-pressed", "true")
        with page.expect_download() as saved:
            walk.get_by_role("button", name="Save as CSV").click()
        lines = Path(saved.value.path()).read_text(encoding="utf-8-sig").splitlines()
        assert lines[0].startswith("station,expected,expected_carrier,seen,seen_carrier,finding")
        assert lines[1].startswith("L3,,,empty,,")
        file = tmp_path / "walk.csv"
        file.write_text("station,seen\nL3,perhaps\n", encoding="utf-8")
        walk.get_by_label("Read a CSV").set_input_files(file)
        expect(walk.locator(".problem")).to_contain_text("Line 2: seen is full, empty, or nothing")
        place.get_by_label("Carrier L3").fill("F8")
        place.get_by_role("button", name="Empty").click()
        wait_until(lambda: len(asked(plant, EnterSights)) == 2, "the entry")
        file.write_text("station,seen,seen_carrier\nL3,empty,F9\n", encoding="utf-8")
        walk.get_by_label("Read a CSV").set_input_files(file)
        wait_until(lambda: len(asked(plant, EnterSights)) == 3, "the file")
        file.write_text("Station;Seen;Seen_Carrier\r\nL3;Full;F7\r\nP1;;\r\n", encoding="utf-8")
        walk.get_by_label("Read a CSV").set_input_files(file)
        expect(walk.locator(".done").first).to_contain_text("1 places entered from the file")
        press_twice(walk, "Take it for true")
        expect(walk).to_contain_text("accepted")
    assert asked(plant, StartWalk) == [StartWalk(LEE, "after the outage", ())]
    assert [request.sights for request in asked(plant, EnterSights)] == [
        (Sight(StationId("L3"), present=False),),
        (Sight(StationId("L3"), present=False, carrier=CarrierId("F8")),),  # the controller refuses both
        (Sight(StationId("L3"), present=False, carrier=CarrierId("F9")),),
        (Sight(StationId("L3"), present=True, carrier=CarrierId("F7")),),
    ]
    assert asked(plant, AcceptWalk) == [AcceptWalk(LEE, 1)]


def test_a_walk_is_given_up_with_a_reason_by_those_who_may(plant: Staffed) -> None:
    with plant.at_work("mia", "walks") as page:
        begin = page.get_by_role("form", name="Begin a walk").get_by_role("button", name="Begin a walk")
        expect(begin).to_have_attribute("aria-disabled", "true")
    with plant.at_work("lee", "walks") as page:
        form = page.get_by_role("form", name="Begin a walk")
        form.get_by_label("Reason").fill("spot check")
        form.get_by_label("Stations").fill("L3, P1")
        form.get_by_role("button", name="Begin a walk").click()
        walk = page.locator("[data-walk='1']")
        expect(walk).to_contain_text("spot check")
        walk.get_by_label("Reason").fill("nobody had time")
        press_twice(walk, "Abandon")
        expect(walk).to_contain_text("abandoned")
    assert asked(plant, StartWalk)[-1] == StartWalk(LEE, "spot check", (StationId("L3"), StationId("P1")))
    assert asked(plant, AbandonWalk) == [AbandonWalk(LEE, 1, "nobody had time")]
