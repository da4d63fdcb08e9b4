"""Colours, told apart also by the colour-blind: shapes differ as well."""

from collections.abc import Callable
from dataclasses import dataclass

from app.domain.layout import StationKind


@dataclass(frozen=True, slots=True)
class Palette:
    """The colours of one look."""

    paper: str
    ink: str
    faint: str
    track: str
    both: str
    arrow: str
    zone: str
    port: str
    left: str
    right: str
    buffer: str
    park: str
    door: str
    charger: str
    vehicle: str


LIGHT = Palette(
    paper="#ffffff", ink="#17212b", faint="#5c6873", track="#7b8794", both="#8250df", arrow="#3e4c59", zone="#fdecc8",
    port="#0b62c4", left="#00857a", right="#b35900", buffer="#0b62c4", park="#2f7d32", door="#c62828", charger="#946200",
    vehicle="#111827",
)  # fmt: skip
DARK = Palette(
    paper="#10161c", ink="#eef2f6", faint="#9aa7b4", track="#66788a", both="#b392f0", arrow="#c3ced9", zone="#3d3214",
    port="#58a6ff", left="#2dd4bf", right="#ffa657", buffer="#58a6ff", park="#56d364", door="#ff7b72", charger="#e3b341",
    vehicle="#f8fafc",
)  # fmt: skip
STATIONS: dict[StationKind, Callable[[Palette], str]] = {
    StationKind.PORT: lambda palette: palette.port,
    StationKind.SBFL: lambda palette: palette.left,
    StationKind.SBFR: lambda palette: palette.right,
    StationKind.AGV_BUFFER: lambda palette: palette.buffer,
}
