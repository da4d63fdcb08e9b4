"""What a format cannot carry of a plant, in sentences."""

from collections.abc import Iterable, Mapping
from math import hypot

from app.domain.layout import ChargingRules, IdleRules, Plant
from app.plant.exchange.report import counted

COUNTED = {
    "zones": "zones",
    "vehicles": "vehicles",
    "carriers": "carriers",
    "links": "links",
    "doors": "doors",
    "buffers": "buffers",
    "chargers": "chargers",
    "drives": "drives",
    "dialects": "dialects",
    "process_codes": "process codes",
    "alarm_codes": "alarm codes",
    "event_numbers": "event numbers",
}
BEYOND = ("vehicles", "carriers", "links", "doors", "buffers", "drives", "dialects")
CODES = ("process_codes", "alarm_codes", "event_numbers")


def parts_lost(plant: Plant, parts: Iterable[str]) -> list[str]:
    """Return a line for each of these parts that the plant has."""
    return [counted(len(getattr(plant, part)), COUNTED[part]) for part in parts if getattr(plant, part)]


def rules_lost(plant: Plant) -> list[str]:
    """Return a line for the rules that no layout format knows."""
    rules: Mapping[str, bool] = {
        "when AGVs charge": plant.charging != ChargingRules(),
        "how hoists share the track (traffic)": plant.restrain,
        "what idle hoists do (idle)": plant.idle != IdleRules(),
        "where vehicles connect to (listen)": plant.listen is not None,
        "names of alarm and process codes, event numbers": any(getattr(plant, part) for part in CODES),
    }
    return [what for what, has in rules.items() if has]


def stations_lost(plant: Plant) -> list[str]:
    """Return lines for what stations have that belongs to wires."""
    bound = sum(station.buffer is not None or station.alias is not None for station in plant.stations)
    return [f"buffer and alias of {counted(bound, 'stations')}"] if bound else []


def bent(plant: Plant) -> int:
    """Return how many edges are longer or shorter than the straight line between their ends."""
    places = {point.barcode: point for point in plant.points}
    lines = ((edge, places[edge.start], places[edge.end]) for edge in plant.edges)
    return sum(edge.length != round(hypot(b.x - a.x, b.y - a.y)) for edge, a, b in lines)
