from typing import Any

import pytest

from app.protocols.enig.dialects import DEFAULT, DIALECTS, CrcFrom, Dialect, DialectError, dialect_named


def test_an_overlay_changes_what_it_names_and_nothing_else() -> None:
    made = Dialect.from_mapping({"crc_from": "id", "aliases": [("X1", 5)]}, DIALECTS["crc-be"])
    assert (made.crc_from, made.crc_order, made.aliases) == (CrcFrom.ID, "big", (("X1", 5),))
    assert Dialect.from_mapping({}) == DEFAULT


def test_a_preset_is_found_with_or_without_its_prefix() -> None:
    assert dialect_named("enig.crc-data-be") is dialect_named("crc-data-be") is DIALECTS["crc-data-be"]
    with pytest.raises(DialectError, match="did you mean 'target'"):
        dialect_named("targets")


@pytest.mark.parametrize(
    ("mapping", "complaint"),
    [
        ({"crc_form": "len"}, "did you mean 'crc_from'"),
        ({"crc_from": "etx"}, "crc_from 'etx' is none of stx, len, id, cmd, data"),
        ({"crc_order": 1}, "crc_order 1 is none of"),
        ({"target": True}, "target True is none of"),
        ({"host_id": "acs"}, "host_id acs needs target include"),
        ({"max_len": 256}, "max_len 256"),
        ({"max_len": True}, "max_len True"),
        ({"agv_ids": 5}, "agv_ids 5"),
        ({"agv_ids": [0]}, "agv_ids 0"),
        ({"agv_ids": [21]}, "buffer_ids 21 is given to agv_ids already"),
        ({"door_ids": ["30"]}, "door_ids '30'"),
        ({"door_ids": [40], "target": "include"}, "door_ids 40 cannot be a Target"),
        ({"aliases": {"": 1}}, "alias ''"),
        ({"aliases": {"문": 1}}, "alias '문'"),
        ({"aliases": ["AB", 3]}, "aliases"),
        ({"aliases": {"B1": "x"}}, "aliases"),
    ],
)
def test_a_dialect_that_cannot_be_is_refused_in_a_sentence(mapping: dict[str, Any], complaint: str) -> None:
    with pytest.raises(DialectError, match=complaint):
        Dialect.from_mapping(mapping)


def test_ids_of_other_numbers_are_no_clash_with_the_host() -> None:
    with pytest.raises(DialectError, match="no DeviceType from 1 to 255"):
        Dialect(agv_ids=(256,))
