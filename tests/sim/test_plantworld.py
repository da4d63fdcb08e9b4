"""The simulated plant becomes another one while its vehicles stand and drive."""

from dataclasses import replace
from pathlib import Path

import pytest

from app.domain.ids import CarrierId, StationId, VehicleId
from app.domain.layout import Plant, StationKind
from app.domain.units import Barcode, Millimetres, Seconds
from app.plant import read
from app.sim.plantworld import SimulatedPlant, unfollowed

PLANTS = Path(__file__).parents[2] / "plants"
NOW = Seconds(1.0)
P1, V1, V2, V9 = StationId("P1"), VehicleId("V001"), VehicleId("V002"), VehicleId("V009")
FOUP1 = CarrierId("FOUP0001")


def plant(name: str) -> Plant:
    return read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)[0]


@pytest.fixture
def floor() -> SimulatedPlant:
    return SimulatedPlant(plant("small"))


def test_stations_and_track_follow_and_carriers_stay_where_they_are(floor: SimulatedPlant) -> None:
    port = floor.plant.station(P1)
    assert port is not None
    moved = replace(port, id=StationId("P9"), barcode=Barcode("108"))
    short = tuple(edge for edge in floor.plant.edges if edge.start != "108")
    came, gone = floor.follow(replace(floor.plant, stations=(*floor.plant.stations, moved), edges=short), NOW)
    assert (came, gone) == ([], [])
    assert floor.truth.at[P1] == FOUP1
    assert floor.truth.take(V1, port.barcode, StationKind.PORT, None)
    assert floor.truth.put(V1, moved.barcode, StationKind.PORT, None)
    assert floor.truth.at[moved.id] == FOUP1
    assert floor.devices[V1]._track.edge(Barcode("108"), Barcode("109")) is None


def test_what_stands_at_a_station_that_goes_goes_with_it(floor: SimulatedPlant) -> None:
    less = tuple(station for station in floor.plant.stations if station.id != P1)
    floor.follow(replace(floor.plant, stations=less), NOW)
    assert P1 not in floor.truth.at
    assert floor.truth.total == len(floor.truth.at) == 1


def test_hoists_come_where_nobody_stands_and_go(floor: SimulatedPlant) -> None:
    second = next(spec for spec in floor.plant.vehicles if spec.id == V2)
    third = replace(second, id=V9, start=floor.places(NOW)[V1][0])
    stayed = floor.devices[V1]
    came, gone = floor.follow(replace(floor.plant, vehicles=(floor.plant.vehicles[0], third)), NOW)
    assert (came, gone) == ([third], [V2])
    assert set(floor.devices) == {V1, V9}
    assert floor.devices[V1] is stayed
    places = [place[0] for place in floor.places(NOW).values()]
    assert len(set(places)) == 2


def test_agvs_find_new_tape(floor: SimulatedPlant) -> None:
    hall = SimulatedPlant(plant("hall"))
    where = {vehicle: agv.place(NOW)[0] for vehicle, agv in hall.halls.agvs.items()}
    away = next(edge for edge in hall.plant.edges if edge.start == where[VehicleId("AGV1")])
    assert hall.halls._tape.edge(away.start, away.end) is not None
    hall.follow(replace(hall.plant, edges=tuple(edge for edge in hall.plant.edges if edge != away)), NOW)
    assert hall.halls._tape.edge(away.start, away.end) is None


def test_what_is_not_followed_is_told(floor: SimulatedPlant) -> None:
    old = plant("demo")
    hoist = next(spec for spec in old.vehicles if spec.link is None)
    agv = next(spec for spec in old.vehicles if spec.link is not None)
    slow = replace(hoist, max_speed=Millimetres(1))
    new = replace(
        old,
        doors=(),
        drives=old.drives[1:],
        vehicles=tuple(slow if spec is hoist else spec for spec in old.vehicles if spec is not agv),
        stations=old.stations[1:],
    )
    assert unfollowed(old, new) == [
        f"vehicle {agv.id} removed",
        f"vehicle {hoist.id} changed",
        f"door {old.doors[0].id} removed",
        f"drive {old.drives[0].id} removed",
    ]
    come = replace(hoist, id=VehicleId("V777"))
    assert unfollowed(old, replace(old, vehicles=(*old.vehicles, come))) == []
