"""What many look at: the list of 1,000 vehicles, and the live stream to 500 watchers."""

import asyncio
import http.client
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import cast

import uvloop

from tests.bench.measuring import PATIENCE, Row, child, compiled, cpu_of, in_turn, line_of, module

WATCHERS = 500
READERS = 8
WARM, MEASURE = 1.0, 2.0
"""Seconds; they count from when every watcher is in and has had its first change: letting 500 in is no part of a send."""
CHANGE = b'"type":"change"'
GET = b"GET /api/v1/vehicles HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"
WATCH = (
    b"GET /api/v1/live?topics=vehicles HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
)


class Reader(asyncio.Protocol):
    """Asks for the list, again and again; the answers are all of one size."""

    begun = True

    def __init__(self, count: list[int], size: int) -> None:
        self._count, self._size, self._got = count, size, 0

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Ask first."""
        self._transport = cast(asyncio.Transport, transport)
        self._transport.write(GET)

    def data_received(self, data: bytes) -> None:
        """Ask again once an answer is whole."""
        self._got += len(data)
        if self._got >= self._size:
            self._got -= self._size
            self._count[0] += 1
            self._transport.write(GET)


class Watcher(asyncio.Protocol):
    """Counts the bytes of the live stream."""

    def __init__(self, count: list[int], *, upgrade: bool) -> None:
        self._count, self._upgrade = count, upgrade
        self.begun = False
        """Whether a change has come: the snapshot before it is a hundred times as long."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Ask for the stream where that is needed."""
        if self._upgrade:
            cast(asyncio.Transport, transport).write(WATCH)

    def data_received(self, data: bytes) -> None:
        """Count."""
        self._count[0] += len(data)
        self.begun = self.begun or CHANGE in data


def _answer(port: int) -> bytes:
    """Return head and body of the list, as the wire has them."""
    import socket

    with socket.create_connection(("127.0.0.1", port), PATIENCE) as peer:
        peer.settimeout(PATIENCE)
        peer.sendall(GET)
        data = peer.recv(65536)
        while b"\r\n\r\n" not in data:
            data += peer.recv(65536)
        head, _, body = data.partition(b"\r\n\r\n")
        length = int(head.lower().partition(b"content-length:")[2].partition(b"\r\n")[0])
        while len(body) < length:
            body += peer.recv(65536)
        return head + b"\r\n\r\n" + body


def _frame(port: int) -> bytes:
    """Return one change frame of the live stream, as the wire has it."""
    import socket

    with socket.create_connection(("127.0.0.1", port), PATIENCE) as peer:
        peer.settimeout(PATIENCE)
        peer.sendall(WATCH)
        stream = peer.makefile("rb")
        while stream.readline().strip():
            pass
        while True:
            kind, size = stream.read(2)
            extended = {126: 2, 127: 8}.get(size, 0)
            head = stream.read(extended)
            body = stream.read(int.from_bytes(head, "big") if extended else size)
            if b'"change"' in body[:40]:
                return bytes([kind, size]) + head + body


async def _cost(port: int, pid: int, count: list[int], make: Callable[[], Reader | Watcher], peers: int) -> float:
    """Return the microseconds of CPU that a process takes for each of what is counted."""
    loop = asyncio.get_running_loop()
    lines = [await loop.create_connection(make, "127.0.0.1", port) for _ in range(peers)]
    async with asyncio.timeout(PATIENCE):
        while not all(peer.begun for _, peer in lines):
            await asyncio.sleep(0.1)
    await asyncio.sleep(WARM)
    done, cpu = count[0], cpu_of(pid)
    await asyncio.sleep(MEASURE)
    done, cpu = count[0] - done, cpu_of(pid) - cpu
    for transport, _ in lines:
        transport.abort()
    return cpu / done * 1e6


def _measured(command: list[str], sample: bytes, *, reading: bool, upgrade: bool = True) -> float:
    with child(*command, stdout=subprocess.PIPE) as server:
        port = int(line_of(server.stdout))
        size = len(_answer(port)) if reading and upgrade else len(sample)
        count = [0]
        make: Callable[[], Reader | Watcher]
        make = partial(Reader, count, size) if reading else partial(Watcher, count, upgrade=upgrade)
        peers = READERS if reading else WATCHERS
        with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
            cost = runner.run(_cost(port, server.pid, count, make, peers))
        return cost if reading else cost * size


def _sampled() -> tuple[bytes, bytes]:
    with child(*module("shows", "ours"), stdout=subprocess.PIPE) as server:
        port = int(line_of(server.stdout))
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            try:
                http.client.HTTPConnection("127.0.0.1", port, timeout=1).request("GET", "/healthz")
                break
            except OSError:
                time.sleep(0.05)
        return _answer(port), _frame(port)


def rows() -> Iterator[Row]:
    """Measure the list, then the stream."""
    answer, frame = _sampled()
    ours, naive = module("shows", "ours"), module("shows", "naive")
    with tempfile.TemporaryDirectory(prefix="hoistway-bench-") as name:
        (Path(name) / "answer").write_bytes(answer)
        (Path(name) / "frame").write_bytes(frame)
        floor = [str(compiled("answers")), f"{name}/answer", "0"]
        base, got = in_turn(
            2,
            partial(_measured, floor, answer, reading=True, upgrade=False),
            partial(_measured, ours, answer, reading=True),
        )
        usual = _measured(naive, answer, reading=True)
        yield Row(
            f"GET /vehicles, 1,000 vehicles ({len(answer) // 1000} kB), 8 readers",
            got, base, usual, "µs CPU/request", 3.0,
            note="floor: a C server that writes the same bytes; naive: a list of dataclasses returned from FastAPI",
        )  # fmt: skip
        floor = [str(compiled("answers")), f"{name}/frame", str(WATCHERS)]
        base, got = in_turn(
            2,
            partial(_measured, floor, frame, reading=False, upgrade=False),
            partial(_measured, ours, frame, reading=False),
        )
        usual = _measured(naive, frame, reading=False)
        yield Row(
            f"live frame ({len(frame) / 1000:.0f} kB, ten vehicles) to one of 500 watchers, ten a second",
            got, base, usual, "µs CPU/send", 2.2,
            note="floor: a C loop that writes the same bytes; naive: send_json for each client",
        )  # fmt: skip
