"""Alarms as history."""

import sqlalchemy as sa
from alembic import op

revision = "r0008"
down_revision = "r0007"

TEXT = sa.Text()
BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
UTC = sa.Double[float]()


def upgrade() -> None:
    """Make the table of alarms; those from before are events only."""
    op.create_table(
        "alarms",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("kind", TEXT, nullable=False),
        sa.Column("source", TEXT, nullable=False),
        sa.Column("code", TEXT, nullable=False),
        sa.Column("cause", TEXT, nullable=False),
        sa.Column("remedy", TEXT, nullable=False),
        sa.Column("begun", UTC, nullable=False),
        sa.Column("job", TEXT),
        sa.Column("ended", UTC),
        sa.Column("outcome", TEXT, nullable=False),
        sa.Column("acknowledged", UTC),
        sa.Column("acknowledged_by", TEXT),
        sa.Column("note", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("number", name="pk_alarms"),
    )
    there_now = sa.text("ended IS NULL")
    op.create_index("ix_alarms_there_now", "alarms", ["number"], sqlite_where=there_now, postgresql_where=there_now)
    op.create_index("ix_alarms_begun", "alarms", ["begun"])
    op.create_index("ix_alarms_source_number", "alarms", ["source", "number"])
