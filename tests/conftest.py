"""Settings of all tests."""

import gc
import os
import sys
from compileall import compile_dir
from pathlib import Path

import pytest
import structlog
from hypothesis import settings
from xdist.remote import Producer

from tests.ordering import Shared, spread, together, weight

# Compiling takes longer than any test of what is compiled: tests run the same functions as they stand.
os.environ.setdefault("NUMBA_DISABLE_JIT", "1")
# Containers often forbid to keep what was compiled: then each worker and each process of a test would compile the program anew.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False
# A worker holds 5,000 tests that are no garbage: they are looked through seldom, and once collected never again.
gc.set_threshold(50_000, 20, 50)
# A loaded machine makes an example slow, not wrong.
settings.register_profile("hoistway", deadline=None)
settings.load_profile("hoistway")


def pytest_configure(config: pytest.Config) -> None:
    """Compile the program once, before several workers do it at the same time."""
    if not hasattr(config, "workerinput"):
        compile_dir(Path(__file__).parents[1] / "app", quiet=2)


def pytest_xdist_auto_num_workers() -> int | None:
    """Two workers a core and two more for ``-n auto``: the long tests wait for real processes most of their time."""
    if "PYTEST_XDIST_AUTO_NUM_WORKERS" in os.environ:
        return None
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return 2 * (cores or 1) + 2


def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> Shared:
    """Go by the table, not by marks: pytest-xdist 3.8 writes the group of a mark where pytest 9.2 does not read it."""
    config.option.loadscopereorder = False
    return Shared(config, log)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin the long tests first where several workers share the tests."""
    workers = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    if workers > 1:
        items[:] = spread(items, workers, lambda item: weight(item.nodeid), lambda item: together(item.nodeid))


def pytest_collection_finish() -> None:
    """Leave the tests themselves out of every search for garbage."""
    gc.collect()
    gc.freeze()


def pytest_runtest_teardown() -> None:
    """Undo how a command set the logs up: its standard error is closed when its test is over, and the next test logs too."""
    structlog.reset_defaults()
