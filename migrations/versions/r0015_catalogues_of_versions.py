"""The catalogues of drives that a version of the plant was made with."""

import sqlalchemy as sa
from alembic import op

revision = "r0015"
down_revision = "r0014"


def upgrade() -> None:
    """Add the columns. Versions from before go on with the catalogues that are found."""
    op.add_column("plant_versions", sa.Column("models", sa.JSON(none_as_null=True)))
    op.add_column("plant_versions", sa.Column("catalogues", sa.JSON(none_as_null=True)))
