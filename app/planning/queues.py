"""The lines before the exits of a track's buffers: who has a slot where, and who hangs on whom (TRAFFIC section 3).

``planning.admission`` has the rule over numbers; here vehicles and barcodes have their names.
"""

from collections import defaultdict
from collections.abc import Callable, Sequence

from app.domain.ids import VehicleId
from app.domain.layout import VehicleKind
from app.domain.units import Barcode, Millimetres, Seconds
from app.planning.admission import ADMITTED, ANY, CIRCLE, admits, enter, leave, lines, may_want
from app.planning.blocking import Blocked, BlockReason
from app.planning.buffers import LONGEST_PASS, Buffers, Row
from app.planning.metering import Metered, metered
from app.planning.track import BOOK_VEHICLE, Track

AGE = Seconds(30.0)
"""Who has waited so long for a slot goes before those that come by another branch (TRAFFIC section 5; our choice)."""
GIVES_TURN = Seconds(3.0)
"""A vehicle lets others go first for so long at most, each time (our choice)."""


class Queues:
    """The buffers of a track with the vehicles in line in each.

    A vehicle has the slot of the farthest buffer that it may wait in and is granted track in. A goal in a transit buffer, and
    two-way floor, need none: whoever goes there keeps the slot it has. ``stirred`` are the buffers that a vehicle has left, or
    whose head wants something else, since they were last taken.
    """

    def __init__(self, track: Track) -> None:
        hoists = [v for v in track.plant.vehicles if v.kind is not VehicleKind.AGV]
        self.buffers = Buffers(track, max((v.length for v in hoists), default=BOOK_VEHICLE.length))
        self._track = track
        self._lines = lines(self.buffers, 0)
        self._numbers: dict[VehicleId, int] = {}
        self._names: list[VehicleId] = []
        b = self.buffers
        self.no_end = frozenset(at for (at, i), end in zip(b.index.items(), self._find_ends(), strict=True) if not end)
        """Where a grant that is not for a goal does not end."""
        self._waits = {at: b.of[i] for at, i in b.index.items() if b.of[i] >= 0 and not b.transit[b.of[i]]}
        self._opening = frozenset(chain[0] for chain in b.chains)
        self._left = {at: len(chain) - place for chain in b.chains for place, at in enumerate(chain)}
        self.stirred: dict[int, None] = {}
        self._meters = metered(track, self.buffers)
        self._asked: dict[VehicleId, tuple[int, int]] = {}
        self._since: dict[VehicleId, Seconds] = {}
        self._looked: dict[VehicleId, tuple[int, ...]] = {}
        self._gave: dict[VehicleId, Seconds] = {}
        self._watched: dict[VehicleId, tuple[int, ...]] = {}
        self._watchers: defaultdict[int, dict[VehicleId, None]] = defaultdict(dict)

    def _find_ends(self) -> Row:
        """Return for each barcode whether a grant may end there: where one may wait, or where no such place is near enough."""
        b = self.buffers
        ends = [int(of < 0 or (stop and not b.transit[of])) for of, stop in zip(b.of, b.stop, strict=True)]
        for barcode, index in b.index.items():
            if not ends[index] and not self._leads_out(barcode, ends):
                ends[index] = 2
        return [min(1, end) for end in ends]

    def _leads_out(self, start: Barcode, ends: Row) -> bool:
        """Whether every way from here comes to a place to wait within LONGEST_PASS."""
        queue: list[tuple[Barcode, int]] = [(start, 0)]
        seen = {start}
        while queue:
            here, way = queue.pop()
            after = self._track.successors(here)
            if not after or way > LONGEST_PASS:
                return False
            for barcode in after:
                if barcode not in seen and ends[self.buffers.index[barcode]] != 1:
                    seen.add(barcode)
                    queue.append((barcode, Millimetres(way + self._track.edge(here, barcode).length)))
        return True

    # -- where vehicles are in line -----------------------------------------------------------------------------------

    def waits_in(self, barcode: Barcode) -> int:
        """Return the buffer whose slot is needed to stand here; -1: none is."""
        return self._waits.get(barcode, -1)

    def slot(self, vehicle: VehicleId) -> int:
        """Return the buffer that the vehicle has a slot of; -1: of none."""
        number = self._numbers.get(vehicle)
        return -1 if number is None else self._lines.slot[number]

    def want(self, vehicle: VehicleId) -> int:
        """Return the buffer that the vehicle is committed to wait in next; ANY: whichever."""
        number = self._numbers.get(vehicle)
        return ANY if number is None else self._lines.want[number]

    def load(self, buffer: int) -> int:
        """Return how many slots of a buffer are taken."""
        return self._lines.load[buffer]

    def line(self, buffer: int) -> tuple[VehicleId, ...]:
        """Return the vehicles in line in a buffer, its head first."""
        found, number = [], self._lines.head[buffer]
        while number >= 0:
            found.append(self._names[number])
            number = self._lines.behind[number]
        return tuple(found)

    def head(self, buffer: int) -> VehicleId | None:
        """Return who must leave a buffer first."""
        number = self._lines.head[buffer]
        return self._names[number] if number >= 0 else None

    def want_after(
        self, buffer: int, way: Sequence[Barcode], beyond: Sequence[Barcode] = (), begun: int = 0, gone: int = 0
    ) -> int:
        """Return the buffer in which a vehicle waits next on its way on in this one; ANY: its way ends before one.

        On a ring it may be the same again. The way begins at the index ``gone`` of ``way``, and goes on at ``begun`` of
        ``beyond``. A buffer that it comes to, it follows to the end: there is no other way.
        """
        waits, left, at, count = self._waits, self._left, gone, len(way)
        while at < count:
            here = way[at]
            after = waits.get(here, -1)
            if after >= 0 and (after != buffer or here in self._opening):
                return after
            at += left.get(here, 1)
        at, count = at - count + begun, len(beyond)
        while at < count:
            here = beyond[at]
            after = waits.get(here, -1)
            if after >= 0 and (after != buffer or here in self._opening):
                return after
            at += left.get(here, 1)
        return ANY

    def asks_slot(self, vehicle: VehicleId, way: Sequence[Barcode], first: int, last: int) -> bool:
        """Return whether a vehicle that goes from ``way[first]`` to ``way[last]`` needs a slot to stand there, and lacks it."""
        buffer = self._waits.get(way[last], -1)
        if buffer < 0:
            return False
        number = self._numbers.get(vehicle)
        if number is None or buffer != self._lines.slot[number]:
            return True
        return self.buffers.chains[buffer][0] in way[first : last + 1]

    def stays(self, vehicle: VehicleId, last: Barcode) -> bool:
        """Return whether a vehicle that holds this farthest ahead has the slot that is due to it."""
        number = self._numbers.get(vehicle)
        return number is not None and self._waits.get(last, -2) == self._lines.slot[number]

    # -- what vehicles ask --------------------------------------------------------------------------------------------

    def ask(self, vehicle: VehicleId, buffer: int, want: int) -> BlockReason | None:
        """Return why the vehicle may not take a slot of this buffer; None: it may, or has it."""
        answer = admits(self._lines, self._number(vehicle), buffer, want)
        if answer == ADMITTED:
            return None
        return BlockReason.CIRCLE if answer == CIRCLE else BlockReason.FULL

    def refusal(self, vehicle: VehicleId, at: Barcode, buffer: int, want: int, now: Seconds) -> Blocked | None:
        """Ask, and name who must go first: the head of the full buffer, or whose turn it is to take the last slot.

        Besides, soft zones and those who have waited very long are minded.
        """
        why = self.ask(vehicle, buffer, want)
        if why is None and buffer not in self._meters and not self._watchers.get(buffer):
            return None
        looked = tuple(self._lines.looked[: self._lines.seen[0]])
        before = self._asked.get(vehicle)
        since = self._since.get(vehicle, now) if before is not None and before[0] == buffer else now
        blocked = None
        if why is not None:
            by = self.head(buffer) if why is BlockReason.FULL else self._who_closes(buffer)
            blocked = Blocked(at, by if by != vehicle else None, why)
        elif meter := self._meter(vehicle, buffer, now - since):
            blocked, looked = Blocked(at, None, BlockReason.METER, meter.zone), tuple(sorted(meter.buffers))
        elif (first := self._before(vehicle, buffer, since, now)) is not None:
            blocked, looked = Blocked(at, first, BlockReason.TURN), (buffer, self.slot(first))
        if blocked is not None:
            self._asked[vehicle], self._since[vehicle], self._looked[vehicle] = (buffer, want), since, looked
        return blocked

    def _meter(self, vehicle: VehicleId, buffer: int, waited: float) -> Metered | None:
        """Return the soft zone that has no room for a vehicle from outside that has waited so long."""
        home = self.slot(vehicle)
        for meter in self._meters.get(buffer, ()):
            if home not in meter.buffers and waited < meter.patience and meter.full(self._lines.load):
                return meter
        return None

    def _before(self, vehicle: VehicleId, buffer: int, since: Seconds, now: Seconds) -> VehicleId | None:
        """Return who has waited beyond an age for this buffer on another branch, and longer, and could come in now.

        Nobody gives way for longer than GIVES_TURN: that one may be kept by something else.
        """
        home, gave = self.slot(vehicle), self._gave.get(vehicle, now)
        if now - gave >= GIVES_TURN:
            return None
        for other in self._watchers.get(buffer, ()):
            # One that was let in a moment ago, this one itself above all, is not struck off the watchers yet.
            if other == vehicle or other not in self._asked:
                continue
            old, (asks, want) = self._since[other], self._asked[other]
            if asks != buffer or old >= since or now - old < AGE or self.slot(other) in {home, -1}:
                continue
            if self.ask(other, buffer, want) is None:
                self._gave[vehicle] = gave
                return other
        return None

    def wait_no_more(self, vehicle: VehicleId) -> None:
        """The vehicle has come in, or wants to no more: its wait counts no longer."""
        if self._asked.pop(vehicle, None) is not None:
            for kept in (self._since, self._looked, self._gave):
                kept.pop(vehicle, None)

    def _who_closes(self, buffer: int) -> VehicleId | None:
        """Return the head that the last slot of a buffer is kept for: the circle that was found last ends with it."""
        s = self._lines
        for here in reversed(s.looked[: s.seen[0]]):
            head = s.head[here]
            if head >= 0 and (s.want[head] == buffer or (s.want[head] == ANY and buffer in self.buffers.outs[here])):
                return self._names[head]
        return self.head(buffer)

    def enter(self, vehicle: VehicleId, buffer: int, want: int) -> None:
        """Give the vehicle a slot of this buffer, last in line, and back the one it has."""
        number = self._number(vehicle)
        before = self._lines.slot[number]
        enter(self._lines, number, buffer, want)
        if before >= 0:
            self.stirred[before] = None

    def commit_on(self, vehicle: VehicleId, way: Sequence[Barcode], beyond: Sequence[Barcode], begun: int) -> None:
        """Let a vehicle in line want the buffer that it will wait in next on this way (as in ``want_after``)."""
        number = self._numbers.get(vehicle)
        if number is not None and (slot := self._lines.slot[number]) >= 0:
            want = self.want_after(slot, way, beyond, begun)
            if want != self._lines.want[number]:
                self.commit(vehicle, want)

    def commit(self, vehicle: VehicleId, want: int) -> bool:
        """Let the vehicle want this next, unless a circle closed by it: then it stays with what it wanted. Return whether so."""
        number = self._number(vehicle)
        s = self._lines
        if s.want[number] == want:
            return True
        if not may_want(s, number, want):
            return False
        s.want[number] = want
        if (buffer := s.slot[number]) >= 0 and s.head[buffer] == number:
            self.stirred[buffer] = None
        return True

    def put(self, vehicle: VehicleId, held_by: Callable[[VehicleId], Sequence[Barcode]]) -> None:
        """The vehicle holds something else now, whatever stands against it: its slot is where it can wait farthest ahead.

        ``held_by`` tells what a vehicle holds, tail first. It comes into line by its place in the buffer.
        """
        held = held_by(vehicle)
        if not held:
            self.take_out(vehicle)
            return
        buffer = next((b for at in reversed(held) if (b := self._waits.get(at, -1)) >= 0), -1)
        if buffer in {-1, self.slot(vehicle)}:
            return
        place = self._place(buffer, held)
        behind = [other for other in self.line(buffer) if self._place(buffer, held_by(other)) < place]
        self.enter(vehicle, buffer, ANY)
        for other in behind:
            number = self._numbers[other]
            enter(self._lines, number, buffer, self._lines.want[number])
        self.stirred[buffer] = None

    def _place(self, buffer: int, held: Sequence[Barcode]) -> int:
        """Return how far ahead in a buffer a vehicle reaches; one that holds nothing there has gone on from it."""
        b = self.buffers
        places = (b.place[b.index[barcode]] for barcode in reversed(held) if b.at(barcode) == buffer)
        return next(places, len(b.chains[buffer]))

    def take_out(self, vehicle: VehicleId) -> None:
        """The vehicle stands nowhere any more."""
        if (buffer := self.slot(vehicle)) >= 0:
            leave(self._lines, self._numbers[vehicle])
            self.stirred[buffer] = None

    # -- who hangs on what --------------------------------------------------------------------------------------------

    def watch(self, vehicle: VehicleId) -> None:
        """The vehicle waits for one of the buffers that its last refusal came by."""
        self._watched[vehicle] = self._looked[vehicle]
        for buffer in self._watched[vehicle]:
            self._watchers[buffer][vehicle] = None

    def unwatch(self, vehicle: VehicleId) -> None:
        """The vehicle waits for no buffer."""
        for buffer in self._watched.pop(vehicle, ()):
            self._watchers[buffer].pop(vehicle)

    def concerned(self) -> list[VehicleId]:
        """Return who may be answered otherwise now, and forget what was stirred."""
        found = [vehicle for buffer in self.stirred for vehicle in self._watchers.get(buffer, ())]
        self.stirred.clear()
        return found

    def needs(self, vehicle: VehicleId) -> list[list[VehicleId]]:
        """Return of whom one must go first, for a vehicle that was refused a slot, by what stands against it now."""
        buffer, want = self._asked[vehicle]
        why = self.ask(vehicle, buffer, want)
        if why is None:
            return []
        s = self._lines
        buffers = [buffer] if why is BlockReason.FULL else s.looked[: s.seen[0]]
        heads = [head for b in buffers if (head := self.head(b)) is not None and head != vehicle]
        return [heads] if heads else []

    def _number(self, vehicle: VehicleId) -> int:
        if (number := self._numbers.get(vehicle)) is None:
            number = self._numbers[vehicle] = len(self._names)
            self._names.append(vehicle)
            for row in (self._lines.slot, self._lines.want, self._lines.before, self._lines.behind):
                row.append(-1)
        return number
