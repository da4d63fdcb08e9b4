"""The steps of ``migrations`` and the tables of ``app.store.tables`` say the same; databases are upgraded or refused."""

from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic import command
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext
from alembic.script import ScriptDirectory

import migrations
from app.domain.errors import StoreError
from app.domain.versions import Source
from app.store import schema
from app.store.engine import parsed, writing
from app.store.opening import bring_up_to_date, revision
from app.store.tables import metadata
from app.store.versions import VersionStore
from tests.store.conftest import NOW, Open
from tests.store.samples import job

REVISIONS = [script.revision for script in ScriptDirectory(str(Path(migrations.__file__).parent)).walk_revisions()]


def test_the_migrations_make_the_tables_that_the_program_means(url: str, open_ledger: Open, raw: sa.Engine) -> None:
    open_ledger(url)
    with raw.connect() as connection:
        context = MigrationContext.configure(connection, opts={"compare_type": True, "compare_server_default": True})
        assert compare_metadata(context, metadata) == []


def test_the_migrations_give_each_index_its_condition(sqlite_url: str, open_ledger: Open) -> None:
    open_ledger(sqlite_url)
    with sa.create_engine(sqlite_url).connect() as migrated, sa.create_engine("sqlite://").connect() as meant:
        metadata.create_all(meant)
        assert indexes(migrated) == indexes(meant)


def indexes(connection: sa.Connection) -> dict[str, str]:
    query = sa.text("SELECT name, sql FROM sqlite_master WHERE type = 'index' AND name LIKE 'ix%'")
    return {name: sql.replace("(state NOT", "state NOT").replace("))", ")") for name, sql in connection.execute(query)}


@pytest.mark.parametrize("start", REVISIONS)
def test_an_older_schema_is_upgraded_when_the_plant_is_opened(start: str, url: str, open_ledger: Open) -> None:
    engine = writing(parsed(url))
    with engine.begin() as connection:
        config = schema._config()
        config.attributes["connection"] = connection
        command.upgrade(config, start)
    engine.dispose()
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit([job(1)])
    assert revision(url) == schema.newest()


def test_a_newer_schema_is_refused_and_left_as_it_is(url: str, open_ledger: Open, raw: sa.Engine) -> None:
    open_ledger(url).close()
    with raw.begin() as connection:
        connection.execute(sa.text("UPDATE alembic_version SET version_num = 'r9999'"))
    with pytest.raises(StoreError, match="r9999, written by a newer Hoistway") as caught:
        open_ledger(url)
    assert "newer" in caught.value.remedy
    with pytest.raises(StoreError, match="r9999"):
        revision(url)


def test_a_database_of_something_else_is_refused_and_left_as_it_is(url: str, open_ledger: Open, raw: sa.Engine) -> None:
    with raw.begin() as connection:
        connection.execute(sa.text("CREATE TABLE wages (who INTEGER)"))
    with pytest.raises(StoreError, match="in use for something else: it has a table 'wages'"):
        open_ledger(url)
    with raw.connect() as connection:
        assert sa.inspect(connection).get_table_names() == ["wages"]


def test_a_migration_that_breaks_off_leaves_nothing_behind(
    url: str, open_ledger: Open, raw: sa.Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(connection: sa.Connection) -> None:
        connection.execute(sa.text("CREATE TABLE half (a INTEGER)"))
        raise StoreError("power lost")

    with monkeypatch.context() as patch:
        patch.setattr("app.store.opening.upgrade", broken)
        with pytest.raises(StoreError, match="power lost"):
            open_ledger(url)
    with raw.connect() as connection:
        assert sa.inspect(connection).get_table_names() == []
    open_ledger(url)


def test_a_database_is_brought_up_to_date_by_hand_only_while_no_controller_runs(url: str, open_ledger: Open) -> None:
    assert revision(url) is None
    assert bring_up_to_date(url, "by hand", NOW) == schema.newest()
    assert revision(url) == schema.newest()
    open_ledger(url)
    assert revision(url) == schema.newest()


def test_the_steps_are_found_beside_the_program_wherever_it_is_installed() -> None:
    assert schema.newest() == REVISIONS[0]
    assert Path(schema._config().get_main_option("script_location") or "") == Path(migrations.__file__).parent


def test_versions_of_the_plant_from_before_their_trial_have_run_if_they_were_activated(
    url: str, open_ledger: Open, raw: sa.Engine
) -> None:
    rows = [(1, "former", 10.0), (2, "active", 20.0), (3, "staged", None), (4, "rejected", 15.0), (5, "rejected", None)]
    with raw.begin() as connection:
        config = schema._config()
        config.attributes["connection"] = connection
        command.upgrade(config, "r0013")
        for number, state, activated in rows:
            connection.execute(
                sa.text(
                    "INSERT INTO plant_versions (number, state, activated, digest, origin, at, actor, reason, size, why,"
                    " asked_why, patient, note, text)"
                    " VALUES (:n, :state, :activated, 'd', 'file', 5.0, 'kim', '', 1, '', '', false, '', 'x')"
                ),
                {"n": number, "state": state, "activated": activated},
            )
    open_ledger(url)
    store = VersionStore(url)
    found = {one.number: (one.ran, one.tries, one.rejected, dict(one.models)) for one in store.versions()}
    assert found == {
        1: (10.0, None, None, {}),
        2: (20.0, None, None, {}),
        3: (None, None, None, {}),
        4: (None, None, 15.0, {}),
        5: (None, None, 5.0, {}),
    }
    assert store.source(1) == Source("x")
    store.close()
