"""Doors, buffers and chargers: what is known of them, what they were asked, what is wrong with them (DOMAIN section 7).

A command is an intent like a vehicle's: durable before its first byte. Nothing acknowledges it, so its session tells by the
device's Status what became of it; what a restart or a lost line leaves open is settled here, by a Status that has stood for a
while (COMMANDS sections 1 and 3). Who decides what to ask is elsewhere: ``doors``, ``buffers``, ``device_orders``.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from app.domain.alarms import AlarmKind
from app.domain.devices import (
    BufferState,
    DeviceAct,
    DeviceBack,
    DeviceDone,
    DeviceEvent,
    DeviceFailed,
    DeviceGarbled,
    DeviceId,
    DeviceKind,
    DeviceNotAccepted,
    DeviceNotSent,
    DeviceReported,
    DeviceRequest,
    DeviceRequestId,
    DeviceStale,
    DeviceTaken,
    DeviceUnknown,
    DoorState,
    MoveCompleted,
    TagRead,
)
from app.domain.ids import Actor, CmdId, LinkId, VehicleId
from app.domain.job import JobEvent
from app.domain.layout import BufferSpec, ChargerSpec, DoorSpec
from app.domain.links import LinkSend
from app.domain.records import DeviceRecord, Intent, IntentState, Kept
from app.domain.units import Seconds
from app.domain.view import DeviceView, Topic
from app.fleet.books import Books
from app.fleet.device_views import view_of_device
from app.fleet.views import view_of_intent

QUIESCE = Seconds(1.0)
"""So long after a device is back what was open is settled: longer than the longest delay of a link (our choice)."""
RETRY = Seconds(10.0)
"""What came to nothing is asked again by ourselves after so long, if it is still wanted (our choice)."""
SILENT = Seconds(5.0)
"""A device that is not known is an alarm after so long: 10 s after its last word (PROTOCOLS E14 and our choice)."""

LOCKS = frozenset({DeviceAct.LOCK, DeviceAct.UNLOCK})
FAULTS: Mapping[DoorState | BufferState, str] = {
    DoorState.ERROR: "reports an error (255)",
    BufferState.ERROR: "reports an error (255)",
    DoorState.UNKNOWN: "does not know its state (3)",
    BufferState.UNKNOWN: "does not know its state (3)",
}
Spec = DoorSpec | BufferSpec | ChargerSpec
State = DoorState | BufferState


@dataclass(slots=True, eq=False)
class DeviceNow:
    """A device at this moment. ``state`` is its last word; it counts only while ``fresh``.

    ``since`` is when it came to this state, or fell silent; ``back`` when it was heard again after a silence. ``opened`` are
    commands whose outcome is not known yet, ``live`` those of them that its session is still watching. ``failed``: when an act
    last came to nothing; ``refusal`` in words, until something succeeds; ``faulty``: an error, until it shows a state that is
    none. ``trouble`` and ``contradiction`` are said of it by
    those who use it.
    """

    spec: Spec
    record: DeviceRecord
    since: Seconds
    fresh: bool = False
    state: State | None = None
    seen: Seconds | None = None
    back: Seconds = Seconds(0.0)
    reason: str = "not connected yet"
    opened: dict[CmdId, Intent] = field(default_factory=dict)
    live: set[CmdId] = field(default_factory=set)
    failed: dict[DeviceAct, Seconds] = field(default_factory=dict)
    refusal: tuple[str, str] | None = None
    faulty: str = ""
    alarm: str = ""
    remedy: str = ""
    trouble: tuple[str, str] | None = None
    contradiction: str = ""
    vehicles: tuple[str, ...] = ()
    waiting: tuple[str, ...] = ()

    @property
    def id(self) -> DeviceId:
        """The device's name."""
        return self.spec.id

    @property
    def link(self) -> LinkId | None:
        """The line that it is on; a charger is on none."""
        return None if isinstance(self.spec, ChargerSpec) else self.spec.link

    @property
    def kind(self) -> DeviceKind:
        """What it is."""
        kinds = {DoorSpec: DeviceKind.DOOR, BufferSpec: DeviceKind.BUFFER, ChargerSpec: DeviceKind.CHARGER}
        return kinds[type(self.spec)]

    @property
    def busy(self) -> bool:
        """Whether it is at work, by its last word."""
        return self.state in (DoorState.BUSY, BufferState.BUSY)

    @property
    def barred(self) -> str:
        """Why people have closed it to vehicles, as a clause; empty if they have not."""
        if self.record.lockout:
            return str(self.record.lockout)
        if self.record.out_of_service:
            return f"out of service: {self.record.out_of_service}"
        return ""

    def pending(self, *acts: DeviceAct) -> bool:
        """Whether one of these may still take effect."""
        return any(intent.kind in acts for intent in self.opened.values())


class Devices:
    """Knows the doors, buffers and chargers of the plant."""

    def __init__(self, books: Books, kept: Kept) -> None:
        self._books = books
        records = {record.device: record for record in kept.devices}
        plant = books.plant
        specs: list[Spec] = [*plant.doors, *plant.buffers, *plant.chargers]
        self.all: dict[DeviceId, DeviceNow] = {
            spec.id: DeviceNow(spec, records.get(spec.id, DeviceRecord(spec.id)), books.now) for spec in specs
        }
        for intent in kept.intents:
            if device := self.all.get(DeviceId(intent.vehicle)):
                device.opened[intent.cmd_id] = intent
        self._shown: dict[DeviceId, DeviceView] = {}
        self._changed: dict[DeviceId, None] = dict.fromkeys(self.all)
        self._concerned: dict[DeviceId, None] = dict.fromkeys(self.all)
        self.locked_for: dict[VehicleId, dict[DeviceId, None]] = {}
        """The buffers that are locked, or to be locked, for each vehicle."""
        for record in records.values():
            self._note_lock(record, None)
        for device in self.all.values():
            if isinstance(device.spec, ChargerSpec):
                device.fresh, device.reason = True, ""
            for intent in device.opened.values():
                books.show(Topic.COMMANDS, f"{intent.cmd_id:016x}", view_of_intent(intent))

    # -- what they say ------------------------------------------------------------------------------------------------

    def handle(self, event: DeviceEvent) -> DeviceNow | None:
        """Take what a link tells of one of its doors and buffers; return that one if anything is different now."""
        device = None if event.device is None else self.all.get(event.device)
        if device is None:
            return None
        match event:
            case DeviceReported(status=DoorState() | BufferState() as state, at=at):
                self._reported(device, state, at)
            case DeviceStale(reason=reason):
                device.fresh, device.reason, device.since = False, reason, self._books.now
            case DeviceBack():
                device.fresh, device.reason, device.back = True, "", self._books.now
                device.failed.clear()
                if device.record.locked:
                    self.save(device, locked=None)
            case DeviceDone() | DeviceNotSent() | DeviceNotAccepted() | DeviceFailed() | DeviceUnknown():
                self._ended(device, event)
            case DeviceReported() | DeviceTaken() | DeviceGarbled() | TagRead() | MoveCompleted():
                return None
        self._settle(device)
        self._mind_alarm(device)
        self.touch(device)
        return device

    def _reported(self, device: DeviceNow, state: State, at: Seconds) -> None:
        if device.state is not state:
            device.since = at
            if state in FAULTS:
                device.faulty = FAULTS[state]
            elif state not in (DoorState.BUSY, BufferState.BUSY):
                device.faulty, device.refusal = "", None
        device.fresh, device.state, device.seen, device.reason = True, state, at, ""

    def _ended(
        self, device: DeviceNow, event: DeviceDone | DeviceNotSent | DeviceNotAccepted | DeviceFailed | DeviceUnknown
    ) -> None:
        """The session has said what became of a command. Unknown is not failed: Status will settle it."""
        cmd_id = CmdId(event.request)
        intent = device.opened.get(cmd_id)
        device.live.discard(cmd_id)
        if intent is None:
            return
        act = DeviceAct(intent.kind)
        match event:
            case DeviceDone():
                self._close(device, cmd_id, IntentState.DONE, "Status shows it")
                device.failed.pop(act, None)
                device.refusal = None
                if act in LOCKS:
                    self.save(device, locked=act is DeviceAct.LOCK)
                return
            case DeviceUnknown(why=why):
                self._keep(device, replace(intent, state=IntentState.UNKNOWN, outcome=why.value))
                return
            case DeviceNotSent(reason=reason):
                self._close(device, cmd_id, IntentState.NOT_SENT, reason)
            case DeviceNotAccepted(reason=reason, remedy=remedy):
                self._close(device, cmd_id, IntentState.FAILED, f"not accepted: {reason}")
                device.refusal = f"does not {act.value}: {reason}", remedy or "look at the device"
            case DeviceFailed(reason=reason):
                self._close(device, cmd_id, IntentState.FAILED, reason)
                device.refusal = f"did not {act.value}: {reason}", "look at the device, then command it again"
        device.failed[act] = self._books.now

    # -- what they are asked ------------------------------------------------------------------------------------------

    def ask(self, device: DeviceNow, act: DeviceAct, actor: Actor) -> Intent:
        """Make a command durable and send it. Only for a device on a link."""
        books = self._books
        intent = Intent(books.cmd_ids.next(), VehicleId(device.id), act.value, IntentState.OPEN, books.utc, actor)
        device.live.add(intent.cmd_id)
        self._keep(device, intent)
        if act in LOCKS:
            self.save(device, locked=None)
        if device.link is not None:
            request = DeviceRequest(DeviceRequestId(intent.cmd_id), device.id, act)
            books.effects.link_sends.append(LinkSend(device.link, request))
        return intent

    def may_ask(self, device: DeviceNow, act: DeviceAct) -> bool:
        """Whether we ask for this by ourselves now: not while it is under way, nor too soon after it came to nothing."""
        if not device.fresh or device.record.lockout or device.pending(act):
            return False
        failed = device.failed.get(act)
        return failed is None or self._books.now - failed >= RETRY

    def may_leave(self, device: DeviceNow, request: DeviceRequestId) -> str:
        """Return why a command must not leave any more now that it is durable, empty if it may."""
        if CmdId(request) not in device.opened:
            return "it was settled before it could be sent"
        return device.barred if device.record.lockout else ""

    def _keep(self, device: DeviceNow, intent: Intent) -> None:
        books = self._books
        if intent.state.closed:
            device.opened.pop(intent.cmd_id, None)
        else:
            device.opened[intent.cmd_id] = intent
        books.effects.records.append(intent)
        shown = None if intent.state.closed else view_of_intent(intent)
        books.show(Topic.COMMANDS, f"{intent.cmd_id:016x}", shown)
        self.touch(device)

    def _close(self, device: DeviceNow, cmd_id: CmdId, state: IntentState, outcome: str) -> None:
        intent = device.opened[cmd_id]
        self._keep(device, replace(intent, state=state, closed=self._books.utc, outcome=outcome))

    # -- settlement ---------------------------------------------------------------------------------------------------

    def _settle(self, device: DeviceNow) -> None:
        """Decide by Status what nobody watches any more: after a restart, a lost line, a later command (COMMANDS section 3)."""
        if not device.opened or device.live or not device.fresh or device.state is None or device.busy:
            return
        if self._books.now - device.back < QUIESCE:
            return
        said = f"by Status: {device.state.name.lower()}"
        shown = {DeviceAct.OPEN: DoorState.OPEN, DeviceAct.CLOSE: DoorState.CLOSED}
        for cmd_id, intent in list(device.opened.items()):
            act = DeviceAct(intent.kind)
            if act not in shown:
                outcome = f"{said}; it does not say whether the buffer is locked"
                self._close(device, cmd_id, IntentState.SETTLED_NOT_DONE, outcome)
                self.save(device, locked=None)
                continue
            done = device.state is shown[act]
            self._close(device, cmd_id, IntentState.SETTLED_DONE if done else IntentState.SETTLED_NOT_DONE, said)

    # -- records ------------------------------------------------------------------------------------------------------

    def save(self, device: DeviceNow, **changes: object) -> None:
        """Change and keep the durable part of a device."""
        record = replace(device.record, **changes)  # type: ignore[arg-type]
        if record != device.record:
            self._note_lock(record, device.record)
            device.record = record
            self._books.effects.records.append(record)
        self.touch(device)

    def _note_lock(self, now: DeviceRecord, before: DeviceRecord | None) -> None:
        if before is not None and before.lock:
            self.locked_for.get(VehicleId(before.lock.owner), {}).pop(now.device, None)
        if now.lock:
            self.locked_for.setdefault(VehicleId(now.lock.owner), {})[now.device] = None

    def charging(self, charger: DeviceId, vehicle: VehicleId | None) -> None:
        """Say which vehicle charges at a charger, or is on its way to; None: nobody."""
        device = self.all.get(charger)
        vehicles = () if vehicle is None else (vehicle,)
        if device and device.vehicles != vehicles:
            device.vehicles = vehicles
            self.touch(device)

    # -- alarms -------------------------------------------------------------------------------------------------------

    def tick(self) -> None:
        """Time has passed: settle what may be settled now, and mind what has been silent for too long."""
        for device in self.all.values():
            self._settle(device)
            self._mind_alarm(device)

    def say(self, device: DeviceNow, trouble: tuple[str, str] | None, contradiction: str = "") -> None:
        """Those who use a device say what is wrong with it, with the remedy; None: nothing is, as far as they know."""
        if (device.trouble, device.contradiction) != (trouble, contradiction):
            device.trouble, device.contradiction = trouble, contradiction
            self._mind_alarm(device)
            self.touch(device)

    def _mind_alarm(self, device: DeviceNow) -> None:
        """An alarm that begins, changes or ends is a durable event."""
        alarm, remedy = self._wrong(device) or ("", "")
        before = device.alarm
        device.alarm, device.remedy = alarm, remedy
        if alarm:
            code = alarm.partition(":")[0]
            self._books.alarms.begin_only(AlarmKind.DEVICE, device.id, code, f"{device.id} {alarm}", remedy)
        elif device.fresh and self._books.alarms.about(AlarmKind.DEVICE, device.id):
            self._books.alarms.end(AlarmKind.DEVICE, device.id, "nothing is wrong with it any more")
        if alarm == before:
            return
        self.touch(device)
        name = JobEvent.ALARM_SET if alarm else JobEvent.ALARM_CLEARED
        detail = f"{device.id} {alarm}; {remedy}" if alarm else f"{device.id} {before}"
        self._books.event(name, vehicle=VehicleId(device.id), detail=detail)

    def _wrong(self, device: DeviceNow) -> tuple[str, str] | None:
        """Return what is wrong with a device, and what would help."""
        if not device.fresh:
            silent = self._books.now - device.since >= SILENT
            return (f"is silent: {device.reason}", "see its line and its power") if silent else None
        if device.faulty:
            again = ", then open or close it" if device.kind is DeviceKind.DOOR else ""
            return device.faulty, f"see what is in its way at the {device.kind.value}{again}"
        if device.contradiction:
            return device.contradiction, "look there, then PUT /api/v1/stations/ID with what is there"
        return device.trouble or device.refusal

    # -- what people see ----------------------------------------------------------------------------------------------

    def touch(self, device: DeviceNow) -> None:
        """Note that a device may look different now."""
        self._changed[device.id] = self._concerned[device.id] = None

    def concern(self, device: DeviceId) -> None:
        """Note that something is different on which it hangs what a device is to do."""
        self._concerned[device] = None

    def concerned(self, *, everything: bool) -> list[DeviceNow]:
        """Return and forget the devices for which something is different, or all of them."""
        names, self._concerned = self._concerned, {}
        return list(self.all.values()) if everything else [self.all[name] for name in names]

    def show(self) -> None:
        """Show the devices that look different now."""
        for name in self._changed:
            view = view_of_device(self.all[name], self._books)
            if self._shown.get(name) != view:
                self._shown[name] = view
                self._books.show(Topic.DEVICES, name, view)
        self._changed.clear()
