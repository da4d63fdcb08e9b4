"""From the file's structs to a plant: names resolved, edges measured, every wrong reference noted."""

from collections.abc import Iterable
from itertools import count, pairwise
from math import hypot

from app.domain.devices import AliasName, DeviceId
from app.domain.ids import CarrierId, StationId, VehicleId, ZoneId
from app.domain.layout import Edge, IdleRules, Meter, Plant, Point, Station, StationKind, Zone
from app.domain.units import Barcode, Millimetres, Percent, Seconds
from app.plant import format as file_format
from app.plant.dialects import check_overlays
from app.plant.document import Document, Path
from app.plant.equipment import Links, buffers, chargers, charging, doors, drives
from app.plant.names import DISPLAY_BYTES, address, expand, is_barcode, is_range
from app.plant.references import Places, check_event, check_id, check_station, is_known, pulses
from app.plant.vehicles import vehicles
from app.wire.names import nearest

_STRAIGHT_TOLERANCE = (0.9, 1.1)
_CURVE_TOLERANCE = (0.9, 1.6)
"""Length of an edge divided by the distance of its ends; a half circle has 1.57. Our choice."""


def build(document: Document, file: file_format.PlantFile, name: str) -> tuple[Plant, Places]:
    """Return the plant that the file describes, as far as it does, and where its parts stand in it."""
    places = Places()
    positions = _positions(document, file, places)
    edges = _edges(document, file, places, positions)
    parking = set(_marks(document, places, file.parking, ("parking",)))
    dialects = check_overlays(document, file.dialects)
    for event in file.event_numbers:
        check_event(document, event, ("event_numbers", event))
    links = Links(document, file)
    plant = Plant(
        name=file.name or name,
        points=tuple(
            Point(Barcode(b), Millimetres(x), Millimetres(y), b in parking) for b, (x, y) in positions.items()
        ),
        edges=edges,
        stations=tuple(_stations(document, file, places)),
        vehicles=tuple(vehicles(document, file, places, dialects, links)),
        zones=tuple(_zones(document, file, places)),
        carriers=tuple(_carriers(document, file)),
        clearance=Millimetres(file.clearance),
        listen=_listen(document, file),
        process_codes=_codes(document, file.process_codes, "process_codes"),
        alarm_codes=_codes(document, file.alarm_codes, "alarm_codes"),
        event_numbers=dict(file.event_numbers),
        dialects=dialects,
        links=tuple(links.all.values()),
        doors=tuple(doors(document, file, places, links)),
        buffers=tuple(buffers(document, file, links)),
        chargers=tuple(chargers(document, file, places)),
        charging=charging(document, file),
        restrain=file.traffic.restrain,
        congestion=file.traffic.congestion if isinstance(file.traffic.congestion, bool) else None,
        idle=IdleRules(file.idle.park, Seconds(file.idle.after), Seconds(file.idle.farthest)),
        overdue=Seconds(file.jobs.overdue),
        drives=tuple(drives(document, file, links)),
        reference_vehicles=frozenset(VehicleId(v) for v, given in file.vehicles.items() if given.reference),
    )
    return plant, places


def _positions(document: Document, file: file_format.PlantFile, places: Places) -> dict[str, tuple[int, int]]:
    found: dict[str, tuple[int, int]] = {}
    for key in document.section("barcodes"):
        path = ("barcodes", key)
        names = _barcode_names(document, key, path)
        placed = file.barcodes.get(key)
        if placed is None or not names:
            places.doubtful.update(names or (key,))
            continue
        for name, position in zip(names, _spread(document, placed, names, path), strict=True):
            if name in found:
                first = document.place(places.barcodes[name], key=True)[0]
                document.error(
                    path, f"barcode {name} is given twice: the first time on line {first}", "keep one", key=True
                )
                continue
            found[name] = position
            places.barcodes[name] = path
    return found


def _barcode_names(document: Document, key: str, path: Path) -> tuple[str, ...]:
    if is_range(key):
        try:
            return expand(key)
        except ValueError as wrong:
            document.error(path, str(wrong), key=True)
            return ()
    if not is_barcode(key):
        document.error(path, f"barcode {key!r} is not 1 to 16 visible ASCII characters", key=True)
        return ()
    return (key,)


def _spread(
    document: Document, placed: tuple[int, int] | file_format.Straight, names: tuple[str, ...], path: Path
) -> list[tuple[int, int]]:
    if not isinstance(placed, file_format.Straight):
        if len(names) > 1:
            document.error(path, f"{path[-1]} is a range, so it needs two ends", "write {from: [x, y], to: [x, y]}")
        return [placed] * len(names)
    if len(names) == 1:
        document.error(
            path, f"{names[0]} is one barcode, so it has one position", "write [x, y], or a range as the key"
        )
        return [placed.start]
    (x, y), (to_x, to_y), last = placed.start, placed.end, len(names) - 1
    return [(round(x + (to_x - x) * i / last), round(y + (to_y - y) * i / last)) for i in range(len(names))]


def _marks(document: Document, places: Places, marks: Iterable[int | str], path: Path) -> list[Barcode]:
    """Return the barcodes of a list with ranges expanded; unknown ones are noted and left out."""
    return [
        Barcode(name)
        for position, mark in enumerate(marks)
        for name in _expanded(document, str(mark), (*path, position))
        if is_known(document, places, name, (*path, position))
    ]


def _expanded(document: Document, text: str, path: Path) -> tuple[str, ...]:
    if not is_range(text):
        return (text,)
    try:
        return expand(text)
    except ValueError as wrong:
        document.error(path, str(wrong))
        return ()


def _edges(
    document: Document, file: file_format.PlantFile, places: Places, positions: dict[str, tuple[int, int]]
) -> tuple[Edge, ...]:
    edges = []
    kept = (position for position in count() if ("track", position) not in document.dropped)
    for run, position in zip(file.track, kept, strict=False):
        path: Path = ("track", position, "through")
        marks = _marks(document, places, run.through, path)
        if len(marks) == 1 and len(run.through) == 1:
            document.error(path, f"track through {marks[0]} alone leads nowhere", "name at least two barcodes")
        for start, end in pairwise(marks):
            edge = _edge(document, places, run, (start, end), positions, ("track", position))
            if edge is not None:
                edges.append(edge)
    return tuple(edges)


def _edge(
    document: Document,
    places: Places,
    run: file_format.Run,
    ends: tuple[Barcode, Barcode],
    positions: dict[str, tuple[int, int]],
    path: Path,
) -> Edge | None:
    start, end = ends
    if start == end:
        document.error((*path, "through"), f"track leads from {start} to itself", "name it once")
        return None
    if ends in places.edges:
        first = document.place(places.edges[ends])[0]
        document.error((*path, "through"), f"track {start} → {end} is given twice: the first time on line {first}")
        return None
    places.edges[ends] = path
    (x, y), (to_x, to_y) = positions[start], positions[end]
    distance = hypot(to_x - x, to_y - y)
    length = run.length if isinstance(run.length, int) else round(distance)
    if length == 0:
        document.error((*path, "through"), f"track {start} → {end} has length 0: both lie at [{x}, {y}]", "move one")
        return None
    low, high = _CURVE_TOLERANCE if run.curve else _STRAIGHT_TOLERANCE
    if not low * distance - 1 <= length <= high * distance + 1:
        document.warn(
            (*path, "length"),
            f"track {start} → {end} is {length} mm long, but its ends are {distance:.0f} mm apart",
            "correct the length or the positions" if run.curve else "correct it, or mark it with curve: true",
        )
    return Edge(start, end, Millimetres(length), Percent(run.speed), run.sensor, run.curve)


def _stations(document: Document, file: file_format.PlantFile, places: Places) -> Iterable[Station]:
    for name, station in file.stations.items():
        path = ("stations", name)
        display = station.display or name
        check_id(document, name, path)
        if len(display) > DISPLAY_BYTES or not display.isascii() or not display.isprintable():
            document.error(
                (*path, "display"),
                f"{display!r} does not fit the vehicle's display: {DISPLAY_BYTES} ASCII characters",
                "give a shorter name with display:",
            )
        for position, fallback in enumerate(station.fallbacks):
            check_station(document, fallback, (*path, "fallbacks", position))
            if fallback == name:
                document.error((*path, "fallbacks", position), f"{name} cannot be its own fallback", "name another")
        dest = pulses(station.dest) if isinstance(station.dest, file_format.Pulses) else None
        if dest is not None and station.kind is not StationKind.PORT:
            message = f"{name} is no port: a vehicle knows its positions there, so dest is not used"
            document.warn((*path, "dest"), message, "leave it out", key=True)
        _check_buffer(document, file, name, station)
        if is_known(document, places, str(station.at), (*path, "at")):
            yield Station(
                id=StationId(name),
                kind=station.kind,
                barcode=Barcode(str(station.at)),
                look_down=station.look_down,
                speed=Percent(station.speed),
                dest=dest,
                display=display,
                fallbacks=tuple(StationId(fallback) for fallback in station.fallbacks),
                buffer=DeviceId(station.buffer) if isinstance(station.buffer, str) else None,
                alias=AliasName(station.alias) if isinstance(station.alias, str) else None,
            )


def _check_buffer(document: Document, file: file_format.PlantFile, name: str, station: file_format.Station) -> None:
    path: Path = ("stations", name, "buffer")
    if not isinstance(station.buffer, str):
        return
    if station.buffer not in document.section("buffers"):
        close = nearest(station.buffer, file.buffers)
        remedy = f"did you mean {close}?" if close else "give it under buffers"
        document.error(path, f"unknown buffer {station.buffer}", remedy)
    first = next(other for other, given in file.stations.items() if given.buffer == station.buffer)
    if first != name:
        document.error(path, f"{name} has the same buffer as {first}: {station.buffer}", "each needs its own")


def _zones(document: Document, file: file_format.PlantFile, places: Places) -> Iterable[Zone]:
    for name, zone in file.zones.items():
        check_id(document, name, ("zones", name))
        marks = _marks(document, places, zone.barcodes, ("zones", name, "barcodes"))
        if zone.soft and zone.no_stop:
            document.error(("zones", name), f"zone {name} is soft and no_stop", "leave out one of them", key=True)
        if not zone.soft and (zone.share, zone.patience) != (file_format.SHARE, file_format.PATIENCE):
            message = f"zone {name} has a share or a patience, and is not soft: they count for nothing"
            document.warn(("zones", name), message, "add soft: true", key=True)
        meter = Meter(zone.share, Seconds(zone.patience)) if zone.soft else None
        yield Zone(ZoneId(name), frozenset(marks), zone.capacity, zone.no_stop, zone.name or name, meter)


def _carriers(document: Document, file: file_format.PlantFile) -> Iterable[tuple[CarrierId, StationId]]:
    taken: dict[str, str] = {}
    for name, station in file.carriers.items():
        path = ("carriers", name)
        check_id(document, name, path)
        if len(name) > DISPLAY_BYTES:
            message = f"carrier {name} does not fit the vehicle's display: {DISPLAY_BYTES} characters"
            document.error(path, message, key=True)
        check_station(document, station, path)
        if station in taken:
            document.error(path, f"{station} holds {taken[station]} already: one carrier a station", "choose another")
            continue
        taken[station] = name
        yield CarrierId(name), StationId(station)


def _listen(document: Document, file: file_format.PlantFile) -> tuple[str, int] | None:
    if not file.listen:
        return None
    try:
        host, port = address(file.listen)
    except ValueError as wrong:
        document.error(("listen",), str(wrong))
        return None
    if not port:
        document.error(("listen",), f"{file.listen} has no port", "write HOST:PORT")
    return host, port


def _codes(document: Document, named: dict[str, str], section: str) -> dict[int, str]:
    found: dict[int, str] = {}
    for key, text in named.items():
        try:
            code = int(key, 16 if key.startswith("0x") else 10)
        except ValueError:
            code = -1
        if not 0 <= code <= 0xFFFF:
            document.error((section, key), f"{key!r} is no code from 0 to 65535 (0xFFFF)", key=True)
        elif code in found:
            document.error((section, key), f"code {key} is given twice", "keep one", key=True)
        found[code] = text
    return found
