"""An AGV between its ENIG link and the fleet (PROTOCOLS 3.3, E9; COMMANDS section 1; DOMAIN section 4).

The fleet's commands become ENIG's, what the AGV shows becomes the fleet's events, so that settlement, claims, jobs and
people's decisions know no other kind of vehicle. Nothing is taken for done because it was sent.
"""

from collections import deque
from collections.abc import Iterable
from dataclasses import replace

from app.control.agv_tasks import Handling, Journey, Outcome, Task, task_of
from app.control.agv_words import condition_of
from app.domain.commands import Display, Send, Xmove
from app.domain.devices import (
    AgvMove,
    AgvStatus,
    DeviceAct,
    DeviceBack,
    DeviceCommand,
    DeviceDone,
    DeviceDoubt,
    DeviceEvent,
    DeviceFailed,
    DeviceGarbled,
    DeviceId,
    DeviceNotAccepted,
    DeviceNotSent,
    DeviceReported,
    DeviceRequest,
    DeviceRequestId,
    DeviceStale,
    DeviceStatus,
    DeviceTaken,
    DeviceUnknown,
    MoveCompleted,
    TagRead,
)
from app.domain.events import (
    Acknowledged,
    Answered,
    Event,
    Garbled,
    LinkDown,
    LinkUp,
    NotSent,
    Reported,
    Unanswered,
    Unknown,
)
from app.domain.ids import CmdId, CmdIds, VehicleId
from app.domain.units import Barcode, Seconds
from app.domain.vehicle import Condition, VehicleStatus
from app.planning.ways import Ways

DELAY = Seconds(0.3)
"""A Status may have been on its way so long: it shows the AGV as it was no earlier than that before it came (our choice)."""
PATIENCE = Seconds(2.0)
"""So long after a command's end a Status that denies it is not believed to be an old one any more (our choice)."""


class Agv:
    """Takes ``send`` from the fleet and ``take`` and ``hear`` from the link; gives ``requests`` and ``events``.

    ENIG has no poll: each Status counts as asked for ``DELAY`` before it came.
    """

    def __init__(self, vehicle: VehicleId, ways: Ways, cmd_ids: CmdIds) -> None:
        self.vehicle = vehicle
        self.device = DeviceId(vehicle)
        self._ways = ways
        self._cmd_ids = cmd_ids
        self._status: AgvStatus | None = None
        self._condition: Condition | None = None
        self._told_at: Seconds | None = None
        self._tasks: dict[CmdId, Task] = {}
        self._asked: dict[DeviceRequestId, Task] = {}
        self._requests: list[DeviceRequest] = []
        self._events: list[Event] = []

    def requests(self) -> list[DeviceRequest]:
        """Return and forget what the link is to send now."""
        requests, self._requests = self._requests, []
        return requests

    def events(self) -> list[Event]:
        """Return and forget what the fleet is to be told, in order."""
        events, self._events = self._events, []
        return events

    # -- from the fleet -----------------------------------------------------------------------------------------------

    def send(self, send: Send, now: Seconds) -> None:
        """Begin a command whose intent is durable, or say why not."""
        command = send.command
        if isinstance(command, Xmove):
            self._lengthen(send, command)
            return
        if self._status is None:
            self._events.append(NotSent(self.vehicle, send.cmd_id, command, "it has not reported yet", "wait for it"))
            return
        task = task_of(send, self._status)
        if task is None:
            what = "display" if isinstance(command, Display) else "such a command"
            reason = f"{self.vehicle} is an AGV, and ENIG has no {what}"
            self._events.append(NotSent(self.vehicle, send.cmd_id, command, reason))
            return
        if DeviceAct.STOP in task.steps:
            self._cut_short()
        self._tasks[send.cmd_id] = task
        self._go_on(task, now)

    def _lengthen(self, send: Send, xmove: Xmove) -> None:
        """An XMOVE: the journey goes on beyond its end. The AGV is told as far as it may be, now or on the way."""
        journey = self._tasks.get(xmove.amends)
        path = [element.barcode for element in xmove.path]
        if not isinstance(journey, Journey) or journey.ends or journey.way[-1] != path[0]:
            self._answer(send, Outcome(ok=False, reason="it stands, or is about to"))
            return
        journey.way += path[1:]
        self._answer(send, Outcome(ok=True))
        self._drive_on(journey)

    def _cut_short(self) -> None:
        """A Stop goes out: nothing more of what drives leaves. A handling ends: half a lift is no safer."""
        for task in self._tasks.values():
            if not isinstance(task, Handling) and (task.steps or isinstance(task, Journey)):
                task.stopped = True
                task.steps.clear()

    # -- from the link ------------------------------------------------------------------------------------------------

    def take(self, events: Iterable[DeviceEvent], now: Seconds) -> None:
        """Take what the link tells of this AGV."""
        for event in events:
            self._take(event, now)

    def hear(self, status: DeviceStatus | None, at: Seconds | None, now: Seconds) -> None:
        """Note when the newest Status came: one that is like the one before is told too, since it answers a question."""
        if at is None or not isinstance(status, AgvStatus) or (self._told_at is not None and at <= self._told_at):
            return
        self._learn(status)
        self._report(at)
        self._look(now)

    def _take(self, event: DeviceEvent, now: Seconds) -> None:
        match event:
            case DeviceBack():
                self._events.append(LinkUp(self.vehicle))
            case DeviceStale(reason=reason):
                self._lose(reason)
            case DeviceReported(status=AgvStatus() as status, at=at):
                self._learn(status)
                self._report(at)
                self._look(now)
            case TagRead(tag=tag):
                self._passed(tag)
            case DeviceTaken(request=request):
                self._taken(request)
            case DeviceDone(request=request):
                self._done(request, now)
            case DeviceNotSent() | DeviceNotAccepted() | DeviceFailed():
                self._failed(event)
            case DeviceUnknown(request=request, why=why):
                self._unknown(request, why)
            case DeviceGarbled(reason=reason, detail=detail):
                self._events.append(Garbled(self.vehicle, reason, detail))
            case MoveCompleted() | DeviceReported():
                pass

    def _learn(self, status: AgvStatus) -> None:
        if status != self._status:
            self._status, self._condition = status, condition_of(status)
        for journey in self._journeys():
            journey.passed(status.tag)

    def _report(self, at: Seconds) -> None:
        if self._status is not None and self._condition is not None:
            self._told_at = at
            status = VehicleStatus(self._condition, self._status.tag, 0)
            self._events.append(Reported(self.vehicle, status, polled=True, asked_at=Seconds(at - DELAY)))

    def _passed(self, tag: Barcode) -> None:
        """A tag was read: the place is known before the next Status says so."""
        if self._status is None or self._condition is None or tag == self._status.tag:
            return
        self._learn(replace(self._status, tag=tag))
        status = VehicleStatus(self._condition, tag, 0)
        self._events.append(Reported(self.vehicle, status, polled=False, asked_at=Seconds(0.0)))

    def _journeys(self) -> list[Journey]:
        return [task for task in self._tasks.values() if isinstance(task, Journey)]

    def _look(self, now: Seconds) -> None:
        """A Status has come: does it agree with what has ended, and may a journey be told more of its way?"""
        for task in list(self._tasks.values()):
            if task.ended is not None:
                self._conclude(task, now)
            elif isinstance(task, Journey):
                self._drive_on(task)

    def _lose(self, reason: str) -> None:
        for task in [task for task in self._tasks.values() if task.request not in self._asked]:
            self._unanswered(task, Unknown.LINK_LOST)
        self._events.append(LinkDown(self.vehicle, reason))

    # -- commands under way -------------------------------------------------------------------------------------------

    def _order(self, task: Task, command: DeviceCommand) -> None:
        """Send one of a task's commands; the first under the task's own id."""
        number = task.send.cmd_id if task.request is None else self._cmd_ids.next()
        task.request = DeviceRequestId(number)
        self._asked[task.request] = task
        self._requests.append(DeviceRequest(task.request, self.device, command))

    def _go_on(self, task: Task, now: Seconds) -> None:
        """Send a task's next command, or look whether it is done."""
        if task.steps:
            task.waits = True
            self._order(task, task.steps.popleft())
        elif isinstance(task, Journey) and task.at_its_aim_short_of_the_end:
            self._drive_on(task)
        elif task.stopped and not isinstance(task, Journey):
            self._finish(task, Outcome(ok=False, reason="stopped before it set out"))
        else:
            task.ended = now
            self._conclude(task, now)

    def _drive_on(self, journey: Journey) -> None:
        """Tell the AGV to drive on, as far as the granted way is certainly its own; once it shows the last command taken."""
        if journey.steps or journey.waits or journey.ended is not None:
            return
        if journey.stopped:
            if not journey.under_way:
                self._finish(journey, Outcome(ok=False, reason="stopped on its way"))
            return
        aim = journey.at + self._ways.sure(journey.way[journey.at :])
        if journey.aim is None or aim > journey.aim:
            if aim == journey.at and len(journey.way) > 1:
                self._lead_astray(journey)
                return
            journey.aim, journey.waits, journey.under_way = aim, True, True
            self._order(journey, AgvMove(journey.way[aim]))
        elif not journey.under_way:
            self._lead_astray(journey)

    def _lead_astray(self, journey: Journey) -> None:
        """No part of the rest of the way is certainly the AGV's own. While it drives, the next tag may change that."""
        if journey.under_way:
            return
        here, there = journey.way[journey.at : journey.at + 2]
        reason = f"{self.vehicle} may choose another way from {here} to {there} than the one granted"
        if journey.request is None:
            del self._tasks[journey.send.cmd_id]
            remedy = "correct the lengths of the track there, or make one of the ways one-way"
            self._events.append(NotSent(self.vehicle, journey.send.cmd_id, journey.send.command, reason, remedy))
        else:
            self._finish(journey, Outcome(ok=False, reason=reason))

    def _taken(self, request: DeviceRequestId) -> None:
        task = self._asked.get(request)
        if isinstance(task, Journey) and request == task.request and task.aim is not None:
            self._began(task)
            self._drive_on(task)

    def _began(self, journey: Journey) -> None:
        journey.waits = False
        if not journey.acknowledged:
            journey.acknowledged = True
            self._events.append(Acknowledged(self.vehicle, journey.send.cmd_id))

    def _done(self, request: DeviceRequestId, now: Seconds) -> None:
        task = self._asked.pop(request, None)
        if task is None or request != task.request:
            return
        task.waits = False
        if isinstance(task, Journey) and task.aim is not None:
            self._began(task)
            task.at, task.under_way = task.aim, False
        self._go_on(task, now)

    def _failed(self, event: DeviceNotSent | DeviceNotAccepted | DeviceFailed) -> None:
        """The newest of a task's commands has failed: so has the task. One that was overtaken has not."""
        task = self._asked.pop(event.request, None)
        if task is None or event.request != task.request:
            return
        if isinstance(event, DeviceNotSent) and event.request == DeviceRequestId(task.send.cmd_id):
            self._forget(task)
            self._events.append(NotSent(self.vehicle, task.send.cmd_id, task.send.command, event.reason, event.remedy))
            return
        self._finish(task, Outcome(ok=False, reason=event.reason))

    def _unknown(self, request: DeviceRequestId, why: DeviceDoubt) -> None:
        task = self._asked.pop(request, None)
        if task is not None and request == task.request:
            self._unanswered(task, Unknown.NO_ANSWER if why is DeviceDoubt.OVERTAKEN else Unknown.LINK_LOST)

    def _conclude(self, task: Task, now: Seconds) -> None:
        """All of a task's commands have ended: it is done if Status agrees, and undone where a lift moved no cart."""
        if self._status is None or task.ended is None:
            return
        outcome = task.judged(self._status)
        if not outcome.ok and now < task.ended + PATIENCE:
            return
        if isinstance(task, Handling) and not outcome.ok and task.way_back:
            task.outcome, task.ended = outcome, None
            task.steps, task.way_back = deque(task.way_back), ()
            self._go_on(task, now)
            return
        self._finish(task, outcome)

    def _finish(self, task: Task, outcome: Outcome) -> None:
        self._forget(task)
        self._answer(task.send, outcome)

    def _answer(self, send: Send, outcome: Outcome) -> None:
        if self._status is None or self._condition is None:
            return
        answer = Answered(
            self.vehicle, send.cmd_id, send.command, outcome.ok, outcome.reason, self._condition, self._status.tag, 0
        )
        self._events.append(answer)

    def _unanswered(self, task: Task, why: Unknown) -> None:
        self._forget(task)
        self._events.append(Unanswered(self.vehicle, task.send.cmd_id, task.send.command, why))

    def _forget(self, task: Task) -> None:
        self._tasks.pop(task.send.cmd_id, None)
        for request in [request for request, asked in self._asked.items() if asked is task]:
            del self._asked[request]
