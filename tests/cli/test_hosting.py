"""The controller and its server in one process: what comes up, what does not, and what is told of it."""

import asyncio
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.cli import hosting
from app.cli.changes import Changes
from app.cli.plainly import CannotStart
from app.cli.running import bound, plant_and_text_of
from app.domain.layout import Plant
from app.domain.units import Timestamp
from app.runtime.notify import Notifier
from app.settings import Settings, load
from app.store.versions import VersionStore

NOW = Timestamp(1000.0)
PLANT = """
name: P1
barcodes:
  1: [0, 0]
  2: [5000, 0]
  3: [5000, 5000]
  4: [0, 5000]
track:
  - {through: [1, 2, 3, 4, 1]}
vehicles:
  V1: {dev_id: 1, address: "127.0.0.1:1", start: 1, length: 500}
"""
COMING = PLANT.replace('address: "127.0.0.1:1"', "listen: true") + 'listen: "127.0.0.1:PORT"\n'


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    return load(database=f"sqlite:///{tmp_path}/plant.db", log_level="error")


@pytest.fixture
def taken() -> Iterator[int]:
    """A port that somebody else listens at."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        yield server.getsockname()[1]


def test_a_server_that_does_not_come_up_is_an_error_and_nobody_is_told_that_it_is_ready(
    tmp_path: Path, settings: Settings
) -> None:
    file, told = tmp_path / "plant.yaml", list[str]()
    file.write_text(PLANT, encoding="utf-8")
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager, socket.socket(type=socket.SOCK_DGRAM) as deaf:
        manager.bind(str(tmp_path / "notify"))
        manager.settimeout(0.0)
        deaf.bind(("127.0.0.1", 0))
        serving = hosting.serve(
            plant_and_text_of(file)[0],
            settings,
            deaf,
            asyncio.Event(),
            told.append,
            notify=Notifier({"NOTIFY_SOCKET": str(tmp_path / "notify")}),
        )
        with pytest.raises(CannotStart, match=r"requests cannot be answered: .*Stream Socket"):
            asyncio.run(serving)
        assert told == []
        with pytest.raises(BlockingIOError):
            manager.recv(1000)


def test_a_version_that_dies_soon_after_its_start_gives_way_and_one_that_ran_for_a_while_does_not(
    tmp_path: Path, settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    file, ran = tmp_path / "plant.yaml", list[int | None]()
    store = VersionStore(settings.database)

    async def killed(plant: Plant, changes: Changes, *, proven: bool) -> None:
        ready = asyncio.Event()
        with bound("127.0.0.1", 0) as listening:
            serving = asyncio.create_task(
                hosting.serve(
                    plant,
                    settings,
                    listening,
                    asyncio.Event(),
                    lambda _: ready.set(),
                    seen=lambda controller: ran.append(controller.version),
                    changes=changes,
                )
            )
            await ready.wait()
            while proven and on_trial():
                await asyncio.sleep(0)
            serving.cancel()
            await serving

    def on_trial() -> bool:
        active = store.active()
        return active is None or active.ran is None or active.tries is not None

    def start(text: str, *, proven: bool = False) -> None:
        file.write_text(text, encoding="utf-8")
        with (
            pytest.raises(asyncio.CancelledError),
            Changes(file, settings.database, lambda: NOW) as changes,
        ):
            asyncio.run(killed(changes.begin(*plant_and_text_of(file)), changes, proven=proven))

    edited = PLANT + "\njobs: {overdue: 700}\n"
    monkeypatch.setattr(hosting, "TRIAL", 0.0)
    start(PLANT, proven=True)
    monkeypatch.setattr(hosting, "TRIAL", 30.0)
    for _ in range(3):
        start(edited)
    assert ran == [1, 2, 2, 1]
    assert [(one.number, one.state.value) for one in store.versions()] == [(2, "rejected"), (1, "active")]
    monkeypatch.setattr(hosting, "TRIAL", 0.0)
    better = edited.replace("700", "800")
    for number in range(4):
        start(better, proven=number == 0)
    assert ran[4:] == [3, 3, 3, 3]
    store.close()


def test_an_edited_plant_that_cannot_be_started_gives_way_to_the_one_before(
    tmp_path: Path, settings: Settings, taken: int
) -> None:
    file, ran = tmp_path / "plant.yaml", list[int | None]()

    def begun(text: str, changes: Changes) -> Plant:
        file.write_text(text, encoding="utf-8")
        return changes.begin(*plant_and_text_of(file))

    async def run(plant: Plant, changes: Changes) -> int:
        stop = asyncio.Event()
        with bound("127.0.0.1", 0) as listening:
            return await hosting.serve(
                plant,
                settings,
                listening,
                stop,
                lambda _: stop.set(),
                seen=lambda controller: ran.append(controller.version),
                changes=changes,
            )

    with Changes(file, settings.database, lambda: NOW) as changes:
        begun(PLANT, changes)
        asyncio.run(changes.started())
        plant = begun(COMING.replace("PORT", str(taken)), changes)
        assert changes.number == 2
        assert asyncio.run(run(plant, changes)) == 0
        found = {one.number: (one.state.value, one.note) for one in changes.versions.store.versions()}
    assert ran == [1]
    why = f"cannot listen for vehicles at 127.0.0.1:{taken}: Address already in use"
    assert found == {1: ("active", ""), 2: ("rejected", why)}
