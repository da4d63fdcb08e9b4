"""``hoistway detect PROTOCOL FILE``: which CRC a device uses, from captured packets (PROTOCOLS 6.4)."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from app.cli.tongue import say, told_here
from app.wire.names import unknown

if TYPE_CHECKING:
    from app.protocols.itsc.detect import Variant


def detect(
    protocol: Annotated[str, typer.Argument(help="itsc, hi or enig")],
    file: Annotated[Path, typer.Argument(help="a capture in hexadecimal: one packet on each line, or a stream")],
) -> None:
    """Try every CRC, coverage and byte order on a capture and print those that fit. iTSC: ACKs serve best."""
    tell = _PROTOCOLS.get(protocol)
    if tell is None:
        _refuse(unknown("protocol", protocol, _PROTOCOLS))
    text, fits = tell(_read(file))
    say(text)
    if not fits:
        raise typer.Exit(1)


def _itsc(packets: list[bytes]) -> tuple[str, bool]:
    from app.protocols.itsc.detect import VARIANTS, fits_of_stream, surviving

    survivors = surviving(packets)
    if survivors:
        lines = [f"{len(packets)} packets, {len(VARIANTS)} variants tried, {len(survivors)} left:"]
        lines += [f"  {_name(variant)}" for variant in survivors]
        if len(survivors) > 1:
            lines.append("more than one is left: capture more packets (three are proof)")
        return "\n".join(lines), True
    stream = b"".join(packets)
    fits = fits_of_stream(stream)
    if not fits:
        return f"none of the {len(VARIANTS)} variants fits: not iTSC, or a CRC that is not in the list", False
    lines = [f"the lines are not one whole packet each that fits; read as a stream of {len(stream)} bytes:"]
    for fit in fits:
        lines.append(f"  {_name(fit.variant)}: {fit.frames} packets, {fit.covered} bytes fit, {fit.dropped} do not")
    return "\n".join(lines), True


def _hi(packets: list[bytes]) -> tuple[str, bool]:
    from app.protocols.hi.detect import detected

    return detected(packets)


def _enig(packets: list[bytes]) -> tuple[str, bool]:
    from app.protocols.enig.detect import detected

    return detected(packets)


_PROTOCOLS: dict[str, Callable[[list[bytes]], tuple[str, bool]]] = {"itsc": _itsc, "hi": _hi, "enig": _enig}
"""What tells of the captured packets of each protocol which variants fit, and whether any does."""


def _read(file: Path) -> list[bytes]:
    from app.wire.hextext import parse_hex

    try:
        lines = file.read_text(encoding="utf-8").splitlines()
    except OSError as wrong:
        _refuse(f"{file} cannot be read: {wrong.strerror}")
    except UnicodeDecodeError:
        _refuse(f"{file} is no text: a capture is hexadecimal text")
    packets = []
    for number, line in enumerate(lines, 1):
        try:
            packet = parse_hex(line.partition("#")[0])
        except ValueError as wrong:
            _refuse(f"{file}, line {number}: {wrong}")
        if packet:
            packets.append(packet)
    if not packets:
        _refuse(f"{file} holds no bytes")
    return packets


def _name(variant: Variant) -> str:
    covers = "covers TYPE" if variant.covers_type else "starts after TYPE"
    order = "high byte first" if variant.order == "big" else "low byte first"
    preset = f"  (dialect {variant.preset})" if variant.preset else ""
    return f"crc {variant.crc}, {told_here(covers)}, {told_here(order)}{preset}"


def _refuse(reason: str) -> NoReturn:
    say(reason, wrong=True)
    raise typer.Exit(2)
