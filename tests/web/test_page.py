"""The page in a real browser, with the real application behind it."""

from collections.abc import Iterator
from dataclasses import replace
from urllib.parse import urlsplit

import pytest
from websockets.sync.client import ClientConnection

from app.domain.devices import AgvMoveManual, AgvSetCurrent, AgvSpeed, ManualDirection
from app.domain.ids import JobId, VehicleId
from app.domain.requests import CommandAgv, CreateJob
from app.domain.units import Barcode
from app.domain.view import ControllerView, HoldView, Topic, Update
from app.domain.why import Candidate, Choice, Why
from tests.api.scripted import NOW
from tests.e2e.processes import wait_until
from tests.web.hands import TWICE
from tests.web.served import Served, served
from tests.web.whole import device, whole
from tools.chromium import Page, chromium, installed, new_tab

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(installed() is None, reason="Chromium is not installed"),
]

LIVE = "document.querySelector('.link.live')"
KEY = "a-key-of-sixteen-or-more-letters"


@pytest.fixture(scope="module")
def wire() -> Iterator[ClientConnection]:
    """A Chromium for all tests: its start takes longer than most of them. Each has a tab without a past."""
    with chromium() as wire:
        yield wire


def text_of(selector: str, words: str) -> str:
    return f"[...document.querySelectorAll({selector!r})].some((e) => e.textContent.includes({words!r}))"


def fill(selector: str, value: str, event: str = "input") -> str:
    return (
        f"(() => {{ const e = document.querySelector({selector!r}); e.value = {value!r}; "
        f"e.dispatchEvent(new Event({event!r}, {{ bubbles: true }})); }})()"
    )


def order(page: Page, source: str, destination: str) -> None:
    page.ask(fill(".transfer label:nth-of-type(1) select", source, "change"))
    page.ask(fill(".transfer label:nth-of-type(2) select", destination, "change"))
    page.ask("document.querySelector('.transfer button[type=submit]').click()")


def test_the_page_shows_vehicles_jobs_and_events_live_and_calls_no_other_host(wire: ClientConnection) -> None:
    with served() as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        page.until(text_of(".chip", "V001") + " && " + text_of(".chip", "V002"))
        order(page, "P1", "P2")
        page.until(text_of(".jobs .job", "P1"))
        page.until(text_of(".events li", "Transfer initiated"))
        server.do(lambda: server.controller.end("J1"))
        page.until(text_of(".job.over", "completed"))
        assert [request.source for request in server.controller.seen if isinstance(request, CreateJob)] == ["P1"]
        assert {urlsplit(address).netloc for address in page.requests} == {f"127.0.0.1:{server.port}"}
        assert page.complaints == []


def test_a_vehicle_chosen_shows_every_bit_and_why_it_waits(wire: ClientConnection) -> None:
    with served() as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        server.place("V001", "1002", activity="waiting", waiting="V001 waits at 1002 for 1003 held by V002")
        page.ask("document.querySelector('.chip').click()")
        page.until(text_of(".panel .note", "for 1003 held by V002"))
        page.until(text_of(".panel .bits th", "MODE") + " && " + text_of(".panel .bits td", "no FOUP"))
        page.until(text_of(".panel dd", "1002"))
        page.until(DRAWN)
        assert page.complaints == []


DRAWN = """(() => {
  const { width, height } = document.querySelector('.map canvas.front');
  const seen = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  seen.drawImage(document.querySelector('.map canvas.front'), 0, 0);
  return seen.getImageData(0, 0, width, height).data.some((value) => value > 0);
})()"""
"""Whether anything is on the canvas of what moves."""


def test_a_refusal_is_shown_with_its_remedy(wire: ClientConnection) -> None:
    with served() as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        page.ask("document.querySelector('.chip').click()")
        server.place("V001", "1001", activity="held", hold=HoldView("it was moved by hand", "look at it", NOW))
        page.until("document.querySelector('.decide select')")
        page.ask(fill(".decide input", "seen it"))
        page.ask("document.querySelector('.decide button').click()")
        page.until(text_of(".problem", "Write your name at the top right"))


def test_the_page_says_that_its_data_is_old_and_goes_on_by_itself_even_with_another_history(
    wire: ClientConnection,
) -> None:
    with new_tab(wire) as page:
        with served() as first:
            port = first.port
            page.open(first.url)
            page.until(LIVE)
            first.do(lambda: [first.controller.happen("VehicleDeparted", vehicle="V001") for _ in range(5)])
            page.until(text_of(".events li", "#5"))
        page.until(text_of(".link.lost", "Reconnecting"))
        with served(port) as second:
            page.until(LIVE)
            second.do(lambda: second.controller.happen("AlarmSet", vehicle="V002"))
            page.until(text_of(".events li", "Alarm set"))
            assert not page.ask(text_of(".events li", "Vehicle departed"))


def test_the_access_key_is_asked_for_and_kept_in_the_tab_only(wire: ClientConnection) -> None:
    with served(access_key=KEY) as server, new_tab(wire) as page:
        page.open(server.url)
        page.until("document.querySelector('dialog[open]')")
        page.ask("document.querySelector('dialog button.text').click()")
        page.until("document.querySelector('dialog input[name=key]')")
        use(page, "not the key of this server")
        page.until(text_of("dialog .problem", "This is no key"))
        assert page.ask("sessionStorage.getItem('hoistway.key')") == ""
        use(page, KEY)
        page.until(LIVE)
        page.until(text_of("header .account", "access-key"))
        assert page.ask("sessionStorage.getItem('hoistway.key')") == KEY
        assert KEY not in page.ask("Object.values(localStorage).join()")
        assert not [address for address in page.requests if KEY in address]


def use(page: Page, key: str) -> None:
    page.ask(fill("dialog input[name=key]", key))
    page.ask("document.querySelector('dialog form').requestSubmit()")


def test_the_page_of_the_demo_plant_shows_the_door_both_agvs_and_the_drives(wire: ClientConnection) -> None:
    with served(controller=whole()) as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        page.until(text_of(".chip", "AGV1") + " && " + text_of(".chip", "AGV2"))
        page.ask(tab("Devices"))
        page.until(text_of("[data-device=DOOR1]", "closed") + " && " + text_of("[data-device=BUFFER1]", "cart there"))
        server.place("AGV1", "0142", activity="moving", granted=("0143", "0144"))
        server.place("AGV2", "0153", activity="charging")
        server.show([device("door", "DOOR1", 30, "open", vehicles=("AGV1",))])
        page.until(text_of("[data-device=DOOR1]", "open") + " && " + text_of("[data-device=DOOR1]", "AGV1"))
        page.until(text_of("[data-device=CHARGER1]", "charging") + " && " + text_of("[data-device=CHARGER1]", "AGV2"))
        page.ask(tab("Drives"))
        for drive in ("STK01-LIFT", "STK01-FORK", "SORT01-TURN"):
            page.until(text_of(f"[data-drive={drive}]", "monitoring"))
        page.until(DRAWN)
        assert page.complaints == []


def test_a_door_that_is_not_heard_says_so_and_why(wire: ClientConnection) -> None:
    with served(controller=whole()) as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        page.ask(tab("Devices"))
        page.until("document.querySelector('[data-device=DOOR1]')")
        page.ask("document.querySelector('[data-device=DOOR1]').click()")
        page.until(text_of(".panel h2", "DOOR1"))
        server.show([device("door", "DOOR1", 30, "open", fresh=False, reason="no Status for 5 s")])
        page.until(text_of(".panel .note", "no Status for 5 s"))
        page.until(text_of(".panel dd", "last said: open"))


def test_a_drive_is_stopped_by_one_press_and_its_parameters_are_read(wire: ClientConnection) -> None:
    with served() as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        page.ask(tab("Drives"))
        page.until("document.querySelector('[data-drive=D1]')")
        page.ask("document.querySelector('[data-drive=D1]').click()")
        page.until("document.querySelector('.panel .halt')")
        page.ask("document.querySelector('.panel .halt').click()")
        end_of_operation(server, 1)
        page.until(text_of(".panel .done", "Stop / reset: done"))
        page.ask("document.querySelector('.panel .part h3 button').click()")
        end_of_operation(server, 2)
        page.until(text_of(".panel .done", "Read parameters: done"))
        page.until("[...document.querySelectorAll('.panel .numbered tr')].length > 0")
        asked = [type(request).__name__ for request in server.controller.seen]
        assert asked == ["PressDriveKey", "ReadDrive"]
        assert page.complaints == []


def test_an_agv_is_driven_by_hand_and_told_where_it_stands(wire: ClientConnection) -> None:
    with served(controller=whole()) as server, new_tab(wire) as page:
        server.place("AGV1", "0142", mode="mant")
        page.open(f"{server.url}#/map?vehicle=AGV1")
        page.until(LIVE)
        page.until("document.querySelector('[data-commands=AGV1]')")
        page.ask(press_twice("By hand: turn left"))
        page.until("document.querySelector('.panel .done')")
        page.ask(fill(".panel input[name=tag]", "0142"))
        page.ask(press_twice("Tell it so"))
        seen = server.controller.seen
        wait_until(lambda: sum(isinstance(request, CommandAgv) for request in seen) == 2, "the second command")
        asked = [request.command for request in seen if isinstance(request, CommandAgv)]
        assert asked == [AgvMoveManual(ManualDirection.TURN_LEFT, AgvSpeed.SLOW), AgvSetCurrent(Barcode("0142"))]
        assert page.complaints == []


def press_twice(words: str) -> str:
    """Press a button of the panel by what stands on it, and say that one is sure."""
    return f"({TWICE})([...document.querySelectorAll('.panel button')].find((e) => e.textContent === {words!r}))"


def test_a_door_is_commanded_by_two_presses(wire: ClientConnection) -> None:
    with served(controller=whole()) as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        page.ask(tab("Devices"))
        page.until("document.querySelector('[data-device=DOOR1]')")
        page.ask("document.querySelector('[data-device=DOOR1]').click()")
        page.until("document.querySelector('[data-commands=DOOR1] button')")
        page.ask("document.querySelector('[data-commands=DOOR1] button').click()")
        page.until(text_of("[data-commands=DOOR1] .armed", "Sure?"))
        assert not server.controller.seen
        page.ask(f"({TWICE})(document.querySelector('[data-commands=DOOR1] button'))")
        page.until(text_of(".panel .done", "Open door"))
        assert [type(request).__name__ for request in server.controller.seen] == ["CommandDevice"]


def end_of_operation(server: Served, number: int) -> None:
    """Let an operation end once the page has asked for it."""
    drives = server.controller.drives
    wait_until(lambda: number in drives.operations, "the request")
    server.show([drives.end(number)])


@pytest.mark.parametrize(("name", "kind"), [("DOOR1", "Door"), ("CHARGER1", "Charger"), ("AB2", "AGV buffer")])
def test_what_stands_in_the_hall_is_chosen_on_the_map(wire: ClientConnection, name: str, kind: str) -> None:
    with served(controller=whole()) as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        click(page, *place_on_map(page, name))
        page.until(text_of(".panel h2", name) + " && " + text_of(".panel .tag", kind))
        assert page.complaints == []


def place_on_map(page: Page, name: str) -> tuple[float, float]:
    """Return where the map names something under the pointer."""
    found = page.ask(f"""(async () => {{
      const canvas = document.querySelector('.map .touch');
      const {{ left, top, width, height }} = canvas.getBoundingClientRect();
      for (let x = width - 5; x > width / 2; x -= 7) for (let y = 40; y < height; y += 7) {{
        const at = {{ clientX: left + x, clientY: top + y, bubbles: true }};
        canvas.dispatchEvent(new PointerEvent('pointermove', at));
        if (canvas.style.cursor !== 'pointer') continue;
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        if (document.querySelector('.tip b')?.textContent === {name!r}) return [at.clientX, at.clientY];
      }}
      return null;
    }})()""")
    assert found is not None, f"{name} is nowhere on the map"
    return found[0], found[1]


def click(page: Page, x: float, y: float) -> None:
    for kind in ("mousePressed", "mouseReleased"):
        page.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)


def test_the_form_offers_only_ends_that_one_vehicle_can_join(wire: ClientConnection) -> None:
    with served(controller=whole()) as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        ends = "[...document.querySelectorAll('.transfer label:nth-of-type(2) option')].map((e) => e.value).join()"
        page.ask(fill(".transfer label:nth-of-type(1) select", "AB1", "change"))
        page.until(f"{ends} === ',AB1,AB2,AB3,AB4'")
        page.ask(fill(".transfer label:nth-of-type(2) select", "AB2", "change"))
        page.ask(fill(".transfer label:nth-of-type(1) select", "ETCH01-P1", "change"))
        page.until(f"{ends}.includes('SBA-L1') && !{ends}.includes('AB1')")
        assert page.ask("document.querySelector('.transfer label:nth-of-type(2) select').value") == ""


def test_a_circle_of_hoists_stands_over_the_map_and_among_the_alarms(wire: ClientConnection) -> None:
    with served() as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        (now,) = server.controller.model.all(Topic.CONTROLLER)
        assert isinstance(now, ControllerView)
        words = "V001, V002 wait for each other in a circle (a); if none finds another way, move V001 by hand"
        server.show([Update(Topic.CONTROLLER, "controller", replace(now, circles=(words,), circles_found=3))])
        page.until(text_of(".banner", "V001, V002 wait for each other") + " && " + text_of(".banner", "found 3"))
        page.ask(room("Alarms"))
        page.until(text_of("[data-alarm^=controller]", "V001, V002 wait for each other"))
        assert page.complaints == []


def test_a_job_chosen_says_why_this_vehicle_and_what_it_waited_for(wire: ClientConnection) -> None:
    with served() as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        order(page, "P1", "P2")
        page.until(text_of(".jobs .job", "P1"))
        other = Candidate(VehicleId("V002"), 31.5, "is not free")
        choice = Choice(NOW, VehicleId("V001"), 12.25, 50, hot=False, waited=3.0, switch=0.0, candidates=(other,))
        why = Why(1, JobId("J1")).waiting("P2 is occupied by F7", NOW).chosen(choice)
        server.controller.reader.whys[1] = why
        page.ask("document.querySelector('.jobs .job .facts button').click()")
        page.until(text_of(".panel .choice", "V001") + " && " + text_of(".panel .choice", "12.3 s to the source"))
        page.until(text_of(".panel .choice tr", "V002") + " && " + text_of(".panel .choice tr", "is not free"))
        page.until(text_of(".panel .why-list", "P2 is occupied by F7"))
        page.until("location.hash === '#/map?job=J1'")
        server.do(lambda: server.controller.happen("VehicleUnassigned", "J1", "V001"))
        page.until(text_of(".panel .choice", "Taken back at"))
        page.until(text_of(".panel dd", "before: V001"))
        assert page.complaints == []


def test_what_is_looked_for_is_found_by_a_part_of_its_name_and_chosen(wire: ClientConnection) -> None:
    with served(controller=whole()) as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        page.ask(fill(".finder input", "etch01-p"))
        page.until(text_of("#found [role=option]", "ETCH01-P1"))
        page.ask("""document.querySelector('.finder input').dispatchEvent(
          new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }))""")
        page.until(text_of(".panel h2", "ETCH01-P1"))
        assert page.complaints == []


@pytest.mark.parametrize(("theme", "language", "word"), [("light", "en", "Jobs"), ("dark", "ko", "작업")])
def test_theme_and_language_are_kept(wire: ClientConnection, theme: str, language: str, word: str) -> None:
    with served() as server, new_tab(wire) as page:
        page.open(server.url)
        page.until(LIVE)
        if page.ask("document.documentElement.dataset.theme") != theme:
            page.ask("[...document.querySelectorAll('header .plain')][0].click()")
            page.until(f"localStorage.getItem('hoistway.theme') === {theme!r}")
        if page.ask("document.documentElement.lang") != language:
            page.ask("[...document.querySelectorAll('header .plain')][1].click()")
            page.until(f"localStorage.getItem('hoistway.language') === {language!r}")
        page.open("about:blank")
        page.open(server.url)
        page.until(f"{LIVE} && document.documentElement.dataset.theme === {theme!r}")
        page.until(text_of("nav.rooms button", word))
        assert page.ask("document.documentElement.lang") == language


def room(name: str) -> str:
    """Open a room by its name in the head."""
    return f"[...document.querySelectorAll('nav.rooms button')].find((e) => e.textContent.includes({name!r})).click()"


def tab(name: str) -> str:
    """Choose a list below the map."""
    return (
        f"[...document.querySelectorAll('.below .tabs button')].find((e) => e.textContent.includes({name!r})).click()"
    )
