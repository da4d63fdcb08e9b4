"""The curl scripts about drives, as a maintenance person runs them: real processes, a serial line, real time."""

import json
import os
import re
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tests.e2e.processes import GENEROUS, HTTP, answers, free_ports, quick_plant, running, wait_until

ROOT = Path(__file__).parents[2]
SCRIPTS = ROOT / "examples/curl"
LINE = """
links:
  axes: {{protocol: hi, serial: {{device: {device}}}}}
drives:
  AX1: {{link: axes, id: 1, model: demo, name: Shutter}}
  AX2: {{link: axes, id: 2, model: demo}}
  AX3: {{link: axes, id: 3, model: demo}}
"""


class Maintenance:
    """Somebody with a shell."""

    def __init__(self, url: str, directory: Path) -> None:
        self.url, self.directory = url, directory

    def run(self, script: str, *words: str, code: int = 0) -> str:
        """Run a script and return what it printed."""
        env = {**os.environ, "HOISTWAY": self.url, "ACTOR": "kim"}
        ended = subprocess.run(
            [str(SCRIPTS / script), *words],
            capture_output=True,
            text=True,
            timeout=2 * GENEROUS,
            env=env,
            cwd=self.directory,
            check=False,
        )
        assert ended.returncode == code, ended
        return ended.stdout

    def last(self, script: str, *words: str, code: int = 0) -> dict[str, Any]:
        """Run a script and return the last JSON that it printed."""
        found: dict[str, Any] = json.loads(self.run(script, *words, code=code).strip().splitlines()[-1])
        return found

    def get(self, path: str) -> dict[str, Any]:
        found: dict[str, Any] = HTTP.get(f"{self.url}/api/v1{path}", timeout=GENEROUS).json()
        return found


@contextmanager
def on_shift(directory: Path) -> Iterator[Maintenance]:
    """Start the simulated plant, two of whose drives are in jog and in error, and its controller."""
    plant = quick_plant("small", directory)
    with plant.open("a", encoding="utf-8") as file:
        file.write(LINE.format(device=directory / "axes"))
    (port,) = free_ports(1)
    url, log = f"http://127.0.0.1:{port}", directory / "log"
    panels = ("--panel", "AX2=jog", "--panel", "AX3=error7")
    serve = ("serve", "--plant", str(plant), "--database", f"sqlite:///{directory}/plant.db", "--port", str(port))
    with running("sim", "--plant", str(plant), *panels, log=log), running(*serve, log=log):
        wait_until(lambda: answers(url), "the controller", log)
        person = Maintenance(url, directory)
        online = [f"/drives/AX{n}" for n in (1, 2, 3)]
        wait_until(lambda: all(person.get(path)["online"] for path in online), "the drives", log)
        yield person


def drives_and_their_lines_are_listed(shift: Maintenance) -> None:
    drives, links = (json.loads(line) for line in shift.run("drive-list.sh").splitlines())
    assert [drive["id"] for drive in drives["items"]] == ["AX1", "AX2", "AX3"]
    assert (links["items"][0]["id"], links["items"][0]["up"]) == ("axes", True)


def all_parameters_are_read_one_is_written_and_the_drive_restored(shift: Maintenance) -> None:
    parameters = {row["number"]: row for row in shift.last("drive-read-all.sh", "AX1")["items"]}
    assert len(parameters) == 256
    assert (parameters["00"]["name"], parameters["00"]["text"]) == ("Acceleration time", "1.50 s")
    assert all(row["raw"] is not None for row in parameters.values())

    backup = shift.run("drive-backup.sh", "AX1", "before tuning", "saved.csv").strip()
    assert "00,150,Acceleration time,1.5,s" in (shift.directory / "saved.csv").read_text(encoding="utf-8")

    assert shift.last("drive-write.sh", "AX1", "00", "2.5")["result"] == {"before": 150, "after": 250}
    refused = shift.last("drive-write.sh", "AX1", "00", "99", code=1)
    assert "0.10 s to 60.00 s" in refused["detail"]
    assert "is read-only" in shift.last("drive-write.sh", "AX1", "FF", "1", code=1)["detail"]

    (difference,) = shift.last("drive-compare.sh", "AX1", backup)["result"]["differences"]
    assert (difference["parameter"], difference["here"], difference["there"]) == ("00", 250, 150)
    (dry,) = shift.last("drive-restore.sh", "AX1", backup)["result"]["rows"]
    assert dry["fate"] == "write"
    assert shift.last("drive-compare.sh", "AX1", backup)["result"]["differences"]
    (real,) = shift.last("drive-restore.sh", "AX1", backup, "really")["result"]["rows"]
    assert real["fate"] == "written"
    assert shift.last("drive-compare.sh", "AX1", backup)["result"]["differences"] == []
    assert shift.last("drive-compare.sh", "AX1", "AX2")["result"]["differences"] == []

    history = [event["detail"] for event in shift.get("/events?limit=1000")["items"] if event["source"] == "AX1"]
    assert history == [
        "00 (Acceleration time): 0150 (1.50 s) -> 0250 (2.50 s), by kim",
        "00 (Acceleration time): 0250 (2.50 s) -> 0150 (1.50 s), by kim",
    ]


def an_axis_is_jogged_for_a_second(shift: Maintenance) -> None:
    ended: list[dict[str, Any]] = []

    def jogged() -> bool:
        """Whether the axis was let go, and not stopped since half a second went by between two beats of the script."""
        ended.append(shift.last("drive-jog.sh", "AX2", "cw", "1"))
        return bool(ended[-1]["result"].get("ended") == "released")

    wait_until(jogged, "a jog that is let go")
    assert (ended[-1]["state"], ended[-1]["result"]["moving"]) == ("done", True)
    wait_until(lambda: (shift.get("/drives/AX2")["distance"] or 0) > 0, "the distance")
    refused = shift.run("drive-jog.sh", "AX1", "cw", "1", code=1)
    assert refused == ""


def an_error_is_explained_and_reset(shift: Maintenance) -> None:
    before, reset, after = (json.loads(line) for line in shift.run("drive-reset.sh", "AX3").splitlines())
    assert (before["mode"], before["code"], before["error"]) == ("error", 7, "overload")
    assert reset["state"] == "done"
    assert after["result"]["mode"] == "parameter_select"


def all_drives_of_a_line_are_stopped(shift: Maintenance) -> None:
    assert shift.last("drive-stop-all.sh", "axes")["kind"] == "stop_all"
    shift.run("drive-stop-all.sh", "nope", code=1)


def test_a_maintenance_person_does_everything_with_curl(tmp_path: Path) -> None:
    with on_shift(tmp_path) as shift:
        drives_and_their_lines_are_listed(shift)
        all_parameters_are_read_one_is_written_and_the_drive_restored(shift)
        an_axis_is_jogged_for_a_second(shift)
        an_error_is_explained_and_reset(shift)
        all_drives_of_a_line_are_stopped(shift)


def test_every_script_is_tried_here() -> None:
    tried = set(re.findall(r'"(drive-[a-z-]+[.]sh)"', Path(__file__).read_text(encoding="utf-8")))
    assert tried == {file.name for file in SCRIPTS.glob("drive-*.sh")}
