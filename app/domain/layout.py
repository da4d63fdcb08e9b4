"""The plant: track, stations, zones and vehicles, as read from one plant file. Immutable."""

from dataclasses import dataclass, field
from enum import IntEnum, StrEnum

from app.domain.catalogue import UNKNOWN_MODEL, Catalogue
from app.domain.devices import AliasName, DeviceId, DeviceNumber
from app.domain.drive import DriveAddress, DriveId
from app.domain.ids import CarrierId, DevId, LinkId, StationId, VehicleId, ZoneId
from app.domain.units import Barcode, Millimetres, Percent, Pulses, Seconds


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
    """Where a hoist can find or leave a carrier (PROTOCOLS 1.1), or an AGV a cart (3.2)."""

    PORT = "port"
    SBFL = "sbfl"
    SBFR = "sbfr"
    AGV_BUFFER = "agv_buffer"

    @property
    def stop_action(self) -> StopAction:
        """The stop that brings a vehicle to this kind of station."""
        return _STOP_AT[self]


_STOP_AT = {
    StationKind.PORT: StopAction.PORT,
    StationKind.SBFL: StopAction.SBFL,
    StationKind.SBFR: StopAction.SBFR,
    StationKind.AGV_BUFFER: StopAction.STOP,
}


class Axis(StrEnum):
    """The taught axes of a hoist (PROTOCOLS 1.6, INST_PORT)."""

    SHFT = "shft"
    ROTA = "rota"
    LIFT = "lift"


OVERDUE = Seconds(600.0)
"""What ``Plant.overdue`` is where a plant does not say. Our choice."""


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
    ``buffer`` is the device to lock while the station is served (AGV buffers); ``alias`` its name for command 107.
    """

    id: StationId
    kind: StationKind
    barcode: Barcode
    look_down: int = 0
    speed: Percent = Percent(100)
    dest: PulseSet | None = None
    display: str = ""
    fallbacks: tuple[StationId, ...] = ()
    buffer: DeviceId | None = None
    alias: AliasName | None = None


@dataclass(frozen=True, slots=True)
class Meter:
    """Makes a zone soft: at most ``share`` (0 to 1) of its slots are filled from outside; who waited ``patience`` comes in."""

    share: float
    patience: Seconds


@dataclass(frozen=True, slots=True)
class Zone:
    """A set of barcodes that at most ``capacity`` vehicles may hold track in at the same time.

    ``no_stop``: a vehicle enters only if it is granted track to beyond the zone, or to a goal inside it (merges, crossings).
    ``meter``: the zone is soft. Then ``capacity`` counts for nothing.
    """

    id: ZoneId
    barcodes: frozenset[Barcode]
    capacity: int = 1
    no_stop: bool = False
    name: str = ""
    meter: Meter | None = None


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


class Wire(StrEnum):
    """Which protocol is spoken on a line."""

    ITSC = "itsc"
    ENIG = "enig"
    HI = "hi"


@dataclass(frozen=True, slots=True)
class SerialPort:
    """A serial device and how its characters are framed (9600 8N1 unless configured, PROTOCOLS 2.1, H13)."""

    device: str
    baud: int = 9600
    data_bits: int = 8
    parity: str = "N"
    stop_bits: int = 1


@dataclass(frozen=True, slots=True)
class LinkSpec:
    """A line that carries several devices: those of an ENIG link, or the drives of one HI line (PROTOCOLS E23, 2.3).

    ``host``/``port`` is where we dial (a device, or a TCP serial server) unless ``serial`` names a port of this machine.
    ``dialect`` are fields laid over the protocol's default dialect, or over the one that ``preset`` names.
    """

    id: LinkId
    wire: Wire
    host: str = "127.0.0.1"
    port: int = 0
    serial: SerialPort | None = None
    dialect: dict[str, object] = field(default_factory=dict)


class OnEmergency(StrEnum):
    """What a door does when a fire or an earthquake is told (DOMAIN section 7)."""

    LEAVE = "leave"
    OPEN = "open"
    CLOSE = "close"


@dataclass(frozen=True, slots=True)
class DoorSpec:
    """A door across the track (PROTOCOLS 3.3). ``passages`` are the pieces of track that lead through it, either way.

    ``normally_open`` doors are open at rest, and are closed by people alone.
    """

    id: DeviceId
    link: LinkId
    number: DeviceNumber
    passages: frozenset[tuple[Barcode, Barcode]]
    normally_open: bool = False
    on_emergency: OnEmergency = OnEmergency.LEAVE


@dataclass(frozen=True, slots=True)
class BufferSpec:
    """A buffer with a lock of its own (PROTOCOLS 3.3); the station whose ``buffer`` it is says where."""

    id: DeviceId
    link: LinkId
    number: DeviceNumber


@dataclass(frozen=True, slots=True)
class ChargerSpec:
    """A place where an AGV charges. It has no packets of its own (PROTOCOLS 3.2); ``alias`` is its name for command 107."""

    id: DeviceId
    barcode: Barcode
    alias: AliasName | None = None


@dataclass(frozen=True, slots=True)
class ChargingRules:
    """When AGVs charge: ENIG reports no battery level (DOMAIN section 7).

    An AGV is sent to charge after so many ``trips`` or so much time (``after``) since it last charged, whichever comes first
    (None: not for this reason), and stays ``lasting`` long at least. In ``windows``, minutes of the day in UTC (from, to),
    idle AGVs charge whatever they did.
    """

    trips: int | None = None
    after: Seconds | None = None
    lasting: Seconds = Seconds(600.0)
    windows: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True, slots=True)
class IdleRules:
    """What hoists do that have nothing to do: with ``park``, after so long (``after``) they go to a parking place.

    It is no farther than ``farthest`` seconds of driving. All values are our choice.
    """

    park: bool = False
    after: Seconds = Seconds(20.0)
    farthest: Seconds = Seconds(60.0)


@dataclass(frozen=True, slots=True)
class DriveUnit:
    """An axis drive on an HI line (PROTOCOLS section 2). ``model`` names its parameter catalogue; empty: raw access only."""

    id: DriveId
    link: LinkId
    address: DriveAddress
    model: str = ""
    name: str = ""


class VehicleKind(StrEnum):
    """What a vehicle is, and so which stations it serves and which protocol it speaks."""

    HOIST = "hoist"
    AGV = "agv"

    @property
    def serves(self) -> frozenset[StationKind]:
        """The stations that it can take from and bring to."""
        return _SERVES[self]


_SERVES = {
    VehicleKind.HOIST: frozenset({StationKind.PORT, StationKind.SBFL, StationKind.SBFR}),
    VehicleKind.AGV: frozenset({StationKind.AGV_BUFFER}),
}


@dataclass(frozen=True, slots=True)
class VehicleSpec:
    """A vehicle as the plant file gives it.

    ``host``/``port`` is where we dial, or, with ``listen``, the address that an incoming vehicle must come from (empty:
    any). Speeds in mm/s, accelerations in mm/s² (defaults: PROTOCOLS 5.1). ``length`` is the stretch of rail the
    vehicle covers *behind* the barcode it reports, safety margin included. ``start`` is where the simulated vehicle is
    put. ``reach`` is how far it may move by itself in MANT, both ways (COMMANDS section 3). An AGV is reached over its
    ``link``, where ``dev_id`` is its number (DeviceType); host, port, listen, dialect, limits and offset are a hoist's.
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
    kind: VehicleKind = VehicleKind.HOIST
    link: LinkId | None = None


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
    links: tuple[LinkSpec, ...] = ()
    doors: tuple[DoorSpec, ...] = ()
    buffers: tuple[BufferSpec, ...] = ()
    chargers: tuple[ChargerSpec, ...] = ()
    charging: ChargingRules = ChargingRules()
    restrain: bool = False
    """Whether no more vehicles set out with jobs than the track carries."""
    congestion: bool | None = None
    """Whether routes keep off track that is slow by the traffic on it; None: unless the fleet is kept back (docs/traffic.md)."""
    idle: IdleRules = IdleRules()
    overdue: Seconds = OVERDUE
    """A job that waits so long for what no driving puts right is an alarm; 0: never."""
    drives: tuple[DriveUnit, ...] = ()
    catalogues: tuple[Catalogue, ...] = ()
    reference_vehicles: frozenset[VehicleId] = frozenset()
    """Vehicles whose OFFSET is zero by declaration (I40): what they teach is the DEST itself."""

    def station(self, station: StationId) -> Station | None:
        """Return the station of that name, or None."""
        return next((s for s in self.stations if s.id == station), None)

    def vehicle(self, vehicle: VehicleId) -> VehicleSpec | None:
        """Return the vehicle of that name, or None."""
        return next((v for v in self.vehicles if v.id == vehicle), None)

    @property
    def hoists(self) -> tuple[VehicleSpec, ...]:
        """The vehicles that have a line of their own."""
        return tuple(v for v in self.vehicles if v.kind is VehicleKind.HOIST)

    @property
    def aliases(self) -> dict[AliasName, Barcode]:
        """The destinations of ENIG's command 107 that are known here, with the tag of each."""
        named = {station.alias: station.barcode for station in self.stations}
        named |= {charger.alias: charger.barcode for charger in self.chargers}
        return {alias: tag for alias, tag in named.items() if alias is not None}

    def agvs_on(self, link: LinkId) -> tuple[VehicleSpec, ...]:
        """Return the AGVs that are reached over a link."""
        return tuple(v for v in self.vehicles if v.kind is VehicleKind.AGV and v.link == link)

    def drive(self, drive: DriveId) -> DriveUnit | None:
        """Return the drive of that name, or None."""
        return next((d for d in self.drives if d.id == drive), None)

    def link(self, link: LinkId) -> LinkSpec | None:
        """Return the link of that name, or None."""
        return next((spec for spec in self.links if spec.id == link), None)

    def catalogue_of(self, drive: DriveUnit) -> Catalogue:
        """Return the catalogue of a drive's model, an empty one if there is none."""
        return next((c for c in self.catalogues if c.model == drive.model), UNKNOWN_MODEL)

    def drives_on(self, link: LinkId) -> tuple[DriveUnit, ...]:
        """Return the drives of an HI line."""
        return tuple(d for d in self.drives if d.link == link)
