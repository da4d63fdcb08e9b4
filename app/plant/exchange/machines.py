"""The vehicles of an imported plant: those that the layout names, and simulated ones to try it with."""

from collections import deque
from collections.abc import Iterator
from dataclasses import replace
from math import isfinite

from app.domain.ids import DevId, LinkId, VehicleId
from app.domain.layout import NO_OFFSET, LinkSpec, Plant, VehicleKind, VehicleSpec, Wire
from app.domain.units import Barcode, Millimetres
from app.plant.exchange.draft import Draft, Machine
from app.plant.exchange.naming import ids_of
from app.plant.exchange.report import Report, shown
from app.plant.fab.chains import degrees
from app.plant.names import address
from app.protocols.enig.dialects import Dialect

FLOOR = "hall"
"""The name of the link over which AGVs are reached."""
TEXT_BARCODES = "text-barcodes"
"""The name of the dialect for barcodes that are no numbers."""
FIRST_PORT, FIRST_LINK_PORT = 17_101, 17_001
"""TCP ports of this machine where what has no address yet is simulated: one each, below 32768. Our choice."""
MOST = 2_000
"""Most vehicles that are made up. Our choice."""
_AGV_NUMBERS = Dialect().agv_ids
_HALL = VehicleSpec(
    VehicleId(""),
    DevId(0),
    kind=VehicleKind.AGV,
    length=Millimetres(1000),
    max_speed=Millimetres(500),
    curve_speed=Millimetres(500),
    acceleration=Millimetres(500),
    braking=Millimetres(500),
)
_RAIL = VehicleSpec(VehicleId(""), DevId(0))


def crew(
    plant: Plant,
    draft: Draft,
    barcodes: dict[str, Barcode],
    kind: VehicleKind,
    more: int,
    top: float | None,
    taken: set[str],
    report: Report,
    *,
    text: bool,
) -> Plant:
    """Return the plant with its vehicles, and ``more`` simulated ones, and say what they still need.

    ``top`` is their speed in mm/s, ``taken`` are names that other things have, ``text``: barcodes are no numbers.
    """
    machines = [*draft.machines, *_made_up(draft, kind, more, report)]
    agvs = kind is VehicleKind.AGV
    names = ids_of(((machine.name, machine.where) for machine in machines), taken, "V", report)
    usual = _usual(kind, machines, top)
    starts = _starts(plant, machines, barcodes, usual.length, report)
    specs = [_spec(names[m.name], m, usual, start) for m, start in zip(machines, starts, strict=True)]
    if machines:
        _note_distances(plant, usual, report)
    plant = _linked(plant, specs, report) if agvs else _addressed(plant, machines, specs, report, text=text)
    _note_needs(plant, kind, report)
    return plant


def _made_up(draft: Draft, kind: VehicleKind, more: int, report: Report) -> Iterator[Machine]:
    known = {machine.name for machine in draft.machines}
    free = (f"{'V' if kind is VehicleKind.HOIST else 'AGV'}{number:03d}" for number in range(1, MOST + len(known) + 1))
    for name, _ in zip((name for name in free if name not in known), range(min(more, MOST)), strict=False):
        yield Machine(name, "--vehicles", offset=NO_OFFSET if kind is VehicleKind.HOIST else None)
    if more > MOST:
        report.wrong("--vehicles", f"at most {MOST} are made up")


def _usual(kind: VehicleKind, machines: list[Machine], top: float | None) -> VehicleSpec:
    """Return what holds for a vehicle of which nothing else is said."""
    usual = _HALL if kind is VehicleKind.AGV else _RAIL
    if top:
        speed = Millimetres(max(1, min(100_000, round(top))))
        usual = replace(usual, max_speed=speed, curve_speed=Millimetres(min(usual.curve_speed, speed)))
    lengths = [machine.length for machine in machines if machine.length and isfinite(machine.length)]
    if lengths:
        usual = replace(usual, length=Millimetres(max(1, min(100_000, round(max(lengths))))))
    return usual


def _spec(name: str, machine: Machine, usual: VehicleSpec, start: Barcode | None) -> VehicleSpec:
    spec = replace(usual, id=VehicleId(name), start=start, dev_id=DevId(machine.dev_id or 0), offset=machine.offset)
    if machine.velocity and isfinite(machine.velocity):
        speed = Millimetres(max(1, min(100_000, round(machine.velocity))))
        spec = replace(spec, max_speed=speed, curve_speed=Millimetres(min(spec.curve_speed, speed)))
    return spec


def _note_distances(plant: Plant, usual: VehicleSpec, report: Report) -> None:
    """Say by which figures vehicles are kept apart where the file has none: nobody is to find that out on the rail."""
    what = (
        f"vehicles are {usual.length} mm long, drive up to {usual.max_speed} mm/s and brake with {usual.braking} mm/s²"
    )
    report.assumed("", f"{what} where the file does not say", "write what is true under vehicle_defaults")
    if not plant.clearance:
        report.assumed(
            "", "clearance is 0: tracks side by side do not exclude each other", "write it, in mm, as clearance"
        )


# -- where they begin -------------------------------------------------------------------------------------------------


def _starts(
    plant: Plant, machines: list[Machine], barcodes: dict[str, Barcode], length: Millimetres, report: Report
) -> list[Barcode | None]:
    """Return a start for each: the layout's own, or places for the simulated ones, spread and out of each other's way."""
    near = _Neighbourhood(plant, length)
    chosen: dict[int, Barcode] = {}
    for i, machine in enumerate(machines):
        if machine.start is None:
            continue
        if machine.start not in barcodes:
            report.wrong(machine.where, f"starts at {shown(machine.start)}, which is nowhere given")
        elif near.take(barcodes[machine.start]):
            chosen[i] = barcodes[machine.start]
        else:
            report.wrong(machine.where, f"starts at {shown(machine.start)}, where another vehicle stands")
    rest = [i for i in range(len(machines)) if i not in chosen]
    free = _candidates(plant)
    for turn, i in enumerate(rest):
        from_here = turn * len(free) // len(rest)
        order = (*free[from_here:], *free[:from_here])
        start = next((barcode for barcode in order if near.take(barcode)), None)
        if start is None:
            what = "no barcode is free where it could start, reached and left by track, with its length around"
            report.needed(machines[i].where, f"{shown(machines[i].name)}: {what}", "give start, or fewer vehicles")
        else:
            chosen[i] = start
    return [chosen.get(i) for i in range(len(machines))]


def _candidates(plant: Plant) -> list[Barcode]:
    """Return where a vehicle may start: parking places, or any barcode between merges and diverges, or any."""
    into, out = degrees(plant)
    reached = [point for point in plant.points if into[point.barcode] and out[point.barcode]]
    parks = [point.barcode for point in reached if point.park]
    plain = [p.barcode for p in reached if into[p.barcode] == 1 and out[p.barcode] == 1 and not p.park]
    known = {*parks, *plain}
    rest = [point.barcode for point in reached if point.barcode not in known]
    closed = {barcode for zone in plant.zones for barcode in zone.barcodes}
    ordered = [*parks, *plain] if len(plain) > len(parks) else [*parks, *plain, *rest]
    return [barcode for barcode in ordered if barcode not in closed]


class _Neighbourhood:
    """Which barcodes are still free of others within a vehicle's length, along the track either way."""

    def __init__(self, plant: Plant, length: Millimetres) -> None:
        self._length = length
        self._taken: set[Barcode] = set()
        self._around: dict[Barcode, list[tuple[Barcode, int]]] = {point.barcode: [] for point in plant.points}
        for edge in plant.edges:
            self._around[edge.start].append((edge.end, edge.length))
            self._around[edge.end].append((edge.start, edge.length))

    def take(self, barcode: Barcode) -> bool:
        """Whether a vehicle may stand here; then the barcodes around are no longer free."""
        if barcode in self._taken:
            return False
        queue, ways = deque([barcode]), {barcode: 0}
        while queue:
            here = queue.popleft()
            for other, length in self._around[here]:
                way = ways[here] + length
                if way <= self._length and way < ways.get(other, way + 1):
                    ways[other] = way
                    queue.append(other)
        self._taken.update(ways)
        return True


# -- how they are reached ---------------------------------------------------------------------------------------------


def _linked(plant: Plant, specs: list[VehicleSpec], report: Report) -> Plant:
    links, placed = [], []
    for i, spec in enumerate(specs):
        block, number = divmod(i, len(_AGV_NUMBERS))
        if number == 0:
            name = LinkId(FLOOR if block == 0 else f"{FLOOR}-{block + 1}")
            links.append(LinkSpec(name, Wire.ENIG, port=FIRST_LINK_PORT + block))
            what = "a link at this machine, for simulation"
            report.needed(name, what, "write the real line's address, or serial:, under links")
        placed.append(replace(spec, link=links[-1].id, dev_id=DevId(_AGV_NUMBERS[number])))
        report.needed(spec.id, "the AGV's number on its link is made up", "write the real one as dev_id")
    return replace(plant, vehicles=tuple(placed), links=tuple(links))


def _addressed(plant: Plant, machines: list[Machine], specs: list[VehicleSpec], report: Report, *, text: bool) -> Plant:
    dialects: dict[str, dict[str, object]] = {}
    if text and specs:
        dialects = {TEXT_BARCODES: {"preset": "default", "barcode_format": "ascii"}}
        report.assumed("", "barcodes are no numbers, so vehicles speak a dialect of text barcodes", "see dialects")
        specs = [replace(spec, dialect=TEXT_BARCODES) for spec in specs]
    used = {machine.dev_id for machine in machines}
    free = (number for number in range(1, len(machines) + len(used) + 1) if number not in used)
    placed = []
    for i, (machine, spec) in enumerate(zip(machines, specs, strict=True)):
        if machine.dev_id is None:
            spec = replace(spec, dev_id=DevId(next(free)))
            report.needed(spec.id, "the vehicle's number is made up", "write the real one as dev_id")
        host, port = _reached(machine, spec, FIRST_PORT + i, report)
        placed.append(replace(spec, host=host, port=port))
    return replace(plant, vehicles=tuple(placed), dialects=dialects)


def _reached(machine: Machine, spec: VehicleSpec, port: int, report: Report) -> tuple[str, int]:
    if machine.address:
        try:
            host, given = address(machine.address)
        except ValueError as wrong:
            report.wrong(machine.where, str(wrong), "write HOST:PORT")
        else:
            if given:
                return host, given
            report.wrong(machine.where, f"{shown(machine.address)} has no port", "write HOST:PORT")
    report.needed(spec.id, "an address at this machine, for simulation", "write the real one as address: HOST:PORT")
    return "127.0.0.1", port


def _note_needs(plant: Plant, kind: VehicleKind, report: Report) -> None:
    if not plant.vehicles:
        what = "vehicles: name, dev_id and address" if kind is VehicleKind.HOIST else "vehicles: name, link and dev_id"
        report.needed("", what, "under vehicles; --vehicles N makes simulated ones up")
    if not plant.stations:
        report.needed("", "stations: where carriers are taken and put down", "under stations")
    if not any(point.park for point in plant.points):
        report.needed("", "parking: where idle vehicles may wait", "a list of barcodes under parking")
    for vehicle in plant.hoists:
        if vehicle.offset is None:
            report.needed(
                vehicle.id, "the vehicle's offset is not known", "teach it (docs/teaching.md), or give offset"
            )
    untaught = [s.id for s in plant.stations if s.kind.value == "port" and s.dest is None]
    for name in untaught:
        report.needed(name, "the port's target pulses are not known", "teach it (docs/teaching.md), or give dest")
