"""Pulses that were edited in a plant file, where others hold."""

from pathlib import Path

import pytest

from app.domain.ids import Actor, Epoch, StationId, VehicleId
from app.domain.layout import Plant, PulseSet
from app.domain.pulses import AxisPulses, PartialPulses
from app.domain.records import Kept, StationDest, VehicleOffset
from app.domain.units import Pulses, Timestamp
from app.plant import read
from app.plant.overruled import overruled

TEXT = (Path(__file__).parents[2] / "plants" / "small.yaml").read_text(encoding="utf-8")
BY_FILE = PulseSet(Pulses(1200), Pulses(-300), Pulses(41000))
TAUGHT = PulseSet(Pulses(1210), Pulses(-305), Pulses(41020))
EDITED = TEXT.replace("dest: {shft: 1200, rota: -300, lift: 41000}", "dest: {shft: 1300, rota: -300, lift: 41000}")


def plant(text: str) -> Plant:
    return read(text, "small")[0]


def kept(*dests: StationDest, offsets: tuple[VehicleOffset, ...] = ()) -> Kept:
    return Kept(epoch=Epoch(1), dests=dests, offsets=offsets)


def dest(pulses: AxisPulses, version: int = 2, source: str = "teaching", actor: str = "kim") -> StationDest:
    return StationDest(StationId("P1"), version, pulses, Actor(actor), source, Timestamp(1.0))


def test_an_edited_dest_of_a_port_that_was_taught_is_told_with_what_holds_and_how_to_take_the_files() -> None:
    (found,) = overruled(plant(TEXT), plant(EDITED), kept(dest(TAUGHT)))
    assert (found.what, found.name) == ("station", "P1")
    assert found.text == (
        "its dest in the plant file does not count (SHFT 1300, ROTA -300, LIFT 41000): "
        "version 2 of the database holds, by teaching, kim (SHFT 1210, ROTA -305, LIFT 41020)"
    )
    assert found.remedy == (
        'to take the file\'s: PUT /api/v1/stations/P1/dest {"shft": 1300, "rota": -300, "lift": 41000}'
    )


def test_a_value_of_an_older_file_holds_too_and_one_of_which_some_axes_are_known() -> None:
    (found,) = overruled(plant(TEXT), plant(EDITED), kept(dest(BY_FILE, 1, "plant file", "controller")))
    assert "version 1 of the database holds, by plant file, controller (SHFT 1200, " in found.text
    (found,) = overruled(plant(TEXT), plant(EDITED), kept(dest(PartialPulses(lift=Pulses(3)))))
    assert found.text.endswith("(LIFT 3)")


@pytest.mark.parametrize("what", ["the file says what it said", "nothing is taught", "the file says what is taught"])
def test_nothing_is_told_where(what: str) -> None:
    same = PulseSet(Pulses(1300), Pulses(-300), Pulses(41000))
    new, there = {
        "the file says what it said": (TEXT, kept(dest(TAUGHT))),
        "nothing is taught": (EDITED, kept()),
        "the file says what is taught": (EDITED, kept(dest(same))),
    }[what]
    assert overruled(plant(TEXT), plant(new), there) == []


def test_an_edited_offset_is_told_but_not_that_of_a_reference_vehicle() -> None:
    edited = TEXT.replace("offset: {shft: 10, rota: -4, lift: 120}", "offset: {shft: 11, rota: -4, lift: 120}")
    holds = VehicleOffset(VehicleId("V001"), 3, TAUGHT, Actor("kim"), "rest", Timestamp(1.0))
    (found,) = overruled(plant(TEXT), plant(edited), kept(offsets=(holds,)))
    assert (found.what, found.name) == ("vehicle", "V001")
    assert found.text.startswith("its offset in the plant file does not count (SHFT 11,")
    assert "PUT /api/v1/vehicles/V001/offset" in found.remedy
