"""The curl scripts of the control room as people run them: real processes, sockets, real time, and a kill in between."""

import json
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.e2e.processes import GENEROUS, HTTP, answers, free_ports, quick_plant, running, wait_until
from tests.e2e.test_killed_server import Server

SCRIPTS = Path(__file__).parents[2] / "examples/curl"


class Room:
    """Somebody with a shell in a control room; the controller can be killed."""

    def __init__(self, server: Server) -> None:
        self.server = server

    def run(self, script: str, *words: str, actor: str = "kim", code: int = 0, **more: str) -> Any:
        """Run a script and return what it printed, as JSON."""
        env = {**os.environ, "HOISTWAY": self.server.url, "ACTOR": actor, **more}
        ended = subprocess.run(
            [str(SCRIPTS / script), *words], capture_output=True, text=True, timeout=GENEROUS, env=env, check=False
        )
        assert ended.returncode == code, ended
        return json.loads(ended.stdout)

    def get(self, path: str) -> Any:
        """Return an answer of the API."""
        return HTTP.get(f"{self.server.url}/api/v1{path}", timeout=GENEROUS).json()

    def kill(self) -> None:
        """Kill the controller with -9, and start it again."""
        self.server.kill()
        self.server.start()
        self.settle()

    def settle(self) -> None:
        """Wait until both hoists have said where they are."""
        self.server.ready()
        idle = lambda: all(v["activity"] == "idle" for v in self.get("/vehicles")["items"])  # noqa: E731
        wait_until(idle, "the hoists", self.server.log)


@pytest.fixture(scope="module")
def room(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Room]:
    directory = tmp_path_factory.mktemp("room")
    plant = quick_plant("small", directory)
    server = Server(plant, directory)
    with running("sim", "--plant", str(plant), log=directory / "sim.log"):
        server.start()
        try:
            room = Room(server)
            room.settle()
            yield room
        finally:
            server.close()


def test_a_fire_is_an_alarm_that_a_person_acknowledges(room: Room) -> None:
    told = HTTP.post(
        f"{room.server.url}/api/v1/controller/emergency",
        json={"kind": "fire", "reason": "smoke"},
        headers={"X-Actor": "panel"},
        timeout=GENEROUS,
    )
    assert told.status_code == 200
    room.kill()
    (alarm,) = [one for one in room.get("/alarms/active")["items"] if one["kind"] == "plant"]
    seen = room.run("alarm-acknowledge.sh", str(alarm["id"]), "on my way")
    assert (seen["acknowledged_by"], seen["note"], seen["code"]) == ("kim", "on my way", "fire")
    room.run("emergency.sh", "--release", "fire", "toast")
    HTTP.post(f"{room.server.url}/api/v1/controller/resume", timeout=GENEROUS)
    ended = room.get(f"/alarms/{alarm['id']}")
    assert (ended["outcome"], ended["acknowledged_by"]) == ("fire is over: toast (kim)", "kim")


def test_a_closure_is_previewed_made_survives_a_kill_and_is_opened_by_its_owner(room: Room) -> None:
    preview = room.run("closure-preview.sh", "stretch", "105", "107")
    assert preview["stations"] == ["P2"]
    closed = room.run("closure-close.sh", "rail change", "stretch", "105", "107", PURPOSE="work")
    number = str(closed["id"])
    room.kill()
    (kept,) = room.run("closure-list.sh")["items"]
    assert (kept["id"], kept["barcodes"], kept["owner"]) == (closed["id"], ["105", "106", "107"], "kim")
    wait_until(lambda: room.get(f"/closures/{number}")["state"] == "closed", "the closure")
    refused = room.run("closure-open.sh", number, actor="lee", code=22)
    assert refused["detail"] == f"closure {number} is kim's, for people at work; your wish to open it is noted"
    assert room.run("closure-open.sh", number, "rail is back")["state"] == "opened"
    # A list may be 100 ms old.
    wait_until(lambda: room.run("closure-list.sh")["items"] == [], "a list without it")
    asked = [row["action"] for row in room.get("/audit")["items"]]
    assert [action for action in asked if "Place" in action] == ["ClosePlace", "OpenPlace", "OpenPlace"]


def test_a_walk_is_begun_entered_and_accepted_over_a_kill(room: Room) -> None:
    walk = str(room.run("walk-start.sh", "after the outage", "B1", "B2")["id"])
    room.run("walk-enter.sh", walk, "B1", "empty")
    room.kill()
    refused = room.run("walk-accept.sh", walk, code=22)
    assert refused["detail"] == "not seen, or changed since: B2"
    room.run("walk-enter.sh", walk, "B2", "full", "FOUP0002")
    assert [row["finding"] for row in room.get(f"/walks/{walk}/places")["items"]] == ["differs", "differs"]
    assert room.run("walk-accept.sh", walk)["state"] == "accepted"
    carrier = room.get("/carriers/FOUP0002")
    assert (carrier["place"], carrier["provenance"], carrier["verified"]) == ("B2", "verified", True)


def test_an_incident_is_exported_and_opened_elsewhere(room: Room, tmp_path: Path) -> None:
    def recorded() -> bool:
        span = room.get("/history/span")
        return span["from"] is not None and span["to"] > span["from"]

    wait_until(recorded, "the recording")
    span = room.get("/history/span")
    file = tmp_path / "incident.hoistway.gz"
    room.run("incident-export.sh", span["from"], span["to"], str(file))
    (port,) = free_ports(1)
    url, log = f"http://127.0.0.1:{port}", tmp_path / "replay.log"
    with running("replay", str(file), "--port", str(port), log=log):
        wait_until(lambda: answers(url), "the replay", log)
        moment = HTTP.get(f"{url}/api/v1/history", params={"at": span["to"]}, timeout=GENEROUS).json()
        assert set(moment["objects"]["vehicles"]) == {"V001", "V002"}
        assert HTTP.get(f"{url}/api/v1/layout", timeout=GENEROUS).json()["name"] == "small"
        refused = HTTP.post(f"{url}/api/v1/controller/pause", json={"reason": "x"}, timeout=GENEROUS)
        assert refused.json()["detail"] == "This is a recording."
    assert "plant small" in log.read_text(encoding="utf-8")


def test_every_script_of_the_control_room_is_run_here() -> None:
    text = Path(__file__).read_text(encoding="utf-8")
    scripts = {file.name for kind in ("closure", "alarm", "walk", "incident") for file in SCRIPTS.glob(f"{kind}-*.sh")}
    helpers = {"closure-place.sh"}
    assert scripts >= helpers
    assert {name for name in scripts - helpers if f'run("{name}"' not in text} == set()
