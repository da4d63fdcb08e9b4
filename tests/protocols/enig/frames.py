"""Strategies for ENIG packets that a strict sender may send, in a given dialect."""

from collections.abc import Callable, Mapping
from typing import Any

from hypothesis import strategies as st

from app.protocols.enig.codec import codec_of
from app.protocols.enig.dialects import Dialect
from app.protocols.enig.messages import (
    AgvReport,
    Body,
    BufferReport,
    Charge,
    Close,
    DoorReport,
    Frame,
    Lift,
    Lock,
    MarkStop,
    Move,
    MoveAlias,
    MoveAuto,
    MoveComplete,
    MoveManual,
    Open,
    Reset,
    SetCurrent,
    Stop,
    TagReceived,
    Toward,
    UnLock,
)

TAGS = st.text(st.characters(min_codepoint=0x20, max_codepoint=0x7E), min_size=4, max_size=4)
STATES = st.sampled_from([0, 1, 2, 3, 255])


def _small(top: int) -> st.SearchStrategy[int]:
    return st.integers(0, top)


AGV_COMMANDS: tuple[Callable[[Dialect], st.SearchStrategy[Body]], ...] = (
    lambda _: st.builds(Move, TAGS),
    lambda _: st.builds(Stop),
    lambda _: st.builds(Reset),
    lambda _: st.builds(SetCurrent, TAGS),
    lambda _: st.builds(MoveManual, _small(3), _small(2)),
    lambda _: st.builds(MarkStop),
    lambda _: st.builds(Lift, _small(2)),
    lambda dialect: st.builds(MoveAlias, st.sampled_from([name for name, _ in dialect.aliases])),
    lambda _: st.builds(MoveAuto, _small(1), _small(2), _small(2)),
    lambda _: st.builds(Charge, _small(1)),
)
REPORT = st.builds(
    AgvReport, _small(1), _small(2), _small(3), _small(1), _small(1), _small(2), _small(2), TAGS, _small(255)
)
BODIES: Mapping[tuple[str, Toward], Callable[[Dialect], st.SearchStrategy[Any]]] = {
    ("agv_ids", Toward.DEVICE): lambda dialect: st.one_of(*(make(dialect) for make in AGV_COMMANDS)),
    ("agv_ids", Toward.HOST): lambda _: st.one_of(st.builds(MoveComplete, TAGS), st.builds(TagReceived, TAGS), REPORT),
    ("buffer_ids", Toward.DEVICE): lambda _: st.one_of(st.builds(Lock), st.builds(UnLock)),
    ("buffer_ids", Toward.HOST): lambda _: st.builds(BufferReport, STATES),
    ("door_ids", Toward.DEVICE): lambda _: st.one_of(st.builds(Open), st.builds(Close)),
    ("door_ids", Toward.HOST): lambda _: st.builds(DoorReport, STATES),
}


@st.composite
def frames(draw: st.DrawFn, dialect: Dialect, toward: Toward) -> Frame:
    """A packet as the dialect's strict sender makes it."""
    ids = draw(st.sampled_from(["agv_ids", "buffer_ids", "door_ids"]))
    device = draw(st.sampled_from(getattr(dialect, ids)))
    return codec_of(dialect).packet(device, draw(BODIES[ids, toward](dialect)))
