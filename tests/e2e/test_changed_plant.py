"""A plant that changes while it runs: jobs go on, what would break keeps the old plant, and back again."""

import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.e2e.processes import (
    COMMAND,
    GENEROUS,
    HTTP,
    answers,
    free_ports,
    journal_of,
    quick_plant,
    running,
    wait_until,
)
from tests.shares import shared

NEW = "  P9: {kind: port, at: 108, dest: {shft: 5, rota: 5, lift: 5}}\n"


class Plant:
    """A running plant, and its file."""

    def __init__(self, directory: Path, stack: ExitStack) -> None:
        self.file = quick_plant("small", directory)
        self.text = self.file.read_text(encoding="utf-8")
        simulated = directory / "simulated.yaml"
        simulated.write_text(self.text, encoding="utf-8")
        (port,) = free_ports(1)
        self.url, self.log, self.journal = f"http://127.0.0.1:{port}", directory / "serve.log", directory / "journal"
        sim = ("sim", "--plant", str(simulated), "--haste", "4", "--journal", str(self.journal))
        stack.enter_context(running(*sim, log=directory / "sim.log"))
        database = f"sqlite:///{directory / 'plant.db'}"
        self._stack = stack
        self._serve = ("serve", "--plant", str(self.file), "--database", database, "--port", str(port))

    def start(self, *killed_at: str) -> None:
        """Run the controller; ``killed_at``: until it is killed at that point."""
        command = (sys.executable, "-m", "tests.e2e.killed_at", *killed_at) if killed_at else COMMAND
        self.process = self._stack.enter_context(running(*self._serve, log=self.log, command=command))
        wait_until(lambda: answers(self.url) and self.idle(), "the plant", self.log)

    def get(self, path: str) -> Any:
        """Ask; a connection that is cut while the controller changes over is made anew, as any client must."""
        found: list[Any] = []

        def asked() -> bool:
            with suppress(httpx.TransportError):
                found.append(HTTP.get(f"{self.url}/api/v1{path}").json())
            return bool(found)

        wait_until(asked, path, self.log)
        return found[0]

    def idle(self) -> bool:
        return all(vehicle["activity"] == "idle" for vehicle in self.get("/vehicles")["items"])

    def order(self, name: str, source: str, destination: str) -> None:
        body = {"job_id": name, "source": source, "destination": destination}
        assert HTTP.post(f"{self.url}/api/v1/jobs", json=body).status_code == 201

    def change(self, text: str) -> None:
        """Write the file, and ask the controller to look at it."""
        self.file.write_text(text, encoding="utf-8")
        self.process.send_signal(signal.SIGHUP)

    def stations(self) -> set[str]:
        return {station["id"] for station in self.get("/stations")["items"]}

    def layout(self, *words: str) -> str:
        """Say ``hoistway layout …`` to the controller, and return what it says."""
        told = subprocess.run(
            [*COMMAND, "layout", *words, "--url", self.url],
            capture_output=True,
            text=True,
            timeout=GENEROUS,
            check=False,
        )
        return f"{told.stdout}{told.stderr}exit {told.returncode}"

    def versions(self) -> dict[int, str]:
        """Return number and state of all versions."""
        return {one["number"]: one["state"] for one in self.get("/layout/versions")["items"]}

    def said(self, text: str) -> bool:
        return text in self.log.read_text(encoding="utf-8")


@pytest.fixture
def plant(tmp_path: Path) -> Iterator[Plant]:
    with ExitStack() as stack:
        yield Plant(tmp_path, stack)


def with_port(text: str) -> str:
    return text.replace("  B1: {", NEW + "  B1: {")


def without(text: str, station: str) -> str:
    return "\n".join(line for line in text.splitlines() if not line.startswith(f"  {station}:")) + "\n"


def test_a_plant_changes_under_a_job_without_losing_it_and_changes_back(plant: Plant) -> None:
    plant.start()
    plant.order("J1", "P1", "P3")
    wait_until(lambda: plant.get("/jobs/J1")["picked"] is not None, "the carrier aboard", plant.log)
    plant.change(with_port(plant.text))
    wait_until(lambda: answers(plant.url) and "P9" in plant.stations(), "the new station", plant.log)
    wait_until(lambda: plant.get("/jobs/J1")["state"] == "completed", "the job", plant.log)
    assert [act["deed"] for act in journal_of(plant.journal) if act["carrier"] == "FOUP0001"] == ["take", "put"]

    plant.order("J2", "P3", "P2")
    plant.change(with_port(without(plant.text, "P2")))
    wait_until(lambda: plant.said("it names P2, which the new plant does not have"), "the refusal", plant.log)
    assert {"P2", "P9"} <= plant.stations()
    plant.change("barcodes: {}\n")
    wait_until(lambda: plant.said("the plant file has no track"), "the refusal of no plant", plant.log)
    wait_until(lambda: plant.get("/jobs/J2")["state"] == "completed", "the second job", plant.log)

    plant.change(plant.text)
    wait_until(lambda: answers(plant.url) and "P9" not in plant.stations(), "the plant as it was", plant.log)
    assert plant.process.poll() is None
    assert not plant.said("Traceback")


def test_maintenance_stages_a_layout_activates_it_waits_for_a_job_and_rolls_back(plant: Plant, tmp_path: Path) -> None:
    plant.start()
    new, less, wrong = (tmp_path / name for name in ("new.yaml", "less.yaml", "wrong.yaml"))
    new.write_text(with_port(plant.text), encoding="utf-8")
    less.write_text(with_port(without(plant.text, "P2")), encoding="utf-8")
    wrong.write_text(plant.text.replace("at: 104", "at: 904"), encoding="utf-8")

    told = plant.layout("stage", str(wrong), "--reason", "typing error")
    assert "904" in told
    assert "exit 1" in told
    told = plant.layout("stage", str(new), "--reason", "a port more")
    assert "station P9 added" in told
    assert "version 2 is staged" in told
    assert "exit 0" in told
    assert plant.versions() == {1: "active", 2: "staged"}
    assert plant.layout("activate", "2", "--reason", "it is built") == "version 2 is active\nexit 0"
    assert "P9" in plant.stations()

    HTTP.post(f"{plant.url}/api/v1/controller/pause", json={"reason": "one after the other"})
    plant.order("J1", "P1", "P2")
    plant.order("J2", "P2", "P3")
    told = plant.layout("stage", str(less), "--reason", "P2 goes")
    assert "in the way: job J1: it names P2, which the new plant does not have" in told
    told = plant.layout("activate", "3", "--reason", "P2 goes")
    assert "job J1 stands in the way" in told
    assert "exit 1" in told
    body = {"reason": "P2 goes", "wait": True}
    patient = HTTP.post(f"{plant.url}/api/v1/layout/versions/3/activate", json=body, headers={"X-Actor": "kim"})
    assert [one["name"] for one in patient.json()["in_the_way"]] == ["J1", "J2"]
    more = HTTP.post(f"{plant.url}/api/v1/jobs", json={"source": "P1", "destination": "P2"})
    assert (more.status_code, more.json()["detail"].partition(",")[0]) == (409, "P2 is not in version 3 of the plant")
    HTTP.post(f"{plant.url}/api/v1/controller/resume")
    wait_until(lambda: plant.versions() == {1: "former", 2: "former", 3: "active"}, "the change", plant.log)
    assert [plant.get(f"/jobs/{job}")["state"] for job in ("J1", "J2")] == ["completed"] * 2
    assert "P2" not in plant.stations()
    assert plant.layout("rollback", "--reason", "P2 stays") == "version 2 is active\nexit 0"
    assert {"P2", "P9"} <= plant.stations()
    assert not plant.said("Traceback")


@pytest.mark.parametrize(
    ("point", "when"),
    shared(
        [
            ("app.store.versions:VersionStore.activate", "after"),
            ("app.store.versions:VersionStore.ask", "after"),
            ("app.runtime.controller:Controller.stop", "before"),
            ("app.store.versions:VersionStore.activate", "before"),
        ],
        1,
    ),
)
def test_a_controller_killed_in_a_change_over_goes_on_with_one_version_and_all_jobs(
    plant: Plant, point: str, when: str
) -> None:
    plant.start(point, when)
    plant.order("J1", "P1", "P3")
    wait_until(lambda: plant.get("/jobs/J1")["picked"] is not None, "the carrier aboard", plant.log)
    text = with_port(plant.text)
    staging, headers = f"{plant.url}/api/v1/layout/versions?reason=a+port+more", {"Content-Type": "application/yaml"}
    assert HTTP.post(staging, content=text, headers=headers).status_code == 201
    with suppress(httpx.TransportError):
        body = {"reason": "it is built"}
        HTTP.post(f"{plant.url}/api/v1/layout/versions/2/activate", json=body, headers={"X-Actor": "kim"})
    wait_until(lambda: plant.process.poll() == -signal.SIGKILL, "the kill", plant.log)
    plant.start()
    wait_until(lambda: plant.versions() == {1: "former", 2: "active"}, "the change", plant.log)
    wait_until(lambda: plant.get("/jobs/J1")["state"] == "completed", "the job", plant.log)
    assert "P9" in plant.stations()
    assert [act["deed"] for act in journal_of(plant.journal) if act["carrier"] == "FOUP0001"] == ["take", "put"]
