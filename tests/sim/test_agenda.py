import pytest

from app.domain.units import Seconds
from app.sim.agenda import Agenda, Standstill, Watchdog
from tests.runtime.peers import Echo


def test_acts_happen_in_order_of_time_and_those_of_one_instant_in_order_of_entry() -> None:
    agenda, seen = Agenda(), []
    for when, name in ((2.0, "c"), (1.0, "a"), (1.0, "b")):
        agenda.at(when, lambda name=name: seen.append(name))  # type: ignore[misc]
    agenda.run(5.0)
    assert seen == ["a", "b", "c"]
    assert agenda.now == 5.0


def test_an_act_in_the_past_happens_next_without_turning_time_back() -> None:
    agenda, seen = Agenda(), []
    agenda.run(3.0)
    agenda.at(1.0, lambda: seen.append(agenda.now))
    agenda.run(4.0)
    assert seen == [3.0]


def test_time_stops_where_it_is_told_to() -> None:
    agenda, seen = Agenda(), []
    agenda.after(2.0, lambda: seen.append("late"))
    agenda.run(1.5)
    assert seen == []
    assert agenda.now == 1.5


def test_endless_acts_at_one_instant_are_found() -> None:
    agenda = Agenda()

    def again() -> None:
        agenda.after(0.0, again)

    again()
    with pytest.raises(Standstill):
        agenda.run(1.0)


def test_a_watchdog_ticks_at_the_deadline_and_not_at_one_that_moved() -> None:
    agenda, echo = Agenda(), Echo()
    watchdog = Watchdog(agenda, echo, lambda: None)
    echo.deadline = Seconds(1.0)
    watchdog.rearm()
    echo.deadline = Seconds(3.0)
    watchdog.rearm()
    agenda.run(2.0)
    assert echo.notes == []
    agenda.run(3.0)
    assert echo.notes == ["tick"]


def test_a_deadline_that_comes_nearer_is_kept() -> None:
    agenda, echo = Agenda(), Echo()
    watchdog = Watchdog(agenda, echo, lambda: None)
    echo.deadline = Seconds(9.0)
    watchdog.rearm()
    echo.deadline = Seconds(1.0)
    watchdog.rearm()
    agenda.run(2.0)
    assert echo.notes == ["tick"]
    agenda.run(10.0)
    assert echo.notes == ["tick"]


def test_a_stopped_watchdog_ticks_no_more() -> None:
    agenda, echo = Agenda(), Echo()
    watchdog = Watchdog(agenda, echo, lambda: None)
    echo.deadline = Seconds(1.0)
    watchdog.rearm()
    watchdog.stop()
    agenda.run(2.0)
    assert echo.notes == []
