"""``hoistway bench``: what this program does on this machine, measured."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.plainly import plainly, positive, refuse
from app.cli.tongue import say, told_here

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.plant.fab import Shape

FULL = 0.5
"""Share of the ports that have a carrier at first. Our choice."""

CARRIED = 0.048
"""Vehicles per barcode that are on their way in a generated fab at any time, by runs of the fast plant (docs/traffic.md)."""

commands = typer.Typer(help="Measure this program on this machine.", no_args_is_help=True)


@commands.callback()
def _bench() -> None:
    """Keep the name of a measurement a word of its own, even while there is only one."""


@commands.command()
def hoists(
    vehicles: Annotated[int, typer.Option(min=1, max=10_000, help="hoists of the generated plant")] = 1000,
    minutes: Annotated[float, typer.Option(callback=positive, help="minutes to measure")] = 10.0,
    processes: Annotated[int, typer.Option(min=1, help="processes for the simulated hoists")] = 1,
    settle: Annotated[float, typer.Option(help="seconds under load before it begins")] = 60.0,
    jobs: Annotated[int | None, typer.Option(min=0, help="jobs kept open; as many as hoists unless said")] = None,
    plant: Annotated[Path | None, typer.Option(help="a plant file instead of a generated one")] = None,
    first_port: Annotated[int, typer.Option(min=1024, max=60000, help="port of the first simulated hoist")] = 20001,
    seed: Annotated[int, typer.Option(help="of plant and jobs")] = 1,
) -> None:
    """Drive simulated hoists, to the byte, in other processes: deadlines missed, and CPU by part."""
    from app.cli.hoists.report import missed, report
    from app.cli.hoists.run import Asked, measure
    from app.cli.running import on_loop

    with plainly():
        found_plant = _plant(plant, vehicles, seed)
        count = len(found_plant.hoists)
        asked = Asked(minutes * 60, settle, processes, first_port, count if jobs is None else jobs, seed)

        async def run() -> int:
            found = await measure(found_plant, asked)
            for line in report(found):
                print(line, flush=True)
            return 1 if missed(found) else 0

        code = on_loop(run())
    raise typer.Exit(code)


@commands.command()
def rules(
    networks: Annotated[int, typer.Option(min=1, help="random networks for each rule")] = 1000,
    steps: Annotated[int, typer.Option(min=1, help="steps of each network")] = 2000,
) -> None:
    """Try the rule of admission on random networks of queues, and what is left of it without one of its parts."""
    from app.sim.rules import Rule, check

    failed = False
    for rule in Rule:
        found = [check(seed, rule, steps) for seed in range(networks)]
        locked = sum(outcome.locked for outcome in found)
        looked = sum(outcome.looked for outcome in found) / networks
        print(
            f"{rule:12} {locked:6} of {networks} networks locked up, {sum(o.moves for o in found):9,} moves, "
            f"{sum(o.refusals for o in found):9,} refusals over {looked:.2f} buffers each",
            flush=True,
        )
        failed |= rule is Rule.LOOK_AHEAD and locked > 0
    raise typer.Exit(1 if failed else 0)


@commands.command()
def traffic(
    full: Annotated[bool, typer.Option("--full", help="soak and drill for 8 hours instead of 2")] = False,
    only: Annotated[
        list[str] | None, typer.Option(help="a part: routes, rules, sweep, soak, …; all unless said")
    ] = None,
    fleet: Annotated[list[int] | None, typer.Option(min=1, help="vehicles in the sweep; may be given again")] = None,
    seeds: Annotated[int | None, typer.Option(min=1, help="of each run of the sweep")] = None,
    minutes: Annotated[int | None, typer.Option(min=4, help="of each run of sweep and dispatch")] = None,
    hours: Annotated[float | None, typer.Option(min=1.0, help="of soak and drill")] = None,
    peak: Annotated[int | None, typer.Option(min=1, help="vehicles that count as the fleet that delivers most")] = None,
    json: Annotated[
        Path | None, typer.Option(help="keep what is found there, part by part, beside what runs before have found")
    ] = None,
    table: Annotated[
        list[Path] | None,
        typer.Option(help="write all that is known there as a Markdown table, goals and whether they are met"),
    ] = None,
) -> None:
    """Try the rules of traffic on a whole fab: routes, lock-ups, deliveries by fleet, hours, dispatch, speed, a drill."""
    from dataclasses import replace

    from app.cli.traffic.report import FAB, OVER, PARTS, Extent, Report
    from app.cli.traffic.report import FULL as EIGHT_HOURS
    from app.cli.traffic.table import Kept

    unknown = [name for name in only or () if name not in PARTS]
    if unknown:
        raise typer.BadParameter(f"there is no part {', '.join(unknown)}; there are {', '.join(PARTS)}")
    for vehicles in (*(fleet or ()), *((peak,) if peak else ())):
        _fits(FAB, round(OVER * vehicles))
    extent = EIGHT_HOURS if full else Extent()
    extent = replace(
        extent,
        fleets=tuple(fleet or extent.fleets),
        seeds=tuple(range(1, seeds + 1)) if seeds else extent.seeds,
        minutes=minutes or extent.minutes,
        soak=hours or extent.soak,
        drill=hours or extent.drill,
        peak=peak or extent.peak,
    )
    with plainly():
        kept = Kept(json, table or ())
        report = Report(extent, kept.found)
        kept.keep()  # rather now than after an hour
    for name, part in PARTS.items():
        if not only or name in only:
            report.begin(name)
            for line in part(report):
                print(f"{name:9} {line}", flush=True)
            kept.keep()
    print(f"\n{kept.table}")
    raise typer.Exit(1 if report.failed else 0)


@commands.command()
def agree(
    size: Annotated[str, typer.Option(help="of the generated fab")] = "1k",
    vehicles: Annotated[int, typer.Option(min=1, help="hoists")] = 20,
    minutes: Annotated[
        float, typer.Option(callback=positive, help="virtual minutes, of which the first two do not count")
    ] = 15.0,
    backlog: Annotated[int, typer.Option(min=0, help="transfers that wait for a vehicle")] = 50,
    seed: Annotated[int, typer.Option(help="of fab, starts and transfers")] = 1,
) -> None:
    """Compare the fast plant with the byte-level one: same fab, same starts, same transfers in the same order."""
    from time import process_time

    from app.plant.fab import SIZES, generate, populate
    from app.sim.agreement import fast, orders, to_the_byte

    if size not in SIZES:
        raise typer.BadParameter(f"there is no size {size}; there are {', '.join(SIZES)}")
    _fits(SIZES[size], vehicles)
    found_plant = populate(generate(SIZES[size], seed).plant, vehicles, seed, FULL)
    work, until, rates = orders(found_plant, seed), minutes * 60, []
    for name, run in (("to the byte", to_the_byte), ("fast", fast)):
        begun = process_time()
        ran = run(found_plant, seed, work, backlog, until)
        rates.append(ran.per_hour(min(120.0, until / 2), until))
        used = process_time() - begun
        say(f"{told_here(name)}: {len(ran.delivered)} delivered, {rates[-1]:,.1f}/h, {used:.1f} s CPU")
        if len(ran.delivered) + vehicles > len(work):
            refuse(
                f"its {len(work)} transfers were used up before the end",
                "Say fewer minutes or vehicles, or a larger fab.",
            )
    if not rates[0]:
        refuse("nothing was delivered in the time that counts", "Say more minutes.")
    off = rates[1] / rates[0] - 1
    say(f"the fast plant delivers {off:+.1%} (goal: within 3 %)")
    raise typer.Exit(0 if abs(off) <= 0.03 else 1)


def _fits(shape: Shape, vehicles: int) -> None:
    """Raises typer.BadParameter: so many vehicles do not find room in that fab."""
    from app.plant.fab import generate, populate

    try:
        populate(generate(shape, 1).plant, vehicles, 1, FULL)
    except ValueError as wrong:
        raise typer.BadParameter(str(wrong)) from None


def _plant(file: Path | None, vehicles: int, seed: int) -> Plant:
    if file is not None:
        from app.cli.running import plant_of

        return plant_of(file)
    return kept_back(generated(vehicles, seed))


def kept_back(plant: Plant) -> Plant:
    """Return the plant with the rules that its operator would set if its fleet is larger than its track carries."""
    from dataclasses import replace

    from app.domain.layout import IdleRules
    from app.domain.units import Seconds

    if len(plant.vehicles) <= CARRIED * len(plant.points):
        return plant
    return replace(plant, restrain=True, idle=IdleRules(park=True, after=Seconds(5.0), farthest=Seconds(240.0)))


def generated(vehicles: int, seed: int) -> Plant:
    """Return a fab with so many hoists, and carriers at half of its ports."""
    from app.cli.traffic.report import grown
    from app.plant.fab import generate, populate

    return populate(generate(grown(vehicles), seed).plant, vehicles, seed, FULL)
