"""The fleet: takes what sessions tell and people ask, in order, and gives effects (ARCHITECTURE section 1)."""

from collections.abc import Callable, Iterable
from itertools import takewhile
from math import inf

from app.domain.commands import Send
from app.domain.devices import DeviceAct, DeviceEvent, DeviceKind, DeviceRequest
from app.domain.drive import DriveEvent
from app.domain.drive_requests import Word
from app.domain.events import (
    Event,
)
from app.domain.ids import CmdIds, VehicleId
from app.domain.layout import Plant
from app.domain.links import LinkSend
from app.domain.records import Intent, Kept
from app.domain.requests import Reply, Request
from app.domain.units import Seconds, Timestamp
from app.domain.view import LinkView, Topic, Update, VehicleView
from app.fleet.agv_orders import AgvOrders
from app.fleet.alarm_watch import AlarmWatch
from app.fleet.alarms import Alarms
from app.fleet.books import Books
from app.fleet.buffers import Buffers
from app.fleet.charging import Charging
from app.fleet.closures import Closures
from app.fleet.courtesy import Courtesy
from app.fleet.desk import Desk
from app.fleet.device_orders import DeviceOrders
from app.fleet.devices import Devices
from app.fleet.dispatch import Dispatch
from app.fleet.doors import Doors
from app.fleet.drives import Drives
from app.fleet.effects import Effects
from app.fleet.emergency import EmergencyDesk
from app.fleet.flow import Flow
from app.fleet.hearing import Hearing
from app.fleet.jobs import Jobs
from app.fleet.looks import LOOKS_AT_ONCE, Looks
from app.fleet.missions import Missions
from app.fleet.motion import Motion
from app.fleet.objections import objection
from app.fleet.orders import VehicleOrders
from app.fleet.parking import Parking
from app.fleet.passages import Passages
from app.fleet.plant_orders import PlantOrders
from app.fleet.recovery import Recovery
from app.fleet.staging import Staging
from app.fleet.standstill import Standstills
from app.fleet.teaching import Teaching
from app.fleet.teaching_desk import TeachingDesk
from app.fleet.teaching_sessions import TeachingSessions
from app.fleet.teaching_views import view_of_proposal, view_of_session
from app.fleet.vehicle import VehicleNow
from app.fleet.views import view_of_alarm, view_of_job, view_of_vehicle
from app.fleet.walks import Walks
from app.fleet.webhooks import Webhooks
from app.planning.tables import Tables

SHOW_EVERY = Seconds(0.1)
"""A vehicle that looks different is shown so long after it first did, at once if anything is decided of it (QUALITY 1)."""
SHOW_TOGETHER = Seconds(0.02)
"""Those that are due so soon are shown together: fewer, and none of them long, as each is due at its own time (our choice)."""
THINK_EVERY = Seconds(1.0)
"""Dispatch, and a look at everything that waits, at least so often; sooner when something changed (our choice)."""
THINK_AT_MOST_EVERY = Seconds(0.1)
"""Dispatch runs at most so often: a burst of orders costs one assignment (our choice)."""
THINK_SECONDS_PER_JOB = Seconds(50e-6)
"""With thousands of jobs, dispatch runs so much more seldom for each, so that it never takes the whole time (our choice)."""
GIVE_BACK_AFTER = Seconds(10.0)
"""A vehicle that cannot go on for so long loses its job to another, or its job is paused if picked up (our choice)."""


class Fleet:
    """Decides for one plant. Inputs in order; ``take`` gives what was decided since the last call.

    ``link`` tells the quality of a vehicle's line, for people only.
    """

    def __init__(
        self,
        plant: Plant,
        kept: Kept,
        cmd_ids: CmdIds,
        now: Seconds,
        utc: Timestamp,
        link: Callable[[VehicleId], LinkView],
    ) -> None:
        self.books = Books(plant, kept, cmd_ids, now, utc)
        self.devices = Devices(self.books, kept)
        passages = Passages(self.books, self.devices)
        self.motion = Motion(self.books, passages)
        self.doors = Doors(self.books, self.devices, passages, self.motion)
        self.buffers = Buffers(self.books, self.devices)
        self.recovery = Recovery(self.books, self.motion)
        self.alarms = Alarms(self.books, self.recovery)
        self.missions = Missions(self.books, self.motion, self.recovery, self.buffers)
        self.drives = Drives(self.books, kept)
        self._dispatch = Dispatch(self.books, self.missions)
        self._courtesy = Courtesy(self.books, self.motion)
        self._closures = Closures(self.books, self.motion, self._courtesy)
        self._flow = Flow(self.books, self.motion)
        self._charging = Charging(self.books, self.motion, self.devices)
        self._parking = Parking(self.books, self.motion)
        self._jobs = Jobs(self.books, self.missions)
        self._plant_orders = PlantOrders(self.books)
        orders = VehicleOrders(self.books, self.motion, self.missions, self.recovery, self.alarms)
        self._agv_orders = AgvOrders(self.books, self.motion, self.recovery, orders, self.devices)
        self.teaching = Teaching(self.books)
        self._hearing = Hearing(
            self.books, self.motion, self.missions, self.recovery, self.alarms, self._agv_orders, self.teaching
        )
        sessions = TeachingSessions(self.books, self.missions, orders, self.teaching)
        teaching = TeachingDesk(self.books, self.teaching, sessions)
        device_orders = DeviceOrders(self.books, self.devices, passages, self.doors, self.buffers)
        emergency = EmergencyDesk(self.books, self._plant_orders, self.alarms, self.drives)
        self.webhooks = Webhooks(self.books, kept.webhooks, kept.webhook_progress, kept.next_webhook)
        self._desk = Desk(
            self.books,
            self._jobs,
            orders,
            self._agv_orders,
            self._plant_orders,
            self.drives,
            teaching,
            device_orders,
            emergency,
            self._closures,
            Standstills(self.books, self._plant_orders, self.alarms),
            self.webhooks,
            Walks(self.books, self._plant_orders),
            Staging(self.books, self.motion, orders),
        )
        self._link = link
        self._looks = Looks()
        self._free: set[VehicleId] = set()
        """Vehicles that a job could be given to when they were last looked at."""
        self._shown: dict[VehicleId, VehicleView] = {}
        self._next_thought = self._last_thought = now
        self.watch = AlarmWatch(self.books)
        self._start(restored=kept.restored)

    # -- start --------------------------------------------------------------------------------------------------------

    def _start(self, *, restored: bool) -> None:
        """Claim what every vehicle may be on, call the roll, and show all there is (COMMANDS sections 3.1, 3.6, 3.8)."""
        books = self.books
        for vehicle in books.vehicles.values():
            if vehicle.record.off_rail or (not vehicle.spec.in_service and vehicle.record.out_of_service):
                continue
            claim = [*vehicle.record.held, *(b for i in vehicle.opened.values() for b in i.path)]
            books.traffic.hold(vehicle.id, [b for b in dict.fromkeys(claim) if b in books.track])
            books.roll_call.miss(vehicle)
            if restored:
                self.recovery.doubt_backup(vehicle)
        self._jobs.end_impossible()
        self.watch.start()
        self._show_all()

    def _show_all(self) -> None:
        """Show all there is."""
        books = self.books
        for job in books.jobs.values():
            books.show(Topic.JOBS, job.id, view_of_job(job))
        for station in books.specs:
            books.show_station(station)
        for carrier in books.carriers:
            books.show_carrier(carrier)
        for session in books.teaching.sessions.values():
            books.show(Topic.TEACHING, f"session-{session.number}", view_of_session(session))
        for proposal in books.teaching.proposals.values():
            books.show(Topic.TEACHING, f"proposal-{proposal.number}", view_of_proposal(proposal))
        for closure in books.closures.live.values():
            books.show_closure(closure)
        for walk in books.walks.values():
            books.show_walk(walk)
        for alarm in books.alarms.live.values():
            books.show(Topic.ALARMS, str(alarm.number), view_of_alarm(alarm))
        books.show_controller()
        for vehicle in books.vehicles.values():
            books.touch(vehicle)
        self.devices.show()

    # -- inputs -------------------------------------------------------------------------------------------------------

    @property
    def deadline(self) -> Seconds:
        """When ``tick`` wants to be called next."""
        at_once = self.books.now if self._dispatch.pending or self._flow.pending else Seconds(inf)
        return min(self._next_thought, self._looks.deadline, self.drives.deadline, self._show_at, at_once)

    def tick(self, now: Seconds) -> None:
        """Time has passed."""
        self.books.now = now
        self.drives.tick()
        all_seen = self._look()
        if all_seen and self._dispatch.pending:
            self._dispatch.go_on()  # to the end: a new thought before would begin anew for ever under load
        elif self._flow.pending:
            self._flow.go_on()
        elif all_seen and now >= self._next_thought:
            self._think()
            return
        if self.books.woken:
            self._go_on()

    def _think(self) -> None:
        """See to all that waits."""
        now = self.books.now
        self._next_thought, self._last_thought = Seconds(now + THINK_EVERY), now
        self.teaching.tick()
        self.devices.tick()
        self._charging.run()
        self._parking.run(self._free)
        self._flow.before_dispatch()
        self._closures.tick()
        self.watch.tick()
        self._dispatch.overdue.tick()
        self._dispatch.run()
        self._flow.after_dispatch()
        self._go_on(all_devices=True)

    def _look(self) -> bool:
        """Look at the vehicles whose time has come, though nothing was heard of them; return whether that was all of them."""
        due = self._looks.due(self.books.now)
        for name in due:
            vehicle = self.books.vehicles[name]
            self.alarms.tick(vehicle)
            self._mind_job(vehicle)
            self.books.wake(name)
        return len(due) < LOOKS_AT_ONCE

    def _mind_job(self, vehicle: VehicleNow) -> None:
        """A job does not wait for a vehicle that cannot go on without saying so."""
        self._note_fitness(vehicle)
        if vehicle.unfit_since is not None and self.books.now - vehicle.unfit_since >= GIVE_BACK_AFTER:
            cut = "" if vehicle.linked else f"it is not connected: {vehicle.link_reason}"
            why = vehicle.barred or vehicle.waiting or cut or "it is not ready"
            self.missions.interrupt(vehicle, why)

    def _note_fitness(self, vehicle: VehicleNow) -> None:
        if vehicle.job is None or vehicle.fit:
            vehicle.unfit_since = None
        elif vehicle.unfit_since is None:
            vehicle.unfit_since = self.books.now

    def handle(self, event: Event, now: Seconds) -> None:
        """Take one event of a session."""
        self.books.now = now
        vehicle = self.books.vehicles[event.vehicle]
        self._hearing.take(vehicle, event)
        self._go_on()

    def handle_device(self, event: DeviceEvent, now: Seconds) -> None:
        """Take one event of an ENIG link."""
        self.books.now = now
        if device := self.devices.handle(event):
            if device.kind is DeviceKind.DOOR:
                self.doors.told(device)
            else:
                self.buffers.told(device, event)
                self._think_soon()
        self._go_on()

    def handle_drive(self, event: DriveEvent, now: Seconds) -> None:
        """Take one event of a drive line."""
        self.books.now = now
        self.drives.handle(event)

    def replanned(self, tables: Tables, now: Seconds) -> None:
        """Plan routes by these tables from now on, if they are those that were wanted."""
        self.books.now = now
        if self.books.router.adopt(tables):
            self._think_soon()

    def ask(self, request: Request, ticket: int, now: Seconds) -> None:
        """Take one request; its reply is among the effects under this ticket."""
        self.books.now = now
        self.books.effects.replies.append((ticket, self._desk.answer(request)))
        self._think_soon()
        self._go_on(all_devices=True)

    def tell(self, word: Word, now: Seconds) -> tuple[Reply, list[LinkSend]]:
        """Take a word that changes nothing that is kept. Its reply, and what it gives the lines to do, need no commit."""
        self.books.now = now
        return self.drives.tell(word)

    def link_objection(self, send: LinkSend) -> str:
        """Return why an order to a link must not leave any more now that it is durable, empty if it may."""
        if isinstance(send.order, DeviceRequest):
            return self.device_objection(send.order)
        return self.drives.objection(send)

    def _think_soon(self) -> None:
        """Something changed that dispatch should see; many changes together cost one assignment."""
        pause = max(THINK_AT_MOST_EVERY, min(THINK_EVERY, len(self.books.jobs) * THINK_SECONDS_PER_JOB))
        self._next_thought = min(self._next_thought, Seconds(max(self.books.now, self._last_thought + pause)))

    # -- between a decision and its sending --------------------------------------------------------------------------

    def objection(self, send: Send) -> str:
        """Return why a command must not leave any more now that it is durable, empty if it may."""
        return objection(self.books, self.motion.passages, send)

    def device_objection(self, request: DeviceRequest) -> str:
        """Return why a command to a door or buffer must not leave any more now that it is durable, empty if it may."""
        device = self.devices.all.get(request.device)
        if device is None or not isinstance(request.command, DeviceAct):
            return ""
        return self.devices.may_leave(device, request.id) or self.doors.may_leave(device, request.command)

    # -- going on -----------------------------------------------------------------------------------------------------

    def _go_on(self, *, all_devices: bool = False) -> None:
        """Let everything go on that may: vehicles that were woken, then what depends on them, until nothing changes."""
        books = self.books
        while True:
            while books.woken:
                name = next(iter(books.woken))
                del books.woken[name]
                vehicle = books.vehicles[name]
                self._flow.goes_on(vehicle)
                self.missions.proceed(vehicle)
                if vehicle.errand:
                    self._courtesy.explain(vehicle, self.motion.advance(vehicle))
                self.doors.follow(vehicle)
                self._looks.looked(vehicle, books.now)
            self._mind_changed()
            if self.devices.all:
                self._mind_devices(everything=all_devices)
            if not books.woken:
                break
        self.teaching.reassess()
        self._plant_orders.note_rest()
        if books.jobs_changed:
            books.jobs_changed = False
            self._think_soon()

    def _mind_changed(self) -> None:
        """See to what hangs on the vehicles that are different now: their next look, who is free, doors and buffers."""
        books = self.books
        changed, books.changed = books.changed, {}
        for name in changed:
            vehicle = books.vehicles[name]
            self._note_fitness(vehicle)
            self._flow.mind(vehicle)
            self._looks.mind(vehicle, books.now)
            if not vehicle.available:
                self._free.discard(name)
            elif name not in self._free:
                self._free.add(name)
                books.jobs_changed |= bool(books.backlog.queued)
        if self.devices.all:
            self.doors.concern(changed)
            self.buffers.concern(changed)

    def _mind_devices(self, *, everything: bool) -> None:
        """Doors open and close, buffers are locked and unlocked, by what vehicles do now."""
        concerned = self.devices.concerned(everything=everything)
        self.doors.mind(concerned)
        self.buffers.mind(concerned)
        self.devices.show()

    # -- outputs ------------------------------------------------------------------------------------------------------

    def take(self) -> Effects:
        """Return and forget what was decided, with what has changed for the eye."""
        books = self.books
        effects, touched = books.effects, books.touched
        if touched:
            books.touched = {}
            if effects.records or effects.replies:
                self._show_vehicles(name for name in touched if name in books.dirty)
        if self._show_at <= books.now:
            due = books.now - SHOW_EVERY + SHOW_TOGETHER
            self._show_vehicles(list(takewhile(lambda name: books.dirty[name] <= due, books.dirty)))
        if effects.empty:
            return effects
        books.effects = Effects()
        return effects

    @property
    def _show_at(self) -> Seconds:
        """When the next vehicle is to be shown; infinite if none looks different."""
        return Seconds(next(iter(self.books.dirty.values())) + SHOW_EVERY) if self.books.dirty else Seconds(inf)

    def _show_vehicles(self, names: Iterable[VehicleId]) -> None:
        books = self.books
        for name in names:
            vehicle = books.vehicles[name]
            del books.dirty[name]
            job, link = books.job_of(vehicle), self._link(name)
            view = view_of_vehicle(vehicle, job, books.plant, link, books.utc_at, books.parking)
            if self._shown.get(name) != view:
                self._shown[name] = view
                books.effects.updates.append(Update(Topic.VEHICLES, name, view))

    def open_intents(self, vehicle: VehicleId) -> tuple[Intent, ...]:
        """Return the commands of a vehicle whose outcome is not known yet."""
        return tuple(self.books.vehicles[vehicle].opened.values())
