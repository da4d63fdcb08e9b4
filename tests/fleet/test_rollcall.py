"""Who is missing after a start, by area."""

from app.domain.ids import VehicleId
from app.fleet.rollcall import named


def test_a_long_roll_call_names_the_first_and_counts_the_others() -> None:
    assert named(()) == ""
    assert named((VehicleId("V1"), VehicleId("V2"))) == "V1, V2"
    assert named(tuple(VehicleId(f"V{n}") for n in range(1, 8))) == "V1, V2, V3, V4, V5 and 2 more"
