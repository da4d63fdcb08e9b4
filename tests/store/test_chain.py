"""The audit is a chain: whoever changes a row, takes one out or puts one in breaks it, and the first broken row is named."""

from dataclasses import replace
from random import Random

import pytest
import sqlalchemy as sa
from alembic import command

from app.domain.access import Role, User
from app.domain.ids import Actor
from app.domain.records import AuditRow
from app.domain.units import Timestamp
from app.store import schema
from app.store.access import AccessStore
from app.store.chain import Checked
from app.store.engine import parsed, writing
from app.store.ledger import SqlLedger
from app.store.reading import Reader
from tests.store.conftest import NOW, Open
from tests.store.samples import audit, event

ODD = AuditRow(NOW, Actor("kim"), "Said", "V\ud8001", 'a\0b "\u1100" \N{GRINNING FACE}', accepted=True)
"""What no database keeps as it is: half a surrogate pair, NUL."""


@pytest.fixture
def reader(url: str) -> Reader:
    return Reader(url)


@pytest.fixture
def ledger(url: str, open_ledger: Open) -> SqlLedger:
    ledger = open_ledger(url)
    ledger.load()
    return ledger


def checked(reader: Reader) -> Checked:
    return reader.audit_checked(0, 1000)


def test_rows_written_together_and_apart_follow_from_one_another(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([audit("a"), event(1), audit("b")])
    ledger.commit([event(2)])
    ledger.commit([audit("c"), ODD])
    found = checked(reader)
    assert (found.rows, found.last, found.broken) == (4, 4, None)
    assert reader.audit_checked(2, 1) == Checked(1, 3, reader.audit_checked(0, 3).hash)
    assert reader.audit_checked(0, 2).last == 2
    assert reader.audit_checked(9, 2).reason == "there is no row 9"


@pytest.mark.parametrize(
    "tampering",
    [
        "UPDATE audit SET actor = 'lee' WHERE seq = 3",
        "UPDATE audit SET accepted = NOT accepted WHERE seq = 3",
        "UPDATE audit SET at = at + 1 WHERE seq = 3",
        "UPDATE audit SET detail = detail || ' ' WHERE seq = 3",
        "DELETE FROM audit WHERE seq = 2",
        "UPDATE audit SET seq = 30 WHERE seq = 3",
        "INSERT INTO audit SELECT 0, at, actor, action, target, detail, accepted, hash FROM audit WHERE seq = 3",
    ],
)
def test_a_row_that_was_tampered_with_is_named(
    tampering: str, ledger: SqlLedger, reader: Reader, raw: sa.Engine
) -> None:
    ledger.commit([audit(name) for name in "abcd"])
    with raw.begin() as connection:
        connection.execute(sa.text(tampering))
    broken = reader.audit_checked(0, 1000) if "INSERT" not in tampering else reader.audit_checked(-1, 1000)
    assert broken.broken == {"INSERT INTO": -1}.get(tampering[:11], 4 if "30" in tampering else 3)


def test_a_new_row_follows_what_is_there_after_a_restart(url: str, open_ledger: Open, reader: Reader) -> None:
    first = open_ledger(url)
    first.load()
    first.commit([audit("a")])
    first.close()
    second = open_ledger(url)
    second.load()
    second.commit([audit("b")])
    assert (checked(reader).rows, checked(reader).broken) == (2, None)


def test_the_command_line_may_add_to_the_audit_while_the_controller_runs(
    url: str, ledger: SqlLedger, reader: Reader
) -> None:
    beside = AccessStore(url, Random(1).randbytes)
    for number in range(3):
        ledger.commit([audit(f"mine {number}"), event(number + 1)])
        user = User(f"kim{number}", frozenset({Role.ADMIN}), "x", Timestamp(2.0), Actor("root"))
        assert beside.add_user(user) is None
    ledger.commit([audit("last")])
    beside.close()
    actions = [row.action for _, row in reader.audit()]
    assert actions == ["mine 0", "AddUser", "mine 1", "AddUser", "mine 2", "AddUser", "last"]
    assert (checked(reader).rows, checked(reader).broken) == (7, None)
    assert [one.seq for one in reader.events()] == [1, 2, 3]


def test_an_audit_from_before_is_chained_when_the_plant_is_opened(
    url: str, open_ledger: Open, raw: sa.Engine, reader: Reader
) -> None:
    engine = writing(parsed(url))
    with engine.begin() as connection:
        config = schema._config()
        config.attributes["connection"] = connection
        command.upgrade(config, "r0010")
        for number in (1, 2, 5):
            values = {"seq": number, "at": 1.5 + number, "detail": 'was "\u1100"', "accepted": number != 2}
            names = "seq, at, actor, action, target, detail, accepted"
            connection.execute(
                sa.text(f"INSERT INTO audit ({names}) VALUES (:seq, :at, 'kim', 'Old', 'V1', :detail, :accepted)"),
                values,
            )
    engine.dispose()
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit([audit("new")])
    found = checked(reader)
    assert (found.rows, found.last, found.broken) == (4, 6, None)
    with raw.begin() as connection:
        connection.execute(sa.text("UPDATE audit SET actor = 'lee' WHERE seq = 2"))
    assert checked(reader).broken == 2


def test_what_is_looked_for_in_the_audit_comes_newest_first(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([audit("a"), audit("b"), audit("a"), audit("a")])
    assert [seq for seq, _ in reader.audit_found(action="a", limit=2)] == [4, 3]
    assert [seq for seq, _ in reader.audit_found(action="a", before=3)] == [1]
    assert reader.audit_found(actor="nobody", target="none") == []


def test_the_audit_is_searched_by_when_and_by_whether_it_was_carried_out(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([replace(audit("a"), at=Timestamp(at), accepted=at != 20.0) for at in (10.0, 20.0, 30.0)])
    assert [seq for seq, _ in reader.audit_found(begin=20.0)] == [3, 2]
    assert [seq for seq, _ in reader.audit_found(begin=10.0, end=30.0)] == [2, 1]
    assert [seq for seq, _ in reader.audit_found(accepted=False)] == [2]
    assert [seq for seq, _ in reader.audit_found(accepted=True, end=30.0)] == [1]
