"""Logging in at the page: who may what, what becomes of a session that ends; users and keys, the audit."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from app.domain.access import Role
from app.domain.ids import Actor
from app.domain.records import AuditRow
from app.domain.requests import CreateJob
from app.domain.units import Timestamp
from app.runtime.reception import LOG_IN_LIFE
from app.store.chain import Checked
from tests.api.receptions import PASSWORD, ROOT
from tests.api.scripted import NOW
from tests.web.hands import press_twice
from tests.web.looks import faults
from tests.web.served import served
from tests.web.staffed import Staffed, log_in, staffed
from tools.chromium import browser, installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]

RENEW_NOW = """() => { const kept = JSON.parse(sessionStorage.getItem('hoistway.session'));
  sessionStorage.setItem('hoistway.session', JSON.stringify({ ...kept, renew: 0 })); }"""
"""The token is to be renewed as soon as the page is loaded again."""


@pytest.fixture(scope="module")
def plant(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Staffed]:
    with staffed(chromium, tmp_path_factory.mktemp("staffed")) as plant:
        yield plant


def fill_order(page: Page, source: str, destination: str) -> None:
    form = page.locator(".transfer")
    form.locator("select").nth(0).select_option(source)
    form.locator("select").nth(1).select_option(destination)


def test_whoever_logs_in_sees_who_they_are_and_acts_in_their_own_name(plant: Staffed) -> None:
    with plant.visitor() as page:
        log_in(page, "lee", "not the password")
        expect(page.locator("dialog .problem")).to_contain_text("nobody of that name with that password")
        assert page.locator("dialog input[name=password]").input_value() == ""
        log_in(page, "lee")
        account = page.locator("header .account > button")
        expect(account).to_contain_text("lee")
        expect(account).to_contain_text("operator")
        expect(page.get_by_label("Your name")).to_have_count(0)
        fill_order(page, "P1", "P2")
        page.get_by_role("button", name="Order", exact=True).click()
        expect(page.locator(".transfer .done")).to_contain_text("accepted")
        (order,) = [request for request in plant.server.controller.seen if isinstance(request, CreateJob)]
        assert order.actor == "lee"
        account.click()
        page.get_by_role("button", name="Log out").click()
        expect(page.locator("dialog")).to_be_visible()
        page.wait_for_function("() => Object.values(sessionStorage).join('') === ''")


def test_a_first_visit_asks_for_nothing_but_a_log_in_and_then_shows_the_room_that_was_wanted(plant: Staffed) -> None:
    with plant.visitor() as page:
        said: list[str] = []
        page.on("console", lambda word: said.append(word.text) if word.type in {"error", "warning"} else None)
        asked: list[str] = []
        page.on("request", lambda request: asked.append(request.url) if "/api/" in request.url else None)
        page.goto(f"{plant.server.url}#/audit")
        page.reload()
        expect(page.locator("dialog input[name=name]")).to_be_visible()
        expect(page.get_by_role("heading", name="Audit")).to_be_attached()
        assert {url.partition("/api/v1")[2] for url in asked} == {"/session/required"}
        log_in(page, "kim")
        expect(page.locator(".link.live")).to_be_visible()
        expect(page.locator("dialog")).to_have_count(0)
        assert said == []


def test_tabs_made_of_one_another_go_on_with_a_new_token_and_are_logged_out_together(plant: Staffed) -> None:
    with plant.at_work("lee") as page:
        with page.expect_popup() as opening:
            page.evaluate("window.open(location.href)")
        other = opening.value
        expect(other.locator("header .account > button")).to_contain_text("lee")
        first = page.evaluate("sessionStorage.getItem('hoistway.key')")
        page.evaluate(RENEW_NOW)
        page.reload()
        other.wait_for_function("first => sessionStorage.getItem('hoistway.key') !== first", arg=first)
        keys = [tab.evaluate("sessionStorage.getItem('hoistway.key')") for tab in (page, other)]
        assert keys[0] == keys[1]
        page.locator("header .account > button").click()
        page.get_by_role("button", name="Log out").click()
        for tab in (page, other):
            expect(tab.locator("dialog input[name=name]")).to_be_visible()
            tab.wait_for_function("() => Object.values(sessionStorage).join('') === ''")


def test_somebody_else_in_another_tab_stays_logged_in(plant: Staffed) -> None:
    with plant.at_work("lee") as page:
        other = page.context.new_page()
        other.goto(plant.server.url)
        log_in(other, "mia")
        expect(other.locator("header .account > button")).to_contain_text("mia")
        page.locator("header .account > button").click()
        page.get_by_role("button", name="Log out").click()
        expect(page.locator("dialog input[name=name]")).to_be_visible()
        expect(other.locator(".link.live")).to_be_visible()
        assert other.evaluate("sessionStorage.getItem('hoistway.key')") != ""


def test_a_button_that_a_role_may_not_press_says_whose_it_is_and_asks_nothing(plant: Staffed) -> None:
    with plant.at_work("vic") as page:
        asked: list[str] = []
        page.on("request", lambda request: asked.append(request.method) if request.method != "GET" else None)
        fill_order(page, "P1", "P2")
        button = page.locator(".transfer button[type=submit]")
        expect(button).to_have_attribute("aria-disabled", "true")
        expect(button).to_have_attribute(
            "title", "This needs the role operator, MES, administrator. You are vic, with viewer."
        )
        page.locator(".transfer input[name=carrier]").press("Enter")
        toast = page.locator(".toast")
        expect(toast).to_contain_text("This needs the role operator, MES, administrator")
        assert asked == []
        toast.get_by_role("button", name="Log in as somebody else").click()
        log_in(page, "lee")
        expect(button).not_to_have_attribute("aria-disabled", "true")
        assert page.locator(".transfer select").nth(0).input_value() == "P1"


def test_every_role_may_press_what_the_policy_says_and_nothing_else(plant: Staffed) -> None:
    may: dict[str, set[str]] = {"vic": set(), "lee": {"hold", "order"}, "mia": {"hold", "lockout"}}
    buttons = {
        "hold": "[data-needs='POST /vehicles/{vehicle}/hold']",
        "order": "[data-needs='POST /jobs']",
        "lockout": "[data-needs='POST /vehicles/{vehicle}/lockout']",
    }
    for name, wanted in may.items():
        with plant.at_work(name, "map?vehicle=V001") as page:
            page.locator(".panel details.acts").first.evaluate("(box) => { box.open = true; }")
            for what, selector in buttons.items():
                button = expect(page.locator(selector), f"{what}, by {name}")
                (button.not_to_contain_class if what in wanted else button.to_contain_class)("barred")


def test_a_session_that_ends_asks_again_and_loses_nothing_that_was_being_written(plant: Staffed) -> None:
    with plant.at_work("lee", "closures") as page:
        form = page.get_by_role("form", name="Close")
        form.get_by_label("From barcode").fill("1001")
        form.get_by_label("Reason").fill("the rail is clea")
        plant.clock.at += LOG_IN_LIFE
        expect(page.locator("dialog")).to_contain_text("What you were writing is still there")
        expect(page.locator("dialog input[name=name]")).to_have_value("lee")
        page.locator("dialog input[name=password]").fill(PASSWORD)
        page.locator("dialog button[type=submit]").click()
        expect(page.locator(".link.live")).to_be_visible()
        expect(page.locator("dialog")).to_have_count(0)
        assert form.get_by_label("From barcode").input_value() == "1001"
        assert form.get_by_label("Reason").input_value() == "the rail is clea"


def test_a_token_is_renewed_before_it_ends_and_a_new_page_of_the_tab_goes_on(plant: Staffed) -> None:
    with plant.at_work("lee") as page:
        first = page.evaluate("sessionStorage.getItem('hoistway.key')")
        page.evaluate(RENEW_NOW)
        page.reload()
        page.wait_for_function("(first) => sessionStorage.getItem('hoistway.key') !== first", arg=first)
        expect(page.locator(".link.live")).to_be_visible()
        expect(page.locator("dialog")).to_have_count(0)


def test_other_roles_take_effect_at_once(plant: Staffed) -> None:
    server, desk = plant.server, plant.desk
    assert server.wait(desk.add_user("new", frozenset({Role.OPERATOR}), PASSWORD, ROOT)) is None
    with plant.at_work("new") as page:
        button = page.locator(".transfer button[type=submit]")
        expect(button).not_to_have_attribute("aria-disabled", "true")
        assert server.wait(desk.change_user("new", ROOT, roles=frozenset({Role.VIEWER}))) is None
        fill_order(page, "P1", "P2")
        button.click()
        expect(page.locator(".transfer .problem")).to_contain_text("needs the role operator or mes or admin")
        expect(button).to_have_attribute("aria-disabled", "true")


def test_where_nobody_has_to_log_in_everything_can_be_pressed_and_people_name_themselves() -> None:
    with served() as server, browser() as page:
        page.open(server.url)
        page.until("document.querySelector('.link.live')")
        page.until("document.querySelector('header .actor input')")
        assert page.ask("document.querySelector('header .account')") is None
        assert page.ask("document.querySelectorAll('.barred').length") == 0
        assert page.complaints == []


# -- users, keys, the audit -------------------------------------------------------------------------------------------


def test_an_administrator_adds_somebody_changes_their_roles_and_disables_them(plant: Staffed) -> None:
    with plant.at_work("kim", "access") as page:
        form = page.get_by_role("form", name="Add a person")
        form.get_by_label("Name").fill("ola")
        form.get_by_label("Password").fill("short")
        form.get_by_label("viewer").check()
        form.get_by_role("button", name="Add a person").click()
        expect(form.locator(".problem")).to_contain_text("10")
        form.get_by_label("Password").fill("horse battery 9")
        form.get_by_role("button", name="Add a person").click()
        expect(form.locator(".done")).to_contain_text("ola may log in now")
        page.locator("[data-row=ola] button").click()
        change = page.locator("[data-user=ola]")
        change.get_by_label("operator").check()
        press_twice(change, "Change the roles")
        expect(page.locator("[data-row=ola]")).to_contain_text("viewer, operator")
        change.get_by_label("New password").fill("another horse 10")
        press_twice(change, "Give a new password")
        expect(change.locator(".done")).to_contain_text("logged out")
        press_twice(change, "Disable")
        expect(page.locator("[data-row=ola]")).to_contain_text("disabled")
    ola = plant.desk.user("ola")
    assert ola is not None
    assert (set(ola.roles), ola.disabled, str(ola.created_by)) == ({Role.VIEWER, Role.OPERATOR}, True, "kim")


def test_a_key_is_shown_once_copied_and_revoked(plant: Staffed) -> None:
    with plant.at_work("kim", "access") as page:
        page.context.grant_permissions(["clipboard-read", "clipboard-write"])
        page.get_by_role("button", name="Keys", exact=True).click()
        form = page.get_by_role("form", name="Issue a key")
        form.get_by_label("Name").fill("mes-7")
        form.get_by_label("MES").check()
        form.get_by_role("button", name="Issue a key").click()
        key = form.get_by_label("The new key").input_value()
        assert key.startswith("hwk_")
        form.get_by_role("button", name="Copy").click()
        expect(form.get_by_role("button", name="Copied")).to_be_visible()
        assert page.evaluate("navigator.clipboard.readText()") == key
        form.get_by_role("button", name="Put away").click()
        assert key not in page.content()
        row = page.locator("[data-row='mes-7']")
        expect(row).to_contain_text("active")
        press_twice(row, "Revoke")
        expect(row).to_contain_text("revoked")
    assert plant.desk.access.caller(key.encode()) is None


def test_only_administrators_see_who_is_known(plant: Staffed) -> None:
    with plant.at_work("lee", "access") as page:
        expect(page.locator(".room .nothing")).to_contain_text(
            "This needs the role administrator. You are lee, with operator."
        )


def test_what_was_asked_for_is_told_field_by_field_in_korean(plant: Staffed) -> None:
    reader = plant.server.controller.reader
    before = list(reader.asked)
    details = ("vehicle V005, what stop", "station SBA-R1, out_of_service bent, by_person False, walked False")
    reader.asked[:] = [
        AuditRow(Timestamp(NOW + i), Actor("lee"), "CommandVehicle", "", detail, accepted=True)
        for i, detail in enumerate(details)
    ]
    with plant.at_work("lee", "audit", language="ko") as page:
        rows = page.locator(".room tbody tr")
        expect(rows.first).to_contain_text("스테이션: SBA-R1 · 사용 중지: bent")
        expect(rows.last).to_contain_text("차량: V005 · 작업 내용: 정지 (MANT)")
    reader.asked[:] = before


def test_the_audit_is_searched_gone_through_page_by_page_checked_and_saved(plant: Staffed) -> None:
    reader = plant.server.controller.reader
    before = list(reader.asked)
    reader.asked[:] = [
        AuditRow(
            Timestamp(NOW + i), Actor("kim" if i % 2 else "lee"), "PauseController", "", f"row {i}", accepted=i != 7
        )
        for i in range(230)
    ]
    with plant.at_work("lee", "audit") as page:
        rows = page.locator(".room tbody tr")
        expect(rows).to_have_count(100)
        expect(rows.first).to_contain_text("row 229")
        page.get_by_role("button", name="Older").click()
        expect(rows.first).to_contain_text("row 129")
        page.get_by_role("button", name="Older").click()
        expect(rows).to_have_count(30)
        page.get_by_role("button", name="Newer").click()
        expect(rows.first).to_contain_text("row 129")
        search = page.get_by_role("search")
        search.get_by_label("Who").fill("kim")
        search.get_by_label("Result").select_option("false")
        search.get_by_role("button", name="Find").click()
        expect(rows).to_have_count(1)
        expect(rows.first).to_contain_text("row 7")
        with page.expect_download() as saved:
            search.get_by_role("button", name="Save as CSV").click()
        text = Path(saved.value.path()).read_text(encoding="utf-8-sig")
        assert text.splitlines()[1:] == ["8,2026-01-01T00:00:07.000Z,kim,PauseController,,row 7,false"]
        page.get_by_role("button", name="Check the chain").click()
        expect(page.locator("[data-chain=whole]")).to_contain_text("230 rows up to #230")
        reader.broken = Checked(12, 12, "00", 13, "the row was changed, or one before it was taken out or put in")
        page.get_by_role("button", name="Check the chain").click()
        expect(page.locator("[data-chain=broken]")).to_contain_text("Broken at #13")
    reader.broken = None
    reader.asked[:] = before


@pytest.mark.parametrize(("theme", "language"), [("dark", "ko"), ("light", "en")])
def test_logging_in_who_is_known_and_what_a_viewer_may_not_press_are_accessible(
    plant: Staffed, theme: str, language: str
) -> None:
    found: dict[str, list[str]] = {}
    for name, places in {"kim": ["access"], "vic": ["map?drive=D1"]}.items():
        with plant.visitor(theme=theme, language=language) as page:
            expect(page.locator("dialog input[name=name]")).to_be_visible()
            found[f"{name} logs in"] = faults(page)
            log_in(page, name)
            expect(page.locator(".link.live")).to_be_visible()
            page.locator("header .account > button").click()
            for place in places:
                page.evaluate("(place) => { location.hash = `#/${place}`; }", place)
                page.evaluate("document.querySelectorAll('details').forEach((box) => { box.open = true; })")
                found[f"{name} {place}"] = faults(page)
    assert {place: wrong for place, wrong in found.items() if wrong} == {}
