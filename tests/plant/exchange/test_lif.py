"""VDA LIF: read tolerantly, each repair said."""

import json
from math import pi
from typing import Any

import pytest

from app.domain.layout import VehicleKind
from app.plant.exchange.importing import Imported, Wishes
from app.plant.exchange.report import Kind, UnreadableLayout
from app.plant.exchange.settle import Options
from tests.plant.exchange.layouts import (
    HALL_EDGES,
    HALL_NODES,
    HALL_STATIONS,
    action,
    edge,
    imported,
    lif,
    node,
    said,
    samples,
)

SAMPLES = samples("lif")
PAIR = [edge("a", "b"), edge("b", "a")]


def hall(**more: Any) -> Imported:
    return imported(lif(HALL_NODES, HALL_EDGES, HALL_STATIONS, **more))


def test_a_hall_becomes_a_plant_of_tags_in_millimetres_with_y_downwards() -> None:
    made = hall()
    assert made.is_sound
    assert [(p.barcode, p.x, p.y) for p in made.plant.points] == [
        ("0001", 0, 0),
        ("0002", 5000, 0),
        ("0003", 10000, 0),
        ("0004", 10000, -5000),
        ("0005", 0, -5000),
    ]
    assert [(s.id, s.display, s.barcode) for s in made.plant.stations] == [
        ("S1", "Goods in", "0002"),
        ("S2", "Goods out", "0004"),
    ]
    assert [(c.id, c.barcode) for c in made.plant.chargers] == [("CHARGER-N5", "0005")]
    assert said(made, Kind.REPAIRED)[0].startswith(
        "layouts[0].nodes[4] (N5): vehicles charge at the node, and no station"
    )


def test_simulated_agvs_have_a_link_and_numbers() -> None:
    made = imported(lif(HALL_NODES, HALL_EDGES, HALL_STATIONS), wishes=Wishes(options=Options(vehicles=2)))
    assert made.is_sound
    assert [(v.kind, v.link, v.dev_id) for v in made.plant.vehicles] == [
        (VehicleKind.AGV, "hall", 11),
        (VehicleKind.AGV, "hall", 12),
    ]


def test_what_is_badly_written_is_read_as_it_was_meant_and_said() -> None:
    text = lif(
        [node("a", "0.5", 0), {"nodeId": 7, "x": 3, "y": 0, "vehicleTypeNodeProperties": []}],
        [edge("a", "7"), {"startNodeId": "7", "endnodeid": "a"}],
    )
    data = json.loads(text)
    del data["layouts"][0]["stations"]
    data["metaInformation"]["lifVersion"] = "0.11.0"
    made = imported(json.dumps(data))
    told = "\n".join(said(made, Kind.REPAIRED))
    assert [(p.x, p.y) for p in made.plant.points] == [(500, 0), (3000, 0)]
    assert len(made.plant.edges) == 2
    for repair in (
        "metaInformation: lifVersion is 0.11.0: read as 1.0.0",
        "layouts[0] (L1): there are no stations: taken as none",
        "layouts[0].nodes[0] (a): x is a text where a number is meant",
        "layouts[0].nodes[1] (7): nodeId is a number where a text is meant",
        "layouts[0].nodes[1] (7): x and y stand at the node itself",
        "layouts[0].edges[1]: endnodeid is read as endNodeId",
        "layouts[0].edges[1]: the edge has no edgeId",
    ):
        assert repair in told


def test_nodes_at_one_place_are_one_tag_and_turns_no_track() -> None:
    made = imported(
        lif(
            [node("a", 0, 0), node("b", 5, 0), node("turned", 5, 0)],
            [edge("a", "b"), edge("b", "turned"), edge("turned", "a")],
        )
    )
    assert [p.barcode for p in made.plant.points] == ["0001", "0002"]
    assert {(e.start, e.end) for e in made.plant.edges} == {("0001", "0002"), ("0002", "0001")}
    assert any("lies where another node lies" in note for note in said(made, Kind.REPAIRED))
    assert any("a turn, which vehicles make by themselves" in note for note in said(made, Kind.LEFT_OUT))


def test_a_trajectory_gives_the_length_of_its_curve() -> None:
    quarter = {
        "degree": 2,
        "knotVector": [0, 0, 0, 1, 1, 1],
        "controlPoints": [{"x": 0, "y": 0}, {"x": 10, "y": 0, "weight": 2**0.5 / 2}, {"x": 10, "y": 10}],
    }
    made = imported(lif([node("a", 0, 0), node("b", 10, 10)], [edge("a", "b", trajectory=quarter), edge("b", "a")]))
    there, back = made.plant.edges
    assert there.length == pytest.approx(10_000 * pi / 2, abs=3)
    assert (there.curve, back.curve, back.length) == (True, False, 14142)


def test_a_trajectory_that_is_no_curve_becomes_a_straight_line() -> None:
    bad = {"degree": 3, "knotVector": [0, 1], "controlPoints": [{"x": 0, "y": 0}, {"x": 5, "y": 0}]}
    made = imported(lif([node("a", 0, 0), node("b", 5, 0)], [edge("a", "b", trajectory=bad), edge("b", "a")]))
    assert made.plant.edges[0].length == 5000
    assert any("the trajectory is no curve" in note for note in said(made, Kind.REPAIRED))


def test_speeds_are_percent_of_the_fastest() -> None:
    edges = [edge("a", "b", maxSpeed=1.5), edge("b", "a", maxSpeed=0.5)]
    made = imported(lif([node("a", 0, 0), node("b", 5, 0)], edges), wishes=Wishes(options=Options(vehicles=1)))
    assert [e.speed for e in made.plant.edges] == [100, 33]
    assert made.plant.vehicles[0].max_speed == 1500


def test_what_a_plant_cannot_carry_is_said() -> None:
    edges = [
        edge("a", "b", loadRestriction={"loaded": False, "unloaded": True}, actions=[action("beep")]),
        edge("b", "a"),
    ]
    station = {"stationId": "S", "interactionNodeIds": ["a", "b"], "stationHeight": 2.5}
    made = imported(lif([node("a", 0, 0), node("b", 5, 0, actions=[action("weigh")])], edges, [station]))
    told = "\n".join(said(made, Kind.LEFT_OUT))
    for loss in (
        "track for unloaded vehicles only",
        "actions on track",
        "the height of stations",
        "action weigh",
        "kept is a",
    ):
        assert loss in told


def test_levels_are_drawn_side_by_side_and_lifts_left_out() -> None:
    data = json.loads(lif([node("a", 0, 0), node("b", 5, 0)], [*PAIR, edge("a", "up")], layoutLevelId="0"))
    above = {
        "layoutId": "L2",
        "layoutVersion": "1",
        "layoutLevelId": "1",
        "nodes": [node("up", 0, 0), node("off", 4, 0)],
    }
    data["layouts"].append({**above, "edges": [edge("up", "off"), edge("off", "up")], "stations": []})
    made = imported(json.dumps(data))
    assert [p.x for p in made.plant.points] == [0, 5000, 10000, 14000]
    assert any("an edge from level to level" in note for note in said(made, Kind.LEFT_OUT))
    alone = imported(json.dumps(data), wishes=Wishes(layout="L2"))
    assert [p.x for p in alone.plant.points] == [0, 4000]
    with pytest.raises(UnreadableLayout, match="there is no layout 'L3' in it"):
        imported(json.dumps(data), wishes=Wishes(layout="L3"))


def test_one_vehicle_types_track_can_be_chosen() -> None:
    other = edge("b", "a")
    other["vehicleTypeEdgeProperties"][0]["vehicleTypeId"] = "forklift"
    text = lif([node("a", 0, 0), node("b", 5, 0)], [*PAIR, {**other, "edgeId": "x"}])
    assert len(imported(text, wishes=Wishes(vehicle_type="tugger")).plant.edges) == 2
    made = imported(text, wishes=Wishes(vehicle_type="crane"))
    assert any("no vehicle type crane is named: forklift, tugger" in note for note in said(made, Kind.WRONG))


def test_what_leads_nowhere_is_said() -> None:
    station = {"stationId": "S", "interactionNodeIds": ["zz"]}
    made = imported(lif([node("a", 0, 0), node("b", 5, 0)], [*PAIR, edge("a", "zz")], [station]))
    assert not made.is_sound
    told = "\n".join(said(made, Kind.WRONG))
    assert "layouts[0].edges[2] (a-zz): leads to zz, which is nowhere given" in told
    assert "layouts[0].stations[0] (S): node zz of it is nowhere given" in told
    assert len(made.plant.edges) == 2


def test_a_position_that_is_no_number_is_said() -> None:
    made = imported(lif([node("a", 0, 0), node("b", 5, 0), node("c", float("nan"), 0)], PAIR))
    assert "layouts[0].nodes[2] (c) (nan): x: no number" in said(made, Kind.WRONG)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (lif(HALL_NODES, HALL_EDGES)[:300], "is no JSON: line 1, column"),
        ("[" * 100_000, "is nested too deep"),
        ('{"layouts": null}', "the file has no layouts"),
        ('{"type": "FeatureCollection", "features": []}', "GeoJSON is written, not read"),
        ("[1, 2]", "this JSON is no layout that is known"),
    ],
)
def test_what_is_no_lif_is_refused_in_a_sentence(text: str, message: str) -> None:
    with pytest.raises(UnreadableLayout, match=message):
        imported(text)


@pytest.mark.parametrize("values", [[1, []], ["x"], {"a": 1}, "x", 7])
@pytest.mark.parametrize("key", ["nodes", "edges", "stations"])
def test_no_strange_value_ends_an_import_without_a_sentence(key: str, values: object) -> None:
    data = json.loads(lif(HALL_NODES, HALL_EDGES, HALL_STATIONS))
    data["layouts"][0][key] = values
    if key == "nodes":
        with pytest.raises(UnreadableLayout, match="there is no mark with a position in it"):
            imported(json.dumps(data))
    else:
        assert said(imported(json.dumps(data)), Kind.WRONG)


@pytest.mark.skipif(not SAMPLES.is_dir(), reason="the samples of LIF are not there (../shared/data/lif)")
@pytest.mark.parametrize("number", ["01", "03", "05", "07", "09", "11", "13", "15", "17"])
def test_every_worked_example_of_the_specification_is_read(number: str) -> None:
    made = imported((SAMPLES / f"lif-example-{number}.json").read_bytes())
    assert made.plant.points
    assert said(made, Kind.WRONG) == []
    assert said(made, Kind.REPAIRED)
    # Example 1 is a lone one-way edge, 5 and 9 end in nodes that nothing leads on from: the checker must say so.
    dead = {finding.message.partition(":")[0] for finding in made.findings if finding.is_error}
    assert dead <= {"dead end"}
    assert bool(dead) == (number in {"01", "05", "09"})
