"""Many runs together: what they must have reached, and what they add up to."""

from collections import Counter
from dataclasses import dataclass, field

from app.domain.layout import Plant, Wire
from app.sim.fuzz.plan import ANYWHERE, RAIL, Blow
from app.sim.fuzz.play import Outcome

LEAST_SEEDS = 100
"""Runs from which on a campaign must have reached everything. Our choice: each thing is drawn in one run of ten at least."""
REACHED: frozenset[str] = frozenset(
    {blow.value for blow in (*RAIL, *ANYWHERE)}
    | {
        "noise", "kill at a commit", "kill at a send", "shoved", "dropped", "recover", "release", "pushed to a barcode", "cancel",
        "same order repeated", "other order repeated", "VehicleHeld", "VehicleReleased", "AlarmSet", "AlarmCleared",
        "TransferAbortCompleted", "TransferCancelCompleted", "TransferCompleted",
    }
)  # fmt: skip
"""What a campaign on a plant of hoists must have seen, or it tries nothing."""
HALL_REACHED: frozenset[str] = frozenset(
    {
        Blow.AGV_MANUAL.value,
        Blow.AGV_ERROR.value,
        Blow.AGV_MISS.value,
        Blow.DOOR.value,
        Blow.BUFFER.value,
        Blow.DRIVE.value,
    }
)
"""What it must have seen besides where the plant has a hall and drives."""


def reached(plant: Plant) -> frozenset[str]:
    """Return what a campaign on a plant must have seen, or it tries nothing."""
    hoists = REACHED if any(True for _ in plant.hoists) else frozenset[str]()
    return hoists | (HALL_REACHED if any(link.wire is Wire.ENIG for link in plant.links) else frozenset[str]())


@dataclass(slots=True)
class Tally:
    """Sums over runs."""

    runs: int = 0
    virtual: float = 0.0
    crashes: int = 0
    jobs: int = 0
    counts: Counter[str] = field(default_factory=Counter)
    failed: list[Outcome] = field(default_factory=list)

    def add(self, outcome: Outcome) -> None:
        """Count a run."""
        self.runs += 1
        self.virtual += outcome.virtual
        self.crashes += outcome.crashes
        self.jobs += outcome.jobs
        self.counts.update(outcome.counts)
        if outcome.wrong:
            self.failed.append(outcome)

    def missing(self, wanted: frozenset[str]) -> list[str]:
        """Return what never happened though it should have; with few runs nothing is asked for."""
        return sorted(what for what in wanted if not self.counts[what]) if self.runs >= LEAST_SEEDS else []
