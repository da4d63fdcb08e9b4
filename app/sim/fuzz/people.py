"""Who looks after the plant while things go wrong: a person with a list of held vehicles, and a host that gives orders up."""

from random import Random

from app.domain.ids import StationId, VehicleId
from app.domain.job import JobState
from app.domain.layout import VehicleKind
from app.domain.requests import AbortJob, CancelJob, RecoverAlarm, ReleaseVehicle, Verdict, WriteCarrier
from app.protocols.itsc.messages import Mode
from app.sim.fuzz.blows import ANNA, HOST, clear
from app.sim.fuzz.scene import Scene

LOOK_AFTER = 3.0
"""Virtual seconds between two rounds of the person who looks after the vehicles. Our choice."""
HOST_WAITS = 90.0
"""Virtual seconds after the last fault until the host gives up orders that cannot begin or end. Our choice."""
PASSES_BY = 0.3
"""How often the person walks past a vehicle that needs help. Our choice."""


class People:
    """Looks after every vehicle of a scene, round after round."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._dice = Random(f"{scene.plan.seed}/people")
        scene.agenda.after(LOOK_AFTER, self._round)

    def _round(self) -> None:
        scene = self._scene
        scene.agenda.after(LOOK_AFTER, self._round)
        for spec in scene.plant.vehicles:
            if scene.alive and self._dice.random() >= PASSES_BY:
                if spec.kind is VehicleKind.AGV:
                    self._help_agv(spec.id)
                else:
                    self._help(spec.id)
        if scene.alive and scene.now > scene.plan.calm + HOST_WAITS:
            self._give_up_orders()

    def _help(self, vehicle: VehicleId) -> None:
        """Recover alarms and start-ups, push what stands between barcodes, release what may go on."""
        scene = self._scene
        now, device = scene.control.fleet.books.vehicles[vehicle], scene.floor.devices[vehicle]
        state = device.state
        if not now.linked or now.status is None or now.recovery or device.working or state.driving:
            return
        condition = now.status.condition
        if state.oper.name == "ALARM" or not (condition.servos_on and condition.home_known and condition.all_home):
            scene.tell("recover", vehicle)
            scene.ask(RecoverAlarm(ANNA, vehicle, confirmed=True))
        elif self._lost(vehicle):
            self._put_on_a_barcode(vehicle)
        elif state.mode is Mode.MANT and scene.now > scene.plan.calm:
            scene.ask(RecoverAlarm(ANNA, vehicle, confirmed=True))
        elif now.record.hold:
            self._tell_of_dropped()
            scene.tell("release", vehicle)
            scene.ask(ReleaseVehicle(ANNA, vehicle, Verdict.GO_ON, "looked at it"))

    def _help_agv(self, vehicle: VehicleId) -> None:
        scene = self._scene
        now, agv = scene.control.fleet.books.vehicles[vehicle], scene.floor.halls.agvs[vehicle]
        if not now.linked or now.recovery or agv.report.run == 1:
            return
        if agv.report.run == 2:
            scene.tell("recover", vehicle)
            scene.ask(RecoverAlarm(ANNA, vehicle, confirmed=True))
        elif now.record.hold:
            scene.tell("release", vehicle)
            scene.ask(ReleaseVehicle(ANNA, vehicle, Verdict.GO_ON, "looked at it"))

    def _lost(self, vehicle: VehicleId) -> bool:
        """Whether it stands between barcodes, or reports another one than it stands on, and waits for help."""
        device = self._scene.floor.devices[vehicle]
        at, _, following = device.place(self._scene.now)
        hold = self._scene.control.fleet.books.vehicles[vehicle].record.hold
        helpless = device.state.mode is Mode.MANT or bool(hold)
        unread = not device.state.recognised or device.state.barcode != at
        return unread and (helpless or following is not None)

    def _put_on_a_barcode(self, vehicle: VehicleId) -> None:
        """Push it on to the next barcode, or back to the last, whichever is clear."""
        scene, device = self._scene, self._scene.floor.devices[vehicle]
        at, _, following = device.place(scene.now)
        for barcode in (following, at):
            if barcode and clear(scene, vehicle, barcode):
                scene.tell("pushed to a barcode", vehicle)
                device.push_to(barcode, scene.now)
                scene.flush(vehicle)
                return

    def _tell_of_dropped(self) -> None:
        """Say of carriers that were dropped that they are out of the plant."""
        for carrier in sorted(self._scene.dropped):
            self._scene.ask(WriteCarrier(ANNA, carrier, None, by_person=True))
        self._scene.dropped.clear()

    def _give_up_orders(self) -> None:
        """Cancel what waits for a carrier that did not come, or for a place that stays full; abort what hangs."""
        scene = self._scene
        for job in list(scene.control.fleet.books.jobs.values()):
            at = scene.floor.truth.at
            hopeless = at.get(StationId(job.source)) != job.carrier or job.destination in at
            if job.state is JobState.QUEUED and hopeless:
                scene.tell("cancel", job.id)
                scene.ask(CancelJob(HOST, job.id))
            elif job.state is JobState.PAUSED and scene.now > scene.plan.calm + 3 * HOST_WAITS:
                scene.tell("abort", job.id)
                scene.ask(AbortJob(HOST, job.id))
