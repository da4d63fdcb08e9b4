"""S51 to S60 at the devices' side, with a scripted host."""

import pytest

from app.domain.devices import AgvMode
from app.domain.units import Seconds
from app.protocols.enig.messages import (
    AgvReport,
    BufferReport,
    DoorReport,
    Lock,
    Move,
    MoveAlias,
    MoveComplete,
    Open,
    Reset,
    Stop,
)
from app.protocols.enig.simulator import Hall, SimulatedAgv, SimulatedBuffer, SimulatedDoor, SimulatedLink
from tests.protocols.enig.rig import AGV1, AGV2, BUFFER1, DOOR, Host, agv, tag

ZERO = Seconds(0.0)


@pytest.fixture
def one() -> SimulatedAgv:
    """An AGV in auto at 0001, which it has not read."""
    made = agv()
    made.set_mode(AgvMode.AUTO, ZERO)
    return made


@pytest.fixture
def host(one: SimulatedAgv) -> Host:
    """A host on a link with that AGV alone, which knows its state."""
    made = Host(SimulatedLink([one]))
    made.wait(1.0)
    made.told()
    return made


def test_s51_an_agv_tells_of_its_way_to_an_alias_and_of_its_arrival(host: Host) -> None:
    host.send(AGV1, MoveAlias("B1"))
    host.wait(5.0)
    assert host.story() == [
        "R 0000/1",
        "TagReceived 0002",
        "R 0002/1",
        "TagReceived 0003",
        "SI 0003/1",
        "MoveComplete 0003",
    ]


def test_s52_in_manual_a_move_is_met_with_silence(one: SimulatedAgv, host: Host) -> None:
    one.set_mode(AgvMode.MANUAL, host.now)
    host.wait(0.1)
    host.told()
    host.send(AGV1, Move("0003"))
    host.wait(3.0)
    assert host.story() == []
    assert one.last_ignored == "it is not in auto"


def test_s53_a_stop_ends_the_way_without_an_arrival(host: Host) -> None:
    host.send(AGV1, MoveAlias("B1"))
    host.wait(3.0)
    host.told()
    host.send(AGV1, Stop())
    host.wait(10.0)
    assert host.story() == ["S 0002/1"]


def test_s54_a_lost_move_complete_leaves_the_status_that_says_the_same(host: Host) -> None:
    host.link.lose("MoveComplete")
    host.send(AGV1, MoveAlias("B1"))
    host.wait(6.0)
    assert host.story()[-1] == "SI 0003/1"


def test_s55_in_error_only_a_reset_helps(one: SimulatedAgv, host: Host) -> None:
    one.raise_error(host.now)
    host.wait(0.1)
    host.told()
    host.send(AGV1, Move("0003"))
    host.wait(2.0)
    assert host.story() == []
    host.send(AGV1, Reset())
    assert host.story() == ["S 0000/0"]
    host.send(AGV1, Move("0003"))
    assert host.story() == ["R 0000/1"]


def test_s56_a_door_is_busy_then_open_and_an_agv_does_not_pass_before() -> None:
    door = SimulatedDoor(DOOR)
    one = agv(hall=Hall({(tag("0002"), tag("0003")): door}))
    one.set_mode(AgvMode.AUTO, ZERO)
    host = Host(SimulatedLink([one, door]))
    host.send(DOOR, Open())
    host.wait(1.0)
    assert DoorReport(2) in host.told()
    host.wait(0.9)
    assert host.told() == []
    host.wait(0.1)
    assert host.told() == [DoorReport(1)]
    host.send(AGV1, Move("0003"))
    host.wait(5.0)
    assert MoveComplete("0003") in host.told()


def test_s57_locking_a_buffer_without_a_cart_makes_it_busy_then_without_a_cart() -> None:
    buffer = SimulatedBuffer(BUFFER1)
    host = Host(SimulatedLink([buffer]))
    host.send(BUFFER1, Lock())
    host.wait(0.9)
    assert host.told() == [BufferReport(2)]
    host.wait(0.2)
    assert host.told() == [BufferReport(0)]
    assert buffer.locked


def test_s58_three_devices_on_one_link_report_under_the_same_cmd() -> None:
    host = Host(SimulatedLink([agv(), SimulatedBuffer(BUFFER1, cart=True), SimulatedDoor(DOOR)]))
    host.wait(1.0)
    assert [(number, body) for _, number, body in host.heard] == [
        (AGV1, AgvReport()),
        (BUFFER1, BufferReport(1)),
        (DOOR, DoorReport(0)),
    ]


def test_s59_an_agv_is_silent_to_what_is_meant_for_another(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV2, Move("0003"))
    host.wait(0.9)
    assert host.told() == []
    assert one.report.path == 0


def test_s60_the_path_after_255_is_1(host: Host, one: SimulatedAgv) -> None:
    one.report.path = 255
    host.send(AGV1, Move("0002"))
    assert host.story()[-1] == "R 0000/1"
