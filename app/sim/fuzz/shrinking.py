"""Finds out which of the things that went wrong are needed for a run to fail."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

from app.sim.fuzz.plan import Plan

T = TypeVar("T")


def shrunk(plan: Plan, fails: Callable[[Plan], bool]) -> Plan:
    """Return the plan without what can be left out one part after the other, such that it still fails.

    Noise, delays and crash points first, then strikes by halves (delta debugging), then the load. Not the smallest there is.
    """
    for simpler in _plainer(plan):
        if fails(simpler):
            plan = simpler
            break
    lines = sorted({line for line, _ in plan.noise})
    kept = _needed(lines, lambda some: fails(_with_noise(plan, some)))
    plan = _with_noise(plan, kept)
    kept_crashes = _needed(plan.crashes, lambda some: fails(replace(plan, crashes=tuple(some))))
    plan = replace(plan, crashes=tuple(kept_crashes))
    kept_strikes = _needed(plan.strikes, lambda some: fails(replace(plan, strikes=tuple(some))))
    plan = replace(plan, strikes=tuple(kept_strikes))
    while plan.keep_open > 1 and fails(replace(plan, keep_open=plan.keep_open - 1)):
        plan = replace(plan, keep_open=plan.keep_open - 1)
    return plan


def _plainer(plan: Plan) -> list[Plan]:
    usual = type(plan.delays)()
    tries = [replace(plan, delays=usual, answers_on_acceptance=False), replace(plan, delays=usual)]
    tries.append(replace(plan, answers_on_acceptance=False))
    return [simpler for simpler in tries if simpler != plan]


def _with_noise(plan: Plan, lines: Sequence[str]) -> Plan:
    return replace(plan, noise={key: rates for key, rates in plan.noise.items() if key[0] in lines})


def _needed(parts: Sequence[T], fails: Callable[[Sequence[T]], bool]) -> Sequence[T]:
    """Return some of the parts with which it still fails, in their order."""
    pieces = 1
    while parts:
        size = max(1, len(parts) // pieces)
        for begin in range(0, len(parts), size):
            rest = [*parts[:begin], *parts[begin + size :]]
            if fails(rest):
                parts = rest
                break
        else:
            if size == 1:
                return parts
            pieces *= 2
    return parts
