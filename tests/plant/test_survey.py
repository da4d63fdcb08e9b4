"""What a survey of a plant notices."""

from pathlib import Path

import pytest

from app.domain.layout import Plant
from app.plant import read
from app.plant.fab import SIZES, generate, populate
from app.plant.survey import Remark, survey

PLANTS = Path(__file__).parents[2] / "plants"


def plant(text: str) -> Plant:
    return read(text, "plant")[0]


def remarks(given: Plant) -> dict[str, Remark]:
    return {remark.topic: remark for remark in survey(given).remarks}


RING = """
barcodes: {1: [0, 0], 2: [4000, 0], 3: [8000, 0], 4: [8000, 4000], 5: [0, 4000]}
track: [{through: [1..5, 1]}]
stations: {A: {kind: port, at: 2}, B: {kind: port, at: 4}}
"""


def test_a_sound_ring_gives_figures() -> None:
    seen = survey(plant(RING))
    assert seen.figures["barcodes"] == 5
    assert seen.figures["kilometres"] == 0.024
    assert (seen.figures["ports"], seen.figures["merges"], seen.figures["strongly connected parts"]) == (2, 0, 1)


def test_crossing_track_is_noticed() -> None:
    text = RING.replace("5: [0, 4000]}", "5: [0, 4000], 6: [6000, -500], 7: [6000, 2000]}")
    text = text.replace("[{through: [1..5, 1]}]", "[{through: [1..5, 1]}, {through: [1, 6, 7, 5]}]")
    found = remarks(plant(text))["crossings"]
    assert set(found.barcodes) == {"2"}
    assert found.count == 1


def test_doubled_barcodes_are_noticed() -> None:
    text = RING.replace("5: [0, 4000]}", "5: [0, 4000], 6: [4050, 20]}").replace(
        "..5, 1]}]", "..5, 1]}, {through: [1, 6, 3]}]"
    )
    assert remarks(plant(text))["doubled barcodes"].barcodes == ("2",)


def test_a_station_at_a_branch_is_noticed() -> None:
    text = RING.replace("..5, 1]}]", "..5, 1]}, {through: [2, 5]}]")
    assert remarks(plant(text))["stations at branches"].barcodes == ("2",)


def test_track_without_a_way_around_is_named() -> None:
    text = """
barcodes: {1: [0, 0], 2: [4000, 0], 3: [8000, 0], 4: [8000, 4000], 5: [0, 4000], 6: [4000, 1500], 7: [4000, 2500]}
track: [{through: [1..5, 1]}, {through: [2, 6, 7, 5]}]
stations: {A: {kind: port, at: 1}, B: {kind: port, at: 4}, C: {kind: port, at: 7}}
"""
    found = remarks(plant(text))["no way around"]
    assert set(found.barcodes) == {"2", "5"}
    assert "cuts off up to 2 of 3 places" in found.message


def test_short_buffers_and_dense_barcodes_are_noticed() -> None:
    made = populate(generate(SIZES["1k"], 1).plant, 5, 1)
    assert not {"short buffers", "dense barcodes"} & set(remarks(made))
    text = RING.replace("5: [0, 4000]}", "5: [0, 4000], 6: [6000, 2000]}")
    one = plant(text.replace("[{through: [1..5, 1]}]", "[{through: [1..5, 1]}, {through: [2, 6, 4]}]"))
    short = survey(one).figures["buffers for fewer than two vehicles"]
    assert (remarks(one)["short buffers"].count, bool(short)) == (short, True)
    assert remarks(read((PLANTS / "small.yaml").read_text(encoding="utf-8"), "small")[0])["dense barcodes"].count == 8


def test_parking_in_the_way_is_noticed() -> None:
    assert remarks(plant(RING + "parking: [2]\n"))["parking at stations"].barcodes == ("2",)


@pytest.mark.parametrize("name", ["small", "hall", "demo"])
def test_every_example_plant_can_be_surveyed(name: str) -> None:
    seen = survey(read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)[0])
    assert seen.figures["edges"]
    assert not {"crossings", "doubled barcodes"} & {remark.topic for remark in seen.remarks}
