"""The controller killed at every commit and at every packet of one job: the job ends, with one take and one put."""

from dataclasses import replace
from pathlib import Path

import pytest

from app.domain.ids import Actor, JobId, StationId, VehicleId
from app.domain.job import JobState
from app.domain.layout import Plant
from app.domain.requests import CreateJob
from app.plant import read
from app.sim.world import World
from tests.shares import shared

V1 = VehicleId("V001")
ARRIVED = 0.006
"""Seconds after which a packet has arrived in the virtual world."""


def lone_plant() -> Plant:
    """Return the small plant with one of its vehicles: every packet is the job's."""
    plant, _ = read((Path(__file__).parents[2] / "plants" / "small.yaml").read_text(), "small.yaml")
    return replace(plant, vehicles=plant.vehicles[:1])


class OneJob(World):
    """A world with one job, P1 to P3, and one kill.

    ``at_commit``: when the n-th transaction has been written (``durable``) or was about to be; nothing of it was told.
    ``at_packet``: when the n-th packet has left for the vehicle, and has arrived (``arrived``) or is lost with the line.
    """

    def __init__(
        self, *, at_commit: int = 0, durable: bool = True, at_packet: int = 0, arrived: bool = True, job: bool = True
    ) -> None:
        self.commits = self.packets = 0
        self._at_commit, self._durably, self._at_packet, self._arrives = at_commit, durable, at_packet, arrived
        super().__init__(lone_plant(), 1)
        watch = self._watches[V1].sent

        def sent(data: bytes, now: float) -> None:
            watch(data, now)
            self.packets += 1
            if self.packets == self._at_packet:
                self.agenda.after(ARRIVED if self._arrives else 0.0, self.kill)

        self._watches[V1].sent = sent  # type: ignore[method-assign]
        if job:
            self.agenda.at(4.0, self._order)

    def _order(self) -> None:
        """Order the job, again and again until it was accepted, as a host does."""
        if not self.alive:
            self.agenda.after(1.0, self._order)
            return
        if JobId("J1") not in self.books.jobs:
            self.ask(CreateJob(Actor("host"), JobId("J1"), "P1", StationId("P3"), None, 50, "J1"))
            self.agenda.after(1.0, self._order)

    def _durable(self, life: int) -> None:
        if life == self._life and self.alive:
            self.commits += 1
            if self.commits == self._at_commit:
                if self._durably:
                    self._write()
                self._committing = False
                self.kill()
                return
        super()._durable(life)

    def judged(self) -> "OneJob":
        """Let the job end, and say what must hold of every run."""
        while "J1" not in self.books.jobs:
            self.run(self.now + 1.0)
        assert self.finish(120.0), self.control.fleet.books.jobs
        result = self.result()
        assert result.violations == ()
        assert (result.takes, result.puts) == (1, 1)
        assert self.books.jobs["J1"] is JobState.COMPLETED
        assert dict(self.floor.truth.at)[StationId("P3")] == "FOUP0001"
        return self


def undisturbed() -> OneJob:
    """Return the run without a kill: how many commits and packets there are."""
    world = OneJob().judged()
    assert world.commits >= 10
    assert world.packets > 60
    return world


@pytest.mark.parametrize("durable", [True, False], ids=["just durable", "not yet durable"])
def test_a_kill_at_any_commit_loses_no_job_and_repeats_no_pickup(*, durable: bool) -> None:
    for n in range(1, undisturbed().commits + 1):
        world = OneJob(at_commit=n, durable=durable).judged()
        assert world._life == 1, n


@pytest.mark.parametrize("arrived", shared([False, True], 1), ids=["it is lost", "it has arrived"])
def test_a_kill_at_any_packet_loses_no_job_and_repeats_no_pickup(*, arrived: bool) -> None:
    for n in range(1, undisturbed().packets + 1):
        world = OneJob(at_packet=n, arrived=arrived).judged()
        assert world._life == 1, n
