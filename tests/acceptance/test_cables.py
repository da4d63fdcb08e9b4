"""A whole plant on bad cables, over loopback: see ``tests.acceptance.cables``. Minutes of real time, so in ``make campaign``."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.acceptance.cables import TERMINAL, Weather, stormed
from tests.store.conftest import own_schema

pytestmark = pytest.mark.campaign


@pytest.fixture(params=[None, pytest.param("postgres", marks=pytest.mark.postgres)])
def database(request: pytest.FixtureRequest) -> Iterator[str | None]:
    """A PostgreSQL database that is cut off now and then, or none."""
    if request.param is None:
        yield None
        return
    with own_schema() as url:
        yield url


def test_no_rule_is_broken_and_every_job_ends_on_bad_cables(tmp_path: Path, database: str | None) -> None:
    outcome = stormed(tmp_path, seed=1, seconds=40.0, kills=2, database=database)
    assert outcome.wrong == ()
    assert (outcome.kills, outcome.unplugged) == (2, 1)
    assert all(outcome.met[weather] for weather in Weather)
    assert set(outcome.states) <= TERMINAL
    assert sum(outcome.states.values()) > 5
