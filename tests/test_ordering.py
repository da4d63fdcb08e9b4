"""The order in which tests begin."""

from pathlib import Path
from types import SimpleNamespace

from tests.ordering import COMPILED, LONG, TOGETHER, Shared, spread, weight

ROOT = Path(__file__).parents[1]
SECONDS = {"a": 0, "B": 5, "c": 0, "D": 9, "e": 0, "F": 1, "g": 0}


def test_each_worker_begins_with_a_long_test_and_has_a_short_one_next() -> None:
    assert spread(list(SECONDS), 2, SECONDS.__getitem__) == ["D", "B", "a", "c", "F", "e", "g"]


def test_no_test_is_lost_or_run_twice_however_many_workers_there_are() -> None:
    for workers in range(1, 10):
        assert sorted(spread(list(SECONDS), workers, SECONDS.__getitem__)) == sorted(SECONDS)


def test_what_is_together_begins_as_one_and_stays_so() -> None:
    tests = ["f1", "a", "G1", "f2", "G2", "b"]
    found = spread(tests, 1, lambda test: 3 * test.startswith("G"), lambda test: test[0])
    assert found == ["G1", "G2", "f1", "f2", "a", "b"]


class Worker:
    """As pytest-xdist sees it: it is told which tests to run, by their number."""

    def __init__(self, name: str) -> None:
        self.gateway = SimpleNamespace(id=name)
        self.shutting_down = False
        self.given: list[int] = []

    def send_runtest_some(self, numbers: list[int]) -> None:
        self.given += numbers

    def shutdown(self) -> None:
        self.shutting_down = True


def test_one_worker_is_given_all_of_a_file_that_stays_together() -> None:
    file, other = TOGETHER[0], "tests/test_ordering.py"
    tests = [f"{file}::test_a", f"{other}::test_a", f"{file}::test_b[x::y]", f"{other}::test_b", f"{file}::test_c"]
    option = SimpleNamespace(loadscopereorder=False)
    shared = Shared(SimpleNamespace(getvalue=lambda _: ["2*popen"], option=option, rootpath=ROOT))
    workers = [Worker("one"), Worker("other")]
    for worker in workers:
        shared.add_node(worker)
        shared.add_node_collection(worker, tests)
    shared.schedule()
    assert [worker.given for worker in workers] == [[0, 2, 4], [1, 3]]


def test_every_file_that_stays_together_is_there() -> None:
    assert [file for file in (*TOGETHER, *COMPILED) if not (ROOT / file).is_file()] == []


def test_every_long_test_of_the_table_is_there() -> None:
    for name in LONG:
        file, _, test = name.partition("::")
        assert f"def {test or 'test_'}" in (ROOT / file).read_text(encoding="utf-8")
        assert weight(name) == LONG[name], "an earlier row hides this one"
