"""Run by Alembic. A caller gives its connection, inside a transaction; the ``alembic`` command gives ``-x url=...``."""

from alembic import context
from sqlalchemy import Connection

from app.store.engine import parsed, writing
from app.store.tables import metadata


def _run(connection: Connection) -> None:
    context.configure(connection=connection, target_metadata=metadata, render_as_batch=True)
    with context.begin_transaction():
        context.run_migrations()


_given = context.config.attributes.get("connection")
if _given is not None:
    _run(_given)
else:
    with writing(parsed(context.get_x_argument(as_dictionary=True)["url"])).begin() as _own:
        _run(_own)
