"""What a vehicle covers where it stands, and between which tags an AGV may be (PROTOCOLS 3.3)."""

from app.domain.units import Barcode, Millimetres
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow
from app.planning.track import Track


def next_tag(track: Track, vehicle: VehicleNow, barcode: Barcode) -> Barcode | None:
    """Return the tag on the way to which an AGV was stopped, None if it stands in position (PROTOCOLS 3.3).

    It may be anywhere between the two. What was granted to it last tells, in this process life or by its open intents.
    """
    if vehicle.in_position:
        return None
    if vehicle.barcode == barcode and vehicle.drive is None and vehicle.toward:
        return vehicle.toward
    here = () if vehicle.barcode is None else (vehicle.barcode, *vehicle.ahead)
    for way in (here, *(intent.path for intent in vehicle.opened.values()), vehicle.record.held):
        if barcode in way[:-1]:
            after = way[way.index(barcode) + 1]
            if after in track.successors(barcode):
                return after
    return None


def covered(books: Books, vehicle: VehicleNow, barcode: Barcode) -> dict[Barcode, Millimetres]:
    """Return what it covers there: by the way it came if that is known, else by every branch.

    An AGV may have come backwards, or have turned: it may cover what is on any side of it, but not over another.
    """
    length = vehicle.spec.length
    if vehicle.barcode == barcode and vehicle.trail.get(barcode) == 0:
        return vehicle.trail
    behind = books.track.distances_behind(barcode, length)
    if not vehicle.is_agv:
        return behind
    near = books.track.reach(barcode, length) - {barcode}
    around = dict.fromkeys(sorted(b for b in near if books.traffic.holders(b) <= {vehicle.id}), length)
    return {barcode: Millimetres(0)} | around | behind


def maybe_covered(books: Books, vehicle: VehicleNow, barcode: Barcode) -> frozenset[Barcode]:
    """Return what it covers there only if it came backwards, or has turned: an AGV by a way that is not known."""
    if not vehicle.is_agv or vehicle.toward:
        return frozenset()
    return frozenset(vehicle.trail) - books.track.distances_behind(barcode, vehicle.spec.length).keys()
