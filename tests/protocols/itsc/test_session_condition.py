"""The status words and barcodes in the domain's terms."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.domain.errors import EncodeError
from app.domain.layout import StationKind
from app.domain.units import Barcode
from app.domain.vehicle import Mode, Oper
from app.protocols.itsc import condition as module
from app.protocols.itsc.condition import barcode_text, barcode_value, condition

WORDS = st.integers(0, (1 << 32) - 1)


def test_the_sources_stopped_vehicle_is_read_as_the_source_says() -> None:
    read = condition(0x0B11BB34, 0)
    assert (read.mode, read.oper, read.code) == (Mode.MANT, Oper.IDLE, 0)
    assert not any((read.loaded, read.recognised, read.all_home, read.home_known, read.servos_on, read.travelling))
    assert not read.at_rest
    assert not read.homed
    meanings = {name: meaning for name, _, meaning in read.details}
    assert meanings["trav"] == meanings["lift"] == meanings["slid"] == "servo_not_ready"
    assert (meanings["shft"], meanings["rota"], meanings["grip"], meanings["sftb"]) == (
        "home",
        "home",
        "close",
        "raised",
    )


def test_the_sources_moving_vehicle_is_read_as_the_source_says() -> None:
    read = condition(0x08111134, 0xEF002100)
    assert (read.mode, read.oper, read.code) == (Mode.AUTO, Oper.RUN, 0x2100)
    assert all((read.recognised, read.all_home, read.home_known, read.servos_on, read.travelling, read.homed))
    assert not read.at_rest
    assert ("process_code", 0x2100, "0x2100") in read.details


def test_a_standing_homed_vehicle_is_at_rest() -> None:
    read = condition(0x81111134, 0xCF000000)
    assert read.at_rest
    assert read.homed
    assert read.loaded
    assert read.at_tag
    assert read.tags == {StationKind.PORT}


def test_an_axis_away_from_home_is_not_homed_whatever_the_h_bit_says() -> None:
    assert not condition(0x01110134, 0xCF000000).homed
    assert not condition(0x01111134, 0xCB000000).homed


@pytest.mark.parametrize("trav", range(16))
def test_trav_one_to_seven_is_a_set_of_stop_positions(trav: int) -> None:
    read = condition(trav << 24, 0)
    expected = {
        kind for bit, kind in ((1, StationKind.PORT), (2, StationKind.SBFL), (4, StationKind.SBFR)) if trav & bit
    }
    assert read.tags == (expected if trav < 8 else set())
    assert read.at_tag == (1 <= trav <= 7)


@pytest.mark.parametrize("shift", [0, 4, 8, 12, 16, 20, 24])
@pytest.mark.parametrize("value", [8, 9, 10, 11, 12, 13, 15])
def test_an_axis_that_drives_or_is_in_error_or_unknown_is_no_rest(shift: int, value: int) -> None:
    assert not condition(value << shift, 0).at_rest


@given(WORDS, WORDS)
def test_every_pair_of_words_has_every_field_by_name(word1: int, word2: int) -> None:
    read = condition(word1, word2)
    assert (read.status1, read.status2) == (word1, word2)
    assert len({name for name, _, _ in read.details}) == len(read.details) == 17
    assert all(meaning for _, _, meaning in read.details)


def test_the_same_words_give_the_same_object() -> None:
    assert condition(5, 7) is condition(5, 7)


def test_the_memory_of_conditions_and_barcodes_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "CONDITIONS_KEPT", 10)
    monkeypatch.setattr(module, "BARCODES_KEPT", 10)
    for i in range(50):
        condition(0x12340000 + i, 3)
        barcode_text(10**12 + i)
    assert len(module.KNOWN_CONDITIONS) <= 10
    assert len(module.KNOWN_BARCODES) <= 10


@given(st.integers(0, (1 << 48) - 1))
def test_a_numeric_barcode_survives_the_way_to_text_and_back(number: int) -> None:
    assert barcode_value(barcode_text(number), "uint") == number


def test_a_barcode_in_characters_stays_as_it_is() -> None:
    assert barcode_text("A-17") == "A-17"
    assert barcode_value(Barcode("A-17"), "ascii") == "A-17"


@pytest.mark.parametrize("text", ["", "A17", "-5", "1.5", "007", "00", "١٢", " 12"])
def test_a_text_that_no_vehicle_would_report_as_a_number_is_refused(text: str) -> None:
    with pytest.raises(EncodeError) as refused:
        barcode_value(Barcode(text), "uint")
    assert refused.value.remedy
