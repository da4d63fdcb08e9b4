"""Finds seeds on which known mistakes are caught: ``python -m tests.acceptance.catching [--seeds N] [NAME ...]``.

Without names all are tried. Prints each one's first catching seed and what the oracle said; exit 1 if one is not caught.
"""

import argparse
import sys
from pathlib import Path

import pytest

from app.plant import read
from app.sim.fuzz import draw, play
from tests.acceptance.mistakes import HALL, SMALL

CAUGHT: dict[str, int] = {
    "forgotten_reservation": 1,
    "cmd_ids_again": 0,
    "events_again": 0,
    "forgotten_intents": 16,
    "resent_after_restart": 1,
    "no_quiesce": 0,
    "early_release": 0,
    "released_when_silent": 17,
    "granted_twice": 0,
    "answered_before_commit": 0,
    "sent_before_commit": 0,
    "mode_ignored": 0,
    "silence_unnoticed": 11,
    "source_not_looked_at": 0,
    "destination_not_looked_at": 0,
    "order_taken_twice": 6,
    "audit_forgotten": 0,
    "event_skipped": 0,
    "strange_place_believed": 10,
    "door_closed_on_a_vehicle": 0,
}
"""The recorded seed of each mistake."""
PLANTS = Path(__file__).parents[2] / "plants"


def first_seed(name: str, most: int) -> tuple[int, str] | None:
    """Return the first of so many seeds on which a mistake is caught, and by what; None: none."""
    file = PLANTS / ("hall.yaml" if name in HALL else "small.yaml")
    plant, _ = read(file.read_text(encoding="utf-8"), file.name)
    with pytest.MonkeyPatch.context() as patch:
        (HALL if name in HALL else SMALL)[name](patch)
        for seed in range(most):
            if wrong := play(plant, draw(plant, seed)).wrong:
                return seed, wrong[0]
    return None


def main() -> int:
    """Try the mistakes that are named."""
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("--seeds", type=int, default=60)
    asked.add_argument("names", nargs="*", choices=[*SMALL, *HALL, []])
    given = asked.parse_args()
    missed = 0
    for name in given.names or [*SMALL, *HALL]:
        found = first_seed(name, given.seeds)
        missed += found is None
        print(f"{name:28} " + ("not caught" if found is None else f"seed {found[0]:4}  {found[1]}"), flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
