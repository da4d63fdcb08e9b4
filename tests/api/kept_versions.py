"""Versions of a small plant that are kept for real, for a controller that is played."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from app.cli.running import reader_of
from app.domain.ids import Actor
from app.domain.layout import Plant
from app.domain.versions import Source
from app.runtime.versions import Versions
from app.store.ledger import SqlLedger
from app.store.versions import VersionStore
from tests.api.scripted import NOW

FILE = Path(__file__).parents[2] / "plants" / "small.yaml"
TEXT = FILE.read_text(encoding="utf-8")


@dataclass(frozen=True)
class KeptVersions:
    """The plant of version 1, all versions, and the ledger beside which they are kept."""

    plant: Plant
    versions: Versions
    ledger: SqlLedger


@contextmanager
def kept_versions(directory: Path) -> Iterator[KeptVersions]:
    url = f"sqlite:///{directory}/versions.db"
    ledger = SqlLedger(url, "small", "a test", lambda: NOW)
    ledger.load()
    store = VersionStore(url)
    store.begin(Source(TEXT), Actor("test"), NOW)
    read = reader_of(FILE)
    try:
        yield KeptVersions(read(Source(TEXT)).plant, Versions(store, url, read, lambda: NOW), ledger)
    finally:
        store.close()
        ledger.close()
