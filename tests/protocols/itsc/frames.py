"""Strategies for iTSC frames that a strict sender may send, in a given dialect."""

import string
from collections.abc import Callable
from functools import cache

from hypothesis import strategies as st

from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.messages import (
    NOTHING,
    Ack,
    Barcode,
    Body,
    Code,
    Disp,
    Element,
    Enq,
    Etb,
    Form,
    Frame,
    Infr,
    Jog,
    Message,
    Move,
    Mzone,
    Nak,
    Port,
    Raw,
    Req,
    Resp1,
    Resp2,
    Sbuf,
    Stid,
    Teach,
    Toward,
    Xmove,
    messages_of,
    status1,
    status2,
)

U16 = st.integers(0, 0xFFFF)
U32 = st.integers(0, 0xFFFFFFFF)
U64 = st.integers(0, (1 << 64) - 1)
PULSES = st.integers(-(1 << 31), (1 << 31) - 1)
PERCENT = st.integers(1, 100)
WORD1 = U32.map(status1)
WORD2 = U32.map(status2)
_PRINTABLE = "".join(sorted(set(string.printable) - set("\t\n\r\v\f")))


def texts(size: int) -> st.SearchStrategy[str]:
    return st.text(_PRINTABLE, max_size=size).map(lambda text: text.rstrip(" "))


def barcodes(dialect: Dialect) -> st.SearchStrategy[Barcode]:
    if dialect.barcode_format == "ascii":
        return texts(dialect.barcode_bytes)
    return st.integers(0, (1 << 8 * dialect.barcode_bytes) - 1)


@st.composite
def paths(draw: st.DrawFn, dialect: Dialect, first: int | None = 0) -> list[Element]:
    count = draw(st.integers(1, 6))
    start = draw(st.integers(0, 0xFFFF - count)) if first is None else first
    distances = U16 if dialect.has_dist else st.just(0)
    return [
        Element(
            draw(barcodes(dialect)),
            start + i,
            draw(st.integers(0, 15)),
            draw(st.integers(0 if i < count - 1 else 1, 5)),
            draw(PERCENT),
            draw(distances),
            draw(distances),
        )
        for i in range(count)
    ]


def bodies(form: Form, dialect: Dialect) -> st.SearchStrategy[Body]:
    barcode = barcodes(dialect)
    dist = U16 if dialect.has_dist else st.none()
    makers: dict[Form, Callable[[], st.SearchStrategy[Body]]] = {
        Form.NONE: lambda: st.just(NOTHING),
        Form.PORT: lambda: st.builds(Port, PULSES, PULSES, PULSES, st.integers(0, 15), PERCENT),
        Form.SBUF: lambda: st.builds(Sbuf, PERCENT),
        Form.DISP: lambda: st.builds(Disp, U16, st.integers(0, 1), texts(12)),
        Form.TEACH: lambda: st.builds(Teach, PULSES, barcode),
        Form.MOVE: lambda: st.builds(Move, paths(dialect), texts(16), texts(16), texts(16)),
        Form.XMOVE: lambda: st.builds(Xmove, paths(dialect, None)),
        Form.RESP1: lambda: st.builds(Resp1, st.integers(0, 1), WORD2, barcode, U16, dist),
        Form.RESP2: lambda: st.builds(Resp2, WORD1, WORD2, barcode, U16, dist),
        Form.REQ: lambda: st.builds(Req, st.integers(0, 1), st.integers(0, 1)),
        Form.MZONE: lambda: st.builds(Mzone, U32),
        Form.STID: lambda: st.builds(Stid, texts(16)),
        Form.JOG: lambda: st.one_of(
            st.builds(Jog, st.integers(1, 2), PULSES), st.builds(Jog, st.integers(3, 4), st.just(0))
        ),
        Form.INFR: lambda: st.builds(Infr, st.integers(0, 5)),
        Form.RAW: lambda: st.builds(Raw, st.binary(min_size=16, max_size=16)),
    }
    return makers[form]()


@cache
def frames(dialect: Dialect, toward: Toward) -> st.SearchStrategy[Frame]:
    """Every kind of frame that may go one way. Made once: making it anew costs more than drawing and coding a frame."""
    kinds: list[st.SearchStrategy[Frame]] = [st.builds(Ack, U32, U64), st.builds(Nak, U32, U64)]
    for code, message in messages_of(dialect).items():
        form = _form(message, toward)
        if form is not None:
            packet = Etb if form in (Form.MOVE, Form.XMOVE) else Enq
            kinds.append(st.builds(packet, U32, U64, st.just(code), bodies(form, dialect)))
    return st.one_of(kinds)


def _form(message: Message, toward: Toward) -> Form | None:
    if message.from_vehicle is (toward is Toward.CONTROLLER):
        return message.request
    return message.answer


def a_move(*path: Element) -> Etb:
    return Etb(1, 2, Code.MOVE, Move(list(path) or [Element(1201, 0, 3, 1, 80)]))
