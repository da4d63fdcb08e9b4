"""Frames for property tests."""

from hypothesis import strategies as st

from app.protocols.hi.dialects import Dialect
from app.protocols.hi.messages import (
    CONTENTS,
    ERRORS,
    NOTHING,
    OPERATIONS,
    Ack,
    Content,
    Frame,
    Inputs,
    Nothing,
    Number,
    Refused,
    Role,
    Setting,
    Ssa,
    frame_of,
)

BITS = st.integers(0, 1)
TEXTS = st.text(st.characters(min_codepoint=0x20, max_codepoint=0x7E, exclude_characters="@&#"), min_size=1, max_size=8)


@st.composite
def statuses(draw: st.DrawFn) -> Ssa:
    mode = draw(st.integers(0, 4))
    status = draw(st.sampled_from(sorted(ERRORS if mode == 4 else OPERATIONS)))
    short = Ssa(mode, draw(st.integers(0, 7)), status)
    if draw(st.booleans()):
        return short
    return Ssa(short.mode, short.output, short.status, draw(BITS), draw(st.integers(0, 999999)))


def contents(kind: type[Content], dialect: Dialect) -> st.SearchStrategy[Content]:
    """Everything that a strict sender may say of a kind."""
    strategies: dict[type[Content], st.SearchStrategy[Content]] = {
        Nothing: st.just(NOTHING),
        Number: st.builds(Number, st.integers(0, 255)),
        Setting: st.builds(Setting, st.integers(0, 255), st.integers(0, dialect.highest_value)),
        Inputs: st.builds(Inputs, BITS, BITS, BITS, BITS, st.integers(0, 15)),
        Ack: st.builds(Ack, st.integers(0, 4)),
        Refused: st.builds(Refused, st.none() | st.integers(0, 4)),
        Ssa: statuses(),
    }
    return strategies[kind]


@st.composite
def known_frames(draw: st.DrawFn, dialect: Dialect) -> Frame:
    """A packet of the command table."""
    role, cmd = draw(st.sampled_from(sorted(CONTENTS)))
    drive = draw(st.integers(0 if role is Role.MASTER else 1, 15))
    return frame_of(role, drive, cmd, draw(contents(CONTENTS[role, cmd], dialect)), dialect)


@st.composite
def any_frames(draw: st.DrawFn) -> Frame:
    """Anything that keeps the grammar."""
    role = draw(st.sampled_from(Role))
    cmd = draw(st.text("ABCDEFGHIJKLMNOPQRSTUVWXYZ", min_size=3, max_size=3))
    drive = draw(st.integers(0 if role is Role.MASTER else 1, 15))
    return Frame(role, drive, cmd, tuple(draw(st.lists(TEXTS, max_size=5))), draw(st.booleans()))
