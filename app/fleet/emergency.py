"""Fire and earthquake: everything stops until a named person says that it is over (DOMAIN section 7).

While one is told, no grant is given and nothing new is sent; what drives is stopped where it is (STOP BY HOST, AGV Stop, a
drive's Stop/Reset), what handles ends; doors open or close as the plant file says, and never on a vehicle (``Doors``). It
outlives restarts. After the last one is released the controller is paused: to resume is a decision of its own.
"""

from dataclasses import replace

from app.domain.alarms import AlarmKind
from app.domain.device_requests import RaiseEmergency, ReleaseEmergency
from app.domain.errors import Refusal
from app.domain.job import JobEvent
from app.domain.records import ControllerState, Emergency
from app.domain.requests import Accepted, Reply
from app.domain.view import Topic
from app.fleet.alarms import Alarms
from app.fleet.books import Books
from app.fleet.drives import Drives
from app.fleet.halting import halt
from app.fleet.plant_orders import PlantOrders


class EmergencyDesk:
    """Answers who tells an emergency, and who releases it."""

    def __init__(self, books: Books, plant_orders: PlantOrders, alarms: Alarms, drives: Drives) -> None:
        self._books = books
        self._plant_orders = plant_orders
        self._alarms = alarms
        self._drives = drives

    def answer(self, request: RaiseEmergency | ReleaseEmergency) -> Reply:
        """Tell an emergency, or release it."""
        return self.begin(request) if isinstance(request, RaiseEmergency) else self.release(request)

    def begin(self, request: RaiseEmergency) -> Reply:
        """Stop everything. The same again is accepted and stops again whatever moves."""
        books, controller = self._books, self._books.controller
        told = next((e for e in controller.emergencies if e.kind is request.kind), None)
        if told is None:
            emergency = Emergency(request.kind, request.actor, request.reason, books.utc)
            state = ControllerState.PAUSED if controller.state is ControllerState.PAUSED else ControllerState.PAUSING
            reason = f"{request.kind.value}: {request.reason} ({request.actor})"
            changed = replace(controller, state=state, reason=reason, emergencies=(*controller.emergencies, emergency))
            books.save_controller(changed)
            books.event(JobEvent.EMERGENCY_SET, detail=reason)
            remedy = "when it is over: POST /api/v1/controller/emergency/release"
            books.alarms.begin(AlarmKind.PLANT, books.plant.name, request.kind.value, reason, remedy)
        for vehicle in books.vehicles.values():
            self._alarms.break_off(vehicle, request.kind.value)
            if vehicle.moves:
                halt(books, vehicle, request.actor, f"{request.kind.value}: {request.reason}")
            books.wake(vehicle.id)
        self._drives.halt(request.actor, request.kind.value)
        self._plant_orders.note_rest()
        return Accepted(Topic.CONTROLLER, books.plant.name)

    def release(self, request: ReleaseEmergency) -> Reply:
        """A named person says that it is over."""
        books, controller = self._books, self._books.controller
        left = tuple(e for e in controller.emergencies if e.kind is not request.kind)
        if len(left) == len(controller.emergencies):
            return Refusal("conflict", f"no {request.kind.value} is told", "see GET /api/v1/controller", "kind")
        over = f"{request.kind.value} is over: {request.reason} ({request.actor})"
        reason = controller.reason if left else f"{over}; resume when everything is in order"
        books.save_controller(replace(controller, emergencies=left, reason=reason))
        books.event(JobEvent.EMERGENCY_RELEASED, detail=over)
        books.alarms.end_one(AlarmKind.PLANT, books.plant.name, request.kind.value, over)
        for vehicle in books.vehicles:
            books.wake(vehicle)
        return Accepted(Topic.CONTROLLER, books.plant.name)
