"""A fleet without sessions: tests play what sessions tell, or let toy vehicles obey. Every effect is judged as it comes."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

from app.domain.commands import Command, Send
from app.domain.devices import DeviceEvent, DeviceId
from app.domain.drive import DriveEvent
from app.domain.errors import Refusal
from app.domain.events import Acknowledged, Answered, Event, LinkDown, LinkUp, NotSent, Reported, Unanswered, Unknown
from app.domain.ids import Actor, CarrierId, CmdIds, JobId, StationId, VehicleId
from app.domain.job import Job
from app.domain.layout import Plant, StopAction
from app.domain.records import HistoryEvent, Intent, Kept, Record, StationRecord
from app.domain.requests import Accepted, CreateJob, Reply, Request
from app.domain.units import Barcode, Seconds, Timestamp
from app.domain.vehicle import Condition, VehicleStatus
from app.domain.view import DeviceView, LinkView, Topic, Update, View
from app.fleet import Effects, Fleet
from app.fleet.vehicle import VehicleNow
from app.plant import read
from app.protocols.itsc.condition import condition
from app.sim.memory import MemoryLedger
from tests.fleet.hall import ToyHall
from tests.fleet.judge import Judge
from tests.fleet.toy import TAGS, Toy

HOST = Actor("host")
V1, V2 = VehicleId("V001"), VehicleId("V002")
P1, P2, P3, B1, B2 = (StationId(name) for name in ("P1", "P2", "P3", "B1", "B2"))
FOUP1, FOUP2 = CarrierId("FOUP0001"), CarrierId("FOUP0002")
UTC = 1_000_000_000.0
R = TypeVar("R")


def small() -> Plant:
    """Return the oval of ``plants/small.yaml``: V001 at 103, V002 at 116, FOUP0001 at P1 (104), FOUP0002 at B1 (113)."""
    plant, _ = read((Path(__file__).parents[2] / "plants" / "small.yaml").read_text(), "small.yaml")
    return plant


def words(
    *,
    loaded: bool = False,
    trav: int = 0,
    mode: int = 3,
    oper: int = 0,
    code: int = 0,
    flags: int = 0xF,
    axes: int = 0x111134,
) -> Condition:
    """Return a condition; by default: AUTO, idle, empty, standing without a stop tag, all axes at home."""
    return condition(loaded << 31 | trav << 24 | axes, mode << 30 | oper << 28 | flags << 24 | code)


class Script:
    """A Fleet on a clock of its own. After each input its effects are judged, kept in a ledger and collected here.

    ``sends``, ``records``, ``updates``, ``polls`` collect everything since ``forget``; ``model`` is the read model;
    ``toys`` are the obedient vehicles that ``obey`` and ``run`` use.
    """

    def __init__(self, plant: Plant | None = None, ledger: MemoryLedger | None = None, now: float = 0.0) -> None:
        self.plant = plant or small()
        self.ledger = ledger or MemoryLedger()
        self.now = Seconds(now)
        self.judge = Judge()
        self.toys = {
            spec.id: Toy(self, spec, spec.start or self.plant.points[0].barcode) for spec in self.plant.vehicles
        }
        self.hall = ToyHall(self) if self.plant.links else None
        self.sends: list[Send] = []
        self.records: list[Record] = []
        self.updates: list[Update] = []
        self.polls: list[VehicleId] = []
        self.stored: list[tuple[VehicleId, int]] = []
        self.replies: dict[int, Reply] = {}
        self.model: dict[Topic, dict[str, View]] = {topic: {} for topic in Topic}
        self._tickets = 0
        self.fleet = self._start()

    # -- the controller -----------------------------------------------------------------------------------------------

    def _start(self, *, restored: bool = False) -> Fleet:
        kept: Kept = replace(self.ledger.load(), restored=restored)
        self.judge.restarted(kept, [station.id for station in self.plant.stations])
        self.model = {topic: {} for topic in Topic}
        self.fleet = Fleet(self.plant, kept, CmdIds(kept.epoch), self.now, Timestamp(UTC + self.now), self._link)
        self._collect()
        return self.fleet

    def _link(self, vehicle: VehicleId) -> LinkView:
        now = self.fleet.books.vehicles[vehicle]
        return LinkView(now.linked, 0.0, now.link_reason)

    def restart(self, after: float = 1.0, plant: Plant | None = None, *, restored: bool = False) -> None:
        """Kill the controller after its last commit, and start it again; vehicles go on with what they were told.

        ``restored``: on a backup, as its person says.
        """
        self.plant = plant or self.plant
        self.now = Seconds(self.now + after)
        self.sends.clear()
        for toy in self.toys.values():
            toy.linked = False
        if self.hall:
            self.hall.restart()
        self._start(restored=restored)

    def _collect(self) -> None:
        effects: Effects = self.fleet.take()
        if effects.empty:
            return
        self.judge.effects(effects, self.now)
        self.ledger.commit(effects.records)
        self.records += effects.records
        self.sends += effects.sends
        self.polls += effects.polls
        self.stored += effects.stored
        self.updates += effects.updates
        self.replies.update(effects.replies)
        for update in effects.updates:
            if update.value is None:
                self.model[update.topic].pop(update.key, None)
            else:
                self.model[update.topic][update.key] = update.value
        for send in effects.sends:
            self.toys[send.vehicle].take(send)
        for link_send in effects.link_sends:
            if self.hall:
                self.hall.take(link_send)

    # -- inputs -------------------------------------------------------------------------------------------------------

    def ask(self, request: Request) -> Reply:
        """Ask for something and return the reply."""
        self._tickets += 1
        self.fleet.ask(request, self._tickets, self.now)
        self._collect()
        return self.replies[self._tickets]

    def accept(self, request: Request) -> Accepted:
        """Ask for something that must be accepted."""
        reply = self.ask(request)
        assert isinstance(reply, Accepted), reply
        return reply

    def refuse(self, request: Request) -> Refusal:
        """Ask for something that must be refused."""
        reply = self.ask(request)
        assert isinstance(reply, Refusal), reply
        assert reply.reason
        return reply

    def order(self, source: str = "P1", destination: str = "P3", job: str | None = "J1", **more: object) -> Job:
        """Order a transfer that must be accepted and return it as it is now."""
        return self.job(self.accept(transfer(source, destination, job, **more)).key)

    def hear(self, event: Event) -> None:
        """Let the fleet hear an event of a session."""
        self.fleet.handle(event, self.now)
        self._collect()

    def hear_device(self, event: DeviceEvent) -> None:
        """Let the fleet hear an event of a link."""
        self.fleet.handle_device(event, self.now)
        self._collect()

    def hear_drive(self, event: DriveEvent) -> None:
        """Let the fleet hear an event of a drive line."""
        self.fleet.handle_drive(event, self.now)
        self._collect()

    def tick(self) -> None:
        """Call the fleet's timer, if it is due."""
        if self.fleet.deadline <= self.now:
            self.fleet.tick(self.now)
            self._collect()

    def wait(self, seconds: float, step: float = 0.5) -> None:
        """Let time pass without a word from any vehicle."""
        end = self.now + seconds
        while self.now < end:
            self.now = Seconds(min(self.now + step, end))
            self.tick()

    # -- one vehicle, by hand -----------------------------------------------------------------------------------------

    def link_up(self, vehicle: VehicleId) -> None:
        """The line is there."""
        self.hear(LinkUp(vehicle))

    def link_down(self, vehicle: VehicleId, reason: str = "line cut") -> None:
        """The line is gone. Commands under way are told unknown first, as the session does."""
        for intent in self.fleet.open_intents(vehicle):
            for send in self.sends:
                if send.cmd_id == intent.cmd_id:
                    self.hear(Unanswered(vehicle, send.cmd_id, send.command, Unknown.LINK_LOST))
        self.hear(LinkDown(vehicle, reason))

    def report(
        self, vehicle: VehicleId, barcode: str, state: Condition | None = None, *, seq: int = 0, polled: bool = True
    ) -> None:
        """The vehicle says where it is and how; by default it stands idle in AUTO, empty. A polled one was asked just now."""
        status = VehicleStatus(state or words(), Barcode(barcode), seq)
        self.hear(Reported(vehicle, status, polled, self.now))

    def stand(self, vehicle: VehicleId, barcode: str, state: Condition | None = None, *, link: bool = True) -> None:
        """Bring a vehicle to READY: linked, quiet, two STATUS that agree."""
        if link:
            self.link_up(vehicle)
        self.wait(1.5)
        self.report(vehicle, barcode, state)
        self.wait(0.5)
        self.report(vehicle, barcode, state)

    def acknowledge(self, send: Send) -> None:
        """The vehicle has the command."""
        self.hear(Acknowledged(send.vehicle, send.cmd_id))

    def answer(
        self,
        send: Send,
        barcode: str,
        state: Condition | None = None,
        *,
        ok: bool = True,
        reason: str = "",
        seq: int = 0,
    ) -> None:
        """RESP1 for a command."""
        self.hear(
            Answered(send.vehicle, send.cmd_id, send.command, ok, reason, state or words(), Barcode(barcode), seq)
        )

    def unanswered(self, send: Send, why: Unknown = Unknown.NO_ANSWER) -> None:
        """Nothing is known of the command."""
        self.hear(Unanswered(send.vehicle, send.cmd_id, send.command, why))

    def not_sent(self, send: Send, reason: str = "the session refused it") -> None:
        """The session refused it before the first byte."""
        self.hear(NotSent(send.vehicle, send.cmd_id, send.command, reason))

    def last(self, kind: type[Command], vehicle: VehicleId | None = None) -> Send:
        """Return the newest command of a kind."""
        return next(s for s in reversed(self.sends) if isinstance(s.command, kind) and vehicle in {None, s.vehicle})

    # -- obedient vehicles --------------------------------------------------------------------------------------------

    def obey(self, *vehicles: VehicleId) -> "Script":
        """Connect toy vehicles (all, if none is named); with ``run`` they do what they are told."""
        for name in vehicles or tuple(self.toys):
            self.toys[name].connect()
        if self.hall:
            self.hall.connect()
        self.run(4)
        return self

    def run(self, seconds: float, step: float = 0.25) -> None:
        """Let time pass; toy vehicles that are connected act, and answer polls."""
        end = self.now + seconds
        while self.now < end - 1e-9:
            self.now = Seconds(self.now + step)
            self.tick()
            if self.hall:
                self.hall.step()
            polls, self.polls = self.polls, []
            for toy in self.toys.values():
                toy.step(polled=toy.spec.id in polls)

    def run_until(self, *jobs: str, at_most: float = 300.0) -> None:
        """Let time pass until these jobs (J1 if none is named) have ended."""
        end = self.now + at_most
        while any(name in self.fleet.books.jobs for name in jobs or ("J1",)):
            assert self.now < end, list(self.fleet.books.jobs.values())
            self.run(1)

    def run_to(self, leg: str, job: str = "J1", at_most: float = 300.0) -> Job:
        """Let time pass until a job is on this leg."""
        end = self.now + at_most
        while self.job(job).leg.value != leg:
            assert self.now < end, self.job(job)
            self.run(0.25)
        return self.job(job)

    # -- what is there ------------------------------------------------------------------------------------------------

    def job(self, name: str) -> Job:
        """Return a job as last saved, ended or not."""
        found = self.ledger.job(JobId(name))
        assert found is not None, f"no job {name}"
        return found

    def vehicle(self, name: VehicleId) -> VehicleNow:
        """Return what the fleet knows of a vehicle."""
        return self.fleet.books.vehicles[name]

    def station(self, name: StationId) -> StationRecord:
        """Return what is believed of a station."""
        return self.fleet.books.stations[name]

    def device(self, name: str) -> DeviceView:
        """Return a device as people see it."""
        view = self.model[Topic.DEVICES][DeviceId(name)]
        assert isinstance(view, DeviceView)
        return view

    def events(self, job: str | None = None) -> list[str]:
        """Return the names of the durable events since ``forget``, of one job or of all."""
        return [e.event for e in self.history(job)]

    def history(self, job: str | None = None) -> list[HistoryEvent]:
        """Return the durable events since ``forget``, of one job or of all."""
        return [r for r in self.records if isinstance(r, HistoryEvent) and job in {None, r.job}]

    def kept(self, kind: type[R]) -> list[R]:
        """Return the records of a kind since ``forget``."""
        return [r for r in self.records if isinstance(r, kind)]

    def kept_intents(self) -> list[Intent]:
        """Return the intents saved since ``forget``, every state of each."""
        return self.kept(Intent)

    def intents(self, vehicle: VehicleId) -> Sequence[Intent]:
        """Return the open intents of a vehicle."""
        return self.fleet.open_intents(vehicle)

    def forget(self) -> None:
        """Forget what was collected."""
        for collected in (self.sends, self.records, self.updates, self.polls, self.stored):
            collected.clear()

    def fill(self, station: StationId, carrier: CarrierId) -> None:
        """Have a carrier stand at a station, in the toys' world only."""
        self.world[station] = carrier

    @property
    def world(self) -> "dict[StationId, CarrierId]":
        """Return the carriers at stations in the toys' world."""
        return self.judge.world


def transfer(source: str = "P1", destination: str = "P3", job: str | None = "J1", **more: object) -> CreateJob:
    """Return an order; ``more`` are fields of CreateJob."""
    request = CreateJob(
        actor=HOST,
        job=JobId(job) if job else None,
        source=source,
        destination=StationId(destination),
        carrier=None,
        priority=50,
        fingerprint=f"{source}>{destination}",
    )
    return replace(request, **more)  # type: ignore[arg-type]


def stopped_at(action: StopAction, *, loaded: bool = False) -> Condition:
    """Return the condition of a vehicle that stands idle at a stop of this kind."""
    return words(loaded=loaded, trav=TAGS[action])
