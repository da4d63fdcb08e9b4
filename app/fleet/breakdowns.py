"""Vehicles that stand and will not go on by themselves: routes keep off what they bar (TRAFFIC section 5)."""

from dataclasses import dataclass

from app.domain.ids import VehicleId
from app.domain.job import JobEvent
from app.domain.records import ControllerState
from app.domain.units import Barcode, Seconds
from app.domain.vehicle import Mode, Oper
from app.fleet.books import Books
from app.fleet.closed import Reason
from app.fleet.vehicle import Stage, VehicleNow

GRACE = Seconds(10.0)
"""A vehicle that has stood so long is kept off: by then its job goes to another, too (our choice)."""
OBSTACLE_GRACE = Seconds(30.0)
"""One that an obstacle keeps (PAUSE) only after so long: most obstacles go away by themselves (our choice)."""
AT_ONCE = 10
"""So many are kept off in one look, those that stand longest; the others in the next: each is a piece of a tick (our choice)."""


@dataclass(slots=True)
class Stand:
    """A vehicle that stands: since when, for how long that is let pass, why in words, and what is closed for it."""

    since: Seconds
    grace: Seconds
    why: str
    reason: Reason | None = None
    held: tuple[Barcode, ...] = ()


class Breakdowns:
    """Knows the vehicles that stand for good, and keeps routes off what nobody else is granted because of them.

    Nothing is closed for a vehicle that the roll-call misses: where it stands is not known, and nobody drives there anyway.
    """

    def __init__(self, books: Books) -> None:
        self._books = books
        self._standing: dict[VehicleId, Stand] = {}

    def __contains__(self, vehicle: VehicleId) -> bool:
        """Return whether routes keep off a vehicle."""
        stand = self._standing.get(vehicle)
        return stand is not None and stand.reason is not None

    def mind(self, vehicle: VehicleNow) -> None:
        """A vehicle is different now: it may have come to stand, or to go on."""
        stand = self._standing.get(vehicle.id)
        if stand is None and vehicle.fit and vehicle.oper is not Oper.PAUSE:  # nearly all
            return
        why, grace = self._stands(vehicle)
        if not why:
            self.goes_on(vehicle)
            return
        if stand is None:
            self._standing[vehicle.id] = Stand(self._books.now, grace, why)
            return
        stand.grace, before, stand.why = grace, stand.why, why
        books = self._books
        if (
            stand.reason
            and (why, books.traffic.held(vehicle.id)) == (before, stand.held)
            and books.closed.by(stand.reason)
        ):
            return
        if stand.reason:
            self._shut(vehicle, stand)

    def goes_on(self, vehicle: VehicleNow) -> None:
        """Keep off a vehicle no more if it can go on by itself again: before its way is planned."""
        stand = self._standing.get(vehicle.id)
        if stand is None or self._stands(vehicle)[0]:
            return
        del self._standing[vehicle.id]
        if stand.reason:
            self._books.closed.shut_only(stand.reason)
            gone = "is off the rail" if vehicle.record.off_rail else "can go on"
            self._books.event(JobEvent.VEHICLE_MENDED, vehicle=vehicle.id, detail=f"{vehicle.id} {gone}")

    def run(self) -> None:
        """Keep off those that have stood for long by now."""
        books, now = self._books, self._books.now
        if books.controller.state is not ControllerState.AUTO:
            return
        due = [n for n, stand in self._standing.items() if not stand.reason and now - stand.since >= stand.grace]
        heard, left = self._heard() if due else set(), AT_ONCE
        for name in sorted(due, key=lambda name: self._standing[name].since):
            vehicle, stand = books.vehicles[name], self._standing[name]
            if not left:
                return
            if vehicle.stage is Stage.ABSENT and heard.isdisjoint(self._areas(vehicle)):
                continue  # if none is heard where it is, the network is silent
            if self._shut(vehicle, stand):
                left -= 1
                off = ", ".join(map(str, books.traffic.barred_by(name)))
                books.event(JobEvent.VEHICLE_BROKEN_DOWN, vehicle=name, detail=f"{stand.why}; ways lead round {off}")

    def _shut(self, vehicle: VehicleNow, stand: Stand) -> bool:
        """Close what the vehicle bars now, and nothing else, for it; return whether there is anything."""
        books = self._books
        barred = [barcode for barcode in books.traffic.barred_by(vehicle.id) if barcode in books.track]
        if not barred and stand.reason is None:
            return False
        stand.reason = Reason(vehicle.id, stand.why)
        stand.held = books.traffic.held(vehicle.id)
        books.closed.shut_only(stand.reason, *barred)
        return True

    def _heard(self) -> set[int]:
        """Return the areas of the track in which vehicles are heard."""
        track = self._books.track
        heard = (v.barcode for v in self._books.vehicles.values() if v.linked and v.barcode is not None)
        return {track.area(barcode) for barcode in heard if barcode in track}

    def _areas(self, vehicle: VehicleNow) -> set[int]:
        """Return the areas of the track that a vehicle holds any of."""
        track = self._books.track
        return {track.area(barcode) for barcode in self._books.traffic.held(vehicle.id) if barcode in track}

    def _stands(self, vehicle: VehicleNow) -> tuple[str, Seconds]:
        """Return why a vehicle stands that does not go on by itself, empty if it may, and how long that is let pass."""
        if vehicle.record.off_rail or vehicle.id in self._books.roll_call:
            return "", GRACE
        if vehicle.stage is Stage.ABSENT:
            return f"{vehicle.id} is there, silent: {vehicle.link_reason}", GRACE
        condition = vehicle.status.condition if vehicle.status else None
        if condition is None or (condition.travelling and condition.oper is not Oper.PAUSE):
            return "", GRACE
        if vehicle.fit:
            paused = condition.oper is Oper.PAUSE
            return f"{vehicle.id} stands there before an obstacle" if paused else "", OBSTACLE_GRACE
        return f"{vehicle.id} stands there, {self._unfit(vehicle)}", GRACE

    def _unfit(self, vehicle: VehicleNow) -> str:
        """Return what is wrong with a vehicle that cannot be moved: words that stay as long as the cause does."""
        if vehicle.oper is Oper.ALARM and vehicle.status is not None:
            return f"in alarm {self._books.named_alarm(vehicle.status.condition.code)}"
        if vehicle.barred:
            return vehicle.barred
        if vehicle.mode is not Mode.AUTO and vehicle.mode is not None:
            return f"in {vehicle.mode.name}"
        return "not ready"
