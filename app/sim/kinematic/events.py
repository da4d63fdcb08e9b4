"""The moves of the fast plant: grants, driving, waiting, waking. Everything here is compiled if it can be."""

from math import sqrt

from app.planning.admission import ADMITTED, ANY, CIRCLE, FULL, admits, enter, may_want
from app.sim.kinematic.compiled import compiled
from app.sim.kinematic.network import Network
from app.sim.kinematic.state import (
    AHEAD,
    ASKED,
    BROKEN,
    CIRCLES,
    DELIVERED,
    DRIVING,
    DWELLING,
    EVENTS,
    GRANTED,
    IDLE,
    LOADED,
    METERED,
    MILLIMETRES,
    PLAN,
    PUSHED,
    REFUSED,
    STANDING,
    WATCHED,
    Rules,
    State,
)

# -- the agenda: a heap of vehicles by when they are due ---------------------------------------------------------------


@compiled
def schedule(s: State, vehicle: int, due: float) -> None:
    """Let the vehicle be due at that time, sooner or later than it was."""
    s.due[vehicle] = due
    at = s.place[vehicle]
    if at < 0:
        at = s.size[0]
        s.size[0] += 1
        s.heap[at] = vehicle
        s.place[vehicle] = at
    while at > 0:
        above = (at - 1) // 2
        other = s.heap[above]
        if s.due[other] <= due:
            break
        s.heap[at] = other
        s.place[other] = at
        at = above
    s.heap[at] = vehicle
    s.place[vehicle] = at
    _sink(s, at)


@compiled
def _sink(s: State, at: int) -> None:
    vehicle, size = s.heap[at], s.size[0]
    due = s.due[vehicle]
    while True:
        below = 2 * at + 1
        if below >= size:
            break
        if below + 1 < size and s.due[s.heap[below + 1]] < s.due[s.heap[below]]:
            below += 1
        other = s.heap[below]
        if s.due[other] >= due:
            break
        s.heap[at] = other
        s.place[other] = at
        at = below
    s.heap[at] = vehicle
    s.place[vehicle] = at


@compiled
def unschedule_first(s: State) -> int:
    """Take the vehicle that is due first off the agenda."""
    vehicle = s.heap[0]
    s.place[vehicle] = -1
    s.size[0] -= 1
    if s.size[0] > 0:
        s.heap[0] = s.heap[s.size[0]]
        s.place[s.heap[0]] = 0
        _sink(s, 0)
    return int(vehicle)


# -- who waits for what --------------------------------------------------------------------------------------------------


@compiled
def ask_again(s: State, vehicle: int) -> None:
    """Put a vehicle in the queue of those that may be able to go on."""
    if s.queued[vehicle]:
        return
    s.queued[vehicle] = 1
    s.queue[s.size[2]] = vehicle
    s.size[2] = (s.size[2] + 1) % len(s.queue)


@compiled
def wait_for(s: State, vehicle: int, barcode: int, now: float) -> None:
    """Let a vehicle wait for a barcode, in the order in which they began to wait."""
    if s.since[vehicle] < 0:
        s.since[vehicle] = now
    since = s.since[vehicle]
    before, after = -1, s.waits_first[barcode]
    while after >= 0 and s.since[after] <= since:
        before, after = after, s.waits_next[after]
    s.waits_for[vehicle] = barcode
    s.waits_before[vehicle], s.waits_next[vehicle] = before, after
    if after >= 0:
        s.waits_before[after] = vehicle
    if before >= 0:
        s.waits_next[before] = vehicle
    else:
        s.waits_first[barcode] = vehicle


@compiled
def watch(s: State, vehicle: int, buffer: int, now: float) -> None:
    """Let a vehicle be asked again when something changes in a buffer."""
    if s.since[vehicle] < 0:
        s.since[vehicle] = now
    n = s.watching[vehicle]
    if n == WATCHED:
        return
    node, first = vehicle * WATCHED + n, s.watch_first[buffer]
    s.watches[vehicle, n] = buffer
    s.watching[vehicle] = n + 1
    s.watch_before[node], s.watch_next[node] = -1, first
    if first >= 0:
        s.watch_before[first] = node
    s.watch_first[buffer] = node


@compiled
def forget_waits(s: State, vehicle: int) -> None:
    """Take a vehicle out of all that it waits for."""
    barcode = s.waits_for[vehicle]
    if barcode >= 0:
        before, after = s.waits_before[vehicle], s.waits_next[vehicle]
        if before >= 0:
            s.waits_next[before] = after
        else:
            s.waits_first[barcode] = after
        if after >= 0:
            s.waits_before[after] = before
        s.waits_for[vehicle] = -1
    for n in range(s.watching[vehicle]):
        node = vehicle * WATCHED + n
        before, after = s.watch_before[node], s.watch_next[node]
        if before >= 0:
            s.watch_next[before] = after
        else:
            s.watch_first[s.watches[vehicle, n]] = after
        if after >= 0:
            s.watch_before[after] = before
    s.watching[vehicle] = 0


@compiled
def wake_watchers(s: State, buffer: int) -> None:
    """Ask again those that hang on this buffer."""
    node = s.watch_first[buffer]
    while node >= 0:
        ask_again(s, node // WATCHED)
        node = s.watch_next[node]


@compiled
def release(s: State, barcode: int) -> None:
    """Free a barcode, and ask again who waits for it, the longest wait first."""
    s.owner[barcode] = -1
    vehicle = s.waits_first[barcode]
    while vehicle >= 0:
        ask_again(s, vehicle)
        vehicle = s.waits_next[vehicle]


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
def metered(s: State, rules: Rules, vehicle: int, buffer: int, now: float) -> bool:
    """Return whether a meter keeps a vehicle that comes from outside from entering, for now."""
    meter = s.meter[buffer]
    if rules.patience <= 0 or meter < 0:
        return False
    home = s.lines.slot[vehicle]
    if home >= 0 and s.meter[home] == meter:
        return False
    if s.meter_room[meter] > 0:
        return False
    return bool(s.since[vehicle] < 0 or now < s.since[vehicle] + rules.patience)


@compiled
def take_slot(net: Network, s: State, vehicle: int, buffer: int) -> None:
    """Give the vehicle a slot; whoever hangs on the one it leaves is asked again."""
    home = s.lines.slot[vehicle]
    if home == buffer:
        return
    if home >= 0 and s.meter[home] >= 0:
        s.meter_room[s.meter[home]] += 1
    if s.meter[buffer] >= 0:
        s.meter_room[s.meter[buffer]] -= 1
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
    if metered(s, rules, vehicle, buffer, now):
        s.counts[METERED] += 1
        watch(s, vehicle, buffer, now)
        return False
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
    """Let the vehicle be asked again when something changes in the buffers that its refusal came by."""
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
    """Let the vehicle wait for a barcode; whoever stands idle on it is asked to go on."""
    s.counts[REFUSED] += 1
    wait_for(s, vehicle, barcode, now)
    if s.owner[barcode] >= 0:
        nudge(net, s, s.owner[barcode])


@compiled
def nudge(net: Network, s: State, vehicle: int) -> None:
    """Push a vehicle that stands idle on: to the end of the buffer after its own that has room and where fewest come by."""
    if vehicle < 0 or s.phase[vehicle] != IDLE or s.goal[vehicle] >= 0 or s.doing[vehicle] != STANDING:
        return
    buffer = net.buffer[s.at[vehicle]]
    best, least = -1, -1
    for i in range(s.lines.out_at[buffer], s.lines.out_at[buffer + 1]):
        out = s.lines.outs[i]
        if s.lines.load[out] < s.lines.capacity[out] and (best < 0 or s.passes[out] < least):
            best, least = out, s.passes[out]
    if best < 0 and s.lines.out_at[buffer] < s.lines.out_at[buffer + 1]:
        best = s.lines.outs[s.lines.out_at[buffer]]
    if best < 0:
        return
    s.goal[vehicle] = net.last[best]
    s.lines.want[vehicle] = want_beyond(net, s, vehicle, buffer)
    s.planned[vehicle] = 0
    s.counts[PUSHED] += 1
    ask_again(s, vehicle)


# -- driving -----------------------------------------------------------------------------------------------------------------


@compiled
def set_off(s: State, rules: Rules, vehicle: int, now: float) -> None:
    """Let the vehicle drive to the next barcode of its grant, so that it can stop at the last one."""
    s.began[vehicle] = now + (rules.restart if s.doing[vehicle] == STANDING else 0.0)
    s.initial[vehicle], s.rest[vehicle] = s.pace[vehicle], s.way[vehicle, 0]
    s.doing[vehicle] = DRIVING
    steer(s, rules, vehicle)


@compiled
def steer(s: State, rules: Rules, vehicle: int) -> None:
    """Plan the drive over what is left of the way to the next barcode, from ``initial`` speed at ``began``."""
    braking, stop = 2 * rules.braking, 0.0
    for k in range(s.granted[vehicle] - 1, 0, -1):
        stop = min(min(s.limit[vehicle, k], s.limit[vehicle, k - 1]), sqrt(stop * stop + braking * s.way[vehicle, k]))
    pace, way, limit = s.initial[vehicle], s.rest[vehicle], s.limit[vehicle, 0]
    leave = min(stop, sqrt(pace * pace + 2 * rules.acceleration * way))
    up, down = rules.acceleration, rules.braking
    peak = sqrt((2 * up * down * way + down * pace * pace + up * leave * leave) / (up + down))
    peak = max(min(limit, peak), max(pace, leave))
    ramps = (peak * peak - pace * pace) / (2 * up) + (peak * peak - leave * leave) / (2 * down)
    time = (peak - pace) / up + (peak - leave) / down + max(0.0, way - ramps) / max(peak, 1.0)
    s.pace[vehicle], s.peak[vehicle] = leave, peak
    schedule(s, vehicle, s.began[vehicle] + time)


@compiled
def carry_on(s: State, rules: Rules, vehicle: int, now: float) -> None:
    """A driving vehicle is granted more: it need not brake for its old end, unless it does already (an XMOVE too late)."""
    leave, peak, pace = s.pace[vehicle], s.peak[vehicle], s.initial[vehicle]
    heard = now + rules.hearing
    if heard >= s.due[vehicle] - (peak - leave) / rules.braking:
        return
    past = max(0.0, heard - s.began[vehicle])
    rise = min(past, (peak - pace) / rules.acceleration)
    s.rest[vehicle] -= pace * rise + rules.acceleration * rise * rise / 2 + peak * (past - rise)
    s.initial[vehicle] = pace + rules.acceleration * rise
    s.began[vehicle] = max(heard, s.began[vehicle])
    steer(s, rules, vehicle)


@compiled
def arrive(net: Network, s: State, rules: Rules, vehicle: int, now: float) -> None:
    """The vehicle reads the next barcode: what lies behind is free; on it goes, or it stops."""
    before, here = s.at[vehicle], s.ahead[vehicle, 0]
    s.counts[MILLIMETRES] += int(s.way[vehicle, 0])
    s.left[vehicle] -= s.way[vehicle, 0]
    n = s.granted[vehicle] - 1
    s.granted[vehicle] = n
    for k in range(n):
        s.ahead[vehicle, k] = s.ahead[vehicle, k + 1]
        s.way[vehicle, k] = s.way[vehicle, k + 1]
        s.limit[vehicle, k] = s.limit[vehicle, k + 1]
    s.at[vehicle] = here
    if net.buffer[here] != net.buffer[before] or here <= before:
        s.passes[net.buffer[before]] += 1
    release(s, before)
    if n == 0:
        s.left[vehicle] = 0.0
    if s.failed[vehicle]:
        s.pace[vehicle], s.doing[vehicle] = 0.0, BROKEN
        return
    if s.left[vehicle] < need(net, s, rules, vehicle) and here != s.goal[vehicle]:
        extend(net, s, rules, vehicle, now)
    if s.granted[vehicle] > 0:
        set_off(s, rules, vehicle, now)
    else:
        s.pace[vehicle] = 0.0
        s.doing[vehicle] = STANDING
        if here == s.goal[vehicle]:
            reach(net, s, rules, vehicle, now)
        else:
            give_way(net, s, vehicle)


@compiled
def give_way(net: Network, s: State, vehicle: int) -> None:
    """A vehicle that has nothing to do stands: it goes on at once if somebody waits for its place or for room in its buffer."""
    if s.waits_first[s.at[vehicle]] >= 0 or s.watch_first[net.buffer[s.at[vehicle]]] >= 0:
        nudge(net, s, vehicle)


@compiled
def reach(net: Network, s: State, rules: Rules, vehicle: int, now: float) -> None:
    """The vehicle stands at its goal."""
    if s.phase[vehicle] == IDLE:
        s.goal[vehicle] = -1
        s.since[vehicle] = -1.0
        give_way(net, s, vehicle)
        return
    s.doing[vehicle] = DWELLING
    schedule(s, vehicle, now + rules.dwell)


@compiled
def fail(s: State, vehicle: int) -> None:
    """A vehicle breaks down, unless it handles a carrier: it stands, or will at the next barcode, and keeps its grant."""
    if s.doing[vehicle] == DWELLING:
        return
    s.failed[vehicle] = 1
    forget_waits(s, vehicle)
    if s.doing[vehicle] == STANDING:
        s.doing[vehicle] = BROKEN


@compiled
def repair(s: State, vehicle: int) -> None:
    """A broken vehicle goes on."""
    s.failed[vehicle] = 0
    if s.doing[vehicle] == BROKEN:
        s.doing[vehicle] = STANDING
    ask_again(s, vehicle)


@compiled
def think_again(s: State, vehicle: int) -> None:
    """Let a vehicle that waits decide its way anew: the ways have changed. It hangs on what it is refused for now."""
    if s.since[vehicle] >= 0:
        s.planned[vehicle] = 0
        ask_again(s, vehicle)


@compiled
def take_off(net: Network, s: State, vehicle: int) -> None:
    """A vehicle that was on its way to fetch a carrier has nothing to do any more: it runs to the end of its grant."""
    s.phase[vehicle], s.goal[vehicle] = IDLE, -1
    s.lines.want[vehicle] = ANY
    s.planned[vehicle] = 0
    forget_waits(s, vehicle)
    s.since[vehicle] = -1.0
    give_way(net, s, vehicle)


@compiled
def send(net: Network, s: State, rules: Rules, vehicle: int, goal: int, phase: int) -> None:
    """Give a vehicle a goal. It goes on from the end of its grant; one that has begun to wait elsewhere decides anew."""
    s.goal[vehicle], s.phase[vehicle] = goal, phase
    s.planned[vehicle] = 0
    slot = s.lines.slot[vehicle]
    want = want_beyond(net, s, vehicle, slot)
    if want != s.lines.want[vehicle] and (not rules.admission or may_want(s.lines, vehicle, want)):
        s.lines.want[vehicle] = want
        if s.lines.head[slot] == vehicle:
            wake_watchers(s, slot)
    ask_again(s, vehicle)


@compiled
def go_on(net: Network, s: State, rules: Rules, now: float) -> None:
    """Let those go on that were asked again, and whom they set free, until nobody can."""
    while s.size[1] != s.size[2]:
        vehicle = s.queue[s.size[1]]
        s.size[1] = (s.size[1] + 1) % len(s.queue)
        s.queued[vehicle] = 0
        doing = s.doing[vehicle]
        if doing in (DWELLING, BROKEN):
            continue
        if doing == STANDING and s.at[vehicle] == s.goal[vehicle] and s.granted[vehicle] == 0:
            reach(net, s, rules, vehicle, now)
            continue
        before = s.granted[vehicle]
        if s.left[vehicle] < need(net, s, rules, vehicle):
            extend(net, s, rules, vehicle, now)
        if doing == STANDING and s.granted[vehicle] > 0:
            set_off(s, rules, vehicle, now)
        elif doing == DRIVING and s.granted[vehicle] > before:
            carry_on(s, rules, vehicle, now)


@compiled
def run(net: Network, s: State, rules: Rules, until: float) -> int:
    """Let time pass up to ``until``; return how many ``finished``.

    ``finished`` lists those that have picked up or put down, in order: twice the vehicle, and one more where it has put down.
    """
    done = 0
    go_on(net, s, rules, s.clock[0])
    while s.size[0] > 0 and s.due[s.heap[0]] <= until:
        vehicle = unschedule_first(s)
        now = s.due[vehicle]
        s.clock[0] = now
        s.counts[EVENTS] += 1
        if s.doing[vehicle] == DRIVING:
            arrive(net, s, rules, vehicle, now)
        elif s.doing[vehicle] == DWELLING:
            s.doing[vehicle] = STANDING
            s.finished[done] = 2 * vehicle + (1 if s.phase[vehicle] == LOADED else 0)
            done += 1
            if s.phase[vehicle] == LOADED:
                s.counts[DELIVERED] += 1
                s.phase[vehicle] = IDLE
                s.goal[vehicle] = -1
                s.lines.want[vehicle] = ANY
                give_way(net, s, vehicle)
            else:
                send(net, s, rules, vehicle, s.destination[vehicle], LOADED)
        go_on(net, s, rules, now)
        if done == len(s.finished):
            return done
    s.clock[0] = until
    return done
