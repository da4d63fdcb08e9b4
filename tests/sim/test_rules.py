"""The rule of admission keeps random networks of queues from locking up, and nothing weaker does."""

import pytest

from app.sim.rules import Rule, check

SEEDS = range(60)


def locked(rule: Rule, *, least: int = 2, steps: int = 1_000) -> int:
    return sum(check(seed, rule, steps, least=least).locked for seed in SEEDS)


def test_with_the_look_ahead_no_network_locks_up() -> None:
    assert locked(Rule.LOOK_AHEAD) == 0


@pytest.mark.parametrize("rule", [Rule.NONE, Rule.NO_HOLE, Rule.NO_DWELLERS])
def test_with_less_than_the_rule_most_networks_lock_up(rule: Rule) -> None:
    assert locked(rule) > len(SEEDS) / 2


def test_a_buffer_for_one_vehicle_is_why_there_are_no_stop_zones() -> None:
    assert locked(Rule.LOOK_AHEAD, least=1, steps=3_000) > 0


def test_vehicles_go_on_moving_and_some_are_refused() -> None:
    outcome = check(7, Rule.LOOK_AHEAD)

    assert outcome.moves > 100
    assert outcome.refusals > 0
    assert outcome.looked >= 1


def test_the_same_seed_gives_the_same_run() -> None:
    assert check(3, Rule.LOOK_AHEAD) == check(3, Rule.LOOK_AHEAD)
