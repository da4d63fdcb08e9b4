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
