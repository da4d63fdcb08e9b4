"""Stop one vehicle where it is: it keeps AUTO, and goes on when it is told to (DOMAIN section 7)."""

from app.domain.commands import Plain, Simple
from app.domain.ids import Actor
from app.domain.records import Intent
from app.domain.vehicle import Mode
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow


def halt(books: Books, vehicle: VehicleNow, actor: Actor, why: str) -> Intent | None:
    """Send STOP BY HOST (an AGV: Stop); None if the vehicle is where it cannot be told: silent, or driven by people."""
    if not vehicle.linked or (not vehicle.is_agv and vehicle.mode not in {Mode.AUTO, Mode.SEMI}):
        return None
    if vehicle.drive:
        vehicle.drive.recalled = True
    stop = Plain.STOP_BY_HOST
    return books.open_intent(vehicle, stop.value, Simple(stop), actor, body={"why": why})
