"""What each blow does to a plant, and what mends it."""

from collections.abc import Callable
from random import Random

from app.domain.commands import Plain
from app.domain.devices import AgvMode, BufferState
from app.domain.drive import Parameter
from app.domain.drive_requests import AskDriveStatus, ReadDrive
from app.domain.ids import Actor, CarrierId, JobId, StationId, VehicleId
from app.domain.job import JobState, Leg
from app.domain.layout import StationKind, Wire
from app.domain.requests import AbortJob, CancelJob, ChangeJob, CommandVehicle, CreateJob, HoldVehicle, WriteStation
from app.domain.units import Barcode
from app.protocols.enig.simulator import SimulatedLink
from app.protocols.itsc.messages import Mode
from app.protocols.itsc.simulator import SimulatedVehicle
from app.sim.fuzz.plan import Blow, Strike
from app.sim.fuzz.scene import Scene

ANNA, HOST = Actor("anna"), Actor("host")
ALARMS = (11, 101, 300)
"""Codes that vehicles report. Our choice: one of each range of PROTOCOLS 1.10."""
Act = Callable[[Scene, Random], None]


def strike(scene: Scene, blow: Strike) -> None:
    """Let a blow fall. What it draws depends on the seed and the blow's own number alone."""
    scene.tell(blow.blow)
    ACTS[blow.blow](scene, Random(f"{scene.plan.seed}/{blow.number}"))


# -- hoists -----------------------------------------------------------------------------------------------------------


def _hoist(scene: Scene, dice: Random) -> tuple[VehicleId, SimulatedVehicle]:
    name = dice.choice(sorted(scene.floor.devices))
    return name, scene.floor.devices[name]


def _after(scene: Scene, vehicle: VehicleId, seconds: float, act: Callable[[], None]) -> None:
    def happen() -> None:
        act()
        scene.flush(vehicle)

    scene.agenda.after(seconds, happen)


def _back_to_auto(scene: Scene, device: SimulatedVehicle) -> None:
    state = device.state
    if state.servos and state.home_known and state.all_home:
        device.panel_mode(Mode.AUTO, scene.now)


def _mant(scene: Scene, dice: Random) -> None:
    vehicle, device = _hoist(scene, dice)
    device.panel_mode(Mode.MANT, scene.now)
    scene.flush(vehicle)
    _after(scene, vehicle, dice.uniform(0.1, 15.0), lambda: _back_to_auto(scene, device))


def _push(scene: Scene, dice: Random) -> None:
    """Turn the key, push it a little way back or on, where nobody is or may come, and turn the key again."""
    vehicle, device = _hoist(scene, dice)
    device.panel_mode(Mode.MANT, scene.now)
    scene.flush(vehicle)
    _after(scene, vehicle, dice.uniform(4.0, 9.0), lambda: _shove(scene, dice, vehicle))
    _after(scene, vehicle, dice.uniform(10.0, 20.0), lambda: _back_to_auto(scene, device))


def _shove(scene: Scene, dice: Random, vehicle: VehicleId) -> None:
    device = scene.floor.devices[vehicle]
    if not scene.alive or device.working or device.state.driving:
        return
    track = scene.control.fleet.books.track
    near = [
        b for b in sorted(track.reach(device.place(scene.now)[0], device.spec.reach)) if nobody_near(scene, vehicle, b)
    ]
    if near and scene.knows_to_be_in(vehicle, Mode.MANT):
        scene.tell("shoved")
        device.push_to(dice.choice(near), scene.now)


def nobody_near(scene: Scene, vehicle: VehicleId, barcode: Barcode) -> bool:
    """Whether a vehicle that people push there comes upon nobody, nor on the way that another is driving: they see that."""
    track = scene.control.fleet.books.track
    covered = {barcode, *track.behind(barcode, scene.floor.devices[vehicle].spec.length)}
    near = covered | {n for b in covered for n in track.conflicts(b)}
    for other, device in scene.floor.devices.items():
        at, _, following = device.place(scene.now)
        there = {at, *track.behind(at, device.spec.length), *device.path, *([following] if following else [])}
        if other != vehicle and near & there:
            return False
    return True


def clear(scene: Scene, vehicle: VehicleId, barcode: Barcode) -> bool:
    """Whether a vehicle that people put there covers nothing that another one covers or was granted: they look first."""
    books = scene.control.fleet.books
    covered = {barcode, *books.track.behind(barcode, books.vehicles[vehicle].spec.length)}
    near = covered | {n for b in covered for n in books.track.conflicts(b)}
    return all(books.traffic.holders(b) <= {vehicle} for b in near)


def _alarm(scene: Scene, dice: Random) -> None:
    vehicle, device = _hoist(scene, dice)
    device.raise_alarm(dice.choice(ALARMS), scene.now)
    scene.flush(vehicle)


def _block(scene: Scene, dice: Random) -> None:
    vehicle, device = _hoist(scene, dice)
    device.block_sensor(scene.now)
    scene.flush(vehicle)
    _after(scene, vehicle, dice.uniform(0.5, 60.0), lambda: device.unblock_sensor(scene.now))


def _power(scene: Scene, dice: Random) -> None:
    vehicle, device = _hoist(scene, dice)
    device.power_cycle(scene.now)
    scene.flush(vehicle)


def _refuse(scene: Scene, dice: Random) -> None:
    _hoist(scene, dice)[1].refuse_next(dice.randint(1, 2))


def _misread(scene: Scene, dice: Random) -> None:
    _hoist(scene, dice)[1].misread_next(dice.choice(scene.plant.points).barcode)


def _hold(scene: Scene, dice: Random) -> None:
    if scene.alive:
        scene.ask(HoldVehicle(ANNA, _hoist(scene, dice)[0], "to look at it"))


def _stop(scene: Scene, dice: Random) -> None:
    if scene.alive:
        what = dice.choice([Plain.STOP, Plain.STOP_BY_HOST])
        scene.ask(CommandVehicle(ANNA, _hoist(scene, dice)[0], what))


def _mute(scene: Scene, dice: Random) -> None:
    """A half-open line: it stays up, and nothing arrives on it."""
    cable = scene.cable(_hoist(scene, dice)[0])
    cable.mute = True

    def heard_again() -> None:
        cable.mute = False

    scene.agenda.after(dice.uniform(0.5, 12.0), heard_again)


def _lose(scene: Scene, dice: Random) -> None:
    """A gripper lets go on the way, and a person sets the carrier aside: it is gone from the plant."""
    vehicle, device = _hoist(scene, dice)
    truth = scene.floor.truth
    known = scene.alive and scene.control.fleet.books.vehicles[vehicle].record.carrier
    if known and vehicle in truth.aboard and device.working is None:
        scene.tell("dropped")
        scene.dropped.add(truth.aboard.pop(vehicle))
        truth.total -= 1
        device.lose_foup(scene.now)
        scene.flush(vehicle)


# -- anywhere ---------------------------------------------------------------------------------------------------------


def _kill(scene: Scene, _dice: Random) -> None:
    scene.kill()


def _cut(scene: Scene, dice: Random) -> None:
    scene.cut(dice.choice(sorted(scene.floor.lines)))


def _stall(scene: Scene, dice: Random) -> None:
    scene.slow_disk(1.0, 6.0, scene.now + dice.uniform(3.0, 12.0))


def _job(scene: Scene, dice: Random) -> JobId | None:
    open_jobs = sorted(scene.books.open)
    return JobId(dice.choice(open_jobs)) if open_jobs and scene.alive else None


def _repeat(scene: Scene, dice: Random) -> None:
    """The host sends an order again that it sent before: the same, or another one under the same name."""
    job = _job(scene, dice)
    if job is None:
        return
    known = scene.control.fleet.books.jobs.get(job)
    if known is None:
        return
    other = dice.random() < 0.5
    words = "another order" if other else known.fingerprint
    scene.tell("other order repeated" if other else "same order repeated")
    scene.ask(CreateJob(HOST, job, known.source, known.destination, known.carrier, known.priority, words))


def _cancel(scene: Scene, dice: Random) -> None:
    job = _job(scene, dice)
    if job is not None:
        aboard = scene.books.jobs[job] in {JobState.TRANSFERRING, JobState.PAUSED}
        scene.ask(AbortJob(HOST, job) if aboard else CancelJob(HOST, job))


def _change(scene: Scene, dice: Random) -> None:
    job = _job(scene, dice)
    if job is None:
        return
    known = scene.control.fleet.books.jobs.get(job)
    kinds = {s.id: s.kind is StationKind.AGV_BUFFER for s in scene.plant.stations}
    engaged = {end for j in scene.control.fleet.books.jobs.values() for end in (j.source, j.destination)}
    like = known is not None and kinds.get(StationId(known.destination))
    free = [s for s, kind in kinds.items() if kind is like and s not in engaged and s not in scene.floor.truth.at]
    scene.ask(ChangeJob(HOST, job, priority=dice.randint(0, 99), destination=dice.choice(free) if free else None))


def _intrude(scene: Scene, _dice: Random) -> None:
    """The host says that equipment fills the place that a carrier is on its way to; some time later it is empty again."""
    if not scene.alive:
        return
    books, at = scene.control.fleet.books, scene.floor.truth.at
    jobs = [
        j for j in books.jobs.values() if j.leg is Leg.TO_DESTINATION and j.vehicle and books.vehicles[j.vehicle].rest
    ]
    target = next((j.destination for j in jobs if j.destination not in at), None)
    if target is None:
        return
    scene.ask(WriteStation(HOST, target, present=True))

    def told() -> bool:
        record = scene.control.fleet.books.stations.get(target) if scene.alive else None
        return (
            record is not None
            and record.present is True
            and not any(
                v.handling and v.handling.station == target for v in scene.control.fleet.books.vehicles.values()
            )
        )

    def fill() -> None:
        if told() and target not in at:
            scene.tell("filled", target)
            scene.floor.truth.install(CarrierId("STRANGER"), target)
            scene.agenda.after(30.0, empty)

    def empty() -> None:
        if not scene.alive:
            scene.agenda.after(5.0, empty)
        elif at.get(target) == "STRANGER":
            scene.floor.truth.remove(target)
            scene.ask(WriteStation(HOST, target, present=False))

    scene.agenda.after(1.0, fill)


# -- the hall ---------------------------------------------------------------------------------------------------------


def _agv_manual(scene: Scene, dice: Random) -> None:
    agv = scene.floor.halls.agvs[dice.choice(sorted(scene.floor.halls.agvs))]
    agv.set_mode(AgvMode.MANUAL, scene.now)
    scene.flush_halls()
    scene.agenda.after(dice.uniform(1.0, 20.0), lambda: scene.handle(lambda: agv.set_mode(AgvMode.AUTO, scene.now)))


def _agv_error(scene: Scene, dice: Random) -> None:
    agv = scene.floor.halls.agvs[dice.choice(sorted(scene.floor.halls.agvs))]
    scene.handle(lambda: agv.raise_error(scene.now))


def _agv_miss(scene: Scene, dice: Random) -> None:
    scene.floor.halls.agvs[dice.choice(sorted(scene.floor.halls.agvs))].miss_next()


def _door(scene: Scene, dice: Random) -> None:
    doors = scene.floor.halls.doors
    if not doors:
        return
    door = doors[dice.choice(sorted(doors))]
    dark = dice.random() < 0.5
    scene.handle(lambda: door.power_off(scene.now) if dark else door.obstruct(scene.now))
    mended = (lambda: door.power_on(scene.now)) if dark else (lambda: door.clear(scene.now))
    scene.agenda.after(dice.uniform(1.0, 40.0), lambda: scene.handle(mended))


def _buffer(scene: Scene, dice: Random) -> None:
    buffers = scene.floor.halls.buffers
    if not buffers:
        return
    buffer = buffers[dice.choice(sorted(buffers))]
    dark = dice.random() < 0.5
    scene.handle(lambda: buffer.power_off(scene.now) if dark else buffer.set_state(BufferState.ERROR, scene.now))

    def mended() -> None:
        if dark:
            buffer.power_on(scene.now)
        buffer.set_state(BufferState.CART if buffer.cart else BufferState.NO_CART, scene.now)

    scene.agenda.after(dice.uniform(1.0, 40.0), lambda: scene.handle(mended))


def _lost_packet(scene: Scene, dice: Random) -> None:
    links = [scene.floor.lines[k.id] for k in scene.plant.links if k.wire is Wire.ENIG]
    for link in links:
        if isinstance(link, SimulatedLink):
            link.lose(dice.choice(["MoveComplete", "TagReceived", "Status"]), dice.randint(1, 3))


def _drive(scene: Scene, dice: Random) -> None:
    if scene.alive:
        drive = dice.choice(scene.plant.drives).id
        some = tuple(Parameter(n) for n in sorted(dice.sample(range(20), 5)))
        scene.ask(AskDriveStatus(ANNA, drive) if dice.random() < 0.3 else ReadDrive(ANNA, drive, some))


ACTS: dict[Blow, Act] = {
    Blow.KILL: _kill,
    Blow.CUT: _cut,
    Blow.MANT: _mant,
    Blow.PUSH: _push,
    Blow.ALARM: _alarm,
    Blow.BLOCK: _block,
    Blow.POWER: _power,
    Blow.REFUSE: _refuse,
    Blow.HOLD: _hold,
    Blow.STOP: _stop,
    Blow.MISREAD: _misread,
    Blow.STALL: _stall,
    Blow.MUTE: _mute,
    Blow.LOSE: _lose,
    Blow.REPEAT: _repeat,
    Blow.CANCEL: _cancel,
    Blow.CHANGE: _change,
    Blow.INTRUDE: _intrude,
    Blow.AGV_MANUAL: _agv_manual,
    Blow.AGV_ERROR: _agv_error,
    Blow.AGV_MISS: _agv_miss,
    Blow.DOOR: _door,
    Blow.BUFFER: _buffer,
    Blow.LOST_PACKET: _lost_packet,
    Blow.DRIVE: _drive,
}
