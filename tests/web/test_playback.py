"""Playback on the page: the past is shown as the past, cannot be commanded, and is left by one click; and a recorded incident."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import Page, expect

from app.domain.units import Timestamp
from app.runtime.incident import Incident
from app.runtime.recorded import Recorded
from app.runtime.recording import packed
from app.store.playback import CHANGES, Piece, PlaybackStore
from tests.api.recordings import HEAT, STATE_AT_START, recorded
from tests.api.scripted import NOW, PLANT, Scripted
from tests.web.served import Served, served
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]
AT = "2025-12-31T23:59:"


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Served]:
    """V001 is live at 1001; of the minute before midnight, when it drove to 1003, there is a recording."""
    controller = Scripted()
    controller.playback = recorded(tmp_path)
    with served(controller=controller) as serving:
        yield serving


@pytest.fixture
def complaints(page: Page) -> list[str]:
    """What the page says on the console, or throws."""
    found: list[str] = []
    page.on("console", lambda said: found.append(said.text) if said.type in {"error", "warning"} else None)
    page.on("pageerror", lambda error: found.append(str(error)))
    return found


def place(page: Page) -> Any:
    """Where the chosen vehicle is, by its panel."""
    return page.locator(".panel dt:text-is('Place') + dd")


def test_heat_of_the_past_is_that_of_the_hours_before_the_moment(
    page: Page, server: Served, complaints: list[str]
) -> None:
    page.goto(f"{server.url}#/playback?at={AT}15Z")
    expect(page.locator(".past-banner")).to_contain_text("THE PAST")
    page.get_by_role("button", name="Layers").click()
    with page.expect_response(lambda answer: "/history/heat" in answer.url) as an_hour:
        page.get_by_label("Traffic", exact=True).check()
    assert an_hour.value.json()["traffic"] == HEAT["traffic"]
    with page.expect_response(lambda answer: "/history/heat" in answer.url) as a_shift:
        page.get_by_label("counted over").select_option("8")
    asked = parse_qs(urlsplit(a_shift.value.url).query)
    assert asked == {"from": ["2025-12-31T16:00:00.000Z"], "to": ["2026-01-01T00:00:00.000Z"]}
    expect(page.locator(".heat-key")).to_contain_text("Traffic")
    assert complaints == []


def test_a_link_to_a_moment_shows_what_was_then_and_one_click_what_is(
    page: Page, server: Served, complaints: list[str]
) -> None:
    page.goto(f"{server.url}#/playback?vehicle=V001&at={AT}05Z")
    expect(page.locator(".past-banner")).to_contain_text("THE PAST")
    expect(place(page)).to_have_text("1001")
    expect(page.locator(".jobs .job")).to_have_count(0)
    page.goto(f"{server.url}#/playback?vehicle=V001&at={AT}15Z")
    expect(place(page)).to_have_text("1002")
    expect(page.locator(".jobs .job")).to_contain_text("J1")
    for name in ("Order", "Cancel", "Hold", "Stop all", "Pause"):
        expect(
            page.locator("main, header").get_by_role("button", name=name, exact=True).and_(page.locator(":not(.play)"))
        ).to_have_count(0)
    server.place("V001", "1003", activity="idle")
    expect(place(page)).to_have_text("1002")
    page.get_by_role("button", name="Back to live").click()
    expect(page.locator(".past-banner")).to_have_count(0)
    expect(page.locator(".link.live")).to_be_visible()
    expect(place(page)).to_contain_text("1003")
    expect(page.get_by_role("button", name="Order", exact=True)).to_be_visible()
    assert "at=" not in page.url
    assert complaints == []


def test_who_was_held_is_seen_to_have_been_held_and_why(page: Page, tmp_path: Path, complaints: list[str]) -> None:
    held = {"reason": "V001 has a carrier and no job", "remedy": "look at it", "since": "2025-12-31T23:59:10.000Z"}
    drive = {"id": "X", "name": "X axis", "line": "L1", "address": 1, "online": True, "mode": "error", "code": 3}
    hot = {**drive, "meaning": "overheated", "error": "overheated", "remedy": "let it cool", "moving": False}
    changes = [
        (NOW - 50, "vehicles", "V001", {"activity": "held", "hold": held}),
        (NOW - 50, "drives", "X", {**hot, "lockout": None, "reason": ""}),
    ]
    replayed: Any = Recorded(Incident(PLANT, NOW - 60, NOW, NOW, "kim", STATE_AT_START, changes, []), tmp_path)
    with served(controller=replayed) as server:
        page.goto(f"{server.url}#/playback?vehicle=V001&at={AT}05Z")
        expect(place(page)).to_have_text("1001")
        expect(page.locator(".panel .note")).to_have_count(0)
        page.goto(f"{server.url}#/playback?vehicle=V001&at={AT}15Z")
        expect(page.locator(".panel .note.held")).to_contain_text("V001 has a carrier and no job look at it")
        page.goto(f"{server.url}#/playback?drive=X&at={AT}15Z")
        expect(page.locator(".panel .note.alarm")).to_contain_text("overheated let it cool")
    replayed.close()
    assert complaints == []


def test_the_past_is_played_to_its_end_and_scrubbed_by_key(page: Page, server: Served, complaints: list[str]) -> None:
    page.goto(f"{server.url}#/playback?vehicle=V001&at={AT}05Z")
    expect(place(page)).to_have_text("1001")
    page.get_by_role("button", name="×16").click()
    page.get_by_role("button", name="Play", exact=True).click()
    expect(place(page)).to_have_text("1003")
    expect(page.get_by_role("button", name="Play", exact=True)).to_be_visible()
    page.wait_for_function("at => location.hash.includes(at)", arg=f"at={AT}21")
    slider = page.get_by_role("slider", name="Moment")
    slider.focus()
    page.keyboard.press("Home")
    expect(place(page)).to_have_text("1001")
    page.keyboard.press("ArrowRight")
    expect(place(page)).to_have_text("1001")
    assert complaints == []


def test_steps_lead_from_event_to_event_and_what_happened_is_listed(
    page: Page, server: Served, complaints: list[str]
) -> None:
    moments = {"AlarmSet": NOW - 45, "AlarmCleared": NOW - 39.5}
    for event, at in moments.items():
        server.do(happens(server.controller, event, at))
    page.goto(f"{server.url}#/playback?at={AT}05Z")
    listed = page.locator(".past-events li")
    expect(listed).to_have_count(2)
    expect(listed.first).to_contain_text("Alarm cleared")
    page.get_by_role("button", name="Next event").click()
    expect(page.locator(".past-events [aria-current]")).to_contain_text("Alarm set")
    page.wait_for_function("at => location.hash.includes(at)", arg=f"at={AT}15.5")
    page.keyboard.press(".")
    expect(page.locator(".past-events [aria-current]")).to_contain_text("Alarm cleared")
    page.keyboard.press(",")
    expect(page.locator(".past-events [aria-current]")).to_contain_text("Alarm set")
    listed.first.get_by_role("button").click()
    expect(page.locator(".panel h2")).to_contain_text("V001")
    expect(place(page)).to_have_text("1003")
    assert complaints == []


def happens(controller: Scripted, event: str, at: float) -> Callable[[], object]:
    """Let something have happened at a moment."""

    def happen() -> None:
        controller.happen(event, vehicle="V001", at=Timestamp(at))

    return happen


def test_an_incident_is_saved_as_one_file(page: Page, server: Served, complaints: list[str]) -> None:
    page.goto(f"{server.url}#/playback?at={AT}05Z")
    with page.expect_download() as saving:
        page.get_by_role("button", name="Export as a file").click()
    assert saving.value.suggested_filename == "incident-2025-12-31T235900Z.hoistway.gz"
    expect(page.locator(".export .done")).to_contain_text("Saved as incident-")
    assert complaints == []


def test_a_replayed_incident_has_the_past_alone(page: Page, tmp_path: Path, complaints: list[str]) -> None:
    changes = [(NOW - 50, "vehicles", "V001", {"barcode": "1002", "activity": "moving"})]
    incident = Incident(PLANT, NOW - 60, NOW, NOW, "kim", STATE_AT_START, changes, [])
    replayed: Any = Recorded(incident, tmp_path)
    with served(controller=replayed) as server:
        page.goto(f"{server.url}#/map?vehicle=V001")
        expect(page.locator(".past-banner")).to_contain_text("A RECORDED INCIDENT")
        expect(page.locator(".past-banner")).to_contain_text("kim")
        expect(place(page)).to_have_text("1001")
        expect(page.get_by_role("navigation", name="Rooms").get_by_role("button")).to_have_text(["Playback"])
        expect(page.get_by_role("button", name="Back to live")).to_have_count(0)
    replayed.close()
    assert complaints == []


def test_what_is_recorded_while_somebody_looks_back_can_be_reached(page: Page, server: Served, tmp_path: Path) -> None:
    page.clock.install()
    page.goto(f"{server.url}#/playback?vehicle=V001&at={AT}21Z")
    expect(place(page)).to_have_text("1003")
    store = PlaybackStore(f"sqlite:///{tmp_path}/plant.db")
    later = [[NOW - 20, "vehicles", "V001", {"barcode": "1001"}]]
    store.append([Piece(CHANGES, NOW - 20, NOW - 20, 1, packed(later))])
    store.close()
    slider = page.get_by_role("slider", name="Moment")
    ended = slider.get_attribute("max") or ""
    page.clock.run_for(6000)
    expect(slider).not_to_have_attribute("max", ended)
    slider.press("End")
    expect(place(page)).to_have_text("1001")
