"""What an entry of an audit walk came to when it was accepted."""

import sqlalchemy as sa
from alembic import op

revision = "r0016"
down_revision = "r0015"


def upgrade() -> None:
    """Add the column. Entries that were accepted before are compared with the books of now, as they were."""
    op.add_column("walk_places", sa.Column("accepted", sa.Text()))
