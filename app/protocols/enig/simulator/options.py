"""What can be set on simulated devices: every figure that PROTOCOLS 5.3 gives as a default."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from app.domain.devices import AgvSpeed
from app.domain.units import Seconds

SPEEDS: Mapping[AgvSpeed, float] = MappingProxyType(
    {AgvSpeed.SLOW: 200.0, AgvSpeed.NORMAL: 500.0, AgvSpeed.FAST: 1000.0}
)
"""Millimetres a second. Our choice: what AGVs on tape do among people."""

STATUS_EVERY = Seconds(1.0)
FLUSH_AFTER = Seconds(0.1)
"""Silence after which an incomplete packet is given up (6.1)."""


@dataclass(frozen=True, slots=True)
class AgvOptions:
    """Times in seconds, PROTOCOLS 5.3's. ``speeds`` in mm/s at 100 percent; a Move drives at NORMAL (our choice)."""

    status_every: Seconds = STATUS_EVERY
    lift_time: Seconds = Seconds(2.0)
    speeds: Mapping[AgvSpeed, float] = field(default_factory=lambda: SPEEDS)


@dataclass(frozen=True, slots=True)
class BufferOptions:
    """Times in seconds, PROTOCOLS 5.3's."""

    status_every: Seconds = STATUS_EVERY
    lock_time: Seconds = Seconds(1.0)


@dataclass(frozen=True, slots=True)
class DoorOptions:
    """Times in seconds, PROTOCOLS 5.3's."""

    status_every: Seconds = STATUS_EVERY
    move_time: Seconds = Seconds(2.0)
