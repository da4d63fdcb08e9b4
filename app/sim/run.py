"""One judged run of a plant in virtual time."""

from random import Random

from app.domain.layout import Plant
from app.domain.ports import Ledger
from app.sim.world import Result, World

WARM_UP = 20.0
"""Virtual seconds before the first kill. Our choice."""


def run(
    plant: Plant,
    seed: int,
    seconds: float,
    *,
    per_hour: float | None = None,
    keep_open: int | None = None,
    kills: int = 0,
    drain: float = 1800.0,
    ledger: Ledger | None = None,
) -> Result:
    """Load a plant for so many virtual seconds, then let every job end within ``drain`` seconds more.

    ``kills`` times, at random moments, the controller is killed and comes back a little later.
    """
    world = World(plant, seed, ledger)
    world.work(until=seconds, per_hour=per_hour, keep_open=keep_open)
    dice = Random(f"{seed}/kills")
    for _ in range(kills):
        world.agenda.at(dice.uniform(WARM_UP, seconds), world.kill)
    world.run(seconds)
    world.finish(drain)
    return world.result()
