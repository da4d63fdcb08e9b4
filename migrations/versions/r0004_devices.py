"""Doors, buffers and chargers; fires and earthquakes that nobody has released yet."""

import sqlalchemy as sa
from alembic import op

revision = "r0004"
down_revision = "r0003"

TEXT = sa.Text()
JSON = sa.JSON(none_as_null=True)


def upgrade() -> None:
    """Make the table of devices; the controller remembers emergencies."""
    op.create_table(
        "devices",
        sa.Column("device", TEXT, autoincrement=False, nullable=False),
        sa.Column("lockout", JSON),
        sa.Column("pin", JSON),
        sa.Column("lock", JSON),
        sa.Column("locked", sa.Boolean()),
        sa.Column("out_of_service", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("device", name="pk_devices"),
    )
    op.add_column("controller", sa.Column("emergencies", JSON))
