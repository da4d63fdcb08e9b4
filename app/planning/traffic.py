"""Who may move where: each barcode belongs to one vehicle at a time, and every wait has a reason."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from itertools import count
from types import MappingProxyType
from typing import TypeAlias

from app.domain.ids import VehicleId, ZoneId
from app.domain.layout import Zone
from app.domain.units import Barcode, Seconds
from app.planning.admission import ANY
from app.planning.blocking import OF_BUFFERS, Blocked, BlockReason, Grant, TrafficView
from app.planning.deadlock import Needs, deadlocks
from app.planning.queues import Queues
from app.planning.track import Track

NEVER = Seconds(0.0)
NOWHERE: frozenset[ZoneId] = frozenset()
Way: TypeAlias = tuple[Sequence[Barcode], Sequence[Barcode], int]
"""What is wanted, the way that it is part of or that comes after it, and at which index of this the rest begins."""


class Traffic:
    """Exclusive ownership of barcodes.

    What a vehicle holds is a set: a barcode taken twice is given back by one ``release``. Sets given back go round in
    an order that is the same in every run. A barcode that is not on the track may be held too; nothing conflicts with it.

    With ``admission`` a grant into a buffer of one-way track takes a slot of it by the rule of ``planning.admission``, and
    ends only where a vehicle can wait. ``queues`` are the lines in these buffers, None without.
    """

    def __init__(self, track: Track, *, admission: bool = False) -> None:
        self._track = track
        self.queues = Queues(track) if admission else None
        near = ((b, tuple(sorted(track.conflicts(b)))) for b in track.barcodes)
        self._near = {barcode: others for barcode, others in near if others}
        self._zones = {b: zones for b in track.barcodes if (zones := track.zones_at(b))}
        self._plain = frozenset(b for b in track.barcodes if b not in self._near and b not in self._zones)
        stops = ((b, frozenset(zone.id for zone in zones if zone.no_stop)) for b, zones in self._zones.items())
        self._no_stop = {barcode: zones for barcode, zones in stops if zones}
        no_end = self.queues.no_end if self.queues is not None else frozenset[Barcode]()
        self._no_end = no_end.union(self._no_stop)
        self._now = NEVER
        self._held: dict[VehicleId, dict[Barcode, None]] = {}
        self._holders: dict[Barcode, tuple[VehicleId, ...]] = {}
        self._inside: defaultdict[ZoneId, dict[VehicleId, int]] = defaultdict(dict)
        self._maybe: defaultdict[VehicleId, set[Barcode]] = defaultdict(set)
        self._closed: dict[Barcode, str] = {}
        self._ways_out: dict[Barcode, tuple[AbstractSet[Barcode], ...]] = {}
        self._blocked: dict[VehicleId, Blocked] = {}
        self._blocked_at: defaultdict[Barcode, dict[VehicleId, None]] = defaultdict(dict)
        self._blocked_zone: defaultdict[ZoneId, dict[VehicleId, None]] = defaultdict(dict)
        self._turn: dict[VehicleId, int] = {}
        self._turns = count()

    @property
    def blocked(self) -> Mapping[VehicleId, Blocked]:
        """The last refusal of each vehicle that has not been granted all it wanted since."""
        return MappingProxyType(self._blocked)

    @property
    def closed(self) -> Mapping[Barcode, str]:
        """The closed barcodes, and why."""
        return MappingProxyType(self._closed)

    def held(self, vehicle: VehicleId) -> tuple[Barcode, ...]:
        """Return what the vehicle holds, in the order taken."""
        return tuple(self._held.get(vehicle, ()))

    def holders(self, barcode: Barcode) -> frozenset[VehicleId]:
        """Return who holds the barcode: more than one only after ``hold``."""
        return frozenset(self._holders.get(barcode, ()))

    def claim(
        self,
        vehicle: VehicleId,
        wanted: Sequence[Barcode],
        goal_included: bool,
        *,
        beyond: Sequence[Barcode] = (),
        begun: int = 0,
        now: Seconds = NEVER,
        cut_short: bool = False,
    ) -> Grant:
        """Grant as much of ``wanted`` as may be had, from its start, in order of driving.

        A barcode may be had if no other vehicle holds it or a conflicting one, every zone at it has room, and it is not
        closed. The grant does not end inside a no-stop zone, unless at the goal (``goal_included``: ``wanted[-1]`` is
        it) or in a no-stop zone that what the vehicle took last lies in already.

        With admission it does not end in a transit buffer or where it keeps another branch from passing either, and each buffer
        in which it could wait needs a slot. ``beyond`` from its index ``begun`` on is the way to its goal after ``wanted`` (so
        that the whole way need not be copied): which buffer it will wait in next is committed, granted or not; where that could
        close a circle, it stays committed to the one before.
        ``now`` is for soft zones and for whose turn it is. ``cut_short``: no longer path can be told to the vehicle; if all of
        this one keeps other branches from passing, it may stand there all the same, where else it would never go on.
        """
        self._now = now
        if self.queues is not None:
            self.queues.commit_on(vehicle, wanted, beyond, begun)
        free: list[Barcode] = []
        blocked = None
        holders, plain, closed = self._holders, self._plain, self._closed
        for barcode in wanted:
            simple = barcode not in holders and barcode in plain and barcode not in closed
            if not simple and (blocked := self.obstacle(vehicle, barcode)) is not None:
                break
            free.append(barcode)
        way = (wanted, beyond, begun)
        end, refused = self._stopping_place(vehicle, free, way, at_goal=blocked is None and goal_included)
        if cut_short and not end and blocked is refused is None:
            end, refused = self._stopping_place(vehicle, free, way, at_goal=False, anywhere=True)
        if refused is not None:
            blocked = refused
        elif blocked is None and end < len(free):
            zone = next((zone.id for zone in self._zones.get(free[-1], ()) if zone.no_stop), None)
            blocked = Blocked(free[end], None, BlockReason.NO_STOP, zone)
        del free[end:]
        for barcode in free:
            self._take(vehicle, barcode)
        self._record(vehicle, blocked, moved=bool(free))
        return Grant(tuple(free), blocked)

    def may_end(self, barcode: Barcode) -> bool:
        """Return whether a grant that is not for a goal may end here."""
        return barcode not in self._no_end

    def barred_by(self, vehicle: VehicleId) -> tuple[Barcode, ...]:
        """Return what nobody else is granted as long as this vehicle stays: what it holds, what excludes that, and what lies in
        a zone that it fills alone."""
        found: dict[Barcode, None] = {}
        for barcode in self._held.get(vehicle, ()):
            found[barcode] = None
            found.update(dict.fromkeys(sorted(self._track.conflicts(barcode))))
            for zone in self._track.zones_at(barcode):
                if zone.meter is None and zone.capacity == 1 and vehicle in self._inside[zone.id]:
                    found.update(dict.fromkeys(sorted(zone.barcodes)))
        return tuple(found)

    def strays(self, vehicle: VehicleId, way: Sequence[Barcode]) -> bool:
        """Return whether this way leads elsewhere than where the vehicle is committed to wait next, after a refused change."""
        if self.queues is None or (slot := self.queues.slot(vehicle)) < 0:
            return False
        return self.queues.want(vehicle) not in {ANY, self.queues.want_after(slot, way)}

    def turns(self, vehicle: VehicleId, way: Sequence[Barcode]) -> bool:
        """Commit the vehicle to where it waits next on this way; False: a circle of full buffers could close by the change."""
        if self.queues is None or (slot := self.queues.slot(vehicle)) < 0:
            return True
        done = self.queues.commit(vehicle, self.queues.want_after(slot, way))
        return done or not self.strays(vehicle, way)

    def lets_in(self, vehicle: VehicleId, way: Sequence[Barcode]) -> bool:
        """Return whether the vehicle could begin this way now: its first barcode is free, the next buffer has a slot for it."""
        if not way or self.obstacle(vehicle, way[0]) is not None:
            return False
        if self.queues is None or (slot := self.queues.slot(vehicle)) < 0:
            return True
        buffer = self.queues.want_after(slot, way)
        if buffer == ANY:
            return True
        entry = next(i for i, barcode in enumerate(way) if self.queues.waits_in(barcode) == buffer)
        return self.queues.ask(vehicle, buffer, self.queues.want_after(buffer, way[entry:])) is None

    def _stopping_place(
        self,
        vehicle: VehicleId,
        free: Sequence[Barcode],
        way: Way,
        *,
        at_goal: bool,
        anywhere: bool = False,
    ) -> tuple[int, Blocked | None]:
        """Return how many of ``free`` may be granted so that the vehicle can stop at the last one, with slots taken.

        Besides, what keeps it from a slot farther ahead. ``anywhere``: outside no-stop zones, it may stop everywhere.
        """
        held, queues, no_stop, final = self._held.get(vehicle), self.queues, self._no_stop, len(free) - 1
        last = next(reversed(held)) if held else None
        within = no_stop.get(last, NOWHERE) if last is not None else NOWHERE
        no_end = queues.no_end if queues is not None else ()
        creeps = last in no_end
        end = 0
        for i, barcode in enumerate(free):
            ends = anywhere or barcode not in no_end
            creeps = creeps and not ends
            stands = (creeps or ends) and (barcode not in no_stop or no_stop[barcode] <= within)
            if not stands and not (at_goal and i == final):
                continue
            if (
                queues is not None
                and queues.asks_slot(vehicle, free, end, i)
                and (refused := self._enter(queues, vehicle, free[end : i + 1], way, i + 1)) is not None
            ):
                return end, refused
            end = i + 1
        return end, None

    def _enter(
        self, queues: Queues, vehicle: VehicleId, part: Sequence[Barcode], way: Way, gone: int
    ) -> Blocked | None:
        """Take the slot that the vehicle needs to stand at the end of this part of its way; return what keeps it from that."""
        buffer = queues.waits_in(part[-1])
        entry = next(b for b in part if queues.waits_in(b) == buffer)
        want = queues.want_after(buffer, *way, gone)
        if (refused := queues.refusal(vehicle, entry, buffer, want, self._now)) is None:
            queues.enter(vehicle, buffer, want)
            queues.wait_no_more(vehicle)
        return refused

    def obstacle(self, vehicle: VehicleId, barcode: Barcode) -> Blocked | None:
        """Return what keeps the vehicle from being granted this barcode; None if nothing does."""
        if barcode in self._closed and not self._drives_out(vehicle, barcode):
            return Blocked(barcode, None, BlockReason.CLOSED, note=self._closed[barcode])
        if (other := self._other(vehicle, barcode)) is not None:
            return Blocked(barcode, other, BlockReason.HELD)
        for near in self._near.get(barcode, ()):
            if (other := self._other(vehicle, near)) is not None:
                return Blocked(barcode, other, BlockReason.CONFLICT)
        for zone in self._zones.get(barcode, ()):
            if others := self._in_the_way(vehicle, zone):
                return Blocked(barcode, others[0], BlockReason.ZONE, zone.id)
        return None

    def release(self, vehicle: VehicleId, barcodes: Iterable[Barcode]) -> None:
        """Give back what the vehicle holds of these; the rest is ignored. Then ask ``waiters`` who may go on."""
        held, unsure = self._held.get(vehicle, {}), self._maybe[vehicle]
        for barcode in barcodes:
            if barcode not in held:
                continue
            del held[barcode]
            holders = self._holders.pop(barcode)
            if len(holders) > 1:
                self._holders[barcode] = tuple(v for v in holders if v != vehicle)
            if barcode in unsure:
                unsure.discard(barcode)
            elif barcode in self._zones:
                self._count_in_zones(vehicle, barcode, -1)
        if not held:
            self._held.pop(vehicle, None)
        if self.queues is not None and not (held and self.queues.stays(vehicle, next(reversed(held)))):
            self.queues.put(vehicle, self.held)

    def hold(
        self, vehicle: VehicleId, barcodes: Iterable[Barcode], maybe: AbstractSet[Barcode] = frozenset()
    ) -> AbstractSet[tuple[Barcode, VehicleId]]:
        """Take these whatever stands against it: the vehicle is there, or may be. Tail first.

        Of these it may merely cover ``maybe``: nobody else gets them, but it is not inside their zones for that.
        Returns the barcodes that another vehicle holds, or holds a conflicting one of, with that vehicle. A barcode
        with two holders is granted to nobody, its holders included, until one releases it.
        """
        clashes: dict[tuple[Barcode, VehicleId], None] = {}
        for barcode in barcodes:
            for near in (barcode, *self._near.get(barcode, ())):
                clashes.update(((barcode, other), None) for other in self._others(vehicle, near))
            self._take(vehicle, barcode, maybe=barcode in maybe)
        if self.queues is not None:
            self.queues.put(vehicle, self.held)
        return clashes.keys()

    def clear(self, vehicle: VehicleId) -> None:
        """Give back everything: the vehicle is off the rail."""
        self.release(vehicle, self.held(vehicle))
        self.forget(vehicle)

    def forget(self, vehicle: VehicleId) -> None:
        """Drop the vehicle's last refusal: it wants nothing any more, so that it may go anywhere next."""
        self._record(vehicle, None, moved=True)
        if self.queues is not None:
            self.queues.wait_no_more(vehicle)
            self.queues.commit(vehicle, ANY)

    def close(self, barcodes: Iterable[Barcode], why: str, within: tuple[AbstractSet[Barcode], ...] = ()) -> None:
        """Grant these to nobody from now on; who holds them keeps them. The last word for a barcode is what holds.

        ``within``: closed places that each of these lies in; who holds track in all of them is inside, and may drive out.
        """
        for barcode in barcodes:
            self._closed[barcode] = why
            self._ways_out[barcode] = within

    def open(self, barcodes: Iterable[Barcode]) -> None:
        """End the closure. Then ask ``waiters`` who may go on."""
        for barcode in barcodes:
            self._closed.pop(barcode, None)
            self._ways_out.pop(barcode, None)

    def inside(self, barcodes: Iterable[Barcode]) -> tuple[VehicleId, ...]:
        """Return who holds any of these, by name."""
        return tuple(sorted({vehicle for barcode in barcodes for vehicle in self._holders.get(barcode, ())}))

    def _drives_out(self, vehicle: VehicleId, barcode: Barcode) -> bool:
        held, within = self._held.get(vehicle), self._ways_out[barcode]
        return bool(held and within) and not any(place.isdisjoint(held or ()) for place in within)

    def waiters(self, barcodes: Iterable[Barcode]) -> AbstractSet[VehicleId]:
        """Return who should claim again after these barcodes came free, the longest wait first.

        They are the vehicles whose last refusal concerns one of them, a conflicting one or a zone it lies in; and those that
        wait for a buffer of which a slot was given back, or whose head wants something else, since ``waiters`` was asked last.
        """
        queues = self.queues
        found: dict[VehicleId, None] = dict.fromkeys(
            queues.concerned() if queues is not None and queues.stirred else ()
        )
        for barcode in barcodes:
            for near in (barcode, *self._near.get(barcode, ())):
                if there := self._blocked_at.get(near):
                    found.update(there)
            for zone in self._zones.get(barcode, ()):
                found.update(self._blocked_zone.get(zone.id, {}))
        return (dict.fromkeys(sorted(found, key=self._turn.__getitem__)) if len(found) > 1 else found).keys()

    def cycles(self, going: AbstractSet[VehicleId] = frozenset()) -> tuple[tuple[VehicleId, ...], ...]:
        """Return the deadlocks: vehicles each of which waits for the next, and the last for the first.

        Judged by what stands against each waiting vehicle now. A vehicle that waits for room in a zone is locked only if
        everyone in the zone is; one that waits for an opening or for a longer claim of its own is not, nor one of those
        ``going``: whoever still drives gives back track, though it was refused more. Where cycles share vehicles, one is
        given. Each starts with its smallest id.
        """
        needs = {v: groups for v, b in self._blocked.items() if v not in going and (groups := self._needs(v, b))}
        return deadlocks(needs)

    def snapshot(self) -> TrafficView:
        """Return a copy of everything."""
        held = {vehicle: tuple(barcodes) for vehicle, barcodes in self._held.items()}
        return TrafficView(held, dict(self._blocked), dict(self._closed), self.cycles())

    def _others(self, vehicle: VehicleId, barcode: Barcode) -> Iterator[VehicleId]:
        return (other for other in self._holders.get(barcode, ()) if other != vehicle)

    def _other(self, vehicle: VehicleId, barcode: Barcode) -> VehicleId | None:
        """Return who else holds a barcode, the first of them."""
        for other in self._holders.get(barcode, ()):
            if other != vehicle:
                return other
        return None

    def _in_the_way(self, vehicle: VehicleId, zone: Zone) -> list[VehicleId]:
        """Return the other vehicles inside if they fill the zone; else none."""
        if zone.meter is not None:
            return []
        others = [other for other in self._inside[zone.id] if other != vehicle]
        return others if len(others) >= zone.capacity else []

    def _take(self, vehicle: VehicleId, barcode: Barcode, *, maybe: bool = False) -> None:
        if (held := self._held.get(vehicle)) is None:
            held = self._held[vehicle] = {}
        unsure = self._maybe[vehicle]
        sure_now = not maybe
        if barcode in held:
            del held[barcode]
            if sure_now := sure_now and barcode in unsure:
                unsure.discard(barcode)
        else:
            others = self._holders.get(barcode)
            self._holders[barcode] = (vehicle,) if others is None else (*others, vehicle)
            if maybe:
                unsure.add(barcode)
        if sure_now and barcode in self._zones:
            self._count_in_zones(vehicle, barcode, 1)
        held[barcode] = None

    def _count_in_zones(self, vehicle: VehicleId, barcode: Barcode, more: int) -> None:
        for zone in self._zones.get(barcode, ()):
            inside = self._inside[zone.id]
            inside[vehicle] = inside.get(vehicle, 0) + more
            if not inside[vehicle]:
                del inside[vehicle]

    def _record(self, vehicle: VehicleId, blocked: Blocked | None, *, moved: bool) -> None:
        before = self._blocked.get(vehicle)
        if before is None and blocked is None:
            return
        if before is not None:
            if before == blocked and not moved and before.why not in OF_BUFFERS:
                return
            self._unwatch(vehicle, before)
        if blocked is None:
            del self._blocked[vehicle], self._turn[vehicle]
            return
        self._blocked[vehicle] = blocked
        if self.queues is not None and blocked.why in OF_BUFFERS:
            self.queues.watch(vehicle)
        else:
            self._blocked_at[blocked.at][vehicle] = None
        if blocked.zone is not None:
            self._blocked_zone[blocked.zone][vehicle] = None
        if moved or before is None:
            self._turn[vehicle] = next(self._turns)

    def _unwatch(self, vehicle: VehicleId, before: Blocked) -> None:
        self._blocked_at[before.at].pop(vehicle, None)
        if before.zone is not None:
            self._blocked_zone[before.zone].pop(vehicle)
        if self.queues is not None and before.why in OF_BUFFERS:
            self.queues.unwatch(vehicle)

    def _needs(self, vehicle: VehicleId, blocked: Blocked) -> Needs:
        barcode = blocked.at
        if self.queues is not None and blocked.why in OF_BUFFERS:
            return self.queues.needs(vehicle)
        if barcode in self._closed and not self._drives_out(vehicle, barcode):
            return []
        holders = (other for near in (barcode, *self._near.get(barcode, ())) for other in self._others(vehicle, near))
        zones = (self._in_the_way(vehicle, zone) for zone in self._zones.get(barcode, ()))
        return [[other] for other in holders] + [others for others in zones if others]
