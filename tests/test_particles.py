"""Which Korean particle follows a name: by how the name is read aloud; where that cannot be told both stand there."""

import json
from pathlib import Path

import pytest

from app.texts import said, text, told
from app.texts.particles import FORMS, settled, sound_of

CASES = json.loads((Path(__file__).parent / "particles.json").read_text(encoding="utf-8"))
"""The page's tests read them too (web/test/particles.test.ts): it chooses for itself."""


@pytest.mark.parametrize(("name", "sound"), CASES["sounds"])
def test_a_name_ends_as_it_is_read_aloud(name: str, sound: str | None) -> None:
    assert sound_of(name) == sound


@pytest.mark.parametrize(("written", "settled_as"), CASES["settled"])
def test_the_particle_that_fits_is_chosen_and_both_stand_where_it_cannot_be_told(written: str, settled_as: str) -> None:
    assert settled(written) == settled_as
    assert settled(settled_as) == settled_as


def test_each_particle_has_its_two_forms() -> None:
    for form, (open_, closed) in FORMS.items():
        assert settled(f"V2{form}") == f"V2{open_}"
        assert settled(f"V3{form}") == f"V3{closed}"


def test_page_api_and_command_line_choose_alike() -> None:
    assert told("P2 is occupied by F7", "ko") == "P2에 F7이 있음"
    assert told("P2 is occupied by F4", "ko") == "P2에 F4가 있음"
    assert said("hoistway controls demo: http://127.0.0.1:8080", "ko").startswith("hoistway가 demo를 제어합니다")
    assert text("sayings", "is_occupied_by", "ko", "P2", "F4") == "P2에 F4가 있음"
