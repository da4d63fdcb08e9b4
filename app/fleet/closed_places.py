"""From a place as people name it to the barcodes that are kept empty for it."""

import networkx as nx

from app.domain.closures import ClosedPlace, PlaceKind
from app.domain.errors import Refusal
from app.domain.ids import StationId
from app.domain.units import Barcode
from app.planning.track import Track

SEE = "see GET /api/v1/layout"


def resolved(track: Track, place: ClosedPlace) -> tuple[Barcode, ...] | Refusal:
    """Return the barcodes that nobody may come to; none for an edge or a station. Refusal: there is no such place.

    A stretch is the shortest way from its first barcode to its last, whatever is closed or crowded now (our choice).
    """
    match place.kind:
        case PlaceKind.ZONE:
            return _zone(track, place.names[0])
        case PlaceKind.STATION:
            known = track.plant.station(StationId(place.names[0]))
            return () if known else _none(f"station {place.names[0]}", "station", "see GET /api/v1/stations")
        case _:
            unknown = next((name for name in place.names if name not in track), None)
            return _none(f"barcode {unknown}", "place") if unknown is not None else _rail(track, place)


def _none(what: str, field: str, remedy: str = SEE) -> Refusal:
    return Refusal("invalid", f"there is no {what}", remedy, field)


def _zone(track: Track, name: str) -> tuple[Barcode, ...] | Refusal:
    zone = next((zone for zone in track.plant.zones if zone.id == name), None)
    if zone is None:
        known = ", ".join(zone.id for zone in track.plant.zones[:10]) or "none"
        return _none(f"zone {name}", "zone", f"the plant's zones are {known}")
    return tuple(barcode for barcode in track.barcodes if barcode in zone.barcodes)


def _rail(track: Track, place: ClosedPlace) -> tuple[Barcode, ...] | Refusal:
    names = tuple(Barcode(name) for name in place.names)
    if place.kind is PlaceKind.BARCODE:
        return tuple(dict.fromkeys(names))
    start, end = names
    if place.kind is PlaceKind.EDGE:
        if end in track.successors(start):
            return ()
        return Refusal("invalid", f"no edge leads from {start} to {end}", SEE, "to")
    try:
        return tuple(nx.shortest_path(track.graph, start, end, weight="length"))
    except nx.NetworkXNoPath:
        return Refusal("no-route", f"the track does not lead from {start} to {end}", SEE, "to")
