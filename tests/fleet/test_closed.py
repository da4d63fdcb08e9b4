import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.domain.errors import NoRoute
from app.domain.units import Barcode
from app.fleet.closed import Closed, Place, Reason

A, B, C = Barcode("a"), Barcode("b"), Barcode("c")
CLEANING = Reason("closure 1", "the floor is cleaned there")
BROKEN = Reason("V001", "V001 stands there, on hold")


class Track:
    """Notes what is closed, as the router would."""

    def __init__(self) -> None:
        self.shut: list[Place] = []
        self.calls = 0

    def close(self, *places: Place) -> None:
        self.calls += 1
        assert not set(places) & set(self.shut)
        self.shut += places

    def open(self, *places: Place) -> None:
        self.calls += 1
        for place in places:
            self.shut.remove(place)


@pytest.fixture
def track() -> Track:
    return Track()


@pytest.fixture
def closed(track: Track) -> Closed:
    return Closed(track.close, track.open)


def test_a_place_opens_only_when_all_its_reasons_are_lifted(track: Track, closed: Closed) -> None:
    closed.shut(CLEANING, A, B)
    closed.shut(BROKEN, B, C)
    closed.lift(CLEANING, A, B)
    assert track.shut == [B, C]
    assert B in closed
    assert closed.why(B) == "V001 stands there, on hold"
    closed.lift(BROKEN, B, C)
    assert track.shut == []
    assert not len(closed)


def test_a_reason_counts_once_however_often_it_is_given(track: Track, closed: Closed) -> None:
    closed.shut(CLEANING, A)
    closed.shut(CLEANING, A)
    closed.lift(CLEANING, A)
    assert track.shut == []


def test_what_is_not_closed_for_a_reason_is_not_opened_by_it(track: Track, closed: Closed) -> None:
    closed.shut(CLEANING, A)
    closed.lift(BROKEN, A, B)
    assert track.shut == [A]


def test_the_words_of_a_reason_may_change(closed: Closed) -> None:
    closed.shut(BROKEN, A)
    closed.shut(Reason("V001", "V001 stands there, locked out"), A)
    assert closed.why(A) == "V001 stands there, locked out"
    edition = closed.edition
    closed.shut(Reason("V001", "V001 stands there, locked out"), A)
    assert closed.edition == edition
    closed.shut(Reason("V001", "V001 is there, silent"), A)
    assert closed.edition > edition
    assert len(closed.reasons(A)) == 1


def test_a_reason_may_move_to_other_places_as_a_whole(track: Track, closed: Closed) -> None:
    closed.shut_only(BROKEN, A, B)
    closed.shut_only(BROKEN, B, C)
    assert set(track.shut) == {B, C}
    assert closed.by(BROKEN) == (B, C)
    closed.shut_only(BROKEN)
    assert track.shut == []
    assert closed.by(BROKEN) == ()


def test_all_places_of_a_call_are_closed_at_once_and_none_that_is_closed_already(track: Track, closed: Closed) -> None:
    closed.shut(CLEANING, A, B)
    closed.shut(BROKEN, A, B)
    assert track.calls == 1
    closed.lift(CLEANING, A, B)
    assert track.calls == 1


def test_an_edge_is_another_place_than_its_ends(track: Track, closed: Closed) -> None:
    closed.shut(CLEANING, (A, B))
    assert (A, B) in closed
    assert A not in closed
    assert list(closed) == [(A, B)]


def test_a_new_version_tells_that_a_place_has_closed_or_opened_and_nothing_else_does(closed: Closed) -> None:
    versions = [closed.version]
    for change in (closed.shut, closed.lift):
        change(CLEANING, A, B)
        change(CLEANING, A)
        versions.append(closed.version)
    assert versions == sorted(set(versions))
    closed.shut(CLEANING, A)
    before = closed.version
    closed.shut(BROKEN, A)
    closed.lift(CLEANING, A)
    assert closed.version == before


def test_the_first_closed_place_on_a_way_is_found_but_not_where_it_begins(closed: Closed) -> None:
    assert closed.on([A, B, C]) is None
    closed.shut(BROKEN, A)
    assert closed.on([A, B, C]) is None
    closed.shut(BROKEN, C)
    assert closed.on([A, B, C]) == C
    closed.shut(CLEANING, (A, B))
    assert closed.on([A, B, C]) == (A, B)
    assert closed.told(C) == "c is closed (V001 stands there, on hold)"


def test_a_missing_way_is_explained_by_the_reasons_of_what_is_closed(closed: Closed) -> None:
    closed.shut(CLEANING, (A, B))
    closed.shut(BROKEN, (A, B))
    why = NoRoute("no route from x to y: a to b is closed", closed=(A, B))
    assert closed.explain(why) == f"{why.message} (the floor is cleaned there; V001 stands there, on hold)"
    assert closed.explain(NoRoute("no route from x to y")) == "no route from x to y"


@given(
    st.lists(st.tuples(st.booleans(), st.sampled_from("pqr"), st.lists(st.sampled_from([A, B, C, (A, B)]), max_size=3)))
)
def test_a_place_is_closed_just_while_somebody_wants_it_so(steps: list[tuple[bool, str, list[Place]]]) -> None:
    track, wanted = Track(), set[tuple[str, Place]]()
    closed = Closed(track.close, track.open)
    for shut, by, places in steps:
        (closed.shut if shut else closed.lift)(Reason(by, by), *places)
        mine = {(by, place) for place in places}
        wanted = wanted | mine if shut else wanted - mine
        assert set(track.shut) == set(closed) == {place for _, place in wanted}
        assert all(set(closed.by(Reason(name, ""))) == {p for who, p in wanted if who == name} for name in "pqr")
