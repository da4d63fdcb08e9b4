"""The drive of a simulated vehicle: where it is on the rail, and how it runs along a path (PROTOCOLS 5.1, "Motion")."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from app.domain.layout import Edge, VehicleSpec
from app.domain.units import Barcode
from app.protocols.itsc.messages import Action, Element
from app.protocols.itsc.simulator.agenda import Agenda, Due
from app.protocols.itsc.simulator.motion import EPSILON, Profile, Stretch, brake, plan
from app.protocols.itsc.simulator.track import Track

Place = tuple[Barcode, float, Barcode | None]
"""Barcode last passed, mm past it, and the barcode ahead; None standing on a barcode, where all ways are open."""


@dataclass(frozen=True, slots=True)
class Leg:
    """A piece of rail still to run. ``index`` is the path element at its end; None where the path has left the rail."""

    end: Barcode
    length: float
    limit: float
    index: int | None
    stop: bool


class Traveler:
    """Runs along elements, reads barcodes at their exact times, stops. Knows nothing of modes and messages.

    ``on_barcode(barcode, index)`` is called at each barcode with the path's element there (None: not on the path), then,
    where the way ends, ``on_end(True)``; ``on_end(False)`` where a ``halt`` ended it.
    """

    def __init__(self, spec: VehicleSpec, track: Track, agenda: Agenda, start: Barcode, switch_reach: float) -> None:
        self.on_barcode: Callable[[Barcode, int | None], None] = lambda _barcode, _index: None
        self.on_end: Callable[[bool], None] = lambda _arrived: None
        self.path: list[Element] = []
        self.index = -1
        self._spec = spec
        self._track = track
        self._agenda = agenda
        self._switch_reach = switch_reach
        self._barcode = start
        self._past = 0.0
        self._onto: Barcode | None = None
        self._legs: list[Leg] = []
        self._profile: Profile | None = None
        self._base = 0.0
        self._passed = 0
        self._halting = False
        self._next: Due | None = None

    @property
    def driving(self) -> bool:
        """Whether it runs or brakes."""
        return self._profile is not None

    @property
    def on_mark(self) -> bool:
        """Whether it stands on a barcode."""
        return self._profile is None and self._past < EPSILON

    def place(self, now: float) -> Place:
        """Return where it is; ``now`` is not before the last input and not after the next deadline."""
        past, _ = self._motion(now)
        return self._barcode, past, self._onto if past >= EPSILON or self.driving else None

    def start(self, path: Sequence[Element]) -> bool:
        """Begin a path; return False if it does not begin where the vehicle stands, nor at a barcode next to it."""
        index = self._entry(path)
        if index is None:
            return False
        legs = self._legs_of(path, index)
        if self._past >= EPSILON and (not legs or legs[0].end != self._onto):
            return False
        self.path, self.index = list(path), index
        self._run(legs, self._past, 0.0)
        return True

    def splice(self, elements: Sequence[Element]) -> bool:
        """Replace the path from the first element's SEQ on (I16); return False, and change nothing, if it cannot be."""
        first = elements[0].seq
        if first > len(self.path) or elements[-1].seq <= self.index or self._profile is None or self._halting:
            return False
        past, speed = self._motion(self._agenda.now)
        room = speed**2 / (2 * self._spec.braking) + EPSILON
        path = [*self.path[:first], *elements]
        if self._left(self._legs, past) <= room or not self._leads_on(path, past):
            return False
        legs = self._legs_of(path, self.index)
        if not legs or self._left(legs, past) < room:
            return False
        self.path = path
        self._run(legs, past, speed)
        return True

    def halt(self) -> None:
        """Brake; ``on_end(False)`` follows when it stands, at once if it does already."""
        past, speed = self._motion(self._agenda.now)
        self._halting = True
        stop = speed**2 / (2 * self._spec.braking)
        while (
            self._left(self._legs, past) < stop - EPSILON
            and (stray := self._stray_leg(self._last_barcode())) is not None
        ):
            self._legs.append(stray)
        lengths = [leg.length for leg in self._legs]
        if lengths:
            lengths[0] -= past
        self._follow(brake(self._agenda.now, speed, lengths, self._spec.braking), past)

    def resume(self) -> None:
        """Go on with the path after a halt, or out of one."""
        past, speed = self._motion(self._agenda.now)
        self._run(self._legs, past, speed)

    def freeze(self) -> None:
        """Stand at once, as without power; nobody is told, and the path is gone."""
        self._past, _ = self._motion(self._agenda.now)
        self._end()
        self._legs = []
        self.path = []

    def put_on(self, barcode: Barcode) -> None:
        """Stand on a barcode, moved there by hand."""
        self.freeze()
        self._barcode, self._past, self._onto = barcode, 0.0, None

    def drop_path(self) -> None:
        """Forget the path; the place stays."""
        self.path = []
        self._legs = []

    def _motion(self, now: float) -> tuple[float, float]:
        """Return mm past the last barcode, and speed."""
        if self._profile is None:
            return self._past, 0.0
        run, speed = self._profile.at(now)
        return max(0.0, run - self._base), speed

    def _entry(self, path: Sequence[Element]) -> int | None:
        """Return the index of the element that the vehicle has behind it or under it: 0, or -1 before the first (I56)."""
        first = Barcode(str(path[0].barcode))
        if first == self._barcode:
            return 0
        if self._past < EPSILON:
            return -1 if self._track.edge(self._barcode, first) is not None else None
        return -1 if first == self._onto else None

    def _leads_on(self, path: Sequence[Element], past: float) -> bool:
        """Whether the present element is where the vehicle is, and the next lies ahead or on a branch still to be taken."""
        if self.index >= 0 and Barcode(str(path[self.index].barcode)) != self._barcode:
            return False
        target = Barcode(str(path[self.index + 1].barcode))
        if target == self._onto:
            return True
        edge = self._track.edge(self._barcode, target)
        return edge is not None and past <= min(self._switch_reach, edge.length)

    def _legs_of(self, path: Sequence[Element], index: int) -> list[Leg]:
        legs: list[Leg] = []
        at = self._barcode
        for k in range(index + 1, len(path)):
            barcode = Barcode(str(path[k].barcode))
            edge = self._track.edge(at, barcode)
            if edge is None and barcode != at:
                stray = self._stray_leg(at, path[max(k - 1, 0)].speed)
                return legs if stray is None else [*legs, stray]
            length = 0.0 if edge is None else float(edge.length)
            limit = self._limit(edge, path[max(k - 1, 0)].speed)
            legs.append(Leg(barcode, length, limit, k, path[k].action != Action.RUN))
            at = barcode
        return legs

    def _limit(self, edge: Edge | None, percent: int) -> float:
        speed = percent * self._spec.max_speed / 100
        return min(speed, self._spec.curve_speed) if edge is not None and edge.curve else speed

    def _stray_leg(self, at: Barcode, percent: int = 100) -> Leg | None:
        """Return the way that a vehicle rolls which is not steered; None at the end of the rail."""
        edge = next(iter(self._track.ahead(at).values()), None)
        return None if edge is None else Leg(edge.end, edge.length, self._limit(edge, percent), None, stop=False)

    def _last_barcode(self) -> Barcode:
        return self._legs[-1].end if self._legs else self._barcode

    @staticmethod
    def _left(legs: Sequence[Leg], past: float) -> float:
        return sum(leg.length for leg in legs) - past

    def _run(self, legs: list[Leg], past: float, speed: float) -> None:
        self._halting = False
        self._legs = legs
        lengths = [leg.length for leg in legs]
        if lengths:
            lengths[0] = max(0.0, lengths[0] - past)
        stretches = [
            Stretch(length, leg.limit, 0.0 if leg.stop or (leg is legs[-1] and leg.index is not None) else leg.limit)
            for length, leg in zip(lengths, legs, strict=True)
        ]
        self._follow(plan(self._agenda.now, speed, stretches, self._spec.acceleration, self._spec.braking), past)

    def _follow(self, profile: Profile, past: float) -> None:
        """Take up a profile that begins ``past`` mm behind the last barcode."""
        self._profile, self._base, self._passed = profile, -past, 0
        if self._legs:
            self._onto = self._legs[0].end
        self._arm(profile)

    def _arm(self, profile: Profile) -> None:
        if self._next is not None:
            self._next.cancel()
        more = self._passed < len(profile.ends)
        self._next = self._agenda.at(profile.ends[self._passed] if more else profile.end, lambda: self._step(profile))

    def _step(self, profile: Profile) -> None:
        """A barcode is reached, or the vehicle stands."""
        read, index = self._pass_barcodes(profile)
        if read:
            self.on_barcode(self._barcode, index)
        if self._profile is not profile:
            return
        if profile.end <= self._agenda.now and self._passed >= len(profile.ends):
            halted, self._past = self._halting, 0.0 if read else self._motion(self._agenda.now)[0]
            self._end()
            self.on_end(not halted)
        else:
            self._arm(profile)

    def _pass_barcodes(self, profile: Profile) -> tuple[bool, int | None]:
        """Pass what lies here: one barcode, with all the path elements that name it in a row."""
        read = False
        index: int | None = None
        while self._passed < len(profile.ends) and profile.ends[self._passed] <= self._agenda.now:
            leg = self._legs.pop(0)
            self._base += leg.length
            self._barcode, index, read = leg.end, leg.index, True
            self._passed += 1
            self.index = self.index if index is None else index
            if leg.length and self._legs and self._legs[0].length:
                break
        self._onto = self._legs[0].end if self._legs else None
        return read, index

    def _end(self) -> None:
        self._profile = None
        self._halting = False
        if self._next is not None:
            self._next.cancel()
        if self._past < EPSILON:
            self._past, self._onto = 0.0, None
