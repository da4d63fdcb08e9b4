"""Which addresses a command cannot listen at: all of them are said at once, before anything begins."""

from __future__ import annotations

import errno
import socket
from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.plainly import CannotStart, said
from app.cli.tongue import told_here

if TYPE_CHECKING:
    from app.domain.layout import Plant


@dataclass(frozen=True, slots=True)
class Wanted:
    """An address that is to be listened at; ``by`` is whose it is: a machine of the plant file, or an option (``--port``)."""

    host: str
    port: int
    by: str

    def __str__(self) -> str:
        return f"{f'[{self.host}]' if ':' in self.host else self.host}:{self.port} ({self.by})"


def simulated_at(plant: Plant, host: str | None = None) -> Iterator[Wanted]:
    """Give where the machines of a plant are simulated; at this ``host``, if one is given."""
    for vehicle in plant.hoists:
        if not (vehicle.listen and plant.listen is not None):
            yield Wanted(host or vehicle.host, vehicle.port, vehicle.id)
    for link in plant.links:
        if link.serial is None:
            yield Wanted(host or link.host, link.port, link.id)


def demanded(wanted: Iterable[Wanted], file: Path) -> None:
    """See that all these addresses can be listened at, for a plant of that file.

    Raises CannotStart: it names each that cannot, why, and what changes it.
    """
    refused = list(_refused(wanted))
    if not refused:
        return
    parts = []
    for why, ones in groupby(sorted(refused, key=lambda one: one[1]), key=lambda one: one[1]):
        parts.append(told_here(f"cannot listen at {', '.join(str(one) for one, _, _ in ones)}: {why}"))
    raise CannotStart("; ".join(parts), remedy=" ".join(_remedies(refused, file)))


def _refused(wanted: Iterable[Wanted]) -> Iterator[tuple[Wanted, str, int]]:
    """Give those that cannot be listened at, with the system's word and number for it."""
    with ExitStack() as held:
        for one in wanted:
            try:
                held.enter_context(socket.create_server((one.host, one.port), family=_family(one.host)))
            except OSError as wrong:
                yield one, said(wrong), wrong.errno or 0


def _family(host: str) -> socket.AddressFamily:
    return socket.AF_INET6 if ":" in host else socket.AF_INET


def _remedies(refused: Iterable[tuple[Wanted, str, int]], file: Path) -> Iterator[str]:
    options = [one.by for one, _, _ in refused if one.by.startswith("--")]
    numbers = {number for one, _, number in refused if not one.by.startswith("--")}
    if options:
        yield told_here(f"Choose another one with {', '.join(options)}.")
    if errno.EADDRINUSE in numbers:
        yield told_here(f"Is it simulated already? End that, or write other addresses into {file}.")
    elif errno.EADDRNOTAVAIL in numbers:
        yield told_here(f"Write addresses of this machine into {file}, or give one with sim --host.")
    elif numbers:
        yield told_here(f"Write other addresses into {file}.")
