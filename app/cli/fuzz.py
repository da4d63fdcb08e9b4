"""``hoistway fuzz``: run after run in which everything goes wrong that a seed draws, judged by the oracle."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.plainly import CannotStart, plainly
from app.cli.running import plant_of
from app.cli.tongue import say, told_here

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.sim.fuzz import Outcome, Plan, Tally

MOST_SEEDS = 1_000_000
"""Seeds in one call, at most. Our choice."""
TOLD = 5
"""Failures of a run, and failing runs, that are printed. Our choice."""


def fuzz(
    plant: Annotated[Path, typer.Option(help="the plant file")] = Path("plants/small.yaml"),
    seeds: Annotated[str, typer.Option(metavar="A-B", help="first and last seed, or one")] = "0-99",
    jobs: Annotated[int | None, typer.Option(min=1, help="processes; default: one for each processor")] = None,
    replay: Annotated[int | None, typer.Option(metavar="SEED", help="run this seed alone, and say how it ends")] = None,
    trace: Annotated[bool, typer.Option("--trace", help="with --replay: tell step by step what happens")] = False,
    shrink: Annotated[
        bool, typer.Option("--shrink", help="with --replay: leave out what is not needed to fail")
    ] = False,
    need_all: Annotated[
        bool, typer.Option("--need-all", help="exit 1 if something that a campaign is for never happened")
    ] = False,
) -> None:
    """Run the whole controller against simulated devices while things go wrong; exit 1 if anything happened that must not.

    The same seed gives the same run to the byte. First a safety phase with faults, then faults off and every job must end.
    """
    with plainly():
        found = plant_of(plant)
        if replay is not None:
            raise typer.Exit(_replay(found, plant, replay, trace=trace, shrink=shrink))
        if trace or shrink:
            raise CannotStart("--trace and --shrink are about one run", remedy="Name it: --replay SEED")
        run = _seeds(seeds)
    raise typer.Exit(_campaign(found, plant, run, jobs or os.cpu_count() or 1, need_all=need_all))


def _seeds(text: str) -> range:
    """Return the seeds that ``A-B`` or ``A`` names. Raises CannotStart."""
    first, _, last = text.partition("-")
    if not (first.isascii() and first.isdecimal() and (not last or (last.isascii() and last.isdecimal()))):
        raise CannotStart(f"--seeds {text!r} names no seeds", remedy="Say the first and the last: --seeds 0-299")
    begin, end = int(first), int(last or first)
    if end < begin:
        raise CannotStart(f"--seeds {text}: the last comes before the first", remedy=f"Say --seeds {end}-{begin}")
    if end - begin >= MOST_SEEDS:
        raise CannotStart(f"--seeds {text} are more than {MOST_SEEDS:,}", remedy="Run them in parts")
    return range(begin, end + 1)


def _play(plant: Plant, seed: int) -> Outcome:
    from dataclasses import replace

    from app.sim.fuzz import draw, play

    outcome = play(plant, draw(plant, seed))
    return outcome if outcome.wrong else replace(outcome, said=())


def _outcomes(plant: Plant, seeds: Iterable[int], jobs: int) -> Iterator[Outcome]:
    """Give the outcomes in the order of the seeds, whoever computes them."""
    if jobs == 1:
        yield from (_play(plant, seed) for seed in seeds)
        return
    with multiprocessing.get_context("spawn").Pool(jobs) as pool:
        yield from pool.imap(partial(_play, plant), seeds, chunksize=4)


def _campaign(plant: Plant, file: Path, seeds: range, jobs: int, *, need_all: bool) -> int:
    from rich.console import Console
    from rich.progress import Progress

    from app.sim.fuzz import Tally

    tally = Tally()
    with Progress(console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("seeds", total=len(seeds))
        for outcome in _outcomes(plant, seeds, min(jobs, len(seeds))):
            tally.add(outcome)
            progress.advance(task)
            if outcome.wrong and len(tally.failed) <= TOLD:
                _tell(outcome, file)
    missing = _sum_up(plant, tally)
    return 1 if tally.failed or (need_all and missing) else 0


def _tell(outcome: Outcome, file: Path) -> None:
    say(f"seed {outcome.seed} fails:")
    for wrong in outcome.wrong[:TOLD]:
        print(f"  {wrong}")
    say(f"  see it: hoistway fuzz --plant {file} --replay {outcome.seed} --trace --shrink")


def _sum_up(plant: Plant, tally: Tally) -> list[str]:
    """Print what it adds up to; return what never happened."""
    from app.sim.fuzz import reached

    wanted = reached(plant)
    say(f"runs      {tally.runs}, of which {len(tally.failed)} failed")
    say(
        f"virtual   {tally.virtual / 3600:.1f} h, {tally.jobs} jobs ended, the controller was killed {tally.crashes} times"
    )
    say(f"reached   {', '.join(f'{what} {tally.counts[what]}' for what in sorted(wanted))}")
    missing = tally.missing(wanted)
    if missing:
        say(f"never     {', '.join(missing)}")
    say(f"verdict   {told_here('violated' if tally.failed else 'tries too little' if missing else 'sound')}")
    return missing


def _replay(plant: Plant, file: Path, seed: int, *, trace: bool, shrink: bool) -> int:
    from app.sim.fuzz import draw, play, shrunk

    plan = draw(plant, seed)
    outcome = play(plant, plan)
    if shrink and outcome.wrong:
        before = plan.faults
        plan = shrunk(plan, lambda simpler: bool(play(plant, simpler).wrong))
        outcome = play(plant, plan)
        say(f"shrunk    from {before} faults to {plan.faults}")
    _describe(plan)
    if trace:
        for at, what in outcome.said:
            print(f"{at:10.3f}  {what}")
    for wrong in outcome.wrong:
        say(f"violation {wrong}")
    say(f"trace     {outcome.trace}")
    say(f"verdict   {told_here('violated' if outcome.wrong else 'sound')}")
    return 1 if outcome.wrong else 0


def _describe(plan: Plan) -> None:
    say(f"seed      {plan.seed}: {plan.keep_open} jobs open, calm after {plan.calm:.0f} s")
    for strike in plan.strikes:
        print(f"{strike.at:10.3f}  {strike.blow.value}")
    for crash in plan.crashes:
        say(f"           killed at {crash.where.value} {crash.nth}")
    for (line, way), rates in plan.noise.items():
        if rates:
            print(f"           noise {way} {line}: " + ", ".join(f"{f.value} {r:.3f}" for f, r in rates.items()))
    for what, (least, most) in (
        ("link", plan.delays.link),
        ("commit", plan.delays.commit),
        ("restart", plan.delays.restart),
    ):
        print(f"           {what} takes {least:g}-{most:g} s")
