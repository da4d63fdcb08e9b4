"""The lines: serial ports of this machine, the address that vehicles come to, and whoever is dialled."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Iterator
from pathlib import Path

from app.cli.doctor.found import Found, doubtful, well, wrong
from app.cli.plainly import CannotStart, said
from app.domain.layout import Plant

PATIENCE = 2.0
"""Seconds that a vehicle has to take a connection. Our choice."""
AT_ONCE = 100
"""Vehicles that are knocked at at the same time. Our choice."""


def looks(plant: Plant, *, running: bool, reach: bool) -> Iterator[Found]:
    """Look at every line of a plant. While a controller runs, its lines are its own, and nobody is knocked at."""
    for link in plant.links:
        if link.serial is not None:
            yield _serial(f"link {link.id}", link.serial.device)
    if running:
        yield well("lines", "the controller that runs has them: GET /api/v1/vehicles says how each is")
        return
    if plant.listen is not None:
        yield _listening(plant.listen)
    if reach:
        yield from asyncio.run(_reached(plant))


def _serial(what: str, device: str) -> Found:
    path = Path(device)
    if not path.exists():
        return wrong(
            what, f"there is no {device}", "Plug the converter in, or write the port's name into the plant file."
        )
    if not os.access(path, os.R_OK | os.W_OK):
        return wrong(
            what, f"this user may not use {device}", f"Add it to the port's group: usermod -aG {_group(path)} USER"
        )
    return well(what, f"{device} is there")


def _group(path: Path) -> str:
    try:
        return path.group()
    except KeyError:
        return str(path.stat().st_gid)


def _listening(address: tuple[str, int]) -> Found:
    from app.cli.running import bound

    host, port = address
    try:
        bound(host, port, "listen in the plant file").close()
    except CannotStart as error:
        return wrong("vehicles come to", error.message, error.remedy)
    return well("vehicles come to", f"{host}:{port} is free")


async def _reached(plant: Plant) -> list[Found]:
    dialled = {f"vehicle {v.id}": (v.host, v.port) for v in plant.hoists if not v.listen and v.in_service}
    dialled |= {f"link {link.id}": (link.host, link.port) for link in plant.links if link.serial is None}
    turns = asyncio.Semaphore(AT_ONCE)
    found = await asyncio.gather(*(_knocked(what, *where, turns) for what, where in dialled.items()))
    silent = [one for one in found if one is not None]
    if len(silent) < len(found):
        silent.insert(
            0, well("lines", f"{len(found) - len(silent)} of {len(found)} vehicles and links take a connection")
        )
    return silent


async def _knocked(what: str, host: str, port: int, turns: asyncio.Semaphore) -> Found | None:
    """Connect and hang up; return what is wrong, None if somebody answered."""
    async with turns:
        try:
            _, writer = await asyncio.wait_for(asyncio.open_connection(host, port), PATIENCE)
        except TimeoutError:
            return doubtful(
                what, f"{host}:{port} does not answer", "Is it switched on, on this network, not behind a firewall?"
            )
        except OSError as error:
            remedy = "Does its controller program run? Is it connected to another controller?"
            return doubtful(what, f"{host}:{port} cannot be reached: {said(error)}", remedy)
        writer.close()
        return None
