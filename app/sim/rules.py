"""Checks the rule of admission on random networks of queues, where nothing but the rule can keep them from locking up.

TRAFFIC section 3: every network is strongly connected, all but one to three slots are taken, and every vehicle wants to go
somewhere, dwells there, and wants to go on. Where no head can move and none dwells, the network has locked up.
"""

from collections import deque
from dataclasses import dataclass
from enum import StrEnum
from random import Random

from app.planning.admission import ADMITTED, ANY, Lines, admits, enter, may_want

DWELL = 0.2
"""Share of steps in which a head that dwells goes on. Our choice."""
CHANGE = 0.1
"""Share of steps in which a head thinks of another goal. Our choice."""


class Rule(StrEnum):
    """What keeps the networks from locking up, or does not."""

    NONE = "none"
    """A slot must be free, that is all."""
    LOOK_AHEAD = "look-ahead"
    """The rule of ``planning.admission``."""
    NO_HOLE = "no hole"
    """The same, but the buffer that the vehicle leaves does not count as having a hole: too strict."""
    NO_DWELLERS = "no dwellers"
    """The same, but a head that dwells counts as wanting nothing: too lax."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of one network. ``looked`` are the buffers that each asked head's answer came by, on average."""

    moves: int
    refusals: int
    looked: float
    locked: bool = False


class Network:
    """Queues in random order, filled as far as the rule lets them be: it keeps a safe state safe, and makes none."""

    def __init__(self, seed: int, *, least: int = 2) -> None:
        self.rng = Random(f"{seed}/network")
        size = self.rng.randint(3, 12)
        self.outs = _connected(self.rng, size)
        capacity = [self.rng.randint(least, 4) for _ in range(size)]
        vehicles = max(1, sum(capacity) - self.rng.randint(1, 3))
        self.lines = _rows(capacity, self.outs, vehicles)
        self.hops = [_hops(self.outs, goal) for goal in range(size)]
        self.goal = [self.rng.randrange(size) for _ in range(vehicles)]
        for vehicle in range(vehicles):
            order = list(range(size))
            self.rng.shuffle(order)
            for buffer in order:
                want = self.next(vehicle, buffer)
                if admits(self.lines, vehicle, buffer, want) == ADMITTED:
                    enter(self.lines, vehicle, buffer, want)
                    break

    def next(self, vehicle: int, buffer: int) -> int:
        """Return where a vehicle will go from a buffer; ANY: it stays there for a while."""
        return ANY if self.goal[vehicle] == buffer else self.hops[self.goal[vehicle]][buffer]

    def heads(self) -> list[int]:
        """Return the first vehicle of every line."""
        return [head for head in self.lines.head if head >= 0]

    def think_of_another_goal(self, vehicle: int, *, asks: bool) -> bool:
        """The head of a line wants to go somewhere else from now on, if it need not ask or may; return whether it does."""
        here = self.lines.slot[vehicle]
        goal = self.rng.choice([b for b in range(len(self.outs)) if b != here])
        want = self.hops[goal][here]
        if asks and not may_want(self.lines, vehicle, want):
            return False
        self.goal[vehicle], self.lines.want[vehicle] = goal, want
        return True


def check(seed: int, rule: Rule, steps: int = 2_000, *, least: int = 2) -> Outcome:
    """Run one network for so many steps or until it locks up.

    ``least`` is the least capacity of a buffer. With 1 no rule of one step of look-ahead holds, hence no-stop zones.
    """
    net = Network(seed, least=least)
    rng = net.rng
    moves = refusals = looked = 0
    for _ in range(steps):
        heads = net.heads()
        rng.shuffle(heads)
        moved = False
        for vehicle in heads:
            want = net.lines.want[vehicle]
            if want == ANY:
                moved = rng.random() < DWELL
                if moved:
                    net.think_of_another_goal(vehicle, asks=rule is Rule.LOOK_AHEAD)
            elif _admitted(net, vehicle, want, rule):
                enter(net.lines, vehicle, want, net.next(vehicle, want))
                moves += 1
                moved = True
            else:
                refusals += 1
                looked += net.lines.seen[0]
                changes = rule is Rule.LOOK_AHEAD and rng.random() < CHANGE
                moved = changes and net.think_of_another_goal(vehicle, asks=True)
            if moved:
                break
        if not moved and all(net.lines.want[head] != ANY for head in heads):
            return Outcome(moves, refusals, looked / max(1, refusals), locked=True)
    return Outcome(moves, refusals, looked / max(1, refusals))


def _admitted(net: Network, vehicle: int, want: int, rule: Rule) -> bool:
    s = net.lines
    if rule is Rule.LOOK_AHEAD:
        return admits(s, vehicle, want, net.next(vehicle, want)) == ADMITTED
    s.seen[0] = 1
    if want == s.slot[vehicle]:
        return True
    room = s.capacity[want] - s.load[want]
    if room != 1 or rule is Rule.NONE:
        return room > 0
    return not _comes_back(net, vehicle, want, rule)


def _comes_back(net: Network, vehicle: int, buffer: int, rule: Rule) -> bool:
    """The look-ahead with one of its parts left out."""
    s = net.lines
    home = s.slot[vehicle]
    queue, seen = [buffer], {buffer}
    while queue:
        here = queue.pop()
        head = s.head[here]
        want = s.want[head] if head >= 0 else net.next(vehicle, buffer)
        any_of = [] if rule is Rule.NO_DWELLERS else net.outs[here]
        wants = any_of if want == ANY else [want]
        for ahead in wants:
            if ahead == buffer or (rule is Rule.NO_HOLE and ahead == home):
                return True
            full = s.load[ahead] - (ahead == home) >= s.capacity[ahead]
            if full and ahead not in seen:
                seen.add(ahead)
                queue.append(ahead)
    return False


def _connected(rng: Random, size: int) -> list[list[int]]:
    """Return the outs of a random strongly connected network: a ring, and as many other ways again."""
    order = list(range(size))
    rng.shuffle(order)
    outs: list[list[int]] = [[] for _ in range(size)]
    for here, after in zip(order, [*order[1:], order[0]], strict=True):
        outs[here].append(after)
    for _ in range(rng.randint(1, size)):
        here, after = rng.randrange(size), rng.randrange(size)
        if here != after and after not in outs[here]:
            outs[here].append(after)
    return outs


def _hops(outs: list[list[int]], goal: int) -> list[int]:
    """Return the next buffer on a way with the fewest buffers to the goal, from each."""
    before: list[list[int]] = [[] for _ in outs]
    for here, afters in enumerate(outs):
        for after in afters:
            before[after].append(here)
    hops, queue = [-1] * len(outs), deque([goal])
    while queue:
        here = queue.popleft()
        for other in before[here]:
            if hops[other] < 0 and other != goal:
                hops[other] = here
                queue.append(other)
    hops[goal] = outs[goal][0]
    return hops


def _rows(capacity: list[int], outs: list[list[int]], vehicles: int) -> Lines:
    size = len(capacity)
    out_at = [0]
    for afters in outs:
        out_at.append(out_at[-1] + len(afters))
    return Lines(
        list(capacity), [0] * size, [-1] * size, [-1] * size, [0] * size, out_at, [o for afters in outs for o in afters],
        [-1] * vehicles, [-1] * vehicles, [-1] * vehicles, [-1] * vehicles, [0] * (size + 1), [0, 0],
    )  # fmt: skip
