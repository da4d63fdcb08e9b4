"""What people are told of the traffic as a whole."""

from dataclasses import dataclass, field

from app.domain.ids import StationId


@dataclass(slots=True)
class TrafficState:
    """Circles of vehicles that wait for each other, in words, and how many were found and are over since the start; the
    stations that nobody can reach for what is closed, with why; how many vehicles were led another way since the start: around
    what is closed, and because it was quicker; how many pieces of track are slow by the traffic on them, and how often ways were
    weighed anew by it. ``restrained_to``: how many hoists may be on their way with jobs, where the plant says that a fleet may be
    larger than its track carries.
    """

    circles: tuple[str, ...] = ()
    circles_found: int = 0
    circles_resolved: int = 0
    cut_off: dict[StationId, str] = field(default_factory=dict)
    led_round: int = 0
    led_quicker: int = 0
    slow: int = 0
    weighed: int = 0
    restrained_to: int | None = None
