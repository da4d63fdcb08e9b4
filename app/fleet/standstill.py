"""Stopping everything, and pausing or stopping a zone: vehicles keep AUTO, and go on when they are told to (DOMAIN section 7)."""

from dataclasses import replace

from app.domain.errors import Refusal
from app.domain.ids import ZoneId
from app.domain.job import JobEvent
from app.domain.layout import Zone
from app.domain.records import ControllerState, ZonePause
from app.domain.requests import Accepted, PauseZone, Reply, ResumeZone, StopAll
from app.domain.view import Topic
from app.fleet.alarms import Alarms
from app.fleet.books import Books
from app.fleet.halting import halt
from app.fleet.plant_orders import PlantOrders


class Standstills:
    """Answers who stops all, or pauses, stops and resumes a zone."""

    def __init__(self, books: Books, plant_orders: PlantOrders, alarms: Alarms) -> None:
        self._books = books
        self._plant_orders = plant_orders
        self._alarms = alarms

    def answer(self, request: StopAll | PauseZone | ResumeZone) -> Reply:
        """Stop everything, or still a zone, or let it go on."""
        match request:
            case StopAll():
                return self.stop_all(request)
            case PauseZone():
                return self.pause(request)
            case ResumeZone():
                return self.resume(request)

    def _accepted(self) -> Accepted:
        return Accepted(Topic.CONTROLLER, self._books.plant.name)

    def stop_all(self, request: StopAll) -> Reply:
        """Pause the controller and stop every vehicle that moves where it is. The same again stops again whatever moves."""
        books, why = self._books, f"{request.actor}: {request.reason}"
        if books.controller.state is ControllerState.AUTO:
            books.save_controller(replace(books.controller, state=ControllerState.PAUSING, reason=why))
            books.event(JobEvent.CONTROLLER_PAUSING, detail=f"everything is stopped by {why}")
        for vehicle in books.vehicles.values():
            self._alarms.break_off(vehicle, f"everything is stopped by {request.actor}")
            if vehicle.moves:
                halt(books, vehicle, request.actor, f"stop all: {request.reason}")
            books.wake(vehicle.id)
        self._plant_orders.note_rest()
        return self._accepted()

    def pause(self, request: PauseZone) -> Reply:
        """Let no vehicle begin to move in a zone or come into it; ``stop``: stop those that drive there, where they are."""
        books, zone = self._books, self._zone(request.zone)
        if zone is None:
            return self._none(request.zone)
        told = next((p for p in books.controller.pauses if p.zone == zone.id), None)
        if told is None or (request.stop and not told.stopped):
            pause = ZonePause(zone.id, request.actor, request.reason, books.utc, stopped=request.stop)
            others = tuple(p for p in books.controller.pauses if p.zone != zone.id)
            books.save_controller(replace(books.controller, pauses=(*others, pause)))
            books.event(JobEvent.ZONE_PAUSED, detail=str(pause))
        for name in books.traffic.inside(zone.barcodes):
            vehicle = books.vehicles[name]
            if request.stop and vehicle.moves:
                halt(books, vehicle, request.actor, f"zone {zone.id} is stopped: {request.reason}")
            books.wake(name)
        return self._accepted()

    def resume(self, request: ResumeZone) -> Reply:
        """Let vehicles go on in a zone."""
        books, zone = self._books, self._zone(request.zone)
        if zone is None:
            return self._none(request.zone)
        left = tuple(p for p in books.controller.pauses if p.zone != zone.id)
        if len(left) < len(books.controller.pauses):
            books.save_controller(replace(books.controller, pauses=left))
            books.event(JobEvent.ZONE_RESUMED, detail=f"zone {zone.id} goes on: {request.actor}")
            for vehicle in books.vehicles:
                books.wake(vehicle)
        return self._accepted()

    def _zone(self, name: ZoneId) -> Zone | None:
        return next((zone for zone in self._books.plant.zones if zone.id == name), None)

    def _none(self, name: ZoneId) -> Refusal:
        return Refusal("not-found", f"there is no zone {name}", "see GET /api/v1/zones")
