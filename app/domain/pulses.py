"""Positions of the taught axes, some of them perhaps not known yet, and what follows from them (DOMAIN section 3, I40, I41)."""

from collections.abc import Mapping
from dataclasses import dataclass

from app.domain.layout import Axis, AxisLimits, PulseSet
from app.domain.units import Pulses

LOWEST, HIGHEST = -(1 << 31), (1 << 31) - 1
"""Pulses are signed 32 bit on the wire (PROTOCOLS I25)."""


@dataclass(frozen=True, slots=True)
class PartialPulses:
    """Positions of those taught axes that are known; None where an axis was never taught. One at least is None."""

    shft: Pulses | None = None
    rota: Pulses | None = None
    lift: Pulses | None = None

    def of(self, axis: Axis) -> Pulses | None:
        """Return one axis."""
        return {Axis.SHFT: self.shft, Axis.ROTA: self.rota, Axis.LIFT: self.lift}[axis]


AxisPulses = PulseSet | PartialPulses
"""A PulseSet is complete: PICKUP and PLACE use no other."""


def known(pulses: AxisPulses | None) -> dict[Axis, Pulses]:
    """Return the axes that are known, in the order of the wire."""
    if pulses is None:
        return {}
    return {axis: value for axis in Axis if (value := pulses.of(axis)) is not None}


def pulses_of(values: Mapping[Axis, Pulses]) -> AxisPulses:
    """Undo :func:`known`."""
    if len(values) == len(Axis):
        return PulseSet(values[Axis.SHFT], values[Axis.ROTA], values[Axis.LIFT])
    return PartialPulses(values.get(Axis.SHFT), values.get(Axis.ROTA), values.get(Axis.LIFT))


def missing(pulses: AxisPulses | None) -> tuple[Axis, ...]:
    """Return the axes that are not known."""
    there = known(pulses)
    return tuple(axis for axis in Axis if axis not in there)


def named(axes: tuple[Axis, ...]) -> str:
    """Return axes as people name them: ``SHFT, ROTA``."""
    return ", ".join(axis.name for axis in axes)


def carried_over(before: AxisPulses | None, taught: AxisPulses) -> AxisPulses:
    """Return what a partial re-teaching makes: the axes taught, and the others as they were (DOMAIN section 3)."""
    return pulses_of(known(before) | known(taught))


def less(raw: AxisPulses, other: AxisPulses) -> AxisPulses:
    """Return raw minus the other side, for the axes of raw that the other side has (I40)."""
    subtracted = known(other)
    return pulses_of({a: Pulses(value - subtracted[a]) for a, value in known(raw).items() if a in subtracted})


def target(dest: AxisPulses | None, offset: AxisPulses | None) -> AxisPulses:
    """Return DEST + OFFSET for the axes that both have."""
    added = known(offset)
    return pulses_of({a: Pulses(value + added[a]) for a, value in known(dest).items() if a in added})


def beyond(pulses: AxisPulses, limits: AxisLimits) -> str:
    """Return what is outside the limits, as a clause: ``LIFT 61000 is outside 0..60000``; empty if nothing is."""
    for axis, value in known(pulses).items():
        low, high = limits.of(axis)
        if not low <= value <= high:
            return f"{axis.name} {value} is outside {low}..{high}"
    return ""


def fits_wire(pulses: AxisPulses) -> bool:
    """Whether every axis can be written in 32 bits."""
    return all(LOWEST <= value <= HIGHEST for value in known(pulses).values())


def drifts(before: AxisPulses | None, after: AxisPulses, most: PulseSet) -> str:
    """Return how far the new values are from the old where that is more than ``most``: ``LIFT by +412``; empty: nowhere."""
    old = known(before)
    moved = [(axis, value - old[axis]) for axis, value in known(after).items() if axis in old]
    return ", ".join(f"{axis.name} by {by:+d}" for axis, by in moved if abs(by) > most.of(axis))
