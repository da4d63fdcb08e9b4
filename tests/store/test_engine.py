"""URLs, and the words for what goes wrong."""

import sqlite3
from pathlib import Path

import pytest
import sqlalchemy as sa

from app.domain.errors import StoreError, StoreRefused
from app.store.engine import file_of, parsed, told, writing


@pytest.mark.parametrize(
    ("url", "driver"),
    [
        ("sqlite://", "sqlite+pysqlite"),
        ("sqlite:///var/plant.db", "sqlite+pysqlite"),
        ("postgresql://me@host/plant", "postgresql+psycopg"),
        ("postgres://me@host/plant", "postgresql+psycopg"),
        ("postgresql+psycopg://me@host/plant", "postgresql+psycopg"),
    ],
)
def test_a_url_gets_the_driver_that_is_there(url: str, driver: str) -> None:
    assert parsed(url).drivername == driver


def test_a_url_of_another_database_is_refused_with_an_example() -> None:
    with pytest.raises(StoreError, match="mysql is not a database") as caught:
        parsed("mysql://host/plant")
    assert "sqlite:///" in caught.value.remedy
    with pytest.raises(StoreError, match=r"'plant\.db' is not the URL"):
        parsed("plant.db")


def test_what_the_url_says_of_a_connection_stands() -> None:
    assert parsed("postgresql://host/plant?connect_timeout=60").query["connect_timeout"] == "60"
    assert parsed("postgresql://host/plant").query["connect_timeout"] == "5"


def test_a_database_in_memory_has_no_file(tmp_path: Path) -> None:
    assert file_of(parsed("sqlite://")) is None
    assert file_of(parsed("postgresql://host/plant")) is None
    assert file_of(parsed(f"sqlite:///{tmp_path}/x/../plant.db")) == tmp_path.resolve() / "plant.db"


def test_a_file_that_is_no_sound_database_is_refused_with_a_remedy(tmp_path: Path) -> None:
    file = tmp_path / "plant.db"
    file.write_bytes(b"no database at all" * 1000)
    with pytest.raises(StoreError, match="not a database") as caught, told("it cannot be opened"):
        writing(parsed(f"sqlite:///{file}")).connect()
    assert caught.value.remedy.startswith("Name another file")
    whole = sqlite3.connect(tmp_path / "made.db")
    whole.executescript("CREATE TABLE t (a TEXT); INSERT INTO t VALUES ('x');")
    whole.close()
    sound = (tmp_path / "made.db").read_bytes()
    file.write_bytes(sound[:4096] + b"\xff" * (len(sound) - 4096))
    engine = writing(parsed(f"sqlite:///{file}"))
    with pytest.raises(StoreError, match="malformed") as caught, told("it cannot be read"), engine.connect() as made:
        made.exec_driver_sql("SELECT * FROM t").all()
    assert "hoistway db restore" in caught.value.remedy


def test_sqlite_is_durable_when_it_says_so(sqlite_url: str) -> None:
    with writing(parsed(sqlite_url)).connect() as connection:
        asked = {
            name: connection.exec_driver_sql(f"PRAGMA {name}").scalar() for name in ("journal_mode", "synchronous")
        }
    assert asked == {"journal_mode": "wal", "synchronous": 3}


@pytest.mark.postgres
def test_postgresql_is_durable_when_it_says_so_and_ends_a_stopped_transaction(postgres_url: str) -> None:
    engine = writing(parsed(postgres_url))
    with engine.connect() as connection:
        asked = [
            connection.exec_driver_sql(f"SHOW {name}").scalar()
            for name in ("synchronous_commit", "idle_in_transaction_session_timeout")
        ]
    engine.dispose()
    assert asked == ["on", "5s"]


def test_an_error_of_the_database_is_told_in_our_words() -> None:
    with pytest.raises(StoreError, match=r"^it: disk I/O error$") as caught, told("it"):
        raise sa.exc.OperationalError("SELECT", None, Exception("disk  I/O\nerror"))
    assert caught.value.remedy == ""
    with pytest.raises(StoreRefused, match=r"^it: too large$"), told("it"):
        raise OverflowError("too large")
    with pytest.raises(StoreError, match=r"^it: no such pool$"), told("it"):
        raise sa.exc.SQLAlchemyError("no such pool")


def test_a_server_that_cannot_be_reached_is_trouble_with_a_remedy(tmp_path: Path) -> None:
    engine = writing(parsed(f"postgresql://nobody@/plant?host={tmp_path}"))
    with pytest.raises(StoreError, match=r"^it: .*connection") as caught, told("it"):
        engine.connect()
    assert caught.value.remedy == "See that the database server runs and can be reached."


def test_a_url_that_is_none_is_refused_without_its_password() -> None:
    with pytest.raises(StoreError) as caught:
        parsed("postgresql://kim:secret@host:many/plant")
    assert "secret" not in caught.value.message
    assert "@host" in caught.value.message
