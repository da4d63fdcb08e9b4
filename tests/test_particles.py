"""Which Korean particle follows a name: by how the name is read aloud; where that cannot be told both stand there."""

import pytest

from app.texts import said, text, told
from app.texts.particles import FORMS, settled, sound_of


@pytest.mark.parametrize(
    ("name", "sound"),
    [
        *(("캐리어", "vowel"), ("작업", "consonant"), ("차량", "consonant"), ("레일", "l")),
        *(("V001", "l"), ("V002", "vowel"), ("1203", "consonant"), ("4", "vowel"), ("HW-5", "vowel"), ("P6", "consonant")),
        *(("ETCH7", "l"), ("SBA-R8", "l"), ("9", "vowel"), ("100", "consonant")),
        *(("AGV", "vowel"), ("OHT-L", "l"), ("STK-M", "consonant"), ("PLN", "consonant"), ("CPR", "l")),
        *(("demo", "vowel"), ("plant.yaml", "l"), ("plan", "consonant"), ("parking", "consonant"), ("server", "vowel")),
        *(("port", None), ("node", None), ("DOOR", None), ("AUTO", "vowel"), ("FOUP", None), ("…", None), ("", None)),
        *(("V007(8초)", "l"), ("'V2'", "vowel"), ("P2 (문 앞)", "vowel"), ("20 mm", "vowel"), ("3 s", "vowel")),
    ],
)  # fmt: skip
def test_a_name_ends_as_it_is_read_aloud(name: str, sound: str | None) -> None:
    assert sound_of(name) == sound


@pytest.mark.parametrize(
    ("written", "settled_as"),
    [
        ("V1이(가) V2을(를) 기다림", "V1이 V2를 기다림"),
        ("P3은(는) 비어 있음", "P3은 비어 있음"),
        ("P1(으)로, P2(으)로, P3(으)로", "P1로, P2로, P3으로"),
        ("A1과(와) A2과(와) A3", "A1과 A2와 A3"),
        ("no.yaml 을(를) 읽을 수 없음", "no.yaml을 읽을 수 없음"),
        ("'port'이(가) 필요합니다", "'port'이(가) 필요합니다"),
        ("V9(이)라는 차량", "V9라는 차량"),
    ],
)
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
