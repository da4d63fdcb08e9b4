"""What the parts of a plant file say of one another: barcodes, stations, names."""

from dataclasses import dataclass, field

from app.domain.job import JobEvent
from app.domain.layout import PulseSet
from app.domain.units import Pulses
from app.plant import format as file_format
from app.plant.document import Document, Path
from app.plant.names import ID_RULE, is_id
from app.wire.names import nearest

_MANY = 2_000
"""Beyond so many names the nearest one is not looked for: it would take longer than reading the file."""


@dataclass(slots=True)
class Places:
    """Where in the file the parts of a plant stand; ``doubtful`` barcodes are named there but could not be read."""

    barcodes: dict[str, Path] = field(default_factory=dict)
    edges: dict[tuple[str, str], Path] = field(default_factory=dict)
    doubtful: set[str] = field(default_factory=set)


def is_known(document: Document, places: Places, name: str, path: Path) -> bool:
    """Whether the barcode has a position; if it is not in the file at all, that is noted."""
    if name not in places.barcodes and name not in places.doubtful:
        close = nearest(name, places.barcodes) if len(places.barcodes) < _MANY else None
        document.error(path, f"unknown barcode {name}", f"did you mean {close}?" if close else "give it under barcodes")
    return name in places.barcodes


def check_station(document: Document, name: str, path: Path) -> None:
    """Note the name of a station that the file does not have."""
    named = document.section("stations")
    if name not in named:
        close = nearest(name, named)
        document.error(path, f"unknown station {name}", f"did you mean {close}?" if close else "give it under stations")


def check_event(document: Document, name: str, path: Path) -> None:
    """Note the name of an event that there is not."""
    if name not in set(JobEvent):
        close = nearest(name, JobEvent)
        document.error(path, f"unknown event {name}", f"did you mean {close}?" if close else "", key=True)


def check_id(document: Document, name: str, path: Path) -> None:
    """Note a name that cannot be an id."""
    if not is_id(name):
        document.error(path, f"{name!r} cannot be a name here", f"use {ID_RULE}", key=True)


def pulses(given: file_format.Pulses) -> PulseSet:
    """Return the file's pulses in the domain's words."""
    return PulseSet(Pulses(given.shft), Pulses(given.rota), Pulses(given.lift))
