"""The controller as one object: keep before you tell, and what it shows."""

from dataclasses import replace

from app.domain.commands import Plain
from app.domain.ids import Actor, JobId, StationId
from app.domain.job import Job
from app.domain.layout import StopAction
from app.domain.records import IntentState, TeachingEvent
from app.domain.requests import CommandVehicle, CreateJob, HoldVehicle, MoveVehicle, ReleaseVehicle, Verdict
from app.domain.units import Barcode
from app.domain.view import Topic, VehicleView
from app.protocols.itsc.messages import Code, Mode
from tests.control.bench import UTC, V1, Bench, line_plant

KIM = Actor("kim")


def go(barcode: str) -> MoveVehicle:
    """Return the order to drive to a barcode."""
    return MoveVehicle(KIM, V1, Barcode(barcode))


# -- keep before you tell --------------------------------------------------------------------------------------------------


def test_nothing_is_told_to_anybody_before_it_is_durable(bench: Bench) -> None:
    bench.durable = False
    bench.updates.clear()
    ticket = bench.control.ask(go("1203"), bench.now)
    bench.run(2.5)
    assert ticket not in bench.replies
    assert bench.sent(Code.MOVE) == []
    assert not [u for u in bench.updates if u.topic is Topic.COMMANDS]
    bench.durable = True
    bench.pump()
    assert ticket in bench.replies
    assert len(bench.sent(Code.MOVE)) == 1
    assert [u for u in bench.updates if u.topic is Topic.COMMANDS]


def test_the_sessions_own_packets_need_no_commit(bench: Bench) -> None:
    bench.durable = False
    bench.vehicle.panel_mode(Mode.MANT, bench.now)
    bench.run(3.0)
    polls = bench.sent(Code.STATUS)
    assert len(polls) >= 2
    event = next(h.frame for h in bench.line if h.way == "<" and getattr(h.frame, "cmd_id", 0) >> 63)
    assert bench.acks(event.cmd_id, way=">") == 1


def test_transactions_are_numbered_in_order_and_each_record_is_given_once(bench: Bench) -> None:
    bench.durable = False
    bench.control.ask(go("1203"), bench.now)
    bench.control.ask(CreateJob(KIM, JobId("J1"), "P1", StationId("B1"), None, 50, "x"), bench.now)
    bench.pump()
    numbers = [transaction.number for transaction in bench.waiting]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert len([r for t in bench.waiting for r in t.records if isinstance(r, Job)]) >= 1
    assert bench.control.transactions() == []


def test_a_part_of_what_waits_may_become_durable_first(bench: Bench) -> None:
    bench.durable = False
    first = bench.control.ask(HoldVehicle(KIM, V1, "a"), bench.now)
    second = bench.control.ask(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "b"), bench.now)
    earlier = bench.control.transactions()
    bench.control.committed(earlier[0].number, bench.now)
    assert [ticket for ticket, _ in bench.control.replies()] == [first]
    bench.control.committed(earlier[-1].number, bench.now)
    assert [ticket for ticket, _ in bench.control.replies()] == [second]


def test_a_motion_that_a_slow_disk_has_overtaken_does_not_leave(bench: Bench) -> None:
    """Decided, written slowly; meanwhile the line broke, came back, and the vehicle was settled without it."""
    bench.durable = False
    bench.control.ask(go("1205"), bench.now)
    bench.run(0.5)
    bench.cut()
    bench.connect()
    bench.run(5.0)
    assert bench.control.fleet.books.traffic.held(V1)[-1] == "1205"
    assert bench.sent(Code.MOVE) == []
    bench.commit()
    assert bench.sent(Code.MOVE) == []
    bench.durable = True
    bench.pump()
    moves = bench.intents("move")
    assert moves[0].state in {IntentState.SETTLED_NOT_DONE, IntentState.NOT_SENT}
    bench.run(20.0)
    assert bench.vehicle.place(bench.now)[0] == "1205"
    assert len(bench.sent(Code.MOVE)) == len([m for m in bench.intents("move") if m.state is IntentState.DONE])


def test_a_motion_decided_before_somebody_turned_the_key_does_not_leave(bench: Bench) -> None:
    bench.durable = False
    bench.control.ask(go("1205"), bench.now)
    bench.vehicle.panel_mode(Mode.MANT, bench.now)
    bench.run(2.0)
    bench.durable = True
    bench.pump()
    bench.run(5.0)
    assert bench.sent(Code.MOVE) == []
    assert bench.intents("move")[0].state is IntentState.NOT_SENT
    bench.vehicle.panel_mode(Mode.AUTO, bench.now)
    bench.run(20.0)
    assert bench.vehicle.place(bench.now)[0] == "1205"


def test_a_command_that_the_session_refuses_is_kept_as_not_sent(bench: Bench) -> None:
    bench.accept(go("1205"))
    bench.until(lambda: bench.vehicle.state.driving)
    bench.accept(CommandVehicle(KIM, V1, Plain.STOP_BY_HOST))
    bench.run(6.0)
    bench.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "x"))
    bench.run(20.0)
    assert bench.vehicle.place(bench.now)[0] == "1205"


def test_a_teaching_event_is_acknowledged_once_it_is_durable(bench: Bench) -> None:
    bench.vehicle.panel_mode(Mode.MANT, bench.now)
    bench.run(3.0)
    bench.durable = False
    bench.vehicle.teach_single(Code.LIFT_OFFSET_TEACHING, bench.now)
    bench.run(2.5)
    taught = [h.frame for h in bench.line if h.way == "<" and getattr(h.frame, "code", 0) == 0x2075]
    assert len(taught) >= 2
    assert bench.acks(taught[0].cmd_id, way=">") == 0
    bench.durable = True
    bench.pump()
    bench.run(3.0)
    assert bench.acks(taught[0].cmd_id, way=">") >= 1
    assert len([r for r in bench.kept if isinstance(r, TeachingEvent)]) == 1


# -- what is shown ---------------------------------------------------------------------------------------------------------


def test_the_snapshot_is_the_sum_of_all_updates_so_far_without_events(bench: Bench) -> None:
    bench.accept(CreateJob(KIM, JobId("J1"), "P1", StationId("B1"), None, 50, "x"))
    bench.accept(go("1203"))
    bench.run(15.0)
    model: dict[tuple[Topic, str], object] = {}
    for update in bench.updates:
        if update.topic is Topic.EVENTS:
            continue
        if update.value is None:
            model.pop((update.topic, update.key), None)
        else:
            model[update.topic, update.key] = update.value
    assert {(u.topic, u.key): u.value for u in bench.control.snapshot()} == model
    assert (Topic.VEHICLES, "V1") in model


def test_a_vehicle_is_shown_with_its_line(bench: Bench) -> None:
    bench.run(3.0)
    view = next(u.value for u in bench.control.snapshot() if u.key == "V1" and u.topic is Topic.VEHICLES)
    assert isinstance(view, VehicleView)
    assert view.link.up
    assert view.link.frames_in > 3
    assert view.barcode == "1201"


def test_the_last_packets_are_kept_with_their_time(bench: Bench) -> None:
    frames = bench.control.frames(V1)
    assert {way for _, way, _ in frames} == {"in", "out"}
    assert all(UTC <= when <= UTC + bench.now for when, _, _ in frames)
    assert bench.control.lines == (V1,)


def test_a_vehicle_of_another_dialect_is_told_apart_and_not_moved() -> None:
    """It writes its barcodes in four bytes, and is expected to write them in six."""
    plant = line_plant()
    bench = Bench(plant, ready=False)
    expecting = replace(plant, vehicles=(replace(plant.vehicles[0], dialect="slides"),))
    bench.vehicle.make_ready(bench.now)
    bench.plant = expecting
    bench._begin()
    bench.connect()
    bench.run(10.0)
    assert bench.known.stage.value == "settling"
    assert "not on the map" in bench.known.waiting
    assert "default" in bench.control.hint(V1)
    view = next(u.value for u in bench.control.snapshot() if u.key == "V1" and u.topic is Topic.VEHICLES)
    assert isinstance(view, VehicleView)
    assert view.link.reason == bench.control.hint(V1)
    assert bench.refuse(go("1203")).code == "not-now"


def test_a_vehicle_stops_at_a_side_buffer_as_at_a_side_buffer(bench: Bench) -> None:
    bench.accept(MoveVehicle(KIM, V1, Barcode("1205"), StopAction.SBFL))
    bench.run(15.0)
    assert bench.vehicle.state.trav == 2


def test_the_endpoint_is_dirty_once_when_it_may_have_something_to_say(bench: Bench) -> None:
    bench.control.ask(CommandVehicle(KIM, V1, Plain.STATUS), bench.now)
    transactions = bench.control.transactions()
    bench.control.committed(transactions[-1].number, bench.now)
    assert bench.control.dirty() == [V1]
    assert bench.control.dirty() == []
    assert bench.control.endpoint(V1).outgoing()
