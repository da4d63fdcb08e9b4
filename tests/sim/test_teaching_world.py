"""Teaching in the virtual world: real bytes, real sessions, and vehicles whose axes stand where ports and mechanics put them."""

from collections.abc import Sequence
from dataclasses import replace

from app.domain.commands import Plain
from app.domain.errors import Refusal
from app.domain.ids import Actor, CarrierId, JobId, StationId, VehicleId
from app.domain.layout import Axis, PulseSet
from app.domain.pulses import less
from app.domain.records import Intent, IntentState, Record
from app.domain.requests import Accepted, CommandVehicle, CreateJob, MoveVehicle, Request
from app.domain.teaching import ProposalState, Side
from app.domain.teaching_requests import ApproveProposal, EndTeaching, OpenTeaching, StartTeaching
from app.domain.units import Barcode, Pulses
from app.protocols.itsc.messages import Code
from app.sim.memory import MemoryLedger
from app.sim.world import World
from tests.fleet.teaching import V3, V7, plant_of_two, pulses

KIM = Actor("kim")
P1, P3 = StationId("P1"), StationId("P3")


class Noting(MemoryLedger):
    """A ledger that shows the intents it was given."""

    def __init__(self) -> None:
        super().__init__()
        self.intents: list[Intent] = []

    def commit(self, batch: Sequence[Record]) -> None:
        """Take records over, and note the intents."""
        super().commit(batch)
        self.intents += [record for record in batch if isinstance(record, Intent)]


def accept(world: World, request: Request, seconds: float = 2.0) -> Accepted:
    """Ask, let time pass, and return the reply, which must be an acceptance."""
    ticket = world.ask(request)
    world.run(world.now + seconds)
    reply = world.replies[ticket]
    assert isinstance(reply, Accepted), reply
    return reply


def bring(world: World, vehicle: VehicleId, station: StationId) -> None:
    """Drive a vehicle to a port and stop it there in MANT."""
    spec = world.control.fleet.books.specs[station]
    accept(world, MoveVehicle(KIM, vehicle, spec.barcode, spec.kind.stop_action), 30.0)
    accept(world, CommandVehicle(KIM, vehicle, Plain.STOP), 5.0)


def teach(world: World, vehicle: VehicleId, station: StationId, side: Side = Side.DEST) -> int:
    """Teach a port by the vehicle's own command; return the proposal's number."""
    opened = accept(world, OpenTeaching(KIM, station, vehicle))
    session = int(opened.key.partition("-")[2])
    bring(world, vehicle, station)
    accept(world, StartTeaching(KIM, session, side), 3.0)
    books = world.control.fleet.books
    (proposal,) = [p for p in books.teaching.proposals.values() if p.session == session]
    assert proposal.state is ProposalState.READY, proposal
    accept(world, EndTeaching(KIM, session))
    return proposal.number


def back_to_work(world: World, vehicle: VehicleId) -> None:
    """Bring a vehicle home and into AUTO again."""
    for what in (Plain.GO_HOME, Plain.AUTO):
        accept(world, CommandVehicle(KIM, vehicle, what), 3.0)
    world.run(world.now + 5.0)


def test_a_port_taught_by_one_vehicle_is_right_for_another_whose_job_was_refused_before() -> None:
    plant = replace(plant_of_two(), carriers=((CarrierId("FOUP1"), P1),))
    stations = tuple(replace(s, dest=pulses(900, 100, 40000)) if s.id == P3 else s for s in plant.stations)
    ledger = Noting()
    world = World(replace(plant, stations=stations), seed=1, ledger=ledger)
    kept = ledger.intents
    books = world.control.fleet.books
    world.run(6.0)
    order = CreateJob(KIM, JobId("J1"), P1, P3, CarrierId("FOUP1"), 50, "x", vehicle=V7)
    ticket = world.ask(order)
    world.run(world.now + 2.0)
    refusal = world.replies[ticket]
    assert isinstance(refusal, Refusal)
    assert refusal.reason == "P1 has no DEST (SHFT, ROTA, LIFT)"
    number = teach(world, V3, P1)
    truth = world.floor.truth
    mine = truth.aligned(V3, Barcode("104"))
    assert isinstance(mine, PulseSet)
    accept(world, ApproveProposal(KIM, number))
    assert books.dests[P1].pulses == less(mine, pulses(40, 40, 40))
    accept(world, order)
    back_to_work(world, V3)
    assert world.finish(300.0)
    assert books.ended[JobId("J1")].state.value == "completed"
    sent = [intent for intent in kept if intent.kind == "pickup" and intent.state is IntentState.OPEN]
    assert [intent.body["target"] for intent in sent] == [[mine.shft - 60, mine.rota - 60, mine.lift - 60]]
    assert sent[0].body["target"] == list(_axes(truth.aligned(V7, Barcode("104"))))
    assert not world.result().violations


def test_an_offset_taught_at_a_reference_port_is_the_vehicles_own_mechanics() -> None:
    plant = plant_of_two()
    world = World(replace(plant, vehicles=(plant.vehicles[0], replace(plant.vehicles[1], offset=None))), seed=2)
    books = world.control.fleet.books
    world.run(6.0)
    accept(world, ApproveProposal(KIM, teach(world, V3, P1)))
    back_to_work(world, V3)
    accept(world, MoveVehicle(KIM, V3, Barcode("108")), 30.0)
    accept(world, ApproveProposal(KIM, teach(world, V7, P1, Side.OFFSET)))
    truth = world.floor.truth
    at_p1 = truth.aligned(V7, Barcode("104"))
    port = truth.aligned(V3, Barcode("104"))
    assert at_p1 is not None
    assert port is not None
    assert books.offsets[V7].pulses == less(at_p1, less(port, pulses(40, 40, 40)))
    assert not world.result().violations


def test_a_person_presses_lift_teaching_at_the_vehicle_and_only_the_lifter_changes() -> None:
    world = World(plant_of_two(), seed=3)
    books = world.control.fleet.books
    world.run(6.0)
    accept(world, ApproveProposal(KIM, teach(world, V3, P1)))
    first = books.dests[P1]
    device = world.floor.devices[V3]
    device.jog(Axis.LIFT, Pulses(device.state.pulses[Axis.LIFT] + 200), world.now)
    world.run(world.now + 15.0)
    device.teach_single(Code.LIFT_DEST_TEACHING, world.now)
    world.run(world.now + 15.0)
    accept(world, ApproveProposal(KIM, 2))
    assert less(books.dests[P1].pulses, first.pulses) == pulses(0, 0, 200)


def test_of_a_hoist_over_a_port_only_the_jogged_axis_differs_from_where_it_really_is() -> None:
    world = World(plant_of_two(), seed=3)
    world.run(6.0)
    bring(world, V3, P1)
    truth = world.floor.truth.aligned(V3, Barcode("104"))
    assert truth is not None
    device = world.floor.devices[V3]
    device.jog(Axis.LIFT, Pulses(truth.lift + 200), world.now)
    device.teach_single(Code.LIFT_DEST_TEACHING, world.now)
    assert tuple(device.state.pulses[axis] for axis in Axis) == (truth.shft, truth.rota, truth.lift + 200)


def _axes(pulse_set: PulseSet | None) -> tuple[int, ...]:
    assert pulse_set is not None
    return (pulse_set.shft, pulse_set.rota, pulse_set.lift)
