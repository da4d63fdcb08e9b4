"""Who is due when, and who waits for what, in the fast plant. Everything here is compiled if it can be."""

from app.sim.kinematic.compiled import compiled
from app.sim.kinematic.state import WATCHED, State

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
