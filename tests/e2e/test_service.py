"""The server as a service: what it tells the manager that started it."""

import os
import signal
import socket
from pathlib import Path

import pytest

from tests.e2e.processes import GENEROUS, answers, free_ports, quick_plant, running, wait_until


def test_a_server_tells_its_service_manager_of_readiness_life_and_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    said: list[str] = []
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.settimeout(0.0)
        manager.bind(str(tmp_path / "notify"))

        def heard(word: str) -> bool:
            try:
                while True:
                    said.append(manager.recv(4096).decode())
            except BlockingIOError:
                return any(line.startswith(word) for line in said)

        monkeypatch.setenv("NOTIFY_SOCKET", str(tmp_path / "notify"))
        monkeypatch.setenv("WATCHDOG_USEC", "400000")
        monkeypatch.setenv("HOISTWAY_LOG_FORMAT", "json")
        (port,) = free_ports(1)
        log, database = tmp_path / "log", f"sqlite:///{tmp_path / 'plant.db'}"
        plant = str(quick_plant("small", tmp_path))
        with running("serve", "--plant", plant, "--database", database, "--port", str(port), log=log) as process:
            assert os.getpid() != process.pid
            wait_until(lambda: heard("READY=1"), "readiness", log)
            wait_until(lambda: answers(f"http://127.0.0.1:{port}"), "an answer", log)
            assert f"STATUS=controls small at http://127.0.0.1:{port}" in said[0]
            wait_until(lambda: heard("WATCHDOG=1"), "a sign of life", log)
            process.send_signal(signal.SIGTERM)
            wait_until(lambda: heard("STOPPING=1"), "the end", log)
            assert process.wait(GENEROUS) == 0
