"""The examples for an MES, against a simulated plant: jobs come to their end though the server is killed in between."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from threading import Thread

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


@pytest.mark.campaign
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
        # Lines that begin with no number say why an order waits.
        lines = [line for line in said.read_text(encoding="utf-8").splitlines() if line[0] in "0123456789{"]
        assert json.loads(lines[-1]) == {"LOT-1": "completed", "LOT-2": "completed"}
        seqs = [int(line.split()[0]) for line in lines[:-1]]
        assert seqs == sorted(set(seqs))
        again = subprocess.run(command[:4], capture_output=True, text=True, env=env, check=True)
        assert json.loads(again.stdout) == {"LOT-1": "completed", "LOT-2": "completed"}


def mes(*arguments: str) -> subprocess.CompletedProcess[str]:
    env = {**os.environ, "PYTHONPATH": str(ROOT / "clients/python")}
    command = [sys.executable, str(ROOT / "examples/python/mes.py"), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=GENEROUS, check=False, env=env)


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        ([], "required: url, file"),
        (["http://127.0.0.1:9", "STATE", "LOT-1:P1"], "'LOT-1:P1' is no order: write NAME:SOURCE:DESTINATION"),
        (["http://127.0.0.1:9", "STATE", "LOT-1:P1:P2", "LOT-1:P1:P3"], "LOT-1 was ordered already, from P1 to P2"),
    ],
)
def test_the_mes_in_python_says_how_it_is_called(tmp_path: Path, arguments: list[str], word: str) -> None:
    ended = mes(*(str(tmp_path / "mes.json") if part == "STATE" else part for part in arguments))
    assert ended.returncode == 2
    assert ended.stderr.startswith("usage: mes.py")
    assert word in ended.stderr


@pytest.mark.campaign
def test_the_mes_in_python_says_what_is_refused_and_why_an_order_waits(tmp_path: Path) -> None:
    log, state, said = tmp_path / "log", tmp_path / "mes.json", tmp_path / "said"
    away = mes("http://127.0.0.1:9", str(state), "LOT-1:P1:P2")
    assert away.returncode == 1
    assert "Traceback" not in away.stderr
    assert f"What was ordered is kept in {state}" in away.stderr
    env = {**os.environ, "PYTHONPATH": str(ROOT / "clients/python")}
    with serving(tmp_path, log) as (url, server), running(*server, log=log):
        wait_until(lambda: answers(url), "the server", log)
        actor = {"X-Actor": "kim"}
        HTTP.post(f"{url}/api/v1/controller/pause", json={"reason": "a visit"}, headers=actor).raise_for_status()
        command = [sys.executable, str(ROOT / "examples/python/mes.py"), url, str(state), "LOT-2:NOPE:P2"]
        with said.open("wb") as out, subprocess.Popen(command, stdout=out, stderr=out, env=env) as running_mes:
            try:
                waits = b"LOT-1 is queued: the controller is paused"
                wait_until(lambda: waits in said.read_bytes(), "why the first order waits", log)
                HTTP.post(f"{url}/api/v1/controller/resume", headers=actor).raise_for_status()
                assert running_mes.wait(GENEROUS) == 1, "not all were completed"
            finally:
                running_mes.kill()
    lines = said.read_text(encoding="utf-8").splitlines()
    assert "LOT-2 is refused: 422 invalid: there is no station or vehicle NOPE see GET /api/v1/stations" in lines
    assert json.loads(lines[-1]) == {"LOT-1": "completed", "LOT-2": "failed"}


class _Refusing(BaseHTTPRequestHandler):
    """Gives one answer after the other; the last one again and again."""

    answers: list[int] = []

    def do_POST(self) -> None:
        self.rfile.read(int(self.headers["Content-Length"]))
        status = self.answers[0] if len(self.answers) == 1 else self.answers.pop(0)
        type(self).asked += 1
        body = json.dumps({"status": status, "code": "a-code", "detail": "It cannot be.", "remedy": "Do it otherwise."})
        self.send_response(status)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body.encode())

    asked = 0

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 (named by the library)
        """Say nothing."""


@pytest.mark.parametrize(
    ("statuses", "asked"),
    [([422], 1), ([409], 1), ([401], 1), ([500], 1), ([503, 429, 502, 504, 422], 5), ([503], 6)],
)
def test_the_mes_with_curl_repeats_only_what_may_pass_by_itself_and_says_what_is_refused(
    tmp_path: Path, statuses: list[int], asked: int
) -> None:
    hurried = tmp_path / "sleep"
    hurried.write_text("#!/bin/sh\n", encoding="utf-8")
    hurried.chmod(0o755)
    server = HTTPServer(("127.0.0.1", 0), type("_Asked", (_Refusing,), {"answers": statuses, "asked": 0}))
    serving = Thread(target=server.serve_forever)
    serving.start()
    url, path = f"http://127.0.0.1:{server.server_port}", f"{tmp_path}:{os.environ['PATH']}"
    try:
        ended = subprocess.run(
            [str(ROOT / "examples/curl/mes.sh"), "LOT-9", "P1", "P2"],
            capture_output=True, text=True, timeout=GENEROUS, check=False,
            env={**os.environ, "HOISTWAY_URL": url, "PATH": path},
        )  # fmt: skip
    finally:
        server.shutdown()
        serving.join()
        server.server_close()
    assert ended.returncode == 1
    assert ended.stderr.strip() == f"{statuses[-1]} a-code: It cannot be. Do it otherwise."
    assert server.RequestHandlerClass.asked == asked  # type: ignore[attr-defined]


def test_the_mes_with_curl_says_how_it_is_called() -> None:
    ended = subprocess.run([str(ROOT / "examples/curl/mes.sh"), "LOT-9"], capture_output=True, text=True, check=False)
    assert ended.returncode == 2
    assert ended.stderr.startswith("usage: mes.sh JOB_ID SOURCE DESTINATION")


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
