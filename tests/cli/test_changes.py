"""With which version a controller starts: whichever was changed last counts, the plant file or the active version."""

import asyncio
import re
from collections.abc import Callable, Iterator
from contextlib import ExitStack, suppress
from dataclasses import replace
from pathlib import Path

import pytest
import sqlalchemy as sa
from typer.testing import CliRunner

from app.cli import app
from app.cli.changes import Changes
from app.cli.plainly import CannotStart, FileInError
from app.cli.running import plant_and_text_of
from app.domain.errors import Refusal, StoreError
from app.domain.ids import Actor, StationId
from app.domain.job import Job, JobState
from app.domain.layout import Plant, PulseSet
from app.domain.records import StationDest
from app.domain.units import Pulses, Timestamp
from app.domain.versions import Origin, PlantVersion, Source
from app.plant.difference import difference
from app.runtime.telemetry import logger
from app.store.lease import NoLease
from app.store.ledger import SqlLedger
from tests.store.samples import job

PLANTS = Path(__file__).parents[2] / "plants"
TEXT = (PLANTS / "small.yaml").read_text(encoding="utf-8")
WITH_P9 = TEXT.replace("  B1: {", "  P9: {kind: port, at: 108, dest: {shft: 5, rota: 5, lift: 5}}\n  B1: {")
WITHOUT_P2 = "\n".join(line for line in TEXT.splitlines() if not line.startswith("  P2:")) + "\n"
OTHERS = "name: small\nwords: of another program\n"
NOW = Timestamp(1000.0)
KIM = Actor("kim")
Start = Callable[[str], tuple[Plant, Changes]]


@pytest.fixture
def url(tmp_path: Path) -> str:
    return f"sqlite:///{tmp_path}/plant.db"


@pytest.fixture
def start(tmp_path: Path, url: str) -> Iterator[Start]:
    """Start as ``hoistway serve`` does, with a plant file that says this; the controller comes to run."""
    file = tmp_path / "small.yaml"

    def started(text: str) -> tuple[Plant, Changes]:
        file.write_text(text, encoding="utf-8")
        changes = stack.enter_context(Changes(file, url, lambda: NOW))
        plant = changes.begin(*plant_and_text_of(file))
        asyncio.run(changes.started())
        return plant, changes

    with ExitStack() as stack:
        yield started


@pytest.fixture
def killed(tmp_path: Path, url: str) -> Start:
    """Start in the same way, and be killed before the controller runs."""
    file = tmp_path / "small.yaml"

    def begun(text: str) -> tuple[Plant, Changes]:
        file.write_text(text, encoding="utf-8")
        changes = Changes(file, url, lambda: NOW)
        plant = changes.begin(*plant_and_text_of(file))
        changes.__exit__(SystemError)
        return plant, changes

    return begun


def stations(plant: Plant) -> set[str]:
    return {station.id for station in plant.stations}


def states(changes: Changes) -> dict[int, str]:
    return {version.number: version.state.value for version in changes.versions.store.versions()}


def activated(changes: Changes, text: str) -> None:
    """Activate a version as people do over REST."""
    store = changes.versions.store
    made = store.stage(Source(text), Origin.UPLOAD, KIM, "a port more", NOW)
    number = getattr(made, "number")  # noqa: B009
    store.ask(number, KIM, "it is built", NOW, patient=False)
    store.activate(number, NOW, NoLease())


def test_the_plant_file_is_version_1_and_stays_it(start: Start) -> None:
    for _ in range(2):
        _, changes = start(TEXT)
        assert (changes.number, states(changes)) == (1, {1: "active"})


def test_a_file_that_was_edited_is_a_new_version_and_an_old_one_put_back_is_the_old_version(start: Start) -> None:
    start(TEXT)
    plant, changes = start(WITH_P9)
    assert "P9" in stations(plant)
    assert (changes.number, states(changes)) == (2, {1: "former", 2: "active"})
    plant, changes = start(TEXT)
    assert "P9" not in stations(plant)
    assert (changes.number, states(changes)) == (1, {1: "active", 2: "former"})


def test_a_version_that_was_activated_since_goes_before_a_file_that_was_not_edited(start: Start) -> None:
    _, changes = start(TEXT)
    activated(changes, WITH_P9)
    plant, changes = start(TEXT)
    assert "P9" in stations(plant)
    assert changes.number == 2
    plant, changes = start(WITHOUT_P2)
    assert stations(plant) == stations(start(WITHOUT_P2)[0])
    assert "P2" not in stations(plant)
    assert states(changes) == {1: "former", 2: "former", 3: "active"}


def test_a_dest_that_was_edited_in_the_plant_file_and_does_not_count_is_logged_once(
    start: Start, url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    start(TEXT)
    taught = PulseSet(Pulses(1210), Pulses(-305), Pulses(41020))
    under_way(url, StationDest(StationId("P1"), 2, taught, KIM, "teaching", NOW))
    edited = TEXT.replace("dest: {shft: 1200, rota: -300", "dest: {shft: 1300, rota: -300")
    capsys.readouterr()
    told = []
    for _ in range(2):
        start(edited)
        out, err = capsys.readouterr()
        told += [line for line in (out + err).splitlines() if "pulses of the plant file do not count" in line]
    (line,) = told
    for words in ("station P1", "version 2 of the database holds, by teaching, kim", "PUT /api/v1/stations/P1/dest"):
        assert words in line


def under_way(url: str, *jobs: Job | StationDest) -> None:
    ledger = SqlLedger(url, "small", "a test", lambda: NOW)
    ledger.load()
    ledger.commit(jobs)
    ledger.close()


@pytest.mark.parametrize("edited", [False, True])
def test_what_keeps_an_awaited_version_back_is_logged_once_each(
    start: Start, url: str, capsys: pytest.CaptureFixture[str], *, edited: bool
) -> None:
    plant, changes = start(TEXT)
    first = job(1, source=StationId("P1"), destination=StationId("P2"))
    under_way(url, first)
    store = changes.versions.store
    made = store.stage(Source(WITHOUT_P2), Origin.UPLOAD, KIM, "a port less", NOW)
    assert isinstance(made, PlantVersion)
    store.ask(made.number, KIM, "it goes", NOW, patient=True)
    if edited:
        plant, changes = start(WITHOUT_P2)
        assert "P2" in stations(plant)

    def looked() -> list[str]:
        assert asyncio.run(changes._due(plant, logger(plant=plant.name))) is None
        told = capsys.readouterr()
        return re.findall(r"breaks=.?(job [\w-]+)", told.out + told.err)

    assert looked() == [f"job {first.id}"], "by the start or by the first look"
    assert looked() == []
    second = job(2, source=StationId("P2"), destination=StationId("P1"))
    under_way(url, second)
    assert looked() == [f"job {second.id}"]
    under_way(url, replace(first, state=JobState.CANCELLED))
    assert looked() == []


def test_a_database_that_cannot_be_looked_at_is_logged_once(
    start: Start, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    plant, changes = start(TEXT)
    troubles = ["locked", "locked", "locked", "gone"]

    async def woken() -> None:
        if not troubles:
            raise asyncio.CancelledError

    async def fail(*_: object) -> None:
        raise StoreError(troubles.pop(0))

    monkeypatch.setattr(changes, "_woken", woken)
    monkeypatch.setattr(changes, "_due", fail)
    with pytest.raises(asyncio.CancelledError):
        asyncio.run(changes.next(plant))
    told = capsys.readouterr()
    assert re.findall(r"reason=.?(locked|gone)", told.out + told.err) == ["locked", "gone"]


def test_an_edited_file_that_breaks_something_under_way_stays_staged_until_it_breaks_nothing(
    start: Start, url: str
) -> None:
    start(TEXT)
    under_way(url, job(1, source=StationId("P1"), destination=StationId("P2")))
    plant, changes = start(WITHOUT_P2)
    assert "P2" in stations(plant)
    assert (changes.number, states(changes)) == (1, {1: "active", 2: "staged"})


def test_a_plant_file_with_errors_does_not_keep_down_a_plant_that_ran(
    start: Start, tmp_path: Path, url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    _, before = start(TEXT)
    activated(before, WITH_P9)
    file = tmp_path / "small.yaml"
    file.write_text(TEXT.replace("track:", "trakc:"), encoding="utf-8")
    with pytest.raises(FileInError) as wrong:
        plant_and_text_of(file)
    with Changes(file, url, lambda: NOW) as changes:
        plant = changes.instead(wrong.value)
        assert "P9" in stations(plant)
        assert changes.number == 2
    told = capsys.readouterr()
    assert "the plant file is not taken" in told.out + told.err
    assert f"hoistway layout get 2 -o {file} --force" in told.out + told.err
    plant, changes = start(WITHOUT_P2)  # mended, it counts as edited
    assert "P2" not in stations(plant)
    assert changes.number == 3


def test_a_plant_file_with_errors_is_refused_where_nothing_ran_yet(tmp_path: Path, url: str) -> None:
    file = tmp_path / "small.yaml"
    file.write_text("name: small\n", encoding="utf-8")
    with pytest.raises(FileInError) as wrong:
        plant_and_text_of(file)
    with Changes(file, url, lambda: NOW) as changes, pytest.raises(FileInError, match="has errors"):
        changes.instead(wrong.value)
    assert not (tmp_path / "plant.db").exists()


def test_words_that_change_nothing_make_no_version(start: Start) -> None:
    start(TEXT)
    _, changes = start(TEXT + "# a remark\n")
    assert (changes.number, states(changes)) == (1, {1: "active"})


def test_the_file_of_another_plant_is_refused_and_makes_no_version(start: Start) -> None:
    _, changes = start(TEXT)
    with pytest.raises(StoreError, match="keeps plant small, not other"):
        start(TEXT.replace("name: small", "name: other"))
    assert states(changes) == {1: "active"}


def test_an_active_version_that_nobody_can_read_any_more_gives_way_to_an_edited_file_alone(start: Start) -> None:
    _, changes = start(TEXT)
    activated(changes, OTHERS)
    changes.versions.store.tried(2, None, NOW)
    with pytest.raises(CannotStart, match="version 2 of the plant, the active one, cannot be read"):
        start(TEXT)
    plant, after = start(WITH_P9)
    assert "P9" in stations(plant)
    assert (after.number, states(after)) == (3, {1: "former", 2: "former", 3: "active"})
    assert start(WITH_P9)[1].number == 3


def test_a_version_that_never_ran_and_cannot_be_read_gives_way_to_the_one_before(start: Start) -> None:
    _, changes = start(TEXT)
    activated(changes, OTHERS)
    plant, changes = start(TEXT)
    assert stations(plant) == stations(start(TEXT)[0])
    assert (changes.number, states(changes)) == (1, {1: "active", 2: "rejected"})


def test_a_version_that_cannot_be_read_is_not_waited_for_stop_after_stop(start: Start) -> None:
    plant, changes = start(TEXT)
    store = changes.versions.store
    store.stage(Source(OTHERS), Origin.UPLOAD, KIM, "try", NOW)
    store.ask(2, KIM, "try", NOW, patient=True)
    assert asyncio.run(changes.settle(plant)) == plant
    assert states(changes) == {1: "active", 2: "staged"}


def refused(changes: Changes, plant: Plant, *, listening: bool = False) -> set[str]:
    """Return the stations that are gone on with when the controller cannot start with a plant; none: it is not begun again."""
    before = asyncio.run(changes.fall_back(plant, "it cannot be started", listening=listening))
    return set() if before is None else stations(before)


def test_a_new_version_that_cannot_start_gives_way_to_the_one_before_after_a_crash_too(
    start: Start, killed: Start
) -> None:
    _, changes = start(TEXT)
    activated(changes, WITH_P9)
    plant, changes = killed(TEXT)
    assert "P9" in stations(plant)
    assert refused(changes, plant) == stations(start(TEXT)[0])
    assert states(changes) == {1: "active", 2: "rejected"}
    assert changes.number == 1


def test_a_version_that_has_run_is_not_given_up_for_a_start_that_fails_later(start: Start, killed: Start) -> None:
    start(TEXT)
    start(WITH_P9)
    plant, changes = killed(WITH_P9)
    assert refused(changes, plant) == set()
    assert states(changes) == {1: "former", 2: "active"}


def test_a_new_version_whose_starts_die_before_it_runs_gives_way_after_the_second(start: Start, killed: Start) -> None:
    start(TEXT)
    assert ["P9" in stations(killed(WITH_P9)[0]) for _ in range(3)] == [True, True, False]
    _, changes = start(WITH_P9)
    assert states(changes) == {1: "active", 2: "rejected"}
    assert [one.note for one in changes.versions.store.versions()] == ["2 starts with it ended before it ran", ""]


def test_a_start_that_ends_in_order_does_not_count_against_a_version(
    start: Start, killed: Start, tmp_path: Path, url: str
) -> None:
    start(TEXT)
    killed(WITH_P9)
    for _ in range(3):
        with suppress(StoreError), Changes(tmp_path / "small.yaml", url, lambda: NOW) as changes:
            changes.begin(*plant_and_text_of(tmp_path / "small.yaml"))
            raise StoreError("the certificate cannot be read")
    assert "P9" in stations(killed(WITH_P9)[0])


def test_an_address_that_the_version_before_would_want_too_is_not_the_new_ones_fault(
    start: Start, killed: Start
) -> None:
    start(TEXT)
    plant, changes = killed(WITH_P9)
    assert refused(changes, plant, listening=True) == set()
    coming = replace(plant, listen=("127.0.0.1", 1), vehicles=(replace(plant.vehicles[0], listen=True),))
    assert refused(changes, coming, listening=True) == stations(start(TEXT)[0])


HALL = (PLANTS / "hall.yaml").read_text(encoding="utf-8")
CATALOGUE = (PLANTS.parent / "app" / "catalogues" / "demo.yaml").read_text(encoding="utf-8")
SLOWER = CATALOGUE.replace("default: 500}", "default: 400}").replace("default: 300,", "default: 200,")


def test_a_version_keeps_the_catalogues_that_it_was_made_with(start: Start, tmp_path: Path) -> None:
    plant, changes = start(HALL)
    assert changes.versions.store.source(1) == Source(HALL, {"demo": CATALOGUE})
    (tmp_path / "catalogues").mkdir()
    (tmp_path / "catalogues" / "demo.yaml").write_text(SLOWER, encoding="utf-8")
    slower, changes = start(HALL)
    assert states(changes) == {1: "former", 2: "active"}
    differs = difference(plant, slower).changes
    assert [(one.what, one.how, one.name, one.text) for one in differs] == [
        ("catalogue", "changed", "demo", "describes parameters 04, 06 in another way")
    ]
    store = changes.versions.store
    store.ask(1, KIM, "back", NOW, patient=False)
    assert asyncio.run(changes.settle(slower)) == plant
    asyncio.run(changes.started())
    again, changes = start(HALL)
    assert (again, changes.number) == (plant, 1), "the catalogue beside the plant file was not edited since"


def test_the_same_file_with_another_catalogue_is_another_version(start: Start, tmp_path: Path) -> None:
    _, changes = start(HALL)
    store = changes.versions.store
    assert isinstance(store.stage(Source(HALL, {"demo": CATALOGUE}), Origin.UPLOAD, KIM, "again", NOW), Refusal)
    made = store.stage(Source(HALL, {"demo": SLOWER}), Origin.UPLOAD, KIM, "slower", NOW)
    assert getattr(made, "models") == Source("", {"demo": SLOWER}).models  # noqa: B009
    assert asyncio.run(changes.versions.plant(2)) != asyncio.run(changes.versions.plant(1))


def test_a_version_from_before_goes_on_with_the_catalogues_that_are_found(start: Start, url: str) -> None:
    plant, _ = start(HALL)
    engine = sa.create_engine(url)
    with engine.begin() as connection:
        connection.execute(sa.text("UPDATE plant_versions SET digest = 'old', models = NULL, catalogues = NULL"))
        connection.execute(sa.text("UPDATE plant_file SET digest = 'old'"))
    engine.dispose()
    again, changes = start(HALL)
    assert (again, states(changes)) == (plant, {1: "active"})


def test_what_runs_is_written_over_a_broken_plant_file_without_a_controller(
    start: Start, tmp_path: Path, url: str
) -> None:
    start(HALL)
    file = tmp_path / "back" / "hall.yaml"
    said = CliRunner().invoke(app, ["layout", "get", "--database", url, "-o", str(file), "--catalogues"])
    assert (said.exit_code, file.read_text(encoding="utf-8")) == (0, HALL)
    assert (file.parent / "catalogues" / "demo.yaml").read_text(encoding="utf-8") == CATALOGUE
    again = CliRunner().invoke(app, ["layout", "get", "--database", url, "-o", str(file), "--catalogues"])
    assert again.exit_code == 0, "what says the same loses nothing"
    broken = HALL.replace("name: hall", "nam: hall")
    for there, text in ((file, broken), (file.parent / "catalogues" / "demo.yaml", "model: mine\n")):
        there.write_text(text, encoding="utf-8")
        said = CliRunner().invoke(app, ["layout", "get", "--database", url, "-o", str(file), "--catalogues"])
        assert (said.exit_code, f"{there} is there already" in said.output, "--force" in said.output) == (1, True, True)
        assert there.read_text(encoding="utf-8") == text
        arguments = ["layout", "get", "--database", url, "-o", str(file), "--catalogues", "--force"]
        assert CliRunner().invoke(app, arguments).exit_code == 0
        assert file.read_text(encoding="utf-8") == HALL
    said = CliRunner().invoke(app, ["layout", "get", "7", "--database", url, "-o", str(file)])
    assert (said.exit_code, "does not keep the text of that version" in said.output) == (1, True)
    said = CliRunner().invoke(app, ["layout", "get", "--database", f"sqlite:///{tmp_path}/none.db", "-o", str(file)])
    assert (said.exit_code, "keeps no versions of a plant" in said.output) == (1, True)
    assert not (tmp_path / "none.db").exists()
