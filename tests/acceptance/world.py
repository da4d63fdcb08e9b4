"""Helpers of the acceptance tests: the small plant in virtual time, what is sent on its lines, and who stands where."""

from collections.abc import Callable
from pathlib import Path

from app.domain.ids import Actor, JobId, StationId, VehicleId
from app.domain.layout import Plant
from app.domain.requests import CreateJob, Reply, Request
from app.plant import read
from app.plant.dialects import dialect_of
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import Code, Enq, Etb, Toward
from app.protocols.itsc.simulator import SimulatedVehicle
from app.sim.world import World

HOST, ANNA = Actor("host"), Actor("anna")
V1, V2 = VehicleId("V001"), VehicleId("V002")
STEP = 0.05


def small_plant() -> Plant:
    """Return ``plants/small.yaml``: V001 at 103, V002 at 116."""
    plant, _ = read((Path(__file__).parents[2] / "plants" / "small.yaml").read_text(), "small.yaml")
    return plant


class Watched(World):
    """A world whose commands are read on the wire. ``told`` are (when, vehicle, code) of every command but STATUS."""

    def __init__(self, plant: Plant | None = None, seed: int = 1) -> None:
        self.told: list[tuple[float, VehicleId, int]] = []
        super().__init__(plant or small_plant(), seed)
        for vehicle in self.floor.devices:
            self._listen(vehicle)

    def _listen(self, vehicle: VehicleId) -> None:
        spec = self.floor.devices[vehicle].spec
        decoder = Decoder(Codec(dialect_of(self.plant, spec.dialect)), Toward.VEHICLE)
        watch = self._watches[vehicle].sent

        def sent(data: bytes, now: float) -> None:
            watch(data, now)
            for frame in decoder.feed(data):
                if isinstance(frame, Enq | Etb) and frame.code != Code.STATUS:
                    self.told.append((now, vehicle, frame.code))

        self._watches[vehicle].sent = sent  # type: ignore[method-assign]

    def commands(self, vehicle: VehicleId, *codes: Code) -> list[float]:
        """Return when these commands were sent to a vehicle."""
        return [when for when, name, code in self.told if name == vehicle and code in codes]

    def reply(self, request: Request) -> Reply:
        """Ask, and wait for the reply."""
        ticket = self.ask(request)
        self.replies.pop(ticket, None)  # of an earlier life
        while ticket not in self.replies:
            self.run(self.now + 0.01)
        return self.replies[ticket]

    def order(self, source: str, destination: str, job: str = "J1") -> None:
        """Order a transfer."""
        self.reply(CreateJob(HOST, JobId(job), source, StationId(destination), None, 50, job))

    def until(self, condition: Callable[[], bool], at_most: float = 120.0) -> None:
        """Let time pass until something is so."""
        end = self.now + at_most
        while not condition():
            assert self.now < end, "it does not happen"
            self.run(self.now + STEP)

    def hand(self, vehicle: VehicleId) -> SimulatedVehicle:
        """Return a vehicle for somebody to lay hands on; what that leads to is noticed right after."""
        self.agenda.after(0.0, self._cables[vehicle].flush_device)
        return self.floor.devices[vehicle]

    def pass_by(self, seconds: float) -> None:
        """Let time pass."""
        self.run(self.now + seconds)
