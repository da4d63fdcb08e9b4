"""The vehicles of a plant file, with the defaults filled in."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from msgspec import UNSET
from msgspec.structs import fields

from app.domain.ids import DevId, LinkId, VehicleId
from app.domain.layout import Axis, AxisLimits, VehicleKind, VehicleSpec
from app.domain.units import Barcode, Millimetres, Pulses
from app.plant import format as file_format
from app.plant.dialects import Overlays, resolve
from app.plant.document import Document, Mapping, Path
from app.plant.equipment import Links
from app.plant.names import address
from app.plant.references import Places, check_id, is_known, pulses
from app.protocols.enig.messages import DeviceClass
from app.protocols.itsc.dialects import DialectError

_TRANSPORT_BYTES = 64
_ELEMENT_BYTES = 12
NO_FIELDS = frozenset({"address", "reference"})
"""Keys of a vehicle that become something else than a field of its own."""
"""Sub data of INST_MOVE: transport information, then the path elements (PROTOCOLS 1.6)."""

_HOISTS_ALONE = frozenset({"address", "listen", "dialect", "max_count", "limits", "offset", "reference"})
_AGV_FIGURES = {
    "length": Millimetres(1000),
    "max_speed": Millimetres(500),
    "curve_speed": Millimetres(500),
    "acceleration": Millimetres(500),
    "braking": Millimetres(500),
}
"""An AGV that the plant file says nothing about. Our choice: what AGVs on tape do among people."""


def vehicles(
    document: Document, file: file_format.PlantFile, places: Places, dialects: Overlays, links: Links
) -> Iterable[VehicleSpec]:
    """Give every vehicle that could be read; doubled identities and impossible values are noted."""
    taken: dict[tuple[str, object], str] = {("address", way): name for way, name in links.ways.items()}
    for name, given in file.vehicles.items():
        path = ("vehicles", name)
        check_id(document, name, path)
        if given.kind is VehicleKind.AGV:
            spec = _agv(document, file, name, given, links)
        else:
            spec = _spec(name, _merged(file.vehicle_defaults, given))
            spec = _with_address(document, given, spec, path, plant_listens=bool(file.listen))
            _check_limits(document, spec, path)
            _check_dialect(document, spec, path, dialects)
            if spec.link is not None:
                document.error(
                    (*path, "link"), f"{name} is a hoist: it has a line of its own", "leave link out", key=True
                )
        _check_doubles(document, spec, path, taken)
        if given.reference and spec.offset is not None:
            message = f"{name} is a reference vehicle: its offset is zero, so the one given is not used"
            document.warn((*path, "offset"), message, "leave one of them out", key=True)
            spec = replace(spec, offset=None)
        if spec.curve_speed > spec.max_speed:
            message = f"{name}'s curve_speed {spec.curve_speed} is more than its max_speed {spec.max_speed}"
            document.warn((*path, "curve_speed"), message, "both are in mm/s")
        if spec.start is not None and not is_known(document, places, spec.start, (*path, "start")):
            spec = replace(spec, start=None)
        yield spec


def _agv(
    document: Document, file: file_format.PlantFile, name: str, given: file_format.Vehicle, links: Links
) -> VehicleSpec:
    """Return an AGV's figures; what only a hoist has is noted."""
    path: Path = ("vehicles", name)
    node = document.section("vehicles").get(name)
    for key in node.items if isinstance(node, Mapping) else ():
        if key in _HOISTS_ALONE:
            document.error((*path, key), f"{name} is an AGV: {key} is a hoist's", "leave it out", key=True)
    if given.link is UNSET:
        document.error(path, f"{name} is an AGV and has no link", "add link: the name of an enig link", key=True)
        link = None
    else:
        link = links.number(name, given.link, given.dev_id, path, DeviceClass.AGV)
    values = {**_AGV_FIGURES, **_merged(file.agv_defaults, given)}
    return replace(_spec(name, {key: value for key, value in values.items() if key not in _HOISTS_ALONE}), link=link)


def _merged(
    defaults: file_format.VehicleDefaults | file_format.AgvDefaults, given: file_format.Vehicle
) -> dict[str, Any]:
    values = {field.name: getattr(defaults, field.name) for field in fields(defaults)}
    values |= {field.name: value for field in fields(given) if (value := getattr(given, field.name)) is not UNSET}
    return {name: value for name, value in values.items() if value is not UNSET and name not in NO_FIELDS}


def _spec(name: str, values: dict[str, Any]) -> VehicleSpec:
    if "limits" in values:
        limits = values["limits"]
        values["limits"] = AxisLimits(
            *((Pulses(low), Pulses(high)) for low, high in (limits.shft, limits.rota, limits.lift))
        )
    if "offset" in values:
        values["offset"] = pulses(values["offset"])
    if "start" in values:
        values["start"] = Barcode(str(values["start"]))
    if "link" in values:
        values["link"] = LinkId(values["link"])
    return VehicleSpec(id=VehicleId(name), **{**values, "dev_id": DevId(values["dev_id"])})


def _with_address(
    document: Document, given: file_format.Vehicle, spec: VehicleSpec, path: Path, *, plant_listens: bool
) -> VehicleSpec:
    where = (*path, "address")
    try:
        host, port = address(given.address) if given.address else ("", 0)
    except ValueError as wrong:
        document.error(where, str(wrong))
        return spec
    if spec.listen and port:
        message = f"{spec.id} connects to us, so its address has no port"
        document.error(where, message, "write the host alone, or leave listen out")
    elif spec.listen and not plant_listens:
        message = f"{spec.id} connects to us, but the plant does not listen"
        document.error((*path, "listen"), message, "give listen: HOST:PORT at the top of the file")
    elif not spec.listen and not port:
        document.error(where, f"{spec.id} has no address to connect to", "give address: HOST:PORT, or listen: true")
    return replace(spec, host=host, port=port)


def _check_doubles(document: Document, spec: VehicleSpec, path: Path, taken: dict[tuple[str, object], str]) -> None:
    # An AGV's number is compared with what else is on its link, by that link.
    identities: dict[str, object] = {"dev_id": spec.dev_id} if spec.kind is VehicleKind.HOIST else {}
    if spec.port:
        identities["address"] = (spec.host, spec.port)
    if spec.start is not None:
        identities["start"] = spec.start
    for key, value in identities.items():
        other = taken.setdefault((key, value), spec.id)
        if other != spec.id:
            shown = f"{spec.host}:{spec.port}" if key == "address" else value
            document.error((*path, key), f"{spec.id} has the same {key} as {other}: {shown}", "each needs its own")


def _check_limits(document: Document, spec: VehicleSpec, path: Path) -> None:
    for axis in Axis:
        low, high = spec.limits.of(axis)
        if low > high:
            document.error((*path, "limits", axis.value), f"{spec.id}'s {axis} limits are upside down: {low} > {high}")


def _check_dialect(document: Document, spec: VehicleSpec, path: Path, dialects: Overlays) -> None:
    if spec.dialect in document.section("dialects") and spec.dialect not in dialects:
        return
    try:
        dialect = resolve(dialects, spec.dialect)
    except DialectError as wrong:
        document.error((*path, "dialect"), wrong.message, wrong.remedy)
        return
    most = (dialect.max_sub - _TRANSPORT_BYTES) // _ELEMENT_BYTES
    if spec.max_count > most:
        message = f"{spec.id}'s max_count {spec.max_count} is more than its dialect's packets hold: {most}"
        document.error((*path, "max_count"), message, "lower it, or raise max_sub in a dialect of your own")
