"""What people find in the panels: what is cut off, lines, a drive watched live, taught values as files, webhooks."""

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

import pytest
from playwright.sync_api import Browser, Locator, expect

from app.domain.device_requests import RaiseEmergency
from app.domain.drive import Parameter
from app.domain.drive_records import OperationState
from app.domain.drive_requests import CancelDriveOperation, StopDriveLine, UnwatchDrive, WatchDrive
from app.domain.ids import Actor, JobId, StationId, VehicleId
from app.domain.requests import CancelJob, ChangeJob, CreateJob, StageVehicle, WriteDest, WriteStation
from app.domain.teaching_requests import ImportTaught
from app.domain.view import ControllerView, HoldView, ParameterView, Topic, Update
from app.domain.webhooks import AddWebhook, ReplayWebhook
from tests.api.scripted import NOW
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
    with staffed(chromium, tmp_path_factory.mktemp("panels")) as plant:
        yield plant


T = TypeVar("T")


def seen(plant: Staffed, kind: type[T]) -> list[T]:
    return [request for request in plant.server.controller.seen if isinstance(request, kind)]


def end_all(plant: Staffed) -> None:
    """Let all operations on drives end that are under way."""
    drives = plant.server.controller.drives
    running = [number for number, one in drives.operations.items() if one.state is OperationState.RUNNING]
    plant.server.show([drives.end(number) for number in running])


def opened(scope: Locator, summary: str) -> Locator:
    """Open what stands behind a summary; return the box."""
    words = scope.page.locator("summary", has_text=re.compile(f"^{summary}"))
    box = scope.locator("details", has=words).last
    box.locator("summary").first.click()
    return box


def test_what_is_kept_off_and_cut_off_stands_in_the_header_among_the_closures_and_with_its_station(
    plant: Staffed,
) -> None:
    (now,) = plant.server.controller.model.all(Topic.CONTROLLER)
    assert isinstance(now, ControllerView)
    view = replace(
        now,
        kept_off=("1002 to 1003: V002 has broken down there",),
        closed_places=1,
        cut_off=("P2: V002 stands at 1002",),
        led_round=3,
    )
    plant.server.show([Update(Topic.CONTROLLER, "controller", view)])
    with plant.at_work("lee", "map?station=P2") as page:
        expect(page.locator("[data-cut-off=P2]")).to_contain_text("V002 stands at 1002")
        head = page.locator("header .kept")
        expect(head).to_have_text("Routes keep off 1 · 1 stations cut off")
        head.click()
        room = page.get_by_role("region", name="Closures")
        expect(room.get_by_label("Routes keep off")).to_contain_text("V002 has broken down there")
        expect(room.locator("[data-led]")).to_contain_text("3 vehicles led round what is closed")
        plant.server.show([Update(Topic.CONTROLLER, "controller", now)])
        expect(head).to_have_count(0)


def test_a_drives_parameters_are_watched_live_as_long_as_somebody_looks(plant: Staffed) -> None:
    words = plant.server.controller.drives.words
    with plant.at_work("mia", "map?drive=D1") as page:
        box = opened(page.locator(".panel"), "Watch live")
        box.get_by_label("1C Acceleration").check()
        box.get_by_role("button", name="Watch", exact=True).click()
        drawn = box.locator("[data-points]")
        expect(drawn).to_be_visible()
        view = plant.server.controller.model.get(Topic.PARAMETERS, "D1/1C")
        assert isinstance(view, ParameterView)
        plant.server.show([Update(Topic.PARAMETERS, "D1/1C", replace(view, raw=400, value=4.0))])
        expect(box.locator(".u-legend")).to_contain_text("Acceleration (s)")
        expect(box.locator(".u-legend .u-value").last).to_have_text("4")
        page.wait_for_function("() => Number(document.querySelector('[data-points]').dataset.points) >= 2")
        box.get_by_role("button", name="End", exact=True).click()
        expect(box.get_by_role("button", name="Watch", exact=True)).to_be_visible()
        wait_until(lambda: isinstance(words[-1], UnwatchDrive), "the end of the watch")
    (watched,) = {(word.drive, word.parameters) for word in words if isinstance(word, WatchDrive)}
    assert watched == ("D1", (Parameter(0x1C),))


def test_a_line_says_how_it_does_and_stops_all_its_drives_at_one_press(plant: Staffed) -> None:
    with plant.at_work("lee") as page:
        page.locator(".below .tabs button", has_text="Lines").click()
        line = page.locator("[data-line=AXES]")
        expect(line).to_contain_text("up since")
        expect(line).to_contain_text("D1")
        line.get_by_role("button", name="Stop all drives of this line").click()
        wait_until(lambda: bool(seen(plant, StopDriveLine)), "the request")
        end_all(plant)
        expect(line.locator(".done")).to_contain_text("Stop sent to all of them")
    assert [request.line for request in seen(plant, StopDriveLine)] == ["AXES"]


def test_what_was_asked_of_a_drive_can_be_cancelled_while_it_runs(plant: Staffed) -> None:
    with plant.at_work("mia", "map?drive=D1") as page:
        page.locator(".panel").get_by_role("button", name="Read parameters").click()
        box = opened(page.locator(".panel"), "What was asked of it")
        running = box.locator("[data-operation]", has_text="under way").first
        press_twice(running, "Cancel")
        wait_until(lambda: bool(seen(plant, CancelDriveOperation)), "the request")
        expect(box.locator("[data-operation]", has_text="read").first).to_contain_text("done")


def test_a_vehicle_is_staged_and_parked_and_a_fire_is_told(plant: Staffed) -> None:
    with plant.at_work("lee", "map?station=P1") as page:
        box = opened(page.locator(".panel"), "Send a vehicle here")
        box.get_by_label("Vehicle").fill("V002")
        press_twice(box, "Send a vehicle here")
        expect(page.locator(".panel .done, .panel .problem").first).to_be_visible()
        page.get_by_role("button", name="Plant…").click()
        group = page.get_by_role("group", name="Plant…")
        group.get_by_label("Reason").fill("smoke in bay 2")
        press_twice(group, "There is a fire")
        wait_until(lambda: bool(seen(plant, RaiseEmergency)), "the request")
        page.keyboard.press("Escape")
        plant.server.place("V001", "1001", mode="auto", oper="idle")
        page.goto(f"{plant.server.url}#/map?vehicle=V001")
        panel = page.locator(".panel")
        opened(panel, "Commands")
        press_twice(panel, "Park")
        expect(panel.locator(".done, .problem").first).to_be_visible()
    assert [(request.station, request.vehicle) for request in seen(plant, StageVehicle)] == [("P1", "V002")]
    assert [(request.kind, request.reason) for request in seen(plant, RaiseEmergency)] == [("fire", "smoke in bay 2")]


def test_what_nobody_knows_of_a_station_stays_unknown_when_something_else_is_written(plant: Staffed) -> None:
    with plant.at_work("lee", "map?station=P1") as page:
        form = opened(page.locator(".panel"), "Write down")
        expect(form.get_by_label("Occupied")).to_have_value("unknown")
        form.get_by_label("Reserved").fill("for cleaning")
        form.get_by_role("button", name="Write down").click()
        wait_until(lambda: bool(seen(plant, WriteStation)), "the request")
    (written,) = seen(plant, WriteStation)
    assert (written.present, written.forgotten, written.reserved) == (None, True, "for cleaning")


def test_a_job_is_given_back_to_all_vehicles_and_cancelled_with_its_reason(plant: Staffed) -> None:
    order = CreateJob(Actor("lee"), JobId("J1"), "P1", StationId("P2"), None, 50, "x", vehicle=VehicleId("V001"))
    plant.server.wait(plant.server.controller.ask(order))
    with plant.at_work("lee", "map?job=J1") as page:
        panel = page.locator(".panel")
        expect(panel.locator("input[name=vehicle]")).to_have_value("V001")
        panel.locator("input[name=vehicle]").fill("")
        panel.get_by_role("button", name="Change", exact=True).click()
        wait_until(lambda: bool(seen(plant, ChangeJob)), "the change")
        panel.locator("input[name=reason]").fill("wrong lot")
        press_twice(panel, "Cancel")
        wait_until(lambda: bool(seen(plant, CancelJob)), "the end")
    assert [(request.vehicle, request.any_vehicle) for request in seen(plant, ChangeJob)] == [(None, True)]
    assert [request.reason for request in seen(plant, CancelJob)] == ["wrong lot"]


def test_a_look_at_a_closure_names_the_jobs_that_it_would_touch(plant: Staffed) -> None:
    order = CreateJob(Actor("lee"), JobId("J1"), "P1", StationId("P2"), None, 50, "x")
    plant.server.wait(plant.server.controller.ask(order))
    with plant.at_work("lee", "closures") as page:
        form = page.get_by_role("form", name="Close", exact=True)
        form.get_by_label("Kind").select_option("station")
        form.locator("input[name=from]").fill("P2")
        form.get_by_role("button", name="Look what it would do").click()
        jobs = form.get_by_role("list", name="1 jobs touched")
        expect(jobs).to_contain_text("J1: its destination P2 would be closed")
        jobs.get_by_role("button", name="J1").click()
        expect(page.locator(".panel h2")).to_contain_text("J1")


def test_a_menu_closes_after_a_choice_and_when_somebody_presses_elsewhere(plant: Staffed) -> None:
    with plant.at_work("lee") as page:
        menu, group = page.get_by_role("button", name="Plant…"), page.get_by_role("group", name="Plant…")
        menu.click()
        expect(group).to_be_visible()
        page.locator(".jobs h2").click()
        expect(group).to_have_count(0)
        menu.click()
        group.get_by_label("Reason").fill("a break")
        group.get_by_role("button", name="Pause", exact=True).click()
        expect(group).to_have_count(0)
        page.get_by_role("button", name="Layers").click()
        expect(page.get_by_role("group", name="Layers")).to_be_visible()
        page.locator(".jobs h2").click()
        expect(page.get_by_role("group", name="Layers")).to_have_count(0)


def test_an_address_of_no_room_is_said_to_be_none_and_shows_the_map(plant: Staffed) -> None:
    with plant.at_work("lee", "crane") as page:
        words = page.locator("header .why")
        expect(words).to_have_text("There is no room crane on this page: this is the map.")
        expect(page.locator(".map")).to_be_visible()
        expect(page.locator(".legend .mark-unknown")).to_have_text("?")
        page.get_by_role("navigation", name="Rooms").get_by_role("button", name="Jobs").click()
        expect(words).not_to_contain_text("crane")


def test_a_command_that_would_be_refused_is_not_offered_and_says_why_in_both_languages(plant: Staffed) -> None:
    plant.server.place("V002", "1002", mode="auto", oper="idle")
    with plant.at_work("mia", "map?vehicle=V002") as page:
        panel = page.locator(".panel")
        opened(panel, "Commands")
        servo = panel.get_by_role("button", name="Servo on", exact=True)
        expect(servo).to_be_disabled()
        expect(servo).to_have_attribute("title", re.compile("It is in AUTO, and this needs MANT"))
        servo.focus()
        page.keyboard.press("Enter")
        told = page.locator(".toast")
        expect(told).to_contain_text("It is in AUTO, and this needs MANT")
        expect(told.get_by_role("button", name="Log in")).to_have_count(0)
        page.keyboard.press("Escape")
        expect(told).to_have_count(0)
        expect(servo).to_be_focused()
        expect(panel.get_by_role("button", name="Stop (to MANT)")).to_be_enabled()
        page.get_by_role("button", name="KO", exact=True).click()
        expect(panel.get_by_role("button", name="서보 켜기")).to_have_attribute(
            "title", re.compile("AUTO이며 MANT가 필요")
        )
        page.get_by_role("button", name="EN", exact=True).click()
        plant.server.place("V002", "1002", mode="mant", oper="idle")
        expect(servo).to_be_enabled()
        stop = panel.get_by_role("button", name="Stop by host")
        expect(stop).to_be_disabled()
        plant.server.place("V002", "1002", mode="auto", oper="idle")
        expect(stop).to_be_enabled()
        stop.focus()
        plant.server.place("V002", "1002", mode="mant", oper="idle")
        expect(stop).to_be_disabled()
        expect(stop).to_be_focused()


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("EN", "clear the cause, then press ‘Recover from the alarm’ at V002"),
        ("KO", "원인을 없앤 뒤 V002에서 ‘알람 복구’를 누르세요"),
    ],
)
def test_what_helps_names_the_button_on_the_page_and_no_call_of_the_api(
    plant: Staffed, language: str, words: str
) -> None:
    hold = HoldView("alarm 105", "clear the cause, then POST /api/v1/vehicles/V002/recover", NOW)
    plant.server.place("V002", "1002", hold=hold, activity="held")
    with plant.at_work("vic", "map?vehicle=V002") as page:
        if language == "KO":
            page.get_by_role("button", name="KO", exact=True).click()
        expect(page.locator(".panel .note.held em")).to_have_text(words)


def test_taught_values_are_read_from_a_file_after_a_look_at_each_row(plant: Staffed, tmp_path: Path) -> None:
    file = tmp_path / "dests.csv"
    with plant.at_work("mia", "teaching") as page:
        page.get_by_role("button", name="Files", exact=True).click()
        file.write_text("station,shft,rota,lift\nP1,1,2,3\nP9,1,2,3\n", encoding="utf-8")
        page.get_by_label("Read a file").set_input_files(file)
        expect(page.locator("[data-import=tried]")).to_contain_text("1 wrong")
        expect(page.get_by_role("button", name="Import", exact=True)).to_be_disabled()
        assert not seen(plant, ImportTaught)
        file.write_text("station,shft,rota,lift\nP1,1,2,3\n", encoding="utf-8")
        page.get_by_label("Read a file").set_input_files(file)
        expect(page.locator("[data-import=tried]")).to_contain_text("1 new")
        press_twice(page.locator(".room"), "Import")
        wait_until(lambda: bool(seen(plant, ImportTaught)), "the request")
    (asked,) = seen(plant, ImportTaught)
    assert [row.name for row in asked.rows] == ["P1"]


def test_a_port_is_given_its_pulses_by_hand(plant: Staffed) -> None:
    with plant.at_work("mia", "map?station=P1") as page:
        taught = opened(page.locator(".panel"), "DEST")
        opened(taught, "Write by hand")
        for axis, value in (("SHFT", "10"), ("ROTA", "-20"), ("LIFT", "30")):
            taught.get_by_label(axis, exact=True).fill(value)
        press_twice(taught, "Write")
        expect(taught.locator("[data-version='1']")).to_contain_text("-20")
    (asked,) = seen(plant, WriteDest)
    assert (asked.pulses.shft, asked.pulses.rota, asked.pulses.lift, asked.actor) == (10, -20, 30, "mia")


def test_a_webhook_is_added_its_secret_shown_once_and_events_are_told_again(plant: Staffed) -> None:
    with plant.at_work("kim", "webhooks") as page:
        form = page.get_by_role("form", name="Tell somebody")
        form.get_by_label("URL").fill("http://elsewhere.example/")
        form.get_by_role("button", name="Tell somebody").click()
        expect(form.locator(".problem")).to_contain_text("Nothing may be sent there")
        form.get_by_label("URL").fill("http://mes.fab/events")
        form.get_by_label("Events").fill("TransferCompleted")
        form.get_by_role("button", name="Tell somebody").click()
        assert form.get_by_label("Secret").input_value().startswith("whsec_")
        page.locator("[data-row='1'] button").click()
        hook = page.locator("[data-webhook='1']")
        hook.get_by_role("button", name="Try it").click()
        expect(hook.locator(".done")).to_contain_text("It was taken")
        hook.get_by_label("Again after event").fill("4")
        press_twice(hook, "Tell again")
        expect(hook.locator("dd", has_text="#4")).to_be_visible()
        press_twice(hook, "Remove")
        expect(page.locator("[data-row='1']")).to_have_count(0)
    assert [request.url for request in seen(plant, AddWebhook)] == ["http://mes.fab/events"]
    assert [request.after for request in seen(plant, ReplayWebhook)] == [4]


def test_the_focus_goes_back_to_what_opened_a_panel_or_a_menu(plant: Staffed) -> None:
    with plant.at_work("lee") as page:
        chip = page.locator(".chip").first
        chip.focus()
        page.keyboard.press("Enter")
        close = page.locator(".panel h2").get_by_role("button", name="Close")
        close.focus()
        page.keyboard.press("Enter")
        expect(page.locator(".panel")).to_have_count(0)
        expect(chip).to_be_focused()
        for name in ("Layers", "Plant…"):
            opener = page.get_by_role("button", name=name, exact=True)
            opener.focus()
            page.keyboard.press("Enter")
            page.keyboard.press("Tab")
            expect(opener).not_to_be_focused()
            page.keyboard.press("Escape")
            expect(opener).to_be_focused()
            expect(opener).to_have_attribute("aria-expanded", "false")


def test_the_focus_stays_on_the_button_by_which_a_transfer_was_ordered(plant: Staffed) -> None:
    with plant.at_work("lee") as page:
        form = page.locator("form.transfer")
        form.locator("select").first.select_option("P1")
        form.locator("select").last.select_option("P2")
        order = form.get_by_role("button", name="Order", exact=True)
        order.focus()
        page.keyboard.press("Enter")
        expect(form.locator(".outcome .problem, .outcome .done:not(:empty)")).to_be_visible()
        expect(order).to_be_focused()
