"""A reception over a database of its own, with passwords that cost little and a clock that the test moves."""

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from random import Random
from typing import cast

import sqlalchemy as sa
from argon2 import PasswordHasher

from app.domain.access import Role
from app.domain.ids import Actor
from app.domain.units import Seconds, Timestamp
from app.runtime.access import Access
from app.runtime.clock import Clock
from app.runtime.passwords import Passwords
from app.runtime.reception import Reception
from app.store.access import AccessStore
from app.store.tables import metadata

CHEAP = PasswordHasher(time_cost=1, memory_cost=8, parallelism=1)
PASSWORD = "correct horse 1"
ROOT = Actor("root")
START = 1_767_225_600.0


class Hand(Clock):
    """Time goes on when the test says so; monotonic and UTC seconds in step."""

    __slots__ = ("at",)

    def __init__(self) -> None:
        super().__init__()
        self.at = START

    @property
    def now(self) -> Callable[[], Seconds]:
        return lambda: cast(Seconds, self.at)

    def utc(self) -> Timestamp:
        return Timestamp(self.at)


def made(url: str) -> AccessStore:
    """Return a store on a database whose tables are there."""
    engine = sa.create_engine(url)
    metadata.create_all(engine)
    engine.dispose()
    return AccessStore(url, Random(7).randbytes)


@asynccontextmanager
async def reception(tmp_path: Path, clock: Clock | None = None) -> AsyncIterator[Reception]:
    """Give a reception that knows nobody yet."""
    access = Access(made(f"sqlite:///{tmp_path}/access.db"), clock or Hand())
    await access.start()
    try:
        yield Reception(access, Passwords(CHEAP))
    finally:
        await access.stop()


async def with_admin(desk: Reception) -> Reception:
    """Add the person kim, who may do everything."""
    assert await desk.add_user("kim", frozenset({Role.ADMIN}), PASSWORD, ROOT) is None
    return desk
