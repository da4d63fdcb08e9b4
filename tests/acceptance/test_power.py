"""Power cuts lose nothing that was acknowledged; ``make campaign`` makes a thousand (tests/acceptance/power.py)."""

import random
from pathlib import Path

import pytest

from tests.acceptance.power import BATCHES, Delete, Flush, Recording, Write, cut, cuts, reopened, written


class Fixed(random.Random):
    """Draws the same each time."""

    fate = 0.0

    def random(self) -> float:
        return self.fate

    def randrange(self, start: int, *_: object) -> int:
        return start


class Nothing(Fixed):
    """Nothing that was not flushed is left."""


class Everything(Fixed):
    fate = 0.5


class Torn(Fixed):
    fate = 0.9


def test_no_acknowledged_batch_is_lost_and_none_is_there_in_part(tmp_path: Path) -> None:
    wrong: list[str] = []
    assert cuts(written(tmp_path), 60, 1, lambda one, why: wrong.append(f"{one}: {why}")) == 0, wrong


@pytest.mark.parametrize("mistake", ["PRAGMA synchronous = NORMAL", "PRAGMA synchronous = OFF"])
def test_a_ledger_that_does_not_flush_each_commit_is_found_out(mistake: str, tmp_path: Path) -> None:
    assert cuts(written(tmp_path, mistake), 20, 1, lambda one, why: None) > 0


def test_the_next_controller_goes_on_with_what_a_cut_has_left(tmp_path: Path) -> None:
    (tmp_path / "first").mkdir()
    (tmp_path / "next").mkdir()
    recording = written(tmp_path / "first")
    middle = recording.acknowledged[BATCHES // 2]
    assert reopened(cut(recording, middle, Nothing()), tmp_path / "next") == BATCHES // 2 + 1


def test_a_disk_keeps_what_was_flushed_and_of_the_rest_what_is_drawn() -> None:
    steps: list[Write | Flush | Delete] = [
        Write("a", 0, b"x" * 2048),
        Flush("a"),
        Write("a", 512, b"y" * 1024),
        Delete("b"),
        Write("a", 4, None),
    ]
    recording = Recording(steps)
    assert cut(recording, 2, Nothing()) == {"a": b"x" * 2048}
    assert cut(recording, 4, Nothing()) == {"a": b"x" * 2048}
    assert cut(recording, 4, Everything()) == {"a": b"x" * 512 + b"y" * 1024 + b"x" * 512}
    assert cut(recording, 5, Everything()) == {"a": b"xxxx"}
    assert cut(recording, 3, Torn()) == {"a": b"x" * 512 + b"y" * 512 + b"x" * 1024}
