"""A noisy cable between a controller and a device: a TCP relay that spoils packets."""

import socket
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from random import Random

from app.wire.faults import Lane, Rates


@contextmanager
def noisy(device: int, rates: Rates, seed: int) -> Iterator[int]:
    """Relay connections to a port of this machine through lanes with these faults; give the port to dial instead."""
    server = socket.create_server(("127.0.0.1", 0))
    opened: list[socket.socket] = [server]
    random = Random(seed)

    def serve() -> None:
        with suppress(OSError):
            while True:
                here, _ = server.accept()
                opened.append(here)
                try:
                    there = socket.create_connection(("127.0.0.1", device))
                except OSError:
                    here.close()
                    continue
                opened.append(there)
                for source, target in ((here, there), (there, here)):
                    lane = Lane(Random(random.random()), rates)
                    threading.Thread(target=_carry, args=(source, target, lane), daemon=True).start()

    threading.Thread(target=serve, daemon=True).start()
    try:
        yield server.getsockname()[1]
    finally:
        for one in opened:
            with suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)
            one.close()


def _carry(source: socket.socket, target: socket.socket, lane: Lane) -> None:
    with suppress(OSError):
        while packet := source.recv(4096):
            lane.put(packet, time.monotonic())
            while piece := lane.take(float("inf")):
                target.sendall(piece)
    for one in (source, target):
        with suppress(OSError):
            one.shutdown(socket.SHUT_RDWR)
