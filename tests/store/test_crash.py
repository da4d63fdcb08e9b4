"""A process killed with -9 loses nothing that was committed, and keeps the plant from nobody."""

import signal
import subprocess
import sys

import pytest
import sqlalchemy as sa

from app.domain.errors import PlantHeld
from tests.store.conftest import Open
from tests.store.samples import job

COMMIT_AND_WAIT = """
import sys
from app.store.ledger import SqlLedger
from tests.store.samples import job

ledger = SqlLedger(sys.argv[1], "P1", "the killed one", lambda: 1000.0, lease_seconds=600.0)
ledger.load()
for number in range(1, 6):
    ledger.commit([job(number)])
with ledger._transaction("left open") as connection:
    connection.exec_driver_sql("UPDATE jobs SET priority = 1")
    print("committed", flush=True)
    sys.stdin.read()
"""


def run_out(raw: sa.Engine) -> None:
    """Let so much time pass that the lease is over."""
    with raw.begin() as connection:
        connection.execute(sa.text("UPDATE lease SET deadline = deadline - 3600"))


def test_a_killed_controller_has_lost_nothing_and_its_plant_can_be_taken(
    url: str, open_ledger: Open, raw: sa.Engine
) -> None:
    with subprocess.Popen(
        [sys.executable, "-c", COMMIT_AND_WAIT, url], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "committed\n"
        if url.startswith("sqlite"):
            with pytest.raises(PlantHeld, match="the killed one"):
                open_ledger(url)
        child.send_signal(signal.SIGKILL)
        child.wait()
    if not url.startswith("sqlite"):
        run_out(raw)
    kept = open_ledger(url).load()
    assert kept.jobs == tuple(job(number) for number in range(1, 6))
    assert kept.epoch == 2
    assert not kept.fresh
    assert kept.next_order == 6
