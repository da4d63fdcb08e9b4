"""From a draft to a plant: names that the wire takes, whole millimetres, references that lead somewhere."""

from collections import Counter, defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import islice
from math import hypot, isfinite

from app.domain.devices import DeviceId
from app.domain.ids import CarrierId, StationId, ZoneId
from app.domain.layout import (
    ChargerSpec,
    ChargingRules,
    Edge,
    Plant,
    Point,
    Station,
    StationKind,
    VehicleKind,
    Zone,
)
from app.domain.units import Barcode, Millimetres, Percent, Seconds
from app.plant.exchange.draft import Draft, Place, Spot, Way
from app.plant.exchange.machines import FLOOR, crew
from app.plant.exchange.naming import barcodes_of, displays_of, ids_of
from app.plant.exchange.report import Report, shown
from app.plant.format import MAX_LENGTH
from app.plant.names import DISPLAY_BYTES, is_id

NAME_UNIT = "check the unit, and name it: --unit mm or --unit m"
FARTHEST = 10**9
"""Largest coordinate of a plant file, mm."""
BENT = 1.1
"""Track longer than the distance of its ends by more than this is a curve (the checker's own tolerance)."""
CHARGE_AFTER = ChargingRules(trips=20, after=Seconds(3600.0))
"""When AGVs charge where nobody has said it yet. Our choice."""


@dataclass(frozen=True, slots=True)
class Options:
    """What a person says about an import.

    ``kind``: what drives there; None: what the layout tells. ``names``: barcodes by the layout's own names. ``vehicles``: so
    many simulated ones. ``velocity``: 100 percent of speed, mm/s.
    """

    kind: VehicleKind | None = None
    names: dict[str, str] = field(default_factory=dict)
    vehicles: int = 0
    velocity: float | None = None
    title: str = ""
    clearance: int = 0


@dataclass(frozen=True, slots=True)
class Settled:
    """The plant, and for each barcode and each station that has another name in the source, that name."""

    plant: Plant
    notes: dict[Barcode, str]
    stations: dict[StationId, str]


def settle(draft: Draft, options: Options, report: Report) -> Settled:
    """Return the plant that the draft describes, as far as it does; everything else is in the report."""
    kind = options.kind or _kind(draft)
    spots = _spots(draft, report)
    merged = _merged(draft, spots, report) if draft.maps else {spot.name: spot.name for spot in spots}
    kept = [spot for spot in spots if merged[spot.name] == spot.name]
    for name in options.names:
        if name not in merged:
            report.wrong(f"names: {shown(name)}", "the layout has no such mark", "correct it in the file of names")
    by_name, text = barcodes_of([spot.name for spot in kept], kind, options.names, report)
    barcodes = {name: Barcode(by_name[first]) for name, first in merged.items()}
    top = options.velocity or _fastest(draft)
    points = tuple(Point(barcodes[s.name], Millimetres(round(s.x)), Millimetres(round(s.y)), s.park) for s in kept)
    edges = _in_runs(_edges(draft, barcodes, points, top, report))
    taken: set[str] = {FLOOR}
    chargers = _chargers(draft, barcodes, kind, taken, report)
    made = list(_stations(draft, barcodes, kind, report))
    stations = {place.name: station for place, station in made}
    plant = Plant(
        name=options.title or draft.title or "plant",
        points=points,
        edges=tuple(edges),
        stations=tuple(stations.values()),
        carriers=tuple(_carriers(made, report)),
        vehicles=(),
        zones=tuple(_zones(draft, barcodes, report)),
        chargers=chargers,
        charging=CHARGE_AFTER if chargers else ChargingRules(),
        clearance=Millimetres(options.clearance or draft.clearance),
    )
    plant = crew(plant, draft, barcodes, kind, options.vehicles, top, taken, report, text=text)
    notes = {Barcode(by_name[s.name]): s.name for s in kept if by_name[s.name] != s.name}
    return Settled(plant, notes, {station.id: name for name, station in stations.items() if station.id != name})


def _kind(draft: Draft) -> VehicleKind:
    kinds = Counter(kind for place in draft.places for kind in VehicleKind if place.kind in kind.serves)
    kinds.update(machine.kind for machine in draft.machines if machine.kind is not None)
    return kinds.most_common(1)[0][0] if kinds else draft.kind


def _fastest(draft: Draft) -> float | None:
    """Return the highest velocity that anything in the layout has, which becomes 100 percent."""
    said = [m.velocity for m in draft.machines if m.velocity] or [w.velocity for w in draft.ways if w.velocity]
    return max(said, default=None)


# -- marks ------------------------------------------------------------------------------------------------------------


def _spots(draft: Draft, report: Report) -> list[Spot]:
    found: dict[str, Spot] = {}
    for spot in draft.spots:
        if not (isfinite(spot.x) and isfinite(spot.y)):
            report.wrong(spot.where, "the position is no number, so the mark is left out", "give x and y")
        elif max(abs(spot.x), abs(spot.y)) > FARTHEST:
            report.wrong(spot.where, f"the position is more than {FARTHEST // 10**6} km away", NAME_UNIT)
        elif spot.name not in found:
            found[spot.name] = spot
        else:
            _doubled(found[spot.name], spot, report)
    return list(found.values())


def _doubled(first: Spot, spot: Spot, report: Report) -> None:
    first.park |= spot.park
    if hypot(first.x - spot.x, first.y - spot.y) < 1:
        report.repaired(spot.where, f"{shown(spot.name)} is given again, alike ({first.where})")
    else:
        what = f"{shown(spot.name)} is given twice, at different places: kept is the first ({first.where})"
        report.wrong(spot.where, what, "keep one of them")


def _merged(draft: Draft, spots: list[Spot], report: Report) -> dict[str, str]:
    """Return for each name the one that stands for its place: an AGV reads one tag there."""
    at: dict[tuple[str, int, int], Spot] = {}
    found = {}
    for spot in spots:
        first = at.setdefault((spot.level, round(spot.x), round(spot.y)), spot)
        found[spot.name] = first.name
        if first is not spot:
            first.park |= spot.park
            what = "lies where another node lies, and becomes one mark with it (turns and levels are not told apart)"
            report.repaired(f"{spot.where} → {shown(first.name)}", what)
    return found


# -- track ------------------------------------------------------------------------------------------------------------


def _edges(
    draft: Draft, barcodes: dict[str, Barcode], points: tuple[Point, ...], top: float | None, report: Report
) -> list[Edge]:
    places = {point.barcode: point for point in points}
    found: dict[tuple[Barcode, Barcode], Edge] = {}
    for way in draft.ways:
        missing = [name for name in (way.start, way.end) if name not in barcodes]
        if missing:
            what = f"leads to {shown(missing[0])}, which is nowhere given: left out"
            report.wrong(way.where, what, "give the mark a position, or leave the track out")
            continue
        ends = barcodes[way.start], barcodes[way.end]
        if ends[0] == ends[1]:
            _note_turn(way, report)
            continue
        edge = _edge(way, (places[ends[0]], places[ends[1]]), top, report)
        if edge is not None and _is_new(found.get(ends), edge, way, report):
            found[ends] = edge
    return list(found.values())


def _note_turn(way: Way, report: Report) -> None:
    if way.start == way.end:
        report.left_out(way.where, "leads from a mark to itself")
    else:
        report.left_out(way.where, "leads from node to node at one place: a turn, which vehicles make by themselves")


def _is_new(known: Edge | None, edge: Edge, way: Way, report: Report) -> bool:
    if known is None:
        return True
    if known == edge:
        report.repaired(way.where, "the same track is given again")
    else:
        report.left_out(way.where, "a second way between the same two marks: kept is the first")
    return False


def _edge(way: Way, ends: tuple[Point, Point], top: float | None, report: Report) -> Edge | None:
    distance = hypot(ends[1].x - ends[0].x, ends[1].y - ends[0].y)
    length = _length(way, distance, report)
    if length is None:
        return None
    curve = way.curve if way.curve is not None else length > BENT * distance + 1
    return Edge(
        ends[0].barcode, ends[1].barcode, Millimetres(length), _percent(way, top, report), way.sensor & 15, curve
    )


def _length(way: Way, distance: float, report: Report) -> int | None:
    given = way.length
    if given is not None and not isfinite(given):
        report.wrong(way.where, "the length is no number: taken is the distance of the ends", "correct it")
        given = None
    elif given is not None and given < 0:
        report.wrong(way.where, "the length is below zero: taken is the distance of the ends", "correct it")
        given = None
    elif given is not None and round(given) == 0:
        if distance >= 1:
            report.repaired(way.where, "the length is 0: taken is the distance of the ends")
        given = None
    length = round(distance if given is None else given)
    if length == 0:
        what = "both ends lie at one place and no length is given: left out"
        report.wrong(way.where, what, "correct a position, or give the length")
        return None
    if length > MAX_LENGTH:
        report.wrong(way.where, f"longer than {MAX_LENGTH // 10**6} km: left out", NAME_UNIT)
        return None
    return length


def _percent(way: Way, top: float | None, report: Report) -> Percent:
    speed = 100.0 if way.speed is None else way.speed
    if way.velocity is not None and top:
        speed = way.velocity / top * 100
    if not isfinite(speed) or speed <= 0:
        report.wrong(way.where, "the speed is not above 0: taken is 100 percent", "correct it")
        speed = 100
    if speed > 100.5:
        report.repaired(way.where, "the speed is above the vehicles' own: taken is 100 percent")
    return Percent(max(1, min(100, round(speed))))


def _in_runs(edges: list[Edge]) -> list[Edge]:
    """Return the edges so that as many as possible follow one another: they make few lines in the file."""
    after: defaultdict[Barcode, list[Edge]] = defaultdict(list)
    into: Counter[Barcode] = Counter()
    for edge in edges:
        after[edge.start].append(edge)
        into[edge.end] += 1
    first = [e for e in edges if into[e.start] != 1 or len(after[e.start]) != 1]
    done: set[tuple[Barcode, Barcode]] = set()
    found: list[Edge] = []
    for begin in (*first, *edges):
        run = [begin] if (begin.start, begin.end) not in done else []
        while run:
            here = run.pop()
            done.add((here.start, here.end))
            found.append(here)
            onward = (e for e in after[here.end] if (e.start, e.end) not in done and e.end != here.start)
            run = list(islice(onward, 1))
    return found


# -- stations, chargers, zones ----------------------------------------------------------------------------------------


def _stations(
    draft: Draft, barcodes: dict[str, Barcode], kind: VehicleKind, report: Report
) -> Iterable[tuple[Place, Station]]:
    """Give the stations, each with what it was made of; a carrier that was to stand at one that is left out is named with it."""
    names = ids_of(((place.name, place.where) for place in draft.places), set(), "ST", report)
    shows = displays_of(((names[place.name], place.display or names[place.name]) for place in draft.places), report)
    usual = StationKind.AGV_BUFFER if kind is VehicleKind.AGV else StationKind.PORT
    seen: dict[str, str] = {}
    for place in draft.places:
        spots = [spot for spot in place.spots if spot in barcodes]
        also = f", and carrier {shown(place.carrier)} with it" if place.carrier else ""
        if place.name in seen:
            report.wrong(place.where, f"{shown(place.name)} is a station already ({seen[place.name]}): left out{also}")
            continue
        if not spots:
            named = f"its mark {shown(place.spots[0])} is nowhere given" if place.spots else "no mark is named for it"
            report.wrong(place.where, f"{named}: left out{also}", "name the mark where vehicles stop for it")
            continue
        others = sorted({barcodes[spot] for spot in spots} - {barcodes[spots[0]]})
        if others:
            what = f"a station is reached from one mark: kept is {shown(spots[0])}"
            report.left_out(
                place.where, what, "give stations of their own to the others if they hold carriers of their own"
            )
        seen[place.name] = place.where
        yield (
            place,
            Station(
                id=StationId(names[place.name]),
                kind=place.kind or usual,
                barcode=barcodes[spots[0]],
                look_down=place.look_down & 15,
                speed=Percent(max(1, min(100, place.speed))),
                dest=place.dest if (place.kind or usual) is StationKind.PORT else None,
                display=shows[names[place.name]],
                fallbacks=tuple(StationId(names[f]) for f in place.fallbacks if f in names and f != place.name),
            ),
        )


def _carriers(made: Iterable[tuple[Place, Station]], report: Report) -> Iterable[tuple[CarrierId, StationId]]:
    """Give the carriers that stand at stations when the plant is first started."""
    seen: set[str] = set()
    for place, station in made:
        if not place.carrier:
            continue
        if place.carrier in seen or not is_id(place.carrier) or len(place.carrier) > DISPLAY_BYTES:
            what = f"{shown(place.carrier)} cannot be a carrier: {DISPLAY_BYTES} letters and digits, each once"
            report.wrong(place.where, what, "correct its name")
        else:
            seen.add(place.carrier)
            yield CarrierId(place.carrier), station.id


def _chargers(
    draft: Draft, barcodes: dict[str, Barcode], kind: VehicleKind, taken: set[str], report: Report
) -> tuple[ChargerSpec, ...]:
    if kind is not VehicleKind.AGV and not any(place.kind is StationKind.AGV_BUFFER for place in draft.places):
        for charge in draft.charges:
            report.left_out(charge.where, "hoists do not charge")
        return ()
    known = [charge for charge in draft.charges if charge.spot in barcodes]
    for charge in draft.charges:
        if charge.spot not in barcodes:
            report.wrong(charge.where, f"its mark {shown(charge.spot)} is nowhere given: left out")
    names = ids_of(((charge.name, charge.where) for charge in known), taken, "CHARGER", report)
    found = {barcodes[charge.spot]: names[charge.name] for charge in reversed(known)}
    if found:
        what = f"AGVs charge after {CHARGE_AFTER.trips} trips or an hour: layouts do not say when"
        report.assumed("", what, "say when under charging")
    return tuple(ChargerSpec(DeviceId(name), barcode) for barcode, name in reversed(found.items()))


def _zones(draft: Draft, barcodes: dict[str, Barcode], report: Report) -> Iterable[Zone]:
    names = ids_of(((area.name, area.where) for area in draft.areas.values()), set(), "ZONE", report, titled=True)
    for area in draft.areas.values():
        inside = frozenset(barcodes[spot] for spot in area.spots if spot in barcodes)
        unknown = [spot for spot in area.spots if spot not in barcodes]
        if unknown:
            report.wrong(area.where, f"{shown(unknown[0])} in it is nowhere given", "correct or leave it out")
        if not inside:
            report.left_out(area.where, "a zone without marks")
            continue
        yield Zone(ZoneId(names[area.name]), inside, max(1, area.capacity), area.no_stop, area.name)
