"""Vehicles under way are led another way beyond what they hold: round what has closed, and where that has become quicker."""

from itertools import pairwise

import pytest

from app.domain.requests import MoveVehicle
from app.domain.units import Barcode
from app.fleet.closed import Reason
from app.fleet.reroutes import AGAIN_AFTER, LEAST_GAIN
from tests.fleet.branching import KIM, PLANT, V1, V2, branching, controller, driven, go
from tests.fleet.script import Script
from tests.planning.weights import weigh

WORKS = Reason("works", "the floor is cleaned")
SHORT = [Barcode(b) for b in ("104", "105", "106", "107", "110")]


@pytest.fixture
def script() -> Script:
    """V001 out of the way at 112, V002 at 101 on its way to 111."""
    script = branching()
    script.accept(go("112", V1))
    script.run(20)
    script.forget()
    script.accept(go("111"))
    return script


def jam(script: Script, seconds: float) -> None:
    """Let each edge of the short branch take so long."""
    edges = pairwise(SHORT)
    weigh(script.fleet.books.router, script.fleet.books.track, dict.fromkeys(edges, seconds))


def test_a_closure_ahead_is_driven_round_without_stopping_before_it(script: Script) -> None:
    script.run(0.5)
    script.fleet.books.closed.shut(WORKS, Barcode("107"))
    moves = len([i for i in script.kept_intents() if i.kind == "move"])
    script.run(40)
    assert script.vehicle(V2).barcode == "111"
    assert "203" in driven(script)
    assert "107" not in driven(script)
    assert len({i.cmd_id for i in script.kept_intents() if i.kind == "move"}) == max(moves, 1), "it stopped"
    assert (controller(script).led_round, controller(script).led_quicker) == (1, 0)


def test_what_it_holds_already_is_driven_though_closed_since(script: Script) -> None:
    script.run(0.5)
    held = script.vehicle(V2).ahead[-1]
    script.fleet.books.closed.shut(WORKS, held)
    script.run(40)
    assert script.vehicle(V2).barcode == "111"
    assert held in driven(script)


def test_a_way_that_has_become_much_slower_than_another_is_left(script: Script) -> None:
    script.run(0.5)
    jam(script, 20.0)
    script.run(40)
    assert "203" in driven(script)
    assert script.vehicle(V2).barcode == "111"
    assert controller(script).led_quicker == 1


def test_a_way_that_is_only_a_little_slower_is_kept(script: Script) -> None:
    script.run(0.5)
    books = script.fleet.books
    gain = books.router.time(Barcode("104"), Barcode("110"))
    books.closed.shut(WORKS, Barcode("106"))
    other = books.router.time(Barcode("104"), Barcode("110"))
    books.closed.lift(WORKS, Barcode("106"))
    assert other > gain
    jam(script, (other + LEAST_GAIN - 1) / 4)
    script.run(40)
    assert "106" in driven(script)
    assert controller(script).led_quicker == 0


def test_a_vehicle_does_not_change_its_mind_again_at_once(script: Script) -> None:
    script.toys[V2].paused = True
    script.run(1)
    vehicle, books = script.vehicle(V2), script.fleet.books
    jam(script, 20.0)
    script.run(2)
    assert "203" in vehicle.rest
    jam(script, 0.0)
    weigh(books.router, books.track, {(Barcode("203"), Barcode("204")): 200.0})
    script.run(AGAIN_AFTER - 5)
    assert "203" in vehicle.rest
    weigh(books.router, books.track, {(Barcode("203"), Barcode("204")): 201.0})
    script.run(8)
    weigh(books.router, books.track, {(Barcode("203"), Barcode("204")): 202.0})
    script.run(2)
    assert "203" not in vehicle.rest


def test_a_vehicle_that_is_committed_to_a_queue_stays_so_where_the_change_could_close_a_circle(
    script: Script, monkeypatch: pytest.MonkeyPatch
) -> None:
    script.run(0.5)
    rest = list(script.vehicle(V2).rest)
    monkeypatch.setattr(script.fleet.books.traffic, "turns", lambda *_: False)
    jam(script, 20.0)
    script.run(2)
    assert script.vehicle(V2).rest == rest[-len(script.vehicle(V2).rest) :]
    assert controller(script).led_quicker == 0


def test_one_that_stands_before_what_is_closed_goes_on_once_a_way_is_given(script: Script) -> None:
    books = script.fleet.books
    script.run(0.5)
    books.closed.shut(WORKS, Barcode("107"), Barcode("203"))
    books.traffic.close([Barcode("107"), Barcode("203")], "the floor is cleaned")
    script.run(30)
    assert script.vehicle(V2).waiting == "V002 waits at 106: 107 is closed (the floor is cleaned)"
    books.closed.shut(WORKS, Barcode("105"))
    books.closed.lift(WORKS, Barcode("107"))
    books.traffic.open([Barcode("107")])
    script.run(40)
    assert script.vehicle(V2).barcode == "111"


def test_a_person_is_told_what_closes_the_way() -> None:
    script = branching(PLANT)
    script.fleet.books.closed.shut(WORKS, Barcode("111"))
    refusal = script.refuse(MoveVehicle(KIM, V2, Barcode("112")))
    assert refusal.reason == "no route from 101 to 112: 111 is closed (the floor is cleaned)"
    assert "GET /api/v1/controller" in refusal.remedy
