"""The examples for an MES, against a simulated plant: jobs come to their end though the server is killed in between."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest

from tests.e2e.processes import GENEROUS, HTTP, answers, free_ports, quick_plant, running, wait_until

ROOT = Path(__file__).parents[2]


@contextmanager
def serving(tmp_path: Path, log: Path) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Simulate a small plant; give the URL and the command of its server."""
    (port,) = free_ports(1)
    plant = str(quick_plant("small", tmp_path))
    server = ("serve", "--plant", plant, "--database", f"sqlite:///{tmp_path / 'plant.db'}", "--port", str(port))
    with running("sim", "--plant", plant, log=log):
        yield f"http://127.0.0.1:{port}", server


def test_the_mes_in_python_sees_its_orders_to_their_end_through_a_killed_server(tmp_path: Path) -> None:
    log, state, said = tmp_path / "log", tmp_path / "mes.json", tmp_path / "said"
    env = {**os.environ, "PYTHONPATH": str(ROOT / "clients/python")}
    with serving(tmp_path, log) as (url, server), ExitStack() as stack:
        process = stack.enter_context(running(*server, log=log))
        wait_until(lambda: answers(url), "the server", log)
        command = [sys.executable, str(ROOT / "examples/python/mes.py"), url, str(state), "LOT-1:P1:P2", "LOT-2:B1:P1"]
        with said.open("wb") as out, subprocess.Popen(command, stdout=out, stderr=out, env=env) as mes:
            try:
                wait_until(lambda: b"VehicleAssigned" in said.read_bytes(), "the first events", log)
                process.send_signal(signal.SIGKILL)
                process.wait()
                stack.enter_context(running(*server, log=log))
                assert mes.wait(GENEROUS) == 0, said.read_text(encoding="utf-8")
            finally:
                mes.kill()
        lines = said.read_text(encoding="utf-8").splitlines()
        assert json.loads(lines[-1]) == {"LOT-1": "completed", "LOT-2": "completed"}
        seqs = [int(line.split()[0]) for line in lines[:-1]]
        assert seqs == sorted(set(seqs))
        again = subprocess.run(command[:4], capture_output=True, text=True, env=env, check=True)
        assert json.loads(again.stdout) == {"LOT-1": "completed", "LOT-2": "completed"}


def test_the_mes_with_curl_follows_a_job_to_its_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    log = tmp_path / "log"
    with serving(tmp_path, log) as (url, server), running(*server, log=log):
        wait_until(lambda: answers(url), "the server", log)
        monkeypatch.setenv("HOISTWAY_URL", url)
        script = [str(ROOT / "examples/curl/mes.sh"), "LOT-9", "P1", "P2"]
        done = subprocess.run(script, capture_output=True, text=True, timeout=GENEROUS, check=False)
        assert done.returncode == 0, done.stderr
        assert done.stdout.splitlines()[-1] == "completed"
        assert "TransferCompleted V00" in done.stdout
        assert HTTP.get(f"{url}/api/v1/jobs/LOT-9").json()["actor"] == "mes"
