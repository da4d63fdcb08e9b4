"""Where vehicles of the fast plant go, and what track they are granted. Everything here is compiled if it can be."""

from math import sqrt

from app.planning.admission import ADMITTED, ANY, CIRCLE, FULL, admits, enter, may_want
from app.sim.kinematic.compiled import compiled
from app.sim.kinematic.network import Network
from app.sim.kinematic.state import (
    AHEAD,
    ASKED,
    CIRCLES,
    GRANTED,
    IDLE,
    PLAN,
    PUSHED,
    REFUSED,
    STANDING,
    WATCHED,
    Rules,
    State,
)
from app.sim.kinematic.waiting import ask_again, forget_waits, wait_for, wake_watchers, watch

# -- where to --------------------------------------------------------------------------------------------------------------


@compiled
def hop_to(net: Network, s: State, goal: int, here: int) -> int:
    """Return the next buffer toward a goal's. Where the table has no row for that one, a vehicle is pushed there from nearby."""
    known = s.hop[goal, here]
    if known >= 0:
        return int(known)
    for c in range(net.next_at[here], net.next_at[here + 1]):
        after = net.next_to[c]
        if after == goal:
            return int(goal)
        if net.transit[after]:
            for d in range(net.next_at[after], net.next_at[after + 1]):
                if net.next_to[d] == goal:
                    return int(after)
    return -1


@compiled
def decide(net: Network, s: State, vehicle: int, buffer: int) -> None:
    """Decide which buffers the vehicle crosses next from this one, up to one where it may wait: by the table, to its goal."""
    n, here = 0, buffer
    goal = net.buffer[s.goal[vehicle]]
    while n < PLAN:
        after = hop_to(net, s, goal, here)
        if after < 0:
            break
        s.plan[vehicle, n] = after
        n += 1
        here = after
        if not net.transit[here] or here == goal:
            break
    s.planned[vehicle] = n


@compiled
def want_beyond(net: Network, s: State, vehicle: int, buffer: int) -> int:
    """Return where the vehicle will wait after this buffer; ANY if its goal lies in it, or there is none."""
    if s.goal[vehicle] < 0:
        return ANY
    goal = net.buffer[s.goal[vehicle]]
    if goal == buffer:
        return ANY
    here = buffer
    for _ in range(PLAN):
        here = hop_to(net, s, goal, here)
        if here < 0:
            return ANY
        if not net.transit[here] or here == goal:
            return int(here)
    return ANY


@compiled
def connection(net: Network, buffer: int, after: int) -> int:
    """Return the number of the connection from one buffer to a next one."""
    for c in range(net.next_at[buffer], net.next_at[buffer + 1]):
        if net.next_to[c] == after:
            return c
    return -1


# -- grants ------------------------------------------------------------------------------------------------------------------


@compiled
def collect(net: Network, s: State, vehicle: int, last: int) -> int:
    """Write the barcodes from ``last`` on to the next place where the vehicle may stop into ``scratch``; return how many.

    0: it has no way on. ``scratch[AHEAD]`` is the buffer in which a slot is needed then.
    """
    n, here, hop = 0, last, 0
    goal = s.goal[vehicle]
    buffer = net.buffer[here]
    while n < AHEAD - 1:
        if here == net.last[buffer]:
            if hop == s.planned[vehicle]:
                if hop > 0:
                    return 0
                decide(net, s, vehicle, buffer)
                if s.planned[vehicle] == 0:
                    return 0
            buffer = s.plan[vehicle, hop]
            hop += 1
            here = net.first[buffer]
        else:
            here += 1
        s.scratch[n] = here
        n += 1
        s.scratch[AHEAD] = buffer
        if here == goal or (net.stop[here] and not net.transit[buffer]):
            return n
    return 0


@compiled
def obstacle(s: State, vehicle: int, n: int) -> int:
    """Return the first of the barcodes in ``scratch`` that cannot be had, -1 if all can."""
    for i in range(n):
        barcode = s.scratch[i]
        if s.closed[barcode] or (s.owner[barcode] >= 0 and s.owner[barcode] != vehicle):
            return int(barcode)
    return -1


@compiled
def take_slot(net: Network, s: State, vehicle: int, buffer: int) -> None:
    """Give the vehicle a slot; whoever hangs on the one it leaves is asked again."""
    home = s.lines.slot[vehicle]
    if home == buffer:
        return
    enter(s.lines, vehicle, buffer, want_beyond(net, s, vehicle, buffer))
    s.planned[vehicle] = 0
    if home >= 0:
        wake_watchers(s, home)


@compiled
def need(net: Network, s: State, rules: Rules, vehicle: int) -> float:
    """Return how much must be granted so that the vehicle need not brake up to its next barcode, mm (TRAFFIC section 2)."""
    pace, fastest = s.pace[vehicle], net.speed[s.at[vehicle]]
    if s.granted[vehicle] > 0:
        fastest = s.limit[vehicle, 0]
    elif fastest == 0.0:
        fastest = 3000.0
    pace = max(pace, min(fastest, sqrt(pace * pace + 2 * rules.acceleration * rules.edge)))
    return float(pace * pace / (2 * rules.braking) + pace * rules.reaction + rules.edge)


@compiled
def extend(net: Network, s: State, rules: Rules, vehicle: int, now: float) -> None:
    """Grant the vehicle more track, up to ``rules.high``, or let it wait for what stands against it."""
    forget_waits(s, vehicle)
    if s.failed[vehicle]:
        return
    s.counts[ASKED] += 1
    needed = need(net, s, rules, vehicle)
    enough = needed + rules.more
    while s.left[vehicle] < enough:
        granted = s.granted[vehicle]
        last = s.at[vehicle] if granted == 0 else s.ahead[vehicle, granted - 1]
        if s.goal[vehicle] < 0 or last == s.goal[vehicle]:
            return
        if s.left[vehicle] >= needed and last == net.last[net.buffer[last]]:
            return
        n = collect(net, s, vehicle, last)
        if n == 0 or granted + n > AHEAD:
            return
        buffer = s.scratch[AHEAD]
        if rules.admission and not commit_want(s, vehicle, buffer):
            hang_on(s, vehicle, now)
            return
        blocking = obstacle(s, vehicle, n)
        if blocking >= 0:
            refuse(net, s, vehicle, blocking, now)
            return
        if buffer != s.lines.slot[vehicle]:
            if not may_enter(net, s, rules, vehicle, buffer, now):
                return
            take_slot(net, s, vehicle, buffer)
        take(net, s, vehicle, last, n)
        s.since[vehicle] = -1.0


@compiled
def may_enter(net: Network, s: State, rules: Rules, vehicle: int, buffer: int, now: float) -> bool:
    """Return whether the vehicle may have a slot of this buffer now; if not, it is asked again when that may have changed."""
    if not rules.admission:
        return True
    answer = admits(s.lines, vehicle, buffer, want_beyond(net, s, vehicle, buffer))
    if answer == ADMITTED:
        return True
    s.counts[CIRCLES] += answer == CIRCLE
    hang_on(s, vehicle, now)
    if answer == FULL:
        nudge(net, s, s.lines.head[buffer])
    return False


@compiled
def commit_want(s: State, vehicle: int, buffer: int) -> bool:
    """Let it be known that the vehicle wants to wait in this buffer next; False: a circle could close by that, it must wait."""
    lines, slot = s.lines, s.lines.slot[vehicle]
    if buffer == slot or lines.want[vehicle] == buffer:
        return True
    if not may_want(lines, vehicle, buffer):
        s.counts[CIRCLES] += 1
        return False
    lines.want[vehicle] = buffer
    if lines.head[slot] == vehicle:
        wake_watchers(s, slot)
    return True


@compiled
def hang_on(s: State, vehicle: int, now: float) -> None:
    """Let the vehicle be asked again when something changes in the buffers that its refusal came by (``events.remind``)."""
    s.counts[REFUSED] += 1
    for i in range(min(s.lines.seen[0], WATCHED)):
        watch(s, vehicle, s.lines.looked[i], now)


@compiled
def take(net: Network, s: State, vehicle: int, last: int, n: int) -> None:
    """Give the vehicle the barcodes in ``scratch``."""
    s.counts[GRANTED] += 1
    k, here = s.granted[vehicle], last
    for i in range(n):
        barcode = s.scratch[i]
        s.owner[barcode] = vehicle
        if barcode == here + 1 and net.buffer[barcode] == net.buffer[here]:
            way, limit = net.gap[here], net.speed[here]
        else:
            c = connection(net, net.buffer[here], net.buffer[barcode])
            way, limit = net.next_gap[c], net.next_speed[c]
        s.ahead[vehicle, k], s.way[vehicle, k], s.limit[vehicle, k] = barcode, way, limit
        s.left[vehicle] += way
        k += 1
        here = barcode
    s.granted[vehicle] = k


@compiled
def refuse(net: Network, s: State, vehicle: int, barcode: int, now: float) -> None:
    """Let the vehicle wait for a barcode; whoever stands idle on it is asked to go on, unless both park there."""
    s.counts[REFUSED] += 1
    slot, owner = s.lines.slot[vehicle], s.owner[barcode]
    parks = s.phase[vehicle] == IDLE and s.park[slot] == 1 and s.goal[vehicle] == net.last[slot]
    if parks and owner >= 0 and s.phase[owner] == IDLE and s.goal[owner] < 0:
        s.goal[vehicle], s.since[vehicle], s.lines.want[vehicle] = -1, -1.0, ANY
        return
    wait_for(s, vehicle, barcode, now)
    if s.owner[barcode] >= 0:
        nudge(net, s, s.owner[barcode])


@compiled
def nudge(net: Network, s: State, vehicle: int) -> None:
    """Push a vehicle that stands idle on: to the end of its own buffer if that is kept free for such ones, or of the next."""
    if vehicle < 0 or s.phase[vehicle] != IDLE or s.goal[vehicle] >= 0 or s.doing[vehicle] != STANDING:
        return
    buffer = net.buffer[s.at[vehicle]]
    closes_up = s.park[buffer] and s.at[vehicle] != net.last[buffer] and s.owner[s.at[vehicle] + 1] < 0
    best = buffer if closes_up else aside(s, buffer)
    if best < 0:
        return
    s.goal[vehicle] = net.last[best]
    s.lines.want[vehicle] = want_beyond(net, s, vehicle, buffer)
    s.planned[vehicle] = 0
    s.counts[PUSHED] += 1
    ask_again(s, vehicle)


@compiled
def aside(s: State, buffer: int) -> int:
    """Return the buffer after this one that has room and is kept free for idle vehicles, or else where fewest come by.

    -1: none comes after it.
    """
    best, least = -1, -1
    for i in range(s.lines.out_at[buffer], s.lines.out_at[buffer + 1]):
        out = s.lines.outs[i]
        passes = -1 if s.park[out] else s.passes[out]
        if s.lines.load[out] < s.lines.capacity[out] and (best < 0 or passes < least):
            best, least = out, passes
    if best < 0 and s.lines.out_at[buffer] < s.lines.out_at[buffer + 1]:
        best = s.lines.outs[s.lines.out_at[buffer]]
    return int(best)
