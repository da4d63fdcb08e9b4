"""In which order the tests begin, so that no core idles while a test waits, and no long test is begun last."""

from collections.abc import Callable, Hashable, Sequence
from itertools import zip_longest
from typing import TypeVar

from xdist.scheduler import LoadScopeScheduling

T = TypeVar("T")
LONG = {
    "tests/e2e/test_killed_server.py::test_a_server": 50,
    "tests/e2e/test_whole_shift.py": 107,
    "tests/sim/test_whole_plant.py::test_work_under_load": 10,
    "tests/e2e/test_curl_teaching.py": 67,
    "tests/e2e/test_room_scripts.py": 40,
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
    "tests/web/test_access.py": 25,
    "tests/web/test_alarm_room.py": 8,
    "tests/web/test_away.py": 12,
    "tests/web/test_looking_up.py": 8,
    "tests/web/test_narrow.py": 15,
    "tests/web/test_page.py": 20,
    "tests/web/test_panels.py": 12,
    "tests/web/test_playback.py": 10,
    "tests/web/test_walks.py": 6,
    "tests/store/test_roundtrip.py": 15,
    "tests/sim/kinematic/test_fab.py": 8,
    "tests/plant/fab/test_fab.py": 5,
    "tests/e2e/test_device_scripts.py": 15,
    "tests/test_against.py::test_the_orders": 14,
    "tests/runtime/test_serial_hall.py": 20,
    "tests/e2e/test_demo_plant.py": 25,
    "tests/e2e/test_mes.py": 40,
    "tests/e2e/test_sim_follows.py": 20,
    "tests/e2e/test_webhooks.py::test_no_event": 8,
    "tests/e2e/test_command_line.py::test_the_demo": 15,
    "tests/sim/test_whole_plant.py::test_a_controller_killed": 8,
    "tests/sim/test_agreement.py::test_both_plants": 40,  # with all that runs the fast plant
    "tests/sim/kinematic/test_drill.py::test_a_whole_drill": 8,
    "tests/sim/kinematic/test_drill.py::test_a_drill_names": 6,
    "tests/e2e/test_command_line.py::test_a_killed_demo": 5,
    "tests/e2e/test_command_line.py::test_the_workload": 5,
}
"""Seconds that a test of this file, or of this name, takes by itself on an idle machine: those of five or more. Of a file whose
tests stay together: all of them."""


TOGETHER = (
    "tests/e2e/test_device_scripts.py",
    "tests/e2e/test_room_scripts.py",
    "tests/plant/fab/test_fab.py",
    "tests/planning/test_routing_fab.py",
    "tests/store/test_roundtrip.py",
    "tests/test_site.py",
    "tests/web/test_access.py",
    "tests/web/test_alarm_room.py",
    "tests/web/test_away.py",
    "tests/web/test_looking_up.py",
    "tests/web/test_narrow.py",
    "tests/web/test_page.py",
    "tests/web/test_panels.py",
    "tests/web/test_playback.py",
    "tests/web/test_walks.py",
)
"""Files whose tests share what takes a while to make (a plant under way, a browser, a fab): one worker runs all of a file."""
COMPILED = (
    "tests/cli/test_traffic.py",
    "tests/sim/kinematic/test_drill.py",
    "tests/sim/kinematic/test_fab.py",
    "tests/sim/test_agreement.py",
)
"""Files whose tests run the fast plant: one worker runs them all, since each that does has to compile it (some 35 s)."""


def weight(nodeid: str) -> int:
    """Return the seconds that the table gives for a test, or for all of a file that stays together; 0 for a short one."""
    return next((seconds for name, seconds in LONG.items() if nodeid.startswith(name)), 0)


def together(nodeid: str) -> str:
    """Return what a test is part of that one worker runs whole: its file, what is compiled for all of them, or itself."""
    file = nodeid.partition("::")[0]
    if file in COMPILED:
        return "compiled"
    return file if file in TOGETHER else nodeid


class Shared(LoadScopeScheduling):  # type: ignore[misc]
    """Gives each worker one test after the other, and the whole of a file whose tests stay together."""

    def _split_scope(self, nodeid: str) -> str:
        return together(nodeid)


def spread(
    tests: Sequence[T], workers: int, weigh: Callable[[T], int], part_of: Callable[[T], Hashable] = lambda test: test
) -> list[T]:
    """Return the same tests with those that weigh anything first, the heaviest before all.

    A worker is given its next test while it still runs one, and that one waits for the other to end. So each worker begins
    with a long test and has a short one next; from then on long ones and short ones take turns. Short ones keep their order.
    Tests that are ``part_of`` the same count, and stay, as one.
    """
    parts: dict[Hashable, list[T]] = {}
    for test in tests:
        parts.setdefault(part_of(test), []).append(test)
    weights = {part: max(map(weigh, those)) for part, those in parts.items()}
    long = sorted(filter(weights.__getitem__, parts), key=weights.__getitem__, reverse=True)
    short = [part for part in parts if not weights[part]]
    turns = zip_longest(long[workers:], short[workers:])
    rest = (part for turn in turns for part in turn if part is not None)
    return [test for part in (*long[:workers], *short[:workers], *rest) for test in parts[part]]
