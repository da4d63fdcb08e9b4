"""Versions of the plant are kept: one is active whatever happens, and whoever asks is in the audit."""

from collections.abc import Iterator

import pytest
import sqlalchemy as sa

from app.domain.errors import PlantHeld, Refusal, StoreError
from app.domain.ids import Actor
from app.domain.units import Timestamp
from app.domain.versions import Origin, PlantVersion, Source, VersionState
from app.store.lease import NoLease
from app.store.reading import Reader
from app.store.versions import KEPT_REJECTED, MOST_STAGED, VersionStore
from tests.store.conftest import NOW, Open

LEE, KIM = Actor("lee"), Actor("kim")
LATER = Timestamp(NOW + 60)


@pytest.fixture
def store(url: str, open_ledger: Open) -> Iterator[VersionStore]:
    open_ledger(url)
    store = VersionStore(url)
    yield store
    store.close()


def begun(store: VersionStore) -> None:
    """Make version 1, which runs."""
    store.begin(Source("one"), KIM, NOW)
    store.tried(1, None, NOW)


def staged(store: VersionStore, text: str, reason: str = "a port more") -> PlantVersion:
    made = store.stage(Source(text), Origin.UPLOAD, LEE, reason, NOW)
    assert isinstance(made, PlantVersion)
    return made


def awaited(store: VersionStore, number: int, *, patient: bool = False) -> PlantVersion:
    made = store.ask(number, KIM, "night shift", LATER, patient=patient)
    assert isinstance(made, PlantVersion)
    return made


def activated(store: VersionStore, number: int, *, runs: bool = True) -> PlantVersion:
    """Activate an awaited version; ``runs``: a controller comes to run with it."""
    made = store.activate(number, LATER, NoLease())
    if runs:
        store.tried(number, None, LATER)
    return made


def states(store: VersionStore) -> dict[int, str]:
    return {version.number: version.state.value for version in store.versions()}


def test_the_first_plant_file_is_version_1_and_active(store: VersionStore) -> None:
    assert store.active() is None
    first = store.begin(Source("plant"), KIM, NOW)
    assert first == store.active() == store.version(1)
    assert (first.number, first.state, first.origin, first.size) == (1, VersionState.ACTIVE, Origin.FILE, 5)
    assert store.text(1) == "plant"
    assert store.file_taken() == first.digest
    with pytest.raises(StoreError, match="another controller has begun"):
        store.begin(Source("other"), KIM, NOW)


def test_a_version_goes_from_staged_over_awaited_to_active_and_the_one_before_can_come_back(
    store: VersionStore,
) -> None:
    begun(store)
    assert staged(store, "two").number == 2
    wish = awaited(store, 2, patient=True)
    assert (wish.state, wish.asked, wish.asked_by, wish.asked_why) == (VersionState.AWAITED, LATER, KIM, "night shift")
    assert store.awaited() == wish
    made = activated(store, 2)
    assert (made.before, made.activated, made.activated_by, made.why) == (1, LATER, KIM, "night shift")
    assert (made.asked, made.asked_by, made.patient) == (None, None, False)
    assert states(store) == {1: "former", 2: "active"}
    awaited(store, 1)
    assert activated(store, 1).before == 2
    assert states(store) == {1: "active", 2: "former"}


def test_a_wish_that_comes_to_nothing_leaves_the_version_as_it_was_and_says_why(store: VersionStore) -> None:
    store.begin(Source("one"), KIM, NOW)
    staged(store, "two")
    awaited(store, 2)
    store.give_up(2, "job J1 names P2", LATER)
    found = store.version(2)
    assert found is not None
    assert (found.state, found.note, found.asked) == (VersionState.STAGED, "job J1 names P2", None)
    with pytest.raises(StoreError, match="not wanted any more"):
        store.activate(2, LATER, NoLease())
    assert states(store) == {1: "active", 2: "staged"}


def test_a_version_that_cannot_be_run_is_rejected_and_the_one_before_is_active_again(store: VersionStore) -> None:
    begun(store)
    staged(store, "two")
    awaited(store, 2)
    activated(store, 2, runs=False)
    back = store.fall_back(2, "no such address", LATER, NoLease())
    assert back is not None
    assert back.number == 1
    assert states(store) == {1: "active", 2: "rejected"}
    assert store.fall_back(1, "nothing before", LATER, NoLease()) is None
    assert states(store) == {1: "active", 2: "rejected"}


def test_a_version_that_has_run_since_it_became_active_is_not_fallen_back_from(store: VersionStore) -> None:
    begun(store)
    staged(store, "two")
    awaited(store, 2)
    activated(store, 2)
    assert store.fall_back(2, "no such address", LATER, NoLease()) is None
    assert states(store) == {1: "former", 2: "active"}


def test_a_version_that_ran_before_and_cannot_be_run_now_can_be_tried_again_later(store: VersionStore) -> None:
    begun(store)
    staged(store, "two")
    awaited(store, 2)
    activated(store, 2)
    awaited(store, 1)
    activated(store, 1, runs=False)
    assert store.fall_back(1, "the address is taken", LATER, NoLease()) == store.version(2)
    found = store.version(1)
    assert found is not None
    assert (found.state, found.note) == (VersionState.FORMER, "the address is taken")


def test_the_way_back_leads_past_a_version_that_never_ran(store: VersionStore) -> None:
    begun(store)
    staged(store, "two")
    staged(store, "three")
    awaited(store, 2)
    activated(store, 2, runs=False)
    awaited(store, 3)
    assert activated(store, 3).before == 1
    assert states(store) == {1: "former", 2: "staged", 3: "active"}


@pytest.mark.parametrize(
    ("number", "reason"),
    [
        (1, "Version 1 is the active one."),
        (3, "Version 2 is to become active already."),
        (4, "Version 4 is rejected: kim: typing error"),
        (9, "There is no version 9."),
    ],
)
def test_what_cannot_become_active_is_refused_with_the_reason(store: VersionStore, number: int, reason: str) -> None:
    store.begin(Source("one"), KIM, NOW)
    for text in ("two", "three", "four"):
        staged(store, text)
    awaited(store, 2)
    store.reject(4, KIM, "typing error", LATER)
    refusal = store.ask(number, KIM, "now", LATER, patient=False)
    assert isinstance(refusal, Refusal)
    assert refusal.reason == reason


def test_a_staged_version_is_rejected_a_former_one_only_stays_and_an_active_one_neither(store: VersionStore) -> None:
    begun(store)
    staged(store, "two")
    awaited(store, 2)
    activated(store, 2)
    awaited(store, 1)
    kept = store.reject(1, KIM, "not today", LATER)
    assert isinstance(kept, PlantVersion)
    assert (kept.state, kept.note) == (VersionState.FORMER, "kim took the wish back: not today")
    assert isinstance(store.reject(2, KIM, "not today", LATER), Refusal)
    assert staged(store, "three").number == 3
    assert isinstance(store.reject(3, KIM, "wrong bay", LATER), PlantVersion)
    assert states(store) == {1: "former", 2: "active", 3: "rejected"}


def test_the_same_text_is_not_kept_twice_while_the_first_can_be_used(store: VersionStore) -> None:
    store.begin(Source("one"), KIM, NOW)
    same = store.stage(Source("one"), Origin.UPLOAD, LEE, "again", NOW)
    assert isinstance(same, Refusal)
    assert same.reason == "That is the active version 1, to the letter."
    staged(store, "two")
    again = store.stage(Source("two"), Origin.UPLOAD, LEE, "again", NOW)
    assert isinstance(again, Refusal)
    assert again.remedy == "Activate that one: POST /api/v1/layout/versions/2/activate."
    store.reject(2, KIM, "wrong", NOW)
    assert staged(store, "two").number == 3


def test_pages_of_versions_go_from_new_to_old(store: VersionStore) -> None:
    store.begin(Source("one"), KIM, NOW)
    for number in range(2, 7):
        staged(store, str(number))
    assert [version.number for version in store.versions(limit=3)] == [6, 5, 4]
    assert [version.number for version in store.versions(after=4)] == [3, 2, 1]


def test_two_versions_can_never_be_active(store: VersionStore, raw: sa.Engine) -> None:
    store.begin(Source("one"), KIM, NOW)
    staged(store, "two")
    with pytest.raises(sa.exc.IntegrityError), raw.begin() as connection:
        connection.execute(sa.text("UPDATE plant_versions SET state = 'active' WHERE number = 2"))


def test_whatever_is_asked_of_versions_is_in_the_audit_once(store: VersionStore, url: str) -> None:
    store.begin(Source("one"), KIM, NOW)
    staged(store, "two")
    store.ask(2, KIM, "now", LATER, patient=False, refusal=Refusal("not-now", "job J1 is in the way"))
    awaited(store, 2)
    store.activate(2, LATER, NoLease())
    store.reject(2, KIM, "too late", LATER)
    reader = Reader(url)
    rows = [(row.actor, row.action, row.target, row.detail, row.accepted) for _, row in reader.audit()]
    reader.close()
    assert rows == [
        ("kim", "BeginLayout", "version 1", "the first start on this database", True),
        ("lee", "StageLayout", "version 2", "a port more", True),
        ("kim", "ActivateLayout", "version 2", "refused: job J1 is in the way", False),
        ("kim", "ActivateLayout", "version 2", "night shift", True),
        ("kim", "ChangeLayout", "version 2", "instead of version 1: night shift", True),
        ("kim", "RejectLayout", "version 2", "refused: Version 2 is active.", False),
    ]


def test_a_version_becomes_active_only_while_the_plant_is_held(store: VersionStore) -> None:
    class Lost(NoLease):
        """Another controller has come meanwhile."""

        def verify(self, connection: sa.Connection) -> None:
            raise PlantHeld("plant P1 is held by the standby")

    begun(store)
    staged(store, "two")
    awaited(store, 2)
    with pytest.raises(PlantHeld):
        store.activate(2, LATER, Lost())
    assert states(store) == {1: "active", 2: "awaited"}
    activated(store, 2, runs=False)
    with pytest.raises(PlantHeld):
        store.fall_back(2, "no such address", LATER, Lost())
    assert states(store) == {1: "former", 2: "active"}


def test_texts_of_versions_rejected_long_ago_are_thrown_away_and_what_ran_is_kept_for_good(store: VersionStore) -> None:
    begun(store)
    staged(store, "two")
    awaited(store, 2)
    activated(store, 2)
    for number in range(3, KEPT_REJECTED + 6):
        staged(store, str(number))
    order = [KEPT_REJECTED + 5, *range(3, KEPT_REJECTED + 5)]
    for later, number in enumerate(order):
        store.reject(number, KIM, "not this one", Timestamp(LATER + later))
    thrown = order[:-KEPT_REJECTED]
    assert [number for number in range(1, KEPT_REJECTED + 6) if store.text(number) is None] == sorted(thrown)
    found = store.version(thrown[0])
    assert found is not None
    assert (found.state, found.reason, found.pruned) == (VersionState.REJECTED, "a port more", LATER + KEPT_REJECTED)
    assert (store.text(1), store.text(2)) == ("one", "two")


def test_so_many_versions_can_be_staged_at_once_and_no_more(store: VersionStore) -> None:
    begun(store)
    for number in range(2, MOST_STAGED + 2):
        staged(store, str(number))
    refusal = store.stage(Source("one more"), Origin.UPLOAD, LEE, "a port more", NOW)
    assert isinstance(refusal, Refusal)
    assert refusal.reason == f"{MOST_STAGED} versions are staged already."
    store.reject(7, KIM, "not this one", LATER)
    staged(store, "one more")
    assert isinstance(store.stage(Source("the file"), Origin.FILE, LEE, "edited", NOW, again=True), PlantVersion)
