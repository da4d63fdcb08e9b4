"""The generated fab: its figures, its plan, its file, its vehicles."""

import os
import subprocess
import sys
from collections import Counter
from dataclasses import replace
from typing import Any

import pytest

from app.domain.layout import Plant, StationKind
from app.domain.units import Millimetres
from app.planning.buffers import Buffers
from app.planning.clearance import crossing_edges
from app.planning.track import Track
from app.plant import read
from app.plant.fab import SIZES, Fab, Shape, chains, generate, populate, statistics, write
from app.plant.fab.populate import VEHICLE_LENGTH
from app.plant.fab.shape import LANE_CHANGES
from app.plant.fab.spine import INNER_ASIDE

SMALL = generate(SIZES["1k"], 1)


@pytest.fixture(scope="module")
def standard() -> Fab:
    """The fab of TRAFFIC section 1."""
    return generate(SIZES["10k"], 1)


def test_the_standard_fab_has_the_figures_of_a_real_one(standard: Fab) -> None:
    figures = statistics(standard.plant)
    assert len(standard.bays) == 40
    assert figures.diverges == figures.merges == 566
    assert figures.barcodes == pytest.approx(10_312, rel=0.01)
    assert figures.kilometres == pytest.approx(11, rel=0.03)
    assert figures.mean_path == pytest.approx(257, rel=0.03)
    assert figures.buffers == pytest.approx(1470, rel=0.01)
    assert figures.parts == 1


@pytest.mark.parametrize(("size", "buffers"), [("50k", 1400), ("50k-dense", 7000)])
def test_the_large_sizes_have_50_000_barcodes_in_so_many_buffers_and_no_crossing(size: str, buffers: int) -> None:
    plant = generate(SIZES[size], 1).plant
    assert len(plant.points) == pytest.approx(50_000, rel=0.01)
    assert len(chains(plant)) == pytest.approx(buffers, rel=0.01)
    assert crossing_edges(plant.edges, {point.barcode: point for point in plant.points}) == []


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_whatever_the_seed_the_figures_that_a_shape_promises_hold(seed: int) -> None:
    shape = SIZES["1k"]
    figures, usual = statistics(generate(shape, seed).plant), statistics(SMALL.plant)
    assert figures.diverges == figures.merges == shape.diverges
    assert figures.buffers == shape.buffers
    assert figures.barcodes == usual.barcodes
    assert figures.kilometres == pytest.approx(usual.kilometres, rel=0.01)


@pytest.mark.parametrize("seed", [2, 3])
def test_another_seed_is_another_fab_of_the_same_mean_path(standard: Fab, seed: int) -> None:
    other = generate(SIZES["10k"], seed)
    assert other.plant.edges != standard.plant.edges
    assert statistics(other.plant).mean_path == pytest.approx(257, rel=0.03)


@pytest.mark.parametrize("seed", range(5))
def test_every_barcode_can_be_reached_and_every_buffer_has_room_for_two(seed: int) -> None:
    plant = generate(SIZES["1k"], seed).plant
    figures = statistics(plant)
    assert figures.parts == 1
    assert figures.single == 0
    assert min(len(chain) for chain in chains(plant)) == 2


def test_every_buffer_of_the_standard_fab_may_be_waited_in(standard: Fab) -> None:
    buffers = Buffers(Track(standard.plant), VEHICLE_LENGTH)
    assert not any(buffers.transit)
    assert min(buffers.capacity) == 2


def test_a_lane_change_is_driven_at_half_speed_and_has_room_for_three() -> None:
    shape = SIZES["1k"]
    slow = {edge.start for edge in SMALL.plant.edges if edge.speed == 50}
    places = {point.barcode: point for point in SMALL.plant.points}
    between_lanes = {b for b in slow if INNER_ASIDE < abs(places[b].y) < INNER_ASIDE + shape.lane_gap}
    assert sorted(len(chain) for chain in chains(SMALL.plant) if between_lanes.issuperset(chain)) == [3] * 8
    assert len(between_lanes) == 3 * shape.bays * LANE_CHANGES


def test_no_two_edges_meet_but_at_a_common_barcode(standard: Fab) -> None:
    track = Track(standard.plant)
    assert [barcode for barcode in track.barcodes if track.conflicts(barcode)] == []
    assert len(track.areas) == 1


def test_a_vehicle_covers_its_own_barcode_alone(standard: Fab) -> None:
    longest = max(vehicle.length for vehicle in populate(standard.plant, 3, 1).vehicles)
    assert min(edge.length for edge in standard.plant.edges) > longest


def test_rails_that_no_junction_joins_keep_1200_mm(standard: Fab) -> None:
    track = Track(replace(standard.plant, clearance=Millimetres(1200)))
    ends = {barcode for chain in chains(standard.plant) for barcode in (*chain[:2], *chain[-2:])}
    across = {edge.start for edge in standard.plant.edges if edge.speed == 50}
    assert [b for b in track.barcodes if b not in ends and set(track.conflicts(b)) - across] == []


def test_vehicles_slow_down_where_the_track_turns() -> None:
    places = {point.barcode: point for point in SMALL.plant.points}
    for edge in SMALL.plant.edges:
        dx, dy = places[edge.end].x - places[edge.start].x, places[edge.end].y - places[edge.start].y
        assert edge.curve or edge.speed == 50 or dx == 0 or dy == 0


def test_every_barcode_lies_in_one_bay_or_on_the_spine() -> None:
    parts = [*SMALL.bays.values(), SMALL.spine]
    everywhere = Counter(barcode for part in parts for barcode in part)
    assert everywhere == Counter(point.barcode for point in SMALL.plant.points)
    assert all(SMALL.bay_of[barcode] == name for name, barcodes in SMALL.bays.items() for barcode in barcodes)
    assert all(station.id.startswith(SMALL.bay_of[station.barcode]) for station in SMALL.plant.stations)


def test_stations_have_barcodes_of_their_own_away_from_junctions() -> None:
    at = [station.barcode for station in SMALL.plant.stations]
    into, out = Counter(e.end for e in SMALL.plant.edges), Counter(e.start for e in SMALL.plant.edges)
    assert len(set(at)) == len(at)
    assert all(into[barcode] == out[barcode] == 1 for barcode in at)
    assert {station.kind for station in SMALL.plant.stations} == {StationKind.PORT, StationKind.SBFL, StationKind.SBFR}


def test_barcodes_fit_four_bytes_on_the_wire(standard: Fab) -> None:
    assert all(0 < int(point.barcode) < 1 << 31 for point in standard.plant.points)


def test_the_file_reads_back_as_the_plant() -> None:
    plant = populate(SMALL.plant, 40, 1, carriers=0.3)
    found, findings = read(write(plant), "fab-1k.yaml")
    assert found == plant
    assert findings == []


def test_the_same_seed_writes_the_same_file_in_another_process() -> None:
    code = "from app.plant.fab import *; print(write(populate(generate(SIZES['1k'], 5).plant, 9, 5, 0.5)), end='')"
    environment = {**os.environ, "PYTHONHASHSEED": "1"}
    told = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, check=True, text=True)
    assert told.stdout == write(populate(generate(SIZES["1k"], 5).plant, 9, 5, 0.5))


def test_a_vehicle_of_its_own_figures_is_written_with_them() -> None:
    plant = populate(SMALL.plant, 2, 1)
    slow = replace(plant.vehicles[1], max_speed=Millimetres(1500), in_service=False, offset=None, start=None)
    plant = replace(plant, vehicles=(plant.vehicles[0], slow))
    assert read(write(plant), "fab.yaml")[0] == plant


def test_a_plant_that_is_more_than_a_fab_is_written_whole() -> None:
    more = replace(SMALL.plant, alarm_codes={1: "lost"})
    assert read(write(more), "fab.yaml")[0] == more


def fully_populated() -> Plant:
    """The small fab with as many vehicles as it takes."""
    with pytest.raises(ValueError, match="may be started from") as refused:
        populate(SMALL.plant, 10_000, 1)
    return populate(SMALL.plant, int(str(refused.value).split(": ")[1].split()[0]), 1)


def test_even_the_fullest_fab_starts_with_a_free_place_in_every_buffer_and_free_junctions() -> None:
    plant = fully_populated()
    started = {vehicle.start for vehicle in plant.vehicles}
    into, out = Counter(e.end for e in plant.edges), Counter(e.start for e in plant.edges)
    assert len(started) == len(plant.vehicles) > 700
    assert all(into[barcode] == out[barcode] == 1 for barcode in started if barcode)
    assert all(set(chain) - started for chain in chains(plant))


def test_vehicles_are_spread_over_all_bays(standard: Fab) -> None:
    plant = populate(standard.plant, 400, 7)
    places = Counter(
        standard.bay_of.get(vehicle.start or plant.points[0].barcode, "spine") for vehicle in plant.vehicles
    )
    assert set(places) == {*standard.bays, "spine"}
    assert all(4 <= places[bay] <= 14 for bay in standard.bays)


def test_each_vehicle_has_an_address_and_a_number_of_its_own() -> None:
    vehicles = fully_populated().vehicles
    assert len({(vehicle.host, vehicle.port) for vehicle in vehicles}) == len(vehicles)
    assert all(1024 < vehicle.port < 32_768 for vehicle in vehicles)
    assert sorted(vehicle.dev_id for vehicle in vehicles) == list(range(1, len(vehicles) + 1))


@pytest.mark.parametrize(("carriers", "count"), [(0.5, 242), (7, 7), (0.0, 0), (1.0, 485)])
def test_carriers_are_a_number_or_a_share_of_the_ports(carriers: float | int, count: int) -> None:
    plant = populate(SMALL.plant, 0, 1, carriers)
    ports = {station.id for station in plant.stations if station.kind is StationKind.PORT}
    assert len(ports) == 485
    assert len({station for _, station in plant.carriers} & ports) == len(plant.carriers) == count


def test_more_carriers_than_ports_are_refused() -> None:
    with pytest.raises(ValueError, match="486 carriers do not fit 485 ports"):
        populate(SMALL.plant, 0, 1, 486)


@pytest.mark.parametrize(
    "wrong",
    [{"bays": 3}, {"column": 14}, {"pitch": 1000}, {"lane_gap": 1100}, {"turnarounds": 11}, {"shortcuts": 4000}],
    ids=str,
)
def test_a_shape_that_cannot_be_drawn_is_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"bays|close|turnarounds|room"):
        generate(replace(Shape(), **wrong), 1)


def test_a_ring_without_junctions_is_one_chain() -> None:
    ring, _ = read("barcodes: {1: [0, 0], 2: [1000, 0], 3: [0, 1000]}\ntrack: [{through: [1..3, 1]}]\n", "ring.yaml")
    assert chains(ring) == [("1", "2", "3")]
    assert statistics(ring).mean_path == 0
