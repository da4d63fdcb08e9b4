"""Pulses that a changed plant file gives and that do not count: the database has others, which hold until a person says so."""

from collections.abc import Iterator
from typing import Protocol

from app.domain.ids import Actor
from app.domain.layout import Axis, Plant, PulseSet, StationKind
from app.domain.pulses import AxisPulses, known
from app.domain.records import Kept
from app.plant.difference import Broken


class _Version(Protocol):
    """A version of a DEST or an OFFSET."""

    @property
    def version(self) -> int: ...
    @property
    def pulses(self) -> AxisPulses: ...
    @property
    def source(self) -> str: ...
    @property
    def actor(self) -> Actor: ...


def overruled(old: Plant, new: Plant, kept: Kept) -> list[Broken]:
    """Return the ports and hoists whose pulses were edited in the plant file, and for which others hold.

    Those of a plant file count only where the database is made (DOMAIN section 3). None of it keeps a change back. ``kept`` is
    what the database of the running plant has.
    """
    return [*_ports(old, new, kept), *_hoists(old, new, kept)]


def _ports(old: Plant, new: Plant, kept: Kept) -> Iterator[Broken]:
    before = {station.id: station.dest for station in old.stations}
    hold = {dest.station: dest for dest in kept.dests}
    for port in new.stations:
        if port.kind is StationKind.PORT and port.dest and port.dest != before.get(port.id):
            yield from _said("station", port.id, "dest", port.dest, hold.get(port.id))


def _hoists(old: Plant, new: Plant, kept: Kept) -> Iterator[Broken]:
    before = {vehicle.id: vehicle.offset for vehicle in old.hoists}
    hold = {offset.vehicle: offset for offset in kept.offsets}
    for hoist in new.hoists:
        if hoist.id not in new.reference_vehicles and hoist.offset and hoist.offset != before.get(hoist.id):
            yield from _said("vehicle", hoist.id, "offset", hoist.offset, hold.get(hoist.id))


def _said(what: str, name: str, field: str, given: PulseSet, holds: _Version | None) -> Iterator[Broken]:
    if holds is None or holds.pulses == given:
        return
    text = (
        f"its {field} in the plant file does not count ({_told(given)}): "
        f"version {holds.version} of the database holds, by {holds.source}, {holds.actor} ({_told(holds.pulses)})"
    )
    body = ", ".join(f'"{axis.value}": {given.of(axis)}' for axis in Axis)
    yield Broken(what, name, text, f"to take the file's: PUT /api/v1/{what}s/{name}/{field} {{{body}}}", ("teaching",))


def _told(pulses: AxisPulses) -> str:
    return ", ".join(f"{axis.name} {value}" for axis, value in known(pulses).items())
