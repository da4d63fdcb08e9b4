"""What differs between two plants, in words, and what that breaks in a plant that has run."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from enum import Enum
from math import hypot
from typing import Any

from app.domain.layout import Plant, Point, Station, VehicleKind
from app.plant.connections import graph_of, reachable

NEAR = 1.0
"""A mark that disappears where another appears, within so many mm, has got another name."""
FIRST_ONLY = "its dest counts only where a database is made: teach it, or PUT /api/v1/stations/ID/dest"
CARRIERS_ONCE = "counts only where a database is made: PUT /api/v1/carriers/ID with its place"
SECTIONS = ("zones", "vehicles", "links", "doors", "buffers", "chargers", "drives")
RULES = (
    "name",
    "clearance",
    "listen",
    "charging",
    "restrain",
    "congestion",
    "reference_vehicles",
    "carriers",
    "idle",
    "overdue",
    "dialects",
    "process_codes",
    "alarm_codes",
    "event_numbers",
)


@dataclass(frozen=True, slots=True)
class Change:
    """One difference: ``what`` is ``barcode``, ``track``, ``station``, …, ``how`` is added, moved, changed …"""

    what: str
    how: str
    name: str
    text: str
    before: Any = None
    after: Any = None


@dataclass(frozen=True, slots=True)
class Broken:
    """What no longer holds in a plant that has run with the old file: ``touches`` are what may refer to it."""

    what: str
    name: str
    text: str
    remedy: str
    touches: tuple[str, ...] = ()


def obstruction(broken: Sequence[Broken]) -> str:
    """Return in a sentence, without its full stop, what stands in the way of a plant: the first of it, and how much more."""
    first, more = broken[0], f" (and {len(broken) - 1} more)" if len(broken) > 1 else ""
    return f"{first.what} {first.name} stands in the way: {first.text}{more}"


@dataclass(frozen=True, slots=True)
class Difference:
    """All changes, and what they break."""

    changes: list[Change]
    broken: list[Broken]


def difference(old: Plant, new: Plant) -> Difference:
    """Return what is different in the new plant."""
    renamed = _renamed(old, new)
    changes = [*_points(old, new, renamed), *_edges(old, new), *_stations(old, new)]
    for section in SECTIONS:
        changes += _section(section.removesuffix("s"), _by_id(getattr(old, section)), _by_id(getattr(new, section)))
    changes += _rules(old, new)
    changes += _catalogues(old, new)
    return Difference(changes, list(_broken(old, new, renamed)))


def shown(value: Any) -> Any:
    """Return a value of the plant as JSON and people see it."""
    if isinstance(value, Enum):
        return value.value
    if hasattr(value, "__dataclass_fields__"):
        return {field.name: shown(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, frozenset | set):
        return sorted((shown(item) for item in value), key=str)
    if isinstance(value, tuple | list):
        return [shown(item) for item in value]
    if isinstance(value, Mapping):
        return {str(key): shown(item) for key, item in value.items()}
    return value


def _by_id(items: Iterable[Any]) -> dict[str, Any]:
    return {item.id: item for item in items}


# -- track --------------------------------------------------------------------------------------------------------------


def _renamed(old: Plant, new: Plant) -> dict[str, str]:
    """Return new names by old ones, of marks that stand where another stood."""
    before, after = {p.barcode for p in old.points}, {p.barcode for p in new.points}
    spots = {(p.x, p.y): p.barcode for p in new.points if p.barcode not in before}
    found = {p.barcode: spots[p.x, p.y] for p in old.points if p.barcode not in after and (p.x, p.y) in spots}
    twice = [name for name in found.values() if list(found.values()).count(name) > 1] if len(found) < 1000 else []
    return {name: other for name, other in found.items() if other not in twice}


def _points(old: Plant, new: Plant, renamed: Mapping[str, str]) -> Iterator[Change]:
    before, after = {p.barcode: p for p in old.points}, {p.barcode: p for p in new.points}
    for name, point in before.items():
        if name in renamed:
            yield Change("barcode", "renamed", name, f"is {renamed[name]} now, at the same place", name, renamed[name])
        elif name not in after:
            yield Change("barcode", "removed", name, f"was at [{point.x}, {point.y}]", shown(point))
    names = set(renamed.values())
    for name, point in after.items():
        if name not in before:
            if name not in names:
                yield Change("barcode", "added", name, f"at [{point.x}, {point.y}]", None, shown(point))
            continue
        yield from _moved(before[name], point)


def _moved(was: Point, point: Point) -> Iterator[Change]:
    away = hypot(point.x - was.x, point.y - was.y)
    if away >= NEAR:
        text = f"by {away:.0f} mm, from [{was.x}, {was.y}] to [{point.x}, {point.y}]"
        yield Change("barcode", "moved", was.barcode, text, [was.x, was.y], [point.x, point.y])
    if was.park != point.park:
        text = "is a parking place now" if point.park else "is no parking place any more"
        yield Change("barcode", "changed", was.barcode, text, was.park, point.park)


def _edges(old: Plant, new: Plant) -> Iterator[Change]:
    before = {(edge.start, edge.end): edge for edge in old.edges}
    after = {(edge.start, edge.end): edge for edge in new.edges}
    for pair, edge in before.items():
        if pair not in after:
            yield Change("track", "removed", f"{pair[0]} → {pair[1]}", f"was {edge.length} mm long", shown(edge))
    for pair, edge in after.items():
        name = f"{pair[0]} → {pair[1]}"
        if pair not in before:
            yield Change("track", "added", name, f"{edge.length} mm long", None, shown(edge))
        elif before[pair] != edge:
            was = before[pair]
            text = _fields_text(was, edge, ("length", "speed", "sensor", "curve"), {"length": " mm", "speed": " %"})
            yield Change("track", "changed", name, text, shown(was), shown(edge))


# -- what stands on it --------------------------------------------------------------------------------------------------


def _stations(old: Plant, new: Plant) -> Iterator[Change]:
    for change in _section("station", _by_id(old.stations), _by_id(new.stations)):
        before, after = ((shape or {}).get("dest") for shape in (change.before, change.after))
        text = f"{change.text}; {FIRST_ONLY}" if change.text else FIRST_ONLY
        yield replace(change, text=text) if after is not None and after != before else change


def _section(what: str, before: Mapping[str, Any], after: Mapping[str, Any]) -> Iterator[Change]:
    for name, item in before.items():
        if name not in after:
            yield Change(what, "removed", name, "", shown(item))
    for name, item in after.items():
        if name not in before:
            yield Change(what, "added", name, "", None, shown(item))
        elif before[name] != item:
            names = tuple(field.name for field in fields(item) if field.name != "id")
            yield Change(
                what, "changed", name, _fields_text(before[name], item, names), shown(before[name]), shown(item)
            )


def _fields_text(was: Any, now: Any, names: Iterable[str], units: Mapping[str, str] | None = None) -> str:
    told = []
    for name in names:
        a, b = getattr(was, name), getattr(now, name)
        if a != b:
            unit = (units or {}).get(name, "")
            told.append(f"{name} {_short(a)} → {_short(b)}{unit}")
    return ", ".join(told)


def _short(value: Any) -> str:
    plain = shown(value)
    if isinstance(plain, list) and len(plain) > 6:
        return f"[{len(plain)} items]"
    if isinstance(plain, dict):
        return "{" + ", ".join(f"{key}: {item}" for key, item in plain.items()) + "}"
    return "none" if plain in (None, "") else str(plain)


def _rules(old: Plant, new: Plant) -> Iterator[Change]:
    for name in RULES:
        a, b = getattr(old, name), getattr(new, name)
        if a != b:
            text = f"{_short(a)} → {_short(b)}" + (f"; {CARRIERS_ONCE}" if name == "carriers" else "")
            yield Change("plant", "changed", name, text, shown(a), shown(b))


def _catalogues(old: Plant, new: Plant) -> Iterator[Change]:
    before, after = ({catalogue.model: catalogue for catalogue in plant.catalogues} for plant in (old, new))
    for model in sorted({*before, *after}):
        was, now = before.get(model), after.get(model)
        if was is None or now is None:
            yield Change("catalogue", "added" if now else "removed", model, "", shown(was), shown(now))
        elif was != now:
            numbers = sorted({*was.parameters, *now.parameters})
            told = [f"{n:02X}" for n in numbers if was.parameters.get(n) != now.parameters.get(n)]
            text = f"describes {_listed(told)} in another way" if told else "has another description"
            yield Change("catalogue", "changed", model, text, shown(was), shown(now))


def _listed(names: Sequence[str]) -> str:
    more = f" and {len(names) - 6} more" if len(names) > 6 else ""
    return f"parameter{'s' * (len(names) > 1)} {', '.join(names[:6])}{more}"


# -- what breaks --------------------------------------------------------------------------------------------------------


def _broken(old: Plant, new: Plant, renamed: Mapping[str, str]) -> Iterator[Broken]:
    stations = _by_id(new.stations)
    for station in old.stations:
        yield from _broken_station(station, stations.get(station.id), renamed)
    yield from _cut_off(old, new)
    places = {point.barcode for point in new.points}
    gone = [p.barcode for p in old.points if p.barcode not in places]
    if gone:
        more = f" and {len(gone) - 1} more" if len(gone) > 1 else ""
        text = "a vehicle that stands there, holds it or is on its way there is not placed in the new plant"
        yield Broken("barcode", f"{gone[0]}{more}", text, "change over with no vehicle there", ("vehicles", "closures"))
    vehicles = _by_id(new.vehicles)
    for vehicle in old.vehicles:
        now = vehicles.get(vehicle.id)
        if now is None:
            text = "jobs that it carries out, its taught offset and its history have no vehicle any more"
            remedy = "let it end its job, and take it off the rail"
            yield Broken("vehicle", vehicle.id, text, remedy, ("jobs", "teaching", "holds"))
        elif (now.dev_id, now.kind) != (vehicle.dev_id, vehicle.kind):
            text = (
                f"it has another number or kind: {vehicle.kind.value} {vehicle.dev_id} → {now.kind.value} {now.dev_id}"
            )
            yield Broken("vehicle", vehicle.id, text, "is it the same machine? Its offset is kept", ("teaching",))


def _broken_station(was: Station, now: Station | None, renamed: Mapping[str, str]) -> Iterator[Broken]:
    if now is None:
        text = (
            "jobs from and to it, the carrier in it, its taught DEST and reservations name a station that is not there"
        )
        remedy = "end those jobs, move the carrier, or keep the name"
        yield Broken("station", was.id, text, remedy, ("jobs", "carriers", "teaching", "fallbacks"))
        return
    if now.kind is not was.kind:
        text = f"it was a {was.kind.value} and is a {now.kind.value}: other vehicles, or other commands, serve it"
        yield Broken("station", was.id, text, "end its jobs first", ("jobs", "teaching"))
    if now.barcode != was.barcode and renamed.get(was.barcode) != now.barcode:
        text = f"it is served from {now.barcode} instead of {was.barcode}: its taught DEST was measured at the other"
        yield Broken("station", was.id, text, "teach it anew before jobs go there", ("teaching", "jobs"))


def _cut_off(old: Plant, new: Plant) -> Iterator[Broken]:
    """Stations that could be reached from the others and back, and now cannot."""
    for kind in VehicleKind:
        both = {s.id for s in old.stations} & {s.id for s in new.stations}
        was = [s for s in old.stations if s.id in both and s.kind in kind.serves]
        now = [s for s in new.stations if s.id in both and s.kind in kind.serves]
        lost = _apart(new, now) - _apart(old, was)
        for name in sorted(lost):
            text = "no way leads there and back any more from where most stations are: its jobs would wait for ever"
            yield Broken("station", name, text, "add the missing track", ("jobs",))


def _apart(plant: Plant, stations: list[Station]) -> set[str]:
    """Return the stations that lie outside the part of the track where most of them are."""
    if not stations:
        return set()
    main = reachable(graph_of(plant), [station.barcode for station in stations])
    return {station.id for station in stations if station.barcode not in main}
