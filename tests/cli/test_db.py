"""``hoistway db``."""

from pathlib import Path

from typer.testing import CliRunner

from app.cli.db import commands
from app.domain.units import Timestamp
from app.store.ledger import SqlLedger
from app.store.schema import newest


def ask(*words: str) -> tuple[int, str]:
    result = CliRunner().invoke(commands, list(words))
    return result.exit_code, result.output.strip()


def test_a_new_database_is_empty_until_it_is_upgraded(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/plant.db"
    assert ask("current", "--url", url) == (0, f"empty (newest: {newest()})")
    assert not (tmp_path / "plant.db").exists()
    assert ask("upgrade", "--url", url) == (0, newest())
    assert ask("current", "--url", url) == (0, newest())


def test_a_database_in_use_is_not_upgraded_and_it_is_said_by_whom(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/plant.db"
    ledger = SqlLedger(url, "P1", "server A", lambda: Timestamp(0.0))
    code, words = ask("upgrade", "--url", url)
    ledger.close()
    assert code == 1
    assert "held by server A" in words
    assert "Stop that controller first" in words


def test_a_url_that_is_none_is_an_error_with_an_example() -> None:
    code, words = ask("current", "--url", "plant.db")
    assert code == 1
    assert "sqlite:///" in words


def test_a_backup_is_written_and_put_back_and_says_what_it_holds(tmp_path: Path) -> None:
    url, file = f"sqlite:///{tmp_path}/plant.db", tmp_path / "monday.backup"
    SqlLedger(url, "P1", "server A", lambda: Timestamp(0.0)).close()
    code, words = ask("backup", str(file), "--url", url)
    assert (code, words) == (0, f"{file}: plant P1, schema {newest()}, 0 jobs after 0 commits")
    code, words = ask("backup", str(file), "--url", url)
    assert code == 1
    assert "exists already. A backup does not replace another one" in words
    code, words = ask("restore", str(file), "--url", url)
    assert code == 0
    assert "put back: plant P1" in words
    assert f"what was there before: {file}.replaced-" in words
    assert "holds every vehicle" in words


def test_a_restore_without_its_backup_says_what_would_help(tmp_path: Path) -> None:
    code, words = ask("restore", str(tmp_path / "none"), "--url", f"sqlite:///{tmp_path}/plant.db")
    assert code == 1
    assert "Name a file that hoistway db backup has written" in words
