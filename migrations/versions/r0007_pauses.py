"""Zones in which motion is paused."""

import sqlalchemy as sa
from alembic import op

revision = "r0007"
down_revision = "r0006"


def upgrade() -> None:
    """The controller remembers pauses of zones."""
    op.add_column("controller", sa.Column("pauses", sa.JSON(none_as_null=True)))
