"""A real server, a real receiver, and kill -9 in between: every event is taken, in order."""

import importlib.util
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import httpx
import pytest

from app.runtime.webhooks import drawn_secret, signature
from tests.e2e.processes import HTTP, answers, free_ports, quick_plant, running, wait_until

EXAMPLE = Path(__file__).parents[2] / "examples/python/webhook_receiver.py"


def example() -> Any:
    spec = importlib.util.spec_from_file_location("webhook_receiver", EXAMPLE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Log:
    """What a receiver got, and whether it takes it."""

    def __init__(self) -> None:
        self.messages: list[dict[str, Any]] = []
        self.came: list[tuple[dict[str, str], bytes]] = []
        self.refuses = False

    def seqs(self) -> list[int]:
        """Return the numbers of the events, in the order in which they came."""
        return [message["data"]["seq"] for message in self.messages if message["type"] != "Ping"]


@contextmanager
def receiving(log: Log, port: int) -> Iterator[None]:
    class Receiver(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = self.rfile.read(int(self.headers["Content-Length"]))
            if log.refuses:
                self.send_error(500)
                return
            log.messages.append(json.loads(body))
            log.came.append(({name.lower(): value for name, value in self.headers.items()}, body))
            self.send_response(204)
            self.end_headers()

        def log_message(self, format: str, *args: object) -> None:  # noqa: A002
            pass

    with ThreadingHTTPServer(("127.0.0.1", port), Receiver) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield
        finally:
            server.shutdown()
            thread.join()


def test_no_event_is_lost_though_the_server_is_killed_and_the_receiver_is_away(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOISTWAY_WEBHOOK_TARGETS", "127.0.0.1")
    monkeypatch.setenv("HOISTWAY_LOG_FORMAT", "json")
    port, hook = free_ports(2)
    log, database, received = tmp_path / "log", f"sqlite:///{tmp_path / 'plant.db'}", Log()
    plant = str(quick_plant("small", tmp_path))
    base = f"http://127.0.0.1:{port}"
    command = ("serve", "--plant", plant, "--database", database, "--port", str(port))

    def pause_and_resume(times: int) -> None:
        for _ in range(times):
            HTTP.post(f"{base}/api/v1/controller/pause", json={"reason": "x"})
            HTTP.post(f"{base}/api/v1/controller/resume")

    def state() -> dict[str, Any]:
        found: dict[str, Any] = HTTP.get(f"{base}/api/v1/webhooks/1").json()
        return found

    with receiving(received, hook):
        with running(*command, log=log) as process:
            wait_until(lambda: answers(base), "the server", log)
            made = HTTP.post(f"{base}/api/v1/webhooks", json={"url": f"http://127.0.0.1:{hook}/", "after": 0}).json()
            pause_and_resume(3)
            wait_until(lambda: len(received.messages) > 3, "the first events", log)
            received.refuses = True
            pause_and_resume(3)
            wait_until(lambda: state()["attempts"] > 0, "a delivery that is not taken", log)
            process.send_signal(signal.SIGKILL)
            process.wait()
        received.refuses = False
        with running(*command, log=log) as process:
            wait_until(lambda: answers(base), "the server again", log)
            pause_and_resume(2)
            wait_until(lambda: state()["behind"] == 0, "all events", log)
            last = HTTP.get(f"{base}/api/v1/events", params={"limit": 1000}).json()["items"][-1]["seq"]
            wait_until(lambda: last in received.seqs(), "the last event", log)
            ping = HTTP.post(f"{base}/api/v1/webhooks/1/ping").json()
            assert (ping["taken"], ping["event"]) == (True, "Ping")
            tries = HTTP.get(f"{base}/api/v1/webhooks/1/deliveries").json()["items"]
            assert any(not one["taken"] for one in tries)
    firsts = list(dict.fromkeys(received.seqs()))
    assert firsts[:last] == list(range(1, last + 1))
    genuine = example().genuine
    assert all(
        genuine(made["secret"], headers, body, int(headers["webhook-timestamp"])) for headers, body in received.came
    )


def test_the_example_receiver_takes_what_is_signed_and_nothing_else(tmp_path: Path) -> None:
    (port,) = free_ports(1)
    secret = drawn_secret(os.urandom(32))
    env = {**os.environ, "HOISTWAY_WEBHOOK_SECRET": secret}
    out = tmp_path / "out"
    with (
        out.open("wb") as file,
        subprocess.Popen([sys.executable, str(EXAMPLE), str(port)], stdout=file, env=env) as process,
    ):
        try:
            url, body = f"http://127.0.0.1:{port}/", b'{"type":"Ping"}'

            def status(timestamp: int, signed: bytes = body, secret: str = secret) -> int:
                headers = {
                    "webhook-id": f"evt_{timestamp}",
                    "webhook-timestamp": str(timestamp),
                    "webhook-signature": "v1,AAAA " + signature([secret], f"evt_{timestamp}", timestamp, signed),
                }
                return HTTP.post(url, headers=headers, content=body).status_code

            def listens() -> bool:
                try:
                    return HTTP.post(url, content=b"").status_code == 401
                except httpx.HTTPError:
                    return False

            wait_until(listens, "the receiver")
            module = example()
            now = int(time.time())
            assert (status(now), status(now)) == (204, 204)
            assert status(now, secret=drawn_secret(b"z" * 32)) == 401
            assert status(now, signed=b"{}") == 401
            assert status(now - module.TOLERANCE - 60) == 401
        finally:
            process.terminate()
    assert out.read_text(encoding="utf-8") == '{"type": "Ping"}\n'
