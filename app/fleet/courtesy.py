"""Who waits for whom, why, and who gives way (DOMAIN section 5, TRAFFIC section 5)."""

from heapq import heappop, heappush

from app.domain.errors import NoRoute
from app.domain.ids import VehicleId
from app.domain.layout import StopAction
from app.domain.units import Barcode
from app.domain.vehicle import Oper
from app.fleet.books import Books
from app.fleet.motion import Motion
from app.fleet.rollcall import named
from app.fleet.vehicle import Errand, Purpose, Stage, VehicleNow
from app.planning.blocking import OF_BUFFERS, Blocked, BlockReason

PARK_BONUS = 20.0
"""A parking place may be so many seconds farther than the nearest other place (our choice)."""


class Courtesy:
    """Explains waits, and sends idle vehicles out of others' way."""

    def __init__(self, books: Books, motion: Motion) -> None:
        self._books = books
        self._motion = motion
        self._chargers = {charger.barcode for charger in books.plant.chargers}

    def explain(self, vehicle: VehicleNow, blocked: Blocked | None) -> None:
        """Say what a vehicle waits for, and ask who stands in its way idle to give way."""
        if blocked is None or blocked.why is BlockReason.NO_STOP:
            reason = self._barrier(vehicle)
        else:
            reason = self._sentence(vehicle, blocked)
            if blocked.by:
                self.ask_way(vehicle, self._books.vehicles[blocked.by])
                self._untie(vehicle)
        moving = vehicle.drive is not None
        if not moving and reason != vehicle.waiting:
            if not vehicle.waiting:
                vehicle.waiting_since = self._books.now
            vehicle.waiting = reason
            vehicle.waits_for = blocked.by if blocked else None
            self._books.touch(vehicle)

    def _barrier(self, vehicle: VehicleNow) -> str:
        """Return what keeps every vehicle, or all in its area, from moving; empty if nothing does."""
        if not vehicle.fit or self._motion.arrived(vehicle):
            return ""
        emergencies = self._books.controller.emergencies
        if emergencies:
            told = ", ".join(f"{e.kind.value}, told by {e.actor}" for e in emergencies)
            return f"{vehicle.id} waits at {vehicle.barcode}: {told}"
        if stilled := self._books.stilled(vehicle):
            return f"{vehicle.id} waits at {vehicle.barcode}: {stilled}"
        missing = named(self._motion.missing(vehicle))
        return f"{vehicle.id} waits at {vehicle.barcode}: the roll-call still misses {missing}" if missing else ""

    def _sentence(self, vehicle: VehicleNow, blocked: Blocked) -> str:
        what = {
            BlockReason.HELD: f"{blocked.at}",
            BlockReason.CONFLICT: f"{blocked.at}, which excludes track",
            BlockReason.ZONE: f"{blocked.at} in zone {blocked.zone}",
        }.get(blocked.why)
        if blocked.why is BlockReason.DOOR:
            return f"{vehicle.id} waits at {vehicle.barcode} for door {blocked.note}"
        if blocked.why in OF_BUFFERS:
            return f"{vehicle.id} waits at {vehicle.barcode}{self._of_queue(blocked)}"
        if what is None or blocked.by is None:
            return f"{vehicle.id} waits at {vehicle.barcode}: {blocked.at} is closed ({blocked.note})"
        return f"{vehicle.id} waits at {vehicle.barcode} for {what} held by {self.doing(blocked.by)}"

    def _of_queue(self, blocked: Blocked) -> str:
        """Return what keeps a vehicle from the queue that begins at a barcode, as the end of a sentence."""
        first = f"; first goes {self.doing(blocked.by)}" if blocked.by else ""
        if blocked.why is BlockReason.FULL:
            return f": no slot is free in the queue from {blocked.at} on{first}"
        if blocked.why is BlockReason.METER:
            return f": zone {blocked.zone} takes in no more for now"
        if blocked.why is BlockReason.TURN:
            return f": others have waited longer for the queue from {blocked.at} on{first}"
        return f": the last slot in the queue from {blocked.at} on could close a circle of full queues{first}"

    def doing(self, name: VehicleId) -> str:
        """Return a vehicle with what it is doing, as the end of a sentence."""
        other = self._books.vehicles[name]
        if other.handling:
            what = "picking up" if other.handling.pickup else "putting down"
            since = int(self._books.now - other.handling.started)
            return f"{name}, which is {what} at {other.handling.station} ({since} s)"
        states = (
            (other.barred, f"{name}, which is {other.barred}"),
            (other.teaching is not None, f"{name}, which is used for teaching (session {other.teaching})"),
            (other.stage is Stage.ABSENT, f"{name}, which is silent ({other.link_reason})"),
            (other.oper is Oper.ALARM, f"{name}, which has an alarm"),
            (other.stage is Stage.SETTLING, f"{name}, which is being asked where it is"),
            (other.drive, f"{name}, which is moving"),
            (other.waiting, f"{name}, which waits itself"),
        )
        return next((words for applies, words in states if applies), f"{name}, which is idle there")

    # -- giving way ---------------------------------------------------------------------------------------------------

    def ask_way(self, asker: VehicleNow, other: VehicleNow) -> None:
        """Send an idle vehicle that stands in the way to a place where it is in nobody's."""
        bound = other.order or other.errand or other.kept or other.teaching is not None
        if not other.fit or not other.at_rest or bound:
            return
        if not self.stands_by(other):
            return
        if other.is_agv:
            self._part(asker, other)
            return
        goal = self.refuge(asker, other)
        if goal is None:
            return
        try:
            self._motion.send(other, Errand(goal, StopAction.STOP, Purpose.GIVE_WAY))
        except NoRoute:
            return

    def _untie(self, vehicle: VehicleNow) -> None:
        """Where AGVs wait for each other in a circle, one that stands backs out to where it is in nobody's way.

        Its job goes on from there (TRAFFIC section 5). On two-way track no order of going can rule such circles out: two AGVs
        may want each other's place.
        """
        books = self._books
        if not vehicle.is_agv:
            return
        going = {name for name in books.traffic.blocked if books.vehicles[name].drive is not None}
        circle = next((c for c in books.traffic.cycles(going) if vehicle.id in c), ())
        tied = [books.vehicles[name] for name in circle]
        if any(v.errand and v.errand.purpose is Purpose.BACK_OUT for v in tied):
            return
        for index, other in enumerate(tied):
            waiter = tied[index - 1]
            if other.fit and other.at_rest and not other.ahead and self._let_agv(waiter, other, Purpose.BACK_OUT):
                return

    def _part(self, asker: VehicleNow, other: VehicleNow) -> None:
        """Send an idle AGV out of the way; where it is shut in by the one that asks, that one backs out first.

        One that was stopped between two tags first drives on to the next, which is its own; it is asked again from there.
        """
        if other.toward is not None:
            self._motion.send(other, Errand(other.toward, StopAction.STOP, Purpose.GIVE_WAY))
            self._books.wake(other.id)
            return
        if self._let_agv(asker, other, Purpose.GIVE_WAY) or asker.barcode is None or asker.ahead:
            return
        may_rest = self._books.track.may_rest
        # After a restart it may hold the mouth of a corridor ahead of it too, for want of knowing which way it stands.
        if asker.fit and asker.at_rest and not all(may_rest(b) for b in self._books.traffic.held(asker.id)):
            self._let_agv(other, asker, Purpose.BACK_OUT)

    def _wanted(self, asker: VehicleNow) -> set[Barcode]:
        """Return the track that has to be left for an AGV: its way, and all of the zone that it waits for."""
        wanted = {b for b in (asker.barcode, *asker.ahead, *asker.rest) if b is not None}
        blocked = self._books.traffic.blocked.get(asker.id)
        if blocked is not None and blocked.zone is not None:
            wanted |= {
                b for zone in self._books.track.zones_at(blocked.at) if zone.id == blocked.zone for b in zone.barcodes
            }
        return wanted

    def _let_agv(self, asker: VehicleNow, other: VehicleNow, purpose: Purpose) -> bool:
        """Send an AGV out of another's way over free track, to where it harms nobody's passage; else just out of the way."""
        books, length = self._books, other.spec.length
        if other.toward is not None:
            return False
        whole = self._wanted(asker)
        near = {b for b in (asker.barcode, *asker.ahead, *asker.rest[:1]) if b is not None}
        tries = ((whole, True), (whole, False), (near, True))
        for way, harmless in tries:

            def ends(place: Barcode, way: set[Barcode] = way, harmless: bool = harmless) -> bool:
                return (books.track.may_rest(place) or not harmless) and self._off(place, way, length, other)

            if found := self._motion.detours.free_way(other, ends):
                self._motion.send(other, Errand(found[-1], StopAction.STOP, purpose), found)
                books.wake(other.id)
                return True
        return False

    def stands_by(self, other: VehicleNow) -> bool:
        """Whether a vehicle has no job, or only waits for its destination, and may do so elsewhere."""
        job = self._books.job_of(other)
        return other.job is None or (job is not None and bool(job.reason))

    def refuge(self, asker: VehicleNow, other: VehicleNow) -> Barcode | None:
        """Return the nearest place off the asker's way, by driving time, preferring parking places; None: there is none.

        Where the asker's way takes in every place (it goes once round a loop), one off the first half of it, and so on: it
        will ask again from there.
        """
        way = [b for b in (asker.barcode, *asker.ahead, *asker.rest) if b is not None]
        while len(way) > 1:
            if found := self.nearest(other, set(way)):
                return found
            way = way[: len(way) // 2]
        return None

    def nearest(self, other: VehicleNow, way: set[Barcode]) -> Barcode | None:
        """Return the nearest place off this way, by driving time, preferring parking places; None: there is none."""
        books, length = self._books, other.spec.length
        start = other.barcode
        if start is None:
            return None
        best: Barcode | None = None
        bound = float("inf")
        queue: list[tuple[float, Barcode]] = [(0.0, start)]
        seen: set[Barcode] = set()
        while queue:
            time, here = heappop(queue)
            if here in seen:
                continue
            seen.add(here)
            if time > bound:
                break
            if here != start and self._free_of(here, way, length, other):
                if books.track.point(here).park:
                    return here
                if best is None:
                    best, bound = here, time + PARK_BONUS
            for ahead in books.track.successors(here):
                if ahead in books.closed or (here, ahead) in books.closed:
                    continue
                edge = books.track.edge(here, ahead)
                heappush(queue, (time + 100 * edge.length / (edge.speed * other.spec.max_speed), ahead))
        return best

    def _free_of(self, place: Barcode, way: set[Barcode], length: int, other: VehicleNow) -> bool:
        """Whether a vehicle standing there is off the way, off no-stop zones and on nobody's track."""
        return not self._books.track.no_stop(place) and self._off(place, way, length, other)

    def _off(self, place: Barcode, way: set[Barcode], length: int, other: VehicleNow) -> bool:
        """Whether a vehicle standing there is off the way, at no charger, and on nobody's track."""
        books = self._books
        covered = {place, *books.track.behind(place, other.spec.length)} if length else {place}
        if covered & way or place in self._chargers or books.closures.at(place):
            return False
        return not any(books.traffic.holders(b) - {other.id} for b in covered)
