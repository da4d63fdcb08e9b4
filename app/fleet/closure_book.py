"""What is closed now, and for which reasons: for routes, for grants and for stations (DOMAIN section 7)."""

from collections import defaultdict
from collections.abc import Iterable
from itertools import pairwise

from app.domain.closures import Closure, ClosurePurpose, ClosureState
from app.domain.ids import StationId
from app.domain.layout import Station
from app.domain.records import ZonePause
from app.domain.units import Barcode
from app.fleet.closed import Closed, Reason
from app.fleet.vehicle import VehicleNow
from app.planning.track import Track
from app.planning.traffic import Traffic

Edge = tuple[Barcode, Barcode]


class ClosureBook:
    """The closures that are not over. A place that several concern opens with the last of them.

    Zones in which motion is paused count for grants only: vehicles wait before them, and where they are.

    Routes are kept from entering a closed place: who is inside still finds the way out. Grants into it are given to nobody but
    those inside; once people work there, to nobody at all.
    """

    def __init__(self, track: Track, closed: Closed, traffic: Traffic, kept: Iterable[Closure]) -> None:
        self._track = track
        self._closed = closed
        self._traffic = traffic
        self.live: dict[int, Closure] = {}
        self._at: defaultdict[Barcode, dict[int, Closure]] = defaultdict(dict)
        self._stations: defaultdict[str, dict[int, Closure]] = defaultdict(dict)
        self._edges: dict[Edge, dict[int, Closure]] = {}
        self._for_people: tuple[Closure, ...] = ()
        self._paused: dict[Barcode, str] = {}
        for closure in kept:
            self.put(closure)

    def put(self, closure: Closure) -> None:
        """Take a closure as it is now: new, changed or over."""
        if closure.state.over:
            self.live.pop(closure.number, None)
        else:
            self.live[closure.number] = closure
        self._index(closure)
        self._keep_off(closure)
        people = (c for c in self.live.values() if c.purpose is ClosurePurpose.WORK)
        self._for_people = tuple(c for c in people if c.state is ClosureState.CLOSED)

    def _index(self, closure: Closure) -> None:
        places: list[dict[int, Closure]] = [self._at[barcode] for barcode in closure.barcodes]
        if closure.edge:
            places.append(self._edges.setdefault(closure.edge, {}))
        if closure.station:
            places.append(self._stations[closure.station])
        for there in places:
            if closure.state.over:
                there.pop(closure.number, None)
            else:
                there[closure.number] = closure

    def _keep_off(self, closure: Closure) -> None:
        """Tell routes and grants."""
        ways: list[Edge] = [closure.edge] if closure.edge else list(self.entrances(closure.barcodes))
        self._closed.shut_only(Reason(closure.name, str(closure)), *([] if closure.state.over else ways))
        for barcode in closure.barcodes:
            self._regrant(barcode)

    def _regrant(self, barcode: Barcode) -> None:
        """Tell grants what keeps vehicles from a barcode now."""
        reasons, paused = self._at.get(barcode, {}).values(), self.paused_at(barcode)
        if reasons or paused:
            within = tuple(frozenset(c.barcodes) if self._drains(c) else frozenset() for c in reasons)
            words = "; ".join([*map(str, reasons), *([paused] if paused else [])])
            self._traffic.close([barcode], words, (*within, frozenset()) if paused else within)
        else:
            self._traffic.open([barcode])

    def still(self, pauses: Iterable[ZonePause]) -> None:
        """Take the zones in which nothing begins to move as they are now."""
        words = {pause.zone: str(pause) for pause in pauses}
        before, self._paused = self._paused, {}
        for zone in self._track.plant.zones:
            if zone.id in words:
                self._paused.update(dict.fromkeys(zone.barcodes, words[zone.id]))
        for barcode in dict.fromkeys((*before, *self._paused)):
            self._regrant(barcode)

    def paused_at(self, barcode: Barcode | None) -> str:
        """Return which pause a barcode lies in, as a clause; empty if in none."""
        return self._paused.get(barcode, "") if self._paused and barcode is not None else ""

    def entrances(self, barcodes: Iterable[Barcode]) -> Iterable[Edge]:
        """Give the edges that lead into a set of barcodes from outside."""
        inside = dict.fromkeys(b for b in barcodes if b in self._track)
        return ((before, b) for b in inside for before in self._track.predecessors(b) if before not in inside)

    @staticmethod
    def _drains(closure: Closure) -> bool:
        return closure.purpose is ClosurePurpose.TRAFFIC or closure.state is ClosureState.DRAINING

    # -- what is closed ---------------------------------------------------------------------------------------------------

    def edge(self, start: Barcode, end: Barcode) -> str:
        """Return why an edge is closed by itself, empty if it is not."""
        return _words(self._edges.get((start, end), {})) if self._edges else ""

    def at(self, barcode: Barcode) -> bool:
        """Return whether a barcode lies in a closed place."""
        return bool(self.live) and bool(self._at.get(barcode))

    def of(self, station: Station) -> tuple[Closure, ...]:
        """Return the closures that keep a station from use: its own, and those of the rail where it is served."""
        if not self.live:
            return ()
        return (*self._stations.get(station.id, {}).values(), *self._at.get(station.barcode, {}).values())

    def against(self, station: Station) -> str:
        """Return why a station is closed, as a clause; empty if it is not."""
        found = self.of(station)
        return f"{station.id} is {'; '.join(map(str, found))}" if found else ""

    def stations(self, closure: Closure) -> tuple[StationId, ...]:
        """Return the stations that a closure keeps from use."""
        if closure.station:
            return (StationId(closure.station),)
        inside = (barcode for barcode in closure.barcodes if barcode in self._track)
        return tuple(station.id for barcode in inside for station in self._track.stations_at(barcode))

    # -- who is inside ----------------------------------------------------------------------------------------------------

    def inside(self, closure: Closure, vehicles: Iterable[VehicleNow]) -> tuple[VehicleNow, ...]:
        """Return those of the vehicles that are inside, or may be."""
        if closure.barcodes:
            names = frozenset(self._traffic.inside(closure.barcodes))
            return tuple(vehicle for vehicle in vehicles if vehicle.id in names)
        return tuple(vehicle for vehicle in vehicles if self._is_on(vehicle, closure))

    def _is_on(self, vehicle: VehicleNow, closure: Closure) -> bool:
        if closure.station:
            at_it = vehicle.handling is not None and vehicle.handling.station == closure.station
            return at_it or any(intent.body.get("station") == closure.station for intent in vehicle.handlings)
        if edge := closure.edge:
            way = (*vehicle.way, *vehicle.ahead)
            return edge in pairwise(way) and (edge[1] in vehicle.trail or edge[1] in vehicle.ahead)
        return not frozenset(closure.barcodes).isdisjoint(self._traffic.held(vehicle.id))

    def barring(self, vehicle: VehicleNow) -> str:
        """Return why nothing may be sent to a vehicle: it is where people are at work; empty if it may."""
        found = next((c for c in self._for_people if not c.station and self._is_on(vehicle, c)), None)
        return f"{found.place} is {found}" if found else ""


def _words(closures: dict[int, Closure]) -> str:
    return "; ".join(map(str, closures.values()))
