"""The moves of the fast plant: driving, handling, breaking down, going on. Everything here is compiled if it can be."""

from math import sqrt

from app.planning.admission import ANY, may_want
from app.sim.kinematic.compiled import compiled
from app.sim.kinematic.granting import extend, need, nudge, want_beyond
from app.sim.kinematic.network import Network, Whole
from app.sim.kinematic.state import (
    BROKEN,
    DELIVERED,
    DRIVING,
    DWELLING,
    EVENTS,
    IDLE,
    LOADED,
    MILLIMETRES,
    STANDING,
    WATCHED,
    Rules,
    State,
)
from app.sim.kinematic.waiting import ask_again, forget_waits, release, schedule, unschedule_first, wake_watchers


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
def remind(s: State) -> None:
    """Ask those again that hang on more buffers than they can watch: nobody wakes them when another of these changes."""
    for vehicle in range(len(s.watching)):
        if s.watching[vehicle] == WATCHED:
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
def send_each(net: Network, s: State, rules: Rules, vehicles: Whole, goals: Whole, phase: int) -> None:
    """Give each of these vehicles its goal."""
    for i in range(len(vehicles)):
        send(net, s, rules, vehicles[i], goals[i], phase)


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
