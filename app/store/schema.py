"""Which schema a database has, and how it gets ours. The steps are in the package ``migrations``."""

from pathlib import Path

import sqlalchemy as sa
from alembic import command
from alembic.config import Config
from alembic.runtime.migration import MigrationContext
from alembic.script import ScriptDirectory

import migrations
from app.domain.errors import StoreError
from app.store.engine import told
from app.store.tables import metadata

_LOCK = 0x486F6973
"""Key of PostgreSQL's advisory lock while tables are made: two controllers may start on an empty database at once."""


def _config() -> Config:
    config = Config()
    # Config reads "%" as the start of a variable.
    config.set_main_option("script_location", str(Path(migrations.__file__).parent).replace("%", "%%"))
    config.set_main_option("path_separator", "os")
    return config


def newest() -> str:
    """Return the revision that this program works with."""
    return str(ScriptDirectory.from_config(_config()).get_current_head())


def current(connection: sa.Connection) -> str | None:
    """Return the revision of a database; None while it is empty.

    Raises StoreError for a database that is not ours, or that a newer Hoistway has written.
    """
    with told("the version of the database cannot be read"):
        revision = MigrationContext.configure(connection).get_current_revision()
        names = set(sa.inspect(connection).get_table_names())
    if revision is None:
        if names - {"alembic_version"}:
            raise StoreError(
                f"the database is in use for something else: it has a table {min(names)!r}, and no version",
                remedy="Give Hoistway a database (PostgreSQL: or a schema) of its own.",
            )
        return None
    known = {script.revision for script in ScriptDirectory.from_config(_config()).walk_revisions()}
    if revision not in known:
        raise StoreError(
            f"the database has schema {revision}, written by a newer Hoistway; this one knows schemas up to {newest()}",
            remedy="Run the newer Hoistway, or restore a backup made before its first start.",
        )
    return revision


def upgrade(connection: sa.Connection) -> None:
    """Bring the database of ``connection`` to the newest schema, within its transaction. Raises StoreError."""
    with told("the tables of the database cannot be made"):
        if connection.dialect.name == "postgresql":
            connection.execute(sa.select(sa.func.pg_advisory_xact_lock(_LOCK)))
    if current(connection) == newest():
        return
    config = _config()
    config.attributes["connection"] = connection
    with told("the tables of the database cannot be made"):
        command.upgrade(config, "head")


def create(connection: sa.Connection) -> None:
    """Make all tables at once, without the steps: for a database in memory."""
    with told("the tables of the database cannot be made"):
        metadata.create_all(connection)
