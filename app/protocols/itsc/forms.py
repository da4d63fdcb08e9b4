"""The data formats as tables of fields, top to bottom as they stand on the wire (PROTOCOLS 1.6, 1.7)."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.messages import (
    Barcode,
    Disp,
    Element,
    Form,
    Infr,
    Jog,
    Move,
    Mzone,
    Nothing,
    Port,
    Req,
    Resp1,
    Resp2,
    Sbuf,
    Stid,
    Teach,
)
from app.protocols.itsc.status import Status1, Status2, status1, status2
from app.wire.layout import Field, Layout, filler, i32, text, u8, u16, u32, wide, word


def _barcode(dialect: Dialect) -> Field:
    if dialect.barcode_format == "uint":
        return wide("barcode", dialect.barcode_bytes, dialect.byte_order)
    return text("barcode", dialect.barcode_bytes, dialect.pad)


def _word1(value: Status1) -> int:
    return value.word


def _word2(value: Status2) -> int:
    return value.word


def _tail(dialect: Dialect) -> tuple[Field, ...]:
    """Return what RESP1 and RESP2 end in: BARCODE, SEQ and in document A DIST (I8, I10)."""
    if dialect.has_dist:
        return (_barcode(dialect), u16("seq"), u16("dist", write=lambda dist: dist or 0))
    return (_barcode(dialect), u16("seq"))


def _port(dialect: Dialect) -> Layout[Port]:
    last = word(dialect.byte_order, filler(2), u8("lkdn"), u8("spd"))
    fields = (i32("shft"), i32("rota"), i32("lift"), *last)
    return Layout(dialect.byte_order, fields, Port, ("shft", "rota", "lift", "lkdn", "spd"))


def _sbuf(dialect: Dialect) -> Layout[Sbuf]:
    return Layout(dialect.byte_order, (filler(12), *word(dialect.byte_order, filler(3), u8("spd"))), Sbuf)


def _teach(dialect: Dialect) -> Layout[Teach]:
    fields = (filler(4), i32("pos"), _barcode(dialect), filler(8 - dialect.barcode_bytes))
    return Layout(dialect.byte_order, fields, Teach)


def _resp1(dialect: Dialect) -> Layout[Resp1]:
    state = u32("status2", read=status2, write=_word2)
    return Layout(dialect.byte_order, (u32("result"), state, *_tail(dialect)), Resp1)


def _resp2(dialect: Dialect) -> Layout[Resp2]:
    axes = u32("status1", read=status1, write=_word1)
    state = u32("status2", read=status2, write=_word2)
    return Layout(dialect.byte_order, (axes, state, *_tail(dialect)), Resp2)


ENQ_FORMS: Mapping[Form, Callable[[Dialect], Layout[Any]]] = MappingProxyType(
    {
        Form.NONE: lambda d: Layout(d.byte_order, (filler(16),), Nothing),
        Form.PORT: _port,
        Form.SBUF: _sbuf,
        Form.DISP: lambda d: Layout(d.byte_order, (u16("alarm"), u16("opt"), text("text", 12, d.pad)), Disp),
        Form.TEACH: _teach,
        Form.RESP1: _resp1,
        Form.RESP2: _resp2,
        Form.REQ: lambda d: Layout(d.byte_order, (u32("opt1"), u32("opt2"), filler(8)), Req),
        Form.MZONE: lambda d: Layout(d.byte_order, (filler(4), u32("zone"), filler(8)), Mzone),
        Form.STID: lambda d: Layout(d.byte_order, (text("stid", 16, d.pad),), Stid),
        Form.JOG: lambda d: Layout(d.byte_order, (u32("opt"), i32("value"), filler(8)), Jog),
        Form.INFR: lambda d: Layout(d.byte_order, (u32("opt"), filler(12)), Infr),
    }
)
"""What makes the layout of an ENQ's 16 data bytes in a dialect, for each format."""


def route_info_layout(dialect: Dialect) -> Layout[Move]:
    """Return the layout of the 64 bytes of transport information; reading gives a Move with an empty path."""
    fields = (text("foup_id", 16, dialect.pad), text("source", 16, dialect.pad), text("destination", 16, dialect.pad))
    return Layout(dialect.byte_order, (*fields, filler(16)), _route_info)


def path_layout(dialect: Dialect) -> Layout[Element]:
    """Return the layout of one path element of 12 bytes."""
    fields = (_barcode(dialect), u16("seq"), u16("trav_cond"))
    tail = (u16("dist_act"), u16("dist_next")) if dialect.has_dist else (filler(2),)
    return Layout(dialect.byte_order, (*fields, *tail), _element)


def _route_info(foup_id: str, source: str, destination: str) -> Move:
    return Move([], foup_id, source, destination)


def _element(barcode: Barcode, seq: int, condition: int, dist_act: int = 0, dist_next: int = 0) -> Element:
    return Element(barcode, seq, condition >> 12, condition >> 8 & 15, condition & 0xFF, dist_act, dist_next)
