"""The plant file as typed structs: what may stand where, and the JSON schema for editors."""

import json
from dataclasses import fields
from enum import StrEnum
from inspect import cleandoc
from typing import Annotated, Any

import msgspec
from msgspec import UNSET, Meta, UnsetType

from app.domain.layout import OVERDUE, OnEmergency, StationKind, VehicleKind, Wire
from app.protocols.itsc.dialects import DIALECTS, Dialect


def _number(what: str, unit: str, low: int, high: int) -> Meta:
    return Meta(ge=low, le=high, description=what, extra={"unit": unit})


MAX_LENGTH = 10_000_000
"""Longest stretch of track in mm, 10 km. Our choice."""

Coordinate = Annotated[int, _number("Position on the plan, mm; x to the right, y downwards", "mm", -(10**9), 10**9)]
Length = Annotated[int, _number("Length along the track, mm", "mm", 1, MAX_LENGTH)]
Distance = Annotated[int, _number("Distance, mm", "mm", 0, MAX_LENGTH)]
Speed = Annotated[int, _number("Speed, percent of the vehicle's own maximum (PROTOCOLS 1.6)", "percent", 1, 100)]
Velocity = Annotated[int, _number("Speed, mm/s", "mm/s", 1, 100_000)]
Acceleration = Annotated[int, _number("Acceleration, mm/s²", "mm/s²", 1, 100_000)]
Area = Annotated[int, _number("Obstacle-sensor or look-down area, defined by the vehicle's maker (I49)", "", 0, 15)]
Axis = Annotated[int, _number("Axis position, pulses, signed 32 bit", "pulses", -(1 << 31), (1 << 31) - 1)]
Count = Annotated[int, _number("Number of vehicles", "vehicles", 1, 10_000)]
Elements = Annotated[int, _number("Most path elements in one MOVE (I47)", "path elements", 2, 65_535)]
Identity = Annotated[int, _number("DEV_ID on the wire, unsigned 32 bit (I22)", "", 0, (1 << 32) - 1)]
Baud = Annotated[int, _number("Speed of a serial line, bits per second", "bit/s", 300, 4_000_000)]
Bits = Annotated[int, _number("Data bits of a character", "bits", 5, 8)]
StopBits = Annotated[int, _number("Stop bits of a character", "bits", 1, 2)]
Byte = Annotated[int, _number("DeviceType on the wire (PROTOCOLS 3.2)", "", 0, 255)]
DriveId = Annotated[int, _number("A drive's id on its line (PROTOCOLS 2.2)", "", 1, 15)]
Trips = Annotated[int, _number("Transfers of one AGV", "transfers", 1, 100_000)]
Time = Annotated[int, _number("Time, seconds", "s", 1, 10_000_000)]
TimeOrNever = Annotated[int, _number("Time, seconds; 0: never", "s", 0, 10_000_000)]
SHARE, PATIENCE = 0.35, 60
"""Of a soft zone that does not say otherwise (TRAFFIC section 4)."""
Share = Annotated[float, Meta(ge=0.01, le=1.0, description="A share of the whole, 0.01 to 1")]
Code = Annotated[int, _number("Code as it stands on the wire or in an event", "", 0, (1 << 32) - 1)]

Mark = Annotated[
    int | str, Meta(description="A barcode of the rail: a number or text; 1001..1020 where a list is asked for")
]
Address = Annotated[str, Meta(description="HOST:PORT; with `listen: true` the HOST that the vehicle comes from")]
Name = Annotated[str, Meta(description="A name of this file")]
Text = Annotated[str, Meta(description="Text for people")]


class Strict(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A mapping with known keys only."""


class Straight(Strict, frozen=True):
    """A range of barcodes evenly spaced on a straight line, the first at `from`, the last at `to`."""

    start: tuple[Coordinate, Coordinate] = msgspec.field(name="from")
    end: tuple[Coordinate, Coordinate] = msgspec.field(name="to")


class Run(Strict, frozen=True):
    """One-way track through these barcodes, in driving direction; each neighbouring pair is one edge.

    `length` is the length of each edge in mm (default: the distance of the positions), `speed` the limit in percent,
    `sensor` the obstacle-sensor area 0-15, `curve` limits the vehicle to its curve speed.
    """

    through: Annotated[list[Mark], Meta(min_length=1)]
    speed: Speed = 100
    sensor: Area = 0
    curve: bool = False
    length: Length | UnsetType = UNSET


class Pulses(Strict, frozen=True):
    """Positions of the three taught axes, in pulses."""

    shft: Axis
    rota: Axis
    lift: Axis


class Limits(Strict, frozen=True):
    """Lowest and highest pulses per axis that may be sent to the vehicle, inclusive."""

    shft: tuple[Axis, Axis]
    rota: tuple[Axis, Axis]
    lift: tuple[Axis, Axis]


class Station(Strict, frozen=True):
    """A place for one carrier, reached by standing at barcode `at`.

    `look_down` (LKDN 0-15) and `speed` (SPD 1-100) go into INST_PORT and INST_SBUF. `dest` are the target pulses before
    teaching (ports only). `display` is the name on the vehicle, at most 16 characters (default: the station's own name).
    `fallbacks` are stations for a carrier that cannot be put here, in order. Of an AGV buffer, `buffer` names the device that
    is locked while the station is served, and `alias` is its name on the wire, such as B1.
    """

    kind: StationKind
    at: Mark
    buffer: Name | UnsetType = UNSET
    alias: Text | UnsetType = UNSET
    look_down: Area = 0
    speed: Speed = 100
    dest: Pulses | UnsetType = UNSET
    display: Text = ""
    fallbacks: list[Name] = []


class Zone(Strict, frozen=True):
    """Barcodes that at most `capacity` vehicles may hold at once.

    `soft`: instead, no more than `share` of the vehicles that could queue there come in from outside; one that has waited
    `patience` seconds for that comes in all the same (a narrow spine; hoists only).
    `no_stop`: a vehicle enters only if it can leave again, or if its goal is inside (merges, crossings).
    """

    barcodes: Annotated[list[Mark], Meta(min_length=1)]
    capacity: Count = 1
    no_stop: bool = False
    soft: bool = False
    share: Share = SHARE
    patience: Time = PATIENCE
    name: Text = ""


class Parity(StrEnum):
    """The parity bit of a character."""

    NONE = "none"
    EVEN = "even"
    ODD = "odd"


class Serial(Strict, frozen=True):
    """A serial port of this machine and how its characters are framed; HI drives use 9600 bit/s without parity."""

    device: Text
    baud: Baud = 9600
    data_bits: Bits = 8
    parity: Parity = Parity.NONE
    stop_bits: StopBits = 1


class Link(Strict, frozen=True):
    """A line that carries several devices: `enig` for AGVs, doors and buffers, `hi` for the drives of one line.

    It is reached at `address` (a device, or a TCP serial server) or over `serial`. `dialect` are fields laid over the
    protocol's default dialect, or over the one that `preset` names.
    """

    protocol: Wire
    address: Address = ""
    serial: Serial | UnsetType = UNSET
    dialect: dict[str, Any] = {}


class Door(Strict, frozen=True):
    """A door across the track: vehicles pass the pieces of track in `through`, either way, only while it is open.

    A `normally_open` door is closed by people alone. `on_emergency` says what it does when a fire or an earthquake is told.
    """

    link: Name
    through: Annotated[list[tuple[Mark, Mark]], Meta(min_length=1)]
    number: Byte = 30
    normally_open: bool = False
    on_emergency: OnEmergency = OnEmergency.LEAVE


class Buffer(Strict, frozen=True):
    """A buffer with a lock; a station's `buffer` names it. `number` is 21 to 29 unless the dialect says otherwise."""

    link: Name
    number: Byte


class Charger(Strict, frozen=True):
    """A place where an AGV charges, at barcode `at`. `alias` is its name on the wire, such as C1."""

    at: Mark
    alias: Text | UnsetType = UNSET


class Charging(Strict, frozen=True):
    """When AGVs charge, as they report no battery level: after so many `trips`, or so many seconds `after` the last time.

    They stay `lasting` seconds at least. In `windows`, such as "12:00-12:30" (UTC), idle ones charge whatever they did.
    """

    trips: Trips | UnsetType = UNSET
    after: Time | UnsetType = UNSET
    lasting: Time = 600
    windows: list[Text] = []


class Traffic(Strict, frozen=True):
    """How hoists share the track.

    `restrain`: no more vehicles are given jobs at once than the track carries, found by how many of them stand: for a fleet of
    hundreds that may be larger than its track. The others stay idle, and give way.
    `congestion`: routes keep off track that is slow by the traffic on it; left out, they do unless `restrain` is given: a fleet
    that is kept back delivers more by ways that do not change.
    """

    restrain: bool = False
    congestion: bool | UnsetType = UNSET


class Idle(Strict, frozen=True):
    """What idle hoists do: with `park`, they go to a place under `parking` by where jobs began lately.

    They do so after they had nothing to do for `after` seconds, and go no farther than `farthest` seconds of driving.
    """

    park: bool = False
    after: Time = 20
    farthest: Time = 60


class Jobs(Strict, frozen=True):
    """What holds for transfer jobs.

    One that waits `overdue` seconds for what no driving puts right is an alarm: its source is empty or holds another carrier, its
    destination is occupied, a port is out of service, no vehicle can serve both. 0: never, where hosts order hours ahead.
    """

    overdue: TimeOrNever = int(OVERDUE)


class Drive(Strict, frozen=True):
    """An axis drive on an HI line; `model` names its catalogue of parameters, without which only raw access is possible."""

    link: Name
    id: DriveId
    model: Text = ""
    name: Text = ""


class AgvDefaults(Strict, frozen=True):
    """What holds for every AGV that does not say otherwise; without it AGVs drive 500 mm/s and cover 1000 mm."""

    length: Length | UnsetType = UNSET
    max_speed: Velocity | UnsetType = UNSET
    curve_speed: Velocity | UnsetType = UNSET
    acceleration: Acceleration | UnsetType = UNSET
    braking: Acceleration | UnsetType = UNSET
    reach: Distance | UnsetType = UNSET
    in_service: bool | UnsetType = UNSET


class VehicleDefaults(Strict, frozen=True):
    """What holds for every hoist that does not say otherwise.

    `length` is the stretch of rail that the vehicle covers behind the barcode it reports, safety margin included. `reach`
    is how far it may move by itself in MANT, both ways. `dialect` is a preset or a name of `dialects`.
    """

    dialect: Name | UnsetType = UNSET
    listen: bool | UnsetType = UNSET
    length: Length | UnsetType = UNSET
    max_count: Elements | UnsetType = UNSET
    max_speed: Velocity | UnsetType = UNSET
    curve_speed: Velocity | UnsetType = UNSET
    acceleration: Acceleration | UnsetType = UNSET
    braking: Acceleration | UnsetType = UNSET
    reach: Distance | UnsetType = UNSET
    limits: Limits | UnsetType = UNSET
    in_service: bool | UnsetType = UNSET


class Vehicle(VehicleDefaults, frozen=True, kw_only=True):
    """A vehicle. `start` is the barcode where the simulated one is put; `offset` its taught difference, in pulses.

    An AGV (`kind: agv`) is reached over its `link`, where `dev_id` is its number, 11 to 19 unless the dialect says otherwise.
    A `reference` vehicle has offset zero by declaration: what it teaches at a port is the port's DEST itself.
    """

    dev_id: Identity
    kind: VehicleKind = VehicleKind.HOIST
    link: Name | UnsetType = UNSET
    address: Address = ""
    offset: Pulses | UnsetType = UNSET
    start: Mark | UnsetType = UNSET
    reference: bool = False


class PlantFile(Strict, frozen=True):
    """A plant: track, stations, zones and vehicles. Lengths in mm, speeds of edges in percent of the vehicle's maximum."""

    barcodes: dict[str, tuple[Coordinate, Coordinate] | Straight]
    track: list[Run]
    name: Text = ""
    parking: list[Mark] = []
    clearance: Distance = 0
    stations: dict[str, Station] = {}
    zones: dict[str, Zone] = {}
    listen: Address = ""
    dialects: dict[str, dict[str, Any]] = {}
    links: dict[str, Link] = {}
    doors: dict[str, Door] = {}
    buffers: dict[str, Buffer] = {}
    chargers: dict[str, Charger] = {}
    charging: Charging = Charging()
    traffic: Traffic = Traffic()
    jobs: Jobs = Jobs()
    idle: Idle = Idle()
    drives: dict[str, Drive] = {}
    vehicle_defaults: VehicleDefaults = VehicleDefaults()
    agv_defaults: AgvDefaults = AgvDefaults()
    vehicles: dict[str, Vehicle] = {}
    carriers: dict[str, Name] = {}
    process_codes: dict[str, Text] = {}
    alarm_codes: dict[str, Text] = {}
    event_numbers: dict[str, Code] = {}


def schema() -> dict[str, Any]:
    """Return the JSON schema of a plant file."""
    made = msgspec.json.schema(PlantFile)
    for definition in made["$defs"].values():
        # Python before 3.13 keeps the indentation of docstrings, later ones do not.
        definition["description"] = cleandoc(definition["description"])
    made["$defs"]["PlantFile"]["properties"]["dialects"]["additionalProperties"] = _dialect_schema()
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "Hoistway plant file", **made}


def _dialect_schema() -> dict[str, Any]:
    known: dict[str, Any] = {field.name: {} for field in fields(Dialect)}
    known |= {name: {"enum": list(choices)} for name, choices in Dialect.CHOICES.items()}
    preset = {"description": "The dialect that the others are laid over", "enum": list(DIALECTS), "default": "default"}
    return {"type": "object", "properties": {"preset": preset, **known}, "additionalProperties": False}


def schema_text() -> str:
    """Return the JSON schema as ``plants/plant.schema.json`` holds it."""
    return json.dumps(schema(), indent=2, ensure_ascii=False) + "\n"
