"""The whole controller with 1,000 hoists simulated to the byte in another process: a short ``hoistway bench hoists``."""

import asyncio
from collections.abc import Iterator

from app.cli.bench import generated, kept_back
from app.cli.hoists.report import missed
from app.cli.hoists.run import Asked, measure
from tests.bench.measuring import Row, compiled
from tests.bench.session_path import Load, cpu_per_packet

HOISTS = 1_000
ASKED = Asked(seconds=20.0, settle=30.0, processes=1, first_port=22_001, jobs=HOISTS)


def rows() -> Iterator[Row]:
    """Measure under load; the floor receives and acknowledges as many packets in C."""
    found = asyncio.run(measure(kept_back(generated(HOISTS, 1)), ASKED))
    packets = found.controller["lines"]["frames_in"] / found.seconds / HOISTS
    floor = packets * cpu_per_packet([compiled("floor")], Load())
    yield Row(
        "whole controller, 1,000 hoists under load in other processes; floor: C, the same packets",
        found.per_vehicle_second, floor, None, "µs CPU/vehicle-second", None,
        note=f"{packets:.1f} packets a vehicle and second, {missed(found)} deadlines missed in {found.seconds:.0f} s",
    )  # fmt: skip
