"""What every foreign layout says, before names and contradictions are settled: mm, y downwards, names as given."""

from dataclasses import dataclass, field

from app.domain.layout import PulseSet, StationKind, VehicleKind


@dataclass(slots=True)
class Spot:
    """A position mark. ``level`` tells floors apart: only marks of one level can lie at one place."""

    name: str
    x: float
    y: float
    where: str
    park: bool = False
    level: str = ""


@dataclass(slots=True)
class Way:
    """One-way track from mark to mark. ``length`` in mm; ``speed`` in percent, or ``velocity`` in mm/s; None: not said."""

    start: str
    end: str
    where: str
    length: float | None = None
    speed: float | None = None
    velocity: float | None = None
    sensor: int = 0
    curve: bool | None = None


@dataclass(slots=True)
class Place:
    """A station at the first of ``spots`` that there is; ``kind`` None: whatever the plant's vehicles serve."""

    name: str
    spots: list[str]
    where: str
    kind: StationKind | None = None
    display: str = ""
    dest: PulseSet | None = None
    look_down: int = 0
    speed: int = 100
    fallbacks: tuple[str, ...] = ()
    carrier: str = ""


@dataclass(slots=True)
class Charge:
    """A place to charge."""

    name: str
    spot: str
    where: str


@dataclass(slots=True)
class Area:
    """Marks that so many vehicles may hold at once."""

    name: str
    spots: list[str]
    where: str
    capacity: int = 1
    no_stop: bool = False


@dataclass(slots=True)
class Machine:
    """A vehicle. ``velocity`` in mm/s, ``length`` in mm, ``address`` HOST:PORT; None: not said."""

    name: str
    where: str
    kind: VehicleKind | None = None
    dev_id: int | None = None
    address: str = ""
    start: str | None = None
    velocity: float | None = None
    length: float | None = None
    offset: PulseSet | None = None


@dataclass(slots=True)
class Draft:
    """A layout as it was read.

    ``maps``: it comes from a plan of nodes, not from a list of marks that are on the rail: two nodes at one place are one mark.
    ``kind`` is what drives there where nothing else tells.
    """

    title: str = ""
    kind: VehicleKind = VehicleKind.HOIST
    maps: bool = False
    clearance: int = 0
    spots: list[Spot] = field(default_factory=list)
    ways: list[Way] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)
    charges: list[Charge] = field(default_factory=list)
    areas: dict[str, Area] = field(default_factory=dict)
    machines: list[Machine] = field(default_factory=list)
