"""Positions, lengths and speeds in the plant file's units, where a file names units or leaves them to be found out."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot
from statistics import median

from app.plant.exchange.columns import MM, SPEEDS
from app.plant.exchange.draft import Draft
from app.plant.exchange.report import Report

METRES_BELOW = 50
"""Marks less than so far apart, in a column without a unit, are given in metres. Our choice: no marks are 5 cm apart."""


@dataclass(frozen=True, slots=True)
class Reading:
    """How a person wants lists and graphs read. ``unit`` of positions and lengths, empty: found out."""

    unit: str = ""
    y_up: bool = False
    in_order: bool = False
    loop: bool = False


def scale(
    draft: Draft, positions: str, lengths: str, reading: Reading, report: Report, *, y_known: bool = False
) -> None:
    """Bring positions and lengths to millimetres. ``positions`` and ``lengths`` are the units that the file names.

    ``y_known``: the file says itself that y grows downwards.
    """
    given = reading.unit or positions
    unit = given or _likely(_steps(draft))
    if not given and draft.ways:
        report.assumed("", f"positions are in {unit}: the file does not name the unit", "say --unit mm or --unit m")
    factor = MM.get(unit, 1.0)
    for spot in draft.spots:
        spot.x, spot.y = spot.x * factor, spot.y * (-factor if reading.y_up else factor)
    if not reading.y_up and not y_known:
        report.assumed("", "y grows downwards, as on a screen", "say --y-up if the drawing stands on its head")
    known = [(way, way.length) for way in draft.ways if way.length is not None]
    if known and not lengths and not reading.unit:
        lengths = _unit_of_lengths(draft, unit)
        if lengths != unit:
            report.assumed("", f"lengths are in {lengths}, as the positions tell", "name the unit: length (m)")
    for way, length in known:
        way.length = length * MM.get(lengths or unit, 1.0)


def _steps(draft: Draft) -> list[float]:
    """Return how far the ends of track are apart, in the unit of the positions."""
    at = {spot.name: spot for spot in draft.spots}
    pairs = [(at[way.start], at[way.end]) for way in draft.ways if way.start in at and way.end in at]
    return [hypot(a.x - b.x, a.y - b.y) for a, b in pairs]


def _likely(steps: Iterable[float]) -> str:
    apart = [step for step in steps if step > 0]
    return "m" if apart and median(apart) < METRES_BELOW else "mm"


def _unit_of_lengths(draft: Draft, unit: str) -> str:
    """Return the unit in which lengths fit positions that are in mm by now."""
    at = {spot.name: spot for spot in draft.spots}
    ratios = []
    for way in draft.ways:
        if way.length and way.length > 0 and way.start in at and way.end in at:
            a, b = at[way.start], at[way.end]
            ratios.append(hypot(a.x - b.x, a.y - b.y) / way.length)
    if not ratios:
        return unit
    middle = median(ratios)
    return min(("mm", "cm", "m"), key=lambda name: abs(middle - MM[name]) / MM[name])


def settle_speeds(draft: Draft, unit: str, report: Report) -> None:
    """Make speeds of track percent, or velocities where they are in mm/s. ``unit`` is the one that the file names."""
    given = [(way, way.speed) for way in draft.ways if way.speed is not None]
    if not given:
        return
    if not unit:
        most = max(speed for _, speed in given)
        share, unit = most <= 1, "mm/s" if most > 100 else "%"
        what = "shares of the vehicles' own" if share else "mm/s" if unit == "mm/s" else "percent of the vehicles' own"
        report.assumed("", f"speeds are {what}", "name the unit: speed (%) or speed (mm/s)")
        for way, speed in given if share else ():
            way.speed = speed * 100
    if (factor := SPEEDS.get(unit, 0.0)) > 0:
        for way, speed in given:
            way.velocity, way.speed = speed * factor, None
