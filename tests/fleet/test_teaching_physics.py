"""Physical truth: what is taught by one vehicle is right for every other one, and for no other port (I40, DOMAIN section 3)."""

from dataclasses import replace

import pytest

from app.domain.errors import Refusal
from app.domain.events import TeachingKind
from app.domain.layout import Axis
from app.domain.pulses import PartialPulses
from app.domain.requests import WriteDest, WriteOffset
from app.domain.teaching import Side
from tests.fleet.script import P1, P2, V1, Script, small, transfer
from tests.fleet.teaching import KIM, V3, V7, Teacher, approve, dest, last, offset, plant_of_two, pulses, sent_to


@pytest.fixture
def two() -> Script:
    """V3 at offset +40 and V7 at -20; no port is taught."""
    return Script(plant_of_two())


def test_a_port_taught_by_v3_sends_v3_its_raw_value_and_v7_that_less_sixty(two: Script) -> None:
    proposal = Teacher(two, V3).teach(1000, 200, 41000)
    assert isinstance(sent_to(two, V3), Refusal)
    two.accept(approve(proposal))
    assert sent_to(two, V3) == pulses(1000, 200, 41000)
    assert sent_to(two, V7) == pulses(940, 140, 40940)
    assert dest(two).pulses == pulses(960, 160, 40960)


def test_a_version_says_what_it_was_derived_from(two: Script) -> None:
    two.accept(approve(Teacher(two, V3).teach(1000, 200, 41000)))
    lift = next(basis for basis in dest(two).basis if basis.axis is Axis.LIFT)
    assert (lift.raw, lift.vehicle, lift.barcode, lift.against, lift.version, lift.less) == (
        41000,
        V3,
        "104",
        V3,
        1,
        40,
    )
    assert lift.events == (3,)
    assert (dest(two).proposal, dest(two).source, dest(two).actor, dest(two).reason) == (
        1,
        "teaching",
        KIM,
        "as measured",
    )


def test_re_teaching_the_reference_station_changes_no_other_pulses_and_no_offset(two: Script) -> None:
    two.accept(approve(Teacher(two, V3).teach(1000, 200, 41000)))
    new = Teacher(two, V7, "104").teach(950, 150, 40950, Side.OFFSET)
    two.accept(approve(new))
    assert offset(two, V7).pulses == pulses(-10, -10, -10)
    two.accept(approve(Teacher(two, V7, "106").teach(500, 100, 40000)))
    before = sent_to(two, V3, P2), sent_to(two, V7, P2)
    two.accept(approve(Teacher(two, V3, "104").teach(1100, 300, 41500)))
    assert (sent_to(two, V3, P2), sent_to(two, V7, P2)) == before
    assert offset(two, V7).pulses == pulses(-10, -10, -10)
    assert offset(two, V7).basis[0].version == 1
    assert sent_to(two, V3) == pulses(1100, 300, 41500)


def test_lift_alone_is_taught_again_and_the_other_axes_are_carried_over_with_their_origin(two: Script) -> None:
    two.accept(approve(Teacher(two, V3).teach(1000, 200, 41000)))
    first = dest(two)
    again = Teacher(two, V7, "104")
    again.send(TeachingKind.LIFT_DEST, 40900)
    two.wait(11)
    two.accept(approve(last(two)))
    second = dest(two)
    assert (second.version, second.pulses) == (2, pulses(960, 160, 40920))
    assert second.basis[:2] == first.basis[:2]
    assert (second.basis[2].vehicle, second.basis[2].less) == (V7, -20)
    assert sent_to(two, V3) == pulses(1000, 200, 40960)


def test_what_a_reference_vehicle_sends_is_the_dest_itself() -> None:
    script = Script(plant_of_two(reference=True))
    script.accept(approve(Teacher(script, V1).teach(1000, 200, 41000)))
    assert dest(script).pulses == pulses(1000, 200, 41000)
    assert dest(script).basis[0].version is None
    assert sent_to(script, V1) == pulses(1000, 200, 41000)
    assert sent_to(script, V7) == pulses(980, 180, 40980)


def test_the_offset_of_a_reference_vehicle_cannot_be_written_or_taught() -> None:
    script = Script(plant_of_two(reference=True))
    assert "reference" in script.refuse(WriteOffset(KIM, V1, pulses(1, 2, 3))).reason
    script.accept(WriteDest(KIM, P1, pulses(1, 2, 3)))
    proposal = Teacher(script, V1).teach(5, 6, 7, Side.OFFSET)
    assert proposal.state == "unusable"
    assert "reference" in script.refuse(approve(proposal)).reason


def test_a_port_of_which_only_lift_was_ever_taught_refuses_and_names_the_others(two: Script) -> None:
    Teacher(two, V3).send(TeachingKind.LIFT_DEST, 41000)
    two.wait(11)
    proposal = last(two)
    assert any("SHFT, ROTA are still not known" in warning for warning in proposal.warnings)
    two.accept(approve(proposal))
    assert dest(two).pulses == PartialPulses(lift=pulses(0, 0, 40960).lift)
    refusal = sent_to(two, V3)
    assert isinstance(refusal, Refusal)
    assert refusal.reason == "P1 has no DEST (SHFT, ROTA)"
    assert "/teaching/sessions" in refusal.remedy


def test_a_value_written_by_a_person_has_no_origin_and_the_taught_axes_beside_it_keep_theirs(two: Script) -> None:
    two.accept(WriteDest(KIM, P1, pulses(1, 2, 3)))
    Teacher(two, V3).send(TeachingKind.LIFT_DEST, 41000)
    two.wait(11)
    two.accept(approve(last(two)))
    assert dest(two).pulses == pulses(1, 2, 40960)
    assert [basis.axis for basis in dest(two).basis] == [Axis.LIFT]


def test_a_job_is_refused_with_the_missing_axis_named_and_accepted_once_it_is_taught(two: Script) -> None:
    for station in (P1, P2):
        two.accept(WriteDest(KIM, station, pulses(1, 2, 41000)))
    Teacher(two, V3, "114").send(TeachingKind.SHFT_DEST, 900)
    two.wait(11)
    two.accept(approve(last(two)))
    assert two.refuse(transfer("P1", "P3")).reason == "P3 has no DEST (ROTA, LIFT)"
    assert two.refuse(transfer("P1", "P3")).field == "destination"
    two.accept(transfer("P1", "P2"))


def test_a_job_for_a_vehicle_without_offset_is_refused_with_the_missing_axes_named() -> None:
    plant = small()
    script = Script(replace(plant, vehicles=tuple(replace(v, offset=None) for v in plant.vehicles)))
    refusal = script.refuse(transfer("P1", "P3", vehicle=V1))
    assert (refusal.reason, refusal.field) == ("V001 has no OFFSET (SHFT, ROTA, LIFT)", "vehicle")
    script.accept(transfer("B1", "B2", vehicle=V1))
    script.obey()
    script.accept(transfer("P1", "P3", job="J2"))
    script.run(3)
    assert "no vehicle can serve both stations" in script.job("J2").reason
