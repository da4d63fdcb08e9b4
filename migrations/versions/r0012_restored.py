"""The mark that a backup was put back, until the first start has held every vehicle for it."""

import sqlalchemy as sa
from alembic import op

revision = "r0012"
down_revision = "r0011"

BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def upgrade() -> None:
    """Make room for the mark."""
    op.create_table(
        "restored",
        sa.Column("one", BIG, autoincrement=False, nullable=False),
        sa.Column("at", sa.Double[float](), nullable=False),
        sa.Column("source", sa.Text(), nullable=False),
        sa.PrimaryKeyConstraint("one", name="pk_restored"),
        sa.CheckConstraint("one = 1", name=op.f("ck_restored_only")),
    )
