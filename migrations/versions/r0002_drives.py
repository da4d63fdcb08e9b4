"""Drives: what was asked of them, backups, known values, lockouts."""

import sqlalchemy as sa
from alembic import op

revision = "r0002"
down_revision = "r0001"

BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
TEXT = sa.Text()
UTC = sa.Double[float]()
JSON = sa.JSON(none_as_null=True)


def upgrade() -> None:
    """Make the tables of drives."""
    _kept()
    _operations()


def _kept() -> None:
    op.create_table(
        "drives",
        sa.Column("drive", TEXT, autoincrement=False, nullable=False),
        sa.Column("lockout", JSON),
        sa.PrimaryKeyConstraint("drive", name="pk_drives"),
    )
    op.create_table(
        "drive_values",
        sa.Column("drive", TEXT, autoincrement=False, nullable=False),
        sa.Column("parameter", BIG, autoincrement=False, nullable=False),
        sa.Column("value", BIG, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.PrimaryKeyConstraint("drive", "parameter", name="pk_drive_values"),
    )
    op.create_table(
        "drive_backups",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("drive", TEXT, nullable=False),
        sa.Column("model", TEXT, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("note", TEXT, nullable=False),
        sa.Column("raws", JSON, nullable=False),
        sa.PrimaryKeyConstraint("number", name="pk_drive_backups"),
    )
    op.create_index("ix_drive_backups_drive_number", "drive_backups", ["drive", "number"])


def _operations() -> None:
    op.create_table(
        "operations",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("kind", TEXT, nullable=False),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("opened", UTC, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("line", TEXT, nullable=False),
        sa.Column("drive", TEXT),
        sa.Column("body", JSON, nullable=False),
        sa.Column("done", BIG, nullable=False),
        sa.Column("total", BIG, nullable=False),
        sa.Column("closed", UTC),
        sa.Column("result", JSON, nullable=False),
        sa.Column("reason", TEXT, nullable=False),
        sa.Column("remedy", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("number", name="pk_operations"),
    )
    for name, columns, where in (
        ("ix_operations_drive_number", ["drive", "number"], "drive IS NOT NULL"),
        ("ix_operations_under_way", ["number"], "state = 'running'"),
    ):
        op.create_index(name, "operations", columns, sqlite_where=sa.text(where), postgresql_where=sa.text(where))
