"""What a running plant has learnt that a changed plant file has no use for: it is kept, but serves nobody."""

from collections.abc import Iterator

from app.domain.layout import Plant
from app.domain.records import Kept
from app.plant.difference import Broken

EXPORT = "export it first (GET /api/v1/teaching/{}), and keep the name if it is the same place or machine"


def lost(new: Plant, kept: Kept) -> list[Broken]:
    """Return what is taught, kept or held ready under names that the new plant does not have. None of it keeps a change back.

    ``kept`` is what the database of the running plant has.
    """
    return [*_taught(new, kept), *_places(new, kept), *_drives(new, kept)]


def _taught(new: Plant, kept: Kept) -> Iterator[Broken]:
    stations = {station.id for station in new.stations}
    vehicles = {vehicle.id for vehicle in new.vehicles}
    for dest in kept.dests:
        if dest.station not in stations:
            text = f"its taught DEST (version {dest.version}) serves nobody any more"
            yield Broken("station", dest.station, text, EXPORT.format("dests"), ("teaching",))
    for offset in kept.offsets:
        if offset.vehicle not in vehicles:
            text = f"its taught OFFSET (version {offset.version}) serves nobody any more"
            yield Broken("vehicle", offset.vehicle, text, EXPORT.format("offsets"), ("teaching",))


def _places(new: Plant, kept: Kept) -> Iterator[Broken]:
    stations = {station.id for station in new.stations}
    for record in kept.stations:
        if record.station not in stations and (record.reserved or record.out_of_service):
            said = f"reserved: {record.reserved}" if record.reserved else f"out of service: {record.out_of_service}"
            yield Broken("station", record.station, f"what was noted of it goes ({said})", "", ("stations",))


def _drives(new: Plant, kept: Kept) -> Iterator[Broken]:
    drives = {drive.id for drive in new.drives}
    for name in dict.fromkeys(value.drive for value in kept.drive_values):
        if name not in drives:
            remedy = "back it up first: POST /api/v1/drives/ID/backups"
            yield Broken("drive", name, "the values that were read of it are not shown any more", remedy, ("drives",))
