"""``hoistway simulate``: controller and plant in virtual time, judged by the oracle."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.plainly import plainly, positive
from app.cli.running import plant_of
from app.cli.tongue import say, told_here

if TYPE_CHECKING:
    from app.sim.world import Result

DRAIN = 1800.0
"""Virtual seconds for the last jobs to end. Our choice."""


def simulate(
    plant: Annotated[Path, typer.Option(help="the plant file")],
    hours: Annotated[float, typer.Option(callback=positive, help="virtual hours under load")] = 1.0,
    seed: Annotated[int, typer.Option(help="the same seed gives the same run, byte for byte")] = 1,
    rate: Annotated[float | None, typer.Option(callback=positive, help="jobs per hour, at random moments")] = None,
    keep: Annotated[int, typer.Option(min=1, help="jobs kept open, if no rate is given")] = 8,
    kills: Annotated[int, typer.Option(min=0, help="kill the controller so many times at random moments")] = 0,
) -> None:
    """Run the whole controller with simulated vehicles in virtual time; exit 1 if anything happened that must not."""
    with plainly():
        found = plant_of(plant)
    from app.sim.run import run  # heavy: a wrong plant file is told before

    begun = time.perf_counter()
    result = run(found, seed, hours * 3600, per_hour=rate, keep_open=None if rate else keep, kills=kills, drain=DRAIN)
    _print(result, time.perf_counter() - begun)
    raise typer.Exit(1 if result.violations or result.open else 0)


def _print(result: Result, seconds: float) -> None:
    say(f"virtual time   {result.virtual / 3600:.2f} h in {seconds:.1f} s ({result.virtual / seconds:.0f} x real time)")
    say(f"jobs           {result.completed} completed, {result.ended} ended, {len(result.open)} open")
    say(f"carriers       {result.takes} picked up, {result.puts} put down")
    say(f"trace          {result.trace}")
    for job in result.open[:10]:
        say(f"  open: {job}")
    for violation in result.violations:
        say(f"  violation {violation}")
    verdict = "violated" if result.violations else "not all ended" if result.open else "sound"
    say(f"verdict        {told_here(verdict)}")
