"""A simulated vehicle: bytes on one side, operator and physical world on the other (PROTOCOLS 5.1)."""

from collections.abc import Callable
from functools import cache, lru_cache

from app.domain.layout import Axis, PulseSet, VehicleSpec
from app.domain.units import Barcode, Pulses, Seconds
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT, Dialect
from app.protocols.itsc.messages import Code, Mode
from app.protocols.itsc.simulator.agenda import Agenda, Due
from app.protocols.itsc.simulator.link import Link
from app.protocols.itsc.simulator.onboard import Onboard
from app.protocols.itsc.simulator.options import Options
from app.protocols.itsc.simulator.state import State
from app.protocols.itsc.simulator.surroundings import Places, Surroundings
from app.protocols.itsc.simulator.teaching import TAUGHT_AXIS
from app.protocols.itsc.simulator.track import Track
from app.protocols.itsc.simulator.traveler import Place, Traveler


@cache
def _codec(dialect: Dialect) -> Codec:
    return Codec(dialect)


def _check_barcode(barcode: Barcode, dialect: Dialect) -> None:
    if dialect.barcode_format == "ascii":
        fits = len(barcode) <= dialect.barcode_bytes and barcode.isascii()
    else:
        fits = barcode.isascii() and barcode.isdecimal() and int(barcode) < 1 << 8 * dialect.barcode_bytes
    if not fits:
        raise ValueError(
            f"barcode {barcode!r} does not fit in {dialect.barcode_bytes} bytes ({dialect.barcode_format})"
        )


@lru_cache(maxsize=4)
def _check_track(track: Track, dialect: Dialect) -> None:
    """Raises: ValueError: a barcode cannot be written. Done once for all vehicles of a plant."""
    for barcode in track.barcodes:
        _check_barcode(barcode, dialect)


class SimulatedVehicle:
    """An :class:`app.domain.ports.Endpoint` that behaves as an overhead hoist on its rail.

    It lives on without a connection: whoever owns it calls ``tick`` at ``deadline``, connected or not. Every input first
    lets everything happen that is due by ``now``. ``outgoing`` gives one packet at a call. ``accepting`` is False while the
    vehicle is off or restarting: the owner then refuses connections.
    """

    def __init__(
        self,
        spec: VehicleSpec,
        track: Track,
        *,
        dialect: Dialect = DEFAULT,
        surroundings: Surroundings | None = None,
        options: Options | None = None,
        start: Barcode | None = None,
        aligned: Callable[[Barcode], PulseSet | None] | None = None,
    ) -> None:
        """Put the vehicle on ``start``, or where its spec says.

        ``aligned`` tells where its axes stand once a person has brought the hoist over the port at a barcode by hand.

        Raises: ValueError: neither is on the track, or a barcode of the track cannot be written in the dialect.
        """
        where = start if start is not None else spec.start
        if where is None or where not in track:
            raise ValueError(f"vehicle {spec.id}: {where} is no barcode of the track to start from")
        _check_track(track, dialect)
        self.spec = spec
        self.options = options or Options()
        self._dialect = dialect
        codec = _codec(dialect)
        self._agenda = Agenda()
        self._link = Link(codec, spec.dev_id, self._agenda, self.options)
        self._traveler = Traveler(spec, track, self._agenda, where, self.options.switch_reach)
        self._track = track
        self._onboard = Onboard(
            spec, codec, self._agenda, self._link, self._traveler, surroundings or Places(), self.options
        )
        self._onboard.reset = self._system_reset
        self._onboard.aligned = aligned or self._onboard.aligned
        self._boot: Due | None = None
        self._off = False

    # Endpoint

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next, connected or not."""
        due = self._agenda.deadline
        return None if due is None else Seconds(due)

    @property
    def wants_close(self) -> bool:
        """Whether the connection should be closed once everything is sent."""
        return self._link.wants_close

    @property
    def accepting(self) -> bool:
        """Whether the vehicle takes a connection now."""
        return not self._off and (self._boot is None or self._boot.cancelled)

    def connected(self, now: Seconds) -> None:
        """A controller has connected; one that comes while the vehicle is not accepting is asked to go."""
        self._agenda.run(now)
        self._link.open()
        if not self.accepting:
            self._link.hang_up()

    def received(self, data: bytes, now: Seconds) -> None:
        """Take bytes; never raises."""
        self._agenda.run(now)
        self._link.feed(data)
        self._agenda.run(now)

    def disconnected(self, now: Seconds, reason: str = "") -> None:
        """The line is down; what the vehicle does goes on."""
        self._agenda.run(now)
        self._link.close()

    def tick(self, now: Seconds) -> None:
        """Let everything happen that is due."""
        self._agenda.run(now)

    def outgoing(self) -> bytes:
        """Return and forget the next packet; empty if there is none."""
        return self._link.outgoing()

    # What an oracle may see

    @property
    def state(self) -> State:
        """The vehicle's state, to be read only."""
        return self._onboard.state

    @property
    def last_refusal(self) -> str:
        """Why the vehicle refused last, which iTSC does not say (I46)."""
        return self._onboard.last_refusal

    @property
    def working(self) -> Code | None:
        """The command under way."""
        return None if self._onboard.job is None else self._onboard.job.kind

    @property
    def path(self) -> tuple[Barcode, ...]:
        """The barcodes of the path that it runs or has run, by SEQ; empty after a stop."""
        return tuple(Barcode(str(element.barcode)) for element in self._traveler.path)

    def place(self, now: Seconds) -> Place:
        """Return the barcode last passed, mm past it, and the barcode ahead, None standing on one.

        ``now`` is not before the last input and not after ``deadline``.
        """
        return self._traveler.place(now)

    # Operator and faults

    def panel_mode(self, mode: Mode, now: Seconds) -> None:
        """Turn the key on the vehicle (I35). A running job fails: nothing says so. Our choice."""
        self._agenda.run(now)
        changed = mode is not self.state.mode
        self._onboard.set_mode(mode)
        if changed and self._onboard.job is not None:
            self._onboard.fail_job()
        self._onboard.settle()

    def make_ready(self, now: Seconds, mode: Mode = Mode.AUTO) -> None:
        """Bring a standing vehicle at once to servos on, homed, its barcode read, in a mode: a shortcut for tests and demos."""
        self._agenda.run(now)
        self._onboard.hoist.freeze()
        for axis in Axis:
            self._onboard.hoist.jog(axis, Pulses(0))
        self.state.servos_on()
        self.state.axes.update(State().axes)
        self.state.home_known = True
        self._onboard.read_here()
        self._onboard.set_mode(mode)
        self._onboard.settle()

    def raise_alarm(self, code: int, now: Seconds, *, cause_remains: bool = False) -> None:
        """Put the vehicle in ALARM; ``cause_remains`` makes ALARM CLEAR fail until ``clear_cause``."""
        self._agenda.run(now)
        self._onboard.raise_alarm(code, cause_remains=cause_remains)
        self._onboard.settle()

    def clear_cause(self) -> None:
        """Take away what caused the alarm."""
        self.state.cause_remains = False

    def block_sensor(self, now: Seconds) -> None:
        """Put an obstacle before the sensor: a running MOVE pauses."""
        self._agenda.run(now)
        self._onboard.block()
        self._onboard.settle()

    def unblock_sensor(self, now: Seconds) -> None:
        """Take the obstacle away."""
        self._agenda.run(now)
        self._onboard.unblock()
        self._onboard.settle()

    def misread_next(self, barcode: Barcode) -> None:
        """Read the next barcode as another: a running MOVE ends in an alarm. Raises: ValueError: it cannot be written."""
        _check_barcode(barcode, self._dialect)
        self._onboard.misread = barcode

    def push_to(self, barcode: Barcode, now: Seconds) -> None:
        """Move the vehicle to a barcode by hand, also while it is off; with servos on it is read there (our choice).

        A running job fails with the wrong-barcode alarm. Raises: ValueError: no barcode of the track.
        """
        if barcode not in self._track:
            raise ValueError(f"{barcode} is no barcode of the track")
        self._agenda.run(now)
        self._traveler.put_on(barcode)
        self.state.driving, self.state.tag, self.state.recognised = False, 0, False
        if self.state.servos:
            self._onboard.read_here()
        else:
            self.state.barcode = None
        if self._onboard.job is not None:
            self._onboard.raise_alarm(self.options.wrong_barcode_alarm, cause_remains=False)
        self._onboard.settle()

    def jog(self, axis: Axis, pulses: Pulses, now: Seconds) -> None:
        """Bring one axis to a position by hand, as for teaching."""
        self._agenda.run(now)
        self._onboard.hoist.jog(axis, pulses)

    def teach_single(self, kind: Code, now: Seconds) -> None:
        """Send one teaching event unasked. Raises: ValueError: no such event, or the vehicle is not in MANT."""
        self._agenda.run(now)
        if kind not in TAUGHT_AXIS or self.state.mode is not Mode.MANT:
            raise ValueError(f"{kind.name} is no teaching event, or {self.spec.id} is not in MANT")
        self._onboard.align()
        self._onboard.teach(kind, lambda: None, lambda: None)

    def insert_foup(self, now: Seconds) -> None:
        """Put a FOUP into the gripper by hand."""
        self._agenda.run(now)
        self.state.foup = True

    def remove_foup(self, now: Seconds) -> None:
        """Take the FOUP out by hand."""
        self._agenda.run(now)
        self.state.foup = False

    def lose_foup(self, now: Seconds) -> None:
        """The FOUP falls: F = 0 and an alarm (5.1)."""
        self._agenda.run(now)
        self.state.foup = False
        self._onboard.raise_alarm(self.options.foup_lost_alarm, cause_remains=False)
        self._onboard.settle()

    def refuse_next(self, count: int = 1) -> None:
        """Refuse the next commands that would be carried out; STATUS is always answered."""
        self._onboard.refuse_next = count

    def power_off(self, now: Seconds) -> None:
        """Cut the power: the line drops, everything stands where it is, the memory is gone."""
        self._agenda.run(now)
        self._stop_life()
        self._off = True
        self._link.break_off()

    def power_on(self, now: Seconds) -> None:
        """Give power again: start-up state at once, connections after ``reboot_time``."""
        self._agenda.run(now)
        self._off = False
        self._reboot(self.options.reboot_time)

    def power_cycle(self, now: Seconds) -> None:
        """Cut the power and give it again."""
        self.power_off(now)
        self.power_on(now)

    def _stop_life(self) -> None:
        self._agenda.clear()
        self._onboard.restart()
        self._link.forget()

    def _system_reset(self) -> None:
        """ACK is on its way: close the link soon, refuse connections for a while, come back in the start-up state (I34)."""
        self._stop_life()
        self._agenda.after(self.options.close_after_reset, self._link.hang_up)
        self._link.deaf = True
        self._reboot(self.options.close_after_reset + self.options.reboot_time)

    def _reboot(self, seconds: float) -> None:
        self._boot = self._agenda.after(seconds, lambda: None)
