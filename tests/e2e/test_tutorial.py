"""The tutorial's commands, word by word, as one person runs them in several terminals."""

import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from pathlib import Path

import pytest

from tests.e2e.processes import GENEROUS, HTTP, answers, free_ports, wait_until

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "tutorial.md"
NOT_HERE = ("make setup", "source .venv/bin/activate")
"""What sets up the very environment that runs this test."""
STAYS = ("hoistway sim", "hoistway serve")
"""Commands of terminals of their own."""
FAILS = {"hoistway layout diff myfab/simulated.yaml myfab/plant.yaml": 1}
"""Commands that end with something else than 0, as the page says."""


def commands() -> list[str]:
    """Return what stands indented on the page, outside lists."""
    return [line.strip() for line in PAGE.read_text(encoding="utf-8").splitlines() if re.match(r" {4}\S", line)]


class Desk:
    """A person's directory and terminals; ports of the page are replaced by free ones, and vehicles are quick."""

    def __init__(self, directory: Path) -> None:
        self.directory = directory
        ports = free_ports(5)
        named = ("8080", "17101", "17102", "17103", "17501")
        self._ports = dict(zip(named, map(str, ports), strict=True))
        self.url = f"http://127.0.0.1:{ports[0]}"
        (directory / "examples").symlink_to(ROOT / "examples")
        (directory / "bin").mkdir()
        hoistway = directory / "bin" / "hoistway"
        hoistway.write_text(
            f'#!/bin/sh\nPYTHONPATH="{ROOT}" exec "{sys.executable}" -m app.cli "$@"\n', encoding="utf-8"
        )
        hoistway.chmod(0o755)
        self._env = {**os.environ, "PATH": f"{directory / 'bin'}:{os.environ['PATH']}", "PYTHONUNBUFFERED": "1"}
        self._env["HOISTWAY_PORT"] = str(ports[0])
        self._terminals: list[subprocess.Popen[bytes]] = []
        self.log = directory / "terminals.log"

    def own(self, text: str) -> str:
        """Return a text with ports of our own."""
        return re.sub(r"\b(8080|1710[123]|17501)\b", lambda match: self._ports[match[1]], text)

    def start(self, command: str) -> None:
        """Run a command in a terminal of its own."""
        quick = " --haste 20" if command.startswith("hoistway sim") else ""
        with self.log.open("ab") as out:
            started = subprocess.Popen(
                ["bash", "-c", f"exec {self.own(command)}{quick}"],
                cwd=self.directory, env=self._env, stdout=out, stderr=out, stdin=subprocess.DEVNULL,
            )  # fmt: skip
        self._terminals.append(started)

    def end_all(self) -> None:
        """Press Ctrl-C in every terminal."""
        for terminal in self._terminals:
            terminal.send_signal(signal.SIGINT)
        for terminal in self._terminals:
            with suppress(subprocess.TimeoutExpired):
                terminal.wait(30)
            if terminal.poll() is None:
                terminal.kill()
        self._terminals.clear()

    def run(self, command: str) -> str:
        """Run a command, and return what it printed."""
        if command.startswith("export "):
            self._env |= dict(pair.split("=", 1) for pair in self.own(command).split()[1:])
            return ""
        ended = subprocess.run(
            ["bash", "-c", self.own(command)],
            cwd=self.directory, env=self._env, capture_output=True, text=True, timeout=GENEROUS, check=False,
        )  # fmt: skip
        told = self.log.read_text(encoding="utf-8", errors="replace")[-2000:] if self.log.exists() else ""
        assert ended.returncode == FAILS.get(command, 0), (command, ended.stdout, ended.stderr, told)
        return ended.stdout

    def quicken(self) -> None:
        """Make the vehicles of the plant quick, and let them listen where nobody else does."""
        plant = self.directory / "myfab" / "plant.yaml"
        text = self.own(plant.read_text(encoding="utf-8"))
        for field, value in {"max_speed": 8000, "curve_speed": 4000, "acceleration": 8000, "braking": 8000}.items():
            text = re.sub(rf"^  {field}: .*$", f"  {field}: {value}", text, flags=re.MULTILINE)
        plant.write_text(text, encoding="utf-8")

    def idle(self, *vehicles: str) -> bool:
        """Whether these vehicles have nothing to do."""
        found = HTTP.get(f"{self.url}/api/v1/vehicles").json()["items"]
        return all(vehicle["activity"] == "idle" for vehicle in found if vehicle["id"] in vehicles)


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Desk]:
    with ExitStack() as stack:
        made = Desk(tmp_path)
        stack.callback(made.end_all)
        yield made


def test_every_command_of_the_tutorial_works_word_by_word(desk: Desk) -> None:
    told: dict[str, str] = {}
    wanted = [command for command in commands() if command not in NOT_HERE]
    for command in wanted:
        if command.startswith(STAYS):
            desk.start(command)
            continue
        if command.startswith("rm "):
            desk.end_all()
        if "127.0.0.1:8080" in command and command.startswith("curl"):
            wait_until(lambda: answers(desk.url) and desk.idle("V001", "V002", "V003"), "the plant", desk.log)
        if match := re.fullmatch(r"curl http\S+/jobs/(\S+)", command):
            wait_until(lambda c=command: '"state":"completed"' in desk.run(c), match[1], desk.log)  # type: ignore[misc]
        told[command] = desk.run(command)
        if command.startswith("hoistway layout import myfab"):
            desk.quicken()
        if command.startswith("hoistway layout import examples"):
            # The vehicles are quick here, and at ports of their own: what the list says is compared below.
            korean = desk.directory / "myfab" / "korean.yaml"
            korean.write_text((desk.directory / "myfab" / "plant.yaml").read_text(encoding="utf-8"), encoding="utf-8")
    jobs = {name: json.loads(text) for name, text in told.items() if re.fullmatch(r"curl http\S+/jobs/\S+", name)}
    assert [job["vehicle"] for job in jobs.values()][1:] == ["V001", "V002"]
    assert all(job["state"] == "completed" for job in jobs.values())
    refused = next(text for name, text in told.items() if '"destination": "STK01-P2"}' in name)
    assert "STK01-P2 has no DEST" in refused
    assert any(
        "0 errors, 0 warnings" in text for name, text in told.items() if name.startswith("hoistway layout import")
    )
    assert "V001" in told["hoistway layout diff myfab/simulated.yaml myfab/plant.yaml"]
    assert "Traceback" not in desk.log.read_text(encoding="utf-8", errors="replace")


def test_the_korean_list_is_the_same_plant(tmp_path: Path) -> None:
    desk = Desk(tmp_path)
    (tmp_path / "myfab").mkdir()
    for command in commands():
        if command.startswith(("hoistway layout import", "cp examples")):
            desk.run(command)
    assert desk.run("hoistway layout diff myfab/plant.yaml myfab/korean.yaml") == "no difference\n"
