"""Requests about stations, carriers, taught values and the controller itself."""

from dataclasses import replace

from app.domain.errors import Refusal
from app.domain.ids import Actor, CarrierId, StationId, VehicleId
from app.domain.job import JobEvent
from app.domain.layout import StopAction
from app.domain.records import (
    ControllerState,
    Provenance,
    StationDest,
    StationRecord,
    VehicleOffset,
)
from app.domain.requests import (
    Accepted,
    PauseController,
    Reply,
    ResumeController,
    WriteCarrier,
    WriteDest,
    WriteOffset,
    WriteStation,
)
from app.domain.view import Topic
from app.fleet.books import Books
from app.fleet.refusals import no_station, no_vehicle
from app.fleet.teaching_desk import reference_refusal, stale
from app.fleet.vehicle import VehicleNow

SHORTER = "use a shorter id, as the vehicles' displays show it"
DISPLAY_BYTES = 16
"""FOUP ID, SOURCE and DESTINATION on the vehicle's display (PROTOCOLS 1.6)."""


def unfit_name(carrier: str) -> Refusal | None:
    """Refusal for a carrier's name that the vehicles' display cannot show (DOMAIN section 2)."""
    if len(carrier) <= DISPLAY_BYTES and carrier.isascii() and carrier.isprintable():
        return None
    return Refusal("invalid", f"carrier must be at most {DISPLAY_BYTES} printable ASCII characters", SHORTER, "carrier")


class PlantOrders:
    """Answers requests about stations, carriers, taught values and the controller."""

    def __init__(self, books: Books) -> None:
        self._books = books

    def station(self, request: WriteStation) -> Reply:
        """Write what is at a station: all or nothing."""
        books = self._books
        record = books.stations.get(request.station)
        if record is None:
            return no_station(request.station)
        carrier = record.carrier if request.carrier is None else CarrierId(request.carrier) or None
        present = self._present(request, record)
        if request.carrier and request.present is False:
            return Refusal(
                "invalid", "a carrier cannot be where nothing is present", "leave carrier or present out", "carrier"
            )
        if request.carrier and (refusal := unfit_name(request.carrier)):
            return refusal
        if request.forgotten or present is False:
            carrier = None
        provenance = Provenance.VERIFIED if request.walked else self._provenance(by_person=request.by_person)
        if record.carrier and carrier != record.carrier:
            self._lose(record, provenance)
        if carrier and carrier != record.carrier:
            self._leave_vehicle(carrier)
            books.put_carrier(carrier, request.station, provenance)
        seen = request.forgotten or request.present is not None or request.carrier is not None
        changed = replace(
            record,
            present=present,
            carrier=carrier,
            reserved=record.reserved if request.reserved is None else request.reserved,
            out_of_service=record.out_of_service if request.out_of_service is None else request.out_of_service,
            provenance=provenance if seen else record.provenance,
            at=books.utc if seen else record.at,
        )
        books.save_station(changed)
        books.event(JobEvent.PORT_CHANGED, destination=request.station, carrier=carrier, detail=self._words(changed))
        return Accepted(Topic.STATIONS, request.station)

    @staticmethod
    def _present(request: WriteStation, record: StationRecord) -> bool | None:
        if request.forgotten or request.present is not None:
            return request.present
        return True if request.carrier else record.present

    def _provenance(self, *, by_person: bool) -> Provenance:
        return Provenance.PERSON if by_person else Provenance.HOST

    def _lose(self, record: StationRecord, provenance: Provenance) -> None:
        """The carrier we believed there is not there: where it is, we do not know."""
        if record.carrier and self._books.carriers.get(record.carrier):
            self._books.put_carrier(record.carrier, None, provenance)

    def _words(self, record: StationRecord) -> str:
        known = {True: "occupied", False: "empty", None: "not known"}[record.present]
        more = [f"reserved: {record.reserved}"] if record.reserved else []
        more += [f"out of service: {record.out_of_service}"] if record.out_of_service else []
        return ", ".join([known, *more])

    def carrier(self, request: WriteCarrier) -> Reply:
        """Install, move or remove a carrier's record."""
        books = self._books
        before = books.carriers.get(request.carrier)
        if request.place is None:
            return self._remove(request)
        if refusal := unfit_name(request.carrier):
            return refusal
        if request.place in books.vehicles:
            return self._carrier_aboard(request, books.vehicles[VehicleId(request.place)])
        if request.place not in books.specs:
            return Refusal(
                "invalid", f"there is no station or vehicle {request.place}", "see GET /api/v1/stations", "place"
            )
        there = books.stations[StationId(request.place)]
        if there.carrier and there.carrier != request.carrier:
            return Refusal(
                "conflict", f"{request.place} holds {there.carrier}", f"move or remove {there.carrier} first", "place"
            )
        self._leave_vehicle(request.carrier)
        books.put_carrier(request.carrier, StationId(request.place), self._provenance(by_person=request.by_person))
        books.event(JobEvent.CARRIER_MOVED, carrier=request.carrier, destination=request.place)
        return Accepted(Topic.CARRIERS, request.carrier, created=before is None)

    def _carrier_aboard(self, request: WriteCarrier, vehicle: VehicleNow) -> Reply:
        if vehicle.record.carrier and vehicle.record.carrier != request.carrier:
            carried = vehicle.record.carrier
            return Refusal("conflict", f"{vehicle.id} carries {carried}", f"move or remove {carried} first", "place")
        if vehicle.linked and vehicle.loaded is False:
            return Refusal(
                "conflict",
                f"{vehicle.id} says that nothing is aboard ({vehicle.burden} bit 0)",
                "look where the carrier is, and name that place",
                "place",
            )
        if vehicle.record.carrier != request.carrier:
            self._leave_vehicle(request.carrier)
        created = request.carrier not in self._books.carriers
        self._books.put_carrier(request.carrier, vehicle.id, self._provenance(by_person=request.by_person))
        self._books.save_vehicle(vehicle, carrier=request.carrier)
        self._books.event(JobEvent.CARRIER_MOVED, carrier=request.carrier, vehicle=vehicle.id, destination=vehicle.id)
        return Accepted(Topic.CARRIERS, request.carrier, created=created)

    def _leave_vehicle(self, carrier: CarrierId) -> None:
        for vehicle in self._books.vehicles.values():
            if vehicle.record.carrier == carrier:
                self._books.save_vehicle(vehicle, carrier=None)

    def _remove(self, request: WriteCarrier) -> Reply:
        books = self._books
        if request.carrier not in books.carriers:
            return Refusal("not-found", f"there is no carrier {request.carrier}", "see GET /api/v1/carriers")
        busy = next((job for job in books.jobs.values() if job.carrier == request.carrier), None)
        if busy:
            return Refusal(
                "conflict", f"{request.carrier} is ordered by job {busy.id}", "cancel or abort the job first"
            )
        self._leave_vehicle(request.carrier)
        books.put_carrier(request.carrier, None, self._provenance(by_person=request.by_person))
        books.drop_carrier(request.carrier)
        books.event(JobEvent.CARRIER_MOVED, carrier=request.carrier, detail="removed from the plant")
        return Accepted(Topic.CARRIERS, request.carrier)

    # -- taught values ------------------------------------------------------------------------------------------------

    def dest(self, request: WriteDest) -> Reply:
        """A new version of a station's DEST."""
        spec = self._books.specs.get(request.station)
        if spec is None:
            return no_station(request.station)
        if spec.kind.stop_action is not StopAction.PORT:
            return Refusal(
                "invalid",
                f"{spec.id} is a side buffer: vehicles know its positions themselves",
                "only ports have a DEST",
                "station",
            )
        now = self._books.dests.get(request.station)
        version = now.version if now else 0
        if refusal := stale(request.expected, version):
            return refusal
        self._books.keep_dest(
            StationDest(request.station, version + 1, request.pulses, request.actor, "rest", self._books.utc)
        )
        return Accepted(Topic.STATIONS, request.station, created=version == 0)

    def offset(self, request: WriteOffset) -> Reply:
        """A new version of a vehicle's OFFSET."""
        if request.vehicle not in self._books.vehicles:
            return no_vehicle(request.vehicle)
        if self._books.teaching.is_reference(request.vehicle):
            return reference_refusal(request.vehicle)
        now = self._books.offsets.get(request.vehicle)
        version = now.version if now else 0
        if refusal := stale(request.expected, version):
            return refusal
        self._books.keep_offset(
            VehicleOffset(request.vehicle, version + 1, request.pulses, request.actor, "rest", self._books.utc)
        )
        return Accepted(Topic.VEHICLES, request.vehicle, created=version == 0)

    # -- the controller -----------------------------------------------------------------------------------------------

    def pause(self, request: PauseController) -> Reply:
        """No new movement; paused once everything stands."""
        if self._books.controller.state is ControllerState.AUTO:
            why, now = f"{request.actor}: {request.reason}", self._books.controller
            self._books.save_controller(replace(now, state=ControllerState.PAUSING, reason=why))
            self._books.event(JobEvent.CONTROLLER_PAUSING, detail=why)
            self.note_rest()
        return Accepted(Topic.CONTROLLER, self._books.plant.name)

    def note_rest(self) -> None:
        """Pausing becomes paused when no motion or handling of ours is under way."""
        books = self._books
        if books.controller.state is ControllerState.PAUSING and all(v.at_rest for v in books.vehicles.values()):
            books.save_controller(replace(books.controller, state=ControllerState.PAUSED))
            books.event(JobEvent.CONTROLLER_PAUSED)

    def resume(self, request: ResumeController) -> Reply:
        """Go on; not before every emergency is released."""
        if emergencies := self._books.controller.emergencies:
            told = ", ".join(f"{e.kind.value} told by {e.actor}: {e.reason}" for e in emergencies)
            return Refusal("not-now", told, "release it first: POST /api/v1/controller/emergency/release")
        if self._books.controller.state is not ControllerState.AUTO:
            self._books.save_controller(replace(self._books.controller, state=ControllerState.AUTO, reason=""))
            self._books.event(JobEvent.CONTROLLER_AUTO, detail=str(Actor(request.actor)))
            for vehicle in self._books.vehicles:
                self._books.wake(vehicle)
        return Accepted(Topic.CONTROLLER, self._books.plant.name)
