"""Audit walks after an outage: what is believed, what was seen, and how the one becomes the other (DOMAIN section 2)."""

from dataclasses import replace

from app.domain.errors import Refusal
from app.domain.ids import CarrierId, StationId
from app.domain.job import JobEvent
from app.domain.layout import StationKind
from app.domain.requests import Accepted, Reply, WriteStation
from app.domain.view import Topic
from app.domain.walks import (
    AbandonWalk,
    AcceptWalk,
    EnterSights,
    Finding,
    Sight,
    StartWalk,
    Walk,
    WalkPlace,
    WalkRequest,
    WalkState,
)
from app.fleet.books import Books
from app.fleet.plant_orders import PlantOrders, unfit_name
from app.fleet.rollcall import NAMED

SIDE_BUFFERS = frozenset({StationKind.SBFL, StationKind.SBFR})


class Walks:
    """Answers who walks."""

    def __init__(self, books: Books, plant_orders: PlantOrders) -> None:
        self._books = books
        self._plant_orders = plant_orders

    def answer(self, request: WalkRequest) -> Reply:
        """Carry a request out, or say why not."""
        match request:
            case StartWalk():
                return self.start(request)
            case EnterSights():
                return self.enter(request)
            case AcceptWalk():
                return self.accept(request)
            case AbandonWalk():
                return self.abandon(request)

    def start(self, request: StartWalk) -> Reply:
        """Begin a walk: what is believed of its places is written down."""
        books = self._books
        sides = (spec.id for spec in books.plant.stations if spec.kind in SIDE_BUFFERS)
        stations = tuple(dict.fromkeys(request.stations or sides))
        if not stations:
            return Refusal("invalid", "the plant has no side buffer", "name the stations to walk along", "stations")
        for name in stations:
            if name not in books.specs:
                return Refusal("invalid", f"there is no station {name}", "see GET /api/v1/stations", "stations")
            if (other := books.walk_at(name)) is not None:
                return Refusal("conflict", f"walk {other.number} of {other.actor} is at {name}", "let it end first")
        walk = Walk(books.new_walk(), request.actor, request.reason, books.utc)
        for name in stations:
            record = books.stations[name]
            books.save_walk_place(WalkPlace(walk.number, name, record.present, record.carrier))
        books.save_walk(walk)
        books.event(JobEvent.WALK_STARTED, detail=f"walk {walk.number} of {request.actor}: {request.reason}")
        return Accepted(Topic.WALKS, str(walk.number), created=True)

    def _open(self, number: int) -> Walk | Refusal:
        walk = self._books.walks.get(number)
        return walk or Refusal("not-found", f"there is no open walk {number}", "see GET /api/v1/walks")

    def enter(self, request: EnterSights) -> Reply:
        """Write down what was seen, if all of it can be."""
        books, walk = self._books, self._open(request.walk)
        if isinstance(walk, Refusal):
            return walk
        places = books.walk_places[walk.number]
        for sight in request.sights:
            if refusal := self._bad(sight, walk):
                return refusal
        for sight in request.sights:
            carrier = sight.carrier if sight.present else None
            seen = replace(
                places[sight.station], seen=sight.present, seen_carrier=carrier, by=request.actor, at=books.utc
            )
            books.save_walk_place(seen)
        books.show_walk(walk)
        return Accepted(Topic.WALKS, str(walk.number))

    def _bad(self, sight: Sight, walk: Walk) -> Refusal | None:
        if sight.station not in self._books.walk_places[walk.number]:
            return Refusal(
                "invalid", f"{sight.station} is not on walk {walk.number}", "begin a walk along it", "station"
            )
        if sight.carrier and not sight.present:
            reason = f"{sight.carrier} cannot be at {sight.station} while nothing is present there"
            return Refusal("invalid", reason, "leave carrier out, or say that something is present", "carrier")
        return unfit_name(sight.carrier) if sight.carrier else None

    def accept(self, request: AcceptWalk) -> Reply:
        """Believe what was seen: places seen empty first, so that a carrier found elsewhere is nowhere twice."""
        books, walk = self._books, self._open(request.walk)
        if isinstance(walk, Refusal):
            return walk
        places = books.walk_places[walk.number]
        findings = {place: self.finding(place) for place in places.values()}
        seen = [place for place, found in findings.items() if found in {Finding.AGREES, Finding.DIFFERS}]
        if not seen:
            entered = any(place.seen is not None for place in places.values())
            reason = "all that was entered has changed since" if entered else "nothing was entered"
            return Refusal("conflict", reason, "look again and enter it, or abandon the walk")
        open_ = [p.station for p, found in findings.items() if found in {Finding.NOT_SEEN, Finding.MOVED}]
        if open_ and not request.partial:
            more = f" and {len(open_) - NAMED} more" if len(open_) > NAMED else ""
            return Refusal(
                "conflict",
                f"not seen, or changed since: {', '.join(open_[:NAMED])}{more}",
                'look there and enter it, or send {"partial": true}',
                "partial",
            )
        if twice := self._seen_twice(findings):
            return Refusal("conflict", f"{twice} was seen at two places", "look again, and enter what is right")
        for place in sorted(seen, key=lambda place: bool(place.seen)):
            carrier = place.seen_carrier if place.seen else None
            self._plant_orders.station(
                WriteStation(request.actor, place.station, place.seen, carrier, by_person=True, walked=True)
            )
            books.save_walk_place(replace(place, accepted=findings[place]))
        differ = sum(found is Finding.DIFFERS for found in findings.values())
        self._end(walk, WalkState.ACCEPTED, request, f"{len(seen)} places verified, {differ} of them were wrong")
        return Accepted(Topic.WALKS, str(walk.number))

    def _seen_twice(self, findings: dict[WalkPlace, Finding]) -> CarrierId | None:
        """Return a carrier that was entered at two places."""
        seen: set[CarrierId] = set()
        for place in findings:
            if place.seen_carrier in seen:
                return place.seen_carrier
            if place.seen_carrier:
                seen.add(place.seen_carrier)
        return None

    def abandon(self, request: AbandonWalk) -> Reply:
        """End a walk without believing it."""
        walk = self._open(request.walk)
        if isinstance(walk, Refusal):
            return walk
        self._end(walk, WalkState.ABANDONED, request, request.reason)
        return Accepted(Topic.WALKS, str(walk.number))

    def _end(self, walk: Walk, state: WalkState, request: AcceptWalk | AbandonWalk, detail: str) -> None:
        books = self._books
        books.save_walk(replace(walk, state=state, ended=books.utc, ended_by=request.actor))
        books.event(JobEvent.WALK_ENDED, detail=f"walk {walk.number} is {state.value} by {request.actor}: {detail}")

    def finding(self, place: WalkPlace) -> Finding:
        """Return what an entry says against the books."""
        record = self._books.stations[StationId(place.station)]
        return place.finding(record.present, record.carrier, record.at)
