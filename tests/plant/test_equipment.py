"""Links, AGVs, doors, buffers, chargers and drives of a plant file: read, and each mistake named."""

import pytest

from app.domain.devices import AliasName, DeviceId, DeviceNumber
from app.domain.drive import DriveAddress, DriveId
from app.domain.ids import DevId, LinkId, StationId, VehicleId
from app.domain.layout import (
    BufferSpec,
    ChargerSpec,
    ChargingRules,
    DoorSpec,
    DriveUnit,
    LinkSpec,
    OnEmergency,
    SerialPort,
    StationKind,
    VehicleKind,
    Wire,
)
from app.domain.units import Barcode, Seconds
from app.plant import read
from tests.plant.test_findings import Case, assert_found, findings_of, warning

HALL = """\
name: hall
barcodes: {"0101..0106": {from: [0, 0], to: [5000, 0]}}
track:
  - {through: ["0101..0106"]}
  - {through: ["0106..0101"]}
parking: ["0101", "0106"]
stations:
  AB1: {kind: agv_buffer, at: "0102", buffer: BUF1, alias: B1}
  AB2: {kind: agv_buffer, at: "0105"}
links:
  hall: {protocol: enig, address: "10.0.0.1:9000", dialect: {preset: max64}}
  axes: {protocol: hi, serial: {device: /dev/ttyS0, parity: even}}
doors:
  DOOR1: {link: hall, through: [["0103", "0104"]], on_emergency: open}
buffers:
  BUF1: {link: hall, number: 21}
chargers:
  CHG1: {at: "0106", alias: C1}
charging: {trips: 20, after: 3600, windows: ["12:00-12:30"]}
drives:
  AX1: {link: axes, id: 3, model: demo, name: Shutter}
agv_defaults: {length: 800}
vehicles:
  AGV1: {kind: agv, link: hall, dev_id: 11, start: "0101"}
  AGV2: {kind: agv, link: hall, dev_id: 12, start: "0106", max_speed: 900}
"""


def test_the_good_hall_has_no_finding() -> None:
    assert findings_of(HALL) == []


def test_a_hall_is_read_as_it_stands() -> None:
    plant, _ = read(HALL, "hall.yaml")
    assert plant.links == (
        LinkSpec(LinkId("hall"), Wire.ENIG, "10.0.0.1", 9000, None, {"preset": "max64"}),
        LinkSpec(LinkId("axes"), Wire.HI, "", 0, SerialPort("/dev/ttyS0", parity="E")),
    )
    passages = frozenset({(Barcode("0103"), Barcode("0104"))})
    assert plant.doors == (
        DoorSpec(DeviceId("DOOR1"), LinkId("hall"), DeviceNumber(30), passages, on_emergency=OnEmergency.OPEN),
    )
    assert plant.buffers == (BufferSpec(DeviceId("BUF1"), LinkId("hall"), DeviceNumber(21)),)
    assert plant.chargers == (ChargerSpec(DeviceId("CHG1"), Barcode("0106"), AliasName("C1")),)
    assert plant.charging == ChargingRules(20, Seconds(3600), Seconds(600), ((720, 750),))
    assert plant.drives == (DriveUnit(DriveId("AX1"), LinkId("axes"), DriveAddress(3), "demo", "Shutter"),)
    assert plant.aliases == {"B1": "0102", "C1": "0106"}


def test_agvs_are_vehicles_on_a_link_and_have_no_line_of_their_own() -> None:
    plant, _ = read(HALL, "hall.yaml")
    one, two = plant.vehicles
    assert (one.id, one.kind, one.link, one.dev_id) == (VehicleId("AGV1"), VehicleKind.AGV, LinkId("hall"), DevId(11))
    assert (one.length, one.max_speed, two.length, two.max_speed) == (800, 500, 800, 900)
    assert plant.hoists == ()
    assert plant.agvs_on(LinkId("hall")) == plant.vehicles
    station = plant.station(StationId("AB1"))
    assert station is not None
    assert (station.kind, station.buffer) == (StationKind.AGV_BUFFER, DeviceId("BUF1"))


CASES = {
    "a link reached in no way": Case(', address: "10.0.0.1:9000"', "", 11, "hall is reached in no way", "give address"),
    "a link reached in two ways": Case(
        "protocol: hi,", 'protocol: hi, address: "10.0.0.2:1",', 12, "axes is reached in two ways", "give address"
    ),
    "a link without a port": Case('"10.0.0.1:9000"', '"10.0.0.1"', 11, "10.0.0.1 has no port", "HOST:PORT"),
    "a link that speaks iTSC": Case("protocol: hi", "protocol: itsc", 12, "an iTSC line carries one hoist alone"),
    "a dialect field that there is not": Case(
        "preset: max64", "crc: arc", 11, "unknown dialect field", "known: preset"
    ),
    "a preset that there is not": Case("preset: max64", "preset: max65", 11, "'max65'"),
    "a door on a link that there is not": Case(
        "DOOR1: {link: hall", "DOOR1: {link: hal", 14, "unknown link hal", "did you mean hall?"
    ),
    "a door on a drive line": Case("DOOR1: {link: hall", "DOOR1: {link: axes", 14, "axes speaks hi, this needs enig"),
    "a door across no track": Case('"0103", "0104"', '"0103", "0105"', 14, "no track leads between 0103 and 0105"),
    "a door on an unknown tag": Case('"0103", "0104"', '"0103", "0204"', 14, "unknown barcode 0204"),
    "a number of another kind": Case("number: 21", "number: 31", 16, "31 is no number of a buffer here", "known: 21"),
    "a doubled number": Case(
        "number: 21}", "number: 21}\n  BUF2: {link: hall, number: 21}", 17, "BUF2 has the same number on hall as BUF1"
    ),
    "a buffer that there is not": Case("buffer: BUF1", "buffer: BUF2", 8, "unknown buffer BUF2", "mean BUF1?"),
    "two stations with one buffer": Case('"0105"}', '"0105", buffer: BUF1}', 9, "AB2 has the same buffer as AB1: BUF1"),
    "a buffer without a station": warning(", buffer: BUF1", "", 16, "no station has buffer BUF1"),
    "a name that the wire does not know": Case("alias: B1", "alias: B9", 8, "B9 is no name on the wire", "known: B1"),
    "a doubled alias": Case("alias: C1", "alias: B1", 18, "CHG1 has the same alias as AB1: B1"),
    "no time of day": Case("12:00-12:30", "12:00-25:00", 19, "'12:00-25:00' is no time of day", "12:00-12:30"),
    "a drive's id out of range": Case("id: 3", "id: 16", 21, "expected a whole number from 1 to 15, got 16"),
    "a drive on an ENIG link": Case("{link: axes", "{link: hall", 21, "hall speaks enig, this needs hi"),
    "an AGV without a link": Case(
        "kind: agv, link: hall, dev_id: 11", "kind: agv, dev_id: 11", 24, "AGV1 is an AGV and has no link"
    ),
    "an AGV with what a hoist has": Case("dev_id: 11,", "dev_id: 11, max_count: 9,", 24, "max_count is a hoist's"),
    "an AGV's number of another kind": Case("dev_id: 11", "dev_id: 21", 24, "21 is no number of an AGV here"),
    "a hoist on a link": Case(
        "{kind: agv, link: hall, dev_id: 12", "{link: hall, dev_id: 12", 25, "has a line of its own"
    ),
    "a hoist where a link is": Case(
        'start: "0106", max_speed: 900}',
        'start: "0106"}\n  V1: {dev_id: 1, address: "10.0.0.1:9000"}',
        26,
        "V1 has the same address as hall: 10.0.0.1:9000",
        "each needs its own",
    ),
    "a hoist on the floor": Case("{kind: agv, link: hall, dev_id: 12", "{dev_id: 12", 25, "AGV2 is a hoist and starts"),
    "a port on the floor": Case(
        "AB2: {kind: agv_buffer", "AB2: {kind: port", 9, "AB2 is a port at 0105, on the track of"
    ),
    "a tag that no AGV reads": Case('{kind: agv_buffer, at: "0105"}', '{kind: agv_buffer, at: "01055"}', 9, "unknown"),
    "a name given twice": Case("CHG1: {", "AGV1: {", 18, "AGV1 is a name under vehicles already"),
    "chargers that are never used": warning(
        'charging: {trips: 20, after: 3600, windows: ["12:00-12:30"]}', "charging: {}", 17, "are never sent to charge"
    ),
    "a soft zone on the floor": warning(
        "chargers:\n",
        'zones: {Z: {barcodes: ["0103"], soft: true}}\nchargers:\n',
        17,
        "Z is soft and lies on the track of AGVs",
    ),
    "rules without a charger": warning('chargers:\n  CHG1: {at: "0106", alias: C1}\n', "", 17, "there is no charger"),
    "a link that nobody uses": warning(
        "axes: {protocol: hi, serial", "spare: {protocol: hi, serial", 12, "nothing is on"
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_mistake_in_the_hall_is_named_with_line_and_remedy(case: Case) -> None:
    assert HALL.count(case.old) == 1
    assert_found(findings_of(HALL.replace(case.old, case.new)), case)


def test_tags_that_agvs_cannot_read_are_named() -> None:
    text = HALL.replace("0101..0106", "101..106").replace("0106..0101", "106..101").replace('"010', '"10')
    found = [finding.message for finding in findings_of(text)]
    assert "barcode 101 and 5 more are no tag that an AGV reads: four printable ASCII characters" in found
