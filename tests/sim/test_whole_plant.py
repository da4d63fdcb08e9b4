"""The demo plant under load in virtual time: the real controller, real bytes, simulated vehicles, one seed."""

import json
import os
import subprocess
import sys
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import pytest

from app.domain.layout import IdleRules, Plant
from app.domain.units import Seconds
from app.domain.view import Update, VehicleView
from app.plant import read
from app.sim.run import run
from app.sim.truth import Act
from app.sim.world import Result, World
from tests.shares import shared

PLANTS = Path(__file__).parents[2] / "plants"
FIVE_MINUTES, TEN_MINUTES, HALF_AN_HOUR, ONE_HOUR = 300.0, 600.0, 1800.0, 3600.0
AGAIN = """
import json, sys
from dataclasses import asdict
from pathlib import Path
from app.plant import read
from app.sim.world import World

file, seconds, until = Path(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3])
plant, _ = read(file.read_text(encoding="utf-8"), file.name)
world = World(plant, 1)
world.work(until=until, keep_open=8)
world.run(seconds)
if seconds == until:
    world.finish(1800.0)
print(json.dumps(asdict(world.result())))
"""


def plant_of(name: str) -> Plant:
    plant, _ = read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)
    return plant


def begun_elsewhere(name: str, seconds: float, until: float, hash_seed: str) -> subprocess.Popen[str]:
    """Begin the same run in another process, whose sets and dictionaries hash otherwise; look at it after some seconds."""
    return subprocess.Popen(
        [sys.executable, "-c", AGAIN, str(PLANTS / f"{name}.yaml"), str(seconds), str(until)],
        env={**os.environ, "PYTHONHASHSEED": hash_seed},
        stdout=subprocess.PIPE,
        text=True,
    )


def plain(result: Result) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(json.dumps(asdict(result)))
    return found


@pytest.mark.parametrize("seconds", shared([FIVE_MINUTES, HALF_AN_HOUR], 1))
def test_work_under_load_ends_every_job_breaks_no_rule_and_is_the_same_in_every_process(seconds: float) -> None:
    """Two hours of it: ``hoistway simulate`` in ``make campaign``."""
    elsewhere = begun_elsewhere("demo", seconds, seconds, "4711")
    world = World(plant_of("demo"), 1)
    world.work(until=seconds, keep_open=8)
    world.run(seconds)
    assert world.finish(1800.0)
    here = world.result()
    there, _ = elsewhere.communicate()
    assert here.violations == ()
    assert here.open == ()
    assert here.completed == here.ended == here.takes == here.puts
    assert here.completed > seconds / 18
    assert json.loads(there) == plain(here)


@pytest.mark.parametrize("seconds", shared([TEN_MINUTES, ONE_HOUR], 1))
def test_work_in_the_agv_hall_ends_every_job_through_its_door_and_is_the_same_in_every_process(seconds: float) -> None:
    elsewhere = begun_elsewhere("hall", seconds, seconds, "4711")
    world = World(plant_of("hall"), 1)
    acts: list[Act] = []
    world.acted = acts.append
    world.work(until=seconds, keep_open=8)
    world.run(seconds)
    assert world.finish(1800.0)
    here = world.result()
    there, _ = elsewhere.communicate()
    assert here.violations == ()
    assert here.completed == here.ended == here.takes == here.puts
    assert here.completed > seconds / 60
    assert sum(act.station == "AB3" for act in acts) > seconds / 180, "AB3 lies behind the door"
    assert json.loads(there) == plain(here)


def test_another_seed_is_another_run() -> None:
    plant = plant_of("small")
    one, same, other = (run(plant, seed, 120.0, keep_open=2) for seed in (1, 1, 2))
    assert one == same
    assert one.trace != other.trace


@pytest.mark.parametrize("seed", shared([0, 1, 2], 1))
def test_a_controller_killed_at_random_moments_loses_no_job_and_breaks_no_rule(seed: int) -> None:
    result = run(plant_of("demo"), seed, 240.0, keep_open=8, kills=8)
    assert result.violations == ()
    assert result.open == ()
    assert result.takes == result.puts == result.completed


def test_with_idle_hoists_parked_every_job_ends_and_no_rule_is_broken() -> None:
    plant = replace(plant_of("demo"), idle=IdleRules(park=True, after=Seconds(5.0)))
    world = World(plant, 1)
    parked: set[object] = set()

    def seen(update: Update) -> None:
        if isinstance(update.value, VehicleView) and update.value.parked:
            parked.add(update.key)

    world.seen = seen
    world.work(until=240.0, keep_open=3)
    world.run(240.0)
    assert world.finish(1800.0)
    result = world.result()
    assert result.violations == ()
    assert result.takes == result.puts == result.completed > 0
    assert len(parked) > 3, "hardly anyone was parked"
