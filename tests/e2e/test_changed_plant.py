"""A plant that changes while it runs: jobs go on, what would break keeps the old plant, and back again."""

import signal
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.e2e.processes import HTTP, answers, free_ports, journal_of, quick_plant, running, wait_until

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
        serve = ("serve", "--plant", str(self.file), "--database", database, "--port", str(port))
        self.process: subprocess.Popen[bytes] = stack.enter_context(running(*serve, log=self.log))
        wait_until(lambda: answers(self.url) and self.idle(), "the plant", self.log)

    def get(self, path: str) -> Any:
        """Ask; a connection that is cut while the controller changes over is made anew, as any client must."""
        found: list[Any] = []

        def asked() -> bool:
            with suppress(httpx.TransportError):
                found.append(HTTP.get(f"{self.url}/api/v1{path}", timeout=30.0).json())
            return bool(found)

        wait_until(asked, path, self.log)
        return found[0]

    def idle(self) -> bool:
        return all(vehicle["activity"] == "idle" for vehicle in self.get("/vehicles")["items"])

    def order(self, name: str, source: str, destination: str) -> None:
        body = {"job_id": name, "source": source, "destination": destination}
        assert HTTP.post(f"{self.url}/api/v1/jobs", json=body, timeout=30.0).status_code == 201

    def change(self, text: str) -> None:
        """Write the file, and ask the controller to look at it."""
        self.file.write_text(text, encoding="utf-8")
        self.process.send_signal(signal.SIGHUP)

    def stations(self) -> set[str]:
        return {station["id"] for station in self.get("/stations")["items"]}

    def said(self, text: str) -> bool:
        return text in self.log.read_text(encoding="utf-8")


@pytest.fixture
def plant(tmp_path: Path) -> Iterator[Plant]:
    with ExitStack() as stack:
        yield Plant(tmp_path, stack)


def test_a_plant_changes_under_a_job_without_losing_it_and_changes_back(plant: Plant) -> None:
    plant.order("J1", "P1", "P3")
    wait_until(lambda: plant.get("/jobs/J1")["picked"] is not None, "the carrier aboard", plant.log)
    plant.change(plant.text.replace("  B1: {", NEW + "  B1: {"))
    wait_until(lambda: answers(plant.url) and "P9" in plant.stations(), "the new station", plant.log)
    wait_until(lambda: plant.get("/jobs/J1")["state"] == "completed", "the job", plant.log)
    assert [act["deed"] for act in journal_of(plant.journal) if act["carrier"] == "FOUP0001"] == ["take", "put"]

    plant.order("J2", "P3", "P2")
    without = "\n".join(line for line in plant.text.splitlines() if not line.startswith("  P2:")) + "\n"
    plant.change(without.replace("  B1: {", NEW + "  B1: {"))
    wait_until(lambda: plant.said("it names P2, which the new plant does not have"), "the refusal", plant.log)
    assert {"P2", "P9"} <= plant.stations()
    plant.change("barcodes: {}\n")
    wait_until(lambda: plant.said("has 1 errors") or plant.said(" errors"), "the refusal of no plant", plant.log)
    wait_until(lambda: plant.get("/jobs/J2")["state"] == "completed", "the second job", plant.log)

    plant.change(plant.text)
    wait_until(lambda: answers(plant.url) and "P9" not in plant.stations(), "the plant as it was", plant.log)
    assert plant.process.poll() is None
    assert not plant.said("Traceback")
