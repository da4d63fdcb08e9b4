"""Hundreds of short runs in which everything goes wrong: nothing that must never happen does, and every job ends."""

from collections import Counter

import pytest

from tests.acceptance.chaos import Chaos
from tests.acceptance.world import small_plant

SEEDS = 304
SLICES = 8
REACHED = {
    "kill", "cut", "mant", "shoved", "alarm", "block", "power", "refuse", "hold", "stop", "misread", "stall",
    "recover", "release", "pushed to a barcode", "mended", "VehicleHeld", "VehicleReleased", "AlarmSet", "AlarmCleared",
}  # fmt: skip
"""What every slice of the campaign must have seen, or it tries nothing."""


@pytest.mark.parametrize("part", range(SLICES))
def test_whatever_goes_wrong_no_track_is_shared_no_carrier_lost_and_every_job_ends(part: int) -> None:
    plant, seen = small_plant(), Counter[str]()
    for seed in range(part * SEEDS // SLICES, (part + 1) * SEEDS // SLICES):
        chaos = Chaos(plant, seed, calm=45.0, number=5, keep_open=2).run()
        result = chaos.world.result()
        assert (result.violations, result.open) == ((), ()), f"seed {seed}"
        assert result.takes == result.puts, f"seed {seed}"
        seen.update(chaos.seen)
    assert set(seen) >= REACHED


def test_the_same_seed_gives_the_same_bytes_at_the_same_times() -> None:
    traces = {Chaos(small_plant(), 7, calm=60.0).run().world.trace for _ in range(2)}
    assert len(traces) == 1
