"""A database that its reader may not write: on a read-only disk, or another user's."""

import os
import shutil
import sqlite3
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli import app
from app.domain.units import Timestamp
from app.store.ledger import SqlLedger

NOBODY = 65_534


def hoistway(*words: str) -> tuple[int, str]:
    result = CliRunner().invoke(app, words)
    return result.exit_code, result.output


@pytest.fixture
def locked() -> Iterator[Path]:
    """A plant's database that this process may not write while it is used: it is somebody else's for root, too."""
    directory = Path(tempfile.mkdtemp())
    file = directory / "plant.db"
    SqlLedger(f"sqlite:///{file}", "P1", "server A", lambda: Timestamp(0.0)).close()
    code, said = hoistway("keys", "add", "mes", "--role", "mes", "--database", f"sqlite:///{file}")
    assert code == 0, said
    code, said = hoistway("keys", "revoke", "mes", "--database", f"sqlite:///{file}")
    assert code == 0, said
    file.chmod(0o444)
    directory.chmod(0o555)
    user = os.geteuid()
    if user == 0:
        os.seteuid(NOBODY)
    try:
        yield file
    finally:
        os.seteuid(user)
        directory.chmod(0o755)
        shutil.rmtree(directory)


def test_it_is_as_it_says(locked: Path) -> None:
    with pytest.raises(PermissionError):
        (locked.parent / "more").touch()


def test_its_audit_is_verified(locked: Path) -> None:
    code, said = hoistway("audit", "verify", "--database", f"sqlite:///{locked}")
    assert (code, said.partition(".")[0]) == (0, "2 rows follow from one another")
    assert sorted(path.name for path in locked.parent.iterdir()) == ["plant.db", "plant.db.lock"]


def test_who_may_log_in_is_listed(locked: Path) -> None:
    database = f"sqlite:///{locked}"
    code, said = hoistway("keys", "list", "--database", database)
    assert (code, said.split()) == (0, ["mes", "mes", "revoked", "never", "used"])
    assert hoistway("users", "list", "--database", database) == (0, "")
    assert sorted(path.name for path in locked.parent.iterdir()) == ["plant.db", "plant.db.lock"]
    code, said = hoistway("keys", "add", "more", "--role", "mes", "--database", database)
    assert code == 1
    assert "hoistway: " in said


def test_its_schema_is_told_and_it_is_backed_up_elsewhere(locked: Path) -> None:
    code, said = hoistway("db", "current", "--url", f"sqlite:///{locked}")
    assert code == 0, said
    with tempfile.TemporaryDirectory() as elsewhere:
        copy = Path(elsewhere) / "copy.db"
        code, said = hoistway("db", "backup", str(copy), "--url", f"sqlite:///{locked}")
        assert code == 0, said
        kept = sqlite3.connect(copy).execute("SELECT count(*) FROM audit").fetchone()
        assert kept == (2,)


def test_a_name_that_means_something_in_a_url_is_read_as_it_is(locked: Path) -> None:
    with tempfile.TemporaryDirectory() as elsewhere:
        odd = Path(elsewhere) / "50% of #1.db"
        shutil.copy(locked, odd)
        odd.chmod(0o444)
        odd.parent.chmod(0o555)
        try:
            code, said = hoistway("audit", "verify", "--database", f"sqlite:///{odd}")
        finally:
            odd.parent.chmod(0o755)
        assert (code, said.partition(".")[0]) == (0, "2 rows follow from one another")
