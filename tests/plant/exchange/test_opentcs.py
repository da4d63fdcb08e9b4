"""Plant models of openTCS."""

import pytest

from app.plant import read
from app.plant.exchange.importing import Wishes
from app.plant.exchange.report import Kind, UnreadableLayout
from app.texts import said as said_in
from tests.plant.exchange.layouts import OPENTCS, imported, said, samples

SAMPLES = samples("opentcs")


def test_a_model_becomes_a_plant_that_passes_the_check() -> None:
    made = imported(OPENTCS)
    assert made.is_sound
    plant, findings = read(made.text, "hall")
    assert plant == made.plant
    assert [f.message for f in findings if f.is_error] == []
    assert {(e.start, e.end): (e.length, e.speed, e.curve) for e in plant.edges} == {
        ("0001", "0002"): (4000, 100, False),
        ("0002", "0003"): (3300, 50, True),
        ("0003", "0004"): (4000, 100, False),
        ("0004", "0001"): (3000, 100, False),
        ("0002", "0005"): (4000, 100, False),
        ("0005", "0002"): (4000, 100, False),
    }
    assert [(s.id, s.kind.value, s.barcode) for s in plant.stations] == [
        ("In", "agv_buffer", "0002"),
        ("Out", "agv_buffer", "0005"),
    ]
    assert [(c.id, c.barcode) for c in plant.chargers] == [("Plug", "0004")]
    assert [(z.id, sorted(z.barcodes), z.capacity) for z in plant.zones] == [("crossing", ["0002", "0003", "0005"], 1)]
    assert [p.barcode for p in plant.points if p.park] == ["0004"]


def test_vehicles_come_with_what_the_model_says_and_what_it_lacks_is_named() -> None:
    made = imported(OPENTCS)
    first, second = made.plant.vehicles
    assert (first.id, first.start, first.max_speed, first.length) == ("AGV-A", "0004", 1000, 1200)
    assert (second.id, second.dev_id) == ("AGV-B", 12)
    assert second.start not in (None, "0004")
    assert any(note.startswith("vehicle AGV A (line") and "AGV-A" in note for note in said(made, Kind.REPAIRED))
    needed = "\n".join(said(made, Kind.NEEDED))
    assert "hall: a link at this machine, for simulation" in needed
    assert "AGV-A, AGV-B: the AGV's number on its link is made up" in needed


def test_a_locked_path_is_left_out_unless_it_is_asked_for() -> None:
    made = imported(OPENTCS)
    assert any("path f (line" in note and "a closed path" in note for note in said(made, Kind.LEFT_OUT))
    kept = imported(OPENTCS, wishes=Wishes(keep_locked=True))
    assert ("0001", "0003") in {(e.start, e.end) for e in kept.plant.edges}


def test_points_of_one_place_and_of_the_drawing_are_repaired() -> None:
    text = OPENTCS.replace(
        '<point name="P-5" positionX="8000" positionY="0" positionZ="0" vehicleOrientationAngle="NaN" type="HALT_POSITION"/>',
        '<point name="P-5" positionX="0" positionY="0"><pointLayout positionX="8000" positionY="0"/></point>',
    )
    made = imported(text)
    assert [p.x for p in made.plant.points] == [0, 4000, 4000, 0, 8000]
    assert any("taken is that of the drawing" in note for note in said(made, Kind.REPAIRED))


def test_contradictions_are_said_with_their_lines() -> None:
    text = (
        '<model version="7.0.0">\n<point/>\n<point name="a" positionX="x" positionY="1"/>\n'
        '<point name="b" positionX="1" positionY="2"/>\n<point name="c" positionX="5000" positionY="2"/>\n'
        '<path name="p" sourcePoint="b" destinationPoint="zz"/>\n'
        '<path name="q" sourcePoint="b" destinationPoint="c" length="NaN"/>\n'
        '<location name="l" type="none"><link point="zz"/></location>\n<block name="k"><member name="nope"/></block>\n'
        "<foo/></model>"
    )
    made = imported(text)
    told = "\n".join(said(made, Kind.WRONG))
    for wrong in (
        "point (line 2): it has no name",
        "point a (line 3) ('x'): positionX: no number",
        "path p (line 6): leads to zz, which is nowhere given",
        "path q (line 7) ('NaN'): length: no number",
        "location l (line 8): its type none is nowhere given",
        "location l (line 8): its mark zz is nowhere given",
        "block k (line 9): its member nope is nowhere given",
    ):
        assert wrong in told


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (OPENTCS[:900], "is no XML: line"),
        ('<!DOCTYPE a [<!ENTITY x "y">]><model><point name="&x;"/></model>', "declares a document type or entities"),
        ('<!DOCTYPE a SYSTEM "http://192.0.2.1/a.dtd"><model/>', "declares a document type or entities"),
        ("<html></html>", "this XML is no layout that is known"),
        ("<model/>", "there is no mark with a position in it"),
        ("<model>" * 400 + "</model>" * 400, "is no XML"),
    ],
)
def test_what_is_no_model_is_refused_in_a_sentence(text: str, message: str) -> None:
    with pytest.raises(UnreadableLayout, match=message):
        imported(text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('<model version="6"><point></model>', "line 1, column 35: the end of another element is expected here"),
        ("<model version=6/>", "the value of an attribute is written in quotation marks"),
        ("<model version/>", "the attribute has no value"),
        ('<model a="1" a="2"/>', "the element has this attribute already"),
        ('<model a="&b;"/>', "this entity is none of XML's own"),
        ('<model a="1">', "an element that has begun is not ended"),
        ("<model/><model/>", "the outermost element has ended before this"),
        ("<model>\x07</model>", "this character is none that XML may have"),
        ("<a:model/>", "the prefix before the colon is declared nowhere"),
    ],
)
def test_xml_that_is_broken_says_where_and_what_is_wanted(text: str, expected: str) -> None:
    with pytest.raises(UnreadableLayout) as refused:
        imported(text)
    assert expected in refused.value.message
    assert "line 1, column" in refused.value.message
    assert expected not in said_in(refused.value.message, "ko")


def test_entities_are_refused_in_utf_16_too() -> None:
    text = '<?xml version="1.0" encoding="utf-16"?><!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/passwd">]><model/>'
    with pytest.raises(UnreadableLayout, match="declares a document type or entities"):
        imported(text.encode("utf-16"))


@pytest.mark.skipif(not SAMPLES.is_dir(), reason="the samples of openTCS are not there (../shared/data/opentcs)")
@pytest.mark.parametrize("version", ["6", "7"])
def test_the_samples_are_read_whole(version: str) -> None:
    made = imported((SAMPLES / f"PlantModelV{version}.sample.xml").read_bytes())
    assert made.report.read == {"points": 15, "paths": 7, "locations": 2, "vehicles": 1, "blocks": 2}
    assert said(made, Kind.WRONG) == []
    assert (len(made.plant.points), len(made.plant.edges), len(made.plant.stations)) == (15, 6, 1)
    # Each of its six paths begins and ends alone, and the checker says so.
    assert {finding.message.partition(":")[0] for finding in made.findings if finding.is_error} == {"dead end"}
