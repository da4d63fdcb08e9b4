"""Audit walks."""

import sqlalchemy as sa
from alembic import op

revision = "r0009"
down_revision = "r0008"

TEXT = sa.Text()
BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
UTC = sa.Double[float]()


def upgrade() -> None:
    """Make the tables of audit walks and their places."""
    op.create_table(
        "walks",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("reason", TEXT, nullable=False),
        sa.Column("started", UTC, nullable=False),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("ended", UTC),
        sa.Column("ended_by", TEXT),
        sa.PrimaryKeyConstraint("number", name="pk_walks"),
    )
    op.create_table(
        "walk_places",
        sa.Column("walk", BIG, autoincrement=False, nullable=False),
        sa.Column("station", TEXT, autoincrement=False, nullable=False),
        sa.Column("believed", sa.Boolean()),
        sa.Column("believed_carrier", TEXT),
        sa.Column("seen", sa.Boolean()),
        sa.Column("seen_carrier", TEXT),
        sa.Column("by", TEXT),
        sa.Column("at", UTC),
        sa.PrimaryKeyConstraint("walk", "station", name="pk_walk_places"),
    )
