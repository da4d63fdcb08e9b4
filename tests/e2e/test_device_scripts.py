"""The curl scripts about doors, buffers, chargers and emergencies, as people run them: real processes, sockets, real time."""

import json
import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from tests.e2e.processes import GENEROUS, HTTP, answers, free_ports, quick_plant, running, wait_until

SCRIPTS = Path(__file__).parents[2] / "examples/curl"
HALL = """
links:
  hall: {{protocol: enig, address: "127.0.0.1:{port}"}}
doors:
  DOOR1: {{link: hall, number: 30, through: [[105, 106]]}}
buffers:
  BUFFER1: {{link: hall, number: 21}}
"""


class People:
    """Somebody with a shell, by the name of kim unless another is given."""

    def __init__(self, url: str) -> None:
        self.url = url

    def run(self, script: str, *words: str, actor: str = "kim", code: int = 0) -> list[dict[str, Any]]:
        """Run a script and return every line of JSON that it printed."""
        env = {**os.environ, "HOISTWAY": self.url, "ACTOR": actor}
        command = [str(SCRIPTS / script), *words]
        ended = subprocess.run(command, capture_output=True, text=True, timeout=GENEROUS, env=env, check=False)
        assert ended.returncode == code, ended
        return [json.loads(line) for line in ended.stdout.splitlines() if line]

    def device(self, name: str) -> dict[str, Any]:
        """Return a device as it is now."""
        found: dict[str, Any] = HTTP.get(f"{self.url}/api/v1/devices/{name}", timeout=GENEROUS).json()
        return found

    def vehicles(self) -> list[dict[str, Any]]:
        """Return all vehicles."""
        found: list[dict[str, Any]] = HTTP.get(f"{self.url}/api/v1/vehicles", timeout=GENEROUS).json()["items"]
        return found


@contextmanager
def in_the_hall(directory: Path) -> Iterator[People]:
    """Start a simulated plant with a door and a buffer, and its controller."""
    plant = quick_plant("small", directory)
    link, port = free_ports(2)
    with plant.open("a", encoding="utf-8") as file:
        file.write(HALL.format(port=link))
    url, log = f"http://127.0.0.1:{port}", directory / "log"
    serve = ("serve", "--plant", str(plant), "--database", f"sqlite:///{directory}/plant.db", "--port", str(port))
    with running("sim", "--plant", str(plant), log=log), running(*serve, log=log):
        wait_until(lambda: answers(url), "the controller", log)
        people = People(url)
        wait_until(lambda: all(people.device(n)["fresh"] for n in ("DOOR1", "BUFFER1")), "the hall", log)
        wait_until(lambda: all(v["activity"] == "idle" for v in people.vehicles()), "the hoists", log)
        yield people


@pytest.fixture(scope="module")
def people(tmp_path_factory: pytest.TempPathFactory) -> Iterator[People]:
    with in_the_hall(tmp_path_factory.mktemp("hall")) as people:
        yield people


def test_devices_are_listed(people: People) -> None:
    ((listed),) = people.run("device-list.sh")
    assert [device["id"] for device in listed["items"]] == ["DOOR1", "BUFFER1"]


def test_a_door_is_opened_closed_and_tested(people: People) -> None:
    (opened,) = people.run("door-open.sh", "DOOR1")
    assert (opened["kind"], opened["state"], opened["actor"]) == ("open", "done", "kim")
    assert people.device("DOOR1")["state"] == "open"
    (closed,) = people.run("door-close.sh", "DOOR1")
    assert (closed["kind"], closed["state"]) == ("close", "done")
    tested = people.run("door-test.sh", "DOOR1")
    assert [part["state"] for part in tested[:2]] == ["done", "done"]
    assert [command["kind"] for command in tested[2]["items"]] == ["close", "open"]
    assert tested[3]["items"]


def test_what_a_device_cannot_do_is_refused_with_the_reason(people: People) -> None:
    (refused,) = people.run("device-command.sh", "DOOR1", "lock", code=1)
    assert refused["detail"] == "DOOR1 is a door and does not lock"


def test_a_door_is_kept_open_and_given_back(people: People) -> None:
    (kept,) = people.run("door-keep.sh", "DOOR1", "open", "moving in")
    assert (kept["pin"]["owner"], kept["pin"]["reason"]) == ("kim", "moving in")
    wait_until(lambda: people.device("DOOR1")["state"] == "open", "the door")
    (refused,) = people.run("door-close.sh", "DOOR1", actor="lee", code=1)
    assert refused["detail"] == "DOOR1 is kept open by kim: moving in"
    people.run("door-keep.sh", "DOOR1", "back")
    wait_until(lambda: people.device("DOOR1")["state"] == "closed", "the door")


def test_a_locked_out_device_takes_no_command_until_its_owner_lifts_it(people: People) -> None:
    people.run("device-lockout.sh", "DOOR1", "new motor")
    (refused,) = people.run("door-open.sh", "DOOR1", actor="lee", code=1)
    assert refused["detail"] == "DOOR1 is locked out by kim: new motor"
    (lifted,) = people.run("device-lockout.sh", "DOOR1", "--lift")
    assert lifted["lockout"] is None


def test_a_buffer_is_locked_and_unlocked(people: People) -> None:
    (locked,) = people.run("buffer-lock.sh", "BUFFER1")
    assert (locked["kind"], locked["state"]) == ("lock", "done")
    assert people.device("BUFFER1")["lock"]["owner"] == "kim"
    (unlocked,) = people.run("buffer-unlock.sh", "BUFFER1")
    assert (unlocked["kind"], unlocked["state"]) == ("unlock", "done")


def test_a_device_is_taken_out_of_service_and_put_back(people: People) -> None:
    (off,) = people.run("device-service.sh", "BUFFER1", "bent rail")
    assert (off["service"], off["out_of_service"]) == ("out_of_service", "bent rail")
    (on,) = people.run("device-service.sh", "BUFFER1")
    assert on["service"] == "in_service"


def test_a_fire_is_told_and_released(people: People) -> None:
    (told,) = people.run("emergency.sh", "fire", "smoke in bay 2", actor="fire-panel")
    assert told["emergencies"] == ["fire: smoke in bay 2 (fire-panel)"]
    (over,) = people.run("emergency.sh", "--release", "fire", "false alarm")
    assert (over["emergencies"], over["state"]) == ([], "paused")
    resumed = HTTP.post(f"{people.url}/api/v1/controller/resume", timeout=GENEROUS)
    assert resumed.json()["state"] == "auto"


def test_every_script_about_devices_is_run_here() -> None:
    text = Path(__file__).read_text(encoding="utf-8")
    names = {path.name for kind in ("door", "buffer", "device", "emergency") for path in SCRIPTS.glob(f"{kind}*.sh")}
    assert names
    assert all(f'"{name}"' in text for name in names)
