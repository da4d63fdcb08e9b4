"""The stations that nobody can reach any more because of what is closed: named in an alarm for each cause, and in the view."""

from collections import defaultdict
from collections.abc import Iterator
from itertools import islice

from app.domain.alarms import AlarmKind
from app.domain.ids import StationId
from app.domain.job import JobEvent
from app.domain.layout import Station
from app.domain.units import Barcode, Seconds
from app.fleet.books import Books
from app.fleet.breakdowns import Breakdowns
from app.fleet.vehicle import VehicleNow

LOOK_EVERY = Seconds(5.0)
"""While anything is closed: vehicles may drive out of a piece that is cut off, or into it (our choice)."""
LOOKED_AT_ONCE = 400
"""So many stations are looked at before others may do something (our choice: about 1 ms)."""
NAMED = 12
"""So many stations are named in one alarm; the others are counted (our choice)."""
CODE = "cut-off"
REMEDY = "move away what stands there, or open what is closed; jobs to there wait, and go on then"


class CutOff:
    """Keeps ``books.traffic_state.cut_off`` true."""

    def __init__(self, books: Books, breakdowns: Breakdowns) -> None:
        self._books = books
        self._breakdowns = breakdowns
        self._seen = books.closed.version
        self._next_look = books.now
        self._looking: Iterator[None] | None = None
        self._alarms: dict[str, StationId] = {}
        """By cause: the station that its alarm is about, the first that was cut off for it."""

    @property
    def pending(self) -> bool:
        """Whether ``go_on`` has something to do."""
        return self._looking is not None

    def look(self) -> None:
        """Have it looked which stations can be reached, if that can be otherwise than it was."""
        books = self._books
        changed = books.closed.version != self._seen
        if not changed and (not len(books.closed) or books.now < self._next_look):
            return
        self._seen, self._next_look = books.closed.version, Seconds(books.now + LOOK_EVERY)
        self._looking = self._look()

    def go_on(self) -> None:
        """Look at some more stations; at the end, tell."""
        if self._looking is not None and next(self._looking, self) is self:
            self._looking = None

    def _look(self) -> Iterator[None]:
        """Find the stations that cannot be reached by anybody for what is closed, and why; give after each slice."""
        books = self._books
        starts = [at for vehicle in books.vehicles.values() if (at := self._sets_out_from(vehicle)) is not None]
        areas = {books.track.area(start) for start in starts}
        now, before, found = books.router.reach(starts), books.traffic_state.cut_off, dict[StationId, str]()
        lost: list[Station] = []
        stations = iter(books.specs.values() if len(books.closed) else ())
        while some := list(islice(stations, LOOKED_AT_ONCE)):
            yield
            for station in (s for s in some if s.barcode in books.track):
                if books.track.area(station.barcode) not in areas:  # nobody is heard there: it stays as it was told
                    if why := before.get(station.id):
                        found[station.id] = why
                elif not now.leads_to(station.barcode):
                    lost.append(station)
        if lost:
            yield
            ever = books.router.reach(starts, anyway=True)
            found |= {s.id: books.no_way.cause(s.barcode) for s in lost if ever.leads_to(s.barcode)}
        self._note(found)

    def _note(self, now: dict[StationId, str]) -> None:
        books = self._books
        before = books.traffic_state.cut_off
        if now == before:
            return
        books.traffic_state.cut_off = now
        books.jobs_changed = True
        self._warn(now)
        self._tell({name: why for name, why in now.items() if name not in before}, JobEvent.ALARM_SET)
        self._tell({name: why for name, why in before.items() if name not in now}, JobEvent.ALARM_CLEARED)

    def _sets_out_from(self, vehicle: VehicleNow) -> Barcode | None:
        """Return where a vehicle that can go on can turn to another goal; None: it cannot go on, or is nobody knows where."""
        at = vehicle.ahead[-1] if vehicle.ahead else vehicle.barcode
        broken = vehicle.id in self._breakdowns or vehicle.barred or not vehicle.linked
        return None if broken or at not in self._books.track else at

    def _warn(self, now: dict[StationId, str]) -> None:
        """Keep one alarm for each cause, with the stations that are cut off for it now."""
        alarms, causes = self._books.alarms, _by_cause(now)
        for why in [why for why in self._alarms if why not in causes]:
            alarms.end_one(AlarmKind.TRAFFIC, self._alarms.pop(why), CODE, "they can be reached again")
        for why, names in causes.items():
            if why not in self._alarms:
                taken = set(self._alarms.values())
                self._alarms[why] = next((name for name in names if name not in taken), names[0])
            alarms.begin(AlarmKind.TRAFFIC, self._alarms[why], CODE, f"{_list(names)} cannot be reached: {why}", REMEDY)

    def _tell(self, stations: dict[StationId, str], name: JobEvent) -> None:
        """Tell of stations that are cut off now, or no more: together where the cause is the same."""
        over = name is JobEvent.ALARM_CLEARED
        for why, names in _by_cause(stations).items():
            detail = f"{_list(names)} can be reached again" if over else f"{_list(names)} cannot be reached: {why}"
            self._books.event(name, source=names[0], detail=detail)


def _by_cause(stations: dict[StationId, str]) -> dict[str, list[StationId]]:
    by_cause: defaultdict[str, list[StationId]] = defaultdict(list)
    for station, why in stations.items():
        by_cause[why].append(station)
    return by_cause


def _list(names: list[StationId]) -> str:
    """Return so many stations in words."""
    more = f" and {len(names) - NAMED} more" if len(names) > NAMED else ""
    return f"{', '.join(names[:NAMED])}{more}"
