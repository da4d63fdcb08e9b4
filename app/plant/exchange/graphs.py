"""Graphs as networkx writes them: node-link JSON (``links`` or ``edges``) and GraphML, that of yEd included."""

import json
from collections.abc import Iterable, Mapping
from typing import Any

from app.domain.layout import PulseSet, StationKind, VehicleKind
from app.domain.units import Pulses
from app.plant.exchange.columns import CHARGER_WORDS, FALSE, KIND_OF, PARK_WORDS, ROLES, TRUE, fold
from app.plant.exchange.draft import Area, Charge, Draft, Place, Spot, Way
from app.plant.exchange.numbers import WANTED, number
from app.plant.exchange.report import Report, UnreadableLayout, shown
from app.plant.exchange.units import Reading, scale, settle_speeds
from app.plant.exchange.xml_text import Element, child, children, local
from app.plant.format import MAX_LENGTH

_IDENTITY = frozenset({"id", "source", "target", "key", "name", "label", "title", "role"})
_OURS = frozenset({"stations", "zones", "pos", "position", "park", "charger"})
_WORDS = {"stations": "station", "pos": "pos", "position": "pos", "weight": "length", "parking": "park"}


def draft_of_json(data: Any, reading: Reading, report: Report) -> Draft:
    """Return the layout of a node-link file. Raises: UnreadableLayout: it is none."""
    if not isinstance(data, dict) or not isinstance(data.get("nodes"), list):
        raise UnreadableLayout(
            "this JSON is no node-link graph", remedy="it is an object with nodes, and links or edges"
        )
    key = next((name for name in ("links", "edges") if isinstance(data.get(name), list)), None)
    if key is None:
        report.wrong("", "the graph has neither links nor edges", "write it with networkx's node_link_data")
    nodes = [(f"nodes[{i}]", node) for i, node in enumerate(data["nodes"])]
    edges = [(f"{key}[{i}]", edge) for i, edge in enumerate(data.get(key or "", []))]
    about = data.get("graph")
    about = dict(about) if isinstance(about, dict) else {}
    report.source = f"node-link JSON ({key or 'no edges'}), {shown(about.get('name') or 'unnamed')}"
    builder = _Builder(about, report, directed=data.get("directed", True) is not False)
    builder.nodes(nodes)
    builder.edges(_by_index(nodes, edges, report))
    return builder.finished(reading)


def _by_index(nodes: list[tuple[str, Any]], edges: list[tuple[str, Any]], report: Report) -> Iterable[tuple[str, Any]]:
    """Give the edges with names for ends; networkx 1 and d3 wrote the nodes' positions in the list."""
    names = [node.get("id") for _, node in nodes if isinstance(node, dict)]
    ends = [e.get(end) for _, e in edges if isinstance(e, dict) for end in ("source", "target")]
    known = {str(name) for name in names}
    by_index = bool(ends) and all(type(end) is int and 0 <= end < len(names) for end in ends)
    if not by_index or all(str(end) in known for end in ends):
        return edges
    report.repaired("", "ends of edges are positions in the list of nodes, as networkx 1 and d3 wrote them")
    return [
        (where, {**e, "source": names[e["source"]], "target": names[e["target"]]} if isinstance(e, dict) else e)
        for where, e in edges
    ]


def draft_of_graphml(root: Element, reading: Reading, report: Report) -> Draft:
    """Return the layout of a GraphML file. Raises: UnreadableLayout: it is none."""
    graph = child(root, "graph") if local(root) == "graphml" else None
    if graph is None:
        raise UnreadableLayout("this XML is no GraphML: it has no graph")
    keys = {key.get("id", ""): key for key in children(root, "key")}
    about = _data(graph, keys)
    report.source = f"GraphML, {shown(about.get('name') or graph.get('id') or 'unnamed')}"
    builder = _Builder(about, report, directed=graph.get("edgedefault", "directed") != "undirected")
    nodes = [(f"node {shown(n.get('id', ''))} (line {n.sourceline})", n) for n in graph.iter() if local(n) == "node"]
    edges = [(f"edge (line {e.sourceline})", e) for e in graph.iter() if local(e) == "edge"]
    builder.nodes((where, {**_drawn(node), **_data(node, keys), "id": node.get("id")}) for where, node in nodes)
    builder.edges((where, _edge_of(edge, keys)) for where, edge in edges)
    return builder.finished(reading)


def _edge_of(edge: Element, keys: Mapping[str, Element]) -> dict[str, Any]:
    own = {"directed": edge.get("directed")} if edge.get("directed") else {}
    return {**_data(edge, keys), **own, "source": edge.get("source"), "target": edge.get("target")}


def _data(element: Element, keys: Mapping[str, Element]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for data in children(element, "data"):
        key = keys.get(data.get("key", ""))
        name = key.get("attr.name") if key is not None else None
        if name and not len(data):
            found[name] = (data.text or "").strip()
    return found


def _drawn(node: Element) -> dict[str, Any]:
    """Return where yEd draws a node: the middle of its box."""
    for box in node.iter():
        if local(box) == "Geometry":
            try:
                width, height = number(box.get("width", "0")), number(box.get("height", "0"))
                return {"x": number(box.get("x")) + width / 2, "y": number(box.get("y")) + height / 2}
            except ValueError:
                return {}
    return {}


class _Builder:
    """Makes a draft of nodes and edges with attributes of whatever names mean the same as a list's columns."""

    def __init__(self, about: Mapping[str, Any], report: Report, *, directed: bool) -> None:
        self._report, self._directed, self._about = report, directed, about
        self._draft = Draft(title=str(about.get("name") or ""))
        if str(about.get("kind")) == VehicleKind.AGV.value:
            self._draft.kind = VehicleKind.AGV
        if not directed:
            report.assumed(
                "", "the graph is undirected: all track is two-way", "write a directed graph for one-way track"
            )

    def nodes(self, nodes: Iterable[tuple[str, Any]]) -> None:
        """Read nodes."""
        for place, node in nodes:
            name = _text(node.get("id", node.get("name"))) if isinstance(node, dict) else ""
            if not name:
                self._report.wrong(place, "the node has no id: left out", "give it one")
                continue
            where = f"{place} ({shown(name)})" if "[" in place else place
            self._node(name, where, self._roles(node))

    def _roles(self, given: Mapping[str, Any]) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for key, value in given.items():
            folded = fold(str(key))
            role = _WORDS.get(folded) or (key if key in _OURS else ROLES.get(folded))
            if value is None or value == "":
                continue
            if role is None or (role == "barcode" and key not in _IDENTITY):
                if folded not in _IDENTITY and folded not in {"directed", "time"}:
                    self._report.left_out(f"{shown(key)}", "attributes that are not understood")
                continue
            found.setdefault(role, value)
        return found

    def _node(self, name: str, where: str, roles: dict[str, Any]) -> None:
        pos = roles.get("pos")
        if isinstance(pos, list | tuple) and len(pos) >= 2:
            roles.setdefault("x", pos[0])
            roles.setdefault("y", pos[1])
        x, y = self._number(roles, "x", where), self._number(roles, "y", where)
        if x is None or y is None:
            if "x" not in roles or "y" not in roles:
                self._report.wrong(where, "the node has no position: left out", "give it x and y, or pos")
            return
        word = fold(_text(roles.get("kind")))
        park = self._truth(roles, "park", where) or word in PARK_WORDS
        self._draft.spots.append(Spot(name, x, y, where, park))
        if word in CHARGER_WORDS or roles.get("charger"):
            called = _text(roles.get("charger")) or f"CHARGER-{name}"
            self._draft.charges.append(Charge(f"CHARGER-{name}" if called.casefold() in TRUE else called, name, where))
        for station in self._listed(roles.get("station")):
            self._station(station, name, where, KIND_OF.get(word))
        for zone in self._listed(roles.get("zones", roles.get("zone"))):
            self._zone(zone, name, where)

    def _listed(self, value: Any) -> list[Any]:
        if isinstance(value, str) and value[:1] in "[{":
            try:
                value = json.loads(value)
            except ValueError:
                return [value]
        if isinstance(value, list | tuple):
            return list(value)
        return [] if value in (None, "") else [value]

    def _station(self, given: Any, spot: str, where: str, kind: StationKind | None) -> None:
        if not isinstance(given, dict):
            self._draft.places.append(Place(_text(given), [spot], where, kind))
            return
        named = _text(given.get("id") or given.get("name"))
        if not named:
            self._report.wrong(where, "a station without an id: left out", "give it one")
            return
        place = Place(named, [spot], where, KIND_OF.get(fold(_text(given.get("kind"))), kind))
        place.display = _text(given.get("display"))
        place.look_down = int(self._number(given, "look_down", where) or 0)
        place.speed = int(self._number(given, "speed", where) or 100)
        place.fallbacks = tuple(map(_text, self._listed(given.get("fallbacks"))))
        dest = given.get("dest")
        axes = [self._number(dest, axis, where) for axis in ("shft", "rota", "lift")] if isinstance(dest, dict) else []
        pulses = [Pulses(round(axis)) for axis in axes if axis is not None]
        place.dest = PulseSet(*pulses) if len(pulses) == 3 else None
        self._draft.places.append(place)

    def _zone(self, given: Any, spot: str, where: str) -> None:
        about = given if isinstance(given, dict) else {"id": given}
        name = _text(about.get("id"))
        area = self._draft.areas.setdefault(name, Area(name, [], where))
        area.spots.append(spot)
        area.capacity = max(area.capacity, int(self._number(about, "capacity", where) or 1))
        area.no_stop |= about.get("no_stop") is True

    def edges(self, edges: Iterable[tuple[str, Any]]) -> None:
        """Read edges."""
        for place, edge in edges:
            start, end = (_text(edge.get(key)) for key in ("source", "target")) if isinstance(edge, dict) else ("", "")
            if not start or not end:
                self._report.wrong(place, "the edge has no source or no target: left out", "give both")
                continue
            roles, where = self._roles(edge), f"{place} {shown(start)} → {shown(end)}"
            way = Way(start, end, where, self._number(roles, "length", where))
            way.speed = self._number(roles, "speed", where)
            way.sensor = int(self._number(roles, "sensor", where) or 0)
            way.curve = self._truth(roles, "curve", where) if "curve" in roles else None
            self._draft.ways.append(way)
            own = str(edge.get("directed", "")).casefold()
            if own in ("false", "0") or (not self._directed and own not in ("true", "1")):
                back = Way(end, start, way.where, way.length, way.speed, None, way.sensor, way.curve)
                self._draft.ways.append(back)

    def _number(self, roles: Mapping[str, Any], key: str, where: str) -> float | None:
        if roles.get(key) is None:
            return None
        try:
            return number(roles[key])
        except ValueError:
            self._report.wrong(where, f"{key}: no number", WANTED, was=roles[key])
            return None

    def _truth(self, roles: Mapping[str, Any], key: str, where: str) -> bool:
        value = roles.get(key)
        if value is None or isinstance(value, bool):
            return bool(value)
        word = _text(value).casefold()
        if word not in TRUE | FALSE | {"0.0", "1.0"}:
            self._report.wrong(where, f"{key}: neither yes nor no: taken is no", "write true or false", was=value)
        return word in TRUE or word == "1.0"

    def finished(self, reading: Reading) -> Draft:
        """Return the draft, in millimetres."""
        draft = self._draft
        unit = str(self._about.get("unit") or "")
        scale(draft, unit, unit, reading, self._report, y_known=self._about.get("y") == "down")
        settle_speeds(draft, "%" if unit else "", self._report)
        clearance = self._number(self._about, "clearance", "graph") or 0
        draft.clearance = round(min(max(clearance, 0), MAX_LENGTH))
        if draft.charges or any(place.kind is StationKind.AGV_BUFFER for place in draft.places):
            draft.kind = VehicleKind.AGV
        counted = {"nodes": len(draft.spots), "edges": len(draft.ways), "stations": len(draft.places)}
        self._report.read |= counted
        return draft


def _text(value: Any) -> str:
    if value is None or isinstance(value, bool | dict | list):
        return "" if value is None or isinstance(value, dict | list) else str(value).lower()
    return str(int(value)) if isinstance(value, float) and value.is_integer() else str(value).strip()
