"""People, keys and sessions; the audit as a chain of hashes."""

import json
from hashlib import sha256

import sqlalchemy as sa
from alembic import op

revision = "r0011"
down_revision = "r0010"

BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
TEXT = sa.Text()
UTC = sa.Double[float]()
JSON = sa.JSON(none_as_null=True)
PAGE = 5_000


def upgrade() -> None:
    """Chain the audit that there is, and make room for those who may log in."""
    _chain()
    op.create_table(
        "access",
        sa.Column("one", BIG, autoincrement=False, nullable=False),
        sa.Column("secret", TEXT, nullable=False),
        sa.Column("revision", BIG, nullable=False),
        sa.PrimaryKeyConstraint("one", name="pk_access"),
        sa.CheckConstraint("one = 1", name=op.f("ck_access_only")),
    )
    op.create_table(
        "users",
        sa.Column("name", TEXT, autoincrement=False, nullable=False),
        sa.Column("roles", JSON, nullable=False),
        sa.Column("password", TEXT, nullable=False),
        sa.Column("created", UTC, nullable=False),
        sa.Column("created_by", TEXT, nullable=False),
        sa.Column("disabled", sa.Boolean(), nullable=False),
        sa.Column("logged_in", UTC),
        sa.PrimaryKeyConstraint("name", name="pk_users"),
    )
    op.create_table(
        "access_keys",
        sa.Column("name", TEXT, autoincrement=False, nullable=False),
        sa.Column("roles", JSON, nullable=False),
        sa.Column("digest", TEXT, nullable=False),
        sa.Column("created", UTC, nullable=False),
        sa.Column("created_by", TEXT, nullable=False),
        sa.Column("expires", UTC),
        sa.Column("revoked", UTC),
        sa.Column("used", UTC),
        sa.PrimaryKeyConstraint("name", name="pk_access_keys"),
    )
    op.create_table(
        "access_sessions",
        sa.Column("digest", TEXT, autoincrement=False, nullable=False),
        sa.Column("log_in", TEXT, nullable=False),
        sa.Column("user", TEXT, nullable=False),
        sa.Column("started", UTC, nullable=False),
        sa.Column("expires", UTC, nullable=False),
        sa.Column("address", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("digest", name="pk_access_sessions"),
    )


def _chain() -> None:
    """Give each row its hash, and leave numbering to the program."""
    op.add_column("audit", sa.Column("hash", TEXT, nullable=False, server_default=""))
    connection = op.get_bind()
    before, last = "", -1
    update = sa.text("UPDATE audit SET hash = :hash WHERE seq = :seq")
    page = sa.text(
        "SELECT seq, at, actor, action, target, detail, accepted FROM audit WHERE seq > :last ORDER BY seq LIMIT :most"
    )
    while rows := connection.execute(page, {"last": last, "most": PAGE}).all():
        hashes = []
        for seq, at, *said, accepted in rows:
            text = json.dumps([before, seq, float(at), *said, bool(accepted)], separators=(",", ":"))
            before, last = sha256(text.encode()).hexdigest(), seq
            hashes.append({"hash": before, "seq": seq})
        connection.execute(update, hashes)
    with op.batch_alter_table("audit") as batch:
        batch.alter_column("hash", existing_type=TEXT, server_default=None)
    if connection.dialect.name == "postgresql":
        op.execute("ALTER TABLE audit ALTER COLUMN seq DROP DEFAULT")
        op.execute("DROP SEQUENCE IF EXISTS audit_seq_seq")
