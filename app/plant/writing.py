"""A plant as the text of a plant file, the same text for the same plant; what is read back is the very same plant."""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from math import hypot
from typing import TypeAlias

from app.domain.ids import StationId
from app.domain.layout import OVERDUE, Edge, Plant, Point, PulseSet, Station, Zone
from app.domain.units import Barcode
from app.plant.writing_machines import equipment, vehicles
from app.plant.written import Value, address, entries, flow, mark, quoted, word

LEAST_RANGE = 3
"""Barcodes that are worth writing as a range. Our choice."""
PER_LINE = 20
Notes: TypeAlias = Mapping[Barcode, str]


def write(
    plant: Plant, head: Sequence[str] = (), notes: Notes | None = None, stations: Mapping[StationId, str] | None = None
) -> str:
    """Return the plant file that reads back as this plant.

    ``head`` are lines of comment before everything else, ``notes`` and ``stations`` a comment behind the barcodes and
    stations that have one. Catalogues of drives are files of their own.
    """
    sections = (
        [f"# {_shown(line)}".rstrip() for line in head],
        [f"name: {quoted(plant.name)}", f"clearance: {plant.clearance}", *_listen(plant)],
        ["barcodes:", *_barcodes(plant.points, notes or {})],
        ["track:" if plant.edges else "track: []", *_track(plant)],
        _parking(plant),
        entries("stations", (_station(station, (stations or {}).get(station.id)) for station in plant.stations)),
        _zones(plant),
        entries("dialects", (f"{word(name)}: {_plain(given)}" for name, given in plant.dialects.items())),
        *equipment(plant),
        _rules(plant),
        *vehicles(plant),
        entries("carriers", (f"{word(carrier)}: {word(station)}" for carrier, station in plant.carriers)),
        *_codes(plant),
    )
    return "\n\n".join("\n".join(lines) for lines in sections if lines) + "\n"


def _shown(text: str) -> str:
    """Return a text as it may stand in a comment."""
    return "".join(letter if letter.isprintable() else " " for letter in text)


def _plain(value: Mapping[str, object]) -> str:
    return json.dumps(dict(value), ensure_ascii=False, default=list)


def _listen(plant: Plant) -> list[str]:
    return [f"listen: {quoted(address(*plant.listen))}"] if plant.listen else []


def _codes(plant: Plant) -> Iterator[list[str]]:
    yield entries("process_codes", (f"0x{code:04X}: {quoted(text)}" for code, text in plant.process_codes.items()))
    yield entries("alarm_codes", (f"0x{code:04X}: {quoted(text)}" for code, text in plant.alarm_codes.items()))
    yield entries("event_numbers", (f"{word(name)}: {number}" for name, number in plant.event_numbers.items()))


def _rules(plant: Plant) -> list[str]:
    idle = plant.idle
    traffic = ["restrain: true"] if plant.restrain else []
    traffic += [] if plant.congestion is None else [f"congestion: {str(plant.congestion).lower()}"]
    lines = [f"traffic: {{{', '.join(traffic)}}}"] if traffic else []
    if idle.park:
        lines.append(f"idle: {{park: true, after: {idle.after:.0f}, farthest: {idle.farthest:.0f}}}")
    if plant.overdue != OVERDUE:
        lines.append(f"jobs: {{overdue: {plant.overdue:.0f}}}")
    return lines


# -- barcodes and track -----------------------------------------------------------------------------------------------


def _number(barcode: Barcode) -> int | None:
    return int(barcode) if mark(barcode) == barcode else None


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


def _barcodes(points: Sequence[Point], notes: Notes) -> Iterator[str]:
    def evenly(first: int, i: int) -> bool:
        one, two, before, here = points[first], points[first + 1], points[i - 1], points[i]
        rises = int(one.barcode) < int(two.barcode)
        alone = any(points[k].barcode in notes for k in (first, i))
        return rises and not alone and (two.x - one.x, two.y - one.y) == (here.x - before.x, here.y - before.y)

    for first, last in _groups([point.barcode for point in points], evenly):
        start, end = points[first], points[last]
        if last - first + 1 >= LEAST_RANGE:
            yield f"  {start.barcode}..{end.barcode}: {{from: [{start.x}, {start.y}], to: [{end.x}, {end.y}]}}"
        else:
            for point in points[first : last + 1]:
                note = f"  # {_shown(notes[point.barcode])}" if point.barcode in notes else ""
                yield f"  {mark(point.barcode)}: [{point.x}, {point.y}]{note}"


def _ranges(barcodes: Sequence[Barcode]) -> Iterator[str]:
    for first, last in _groups(barcodes, lambda *_: True):
        if last - first + 1 >= LEAST_RANGE:
            yield f"{barcodes[first]}..{barcodes[last]}"
        else:
            yield from map(mark, barcodes[first : last + 1])


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


def _listed(barcodes: Sequence[Barcode]) -> list[str]:
    marks = list(_ranges(barcodes))
    return [f"  {', '.join(marks[i : i + PER_LINE])}," for i in range(0, len(marks), PER_LINE)]


def _parking(plant: Plant) -> list[str]:
    lines = _listed([point.barcode for point in plant.points if point.park])
    return ["parking: [", *lines, "]"] if lines else []


# -- stations and zones -----------------------------------------------------------------------------------------------


def pulses(given: PulseSet | None) -> str | None:
    """Return taught positions as they stand in the file."""
    return flow({"shft": given.shft, "rota": given.rota, "lift": given.lift}) if given else None


def _station(station: Station, note: str | None) -> str:
    given: dict[str, Value | None] = {
        "kind": station.kind.value,
        "at": mark(station.barcode),
        "buffer": word(station.buffer) if station.buffer is not None else None,
        "alias": word(station.alias) if station.alias is not None else None,
        "look_down": station.look_down or None,
        "speed": station.speed if station.speed != 100 else None,
        "dest": pulses(station.dest),
        "display": quoted(station.display) if station.display not in ("", station.id) else None,
        "fallbacks": f"[{', '.join(map(word, station.fallbacks))}]" if station.fallbacks else None,
    }
    return f"{word(station.id)}: {flow(given)}" + (f"  # {_shown(note)}" if note else "")


def _zones(plant: Plant) -> list[str]:
    order = {point.barcode: i for i, point in enumerate(plant.points)}
    return entries("zones", (_zone(zone, sorted(zone.barcodes, key=order.__getitem__)) for zone in plant.zones))


def _zone(zone: Zone, inside: Sequence[Barcode]) -> str:
    given: dict[str, Value | None] = {
        "barcodes": f"[{', '.join(_ranges(inside))}]",
        "capacity": zone.capacity if zone.capacity != 1 else None,
        "no_stop": "true" if zone.no_stop else None,
        "name": quoted(zone.name) if zone.name not in ("", zone.id) else None,
    }
    if zone.meter is not None:
        given |= {"soft": "true", "share": str(zone.meter.share), "patience": f"{zone.meter.patience:.0f}"}
    return f"{word(zone.id)}: {flow(given)}"
