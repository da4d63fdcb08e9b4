"""Audit walks: what is believed, what was seen, and a named person who accepts it (DOMAIN section 2)."""

from app.domain.ids import Actor, CarrierId, StationId
from app.domain.records import Provenance
from app.domain.requests import WriteCarrier, WriteStation
from app.domain.view import CarrierView, StationView, Topic, WalkView
from app.domain.walks import AbandonWalk, AcceptWalk, EnterSights, Finding, Sight, StartWalk
from tests.fleet.drives import KIM
from tests.fleet.script import B1, B2, FOUP1, FOUP2, HOST, P1, Script

LEE = Actor("lee")
OUTAGE = "after the outage"


def begin(script: Script, *stations: StationId) -> int:
    return int(script.accept(StartWalk(KIM, OUTAGE, stations)).key)


def enter(script: Script, walk: int, *sights: Sight) -> None:
    script.wait(1)
    script.accept(EnterSights(LEE, walk, sights))


def findings(script: Script, walk: int) -> dict[str, str]:
    walks = script.fleet._desk._walks
    return {place.station: walks.finding(place).value for place in script.fleet.books.walk_places[walk].values()}


def test_a_walk_goes_along_every_side_buffer_and_knows_what_was_believed(ready: Script) -> None:
    walk = begin(ready)
    places = ready.fleet.books.walk_places[walk]
    assert list(places) == ["B1", "B2"]
    assert (places[B1].believed, places[B1].believed_carrier) == (True, FOUP2)
    view = ready.model[Topic.WALKS][str(walk)]
    assert isinstance(view, WalkView)
    assert (view.state, view.places, view.entered, view.actor) == ("open", 2, 0, "kim")


def test_what_was_seen_is_compared_and_accepted_as_verified(ready: Script) -> None:
    walk = begin(ready)
    enter(ready, walk, Sight(B1, present=False), Sight(B2, present=True, carrier=FOUP2))
    assert findings(ready, walk) == {"B1": "differs", "B2": "differs"}
    ready.accept(AcceptWalk(KIM, walk))
    assert (ready.station(B1).present, ready.station(B1).carrier) == (False, None)
    assert (ready.station(B2).present, ready.station(B2).carrier) == (True, FOUP2)
    assert {ready.station(name).provenance for name in (B1, B2)} == {Provenance.VERIFIED}
    station, carrier = ready.model[Topic.STATIONS][B2], ready.model[Topic.CARRIERS][FOUP2]
    assert isinstance(station, StationView)
    assert isinstance(carrier, CarrierView)
    assert station.verified
    assert (carrier.place, carrier.provenance, carrier.verified) == ("B2", "verified", True)
    assert str(walk) not in ready.model[Topic.WALKS]
    assert ready.events()[-1] == "WalkEnded"


def test_two_carriers_that_were_exchanged_are_where_they_were_seen(ready: Script) -> None:
    ready.accept(WriteCarrier(HOST, CarrierId("F3"), "B2"))
    walk = begin(ready)
    enter(ready, walk, Sight(B1, present=True, carrier=CarrierId("F3")), Sight(B2, present=True, carrier=FOUP2))
    ready.accept(AcceptWalk(KIM, walk))
    assert (ready.station(B1).carrier, ready.station(B2).carrier) == ("F3", FOUP2)


def test_a_place_that_agrees_is_verified_too_and_an_unreadable_id_keeps_the_believed_one(ready: Script) -> None:
    walk = begin(ready, B1)
    enter(ready, walk, Sight(B1, present=True))
    assert findings(ready, walk) == {"B1": "agrees"}
    ready.accept(AcceptWalk(KIM, walk))
    record = ready.station(B1)
    assert (record.carrier, record.provenance) == (FOUP2, Provenance.VERIFIED)


def test_what_was_not_seen_or_has_changed_since_is_not_accepted_unasked(ready: Script) -> None:
    walk = begin(ready)
    enter(ready, walk, Sight(B1, present=True))
    ready.wait(1)
    ready.accept(WriteStation(HOST, B1, present=False))
    assert findings(ready, walk) == {"B1": "moved", "B2": "not_seen"}
    for partial in (False, True):
        refusal = ready.refuse(AcceptWalk(KIM, walk, partial))
        assert (refusal.code, refusal.reason) == ("conflict", "all that was entered has changed since")
    enter(ready, walk, Sight(B2, present=False))
    refusal = ready.refuse(AcceptWalk(KIM, walk))
    assert refusal.reason == "not seen, or changed since: B1"
    ready.accept(AcceptWalk(KIM, walk, partial=True))
    assert (ready.station(B1).present, ready.station(B1).provenance) == (False, Provenance.HOST)
    assert ready.station(B2).provenance is Provenance.VERIFIED


def test_a_walk_on_which_nothing_was_entered_is_not_accepted_but_abandoned(ready: Script) -> None:
    walk = begin(ready)
    for partial in (False, True):
        refusal = ready.refuse(AcceptWalk(KIM, walk, partial))
        assert (refusal.reason, refusal.remedy) == (
            "nothing was entered",
            "look again and enter it, or abandon the walk",
        )
    ready.accept(AbandonWalk(KIM, walk, "nobody went"))
    assert ready.events()[-1] == "WalkEnded"


def test_what_was_accepted_keeps_its_finding_though_the_books_are_changed_by_it(ready: Script) -> None:
    walk = begin(ready)
    enter(ready, walk, Sight(B1, present=True), Sight(B2, present=True, carrier=CarrierId("F9")))
    ready.wait(1)
    places = ready.fleet.books.walk_places[walk]
    ready.accept(AcceptWalk(KIM, walk))
    found = {}
    for place in places.values():
        record = ready.station(place.station)
        found[place.station] = place.finding(record.present, record.carrier, record.at)
    assert found == {B1: Finding.AGREES, B2: Finding.DIFFERS}


def test_a_carrier_seen_twice_is_looked_for_again(ready: Script) -> None:
    walk = begin(ready)
    enter(ready, walk, Sight(B1, present=True, carrier=FOUP1), Sight(B2, present=True, carrier=FOUP1))
    assert ready.refuse(AcceptWalk(KIM, walk)).reason == "FOUP0001 was seen at two places"
    enter(ready, walk, Sight(B2, present=False))
    ready.accept(AcceptWalk(KIM, walk))
    assert (ready.station(B1).carrier, ready.station(P1).carrier) == (FOUP1, None)


def test_entries_are_all_or_nothing_and_say_what_is_wrong(ready: Script) -> None:
    walk = begin(ready)
    wrong = (Sight(B1, present=False), Sight(P1, present=True))
    assert ready.refuse(EnterSights(LEE, walk, wrong)).reason == f"P1 is not on walk {walk}"
    assert findings(ready, walk)["B1"] == Finding.NOT_SEEN
    odd = (Sight(B1, present=False, carrier=FOUP1),)
    refusal = ready.refuse(EnterSights(LEE, walk, odd))
    assert (refusal.field, refusal.reason) == ("carrier", "FOUP0001 cannot be at B1 while nothing is present there")
    assert ready.refuse(EnterSights(LEE, 99, ())).code == "not-found"
    assert ready.refuse(StartWalk(LEE, "x", (StationId("P9"),))).field == "stations"
    assert ready.refuse(StartWalk(LEE, "x", (B2,))).reason == f"walk {walk} of kim is at B2"


def test_a_walk_outlives_a_restart_and_an_abandoned_one_changes_nothing(ready: Script) -> None:
    walk = begin(ready)
    enter(ready, walk, Sight(B1, present=False))
    ready.restart()
    ready.obey()
    assert findings(ready, walk) == {"B1": "differs", "B2": "not_seen"}
    ready.accept(AbandonWalk(LEE, walk, "called away"))
    assert ready.station(B1).carrier == FOUP2
    assert begin(ready) == walk + 1
