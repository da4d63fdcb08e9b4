"""The fast plant beside the byte-level one: same fab, same starts, same transfers in the same order."""

from collections.abc import Sequence
from random import Random
from typing import NamedTuple

from app.domain.ids import Actor, CarrierId, JobId, StationId
from app.domain.layout import Plant, Station, StationKind
from app.domain.requests import CreateJob
from app.domain.units import Seconds
from app.planning.track import Track
from app.protocols.itsc.simulator import Options
from app.protocols.itsc.simulator.transfer import TRANSFERS
from app.sim.kinematic.fab import Fab
from app.sim.kinematic.fab import Plant as How
from app.sim.kinematic.network import draw
from app.sim.truth import Act, Deed
from app.sim.world import World

DWELL = 10.0
"""Seconds at a port, for picking up or putting down."""


class Order(NamedTuple):
    """A transfer between two ports; ``carrier`` stands at the source."""

    source: Station
    destination: Station
    carrier: CarrierId


class Ran(NamedTuple):
    """When each transfer of one plant was delivered, in virtual seconds: in the byte-level one as its gripper opens."""

    delivered: tuple[float, ...]

    def per_hour(self, begin: float, end: float) -> float:
        """Return deliveries per hour between two times."""
        return sum(begin < at <= end for at in self.delivered) * 3600 / (end - begin)


def orders(plant: Plant, seed: int) -> list[Order]:
    """Return transfers from every full port to an empty one, in an order drawn from the seed. No port is in two of them."""
    at = {station: carrier for carrier, station in plant.carriers}
    ports = [station for station in plant.stations if station.kind is StationKind.PORT]
    Random(f"{seed}/agreement").shuffle(ports)
    full, empty = [p for p in ports if p.id in at], [p for p in ports if p.id not in at]
    return [Order(source, to, at[source.id]) for source, to in zip(full, empty, strict=False)]


def to_the_byte(plant: Plant, seed: int, work: Sequence[Order], backlog: int, seconds: float) -> Ran:
    """Run controller and simulated hoists; as many orders are open as there are vehicles, and ``backlog`` more."""
    steps = {len(transfer.steps) for transfer in TRANSFERS.values() if transfer.kind is StationKind.PORT}
    world = World(plant, seed, options=Options(step_time=Seconds(DWELL / max(steps))))
    left = iter(enumerate(work, 1))
    delivered: list[float] = []

    def acted(act: Act) -> None:
        if act.deed is Deed.PUT:
            delivered.append(world.now)

    def look() -> None:
        ordered = len(world.replies)
        completed = sum(state.terminal for state in world.books.jobs.values())
        for _ in range(len(plant.vehicles) + backlog - (ordered - completed)):
            if (following := next(left, None)) is not None:
                world.ask(_request(*following))
        world.agenda.after(1.0, look)

    world.acted = acted
    world.agenda.after(1.0, look)
    world.run(seconds)
    if world.oracle.violations:
        raise LookupError(f"the byte-level plant broke a rule: {world.oracle.violations[0]}")
    return Ran(tuple(delivered))


def _request(number: int, order: Order) -> CreateJob:
    source, destination = StationId(order.source.id), StationId(order.destination.id)
    return CreateJob(
        actor=Actor("host"),
        job=JobId(f"J{number:06d}"),
        source=source,
        destination=destination,
        carrier=order.carrier,
        priority=50,
        fingerprint=f"{source}/{destination}",
    )


class Listed:
    """Ports whose transfers are given, in their order."""

    def __init__(self, plant: Plant, number: dict[str, int], work: Sequence[Order]) -> None:
        self.barcodes = [number[station.barcode] for station in plant.stations]
        index = {station.id: i for i, station in enumerate(plant.stations)}
        self._left = iter([(index[o.source.id], index[o.destination.id]) for o in work])

    def draw(self) -> tuple[int, int] | None:
        """Return the next transfer; None: there is none left."""
        return next(self._left, None)

    def emptied(self, port: int) -> None:
        """No port is used twice."""

    def filled(self, port: int) -> None:
        """No port is used twice."""


def fast(plant: Plant, seed: int, work: Sequence[Order], backlog: int, seconds: float) -> Ran:
    """Run the fast plant with the plant file's vehicle, static ways and nobody kept back, as the controller does by itself.

    ``backlog`` orders wait for a vehicle.
    """
    spec = plant.vehicles[0]
    plan = draw(Track(plant), spec)
    starts = [v.start for v in plant.vehicles if v.start is not None]
    how = How(backlog=backlog, dwell=DWELL, reweigh=0.0, restraint=False)
    listed = Listed(plant, {str(b): i for b, i in plan.number.items()}, work)
    run = Fab(plan, spec, [s.barcode for s in plant.stations], starts, seed, how, listed)
    run.run(seconds)
    return Ran(tuple(d.at for d in run.delivered))
