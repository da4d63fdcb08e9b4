"""Plants as text: what is written reads back as the very same plant."""

from dataclasses import replace
from pathlib import Path

import pytest

from app.domain.ids import LinkId, VehicleId
from app.domain.layout import Plant, SerialPort
from app.domain.units import Barcode, Seconds
from app.plant import read
from app.plant.writing import write

PLANTS = Path(__file__).parents[2] / "plants"


def plant(name: str) -> Plant:
    found, _ = read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)
    return found


@pytest.mark.parametrize("name", ["small", "hall", "demo"])
def test_every_example_plant_reads_back_as_it_was(name: str) -> None:
    given = plant(name)
    assert read(write(given), name) == (given, [])


def test_rare_words_read_back_too() -> None:
    given = plant("hall")
    links = (
        replace(
            given.links[0], host="::1", dialect={"preset": "max64", "aliases": [["B1", 21], ["B2", 22], ["B3", 23]]}
        ),
        replace(given.links[1], serial=SerialPort("/dev/ttyUSB0", parity="E"), host="", port=0),
    )
    given = replace(given, name='the "hall"', links=links, listen=("0.0.0.0", 9000))
    found, findings = read(write(given), "hall")
    assert (found, findings) == (given, [])


def test_reference_vehicles_and_those_that_connect_to_us_read_back() -> None:
    given = plant("small")
    first = replace(given.vehicles[0], listen=True, host="10.0.0.7", port=0, offset=None)
    given = replace(
        given,
        vehicles=(first, *given.vehicles[1:]),
        listen=("127.0.0.1", 9000),
        reference_vehicles=frozenset({VehicleId("V001")}),
    )
    assert read(write(given), "small")[0] == given


@pytest.mark.parametrize("restrain", [False, True])
@pytest.mark.parametrize("congestion", [None, False, True])
def test_the_rules_of_traffic_read_back(restrain: bool, congestion: bool | None) -> None:
    given = replace(plant("small"), restrain=restrain, congestion=congestion)
    assert read(write(given), "small") == (given, [])


@pytest.mark.parametrize("seconds", [0, 600, 1800])
def test_how_long_jobs_may_wait_reads_back_and_never_does_too(seconds: int) -> None:
    made = replace(plant("small"), overdue=Seconds(seconds))
    text = write(made)
    assert ("jobs: {overdue:" in text) == (seconds != 600)
    assert read(text, "small")[0] == made


def test_a_note_stands_behind_its_barcode_and_cannot_break_out_of_the_comment() -> None:
    text = write(plant("small"), ["first\nline"], {Barcode("103"): "Point 3\nvehicles: {}"})
    assert "  103: [3000, 0]  # Point 3 vehicles: {}\n" in text
    assert text.startswith("# first line\n")
    assert read(text, "small")[0] == plant("small")


def test_a_name_that_looks_like_a_number_is_quoted() -> None:
    given = plant("hall")
    links = tuple(replace(link, id=LinkId("007")) if link.id == "hall" else link for link in given.links)
    moved = replace(
        given,
        links=links,
        vehicles=tuple(replace(v, link=LinkId("007")) for v in given.vehicles),
        doors=tuple(replace(d, link=LinkId("007")) for d in given.doors),
        buffers=tuple(replace(b, link=LinkId("007")) for b in given.buffers),
    )
    assert read(write(moved), "hall")[0] == moved
