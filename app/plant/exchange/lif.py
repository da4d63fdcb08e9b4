"""Layout Interchange Format (VDMA, 1.0), read tolerantly: a plan of nodes and edges for AGVs, in metres, y upwards."""

from collections import defaultdict
from typing import Any

from app.domain.layout import StationKind, VehicleKind
from app.plant.exchange.curves import nurbs
from app.plant.exchange.draft import Charge, Draft, Place, Spot, Way
from app.plant.exchange.json_text import Item
from app.plant.exchange.report import Report, UnreadableLayout, listed, shown

MM = 1000.0
VERSION = "1.0.0"
CHARGING = frozenset({"startcharging", "stopcharging"})
HANDLING = frozenset({"pick", "drop", "pickup", "dropoff", "load", "unload"})
APART = 5.0
"""Levels are drawn side by side, so many metres apart. Our choice."""
KINDS = {kind.value: kind for kind in StationKind}
"""As our own writer describes stations."""
_LEFT_OUT = {
    "vehicleOrientation": "how vehicles are turned on track",
    "rotationAllowed": "where vehicles may turn",
    "rotationAtStartNodeAllowed": "where vehicles may turn",
    "rotationAtEndNodeAllowed": "where vehicles may turn",
    "maxRotationSpeed": "how fast vehicles may turn",
    "minHeight": "heights of load handling",
    "maxHeight": "heights of load handling",
    "reentryAllowed": "where vehicles may be taken into control",
}


def draft_of(data: Any, report: Report, layout: str = "", vehicle_type: str = "") -> Draft:
    """Return the layouts of a file as one draft; ``layout`` and ``vehicle_type`` choose one of each.

    Raises: UnreadableLayout: there is no layout in it, or not the one that was asked for.
    """
    root = _root(data, report)
    meta = root.get("metaInformation")
    about = Item(meta if isinstance(meta, dict) else {}, "metaInformation", report)
    if not isinstance(meta, dict):
        report.repaired("", "there is no metaInformation")
    version, title = about.text("lifVersion"), about.text("projectIdentification")
    if version != VERSION:
        report.repaired("metaInformation", f"lifVersion is {shown(version) or 'missing'}: read as {VERSION}")
    report.source = f"LIF {version or '(no version)'}, {shown(title) or 'unnamed'}"
    chosen = _chosen(root.items("layouts", "layoutId"), layout)
    draft = Draft(title=title, kind=VehicleKind.AGV, maps=True)
    reader = _Reader(draft, report, vehicle_type)
    for item in chosen:
        reader.nodes(item)
    reader.spread()
    for item in chosen:
        reader.edges(item)
        reader.stations(item)
    reader.lone_places()
    report.read |= {"layouts": len(chosen), "nodes": len(draft.spots), "edges": reader.seen, "stations": reader.stops}
    return draft


def _root(data: Any, report: Report) -> Item:
    if isinstance(data, list):
        report.repaired("", "the file is a list of layouts where an object with layouts is meant")
        data = {"layouts": data}
    if isinstance(data, dict) and not any(str(key).casefold() == "layouts" for key in data) and "nodes" in data:
        report.repaired("", "the file is one layout where an object with layouts is meant")
        data = {"layouts": [data], "metaInformation": data.get("metaInformation")}
    if not isinstance(data, dict):
        raise UnreadableLayout("this JSON holds no layouts", remedy="a LIF file is an object with layouts")
    return Item(data, "", report)


def _chosen(layouts: list[Item], wanted: str) -> list[Item]:
    if not layouts:
        raise UnreadableLayout("the file has no layouts", remedy="a LIF file is an object with a list layouts")
    if not wanted:
        return layouts
    found = [item for item in layouts if wanted in (item.text("layoutId"), item.text("layoutName"))]
    if not found:
        known = listed(item.text("layoutId") for item in layouts)
        raise UnreadableLayout(f"there is no layout {wanted!r} in it", remedy=f"there are: {known}")
    return found


class _Reader:
    """Reads the layouts of one file one after the other; nodes of all come before edges, which may lead from one to another."""

    def __init__(self, draft: Draft, report: Report, vehicle_type: str) -> None:
        self._draft, self._report, self._type = draft, report, vehicle_type
        self._levels: dict[str, str] = {}
        self._charging: dict[str, str] = {}
        self._handling: dict[str, str] = {}
        self._types: defaultdict[str, int] = defaultdict(int)
        self._served: set[str] = set()
        self.seen = self.stops = 0

    # -- nodes ----------------------------------------------------------------------------------------------------------

    def nodes(self, layout: Item) -> None:
        """Read the nodes of a layout."""
        for key in ("layoutId", "layoutVersion"):
            if not layout.text(key):
                self._report.repaired(layout.where, f"there is no {key}")
        nodes = layout.items("nodes", "nodeId", path=f"{_short(layout)}.")
        maps = (str(node.value.get("mapId") or "") for node in nodes)
        level = layout.text("layoutLevelId") or next(filter(None, maps), "") or layout.text("layoutId")
        for node in nodes:
            name = node.text("nodeId")
            if not name:
                self._report.wrong(node.where, "the node has no nodeId: left out", "give it one")
                continue
            spot = self._position(node)
            if spot is None:
                self._report.wrong(node.where, "the node has no position: left out", "give nodePosition with x and y")
                continue
            self._levels[name] = level
            self._actions(node, name)
            self._draft.spots.append(Spot(name, spot[0] * MM, -spot[1] * MM, node.where, level=level))

    def _position(self, node: Item) -> tuple[float, float] | None:
        given = node.get("nodePosition")
        if isinstance(given, dict):
            place = Item(given, node.where, self._report)
        elif node.get("x") is not None:
            self._report.repaired(node.where, "x and y stand at the node itself, without nodePosition")
            place = node
        else:
            return None
        x, y = place.number("x"), place.number("y")
        return None if x is None or y is None else (x, y)

    def _actions(self, node: Item, name: str) -> None:
        properties = node.items("vehicleTypeNodeProperties", "vehicleTypeId")
        if not properties:
            self._report.repaired(node.where, "no vehicle type is named for the node: taken is every type")
        for of_type in self._of_type(properties):
            if of_type.get("theta") is not None:
                self._report.left_out(node.where, "how vehicles are turned at nodes")
            for action in of_type.items("actions", "actionType"):
                verb = action.text("actionType").casefold()
                if verb in CHARGING:
                    self._charging[name] = node.where
                elif verb in HANDLING:
                    self._handling[name] = node.where
                else:
                    self._report.left_out(node.where, f"action {shown(action.text('actionType'))}")

    def _of_type(self, properties: list[Item]) -> list[Item]:
        for item in properties:
            self._types[item.text("vehicleTypeId")] += 1
        if not self._type:
            return properties
        return [item for item in properties if item.text("vehicleTypeId") == self._type]

    def spread(self) -> None:
        """Draw levels side by side: one above the other, their track would seem to cross."""
        by_level: defaultdict[str, list[Spot]] = defaultdict(list)
        for spot in self._draft.spots:
            by_level[spot.level].append(spot)
        right: float | None = None
        for level, spots in by_level.items():
            left = min(spot.x for spot in spots)
            shift = 0.0 if right is None else right + APART * MM - left
            for spot in spots:
                spot.x += shift
            right = max(spot.x for spot in spots)
            if shift:
                what = f"drawn {shift / MM:.1f} m to the right, beside the others: a plant has one plan"
                self._report.assumed(f"level {shown(level)}", what, "or import one layout alone with --layout")

    # -- edges ----------------------------------------------------------------------------------------------------------

    def edges(self, layout: Item) -> None:
        """Read the edges of a layout."""
        for edge in layout.items("edges", "edgeId", path=f"{_short(layout)}."):
            self.seen += 1
            start, end = edge.text("startNodeId"), edge.text("endNodeId")
            if not edge.text("edgeId"):
                self._report.repaired(edge.where, "the edge has no edgeId")
            if not start or not end:
                self._report.wrong(edge.where, "the edge has no startNodeId or no endNodeId: left out", "give both")
            elif self._levels.get(start) != self._levels.get(end) and {start, end} <= set(self._levels):
                self._report.left_out(edge.where, "an edge from level to level: lifts are not driven")
            else:
                self._edge(edge, start, end)

    def _edge(self, edge: Item, start: str, end: str) -> None:
        given = edge.items("vehicleTypeEdgeProperties", "vehicleTypeId")
        if not given:
            self._report.repaired(edge.where, "no vehicle type is named for the edge: taken is every type")
        properties = self._of_type(given)
        if given and not properties:
            self._report.left_out(edge.where, f"edges that are not for vehicle type {shown(self._type)}")
            return
        way = Way(start, end, edge.where)
        speeds = []
        for of_type in properties:
            if (speed := of_type.number("maxSpeed")) is not None:
                speeds.append(speed * MM)
            way.length = self._curved(of_type, edge.where) or way.length
            self._note_restrictions(of_type, edge.where)
        way.velocity = min(speeds, default=None)
        self._draft.ways.append(way)

    def _curved(self, of_type: Item, where: str) -> float | None:
        given = of_type.get("trajectory")
        if not isinstance(given, dict):
            return None
        curve = Item(given, where, self._report)
        try:
            spots = [(_sure(point, "x"), _sure(point, "y")) for point in curve.items("controlPoints")]
            weights = [point.number("weight") or 1.0 for point in curve.items("controlPoints")]
            knots = [float(knot) for knot in curve.get("knotVector") or ()]
            return nurbs(spots, weights, knots, int(curve.number("degree") or 1)) * MM
        except (ValueError, TypeError, OverflowError) as wrong:
            self._report.repaired(where, f"the trajectory is no curve ({shown(wrong)}): taken is the straight line")
            return None

    def _note_restrictions(self, of_type: Item, where: str) -> None:
        for what in dict.fromkeys(what for key, what in _LEFT_OUT.items() if of_type.get(key) is not None):
            self._report.left_out(where, what)
        load = of_type.get("loadRestriction")
        if isinstance(load, dict) and not (load.get("loaded", True) and load.get("unloaded", True)):
            only = "loaded" if load.get("loaded", True) else "unloaded"
            what = f"track for {only} vehicles only: any vehicle may be sent there"
            self._report.left_out(where, what)
        elif isinstance(load, dict) and load.get("loadSetNames"):
            self._report.left_out(where, "which loads may be carried there")
        if of_type.get("actions"):
            self._report.left_out(where, "actions on track")

    # -- stations -------------------------------------------------------------------------------------------------------

    def stations(self, layout: Item) -> None:
        """Read the stations of a layout; those where vehicles charge become chargers."""
        if layout.get("stations") is None:
            self._report.repaired(layout.where, "there are no stations: taken as none")
        for station in layout.items("stations", "stationId", path=f"{_short(layout)}."):
            self.stops += 1
            name = station.text("stationId") or station.text("stationName")
            spots = self._spots_of(station)
            if not name:
                self._report.wrong(station.where, "the station has no stationId: left out", "give it one")
                continue
            if station.number("stationHeight"):
                self._report.left_out(station.where, "the height of stations")
            self._served.update(spots)
            known = [spot for spot in spots if spot in self._levels] or spots
            if known and all(spot in self._charging for spot in known):
                self._draft.charges.append(Charge(name, known[0], station.where))
            else:
                kind = KINDS.get(station.text("stationDescription"))
                self._draft.places.append(Place(name, known, station.where, kind, station.text("stationName")))

    def _spots_of(self, station: Item) -> list[str]:
        given = station.get("interactionNodeIds")
        if isinstance(given, str):
            self._report.repaired(station.where, "interactionNodeIds is one text where a list is meant")
            given = [given]
        found = [str(name) for name in given if isinstance(name, str | int)] if isinstance(given, list) else []
        for name in found:
            if name not in self._levels:
                self._report.wrong(
                    station.where, f"node {shown(name)} of it is nowhere given", "correct interactionNodeIds"
                )
        return found

    def lone_places(self) -> None:
        """Make stations and chargers of nodes where vehicles handle loads or charge, but that no station names."""
        for name, where in self._charging.items():
            if name not in self._served:
                self._draft.charges.append(Charge(f"CHARGER-{name}", name, where))
                self._report.repaired(
                    where, "vehicles charge at the node, and no station names it: it becomes a charger"
                )
        for name, where in self._handling.items():
            if name not in self._served and name not in self._charging:
                self._draft.places.append(Place(f"ST-{name}", [name], where))
                self._report.repaired(where, "loads are handled at the node, and no station names it: it becomes one")
        if len(self._types) > 1 and not self._type:
            what = f"taken is what any vehicle type may use: {listed(sorted(self._types))}"
            self._report.assumed("", what, "or choose one with --vehicle-type")
        elif self._type and self._type not in self._types:
            self._report.wrong("", f"no vehicle type {shown(self._type)} is named: {listed(sorted(self._types))}")


def _short(layout: Item) -> str:
    return layout.where.partition(" ")[0]


def _sure(item: Item, key: str) -> float:
    found = item.number(key)
    if found is None:
        raise ValueError(f"a control point has no {key}")
    return found
