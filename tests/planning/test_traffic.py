from collections.abc import Callable
from typing import TypeAlias

import pytest

from app.domain.ids import VehicleId, ZoneId
from app.domain.layout import Zone
from app.domain.units import Barcode
from app.planning.blocking import Blocked, BlockReason, Grant
from app.planning.track import Track
from app.planning.traffic import Traffic

Lay: TypeAlias = Callable[..., Track]
MakeZone: TypeAlias = Callable[..., Zone]
V1, V2, V3, V4 = (VehicleId(f"V{i}") for i in range(1, 5))
CROSS = {"w": (0, 0), "e": (1000, 0), "s": (500, -500), "n": (500, 500)}


def path(names: str) -> tuple[Barcode, ...]:
    return tuple(Barcode(name) for name in names.split())


def b(name: str) -> Barcode:
    return Barcode(name)


def test_free_track_is_granted_whole(lay: Lay) -> None:
    traffic = Traffic(lay("a b c d"))
    assert traffic.claim(V1, path("a b"), goal_included=False) == Grant(path("a b"), None)
    assert traffic.claim(V1, path("c"), goal_included=True) == Grant(path("c"), None)
    assert traffic.held(V1) == path("a b c")
    assert traffic.holders(b("c")) == {V1}
    assert traffic.holders(b("d")) == frozenset()


def test_nothing_wanted_is_granted(lay: Lay) -> None:
    assert Traffic(lay("a b")).claim(V1, (), goal_included=False) == Grant((), None)


def test_a_grant_ends_before_what_another_holds_and_says_who(lay: Lay) -> None:
    traffic = Traffic(lay("a b c d"))
    traffic.hold(V2, path("c"))
    blocked = Blocked(b("c"), V2, BlockReason.HELD)
    assert traffic.claim(V1, path("a b c d"), goal_included=True) == Grant(path("a b"), blocked)
    assert traffic.blocked == {V1: blocked}
    assert traffic.held(V1) == path("a b")


def test_what_is_released_can_be_had_by_those_who_wait_for_it(lay: Lay) -> None:
    traffic = Traffic(lay("a b c d"))
    traffic.hold(V2, path("b c"))
    traffic.claim(V1, path("a b"), goal_included=False)
    assert traffic.waiters(path("c d")) == set()
    traffic.release(V2, path("b d"))
    assert traffic.waiters(path("b")) == {V1}
    assert traffic.claim(V1, path("b"), goal_included=False) == Grant(path("b"), None)
    assert traffic.blocked == {}
    assert traffic.waiters(path("b")) == set()


def test_waiters_are_in_the_order_of_their_waiting(lay: Lay) -> None:
    traffic = Traffic(lay("a b c", "d b", "x b"))
    traffic.hold(V3, path("b"))
    traffic.claim(V2, path("b"), goal_included=False)
    traffic.claim(V1, path("b"), goal_included=False)
    traffic.claim(V4, path("b"), goal_included=False)
    traffic.claim(V2, path("b"), goal_included=False)
    assert list(traffic.waiters(path("b"))) == [V2, V1, V4]
    traffic.claim(V2, path("d b"), goal_included=False)
    assert list(traffic.waiters(path("b"))) == [V1, V4, V2]


def test_taking_again_what_is_held_puts_it_last(lay: Lay) -> None:
    traffic = Traffic(lay("a b c a"))
    traffic.claim(V1, path("a b c"), goal_included=False)
    traffic.claim(V1, path("a"), goal_included=False)
    assert traffic.held(V1) == path("b c a")
    traffic.release(V1, path("a"))
    assert traffic.holders(b("a")) == frozenset()


def test_a_crossing_lets_one_pass_at_a_time(lay: Lay) -> None:
    traffic = Traffic(lay("w e", "s n", at=CROSS))
    assert traffic.claim(V1, path("w e"), goal_included=True).blocked is None
    grant = traffic.claim(V2, path("s n"), goal_included=True)
    assert grant == Grant(path("s"), Blocked(b("n"), V1, BlockReason.CONFLICT))
    assert traffic.waiters(path("e")) == {V2}


def test_ones_own_conflicts_do_not_block(lay: Lay) -> None:
    traffic = Traffic(lay("w e s n", at=CROSS))
    assert traffic.claim(V1, path("w e s n"), goal_included=True).blocked is None


def test_a_zone_takes_as_many_as_its_capacity(lay: Lay, zone: MakeZone) -> None:
    traffic = Traffic(lay("a b c d e", zones=[zone("b c d", 2, name="bay")]))
    traffic.claim(V1, path("c d"), goal_included=True)
    assert traffic.claim(V2, path("b"), goal_included=True).blocked is None
    traffic.release(V2, path("b"))
    traffic.hold(V3, path("b"))
    blocked = Blocked(b("c"), V1, BlockReason.ZONE, ZoneId("bay"))
    traffic.release(V1, path("c"))
    assert traffic.claim(V2, path("c"), goal_included=True) == Grant((), blocked)
    assert traffic.waiters(path("d")) == {V2}
    traffic.release(V1, path("d"))
    assert traffic.claim(V2, path("c"), goal_included=True).blocked is None


def test_who_is_inside_a_full_zone_may_go_on_in_it(lay: Lay, zone: MakeZone) -> None:
    traffic = Traffic(lay("a b c", zones=[zone("a b c", 1)]))
    traffic.hold(V1, path("a"))
    assert traffic.claim(V1, path("b c"), goal_included=True).blocked is None


def test_what_a_vehicle_may_merely_cover_is_nobodys_but_does_not_fill_its_zone(lay: Lay, zone: MakeZone) -> None:
    """Two AGVs stop before a merge; after a restart each may stick out into it. One must get through."""
    traffic = Traffic(lay("a b m", "x y m", zones=[zone("b y m", 1)]))
    traffic.hold(V1, path("b a"), maybe={b("b")})
    traffic.hold(V2, path("y x"), maybe={b("y")})
    assert traffic.claim(V3, path("b"), goal_included=True).blocked == Blocked(b("b"), V1, BlockReason.HELD)
    assert traffic.claim(V1, path("b m"), goal_included=True) == Grant(path("b m"), None)
    assert traffic.claim(V2, path("y m"), goal_included=True).granted == ()
    traffic.release(V1, path("a b m"))
    assert traffic.claim(V2, path("y m"), goal_included=True) == Grant(path("y m"), None)
    traffic.release(V2, path("x y m"))
    assert traffic.claim(V1, path("b m"), goal_included=True) == Grant(path("b m"), None)


def test_a_grant_does_not_end_inside_a_no_stop_zone(lay: Lay, zone: MakeZone) -> None:
    traffic = Traffic(lay("a b c d", zones=[zone("b c", no_stop=True)]))
    refused = traffic.claim(V1, path("a b c"), goal_included=False)
    assert refused.granted == path("a")
    assert refused.blocked is not None
    assert (refused.blocked.at, refused.blocked.why, refused.blocked.zone) == ("b", BlockReason.NO_STOP, "Z")
    assert refused.blocked.by is None
    assert traffic.claim(V1, path("b c d"), goal_included=False).granted == path("b c d")


def test_a_goal_inside_a_no_stop_zone_may_be_driven_to(lay: Lay, zone: MakeZone) -> None:
    traffic = Traffic(lay("a b c d", zones=[zone("b c", no_stop=True)]))
    assert traffic.claim(V1, path("a b"), goal_included=True).granted == path("a b")


def test_whoever_stands_inside_a_no_stop_zone_may_move_up_in_it_but_not_into_another(lay: Lay, zone: MakeZone) -> None:
    zones = [zone("b c d", no_stop=True, name="one"), zone("d", no_stop=True, name="two")]
    traffic = Traffic(lay("a b c d e", zones=zones))
    traffic.hold(V1, path("b"))
    assert traffic.claim(V1, path("c d"), goal_included=False).granted == path("c")


def test_a_vehicle_beyond_a_no_stop_zone_is_named_as_the_reason_to_wait_before_it(lay: Lay, zone: MakeZone) -> None:
    traffic = Traffic(lay("a b c d", zones=[zone("b c", no_stop=True)]))
    traffic.hold(V2, path("d"))
    blocked = Blocked(b("d"), V2, BlockReason.HELD)
    assert traffic.claim(V1, path("a b c d"), goal_included=True) == Grant(path("a"), blocked)
    assert traffic.held(V1) == path("a")


def test_closed_track_is_granted_to_nobody_until_it_opens(lay: Lay) -> None:
    traffic = Traffic(lay("a b"))
    traffic.close(path("b"), "V9 stands here, broken")
    blocked = Blocked(b("b"), None, BlockReason.CLOSED, note="V9 stands here, broken")
    assert traffic.claim(V1, path("a b"), goal_included=True) == Grant(path("a"), blocked)
    assert traffic.closed == {"b": "V9 stands here, broken"}
    traffic.open(path("b a"))
    assert traffic.waiters(path("b")) == {V1}
    assert traffic.claim(V1, path("b"), goal_included=True).blocked is None


def test_holding_by_force_reports_whom_it_clashes_with_and_locks_both_out(lay: Lay) -> None:
    traffic = Traffic(lay("a b c"))
    traffic.claim(V1, path("a b"), goal_included=False)
    assert traffic.hold(V2, path("b c")) == {(b("b"), V1)}
    assert traffic.holders(b("b")) == {V1, V2}
    for vehicle in (V1, V2, V3):
        assert traffic.claim(vehicle, path("b"), goal_included=False).granted == ()
    traffic.release(V1, path("b"))
    assert traffic.holders(b("b")) == {V2}
    assert traffic.claim(V2, path("b"), goal_included=False).granted == path("b")


def test_holding_by_force_reports_conflicts_too(lay: Lay) -> None:
    traffic = Traffic(lay("w e", "s n", at=CROSS))
    traffic.hold(V1, path("w e"))
    assert traffic.hold(V2, path("s n")) == {(b("n"), V1)}


def test_clearing_gives_everything_back_and_forgets_what_was_wanted(lay: Lay) -> None:
    traffic = Traffic(lay("a b c"))
    traffic.hold(V2, path("c"))
    traffic.claim(V1, path("a b c"), goal_included=True)
    traffic.clear(V1)
    assert traffic.held(V1) == ()
    assert traffic.blocked == {}
    assert traffic.snapshot().held == {V2: path("c")}
    traffic.clear(V3)


def test_forgetting_drops_the_refusal_only(lay: Lay) -> None:
    traffic = Traffic(lay("a b c"))
    traffic.hold(V2, path("c"))
    traffic.claim(V1, path("b c"), goal_included=True)
    traffic.forget(V1)
    assert traffic.blocked == {}
    assert traffic.held(V1) == path("b")


def test_obstacle_says_what_stands_against_a_claim_without_making_it(lay: Lay) -> None:
    traffic = Traffic(lay("a b"))
    traffic.hold(V2, path("b"))
    assert traffic.obstacle(V1, b("a")) is None
    assert traffic.obstacle(V1, b("b")) == Blocked(b("b"), V2, BlockReason.HELD)
    assert traffic.obstacle(V2, b("b")) is None
    assert traffic.blocked == {}


def ring(lay: Lay, *zones: Zone) -> Traffic:
    """Return the traffic of a ring on which V1, V2 and V3 stand one behind the other and a is where V3 goes next."""
    traffic = Traffic(lay("a b c a", zones=zones))
    for vehicle, place in ((V1, "a"), (V2, "b"), (V3, "c")):
        traffic.hold(vehicle, path(place))
    return traffic


def test_a_full_ring_is_a_cycle_that_starts_with_its_smallest_name(lay: Lay) -> None:
    traffic = ring(lay)
    for vehicle, wanted in ((V3, "a"), (V2, "c"), (V1, "b")):
        assert traffic.cycles() == ()
        traffic.claim(vehicle, path(wanted), goal_included=True)
    traffic.claim(V4, path("a"), goal_included=True)
    assert traffic.cycles() == ((V1, V2, V3),)
    view = traffic.snapshot()
    assert view.cycles == ((V1, V2, V3),)
    assert set(view.blocked) == {V1, V2, V3, V4}


def test_a_cycle_is_judged_by_what_stands_there_now(lay: Lay) -> None:
    traffic = ring(lay)
    for vehicle, wanted in ((V3, "a"), (V2, "c"), (V1, "b")):
        traffic.claim(vehicle, path(wanted), goal_included=True)
    traffic.release(V2, path("b"))
    assert traffic.cycles() == ()


def test_waiting_for_an_opening_is_no_deadlock(lay: Lay) -> None:
    traffic = ring(lay)
    for vehicle, wanted in ((V3, "a"), (V2, "c"), (V1, "b")):
        traffic.claim(vehicle, path(wanted), goal_included=True)
    traffic.close(path("b"), "oil")
    assert traffic.cycles() == ()


def test_waiting_for_room_in_a_zone_is_a_deadlock_only_if_everyone_inside_is_locked(lay: Lay, zone: MakeZone) -> None:
    traffic = Traffic(lay("a b", "x y z", zones=[zone("x y z", 2)]))
    traffic.hold(V1, path("a"))
    traffic.hold(V2, path("x"))
    traffic.hold(V3, path("y"))
    traffic.claim(V1, path("z"), goal_included=True)
    traffic.claim(V2, path("a"), goal_included=True)
    assert traffic.cycles() == ()
    traffic.claim(V3, path("a"), goal_included=True)
    assert traffic.cycles() == ((V1, V2),)


def test_two_rings_are_two_cycles(lay: Lay) -> None:
    traffic = Traffic(lay("a b a", "x y x"))
    for vehicle, here in ((V4, "a"), (V2, "b"), (V3, "x"), (V1, "y")):
        traffic.hold(vehicle, path(here))
    for vehicle, there in ((V4, "b"), (V2, "a"), (V3, "y"), (V1, "x")):
        traffic.claim(vehicle, path(there), goal_included=True)
    assert traffic.cycles() == ((V1, V3), (V2, V4))


def test_the_views_cannot_be_changed_from_outside(lay: Lay) -> None:
    traffic = Traffic(lay("a b"))
    with pytest.raises(TypeError):
        traffic.blocked[V1] = Blocked(b("a"), None, BlockReason.CLOSED)  # type: ignore[index]


def test_a_vehicle_bars_what_it_holds_what_excludes_that_and_the_zones_that_it_fills_alone(
    lay: Lay, zone: MakeZone
) -> None:
    zones = [zone("b3 b4 b5", name="one"), zone("b6 b7", 2, name="two")]
    at = CROSS | {f"b{n}": (9000 * n, 9000) for n in range(1, 8)}
    traffic = Traffic(lay("b1 b2 b3 b4 b5 b6 b7", "w e", "s n", at=at, zones=zones))
    assert traffic.barred_by(V1) == ()
    traffic.hold(V1, path("b2 b3 b6"))
    assert traffic.barred_by(V1) == path("b2 b3 b4 b5 b6")
    traffic.hold(V2, path("n"))
    assert traffic.barred_by(V2) == path("n e")
    traffic.clear(V1)
    assert traffic.barred_by(V1) == ()
