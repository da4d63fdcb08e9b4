"""Versions of the plant as they are kept, written beside the ledger by a connection of its own; each change one transaction."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, fields, replace
from typing import Any

import sqlalchemy as sa

from app.domain.errors import Refusal, StoreError
from app.domain.ids import Actor
from app.domain.records import AuditRow
from app.domain.units import Timestamp
from app.domain.versions import Origin, PlantVersion, Source, VersionState
from app.store.chain import append
from app.store.columns import Found
from app.store.engine import MEMORY, parsed, told, writing
from app.store.lease import Lease
from app.store.tables import plant, plant_file, plant_versions

_FIELDS = tuple(field.name for field in fields(PlantVersion))
_COLUMNS = [plant_versions.c[name] for name in _FIELDS]
_number = plant_versions.c.number
KEPT_REJECTED = 10
"""So many texts of rejected versions are kept, those rejected last: who rejected one by mistake, or asks why it could not be run,
does so soon, and a fab's file has megabytes. What ever ran is kept for good: it is what one rolls back to. Our choice."""
MOST_STAGED = 50
"""So many uploaded versions may be staged at once: they are kept until somebody rejects them. Our choice."""
LIVE = (VersionState.STAGED, VersionState.AWAITED, VersionState.ACTIVE, VersionState.FORMER)
"""States of versions that can be used."""

Work = Callable[[sa.Connection, PlantVersion], PlantVersion | Refusal]


class VersionStore:
    """The versions of one plant. Blocking, from any thread. Every method raises StoreError if the database cannot be used.

    What somebody asked for and its audit row are one transaction; what is refused is written into the audit too. The tables
    must be there.
    """

    def __init__(self, url: str) -> None:
        made = parsed(url)
        if made.database == MEMORY:
            raise StoreError("a database in memory keeps no versions of the plant", remedy="Keep the plant in a file.")
        self._engine = writing(made)

    def close(self) -> None:
        """Close all connections."""
        self._engine.dispose()

    # -- what there is ------------------------------------------------------------------------------------------------

    def plant_name(self) -> str | None:
        """Return whose database it is; None: nobody's yet."""
        with told("the database cannot be read"), self._engine.connect() as connection:
            return connection.execute(sa.select(plant.c.name)).scalar()

    def versions(self, after: int | None = None, limit: int = 100) -> list[PlantVersion]:
        """Return versions, newest first; ``after`` is the number of the last one seen."""
        query = sa.select(*_COLUMNS).order_by(_number.desc()).limit(limit)
        return self._list(query if after is None else query.where(_number < after))

    def version(self, number: int) -> PlantVersion | None:
        """Return one version."""
        return next(iter(self._list(sa.select(*_COLUMNS).where(_number == number))), None)

    def text(self, number: int) -> str | None:
        """Return the text of a version's plant file; None: there is no such version, or its text is not kept any more."""
        with told("the versions of the plant cannot be read"), self._engine.connect() as connection:
            which = sa.and_(_number == number, plant_versions.c.pruned.is_(None))
            return connection.execute(sa.select(plant_versions.c.text).where(which)).scalar()

    def active(self) -> PlantVersion | None:
        """Return the version that is active; None: no controller has started here yet."""
        return self._in_state(VersionState.ACTIVE)

    def awaited(self) -> PlantVersion | None:
        """Return the version that is to become active."""
        return self._in_state(VersionState.AWAITED)

    def source(self, number: int) -> Source | None:
        """Return what a version is made of; None as for ``text``."""
        which = sa.and_(_number == number, plant_versions.c.pruned.is_(None))
        query = sa.select(plant_versions.c.text, plant_versions.c.catalogues).where(which)
        with told("the versions of the plant cannot be read"), self._engine.connect() as connection:
            row = connection.execute(query).one_or_none()
            return None if row is None else Source(row.text, row.catalogues)

    def with_source(self, source: Source) -> PlantVersion | None:
        """Return the newest version made of the same that can be used."""
        return next(iter(self._list(_same_source(source))), None)

    def file_taken(self) -> str | None:
        """Return the digest of the plant file as it was when it was last taken."""
        with told("the versions of the plant cannot be read"), self._engine.connect() as connection:
            return connection.execute(sa.select(plant_file.c.digest)).scalar()

    # -- changes ------------------------------------------------------------------------------------------------------

    def take_file(self, source: Source, now: Timestamp) -> None:
        """Note that the plant file is known as it is now."""
        with self._transaction() as connection:
            _take_file(connection, source.digest, now)

    def begin(self, source: Source, actor: Actor, now: Timestamp) -> PlantVersion:
        """Make the plant file version 1, the active one. Raises StoreError: there are versions already."""
        with self._transaction() as connection:
            if connection.execute(sa.select(_number).limit(1)).first() is not None:
                raise StoreError("another controller has begun on the database meanwhile", remedy="Start again.")
            digest, size = source.digest, len(source.text.encode())
            why = "the first start on this database"
            first = PlantVersion(
                1,
                digest,
                VersionState.ACTIVE,
                Origin.FILE,
                now,
                actor,
                why,
                size,
                now,
                actor,
                why,
                tries=1,
                models=source.models,
            )
            connection.execute(plant_versions.insert(), {**asdict(first), **_kept(source)})
            _take_file(connection, digest, now)
            append(connection, AuditRow(now, actor, "BeginLayout", "version 1", why, accepted=True))
            return first

    def stage(
        self, source: Source, origin: Origin, actor: Actor, reason: str, now: Timestamp, *, again: bool = False
    ) -> PlantVersion | Refusal:
        """Keep a plant as a new version. ``again``: also if there is one made of the same."""
        with self._transaction() as connection:
            same = None if again else connection.execute(_same_source(source)).one_or_none()
            number = (connection.execute(sa.select(sa.func.max(_number))).scalar() or 0) + 1
            refusal = _same(_version(same)) if same is not None else None if again else _too_many(connection)
            if refusal is not None:
                _note(connection, now, actor, "StageLayout", number, refusal)
                return refusal
            size, digest = len(source.text.encode()), source.digest
            made = PlantVersion(
                number, digest, VersionState.STAGED, origin, now, actor, reason, size, models=source.models
            )
            connection.execute(plant_versions.insert(), {**asdict(made), **_kept(source)})
            _note(connection, now, actor, "StageLayout", number, reason)
            return made

    def ask(
        self, number: int, actor: Actor, why: str, now: Timestamp, *, patient: bool, refusal: Refusal | None = None
    ) -> PlantVersion | Refusal:
        """Let a version be awaited. ``refusal``: something stands in its way, which is written into the audit."""

        def work(connection: sa.Connection, found: PlantVersion) -> PlantVersion | Refusal:
            other = connection.execute(
                sa.select(_number).where(plant_versions.c.state == VersionState.AWAITED)
            ).scalar()
            if found.state is VersionState.ACTIVE:
                return Refusal("conflict", f"Version {number} is the active one.", "Nothing has to be done.")
            if found.state is VersionState.REJECTED:
                remedy = "Stage its text again, if it is wanted after all."
                return Refusal("conflict", f"Version {number} is rejected: {found.note}", remedy)
            if other is not None:
                remedy = f"Wait for it, or POST /api/v1/layout/versions/{other}/reject."
                return Refusal("conflict", f"Version {other} is to become active already.", remedy)
            if refusal is not None:
                return refusal
            wish = {"asked": now, "asked_by": actor, "asked_why": why, "patient": patient, "note": ""}
            return replace(found, state=VersionState.AWAITED, **wish)  # type: ignore[arg-type]

        return self._asked(number, now, actor, "ActivateLayout", why, work)

    def reject(self, number: int, actor: Actor, reason: str, now: Timestamp) -> PlantVersion | Refusal:
        """Let a version not become active: a staged one is rejected, a former one that is awaited stays a former one."""

        def work(_connection: sa.Connection, found: PlantVersion) -> PlantVersion | Refusal:
            if found.state is VersionState.AWAITED and found.activated is not None:
                return _over(found, VersionState.FORMER, f"{actor} took the wish back: {reason}")
            if found.state not in {VersionState.STAGED, VersionState.AWAITED}:
                remedy = "Only what is staged or awaited can be rejected."
                return Refusal("conflict", f"Version {number} is {found.state.value}.", remedy)
            return replace(_over(found, VersionState.REJECTED, f"{actor}: {reason}"), rejected=now)

        return self._asked(number, now, actor, "RejectLayout", reason, work)

    def activate(self, number: int, now: Timestamp, lease: Lease, *, file: bool = False) -> PlantVersion:
        """Let an awaited version be the active one, and the active one a former one: both or nothing.

        It is on trial until it runs, and the way back leads past one that is on trial itself.
        ``file``: the plant file says so. Raises StoreError: it is not awaited any more; PlantHeld: another controller has come.
        """
        with self._transaction() as connection:
            lease.verify(connection)
            found = _found(connection, number)
            if found is None or found.state is not VersionState.AWAITED:
                raise StoreError(f"version {number} of the plant is not wanted any more")
            actor = found.asked_by or found.actor
            active = next(iter(_in(connection, VersionState.ACTIVE)), None)
            if active is not None:
                _write(connection, replace(active, state=active.at_rest, tries=None))
            before = None if active is None else active.number if active.tries is None else active.before
            made = replace(
                _over(found, VersionState.ACTIVE, ""),
                activated=now,
                activated_by=actor,
                why=found.asked_why,
                before=before,
                tries=1,
            )
            _write(connection, made)
            if file:
                _take_file(connection, made.digest, now)
            instead = "no version" if active is None else f"version {active.number}"
            _note(connection, now, actor, "ChangeLayout", number, f"instead of {instead}: {made.why}")
            return made

    def tried(self, number: int, tries: int | None, now: Timestamp) -> None:
        """Note how many starts were begun with the active version and came to nothing so far; None: it runs."""
        ran = {"ran": sa.func.coalesce(plant_versions.c.ran, now)} if tries is None else {}
        which = sa.and_(_number == number, plant_versions.c.state == VersionState.ACTIVE)
        with self._transaction() as connection:
            connection.execute(plant_versions.update().where(which).values(tries=tries, **ran))

    def give_up(self, number: int, note: str, now: Timestamp) -> None:
        """Let a version not be awaited any more: something stands in its way."""
        with self._transaction() as connection:
            found = _found(connection, number)
            if found is not None and found.state is VersionState.AWAITED:
                _write(connection, _over(found, found.at_rest, note))
                _note(connection, now, found.asked_by or found.actor, "ActivateLayout", number, _not(note))

    def fall_back(self, number: int, note: str, now: Timestamp, lease: Lease) -> PlantVersion | None:
        """The active version, on trial, cannot be run: let the one before it be active again; None: there is none, or it has run.

        It is rejected, unless it ran some time before. The one before is on trial in its turn if it never ran.
        Raises PlantHeld: another controller has come.
        """
        with self._transaction() as connection:
            lease.verify(connection)
            found = _found(connection, number)
            before = None if found is None or found.before is None else _found(connection, found.before)
            if found is None or before is None or found.state is not VersionState.ACTIVE or found.tries is None:
                return None
            state, since = (VersionState.REJECTED, now) if found.ran is None else (VersionState.FORMER, None)
            _write(connection, replace(_over(found, state, note), tries=None, rejected=since))
            _prune(connection, now)
            made = replace(before, state=VersionState.ACTIVE, tries=1 if before.ran is None else None)
            _write(connection, made)
            actor = found.activated_by or found.actor
            _note(connection, now, actor, "ChangeLayout", number, _not(f"{note}; version {made.number} goes on"))
            return made

    # -- within -------------------------------------------------------------------------------------------------------

    def _asked(
        self, number: int, now: Timestamp, actor: Actor, action: str, said: str, work: Work
    ) -> PlantVersion | Refusal:
        with self._transaction() as connection:
            found = _found(connection, number)
            missing = Refusal("not-found", f"There is no version {number}.", "GET /api/v1/layout/versions lists them.")
            made = missing if found is None else work(connection, found)
            if isinstance(made, PlantVersion):
                _write(connection, made)
                _prune(connection, now)
            _note(connection, now, actor, action, number, made if isinstance(made, Refusal) else said)
            return made

    def _in_state(self, state: VersionState) -> PlantVersion | None:
        return next(iter(self._list(_state(state))), None)

    def _list(self, query: sa.Select[Any]) -> list[PlantVersion]:
        with told("the versions of the plant cannot be read"), self._engine.connect() as connection:
            return [_version(row) for row in connection.execute(query)]

    @contextmanager
    def _transaction(self) -> Iterator[sa.Connection]:
        with told("the versions of the plant cannot be kept"), self._engine.begin() as connection:
            # On PostgreSQL, changes of several programs come one after the other, as they do on SQLite.
            if connection.dialect.name == "postgresql":
                connection.execute(sa.text("LOCK TABLE plant_versions IN SHARE ROW EXCLUSIVE MODE"))
            yield connection


def _kept(source: Source) -> dict[str, Any]:
    """Return the columns of what a version is made of."""
    return {"text": source.text, "catalogues": None if source.catalogues is None else dict(source.catalogues)}


def _same_source(source: Source) -> sa.Select[Any]:
    same = sa.and_(plant_versions.c.digest == source.digest, plant_versions.c.state.in_(LIVE))
    return sa.select(*_COLUMNS).where(same).order_by(_number.desc()).limit(1)


def _state(state: VersionState) -> sa.Select[Any]:
    return sa.select(*_COLUMNS).where(plant_versions.c.state == state).order_by(_number.desc())


def _in(connection: sa.Connection, state: VersionState) -> list[PlantVersion]:
    """Return the versions in a state, newest first."""
    return [_version(row) for row in connection.execute(_state(state))]


def _version(row: Found) -> PlantVersion:
    values = {name: getattr(row, name) for name in _FIELDS}
    return PlantVersion(
        **{**values, "state": VersionState(row.state), "origin": Origin(row.origin), "models": row.models or {}}
    )


def _found(connection: sa.Connection, number: int) -> PlantVersion | None:
    row = connection.execute(sa.select(*_COLUMNS).where(_number == number)).one_or_none()
    return None if row is None else _version(row)


def _write(connection: sa.Connection, version: PlantVersion) -> None:
    connection.execute(plant_versions.update().where(_number == version.number), asdict(version))


def _prune(connection: sa.Connection, now: Timestamp) -> None:
    """Throw away the texts of versions that were rejected long ago."""
    rejected = sa.and_(plant_versions.c.state == VersionState.REJECTED, plant_versions.c.pruned.is_(None))
    last = plant_versions.c.rejected.desc(), _number.desc()
    late = [row.number for row in connection.execute(sa.select(_number).where(rejected).order_by(*last))]
    if late := late[KEPT_REJECTED:]:
        connection.execute(
            plant_versions.update().where(_number.in_(late)).values(text="", catalogues=None, pruned=now)
        )


def _too_many(connection: sa.Connection) -> Refusal | None:
    staged = sa.and_(plant_versions.c.state == VersionState.STAGED, plant_versions.c.origin == Origin.UPLOAD)
    found = connection.execute(sa.select(sa.func.count()).where(staged)).scalar_one()
    remedy = "Reject what nobody wants any more: POST /api/v1/layout/versions/N/reject."
    return Refusal("conflict", f"{found} versions are staged already.", remedy) if found >= MOST_STAGED else None


def _take_file(connection: sa.Connection, digest: str, now: Timestamp) -> None:
    connection.execute(plant_file.delete())
    connection.execute(plant_file.insert(), {"one": 1, "digest": digest, "at": now})


def _over(version: PlantVersion, state: VersionState, note: str) -> PlantVersion:
    """Return a version that is not awaited any more."""
    return replace(version, state=state, asked=None, asked_by=None, asked_why="", patient=False, note=note)


def _note(
    connection: sa.Connection, now: Timestamp, actor: Actor, action: str, number: int, said: str | Refusal
) -> None:
    refused = isinstance(said, Refusal)
    detail = f"refused: {said.reason}" if isinstance(said, Refusal) else said
    append(connection, AuditRow(now, actor, action, f"version {number}", detail, accepted=not refused))


def _not(note: str) -> Refusal:
    return Refusal("not-now", note)


def _same(version: PlantVersion) -> Refusal:
    number, state = version.number, version.state
    if state is VersionState.ACTIVE:
        return Refusal("conflict", f"That is the active version {number}, to the letter.", "Nothing has to be done.")
    remedy = f"Activate that one: POST /api/v1/layout/versions/{number}/activate."
    return Refusal("conflict", f"That is version {number} ({state.value}), to the letter.", remedy)
