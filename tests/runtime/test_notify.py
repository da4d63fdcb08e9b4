"""The service manager hears of readiness, of life while there is any, and of the end."""

import asyncio
import contextlib
import math
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.domain.units import Seconds
from app.runtime.notify import Notifier
from app.runtime.writer import Writer
from tests.runtime.peers import run, until
from tests.runtime.test_writer import BOUND, ScriptedLedger, record


class Manager:
    """The other end of the notification socket."""

    def __init__(self, directory: Path) -> None:
        self.wire = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.wire.settimeout(0.0)
        self.path = str(directory / "notify")
        self.wire.bind(self.path)

    def heard(self) -> list[str]:
        said = []
        with contextlib.suppress(BlockingIOError):
            while True:
                said.append(self.wire.recv(4096).decode())
        return said

    def environ(self, **more: str) -> dict[str, str]:
        return {"NOTIFY_SOCKET": self.path, **more}


class Heart:
    def __init__(self, silent: float = 0.0) -> None:
        self.silent = silent
        self.asked = 0

    def silent_for(self) -> Seconds:
        self.asked += 1
        return Seconds(self.silent)


@pytest.fixture
def manager(tmp_path: Path) -> Iterator[Manager]:
    made = Manager(tmp_path)
    yield made
    made.wire.close()


def test_readiness_and_the_end_are_told(manager: Manager) -> None:
    notifier = Notifier(manager.environ())
    notifier.ready("controls demo at http://127.0.0.1:8080")
    notifier.stopping()
    assert manager.heard() == ["READY=1\nSTATUS=controls demo at http://127.0.0.1:8080", "STOPPING=1"]


def test_without_a_manager_or_with_a_deaf_one_nothing_happens(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    Notifier({}).ready("x")
    Notifier({"NOTIFY_SOCKET": str(tmp_path / "gone")}).stopping()
    assert "does not listen" in capsys.readouterr().out


def test_an_abstract_address_begins_with_a_nul() -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as wire:
        wire.settimeout(BOUND)
        wire.bind("\0hoistway-test-notify")
        Notifier({"NOTIFY_SOCKET": "@hoistway-test-notify"}).ready("x")
        assert wire.recv(100) == b"READY=1\nSTATUS=x"


@pytest.mark.parametrize(
    ("environ", "within"),
    [
        ({"WATCHDOG_USEC": "30000000"}, 30.0),
        ({"WATCHDOG_USEC": "30000000", "WATCHDOG_PID": "7"}, 30.0),
        ({"WATCHDOG_USEC": "30000000", "WATCHDOG_PID": "8"}, None),
        ({"WATCHDOG_USEC": "0"}, None),
        ({"WATCHDOG_USEC": "soon"}, None),
        ({}, None),
    ],
)
def test_the_watchdog_is_this_process_s_own(environ: dict[str, str], within: float | None) -> None:
    assert Notifier({"NOTIFY_SOCKET": "/x", **environ}, pid=7).within == within
    assert Notifier(environ, pid=7).within is None


def test_the_watchdog_is_fed_while_the_heart_beats_and_no_longer(manager: Manager) -> None:
    async def scenario() -> None:
        heart, reasons = Heart(), list[str]()
        notifier = Notifier(manager.environ(WATCHDOG_USEC="40000"))
        manager.heard()
        notifier.feed(heart, reasons.append)
        await until(lambda: heart.asked > 3)
        assert set(manager.heard()) == {"WATCHDOG=1"}
        heart.silent = math.inf
        asked = heart.asked
        await until(lambda: heart.asked > asked + 3)
        assert len(reasons) == 1
        assert manager.heard() == []
        heart.silent = 0.0
        await until(lambda: bool(manager.heard()))
        notifier.stopping()

    run(scenario)


def test_a_writer_whose_commit_hangs_falls_silent_and_one_that_ended_is_silent_for_ever() -> None:
    moment = 100.0
    ledger = ScriptedLedger()
    writer = Writer(ledger, lambda last: None, on_trouble=print, on_lost=print, clock=lambda: moment)
    assert writer.silent_for() == 0.0
    ledger.gate.clear()
    writer.start()
    writer.submit(1, [record("x")])
    assert ledger.entered.wait(BOUND)
    moment = 140.0
    assert writer.silent_for() == 40.0
    ledger.gate.set()
    writer.close()
    assert writer.silent_for() == math.inf


def test_the_loop_that_runs_is_the_one_that_feeds(manager: Manager) -> None:
    async def scenario() -> None:
        notifier = Notifier(manager.environ(WATCHDOG_USEC="40000"))
        notifier.feed(Heart())
        manager.heard()
        await asyncio.sleep(0)
        assert manager.heard() == []
        notifier.rest()

    run(scenario)
