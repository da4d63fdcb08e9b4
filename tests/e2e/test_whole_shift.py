"""A maintenance person's whole shift with curl: a port, a drive behind a noisy cable, a door; real processes, real sockets."""

import json
import os
import re
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest

from app.wire.faults import Fault
from tests.e2e.noise import noisy
from tests.e2e.processes import GENEROUS, HTTP, answers, free_ports, quick_plant, running, wait_until

SCRIPTS = Path(__file__).parents[2] / "examples/curl"
EQUIPMENT = """
links:
  axes: {{protocol: hi, address: "127.0.0.1:{axes}"}}
  hall: {{protocol: enig, address: "127.0.0.1:{hall}"}}
doors:
  DOOR1: {{link: hall, number: 30, through: [[105, 106]]}}
drives:
  AX1: {{link: axes, id: 1, model: demo}}
  AX2: {{link: axes, id: 2, model: demo}}
"""
NOISE = {Fault.NOISE: 0.05, Fault.DROP: 0.03, Fault.DUPLICATE: 0.03, Fault.SPLIT: 0.05}
"""What befalls packets to and from the drives. No flipped bits: the checksum of four bits lets one in sixteen pass."""
ORDER = {"source": "P1", "destination": "P3"}


class Shift:
    """Somebody with a shell."""

    def __init__(self, url: str, directory: Path, operator: int) -> None:
        self.url, self._directory = url, directory
        hands = f"http://127.0.0.1:{operator}"
        self._env = {"HOISTWAY": url, "ACTOR": "kim", "STATION": "P1", "VEHICLE": "V001", "OPERATOR": hands}

    def run(self, script: str, *words: str, **env: str) -> str:
        """Run a script and return what it printed."""
        ended = subprocess.run(
            ["bash", str(SCRIPTS / script), *words],
            capture_output=True,
            text=True,
            timeout=2 * GENEROUS,
            check=False,
            cwd=self._directory,
            env={**os.environ, **self._env, **env},
        )
        assert ended.returncode == 0, (script, ended.stdout, ended.stderr)
        return ended.stdout

    def last(self, script: str, *words: str) -> dict[str, Any]:
        """Run a script and return the last JSON that it printed."""
        found: dict[str, Any] = json.loads(self.run(script, *words).strip().splitlines()[-1])
        return found

    def get(self, path: str) -> dict[str, Any]:
        """Ask for something, past the scripts."""
        found: dict[str, Any] = HTTP.get(f"{self.url}/api/v1{path}", timeout=GENEROUS).json()
        return found

    def order(self) -> httpx.Response:
        """Order a transfer from the port that is taught."""
        return HTTP.post(f"{self.url}/api/v1/jobs", json=ORDER, timeout=GENEROUS)


@contextmanager
def on_shift(directory: Path) -> Iterator[Shift]:
    """The small plant, whose port P1 was never taught, with a door and two drives; its cable to the drives is noisy."""
    plant, log = quick_plant("small", directory), directory / "log"
    axes, hall, port, operator = free_ports(4)
    text, found = re.subn(r"(P1: \{.*?), dest: \{.*?\}", r"\1", plant.read_text(encoding="utf-8"))
    assert found == 1
    plant.write_text(text + EQUIPMENT.format(axes=axes, hall=hall), encoding="utf-8")
    url = f"http://127.0.0.1:{port}"
    sim = ("sim", "--plant", str(plant), "--operator", str(operator), "--panel", "AX2=jog")
    with running(*sim, log=log), noisy(axes, NOISE, seed=1) as spoiled:
        seen = directory / "seen.yaml"
        seen.write_text(plant.read_text(encoding="utf-8").replace(f":{axes}", f":{spoiled}"), encoding="utf-8")
        serve = ("serve", "--plant", str(seen), "--database", f"sqlite:///{directory}/plant.db", "--port", str(port))
        with running(*serve, log=log):
            wait_until(lambda: answers(url), "the controller", log)
            shift = Shift(url, directory, operator)
            wait_until(lambda: ready(shift), "vehicles, door and drives", log)
            yield shift
    assert "Traceback" not in log.read_text(encoding="utf-8")


def ready(shift: Shift) -> bool:
    vehicles, devices, drives = (shift.get(path)["items"] for path in ("/vehicles", "/devices", "/drives"))
    return (
        all(vehicle["activity"] == "idle" for vehicle in vehicles)
        and all(device["fresh"] for device in devices)
        and all(drive["online"] for drive in drives)
    )


def a_new_port_is_taught_used_and_rolled_back(shift: Shift) -> None:
    refused = shift.order()
    assert (refused.status_code, refused.json()["detail"]) == (409, "P1 has no DEST (SHFT, ROTA, LIFT)")
    for script in ("open-session", "bring-vehicle", "teach-station", "approve"):
        shift.run(f"teaching/{script}.sh")
    shift.run("teaching/reteach-lift.sh", LIFT="41500")
    shift.run("teaching/approve.sh")
    assert "version 3 restores version 1" in shift.run("teaching/roll-back.sh", "1", "the lifter was not down")
    shift.run("teaching/close-session.sh")
    taken = shift.order()
    assert taken.status_code == 201
    job = f"/jobs/{taken.json()['id']}"
    wait_until(lambda: shift.get(job)["state"] == "completed", "the end of the job")


def a_drive_is_read_written_and_restored_through_noise(shift: Shift) -> None:
    parameters = {row["number"]: row for row in shift.last("drive-read-all.sh", "AX1")["items"]}
    assert len(parameters) == 256
    assert all(row["raw"] is not None for row in parameters.values())
    backup = shift.run("drive-backup.sh", "AX1", "before the shift", "saved.csv").strip()
    assert shift.last("drive-write.sh", "AX1", "00", "2.5")["result"] == {"before": 150, "after": 250}
    (real,) = shift.last("drive-restore.sh", "AX1", backup, "really")["result"]["rows"]
    assert (real["parameter"], real["fate"]) == ("00", "written")
    assert shift.last("drive-compare.sh", "AX1", backup)["result"]["differences"] == []
    (figures,) = (link["figures"] for link in shift.get("/links")["items"] if link["id"] == "axes")
    assert figures["garbled"] + figures["timeouts"] + figures["naks"] > 0


def an_axis_is_jogged(shift: Shift) -> None:
    def jogged() -> bool:
        """Whether the axis was let go, and not stopped since half a second went by between two beats of the script."""
        ended = shift.last("drive-jog.sh", "AX2", "cw", "1")
        return bool(ended["result"].get("ended") == "released")

    wait_until(jogged, "a jog that is let go")
    wait_until(lambda: (shift.get("/drives/AX2")["distance"] or 0) > 0, "the distance")


def a_door_is_opened(shift: Shift) -> None:
    assert shift.last("door-open.sh", "DOOR1")["state"] == "done"
    assert shift.get("/devices/DOOR1")["state"] == "open"


@pytest.mark.campaign
def test_a_maintenance_persons_whole_shift_is_curl(tmp_path: Path) -> None:
    with on_shift(tmp_path) as shift:
        a_new_port_is_taught_used_and_rolled_back(shift)
        a_drive_is_read_written_and_restored_through_noise(shift)
        an_axis_is_jogged(shift)
        a_door_is_opened(shift)
