"""Routing tables computed beside the loop: by a process that may die, or in slices."""

import os
import signal
import sys
import threading
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from dataclasses import replace
from itertools import chain, pairwise

import numpy as np
import pytest

from app.domain.layout import Edge, Plant, Point
from app.domain.units import Barcode, Millimetres
from app.planning.routing import Router
from app.planning.tables import Tables, Task, compute
from app.planning.track import Track
from app.runtime.planner import SHARED_MEMORY, told
from app.runtime.replanning import COMMAND, Replanner
from tests.runtime.peers import run, until


def wanted() -> Task:
    """Return what a router of a few rings that meet wants after a change."""
    rings = [[f"{ring}{place}" for place in (*range(6), 0)] for ring in "abcd"]
    ways = [*rings, ["a3", "b0"], ["b3", "c0"], ["c3", "d0"], ["d3", "a1"], ["c4", "a4"]]
    points = tuple(Point(Barcode(b), Millimetres(0), Millimetres(0)) for b in dict.fromkeys(chain(*rings)))
    edges = tuple(Edge(Barcode(a), Barcode(b), Millimetres(1000)) for way in ways for a, b in pairwise(way))
    router = Router(Track(Plant("rings", points, edges, (), ())), inline=-1)
    router.close(Barcode("b1"))
    task = router.replan()
    assert task is not None
    return task


def same(found: Tables, task: Task) -> bool:
    expected = compute(task)
    return (
        found.version == expected.version
        and np.array_equal(found.seconds, expected.seconds)
        and np.array_equal(found.hop, expected.hop)
        and np.array_equal(found.parts, expected.parts)
        and np.array_equal(found.at, expected.at)
    )


@asynccontextmanager
async def replanning(found: list[Tables], command: Sequence[str] = COMMAND) -> AsyncIterator[Replanner]:
    replanner = Replanner(found.append, command)
    try:
        yield replanner
    finally:
        await replanner.stop()


def test_a_process_gives_the_very_tables_that_this_one_would_even_after_it_was_killed() -> None:
    async def scenario() -> None:
        task, found = wanted(), list[Tables]()
        async with replanning(found) as replanner:
            replanner.submit(task)
            await until(lambda: len(found) == 1)
            first = replanner.pid
            assert first is not None
            os.kill(first, signal.SIGKILL)
            replanner.submit(task)
            await until(lambda: len(found) == 2)
            assert replanner.pid not in {None, first}
            second = replanner.pid
        assert all(same(tables, task) for tables in found)
        assert second is not None
        assert not list(SHARED_MEMORY.glob(f"hoistway-{second}-*"))
        with pytest.raises(ProcessLookupError):
            os.kill(second, 0)

    run(scenario)


def test_a_process_is_given_a_plan_once_and_another_one_when_the_track_changes() -> None:
    async def scenario() -> None:
        task, found = wanted(), list[Tables]()
        slower = replace(task, version=task.version + 1, seconds=task.seconds * 2, shut=())
        tasks = [task, slower, wanted(), task]
        assert len(told(slower, task)) < len(told(slower, None))
        async with replanning(found) as replanner:
            for one in tasks:
                replanner.submit(one)
            await until(lambda: len(found) == len(tasks))
        assert all(same(tables, one) for tables, one in zip(found, tasks, strict=True))

    run(scenario)


@pytest.mark.parametrize(
    "command", [("/nowhere/python",), (sys.executable, "-c", "print('no planner, but much to say')")]
)
def test_without_a_process_the_tables_are_computed_here_in_slices(
    command: Sequence[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.runtime.replanning.PAUSE", 0.0)

    async def scenario() -> None:
        task, found = wanted(), list[Tables]()
        async with replanning(found, command) as replanner:
            replanner.submit(task)
            await until(lambda: len(found) == 1)
        assert same(found[0], task)

    run(scenario)


def test_stopping_leaves_neither_a_process_nor_files_though_a_task_is_under_way() -> None:
    async def scenario() -> None:
        found = list[Tables]()
        replanner = Replanner(found.append)
        for _ in range(3):
            replanner.submit(wanted())
        await until(lambda: replanner.pid is not None)
        pid = replanner.pid
        await replanner.stop()
        assert not list(SHARED_MEMORY.glob(f"hoistway-{pid}-*"))

    run(scenario)


def test_stopping_leaves_no_thread_either() -> None:
    async def scenario() -> None:
        found = list[Tables]()
        async with replanning(found) as replanner:
            replanner.submit(wanted())
            await until(lambda: len(found) == 1)
            ours = [thread for thread in threading.enumerate() if thread.name.startswith("hoistway-tables")]
        assert ours
        for thread in ours:
            thread.join()

    run(scenario)
