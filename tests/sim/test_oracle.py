from dataclasses import replace

import pytest

from app.domain.devices import DeviceId, DeviceNumber
from app.domain.ids import Actor, CmdId, JobId, LinkId, StationId, VehicleId
from app.domain.job import Job, JobEvent, JobState
from app.domain.layout import DoorSpec, StationKind
from app.domain.records import HistoryEvent, Intent, IntentState, Record
from app.domain.units import Barcode, Timestamp
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT
from app.protocols.itsc.messages import (
    NOTHING,
    Action,
    Code,
    Element,
    Enq,
    Etb,
    Mode,
    Move,
    Resp2,
    Sbuf,
    Status1,
    Status2,
)
from app.sim.oracle import Books, LineWatch, Oracle
from app.sim.truth import Truth
from tests.sim.plants import line

V1, DOOR1 = VehicleId("V1"), DeviceId("DOOR1")
CODEC = Codec(DEFAULT)
JOB = Job(
    id=JobId("J"),
    order=1,
    carrier=None,
    source=StationId("P1"),
    destination=StationId("L"),
    priority=50,
    created=Timestamp(0.0),
    actor=Actor("test"),
    fingerprint="",
)


class Court:
    """An oracle over the line plant, and everything that reports to it."""

    def __init__(self) -> None:
        plant = line()
        self.truth = Truth(plant, lambda act: self.oracle.act(act, 1.0))
        self.oracle = Oracle(plant, self.truth)
        self.books = Books(self.oracle)
        self.watch = LineWatch(plant.vehicles[0], CODEC, self.books, self.oracle)
        self.said(Mode.AUTO, 0.5)

    @property
    def verdict(self) -> list[str]:
        return self.oracle.violations

    def kept(self, *records: Record) -> None:
        self.books.committed(records, 1.0)

    def said(self, mode: Mode, at: float, cmd_id: int = 1) -> None:
        """A STATUS arrives at the controller."""
        body = Resp2(Status1(), Status2(mode=mode), 1001, 0)
        self.watch.heard(CODEC.encode(Enq(1, cmd_id, int(Code.STATUS), body), strict=False), at)

    def sent(self, code: Code, body: Move | Sbuf | None, cmd_id: int = 5) -> None:
        kind = Etb if isinstance(body, Move) else Enq
        self.watch.sent(CODEC.encode(kind(1, cmd_id, int(code), body or NOTHING), strict=False), 1.0)


def intent(cmd_id: int, vehicle: VehicleId = V1) -> Intent:
    return Intent(CmdId(cmd_id), vehicle, "move", IntentState.OPEN, Timestamp(0.0), Actor("test"))


def event(seq: int) -> HistoryEvent:
    return HistoryEvent(seq, Timestamp(0.0), JobEvent.TRANSFERRING, 0)


def path(*steps: tuple[int, Action]) -> Move:
    return Move([Element(1000 + seq, seq, 0, action, 100) for seq, action in steps])


def test_nothing_wrong_is_nothing_said() -> None:
    court = Court()
    court.kept(intent(5), JOB, event(1), replace(JOB, state=JobState.WAITING), event(2))
    court.sent(Code.MOVE, path((0, Action.RUN), (1, Action.STOP)))
    court.sent(Code.STATUS, None, 6)
    court.oracle.look({V1: (Barcode("a"), 0.0, None)}, {V1: False}, 1.0)
    assert court.verdict == []
    assert court.books.open == ["J"]
    assert court.books.count(JobState.WAITING) == 1


def test_a_pick_up_of_nothing_is_a_violation() -> None:
    court = Court()
    court.truth.take(V1, Barcode("d"), StationKind.SBFL, None)
    assert court.verdict == ["at 1.000 s: V1 picked up at L where it could not"]


def test_a_place_without_a_carrier_is_a_violation() -> None:
    court = Court()
    court.truth.put(V1, Barcode("d"), StationKind.SBFL, None)
    assert court.verdict == ["at 1.000 s: V1 placed at L where it could not"]


def test_a_carrier_that_vanishes_is_a_violation() -> None:
    court = Court()
    court.truth.total = 2
    court.truth.take(V1, Barcode("b"), StationKind.PORT, None)
    assert court.verdict == ["at 1.000 s: 1 carriers, of which 1 differ; there must be 2"]
    assert court.oracle.takes == 1


def test_a_sensor_that_disagrees_with_the_truth_is_a_violation() -> None:
    court = Court()
    court.oracle.look({}, {V1: True}, 2.0)
    assert court.verdict == ["at 2.000 s: V1 says F=1, aboard is None"]


def test_a_meeting_is_told_once() -> None:
    court = Court()
    places = {V1: (Barcode("c"), 0.0, None), VehicleId("V2"): (Barcode("c"), 0.0, None)}
    court.oracle.look(places, {}, 2.0)
    court.oracle.look(places, {}, 3.0)
    assert court.verdict == ["at 2.000 s: V1 and V2 both cover barcode c"]


def door_court() -> Court:
    court = Court()
    door = DoorSpec(DOOR1, LinkId("HALL"), DeviceNumber(30), frozenset({(Barcode("c"), Barcode("d"))}))
    court.oracle = Oracle(replace(line(), doors=(door,)), court.truth)
    return court


@pytest.mark.parametrize(
    ("at", "past", "following", "inside"),
    [
        ("b", 900.0, "c", False),
        ("c", 0.0, None, False),
        ("c", 10.0, "d", True),
        ("d", 0.0, None, True),
        ("d", 400.0, "e", True),
    ],
)
def test_a_vehicle_in_a_door_that_is_not_open_is_a_violation(
    at: str, past: float, following: str | None, inside: bool
) -> None:
    court = door_court()
    place = (Barcode(at), past, Barcode(following) if following else None)
    for moment, open_ in ((1.0, True), (2.0, False), (3.0, False)):
        court.oracle.look({V1: place}, {}, moment)
        court.oracle.look_at_doors({DOOR1: open_}, moment)
    assert court.verdict == (["at 2.000 s: V1 is in DOOR1, which is not open"] if inside else [])


def test_a_vehicle_whose_tail_is_in_a_door_that_is_not_open_is_a_violation() -> None:
    court = door_court()
    court.oracle.look({V1: (Barcode("e"), 0.0, None)}, {}, 1.0)
    court.oracle.look_at_doors({DOOR1: False}, 1.0)
    assert court.verdict == ["at 1.000 s: V1 is in DOOR1, which is not open"]


@pytest.mark.parametrize("mode", [Mode.MANT, Mode.SEMI])
def test_a_motion_out_of_auto_is_a_violation_and_an_echo_of_an_older_status_is_none(mode: Mode) -> None:
    court = Court()
    court.kept(intent(5), intent(6))
    court.said(mode, 0.6, 2)
    court.sent(Code.MOVE, path((0, Action.STOP)))
    assert court.verdict == [f"at 1.000 s: V1 was sent 1044 in {mode.name}"]
    court.said(Mode.AUTO, 0.7, 3)
    court.said(mode, 0.8, 2)
    court.sent(Code.MOVE, path((0, Action.STOP)), 6)
    assert len(court.verdict) == 1


def test_a_motion_on_an_old_status_or_on_none_of_this_connection_is_a_violation() -> None:
    court = Court()
    court.kept(intent(5), intent(6))
    court.said(Mode.AUTO, -2.5, 2)
    court.sent(Code.MOVE, path((0, Action.STOP)))
    court.watch.heard(None, 0.9)
    court.sent(Code.MOVE, path((0, Action.STOP)), 6)
    assert court.verdict == [
        "at 1.000 s: V1 was sent 1044 on a STATUS 3.5 s old",
        "at 1.000 s: V1 was sent 1044 before any STATUS of this connection",
    ]


def test_two_jobs_of_one_name_are_a_violation() -> None:
    court = Court()
    court.kept(JOB, replace(JOB, order=2))
    assert court.verdict == ["at 1.000 s: there are two jobs J"]


def test_a_move_without_a_durable_intent_is_a_violation() -> None:
    court = Court()
    court.sent(Code.MOVE, path((0, Action.STOP)))
    assert court.verdict == ["at 1.000 s: V1 was sent 1044 without a durable intent"]


def test_a_pick_up_without_a_durable_intent_is_a_violation() -> None:
    court = Court()
    court.sent(Code.PICKUP_FROM_SBFL, Sbuf(50))
    assert court.verdict == ["at 1.000 s: V1 was sent 1048 without a durable intent"]


def test_a_path_that_ends_in_a_run_or_skips_a_number_is_a_violation() -> None:
    court = Court()
    court.kept(intent(5))
    court.sent(Code.MOVE, path((0, Action.RUN), (2, Action.RUN)))
    assert court.verdict == [
        "at 1.000 s: V1 was sent a path whose SEQ does not rise by one: [0, 2]",
        "at 1.000 s: V1 was sent a path that does not end in a stop",
    ]


def test_a_job_that_leaves_the_state_table_is_a_violation() -> None:
    court = Court()
    court.kept(JOB, replace(JOB, state=JobState.WAITING), replace(JOB, state=JobState.CANCELLED))
    court.kept(replace(JOB, state=JobState.WAITING))
    assert court.verdict == ["at 1.000 s: job J went from cancelled to waiting"]


def test_a_gap_in_history_is_a_violation() -> None:
    court = Court()
    court.kept(event(1), event(3))
    assert court.verdict == ["at 1.000 s: event 3 follows event 1"]


def test_a_cmd_id_for_two_vehicles_is_a_violation() -> None:
    court = Court()
    court.kept(intent(5), intent(5, VehicleId("V2")))
    assert court.verdict == ["at 1.000 s: CMD_ID 0000000000000005 was used for two vehicles"]


def test_a_motion_command_while_the_vehicle_carries_one_out_is_a_violation() -> None:
    court = Court()
    court.kept(intent(5), intent(6))
    busy = LineWatch(line().vehicles[0], CODEC, court.books, court.oracle, lambda: Code.PICKUP_FROM_PORT)
    court.watch = busy
    court.said(Mode.AUTO, 0.5)
    for cmd_id in (5, 5):
        busy.sent(CODEC.encode(Etb(1, cmd_id, int(Code.MOVE), path((0, Action.STOP))), strict=False), 1.0)
    busy.sent(CODEC.encode(Enq(1, 9, int(Code.STATUS), NOTHING)), 1.0)
    assert court.verdict == ["at 1.000 s: V1 was sent 1044 while it was at 1046"]
