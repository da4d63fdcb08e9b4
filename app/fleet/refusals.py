"""Refusals that several desks give, in the same words."""

from collections.abc import Collection

from app.domain.errors import Refusal
from app.domain.lockout import Lockout
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow
from app.wire.names import misspelt


def meant(name: str, see: str, *known: Collection[str]) -> str:
    """Return what helps who named something that there is not: the name that was surely meant, or else where all are."""
    close = next((found for names in known if (found := misspelt(name, names))), None)
    return f"did you mean {close}?" if close else see


def no_vehicle(name: str) -> Refusal:
    """Refusal for a vehicle that the plant does not have."""
    return Refusal("not-found", f"there is no vehicle {name}", "see GET /api/v1/vehicles")


def no_station(name: str) -> Refusal:
    """Refusal for a station that the plant does not have."""
    return Refusal("not-found", f"there is no station {name}", "see GET /api/v1/stations")


def no_link(vehicle: VehicleNow) -> Refusal:
    """Refusal for a vehicle that is not connected."""
    return Refusal("not-now", f"{vehicle.id} is not connected: {vehicle.link_reason}", "look at its line and power")


def not_lifted(lock: Lockout) -> Refusal:
    """Refusal for one who wishes somebody else's lockout away."""
    return Refusal(
        "not-now",
        f"the lockout is {lock.owner}'s; your wish to lift it is noted",
        f"{lock.owner} alone can lift it, or one more person with you",
    )


def leaves(books: Books, name: str, field: str) -> Refusal | None:
    """Refusal of a job that needs what goes with the plant that is to come; None: it stays."""
    leaving = books.leaving
    if leaving is None or not (name in leaving.gone or name in leaving.cut_off):
        return None
    number = leaving.version
    if name in leaving.gone:
        reason = f"{name} is not in version {number} of the plant, which is to become active"
    else:
        reason = f"{name} cannot be reached in version {number} of the plant, which is to become active"
    remedy = f"name another one, or have that version rejected: POST /api/v1/layout/versions/{number}/reject"
    return Refusal("not-now", reason, remedy, field)


def in_emergency(books: Books) -> Refusal | None:
    """Refusal of what may set something moving while a fire or an earthquake is told."""
    told = books.controller.told
    return Refusal("not-now", f"nothing moves: {told}", "release the emergency first") if told else None


def standstill(books: Books, vehicle: VehicleNow) -> Refusal | None:
    """Refusal of what moves a vehicle at once while the controller or its zone is paused, or pauses; None: it may move."""
    stilled = books.stilled(vehicle)
    return Refusal("not-now", stilled, "resume it first") if stilled else None
