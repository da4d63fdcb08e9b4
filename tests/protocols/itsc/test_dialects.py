import json
from pathlib import Path
from typing import Any

import pytest

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT, DIALECTS, Dialect, DialectError, EtbLayout, dialect_named
from app.protocols.itsc.messages import Ack
from app.wire.crc import Crc16

SAMPLE = Path(__file__).parents[2] / "vectors" / "itsc.json"


def test_the_presets_are_those_of_the_vectors() -> None:
    given = json.loads(SAMPLE.read_text(encoding="utf-8"))["dialects"]
    assert {name: Dialect.from_mapping(fields) for name, fields in given.items()} == {
        f"itsc.{name}": dialect for name, dialect in DIALECTS.items()
    }


def test_a_preset_is_found_with_and_without_the_protocol_s_name() -> None:
    assert dialect_named("slides") is dialect_named("itsc.slides") is DIALECTS["slides"]
    with pytest.raises(DialectError, match="did you mean 'slides'"):
        dialect_named("slide")


def test_a_mapping_overlays_a_base() -> None:
    assert Dialect.from_mapping({"pad": 32}, DIALECTS["slides"]) == Dialect(barcode_bytes=4, pad=32)
    assert Dialect.from_mapping({"etb": "head+sub+crc"}).etb is EtbLayout.HEAD_SUB_CRC


def test_a_crc_may_be_given_by_its_parameters() -> None:
    parameters = {
        "width": 16,
        "poly": 0x1021,
        "init": 0xFFFF,
        "refin": False,
        "refout": False,
        "xorout": 0,
        "check": 0x29B1,
    }
    dialect = Dialect.from_mapping({"crc": parameters})
    assert dialect.crc == Crc16(0x1021, init=0xFFFF)
    assert Codec(dialect).encode(Ack(1, 1)) == Codec().encode(Ack(1, 1))


@pytest.mark.parametrize(
    ("mapping", "complaint"),
    [
        ({"barcode_byte": 4}, "unknown dialect field 'barcode_byte'; did you mean 'barcode_bytes'"),
        ({"crc": "modbuss"}, "unknown crc 'modbuss'; did you mean 'modbus'"),
        ({"crc": 7}, "crc 7 is no name"),
        ({"crc": {"poly": 0x1021, "ini": 0}}, "unknown crc parameter 'ini'; did you mean 'init'"),
        ({"crc": {"poly": 0x1021, "width": 32}}, "width 32"),
        ({"crc": {"poly": 0x11021}}, "does not fit in 16 bits"),
        ({"crc": {}}, "crc: "),
        ({"byte_order": "middle"}, "byte_order 'middle' is none of 'big', 'little'"),
        ({"barcode_bytes": 5}, "barcode_bytes 5 is none of 4, 6"),
        ({"barcode_bytes": True}, "barcode_bytes True"),
        ({"crc_covers_type": 1}, "crc_covers_type 1 is none of True, False"),
        ({"etb": "head"}, "etb 'head'"),
        ({"pad": 1}, "pad 1"),
        ({"max_sub": 0}, "max_sub 0"),
        ({"max_sub": 1 << 31}, "max_sub"),
        ({"max_sub": "many"}, "max_sub 'many'"),
        ({"jog_code": 0x10000}, "jog_code 65536"),
        ({"teach_shft_dest": True}, "teach_shft_dest True"),
        ({"jog_code": 0x2070}, "jog_code and teach_shft_dest are both 0x2070"),
    ],
)
def test_what_cannot_be_is_refused_with_what_could(mapping: dict[str, Any], complaint: str) -> None:
    with pytest.raises(DialectError, match=complaint):
        Dialect.from_mapping(mapping)


def test_a_device_is_shown_as_a_number_or_as_four_characters() -> None:
    assert DEFAULT.show_dev_id(0x56303132) == "1445998898"
    text = Dialect(dev_id_format="text")
    assert text.show_dev_id(0x56303132) == "V012"
    assert text.show_dev_id(0xFFFFFFFF) == "0xFFFFFFFF"
    assert Dialect(dev_id_format="text", byte_order="little").show_dev_id(0x32313056) == "V012"
