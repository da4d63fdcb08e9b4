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
    ``order``: for each goal the forks (buffers that lead to several) by how far they were when its row was grown, ``known`` of
    them. A buffer that is no fork leads to one: on to ``fork``, the first fork on its way (itself, if it is one; -1: it comes to
    none), in ``lead`` seconds by the weights of version ``led``; ``outward``: buffers by how many others lie between.
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
    fork: Whole
    outward: Whole
    lead: Real
    led: Whole
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
    fork, steps = _forks(net)
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
        fork=fork,
        outward=np.argsort(steps, kind="stable").astype(np.int64),
        lead=np.zeros(size),
        led=np.full(1, -1, dtype=np.int64),
        extra=np.zeros(size),
    )


def _forks(net: Network) -> tuple[Whole, Whole]:
    """Return the first fork on the way of each buffer, and over how many others it comes there."""
    size = len(net.first)
    fork, steps = np.full(size, -1, dtype=np.int64), np.zeros(size, dtype=np.int64)
    for start in range(size):
        here = start
        while steps[start] <= size:
            count = net.next_at[here + 1] - net.next_at[here]
            if count != 1:
                fork[start] = here if count > 1 else -1
                break
            here = int(net.next_to[net.next_at[here]])
            steps[start] += 1
    return fork, steps


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
        if ways.fork[here] == here and here != goal:
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
def lead(ways: Ways, net: Network) -> None:
    """Add up how far it is from each buffer to the first fork on its way."""
    for here in ways.outward:
        on = ways.fork[here] >= 0 and ways.fork[here] != here
        ways.lead[here] = ways.weight[here] + ways.lead[net.next_to[net.next_at[here]]] if on else 0.0
    ways.led[0] = ways.version[0]


@compiled
def _beyond(ways: Ways, far: Real, here: int) -> float:
    """Return how far it is from a buffer to the goal of a row: as far as it is written, or over the first fork on its way."""
    if far[here] < np.inf or ways.fork[here] < 0:
        return float(far[here])
    return float(ways.lead[here] + far[ways.fork[here]])


@compiled
def _relax(ways: Ways, net: Network, goal: int, hop: Whole) -> bool:
    """Let forks come nearer to the goal by a next buffer that is; return whether one did."""
    far, nearer = ways.far[goal], False
    for i in range(ways.known[goal]):
        here = ways.order[goal, i]
        for c in range(net.next_at[here], net.next_at[here + 1]):
            time = _beyond(ways, far, net.next_to[c]) + ways.weight[here]
            if time < far[here]:
                far[here], hop[here], nearer = time, net.next_to[c], True
    return nearer


@compiled
def renew(ways: Ways, net: Network, goal: int, hop: Whole) -> bool:
    """Make the row of a goal anew by the order of its old one, which weights of now change little; return whether that did.

    Forks are gone through in that order until none gets nearer any more: by then they are as exact as grown ones. Whatever
    comes to the goal without a fork is that far; from all other buffers there is one way, on to the next fork.
    """
    far, heap = ways.far[goal], ways.heap
    far[:] = np.inf
    far[goal], heap[0], size, passes = 0.0, goal, 1, 0
    while size > 0:
        size -= 1
        here = heap[size]
        for i in range(ways.before_at[here], ways.before_at[here + 1]):
            other = ways.before[i]
            if ways.fork[other] != other and far[other] == np.inf:
                far[other] = far[here] + ways.weight[other]
                heap[size] = other
                size += 1
    while _relax(ways, net, goal, hop):
        passes += 1
        if passes > PASSES:
            return False
    for here in range(len(far)):
        far[here] = _beyond(ways, far, here)
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
    if ways.led[0] != ways.version[0]:
        lead(ways, net)
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
