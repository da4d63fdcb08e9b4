from app.wire.agenda import Agenda


def test_acts_happen_in_order_of_time_and_then_of_entry() -> None:
    agenda, done = Agenda(), list[str]()
    agenda.after(2.0, lambda: done.append("later"))
    agenda.after(1.0, lambda: done.append("first"))
    agenda.after(1.0, lambda: done.append("second"))
    assert agenda.deadline == 1.0
    agenda.run(1.5)
    assert done == ["first", "second"]
    agenda.run(9.0)
    assert done == ["first", "second", "later"]
    assert agenda.deadline is None


def test_what_follows_from_an_act_is_timed_from_the_act() -> None:
    agenda, done = Agenda(), list[float]()

    def begin() -> None:
        agenda.after(1.0, lambda: done.append(agenda.now))

    agenda.after(1.0, begin)
    agenda.run(10.0)
    assert done == [2.0]
    assert agenda.now == 10.0


def test_what_is_cancelled_does_not_happen_and_a_clock_that_goes_back_is_ignored() -> None:
    agenda, done = Agenda(), list[str]()
    due = agenda.after(1.0, lambda: done.append("no"))
    assert not due.cancelled
    due.cancel()
    due.act()
    agenda.after(2.0, lambda: done.append("no"))
    agenda.clear()
    agenda.run(5.0)
    agenda.run(3.0)
    assert done == []
    assert agenda.now == 5.0
