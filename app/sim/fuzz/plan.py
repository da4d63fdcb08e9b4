"""What will go wrong in a run: drawn from its seed once, so that parts of it can be left out afterwards."""

from dataclasses import dataclass, field
from enum import StrEnum
from random import Random

from app.domain.layout import Plant, Wire
from app.sim.world import Delays
from app.wire.faults import Fault

CALM = 60.0
"""Virtual seconds in which things go wrong; then the liveness phase begins. Our choice: three jobs of a small plant."""
FIRST = 3.0
"""Virtual seconds before the first strike: vehicles connect meanwhile. Our choice."""
MOST_STRIKES = 9
"""Strikes in a run, at most. Our choice: many more, and every vehicle waits for a person all the time."""
WORST_LINE = 0.02
"""Share of packets that a fault may befall, at most. Our choice."""


class Blow(StrEnum):
    """What can happen to a plant at a moment."""

    KILL = "kill"
    CUT = "cut"
    MANT = "key turned to MANT"
    PUSH = "pushed by hand"
    ALARM = "alarm"
    BLOCK = "obstacle"
    POWER = "rebooted"
    REFUSE = "refuses"
    HOLD = "held by a person"
    STOP = "stopped by a person"
    MISREAD = "misread barcode"
    STALL = "slow disk"
    MUTE = "mute line"
    LOSE = "carrier lost"
    REPEAT = "order repeated"
    CANCEL = "cancelled or aborted by the host"
    CHANGE = "order changed by the host"
    INTRUDE = "destination filled by equipment"
    AGV_MANUAL = "AGV switched to manual"
    AGV_ERROR = "AGV in error"
    AGV_MISS = "tag not read"
    DOOR = "door obstructed or without power"
    BUFFER = "buffer in error or without power"
    LOST_PACKET = "hall packet lost"
    DRIVE = "drive operation asked for"


RAIL = (
    Blow.MANT, Blow.PUSH, Blow.ALARM, Blow.BLOCK, Blow.POWER, Blow.REFUSE, Blow.HOLD, Blow.STOP, Blow.MISREAD, Blow.MUTE,
    Blow.LOSE,
)  # fmt: skip
"""What befalls hoists."""
ANYWHERE = (Blow.KILL, Blow.CUT, Blow.STALL, Blow.REPEAT, Blow.CANCEL, Blow.CHANGE, Blow.INTRUDE)
HALL = (Blow.AGV_MANUAL, Blow.AGV_ERROR, Blow.AGV_MISS, Blow.DOOR, Blow.BUFFER, Blow.LOST_PACKET)
"""What befalls a hall of AGVs."""


@dataclass(frozen=True, slots=True)
class Strike:
    """A blow at a moment. ``number`` seeds what it draws, whatever else is left out of the plan."""

    at: float
    blow: Blow
    number: int


class Where(StrEnum):
    """At which points of the controller's work it is killed."""

    COMMIT = "commit"
    DURABLE = "durable"
    """Just after the transaction was written, before anybody was told."""
    SEND = "send"
    """As a packet leaves, which is lost with the line."""
    ARRIVED = "arrived"
    """As a packet has arrived."""


@dataclass(frozen=True, slots=True)
class Crash:
    """The controller is killed at its ``nth`` commit or packet, counted from the beginning of the run."""

    where: Where
    nth: int


@dataclass(frozen=True, slots=True)
class Plan:
    """One run. ``noise`` are the rates of faults on a line, by its name and direction (``<``, ``>``), until it is calm."""

    seed: int
    calm: float
    keep_open: int
    strikes: tuple[Strike, ...] = ()
    crashes: tuple[Crash, ...] = ()
    noise: dict[tuple[str, str], dict[Fault, float]] = field(default_factory=dict)
    answers_on_acceptance: bool = False
    delays: Delays = Delays()

    @property
    def faults(self) -> int:
        """How many things go wrong, each line with noise counted as one."""
        return len(self.strikes) + len(self.crashes) + len({line for line, _ in self.noise})


def draw(plant: Plant, seed: int, calm: float = CALM) -> Plan:
    """Return what a seed has in store for a plant: its own mix of blows (a swarm), crash points, noise and delays."""
    dice = Random(f"{seed}/plan")
    mix = [blow for blow in _possible(plant) if dice.random() < 0.5] or [Blow.KILL]
    number = dice.randint(1, MOST_STRIKES)
    strikes = [Strike(round(dice.uniform(FIRST, calm), 3), dice.choice(mix), i) for i in range(number)]
    return Plan(
        seed=seed,
        calm=calm,
        keep_open=dice.randint(1, max(2, len(plant.vehicles))),
        strikes=tuple(sorted(strikes, key=lambda strike: strike.at)),
        crashes=_crashes(dice) if dice.random() < 0.5 else (),
        noise=_noise(plant, dice) if dice.random() < 0.3 else {},
        answers_on_acceptance=dice.random() < 0.25,
        delays=_delays(dice),
    )


def _possible(plant: Plant) -> list[Blow]:
    """Return the blows that can befall a plant."""
    found = list(ANYWHERE)
    if any(True for _ in plant.hoists):
        found += RAIL
    if any(link.wire is Wire.ENIG for link in plant.links):
        found += HALL
    if plant.drives:
        found.append(Blow.DRIVE)
    return found


def _crashes(dice: Random) -> tuple[Crash, ...]:
    return tuple(
        Crash(where, dice.randint(1, 60 if where in {Where.COMMIT, Where.DURABLE} else 600))
        for where in (dice.choice(list(Where)) for _ in range(dice.randint(1, 4)))
    )


def _noise(plant: Plant, dice: Random) -> dict[tuple[str, str], dict[Fault, float]]:
    """Return rates for the lines of hoists; those of halls lose packets by blows of their own."""
    return {
        (str(vehicle.id), way): {fault: dice.uniform(0.0, WORST_LINE) for fault in Fault if dice.random() < 0.5}
        for vehicle in plant.hoists
        for way in "<>"
    }


def _delays(dice: Random) -> Delays:
    """Return a switched network and a good disk, or one of them slower by far."""
    usual = Delays()
    kind = dice.random()
    if kind < 0.15:
        return Delays(link=(0.02, 0.2))
    if kind < 0.3:
        return Delays(commit=(0.02, 0.25))
    if kind < 0.4:
        return Delays(restart=(2.0, 15.0))
    return usual
