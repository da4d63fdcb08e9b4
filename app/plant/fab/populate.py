"""Vehicles and carriers for a generated plant."""

from collections.abc import Iterator
from dataclasses import replace
from random import Random

from app.domain.ids import CarrierId, DevId, VehicleId
from app.domain.layout import Axis, AxisLimits, Plant, PulseSet, StationKind, VehicleSpec
from app.domain.units import Barcode, Millimetres, Pulses
from app.plant.fab.chains import chains, degrees

VEHICLE_LENGTH = Millimetres(950)
"""Shorter than every edge that is generated, so that a standing vehicle covers its own barcode alone. Our choice."""
LIMITS = AxisLimits(
    **{
        axis.value: (Pulses(low), Pulses(high))
        for axis, low, high in ((Axis.SHFT, -10_000, 10_000), (Axis.ROTA, -5000, 5000), (Axis.LIFT, 0, 60_000))
    }
)
FIRST_PORT, PORTS = 20_001, 10_000
"""TCP ports of the simulated vehicles: one each, below the range that Linux takes outgoing ports from. Our choice."""


def populate(plant: Plant, vehicles: int, seed: int, carriers: float | int = 0) -> Plant:
    """Return the plant with so many hoists, evenly spread, and with carriers at ports drawn by chance.

    ``carriers`` is how many, or, as a float, the share of ports that are full. A vehicle starts where it neither stands in
    a merge or diverge nor fills a buffer: each keeps its first barcode free, so nobody starts half way of a lane change.
    Raises: ValueError: there is no room for so many.
    """
    random = Random(seed)
    ports = [station for station in plant.stations if station.kind is StationKind.PORT]
    full = round(carriers * len(ports)) if isinstance(carriers, float) else carriers
    if not 0 <= full <= len(ports):
        raise ValueError(f"{full} carriers do not fit {len(ports)} ports")
    starts = _starts(plant, vehicles, random)
    chosen = sorted(random.sample(range(len(ports)), full))
    return replace(
        plant,
        vehicles=tuple(_hoist(i, start, random) for i, start in enumerate(starts, 1)),
        carriers=tuple((CarrierId(f"FOUP{i:05d}"), ports[port].id) for i, port in enumerate(chosen, 1)),
    )


def _starts(plant: Plant, count: int, random: Random) -> list[Barcode]:
    free = list(_free(plant))
    if not 0 <= count <= len(free):
        raise ValueError(f"{count} vehicles do not fit: {len(free)} barcodes may be started from")
    offset = random.random()
    return [free[int((i + offset) * len(free) / count)] for i in range(count)]


def _free(plant: Plant) -> Iterator[Barcode]:
    """Give every barcode that a vehicle may start from, buffer by buffer."""
    into, out = degrees(plant)
    for chain in chains(plant):
        yield from (barcode for barcode in chain[1:] if into[barcode] == 1 and out[barcode] == 1)


def _hoist(number: int, start: Barcode, random: Random) -> VehicleSpec:
    host, port = divmod(number - 1, PORTS)
    offset = PulseSet(*(Pulses(random.randint(-most, most)) for most in (20, 8, 150)))
    return VehicleSpec(
        id=VehicleId(f"V{number:04d}"),
        dev_id=DevId(number),
        host=f"127.0.0.{host + 1}",
        port=FIRST_PORT + port,
        length=VEHICLE_LENGTH,
        limits=LIMITS,
        offset=offset,
        start=start,
    )
