"""``hoistway decode PROTOCOL HEX``: what a packet says."""

from __future__ import annotations

import json as jsonlib
import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer

from app.cli.tongue import language, say
from app.wire.names import unknown

if TYPE_CHECKING:
    from app.protocols.itsc.explain import Explanation, Reading


def decode(
    protocol: Annotated[str, typer.Argument(help="itsc, hi or enig")],
    hex: Annotated[list[str], typer.Argument(help="the bytes; blanks, commas and 0x do not matter")],  # noqa: A002
    dialect: Annotated[str, typer.Option(help="a named dialect of the protocol")] = "default",
    json: Annotated[bool, typer.Option("--json", help="for a program")] = False,
    lang: Annotated[str | None, typer.Option(help="en or ko; without it, as hoistway --lang")] = None,
) -> None:
    """Explain the packets in some bytes: every field and bit by name, and why rubbish is rubbish."""
    from app.domain.errors import HoistwayError
    from app.wire.hextext import parse_hex

    show = _PROTOCOLS.get(protocol)
    if show is None:
        _refuse(unknown("protocol", protocol, _PROTOCOLS))
    lang = lang or language()
    if lang not in ("en", "ko"):
        _refuse(unknown("language", lang, ("en", "ko")))
    try:
        data = parse_hex(" ".join(hex))
        if not data:
            _refuse("no bytes were given")
        print(show(data, dialect, lang, json) if json else _told(show(data, dialect, lang, json), lang))
    except (HoistwayError, ValueError) as wrong:
        _refuse(str(wrong))


def _told(explained: str, lang: str) -> str:
    """Return an explanation with what is said of rubbish, which its protocol gives in English, in a language."""
    from app.texts import said

    def line(match: re.Match[str]) -> str:
        return match[1] + said(match[2], "ko" if lang == "ko" else "en")

    return re.sub(r"^(  \S[^:]*: )(.+)$", line, explained, flags=re.MULTILINE)


def _refuse(reason: str) -> NoReturn:
    say(reason, wrong=True)
    raise typer.Exit(2)


def _itsc(data: bytes, dialect: str, lang: str, json: bool) -> str:
    from app.protocols.itsc.codec import Codec
    from app.protocols.itsc.dialects import PREFIX, dialect_named
    from app.protocols.itsc.explain import explain

    chosen = dialect_named(dialect)
    explanation = explain(data, chosen, "ko" if lang == "ko" else "en")
    if not json:
        return "\n".join(_lines(explanation, "ko" if lang == "ko" else "en"))
    name = dialect.removeprefix(PREFIX)
    return jsonlib.dumps(_plain(explanation, Codec(chosen), name), ensure_ascii=False, indent=2)


def _hi(data: bytes, dialect: str, lang: str, json: bool) -> str:
    from app.protocols.hi.explain import show

    return show(data, dialect, lang, json=json)


def _enig(data: bytes, dialect: str, lang: str, json: bool) -> str:
    from app.protocols.enig.explain import show

    return show(data, dialect, "ko" if lang == "ko" else "en", json=json)


_PROTOCOLS: dict[str, Callable[[bytes, str, str, bool], str]] = {"itsc": _itsc, "hi": _hi, "enig": _enig}
"""What shows the bytes of each protocol."""


def _lines(explanation: Explanation, lang: str) -> Iterator[str]:
    from app.protocols.itsc.explain import garbled_row
    from app.protocols.itsc.wording import DIRECTIONS, said
    from app.wire.hextext import show_hex

    for piece in explanation.pieces:
        yield f"@{piece.offset}  {show_hex(piece.data)}"
        if piece.garbled is not None:
            row = garbled_row(piece.garbled, "ko" if lang == "ko" else "en")
            yield f"  {row.value}: {row.meaning}"
        for reading in piece.readings:
            yield f"  [{said(DIRECTIONS[reading.direction], 'ko' if lang == 'ko' else 'en')}]"
            yield from _table(reading)
        yield ""
    for hint in explanation.hints:
        yield f"* {hint}"


def _table(reading: Reading) -> Iterator[str]:
    names = max(len(row.name) + 2 * row.depth for row in reading.rows)
    values = max((len(row.value) for row in reading.rows if len(row.value) <= 20), default=0)
    for row in reading.rows:
        name = "  " * row.depth + row.name
        yield f"    {name:<{names}}  {row.value:<{values}}  {row.meaning}".rstrip()


def _plain(explanation: Explanation, codec: Any, dialect: str) -> dict[str, Any]:
    from app.protocols.itsc.plain import to_plain

    pieces = []
    for piece in explanation.pieces:
        entry: dict[str, Any] = {"offset": piece.offset, "hex": piece.data.hex()}
        if piece.garbled is not None:
            entry["garbled"] = {"reason": piece.garbled.reason.value, "detail": piece.garbled.detail}
        else:
            entry["readings"] = [
                {
                    "direction": reading.direction,
                    "frame": to_plain(reading.frame, codec),
                    "rows": [{"name": r.name, "value": r.value, "meaning": r.meaning} for r in reading.rows],
                }
                for reading in piece.readings
            ]
        pieces.append(entry)
    return {"protocol": "itsc", "dialect": dialect, "pieces": pieces, "hints": list(explanation.hints)}
