"""In which order the tests begin, so that no core idles while a test waits, and no long test is begun last."""

from collections.abc import Callable, Sequence
from itertools import zip_longest
from typing import TypeVar

T = TypeVar("T")
LONG = {
    "tests/e2e/test_killed_server.py::test_a_server": 50,
    "tests/e2e/test_whole_shift.py": 107,
    "tests/sim/test_whole_plant.py::test_work_under_load": 20,
    "tests/e2e/test_curl_teaching.py": 67,
    "tests/e2e/test_room_scripts.py": 30,
    "tests/agv/test_two_way.py::test_no_agvs": 6,
    "tests/sim/test_doors.py::test_jobs_through": 5,
    "tests/sim/test_breakdowns.py": 8,
    "tests/e2e/test_drive_scripts.py::test_a_maintenance_person": 45,
    "tests/e2e/test_tutorial.py::test_every_command": 60,
    "tests/e2e/test_changed_plant.py::test_a_plant": 25,
    "tests/e2e/test_changed_plant.py::test_maintenance": 30,
    "tests/e2e/test_changed_plant.py::test_a_controller_killed": 12,
    "tests/e2e/test_tutorial.py::test_the_korean": 8,
    "tests/web/test_shift.py::test_an_operators_shift": 30,
    "tests/web/test_shift.py::test_every_room": 20,
    "tests/web/test_access.py::test_logging_in": 6,
    "tests/runtime/test_serial_hall.py": 20,
    "tests/e2e/test_demo_plant.py": 25,
    "tests/e2e/test_mes.py": 40,
    "tests/e2e/test_webhooks.py::test_no_event": 8,
    "tests/e2e/test_command_line.py::test_the_demo": 15,
    "tests/sim/test_whole_plant.py::test_a_controller_killed": 8,
    "tests/sim/test_whole_plant.py::test_work_in_the_agv": 8,
    "tests/sim/test_agreement.py::test_both_plants": 15,
    "tests/sim/kinematic/test_drill.py::test_a_whole_drill": 8,
    "tests/sim/kinematic/test_drill.py::test_a_drill_names": 6,
    "tests/e2e/test_command_line.py::test_a_killed_demo": 5,
    "tests/e2e/test_command_line.py::test_the_workload": 5,
}
"""Seconds that a test of this file, or of this name, takes by itself on an idle machine: those of five or more."""


def weight(nodeid: str) -> int:
    """Return the seconds that the table gives for a test; 0 for a short one."""
    return next((seconds for name, seconds in LONG.items() if nodeid.startswith(name)), 0)


def spread(tests: Sequence[T], workers: int, weigh: Callable[[T], int]) -> list[T]:
    """Return the same tests with those that weigh anything first, the heaviest before all.

    A worker is given its next test while it still runs one, and that one waits for the other to end. So each worker begins
    with a long test and has a short one next; from then on long ones and short ones take turns. Short ones keep their order.
    """
    long = sorted(filter(weigh, tests), key=weigh, reverse=True)
    short = [test for test in tests if not weigh(test)]
    turns = zip_longest(long[workers:], short[workers:])
    return [*long[:workers], *short[:workers], *(test for turn in turns for test in turn if test is not None)]
