"""A generated plant as the text of a plant file, the same text for the same plant."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise
from math import hypot
from typing import TypeAlias

from app.domain.layout import Edge, Plant, Point, PulseSet, Station, VehicleKind, VehicleSpec
from app.domain.units import Barcode

FIGURES = ("length", "max_count", "max_speed", "curve_speed", "acceleration", "braking", "reach")
NOT_WRITTEN = (
    *("zones", "links", "doors", "buffers", "chargers", "drives", "dialects", "catalogues", "reference_vehicles"),
    *("listen", "process_codes", "alarm_codes", "event_numbers"),
)
LEAST_RANGE = 3
"""Barcodes that are worth writing as a range. Our choice."""
PER_LINE = 20
Value: TypeAlias = str | int


def write(plant: Plant) -> str:
    """Return the plant file that reads back as this plant.

    Raises: ValueError: the plant has more than a fab: AGVs, links, zones, dialects and what hangs on them.
    """
    if _beyond(plant):
        raise ValueError(f"{plant.name} has what no generated fab has: {', '.join(_beyond(plant))}")
    sections = (
        [f"# A generated fab (hoistway fab): {len(plant.points)} barcodes, {len(plant.vehicles)} hoists."],
        [f"name: {_text(plant.name)}", f"clearance: {plant.clearance}"],
        ["barcodes:", *_barcodes(plant.points)],
        ["track:", *_track(plant)],
        _parking(plant),
        _mapping("stations", (_station(station) for station in plant.stations)),
        _vehicles(plant.vehicles),
        _mapping("carriers", (f"{carrier}: {station}" for carrier, station in plant.carriers)),
    )
    return "\n\n".join("\n".join(lines) for lines in sections if lines) + "\n"


def _beyond(plant: Plant) -> list[str]:
    found = [part for part in NOT_WRITTEN if getattr(plant, part)]
    strange = [v.id for v in plant.vehicles if v.kind is not VehicleKind.HOIST or v.listen or v.dialect != "default"]
    return found + strange[:1]


def _mapping(name: str, entries: Iterable[str]) -> list[str]:
    lines = [f"  {entry}" for entry in entries]
    return [f"{name}:", *lines] if lines else []


def _text(text: str) -> str:
    return f'"{text}"'


def _mark(barcode: Barcode) -> str:
    """Return a barcode as it stands in the file: numbers bare, as people write them."""
    return barcode if barcode.isdecimal() and (barcode == "0" or not barcode.startswith("0")) else _text(barcode)


def _number(barcode: Barcode) -> int | None:
    return int(barcode) if _mark(barcode) == barcode else None


def _groups(barcodes: Sequence[Barcode], fits: Callable[[int, int], bool]) -> Iterator[tuple[int, int]]:
    """Give first and last index of the longest stretches of numbers one apart; ``fits`` may end one before an index."""
    first = 0
    for i in range(1, len(barcodes) + 1):
        if i < len(barcodes) and _consecutive(barcodes, first, i) and fits(first, i):
            continue
        yield first, i - 1
        first = i


def _consecutive(barcodes: Sequence[Barcode], first: int, i: int) -> bool:
    numbers = _number(barcodes[first]), _number(barcodes[first + 1]), _number(barcodes[i - 1]), _number(barcodes[i])
    match numbers:
        case int(a), int(b), int(c), int(d):
            return b - a == d - c and abs(b - a) == 1
        case _:
            return False


def _barcodes(points: Sequence[Point]) -> Iterator[str]:
    def evenly(first: int, i: int) -> bool:
        one, two, before, here = points[first], points[first + 1], points[i - 1], points[i]
        rises = int(one.barcode) < int(two.barcode)
        return rises and (two.x - one.x, two.y - one.y) == (here.x - before.x, here.y - before.y)

    for first, last in _groups([point.barcode for point in points], evenly):
        start, end = points[first], points[last]
        if last - first + 1 >= LEAST_RANGE:
            yield f"  {start.barcode}..{end.barcode}: {{from: [{start.x}, {start.y}], to: [{end.x}, {end.y}]}}"
        else:
            for point in points[first : last + 1]:
                yield f"  {_mark(point.barcode)}: [{point.x}, {point.y}]"


def _ranges(barcodes: Sequence[Barcode]) -> Iterator[str]:
    for first, last in _groups(barcodes, lambda *_: True):
        if last - first + 1 >= LEAST_RANGE:
            yield f"{barcodes[first]}..{barcodes[last]}"
        else:
            yield from map(_mark, barcodes[first : last + 1])


def _track(plant: Plant) -> Iterator[str]:
    places = {point.barcode: point for point in plant.points}
    rules = [_rule(edge, places) for edge in plant.edges]
    first = 0
    for i, (edge, after) in enumerate(pairwise([*plant.edges, None]), 1):
        if edge is not None and after is not None and edge.end == after.start and rules[i] == rules[first]:
            continue
        through = [edge.start for edge in plant.edges[first:i]] + [plant.edges[i - 1].end]
        yield f"  - {{through: [{', '.join(_ranges(through))}]{rules[first]}}}"
        first = i


def _rule(edge: Edge, places: dict[Barcode, Point]) -> str:
    start, end = places[edge.start], places[edge.end]
    given = {
        "speed": edge.speed if edge.speed != 100 else None,
        "sensor": edge.sensor or None,
        "curve": "true" if edge.curve else None,
        "length": edge.length if edge.length != round(hypot(end.x - start.x, end.y - start.y)) else None,
    }
    return "".join(f", {name}: {value}" for name, value in given.items() if value is not None)


def _parking(plant: Plant) -> list[str]:
    marks = list(_ranges([point.barcode for point in plant.points if point.park]))
    lines = [f"  {', '.join(marks[i : i + PER_LINE])}," for i in range(0, len(marks), PER_LINE)]
    return ["parking: [", *lines, "]"] if lines else []


def _flow(values: dict[str, Value | None]) -> str:
    return "{" + ", ".join(f"{name}: {value}" for name, value in values.items() if value is not None) + "}"


def _pulses(pulses: PulseSet | None) -> str | None:
    return _flow({"shft": pulses.shft, "rota": pulses.rota, "lift": pulses.lift}) if pulses else None


def _station(station: Station) -> str:
    given: dict[str, Value | None] = {
        "kind": station.kind.value,
        "at": _mark(station.barcode),
        "look_down": station.look_down or None,
        "speed": station.speed if station.speed != 100 else None,
        "dest": _pulses(station.dest),
        "display": _text(station.display) if station.display not in ("", station.id) else None,
        "fallbacks": f"[{', '.join(station.fallbacks)}]" if station.fallbacks else None,
    }
    return f"{station.id}: {_flow(given)}"


def _figures(vehicle: VehicleSpec) -> dict[str, Value | None]:
    limits = (vehicle.limits.shft, vehicle.limits.rota, vehicle.limits.lift)
    shown = {axis: f"[{low}, {high}]" for axis, (low, high) in zip(("shft", "rota", "lift"), limits, strict=True)}
    return {**{name: getattr(vehicle, name) for name in FIGURES}, "limits": _flow(dict(shown))}


def _vehicles(vehicles: Sequence[VehicleSpec]) -> list[str]:
    if not vehicles:
        return []
    usual = _figures(vehicles[0])
    lines = _mapping("vehicle_defaults", (f"{name}: {value}" for name, value in usual.items()))
    return [*lines, "", *_mapping("vehicles", (_vehicle(vehicle, usual) for vehicle in vehicles))]


def _vehicle(vehicle: VehicleSpec, usual: dict[str, Value | None]) -> str:
    own = {name: value for name, value in _figures(vehicle).items() if value != usual[name]}
    given: dict[str, Value | None] = {
        "dev_id": vehicle.dev_id,
        "address": _text(f"{vehicle.host}:{vehicle.port}"),
        "start": None if vehicle.start is None else _mark(vehicle.start),
        "offset": _pulses(vehicle.offset),
        "in_service": None if vehicle.in_service else "false",
        **own,
    }
    return f"{vehicle.id}: {_flow(given)}"
