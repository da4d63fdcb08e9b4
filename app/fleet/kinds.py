"""Which vehicle serves which station: hoists and AGVs keep to their own (DOMAIN section 1)."""

from app.domain.errors import Refusal
from app.domain.ids import StationId, VehicleId
from app.domain.layout import Station, StationKind, VehicleKind
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow

SERVANTS = {station: frozenset(kind for kind in VehicleKind if station in kind.serves) for station in StationKind}
"""The kinds of vehicle that serve a kind of station."""
NAMED = {VehicleKind.HOIST: "hoist", VehicleKind.AGV: "AGV"}


def serves(vehicle: VehicleNow, station: Station) -> bool:
    """Return whether a station is one for this kind of vehicle."""
    return station.kind in vehicle.spec.kind.serves


def kinds_at(books: Books, place: str) -> frozenset[VehicleKind]:
    """Return the kinds of vehicle that can do a job's end at a station; for a vehicle, its own."""
    if place in books.vehicles:
        return frozenset({books.vehicles[VehicleId(place)].spec.kind})
    return SERVANTS[books.specs[StationId(place)].kind]


def between_kinds(books: Books, source: str, others: tuple[StationId, ...], wish: VehicleId | None) -> Refusal | None:
    """Return why no vehicle can do a job with these ends, ``others`` being its destination and fall-backs."""
    here = kinds_at(books, source)
    if wish is None and len(others) == 1 and here & kinds_at(books, others[0]):  # nearly all
        return None
    for place, field in zip(others, ("destination", *("fallbacks" for _ in others)), strict=False):
        if not here & kinds_at(books, place):
            reason = f"no vehicle serves both {_said(books, source)} and {_said(books, place)}"
            return Refusal("no-route", reason, "order two jobs, and let the carrier change over between them", field)
    if wish is not None and books.vehicles[wish].spec.kind not in here:
        kind = NAMED[books.vehicles[wish].spec.kind]
        reason = f"{wish} is {_an(kind)}, and does not serve {_said(books, source)}"
        return Refusal("invalid", reason, "name another vehicle, or leave it out", "vehicle")
    return None


def no_servant(vehicle: VehicleNow, station: Station) -> Refusal | None:
    """Return why this vehicle cannot handle at this station, if its kind does not."""
    if serves(vehicle, station):
        return None
    kind = NAMED[vehicle.spec.kind]
    reason = f"{vehicle.id} is {_an(kind)}, and does not serve {station.id} ({station.kind.value})"
    return Refusal("invalid", reason, "see GET /api/v1/stations for those it serves", "station")


def _said(books: Books, place: str) -> str:
    if place in books.vehicles:
        return f"{place} ({NAMED[books.vehicles[VehicleId(place)].spec.kind]})"
    return f"{place} ({books.specs[StationId(place)].kind.value})"


def _an(word: str) -> str:
    return f"{'an' if word[0] in 'AEIOU' else 'a'} {word}"
