"""What vehicles wait for at this moment, counted by cause: the same causes that courtesy puts into words."""

from collections import Counter

from app.domain.records import ControllerState
from app.domain.vehicle import Oper
from app.fleet.books import Books
from app.fleet.vehicle import Stage, VehicleNow
from app.planning.blocking import BlockReason

PEOPLE = ("hold", "lockout", "out_of_service", "off_rail")
"""A person has to do something first."""
BARRIERS = ("emergency", "paused", "roll_call")
"""What keeps all vehicles, or all in an area, from moving."""
CAUSES = (
    *PEOPLE,
    "absent",
    "alarm",
    "settling",
    *BARRIERS,
    *(why.value for why in BlockReason if why is not BlockReason.NO_STOP),
)
"""Every cause there is; the last group is traffic's (``app.planning.blocking``)."""


def waits(books: Books) -> dict[str, int]:
    """Return how many vehicles wait for each cause; every cause is there."""
    found = Counter(cause for vehicle in books.vehicles.values() if (cause := cause_of(books, vehicle)))
    return {cause: found[cause] for cause in CAUSES}


def cause_of(books: Books, vehicle: VehicleNow) -> str:
    """Return what a vehicle waits for, empty if for nothing. What a person has to see to goes before all else."""
    record = vehicle.record
    first = (
        (record.off_rail, "off_rail"),
        (record.lockout, "lockout"),
        (record.hold, "hold"),
        (record.out_of_service, "out_of_service"),
        (vehicle.stage is Stage.ABSENT, "absent"),
        (vehicle.oper is Oper.ALARM, "alarm"),
        (vehicle.stage is Stage.SETTLING, "settling"),
    )
    for applies, cause in first:
        if applies:
            return cause
    if not vehicle.waiting:
        return ""
    blocked = books.traffic.blocked.get(vehicle.id)
    if blocked is not None and blocked.why is not BlockReason.NO_STOP:
        return blocked.why.value
    if books.controller.emergencies:
        return "emergency"
    return "paused" if books.controller.state is not ControllerState.AUTO else "roll_call"
