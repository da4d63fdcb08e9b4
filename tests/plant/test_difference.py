"""What differs between two plants, and what it breaks."""

from dataclasses import fields, replace
from pathlib import Path

import pytest

from app.domain.ids import VehicleId
from app.domain.layout import Plant
from app.plant import read
from app.plant.difference import RULES, SECTIONS, Difference, difference

SMALL = (Path(__file__).parents[2] / "plants" / "small.yaml").read_text(encoding="utf-8")


def plant(*changes: tuple[str, str], text: str = SMALL) -> Plant:
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    return read(text, "small")[0]


def told(made: Difference) -> list[str]:
    return [f"{c.what} {c.name} {c.how}" + (f": {c.text}" if c.text else "") for c in made.changes]


def broken(made: Difference) -> dict[str, str]:
    return {f"{item.what} {item.name}": item.text for item in made.broken}


def test_a_plant_does_not_differ_from_itself() -> None:
    assert difference(plant(), plant()) == Difference([], [])


def test_every_field_of_a_plant_is_compared() -> None:
    track = {"points", "edges", "stations", "catalogues"}
    assert {field.name for field in fields(Plant)} == track | set(SECTIONS) | set(RULES)


def test_a_reference_vehicle_and_what_carriers_are_for_are_told() -> None:
    was = plant()
    made = difference(was, replace(was, reference_vehicles=frozenset({VehicleId("V001")}), carriers=was.carriers[:1]))
    assert told(made)[0] == "plant reference_vehicles changed: [] → ['V001']"
    assert told(made)[1].endswith("; counts only where a database is made: PUT /api/v1/carriers/ID with its place")


def test_a_moved_barcode_is_told_with_its_way() -> None:
    made = difference(plant(), plant(("118: [0, 1000]", "118: [30, 1040]")))
    assert told(made) == ["barcode 118 moved: by 50 mm, from [0, 1000] to [30, 1040]"]
    assert made.broken == []


def test_an_added_barcode_splits_its_track() -> None:
    made = difference(
        plant(),
        plant(
            ("110: [10000, 1000]", "110: [10000, 1000]\n  210: [9900, 500]"),
            (
                "[109, 110, 111], curve: true, speed: 60, sensor: 2, length: 1571",
                "[109, 210, 110, 111], curve: true, speed: 60, sensor: 2",
            ),
        ),
    )
    lines = told(made)
    assert "barcode 210 added: at [9900, 500]" in lines
    assert "track 109 → 110 removed: was 1571 mm long" in lines
    assert any(line.startswith("track 109 → 210 added") for line in lines)
    assert "track 110 → 111 changed: length 1571 → 1414 mm" in lines


def test_a_barcode_with_a_new_name_is_renamed_not_removed() -> None:
    made = difference(plant(), plant(("  118: [0", "  218: [0"), ("117, 118, 101", "117, 218, 101")))
    assert told(made)[0] == "barcode 118 renamed: is 218 now, at the same place"
    assert not any(line.startswith(("barcode 118 removed", "barcode 218 added")) for line in told(made))
    assert "barcode 118" in broken(made)


def test_lengths_speeds_and_parking_are_compared() -> None:
    made = difference(
        plant(),
        plant(
            (
                "speed: 60, sensor: 2, length: 1571}\n  - {through: [111",
                "speed: 50, sensor: 2, length: 1600}\n  - {through: [111",
            ),
            ("[102, 108, 112]", "[102, 112]"),
        ),
    )
    assert told(made) == [
        "barcode 108 changed: is no parking place any more",
        "track 109 → 110 changed: length 1571 → 1600 mm, speed 60 → 50 %",
        "track 110 → 111 changed: length 1571 → 1600 mm, speed 60 → 50 %",
    ]


def test_a_removed_station_breaks_what_names_it() -> None:
    made = difference(plant(), plant(("  B2: {kind: sbfr, at: 115, speed: 80}\n", "")))
    assert told(made) == ["station B2 removed"]
    assert "its taught DEST and reservations name a station that is not there" in broken(made)["station B2"]
    assert made.broken[0].touches == ("jobs", "carriers", "teaching", "fallbacks")


def test_a_station_at_another_barcode_must_be_taught_anew() -> None:
    made = difference(plant(), plant(("at: 106", "at: 107")))
    assert told(made) == ["station P2 changed: barcode 106 → 107"]
    assert "its taught DEST was measured at the other" in broken(made)["station P2"]


def test_a_station_whose_barcode_was_only_renamed_is_the_same_place() -> None:
    line = "111..117: {from: [9000, 2000], to: [1000, 2000]}"
    parts = ("111..113: {from: [9000, 2000], to: [6333, 2000]}", "214: [5000, 2000]")
    rest = "115..117: {from: [3667, 2000], to: [1000, 2000]}"
    track = ("through: [111..117]", "through: [111..113, 214, 115..117]")
    changes = ((line, "\n  ".join((*parts, rest))), track, ("at: 114", "at: 214"))
    made = difference(plant(), plant(*changes))
    assert "barcode 114 renamed: is 214 now, at the same place" in told(made)
    assert "station P3" not in broken(made)


def test_a_removed_vehicle_and_another_number_are_told() -> None:
    made = difference(plant(), plant(("dev_id: 2,", "dev_id: 7,"), ('127.0.0.1:17101"', '10.0.0.1:17101"')))
    assert told(made) == ["vehicle V001 changed: host 127.0.0.1 → 10.0.0.1", "vehicle V002 changed: dev_id 2 → 7"]
    assert list(broken(made)) == ["vehicle V002"]
    without = "\n".join(line for line in SMALL.splitlines() if "V002:" not in line)
    assert list(broken(difference(plant(), plant(text=without)))) == ["vehicle V002"]


ISLAND = """
barcodes: {1: [0, 0], 2: [4000, 0], 3: [8000, 0], 4: [8000, 4000], 5: [0, 4000], 6: [0, 8000], 7: [8000, 8000]}
track: [{through: [1..5, 1]}, {through: [5, 6, 7, 4]}%s]
stations: {A: {kind: port, at: 2}, B: {kind: port, at: 3}, C: {kind: port, at: 6}, D: {kind: port, at: 7}}
"""


def test_stations_that_are_cut_off_break() -> None:
    whole = read(ISLAND % "", "island")[0]
    cut = ISLAND.replace("{through: [5, 6, 7, 4]}%s", "{through: [6, 7, 6]}")
    made = difference(whole, read(cut, "island")[0])
    assert set(broken(made)) == {"station C", "station D"}


def test_zones_rules_and_equipment_are_compared() -> None:
    hall = (Path(__file__).parents[2] / "plants" / "hall.yaml").read_text(encoding="utf-8")
    new = (
        hall.replace("number: 30", "number: 31")
        .replace("lasting: 300", "lasting: 600")
        .replace("alias: C1", "alias: C2")
    )
    made = difference(
        plant(text=hall), plant(("dialect: {preset: max64}", "dialect: {preset: max64, door_ids: [31]}"), text=new)
    )
    names = {(change.what, change.name) for change in made.changes}
    assert names == {("link", "hall"), ("door", "DOOR1"), ("charger", "CHARGER1"), ("plant", "charging")}


@pytest.mark.parametrize("name", ["small", "hall", "demo"])
def test_taking_everything_away_is_told_without_end(name: str) -> None:
    given = plant(text=(Path(__file__).parents[2] / "plants" / f"{name}.yaml").read_text(encoding="utf-8"))
    bare = read(ISLAND % "", "island")[0]
    made = difference(given, bare)
    removed = {c.name for c in made.changes if (c.what, c.how) == ("station", "removed")}
    assert removed == {station.id for station in given.stations} - {"A", "B", "C", "D"}
    assert len(made.broken) >= len(removed)


def test_pulses_in_the_file_are_told_to_count_for_a_new_database_alone() -> None:
    dest = "dest: {shft: 5, rota: 5, lift: 5}"
    new = plant(("  B1: {", f"  P9: {{kind: port, at: 108, {dest}}}\n  B1: {{"))
    taught = "its dest counts only where a database is made: teach it, or PUT /api/v1/stations/ID/dest"
    assert told(difference(plant(), new)) == [f"station P9 added: {taught}"]
    moved = difference(plant(), plant(("lift: 41000", "lift: 41001"))).changes
    assert [(one.name, one.text.partition("; ")[2]) for one in moved] == [("P1", taught)]
    assert difference(plant(), plant(("  B1: {", "  P9: {kind: port, at: 108}\n  B1: {"))).changes[0].text == ""
