"""Versions of the plant."""

import sqlalchemy as sa
from alembic import op

revision = "r0013"
down_revision = "r0012"

TEXT = sa.Text()
BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
UTC = sa.Double[float]()


def upgrade() -> None:
    """Make the table of versions, and of the plant file that was last taken. The next start makes version 1 of its file."""
    op.create_table(
        "plant_versions",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("digest", TEXT, nullable=False),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("origin", TEXT, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("reason", TEXT, nullable=False),
        sa.Column("size", BIG, nullable=False),
        sa.Column("activated", UTC),
        sa.Column("activated_by", TEXT),
        sa.Column("why", TEXT, nullable=False),
        sa.Column("before", BIG),
        sa.Column("asked", UTC),
        sa.Column("asked_by", TEXT),
        sa.Column("asked_why", TEXT, nullable=False),
        sa.Column("patient", sa.Boolean(), nullable=False),
        sa.Column("note", TEXT, nullable=False),
        sa.Column("text", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("number", name="pk_plant_versions"),
    )
    active = sa.text("state = 'active'")
    op.create_index(
        "ix_plant_versions_active",
        "plant_versions",
        ["state"],
        unique=True,
        sqlite_where=active,
        postgresql_where=active,
    )
    op.create_table(
        "plant_file",
        sa.Column("one", BIG, autoincrement=False, nullable=False),
        sa.Column("digest", TEXT, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.PrimaryKeyConstraint("one", name="pk_plant_file"),
        sa.CheckConstraint("one = 1", name=op.f("ck_plant_file_only")),
    )
