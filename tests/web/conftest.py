"""A page in a real Chromium, for tests that use it as a person does: one browser for a file, one clean context for a test."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect, sync_playwright

from tests.e2e.processes import GENEROUS
from tools.chromium import installed

FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-dev-shm-usage",
)
PATIENCE = GENEROUS * 500


@pytest.fixture(scope="module")
def chromium() -> Iterator[Browser]:
    """Return the browser of a file's tests: its start takes longer than most of them."""
    with sync_playwright() as play:
        started = play.chromium.launch(executable_path=installed(), args=list(FLAGS))
        try:
            yield started
        finally:
            started.close()


@pytest.fixture
def page(chromium: Browser) -> Iterator[Page]:
    """Return a page without any past, that keeps still where it can."""
    context = chromium.new_context(viewport={"width": 1440, "height": 1000}, locale="en-GB", reduced_motion="reduce")
    try:
        page = context.new_page()
        page.set_default_timeout(PATIENCE)
        expect.set_options(timeout=PATIENCE)
        yield page
    finally:
        context.close()
