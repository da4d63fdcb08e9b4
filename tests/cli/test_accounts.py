"""``hoistway users``, ``keys`` and ``audit``, on a database that is new, in use, or tampered with."""

import re
import sqlite3
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from app.cli import app
from app.domain.access import Role
from app.domain.ids import Actor
from app.domain.records import AuditRow
from app.domain.units import Timestamp
from app.runtime.access import digest_of
from app.store.access import AccessStore
from app.store.ledger import SqlLedger

PASSWORD = "correct horse 1"


@pytest.fixture
def url(tmp_path: Path) -> str:
    return f"sqlite:///{tmp_path}/plant.db"


def run(url: str, *arguments: str, given: str | None = None) -> Result:
    return CliRunner().invoke(app, [*arguments, "--database", url], input=given)


def known(url: str) -> AccessStore:
    return AccessStore(url, lambda n: b"\0" * n)


def test_the_first_administrator_is_added_before_the_server_ever_ran(url: str) -> None:
    added = run(url, "users", "add", "kim", "--role", "admin", given=f"{PASSWORD}\n{PASSWORD}\n")
    assert added.exit_code == 0, added.output
    assert "kim may log in." in added.output
    assert PASSWORD not in added.output
    listed = run(url, "users", "list")
    assert re.match(r"kim +admin +never", listed.output)


def test_a_key_is_printed_once_and_kept_as_a_digest(url: str) -> None:
    made = run(url, "keys", "add", "mes-1", "--role", "mes", "--role", "viewer", "--days", "30")
    key = made.stdout.splitlines()[0]
    store = known(url)
    kept = store.load()
    assert kept.keys[0].digest == digest_of(kept.secret, key.encode())
    assert kept.keys[0].roles == {Role.MES, Role.VIEWER}
    assert kept.keys[0].expires is not None
    store.close()
    assert key not in run(url, "keys", "list").output
    assert run(url, "keys", "revoke", "mes-1").exit_code == 0
    assert "revoked" in run(url, "keys", "list").output
    assert run(url, "keys", "revoke", "mes-1").exit_code == 1


def test_people_are_changed_and_the_last_administrator_is_not(url: str) -> None:
    for name, role in (("kim", "admin"), ("lee", "operator")):
        run(url, "users", "add", name, "--role", role, "--password-stdin", given=f"{PASSWORD}\n")
    assert run(url, "users", "change", "kim", "--disable").exit_code == 1
    assert run(url, "users", "change", "lee", "--role", "maintenance", "--role", "admin").exit_code == 0
    assert run(url, "users", "change", "kim", "--disable").exit_code == 0
    assert run(url, "users", "password", "lee", "--password-stdin", given="another horse 3\n").exit_code == 0
    assert re.search(r"kim +disabled", run(url, "users", "list").output)
    assert run(url, "users", "change", "lee").exit_code == 1


@pytest.mark.parametrize(
    ("name", "password", "why"),
    [
        ("a b", PASSWORD, "is no name"),
        ("kim", "short", "10 to 200"),
        ("kim", "kim is my name", "must not hold the name"),
    ],
)
def test_what_the_api_would_refuse_is_refused_here(name: str, password: str, why: str, url: str) -> None:
    refused = run(url, "users", "add", name, "--role", "admin", "--password-stdin", given=f"{password}\n")
    assert refused.exit_code == 1
    assert why in refused.output


def test_it_works_while_a_controller_has_the_plant(url: str) -> None:
    ledger = SqlLedger(url, "P1", "the controller", lambda: Timestamp(1.0))
    ledger.load()
    assert run(url, "keys", "add", "mes-1", "--role", "mes").exit_code == 0
    ledger.commit([AuditRow(Timestamp(2.0), Actor("kim"), "CreateJob", "J1", "", accepted=True)])
    ledger.close()
    assert "2 rows follow from one another." in run(url, "audit", "verify").output


def test_a_tampered_audit_is_found_and_so_is_one_that_was_cut_short(url: str, tmp_path: Path) -> None:
    for number in range(4):
        run(url, "keys", "add", f"mes-{number}", "--role", "mes")
    verified = run(url, "audit", "verify")
    head = verified.stdout.rsplit(" ", 1)[1].strip()
    assert run(url, "audit", "verify", "--head", head).exit_code == 0
    with sqlite3.connect(tmp_path / "plant.db") as connection:
        connection.execute("DELETE FROM audit WHERE seq = 4")
    assert run(url, "audit", "verify").exit_code == 0
    cut = run(url, "audit", "verify", "--head", head)
    assert (cut.exit_code, "row 4 is not what it was" in cut.output) == (1, True)
    with sqlite3.connect(tmp_path / "plant.db") as connection:
        connection.execute("UPDATE audit SET target = 'mes-9' WHERE seq = 2")
    broken = run(url, "audit", "verify")
    assert (broken.exit_code, "row 2 has been changed" in broken.output) == (1, True)
    assert run(url, "audit", "verify", "--head", "four").exit_code == 1
