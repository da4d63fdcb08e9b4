"""The figures of a measurement, for people."""

from collections.abc import Iterator, Mapping

from app.cli.hoists.run import Found

ALARMS = 5
"""So many kinds of alarms are named, the most frequent."""


def report(found: Found) -> Iterator[str]:
    """Give the lines of the report."""
    controller, seconds = found.controller, found.seconds
    yield f"{found.vehicles:,} hoists, {seconds:.0f} s"
    yield f"jobs          {found.completed:,} delivered ({found.completed / seconds * 3600:,.0f} an hour), {found.failed} failed"
    yield f"missed        {_missed(found)}"
    for alarm, count in sorted(found.said.items(), key=lambda one: -one[1])[:ALARMS]:
        yield f"  alarm       {count:,} times: {alarm}"
    yield f"loop late     {_spread(controller['late'])}; without the waiting for a processor {_spread(controller['late_own'])}"
    yield f"machine       the loop was ready and had no processor for {_share(controller['waited'], seconds)} of the time"
    came, left = (controller["lines"][name] / seconds for name in ("frames_in", "frames_out"))
    yield f"packets       {came:,.0f} in, {left:,.0f} out a second"
    process = controller["process"]
    total = process["user"] + process["kernel"]
    yield (
        f"controller    {_share(total, seconds)} of a processor ({_share(process['user'], seconds)} user, "
        f"{_share(process['kernel'], seconds)} kernel), {found.per_vehicle_second:.0f} µs a vehicle and second, "
        f"{process['rss']:.0f} MB"
    )
    threads = dict(controller["threads"])
    main = threads.pop("MainThread", 0.0)
    yield from _table("by part of the loop's thread", controller["parts"], seconds, main)
    yield from _table("by thread", {"event loop": main, **threads}, seconds, total)
    plant = sum(floor["user"] + floor["kernel"] for floor in found.floors)
    memory = sum(floor["rss"] for floor in found.floors)
    yield f"plant         {_share(plant, seconds)} of a processor in {len(found.floors)} processes, {memory:.0f} MB"
    for floor in found.floors:
        yield f"plant late    {_spread(floor['late'])}: so much later a simulated hoist drives, answers and reads than a real one"
    yield f"together      {_share(total + plant, seconds)} of a processor"
    yield "commands      " + ", ".join(f"{name} {count:,}" for name, count in found.commands.items() if count)
    for floor in found.floors:
        for violation in floor.get("violations", ()):
            yield f"violation     {violation}"


def missed(found: Found) -> int:
    """Return how many deadlines were missed, by anybody: polls, answers, ACKs, links, and alarms."""
    lines = found.controller["lines"]
    unknown = sum(count for name, count in found.commands.items() if name.split()[1] in UNKNOWN)
    return int(lines["lost_polls"] + lines["connections"] + lines["resends"] + unknown + found.alarms + found.held)


UNKNOWN = frozenset({"unknown", "settled_done", "settled_not_done"})
"""States of commands that had no answer in time."""


def _missed(found: Found) -> str:
    lines = found.controller["lines"]
    unknown = sum(count for name, count in found.commands.items() if name.split()[1] in UNKNOWN)
    return (
        f"{missed(found)}: {lines['lost_polls']:.0f} polls unanswered, {lines['connections']:.0f} links lost, "
        f"{lines['resends']:.0f} packets sent again for want of an ACK, {unknown} commands without an answer, "
        f"{found.alarms} alarms, {found.held} holds; {lines['duplicates']:.0f} packets came twice, {lines['garbled']:.0f} garbled"
    )


def _spread(late: Mapping[str, float]) -> str:
    return ", ".join(f"{name} {value:.1f} ms" for name, value in late.items())


def _share(cpu: float, seconds: float) -> str:
    return f"{100 * cpu / seconds:.1f} %"


def _table(title: str, parts: Mapping[str, float], seconds: float, whole: float) -> Iterator[str]:
    yield f"  {title}: {_share(whole, seconds)}"
    for name, cpu in sorted(parts.items(), key=lambda part: -part[1]):
        yield f"    {name:32} {_share(cpu, seconds):>8}"
