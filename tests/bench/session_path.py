"""A vehicle's STATUS in, its state updated, the ACK out, over loopback; load and server on one processor, and on two.

Where the two run decides more than what they do: on processors of their own each packet wakes the other side up, which costs the
kernel more than all the rest. So each row says where they ran, and its floor, ours and naive ran there alike.
"""

import json
import os
import resource
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from tests.bench.measuring import Row, Skipped, child, compiled, in_turn, line_of, module

CONNECTIONS = 1_000
MANY, RATE = 3_000, 15_000
"""Connections of the open loop, and its events a second from all of them."""
POLL = 20
"""Seconds between two polls of a vehicle where events are measured: at thousands of events a second polls are to be none."""
ROUNDS = 3
NEW_PLACE, AXES_MOVE, ONLY_POLLS = "0", "1", "2"
KEEPS_UP = 0.98
"""A server that acknowledges less than this share of the open loop's events is saturated."""


@dataclass(frozen=True, slots=True)
class Place:
    """On which processors load and server run, None: wherever the system likes; and the words for it."""

    words: str
    load: int | None = None
    server: int | None = None


ANYWHERE = Place("anywhere")


@dataclass(frozen=True, slots=True)
class Load:
    """What the vehicles do: how often they are asked (s), which packets they send, how many events a second (0: closed loop)."""

    poll: float = POLL
    way: str = NEW_PLACE
    settle: float = 0.2
    measure: float = 1.5
    connections: int = CONNECTIONS
    rate: int = 0


@dataclass(frozen=True, slots=True)
class Found:
    """Microseconds of the server's CPU for each packet it acknowledged, and how many it did a second."""

    cpu_us: float
    per_second: float


def places() -> list[Place]:
    """Return the placements that can be had here: one processor, and two."""
    free = sorted(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else []
    if not free:
        return [ANYWHERE]
    one = [Place("load and server on one processor", free[0], free[0])]
    return one + [Place("load and server on processors of their own", free[0], free[1]) for _ in free[1:2]]


def found(server: list[str | Path], load: Load, place: Place = ANYWHERE) -> Found:
    """Return what a server needs for the packets of many vehicles."""
    _open_files(load.connections + 200)
    words = [load.connections, 0, load.settle, 0.7, load.measure, load.way, load.rate]
    with (
        _on(place.load),
        child(compiled("vehicles"), *map(str, words), stdin=subprocess.PIPE, stdout=subprocess.PIPE) as vehicles,
    ):
        port = line_of(vehicles.stdout).strip()
        with _on(place.server), child(*server, port, str(load.connections), str(load.poll)) as process:
            assert vehicles.stdin is not None
            vehicles.stdin.write(f"{process.pid}\n")
            vehicles.stdin.close()
            told = json.loads(line_of(vehicles.stdout))
            return Found(told["cpu_us"], told["packets"] / told["seconds"])


def cpu_per_packet(server: list[str | Path], load: Load, place: Place = ANYWHERE) -> float:
    """Return the microseconds of CPU that a server needs for each packet."""
    return found(server, load, place).cpu_us


@contextmanager
def _on(processor: int | None) -> Iterator[None]:
    """Let children that are started inside run on this processor only: they inherit it, and so do their threads."""
    if processor is None:
        yield
        return
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {processor})
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)


def _open_files(enough: int) -> None:
    """See to it that children may open so many files. Raises Skipped: they may not."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if resource.RLIM_INFINITY not in (soft, hard) and hard < enough:
        raise Skipped(f"a process may open {hard} files here, not {enough}")
    if soft != resource.RLIM_INFINITY and soft < enough:
        resource.setrlimit(resource.RLIMIT_NOFILE, (enough, hard))


def rows() -> Iterator[Row]:
    """Measure the session alone in each placement, then the whole controller."""
    floor: list[str | Path] = [compiled("floor")]
    sessions, whole, streams = (
        list[str | Path](module("serving", kind)) for kind in ("sessions", "controller", "streams")
    )
    for place in places():
        yield _closed(place, floor, sessions, streams)
    for place in places():
        yield _open(place, floor, sessions, streams)
    apart = places()[-1]
    asked = Load(1, ONLY_POLLS, 1.0, 3.0)
    base, ours, naive = in_turn(
        1, *(partial(cpu_per_packet, each, asked, apart) for each in (floor, sessions, streams))
    )
    yield Row(
        f"session path: poll out, STATUS in, ACK out; 1,000 connections, one poll a second each; {apart.words}",
        ours, base, naive, "µs CPU/poll", None,
    )  # fmt: skip
    base, ours = in_turn(
        2,
        partial(cpu_per_packet, floor, Load(1, AXES_MOVE), apart),
        partial(cpu_per_packet, whole, Load(1, AXES_MOVE, 5.0), apart),
    )
    yield Row(
        f"session path, whole controller: with fleet, read model and writer; polls each second included; {apart.words}",
        ours, base, None, "µs CPU/event", None,
        note="vehicles in AUTO stand and move their axes; each is shown ten times a second",
    )  # fmt: skip


def _closed(place: Place, *servers: list[str | Path]) -> Row:
    floor, sessions, streams = (partial(cpu_per_packet, server, Load(), place) for server in servers)
    base, ours = in_turn(ROUNDS, floor, sessions)
    return Row(
        f"session path: STATUS in, ACK out, full state update; 1,000 connections, closed loop; {place.words}",
        ours, base, streams(), "µs CPU/event", 1.8,
        note="ours: Line and Session on uvloop; naive: streams, queue and wait_for per frame with the same codec",
    )  # fmt: skip


def _open(place: Place, *servers: list[str | Path]) -> Row:
    load = Load(connections=MANY, rate=RATE, settle=1.0, measure=2.5)
    rates: dict[str, float] = {}

    def measure(name: str, server: list[str | Path]) -> float:
        got = found(server, load, place)
        rates[name] = got.per_second
        return got.cpu_us

    floor, ours, naive = (
        partial(measure, name, each) for name, each in zip(("floor", "ours", "naive"), servers, strict=True)
    )
    base, mine = in_turn(ROUNDS, floor, ours)
    usual = naive()
    late = [f"{name} is saturated at {rate:,.0f}/s" for name, rate in rates.items() if rate < KEEPS_UP * RATE]
    return Row(
        f"session path, open loop: 15,000 events/s at even distances over 3,000 connections; {place.words}",
        mine, base, usual, "µs CPU/event", 1.5,
        note="; ".join(["an event comes whether the last one is acknowledged or not", *(late or ["all three keep up"])]),
    )  # fmt: skip
