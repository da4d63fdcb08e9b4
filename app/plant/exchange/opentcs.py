"""Plant models of openTCS 6 and 7 (older ones tolerantly): points, paths, locations, blocks, vehicles; mm, y upwards."""

from collections import Counter, defaultdict

from app.domain.layout import VehicleKind
from app.plant.exchange.draft import Area, Charge, Draft, Machine, Place, Spot, Way
from app.plant.exchange.report import Report, UnreadableLayout, shown
from app.plant.exchange.xml_text import Element, child, children, local, numeral, place

KNOWN = ("6", "7")
PARK = "PARK_POSITION"
START = ("loopback:initialPosition", "tcs:initialPosition", "initialPosition")
"""Properties by which openTCS models say where a simulated vehicle begins."""
CURVED = frozenset({"BEZIER", "BEZIER_3", "ELBOW", "SLANTED", "POLYPATH"})
CLOSED = "a closed path: openTCS lets nobody drive on it"
_READ = frozenset(
    {"point", "path", "location", "locationType", "vehicle", "block", "property", "visualLayout", "peripheralOperation"}
)


def draft_of(root: Element, report: Report, *, keep_locked: bool = False) -> Draft:
    """Return what a plant model describes. ``keep_locked``: track that is locked there is track all the same.

    Raises: UnreadableLayout: it is no plant model.
    """
    if local(root) != "model":
        raise UnreadableLayout(f"the root element is {shown(local(root))}, not model")
    version, title = root.get("version", ""), root.get("name", "")
    report.source = f"openTCS plant model {shown(version) or '(no version)'}, {shown(title) or 'unnamed'}"
    if version.partition(".")[0] not in KNOWN:
        report.assumed("", f"version {shown(version) or '(none)'} is read like versions {' and '.join(KNOWN)}")
    draft = Draft(title=title, kind=VehicleKind.AGV, maps=True)
    _points(root, draft, report)
    _paths(root, draft, report, keep_locked=keep_locked)
    _locations(root, draft, report)
    _blocks(root, draft, report)
    _vehicles(root, draft, report)
    counted = Counter(local(element) for element in root)
    names = {"point": "points", "path": "paths", "location": "locations", "vehicle": "vehicles", "block": "blocks"}
    report.read |= {shown_as: counted[tag] for tag, shown_as in names.items()}
    for tag in counted:
        if tag and tag not in _READ:
            report.left_out(f"{shown(tag)}", "elements that are not known here")
    return draft


def _properties(element: Element) -> dict[str, str]:
    return {item.get("name", ""): item.get("value", "") for item in children(element, "property")}


def _named(element: Element, report: Report) -> str:
    name: str = element.get("name") or element.get("id") or ""
    if not name:
        report.wrong(f"{local(element)} (line {element.sourceline})", "it has no name: left out", "give it one")
    return name


# -- points and paths ---------------------------------------------------------------------------------------------------


def _points(root: Element, draft: Draft, report: Report) -> None:
    for point in children(root, "point"):
        name = _named(point, report)
        if not name:
            continue
        where = place(point, name)
        x = numeral(point, ("positionX", "xPosition"), where, report)
        y = numeral(point, ("positionY", "yPosition"), where, report)
        if not x and not y:
            x, y = _from_layout(point, where, (x, y), report)
        if x is None or y is None:
            report.wrong(where, "the point has no position: left out", "give positionX and positionY")
            continue
        if (z := numeral(point, ("positionZ", "zPosition"), where, report)) not in (None, 0.0):
            report.left_out(where, "heights of points: a plant has one plan")
        angle = point.get("vehicleOrientationAngle", "NaN")
        if angle not in ("", "NaN"):
            report.left_out(where, "how vehicles are turned at points")
        draft.spots.append(Spot(name, x, -y, where, park=point.get("type") == PARK, level=str(z or "")))


def _from_layout(
    point: Element, where: str, given: tuple[float | None, float | None], report: Report
) -> tuple[float | None, float | None]:
    """Return the position on the drawing where the model has none."""
    layout = child(point, "pointLayout")
    if layout is None:
        return given
    x = numeral(layout, ("positionX", "xPosition"), where, report)
    y = numeral(layout, ("positionY", "yPosition"), where, report)
    if x is None or y is None or (given != (None, None) and not x and not y):
        return given
    report.repaired(where, "the point has no position of its own: taken is that of the drawing")
    return x, y


def _paths(root: Element, draft: Draft, report: Report, *, keep_locked: bool) -> None:
    for path in children(root, "path"):
        name = _named(path, report) or "(unnamed)"
        where = place(path, name)
        start, end = path.get("sourcePoint", ""), path.get("destinationPoint", "")
        if not start or not end:
            report.wrong(where, "the path has no sourcePoint or no destinationPoint: left out", "give both")
            continue
        if path.get("locked") in ("true", "1"):
            if not keep_locked:
                report.left_out(where, CLOSED, "keep it with --keep-locked, and close it in the running plant")
                continue
            report.needed(where, "a locked path: close it in the running plant", "POST /api/v1/closures")
        _add(path, (start, end), where, draft, report)


def _add(path: Element, ends: tuple[str, str], where: str, draft: Draft, report: Report) -> None:
    layout = child(path, "pathLayout")
    bent = layout is not None and layout.get("connectionType") in CURVED
    length = numeral(path, ("length",), where, report)
    forward = numeral(path, ("maxVelocity",), where, report)
    backward = numeral(path, ("maxReverseVelocity",), where, report)
    if child(path, "peripheralOperation") is not None:
        report.left_out(where, "operations of peripherals on paths", "doors are given under doors")
    if not forward and not backward and forward is not None:
        report.left_out(where, "no speed either way: nobody may drive there")
        return
    if forward is None or forward > 0:
        draft.ways.append(Way(*ends, where, length, velocity=forward, curve=bent or None))
    if backward is not None and backward > 0:
        report.assumed(
            where, "driven backwards as well: two-way track", "drop the run that leads back if it is not wanted"
        )
        draft.ways.append(Way(ends[1], ends[0], where, length, velocity=backward, curve=bent or None))


# -- locations, blocks, vehicles ----------------------------------------------------------------------------------------


def _locations(root: Element, draft: Draft, report: Report) -> None:
    types = {kind.get("name", ""): kind for kind in children(root, "locationType")}
    for location in children(root, "location"):
        name = _named(location, report)
        if not name:
            continue
        where, kind = place(location, name), types.get(location.get("type", ""))
        if kind is None:
            report.wrong(where, f"its type {shown(location.get('type', ''))} is nowhere given", "correct it")
        links = [link.get("point", "") for link in children(location, "link")]
        if location.get("locked") in ("true", "1"):
            report.needed(
                where, "a locked location: put it out of service in the running plant", "PATCH /api/v1/stations/ID"
            )
        if not links:
            report.left_out(where, "a location that is linked to no point", "give it a station at a barcode")
        elif _charges(location, kind):
            draft.charges.append(Charge(name, links[0], where))
        else:
            draft.places.append(Place(name, links, where))


def _charges(location: Element, kind: Element | None) -> bool:
    own = [operation for link in children(location, "link") for operation in children(link, "allowedOperation")]
    general = list(children(kind, "allowedOperation")) if kind is not None else []
    words = [operation.get("name", "").casefold() for operation in own or general]
    return bool(words) and all("charge" in word or "충전" in word for word in words)


def _blocks(root: Element, draft: Draft, report: Report) -> None:
    ends: defaultdict[str, list[str]] = defaultdict(list)
    for path in children(root, "path"):
        # Who drives on a path holds the mark at its end.
        ends[path.get("name", "")].append(path.get("destinationPoint", ""))
        if (path.get("maxReverseVelocity") or "0").strip("0.") != "":
            ends[path.get("name", "")].append(path.get("sourcePoint", ""))
    points = {point.get("name", "") for point in children(root, "point")}
    places = {location.get("name", "") for location in children(root, "location")}
    for block in children(root, "block"):
        name = _named(block, report)
        if not name:
            continue
        where = place(block, name)
        if block.get("type", "SINGLE_VEHICLE_ONLY") != "SINGLE_VEHICLE_ONLY":
            report.left_out(where, f"blocks of type {shown(block.get('type'))}")
            continue
        inside: dict[str, None] = {}
        for member in (member.get("name", "") for member in children(block, "member")):
            if member in points:
                inside[member] = None
            elif member in ends:
                inside.update(dict.fromkeys(ends[member]))
            elif member not in places:
                report.wrong(where, f"its member {shown(member)} is nowhere given", "correct or leave it out")
        draft.areas.setdefault(name, Area(name, list(inside), where))


def _vehicles(root: Element, draft: Draft, report: Report) -> None:
    for vehicle in children(root, "vehicle"):
        name = _named(vehicle, report)
        if not name:
            continue
        where, box = place(vehicle, name), child(vehicle, "boundingBox")
        start = next((value for key, value in _properties(vehicle).items() if key in START and value), None)
        length = numeral(box if box is not None else vehicle, ("length",), where, report)
        velocity = numeral(vehicle, ("maxVelocity",), where, report)
        draft.machines.append(Machine(name, where, None, start=start, velocity=velocity or None, length=length))
