"""A plant as GeoJSON (RFC 7946) for maps and GIS tools."""

import json
from collections import defaultdict
from dataclasses import dataclass
from math import cos, pi, radians, sin
from typing import Any

from app.domain.layout import Plant, Station
from app.domain.units import Barcode
from app.plant.exchange import losses

EARTH = 6_371_008.8
"""Mean radius, m."""
MM = 1000.0


@dataclass(frozen=True, slots=True)
class Origin:
    """Where the plan's [0, 0] lies on earth, in degrees; ``bearing``: the compass direction of the plan's upward axis."""

    latitude: float
    longitude: float
    bearing: float = 0.0

    def placed(self, x: float, y: float) -> list[float]:
        """Return longitude and latitude of a place in metres, y upwards: exact enough for a site of 10 km."""
        turn = radians(self.bearing)
        east, north = x * cos(turn) + y * sin(turn), y * cos(turn) - x * sin(turn)
        latitude = self.latitude + north / EARTH * 180 / pi
        longitude = self.longitude + east / (EARTH * cos(radians(self.latitude))) * 180 / pi
        return [round(longitude, 9), round(latitude, 9)]


def write_geojson(plant: Plant, origin: Origin | None = None) -> tuple[str, list[str]]:
    """Return the file's text, and what it cannot carry; without an origin positions are metres on the plan, y upwards."""
    spots = {point.barcode: _spot(point.x, point.y, origin) for point in plant.points}
    features = [*_marks(plant, spots), *_track(plant, spots), *_zones(plant, spots)]
    told = {"type": "FeatureCollection", "name": plant.name, "features": features}
    parts = losses.parts_lost(plant, losses.BEYOND) + losses.stations_lost(plant) + losses.rules_lost(plant)
    where = [] if origin else ["where on earth the plant lies: positions are metres on the plan (give --origin)"]
    return json.dumps(told, ensure_ascii=False, separators=(",", ":")) + "\n", where + parts


def _spot(x: int, y: int, origin: Origin | None) -> list[float]:
    metres = x / MM, -y / MM + 0.0
    return origin.placed(*metres) if origin else list(metres)


def _feature(kind: str, spots: Any, properties: dict[str, Any]) -> dict[str, Any]:
    return {"type": "Feature", "geometry": {"type": kind, "coordinates": spots}, "properties": properties}


def _marks(plant: Plant, spots: dict[Barcode, list[float]]) -> list[dict[str, Any]]:
    stations: defaultdict[Barcode, list[Station]] = defaultdict(list)
    for station in plant.stations:
        stations[station.barcode].append(station)
    chargers = {charger.barcode: charger.id for charger in plant.chargers}
    found = []
    for point in plant.points:
        properties: dict[str, Any] = {"kind": "barcode", "barcode": point.barcode}
        properties |= {"parking": True} if point.park else {}
        if point.barcode in stations:
            properties["stations"] = [{"id": s.id, "kind": s.kind.value} for s in stations[point.barcode]]
        if point.barcode in chargers:
            properties["charger"] = chargers[point.barcode]
        found.append(_feature("Point", spots[point.barcode], properties))
    return found


def _track(plant: Plant, spots: dict[Barcode, list[float]]) -> list[dict[str, Any]]:
    return [
        _feature(
            "LineString",
            [spots[edge.start], spots[edge.end]],
            {
                "kind": "track",
                "from": edge.start,
                "to": edge.end,
                "length_mm": edge.length,
                "speed_percent": edge.speed,
                "sensor": edge.sensor,
                "curve": edge.curve,
            },
        )
        for edge in plant.edges
    ]


def _zones(plant: Plant, spots: dict[Barcode, list[float]]) -> list[dict[str, Any]]:
    return [
        _feature(
            "MultiPoint",
            [spots[barcode] for barcode in sorted(zone.barcodes)],
            {"kind": "zone", "zone": zone.id, "name": zone.name, "capacity": zone.capacity, "no_stop": zone.no_stop},
        )
        for zone in plant.zones
    ]
