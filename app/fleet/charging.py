"""When AGVs charge: ENIG reports no battery level, so it goes by rules (DOMAIN section 7, COMMANDS section 1).

An idle AGV that is due is sent to a free charger by granted moves, and told to charge only where it stands at one. While it
has to stay, no job is given to it, and nobody asks it to give way; after that any job may take it (our choice). What was counted
before a restart is forgotten (our choice): an AGV that charges says so in its Status.
"""

from dataclasses import dataclass

from app.domain.commands import Direct
from app.domain.devices import AgvCharge
from app.domain.errors import NoRoute
from app.domain.ids import VehicleId
from app.domain.layout import ChargerSpec, StopAction
from app.domain.units import Barcode, Seconds
from app.fleet.books import SYSTEM, Books
from app.fleet.devices import Devices
from app.fleet.motion import Motion
from app.fleet.vehicle import Errand, Purpose, VehicleNow

MINUTES = 24 * 60
AGAIN_AFTER = Seconds(10.0)
"""A Charge that had no effect is asked for again after so long, as a new command (our choice)."""


@dataclass(slots=True)
class Battery:
    """What the rules go by. ``since`` is when it last charged, or was first seen, after so many ``trips``.

    ``begun`` is when this charging began, ``asked`` when Charge was sent last.
    """

    since: Seconds
    trips: int = 0
    begun: Seconds | None = None
    asked: Seconds | None = None


class Charging:
    """Sends AGVs to charge, and has them stay."""

    def __init__(self, books: Books, motion: Motion, devices: Devices) -> None:
        self._books = books
        self._motion = motion
        self._devices = devices
        self._rules = books.plant.charging
        self._at: dict[Barcode, ChargerSpec] = {charger.barcode: charger for charger in books.plant.chargers}
        agvs = (vehicle.id for vehicle in books.vehicles.values() if vehicle.is_agv)
        self._batteries = {name: Battery(books.now) for name in agvs}

    def run(self) -> None:
        """Look at every AGV, once a second."""
        if not self._at:
            return
        for name, battery in self._batteries.items():
            vehicle = self._books.vehicles[name]
            self._note(vehicle, battery)
            if self._idle(vehicle) and not self._books.stilled(vehicle):
                self._mind(vehicle, battery)
        for barcode, charger in self._at.items():
            self._devices.charging(charger.id, self._user_of(barcode))

    def _user_of(self, charger: Barcode) -> VehicleId | None:
        """Return the AGV that charges at a charger, or is on its way there."""
        for name, battery in self._batteries.items():
            vehicle = self._books.vehicles[name]
            comes = vehicle.errand is not None and vehicle.errand.purpose is Purpose.CHARGE
            goal = vehicle.errand.goal if vehicle.errand and comes else None
            begins = any(intent.kind == "agv_charge" for intent in vehicle.opened.values())
            if goal == charger or (vehicle.barcode == charger and (begins or battery.begun is not None)):
                return name
        return None

    def _note(self, vehicle: VehicleNow, battery: Battery) -> None:
        """Follow by Status whether it charges, and how long it has to stay."""
        now, agv = self._books.now, vehicle.status.condition.agv if vehicle.status else None
        if agv is None or not vehicle.linked:
            return
        if agv.charging and battery.begun is None:
            battery.begun = now
        elif not agv.charging and battery.begun is not None:
            battery.since, battery.trips, battery.begun = now, vehicle.trips, None
        stays = battery.begun is not None and now < battery.begun + self._rules.lasting
        kept = (
            "it is charging"
            if stays
            else "it is due to charge"
            if self._due(vehicle, battery) and not agv.charging
            else ""
        )
        if kept != vehicle.kept and (stays or not kept or self._charger_for(vehicle) is not None):
            vehicle.kept = kept
            self._books.touch(vehicle)

    def _due(self, vehicle: VehicleNow, battery: Battery) -> bool:
        rules, trips = self._rules, vehicle.trips - battery.trips
        return (
            (rules.trips is not None and trips >= rules.trips)
            or (rules.after is not None and self._books.now >= battery.since + rules.after)
            or self._in_window()
        )

    def _in_window(self) -> bool:
        minute = int(self._books.utc // 60) % MINUTES
        return any(
            begin <= minute < end if begin <= end else minute >= begin or minute < end
            for begin, end in self._rules.windows
        )

    def _idle(self, vehicle: VehicleNow) -> bool:
        free = vehicle.job is None and vehicle.order is None and vehicle.at_rest
        empty = not vehicle.loaded and not vehicle.record.believed_loaded
        errand = vehicle.errand is None or vehicle.errand.purpose is Purpose.CHARGE
        return vehicle.fit and free and empty and errand and not vehicle.opened

    def _mind(self, vehicle: VehicleNow, battery: Battery) -> None:
        """Send an AGV that is due to a charger; at one, have it charge."""
        if battery.begun is not None or not self._due(vehicle, battery):
            return
        if self._open_at(vehicle.barcode) and vehicle.in_position:
            self._motion.drop(vehicle)
            self._charge(vehicle, battery)
            return
        charger = self._charger_for(vehicle)
        goal = vehicle.errand.goal if vehicle.errand else None
        if charger is None or self._open_at(goal):
            return
        try:
            self._motion.send(vehicle, Errand(charger.barcode, StopAction.STOP, Purpose.CHARGE))
        except NoRoute:
            return

    def _open_at(self, barcode: Barcode | None) -> bool:
        """Whether there is a charger that people have not closed."""
        charger = None if barcode is None else self._at.get(barcode)
        return charger is not None and not self._devices.all[charger.id].barred

    def _charge(self, vehicle: VehicleNow, battery: Battery) -> None:
        """Charge on, at the charger where it stands: the nearest is this one, so that it drives nowhere."""
        now = self._books.now
        if battery.asked is not None and now < battery.asked + AGAIN_AFTER:
            return
        battery.asked = now
        body = {"on": True, "charger": self._at[vehicle.barcode].id if vehicle.barcode else ""}
        self._books.open_intent(vehicle, "agv_charge", Direct(AgvCharge(on=True)), SYSTEM, body=body)

    def _charger_for(self, vehicle: VehicleNow) -> ChargerSpec | None:
        """Return the nearest charger in service that no other AGV charges at or is going to; None: there is none."""
        if vehicle.barcode is None:
            return None
        books = self._books
        taken = {v.errand.goal for v in books.vehicles.values() if v.errand and v.id != vehicle.id}
        taken |= {v.barcode for v in books.vehicles.values() if v.kept and v.id != vehicle.id and v.barcode}
        devices = self._devices.all
        free = [one for one in self._at.values() if one.barcode not in taken and not devices[one.id].barred]
        times = {charger.id: books.router.time(vehicle.barcode, charger.barcode) for charger in free}
        reached = [charger for charger in free if times[charger.id] < float("inf")]
        return min(reached, key=lambda charger: (times[charger.id], charger.id), default=None)
