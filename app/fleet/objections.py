"""What may come between the decision about a command to a vehicle and its sending: it is looked for once more then."""

from app.domain.commands import Direct, Display, Send, Simple
from app.fleet.books import Books
from app.fleet.harmless import harmless
from app.fleet.passages import Passages


def objection(books: Books, passages: Passages, send: Send) -> str:
    """Return why a command must not leave any more now that it is durable, empty if it may.

    While it was being written down the vehicle may have been settled without it, or barred.
    """
    vehicle = books.vehicles[send.vehicle]
    if send.cmd_id not in vehicle.opened:
        return "it was settled before it could be sent"
    if harmless(send.command):
        return ""
    if vehicle.record.lockout:
        return vehicle.barred
    if people := books.closures.barring(vehicle):
        return people
    if between := barrier(books, passages, send):
        return between
    if isinstance(send.command, Simple | Display | Direct):
        return ""
    if vehicle.fit:
        return ""
    return vehicle.barred or vehicle.waiting or f"{vehicle.id} is being asked where it is"


def barrier(books: Books, passages: Passages, send: Send) -> str:
    """Return what came between the decision and the sending that is not the vehicle's doing; empty if nothing did."""
    if isinstance(send.command, Display):
        return ""
    if told := books.controller.told:
        return told
    intent = books.vehicles[send.vehicle].opened.get(send.cmd_id)
    doors = passages.shut_on(intent.path if intent else ())
    return next((f"{door.id} on its way is {passages.against(door)}" for door in doors), "")
