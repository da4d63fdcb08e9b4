"""Teaching: versions with what they were derived from, numbered events, proposals and sessions."""

import sqlalchemy as sa
from alembic import op

revision = "r0003"
down_revision = "r0002"

BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
TEXT = sa.Text()
UTC = sa.Double[float]()
JSON = sa.JSON(none_as_null=True)
OVER = "state NOT IN ('approved', 'rejected', 'superseded')"


def _index(name: str, columns: list[str], where: str) -> None:
    condition = sa.text(where)
    op.create_index(name, "teaching_proposals", columns, sqlite_where=condition, postgresql_where=condition)


def upgrade() -> None:
    """Keep what there is, and make room for the rest."""
    for table in ("station_dests", "vehicle_offsets"):
        _versions(table)
    _events()
    _proposals()
    _sessions()


def _versions(table: str) -> None:
    """An axis may never have been taught; each one taught says what it was derived from (I40)."""
    with op.batch_alter_table(table) as batch:
        for axis in ("shft", "rota", "lift"):
            batch.alter_column(axis, existing_type=BIG, nullable=True)
        batch.add_column(sa.Column("basis", JSON))
        batch.add_column(sa.Column("proposal", BIG))
        batch.add_column(sa.Column("restores", BIG))
        batch.add_column(sa.Column("reason", TEXT))


def _events() -> None:
    """The controller numbers the events itself, so that a set can name them in the same transaction."""
    op.add_column("teaching_events", sa.Column("asked_by", TEXT))
    if op.get_bind().dialect.name == "postgresql":
        op.execute("ALTER TABLE teaching_events ALTER COLUMN seq DROP DEFAULT")
        op.execute("DROP SEQUENCE IF EXISTS teaching_events_seq_seq")


def _proposals() -> None:
    op.create_table(
        "teaching_proposals",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("side", TEXT, nullable=False),
        sa.Column("vehicle", TEXT, nullable=False),
        sa.Column("barcode", TEXT, nullable=False),
        sa.Column("opened", UTC, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.Column("readings", JSON, nullable=False),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("why", TEXT, nullable=False),
        sa.Column("remedy", TEXT, nullable=False),
        sa.Column("warnings", JSON, nullable=False),
        sa.Column("station", TEXT),
        sa.Column("session", BIG),
        sa.Column("asked", BIG),
        sa.Column("asked_by", TEXT),
        sa.Column("collecting", sa.Boolean(), nullable=False),
        sa.Column("broken", TEXT, nullable=False),
        sa.Column("mode", TEXT, nullable=False),
        sa.Column("result", JSON),
        sa.Column("base", BIG, nullable=False),
        sa.Column("against_version", BIG),
        sa.Column("closed", UTC),
        sa.Column("closed_by", TEXT),
        sa.Column("reason", TEXT, nullable=False),
        sa.Column("version", BIG),
        sa.Column("revision", BIG, nullable=False),
        sa.PrimaryKeyConstraint("number", name="pk_teaching_proposals"),
    )
    _index("ix_teaching_proposals_undecided", ["number"], OVER)
    _index("ix_teaching_proposals_station_number", ["station", "number"], "station IS NOT NULL")
    _index("ix_teaching_proposals_vehicle_number", ["vehicle", "number"], "vehicle IS NOT NULL")


def _sessions() -> None:
    op.create_table(
        "teaching_sessions",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("station", TEXT, nullable=False),
        sa.Column("vehicle", TEXT, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("opened", UTC, nullable=False),
        sa.Column("note", TEXT, nullable=False),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("ended", UTC),
        sa.Column("ended_by", TEXT),
        sa.Column("reason", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("number", name="pk_teaching_sessions"),
    )
