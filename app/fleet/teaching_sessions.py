"""Teaching sessions: a named person, a port, a vehicle. The port is closed to jobs while it is open (DOMAIN section 3)."""

from dataclasses import replace

from app.domain.errors import Refusal
from app.domain.job import JobEvent, Leg
from app.domain.layout import StationKind, VehicleKind
from app.domain.requests import Accepted, CommandVehicle, Reply
from app.domain.teaching import ProposalState, SessionState, TeachingSession
from app.domain.teaching_requests import EndTeaching, OpenTeaching, StartTeaching
from app.domain.view import Topic
from app.fleet.books import Books
from app.fleet.missions import Missions
from app.fleet.orders import VehicleOrders
from app.fleet.refusals import no_station, no_vehicle
from app.fleet.teaching import SIDES, Teaching
from app.fleet.vehicle import HANDLINGS, VehicleNow


def no_session(number: int) -> Refusal:
    """Refusal for a session that is not open."""
    return Refusal("not-found", f"there is no open teaching session {number}", "see GET /api/v1/teaching/sessions")


class TeachingSessions:
    """Answers requests about sessions."""

    def __init__(self, books: Books, missions: Missions, orders: VehicleOrders, teaching: Teaching) -> None:
        self._books = books
        self._missions = missions
        self._orders = orders
        self._teaching = teaching

    def open(self, request: OpenTeaching) -> Reply:
        """Open a session: from now on no job uses the port, and the vehicle gets none."""
        books = self._books
        vehicle = books.vehicles.get(request.vehicle)
        if refusal := self._unsuited(request, vehicle) or self._engaged(request):
            return refusal
        if vehicle:
            self._missions.give_back(vehicle, f"{vehicle.id} is wanted for teaching {request.station}")
        session = TeachingSession(
            books.teaching.number("session"), request.station, request.vehicle, request.actor, books.utc, request.note
        )
        books.save_session(session)
        detail = f"session {session.number}: {session.actor} teaches {session.station} with {session.vehicle}"
        books.event(JobEvent.TEACHING_OPENED, vehicle=session.vehicle, destination=session.station, detail=detail)
        self._look_again()
        return Accepted(Topic.TEACHING, f"session-{session.number}", created=True)

    def _unsuited(self, request: OpenTeaching, vehicle: VehicleNow | None) -> Refusal | None:
        spec = self._books.specs.get(request.station)
        if spec is None:
            return replace(no_station(request.station), code="invalid", field="station")
        if spec.kind is not StationKind.PORT:
            return Refusal(
                "invalid", f"{spec.id} is no port: nothing is taught there", "name a station of kind port", "station"
            )
        if vehicle is None:
            return replace(no_vehicle(request.vehicle), code="invalid", field="vehicle")
        if vehicle.spec.kind is not VehicleKind.HOIST:
            return Refusal("invalid", f"{vehicle.id} is no hoist: it is not taught", "name a hoist", "vehicle")
        return None

    def _engaged(self, request: OpenTeaching) -> Refusal | None:
        """Return who uses the port or the vehicle now."""
        teaching = self._books.teaching
        other = teaching.closing(request.station) or teaching.session_of(request.vehicle)
        if other:
            return Refusal(
                "conflict",
                f"{other.actor} teaches {other.station} with {other.vehicle} in session {other.number}",
                f"close session {other.number} first",
            )
        for vehicle in self._books.vehicles.values():
            if any(i.kind in HANDLINGS and i.body.get("station") == request.station for i in vehicle.opened.values()):
                return Refusal(
                    "not-now", f"{vehicle.id} is handling a carrier at {request.station}", "wait for its end", "station"
                )
        used = self._books.vehicles[request.vehicle]
        job = self._books.job_of(used)
        if used.handling or used.order or (job and job.leg is not Leg.TO_SOURCE):
            what = f"is on job {job.id}" if job else "is handling a carrier"
            return Refusal("conflict", f"{used.id} {what}", "let it end, or choose another vehicle", "vehicle")
        return None

    def start(self, request: StartTeaching) -> Reply:
        """Send PORT DEST or PORT OFFSET TEACHING to a vehicle that stands at the port, in MANT."""
        session = self._books.teaching.sessions.get(request.session)
        if session is None:
            return no_session(request.session)
        vehicle = self._books.vehicles.get(session.vehicle)
        station = self._books.specs.get(session.station)
        if vehicle is None or station is None:
            return Refusal("not-now", "its port or vehicle is not in the plant any more", "close the session")
        command = CommandVehicle(request.actor, vehicle.id, request.side.command)
        if refusal := self._orders.unready(vehicle, request.side.command):
            return refusal
        if any(intent.kind in SIDES for intent in vehicle.opened.values()):
            return Refusal("not-now", f"{vehicle.id} is sending its positions already", "wait for its answer")
        status = vehicle.status
        here = status.barcode if status and status.condition.recognised else None
        if here != station.barcode:
            return Refusal(
                "not-now",
                f"{vehicle.id} stands at {here or 'no barcode that it reads'}, and {station.id} is at {station.barcode}",
                f"bring it to barcode {station.barcode}: in AUTO by the command move with action port, then send stop",
            )
        reply = self._orders.command(vehicle, command)
        if isinstance(reply, Accepted):
            return replace(reply, topic=Topic.TEACHING, key=f"session-{session.number}")
        return reply

    def end(self, request: EndTeaching) -> Reply:
        """Close a session: the port is open to jobs again. What it has taught waits for approval, unless it is abandoned."""
        books = self._books
        session = books.teaching.sessions.get(request.session)
        if session is None:
            return no_session(request.session)
        self._teaching.end_sets_of(session.number)
        if request.abandon:
            why = request.reason or f"session {session.number} was abandoned"
            for proposal in [p for p in books.teaching.proposals.values() if p.session == session.number]:
                self._teaching.close(proposal, ProposalState.REJECTED, request.actor, why)
        ended = replace(
            session,
            state=SessionState.ABANDONED if request.abandon else SessionState.CLOSED,
            ended=books.utc,
            ended_by=request.actor,
            reason=request.reason,
        )
        books.save_session(ended)
        detail = f"session {ended.number}: {ended.state.value} by {request.actor}. {request.reason}".rstrip(". ")
        books.event(JobEvent.TEACHING_ENDED, vehicle=ended.vehicle, destination=ended.station, detail=detail)
        self._look_again()
        return Accepted(Topic.TEACHING, f"session-{ended.number}")

    def _look_again(self) -> None:
        """What waits for the port, or was on the way there, thinks again."""
        for name in self._books.vehicles:
            self._books.wake(name)
