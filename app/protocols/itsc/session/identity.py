"""Whose packet is it: what a CMD_ID and a code tell of a packet from the vehicle (PROTOCOLS I12, I23; COMMANDS 2)."""

from enum import Enum, auto

from app.domain.events import TeachingKind
from app.domain.ids import CmdId, Epoch, epoch_of
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.messages import Code, Enq, Form, Raw, Teach

_TOP_BIT = 1 << 63
_KINDS = {
    Code.SHFT_DEST_TEACHING: TeachingKind.SHFT_DEST,
    Code.SHFT_OFFSET_TEACHING: TeachingKind.SHFT_OFFSET,
    Code.ROTA_DEST_TEACHING: TeachingKind.ROTA_DEST,
    Code.ROTA_OFFSET_TEACHING: TeachingKind.ROTA_OFFSET,
    Code.LIFT_DEST_TEACHING: TeachingKind.LIFT_DEST,
    Code.LIFT_OFFSET_TEACHING: TeachingKind.LIFT_OFFSET,
}


class Origin(Enum):
    """Who gave a CMD_ID: the vehicle, this life of the controller, another life; ODD: none of them by our rules."""

    VEHICLE = auto()
    OURS = auto()
    OTHER_EPOCH = auto()
    ODD = auto()


def origin_of(cmd_id: int, epoch: Epoch) -> Origin:
    """Return who gave this CMD_ID. A vehicle that does not set the top bit counts from small numbers: epoch 0, ODD."""
    if cmd_id & _TOP_BIT:
        return Origin.VEHICLE
    given = epoch_of(CmdId(cmd_id))
    if given == epoch:
        return Origin.OURS
    return Origin.OTHER_EPOCH if given else Origin.ODD


def teaching(frame: Enq, codec: Codec) -> tuple[Teach, TeachingKind | None] | None:
    """Return content and kind of a teaching event, None for any other packet.

    An unknown code with data in the shape of INST_TEACH, not all zero, is a teaching event of unknown kind (I12).
    """
    message = codec.message(frame.code)
    if isinstance(frame.body, Teach):
        kind = message.kind if message is not None else None
        return frame.body, _KINDS.get(kind) if kind is not None else None
    if message is not None or not isinstance(frame.body, Raw):
        return None
    data = frame.body.data
    if any(data[:4]) or any(data[8 + codec.dialect.barcode_bytes :]) or not any(data):
        return None
    content = codec.decode_body(Form.TEACH, data)
    return (content, None) if isinstance(content, Teach) else None
