"""Units. A bare int never crosses a module: the type says what is counted."""

from typing import NewType

Millimetres = NewType("Millimetres", int)
"""Length along the track or on the plan, mm."""
Pulses = NewType("Pulses", int)
"""Axis position, signed 32 bit (PROTOCOLS 1.6, I25)."""
Percent = NewType("Percent", int)
"""Speed, 1 to 100 percent of the vehicle's own maximum (PROTOCOLS 1.6)."""
Seconds = NewType("Seconds", float)
"""A duration or a moment on the clock that the caller passes as ``now``."""
Timestamp = NewType("Timestamp", float)
"""A moment in UTC, seconds since 1970-01-01T00:00:00Z; only for records and people, never for deadlines."""
Barcode = NewType("Barcode", str)
"""A position mark on the rail (AGV: tag). Opaque text everywhere but on the wire (PROTOCOLS I7)."""
