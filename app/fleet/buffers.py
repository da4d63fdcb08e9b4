"""Buffers: locked while a vehicle serves them, and asked what stands there (DOMAIN section 2, S57).

A station's buffer is lent to the vehicle before its PICKUP or PLACE is made durable, and given back once that is settled. No
Status says whether a buffer is locked: the session's evidence (busy, then cart or no cart) is all there is, so after a silence
or a restart the lock counts as not known and is asked for again. A lock that is kept for nobody, because its vehicle was
taken off or has gone another way, is released.
"""

from collections.abc import Iterable
from dataclasses import replace

from app.domain.devices import BufferState, DeviceAct, DeviceEvent, DeviceId, DeviceKind, DeviceReported
from app.domain.ids import Actor, StationId, VehicleId
from app.domain.job import JobEvent, Leg
from app.domain.layout import Station
from app.domain.records import BufferLock, Provenance
from app.domain.units import Seconds
from app.fleet.books import SYSTEM, Books
from app.fleet.devices import DeviceNow, Devices
from app.fleet.vehicle import Stage, VehicleNow

PATIENCE = Seconds(10.0)
"""A buffer that is silent for so long counts as one that cannot be used: jobs wait or go on to a fall-back (our choice)."""


class Buffers:
    """Lends buffers to vehicles, and keeps what they report of their stations."""

    def __init__(self, books: Books, devices: Devices) -> None:
        self._books = books
        self._devices = devices
        self._stations: dict[DeviceId, StationId] = {s.buffer: s.id for s in books.plant.stations if s.buffer}
        self._at: dict[StationId, DeviceId] = {station: buffer for buffer, station in self._stations.items()}

    # -- what they say ------------------------------------------------------------------------------------------------

    def told(self, buffer: DeviceNow, event: DeviceEvent) -> None:
        """A buffer has said something new, or something became of a command to it."""
        if isinstance(event, DeviceReported) and isinstance(event.status, BufferState):
            self._sense(buffer, event.status)
        lock = buffer.record.lock
        if lock and not lock.person:
            self._books.wake(VehicleId(lock.owner))

    def _sense(self, buffer: DeviceNow, state: BufferState) -> None:
        """What it reports of its cart is known of its station, unless a vehicle is at work there."""
        station = self._stations.get(buffer.id)
        if station is None:
            return
        if state not in (BufferState.NO_CART, BufferState.CART):
            self._books.sensed.pop(station, None)
            return
        present = state is BufferState.CART
        self._books.sensed[station] = present
        lock, record = buffer.record.lock, self._books.stations[station]
        if (lock and not lock.person) or (record.present is present and record.provenance is Provenance.SENSOR):
            return
        self._books.save_station(replace(record, present=present, provenance=Provenance.SENSOR, at=self._books.utc))
        if record.present is not present:
            detail = f"{'occupied' if present else 'empty'}, reported by {buffer.id}"
            self._books.event(JobEvent.PORT_CHANGED, destination=station, carrier=record.carrier, detail=detail)

    # -- lending ------------------------------------------------------------------------------------------------------

    def lend(self, vehicle: VehicleNow, station: Station) -> str:
        """Lock a station's buffer for a vehicle. Returns why it waits for that, empty once the buffer is locked for it.

        A station without a buffer needs no lock. To be called again whenever the vehicle is woken.
        """
        buffer = self._devices.all.get(station.buffer) if station.buffer else None
        if buffer is None:
            return ""
        if trouble := self.trouble(buffer) or self._silent(buffer):
            return trouble
        lock = buffer.record.lock
        if lock and (lock.person or lock.owner != vehicle.id):
            return f"{buffer.id} is locked for {lock.owner}"
        if lock is None:
            self._devices.save(buffer, lock=BufferLock(vehicle.id, person=False, since=self._books.utc))
        self._mind(buffer)
        return "" if buffer.record.locked else f"{buffer.id} is being locked for {vehicle.id}"

    def give_back(self, vehicle: VehicleNow, station: StationId) -> None:
        """The vehicle is done at a station: its buffer is unlocked."""
        spec = self._books.specs.get(station)
        buffer = self._devices.all.get(spec.buffer) if spec and spec.buffer else None
        if buffer and buffer.record.lock and buffer.record.lock.owner == vehicle.id:
            self._devices.save(buffer, lock=None)
            self._mind(buffer)

    def trouble(self, buffer: DeviceNow) -> str:
        """Return why a buffer cannot be used for now, as an out-of-service station cannot; empty if it can."""
        if buffer.barred:
            return f"{buffer.id} is {buffer.barred}"
        if not buffer.fresh:
            return self._silent(buffer) if self._books.now - buffer.since >= PATIENCE else ""
        if buffer.state in (BufferState.ERROR, BufferState.UNKNOWN):
            return f"{buffer.id} reports {buffer.state.name.lower()}"
        return ""

    def _silent(self, buffer: DeviceNow) -> str:
        return "" if buffer.fresh and buffer.state is not None else f"{buffer.id} is silent: {buffer.reason}"

    # -- minding ------------------------------------------------------------------------------------------------------

    def concern(self, vehicles: Iterable[VehicleId]) -> None:
        """Note which buffers hang on what is different of these vehicles, or of stations."""
        for name in vehicles:
            for buffer in self._devices.locked_for.get(name, ()):
                self._devices.concern(buffer)
        stations, self._books.stations_changed = self._books.stations_changed, {}
        for station in stations:
            if station in self._at:
                self._devices.concern(self._at[station])

    def mind(self, devices: Iterable[DeviceNow]) -> None:
        """Release locks that are kept for nobody, ask for what is wanted, and say what contradicts our books."""
        for buffer in devices:
            if buffer.kind is not DeviceKind.BUFFER:
                continue
            station = self._stations.get(buffer.id)
            if station is not None:
                self._note(buffer, station)
            lock = buffer.record.lock
            if lock and not lock.person and not self._is_served(VehicleId(lock.owner), station):
                self._devices.save(buffer, lock=None)
            self._mind(buffer)

    def _mind(self, buffer: DeviceNow) -> None:
        """Ask for the lock, or for its end, if the one that is wanted is not known to be there."""
        lock = buffer.record.lock
        act = DeviceAct.LOCK if lock else DeviceAct.UNLOCK
        known = buffer.record.locked is (lock is not None)
        unfit = buffer.opened or buffer.state in (BufferState.ERROR, BufferState.UNKNOWN)
        if known or unfit or not self._devices.may_ask(buffer, act):
            return
        self._devices.ask(buffer, act, Actor(lock.owner) if lock and lock.person else SYSTEM)

    def _is_served(self, name: VehicleId, station: StationId | None) -> bool:
        """Whether a vehicle still needs the lock. One of which not all is known keeps it: it may be at work there."""
        vehicle = self._books.vehicles.get(name)
        if vehicle is None or vehicle.record.off_rail or station is None:
            return False
        if any(intent.body.get("station") == station for intent in vehicle.handlings):
            return True
        if vehicle.stage is not Stage.READY:
            return True
        if vehicle.order:
            return vehicle.order.station == station
        job = self._books.job_of(vehicle)
        if job is None:
            return False
        ends = {
            Leg.TO_SOURCE: job.source,
            Leg.ACQUIRING: job.source,
            Leg.TO_DESTINATION: job.destination,
            Leg.DEPOSITING: job.destination,
        }
        return ends.get(job.leg) == station

    def _note(self, buffer: DeviceNow, station: StationId) -> None:
        """Say what hosts, people and dispatch should know of the station by its buffer."""
        books = self._books
        trouble = self.trouble(buffer)
        if trouble:
            books.buffer_trouble[station] = trouble
        else:
            books.buffer_trouble.pop(station, None)
        if not buffer.fresh:
            books.sensed.pop(station, None)
        self._devices.say(buffer, None, self._contradiction(buffer, station))

    def _contradiction(self, buffer: DeviceNow, station: StationId) -> str:
        """Return what a buffer reports against our books while nobody is at work there; empty if they agree."""
        lock, record = buffer.record.lock, self._books.stations[station]
        sensed = self._books.sensed.get(station)
        if lock and not lock.person:
            return ""
        if buffer.busy or buffer.opened:
            return buffer.contradiction
        if sensed is None:
            return ""
        if not sensed and record.carrier:
            return f"reports no cart, but {record.carrier} is believed at {station}"
        if record.present is not None and record.present is not sensed:
            told = "that there is a cart" if record.present else "that there is none"
            return f"reports {'a' if sensed else 'no'} cart, but {record.provenance.value} says {told} at {station}"
        return ""
