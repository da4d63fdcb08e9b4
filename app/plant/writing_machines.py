"""Vehicles, links and equipment as they stand in a plant file."""

from collections.abc import Iterator, Sequence

from app.domain.layout import (
    ChargingRules,
    DoorSpec,
    DriveUnit,
    LinkSpec,
    OnEmergency,
    Plant,
    PulseSet,
    SerialPort,
    VehicleKind,
    VehicleSpec,
)
from app.plant.written import Value, address, entries, flow, mark, quoted, word

AGV_FIGURES = ("length", "max_speed", "curve_speed", "acceleration", "braking", "reach")
HOIST_FIGURES = ("length", "max_count", "max_speed", "curve_speed", "acceleration", "braking", "reach")
_PARITY = {"N": "none", "E": "even", "O": "odd"}


def vehicles(plant: Plant) -> Iterator[list[str]]:
    """Give the sections about vehicles: what the first of each kind has is written as what holds for all."""
    hoists = [vehicle for vehicle in plant.vehicles if vehicle.kind is VehicleKind.HOIST]
    agvs = [vehicle for vehicle in plant.vehicles if vehicle.kind is VehicleKind.AGV]
    usual = {VehicleKind.HOIST: _usual(hoists), VehicleKind.AGV: _usual(agvs)}
    for name, figures in (("vehicle_defaults", usual[VehicleKind.HOIST]), ("agv_defaults", usual[VehicleKind.AGV])):
        yield entries(name, (f"{what}: {value}" for what, value in figures.items()))
    yield entries("vehicles", (_vehicle(plant, vehicle, usual[vehicle.kind]) for vehicle in plant.vehicles))


def _usual(vehicles: Sequence[VehicleSpec]) -> dict[str, Value]:
    return _figures(vehicles[0]) if vehicles else {}


def _figures(vehicle: VehicleSpec) -> dict[str, Value]:
    if vehicle.kind is VehicleKind.AGV:
        return {name: getattr(vehicle, name) for name in AGV_FIGURES}
    axes = zip(("shft", "rota", "lift"), (vehicle.limits.shft, vehicle.limits.rota, vehicle.limits.lift), strict=True)
    limits = flow({axis: f"[{low}, {high}]" for axis, (low, high) in axes})
    return {**{name: getattr(vehicle, name) for name in HOIST_FIGURES}, "limits": limits}


def _vehicle(plant: Plant, vehicle: VehicleSpec, usual: dict[str, Value]) -> str:
    own = {name: value for name, value in _figures(vehicle).items() if value != usual[name]}
    wire: dict[str, Value | None] = (
        {"kind": "agv", "link": word(vehicle.link or ""), "dev_id": vehicle.dev_id}
        if vehicle.kind is VehicleKind.AGV
        else _hoists_wire(vehicle)
    )
    given: dict[str, Value | None] = {
        **wire,
        "start": None if vehicle.start is None else mark(vehicle.start),
        "offset": _pulses(vehicle.offset),
        "reference": "true" if vehicle.id in plant.reference_vehicles else None,
        "in_service": None if vehicle.in_service else "false",
        **own,
    }
    return f"{word(vehicle.id)}: {flow(given)}"


def _hoists_wire(vehicle: VehicleSpec) -> dict[str, Value | None]:
    return {
        "dev_id": vehicle.dev_id,
        "listen": "true" if vehicle.listen else None,
        "address": quoted(address(vehicle.host, vehicle.port)) if vehicle.host else None,
        "dialect": word(vehicle.dialect) if vehicle.dialect != "default" else None,
    }


def _pulses(pulses: PulseSet | None) -> str | None:
    return flow({"shft": pulses.shft, "rota": pulses.rota, "lift": pulses.lift}) if pulses else None


def equipment(plant: Plant) -> Iterator[list[str]]:
    """Give the sections about links and what is on them, and about charging."""
    yield entries("links", map(_link, plant.links))
    yield entries("doors", map(_door, plant.doors))
    numbered = (f"{word(b.id)}: {flow({'link': word(b.link), 'number': b.number})}" for b in plant.buffers)
    yield entries("buffers", numbered)
    yield entries(
        "chargers",
        (
            f"{word(c.id)}: {flow({'at': mark(c.barcode), 'alias': None if c.alias is None else word(c.alias)})}"
            for c in plant.chargers
        ),
    )
    yield _charging(plant.charging)
    yield entries("drives", map(_drive, plant.drives))


def _link(link: LinkSpec) -> str:
    given: dict[str, Value | None] = {
        "protocol": link.wire.value,
        "address": quoted(address(link.host, link.port)) if link.serial is None else None,
        "serial": _serial(link.serial) if link.serial is not None else None,
        "dialect": flow({name: _switch(value) for name, value in link.dialect.items()}) if link.dialect else None,
    }
    return f"{word(link.id)}: {flow(given)}"


def _switch(value: object) -> str:
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(_switch, value))}]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{quoted(str(key))}: {_switch(item)}" for key, item in value.items()) + "}"
    return "null" if value is None else str(value)


def _serial(port: SerialPort) -> str:
    framing: dict[str, Value | None] = {
        "device": quoted(port.device),
        "baud": port.baud,
        "data_bits": port.data_bits,
        "parity": _PARITY[port.parity],
        "stop_bits": port.stop_bits,
    }
    return flow(framing)


def _door(door: DoorSpec) -> str:
    pairs = ", ".join(f"[{mark(start)}, {mark(end)}]" for start, end in sorted(door.passages))
    given: dict[str, Value | None] = {
        "link": word(door.link),
        "number": door.number,
        "through": f"[{pairs}]",
        "normally_open": "true" if door.normally_open else None,
        "on_emergency": door.on_emergency.value if door.on_emergency is not OnEmergency.LEAVE else None,
    }
    return f"{word(door.id)}: {flow(given)}"


def _drive(drive: DriveUnit) -> str:
    given: dict[str, Value | None] = {
        "link": word(drive.link),
        "id": drive.address,
        "model": quoted(drive.model) if drive.model else None,
        "name": quoted(drive.name) if drive.name not in ("", drive.id) else None,
    }
    return f"{word(drive.id)}: {flow(given)}"


def _charging(rules: ChargingRules) -> list[str]:
    if rules == ChargingRules():
        return []
    windows = ", ".join(quoted(f"{_time(start)}-{_time(end)}") for start, end in rules.windows)
    given: dict[str, Value | None] = {
        "trips": rules.trips,
        "after": None if rules.after is None else f"{rules.after:.0f}",
        "lasting": f"{rules.lasting:.0f}",
        "windows": f"[{windows}]" if windows else None,
    }
    return [f"charging: {flow(given)}"]


def _time(minutes: int) -> str:
    return f"{minutes // 60:02d}:{minutes % 60:02d}"
