"""The controller killed at every commit and every packet of one AGV job: it ends, with one take and one put."""

import pytest

from app.domain.ids import JobId, StationId
from app.domain.job import JobState
from app.domain.requests import CreateJob
from tests.agv.hall import HALL, HOST, HallWorld

ARRIVED = 0.006
"""Seconds after which a packet has arrived in the virtual world."""


class OneAgvJob(HallWorld):
    """A world with one AGV job, B1 to B5, and one kill; see ``OneJob`` of the hoists' kill points."""

    def __init__(self, *, at_commit: int = 0, durable: bool = True, at_packet: int = 0, arrived: bool = True) -> None:
        self.commits = self.packets = 0
        self._at_commit, self._durably, self._at_packet, self._arrives = at_commit, durable, at_packet, arrived
        super().__init__()
        link = self.floor.lines[HALL]
        received = link.received

        def counted(data: bytes, now: float) -> None:
            self.packets += 1
            if self.packets == self._at_packet:
                self.agenda.after(ARRIVED, self.kill) if self._arrives else self.kill()
                if not self._arrives:
                    return
            received(data, now)  # type: ignore[arg-type]

        link.received = counted  # type: ignore[method-assign]
        self.agenda.at(4.0, self._order)

    def _order(self) -> None:
        """Order the job, again and again until it was accepted, as a host does."""
        if self.alive and JobId("J1") not in self.books.jobs:
            self.ask(CreateJob(HOST, JobId("J1"), "B1", StationId("B5"), None, 50, "J1"))
        if JobId("J1") not in self.books.jobs:
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

    def judged(self) -> "OneAgvJob":
        """Let the job end, and say what must hold of every run."""
        while "J1" not in self.books.jobs:
            self.run(self.now + 1.0)
        assert self.finish(300.0), self.said()
        result = self.result()
        assert result.violations == ()
        assert (result.takes, result.puts) == (1, 1)
        assert self.books.jobs["J1"] is JobState.COMPLETED
        assert dict(self.floor.truth.at)[StationId("B5")] == "CART1"
        return self


@pytest.mark.parametrize("durable", [True, False], ids=["just durable", "not yet durable"])
def test_a_kill_at_any_commit_of_an_agv_job_repeats_no_lift(*, durable: bool) -> None:
    commits = OneAgvJob().judged().commits
    assert commits >= 8
    for n in range(1, commits + 1):
        assert OneAgvJob(at_commit=n, durable=durable).judged()._life == 1, n


@pytest.mark.parametrize("arrived", [True, False], ids=["it has arrived", "it is lost"])
def test_a_kill_at_any_packet_of_an_agv_job_repeats_no_lift(*, arrived: bool) -> None:
    packets = OneAgvJob().judged().packets
    assert packets >= 4
    for n in range(1, packets + 1):
        assert OneAgvJob(at_packet=n, arrived=arrived).judged()._life == 1, n
