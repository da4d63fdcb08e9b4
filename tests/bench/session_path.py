"""A vehicle's STATUS in, its state updated, the ACK out: 1,000 connections over loopback, one event outstanding on each."""

import json
import subprocess
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from tests.bench.measuring import Row, child, compiled, in_turn, line_of, module

CONNECTIONS = 1_000
POLL = 20
"""Seconds between two polls of a vehicle where events are measured: at thousands of events a second polls are to be none."""
ROUNDS = 3
NEW_PLACE, AXES_MOVE, ONLY_POLLS = "0", "1", "2"


def cpu_per_packet(server: list[str | Path], poll: float, way: str, settle: float = 0.2, measure: float = 1.5) -> float:
    """Return the microseconds of CPU that a server needs for each packet of 1,000 vehicles, in a closed loop."""
    load = [compiled("vehicles"), CONNECTIONS, 0, settle, 0.7, measure, way]
    with child(*map(str, load), stdin=subprocess.PIPE, stdout=subprocess.PIPE) as vehicles:
        port = line_of(vehicles.stdout).strip()
        with child(*server, port, str(CONNECTIONS), str(poll)) as process:
            assert vehicles.stdin is not None
            vehicles.stdin.write(f"{process.pid}\n")
            vehicles.stdin.close()
            return float(json.loads(line_of(vehicles.stdout))["cpu_us"])


def rows() -> Iterator[Row]:
    """Measure the session alone, then the whole controller."""
    floor: list[str | Path] = [compiled("floor")]
    sessions, whole, streams = (
        list[str | Path](module("serving", kind)) for kind in ("sessions", "controller", "streams")
    )
    events = [partial(cpu_per_packet, server, POLL, NEW_PLACE) for server in (floor, sessions, streams)]
    base, ours = in_turn(ROUNDS, *events[:2])
    naive = events[2]()
    yield Row(
        "session path: STATUS in, ACK out, full state update; 1,000 connections, closed loop",
        ours, base, naive, "µs CPU/event", 1.8,
        note="ours: Line and Session on uvloop; naive: streams, queue and wait_for per frame with the same codec",
    )  # fmt: skip
    asked = [partial(cpu_per_packet, server, 1, ONLY_POLLS, 1.0, 3.0) for server in (floor, sessions, streams)]
    base, ours, naive = in_turn(1, *asked)
    yield Row(
        "session path: poll out, STATUS in, ACK out; 1,000 connections, one poll a second each",
        ours, base, naive, "µs CPU/poll", None,
    )  # fmt: skip
    all_of_it = [partial(cpu_per_packet, floor, 1, AXES_MOVE), partial(cpu_per_packet, whole, 1, AXES_MOVE, 5.0)]
    base, ours = in_turn(2, *all_of_it)
    yield Row(
        "session path, whole controller: the same with fleet, read model and writer; polls each second included",
        ours, base, None, "µs CPU/event", None,
        note="vehicles in AUTO stand and move their axes; each is shown ten times a second",
    )  # fmt: skip
