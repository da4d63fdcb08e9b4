"""The simulated vehicle's options and dialects."""

import pytest

from app.domain.units import Seconds
from app.protocols.itsc.dialects import DIALECTS
from app.protocols.itsc.messages import (
    Action,
    Code,
    Element,
    Move,
    Oper,
    Raw,
    Sbuf,
)
from app.protocols.itsc.simulator import Options, RespTiming, SimulatedVehicle, Track
from tests.scenarios.rig import Rig, edge, make_rig, path, small_track, spec


@pytest.fixture
def rig() -> Rig:
    """A vehicle in AUTO at 1201."""
    return make_rig().ready()


def now(rig: Rig) -> Seconds:
    return Seconds(rig.now)


def test_a_vehicle_that_answers_at_acceptance_says_so_once() -> None:
    rig = make_rig(options=Options(resp_timing=RespTiming.ACCEPTANCE)).ready()
    move = rig.move(1201, 1202)
    rig.run(0.1)
    assert rig.order() == [f"ack {move}", f"answer {move}"]
    rig.run(10)
    assert (len(rig.answers(move)), rig.result(move)) == (1, 0)
    assert rig.do(Code.STOP) == 0
    assert len(rig.answers(rig.last_id)) == 1
    assert rig.do(Code.MOVE, Move(path(1202, 1203))) == 1


def test_alarm_events_report_a_change_of_oper() -> None:
    rig = make_rig(options=Options(alarm_events=True)).ready()
    rig.vehicle.raise_alarm(55, now(rig))
    rig.run(0.1)
    assert [event.status2.oper for event in rig.events()] == [Oper.ALARM]


def test_firmware_of_document_b_knows_only_one_stop_tag() -> None:
    rig = make_rig(options=Options(stop_tag_only=True)).ready()
    assert rig.do(Code.MOVE, Move(path(1201, 1202, stop=Action.STOP_SBFL))) == 0
    assert rig.status().status1.trav == 1
    assert rig.do(Code.PICKUP_FROM_SBFR, Sbuf(100)) == 0


@pytest.mark.parametrize(
    ("stop", "trav"),
    [
        (Action.STOP, 0),
        (Action.STOP_PORT, 1),
        (Action.STOP_SBFL, 2),
        (Action.STOP_SBFR, 4),
        (Action.STOP_PORT_UNPREPARED, 1),
    ],
)
def test_each_stop_shows_its_tag(rig: Rig, stop: Action, trav: int) -> None:
    assert rig.do(Code.MOVE, Move(path(1201, 1202, stop=stop))) == 0
    assert rig.status().status1.trav == trav


@pytest.mark.parametrize("name", DIALECTS)
def test_a_move_runs_in_every_dialect(name: str) -> None:
    rig = make_rig(dialect=DIALECTS[name]).ready()
    elements = path(1201, 1202, 1203)
    if DIALECTS[name].barcode_format == "ascii":
        elements = [Element(str(e.barcode), e.seq, e.sensor, e.action, e.speed) for e in elements]
    assert rig.do(Code.MOVE, Move(elements)) == 0
    assert str(rig.status().barcode) == "1203"


def test_the_slides_report_millimetres_from_the_barcode() -> None:
    rig = make_rig(dialect=DIALECTS["slides"]).ready()
    rig.move(1201, 1202)
    rig.run(0.5)
    past = rig.vehicle.place(now(rig))[1]
    answer = rig.status()
    assert answer.dist is not None
    assert 0 <= answer.dist - past < 20


def test_distance_is_answered_with_raw_data(rig: Rig) -> None:
    asked = rig.send(Code.DISTANCE)
    rig.run(0.1)
    assert rig.answers(asked)[0].body == Raw(bytes(16))


def test_in_an_ascii_dialect_no_barcode_is_no_text() -> None:
    assert make_rig(dialect=DIALECTS["ascii-barcode"]).status().barcode == ""


def test_a_barcode_that_the_dialect_cannot_write_is_a_mistake_of_the_plant() -> None:
    for dialect, barcode in (("default", "B1"), ("slides", "4294967296"), ("ascii-barcode", "1234567")):
        with pytest.raises(ValueError, match="does not fit"):
            make_rig(track=Track([edge("1201", barcode)]), dialect=DIALECTS[dialect])
    with pytest.raises(ValueError, match="no barcode of the track"):
        make_rig(start="9999")
    with pytest.raises(ValueError, match="no barcode of the track"):
        SimulatedVehicle(spec(), small_track())
