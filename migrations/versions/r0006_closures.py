"""Closures of rails, stations and zones."""

import sqlalchemy as sa
from alembic import op

revision = "r0006"
down_revision = "r0005"

TEXT = sa.Text()
JSON = sa.JSON(none_as_null=True)
BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
UTC = sa.Double[float]()
IN_FORCE = "state NOT IN ('expired', 'opened')"


def upgrade() -> None:
    """Make the table of closures."""
    op.create_table(
        "closures",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("kind", TEXT, nullable=False),
        sa.Column("names", JSON, nullable=False),
        sa.Column("barcodes", JSON, nullable=False),
        sa.Column("reason", TEXT, nullable=False),
        sa.Column("owner", TEXT, nullable=False),
        sa.Column("purpose", TEXT, nullable=False),
        sa.Column("since", UTC, nullable=False),
        sa.Column("expires", UTC),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("closed", UTC),
        sa.Column("releases", JSON, nullable=False),
        sa.Column("ended", UTC),
        sa.Column("ended_by", TEXT),
        sa.PrimaryKeyConstraint("number", name="pk_closures"),
    )
    op.create_index(
        "ix_closures_in_force",
        "closures",
        ["number"],
        sqlite_where=sa.text(IN_FORCE),
        postgresql_where=sa.text(IN_FORCE),
    )
