"""When a version of the plant first ran, how often that was tried, when it was rejected, when its text was thrown away."""

import sqlalchemy as sa
from alembic import op

revision = "r0014"
down_revision = "r0013"

BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
UTC = sa.Double[float]()


def upgrade() -> None:
    """Add the columns. What was activated until now, and not rejected, has run."""
    op.add_column("plant_versions", sa.Column("ran", UTC))
    op.add_column("plant_versions", sa.Column("tries", BIG))
    op.add_column("plant_versions", sa.Column("rejected", UTC))
    op.add_column("plant_versions", sa.Column("pruned", UTC))
    op.execute("UPDATE plant_versions SET ran = activated WHERE activated IS NOT NULL AND state <> 'rejected'")
    op.execute("UPDATE plant_versions SET rejected = COALESCE(activated, at) WHERE state = 'rejected'")
