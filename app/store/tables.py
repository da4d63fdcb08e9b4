"""The schema. ``migrations`` says the same in steps; a test holds the two together.

Times are UTC seconds as 64-bit floats, so that a record comes back equal to what was written. CMD_IDs are stored as signed
64-bit numbers, because a vehicle sets the top bit in its own (PROTOCOLS I23).
"""

from typing import Any

import sqlalchemy as sa

from app.domain.closures import ClosureState
from app.domain.drive_records import OperationState
from app.domain.job import TERMINAL
from app.domain.records import IntentState
from app.domain.teaching import ProposalState, SessionState
from app.domain.versions import VersionState
from app.domain.walks import WalkState

metadata = sa.MetaData(
    naming_convention={
        "pk": "pk_%(table_name)s",
        "uq": "uq_%(table_name)s_%(column_0_N_name)s",
        "ck": "ck_%(table_name)s_%(constraint_name)s",
        "ix": "ix_%(table_name)s_%(column_0_N_name)s",
    }
)

BIG = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
"""64 bits everywhere; SQLite's INTEGER has them, and only its name makes a key the row's own number."""
TEXT = sa.Text()
UTC = sa.Double[float]()
JSON = sa.JSON(none_as_null=True)


def _key(name: str, type_: sa.types.TypeEngine[Any] = TEXT) -> sa.Column[Any]:
    return sa.Column(name, type_, primary_key=True, autoincrement=False)


def _text(name: str) -> sa.Column[str]:
    return sa.Column(name, TEXT, nullable=False)


def _maybe(name: str) -> sa.Column[str]:
    return sa.Column(name, TEXT)


def _at(name: str) -> sa.Column[float]:
    return sa.Column(name, UTC, nullable=False)


def _big(name: str) -> sa.Column[int]:
    return sa.Column(name, BIG, nullable=False)


def _index_where_set(*columns: sa.Column[Any]) -> None:
    """Index the rows whose first column is not NULL: the others cost nothing to write."""
    name = "_".join(["ix", columns[0].table.name, *(column.name for column in columns)])
    where = columns[0].is_not(None)
    sa.Index(name, *columns, sqlite_where=where, postgresql_where=where)


plant = sa.Table(
    "plant",
    metadata,
    _key("one", BIG),
    _text("name"),
    _big("epoch"),
    _big("commits"),
    _at("created"),
    sa.CheckConstraint("one = 1", name="only"),
)
"""One row: the plant whose database this is. ``commits`` counts transactions, so that a commit in doubt can be looked up."""

restored = sa.Table(
    "restored",
    metadata,
    _key("one", BIG),
    _at("at"),
    _text("source"),
    sa.CheckConstraint("one = 1", name="only"),
)
"""There while a backup has been put back and no commit was made since: the first start holds every vehicle (COMMANDS 3.8)."""

lease = sa.Table(
    "lease",
    metadata,
    _key("one", BIG),
    _text("plant"),
    _text("holder"),
    _text("token"),
    _at("since"),
    _at("deadline"),
    sa.CheckConstraint("one = 1", name="only"),
)
"""Who may write (PostgreSQL; COMMANDS 3.7). Times by the database's clock. Later schemas keep this table as it is, because it
is read before they are known."""

jobs = sa.Table(
    "jobs",
    metadata,
    _key("number", BIG),
    _text("id"),
    _maybe("carrier"),
    _text("source"),
    _text("destination"),
    _big("priority"),
    _at("created"),
    _text("actor"),
    _text("fingerprint"),
    _maybe("idempotency_key"),
    _text("state"),
    _text("leg"),
    _maybe("vehicle"),
    _maybe("wish"),
    sa.Column("fallbacks", JSON, nullable=False),
    _text("reason"),
    _text("result"),
    sa.Column("assigned", UTC),
    sa.Column("picked", UTC),
    sa.Column("ended", UTC),
    sa.UniqueConstraint("id"),
)
going_on = jobs.c.state.not_in([sa.literal_column(f"'{state}'") for state in sorted(TERMINAL)])
"""Jobs that a restart must take up again. Written with its words, not with parameters, so that the index below serves it."""
sa.Index("ix_jobs_going_on", jobs.c.number, sqlite_where=going_on, postgresql_where=going_on)
_index_where_set(jobs.c.idempotency_key)
_index_where_set(jobs.c.carrier, jobs.c.number)
_index_where_set(jobs.c.vehicle, jobs.c.number)

job_whys = sa.Table(
    "job_whys",
    metadata,
    _key("number", BIG),
    _text("job"),
    sa.Column("choices", JSON, nullable=False),
    sa.Column("waits", JSON, nullable=False),
    _big("left_out"),
)
"""One row a job, under the job's own number."""

intents = sa.Table(
    "intents",
    metadata,
    _key("cmd_id", BIG),
    _text("vehicle"),
    _text("kind"),
    _text("state"),
    _at("opened"),
    _text("actor"),
    _maybe("job"),
    sa.Column("path", JSON, nullable=False),
    sa.Column("body", JSON, nullable=False),
    sa.Column("amends", BIG),
    sa.Column("closed", UTC),
    _text("outcome"),
)
sa.Index("ix_intents_vehicle_cmd_id", intents.c.vehicle, intents.c.cmd_id)
unsettled = intents.c.state.in_([sa.literal_column(f"'{state}'") for state in sorted(IntentState) if not state.closed])
"""Intents that a restart must settle."""
sa.Index("ix_intents_unsettled", intents.c.cmd_id, sqlite_where=unsettled, postgresql_where=unsettled)

events = sa.Table(
    "events",
    metadata,
    _key("seq", BIG),
    _at("at"),
    _text("event"),
    _big("ceid"),
    _maybe("job"),
    _maybe("carrier"),
    _maybe("vehicle"),
    _maybe("source"),
    _maybe("destination"),
    _text("result"),
    _text("detail"),
)
_index_where_set(events.c.job, events.c.seq)
_index_where_set(events.c.vehicle, events.c.seq)

audit = sa.Table(
    "audit",
    metadata,
    _key("seq", BIG),
    _at("at"),
    _text("actor"),
    _text("action"),
    _text("target"),
    _text("detail"),
    sa.Column("accepted", sa.Boolean(), nullable=False),
    _text("hash"),
)
"""``hash`` is over the row and the hash of the row before it (:mod:`app.store.chain`)."""

access = sa.Table(
    "access", metadata, _key("one", BIG), _text("secret"), _big("revision"), sa.CheckConstraint("one = 1", name="only")
)
"""One row: what digests of keys are made with (hex), and how often anything of the next three tables has changed."""

users = sa.Table(
    "users",
    metadata,
    _key("name"),
    sa.Column("roles", JSON, nullable=False),
    _text("password"),
    _at("created"),
    _text("created_by"),
    sa.Column("disabled", sa.Boolean(), nullable=False),
    sa.Column("logged_in", UTC),
)

access_keys = sa.Table(
    "access_keys",
    metadata,
    _key("name"),
    sa.Column("roles", JSON, nullable=False),
    _text("digest"),
    _at("created"),
    _text("created_by"),
    sa.Column("expires", UTC),
    sa.Column("revoked", UTC),
    sa.Column("used", UTC),
)

access_sessions = sa.Table(
    "access_sessions",
    metadata,
    _key("digest"),
    _text("log_in"),
    _text("user"),
    _at("started"),
    _at("expires"),
    _text("address"),
)

vehicles = sa.Table(
    "vehicles",
    metadata,
    _key("vehicle"),
    _maybe("barcode"),
    sa.Column("held", JSON, nullable=False),
    _maybe("carrier"),
    sa.Column("believed_loaded", sa.Boolean()),
    sa.Column("hold", JSON),
    sa.Column("lockout", JSON),
    _text("out_of_service"),
    _text("off_rail"),
)

stations = sa.Table(
    "stations",
    metadata,
    _key("station"),
    sa.Column("present", sa.Boolean()),
    _maybe("carrier"),
    _text("reserved"),
    _text("out_of_service"),
    _text("provenance"),
    _at("at"),
)

carriers = sa.Table("carriers", metadata, _key("carrier"), _maybe("place"), _text("provenance"), _at("at"))


def _maybe_big(name: str) -> sa.Column[int]:
    return sa.Column(name, BIG)


def _taught(name: str, owner: str) -> sa.Table:
    pulses = (_maybe_big("shft"), _maybe_big("rota"), _maybe_big("lift"))
    derived = (sa.Column("basis", JSON), _maybe_big("proposal"), _maybe_big("restores"), _maybe("reason"))
    made = (_text("actor"), _text("source"), _at("at"), *derived)
    return sa.Table(name, metadata, _key(owner), _key("version", BIG), *pulses, *made)


station_dests = _taught("station_dests", "station")
vehicle_offsets = _taught("vehicle_offsets", "vehicle")

teaching_events = sa.Table(
    "teaching_events",
    metadata,
    _key("seq", BIG),
    _text("vehicle"),
    _text("connection"),
    _big("cmd_id"),
    _big("code"),
    _maybe("axis"),
    _big("position"),
    _text("barcode"),
    _at("at"),
    _maybe("asked_by"),
    sa.UniqueConstraint(
        "vehicle", "connection", "cmd_id", "code", "position", "barcode", name="uq_teaching_events_same"
    ),
)

drives = sa.Table("drives", metadata, _key("drive"), sa.Column("lockout", JSON))

drive_values = sa.Table("drive_values", metadata, _key("drive"), _key("parameter", BIG), _big("value"), _at("at"))

drive_backups = sa.Table(
    "drive_backups",
    metadata,
    _key("number", BIG),
    _text("drive"),
    _text("model"),
    _at("at"),
    _text("actor"),
    _text("note"),
    sa.Column("raws", JSON, nullable=False),
)
sa.Index("ix_drive_backups_drive_number", drive_backups.c.drive, drive_backups.c.number)

operations = sa.Table(
    "operations",
    metadata,
    _key("number", BIG),
    _text("kind"),
    _text("state"),
    _at("opened"),
    _text("actor"),
    _text("line"),
    _maybe("drive"),
    sa.Column("body", JSON, nullable=False),
    _big("done"),
    _big("total"),
    sa.Column("closed", UTC),
    sa.Column("result", JSON, nullable=False),
    _text("reason"),
    _text("remedy"),
)
_index_where_set(operations.c.drive, operations.c.number)
under_way = operations.c.state == sa.literal_column(f"'{OperationState.RUNNING.value}'")
"""Operations that a restart must close."""
sa.Index("ix_operations_under_way", operations.c.number, sqlite_where=under_way, postgresql_where=under_way)
teaching_proposals = sa.Table(
    "teaching_proposals",
    metadata,
    _key("number", BIG),
    _text("side"),
    _text("vehicle"),
    _text("barcode"),
    _at("opened"),
    _at("at"),
    sa.Column("readings", JSON, nullable=False),
    _text("state"),
    _text("why"),
    _text("remedy"),
    sa.Column("warnings", JSON, nullable=False),
    _maybe("station"),
    _maybe_big("session"),
    _maybe_big("asked"),
    _maybe("asked_by"),
    sa.Column("collecting", sa.Boolean(), nullable=False),
    _text("broken"),
    _text("mode"),
    sa.Column("result", JSON),
    _big("base"),
    _maybe_big("against_version"),
    sa.Column("closed", UTC),
    _maybe("closed_by"),
    _text("reason"),
    _maybe_big("version"),
    _big("revision"),
)
undecided = teaching_proposals.c.state.not_in(
    [sa.literal_column(f"'{state}'") for state in sorted(ProposalState) if state.over]
)
"""Proposals that a restart must take up again."""
sa.Index(
    "ix_teaching_proposals_undecided", teaching_proposals.c.number, sqlite_where=undecided, postgresql_where=undecided
)
_index_where_set(teaching_proposals.c.station, teaching_proposals.c.number)
_index_where_set(teaching_proposals.c.vehicle, teaching_proposals.c.number)

teaching_sessions = sa.Table(
    "teaching_sessions",
    metadata,
    _key("number", BIG),
    _text("station"),
    _text("vehicle"),
    _text("actor"),
    _at("opened"),
    _text("note"),
    _text("state"),
    sa.Column("ended", UTC),
    _maybe("ended_by"),
    _text("reason"),
)
going_on_teaching = teaching_sessions.c.state == sa.literal_column(f"'{SessionState.OPEN}'")
"""Sessions that a restart must take up again."""

controller = sa.Table(
    "controller",
    metadata,
    _key("one", BIG),
    _text("state"),
    _text("reason"),
    sa.Column("emergencies", JSON),
    sa.Column("pauses", JSON),
    sa.CheckConstraint("one = 1", name="only"),
)

devices = sa.Table(
    "devices",
    metadata,
    _key("device"),
    sa.Column("lockout", JSON),
    sa.Column("pin", JSON),
    sa.Column("lock", JSON),
    sa.Column("locked", sa.Boolean()),
    _text("out_of_service"),
)

closures = sa.Table(
    "closures",
    metadata,
    _key("number", BIG),
    _text("kind"),
    sa.Column("names", JSON, nullable=False),
    sa.Column("barcodes", JSON, nullable=False),
    _text("reason"),
    _text("owner"),
    _text("purpose"),
    _at("since"),
    sa.Column("expires", UTC),
    _text("state"),
    sa.Column("closed", UTC),
    sa.Column("releases", JSON, nullable=False),
    sa.Column("ended", UTC),
    _maybe("ended_by"),
)
in_force = closures.c.state.not_in([sa.literal_column(f"'{state}'") for state in sorted(ClosureState) if state.over])
"""Closures that a restart must take up again."""
sa.Index("ix_closures_in_force", closures.c.number, sqlite_where=in_force, postgresql_where=in_force)

webhooks = sa.Table(
    "webhooks",
    metadata,
    _key("number", BIG),
    _text("url"),
    sa.Column("events", JSON, nullable=False),
    _text("secret"),
    _text("actor"),
    _at("created"),
    _text("note"),
    _text("state"),
    _text("reason"),
    _big("replays"),
    _text("old_secret"),
    sa.Column("old_until", UTC),
)

webhook_progress = sa.Table(
    "webhook_progress",
    metadata,
    _key("webhook", BIG),
    _big("position"),
    _big("replays"),
    _big("tries"),
    _big("delivered"),
    sa.Column("last", UTC),
    sa.Column("failing", UTC),
    _big("attempts"),
    _text("error"),
)

webhook_tries = sa.Table(
    "webhook_tries",
    metadata,
    _key("webhook", BIG),
    _key("slot", BIG),
    _big("number"),
    _at("at"),
    sa.Column("seq", BIG),
    _text("event"),
    _big("attempt"),
    sa.Column("status", BIG),
    sa.Column("seconds", UTC, nullable=False),
    _text("error"),
)
"""The newest deliveries of each webhook, in turn: ``slot`` is the number of the delivery modulo how many are kept."""
alarms = sa.Table(
    "alarms",
    metadata,
    _key("number", BIG),
    _text("kind"),
    _text("source"),
    _text("code"),
    _text("cause"),
    _text("remedy"),
    _at("begun"),
    _maybe("job"),
    sa.Column("ended", UTC),
    _text("outcome"),
    sa.Column("acknowledged", UTC),
    _maybe("acknowledged_by"),
    _text("note"),
)
there_now = alarms.c.ended.is_(None)
"""Alarms that a restart must take up again."""
sa.Index("ix_alarms_there_now", alarms.c.number, sqlite_where=there_now, postgresql_where=there_now)
sa.Index("ix_alarms_begun", alarms.c.begun)
sa.Index("ix_alarms_source_number", alarms.c.source, alarms.c.number)

walks = sa.Table(
    "walks",
    metadata,
    _key("number", BIG),
    _text("actor"),
    _text("reason"),
    _at("started"),
    _text("state"),
    sa.Column("ended", UTC),
    _maybe("ended_by"),
)
open_walks = walks.c.state == sa.literal_column(f"'{WalkState.OPEN.value}'")
"""Walks that a restart must take up again."""

walk_places = sa.Table(
    "walk_places",
    metadata,
    _key("walk", BIG),
    _key("station"),
    sa.Column("believed", sa.Boolean()),
    _maybe("believed_carrier"),
    sa.Column("seen", sa.Boolean()),
    _maybe("seen_carrier"),
    _maybe("by"),
    sa.Column("at", UTC),
    _maybe("accepted"),
)

plant_versions = sa.Table(
    "plant_versions",
    metadata,
    _key("number", BIG),
    _text("digest"),
    _text("state"),
    _text("origin"),
    _at("at"),
    _text("actor"),
    _text("reason"),
    _big("size"),
    sa.Column("activated", UTC),
    _maybe("activated_by"),
    _text("why"),
    _maybe_big("before"),
    sa.Column("asked", UTC),
    _maybe("asked_by"),
    _text("asked_why"),
    sa.Column("patient", sa.Boolean(), nullable=False),
    _text("note"),
    _text("text"),
    sa.Column("ran", UTC),
    _maybe_big("tries"),
    sa.Column("models", sa.JSON(none_as_null=True)),
    sa.Column("catalogues", sa.JSON(none_as_null=True)),
    sa.Column("rejected", UTC),
    sa.Column("pruned", UTC),
)
the_active = plant_versions.c.state == sa.literal_column(f"'{VersionState.ACTIVE.value}'")
sa.Index(
    "ix_plant_versions_active",
    plant_versions.c.state,
    unique=True,
    sqlite_where=the_active,
    postgresql_where=the_active,
)
"""Whatever happens, not two are active."""

plant_file = sa.Table(
    "plant_file", metadata, _key("one", BIG), _text("digest"), _at("at"), sa.CheckConstraint("one = 1", name="only")
)
"""One row: the plant file as it was when it was last taken."""
