"""The first schema."""

import sqlalchemy as sa
from alembic import op

revision = "r0001"
down_revision = None

BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
TEXT = sa.Text()
UTC = sa.Double[float]()
JSON = sa.JSON(none_as_null=True)


def _index(name: str, table: str, columns: list[str], where: str) -> None:
    op.create_index(name, table, columns, sqlite_where=sa.text(where), postgresql_where=sa.text(where))


def upgrade() -> None:
    """Make all tables."""
    _audit()
    _carriers()
    _controller()
    _events()
    _intents()
    _jobs()
    _lease()
    _plant()
    _station_dests()
    _stations()
    _teaching_events()
    _vehicle_offsets()
    _vehicles()


def _audit() -> None:
    op.create_table(
        "audit",
        sa.Column("seq", BIG, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("action", TEXT, nullable=False),
        sa.Column("target", TEXT, nullable=False),
        sa.Column("detail", TEXT, nullable=False),
        sa.Column("accepted", sa.Boolean(), nullable=False),
        sa.PrimaryKeyConstraint("seq", name="pk_audit"),
    )


def _carriers() -> None:
    op.create_table(
        "carriers",
        sa.Column("carrier", TEXT, autoincrement=False, nullable=False),
        sa.Column("place", TEXT),
        sa.Column("provenance", TEXT, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.PrimaryKeyConstraint("carrier", name="pk_carriers"),
    )


def _controller() -> None:
    op.create_table(
        "controller",
        sa.Column("one", BIG, autoincrement=False, nullable=False),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("reason", TEXT, nullable=False),
        sa.CheckConstraint("one = 1", name="ck_controller_only"),
        sa.PrimaryKeyConstraint("one", name="pk_controller"),
    )


def _events() -> None:
    op.create_table(
        "events",
        sa.Column("seq", BIG, autoincrement=False, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.Column("event", TEXT, nullable=False),
        sa.Column("ceid", BIG, nullable=False),
        sa.Column("job", TEXT),
        sa.Column("carrier", TEXT),
        sa.Column("vehicle", TEXT),
        sa.Column("source", TEXT),
        sa.Column("destination", TEXT),
        sa.Column("result", TEXT, nullable=False),
        sa.Column("detail", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("seq", name="pk_events"),
    )
    _index("ix_events_job_seq", "events", ["job", "seq"], "job IS NOT NULL")
    _index("ix_events_vehicle_seq", "events", ["vehicle", "seq"], "vehicle IS NOT NULL")


def _intents() -> None:
    op.create_table(
        "intents",
        sa.Column("cmd_id", BIG, autoincrement=False, nullable=False),
        sa.Column("vehicle", TEXT, nullable=False),
        sa.Column("kind", TEXT, nullable=False),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("opened", UTC, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("job", TEXT),
        sa.Column("path", JSON, nullable=False),
        sa.Column("body", JSON, nullable=False),
        sa.Column("amends", BIG),
        sa.Column("closed", UTC),
        sa.Column("outcome", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("cmd_id", name="pk_intents"),
    )
    _index("ix_intents_unsettled", "intents", ["cmd_id"], "state IN ('open', 'unknown')")
    op.create_index("ix_intents_vehicle_cmd_id", "intents", ["vehicle", "cmd_id"])


def _jobs() -> None:
    op.create_table(
        "jobs",
        sa.Column("number", BIG, autoincrement=False, nullable=False),
        sa.Column("id", TEXT, nullable=False),
        sa.Column("carrier", TEXT),
        sa.Column("source", TEXT, nullable=False),
        sa.Column("destination", TEXT, nullable=False),
        sa.Column("priority", BIG, nullable=False),
        sa.Column("created", UTC, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("fingerprint", TEXT, nullable=False),
        sa.Column("idempotency_key", TEXT),
        sa.Column("state", TEXT, nullable=False),
        sa.Column("leg", TEXT, nullable=False),
        sa.Column("vehicle", TEXT),
        sa.Column("wish", TEXT),
        sa.Column("fallbacks", JSON, nullable=False),
        sa.Column("reason", TEXT, nullable=False),
        sa.Column("result", TEXT, nullable=False),
        sa.Column("assigned", UTC),
        sa.Column("picked", UTC),
        sa.Column("ended", UTC),
        sa.PrimaryKeyConstraint("number", name="pk_jobs"),
        sa.UniqueConstraint("id", name="uq_jobs_id"),
    )
    _index("ix_jobs_carrier_number", "jobs", ["carrier", "number"], "carrier IS NOT NULL")
    _index(
        "ix_jobs_going_on",
        "jobs",
        ["number"],
        "state NOT IN ('aborted', 'cancelled', 'completed', 'failed')",
    )
    _index("ix_jobs_idempotency_key", "jobs", ["idempotency_key"], "idempotency_key IS NOT NULL")
    _index("ix_jobs_vehicle_number", "jobs", ["vehicle", "number"], "vehicle IS NOT NULL")


def _lease() -> None:
    op.create_table(
        "lease",
        sa.Column("one", BIG, autoincrement=False, nullable=False),
        sa.Column("plant", TEXT, nullable=False),
        sa.Column("holder", TEXT, nullable=False),
        sa.Column("token", TEXT, nullable=False),
        sa.Column("since", UTC, nullable=False),
        sa.Column("deadline", UTC, nullable=False),
        sa.CheckConstraint("one = 1", name="ck_lease_only"),
        sa.PrimaryKeyConstraint("one", name="pk_lease"),
    )


def _plant() -> None:
    op.create_table(
        "plant",
        sa.Column("one", BIG, autoincrement=False, nullable=False),
        sa.Column("name", TEXT, nullable=False),
        sa.Column("epoch", BIG, nullable=False),
        sa.Column("commits", BIG, nullable=False),
        sa.Column("created", UTC, nullable=False),
        sa.CheckConstraint("one = 1", name="ck_plant_only"),
        sa.PrimaryKeyConstraint("one", name="pk_plant"),
    )


def _station_dests() -> None:
    op.create_table(
        "station_dests",
        sa.Column("station", TEXT, autoincrement=False, nullable=False),
        sa.Column("version", BIG, autoincrement=False, nullable=False),
        sa.Column("shft", BIG, nullable=False),
        sa.Column("rota", BIG, nullable=False),
        sa.Column("lift", BIG, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("source", TEXT, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.PrimaryKeyConstraint("station", "version", name="pk_station_dests"),
    )


def _stations() -> None:
    op.create_table(
        "stations",
        sa.Column("station", TEXT, autoincrement=False, nullable=False),
        sa.Column("present", sa.Boolean()),
        sa.Column("carrier", TEXT),
        sa.Column("reserved", TEXT, nullable=False),
        sa.Column("out_of_service", TEXT, nullable=False),
        sa.Column("provenance", TEXT, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.PrimaryKeyConstraint("station", name="pk_stations"),
    )


def _teaching_events() -> None:
    op.create_table(
        "teaching_events",
        sa.Column("seq", BIG, nullable=False),
        sa.Column("vehicle", TEXT, nullable=False),
        sa.Column("connection", TEXT, nullable=False),
        sa.Column("cmd_id", BIG, nullable=False),
        sa.Column("code", BIG, nullable=False),
        sa.Column("axis", TEXT),
        sa.Column("position", BIG, nullable=False),
        sa.Column("barcode", TEXT, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.PrimaryKeyConstraint("seq", name="pk_teaching_events"),
        sa.UniqueConstraint(
            "vehicle", "connection", "cmd_id", "code", "position", "barcode", name="uq_teaching_events_same"
        ),
    )


def _vehicle_offsets() -> None:
    op.create_table(
        "vehicle_offsets",
        sa.Column("vehicle", TEXT, autoincrement=False, nullable=False),
        sa.Column("version", BIG, autoincrement=False, nullable=False),
        sa.Column("shft", BIG, nullable=False),
        sa.Column("rota", BIG, nullable=False),
        sa.Column("lift", BIG, nullable=False),
        sa.Column("actor", TEXT, nullable=False),
        sa.Column("source", TEXT, nullable=False),
        sa.Column("at", UTC, nullable=False),
        sa.PrimaryKeyConstraint("vehicle", "version", name="pk_vehicle_offsets"),
    )


def _vehicles() -> None:
    op.create_table(
        "vehicles",
        sa.Column("vehicle", TEXT, autoincrement=False, nullable=False),
        sa.Column("barcode", TEXT),
        sa.Column("held", JSON, nullable=False),
        sa.Column("carrier", TEXT),
        sa.Column("believed_loaded", sa.Boolean()),
        sa.Column("hold", JSON),
        sa.Column("lockout", JSON),
        sa.Column("out_of_service", TEXT, nullable=False),
        sa.Column("off_rail", TEXT, nullable=False),
        sa.PrimaryKeyConstraint("vehicle", name="pk_vehicles"),
    )
