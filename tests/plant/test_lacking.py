"""What a changed plant brings along without the pulses that it needs."""

from dataclasses import replace
from pathlib import Path
from typing import Any

from app.domain.ids import Actor, Epoch, StationId, VehicleId
from app.domain.layout import Plant, PulseSet
from app.domain.pulses import PartialPulses
from app.domain.records import Kept, StationDest, VehicleOffset
from app.domain.units import Pulses, Timestamp
from app.plant import read
from app.plant.lacking import lacking

TEXT = (Path(__file__).parents[2] / "plants" / "small.yaml").read_text(encoding="utf-8")
OLD = read(TEXT, "small")[0]
P9, V009 = StationId("P9"), VehicleId("V009")
WITH_P9 = read(
    TEXT.replace("  B1: {", "  P9: {kind: port, at: 108, dest: {shft: 5, rota: 5, lift: 5}}\n  B1: {"), "small"
)[0]
WITH_V009 = replace(OLD, vehicles=(*OLD.vehicles, replace(OLD.vehicles[0], id=V009)))
KIM, NOW = Actor("kim"), Timestamp(0.0)
WHOLE = PulseSet(Pulses(1), Pulses(2), Pulses(3))


def told(new: Plant, **kept: Any) -> list[tuple[str, str]]:
    return [(one.name, one.text) for one in lacking(OLD, new, Kept(epoch=Epoch(1), **kept))]


def dest(pulses: PulseSet | PartialPulses) -> StationDest:
    return StationDest(P9, 1, pulses, KIM, "rest", NOW)


def test_a_new_port_is_to_be_taught_whatever_the_plant_file_says() -> None:
    assert told(WITH_P9) == [("P9", "P9 has no DEST (SHFT, ROTA, LIFT)")]
    assert told(WITH_P9, dests=(dest(PartialPulses(lift=Pulses(3))),)) == [("P9", "P9 has no DEST (SHFT, ROTA)")]


def test_one_that_was_taught_before_is_not() -> None:
    assert told(WITH_P9, dests=(dest(WHOLE),)) == []


def test_a_new_hoist_is_to_be_taught_unless_it_is_a_reference() -> None:
    assert told(WITH_V009) == [("V009", "V009 has no OFFSET (SHFT, ROTA, LIFT)")]
    assert told(WITH_V009, offsets=(VehicleOffset(V009, 1, WHOLE, KIM, "rest", NOW),)) == []
    assert told(replace(WITH_V009, reference_vehicles=frozenset({V009}))) == []


def test_what_was_there_and_a_new_side_buffer_need_nothing() -> None:
    new = read(TEXT.replace("  B1: {", "  B9: {kind: sbfl, at: 108}\n  B1: {"), "small")[0]
    assert "B9" in {station.id for station in new.stations}
    assert told(OLD) == told(new) == []
