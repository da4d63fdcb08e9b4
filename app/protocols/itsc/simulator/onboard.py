"""The controller on board of a simulated vehicle: commands checked, carried out, answered (PROTOCOLS 5.1)."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from app.domain.layout import Axis, PulseSet, VehicleSpec
from app.domain.units import Barcode, Pulses
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.messages import Action, Code, Disp, Enq, Etb, Mode, Move, Oper, Port, Xmove
from app.protocols.itsc.simulator.agenda import Agenda
from app.protocols.itsc.simulator.checks import objections
from app.protocols.itsc.simulator.link import Link
from app.protocols.itsc.simulator.options import Options, RespTiming
from app.protocols.itsc.simulator.report import Reporter
from app.protocols.itsc.simulator.state import STOP_TAGS, State
from app.protocols.itsc.simulator.surroundings import Surroundings
from app.protocols.itsc.simulator.teaching import DEST_TEACHING, OFFSET_TEACHING, Told, teach_each
from app.protocols.itsc.simulator.transfer import TRANSFERS, Effect, Hoist, Transfer, Work
from app.protocols.itsc.simulator.traveler import Traveler


@dataclass(slots=True)
class Job:
    """A command under way. ``answered`` where RESP1 came at acceptance; ``failing`` while the vehicle brakes because of it."""

    cmd_id: int
    kind: Code
    code: int
    answered: bool = False
    failing: bool = False


class Onboard:
    """Holds the state and decides. One job at a time; everything is timed by the agenda."""

    def __init__(
        self,
        spec: VehicleSpec,
        codec: Codec,
        agenda: Agenda,
        link: Link,
        traveler: Traveler,
        surroundings: Surroundings,
        options: Options,
    ) -> None:
        self.state = State()
        self.job: Job | None = None
        self.blocked = False
        self.refuse_next = 0
        self.misread: Barcode | None = None
        self.last_refusal = ""
        self.reset: Callable[[], None] = lambda: None
        self.aligned: Callable[[Barcode], PulseSet | None] = lambda barcode: None
        self._spec = spec
        self._codec = codec
        self._agenda = agenda
        self._link = link
        self._traveler = traveler
        self._surroundings = surroundings
        self._options = options
        self.hoist = Hoist(self.state, agenda, options)
        self._stops: list[Job] = []
        self._servo: Job | None = None
        self._report_due = False
        self._report = Reporter(codec.dialect, options, lambda: traveler.place(agenda.now)[1])
        traveler.on_barcode = self._on_barcode
        traveler.on_end = self._on_end
        link.obey = self.obey
        agenda.after_each = self.settle
        self._acts: Mapping[Code, Callable[[Job, Enq | Etb], None]] = {
            Code.STATUS: self._status,
            Code.DISTANCE: self._distance,
            Code.SERVO_ON: self._servo_on,
            Code.SERVO_OFF: self._servo_off,
            Code.SEARCH_HOME: lambda job, _: self._home(job, options.search_home_time),
            Code.GO_HOME: lambda job, _: self._home(job, options.go_home_time),
            Code.SYSTEM_RESET: lambda _job, _frame: self.reset(),
            Code.ALARM_CLEAR: self._alarm_clear,
            Code.AUTO: self._auto,
            Code.STOP: self._stop,
            Code.STOP_BY_HOST: self._stop,
            Code.MOVE: self._move,
            Code.XMOVE: self._xmove,
            Code.PORT_DEST_TEACHING: lambda job, _: self._teach_all(job, DEST_TEACHING),
            Code.PORT_OFFSET_TEACHING: lambda job, _: self._teach_all(job, OFFSET_TEACHING),
            Code.DISPLAY_BY_HOST: self._display,
        } | dict.fromkeys(TRANSFERS, self._transfer)

    # Commands

    def obey(self, frame: Enq | Etb) -> None:
        """Check a command in the order of 5.1, rule 5; carry it out or refuse it."""
        message = self._codec.message(frame.code)
        kind = None if message is None else message.kind
        running = None if self.job is None else self.job.kind
        wrong = next(objections(frame, message, self._codec, self.state, self._options, running), None)
        if wrong is None and kind is not Code.STATUS and self.refuse_next > 0:
            self.refuse_next -= 1
            wrong = "told to refuse"
        if wrong is not None or kind is None:
            self.last_refusal = wrong or ""
            self._link.answer(frame.cmd_id, frame.code, self._report.resp1(self.state, 1))
            return
        self._acts[kind](Job(frame.cmd_id, kind, frame.code), frame)

    def _status(self, job: Job, _frame: Enq | Etb) -> None:
        self._link.answer(job.cmd_id, job.code, self._report.resp2(self.state))

    def _distance(self, job: Job, _frame: Enq | Etb) -> None:
        self._link.answer(job.cmd_id, job.code, self._report.resp3())

    def _servo_on(self, job: Job, _frame: Enq | Etb) -> None:
        self._accept(job)
        if self._servo is not None:
            self._answer(self._servo, 1)
        self._servo = job
        self._agenda.after(self._options.servo_time, lambda: self._servos_ready(job))

    def _servos_ready(self, job: Job) -> None:
        if self._servo is not job:
            return
        self._servo = None
        if self.state.oper is Oper.ALARM:
            self._answer(job, 1)
            return
        if not self.state.servos:
            self.state.servos_on()
            self.read_here()
        self.settle()
        self._answer(job, 0)

    def _servo_off(self, job: Job, _frame: Enq | Etb) -> None:
        if self._servo is not None:
            self._answer(self._servo, 1)
            self._servo = None
        self.state.servos_off()
        self._answer(job, 0)

    def _home(self, job: Job, seconds: float) -> None:
        self._begin(job)

        def done() -> None:
            self.state.home_known = True
            self._finish(0)

        self.hoist.home(seconds, done)

    def _alarm_clear(self, job: Job, _frame: Enq | Etb) -> None:
        cleared = not self.state.cause_remains
        if cleared:
            self.state.alarm = 0
            if self.state.oper is Oper.ALARM:
                self._set_oper(Oper.IDLE)
        self._answer(job, 0 if cleared else 1)

    def _auto(self, job: Job, _frame: Enq | Etb) -> None:
        self.set_mode(Mode.AUTO)
        self._answer(job, 0)

    def _display(self, job: Job, frame: Enq | Etb) -> None:
        if isinstance(frame.body, Disp):
            self.state.shown_text = frame.body.text
            self.state.shown_alarm = frame.body.alarm if frame.body.opt == 1 else None
        self._answer(job, 0)

    def _stop(self, job: Job, _frame: Enq | Etb) -> None:
        """STOP and STOP BY HOST: answered once standing, after the job that they end (I60)."""
        self._accept(job)
        self._stops.append(job)
        self.fail_job()

    def _move(self, job: Job, frame: Enq | Etb) -> None:
        path = frame.body.path if isinstance(frame.body, Move) else []
        if len(path) > self._spec.max_count:
            self._refuse(job, f"{len(path)} path elements, at most {self._spec.max_count}")
            return
        if not self._traveler.start(path):
            self._refuse(job, "the path does not begin here")
            return
        self.state.seq = 0
        self.state.moving = True
        self._begin(job)
        if self.blocked:
            self._pause()

    def _xmove(self, job: Job, frame: Enq | Etb) -> None:
        path = frame.body.path if isinstance(frame.body, Xmove) else []
        running = self.job is not None and self.job.kind is Code.MOVE and not self.job.failing
        if not running or len(path) > self._spec.max_count or not self._traveler.splice(path):
            self._refuse(job, "the vehicle stands, is stopping, or the path does not lead on from here")
            return
        self._answer(job, 0)

    def _transfer(self, job: Job, frame: Enq | Etb) -> None:
        transfer = TRANSFERS[job.kind]
        body = frame.body
        target = PulseSet(Pulses(body.shft), Pulses(body.rota), Pulses(body.lift)) if isinstance(body, Port) else None
        down = self._options.buffer_lift if target is None else target.lift
        targets = {
            "shft": target.shft if target else Pulses(0),
            "rota": target.rota if target else Pulses(0),
            "lift": down,
        }
        alarm = 0

        def effect(what: Effect) -> bool:
            nonlocal alarm
            done = self._exchange(transfer, target)
            if not done:
                alarm = self._options.no_foup_alarm if what is Effect.TAKE else self._options.place_taken_alarm
            return done

        def done() -> None:
            if alarm:
                self._set_alarm(alarm, cause_remains=False)
            self._finish(1 if alarm else 0)

        self._begin(job)
        self.hoist.run(Work(transfer.steps, targets, effect, done))

    def _exchange(self, transfer: Transfer, target: PulseSet | None) -> bool:
        """The gripper has moved: take the FOUP from the place, or leave it there."""
        barcode = self._traveler.place(self._agenda.now)[0]
        if transfer.picks:
            self.state.foup = self._surroundings.take(self._spec.id, barcode, transfer.kind, target)
            return self.state.foup
        left = self._surroundings.put(self._spec.id, barcode, transfer.kind, target)
        self.state.foup = not left
        return left

    def _teach_all(self, job: Job, codes: tuple[Code, ...]) -> None:
        self.align()
        self._begin(job)
        teach_each(codes, self.teach, lambda: self.job is job, self._finish)

    def align(self) -> None:
        """Who teaches has brought the hoist over the port by hand before: each axis that nobody has jogged is there now."""
        where = self.aligned(self._traveler.place(self._agenda.now)[0])
        if where is not None:
            for axis in Axis:
                if self.state.pulses[axis] == 0:
                    self.hoist.jog(axis, where.of(axis))

    def teach(self, kind: Code, acked: Told, lost: Told) -> None:
        """Send one axis' position and the barcode, under the code that the dialect gives this message (I12)."""
        code = next(code for code, message in self._codec.messages.items() if message.kind is kind)
        self._link.ask(code, self._report.teach(self.state, kind), acked, lost)

    # Jobs

    @property
    def driving(self) -> bool:
        """Whether the drive runs or brakes."""
        return self._traveler.driving

    def fail_job(self) -> None:
        """End the running job abnormally: at once if nothing drives along the rail, otherwise once standing (I60)."""
        if self.job is not None:
            self.job.failing = True
        if self.driving:
            self._traveler.halt()
        else:
            self._fail_now()

    def _fail_now(self) -> None:
        """The vehicle stands: answer the failed job, then the stops, in order; the mode's event follows (I59, I60)."""
        self.hoist.freeze()
        self._traveler.drop_path()
        stops, self._stops = self._stops, []
        if any(stop.kind is Code.STOP for stop in stops):
            self.set_mode(Mode.MANT)
        if self.job is not None:
            self._finish(1, report=False)
        for stop in stops:
            self._answer(stop, 0)

    def _begin(self, job: Job) -> None:
        self.job = job
        self._set_oper(Oper.RUN)
        self._show_driving()
        self._accept(job)

    def _finish(self, result: int, *, report: bool = True) -> None:
        job, self.job = self.job, None
        self.state.moving = False
        self._show_driving()
        if self.state.oper is not Oper.ALARM:
            self._set_oper(Oper.IDLE)
        if report:
            self.settle()
        if job is not None:
            self._answer(job, result)

    def _accept(self, job: Job) -> None:
        if self._options.resp_timing is RespTiming.ACCEPTANCE:
            self._answer(job, 0)
            job.answered = True

    def _refuse(self, job: Job, reason: str) -> None:
        self.last_refusal = reason
        self._answer(job, 1)

    def _answer(self, job: Job, result: int) -> None:
        if not job.answered:
            self._link.answer(job.cmd_id, job.code, self._report.resp1(self.state, result))

    # What happens to the vehicle

    def _on_barcode(self, barcode: Barcode, index: int | None) -> None:
        misread, self.misread = self.misread, None
        self._read(misread or barcode, self.state.seq if index is None else index)
        job = self.job
        if (misread is not None or index is None) and job is not None and not job.failing:
            self.raise_alarm(self._options.wrong_barcode_alarm, cause_remains=False)

    def _on_end(self, arrived: bool) -> None:
        job = self.job
        self._show_driving()
        if not arrived and self.state.oper is Oper.PAUSE and job is not None and not job.failing:
            return
        path = self._traveler.path
        if arrived and job is not None and not job.failing:
            if self._traveler.index == len(path) - 1:
                tag = STOP_TAGS[Action(path[-1].action)]
                self.state.tag = min(tag, 1) if self._options.stop_tag_only else tag
                self._finish(0)
            else:
                self.raise_alarm(self._options.wrong_barcode_alarm, cause_remains=False)
            return
        self._fail_now()

    def _pause(self) -> None:
        self._set_oper(Oper.PAUSE)
        self._traveler.halt()

    def read_here(self) -> None:
        """Read the barcode that the vehicle stands on, if it does."""
        barcode = self._traveler.place(self._agenda.now)[0]
        if self._traveler.on_mark:
            self._read(barcode, self.state.seq)
        else:
            self.state.recognised = False

    def _read(self, barcode: Barcode, seq: int) -> None:
        self.state.barcode, self.state.seq, self.state.recognised = barcode, seq, True
        self._report_due = True

    def block(self) -> None:
        """The obstacle sensor sees something: a MOVE pauses (I54)."""
        self.blocked = True
        if self.job is not None and self.job.kind is Code.MOVE and self.state.oper is Oper.RUN and not self.job.failing:
            self._pause()

    def unblock(self) -> None:
        """The way is free: a paused MOVE goes on."""
        self.blocked = False
        if self.state.oper is Oper.PAUSE and self.job is not None and not self.job.failing:
            self._set_oper(Oper.RUN)
            self._traveler.resume()
            self._show_driving()

    def raise_alarm(self, code: int, *, cause_remains: bool) -> None:
        """OPER becomes ALARM, and a running job fails."""
        self._set_alarm(code, cause_remains=cause_remains)
        if self.job is not None or self.driving:
            self.fail_job()

    def _set_alarm(self, code: int, *, cause_remains: bool) -> None:
        self.state.alarm = code
        self.state.cause_remains = cause_remains
        self._set_oper(Oper.ALARM)

    def set_mode(self, mode: Mode) -> None:
        """Change the mode; a change is an event (1.10)."""
        self._report_due |= mode is not self.state.mode
        self.state.mode = mode

    def _set_oper(self, oper: Oper) -> None:
        self._report_due |= self._options.alarm_events and oper is not self.state.oper
        self.state.oper = oper

    def _show_driving(self) -> None:
        driving = self.driving
        if driving:
            self.state.tag = 0
        self.state.driving = driving

    def restart(self) -> None:
        """Lose job, path and all memory; axes, FOUP and place stay."""
        self.hoist.freeze()
        self._traveler.freeze()
        self.job = self._servo = None
        self._stops = []
        self._report_due = False
        self.state = self.hoist.state = self.state.restarted()

    # What is said

    def settle(self) -> None:
        """Send the STATUS event that is due: one, whatever coincided (I58); none without a connection."""
        if self._report_due:
            self._report_due = False
            self._link.ask(int(Code.STATUS), self._report.resp2(self.state))
