"""A plant as a graph for other tools: networkx node-link JSON, and GraphML."""

import json
from typing import Any

import networkx as nx

from app.domain.layout import Plant, PulseSet, Station, VehicleKind, Zone
from app.domain.units import Barcode
from app.plant.connections import agv_floor, graph_of
from app.plant.exchange import losses
from app.plant.exchange.report import counted


def write_node_link(plant: Plant, key: str = "edges") -> tuple[str, list[str]]:
    """Return node-link JSON, and what it cannot carry. ``key``: ``edges``, or ``links`` as networkx before 3.4 has it."""
    told = nx.node_link_data(graph(plant), edges=key)
    return json.dumps(told, indent=1, ensure_ascii=False) + "\n", _lost(plant)


def write_graphml(plant: Plant) -> tuple[str, list[str]]:
    """Return GraphML, and what it cannot carry; what is a list or an object stands in it as JSON text."""
    drawn = graph(plant)
    for _, attributes in drawn.nodes(data=True):
        for name, value in attributes.items():
            if isinstance(value, list):
                attributes[name] = json.dumps(value, ensure_ascii=False)
    return "\n".join(nx.generate_graphml(drawn)) + "\n", _lost(plant)


def graph(plant: Plant) -> "nx.DiGraph[Barcode]":
    """Return the plant's track with everything that stands on it, positions and lengths in mm, y downwards."""
    kind = VehicleKind.AGV if len(agv_floor(plant, graph_of(plant))) * 2 > len(plant.points) else VehicleKind.HOIST
    found: nx.DiGraph[Barcode] = nx.DiGraph(
        name=plant.name, unit="mm", kind=kind.value, clearance=plant.clearance, y="down"
    )
    for point in plant.points:
        found.add_node(point.barcode, x=point.x, y=point.y)
        if point.park:
            found.nodes[point.barcode]["park"] = True
    for station in plant.stations:
        found.nodes[station.barcode].setdefault("stations", []).append(_station(station))
    for charger in plant.chargers:
        found.nodes[charger.barcode]["charger"] = charger.id
    for zone in plant.zones if all(zone.meter is None for zone in plant.zones) else _hard(plant):
        for barcode in sorted(zone.barcodes):
            found.nodes[barcode].setdefault("zones", []).append(_zone(zone))
    for edge in plant.edges:
        given = {"sensor": edge.sensor} if edge.sensor else {}
        found.add_edge(edge.start, edge.end, length=edge.length, speed=edge.speed, curve=edge.curve, **given)
    return found


def _hard(plant: Plant) -> list[Zone]:
    return [zone for zone in plant.zones if zone.meter is None]


def _station(station: Station) -> dict[str, Any]:
    given: dict[str, Any] = {"id": station.id, "kind": station.kind.value}
    more = {
        "display": station.display if station.display != station.id else "",
        "look_down": station.look_down,
        "speed": station.speed if station.speed != 100 else 0,
        "dest": _pulses(station.dest) if station.dest else None,
        "fallbacks": list(station.fallbacks),
    }
    return given | {name: value for name, value in more.items() if value}


def _pulses(pulses: PulseSet) -> dict[str, int]:
    return {"shft": pulses.shft, "rota": pulses.rota, "lift": pulses.lift}


def _zone(zone: Zone) -> dict[str, Any]:
    return {"id": zone.id, "capacity": zone.capacity} | ({"no_stop": True} if zone.no_stop else {})


def _lost(plant: Plant) -> list[str]:
    soft = sum(zone.meter is not None for zone in plant.zones)
    named = sum(zone.name not in ("", zone.id) for zone in plant.zones)
    lines = [counted(soft, "soft zones") if soft else "", f"names of {counted(named, 'zones')}" if named else ""]
    parts = losses.parts_lost(plant, losses.BEYOND)
    return [line for line in lines if line] + parts + losses.stations_lost(plant) + losses.rules_lost(plant)
