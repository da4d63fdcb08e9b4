"""A whole job by real session and fleet against a simulated vehicle, through bytes, with something going wrong on the way."""

from dataclasses import replace

import pytest

from app.domain.ids import Actor, CarrierId, JobId, StationId
from app.domain.job import Job, JobState
from app.domain.records import IntentState
from app.domain.requests import CreateJob, RecoverAlarm, ReleaseVehicle, Verdict
from app.protocols.itsc.messages import Code, Mode
from app.wire.faults import Fault
from tests.control.bench import V1, Bench, line_plant

HOST, KIM = Actor("host"), Actor("kim")
P1, B1 = StationId("P1"), StationId("B1")


@pytest.fixture
def bench() -> Bench:
    """V1 idle at 1201, a carrier at P1 (1203), and job J1 from there to the side buffer B1 (1205)."""
    bench = Bench(replace(line_plant(), carriers=((CarrierId("F1"), P1),)))
    bench.accept(CreateJob(HOST, JobId("J1"), "P1", B1, None, 50, "x"))
    return bench


def job(bench: Bench) -> Job:
    """Return J1 as last kept."""
    found = bench.ledger.job(JobId("J1"))
    assert found is not None
    return found


def delivered(bench: Bench) -> None:
    """J1 is completed, by one PICKUP and one PLACE."""
    assert job(bench).state is JobState.COMPLETED
    assert bench.truth.at == {B1: "F1"}
    assert len({frame.cmd_id for frame in bench.sent(Code.PICKUP_FROM_PORT)}) == 1
    assert len({frame.cmd_id for frame in bench.sent(Code.PLACE_TO_SBFL)}) == 1


def test_a_job_without_trouble(bench: Bench) -> None:
    bench.run(40.0)
    delivered(bench)


@pytest.mark.parametrize("code", [Code.PICKUP_FROM_PORT, Code.PLACE_TO_SBFL])
@pytest.mark.parametrize("fault", [Fault.DROP, Fault.CORRUPT, Fault.DUPLICATE, Fault.SPLIT, Fault.NOISE])
def test_a_handling_command_that_suffers_on_the_line_is_carried_out_once(
    bench: Bench, code: Code, fault: Fault
) -> None:
    bench.spoil(fault, code)
    bench.run(50.0)
    delivered(bench)


@pytest.mark.parametrize("code", [Code.PICKUP_FROM_PORT, Code.PLACE_TO_SBFL])
def test_a_handling_whose_answer_is_lost_for_ever_is_decided_by_f_and_not_repeated(bench: Bench, code: Code) -> None:
    bench.lose_answer(code)
    bench.run(240.0)
    delivered(bench)
    kind = "pickup" if code is Code.PICKUP_FROM_PORT else "place"
    (intent,) = bench.intents(kind)
    assert intent.state is IntentState.SETTLED_DONE


@pytest.mark.parametrize("after", [0.2, 1.5, 3.0, 4.5])
def test_a_line_cut_during_the_pick_up_changes_nothing(bench: Bench, after: float) -> None:
    bench.until(lambda: bench.vehicle.working is Code.PICKUP_FROM_PORT)
    bench.run(after)
    bench.cut()
    bench.run(1.0)
    bench.connect()
    bench.run(50.0)
    delivered(bench)


@pytest.mark.parametrize("after", [0.2, 1.5, 3.0, 4.5])
def test_a_controller_killed_during_the_pick_up_changes_nothing(bench: Bench, after: float) -> None:
    bench.until(lambda: bench.vehicle.working is Code.PICKUP_FROM_PORT)
    bench.run(after)
    bench.restart()
    bench.run(50.0)
    delivered(bench)


def test_a_pick_up_where_no_foup_is_ends_in_alarm_201_and_the_job_fails_once_it_is_recovered(bench: Bench) -> None:
    bench.truth.remove(P1)
    bench.run(20.0)
    assert bench.hold == "alarm 201 (no name under alarm_codes)"
    assert job(bench).state is not JobState.FAILED
    bench.accept(RecoverAlarm(KIM, V1))
    bench.run(15.0)
    assert job(bench).state is JobState.FAILED
    assert "alarm 201" in job(bench).result
    assert bench.control.fleet.books.stations[P1].present is None
    assert len(bench.sent(Code.PICKUP_FROM_PORT)) == 1
    assert bench.known.fit


def test_a_foup_lost_on_the_way_holds_the_vehicle_until_a_person_has_looked_and_the_job_fails(bench: Bench) -> None:
    bench.until(lambda: bench.vehicle.state.foup and bench.vehicle.state.driving)
    bench.vehicle.lose_foup(bench.now)
    bench.run(8.0)
    assert bench.hold == "alarm 202 (no name under alarm_codes)"
    bench.accept(RecoverAlarm(KIM, V1))
    bench.run(8.0)
    assert bench.hold == "it should carry F1, and its FOUP bit is 0"
    assert bench.sent(Code.PLACE_TO_SBFL) == []
    bench.accept(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "it lies on the floor"))
    bench.run(8.0)
    assert job(bench).state is JobState.FAILED
    assert bench.control.fleet.books.carriers[CarrierId("F1")].place is None


def test_a_foup_put_into_an_idle_vehicle_by_hand_holds_it(bench: Bench) -> None:
    bench.run(40.0)
    bench.vehicle.insert_foup(bench.now)
    bench.run(5.0)
    assert bench.hold == "it carries a FOUP that no job or record accounts for"


def test_a_pick_up_after_which_f_stays_0_is_an_alarm_of_ours(bench: Bench) -> None:
    bench.until(lambda: bench.vehicle.state.foup)
    bench.vehicle.remove_foup(bench.now)
    bench.run(8.0)
    assert bench.hold == "PICKUP at P1 was answered RESULT 0, but the FOUP bit is 0"
    assert bench.sent(Code.MOVE)[1:] == []
    assert bench.intents("pickup")[0].state is IntentState.FAILED


@pytest.mark.parametrize("when", ["to the source", "picking up", "to the destination", "putting down"])
def test_the_key_turned_to_mant_and_back_at_any_time_costs_nothing_but_time(bench: Bench, when: str) -> None:
    busy = {"picking up": Code.PICKUP_FROM_PORT, "putting down": Code.PLACE_TO_SBFL}
    if when in busy:
        bench.until(lambda: bench.vehicle.working is busy[when])
    else:
        bench.until(lambda: bench.vehicle.state.driving and bench.vehicle.state.foup is (when != "to the source"))
    bench.run(0.4)
    bench.vehicle.panel_mode(Mode.MANT, bench.now)
    bench.run(5.0)
    assert not bench.known.fit
    bench.accept(RecoverAlarm(KIM, V1, confirmed=True))
    bench.run(4.0)
    if not bench.vehicle.state.recognised:
        bench.vehicle.push_to(bench.vehicle.place(bench.now)[0], bench.now)
    bench.run(60.0)
    assert job(bench).state is JobState.COMPLETED
    assert bench.truth.at == {B1: "F1"}


def test_a_vehicle_that_loses_its_power_with_the_foup_aboard_goes_on_where_it_was(bench: Bench) -> None:
    bench.until(lambda: bench.vehicle.state.foup and bench.vehicle.state.all_home and not bench.vehicle.state.driving)
    bench.until(lambda: bench.vehicle.state.driving)
    bench.run(0.5)
    bench.vehicle.power_cycle(bench.now)
    bench.run(5.0)
    bench.connect()
    bench.run(3.0)
    bench.accept(RecoverAlarm(KIM, V1, confirmed=True))
    bench.run(8.0)
    if not bench.vehicle.state.recognised:
        assert "reads no barcode" in bench.known.waiting
        bench.vehicle.push_to(bench.vehicle.place(bench.now)[0], bench.now)
    bench.run(40.0)
    delivered(bench)


def test_an_obstacle_on_the_way_is_waited_for_however_long_it_stays(bench: Bench) -> None:
    bench.until(lambda: bench.vehicle.state.driving)
    bench.vehicle.block_sensor(bench.now)
    bench.run(600.0)
    assert len(bench.sent(Code.MOVE)) == 1
    bench.vehicle.unblock_sensor(bench.now)
    bench.run(50.0)
    delivered(bench)
