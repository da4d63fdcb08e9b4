"""People, keys and sessions are kept, each change with one audit row, refused or not."""

from collections.abc import Iterator
from random import Random

import pytest

from app.domain.access import Key, Role, Session, User
from app.domain.errors import StoreError
from app.domain.ids import Actor
from app.domain.records import AuditRow
from app.domain.units import Timestamp
from app.store.access import AccessStore
from app.store.reading import Reader
from tests.store.conftest import NOW, Open

ROOT = Actor("root")
ADMIN, MES = frozenset({Role.ADMIN}), frozenset({Role.MES, Role.VIEWER})
LATER = Timestamp(NOW + 60)


@pytest.fixture
def store(url: str, open_ledger: Open) -> Iterator[AccessStore]:
    open_ledger(url)
    store = AccessStore(url, Random(7).randbytes)
    yield store
    store.close()


def user(name: str, roles: frozenset[Role] = ADMIN) -> User:
    return User(name, roles, f"hash of {name}", NOW, ROOT)


def key(name: str, roles: frozenset[Role] = MES, expires: Timestamp | None = None) -> Key:
    return Key(name, roles, f"digest of {name}", NOW, ROOT, expires)


def session(who: str, digest: str, log_in: str = "L1") -> Session:
    return Session(digest, log_in, who, NOW, LATER, "10.0.0.1")


def asked(url: str) -> list[tuple[str, str, str, bool]]:
    return [(row.action, row.target, row.detail, row.accepted) for _, row in Reader(url).audit()]


def test_all_come_back_as_they_went_in(store: AccessStore) -> None:
    secret = store.load().secret
    assert len(secret) == 32
    assert store.add_user(user("kim")) is None
    assert store.add_key(key("mes", expires=LATER)) is None
    assert store.log_in(session("kim", "d1")) is None
    known = store.load()
    assert known.secret == secret
    assert known.users[0] == User("kim", ADMIN, "hash of kim", NOW, ROOT, logged_in=NOW)
    assert known.keys == (key("mes", expires=LATER),)
    assert known.sessions == (session("kim", "d1"),)
    assert known.revision == store.revision() > 1


def test_each_change_has_one_audit_row(store: AccessStore, url: str) -> None:
    store.load()
    store.add_user(user("kim"))
    store.add_user(user("kim"))
    store.add_key(key("mes", expires=Timestamp(0.0)))
    store.log_in(session("kim", "d1"))
    store.log_out("kim", "L1", NOW)
    store.change_user("lee", ROOT, NOW, disabled=True)
    store.change_own_password("kim", "new hash", NOW, keep="L1")
    store.revoke_key("mes", ROOT, NOW)
    store.note(AuditRow(NOW, ROOT, "Forbidden", "POST /jobs", "", accepted=False))
    assert asked(url) == [
        ("AddUser", "kim", "roles admin", True),
        ("AddUser", "kim", "refused: There is a user kim already.", False),
        ("AddKey", "mes", "roles viewer, mes; until 1970-01-01T00:00:00Z", True),
        ("LogIn", "kim", "from 10.0.0.1", True),
        ("LogOut", "kim", "", True),
        ("ChangeUser", "lee", "refused: There is no user lee.", False),
        ("ChangePassword", "kim", "", True),
        ("RevokeKey", "mes", "", True),
        ("Forbidden", "POST /jobs", "", False),
    ]


@pytest.mark.parametrize("name", ["mes", "MES", "access-key", "Anonymous@10.0.0.1", "hoistway"])
def test_a_name_that_looks_like_another_is_refused(name: str, store: AccessStore) -> None:
    store.add_key(key("mes"))
    refusal = store.add_user(user(name))
    assert refusal is not None
    assert refusal.code == "conflict"


def test_the_last_administrator_stays(store: AccessStore) -> None:
    store.add_user(user("kim"))
    store.add_user(user("lee", MES))
    for changes in ({"disabled": True}, {"roles": MES}):
        refusal = store.change_user("kim", ROOT, NOW, **changes)
        assert refusal is not None
        assert "last administrator" in refusal.reason
    assert store.change_user("lee", ROOT, NOW, roles=ADMIN) is None
    assert store.change_user("kim", ROOT, NOW, disabled=True) is None


def test_a_key_that_is_the_last_administrator_is_not_revoked_and_one_that_expires_does_not_count(
    store: AccessStore,
) -> None:
    store.add_key(key("root-key", ADMIN))
    store.add_key(key("for-a-day", ADMIN, LATER))
    assert store.revoke_key("root-key", ROOT, NOW) is not None
    store.add_key(key("other", ADMIN))
    assert store.revoke_key("root-key", ROOT, NOW) is None
    again = store.revoke_key("root-key", ROOT, NOW)
    assert again is not None
    assert "revoked already" in again.reason


def test_who_is_disabled_or_gets_a_new_password_is_logged_out(store: AccessStore) -> None:
    for name in ("kim", "lee"):
        store.add_user(user(name))
        store.log_in(session(name, f"{name} 1", f"{name} A"))
        store.log_in(session(name, f"{name} 2", f"{name} B"))
    store.change_own_password("kim", "new", NOW, keep="kim B")
    store.change_user("lee", ROOT, NOW, password="new")
    assert [one.digest for one in store.load().sessions] == ["kim 2"]
    store.change_user("kim", ROOT, NOW, disabled=True)
    assert store.load().sessions == ()
    assert store.log_in(session("kim", "again")) is not None


def test_a_session_is_renewed_once_it_is_there(store: AccessStore) -> None:
    store.add_user(user("kim"))
    store.log_in(session("kim", "old"))
    assert store.renew(session("kim", "new"), "old", Timestamp(NOW + 1))
    assert {one.digest: one.expires for one in store.load().sessions} == {"old": NOW + 1, "new": LATER}
    store.log_out("kim", "L1", NOW)
    assert not store.renew(session("kim", "newer"), "new", NOW)


def test_sessions_that_are_over_go_at_the_next_log_in(store: AccessStore) -> None:
    store.add_user(user("kim"))
    store.log_in(session("kim", "old"))
    late = Timestamp(LATER + 1)
    store.log_in(Session("new", "L2", "kim", late, Timestamp(late + 1), "10.0.0.1"))
    assert [one.digest for one in store.load().sessions] == ["new"]


def test_a_better_hash_replaces_only_the_one_that_was_looked_at(store: AccessStore) -> None:
    store.add_user(user("kim"))
    store.rehash("kim", "another hash", "wrong")
    assert store.load().users[0].password == "hash of kim"
    store.rehash("kim", "hash of kim", "better")
    assert store.load().users[0].password == "better"


def test_use_is_noted_without_telling_anybody(store: AccessStore) -> None:
    store.add_key(key("mes"))
    before = store.load().revision
    store.note_used({"mes": LATER})
    assert store.load().keys[0].used == LATER
    assert store.revision() == before


def test_a_database_in_memory_is_refused() -> None:
    with pytest.raises(StoreError, match="in memory"):
        AccessStore("sqlite://", Random(7).randbytes)
