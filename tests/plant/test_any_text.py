"""Whatever the text, reading it ends in a plant or in findings."""

from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from app.plant import UnusablePlant, read

GOOD = (Path(__file__).parents[2] / "plants" / "small.yaml").read_text(encoding="utf-8")


def ends_well(text: str) -> None:
    usable = True
    try:
        _, findings = read(text, "plant")
    except UnusablePlant as unusable:
        usable, findings = False, unusable.findings
    assert usable is not any(finding.is_error for finding in findings)
    lines = text.count("\n") + 2
    assert all(1 <= finding.line <= lines and finding.column >= 1 and finding.message for finding in findings)


@given(st.text(st.characters(codec="utf-8")))
def test_any_text_ends_in_a_plant_or_in_findings(text: str) -> None:
    ends_well(text)


@given(st.integers(0, len(GOOD)), st.integers(0, 12), st.text("[]{}:,. #\n\t'\"&*!|>-0x19aé", max_size=6))
def test_a_good_file_with_a_scratch_ends_in_a_plant_or_in_findings(at: int, cut: int, put: str) -> None:
    ends_well(GOOD[:at] + put + GOOD[at + cut :])
