"""Teaching through the whole controller: nothing is acknowledged before it is durable, and repetitions do not double it."""

from app.domain.commands import Plain
from app.domain.ids import Actor, StationId
from app.domain.layout import Axis
from app.domain.records import StationDest, TeachingEvent
from app.domain.requests import CommandVehicle
from app.domain.teaching import Proposal, ProposalState, Side
from app.domain.teaching_requests import ApproveProposal, OpenTeaching, StartTeaching
from app.domain.units import Barcode, Pulses
from app.protocols.itsc.messages import Code, Enq, Mode
from app.wire.faults import Fault
from tests.control.bench import V1, Bench

KIM = Actor("kim")
P1 = StationId("P1")
DEST = (0x2070, 0x2072, 0x2074)


def at_the_port(bench: Bench) -> Bench:
    """V1 stands at P1 in MANT, its hoist over the port, in a session of kim's."""
    bench.vehicle.push_to(Barcode("1203"), bench.now)
    bench.vehicle.panel_mode(Mode.MANT, bench.now)
    for axis, pulses in zip(Axis, (-1520, 900, 41000), strict=True):
        bench.vehicle.jog(axis, Pulses(pulses), bench.now)
    bench.run(4.0)
    bench.accept(OpenTeaching(KIM, P1, V1))
    bench.line.clear()
    return bench


def taught(bench: Bench) -> list[Enq]:
    """Return the teaching events on the line, each transmission."""
    return [
        h.frame for h in bench.line if h.way == "<" and isinstance(h.frame, Enq) and 0x2070 <= h.frame.code <= 0x2075
    ]


def kept(bench: Bench) -> list[TeachingEvent]:
    return [record for record in bench.kept if isinstance(record, TeachingEvent)]


def newest(bench: Bench) -> Proposal:
    found = {record.number: record for record in bench.kept if isinstance(record, Proposal)}
    return found[max(found)]


def test_port_dest_teaching_gives_three_events_one_after_the_other_and_one_proposal(bench: Bench) -> None:
    at_the_port(bench)
    bench.accept(StartTeaching(KIM, 1, Side.DEST))
    bench.run(3.0)
    assert [event.code for event in taught(bench)] == list(DEST)
    assert bench.answers(Code.PORT_DEST_TEACHING) == [0]
    assert (newest(bench).state, newest(bench).station, newest(bench).asked_by) == (ProposalState.READY, P1, KIM)
    bench.accept(ApproveProposal(KIM, 1))
    dest = [record for record in bench.kept if isinstance(record, StationDest)][-1]
    assert (dest.version, dest.pulses.of(Axis.LIFT), dest.basis[2].events) == (2, 41000, (3,))


def test_a_database_that_stalls_for_ten_seconds_loses_nothing_that_was_acknowledged(bench: Bench) -> None:
    at_the_port(bench)
    bench.accept(StartTeaching(KIM, 1, Side.DEST))
    bench.until(lambda: bench.sent(Code.PORT_DEST_TEACHING) != [])
    bench.durable = False
    bench.run(10.0)
    sent = taught(bench)
    assert [event.code for event in sent] == [0x2070] * 4
    assert len({event.cmd_id for event in sent}) == 1
    assert bench.acks(sent[0].cmd_id, way=">") == 0
    assert kept(bench) == []
    bench.durable = True
    bench.pump()
    bench.run(12.0)
    assert bench.acks(sent[0].cmd_id, way=">") == 1
    (event,) = kept(bench)
    assert (event.axis, event.position, event.number) == (Axis.SHFT, -1520, 1)
    assert newest(bench).state is ProposalState.INCOMPLETE
    assert newest(bench).why.startswith("ROTA, LIFT did not come")
    bench.accept(StartTeaching(KIM, 1, Side.DEST))
    bench.run(3.0)
    assert (newest(bench).number, newest(bench).state) == (2, ProposalState.READY)
    first = [record for record in bench.kept if isinstance(record, Proposal) and record.number == 1][-1]
    assert first.state is ProposalState.SUPERSEDED


def test_a_stall_that_ends_in_time_costs_nothing(bench: Bench) -> None:
    at_the_port(bench)
    bench.accept(StartTeaching(KIM, 1, Side.DEST))
    bench.until(lambda: bench.sent(Code.PORT_DEST_TEACHING) != [])
    bench.durable = False
    bench.run(2.5)
    bench.durable = True
    bench.pump()
    bench.run(3.0)
    assert [event.position for event in kept(bench)] == [-1520, 900, 41000]
    assert newest(bench).state is ProposalState.READY


def test_an_event_whose_acknowledgement_was_lost_is_acknowledged_again_and_kept_once(bench: Bench) -> None:
    at_the_port(bench)
    bench.lane_in.strike(Fault.DROP, lambda packet: packet[0] == 6 and packet[5] & 0x80 != 0)
    bench.accept(StartTeaching(KIM, 1, Side.DEST))
    bench.run(5.0)
    first = taught(bench)[0]
    assert [event.code for event in taught(bench)] == [0x2070, *DEST]
    assert bench.acks(first.cmd_id, way=">") == 2
    assert len(kept(bench)) == 3
    assert newest(bench).state is ProposalState.READY


def test_a_counter_that_restarts_after_a_reset_loses_no_event(bench: Bench) -> None:
    at_the_port(bench)
    bench.vehicle.teach_single(Code.LIFT_DEST_TEACHING, bench.now)
    bench.run(1.0)
    bench.accept(CommandVehicle(KIM, V1, Plain.SYSTEM_RESET))
    bench.run(5.0)
    bench.connect()
    bench.run(3.0)
    bench.vehicle.teach_single(Code.LIFT_DEST_TEACHING, bench.now)
    bench.run(1.0)
    first, second = kept(bench)
    assert (first.position, first.barcode) == (41000, "1203")
    assert first.connection != second.connection


def test_a_vehicle_lost_in_the_middle_leaves_what_it_sent(bench: Bench) -> None:
    at_the_port(bench)
    bench.lose_answer(Code.LIFT_DEST_TEACHING)
    bench.accept(StartTeaching(KIM, 1, Side.DEST))
    bench.run(0.5)
    bench.cut()
    bench.run(1.0)
    assert len(kept(bench)) == 2
    assert (newest(bench).state, newest(bench).why.partition(" did")[0]) == (ProposalState.INCOMPLETE, "LIFT")


def test_open_teaching_goes_on_after_a_restart_of_the_controller(bench: Bench) -> None:
    at_the_port(bench)
    bench.accept(StartTeaching(KIM, 1, Side.DEST))
    bench.run(3.0)
    bench.restart()
    bench.run(3.0)
    assert {update.key for update in bench.control.snapshot()} >= {"session-1", "proposal-1"}
    bench.accept(ApproveProposal(KIM, 1, reason="as before"))
    assert bench.control.fleet.books.dests[P1].version == 2
