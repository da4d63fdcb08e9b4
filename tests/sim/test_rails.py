from collections.abc import Sequence
from dataclasses import replace

from app.domain.ids import VehicleId
from app.domain.layout import Plant
from app.domain.units import Barcode, Millimetres
from app.sim.rails import Place, Rails
from tests.sim.plants import edges, line, points, vehicles

A, B = VehicleId("V1"), VehicleId("V2")


def at(barcode: str, past: float = 0.0, following: str | None = None) -> Place:
    return Barcode(barcode), past, None if following is None else Barcode(following)


def meetings(plant: Plant, *places: tuple[Place, Place]) -> Sequence[str]:
    """Return what the last look finds."""
    rails = Rails(plant)
    found: list[str] = []
    for one, other in places:
        found = list(rails.meetings({A: one, B: other}))
    return found


def test_vehicles_a_length_apart_do_not_meet() -> None:
    assert meetings(line(), (at("a"), at("c"))) == []


def test_a_front_in_another_vehicles_tail_is_found() -> None:
    found = meetings(line(), (at("a", 600, "b"), at("b", 900, "c")))
    assert found == ["V1 and V2 overlap between a and b"]


def test_two_vehicles_at_one_barcode_are_found() -> None:
    assert "V1 and V2 both cover barcode c" in meetings(line(), (at("c"), at("c")))


def test_a_tail_that_only_touches_is_no_meeting() -> None:
    assert meetings(line(), (at("b"), at("c", 500, "d"))) == []


def test_a_vehicle_covers_the_branch_it_came_by_and_not_the_other() -> None:
    plant = line()
    came_by_x = [(at("x"), at("a")), (at("c"), at("a")), (at("c", 100, "d"), at("b"))]
    assert meetings(plant, *came_by_x) == []
    came_by_b = [(at("b"), at("a")), (at("c"), at("a")), (at("c", 100, "d"), at("b"))]
    assert "V1 and V2 both cover barcode b" in meetings(plant, *came_by_b)


def test_a_branch_that_is_not_known_is_not_guessed() -> None:
    assert meetings(line(), (at("c"), at("b"))) == []


def test_a_vehicle_put_elsewhere_by_hand_leaves_no_trail() -> None:
    assert meetings(line(), (at("d"), at("e")), (at("a"), at("d"))) == []


def test_a_vehicle_that_is_gone_covers_nothing() -> None:
    rails = Rails(line())
    assert list(rails.meetings({A: at("c"), B: at("c")}))
    assert list(rails.meetings({A: at("c")})) == []
    assert list(rails.meetings({A: at("c", 1.0, "d")})) == []


def crossing() -> Plant:
    return Plant(
        name="crossing",
        points=points(a=(0, 0), b=(1000, 0), c=(500, -500), d=(500, 500)),
        edges=edges("a-b", "c-d"),
        stations=(),
        vehicles=vehicles("a", "c", length=300),
    )


def test_two_vehicles_where_rails_cross_are_found() -> None:
    assert meetings(crossing(), (at("a", 600, "b"), at("c", 700, "d"))) == ["V1 and V2 meet where c-d is crossed"]


def test_one_after_the_other_at_a_crossing_is_no_meeting() -> None:
    assert meetings(crossing(), (at("a", 900, "b"), at("c", 600, "d"))) == []


def test_rails_nearer_than_the_clearance_exclude_each_other() -> None:
    plant = replace(
        line(),
        points=points(a=(0, 0), b=(1000, 0), c=(2000, 0), d=(3000, 0), e=(4000, 0), x=(1000, 600)),
        clearance=Millimetres(700),
        vehicles=vehicles("b", "x", length=100),
    )
    found = meetings(plant, (at("b"), at("x")))
    assert "V1 at b and V2 at x are nearer than the clearance" in found


def test_neighbours_on_one_rail_may_be_nearer_than_the_clearance() -> None:
    plant = replace(line(), clearance=Millimetres(1200), vehicles=vehicles("b", "c", length=100))
    assert meetings(plant, (at("b"), at("c"))) == []
