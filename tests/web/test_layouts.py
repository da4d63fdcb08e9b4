"""Versions of the plant at the page: staged from a file, compared on the plan, refused when wrong, activated, taken back."""

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.api.kept_versions import TEXT, kept_versions
from tests.api.scripted import Scripted
from tests.web.hands import press_twice
from tests.web.looks import faults
from tests.web.served import served
from tools.chromium import installed

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]


def test_a_plant_file_is_staged_looked_at_activated_and_taken_back(page: Page, tmp_path: Path) -> None:
    wrong, new = tmp_path / "wrong.yaml", tmp_path / "new.yaml"
    wrong.write_text(TEXT.replace("at: 104", "at: 904"), encoding="utf-8")
    without = "\n".join(line for line in TEXT.splitlines() if not line.startswith("  P2:")) + "\n"
    port = "  P9: {kind: port, at: 108, dest: {shft: 5, rota: 5, lift: 5}}\n"
    new.write_text(without.replace("  B1: {", port + "  B1: {"), encoding="utf-8")
    with kept_versions(tmp_path) as kept:
        controller = Scripted(plant=kept.plant)
        controller.versions, controller.version = kept.versions, 1
        with served(controller=controller) as server:
            page.add_init_script("localStorage.setItem('hoistway.actor', 'kim')")
            page.goto(f"{server.url}#/layouts")
            form = page.get_by_role("form", name="Stage a plant file")
            form.get_by_label("Choose a plant file").set_input_files(wrong)
            form.get_by_label("Reason").fill("a port more")
            form.get_by_role("button", name="Stage a plant file").click()
            expect(form.locator(".findings")).to_contain_text("904")
            form.get_by_label("Choose a plant file").set_input_files(new)
            form.get_by_role("button", name="Stage a plant file").click()
            version = page.locator("[data-version='2']")
            expect(version.locator("[data-mark=P9]")).to_have_class("added")
            expect(version.locator("[data-mark=P2]")).to_have_class("removed")
            expect(version.get_by_role("group", name="What differs")).to_contain_text("P9")
            expect(version).to_contain_text("Nothing is in the way.")
            assert faults(page) == []
            version.get_by_placeholder("Reason").fill("it is built")
            press_twice(version, "Activate")
            expect(version).to_contain_text("awaited")
            version.get_by_placeholder("Reason").fill("not today")
            version.get_by_role("button", name="Do not activate it").click()
            expect(version).to_contain_text("rejected")
            expect(version).to_contain_text("kim: not today")
