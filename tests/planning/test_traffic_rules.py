"""Random claims and releases never break the rules of ownership."""

from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

from app.domain.ids import VehicleId, ZoneId
from app.domain.layout import Edge, Plant, Point, Zone
from app.domain.units import Barcode, Millimetres
from app.planning.blocking import Blocked, BlockReason
from app.planning.track import Track
from app.planning.traffic import Traffic

SPOTS = {
    "a": (0, 0),
    "b": (1000, 0),
    "c": (2000, 0),
    "d": (2000, 900),
    "e": (1000, 900),
    "f": (0, 900),
    "s": (1500, -500),
}
SPOTS |= {"n": (1500, 500), "t": (1600, 1500)}
NEXT = {"a": "b", "b": "c", "c": "d", "d": "e", "e": "f", "f": "a", "s": "n", "n": "t", "t": "s"}
CAPACITIES = {ZoneId("bay"): 2, ZoneId("merge"): 1}
INSIDE = {ZoneId("bay"): frozenset("cden"), ZoneId("merge"): frozenset("ab")}


def plant() -> Plant:
    """Two rings that cross, a bay for two and a merge where nobody stops."""
    points = tuple(Point(Barcode(b), Millimetres(x), Millimetres(y)) for b, (x, y) in SPOTS.items())
    edges = tuple(Edge(Barcode(b), Barcode(c), Millimetres(1000)) for b, c in NEXT.items())
    zones = tuple(
        Zone(name, frozenset(map(Barcode, INSIDE[name])), capacity, no_stop=name == "merge")
        for name, capacity in CAPACITIES.items()
    )
    return Plant("rings", points, edges, (), (), zones, clearance=Millimetres(600))


vehicles = st.sampled_from([VehicleId(f"V{i}") for i in range(5)])
barcodes = st.sampled_from([Barcode(b) for b in SPOTS])


class Ownership(RuleBasedStateMachine):
    def __init__(self) -> None:
        super().__init__()
        self.track = Track(plant())
        self.traffic = Traffic(self.track)
        self.forced: set[tuple[VehicleId, Barcode]] = set()

    @rule(vehicle=vehicles, start=barcodes, length=st.integers(0, 6), goal=st.booleans())
    def claim(self, vehicle: VehicleId, start: Barcode, length: int, goal: bool) -> None:
        wanted = [start]
        while len(wanted) < length:
            wanted.append(Barcode(NEXT[wanted[-1]]))
        before = self.traffic.held(vehicle)
        grant = self.traffic.claim(vehicle, wanted, goal)
        assert list(grant.granted) == wanted[: len(grant.granted)]
        assert set(self.traffic.held(vehicle)) == {*before, *grant.granted}
        assert (grant.blocked is None) == (len(grant.granted) == len(wanted))
        assert self.traffic.blocked.get(vehicle) == grant.blocked
        for barcode in grant.granted:
            self.check_exclusive(vehicle, barcode)
            self.forced.discard((vehicle, barcode))
        if grant.granted and not (goal and grant.blocked is None):
            stood_inside = bool(before) and self.track.no_stop(before[-1])
            assert stood_inside or not self.track.no_stop(grant.granted[-1])
        self.check_waiting(vehicle, grant.blocked)

    def check_exclusive(self, vehicle: VehicleId, barcode: Barcode) -> None:
        assert self.traffic.holders(barcode) == {vehicle}
        assert all(self.traffic.holders(c) <= {vehicle} for c in self.track.conflicts(barcode))

    def check_waiting(self, vehicle: VehicleId, blocked: Blocked | None) -> None:
        if blocked is not None:
            assert vehicle in self.traffic.waiters([blocked.at])
        if blocked is not None and blocked.why in (BlockReason.HELD, BlockReason.CONFLICT, BlockReason.ZONE):
            assert blocked.by is not None
            assert vehicle in self.traffic.waiters(self.traffic.held(blocked.by))

    @rule(vehicle=vehicles, given_back=st.lists(barcodes, max_size=4))
    def release(self, vehicle: VehicleId, given_back: list[Barcode]) -> None:
        before = self.traffic.held(vehicle)
        self.traffic.release(vehicle, given_back)
        assert self.traffic.held(vehicle) == tuple(b for b in before if b not in given_back)
        self.forced -= {(vehicle, b) for b in given_back}

    @rule(vehicle=vehicles, places=st.lists(barcodes, max_size=2))
    def hold(self, vehicle: VehicleId, places: list[Barcode]) -> None:
        expected = {
            (b, other)
            for b in places
            for near in {b} | self.track.conflicts(b)
            for other in self.traffic.holders(near) - {vehicle}
        }
        assert self.traffic.hold(vehicle, places) == expected
        self.forced |= {(vehicle, b) for b in places}

    @rule(vehicle=vehicles)
    def clear(self, vehicle: VehicleId) -> None:
        self.traffic.clear(vehicle)
        assert self.traffic.held(vehicle) == ()
        assert vehicle not in self.traffic.blocked
        self.forced = {(v, b) for v, b in self.forced if v != vehicle}

    @rule(place=barcodes)
    def close(self, place: Barcode) -> None:
        self.traffic.close([place], "test")

    @rule()
    def open(self) -> None:
        self.traffic.open(list(self.traffic.closed))

    @invariant()
    def a_barcode_has_one_holder_unless_forced(self) -> None:
        for name in SPOTS:
            barcode = Barcode(name)
            holders = self.traffic.holders(barcode)
            assert {v for v, held in self.traffic.snapshot().held.items() if barcode in held} == holders
            granted = {v for v in holders if (v, barcode) not in self.forced}
            around = {
                v for c in self.track.conflicts(barcode) for v in self.traffic.holders(c) if (v, c) not in self.forced
            }
            assert len(granted) <= 1
            assert not granted or around <= granted

    @invariant()
    def a_zone_is_not_overfull_unless_forced(self) -> None:
        for zone, capacity in CAPACITIES.items():
            inside = {v for b in INSIDE[zone] for v in self.traffic.holders(Barcode(b))}
            forced_in = {v for v, b in self.forced if b in INSIDE[zone]}
            assert len(inside - forced_in) <= capacity

    @invariant()
    def a_cycle_is_made_of_waiting_vehicles(self) -> None:
        for cycle in self.traffic.cycles():
            assert len(cycle) > 1
            assert set(cycle) <= set(self.traffic.blocked)


TestOwnership = Ownership.TestCase
