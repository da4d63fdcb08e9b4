"""A server whose callers have to log in, and pages to it: shared by the tests of a module."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import Browser, Page, expect

from app.domain.access import Role
from app.runtime.access import Access
from app.runtime.passwords import Passwords
from app.runtime.reception import Reception
from tests.api.receptions import CHEAP, PASSWORD, ROOT, Hand, made
from tests.api.scripted import Scripted
from tests.web.conftest import PATIENCE
from tests.web.served import Served, served

STAFF = {"kim": Role.ADMIN, "lee": Role.OPERATOR, "mia": Role.MAINTENANCE, "vic": Role.VIEWER}
"""Who works here. All have the same password."""


class Staffed:
    """The server, the clock that its sessions go by, and a browser."""

    def __init__(self, server: Served, desk: Reception, clock: Hand, chromium: Browser) -> None:
        self.server = server
        self.desk = desk
        self.clock = clock
        self._chromium = chromium

    @contextmanager
    def visitor(self, place: str = "map", *, language: str = "en", theme: str = "dark") -> Iterator[Page]:
        """Give a page of a browser that was never here. It has to have complained of nothing but refusals."""
        context = self._chromium.new_context(
            viewport={"width": 1440, "height": 1000}, locale="en-GB", reduced_motion="reduce"
        )
        try:
            page = context.new_page()
            page.set_default_timeout(PATIENCE)
            expect.set_options(timeout=PATIENCE)
            complaints: list[str] = []
            page.on("pageerror", lambda error: complaints.append(str(error)))
            page.add_init_script(f"localStorage.setItem('hoistway.theme', '{theme}')")
            page.add_init_script(f"localStorage.setItem('hoistway.language', '{language}')")
            page.goto(f"{self.server.url}#/{place}")
            yield page
            assert complaints == []
        finally:
            context.close()

    @contextmanager
    def at_work(self, name: str, place: str = "map", **looks: str) -> Iterator[Page]:
        """Give a page at which somebody has logged in."""
        with self.visitor(place, **looks) as page:
            log_in(page, name)
            expect(page.locator(".link.live")).to_be_visible()
            yield page


def log_in(page: Page, name: str, password: str = PASSWORD) -> None:
    """Say who one is."""
    page.locator("dialog input[name=name]").fill(name)
    page.locator("dialog input[name=password]").fill(password)
    page.locator("dialog button[type=submit]").click()


@contextmanager
def staffed(chromium: Browser, directory: Path, controller: Scripted | None = None) -> Iterator[Staffed]:
    """Serve with :data:`STAFF` known, until the block ends."""
    clock = Hand()
    # The page goes by the server's Date.
    clock.at = time.time()
    controller = controller or Scripted()
    desk = Reception(Access(made(f"sqlite:///{directory}/access.db"), clock), Passwords(CHEAP))
    controller.reception = desk
    with served(controller=controller) as server:
        server.wait(desk.access.start())
        try:
            for name, role in STAFF.items():
                assert server.wait(desk.add_user(name, frozenset({role}), PASSWORD, ROOT)) is None
            yield Staffed(server, desk, clock, chromium)
        finally:
            server.wait(desk.access.stop())
