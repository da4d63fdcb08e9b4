"""Closing and opening places: nobody comes in, those inside drive out, then it is closed (DOMAIN sections 1 and 7)."""

from dataclasses import replace

from app.domain.closures import ClosePlace, Closure, ClosurePurpose, ClosureRequest, ClosureState, OpenPlace
from app.domain.errors import NoRoute, Refusal
from app.domain.ids import Actor
from app.domain.job import JobEvent
from app.domain.layout import StopAction
from app.domain.requests import Accepted, Reply
from app.domain.units import Barcode
from app.domain.view import Topic
from app.fleet.books import SYSTEM, Books
from app.fleet.closed_places import resolved
from app.fleet.courtesy import Courtesy
from app.fleet.motion import Motion
from app.fleet.vehicle import Errand, Purpose, VehicleNow


class Closures:
    """Answers who closes and opens places, and empties them."""

    def __init__(self, books: Books, motion: Motion, courtesy: Courtesy) -> None:
        self._books = books
        self._motion = motion
        self._courtesy = courtesy

    def answer(self, request: ClosureRequest) -> Reply:
        """Close a place or end a closure."""
        return self.close(request) if isinstance(request, ClosePlace) else self.open(request)

    def close(self, request: ClosePlace) -> Reply:
        """Close a place, besides whatever else it is closed for already."""
        books = self._books
        if refusal := self._bad_end(request):
            return refusal
        barcodes = resolved(books.track, request.place)
        if isinstance(barcodes, Refusal):
            return barcodes
        closure = Closure(
            books.new_closure(),
            request.place,
            barcodes,
            request.reason,
            request.actor,
            request.purpose,
            books.utc,
            request.expires,
        )
        books.event(JobEvent.PLACE_CLOSING, destination=closure.station, detail=f"{closure.place} is {closure}")
        self._changed(closure)
        self._empty(closure)
        return Accepted(Topic.CLOSURES, str(closure.number), created=True)

    def _bad_end(self, request: ClosePlace) -> Refusal | None:
        if request.expires is None:
            return None
        if request.purpose is ClosurePurpose.WORK:
            return Refusal(
                "invalid",
                "a closure for people's work never ends by itself",
                "leave expires out, and open it when everybody is out",
                "expires",
            )
        if request.expires <= self._books.utc:
            return Refusal("invalid", "expires lies in the past", "name a later moment, or leave it out", "expires")
        return None

    def open(self, request: OpenPlace) -> Reply:
        """End a closure: traffic by anybody, people's work by its owner or two others together."""
        books = self._books
        closure = books.closures.live.get(request.closure)
        if closure is None:
            return Refusal("not-found", f"there is no closure {request.closure} now", "see GET /api/v1/closures")
        wished = closure.wished_away_by(request.actor)
        if not wished.opened_by(request.actor):
            books.save_closure(wished)
            return Refusal(
                "not-now",
                f"{closure.name} is {closure.owner}'s, for people at work; your wish to open it is noted",
                f"{closure.owner} alone can open it, or one more person with you",
            )
        self._end(wished, ClosureState.OPENED, request.actor, request.reason)
        return Accepted(Topic.CLOSURES, str(closure.number))

    def _end(self, closure: Closure, state: ClosureState, actor: Actor, reason: str = "") -> None:
        books = self._books
        ended = replace(closure, state=state, ended=books.utc, ended_by=actor)
        why = f": {reason}" if reason else ""
        what = "has expired" if state is ClosureState.EXPIRED else f"is opened by {actor}{why}"
        detail = f"{closure.place} {what} ({closure.name})"
        books.event(JobEvent.PLACE_OPENED, destination=closure.station, detail=detail)
        self._changed(ended)

    def _changed(self, closure: Closure) -> None:
        """Keep a closure that begins or ends: jobs and vehicles look again."""
        books = self._books
        books.save_closure(closure)
        books.jobs_changed = True
        for vehicle in books.vehicles:
            books.wake(vehicle)

    # -- emptying ---------------------------------------------------------------------------------------------------------

    def tick(self) -> None:
        """See to expired closures, and to those that are not empty yet."""
        books = self._books
        for closure in list(books.closures.live.values()):
            if closure.expires is not None and closure.expires <= books.utc:
                self._end(closure, ClosureState.EXPIRED, SYSTEM)
            else:
                self._empty(closure)

    def _empty(self, closure: Closure) -> None:
        """Send who is inside out; once nobody is, the place is closed."""
        books = self._books
        inside = books.closures.inside(closure, books.vehicles.values())
        if not inside and closure.state is ClosureState.DRAINING:
            closure = replace(closure, state=ClosureState.CLOSED, closed=books.utc)
            books.event(JobEvent.PLACE_CLOSED, destination=closure.station, detail=f"{closure.place} is {closure}")
            books.save_closure(closure)
        off = frozenset((*closure.barcodes, *(closure.edge or ())))
        for vehicle in inside if off else ():
            if not books.closures.barring(vehicle):
                self._usher(vehicle, off)
        books.show_closure(closure, inside, tuple(self._courtesy.doing(vehicle.id) for vehicle in inside))

    def _usher(self, vehicle: VehicleNow, off: frozenset[Barcode]) -> None:
        """Send a vehicle that stands in a closed place with nothing to do there to the nearest place outside."""
        bound = vehicle.order or vehicle.errand or vehicle.kept or vehicle.teaching is not None
        if not vehicle.fit or not vehicle.at_rest or bound or not self._courtesy.stands_by(vehicle):
            return
        books, way = self._books, None
        if vehicle.is_agv:
            rests = books.track.may_rest
            way = self._motion.detours.free_way(
                vehicle, lambda b: b not in off and not books.closures.at(b) and rests(b)
            )
            goal = way[-1] if way else None
        else:
            goal = self._courtesy.nearest(vehicle, set(off))
        if goal is None:
            return
        try:
            self._motion.send(vehicle, Errand(goal, StopAction.STOP, Purpose.GIVE_WAY), way)
        except NoRoute:
            return
