"""The real thing: two processes over TCP, and one of them is killed again and again."""

import subprocess
from collections import Counter, defaultdict
from contextlib import ExitStack
from pathlib import Path
from random import Random

import httpx
import pytest

from tests.e2e.processes import HTTP, answers, free_ports, journal_of, quick_plant, running, wait_until
from tests.shares import shared

SEED = 7
TRIPS = [
    ("FOUP0001", "ETCH01-P1", "SBA-R1"),
    ("FOUP0002", "ETCH02-P2", "SBA-R2"),
    ("FOUP0003", "CLEAN01-P1", "SBA-R3"),
    ("FOUP0004", "SBA-L1", "SBA-R4"),
    ("FOUP0005", "LITHO01-P2", "SBB-L1"),
    ("FOUP0006", "LITHO02-P1", "SBB-L2"),
    ("FOUP0007", "INSP01-P1", "SBB-L3"),
    ("FOUP0008", "SBB-R2", "SBB-L4"),
    ("FOUP0009", "STK01-P01", "METR01-P1"),
    ("FOUP0010", "STK01-P02", "METR01-P2"),
]
"""There, and later back again: twenty jobs."""


def jobs() -> list[dict[str, str]]:
    there = [
        {"job_id": f"{carrier}-there", "carrier": carrier, "source": home, "destination": away}
        for carrier, home, away in TRIPS
    ]
    back = [
        {"job_id": f"{carrier}-back", "carrier": carrier, "source": away, "destination": home}
        for carrier, home, away in TRIPS
    ]
    return there + back


class Server:
    """A server that can be killed and started again on the same database."""

    def __init__(self, plant: Path, directory: Path) -> None:
        (port,) = free_ports(1)
        self.url = f"http://127.0.0.1:{port}"
        self.log = directory / "serve.log"
        database = f"sqlite:///{directory / 'plant.db'}"
        self._arguments = ("serve", "--plant", str(plant), "--database", database, "--port", str(port))
        self._stack = ExitStack()
        self.process: subprocess.Popen[bytes] | None = None

    def start(self) -> None:
        self.process = self._stack.enter_context(running(*self._arguments, log=self.log))

    def kill(self) -> None:
        assert self.process is not None
        assert self.process.poll() is None, f"the server ended by itself: {self.log.read_text()[-3000:]}"
        self.process.kill()
        self.process.wait()

    def ready(self) -> None:
        wait_until(lambda: answers(self.url) or self._over(), "the server", self.log)
        assert not self._over(), f"the server ended by itself: {self.log.read_text()[-3000:]}"

    def _over(self) -> bool:
        return self.process is not None and self.process.poll() is not None

    def close(self) -> None:
        self._stack.close()


def order(url: str, job: dict[str, str]) -> bool:
    """Order a job; False if the server is not there: then nobody knows, and the same order is sent again."""
    try:
        answer = HTTP.post(f"{url}/api/v1/jobs", json=job, timeout=5.0)
    except httpx.HTTPError:
        return False
    assert answer.status_code in (200, 201), answer.text
    return True


def states(url: str) -> Counter[str]:
    """Return how many jobs there are in each state; none if the server is not there."""
    try:
        answer = HTTP.get(f"{url}/api/v1/jobs", params={"limit": 1000}, timeout=5.0)
    except httpx.HTTPError:
        return Counter()
    return Counter(job["state"] for job in answer.json()["items"]) if answer.status_code == 200 else Counter()


@pytest.mark.parametrize("kills", shared([3, 10], 1))
def test_a_server_killed_again_and_again_loses_no_job_and_repeats_no_pick_up(tmp_path: Path, kills: int) -> None:
    dice = Random(SEED)
    plant, journal, sim_log = quick_plant("demo", tmp_path), tmp_path / "journal", tmp_path / "sim.log"
    server = Server(plant, tmp_path)
    with running("sim", "--plant", str(plant), "--journal", str(journal), "--haste", "5", log=sim_log):
        wait_until(lambda: b"are there" in sim_log.read_bytes(), "the simulated vehicles", sim_log)
        server.start()
        try:
            server.ready()
            waiting = jobs()
            for kill in range(kills):
                batch = len(jobs()) * (kill + 1) // kills - (len(jobs()) - len(waiting))
                while batch > 0:
                    if order(server.url, waiting[0]):
                        waiting.pop(0)
                        batch -= 1
                done = len(journal_of(journal)) + dice.randrange(4)
                wait_for_progress(journal, done, dice)
                server.kill()
                server.start()
                server.ready()
            wait_until(lambda: states(server.url) == {"completed": len(jobs())}, "the end of all jobs", server.log)
        finally:
            server.close()
    assert_each_carrier_was_fetched_once_a_job(journal)


def wait_for_progress(journal: Path, acts: int, dice: Random) -> None:
    """Let the vehicles do something, and a random little while more."""
    if len(journal_of(journal)) < 2 * len(jobs()):
        wait_until(lambda: len(journal_of(journal)) >= min(acts, 2 * len(jobs())), "a physical act")
    subprocess.run(["sleep", str(dice.uniform(0.0, 1.5))], check=True)


def assert_each_carrier_was_fetched_once_a_job(journal: Path) -> None:
    deeds: defaultdict[str, list[tuple[str, str]]] = defaultdict(list)
    for act in journal_of(journal):
        assert act["deed"] in ("take", "put"), act
        deeds[act["carrier"]].append((act["deed"], act["station"]))
    assert deeds == {
        carrier: [("take", home), ("put", away), ("take", away), ("put", home)] for carrier, home, away in TRIPS
    }
