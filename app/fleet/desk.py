"""Where requests of people and hosts arrive: each goes to who answers it, and into the audit."""

from dataclasses import fields
from datetime import UTC, datetime

from app.domain.alarms import AcknowledgeAlarm
from app.domain.closures import ClosePlace, OpenPlace
from app.domain.device_requests import RaiseEmergency, ReleaseEmergency
from app.domain.drive_requests import DriveOrder
from app.domain.requests import (
    AbortJob,
    Accepted,
    CancelJob,
    ChangeJob,
    CommandAgv,
    CommandVehicle,
    CreateJob,
    DisplayOnVehicle,
    HallRequest,
    HandleOnce,
    HoldVehicle,
    LockVehicle,
    MoveVehicle,
    ParkVehicle,
    PauseController,
    PauseZone,
    PlantRequest,
    RecoverAlarm,
    ReleaseVehicle,
    Reply,
    Request,
    ResumeController,
    ResumeZone,
    RoomRequest,
    SetService,
    StageVehicle,
    StopAll,
    UnlockVehicle,
    VehicleRequest,
    WriteCarrier,
    WriteDest,
    WriteOffset,
    WriteStation,
)
from app.domain.teaching_requests import TeachingRequest
from app.domain.walks import AbandonWalk, AcceptWalk, EnterSights, StartWalk
from app.domain.webhooks import WebhookRequest
from app.fleet.agv_orders import AgvOrders
from app.fleet.books import Books
from app.fleet.closures import Closures
from app.fleet.device_orders import DeviceOrders
from app.fleet.drives import Drives
from app.fleet.emergency import EmergencyDesk
from app.fleet.jobs import Jobs
from app.fleet.orders import VehicleOrders
from app.fleet.plant_orders import PlantOrders
from app.fleet.refusals import no_vehicle
from app.fleet.staging import Staging
from app.fleet.standstill import Standstills
from app.fleet.teaching_desk import TeachingDesk
from app.fleet.vehicle import VehicleNow
from app.fleet.walks import Walks
from app.fleet.webhooks import Webhooks

TARGETS = (
    "job",
    "vehicle",
    "station",
    "carrier",
    "drive",
    "line",
    "device",
    "proposal",
    "session",
    "side",
    "closure",
    "place",
    "zone",
    "alarm",
    "walk",
    "webhook",
    "url",
)
"""Parts of a request that name what it is about, the first that is there."""

UNSAID = frozenset({"actor", "fingerprint", "values", "known", "sights", "secret"})
"""Parts of a request that the audit does not repeat: who asked stands in a column of its own, values may be many."""

EMPTY: tuple[object, ...] = ("", (), frozenset())
"""What says nothing."""


class Desk:
    """Answers every request."""

    def __init__(
        self,
        books: Books,
        jobs: Jobs,
        vehicles: VehicleOrders,
        agvs: AgvOrders,
        plant: PlantOrders,
        drives: Drives,
        teaching: TeachingDesk,
        devices: DeviceOrders,
        emergency: EmergencyDesk,
        closures: Closures,
        standstills: Standstills,
        webhooks: Webhooks,
        walks: Walks,
        staging: Staging,
    ) -> None:
        self._books = books
        self._jobs = jobs
        self._vehicles = vehicles
        self._agvs = agvs
        self._plant = plant
        self._drives = drives
        self._teaching = teaching
        self._devices = devices
        self._emergency = emergency
        self._closures = closures
        self._standstills = standstills
        self._webhooks = webhooks
        self._walks = walks
        self._staging = staging

    def answer(self, request: Request) -> Reply:
        """Carry a request out or refuse it, and write down who asked for what."""
        reply = self._answer(request)
        audit, kind = self._books.audit, type(request).__name__
        if isinstance(reply, Accepted):
            audit(request.actor, kind, reply.key, _said(request), accepted=True)
            return reply
        named = (getattr(request, name, None) for name in TARGETS)
        target = next((str(name) for name in named if name), "")
        audit(request.actor, kind, target, f"refused: {reply.reason}", accepted=False)
        return reply

    def _answer(self, request: Request) -> Reply:
        if isinstance(request, CreateJob):  # what is asked most
            return self._jobs.create(request)
        if isinstance(request, VehicleRequest):
            return self._answer_about_vehicle(request)
        if isinstance(request, DriveOrder):
            return self._drives.answer(request)
        if isinstance(request, TeachingRequest):
            return self._teaching.answer(request)
        if isinstance(request, HallRequest):
            return self._answer_about_hall(request)
        if isinstance(request, RoomRequest):
            return self._answer_about_room(request)
        if isinstance(request, WebhookRequest):
            return self._webhooks.answer(request)
        return self._answer_about_plant(request)

    def _answer_about_room(self, request: RoomRequest) -> Reply:
        match request:
            case ClosePlace() | OpenPlace():
                return self._closures.answer(request)
            case AcknowledgeAlarm():
                return self._books.alarms.acknowledge(request)
            case StartWalk() | EnterSights() | AcceptWalk() | AbandonWalk():
                return self._walks.answer(request)
            case StageVehicle():
                return self._staging.stage(request)
            case ParkVehicle():
                return self._staging.park(request)
            case StopAll() | PauseZone() | ResumeZone():
                return self._standstills.answer(request)

    def _answer_about_plant(self, request: CancelJob | AbortJob | ChangeJob | PlantRequest) -> Reply:
        match request:
            case CancelJob():
                return self._jobs.cancel(request)
            case AbortJob():
                return self._jobs.abort(request)
            case ChangeJob():
                return self._jobs.change(request)
            case WriteStation():
                return self._plant.station(request)
            case WriteCarrier():
                return self._plant.carrier(request)
            case WriteDest():
                return self._plant.dest(request)
            case WriteOffset():
                return self._plant.offset(request)
            case PauseController():
                return self._plant.pause(request)
            case ResumeController():
                return self._plant.resume(request)

    def _answer_about_hall(self, request: HallRequest) -> Reply:
        if isinstance(request, RaiseEmergency | ReleaseEmergency):
            return self._emergency.answer(request)
        return self._devices.answer(request)

    def _answer_about_vehicle(self, request: VehicleRequest) -> Reply:
        vehicle, orders = self._books.vehicles.get(request.vehicle), self._vehicles
        if vehicle is None:
            return no_vehicle(request.vehicle)
        match request:
            case CommandVehicle() | CommandAgv() | DisplayOnVehicle() | MoveVehicle():
                return self._answer_by_kind(vehicle, request)
            case HandleOnce():
                return orders.handle(vehicle, request)
            case RecoverAlarm():
                return orders.recover(vehicle, request)
            case ReleaseVehicle():
                return orders.release(vehicle, request)
            case HoldVehicle():
                return orders.hold(vehicle, request)
            case SetService():
                return orders.service(vehicle, request)
            case LockVehicle():
                return orders.lock(vehicle, request)
            case UnlockVehicle():
                return orders.unlock(vehicle, request)

    def _answer_by_kind(
        self, vehicle: VehicleNow, request: CommandVehicle | CommandAgv | DisplayOnVehicle | MoveVehicle
    ) -> Reply:
        """Answer what hoists and AGVs are asked in different ways."""
        own = self._agvs if vehicle.is_agv else self._vehicles
        match request:
            case CommandVehicle():
                return own.command(vehicle, request)
            case CommandAgv():
                return self._agvs.direct(vehicle, request)
            case DisplayOnVehicle():
                return own.display(vehicle, request)
            case MoveVehicle():
                return own.move(vehicle, request)


def _said(request: Request) -> str:
    """Return what was asked for, for people: what was given, without who asked and how it was told from others."""
    if summary := getattr(request, "summary", ""):
        return str(summary)
    kind: type = type(request)
    names = _SAYABLE.get(kind)
    if names is None:
        names = _SAYABLE[kind] = tuple(f.name for f in fields(kind) if f.name not in UNSAID)
    return ", ".join(
        [
            f"{name} {_moment(value) if name == 'expires' else value}"
            for name in names
            if (value := getattr(request, name)) is not None and value not in EMPTY
        ]
    )


def _moment(value: float) -> str:
    """Return a moment in UTC as the API has it, to the second."""
    return datetime.fromtimestamp(value, UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


_SAYABLE: dict[type, tuple[str, ...]] = {}
"""The parts of each kind of request that the audit repeats, found once."""
