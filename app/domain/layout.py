"""The plant: track, stations, zones and vehicles, as read from one plant file. Immutable."""

from dataclasses import dataclass, field
from enum import IntEnum, StrEnum

from app.domain.ids import CarrierId, DevId, StationId, VehicleId, ZoneId
from app.domain.units import Barcode, Millimetres, Percent, Pulses


class StopAction(IntEnum):
    """What a path element asks for at its barcode: TRAV_COND bits 11-8 (PROTOCOLS 1.6)."""

    RUN = 0
    STOP = 1
    PORT = 2
    SBFL = 3
    SBFR = 4
    PORT_BARE = 5
    """Stop to PORT position without preparative action; only on request (I42)."""


class StationKind(StrEnum):
    """Where a hoist can find or leave a carrier (PROTOCOLS 1.1)."""

    PORT = "port"
    SBFL = "sbfl"
    SBFR = "sbfr"

    @property
    def stop_action(self) -> StopAction:
        """The stop that brings a vehicle to this kind of station."""
        return _STOP_AT[self]


_STOP_AT = {
    StationKind.PORT: StopAction.PORT,
    StationKind.SBFL: StopAction.SBFL,
    StationKind.SBFR: StopAction.SBFR,
}


class Axis(StrEnum):
    """The taught axes of a hoist (PROTOCOLS 1.6, INST_PORT)."""

    SHFT = "shft"
    ROTA = "rota"
    LIFT = "lift"


@dataclass(frozen=True, slots=True)
class Point:
    """A barcode and where it lies on the plan; ``park`` marks a place where an idle vehicle may wait."""

    barcode: Barcode
    x: Millimetres
    y: Millimetres
    park: bool = False


@dataclass(frozen=True, slots=True)
class Edge:
    """One-way track between two neighbouring barcodes.

    ``speed`` is the limit in percent, ``sensor`` the obstacle-sensor area 0-15 (PROTOCOLS I49), ``curve`` limits the
    vehicle to its curve speed.
    """

    start: Barcode
    end: Barcode
    length: Millimetres
    speed: Percent = Percent(100)
    sensor: int = 0
    curve: bool = False


@dataclass(frozen=True, slots=True)
class PulseSet:
    """Positions of the three taught axes."""

    shft: Pulses
    rota: Pulses
    lift: Pulses

    def plus(self, other: "PulseSet") -> "PulseSet":
        """Return the sum, axis by axis (target = DEST + OFFSET, DOMAIN section 3)."""
        return PulseSet(Pulses(self.shft + other.shft), Pulses(self.rota + other.rota), Pulses(self.lift + other.lift))

    def of(self, axis: Axis) -> Pulses:
        """Return one axis."""
        return {Axis.SHFT: self.shft, Axis.ROTA: self.rota, Axis.LIFT: self.lift}[axis]


NO_OFFSET = PulseSet(Pulses(0), Pulses(0), Pulses(0))


@dataclass(frozen=True, slots=True)
class Station:
    """A place for one carrier, reached by standing at ``barcode``.

    ``look_down`` is LKDN 0-15 and ``speed`` SPD 1-100 of INST_PORT and INST_SBUF. ``dest`` is the Station DEST the plant
    file brings (ports only; teaching replaces it). ``display`` is the name shown on the vehicle, at most 16 characters.
    """

    id: StationId
    kind: StationKind
    barcode: Barcode
    look_down: int = 0
    speed: Percent = Percent(100)
    dest: PulseSet | None = None
    display: str = ""
    fallbacks: tuple[StationId, ...] = ()


@dataclass(frozen=True, slots=True)
class Zone:
    """A set of barcodes that at most ``capacity`` vehicles may hold track in at the same time.

    ``no_stop``: a vehicle enters only if it is granted track to beyond the zone, or to a goal inside it (merges, crossings).
    """

    id: ZoneId
    barcodes: frozenset[Barcode]
    capacity: int = 1
    no_stop: bool = False
    name: str = ""


@dataclass(frozen=True, slots=True)
class AxisLimits:
    """Lowest and highest pulses per axis that may be sent to a vehicle, inclusive."""

    shft: tuple[Pulses, Pulses]
    rota: tuple[Pulses, Pulses]
    lift: tuple[Pulses, Pulses]

    def of(self, axis: Axis) -> tuple[Pulses, Pulses]:
        """Return the limits of one axis."""
        return {Axis.SHFT: self.shft, Axis.ROTA: self.rota, Axis.LIFT: self.lift}[axis]


_INT32 = (Pulses(-(1 << 31)), Pulses((1 << 31) - 1))


@dataclass(frozen=True, slots=True)
class VehicleSpec:
    """A vehicle as the plant file gives it.

    ``host``/``port`` is where we dial, or, with ``listen``, the address that an incoming vehicle must come from (empty:
    any). Speeds in mm/s, accelerations in mm/s² (defaults: PROTOCOLS 5.1). ``length`` is the stretch of rail the
    vehicle covers *behind* the barcode it reports, safety margin included. ``start`` is where the simulated vehicle is
    put. ``reach`` is how far it may move by itself in MANT, both ways (COMMANDS section 3).
    """

    id: VehicleId
    dev_id: DevId
    host: str = "127.0.0.1"
    port: int = 0
    listen: bool = False
    dialect: str = "default"
    length: Millimetres = Millimetres(1000)
    max_count: int = 200
    max_speed: Millimetres = Millimetres(3000)
    curve_speed: Millimetres = Millimetres(1000)
    acceleration: Millimetres = Millimetres(2000)
    braking: Millimetres = Millimetres(3000)
    reach: Millimetres = Millimetres(3000)
    limits: AxisLimits = AxisLimits(_INT32, _INT32, _INT32)
    offset: PulseSet | None = None
    start: Barcode | None = None
    in_service: bool = True


@dataclass(frozen=True, slots=True)
class Plant:
    """Everything that one controller looks after.

    ``edges`` are one-way. ``carriers`` is where carriers are when the plant is first started (provenance ``plant``).
    ``clearance`` is the least distance in mm between the centres of two vehicles on track that is not consecutive:
    barcodes nearer than that exclude each other. ``dialects`` are the plant's own ones, by name: fields laid over a preset
    (``preset``, else the default).
    """

    name: str
    points: tuple[Point, ...]
    edges: tuple[Edge, ...]
    stations: tuple[Station, ...]
    vehicles: tuple[VehicleSpec, ...]
    zones: tuple[Zone, ...] = ()
    carriers: tuple[tuple[CarrierId, StationId], ...] = ()
    clearance: Millimetres = Millimetres(0)
    listen: tuple[str, int] | None = None
    process_codes: dict[int, str] = field(default_factory=dict)
    alarm_codes: dict[int, str] = field(default_factory=dict)
    event_numbers: dict[str, int] = field(default_factory=dict)
    dialects: dict[str, dict[str, object]] = field(default_factory=dict)

    def station(self, station: StationId) -> Station | None:
        """Return the station of that name, or None."""
        return next((s for s in self.stations if s.id == station), None)

    def vehicle(self, vehicle: VehicleId) -> VehicleSpec | None:
        """Return the vehicle of that name, or None."""
        return next((v for v in self.vehicles if v.id == vehicle), None)
