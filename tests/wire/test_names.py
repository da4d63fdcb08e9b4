from app.wire.names import nearest, unknown


def test_the_nearest_name_is_found_in_spite_of_case_and_a_slip() -> None:
    assert nearest("Modbsu", ["arc", "modbus"]) == "modbus"


def test_a_name_like_no_other_has_no_nearest() -> None:
    assert nearest("zzz", ["arc", "modbus"]) is None


def test_a_refusal_offers_the_nearest_name_or_all() -> None:
    assert unknown("crc", "arcc", ["arc", "modbus"]) == "unknown crc 'arcc'; did you mean 'arc'?"
    assert unknown("crc", "zzz", ["modbus", "arc"]) == "unknown crc 'zzz'; known: arc, modbus"
