"""How far a vehicle must see ahead: what it needs to stop, and what it will come by (TRAFFIC section 2)."""

from itertools import pairwise

from app.domain.units import Barcode, Millimetres, Seconds
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow
from app.planning.kinematics import braking_distance

REACTION = Seconds(0.5)
"""From a barcode read to the XMOVE in the vehicle: link both ways, our commit, its next cycle (our choice, TRAFFIC 2)."""


def horizon(books: Books, vehicle: VehicleNow) -> tuple[Millimetres, Millimetres]:
    """Return (extend when less than this is left, claim up to this): braking, reaction, one edge (TRAFFIC section 2)."""
    spec = vehicle.spec
    edge = 0
    if vehicle.barcode is not None:
        nexts = [*vehicle.ahead, *vehicle.rest][:1]
        edge = books.track.edge(vehicle.barcode, nexts[0]).length if nexts else 0
    low = braking_distance(spec.max_speed, spec) + int(spec.max_speed * REACTION) + edge
    return Millimetres(low), Millimetres(2 * low)


def on_its_way(books: Books, vehicle: VehicleNow, time: Seconds) -> list[tuple[Barcode, Barcode]]:
    """Return the pieces of track before a vehicle, as far as it claims ahead and drives within ``time`` besides.

    A no-stop zone is granted as a whole, however long it is.
    """
    if vehicle.barcode is None:
        return []
    _, high = horizon(books, vehicle)
    left, found = high + vehicle.spec.max_speed * time, []
    for start, end in pairwise([vehicle.barcode, *vehicle.ahead, *vehicle.rest]):
        if left < 0 and not books.track.no_stop(start):
            break
        found.append((start, end))
        left -= books.track.edge(start, end).length
    return found


def can_stop_before(books: Books, vehicle: VehicleNow, barcode: Barcode) -> bool:
    """Whether a vehicle that is told to stop now stands before this barcode on its path, or at it.

    It may be as far as the next barcode by now, at full speed, and the order takes its time.
    """
    if vehicle.barcode is None or barcode not in vehicle.ahead:
        return False
    between = vehicle.ahead[: vehicle.ahead.index(barcode) + 1]
    room = books.track.distance(between)
    spec = vehicle.spec
    return room >= braking_distance(spec.max_speed, spec) + int(spec.max_speed * REACTION)
