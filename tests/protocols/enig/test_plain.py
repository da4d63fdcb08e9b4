from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.cli.vectors import check
from app.domain.errors import EncodeError
from app.protocols.enig.codec import HEAD_SIZE, TAIL_SIZE, Codec
from app.protocols.enig.dialects import DIALECTS
from app.protocols.enig.messages import Frame, MoveAlias, Raw, Toward
from app.protocols.enig.plain import from_plain, to_plain
from app.protocols.enig.vectors import Vectors
from tests.protocols.enig.frames import frames

CODEC = Codec()


@given(st.data())
def test_a_frame_comes_back_from_its_dictionary(data: st.DataObject) -> None:
    codec = Codec(DIALECTS[data.draw(st.sampled_from(sorted(DIALECTS)))])
    toward = data.draw(st.sampled_from(Toward))
    frame = data.draw(frames(codec.dialect, toward))
    wire = codec.encode(frame, toward)[HEAD_SIZE:-TAIL_SIZE]
    assert from_plain(to_plain(frame, wire, codec, toward), codec, toward) == frame


def test_raw_data_is_told_by_its_cmd() -> None:
    plain = to_plain(Frame(11, 200, Raw(b"\1")), b"\1", CODEC, Toward.DEVICE)
    assert plain == {
        "id": 11,
        "cmd": 200,
        "data": "01",
        "class": "agv",
        "name": None,
        "fields": {"data": "01"},
        "problems": ["unknown command"],
    }
    assert from_plain(plain, CODEC, Toward.DEVICE) == Frame(11, 200, Raw(b"\1"))


@pytest.mark.parametrize(
    ("plain", "complaint"),
    [
        ({"name": "Stop", "fields": {}}, "the frame has no 'id'"),
        ({"id": "11", "name": "Stop"}, "id '11' is no whole number"),
        ({"id": 11, "name": "Halt"}, "unknown command H>E of agv 11: 'Halt'"),
        ({"id": 11, "name": "Status", "fields": {}}, "unknown command H>E of agv 11: 'Status'"),
        ({"id": 21, "name": "Move", "fields": {"tag": "0042"}}, "unknown command H>E of buffer 21: 'Move'"),
        ({"id": 40, "name": "Move", "fields": {"tag": "0042"}}, "device of unknown class 40"),
        ({"id": 11, "name": "Move", "fields": {}}, "the frame has no 'tag'"),
        ({"id": 11, "name": "Move", "fields": {"tag": 42}}, "tag 42 is no text"),
        ({"id": 11, "name": "Move", "fields": {"tag": "0042", "speed": 1}}, "unknown field of Move: 'speed'"),
        ({"id": 11, "name": "Lift", "fields": {"action": True}}, "action True is no whole number"),
        ({"id": 11, "name": "Lift", "cmd": 107, "fields": {"action": 1}}, "CMD of Lift is 106, not 107"),
        ({"id": 11, "cmd": 200, "fields": {"data": "0g"}}, "no frame"),
        ({"id": 11, "cmd": 200, "fields": [1]}, "no frame"),
    ],
)
def test_a_dictionary_that_is_no_frame_is_refused(plain: dict[str, Any], complaint: str) -> None:
    with pytest.raises(EncodeError, match=complaint):
        from_plain(plain, CODEC, Toward.DEVICE)


def vector(dialect: str, packet: bytes, **frame: Any) -> dict[str, Any]:
    kind = "semantic" if frame["problems"] else "valid"
    common = {"id": "x", "protocol": "enig", "dialect": dialect, "direction": "H>E"}
    return {**common, "kind": kind, "hex": packet.hex(), "frames": [frame]}


DIALECT_FIELDS = {"enig.default": {}, "enig.acs-id": {"target": "include", "host_id": "acs"}}


@pytest.mark.parametrize("number", [0, 11])
def test_the_id_of_a_packet_with_the_host_s_own_may_be_given_as_the_device(number: int) -> None:
    codec = Codec(DIALECTS["acs-id"])
    packet = codec.encode(codec.packet(11, MoveAlias("B1")), Toward.DEVICE)
    fields = {"alias": "B1", "target": 11}
    told = {"id": number, "cmd": 107, "data": "0b4231", "class": "agv", "name": "MoveAlias", "problems": []}
    assert list(check(vector("enig.acs-id", packet, **told, fields=fields), DIALECT_FIELDS)) == []
    wrong = vector("enig.acs-id", packet, **{**told, "id": 12}, fields=fields)
    assert "id: expected 12, got 0" in "".join(check(wrong, DIALECT_FIELDS))


@pytest.mark.parametrize(
    ("data", "fields"),
    [
        (b"", {"data": ""}),
        (b"", {"alias": ""}),
        (b"\x0b", {"alias": "", "target": 11}),
        (b"\xff", {"data": "FF"}),
        (b"\xff", {"alias": "\xff"}),
    ],
)
def test_a_content_that_cannot_be_read_may_be_given_whole_or_in_parts(data: bytes, fields: dict[str, Any]) -> None:
    packet = CODEC.encode(Frame(11, 107, Raw(data)), Toward.DEVICE, strict=False)
    told = {"id": 11, "cmd": 107, "data": data.hex(), "class": "agv", "name": "MoveAlias", "problems": ["x"]}
    assert list(check(vector("enig.default", packet, **told, fields=fields), DIALECT_FIELDS)) == []


def test_other_questions_than_enig_has_are_refused() -> None:
    adapter = Vectors({}, {})
    for ask in (
        lambda: adapter.bits("STATUS1", b"\0"),
        lambda: adapter.form("MOVE", b""),
        lambda: adapter.form_bytes("MOVE", {}),
        lambda: adapter.crc("arc", b""),
    ):
        with pytest.raises(ValueError, match=r"ENIG has no|unknown crc 'arc'"):
            ask()
