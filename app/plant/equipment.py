"""Links and what is on them: doors, buffers, chargers, drives; every wrong reference noted."""

import re
from collections.abc import Iterable
from dataclasses import fields

from app.domain.devices import AliasName, DeviceId, DeviceNumber
from app.domain.drive import DriveAddress, DriveId
from app.domain.errors import HoistwayError
from app.domain.ids import LinkId
from app.domain.layout import (
    BufferSpec,
    ChargerSpec,
    ChargingRules,
    DoorSpec,
    DriveUnit,
    LinkSpec,
    SerialPort,
    Wire,
)
from app.domain.units import Barcode, Seconds
from app.plant import format as file_format
from app.plant.dialects import drive_dialect_of, hall_dialect_of
from app.plant.document import Document, Path
from app.plant.names import address
from app.plant.references import Places, check_id, is_known
from app.protocols.enig.codec import codec_of
from app.protocols.enig.dialects import Dialect as HallDialect
from app.protocols.enig.messages import DeviceClass
from app.protocols.hi.dialects import Dialect as DriveDialect
from app.wire.names import nearest

_PARITIES = {file_format.Parity.NONE: "N", file_format.Parity.EVEN: "E", file_format.Parity.ODD: "O"}
_NAMED = {DeviceClass.AGV: "an AGV", DeviceClass.BUFFER: "a buffer", DeviceClass.DOOR: "a door"}
_WINDOW = re.compile(r"([01][0-9]|2[0-3]):([0-5][0-9])-([01][0-9]|2[0-4]):([0-5][0-9])")
_DAY = 24 * 60


class Links:
    """The plant's links by name, as far as they could be read, and who has which number on them.

    ``ways``: address (host, port) or serial device -> the link that is reached there.
    """

    def __init__(self, document: Document, file: file_format.PlantFile) -> None:
        self._document = document
        self._taken: dict[tuple[LinkId, int], str] = {}
        self.ways: dict[object, str] = {}
        self._named = file.links
        self.all = {LinkId(name): self._link(name, given) for name, given in file.links.items()}

    def number(self, name: str, link: object, number: int, path: Path, kind: DeviceClass) -> LinkId | None:
        """Return the ENIG link of a device if it is there and its number fits; what does not is noted."""
        found = self._found(link, Wire.ENIG, path)
        if found is None:
            return None
        dialect = self._hall_dialect(found)
        if dialect is not None and codec_of(dialect).class_of(number) is not kind:
            known = {DeviceClass.AGV: dialect.agv_ids, DeviceClass.BUFFER: dialect.buffer_ids}
            ids = ", ".join(map(str, known.get(kind, dialect.door_ids)))
            where = (*path, "dev_id" if kind is DeviceClass.AGV else "number")
            self._document.error(where, f"{name}: {number} is no number of {_NAMED[kind]} here", f"known: {ids}")
        return self._take(name, found, number, path)

    def drive(self, name: str, link: str, number: int, path: Path) -> LinkId | None:
        """Return the HI line of a drive if it is there; a doubled id is noted."""
        found = self._found(link, Wire.HI, path)
        return None if found is None else self._take(name, found, number, path)

    def _take(self, name: str, link: LinkSpec, number: int, path: Path) -> LinkId:
        other = self._taken.setdefault((link.id, number), name)
        if other != name:
            self._document.error(path, f"{name} has the same number on {link.id} as {other}: {number}", key=True)
        return link.id

    def _found(self, link: object, wire: Wire, path: Path) -> LinkSpec | None:
        where = (*path, "link")
        name = str(link)
        if name not in self._named:
            # One that could not be read has findings of its own.
            if name not in self._document.section("links"):
                close = nearest(name, self._named)
                remedy = f"did you mean {close}?" if close else "give it under links"
                self._document.error(where, f"unknown link {name}", remedy)
            return None
        found = self.all[LinkId(name)]
        if found.wire is not wire:
            message = f"link {name} speaks {found.wire.value}, this needs {wire.value}"
            self._document.error(where, message, "name another link, or correct its protocol")
            return None
        return found

    def _link(self, name: str, given: file_format.Link) -> LinkSpec:
        path: Path = ("links", name)
        check_id(self._document, name, path)
        host, port = self._address(name, given, path)
        serial = None
        if isinstance(given.serial, file_format.Serial):
            port_given = given.serial
            serial = SerialPort(
                port_given.device,
                port_given.baud,
                port_given.data_bits,
                _PARITIES[port_given.parity],
                port_given.stop_bits,
            )
            self._alone(name, port_given.device, (*path, "serial", "device"))
        link = LinkSpec(LinkId(name), given.protocol, host, port, serial, dict(given.dialect))
        self._check_protocol(link, path)
        return link

    def _address(self, name: str, given: file_format.Link, path: Path) -> tuple[str, int]:
        is_serial = isinstance(given.serial, file_format.Serial)
        if is_serial == bool(given.address):
            message = f"{name} is reached " + ("in two ways" if is_serial else "in no way")
            self._document.error(path, message, "give address: HOST:PORT, or serial: {device: ...}", key=True)
        if not given.address:
            return "", 0
        try:
            host, port = address(given.address)
        except ValueError as wrong:
            self._document.error((*path, "address"), str(wrong))
            return "", 0
        if not port:
            self._document.error((*path, "address"), f"{given.address} has no port", "write HOST:PORT")
        self._alone(name, (host, port), (*path, "address"))
        return host, port

    def _alone(self, name: str, way: object, path: Path) -> None:
        other = self.ways.setdefault(way, name)
        if other != name:
            self._document.error(path, f"{name} is reached where {other} is", "each link needs its own")

    def _check_protocol(self, link: LinkSpec, path: Path) -> None:
        if link.wire is Wire.ITSC:
            message = f"{link.id}: an iTSC line carries one hoist alone"
            self._document.error((*path, "protocol"), message, "give the hoist an address under vehicles")
            return
        try:
            hall_dialect_of(link) if link.wire is Wire.ENIG else drive_dialect_of(link)
        except HoistwayError as wrong:
            known = [field.name for field in fields(HallDialect if link.wire is Wire.ENIG else DriveDialect)]
            remedy = wrong.remedy or f"known: preset, {', '.join(known)}"
            self._document.error((*path, "dialect"), wrong.message, remedy)

    def _hall_dialect(self, link: LinkSpec) -> HallDialect | None:
        try:
            return hall_dialect_of(link)
        except HoistwayError:
            return None


def doors(document: Document, file: file_format.PlantFile, places: Places, links: Links) -> Iterable[DoorSpec]:
    """Give every door that could be read."""
    for name, given in file.doors.items():
        path: Path = ("doors", name)
        check_id(document, name, path)
        link = links.number(name, given.link, given.number, path, DeviceClass.DOOR)
        passages = []
        for position, pair in enumerate(given.through):
            where = (*path, "through", position)
            start, end = (Barcode(str(mark)) for mark in pair)
            if not all(is_known(document, places, barcode, where) for barcode in (start, end)):
                continue
            if (start, end) not in places.edges and (end, start) not in places.edges:
                message = f"no track leads between {start} and {end}, which {name} stands across"
                document.error(where, message, "name two neighbours on the track")
            passages.append((start, end))
        if link is not None:
            number = DeviceNumber(given.number)
            open_at_rest, then = given.normally_open, given.on_emergency
            yield DoorSpec(DeviceId(name), link, number, frozenset(passages), open_at_rest, then)


def buffers(document: Document, file: file_format.PlantFile, links: Links) -> Iterable[BufferSpec]:
    """Give every buffer that could be read."""
    for name, given in file.buffers.items():
        path: Path = ("buffers", name)
        check_id(document, name, path)
        link = links.number(name, given.link, given.number, path, DeviceClass.BUFFER)
        if not any(station.buffer == name for station in file.stations.values()):
            document.warn(path, f"no station has buffer {name}", "name it at the station where it stands", key=True)
        if link is not None:
            yield BufferSpec(DeviceId(name), link, DeviceNumber(given.number))


def chargers(document: Document, file: file_format.PlantFile, places: Places) -> Iterable[ChargerSpec]:
    """Give every charger that could be read."""
    for name, given in file.chargers.items():
        path: Path = ("chargers", name)
        check_id(document, name, path)
        alias = AliasName(given.alias) if isinstance(given.alias, str) else None
        if is_known(document, places, str(given.at), (*path, "at")):
            yield ChargerSpec(DeviceId(name), Barcode(str(given.at)), alias)


def charging(document: Document, file: file_format.PlantFile) -> ChargingRules:
    """Return when AGVs charge."""
    given, windows = file.charging, []
    for position, text in enumerate(given.windows):
        match = _WINDOW.fullmatch(text)
        if match is None or int(match[3]) * 60 + int(match[4]) > _DAY:
            where = ("charging", "windows", position)
            document.error(where, f"{text!r} is no time of day", 'write FROM-TO in UTC, such as "12:00-12:30"')
            continue
        hours = [int(part) for part in match.groups()]
        windows.append((hours[0] * 60 + hours[1], hours[2] * 60 + hours[3]))
    return ChargingRules(
        trips=given.trips if isinstance(given.trips, int) else None,
        after=Seconds(given.after) if isinstance(given.after, int) else None,
        lasting=Seconds(given.lasting),
        windows=tuple(windows),
    )


def drives(document: Document, file: file_format.PlantFile, links: Links) -> Iterable[DriveUnit]:
    """Give every drive that could be read."""
    for name, given in file.drives.items():
        path: Path = ("drives", name)
        check_id(document, name, path)
        link = links.drive(name, given.link, given.id, path)
        if link is not None:
            yield DriveUnit(DriveId(name), link, DriveAddress(given.id), given.model, given.name or name)
