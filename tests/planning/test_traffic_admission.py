"""Traffic with admission: a slot of every buffer entered, by the rule, and nobody locks up."""

from collections.abc import Callable

import pytest

from app.domain.ids import VehicleId, ZoneId
from app.domain.layout import Meter, Zone
from app.domain.units import Barcode, Seconds
from app.planning.admission import ADMITTED, ANY, CIRCLE, FULL, admits, enter, lines
from app.planning.blocking import BlockReason
from app.planning.track import Track
from app.planning.traffic import Traffic
from tests.planning.yard import Yard

V1, V2, V3, V4, V5 = (VehicleId(f"V{i}") for i in range(1, 6))
SEEDS = range(40)
FORK = ("a1 a2 a3 a4 b1 b2 b3 b4", "a4 c1 c2 c3 c4 a1", "b4 a1")


def way(text: str) -> list[Barcode]:
    return [Barcode(b) for b in text.split()]


@pytest.fixture
def fork(lay: Callable[..., Track]) -> Traffic:
    """Two rings over one way, a1 to a4, four slots each."""
    return Traffic(lay(*FORK, length=1500), admission=True)


def fill(traffic: Traffic, places: str, number: int = 10) -> list[VehicleId]:
    """Put vehicles down, the first of them farthest ahead."""
    names = [VehicleId(f"W{number + i}") for i, _ in enumerate(places.split())]
    for name, place in zip(names, places.split(), strict=True):
        traffic.hold(name, [Barcode(place)])
    return names


def test_a_full_buffer_is_not_entered_and_its_head_is_named(fork: Traffic) -> None:
    head, *_ = fill(fork, "b4 b3 b2")
    fork.claim(V2, way("b1"), goal_included=True)
    fork.release(V2, ())
    fork.hold(V1, way("a4"))
    fork.release(VehicleId("W12"), ())
    blocked = fork.claim(V1, way("b1"), goal_included=False, beyond=way("b2 b3")).blocked
    assert blocked is not None
    assert blocked.why is BlockReason.HELD
    fork.release(V2, way("b1"))
    fork.hold(V3, way("b2 b1"))
    fork.release(V3, way("b1"))
    blocked = fork.claim(V1, way("b1"), goal_included=True).blocked
    assert blocked is not None
    assert (blocked.why, blocked.by, blocked.at) == (BlockReason.FULL, head, "b1")


def test_the_slot_is_taken_when_the_grant_is_given_not_when_the_vehicle_arrives(fork: Traffic) -> None:
    assert fork.queues is not None
    buffer = fork.queues.buffers.at(Barcode("b1"))
    fork.hold(V1, way("a3"))
    fork.claim(V1, way("a4 b1 b2"), goal_included=True)
    assert fork.queues.slot(V1) == buffer
    assert fork.queues.load(buffer) == 1


def test_a_vehicle_cut_short_wants_the_next_buffer_on_its_way_not_the_one_after(fork: Traffic) -> None:
    assert fork.queues is not None
    fork.hold(V1, way("c4"))
    fork.hold(V2, way("b1"))
    grant = fork.claim(V1, way("a1 a2 a3 a4 b1 b2 b3 b4"), goal_included=False, beyond=way("a1 a2"))
    assert grant.granted == tuple(way("a1 a2 a3 a4"))
    assert fork.queues.want(V1) == fork.queues.buffers.at(Barcode("b1"))


def test_the_rest_of_a_way_need_not_be_copied(fork: Traffic) -> None:
    assert fork.queues is not None
    fork.hold(V1, way("c4"))
    whole = way("a1 a2 a3 a4 b1 b2")
    assert fork.claim(V1, whole[:2], goal_included=False, beyond=whole, begun=2).granted == tuple(whole[:2])
    assert fork.queues.want(V1) == fork.queues.buffers.at(Barcode("b1"))


def test_what_is_given_back_ahead_gives_the_slot_back(fork: Traffic) -> None:
    assert fork.queues is not None
    fork.hold(V1, way("a3"))
    fork.claim(V1, way("a4 b1 b2"), goal_included=True)
    fork.release(V1, way("a4 b1 b2"))
    assert fork.queues.slot(V1) == fork.queues.buffers.at(Barcode("a3"))
    assert fork.queues.load(fork.queues.buffers.at(Barcode("b1"))) == 0


def test_vehicles_put_down_come_into_line_by_where_they_stand_in_whatever_order_they_are_put(fork: Traffic) -> None:
    assert fork.queues is not None
    fork.hold(V1, way("b1"))
    fork.hold(V2, way("b4"))
    fork.hold(V3, way("b2"))
    assert fork.queues.line(fork.queues.buffers.at(Barcode("b1"))) == (V2, V3, V1)


def test_more_vehicles_than_slots_may_be_put_down(lay: Callable[..., Track]) -> None:
    traffic = Traffic(lay("a1 a2 a3 a4 b1 b2", "a4 c1", length=900), admission=True)
    assert traffic.queues is not None
    fill(traffic, "a4 a3 a2 a1")
    buffer = traffic.queues.buffers.at(Barcode("a1"))
    assert traffic.queues.load(buffer) == 4 > traffic.queues.buffers.capacity[buffer]


def test_the_last_slot_is_kept_for_the_head_that_would_close_the_circle_and_it_is_named(fork: Traffic) -> None:
    """a is full, its head wants b; b has one slot left, and its head wants a: who came from c would close the circle."""
    blocked = None
    a_head, *_ = fill(fork, "a4 a3 a2")
    fork.claim(a_head, (), goal_included=False, beyond=way("b1 b2"))
    b_head, *_ = fill(fork, "b4 b3 b2 b1", 20)
    fork.claim(b_head, (), goal_included=False, beyond=way("a1 a2"))
    fork.hold(V1, way("c4"))
    blocked = fork.claim(V1, way("a1"), goal_included=False, beyond=way("a2 a3 a4 c1")).blocked
    assert blocked is not None
    assert (blocked.why, blocked.by) == (BlockReason.CIRCLE, b_head)
    assert fork.claim(b_head, way("a1"), goal_included=True).blocked is None, "whose turn it is"


def test_who_was_refused_a_slot_is_woken_when_one_is_given_back_and_by_nothing_else(fork: Traffic) -> None:
    head, *_ = fill(fork, "b4 b3 b2")
    fork.hold(V2, way("b2"))
    fork.hold(V1, way("a4"))
    fork.waiters(())
    assert fork.claim(V1, way("b1"), goal_included=True).blocked is not None
    assert V1 not in fork.waiters(way("b1 b2 b3"))
    fork.claim(head, way("a1"), goal_included=True)
    assert V1 in fork.waiters(())
    assert V1 not in fork.waiters(())


def test_a_head_keeps_what_it_wanted_where_a_change_could_close_a_circle(fork: Traffic) -> None:
    head, *_ = fill(fork, "a4 a3 a2 a1")
    fork.claim(head, (), goal_included=False, beyond=way("c1 c2"))
    b_head, *_ = fill(fork, "b4 b3 b2 b1", 20)
    fork.claim(b_head, (), goal_included=False, beyond=way("a1 a2"))
    assert fork.queues is not None
    c = fork.queues.buffers.at(Barcode("c1"))
    fork.claim(head, (), goal_included=False, beyond=way("b1 b2"))
    assert fork.queues.want(head) == c
    assert fork.strays(head, way("b1 b2"))
    assert not fork.turns(head, way("b1 b2"))
    assert fork.turns(head, way("c1 c2"))
    assert fork.claim(head, way("c1"), goal_included=True).granted == ("c1",)


def test_a_head_turns_to_another_queue_where_no_circle_closes_by_it_and_is_committed_to_that(fork: Traffic) -> None:
    head, *_ = fill(fork, "a4 a3 a2 a1")
    fork.claim(head, (), goal_included=False, beyond=way("c1 c2"))
    assert fork.turns(head, way("b1 b2"))
    assert not fork.strays(head, way("b1 b2"))
    assert fork.strays(head, way("c1 c2"))


def test_a_goal_in_a_transit_buffer_asks_for_no_slot_of_it(lay: Callable[..., Track]) -> None:
    traffic = Traffic(lay("a1 a2 a3 a4 x b1 b2 b3 b4 a1", "a4 c1 c2 c3 x", "b4 c1", length=1500), admission=True)
    queues = traffic.queues
    assert queues is not None
    crossed = queues.buffers.at(Barcode("x"))
    assert not queues.buffers.transit[crossed] or queues.waits_in(Barcode("x")) == -1
    track = lay("a1 a2 a3 a4 x b1 b2 b3 b4 a1", "a4 c1 c2 c3 c4 a1", "y1 y2 y3 y4 b1", "b4 y1", length=1500)
    traffic = Traffic(track, admission=True)
    queues = traffic.queues
    assert queues is not None
    assert queues.waits_in(Barcode("x")) == -1, "one slot: crossed in one go"
    traffic.hold(V1, way("a4"))
    fill(traffic, "b4 b3 b2 b1")
    assert traffic.claim(V1, way("x"), goal_included=False, beyond=way("b1")).granted == ()
    assert traffic.claim(V1, way("x"), goal_included=True).blocked is None
    traffic.release(V1, way("a4"))
    assert queues.slot(V1) == queues.buffers.at(Barcode("a4"))


def test_a_grant_ends_beyond_a_transit_buffer_with_a_slot_or_before_it(lay: Callable[..., Track]) -> None:
    track = lay("a1 a2 a3 a4 x b1 b2 b3 b4 a1", "a4 c1 c2 c3 c4 a1", "y1 y2 y3 y4 b1", "b4 y1", length=1500)
    traffic = Traffic(track, admission=True)
    traffic.hold(V1, way("a2"))
    assert traffic.claim(V1, way("a3 a4 x"), goal_included=False, beyond=way("b1")).granted == ("a3", "a4")
    assert traffic.claim(V1, way("x b1"), goal_included=False, beyond=way("b2")).granted == ("x", "b1")


def test_random_networks_never_lock_up_by_the_rule() -> None:
    yards = [Yard(seed, admission=True) for seed in SEEDS]
    assert [seed for seed, yard in zip(SEEDS, yards, strict=True) if yard.run(120)] == []
    assert sum(yard.moves for yard in yards) > 5_000


def test_random_networks_lock_up_without_it() -> None:
    assert sum(Yard(seed, admission=False).run(120) for seed in SEEDS) > len(SEEDS) // 3


def test_every_answer_is_that_of_the_rule() -> None:
    """One barcode at a time, against lines kept beside."""
    words = {FULL: BlockReason.FULL, CIRCLE: BlockReason.CIRCLE}
    given = dict.fromkeys((ADMITTED, *words), 0)
    for seed in range(25):
        yard = Yard(seed, admission=True, pitch=1 + seed % 2)
        queues, buffers = yard.traffic.queues, yard.buffers
        assert queues is not None
        names = sorted(yard.at)
        beside = lines(buffers, len(names))
        for buffer in range(len(buffers)):
            for vehicle in queues.line(buffer):
                enter(beside, names.index(vehicle), buffer, queues.want(vehicle))
        for _ in range(400):
            vehicle = yard.rng.choice(names)
            if not yard.way[vehicle]:
                yard.way[vehicle] = yard.way_from(yard.at[vehicle])
            number, after = names.index(vehicle), yard.way[vehicle]
            if queues.head(queues.slot(vehicle)) == vehicle:
                yard.traffic.claim(vehicle, (), goal_included=False, beyond=after)
            beside.want[number] = queues.want(vehicle)
            buffer = buffers.at(after[0])
            free = yard.traffic.obstacle(vehicle, after[0]) is None
            want = next((c for b in after[1:] if (c := buffers.at(b)) != buffer or b == buffers.chains[c][0]), ANY)
            answer = admits(beside, number, buffer, want)
            blocked = yard.drive(vehicle, most=1)
            beside.want[number] = queues.want(vehicle)
            if free:
                assert (blocked.why if blocked else None) == words.get(answer)
                given[answer] += 1
            if blocked is None and (buffer != beside.slot[number] or yard.at[vehicle] == buffers.chains[buffer][0]):
                enter(beside, number, buffer, want)
    assert all(count > 20 for count in given.values()), given


# -- soft zones, and whose turn it is ---------------------------------------------------------------------------------

MERGE = ("a1 a2 a3 a4 b1 b2 b3 b4 a1", "c1 c2 c3 c4 b1", "b4 c1")


def soft(lay: Callable[..., Track], share: float) -> Traffic:
    """Two branches, a and c, into b, of whose four slots a share may be filled."""
    inside = frozenset(way("b1 b2 b3 b4"))
    zone = Zone(ZoneId("spine"), inside, 1, meter=Meter(share, Seconds(60)))
    return Traffic(lay(*MERGE, length=1500, zones=[zone]), admission=True)


def test_a_soft_zone_takes_in_no_more_than_its_share_until_one_has_waited_long_enough(
    lay: Callable[..., Track],
) -> None:
    traffic = soft(lay, 0.5)
    fill(traffic, "b4 b3")
    traffic.hold(V1, way("a4"))
    blocked = traffic.claim(V1, way("b1"), goal_included=True, now=Seconds(100)).blocked
    assert blocked is not None
    assert (blocked.why, blocked.zone, blocked.by) == (BlockReason.METER, "spine", None)
    assert traffic.claim(V1, way("b1"), goal_included=True, now=Seconds(159)).blocked is not None
    assert traffic.cycles() == ()
    assert traffic.claim(V1, way("b1"), goal_included=True, now=Seconds(160)).blocked is None


def test_who_waits_before_a_soft_zone_is_woken_when_one_leaves_it(lay: Callable[..., Track]) -> None:
    traffic = soft(lay, 0.5)
    head, _ = fill(traffic, "b4 b3")
    traffic.hold(V1, way("a4"))
    traffic.waiters(())
    assert traffic.claim(V1, way("b1"), goal_included=True, now=Seconds(1)).blocked is not None
    traffic.claim(head, way("c1"), goal_included=True, now=Seconds(2))
    assert V1 in traffic.waiters(())
    assert traffic.claim(V1, way("b1"), goal_included=True, now=Seconds(2)).blocked is None


def test_who_is_let_into_a_soft_zone_at_last_may_be_granted_two_of_its_buffers_at_once(
    lay: Callable[..., Track],
) -> None:
    zone = Zone(ZoneId("spine"), frozenset(way("b1 b2 b3 b4 c1 c2 c3 c4")), 1, meter=Meter(0.25, Seconds(60)))
    traffic = Traffic(lay(*MERGE, length=1500, zones=[zone]), admission=True)
    fill(traffic, "c4 c3")
    traffic.hold(V1, way("a4"))
    ahead = way("b1 b2 b3 b4 c1 c2")
    blocked = traffic.claim(V1, ahead, goal_included=True, now=Seconds(0)).blocked
    assert blocked is not None
    assert blocked.why is BlockReason.METER
    grant = traffic.claim(V1, ahead, goal_included=True, now=Seconds(60))
    assert (grant.granted, grant.blocked) == (tuple(ahead), None)


def test_a_soft_zone_of_small_share_takes_in_one_and_more_than_its_capacity_says(lay: Callable[..., Track]) -> None:
    assert soft(lay, 0.01).claim(V1, way("b1"), goal_included=True).blocked is None
    traffic = soft(lay, 1.0)
    fill(traffic, "b4 b3")
    traffic.hold(V1, way("a4"))
    assert traffic.claim(V1, way("b1"), goal_included=True).blocked is None


def waiting_at_a_merge(lay: Callable[..., Track]) -> tuple[Traffic, VehicleId]:
    """V1 has been refused a slot of b from a, which is full, at 0 s; then its head leaves."""
    traffic = Traffic(lay(*MERGE, "b4 d1 d2 d3 d4 a1", length=1500), admission=True)
    heads = fill(traffic, "b4 b3 b2")
    traffic.hold(VehicleId("W19"), way("b2 b1"))
    traffic.release(VehicleId("W19"), way("b1"))
    traffic.hold(V1, way("a4"))
    traffic.hold(V2, way("c4"))
    assert traffic.claim(V1, way("b1"), goal_included=True, now=Seconds(0)).blocked is not None
    traffic.claim(heads[0], way("d1"), goal_included=True, now=Seconds(50))
    return traffic, heads[1]


def test_who_has_waited_very_long_at_a_merge_goes_before_the_other_branch(lay: Callable[..., Track]) -> None:
    traffic, _ = waiting_at_a_merge(lay)
    blocked = traffic.claim(V2, way("b1"), goal_included=True, now=Seconds(50)).blocked
    assert blocked is not None
    assert (blocked.why, blocked.by) == (BlockReason.TURN, V1)
    assert traffic.claim(V1, way("b1"), goal_included=True, now=Seconds(50)).blocked is None
    assert V2 in traffic.waiters(())


def test_who_lets_another_go_first_does_so_for_a_while_only(lay: Callable[..., Track]) -> None:
    traffic, _ = waiting_at_a_merge(lay)
    assert traffic.claim(V2, way("b1"), goal_included=True, now=Seconds(50)).blocked is not None
    assert traffic.claim(V2, way("b1"), goal_included=True, now=Seconds(54)).blocked is None


def test_who_has_waited_for_a_short_while_has_no_turn(lay: Callable[..., Track]) -> None:
    traffic, _ = waiting_at_a_merge(lay)
    assert traffic.claim(V2, way("b1"), goal_included=True, now=Seconds(20)).blocked is None
