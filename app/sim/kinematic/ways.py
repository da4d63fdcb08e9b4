"""Next hops over buffers, at the weights of the moment: a row for each goal, made when it is first asked for."""

from typing import NamedTuple

import numpy as np

from app.sim.kinematic.compiled import compiled
from app.sim.kinematic.network import Network, Real, Whole

PASSES = 8
"""Times that a row is gone through before it is grown from the start instead. Our choice."""


class Ways(NamedTuple):
    """Per buffer: ``weight``, seconds from its first barcode to a next one's; ``before_at`` (one longer) into ``before``, the
    buffers that lead to it; ``made``, the version of its row. ``far`` has a row per goal: seconds from each buffer's first
    barcode to the goal's first. ``version`` of the weights. ``reach``: seconds to a barcode from its buffer's first.
    ``order``: for each goal its buffers by how far they were when its row was grown, ``known`` of them.
    """

    weight: Real
    before_at: Whole
    before: Whole
    made: Whole
    far: Real
    version: Whole
    reach: Real
    heap: Whole
    place: Whole
    order: Whole
    known: Whole
    extra: Real
    """Seconds that a buffer costs besides, unless one stands in it: it is kept free for idle vehicles."""


def survey(net: Network) -> Ways:
    """Return the ways of a network at free flow."""
    size = len(net.first)
    found: list[list[int]] = [[] for _ in range(size)]
    for here in range(size):
        for c in range(net.next_at[here], net.next_at[here + 1]):
            found[net.next_to[c]].append(here)
    at = np.cumsum([0, *(len(f) for f in found)])
    reach = np.zeros(len(net.buffer))
    for b in range(1, len(reach)):
        if net.buffer[b] == net.buffer[b - 1]:
            reach[b] = reach[b - 1] + net.gap[b - 1] / net.speed[b - 1]
    return Ways(
        weight=free_flow(net),
        before_at=at.astype(np.int64),
        before=np.array([h for f in found for h in f], dtype=np.int64),
        made=np.full(size, -1, dtype=np.int64),
        far=np.full((size, size), np.inf),
        version=np.zeros(1, dtype=np.int64),
        reach=reach,
        heap=np.zeros(size + 1, dtype=np.int64),
        place=np.zeros(size, dtype=np.int64),
        order=np.zeros((size, size), dtype=np.int32),
        known=np.zeros(size, dtype=np.int64),
        extra=np.zeros(size),
    )


def free_flow(net: Network) -> Real:
    """Return the seconds from each buffer's first barcode to a next one's at full speed, over its quickest connection."""
    out = net.inside.copy()
    for here in range(len(out)):
        ways = [net.next_gap[c] / net.next_speed[c] for c in range(net.next_at[here], net.next_at[here + 1])]
        out[here] += min(ways, default=0.0)
    return out


@compiled
def _sink(far: Real, heap: Whole, place: Whole, size: int) -> None:
    """Put the buffer at ``heap[size]`` where the nearest was, and let it sink."""
    last, at = heap[size], 0
    while True:
        below = 2 * at + 1
        if below >= size:
            break
        if below + 1 < size and far[heap[below + 1]] < far[heap[below]]:
            below += 1
        if far[heap[below]] >= far[last]:
            break
        heap[at] = heap[below]
        place[heap[at]] = at
        at = below
    heap[at] = last
    place[last] = at


@compiled
def _rise(far: Real, heap: Whole, place: Whole, buffer: int, at: int) -> None:
    """Let a buffer at that place of the heap, or new there, rise."""
    while at > 0:
        above = (at - 1) // 2
        if far[heap[above]] <= far[buffer]:
            break
        heap[at] = heap[above]
        place[heap[at]] = at
        at = above
    heap[at] = buffer
    place[buffer] = at


@compiled
def grow(ways: Ways, goal: int, hop: Whole) -> None:
    """Make the row of a goal: Dijkstra's algorithm backwards from it. From the goal itself the way leads once round."""
    far, heap, place = ways.far[goal], ways.heap, ways.place
    far[:] = np.inf
    hop[:] = -1
    place[:] = -1
    far[goal], heap[0], place[goal], size, around, known = 0.0, goal, 0, 1, np.inf, 0
    while size > 0:
        here = heap[0]
        ways.order[goal, known] = here
        known += 1
        size -= 1
        if size > 0:
            _sink(far, heap, place, size)
        place[here] = -2
        for i in range(ways.before_at[here], ways.before_at[here + 1]):
            other = ways.before[i]
            time = far[here] + ways.weight[other]
            if other == goal:
                if time < around:
                    around, hop[goal] = time, here
            elif place[other] != -2 and time < far[other]:
                far[other], hop[other] = time, here
                if place[other] < 0:
                    place[other] = size
                    size += 1
                _rise(far, heap, place, other, place[other])
    ways.known[goal] = known
    ways.made[goal] = ways.version[0]


@compiled
def renew(ways: Ways, net: Network, goal: int, hop: Whole) -> bool:
    """Make the row of a goal anew by the order of its old one, which weights of now change little; return whether that did.

    Rows are gone through in that order until nothing gets nearer any more: by then they are as exact as grown ones.
    """
    far, order, known = ways.far[goal], ways.order[goal], ways.known[goal]
    far[:] = np.inf
    hop[:] = -1
    far[goal], changed = 0.0, True
    for _ in range(PASSES):
        changed = False
        for i in range(1, known):
            here = order[i]
            for c in range(net.next_at[here], net.next_at[here + 1]):
                time = far[net.next_to[c]] + ways.weight[here]
                if time < far[here]:
                    far[here], hop[here], changed = time, net.next_to[c], True
        if not changed:
            break
    if changed:
        return False
    around = np.inf
    for c in range(net.next_at[goal], net.next_at[goal + 1]):
        after = net.next_to[c]
        if far[after] + ways.weight[goal] < around:
            around, hop[goal] = far[after] + ways.weight[goal], after
    ways.made[goal] = ways.version[0]
    return True


@compiled
def refresh(ways: Ways, net: Network, hops: Whole, goals: Whole) -> int:
    """Make the rows of these goals where they are older than the weights; return how many were made."""
    made = 0
    for goal in goals:
        if ways.made[goal] != ways.version[0]:
            if ways.made[goal] < 0 or not renew(ways, net, goal, hops[goal]):
                grow(ways, goal, hops[goal])
            made += 1
    return made


@compiled
def drives(ways: Ways, net: Network, hops: Whole, starts: Whole, goals: Whole, out: Real) -> None:
    """Write the seconds from each start (rows) to each goal (columns) into ``out``. All are barcodes; the goals have rows."""
    for j in range(len(goals)):
        goal = goals[j]
        there, beyond = net.buffer[goal], ways.reach[goal]
        far, after = ways.far[there], hops[there, there]
        around = np.inf if after < 0 else ways.weight[there] + far[after]
        for i in range(len(starts)):
            at = starts[i]
            here = net.buffer[at]
            time = far[here] - ways.reach[at] + beyond - ways.extra[here]
            if here == there and goal < at:
                time += around
            out[i, j] = time
