"""Every curl script of teaching, run by a maintenance person against the simulated plant: one shift, in order."""

import os
import re
import signal
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.e2e.processes import GENEROUS, HTTP, answers, free_ports, quick_plant, running, wait_until

SCRIPTS = Path(__file__).parents[2] / "examples" / "curl" / "teaching"
ORDER = {"source": "P1", "destination": "P3", "vehicle": "V002"}


class Shift:
    """A person with a shell. ``done`` are the scripts run so far."""

    def __init__(self, url: str, operator: str, directory: Path) -> None:
        self.url = url
        self.directory = directory
        self.done: set[str] = set()
        self._env = {"HOISTWAY": url, "ACTOR": "kim", "STATION": "P1", "VEHICLE": "V001", "OPERATOR": operator}

    def run(self, script: str, *arguments: str, code: int = 0, **env: str) -> str:
        """Run a script as it stands, and return what it printed."""
        self.done.add(script)
        ended = subprocess.run(
            ["bash", str(SCRIPTS / script), *arguments],
            capture_output=True,
            text=True,
            timeout=GENEROUS,
            check=False,
            cwd=self.directory,
            env={**os.environ, **self._env, **env},
        )
        assert ended.returncode == code, (script, ended.stdout, ended.stderr)
        return ended.stdout if code == 0 else ended.stdout + ended.stderr

    def prints(self, words: str, script: str, **env: str) -> bool:
        """Run a script that goes on and on until it prints a line with these words; return whether it did."""
        self.done.add(script)
        with subprocess.Popen(
            ["bash", str(SCRIPTS / script)],
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, **self._env, **env},
            start_new_session=True,
        ) as watching:
            try:
                assert watching.stdout is not None
                return any(words in line for line in watching.stdout)
            finally:
                os.killpg(watching.pid, signal.SIGTERM)

    def get(self, path: str) -> Any:
        """Ask for something, past the scripts."""
        return HTTP.get(f"{self.url}/api/v1{path}").json()

    def order(self) -> httpx.Response:
        """Order a transfer from the port that is taught."""
        return HTTP.post(f"{self.url}/api/v1/jobs", json=ORDER)


@pytest.fixture
def shift(tmp_path: Path) -> Iterator[Shift]:
    """The small plant, whose port P1 was never taught."""
    plant = quick_plant("small", tmp_path)
    text, found = re.subn(r"(P1: \{.*?), dest: \{.*?\}", r"\1", plant.read_text(encoding="utf-8"))
    assert found == 1
    plant.write_text(text, encoding="utf-8")
    port, operator = free_ports(2)
    url, log = f"http://127.0.0.1:{port}", tmp_path / "demo.log"
    with running("demo", "--plant", str(plant), "--port", str(port), "--operator", str(operator), log=log):
        wait_until(lambda: answers(url), "the server", log)
        shift = Shift(url, f"http://127.0.0.1:{operator}", tmp_path)
        wait_until(lambda: ready(shift), "the vehicles", log)
        yield shift
    assert "Traceback" not in log.read_text(encoding="utf-8")


def ready(shift: Shift) -> bool:
    vehicles = shift.get("/vehicles")
    assert isinstance(vehicles, dict)
    return all(vehicle["activity"] == "idle" for vehicle in vehicles["items"])


def out_of_order_says_what_comes_first(shift: Shift) -> None:
    """Nothing was taught yet, and no session is open."""
    for script in ("teach-station.sh", "close-session.sh"):
        assert shift.run(script, code=1) == "no open session for P1: open-session.sh first\n"
    for script, *words in (("approve.sh",), ("reject.sh", "askew")):
        told = shift.run(script, *words, code=1)
        assert told == "no proposal about P1: teach-station.sh or reteach-lift.sh first\n"
    for script in ("compare.sh", "roll-back.sh"):
        refused = shift.run(script, "1", "2", code=1)
        assert "P1 has no version 1" in refused
        assert "Traceback" not in refused


def test_a_maintenance_persons_shift_of_teaching_is_curl(shift: Shift) -> None:
    refused = shift.order()
    assert (refused.status_code, refused.json()["detail"]) == (409, "P1 has no DEST (SHFT, ROTA, LIFT)")
    assert "would be refused: P1 has no DEST" in shift.run("what-would-be-sent.sh")

    out_of_order_says_what_comes_first(shift)
    assert "bring V001 to barcode 104" in shift.run("open-session.sh", 'say "new" load port')
    assert shift.get("/teaching/sessions/1")["note"] == 'say "new" load port'
    assert "session 1" in shift.run("open-session.sh", code=1)
    in_auto = shift.run("teach-station.sh", code=1)
    assert "needs MANT" in in_auto
    assert "Traceback" not in in_auto
    assert "in MANT" in shift.run("bring-vehicle.sh")
    waited = shift.run("reteach-lift.sh", code=1, OPERATOR="", PATIENCE="0", REMIND="0")
    assert waited.startswith("press LIFT DEST TEACHING on the hand controller of V001\n")
    assert "still waiting for LIFT DEST TEACHING of V001 at P1; ends after 0 s\n" in waited
    assert "nothing was taught at P1 in 0 s" in waited
    assert "LIFT is not set" in shift.run("reteach-lift.sh", code=2)
    assert "proposal 1 is ready" in shift.run("teach-station.sh")
    changes = shift.run("approve.sh")
    assert re.search(r"^P1 V001 shft - -> -?\d+ rota - -> -?\d+ lift - -> \d+", changes, re.MULTILINE)
    assert "proposal 1 is approved as version 1" in changes
    raw = shift.get("/teaching/proposals/1")
    assert isinstance(raw, dict)
    first = raw["raw"]["lift"]
    told = shift.run("what-would-be-sent.sh")
    assert f"lift {first}" in told
    assert "DEST version 1 by kim" in told
    other = shift.run("what-would-be-sent.sh", VEHICLE="V002")
    assert f"lift {first - 200}" in other

    lifted = first + 500
    assert f"'lift': {lifted}" in shift.run("reteach-lift.sh", LIFT=str(lifted))
    assert "drift: LIFT by +500" in shift.run("approve.sh")
    assert shift.run("drift.sh").startswith("P1 drifted: LIFT by +500 in version 2 by kim")
    assert shift.run("compare.sh", "1", "2").strip() == "{'shft': 0, 'rota': 0, 'lift': 500}"
    assert "'lift': -200" in shift.run("compare.sh", "V001", "V002")
    assert "version 3 restores version 1" in shift.run("roll-back.sh", "1", "the lifter was not down")

    shift.run("reteach-lift.sh", LIFT=str(first + 7))
    assert "is rejected" in shift.run("reject.sh", "taught askew")
    assert "proposal 4 is ready" in shift.run("teach-station.sh", WHAT="offset")
    assert "is approved as version 2" in shift.run("approve.sh", "4")
    assert "session 1 is closed" in shift.run("close-session.sh")

    assert shift.order().status_code == 201
    wait_until(lambda: "completed" in str(shift.get("/jobs")), "the end of the job")

    assert "kept/for git/dests.csv: 3 rows" in shift.run("export.sh", "kept/for git")
    assert "3 rows" in shift.run("export.sh", ".")
    assert (shift.directory / "kept/for git/dests.csv").read_bytes() == (shift.directory / "dests.csv").read_bytes()
    file = shift.directory / "dests.csv"
    file.write_text(re.sub(r"^(P2,1,\S+?,\S+?),\d+", r"\1,45000", file.read_text(), flags=re.MULTILINE))
    assert "line 3 P2 changed LIFT 41200 -> 45000" in shift.run("import.sh", "dests.csv")
    assert "'changed': 1" in shift.run("import.sh", "dests.csv", CONFIRM="yes").splitlines()[-1]
    assert "1 of 3 rows are wrong" in shift.run("import.sh", "dests.csv", code=1, CONFIRM="yes")
    elsewhere = shift.directory / "of a colleague"
    elsewhere.mkdir()
    (elsewhere / "-ports (2).csv").write_text(file.read_text())
    assert "dry run of dests: {'new': 0" in shift.run("import.sh", "of a colleague/-ports (2).csv")
    (shift.directory / "-dests.csv").write_bytes(b"\xef\xbb\xbf" + (shift.directory / "offsets.csv").read_bytes())
    assert "dry run of offsets: {'new': 0" in shift.run("import.sh", "-dests.csv")
    file_of_none = shift.directory / "none.csv"
    file_of_none.write_text("place,lift\nP1,1\n")
    assert "none.csv: its first line names no column station" in shift.run("import.sh", "none.csv", code=1)
    assert "there is no such file" in shift.run("import.sh", "nowhere.csv", code=1)
    assert "usage: import.sh FILE.csv\n" in shift.run("import.sh", code=2)
    shift.run("export.sh", ".", HISTORY="true")
    assert len((shift.directory / "dests.csv").read_text().splitlines()) == 7

    history = shift.run("history.sh")
    assert len(re.findall(r"^version", history, re.MULTILINE)) == 3
    assert len(re.findall(r"^event", history, re.MULTILINE)) == 8
    assert shift.prints('"event":"TeachingApproved"', "watch.sh", AFTER="0", SECONDS_LONG=f"{GENEROUS:.0f}")
    assert shift.done == {file.name for file in SCRIPTS.glob("[!_]*.sh")}


def test_a_reference_vehicle_is_sent_what_the_port_is(tmp_path: Path) -> None:
    plant = quick_plant("small", tmp_path)
    text, found = re.subn(r"(V001: \{.*?), offset: \{.*?\}", r"\1, reference: true", plant.read_text(encoding="utf-8"))
    assert found == 1
    plant.write_text(text, encoding="utf-8")
    (port,) = free_ports(1)
    url, log = f"http://127.0.0.1:{port}", tmp_path / "serve.log"
    database = f"sqlite:///{tmp_path}/plant.db"
    with running("serve", "--plant", str(plant), "--database", database, "--port", str(port), log=log):
        wait_until(lambda: answers(url), "the server", log)
        shift = Shift(url, "", tmp_path)
        lines = shift.run("what-would-be-sent.sh").splitlines()
        port_itself = shift.get("/stations/P1/dest")["items"][0]
        assert lines[0] == "V001 at P1: shft {shft}, rota {rota}, lift {lift}".format(**port_itself)
        assert lines[2] == "and no OFFSET: V001 is a reference vehicle, whose OFFSET is zero by declaration"
        other = shift.run("what-would-be-sent.sh", VEHICLE="V002").splitlines()
        assert other[2].startswith("and OFFSET version 1 by ")
