"""Admission: who may take a slot of a buffer, so that no circle of full buffers can close (TRAFFIC section 3).

Plain functions over rows of whole numbers, so that the same rules run in the controller (rows are lists) and, compiled, in the
fast simulated fab (rows are arrays). Vehicles and buffers are numbers from 0; -1 is none.

A vehicle has one *slot*: that of the farthest buffer it is granted track in. A buffer that it only crosses needs none, since the
grant through it is given as a whole. The vehicles of a buffer stand in line; the first is its *head*, and has a *want*, the
buffer where it will wait next: one that dwells, idles or may still choose otherwise wants ``ANY`` of the buffer's outs.
"""

from typing import NamedTuple, TypeAlias

from app.planning.buffers import Buffers

Row: TypeAlias = list[int]
ANY = -1
"""A want: any of the buffers that can come next."""
ADMITTED, FULL, CIRCLE = 0, 1, 2
"""Answers: yes; no slot is free; the last slot is, and taking it could close a circle of full buffers."""


class Lines(NamedTuple):
    """Buffers and the vehicles standing in line in them.

    Per buffer: ``capacity`` and ``load`` in slots, ``head``, ``tail``, ``mark`` (scratch); ``out_at`` (one longer) and ``outs``
    list the buffers that can come next. Per vehicle: ``slot``, ``want``, and its neighbours in line, ``before`` (nearer to the
    exit) and ``behind``. ``looked`` are the buffers that the last refusal came by (scratch), ``seen`` has how many, and
    a running mark.
    """

    capacity: Row
    load: Row
    head: Row
    tail: Row
    mark: Row
    out_at: Row
    outs: Row
    slot: Row
    want: Row
    before: Row
    behind: Row
    looked: Row
    seen: Row


def enter(s: Lines, vehicle: int, buffer: int, want: int) -> None:
    """Give the vehicle a slot of this buffer, last in line, and back the one it has."""
    leave(s, vehicle)
    last = s.tail[buffer]
    s.before[vehicle] = last
    s.behind[vehicle] = -1
    if last < 0:
        s.head[buffer] = vehicle
    else:
        s.behind[last] = vehicle
    s.tail[buffer] = vehicle
    s.slot[vehicle] = buffer
    s.want[vehicle] = want
    s.load[buffer] += 1


def leave(s: Lines, vehicle: int) -> None:
    """Take the vehicle out of the line it stands in, if any."""
    buffer = s.slot[vehicle]
    if buffer < 0:
        return
    ahead, after = s.before[vehicle], s.behind[vehicle]
    if ahead < 0:
        s.head[buffer] = after
    else:
        s.behind[ahead] = after
    if after < 0:
        s.tail[buffer] = ahead
    else:
        s.before[after] = ahead
    s.slot[vehicle] = -1
    s.load[buffer] -= 1


def admits(s: Lines, vehicle: int, buffer: int, want: int) -> int:
    """Return ADMITTED, FULL or CIRCLE for a vehicle that would take a slot of this buffer, and want that one from there.

    The vehicle leaves a hole where it has its slot now. After a refusal ``looked`` has the buffers that it hangs on: when a
    vehicle leaves one of them, or the want of its head changes, the answer may be another.
    """
    s.looked[0] = buffer
    s.seen[0] = 1
    if buffer == s.slot[vehicle]:
        return ADMITTED
    room = s.capacity[buffer] - s.load[buffer]
    if room <= 0:
        return FULL
    if room > 1:
        return ADMITTED
    first = s.head[buffer]
    return comes_back(s, vehicle, buffer, want if first < 0 else s.want[first])


def may_want(s: Lines, vehicle: int, want: int) -> bool:
    """Return whether the head of a buffer may want this next, or any (a closure, another way): no circle closes by it."""
    buffer = s.slot[vehicle]
    if buffer < 0 or s.head[buffer] != vehicle or s.load[buffer] < s.capacity[buffer]:
        return True
    s.looked[0] = buffer
    s.seen[0] = 1
    return comes_back(s, -1, buffer, want) == ADMITTED


def comes_back(s: Lines, vehicle: int, buffer: int, want: int) -> int:
    """Return CIRCLE if ``buffer``, were it full with a head that wants this, could wait for itself over full buffers.

    ``looked`` grows by the full buffers passed on the way. Every buffer is looked at once.
    """
    home = s.slot[vehicle] if vehicle >= 0 else -1
    s.seen[1] += 1
    mark = s.seen[1]
    s.mark[buffer] = mark
    done = 0
    while True:
        here = s.looked[done]
        if here != buffer:
            want = s.want[s.head[here]]
        first = s.out_at[here] if want == ANY else 0
        last = s.out_at[here + 1] if want == ANY else 1
        for i in range(first, last):
            ahead = s.outs[i] if want == ANY else want
            if ahead == buffer:
                return CIRCLE
            load = s.load[ahead] - (1 if ahead == home else 0)
            if load >= s.capacity[ahead] and load > 0 and s.mark[ahead] != mark:
                s.mark[ahead] = mark
                s.looked[s.seen[0]] = ahead
                s.seen[0] += 1
        done += 1
        if done == s.seen[0]:
            return ADMITTED


def lines(buffers: Buffers, vehicles: int) -> Lines:
    """Return empty lines for so many vehicles."""
    outs = [out for of_one in buffers.outs for out in of_one]
    out_at = [0]
    for of_one in buffers.outs:
        out_at.append(out_at[-1] + len(of_one))
    size = len(buffers)
    none, nobody = [-1] * size, [-1] * vehicles
    return Lines(
        capacity=list(buffers.capacity),
        load=[0] * size,
        head=list(none),
        tail=list(none),
        mark=[0] * size,
        out_at=out_at,
        outs=outs,
        slot=list(nobody),
        want=list(nobody),
        before=list(nobody),
        behind=list(nobody),
        looked=[0] * (size + 1),
        seen=[0, 0],
    )
