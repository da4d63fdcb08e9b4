"""The curl scripts of the control room as people run them: real processes, sockets, real time, and a kill in between."""

import json
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.e2e.processes import GENEROUS, HTTP, quick_plant, running, wait_until
from tests.e2e.test_killed_server import Server

SCRIPTS = Path(__file__).parents[2] / "examples/curl"
pytestmark = pytest.mark.xdist_group("room scripts")


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
    assert room.run("closure-list.sh")["items"] == []
    assert [row["action"] for row in room.get("/audit")["items"]] == ["ClosePlace", "OpenPlace", "OpenPlace"]
