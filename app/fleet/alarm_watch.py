"""Alarms that nobody tells: vehicles that have been silent for a while, and those that a restart has left behind."""

from app.domain.alarms import OF_VEHICLES, AlarmKind
from app.domain.units import Seconds
from app.fleet.books import Books

SILENT = Seconds(10.0)
"""A vehicle that was connected is an alarm after so long without its line: one that is back sooner is none (our choice)."""
STRANGER = "stranger"
PERSISTENT = Seconds(150.0)
"""Somebody who is refused, and again within so long, is an alarm, until so long after the last time. Once is none: a vehicle
whose old connection is not known to be dead yet is refused too. More than twice what the shell keeps silent (our choice)."""
MOST_STRANGERS = 100


class AlarmWatch:
    """Looks at all vehicles, once a second."""

    def __init__(self, books: Books) -> None:
        self._books = books
        self._next_look = books.now
        self._strangers: dict[str, Seconds] = {}
        """Why somebody who wanted to be a vehicle was refused, and when last."""

    def refused(self, reason: str) -> None:
        """Somebody who dialled in was refused: an address or number that no vehicle has, or one that is connected already."""
        again = self._strangers.pop(reason, None)
        if len(self._strangers) >= MOST_STRANGERS:
            self._strangers.pop(next(iter(self._strangers)))
        self._strangers[reason] = self._books.now
        if again is not None and self._books.now - again <= PERSISTENT:
            remedy = (
                "find out who that is: a vehicle with a wrong address or DEV_ID, another controller's, or an intruder"
            )
            cause = f"a connection is refused again and again: {reason}"
            self._books.alarms.begin(AlarmKind.PLANT, self._books.plant.name, STRANGER, cause, remedy)

    def start(self) -> None:
        """After a start: end what concerns machines that are gone, and what began with motion that is settled anew."""
        books, plant = self._books, self._books.plant
        known: dict[AlarmKind, set[str]] = {kind: {*books.vehicles} for kind in OF_VEHICLES}
        devices: set[str] = {d.id for d in plant.doors} | {b.id for b in plant.buffers} | {c.id for c in plant.chargers}
        known |= {AlarmKind.DEVICE: devices, AlarmKind.DRIVE: {d.id for d in plant.drives}}
        for alarm in list(books.alarms.live.values()):
            if alarm.kind is AlarmKind.TRAFFIC or (alarm.kind is AlarmKind.PLANT and alarm.code == STRANGER):
                books.alarms.end_one(alarm.kind, alarm.source, alarm.code, "the controller was started again")
            elif alarm.kind in known and alarm.source not in known[alarm.kind]:
                books.alarms.end_one(alarm.kind, alarm.source, alarm.code, "it is not in the plant any more")

    def tick(self) -> None:
        """See who is silent, and who is back."""
        alarms, now = self._books.alarms, self._books.now
        if now < self._next_look:
            return
        self._next_look = Seconds(now + 1.0)
        for vehicle in self._books.vehicles.values():
            if vehicle.linked:
                if alarms.about(AlarmKind.LINK, vehicle.id):
                    alarms.end(AlarmKind.LINK, vehicle.id, "it is connected again")
            elif vehicle.seen is not None and not vehicle.record.off_rail and now - vehicle.link_since >= SILENT:
                remedy = "look at its line and power"
                alarms.begin(AlarmKind.LINK, vehicle.id, "silent", f"not connected: {vehicle.link_reason}", remedy)
        if self._strangers and now - max(self._strangers.values()) > PERSISTENT:
            self._strangers.clear()
            alarms.end_one(AlarmKind.PLANT, self._books.plant.name, STRANGER, "nobody has been refused for a while")
