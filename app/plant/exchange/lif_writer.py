"""A plant as a LIF file that keeps to the letter of version 1.0 (VDMA): metres, y upwards, one layout."""

import json
from collections import defaultdict
from typing import Any

from app.domain.layout import Plant, VehicleKind
from app.domain.units import Barcode
from app.plant.connections import agv_floor, graph_of
from app.plant.exchange import losses
from app.plant.exchange.lif import MM, VERSION
from app.plant.exchange.report import counted

LEAST_SPEED = 0.001
"""m/s; LIF has no lower limit but 0, which would mean no speed."""


def write_lif(plant: Plant, timestamp: str) -> tuple[str, list[str]]:
    """Return the file's text, and what it cannot carry. ``timestamp``: ISO 8601 in UTC, as the file is to have it."""
    kinds = _kinds(plant)
    layout = {
        "layoutId": plant.name,
        "layoutName": plant.name,
        "layoutVersion": "1",
        "nodes": _nodes(plant, kinds),
        "edges": _edges(plant, kinds),
        "stations": _stations(plant),
    }
    meta = {
        "projectIdentification": plant.name,
        "creator": "Hoistway",
        "exportTimestamp": timestamp,
        "lifVersion": VERSION,
    }
    text = json.dumps({"metaInformation": meta, "layouts": [layout]}, indent=1, ensure_ascii=False)
    return text + "\n", _lost(plant)


def _kinds(plant: Plant) -> dict[Barcode, str]:
    floor = agv_floor(plant, graph_of(plant))
    return {p.barcode: (VehicleKind.AGV if p.barcode in floor else VehicleKind.HOIST).value for p in plant.points}


def _action(what: str) -> dict[str, str]:
    return {"actionType": what, "requirementType": "CONDITIONAL", "blockingType": "HARD"}


def _nodes(plant: Plant, kinds: dict[Barcode, str]) -> list[dict[str, Any]]:
    actions: defaultdict[Barcode, list[dict[str, str]]] = defaultdict(list)
    for barcode in dict.fromkeys(station.barcode for station in plant.stations):
        actions[barcode] += [_action("pick"), _action("drop")]
    for charger in plant.chargers:
        actions[charger.barcode] += [_action("startCharging"), _action("stopCharging")]
    return [
        {
            "nodeId": point.barcode,
            "mapId": plant.name,
            "nodePosition": {"x": point.x / MM, "y": -point.y / MM + 0.0},
            "vehicleTypeNodeProperties": [
                {"vehicleTypeId": kinds[point.barcode]}
                | ({"actions": actions[point.barcode]} if point.barcode in actions else {})
            ],
        }
        for point in plant.points
    ]


def _edges(plant: Plant, kinds: dict[Barcode, str]) -> list[dict[str, Any]]:
    top = {vehicle.kind.value: vehicle.max_speed for vehicle in reversed(plant.vehicles)}
    found = []
    for edge in plant.edges:
        kind = kinds[edge.start]
        properties: dict[str, Any] = {"vehicleTypeId": kind, "rotationAllowed": False}
        if kind in top:
            properties["maxSpeed"] = max(LEAST_SPEED, round(top[kind] * edge.speed / 100 / MM, 4))
        found.append(
            {
                "edgeId": f"{edge.start}-{edge.end}",
                "startNodeId": edge.start,
                "endNodeId": edge.end,
                "vehicleTypeEdgeProperties": [properties],
            }
        )
    return found


def _stations(plant: Plant) -> list[dict[str, Any]]:
    stations: list[dict[str, Any]] = [
        {
            "stationId": station.id,
            "interactionNodeIds": [station.barcode],
            "stationName": station.display or station.id,
            "stationDescription": station.kind.value,
        }
        for station in plant.stations
    ]
    names: set[str] = {station.id for station in plant.stations}
    return stations + [
        {"stationId": charger.id, "interactionNodeIds": [charger.barcode], "stationDescription": "charger"}
        for charger in plant.chargers
        if charger.id not in names
    ]


def _lost(plant: Plant) -> list[str]:
    curved, parked = losses.bent(plant), sum(point.park for point in plant.points)
    areas = sum(edge.sensor > 0 for edge in plant.edges)
    taught = sum(s.dest is not None or s.look_down > 0 or s.speed != 100 or bool(s.fallbacks) for s in plant.stations)
    speeds = [] if plant.vehicles else [counted(sum(e.speed != 100 for e in plant.edges), "speeds in percent")]
    lines = [
        f"{counted(curved, 'lengths')} other than the distance of their ends" if curved else "",
        f"{counted(sum(e.curve for e in plant.edges), 'marks')} of curves" if any(e.curve for e in plant.edges) else "",
        counted(parked, "parking places") if parked else "",
        f"obstacle-sensor areas of {counted(areas, 'edges')}" if areas else "",
        f"pulses, look-down, speed and fallbacks of {counted(taught, 'stations')}" if taught else "",
        "the plant's clearance" if plant.clearance else "",
        *(line for line in speeds if not line.startswith("0 ")),
    ]
    parts = losses.parts_lost(plant, ("zones", *losses.BEYOND))
    return [line for line in lines if line] + parts + losses.stations_lost(plant) + losses.rules_lost(plant)
