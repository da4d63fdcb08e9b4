"""A sound plant file becomes the plant that it describes."""

import json
from pathlib import Path

import jsonschema
import pytest
import yaml

from app.domain.layout import Axis, Edge, Meter, PulseSet, StationKind, StopAction
from app.domain.units import Barcode, Millimetres, Percent, Pulses, Seconds
from app.plant import UnusablePlant, dialect_of, read, schema, schema_text
from app.plant.names import address, expand
from app.protocols.itsc.dialects import DIALECTS, DialectError

PLANTS = Path(__file__).parents[2] / "plants"

TINY = """\
barcodes: {1: [0, 0], 2: [1000, 0], 3: [1000, 800], 4: [0, 800]}
track:
  - {through: [1, 2, 3, 4, 1]}
parking: [4]
stations:
  P1: {kind: port, at: 2}
  P2: {kind: sbfl, at: 3}
vehicles:
  V1: {dev_id: 7, address: "10.0.0.7:9000", start: 1}
"""


def example(name: str) -> str:
    return (PLANTS / name).read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["small.yaml", "demo.yaml"])
def test_an_example_plant_has_no_finding(name: str) -> None:
    plant, findings = read(example(name), f"plants/{name}")
    assert findings == []
    assert plant.name == name.removesuffix(".yaml")


@pytest.mark.parametrize("name", ["small.yaml", "demo.yaml"])
def test_an_example_plant_satisfies_the_schema_and_names_it(name: str) -> None:
    assert example(name).startswith("# yaml-language-server: $schema=plant.schema.json\n")
    jsonschema.validate(yaml.safe_load(example(name)), schema())


def test_the_committed_schema_is_the_one_that_the_structs_give() -> None:
    assert example("plant.schema.json") == schema_text()
    jsonschema.Draft202012Validator.check_schema(json.loads(schema_text()))


def test_the_schema_refuses_an_unknown_dialect_field_and_a_speed_of_zero() -> None:
    good = yaml.safe_load(TINY)
    jsonschema.validate(good, schema())
    for bad in ({"dialects": {"x": {"byteorder": "big"}}}, {"track": [{"through": [1, 2], "speed": 0}]}):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(good | bad, schema())


def test_the_demo_plant_has_room_for_ten_hoists_in_two_dialects() -> None:
    plant, _ = read(example("demo.yaml"), "demo")
    kinds = [station.kind for station in plant.stations]
    assert (kinds.count(StationKind.PORT), kinds.count(StationKind.SBFL), kinds.count(StationKind.SBFR)) == (20, 8, 8)
    assert [vehicle.dev_id for vehicle in plant.hoists] == list(range(1, 11))
    assert sorted({vehicle.dialect for vehicle in plant.hoists}) == ["default", "slides"]
    assert sum(point.park for point in plant.points) >= len(plant.vehicles)
    assert all(station.dest for station in plant.stations if station.kind is StationKind.PORT)
    assert all(vehicle.offset and vehicle.start for vehicle in plant.hoists)


def test_edges_follow_the_track_in_driving_direction_and_measure_the_positions() -> None:
    plant, _ = read(TINY, "tiny")
    assert [(edge.start, edge.end, edge.length) for edge in plant.edges] == [
        ("1", "2", 1000),
        ("2", "3", 800),
        ("3", "4", 1000),
        ("4", "1", 800),
    ]


def test_a_run_gives_its_speed_sensor_curve_and_length_to_every_edge() -> None:
    text = TINY.replace(
        "[1, 2, 3, 4, 1]}", "[1, 2], speed: 40, sensor: 15, curve: true, length: 1100}\n  - {through: [2..4, 1]}"
    )
    plant, _ = read(text, "tiny")
    assert plant.edges[0] == Edge(Barcode("1"), Barcode("2"), Millimetres(1100), Percent(40), 15, curve=True)
    assert plant.edges[1] == Edge(Barcode("2"), Barcode("3"), Millimetres(800))


def test_a_range_of_barcodes_lies_evenly_on_a_straight_line() -> None:
    text = TINY.replace(
        "{1: [0, 0], 2: [1000, 0], 3: [1000, 800], 4: [0, 800]}", "{1..4: {from: [0, 0], to: [3100, 30]}}"
    )
    plant, _ = read(text.replace("[1, 2, 3, 4, 1]}", "[1..4]}\n  - {through: [4, 1]}"), "tiny")
    assert [(p.x, p.y) for p in plant.points] == [(0, 0), (1033, 10), (2067, 20), (3100, 30)]


def test_stations_carry_what_the_file_says_and_its_defaults() -> None:
    plant, _ = read(example("small.yaml"), "small")
    p1, p3, b2 = (plant.stations[index] for index in (0, 2, 4))
    assert p1.dest == PulseSet(Pulses(1200), Pulses(-300), Pulses(41000))
    assert (p1.display, p1.look_down, p1.speed, p1.fallbacks) == ("P1", 3, 50, ("B1",))
    assert p3.display == "LOADER-3"
    assert (b2.kind.stop_action, b2.speed, b2.dest) == (StopAction.SBFR, 80, None)


def test_a_vehicle_takes_its_own_value_before_the_default_of_the_file_before_ours() -> None:
    text = TINY.replace("start: 1}", "start: 1, length: 900, limits: {shft: [-1, 1], rota: [-2, 2], lift: [0, 3]}}")
    plant, _ = read(text + "vehicle_defaults: {length: 1200, braking: 2500, in_service: false}\n", "tiny")
    vehicle = plant.vehicles[0]
    assert (vehicle.length, vehicle.braking, vehicle.acceleration, vehicle.in_service) == (900, 2500, 2000, False)
    assert (vehicle.host, vehicle.port, vehicle.start, vehicle.dev_id) == ("10.0.0.7", 9000, "1", 7)
    assert vehicle.limits.of(Axis.LIFT) == (0, 3)


def test_a_vehicle_may_connect_to_us() -> None:
    text = TINY.replace('address: "10.0.0.7:9000"', "listen: true, address: 10.0.0.7") + 'listen: "[::1]:47000"\n'
    plant, _ = read(text, "tiny")
    assert plant.listen == ("::1", 47000)
    assert (plant.vehicles[0].listen, plant.vehicles[0].host, plant.vehicles[0].port) == (True, "10.0.0.7", 0)


def test_zones_carriers_and_code_names_are_read() -> None:
    plant, _ = read(example("small.yaml"), "small")
    assert [(zone.id, sorted(zone.barcodes), zone.capacity, zone.no_stop, zone.name) for zone in plant.zones] == [
        ("east-curve", ["109", "110", "111"], 1, True, "East curve")
    ]
    assert plant.carriers == (("FOUP0001", "P1"), ("FOUP0002", "B1"))
    assert plant.process_codes == {0x2100: "moving"}
    assert plant.alarm_codes[201] == "no carrier found"
    assert plant.event_numbers == {"TransferCompleted": 107}


def test_a_zone_is_soft_with_a_share_and_a_patience() -> None:
    def zones(of: str) -> list[Meter | None]:
        plant, _ = read(TINY + f"zones: {{Z: {{barcodes: [1]{of}}}}}\n", "tiny")
        return [zone.meter for zone in plant.zones]

    assert zones("") == [None]
    assert zones(", soft: true") == [Meter(0.35, Seconds(60))]
    assert zones(", soft: true, share: 0.5, patience: 20") == [Meter(0.5, Seconds(20))]


def test_a_dialect_of_the_plant_is_a_preset_with_changes() -> None:
    text = TINY.replace("start: 1}", "start: 1, dialect: mine}") + "dialects: {mine: {preset: slides, crc: xmodem}}\n"
    plant, _ = read(text, "tiny")
    mine = dialect_of(plant, "mine")
    assert (mine.barcode_bytes, mine.crc, mine.byte_order) == (4, "xmodem", "big")
    assert dialect_of(plant, "slides") is DIALECTS["slides"]
    with pytest.raises(DialectError, match="unknown dialect 'min'"):
        dialect_of(plant, "min")


def test_text_barcodes_keep_their_leading_zeros_in_the_ascii_dialect() -> None:
    text = (
        TINY.replace("{1: [0, 0], 2:", "{0A01: [0, 0], 0002:")
        .replace("[1, 2, 3, 4, 1]", "[0A01, 0002, 3, 4, 0A01]")
        .replace("at: 2", "at: 0002")
    )
    text = text.replace("start: 1}", "start: 0A01, dialect: ascii-barcode}")
    plant, findings = read(text, "tiny")
    assert [point.barcode for point in plant.points] == ["0A01", "0002", "3", "4"]
    assert findings == []


def test_the_plant_is_named_after_its_file_unless_it_names_itself() -> None:
    assert read(TINY, "C:\\plants\\hall.v2.yaml")[0].name == "hall"
    assert read(TINY, "/etc/hall.yaml")[0].name == "hall"
    assert read("name: Hall 3\n" + TINY, "/etc/hall.yaml")[0].name == "Hall 3"


def test_ranges_go_both_ways_and_keep_prefix_and_digits() -> None:
    assert expand("7..10") == ("7", "8", "9", "10")
    assert expand("B2-011..B2-009") == ("B2-011", "B2-010", "B2-009")
    assert address("host.fab:1") == ("host.fab", 1)


def test_an_unusable_plant_names_its_first_error_and_holds_all() -> None:
    with pytest.raises(UnusablePlant) as caught:
        read(TINY.replace("at: 2", "at: 99").replace("at: 3", "at: 98"), "hall.yaml")
    assert str(caught.value) == "hall.yaml:6:24: error: unknown barcode 99 (and 1 more)"
    assert caught.value.remedy == "give it under barcodes"
    assert [finding.line for finding in caught.value.findings] == [6, 7]


def test_a_reference_vehicle_has_no_offset_of_its_own() -> None:
    text = example("small.yaml").replace("V002: {dev_id: 2,", "V002: {dev_id: 2, reference: true,")
    plant, findings = read(text, "small.yaml")
    assert plant.reference_vehicles == {"V002"}
    assert plant.vehicles[1].offset is None
    (finding,) = findings
    assert "V002 is a reference vehicle: its offset is zero" in finding.message
    assert "leave one of them out" in finding.remedy
