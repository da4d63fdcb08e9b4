"""A vehicle that teaches, as the fleet hears it: events by hand, and what people decide."""

from dataclasses import replace

from app.domain.commands import Send, Simple
from app.domain.events import Taught, TeachingKind
from app.domain.ids import Actor, CmdId, StationId, VehicleId
from app.domain.layout import Axis, Plant, PulseSet
from app.domain.records import StationDest, VehicleOffset
from app.domain.teaching import Proposal, ProposalState, Side, TeachingSession
from app.domain.teaching_requests import ApproveProposal, OpenTeaching, RejectProposal
from app.domain.units import Barcode, Pulses
from app.fleet.targets import target_for
from tests.fleet.script import P1, V1, Script, small, words

KIM, LEE = Actor("kim"), Actor("lee")
MANT = words(mode=0)
CODES = {kind: 0x2070 + number for number, kind in enumerate(TeachingKind)}
V3, V7 = VehicleId("V3"), VehicleId("V7")


def pulses(shft: int, rota: int, lift: int) -> PulseSet:
    """Return three positions."""
    return PulseSet(Pulses(shft), Pulses(rota), Pulses(lift))


def plant_of_two(*, reference: bool = False) -> Plant:
    """Return the small plant with V3 at offset +40 and V7 at -20 on every axis; no port is taught.

    With ``reference`` there is V001 too, whose offset is zero by declaration.
    """
    plant = small()
    one, two = plant.vehicles
    vehicles = (
        replace(one, id=V3, offset=pulses(40, 40, 40)),
        replace(two, id=V7, offset=pulses(-20, -20, -20)),
    )
    stations = tuple(replace(station, dest=None) for station in plant.stations)
    if reference:
        vehicles = (replace(vehicles[0], id=V1, offset=None), vehicles[1])
    names = frozenset({V1}) if reference else frozenset[VehicleId]()
    return replace(plant, vehicles=vehicles, stations=stations, carriers=(), reference_vehicles=names)


class Teacher:
    """Plays one vehicle in MANT that sends teaching events."""

    def __init__(self, script: Script, vehicle: VehicleId = V1, at: str = "104", *, mant: bool = True) -> None:
        self.script, self.vehicle, self.at = script, vehicle, at
        self.connection = 1
        self.counter = 0
        self.receipts = 0
        if mant:
            script.link_up(vehicle)
            script.report(vehicle, at, MANT)

    def send(self, kind: TeachingKind, position: int, *, at: str | None = None, cmd_id: int | None = None) -> Taught:
        """Send one event, under the next CMD_ID of the vehicle unless told otherwise."""
        self.counter += 1
        self.receipts += 1
        event = Taught(
            self.vehicle,
            kind,
            CODES[kind],
            Pulses(position),
            Barcode(at or self.at),
            CmdId((1 << 63) | (cmd_id or self.counter)),
            self.receipts,
            self.connection,
        )
        self.script.hear(event)
        return event

    def teach(self, shft: int, rota: int, lift: int, side: Side = Side.DEST, *, at: str | None = None) -> Proposal:
        """Send all three axes unasked, and return the proposal that they make."""
        for axis, position in zip(Axis, (shft, rota, lift), strict=True):
            self.send(TeachingKind(f"{axis.value}_{side.value}"), position, at=at)
        return last(self.script)

    def asked(self, side: Side) -> Send:
        """Return the PORT DEST or PORT OFFSET command that the fleet has sent last."""
        send = self.script.last(Simple, self.vehicle)
        assert isinstance(send.command, Simple)
        assert send.command.what is side.command
        return send


def last(script: Script) -> Proposal:
    """Return the newest proposal as last kept."""
    found: dict[int, Proposal] = {p.number: p for p in script.kept(Proposal)}
    return found[max(found)]


def named(script: Script, number: int) -> Proposal:
    """Return a proposal as last kept."""
    return [p for p in script.kept(Proposal) if p.number == number][-1]


def approve(proposal: Proposal, *accept: ProposalState) -> ApproveProposal:
    """Return the approval of kim."""
    return ApproveProposal(KIM, proposal.number, frozenset(accept), "as measured")


def reject(proposal: Proposal) -> RejectProposal:
    """Return the rejection of kim."""
    return RejectProposal(KIM, proposal.number, "taught askew")


def opened(script: Script, station: StationId = P1, vehicle: VehicleId = V1) -> TeachingSession:
    """Open a session that must be allowed."""
    script.accept(OpenTeaching(KIM, station, vehicle, "new tool"))
    return script.kept(TeachingSession)[-1]


def dest(script: Script, station: StationId = P1) -> StationDest:
    """Return the newest DEST of a port."""
    return script.fleet.books.dests[station]


def offset(script: Script, vehicle: VehicleId = V1) -> VehicleOffset:
    """Return the newest OFFSET of a vehicle."""
    return script.fleet.books.offsets[vehicle]


def sent_to(script: Script, vehicle: VehicleId, station: StationId = P1) -> object:
    """Return the pulses that a vehicle would be sent for a port, or the refusal."""
    books = script.fleet.books
    return target_for(books, books.vehicles[vehicle], books.specs[station])
