"""The order in which tests begin."""

from pathlib import Path

from tests.ordering import LONG, spread, weight

ROOT = Path(__file__).parents[1]
SECONDS = {"a": 0, "B": 5, "c": 0, "D": 9, "e": 0, "F": 1, "g": 0}


def test_each_worker_begins_with_a_long_test_and_has_a_short_one_next() -> None:
    assert spread(list(SECONDS), 2, SECONDS.__getitem__) == ["D", "B", "a", "c", "F", "e", "g"]


def test_no_test_is_lost_or_run_twice_however_many_workers_there_are() -> None:
    for workers in range(1, 10):
        assert sorted(spread(list(SECONDS), workers, SECONDS.__getitem__)) == sorted(SECONDS)


def test_every_long_test_of_the_table_is_there() -> None:
    for name in LONG:
        file, _, test = name.partition("::")
        assert f"def {test or 'test_'}" in (ROOT / file).read_text(encoding="utf-8")
        assert weight(name) == LONG[name], "an earlier row hides this one"
