"""Export: strict, and back again with nothing lost but what is said."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import networkx as nx
import pytest

from app.domain.layout import Plant, Point
from app.domain.units import Barcode, Millimetres
from app.plant import read
from app.plant.exchange.geojson_writer import Origin, write_geojson
from app.plant.exchange.graph_writers import write_graphml, write_node_link
from app.plant.exchange.lif_writer import write_lif
from tests.plant.exchange.layouts import imported, samples

PLANTS = Path(__file__).parents[3] / "plants"
SCHEMA = samples("lif") / "LIF.schema.json"
NAMES = ["small", "hall", "demo"]
NOW = "2026-01-01T00:00:00.00Z"


def plant(name: str) -> Plant:
    found, _ = read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)
    return found


def carried(given: Plant) -> Plant:
    """Return what a graph can carry of a plant."""
    return Plant(
        name=given.name,
        points=given.points,
        edges=tuple(sorted(given.edges, key=lambda edge: (edge.start, edge.end))),
        stations=tuple(
            replace(s, buffer=None, alias=None) for s in sorted(given.stations, key=lambda station: station.id)
        ),
        vehicles=(),
        zones=tuple(sorted((replace(z, name=z.id) for z in given.zones), key=lambda zone: zone.id)),
        clearance=given.clearance,
        chargers=tuple(replace(charger, alias=None) for charger in given.chargers),
    )


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("form", ["edges", "links", "graphml"])
def test_a_graph_carries_track_stations_zones_and_chargers_there_and_back(name: str, form: str) -> None:
    given = plant(name)
    text, _ = write_graphml(given) if form == "graphml" else write_node_link(given, form)
    back = imported(text)
    assert back.report.is_sound
    assert carried(replace(back.plant, charging=given.charging)) == carried(given)


def test_node_link_is_read_by_networkx_itself() -> None:
    text, _ = write_node_link(plant("small"))
    graph: nx.Graph[Any] = nx.node_link_graph(json.loads(text), edges="edges")
    assert nx.is_strongly_connected(nx.DiGraph(graph))
    assert graph.nodes["104"]["stations"][0]["id"] == "P1"


def test_what_a_graph_loses_is_said() -> None:
    _, lost = write_node_link(plant("hall"))
    assert lost == [
        "2 vehicles",
        "2 carriers",
        "2 links",
        "1 door",
        "2 buffers",
        "1 drive",
        "buffer and alias of 3 stations",
        "when AGVs charge",
    ]


@pytest.mark.skipif(not SCHEMA.is_file(), reason="the schema of LIF is not there (../shared/data/lif)")
@pytest.mark.parametrize("name", NAMES)
def test_a_lif_file_keeps_to_the_schema(name: str) -> None:
    text, _ = write_lif(plant(name), NOW)
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft7Validator(schema).validate(json.loads(text))


@pytest.mark.parametrize("name", NAMES)
def test_a_lif_file_has_all_that_the_specification_asks_for(name: str) -> None:
    told = json.loads(write_lif(plant(name), NOW)[0])
    (layout,) = told["layouts"]
    nodes = {node["nodeId"] for node in layout["nodes"]}
    assert set(told["metaInformation"]) == {"projectIdentification", "creator", "exportTimestamp", "lifVersion"}
    assert len(nodes) == len(layout["nodes"]) == len(plant(name).points)
    assert len({edge["edgeId"] for edge in layout["edges"]}) == len(plant(name).edges)
    assert all({edge["startNodeId"], edge["endNodeId"]} <= nodes for edge in layout["edges"])
    assert all(
        station["interactionNodeIds"] and set(station["interactionNodeIds"]) <= nodes for station in layout["stations"]
    )
    assert all(item["vehicleTypeNodeProperties"] for item in layout["nodes"])
    assert all(item["vehicleTypeEdgeProperties"] for item in layout["edges"])


@pytest.mark.parametrize("name", ["small", "hall"])
def test_lif_carries_marks_track_and_stations_there_and_back(name: str) -> None:
    given = plant(name)
    text, lost = write_lif(given, NOW)
    back = imported(text)
    assert back.report.is_sound
    assert [(p.barcode, p.x, p.y) for p in back.plant.points] == [(p.barcode, p.x, p.y) for p in given.points]
    assert {(e.start, e.end, e.speed) for e in back.plant.edges} == {(e.start, e.end, e.speed) for e in given.edges}
    stations = {(s.id, s.kind, s.barcode, s.display) for s in given.stations}
    assert {(s.id, s.kind, s.barcode, s.display) for s in back.plant.stations} == stations
    assert {(c.id, c.barcode) for c in back.plant.chargers} == {(c.id, c.barcode) for c in given.chargers}
    assert any(line.endswith("parking places") for line in lost)


def test_what_lif_loses_is_said() -> None:
    _, lost = write_lif(plant("small"), NOW)
    assert lost[:5] == [
        "4 lengths other than the distance of their ends",
        "4 marks of curves",
        "3 parking places",
        "obstacle-sensor areas of 18 edges",
        "pulses, look-down, speed and fallbacks of 4 stations",
    ]
    assert "1 zone" in lost


def test_geojson_has_metres_upwards_or_degrees_on_earth() -> None:
    told = json.loads(write_geojson(plant("small"))[0])
    marks = {f["properties"]["barcode"]: f for f in told["features"] if f["properties"]["kind"] == "barcode"}
    assert marks["110"]["geometry"] == {"type": "Point", "coordinates": [10.0, -1.0]}
    assert marks["104"]["properties"]["stations"] == [{"id": "P1", "kind": "port"}]
    tracks = [f for f in told["features"] if f["properties"]["kind"] == "track"]
    assert len(tracks) == 18
    assert all(f["geometry"]["type"] == "LineString" for f in tracks)


def test_geojson_on_earth_lies_where_the_bearing_says() -> None:
    north, east = Origin(37.0, 127.0).placed(0.0, 1113.0), Origin(37.0, 127.0, 90.0).placed(0.0, 1113.0)
    assert north[0] == 127.0
    assert north[1] == pytest.approx(37.01, abs=1e-4)
    assert east[1] == pytest.approx(37.0, abs=1e-6)
    assert east[0] == pytest.approx(127.0 + 0.01 / 0.7986, abs=1e-4)
    lost = write_geojson(plant("small"), Origin(37.0, 127.0))[1]
    assert not any("where on earth" in line for line in lost)


def test_a_layout_without_track_is_written_too() -> None:
    bare = Plant("bare", (Point(Barcode("1"), Millimetres(0), Millimetres(0)),), (), (), ())
    for text, _ in (write_lif(bare, NOW), write_geojson(bare), write_graphml(bare), write_node_link(bare)):
        assert text.endswith("\n")
