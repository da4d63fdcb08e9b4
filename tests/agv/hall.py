"""Small AGV halls, and a virtual world around one."""

from collections.abc import Callable, Sequence

import networkx as nx

from app.domain.devices import AliasName, DeviceId
from app.domain.ids import Actor, CarrierId, DevId, JobId, LinkId, StationId, VehicleId
from app.domain.job import JobState
from app.domain.layout import (
    ChargerSpec,
    ChargingRules,
    Edge,
    LinkSpec,
    Plant,
    Point,
    Station,
    StationKind,
    VehicleKind,
    VehicleSpec,
    Wire,
)
from app.domain.requests import CreateJob, Reply, Request
from app.domain.units import Barcode, Millimetres
from app.domain.view import Topic, VehicleView
from app.fleet.vehicle import VehicleNow
from app.protocols.enig.simulator import SimulatedAgv
from app.sim.world import World

HALL = LinkId("HALL")
A1, A2, A3 = VehicleId("A1"), VehicleId("A2"), VehicleId("A3")
HOST, ANNA = Actor("host"), Actor("anna")
STEP = 0.05
PIECE = 2000
"""Millimetres between two tags."""


def tag(number: int) -> Barcode:
    """Return a tag's text."""
    return Barcode(f"{number:04d}")


def edges(ways: Sequence[str], *, two_way: bool, length: int = PIECE) -> list[Edge]:
    """Return the pieces of ways such as ``1-2-3``."""
    pairs = [
        (tag(int(a)), tag(int(b))) for way in ways for a, b in zip(way.split("-"), way.split("-")[1:], strict=False)
    ]
    found = [Edge(a, b, Millimetres(length)) for a, b in pairs]
    return found + ([Edge(b, a, Millimetres(length)) for a, b in pairs] if two_way else [])


def agv(number: int, start: int) -> VehicleSpec:
    """Return AGV 1, 2 ... of the hall's link, on a tag."""
    return VehicleSpec(
        VehicleId(f"A{number}"),
        DevId(10 + number),
        length=Millimetres(1200),
        max_speed=Millimetres(500),
        acceleration=Millimetres(500),
        braking=Millimetres(500),
        start=tag(start),
        kind=VehicleKind.AGV,
        link=HALL,
    )


def hall(
    *,
    two_way: Sequence[str] = (),
    one_way: Sequence[str] = (),
    stations: Sequence[int],
    starts: Sequence[int],
    carts: int,
    parks: Sequence[int] = (),
    chargers: Sequence[int] = (),
    rules: ChargingRules = ChargingRules(),  # noqa: B008  (frozen)
) -> Plant:
    """Return a hall: a buffer ``B`` and its tag's number at each station, carts at the first ones."""
    track = [*edges(two_way, two_way=True), *edges(one_way, two_way=False)]
    tags = sorted({barcode for edge in track for barcode in (edge.start, edge.end)})
    plan = nx.planar_layout(nx.Graph((edge.start, edge.end) for edge in track), scale=100_000)
    places = [Station(StationId(f"B{n}"), StationKind.AGV_BUFFER, tag(n)) for n in stations]
    return Plant(
        name="hall",
        points=tuple(
            Point(t, Millimetres(int(plan[t][0])), Millimetres(int(plan[t][1])), int(t) in parks) for t in tags
        ),
        edges=tuple(track),
        stations=tuple(places),
        vehicles=tuple(agv(i, start) for i, start in enumerate(starts, 1)),
        carriers=tuple((CarrierId(f"CART{i}"), place.id) for i, place in enumerate(places[:carts], 1)),
        links=(LinkSpec(HALL, Wire.ENIG),),
        chargers=tuple(ChargerSpec(DeviceId(f"CH{i}"), tag(n), AliasName(f"C{i}")) for i, n in enumerate(chargers, 1)),
        charging=rules,
    )


def line() -> Plant:
    """Return a two-way line 1-2-3-4-5 with buffers at both ends and one AGV in the middle."""
    return hall(two_way=["1-2-3-4-5"], stations=[1, 5], starts=[3], carts=1)


class HallWorld(World):
    """A world with an AGV hall."""

    def __init__(self, plant: Plant | None = None, seed: int = 1) -> None:
        super().__init__(plant or line(), seed)

    def reply(self, request: Request) -> Reply:
        """Ask, and wait for the reply."""
        ticket = self.ask(request)
        self.replies.pop(ticket, None)  # of an earlier life
        self.until(lambda: ticket in self.replies)
        return self.replies[ticket]

    def order(self, source: str, destination: str, job: str = "J1", vehicle: str | None = None) -> Reply:
        """Order a transfer."""
        wish = VehicleId(vehicle) if vehicle else None
        return self.reply(CreateJob(HOST, JobId(job), source, StationId(destination), None, 50, job, vehicle=wish))

    def until(self, condition: Callable[[], bool], at_most: float = 180.0) -> None:
        """Let time pass until something is so."""
        end = self.now + at_most
        while not condition():
            assert self.now < end, f"it does not happen: {self.said()}"
            self.run(self.now + STEP)

    def said(self) -> dict[str, object]:
        """Return what explains that nothing happens."""
        vehicles = self.control.fleet.books.vehicles.values()
        waits: dict[str, object] = {v.id: (v.barcode, v.stage.value, v.waiting or v.barred, v.errand) for v in vehicles}
        return {**waits, "jobs": {j.id: (j.leg.value, j.reason) for j in self.control.fleet.books.jobs.values()}}

    def pass_by(self, seconds: float) -> None:
        """Let time pass."""
        self.run(self.now + seconds)

    def agv(self, vehicle: VehicleId = A1) -> SimulatedAgv:
        """Return a simulated AGV for somebody to lay hands on; what that leads to is noticed right after."""
        self.agenda.after(0.0, self._cables[HALL].flush_device)
        return self.floor.halls.agvs[vehicle]

    def now_of(self, vehicle: VehicleId = A1) -> VehicleNow:
        """Return what the controller knows of an AGV."""
        return self.control.fleet.books.vehicles[vehicle]

    def view(self, vehicle: VehicleId = A1) -> VehicleView:
        """Return how an AGV is shown."""
        found = {u.key: u.value for u in self.control.snapshot() if u.topic is Topic.VEHICLES}
        value = found[vehicle]
        assert isinstance(value, VehicleView)
        return value

    def ready(self, *vehicles: VehicleId) -> None:
        """Wait until AGVs are settled."""
        for vehicle in vehicles or (A1,):
            self.until(lambda vehicle=vehicle: self.now_of(vehicle).fit)  # type: ignore[misc]

    def ends(self, job: str = "J1", at_most: float = 300.0) -> JobState:
        """Wait for a job's end, and return it."""
        self.until(lambda: job in self.books.jobs and self.books.jobs[job].terminal, at_most)
        return self.books.jobs[job]
