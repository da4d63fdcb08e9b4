"""What each job's assignments were chosen by, and what it waited for."""

import sqlalchemy as sa
from alembic import op

revision = "r0005"
down_revision = "r0004"

TEXT = sa.Text()
JSON = sa.JSON(none_as_null=True)
BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def upgrade() -> None:
    """Make the table of why-records; jobs from before have none."""
    op.create_table(
        "job_whys",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("job", TEXT, nullable=False),
        sa.Column("choices", JSON, nullable=False),
        sa.Column("waits", JSON, nullable=False),
        sa.Column("left_out", BIG, nullable=False),
        sa.PrimaryKeyConstraint("number", name="pk_job_whys"),
    )
