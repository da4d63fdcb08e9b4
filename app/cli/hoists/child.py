"""How the measuring process and its children talk: one word a line to the child, one JSON object a line back."""

import asyncio
import json
import pickle
import sys
from collections.abc import Callable
from pathlib import Path

from app.domain.layout import Plant

Figures = dict[str, object]


def tell(figures: Figures) -> None:
    """Say something to the parent."""
    print(json.dumps(figures), flush=True)


def plant_in(file: str) -> Plant:
    """Return the plant that the parent has put there."""
    plant = pickle.loads(Path(file).read_bytes())  # noqa: S301 (the parent wrote it, into a directory of its own)
    assert isinstance(plant, Plant)
    return plant


async def obey(begin: Callable[[], None], end: Callable[[], Figures]) -> None:
    """Begin and end to measure as the parent says; return when it is gone or has heard the figures."""
    reader = asyncio.StreamReader()
    loop = asyncio.get_running_loop()
    await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)
    while word := (await reader.readline()).decode().strip():
        if word == "begin":
            begin()
            tell({"begun": True})
        elif word == "end":
            tell(end())
            return
