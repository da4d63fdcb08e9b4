from dataclasses import replace

import pytest

from app.domain.ids import CarrierId, StationId, VehicleId
from app.domain.layout import PulseSet, StationKind
from app.domain.units import Barcode, Pulses
from app.sim.truth import Act, Deed, Truth
from tests.sim.plants import line

V, B, D = VehicleId("V1"), Barcode("b"), Barcode("d")


def target(shft: int) -> PulseSet:
    return PulseSet(Pulses(shft), Pulses(0), Pulses(0))


class Scene:
    def __init__(self) -> None:
        self.acts: list[Act] = []
        self.truth = Truth(line(), self.acts.append)

    @property
    def deeds(self) -> list[Deed]:
        return [act.deed for act in self.acts]


def test_a_carrier_goes_from_a_station_aboard_and_down_again() -> None:
    scene = Scene()
    assert scene.truth.take(V, B, StationKind.PORT, target(100))
    assert scene.truth.aboard == {V: CarrierId("F1")}
    assert scene.truth.put(V, D, StationKind.SBFL, None)
    assert scene.truth.at == {StationId("L"): CarrierId("F1")}
    assert scene.deeds == [Deed.TAKE, Deed.PUT]


def test_of_two_stations_at_one_barcode_the_pulses_choose() -> None:
    scene = Scene()
    assert not scene.truth.take(V, B, StationKind.PORT, target(9000))
    assert scene.acts[-1].station == StationId("P2")
    assert scene.truth.take(V, B, StationKind.PORT, target(120))


def test_a_gripper_that_closes_on_nothing_is_told() -> None:
    scene = Scene()
    assert not scene.truth.take(V, D, StationKind.SBFL, None)
    assert not scene.truth.take(V, D, StationKind.PORT, target(0))
    assert scene.deeds == [Deed.TAKE_FAILED, Deed.TAKE_FAILED]


def test_a_second_carrier_cannot_be_gripped() -> None:
    scene = Scene()
    scene.truth.take(V, B, StationKind.PORT, target(100))
    scene.truth.install(CarrierId("F2"), StationId("L"))
    assert not scene.truth.take(V, D, StationKind.SBFL, None)
    assert scene.truth.at[StationId("L")] == CarrierId("F2")


def test_a_carrier_is_not_put_onto_another_nor_out_of_an_empty_gripper() -> None:
    scene = Scene()
    assert not scene.truth.put(V, D, StationKind.SBFL, None)
    scene.truth.take(V, B, StationKind.PORT, target(100))
    scene.truth.install(CarrierId("F2"), StationId("L"))
    assert not scene.truth.put(V, D, StationKind.SBFL, None)
    assert scene.deeds == [Deed.PUT_FAILED, Deed.TAKE, Deed.PUT_FAILED]


def test_equipment_takes_and_brings_carriers() -> None:
    scene = Scene()
    assert scene.truth.remove(StationId("P1")) == CarrierId("F1")
    assert scene.truth.total == 0
    scene.truth.install(CarrierId("F9"), StationId("P1"))
    assert scene.truth.total == 1
    with pytest.raises(ValueError, match="F9 stands at P1"):
        scene.truth.install(CarrierId("F1"), StationId("P1"))


def test_a_hoist_brought_over_a_port_stands_where_the_port_and_its_own_mechanics_put_it() -> None:
    plant = line()
    ports = tuple(replace(s, dest=None) for s in plant.stations)
    truth = Truth(replace(plant, stations=ports, reference_vehicles=frozenset({V})))
    mine, again = truth.aligned(V, B), Truth(replace(plant, stations=ports)).aligned(VehicleId("V2"), B)
    assert mine is not None
    assert again is not None
    assert 0 < abs(mine.lift - again.lift) <= 150
    assert truth.aligned(V, D) is None


def test_what_the_plant_file_says_of_a_port_is_where_it_is() -> None:
    truth = Truth(replace(line(), reference_vehicles=frozenset({V})))
    assert truth.aligned(V, B) == target(100)
