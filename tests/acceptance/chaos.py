"""A virtual world in which everything goes wrong that a seed draws, and in which people and operators do their part."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from random import Random

from app.domain.commands import Plain
from app.domain.ids import Actor, StationId, VehicleId
from app.domain.job import JobState
from app.domain.layout import Plant
from app.domain.requests import CancelJob, CommandVehicle, HoldVehicle, RecoverAlarm, ReleaseVehicle, Verdict
from app.domain.units import Barcode, Seconds
from app.plant.dialects import dialect_of
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.messages import Mode
from app.protocols.itsc.simulator import RespTiming, SimulatedVehicle
from app.protocols.itsc.simulator.faults import Faulty, foreign_dev_id
from app.sim.cables import Cable
from app.sim.world import Delays, World
from app.wire.faults import Fault, Lane

ANNA, HOST = Actor("anna"), Actor("host")
LOOK_AFTER = 3.0
"""Virtual seconds between two rounds of the person who looks after the vehicles."""
HOST_WAITS = 90.0
"""Virtual seconds after the last fault until the host cancels jobs that cannot begin."""
FAULTS = (
    "kill", "kill", "cut", "cut", "mant", "push", "alarm", "block", "power", "refuse", "hold", "stop", "misread", "stall",
)  # fmt: skip


@dataclass
class Chaos:
    """One run: ``faults`` at random moments until ``calm``, then everybody does what is asked of them until all jobs end.

    ``seen`` counts what happened, so that a campaign can show that it reached what it is for.
    """

    plant: Plant
    seed: int
    calm: float = 120.0
    faults: tuple[str, ...] = FAULTS
    number: int = 8
    keep_open: int = 3
    world: World = field(init=False)
    seen: dict[str, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Build the world, draw what will go wrong, and enter it in the world's agenda."""
        self.dice = Random(f"{self.seed}/chaos")
        self.world = World(self.plant, self.seed)
        self.world.seen = self._seen
        if self.dice.random() < 0.25:
            for device in self.world.floor.devices.values():
                answer_on_acceptance(device)
        if self.dice.random() < 0.3:
            self._spoil_the_lines()
        self.world.work(until=self.calm, keep_open=self.keep_open)
        self.world.agenda.after(LOOK_AFTER, self._look_after)
        for _ in range(self.number):
            self.world.agenda.at(self.dice.uniform(3.0, self.calm), self._fault(self.dice.choice(self.faults)))

    def _spoil_the_lines(self) -> None:
        """Let packets be lost, late, doubled, damaged, cut up and mixed with noise until it is calm."""
        lanes = []
        for name, device in self.world.floor.devices.items():
            codec = Codec(dialect_of(self.plant, device.spec.dialect))
            rates = {fault: self.dice.uniform(0.0, 0.02) for fault in Fault if self.dice.random() < 0.5}
            pair = [Lane(Random(f"{self.seed}/{name}/{way}"), rates) for way in "<>"]
            pair[0]._forge = foreign_dev_id(codec)
            lanes += pair
            cable = self.cable(name)
            cable._device = cable._device_timer._of = Faulty(device, *pair)

        def mended() -> None:
            self.count("mended")
            for lane in lanes:
                lane.rates = {}

        self.world.agenda.at(self.calm, mended)

    def run(self, at_most: float = 900.0) -> "Chaos":
        """Let it all happen."""
        self.world.run(self.calm)
        self.world.finish(at_most)
        return self

    def _seen(self, update: object) -> None:
        value = getattr(update, "value", None)
        name = getattr(value, "event", None)
        if name:
            self.count(name)

    def count(self, what: str) -> None:
        """Count a happening."""
        self.seen[what] = self.seen.get(what, 0) + 1

    # -- what goes wrong ----------------------------------------------------------------------------------------------

    def _fault(self, name: str) -> Callable[[], None]:
        vehicle = self.dice.choice(self.plant.vehicles).id
        act: Callable[[VehicleId], None] = getattr(self, f"_{name}")

        def strike() -> None:
            self.count(name)
            act(vehicle)

        return strike

    def later(self, seconds: float, act: Callable[[], None], vehicle: VehicleId | None = None) -> None:
        """Do something to a vehicle some time later, and let what it says leave."""

        def happen() -> None:
            act()
            if vehicle:
                self._flush(vehicle)

        self.world.agenda.after(seconds, happen)

    def _flush(self, vehicle: VehicleId) -> None:
        self.cable(vehicle).flush_device()

    def cable(self, vehicle: VehicleId) -> Cable:
        """Return a vehicle's cable."""
        return self.world._cables[vehicle]

    def device(self, vehicle: VehicleId) -> SimulatedVehicle:
        """Return a vehicle as it physically is."""
        return self.world.floor.devices[vehicle]

    @property
    def now(self) -> Seconds:
        """Return virtual time."""
        return self.world.now

    def _kill(self, vehicle: VehicleId) -> None:
        self.world.kill()

    def _cut(self, vehicle: VehicleId) -> None:
        self.world.cut(vehicle)

    def _mant(self, vehicle: VehicleId) -> None:
        self.device(vehicle).panel_mode(Mode.MANT, self.now)
        self._flush(vehicle)
        self.later(self.dice.uniform(0.1, 15.0), lambda: self._back_to_auto(vehicle), vehicle)

    def _back_to_auto(self, vehicle: VehicleId) -> None:
        state = self.device(vehicle).state
        if state.servos and state.home_known and state.all_home:
            self.device(vehicle).panel_mode(Mode.AUTO, self.now)

    def _push(self, vehicle: VehicleId) -> None:
        """Turn the key, push it a little way back or on, where nobody is or may come, and turn the key again."""
        self.device(vehicle).panel_mode(Mode.MANT, self.now)
        self._flush(vehicle)
        self.later(self.dice.uniform(4.0, 9.0), lambda: self._shove(vehicle), vehicle)
        self.later(self.dice.uniform(10.0, 20.0), lambda: self._back_to_auto(vehicle), vehicle)

    def _shove(self, vehicle: VehicleId) -> None:
        device = self.device(vehicle)
        if not self.world.alive or device.working or device.state.driving:
            return
        books = self.world.control.fleet.books
        barcode = device.place(self.now)[0]
        near = [b for b in sorted(books.track.reach(barcode, device.spec.reach)) if self._clear(vehicle, b)]
        if near:
            self.count("shoved")
            device.push_to(self.dice.choice(near), self.now)

    def _clear(self, vehicle: VehicleId, barcode: Barcode) -> bool:
        """Whether a vehicle pushed there covers nothing that another one covers or was granted."""
        books = self.world.control.fleet.books
        spec = books.vehicles[vehicle].spec
        covered = {barcode, *books.track.behind(barcode, spec.length)}
        near = covered | {n for b in covered for n in books.track.conflicts(b)}
        return all(books.traffic.holders(b) <= {vehicle} for b in near)

    def _alarm(self, vehicle: VehicleId) -> None:
        self.device(vehicle).raise_alarm(self.dice.choice([11, 101, 300]), self.now)
        self._flush(vehicle)

    def _block(self, vehicle: VehicleId) -> None:
        self.device(vehicle).block_sensor(self.now)
        self._flush(vehicle)
        device = self.device(vehicle)
        self.later(self.dice.uniform(0.5, 60.0), lambda: device.unblock_sensor(self.now), vehicle)

    def _power(self, vehicle: VehicleId) -> None:
        self.device(vehicle).power_cycle(self.now)
        self._flush(vehicle)

    def _refuse(self, vehicle: VehicleId) -> None:
        self.device(vehicle).refuse_next(self.dice.randint(1, 2))

    def _misread(self, vehicle: VehicleId) -> None:
        self.device(vehicle).misread_next(self.dice.choice(self.plant.points).barcode)

    def _hold(self, vehicle: VehicleId) -> None:
        if self.world.alive:
            self.world.ask(HoldVehicle(ANNA, vehicle, "to look at it"))

    def _stop(self, vehicle: VehicleId) -> None:
        if self.world.alive:
            what = self.dice.choice([Plain.STOP, Plain.STOP_BY_HOST])
            self.world.ask(CommandVehicle(ANNA, vehicle, what))

    def _stall(self, vehicle: VehicleId) -> None:
        """The disk is slow for a while."""
        usual = Delays()
        self.world._delays = replace(usual, commit=(1.0, 6.0))

        def mended() -> None:
            self.world._delays = usual

        self.later(self.dice.uniform(3.0, 12.0), mended)

    # -- who looks after it -------------------------------------------------------------------------------------------

    def _look_after(self) -> None:
        self.world.agenda.after(LOOK_AFTER, self._look_after)
        for spec in self.plant.vehicles:
            if self.world.alive:
                self._help(spec.id)
        if self.world.alive and self.now > self.calm + HOST_WAITS:
            self._give_up_orders()

    def _give_up_orders(self) -> None:
        """The host cancels what waits for a carrier that did not come, because the job before it failed."""
        for job in list(self.world.control.fleet.books.jobs.values()):
            at_source = self.world.floor.truth.at.get(StationId(job.source))
            if job.state is JobState.QUEUED and at_source != job.carrier:
                self.count("cancel")
                self.world.ask(CancelJob(HOST, job.id))

    def _help(self, vehicle: VehicleId) -> None:
        """Do what a person with a list of held vehicles does: recover alarms and start-ups, release what may go on."""
        now = self.world.control.fleet.books.vehicles[vehicle]
        state = self.device(vehicle).state
        if not now.linked or now.status is None or now.recovery or self.dice.random() < 0.3:
            return
        if self.device(vehicle).working or state.driving:
            return
        condition = now.status.condition
        if state.oper.name == "ALARM" or not (condition.servos_on and condition.home_known and condition.all_home):
            self.count("recover")
            self.world.ask(RecoverAlarm(ANNA, vehicle, confirmed=True))
        elif self._lost(vehicle):
            self._put_on_a_barcode(vehicle)
        elif state.mode is Mode.MANT and self.now > self.calm:
            self.world.ask(RecoverAlarm(ANNA, vehicle, confirmed=True))
        elif now.record.hold:
            self.count("release")
            self.world.ask(ReleaseVehicle(ANNA, vehicle, Verdict.GO_ON, "looked at it"))

    def _lost(self, vehicle: VehicleId) -> bool:
        """Whether it stands between barcodes, or reports another one than it stands on, and waits for help."""
        device = self.device(vehicle)
        at, _, following = device.place(self.now)
        helpless = device.state.mode is Mode.MANT or bool(self.world.control.fleet.books.vehicles[vehicle].record.hold)
        unread = not device.state.recognised or device.state.barcode != at
        return unread and (helpless or following is not None)

    def _put_on_a_barcode(self, vehicle: VehicleId) -> None:
        """Push it on to the next barcode, or back to the last, whichever is clear."""
        device = self.device(vehicle)
        at, _, following = device.place(self.now)
        for barcode in (following, at):
            if barcode and self._clear(vehicle, barcode):
                self.count("pushed to a barcode")
                device.push_to(barcode, self.now)
                self._flush(vehicle)
                return


def answer_on_acceptance(device: SimulatedVehicle) -> None:
    """Let a vehicle give RESP1 when it accepts a command (PROTOCOLS I19)."""
    onboard = device._onboard
    onboard._options = replace(onboard._options, resp_timing=RespTiming.ACCEPTANCE)
