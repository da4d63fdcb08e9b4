"""Backups: one moment of the plant as a file, on any database, and put back with a mark that holds the vehicles."""

import sqlite3
from pathlib import Path

import pytest
import sqlalchemy as sa

from app.domain.errors import PlantHeld, StoreError
from app.domain.ids import Actor
from app.domain.units import Timestamp
from app.domain.versions import Origin, Source, VersionState
from app.store import tables
from app.store.backup import Stock, back_up, look, put_back
from app.store.engine import parsed, writing
from app.store.reading import Reader
from app.store.schema import newest
from app.store.versions import VersionStore
from tests.store.conftest import Open
from tests.store.samples import audit, dest, event, intent, job

LATER = Timestamp(2000.0)
KIM = Actor("kim")
ALL = (job(1), job(2), event(1, "J1"), intent(7), audit("a"), audit("b"), dest(1))


def kept(url: str) -> dict[str, list[dict[str, object]]]:
    """All rows of a database but those of the running controller."""
    engine = writing(parsed(url))
    try:
        with engine.begin() as connection:
            return {
                table.name: [dict(row) for row in connection.execute(sa.select(table)).mappings()]
                for table in tables.metadata.sorted_tables
                if table.name not in ("lease", "restored")
            }
    finally:
        engine.dispose()


def file_url(file: Path) -> str:
    return f"sqlite:///{file}"


def a_backup(url: str, open_ledger: Open, file: Path) -> Stock:
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit(ALL)
    try:
        return back_up(url, file)
    finally:
        ledger.close()


def test_a_backup_holds_every_row_while_a_controller_runs(url: str, open_ledger: Open, tmp_path: Path) -> None:
    file = tmp_path / "one.backup"
    stock = a_backup(url, open_ledger, file)
    assert kept(file_url(file)) == kept(url)
    assert (stock.plant, stock.schema, stock.commits, stock.jobs, stock.audit[0]) == ("P1", newest(), 1, 2, 2)
    assert file.stat().st_mode & 0o777 == 0o600
    assert [path.name for path in tmp_path.iterdir() if "one.backup" in path.name] == ["one.backup"]
    reader = Reader(file_url(file))
    assert reader.audit_checked(0, 10).broken is None
    reader.close()


def test_a_backup_replaces_no_other(sqlite_url: str, open_ledger: Open, tmp_path: Path) -> None:
    file = tmp_path / "one.backup"
    file.write_text("last week's")
    with pytest.raises(StoreError, match="exists already"):
        a_backup(sqlite_url, open_ledger, file)
    assert file.read_text() == "last week's"


def test_a_backup_put_back_is_what_was_there_and_marked_until_the_first_commit(
    url: str, open_ledger: Open, tmp_path: Path
) -> None:
    file = tmp_path / "one.backup"
    a_backup(url, open_ledger, file)
    then = kept(url)
    later = open_ledger(url)
    later.load()
    later.commit((job(3),))
    later.close()
    stock, before = put_back(file, url, "me", LATER)
    assert stock.jobs == 2
    assert before is not None
    assert look(before).jobs == 3
    assert kept(url) == then
    first = open_ledger(url)
    assert first.load().restored
    first.close()
    second = open_ledger(url)
    found = second.load()
    assert (found.restored, found.fresh, len(found.jobs)) == (True, False, 2)
    second.commit((event(2),))
    second.close()
    third = open_ledger(url)
    assert not third.load().restored


def test_a_plant_moves_from_one_database_to_the_other_by_a_backup(
    sqlite_url: str, postgres_url: str, open_ledger: Open, tmp_path: Path
) -> None:
    file, back = tmp_path / "there.backup", tmp_path / "back.backup"
    a_backup(sqlite_url, open_ledger, file)
    assert put_back(file, postgres_url, "me", LATER)[1] is None
    assert kept(postgres_url) == kept(sqlite_url)
    back_up(postgres_url, back)
    put_back(back, sqlite_url, "me", LATER)
    assert kept(sqlite_url) == kept(postgres_url)


def test_nothing_is_put_back_under_a_running_controller(sqlite_url: str, open_ledger: Open, tmp_path: Path) -> None:
    file = tmp_path / "one.backup"
    a_backup(sqlite_url, open_ledger, file)
    ledger = open_ledger(sqlite_url)
    ledger.load()
    with pytest.raises(PlantHeld):
        put_back(file, sqlite_url, "me", LATER)
    ledger.commit((job(3),))
    assert [path.name for path in tmp_path.iterdir() if "replaced" in path.name] == []


def test_a_backup_of_another_plant_is_not_put_back(sqlite_url: str, open_ledger: Open, tmp_path: Path) -> None:
    file = tmp_path / "one.backup"
    a_backup(sqlite_url, open_ledger, file)
    other = f"sqlite:///{tmp_path}/other.db"
    open_ledger(other, plant="P2").close()
    with pytest.raises(StoreError, match=r"keeps plant P2, the backup plant P1"):
        put_back(file, other, "me", LATER)


def test_an_older_schema_is_brought_up_to_date_when_it_is_put_back(
    sqlite_url: str, open_ledger: Open, tmp_path: Path
) -> None:
    file = tmp_path / "old.backup"
    a_backup(sqlite_url, open_ledger, file)
    with sqlite3.connect(file) as connection:
        for table in ("restored", "plant_versions", "plant_file"):
            connection.execute(f"DROP TABLE {table}")
        connection.execute("ALTER TABLE walk_places DROP COLUMN accepted")
        connection.execute("UPDATE alembic_version SET version_num = 'r0011'")
    connection.close()
    assert put_back(file, sqlite_url, "me", LATER)[0].schema == "r0011"
    ledger = open_ledger(sqlite_url)
    assert ledger.load().restored
    assert look(file).schema == "r0011"


@pytest.mark.parametrize(
    ("content", "words"),
    [(None, "there is no backup"), (b"lot,from,to\n" * 500, "not a database"), (b"", "keeps no plant")],
)
def test_what_is_no_backup_is_refused_and_changes_nothing(
    content: bytes | None, words: str, sqlite_url: str, open_ledger: Open, tmp_path: Path
) -> None:
    a_backup(sqlite_url, open_ledger, tmp_path / "good.backup")
    before = kept(sqlite_url)
    file = tmp_path / "bad.backup"
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(StoreError, match=words):
        put_back(file, sqlite_url, "me", LATER)
    assert kept(sqlite_url) == before


def test_a_torn_backup_is_told_from_a_whole_one(sqlite_url: str, open_ledger: Open, tmp_path: Path) -> None:
    file = tmp_path / "torn.backup"
    a_backup(sqlite_url, open_ledger, file)
    whole = file.read_bytes()
    file.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(StoreError, match=r"damaged|malformed|not a database"):
        put_back(file, sqlite_url, "me", LATER)


def test_a_database_that_is_not_there_or_has_no_plant_is_not_backed_up(tmp_path: Path) -> None:
    with pytest.raises(StoreError, match="there is no database"):
        back_up(f"sqlite:///{tmp_path}/none.db", tmp_path / "one.backup")
    assert not (tmp_path / "none.db").exists()
    (tmp_path / "empty.db").touch()
    with pytest.raises(StoreError, match="has schema none"):
        back_up(f"sqlite:///{tmp_path}/empty.db", tmp_path / "one.backup")
    assert not (tmp_path / "one.backup").exists()


def test_a_backup_cannot_be_put_back_over_itself(sqlite_url: str, open_ledger: Open, tmp_path: Path) -> None:
    open_ledger(sqlite_url).close()
    with pytest.raises(StoreError, match="is the database itself"):
        put_back(tmp_path / "plant.db", sqlite_url, "me", LATER)


def test_a_layout_that_was_awaited_then_is_not_awaited_after_a_backup_was_put_back(
    sqlite_url: str, open_ledger: Open, tmp_path: Path
) -> None:
    ledger = open_ledger(sqlite_url)
    ledger.load()
    ledger.close()
    store = VersionStore(sqlite_url)
    store.begin(Source("name: P1"), KIM, LATER)
    store.stage(Source("name: P1 # wider"), Origin.UPLOAD, KIM, "wider", LATER)
    store.ask(2, KIM, "wider", LATER, patient=True)
    store.close()
    file = tmp_path / "one.backup"
    back_up(sqlite_url, file)
    put_back(file, sqlite_url, "me", LATER)
    store = VersionStore(sqlite_url)
    found = [(one.number, one.state, one.note) for one in store.versions()]
    store.close()
    assert found == [(2, VersionState.STAGED, "a backup was put back"), (1, VersionState.ACTIVE, "")]
