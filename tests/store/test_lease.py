"""One controller per plant (COMMANDS 3.7)."""

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
import sqlalchemy as sa

from app.domain.errors import PlantHeld, StoreError
from app.domain.units import Timestamp
from app.store import lease
from app.store.condition import condition
from app.store.ledger import SqlLedger
from tests.store.conftest import Open
from tests.store.samples import job


@contextmanager
def renewed(ledger: SqlLedger) -> Iterator[None]:
    """Keep the lease alive, as a running controller does."""
    over = threading.Event()

    def renew() -> None:
        while not over.wait(0.05):
            ledger.renew()

    thread = threading.Thread(target=renew)
    thread.start()
    yield
    over.set()
    thread.join()


def shift(raw: sa.Engine, seconds: float) -> None:
    """Move the deadline, as if the database's clock had jumped the other way."""
    with raw.begin() as connection:
        connection.execute(sa.text("UPDATE lease SET deadline = deadline + :by"), {"by": seconds})


def test_a_second_controller_is_told_who_holds_the_plant_since_when_and_what_to_do(url: str, open_ledger: Open) -> None:
    first = open_ledger(url, holder="server A, process 42", now=86_400.0)
    since = "1970-01-02" if first.lease_seconds > 1e9 else "since 20"
    with renewed(first), pytest.raises(PlantHeld, match="held by server A, process 42") as caught:
        open_ledger(url, holder="server B")
    assert since in caught.value.message
    assert "Stop that controller first" in caught.value.remedy
    first.load()
    first.commit([job(1)])


def test_a_plant_that_was_let_go_is_free_at_once(url: str, open_ledger: Open) -> None:
    first = open_ledger(url)
    first.close()
    first.close()
    second = open_ledger(url)
    assert second.load().epoch == 1


def test_a_jump_of_the_wall_clock_costs_nobody_the_plant(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url, now=1e9)
    ledger.load()
    ledger._now_utc = lambda: Timestamp(2e9)
    ledger.commit([job(1)])
    ledger._now_utc = lambda: Timestamp(0.0)
    ledger.renew()
    ledger.commit([job(2)])
    assert len(ledger.load().jobs) == 2


def test_a_removed_lock_file_ends_the_controller(sqlite_url: str, open_ledger: Open, tmp_path: Path) -> None:
    ledger = open_ledger(sqlite_url)
    ledger.load()
    (tmp_path / "plant.db.lock").unlink()
    with pytest.raises(PlantHeld, match=r"plant\.db\.lock was removed"):
        ledger.commit([job(1)])
    other = open_ledger(sqlite_url)
    assert other.load().jobs == ()
    with pytest.raises(PlantHeld, match="was removed"):
        ledger.renew()


def test_two_names_of_one_file_are_one_plant(sqlite_url: str, open_ledger: Open, tmp_path: Path) -> None:
    open_ledger(sqlite_url, holder="first")
    (tmp_path / "other.db").symlink_to(tmp_path / "plant.db")
    with pytest.raises(PlantHeld, match="held by first"):
        open_ledger(f"sqlite:///{tmp_path}/other.db")


def test_a_directory_that_is_not_there_is_named(open_ledger: Open, tmp_path: Path) -> None:
    with pytest.raises(StoreError, match=r"cannot open .*none/plant\.db.lock") as caught:
        open_ledger(f"sqlite:///{tmp_path}/none/plant.db")
    assert "directory exists" in caught.value.remedy


def test_who_looks_who_holds_the_plant_keeps_nobody_from_taking_it(
    sqlite_url: str, open_ledger: Open, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = open_ledger(sqlite_url, holder="server A")
    assert (condition(sqlite_url).holder or "").startswith("server A, for plant P1")
    first.close()
    (tmp_path / "plant.db.lock").write_text("server A, which was killed\n", encoding="utf-8")
    close, taken = os.close, list[SqlLedger]()

    def close_late(descriptor: int) -> None:
        """What was opened for a look is still open when a controller starts."""
        if Path(f"/proc/self/fd/{descriptor}").readlink().suffix == ".lock":
            monkeypatch.setattr(os, "close", close)
            taken.append(open_ledger(sqlite_url, holder="server B"))
        close(descriptor)

    monkeypatch.setattr(os, "close", close_late)
    assert condition(sqlite_url).holder is None
    assert len(taken) == 1
    assert (condition(sqlite_url).holder or "").startswith("server B")


@pytest.mark.postgres
class TestLeaseByDeadline:
    @pytest.fixture
    def url(self, postgres_url: str) -> str:
        return postgres_url

    def test_a_dead_controllers_plant_is_taken_when_its_lease_has_run_out(
        self, url: str, open_ledger: Open, raw: sa.Engine
    ) -> None:
        first = open_ledger(url)
        first.load()
        first.commit([job(1)])
        shift(raw, -3600)
        second = open_ledger(url, holder="second")
        assert len(second.load().jobs) == 1
        with pytest.raises(PlantHeld, match="held by second"):
            first.commit([job(2)])
        with pytest.raises(PlantHeld, match="held by second"):
            first.renew()

    def test_a_controller_that_was_stopped_for_longer_than_its_lease_writes_nothing(
        self, url: str, open_ledger: Open, raw: sa.Engine
    ) -> None:
        ledger = open_ledger(url)
        ledger.load()
        shift(raw, -3600)
        with pytest.raises(PlantHeld, match=r"stopped, or cut off .* longer than 10 s") as caught:
            ledger.commit([job(1)])
        assert "Restart it" in caught.value.remedy
        ledger.close()
        assert open_ledger(url).load().jobs == ()

    def test_a_controller_whose_lease_was_taken_away_writes_nothing(
        self, url: str, open_ledger: Open, raw: sa.Engine
    ) -> None:
        ledger = open_ledger(url)
        with raw.begin() as connection:
            connection.execute(sa.text("DELETE FROM lease"))
        with pytest.raises(PlantHeld, match="has run out"):
            ledger.load()

    def test_a_database_clock_set_back_does_not_keep_a_dead_controllers_plant(
        self, url: str, open_ledger: Open, raw: sa.Engine, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        waited: list[float] = []
        monkeypatch.setattr(lease, "pause", lambda _, seconds: waited.append(seconds))
        open_ledger(url, seconds=30)
        shift(raw, 3600)
        assert open_ledger(url, seconds=30).load().epoch == 1
        assert sum(waited) == pytest.approx(30)

    def test_every_commit_renews(self, url: str, open_ledger: Open, raw: sa.Engine) -> None:
        ledger = open_ledger(url, seconds=3600)
        ledger.load()
        shift(raw, -3000)
        ledger.commit([job(1)])
        with raw.begin() as connection:
            left = connection.execute(
                sa.text("SELECT deadline - extract(epoch FROM clock_timestamp()) FROM lease")
            ).scalar_one()
        assert left > 700

    def test_a_lease_that_somebody_takes_in_between_is_not_taken_twice(self, url: str, open_ledger: Open) -> None:
        open_ledger(url).close()
        opened: list[SqlLedger] = []
        refused: list[PlantHeld] = []

        over = threading.Event()

        def race(name: str) -> None:
            try:
                ledger = open_ledger(url, holder=name)
            except PlantHeld as error:
                refused.append(error)
                over.set()
                return
            opened.append(ledger)
            with renewed(ledger):
                over.wait(30)

        threads = [threading.Thread(target=race, args=(name,)) for name in "AB"]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert (len(opened), len(refused)) == (1, 1)


@pytest.mark.parametrize("without", ["a system other than Linux", "locks that can be asked about"])
def test_where_nobody_can_see_the_holder_the_lock_keeps_others_out_all_the_same(
    without: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*_: object) -> None:
        raise OSError(22, "Invalid argument")

    if without.startswith("a system"):
        monkeypatch.setattr("sys.platform", "darwin")
        monkeypatch.delattr("fcntl.F_OFD_SETLK")
        monkeypatch.delattr("fcntl.F_OFD_GETLK")
    else:
        monkeypatch.setattr("fcntl.fcntl", refused)
    held = lease.FileLease(tmp_path / "plant.db", "P1", "server A", Timestamp(0.0))
    assert lease.holder_of(tmp_path / "plant.db") is None
    with pytest.raises(PlantHeld, match="held by server A"):
        lease.FileLease(tmp_path / "plant.db", "P1", "server B", Timestamp(0.0))
    held.release()
