"""Short runs in which everything goes wrong: nothing that must never happen does, and every job ends. More: ``make campaign``."""

from dataclasses import replace
from pathlib import Path

import pytest

from app.domain.layout import Plant
from app.plant import read
from app.sim.fuzz import Plan, Tally, draw, play, reached, shrunk
from app.sim.fuzz.plan import Blow, Crash, Strike, Where

PLANTS = Path(__file__).parents[2] / "plants"
SEEDS = {"small": 24, "hall": 12}
SLICES = 2


def plant_of(name: str) -> Plant:
    plant, _ = read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)
    return plant


@pytest.mark.parametrize("part", range(SLICES))
@pytest.mark.parametrize("name", SEEDS)
def test_whatever_goes_wrong_no_rule_is_broken_and_every_job_ends(name: str, part: int) -> None:
    plant, tally = plant_of(name), Tally()
    for seed in range(part * SEEDS[name] // SLICES, (part + 1) * SEEDS[name] // SLICES):
        outcome = play(plant, draw(plant, seed))
        tally.add(outcome)
        assert outcome.wrong == (), f"hoistway fuzz --plant plants/{name}.yaml --replay {seed} --trace --shrink"
    assert tally.crashes > 0
    assert tally.jobs > tally.runs // 2
    assert tally.counts["TransferCompleted"] > 0


def test_the_same_seed_gives_the_same_bytes_at_the_same_times() -> None:
    plant = plant_of("small")
    seed = next(seed for seed in range(100) if (plan := draw(plant, seed)).noise and plan.crashes)
    assert play(plant, draw(plant, seed)) == play(plant, draw(plant, seed))
    assert play(plant, draw(plant, seed)).trace != play(plant, draw(plant, seed + 1)).trace


def test_a_blow_draws_the_same_whatever_else_is_left_out() -> None:
    plant = plant_of("small")
    plan = Plan(1, 40.0, 1, strikes=(Strike(5.0, Blow.KILL, 3), Strike(20.0, Blow.HOLD, 4)))

    def held(some: Plan) -> list[str]:
        said = [what.split() for _, what in play(plant, some).said if "held by anna" in what]
        return [name for words in said for name in words if name in {"V001", "V002"}]

    assert held(plan) == held(replace(plan, strikes=plan.strikes[1:])) != []


def test_the_controller_is_killed_at_the_commit_and_the_packet_that_the_plan_names() -> None:
    plant = plant_of("small")
    for where, word in (
        (Where.COMMIT, "before"),
        (Where.DURABLE, "after"),
        (Where.SEND, "lost"),
        (Where.ARRIVED, "arrived"),
    ):
        outcome = play(plant, Plan(1, 40.0, 2, crashes=(Crash(where, 12),)))
        assert outcome.wrong == ()
        assert outcome.crashes == 1, where
        assert any(what.startswith("kill at a") and word in what for _, what in outcome.said), where


def test_a_failing_run_is_shrunk_to_what_makes_it_fail() -> None:
    plan = draw(plant_of("small"), next(s for s in range(200) if len(draw(plant_of("small"), s).strikes) >= 6))
    needed = {plan.strikes[1], plan.strikes[4]}
    small = shrunk(plan, lambda simpler: needed <= set(simpler.strikes))
    assert set(small.strikes) == needed
    assert (small.noise, small.crashes, small.keep_open) == ({}, (), 1)


def test_every_seed_has_its_own_mix() -> None:
    plant = plant_of("hall")
    plans = [draw(plant, seed) for seed in range(200)]
    assert len({tuple(plan.strikes) for plan in plans}) == len(plans)
    assert {strike.blow for plan in plans for strike in plan.strikes} >= {
        Blow.DOOR,
        Blow.AGV_ERROR,
        Blow.DRIVE,
        Blow.KILL,
    }
    assert not any(strike.blow is Blow.PUSH for plan in plans for strike in plan.strikes), "the hall has no hoists"


def test_a_campaign_that_tried_too_little_says_what_never_happened() -> None:
    plant, tally = plant_of("small"), Tally()
    assert tally.missing(reached(plant)) == [], "few runs need not reach everything"
    tally.runs = 300
    assert "slow disk" in tally.missing(reached(plant))
    tally.counts.update(reached(plant))
    assert tally.missing(reached(plant)) == []


@pytest.mark.parametrize(("name", "seed"), [("hall", 43)])
def test_a_seed_that_failed_once_is_sound(name: str, seed: int) -> None:
    """hall 43: an AGV that was killed for at a corridor's mouth kept the one inside from coming out."""
    plant = plant_of(name)
    assert play(plant, draw(plant, seed)).wrong == ()
