"""All looks, one after the other; each needs what came before and is left out where that failed."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.doctor.found import Found, doubtful, well, wrong
from app.cli.plainly import CannotStart
from app.domain.errors import HoistwayError
from app.domain.units import Timestamp

if TYPE_CHECKING:
    from app.domain.layout import Plant
    from app.settings import Settings

AHEAD = 1.0
"""Seconds that the clocks of this machine and of the database may be apart. Our choice."""


def everything(config: Path | None, *, reach: bool, **given: object) -> list[Found]:
    """Return all that was found, in the order in which it would be mended."""
    from app.cli.doctor import machine
    from app.settings import SettingsError, load

    found = list(machine.looks())
    try:
        settings = load(config, None, **given)
    except SettingsError as error:
        return [*found, wrong("settings", error.message, error.remedy or "docs/operations.md")]
    found.append(well("settings", f"server at {settings.host}:{settings.port}, database {_shown(settings.database)}"))
    running, more = _database(settings)
    found += more
    plant, more = _plant(settings)
    found += more
    if not running:
        found.append(_port("server", settings.host, settings.port, "--port"))
    if plant is not None:
        from app.cli.doctor.lines import looks

        found += looks(plant, running=running, reach=reach)
        found += machine.room_for(len(plant.vehicles), settings.connections)
    return found


def _shown(url: str) -> str:
    from app.store.engine import parsed

    try:
        return parsed(url).render_as_string(hide_password=True)
    except HoistwayError:
        return "that is none of ours"  # it may hold a password


def _database(settings: Settings) -> tuple[bool, list[Found]]:
    """Return whether a controller runs on it, and what was found."""
    from app.store.condition import condition
    from app.store.schema import newest

    try:
        there = condition(settings.database)
    except HoistwayError as error:
        return False, [wrong("database", error.message, error.remedy)]
    found = list(_writable(settings.database))
    if there.schema is None:
        return False, [*found, well("database", "empty; the first start makes its tables")]
    found.append(well("database", f"plant {there.plant}, schema {there.schema}"))
    if there.schema != newest():
        remedy = "The next start brings it up to date. Back it up before: hoistway db backup FILE."
        found.append(doubtful("database", f"its schema is {there.schema}, ours is {newest()}", remedy))
    if there.put_back is not None:
        remedy = "The next start holds every vehicle until a person has compared it (docs/operations.md)."
        found.append(doubtful("database", f"the backup {there.put_back} was put back", remedy))
    if there.holder is not None:
        found.append(well("controller", f"runs: {there.holder}"))
    return there.holder is not None, [*found, *_clocks(there.last, there.clock)]


def _writable(url: str) -> Iterator[Found]:
    from app.cli.doctor.machine import disk
    from app.store.engine import file_of, parsed

    path = file_of(parsed(url))
    if path is not None:
        yield from disk(path)


def _clocks(last: Timestamp | None, clock: Timestamp | None) -> Iterator[Found]:
    now = time.time()
    if last is not None and last > now + AHEAD:
        remedy = "Set this machine's clock, or wait: times of jobs and history would go backwards."
        yield wrong("clock", f"it is {last - now:.0f} s behind the newest event in the database", remedy)
    if clock is not None and abs(clock - now) > AHEAD:
        remedy = "Let both keep time by NTP. Leases are safe: the database's clock alone decides."
        yield doubtful("clock", f"this machine's and the database's clock are {abs(clock - now):.1f} s apart", remedy)


def _plant(settings: Settings) -> tuple[Plant | None, list[Found]]:
    from app.cli.check import counts
    from app.cli.running import plant_of

    if settings.plant is None:
        return None, [wrong("plant", "no plant file is named", "Say --plant FILE, or set HOISTWAY_PLANT.")]
    try:
        plant = plant_of(settings.plant)
    except CannotStart as error:
        return None, [wrong("plant", error.message, error.remedy)]
    told = counts(plant)
    return plant, [well("plant", f"{plant.name}: {told['barcodes']} barcodes, {told['vehicles']} vehicles")]


def _port(what: str, host: str, port: int, option: str) -> Found:
    from app.cli.running import bound

    try:
        bound(host, port, option).close()
    except CannotStart as error:
        return wrong(what, error.message, error.remedy)
    return well(what, f"{host}:{port} is free")
