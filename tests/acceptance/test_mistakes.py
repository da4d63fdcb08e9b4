"""The oracle notices what it is there for: every known mistake is caught on its recorded seed (QUALITY section 2)."""

from pathlib import Path

import pytest

from app.domain.layout import Plant
from app.plant import read
from app.sim.fuzz import draw, play
from tests.acceptance.catching import CAUGHT
from tests.acceptance.mistakes import HALL, SMALL
from tests.shares import shared


def plant_of(name: str) -> Plant:
    plant, _ = read((Path(__file__).parents[2] / "plants" / f"{name}.yaml").read_text(encoding="utf-8"), name)
    return plant


@pytest.mark.parametrize("name", shared([*SMALL, *HALL], 6))
def test_a_known_mistake_is_caught_on_its_seed(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    plant = plant_of("hall" if name in HALL else "small")
    (HALL if name in HALL else SMALL)[name](monkeypatch)
    assert play(plant, draw(plant, CAUGHT[name])).wrong


@pytest.mark.campaign
def test_without_a_mistake_the_same_seeds_are_sound() -> None:
    for plant, names in ((plant_of("small"), SMALL), (plant_of("hall"), HALL)):
        for seed in sorted({CAUGHT[name] for name in names}):
            assert play(plant, draw(plant, seed)).wrong == (), f"seed {seed}"
