"""``hoistway sim``: which machines of a plant are simulated."""

from pathlib import Path

import pytest

from app.cli.plainly import CannotStart
from app.cli.sim import simulated
from app.domain.layout import Plant
from app.plant import read

PLANTS = Path(__file__).parents[2] / "plants"


def plant(name: str) -> Plant:
    return read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)[0]


def names(given: Plant) -> set[str]:
    return {*(v.id for v in given.vehicles), *(link.id for link in given.links)}


def test_a_plant_is_simulated_whole_where_nothing_is_said() -> None:
    assert simulated(plant("demo"), (), ()) == plant("demo")


def test_a_real_hoist_is_left_out() -> None:
    assert names(simulated(plant("small"), (), ["V001"])) == {"V002"}
    assert names(simulated(plant("small"), ["V001"], ())) == {"V001"}


def test_a_link_goes_with_all_that_is_on_it() -> None:
    kept = simulated(plant("hall"), (), ["hall"])
    assert names(kept) == {"axes"}
    assert (kept.doors, kept.buffers, len(kept.drives)) == ((), (), 1)
    assert all(station.buffer is None for station in kept.stations)
    alone = simulated(plant("hall"), ["hall"], ())
    assert names(alone) == {"hall", "AGV1", "AGV2"}
    assert alone.drives == ()


def test_one_agv_may_be_simulated_with_its_link() -> None:
    assert names(simulated(plant("hall"), ["AGV1"], ())) == {"hall", "AGV1"}
    assert names(simulated(plant("hall"), (), ["AGV1"])) == {"hall", "axes", "AGV2"}


def test_unknown_names_and_nothing_left_are_said() -> None:
    with pytest.raises(CannotStart, match="no vehicle or link is called V0O1") as refused:
        simulated(plant("small"), ["V0O1"], ())
    assert refused.value.remedy == "Did you mean V001?"
    with pytest.raises(CannotStart, match="nothing is left to simulate"):
        simulated(plant("small"), (), ["V001", "V002"])
