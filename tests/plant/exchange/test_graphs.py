"""Graphs: node-link JSON, old and new, and GraphML."""

import json
from typing import Any

import networkx as nx
import pytest

from app.plant.exchange.importing import Imported
from app.plant.exchange.report import Kind, UnreadableLayout
from app.texts import said as said_in
from tests.plant.exchange.layouts import imported, said


def ring() -> "nx.DiGraph[Any]":
    graph: nx.DiGraph[Any] = nx.DiGraph(name="ring")
    for i, (x, y) in enumerate([(0, 0), (4000, 0), (4000, 3000), (0, 3000)], 1):
        graph.add_node(i, pos=(x, y))
    nx.add_cycle(graph, [1, 2, 3, 4], speed=60)
    graph.nodes[2]["station"] = "P1"
    graph.edges[1, 2]["length"] = 4100
    return graph


def track(made: Imported) -> dict[tuple[str, str], tuple[int, int]]:
    return {(e.start, e.end): (e.length, e.speed) for e in made.plant.edges}


@pytest.mark.parametrize("key", ["links", "edges"])
def test_both_node_link_formats_of_networkx_are_read(key: str) -> None:
    made = imported(json.dumps(nx.node_link_data(ring(), edges=key)))
    assert made.is_sound
    assert made.plant.name == "ring"
    assert track(made) == {
        ("1", "2"): (4100, 60),
        ("2", "3"): (3000, 60),
        ("3", "4"): (4000, 60),
        ("4", "1"): (3000, 60),
    }
    assert [(s.id, s.barcode) for s in made.plant.stations] == [("P1", "2")]


def test_ends_by_position_in_the_list_are_repaired() -> None:
    nodes = [{"id": name, "x": x, "y": 0} for name, x in (("A", 0), ("B", 1000))]
    made = imported(json.dumps({"nodes": nodes, "links": [{"source": 0, "target": 1}, {"source": 1, "target": 0}]}))
    assert set(track(made)) == {("A", "B"), ("B", "A")}
    assert "ends of edges are positions in the list of nodes" in said(made, Kind.REPAIRED)[0]


def test_an_undirected_graph_is_two_way_track_and_that_is_said() -> None:
    graph: nx.Graph[Any] = nx.Graph()
    graph.add_node("A", x=0, y=0)
    graph.add_node("B", x=1000, y=0)
    graph.add_edge("A", "B", weight=1100)
    made = imported(json.dumps(nx.node_link_data(graph, edges="edges")))
    assert track(made) == {("A", "B"): (1100, 100), ("B", "A"): (1100, 100)}
    assert any("the graph is undirected" in note for note in said(made, Kind.ASSUMED))


def test_parallel_edges_become_one() -> None:
    graph: nx.MultiDiGraph[Any] = nx.MultiDiGraph()
    graph.add_node("A", x=0, y=0)
    graph.add_node("B", x=1000, y=0)
    graph.add_edges_from([("A", "B", {"length": 1000}), ("A", "B", {"length": 1300}), ("B", "A", {})])
    made = imported(json.dumps(nx.node_link_data(graph, edges="links")))
    assert track(made)["A", "B"] == (1000, 100)
    assert any("a second way between the same two marks" in note for note in said(made, Kind.LEFT_OUT))


def graphml(graph: "nx.Graph[Any]") -> str:
    return "\n".join(nx.generate_graphml(graph))


def test_graphml_of_networkx_is_read() -> None:
    graph = ring()
    for _, node in graph.nodes(data=True):
        node["x"], node["y"] = node.pop("pos")
    made = imported(graphml(graph))
    assert made.is_sound
    assert track(made)["1", "2"] == (4100, 60)
    assert [(s.id, s.barcode) for s in made.plant.stations] == [("P1", "2")]


def test_graphml_drawn_with_yed_has_its_places_from_the_drawing() -> None:
    box = '<data key="d0"><y:ShapeNode><y:Geometry height="30" width="30" x="{}" y="0"/></y:ShapeNode></data>'
    nodes = "".join(f'<node id="n{i}">{box.format(i * 1000)}</node>' for i in range(3))
    edges = "".join(f'<edge source="n{i}" target="n{(i + 1) % 3}"/>' for i in range(3))
    text = (
        '<graphml xmlns="http://graphml.graphdrawing.org/xmlns" xmlns:y="http://www.yworks.com/xml/graphml">'
        '<key for="node" id="d0" yfiles.type="nodegraphics"/>'
        f'<graph edgedefault="directed" id="G">{nodes}{edges}</graph></graphml>'
    )
    made = imported(text)
    assert [(p.x, p.y) for p in made.plant.points] == [(15, 15), (1015, 15), (2015, 15)]
    assert len(made.plant.edges) == 3


def test_what_is_wrong_is_said_with_its_place() -> None:
    nodes = [1, {"id": []}, {"id": "a"}, {"id": "b", "x": 0, "y": 0}, {"id": "c", "x": "1000", "y": 0, "colour": "red"}]
    links = [
        1,
        {"source": "b"},
        {"source": "b", "target": "c", "speed": "fast", "curve": "maybe"},
        {"source": "c", "target": "z"},
    ]
    made = imported(json.dumps({"nodes": nodes, "links": links}))
    told = "\n".join(said(made, Kind.WRONG))
    for wrong in (
        "nodes[0], nodes[1]: the node has no id",
        "nodes[2] (a): the node has no position",
        "links[0], links[1]: the edge has no source or no target",
        "links[2] b → c ('fast'): speed: no number",
        "links[2] b → c ('maybe'): curve: neither yes nor no: taken is no",
        "links[3] c → z: leads to z, which is nowhere given",
    ):
        assert wrong in told
    assert said(made, Kind.LEFT_OUT) == ["colour: attributes that are not understood"]


def test_a_key_that_stands_twice_in_an_object_is_said_with_its_place() -> None:
    text = '{"nodes":[{"id":1,"x":0,"x":500,"y":0},{"id":2,"x":1000,"y":0}],'
    text += '"links":[{"source":1,"target":2},{"source":2,"target":1,"length":500,"length":500}]}'
    made = imported(text)
    assert [point.x for point in made.plant.points] == [500, 1000]
    assert said(made, Kind.WRONG) == [
        "nodes[0]: x is given twice in it: the last one counts",
        "links[1]: length is given twice in it: the last one counts",
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('{"nodes":[{"id":1 "x":0}]}', "line 1, column 19: a comma is expected here, or the end of the list or object"),
        ("{'nodes':[]}", "line 1, column 2: a name in double quotes is expected here"),
        ('{"nodes"\n[]}', "line 2, column 1: a colon is expected here, between name and value"),
        ('{"nodes":[1,]}', "a value is expected here"),
        ('{"nodes":[]} x', "the JSON has ended before this"),
        ('{"nodes":["a', "the text that begins here has no closing quotation mark"),
        ('{"nodes":["a\\q"]}', "this is no escape: a backslash itself is written twice"),
        ('{"nodes":["\\u12"]}', "four hexadecimal digits belong behind this"),
        ('{"nodes":["a\nb"]}', "a line break or control character stands within a text"),
        (f'{{"nodes":[{"9" * 5000}]}}', "it has a number of thousands of digits"),
        ('{"nodes":["\xff"]}'.encode("latin-1"), "is not UTF-8: byte 11 fits no letter"),
    ],
)
def test_json_that_is_broken_says_where_and_what_is_wanted(text: str | bytes, expected: str) -> None:
    with pytest.raises(UnreadableLayout) as refused:
        imported(text)
    assert expected in refused.value.message
    assert expected.rpartition(": ")[2] not in said_in(refused.value.message, "ko")


def test_json_in_wide_letters_is_read() -> None:
    text = '{"nodes":[{"id":1,"x":0,"y":0},{"id":2,"x":1000,"y":0}],"links":[{"source":1,"target":2},{"source":2,"target":1}]}'
    for encoding in ("utf-16", "utf-32", "utf-32-be", "utf-8-sig"):
        assert imported(text.encode(encoding)).is_sound


def test_what_steers_a_terminal_is_not_shown() -> None:
    evil = "\x1b[31mevil\n"
    nodes = [{"id": evil, "x": 0, "y": 0}, {"id": "b", "x": 1000, "y": 0}]
    made = imported(
        json.dumps({"nodes": nodes, "links": [{"source": evil, "target": "b"}, {"source": "b", "target": evil}]})
    )
    assert made.is_sound
    assert all(note.isprintable() for kind in Kind for note in said(made, kind))
    assert "\x1b" not in made.text


def test_a_graph_with_neither_links_nor_edges_says_so() -> None:
    made = imported('{"nodes": [{"id": 1, "x": 0, "y": 0}]}')
    assert "the graph has neither links nor edges" in said(made, Kind.WRONG)
    with pytest.raises(UnreadableLayout, match="it has no graph"):
        imported("<graphml/>")
