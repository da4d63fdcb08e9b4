"""Each mistake in a plant file is named with its line, a message and a remedy."""

from dataclasses import dataclass

import pytest

from app.plant import Finding, Severity, UnusablePlant, document, read
from app.plant.document import NO_YAML

GOOD = """\
name: good
barcodes: {1: [0, 0], 2: [1000, 0], 3: [2000, 0], 4: [2000, 1000], 5: [1000, 1000], 6: [0, 1000]}
track:
  - {through: [1..6, 1]}
parking: [1, 4]
stations:
  P1: {kind: port, at: 2, dest: {shft: 100, rota: 0, lift: 40000}}
  P2: {kind: port, at: 3}
  B1: {kind: sbfl, at: 5}
zones:
  Z1: {barcodes: [6, 1], capacity: 1}
vehicles:
  V1: {dev_id: 1, address: "10.0.0.1:9000", start: 1}
  V2: {dev_id: 2, address: "10.0.0.2:9000", start: 4}
carriers: {FOUP1: P1}
process_codes: {0x2100: moving}
event_numbers: {TransferCompleted: 107}
"""


def findings_of(text: str) -> list[Finding]:
    """Return the findings; every error must make the plant unusable, and nothing else may."""
    usable = True
    try:
        _, findings = read(text, "plant")
    except UnusablePlant as unusable:
        usable, findings = False, unusable.findings
    assert usable is not any(finding.is_error for finding in findings)
    return findings


@dataclass(frozen=True)
class Case:
    """A change to the good file, and what it must give."""

    old: str
    new: str
    line: int
    message: str
    remedy: str = ""
    severity: Severity = Severity.ERROR


def warning(old: str, new: str, line: int, message: str, remedy: str = "") -> Case:
    return Case(old, new, line, message, remedy, Severity.WARNING)


def test_the_good_file_has_no_finding() -> None:
    assert findings_of(GOOD) == []


YAML = {
    "text that is no YAML": Case(
        "{1: [0, 0], 2",
        "{1: [0, 0, 2",
        2,
        "this is no YAML: a comma is missing here, or a bracket is not closed",
        NO_YAML,
    ),
    "a control character": Case(
        "name: good", "name: \x07", 1, "this is no YAML: this character is none that a text may have"
    ),
    "an alias": Case(
        "start: 4", "start: &a 4, reach: *a", 14, "an alias (*a) cannot be used here", "write the value again"
    ),
    "a tag": Case("name: good", "name: !!str good", 1, "a tag (tag:yaml.org,2002:str) cannot be used here"),
    "a text without end": Case(
        "name: good", "name: " + "x" * 201, 1, "a text is longer than 200 characters", "shorten it"
    ),
    "a text that steers the terminal": Case(
        "name: good", 'name: "\\e[31mred"', 1, "has a character that cannot be shown", "leave it out"
    ),
    "a text that runs backwards": Case("name: good", "name: a\u202eb", 1, "has a character that cannot be shown"),
    "a key that cannot be shown": Case("  P2:", '  "P\\u200b2":', 8, "has a character that cannot be shown"),
    "a list as a key": Case("name: good", "? [1]\n: good", 1, "a key must be text or a number"),
    "a second document": Case("name: good", "--- {}\n--- {}", 2, "a second document starts here"),
    "deep nesting": Case("name: good", "name: " + "[" * 30 + "]" * 30, 1, "this is nested more than 20 levels deep"),
    "a doubled key": Case("  P2:", "  P1:", 8, "stations.P1 is given twice: the first time on line 7", "keep one"),
}

SHAPE = {
    "an unknown section": Case("parking:", "parkings:", 5, "unknown key 'parkings'", "did you mean parking?"),
    "an unknown key": Case(
        "at: 3", "at: 3, lookdown: 3", 8, "unknown key 'lookdown' in stations.P2", "did you mean look_down?"
    ),
    "a key like no other": Case(
        "at: 3", "at: 3, zzz: 3", 8, "unknown key 'zzz' in stations.P2", "known here: kind, at,"
    ),
    "a missing key": Case(
        "dev_id: 2, ", "", 14, "vehicles.V2 has no dev_id", "add dev_id: a whole number from 0 to 4294967295"
    ),
    "a missing section": Case(
        "track:\n  - {through: [1..6, 1]}\n", "", 1, "the plant file has no track", "add track: a list"
    ),
    "speed 0": Case("1..6, 1]", "1..6, 1], speed: 0", 4, "expected a whole number of percent from 1 to 100, got 0"),
    "speed 101": Case("1..6, 1]", "1..6, 1], speed: 101", 4, "track[0].speed: expected a whole number of percent"),
    "a speed with its unit": Case(
        "1..6, 1]", "1..6, 1], speed: 80 %", 4, "got text '80 %'", "write the number alone: a whole number of percent"
    ),
    "sensor 16": Case("1..6, 1]", "1..6, 1], sensor: 16", 4, "expected a whole number from 0 to 15, got 16"),
    "look_down 16": Case(
        "at: 3", "at: 3, look_down: 16", 8, "stations.P2.look_down: expected a whole number from 0 to 15"
    ),
    "a fraction of a millimetre": Case(
        "[1000, 0]", "[1000.5, 0]", 2, "barcodes.2[0]: expected a whole number of mm", "alone"
    ),
    "three coordinates": Case("[1000, 0]", "[1000, 0, 0]", 2, "or a mapping, got a list of 3"),
    "an unknown kind of station": Case(
        "kind: sbfl", "kind: sbfll", 9, "expected port or sbfl or sbfr or agv_buffer, got text", "mean sbfl?"
    ),
    "a kind like no other": Case("kind: sbfl", "kind: 7", 9, "expected port or sbfl or sbfr or agv_buffer, got 7"),
    "text where true or false is asked": Case(
        "capacity: 1", "no_stop: no", 11, "expected true or false, got text 'no'"
    ),
    "a number where text is asked": Case(
        "name: good", "name: 12", 1, "name: expected text, got 12", "write it in quotes"
    ),
    "nothing where a mapping is asked": Case(
        "carriers: {FOUP1: P1}", "carriers:", 15, "expected a mapping, got nothing"
    ),
    "a mapping where a list is asked": Case("parking: [1, 4]", "parking: {a: 1}", 5, "expected a list, got a mapping"),
    "an empty list": Case("[6, 1]", "[]", 11, "zones.Z1.barcodes is empty", "give at least 1"),
    "an empty list where two numbers are asked": Case("2: [1000, 0]", "2: []", 2, "got a list"),
    "a list of wrong things": Case(
        "parking: [1, 4]", "parking: [1, true]", 5, "parking[1]: expected a whole number or text"
    ),
    "a run that is no mapping": Case(
        "1..6, 1]}", "1..6, 1]}\n  - [1, 2]", 5, "track[1]: expected a mapping, got a list of 2"
    ),
    "pulses beyond 32 bits": Case(
        "lift: 40000", "lift: 2147483648", 7, "stations.P1.dest.lift: expected a whole number of pulses"
    ),
    "max_count 1": Case(
        "start: 4", "start: 4, max_count: 1", 14, "expected a whole number of path elements from 2 to 65535"
    ),
}

BARCODES = {
    "a doubled barcode": Case("6: [0, 1000]", "5..6: {from: [0, 500], to: [0, 1000]}", 2, "barcode 5 is given twice"),
    "a bad range": Case("6: [0, 1000]", "6..x: [0, 1000]", 2, "'6..x' is no range of barcodes", ""),
    "ends of different lengths": Case(
        "6: [0, 1000]", "06..8: [0, 1000]", 2, "the ends of 06..8 have different numbers of digits"
    ),
    "an endless range": Case("6: [0, 1000]", "6..999999: [0, 1]", 2, "6..999999 has more than 100000 barcodes"),
    "a range with one position": Case("6: [0, 1000]", "6..7: [0, 1000]", 2, "6..7 is a range, so it needs two ends"),
    "a barcode with two positions": Case(
        "6: [0, 1000]", "6: {from: [0, 0], to: [1, 1]}", 2, "6 is one barcode, so it has one"
    ),
    "a barcode that is not ASCII": Case(
        "6: [0, 1000]", "6ß: [0, 1000]", 2, "barcode '6ß' is not 1 to 16 visible ASCII"
    ),
    "a barcode too large for the wire": Case(
        "6: [0, 1000]",
        "6: [0, 1000], 281474976710656: [0, 2000]",
        2,
        "barcode 281474976710656 does not fit dialect default of V1",
    ),
    "barcodes with leading zeros": Case(
        "6: [0, 1000]", "6: [0, 1000], 07: [0, 1], 08: [0, 2]", 2, "barcode 07 and 1 more do not"
    ),
    "a barcode that no track touches": warning(
        "6: [0, 1000]", "6: [0, 1000], 7: [0, 2000]", 2, "no track touches barcode 7"
    ),
}

TRACK = {
    "an unknown barcode": Case("1..6, 1]", "1..6, 11]", 4, "unknown barcode 11", "did you mean 1?"),
    "a barcode like no other": Case("1..6, 1]", "1..6, ABC, 1]", 4, "unknown barcode ABC", "give it under barcodes"),
    "a bad range of track": Case("1..6, 1]", "1..6.., 1]", 4, "'1..6..' is no range of barcodes"),
    "a run of one barcode": Case(
        "1..6, 1]}", "1..6, 1]}\n  - {through: [3]}", 5, "track through 3 alone leads nowhere"
    ),
    "track from a barcode to itself": Case("1..6, 1]", "1..6, 6, 1]", 4, "track leads from 6 to itself"),
    "doubled track": Case(
        "1..6, 1]}", "1..6, 1]}\n  - {through: [2, 3]}", 5, "track 2 → 3 is given twice: the first time on line 4"
    ),
    "track of length 0": Case(
        "2: [1000, 0]", "2: [0, 0]", 4, "track 1 → 2 has length 0: both lie at [0, 0]", "move one"
    ),
    "straight track longer than it can be": warning(
        "[1..6, 1]}", "[1, 2], length: 1200}\n  - {through: [2..6, 1]}", 4, "track 1 → 2 is 1200 mm long", "curve: true"
    ),
    "track shorter than the distance": warning(
        "[1..6, 1]}", "[1, 2], length: 800, curve: true}\n  - {through: [2..6, 1]}", 4, "but its ends are 1000 mm apart"
    ),
}

STATIONS = {
    "a station on an unknown barcode": Case("at: 3", "at: 33", 8, "unknown barcode 33", "did you mean 3?"),
    "a name that cannot stand in an address": Case(
        "  P2:", "  P/2:", 8, "'P/2' cannot be a name here", "use letters, digits"
    ),
    "a name that is not ASCII": Case("  P2:", "  포트2:", 8, "'포트2' cannot be a name here"),
    "a name too long for the display": Case(
        "  P2:", "  STOCKER01-PORT-02:", 8, "does not fit the vehicle's display", "display:"
    ),
    "a display name that is not ASCII": Case(
        "at: 3", "at: 3, display: 포트2", 8, "'포트2' does not fit the vehicle's display"
    ),
    "target pulses at a side buffer": warning(
        "at: 5", "at: 5, dest: {shft: 1, rota: 1, lift: 1}", 9, "B1 is no port", "leave it out"
    ),
    "an unknown fallback": Case("at: 3", "at: 3, fallbacks: [B2]", 8, "unknown station B2", "did you mean"),
    "a fallback to itself": Case("at: 3", "at: 3, fallbacks: [P2]", 8, "P2 cannot be its own fallback"),
    "a target beyond a vehicle's limits": warning(
        "start: 1}",
        "start: 1, limits: {shft: [0, 150], rota: [0, 9], lift: [0, 50000]}, offset: {shft: 60, rota: 0, lift: 0}}",
        7,
        "P1's shft target is beyond the limits of V1 (160, limits 0 to 150)",
        "correct dest",
    ),
    "a target beyond every vehicle's limits": warning(
        "vehicles:\n",
        "vehicle_defaults: {limits: {shft: [0, 999], rota: [0, 9], lift: [0, 1]}}\nvehicles:\n",
        7,
        "P1's lift target is beyond the limits of V1 (40000, limits 0 to 1) and 1 more",
    ),
}

ZONES = {
    "an unknown barcode in a zone": Case("[6, 1]", "[6, 77]", 11, "unknown barcode 77"),
    "a parking place where nobody may stop": warning(
        "capacity: 1", "no_stop: true", 5, "1 is a parking place in zone Z1"
    ),
    "a start where nobody may stop": warning(
        "capacity: 1", "no_stop: true", 13, "V1 starts in zone Z1, where no vehicle may stop"
    ),
    "a soft zone where nobody may stop": Case(
        "capacity: 1", "soft: true, no_stop: true", 11, "zone Z1 is soft and no_stop", "leave out one of them"
    ),
    "a share of a zone that is not soft": warning(
        "capacity: 1", "share: 0.2", 11, "Z1 has a share or a patience", "add soft"
    ),
    "nowhere to park": warning("parking: [1, 4]", "idle: {park: true}", 5, "idle hoists have no place to park"),
    "a share that is none": Case(
        "capacity: 1", "soft: true, share: 1.5", 11, "zones.Z1.share: expected a number from 0.01 to 1.0, got 1.5"
    ),
    "more starts than the zone holds": Case("[6, 1]", "[4..6, 1]", 11, "2 vehicles start in zone Z1, which holds 1"),
}

VEHICLES = {
    "a doubled DEV_ID": Case("dev_id: 2", "dev_id: 1", 14, "V2 has the same dev_id as V1: 1", "each needs its own"),
    "DEV_ID 0": warning("dev_id: 2", "dev_id: 0", 14, "V2's dev_id is 0", "number vehicles from 1"),
    "a doubled address": Case("10.0.0.2", "10.0.0.1", 14, "V2 has the same address as V1: 10.0.0.1:9000"),
    "no address": Case('address: "10.0.0.2:9000", ', "", 14, "V2 has no address to connect to", "or listen: true"),
    "a bad address": Case("10.0.0.2:9000", "10.0.0.2/9000", 14, "'10.0.0.2/9000' is no address: write HOST:PORT"),
    "a bad port": Case("10.0.0.2:9000", "10.0.0.2:90000", 14, "port 90000 is outside 1..65535"),
    "a port of a vehicle that connects to us": Case(
        "start: 4", "start: 4, listen: true", 14, "so its address has no port"
    ),
    "nobody listens": Case(
        '"10.0.0.2:9000"',
        '"10.0.0.2", listen: true',
        14,
        "V2 connects to us, but the plant does not listen",
        "listen: HOST:PORT",
    ),
    "a listener without port": Case("name: good", "listen: 0.0.0.0", 1, "0.0.0.0 has no port", "write HOST:PORT"),
    "a listener without address": Case("name: good", "listen: '?'", 1, "'?' is no address"),
    "an unknown start": Case("start: 4", "start: 44", 14, "unknown barcode 44"),
    "a doubled start": Case("start: 4", "start: 1", 14, "V2 has the same start as V1: 1"),
    "a start that another vehicle covers": Case(
        "start: 4", "start: 6", 14, "V2 starts at 6, which V1 at 1 covers (1000 mm long)"
    ),
    "a start too near on other track": warning(
        "name: good", "name: good\nclearance: 2300", 15, "V2 starts 2236 mm from V1; the plant's clearance is 2300 mm"
    ),
    "limits upside down": Case(
        "start: 4",
        "start: 4, limits: {shft: [5, -5], rota: [0, 0], lift: [0, 1]}",
        14,
        "V2's shft limits are upside down: 5 > -5",
    ),
    "a curve speed above the maximum": warning(
        "start: 4", "start: 4, curve_speed: 5000", 14, "V2's curve_speed 5000 is more than"
    ),
    "more path elements than a packet holds": Case(
        "start: 4", "start: 4, max_count: 513", 14, "is more than its dialect's packets hold: 512"
    ),
    "no vehicle": warning(
        GOOD[GOOD.index("vehicles:") : GOOD.index("carriers:")],
        "",
        1,
        "the plant has no vehicle",
    ),
    "too few places to park": warning("[1, 4]", "[4]", 5, "there are 1 parking places for 2 vehicles in service"),
    "a parking place that does not exist": Case("[1, 4]", "[1, 4, 9]", 5, "unknown barcode 9"),
}

DIALECTS = {
    "an unknown dialect": Case(
        "start: 4", "start: 4, dialect: slide", 14, "unknown dialect 'slide'", "did you mean slides?"
    ),
    "an unknown preset": Case(
        "name: good", "dialects: {x: {preset: slide}}", 1, "unknown preset 'slide'", "did you mean slides?"
    ),
    "a preset like no other": Case(
        "name: good", "dialects: {x: {preset: 7}}", 1, "unknown preset 7", "presets: default, slides"
    ),
    "a preset's name": Case(
        "name: good", "dialects: {slides: {pad: 0}}", 1, "slides is the name of a preset", "another name"
    ),
    "an unknown field": Case("name: good", "dialects: {x: {byteorder: big}}", 1, "unknown dialect field 'byteorder'"),
    "an impossible value": Case(
        "name: good", "dialects: {x: {barcode_bytes: 5}}", 1, "barcode_bytes 5 is none of 4, 6"
    ),
    "two codes that clash": Case("name: good", "dialects: {x: {req_code: 0x2070}}", 1, "dialect x: "),
    "a dialect that is no mapping": Case("name: good", "dialects: {x: 1}", 1, "dialects.x: expected a mapping, got 1"),
}

CARRIERS = {
    "an unknown event": Case(
        "TransferCompleted: 107",
        "TransferComplete: 107",
        17,
        "unknown event TransferComplete",
        "mean TransferCompleted?",
    ),
    "a carrier on an unknown station": Case("FOUP1: P1", "FOUP1: P3", 15, "unknown station P3", "did you mean P"),
    "two carriers at one station": Case(
        "FOUP1: P1", "FOUP1: P1, FOUP2: P1", 15, "P1 holds FOUP1 already: one carrier a station"
    ),
    "a carrier with a long name": Case("FOUP1: P1", "FOUP-123456789012: P1", 15, "does not fit the vehicle's display"),
    "a code that is no number": Case("0x2100", "2100h", 16, "'2100h' is no code from 0 to 65535"),
    "a code too large": Case("0x2100", "0x12100", 16, "'0x12100' is no code from 0 to 65535"),
    "a doubled code": Case("{0x2100: moving}", "{0x2100: moving, 8448: driving}", 16, "code 8448 is given twice"),
}

ALL = {**YAML, **SHAPE, **BARCODES, **TRACK, **STATIONS, **ZONES, **VEHICLES, **DIALECTS, **CARRIERS}


def assert_found(findings: list[Finding], case: Case) -> None:
    hits = [finding for finding in findings if case.message in finding.message]
    assert hits, [str(finding) for finding in findings]
    assert (hits[0].line, hits[0].severity) == (case.line, case.severity)
    assert case.remedy in hits[0].remedy


@pytest.mark.parametrize("case", ALL.values(), ids=ALL)
def test_a_mistake_is_named_with_line_and_remedy(case: Case) -> None:
    assert GOOD.count(case.old) == 1
    assert_found(findings_of(GOOD.replace(case.old, case.new)), case)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the file is empty"),
        ("# no more\n", "the file is empty"),
        ("7", "the plant file: expected a mapping, got 7"),
    ],
)
def test_a_file_without_a_mapping_is_refused(text: str, message: str) -> None:
    assert [finding.message[: len(message)] for finding in findings_of(text)] == [message]


def test_all_mistakes_are_reported_at_once_and_in_the_order_of_the_file() -> None:
    text = GOOD.replace("at: 3", "at: x, speed: 0").replace("kind: sbfl", "kind: left").replace("at: 5", "att: 5")
    text = text.replace("FOUP1: P1", "FOUP1: P2").replace("dev_id: 2", "dev_id: two")
    found = [(finding.line, finding.path) for finding in findings_of(text)]
    assert found == [
        (8, "stations.P2.speed"),
        (9, "stations.B1"),
        (9, "stations.B1.kind"),
        (9, "stations.B1.att"),
        (14, "vehicles.V2.dev_id"),
    ]


def test_what_could_not_be_read_is_not_reported_again_as_unknown() -> None:
    text = GOOD.replace("3: [2000, 0]", "3: here").replace("kind: port, at: 2", "kind: prot, at: 2")
    assert [finding.path for finding in findings_of(text)] == ["barcodes.3", "stations.P1.kind"]
    text = GOOD.replace("6: [0, 1000]}", "6..9: here}")
    assert [finding.path for finding in findings_of(text)] == ["barcodes.6..9"]
    text = GOOD.replace("start: 4", "start: 4, dialect: x") + "dialects: {x: {pad: 7}}\n"
    assert [finding.path for finding in findings_of(text)] == ["dialects.x.pad"]


def test_a_run_that_cannot_be_read_does_not_shift_the_lines_of_the_next() -> None:
    text = GOOD.replace("  - {through: [1..6, 1]}", "  - {through: [1..6, 1], speed: fast}\n  - {through: [3, 99]}")
    assert [(finding.line, finding.message) for finding in findings_of(text)][1] == (5, "unknown barcode 99")


def test_an_overlay_may_move_a_code_out_of_the_way_of_another() -> None:
    assert findings_of(GOOD + "dialects: {x: {req_code: 0x2070, teach_shft_dest: 0x2090}}\n") == []


def test_a_barcode_longer_than_the_wire_has_room_is_refused_in_the_ascii_dialect() -> None:
    text = GOOD.replace("6: [0, 1000]", "6: [0, 1000], LOOP007: [0, 2000]").replace(
        "start: 4", "start: 4, dialect: ascii-barcode"
    )
    hits = [finding for finding in findings_of(text) if finding.is_error]
    assert "barcode LOOP007 does not fit dialect default of V1" in hits[0].message
    assert hits[1].message == "barcode LOOP007 does not fit dialect ascii-barcode of V2: it takes at most 6 characters"
    assert all(finding.line == 2 for finding in hits)


def test_track_longer_than_the_slides_dialect_can_tell_is_a_warning() -> None:
    text = GOOD.replace("3: [2000, 0], 4: [2000, 1000]", "3: [90000, 0], 4: [90000, 1000]").replace(
        "start: 4", "start: 4, dialect: slides"
    )
    first = findings_of(text)[0]
    assert (first.line, first.severity) == (4, Severity.WARNING)
    assert first.message == "track 2 → 3 is 89000 mm long; V2 can be told 65535"


class TestConnections:
    """Mistakes of the track as a whole."""

    def with_track(self, *runs: str, barcodes: str = "") -> list[Finding]:
        track = "".join(f"  - {{through: {run}}}\n" for run in runs)
        text = GOOD.replace("  - {through: [1..6, 1]}\n", track)
        return findings_of(text.replace("6: [0, 1000]}", f"6: [0, 1000]{barcodes}}}"))

    def test_a_barcode_without_way_out_is_a_dead_end(self) -> None:
        found = self.with_track("[1..6, 1]", "[3, 7]", barcodes=", 7: [3000, 0]")
        assert [(finding.line, finding.message) for finding in found] == [
            (2, "dead end: track leads to 7, but none leads on")
        ]
        assert found[0].is_error

    def test_a_barcode_without_way_in_is_a_warning(self) -> None:
        found = self.with_track("[1..6, 1]", "[7, 3]", barcodes=", 7: [3000, 0]")
        assert [finding.message for finding in found] == [
            "no track leads to 7: a vehicle can leave it, but never return"
        ]
        assert not found[0].is_error

    def test_a_loop_without_way_out_is_an_error(self) -> None:
        found = self.with_track("[1..6, 1]", "[3, 7, 8, 7]", barcodes=", 7: [3000, 0], 8: [4000, 0]")
        assert [finding.message for finding in found] == [
            "track leads into the loop of 7 and 1 more barcodes, but none leads out"
        ]

    def test_stations_that_cannot_be_reached_or_left_are_errors(self) -> None:
        found = self.with_track("[1..6]", "[4, 1]")
        messages = [finding.message for finding in found]
        assert "B1 at 5 has no way to P1" in messages
        assert not any("cannot be reached" in message for message in messages)
        found = self.with_track("[2..6, 2]", "[1, 2]")
        assert [finding.message for finding in found] == [
            "no track leads to 1: a vehicle can leave it, but never return"
        ]
        found = self.with_track("[3..6, 3]", "[1, 2, 3]")
        assert "P1 at 2 cannot be reached from P2" in [finding.message for finding in found]

    def test_a_start_from_where_no_station_can_be_reached_is_an_error(self) -> None:
        found = self.with_track("[1, 2, 3, 5, 6, 1]", "[3, 4, 7, 4]", barcodes=", 7: [3000, 1000]")
        assert (15, "V2 starts at 4, from where no way leads to station P1") in [(f.line, f.message) for f in found]

    def test_pieces_that_are_not_connected_are_warnings(self) -> None:
        found = self.with_track("[1, 2, 6, 1]", "[3, 4, 5, 3]")
        assert [finding.message for finding in found] == [
            "the track falls into 2 pieces with stations; 3 is not connected to 1",
            "P1 is the only station on its piece of track: no transfer can begin or end there",
        ]
        assert not any(finding.is_error for finding in found)

    def test_a_start_on_a_piece_without_stations_is_a_warning(self) -> None:
        found = self.with_track("[1, 2, 3, 5, 6, 1]", "[4, 7, 4]", barcodes=", 7: [3000, 1000]")
        assert [finding.message for finding in found] == ["V2 starts at 4, on a piece of track without stations"]

    def test_a_plant_without_stations_is_a_warning(self) -> None:
        start, end = GOOD.index("stations:"), GOOD.index("zones:")
        text = (GOOD[:start] + GOOD[end:]).replace("carriers: {FOUP1: P1}\n", "")
        assert [finding.message for finding in findings_of(text)] == ["the plant has no station"]


def test_a_file_of_far_too_many_values_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(document, "MAX_VALUES", 20)
    (finding,) = findings_of(GOOD)
    assert finding.message == "the file has more than 20 values"
    assert finding.remedy == "write barcodes as ranges"
