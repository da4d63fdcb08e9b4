"""Real processes of the product, on ports of their own."""

import json
import os
import re
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from itertools import count, islice
from pathlib import Path
from typing import Any

import httpx

GENEROUS = 180.0
"""Seconds that anything may take."""
PLANTS = Path(__file__).parents[2] / "plants"
COMMAND = (sys.executable, "-m", "app.cli")
HTTP = httpx.Client(verify=False, trust_env=False, limits=httpx.Limits(max_keepalive_connections=0), timeout=GENEROUS)
"""Asks servers, over a new connection each time, as curl does. ``httpx.get`` would read all certificates for each request:
25 ms of a core."""


def free_ports(number: int) -> list[int]:
    """Return ports that nobody uses, none of them twice.

    They lie below those that Linux gives to outgoing connections, which could take one before it is listened at; each
    process looks from another place on, so that two do not find the same.
    """
    return list(islice(filter(_is_free, _PORTS), number))


_FIRST, _LAST = 18_000, 32_000
_START = os.getpid() * 97 % (_LAST - _FIRST)
_PORTS = (_FIRST + (_START + step) % (_LAST - _FIRST) for step in count())


def _is_free(port: int) -> bool:
    try:
        with socket.create_server(("127.0.0.1", port)):
            return True
    except OSError:
        return False


def quick_plant(name: str, directory: Path) -> Path:
    """Copy an example plant with quick vehicles, at ports of its own."""
    text = (PLANTS / f"{name}.yaml").read_text(encoding="utf-8")
    ports = iter(free_ports(len(re.findall(r"127\.0\.0\.1:\d+", text))))
    text = re.sub(r"127\.0\.0\.1:\d+", lambda _: f"127.0.0.1:{next(ports)}", text)
    quick = {"max_speed": 8000, "curve_speed": 4000, "acceleration": 8000, "braking": 8000}
    for field, value in quick.items():
        text = re.sub(rf"^  {field}: .*\n", "", text, flags=re.MULTILINE)
        text = text.replace("vehicle_defaults:\n", f"vehicle_defaults:\n  {field}: {value}\n")
    file = directory / f"{name}.yaml"
    file.write_text(text, encoding="utf-8")
    return file


@contextmanager
def running(*arguments: str, log: Path, command: Sequence[str] = COMMAND) -> Iterator[subprocess.Popen[bytes]]:
    """Run ``hoistway`` with these arguments; whatever happens, it ends with the block."""
    env = {**os.environ, "PYTHONUNBUFFERED": "1"}
    with (
        log.open("ab") as out,
        subprocess.Popen([*command, *arguments], stdout=out, stderr=out, stdin=subprocess.DEVNULL, env=env) as process,
    ):
        try:
            yield process
        finally:
            if process.poll() is None:
                process.terminate()
                try:
                    process.wait(20)
                except subprocess.TimeoutExpired:
                    process.kill()


def wait_until(condition: Callable[[], bool], what: str, log: Path | None = None, bound: float = GENEROUS) -> None:
    """Wait for something that must come. It is looked for ever more seldom: what takes long is not worth a core."""
    begun = time.monotonic()
    while not condition():
        waited = time.monotonic() - begun
        if waited > bound:
            tail = log.read_text(encoding="utf-8", errors="replace")[-3000:] if log else ""
            raise AssertionError(f"{what} did not come in {bound:g} s\n{tail}")
        time.sleep(min(0.25, 0.02 + waited / 20))


def answers(url: str) -> bool:
    """Whether a controller answers there and can take jobs."""
    try:
        return HTTP.get(f"{url}/readyz", timeout=2.0).status_code == 200
    except httpx.HTTPError:
        return False


def journal_of(file: Path) -> list[dict[str, Any]]:
    """Return what the simulated vehicles physically did, oldest first."""
    return [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines()] if file.exists() else []
