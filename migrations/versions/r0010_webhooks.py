"""Webhooks: subscriptions, how far each has been told, and the log of deliveries."""

import sqlalchemy as sa
from alembic import op

revision = "r0010"
down_revision = "r0009"

BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
TEXT = sa.Text()
UTC = sa.Double[float]()
JSON = sa.JSON(none_as_null=True)


def upgrade() -> None:
    """Make the three tables."""
    op.create_table(
        "webhooks",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("url", TEXT, nullable=False),
        sa.Column("events", JSON, nullable=False),
        sa.Column("secret", TEXT, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("created", UTC, nullable=False),
        sa.Column("note", TEXT, nullable=False),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("reason", TEXT, nullable=False),
        sa.Column("replays", BIG, nullable=False),
        sa.Column("old_secret", TEXT, nullable=False),
        sa.Column("old_until", UTC),
        sa.PrimaryKeyConstraint("number", name="pk_webhooks"),
    )
    op.create_table(
        "webhook_progress",
        sa.Column("webhook", BIG, autoincrement=False, nullable=False),
        sa.Column("position", BIG, nullable=False),
        sa.Column("replays", BIG, nullable=False),
        sa.Column("tries", BIG, nullable=False),
        sa.Column("delivered", BIG, nullable=False),
        sa.Column("last", UTC),
        sa.Column("failing", UTC),
        sa.Column("attempts", BIG, nullable=False),
        sa.Column("error", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("webhook", name="pk_webhook_progress"),
    )
    op.create_table(
        "webhook_tries",
        sa.Column("webhook", BIG, autoincrement=False, nullable=False),
        sa.Column("slot", BIG, autoincrement=False, nullable=False),
        sa.Column("number", BIG, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.Column("seq", BIG),
        sa.Column("event", TEXT, nullable=False),
        sa.Column("attempt", BIG, nullable=False),
        sa.Column("status", BIG),
        sa.Column("seconds", UTC, nullable=False),
        sa.Column("error", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("webhook", "slot", name="pk_webhook_tries"),
    )
