"""Mistakes that controllers make: each is built in on purpose, so that the oracle can show that it would notice.

Each takes a ``pytest.MonkeyPatch`` and spoils one thing. Where a mistake needs doors or AGVs it is tried on the hall.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from app.control.control import Control
from app.domain.ids import Epoch
from app.domain.layout import Plant
from app.domain.records import IntentState, Kept
from app.domain.units import Seconds, Timestamp
from app.domain.vehicle import Oper
from app.fleet import beginnings, dispatch, doors, missions, obstacles, reasons, recovery
from app.fleet.books import Books
from app.fleet.hearing import Hearing
from app.fleet.jobs import Jobs
from app.fleet.missions import Missions
from app.fleet.motion import Motion
from app.fleet.passages import Passages
from app.fleet.recovery import Recovery
from app.fleet.rollcall import RollCall
from app.fleet.targets import target_for
from app.fleet.vehicle import Stage, VehicleNow
from app.planning.traffic import Traffic
from app.protocols.itsc.session import refusals
from app.protocols.itsc.session.timing import Timing
from app.sim.memory import MemoryLedger

Mistake = Callable[[pytest.MonkeyPatch], None]


def _kept(patch: pytest.MonkeyPatch, change: Callable[[Kept], Kept]) -> None:
    """Let a controller load something else than was kept."""
    load = MemoryLedger.load
    patch.setattr(MemoryLedger, "load", lambda self: change(load(self)))


def forgotten_reservation(patch: pytest.MonkeyPatch) -> None:
    """After a restart vehicles are granted track though others have not said where they are, and hold nothing."""
    _kept(patch, lambda kept: replace(kept, vehicles=tuple(replace(v, held=()) for v in kept.vehicles), intents=()))
    patch.setattr(RollCall, "miss", lambda self, vehicle: None)


def cmd_ids_again(patch: pytest.MonkeyPatch) -> None:
    """The epoch is not raised: CMD_IDs are used again after a restart."""
    _kept(patch, lambda kept: replace(kept, epoch=Epoch(1)))


def events_again(patch: pytest.MonkeyPatch) -> None:
    """After a restart events are numbered from 1 again."""
    _kept(patch, lambda kept: replace(kept, next_event=1))


def forgotten_intents(patch: pytest.MonkeyPatch) -> None:
    """After a restart nobody remembers which commands may have been sent."""
    _kept(patch, lambda kept: replace(kept, intents=()))


def resent_after_restart(patch: pytest.MonkeyPatch) -> None:
    """A pick-up or place whose outcome is not known counts as not done, whatever F says."""

    def settle(self: Missions, vehicle: VehicleNow) -> None:
        for intent in vehicle.handlings:
            vehicle.handling = None
            self._books.close_intent(vehicle, intent.cmd_id, IntentState.SETTLED_NOT_DONE, "sent again")
            job = self._books.job_of(vehicle)
            if job is not None:
                station = self._books.specs[job.source if intent.kind == "pickup" else job.destination]  # type: ignore[index]
                target = target_for(self._books, vehicle, station)
                self._handle(vehicle, station, target, job, pickup=intent.kind == "pickup")  # type: ignore[arg-type]

    patch.setattr(Missions, "settle_handling", settle)


def no_quiesce(patch: pytest.MonkeyPatch) -> None:
    """What a vehicle says at once, and once, settles it, at rest or not."""
    patch.setattr(recovery, "QUIESCE", Seconds(0.0))
    patch.setattr(Recovery, "unrest", lambda self, vehicle, status: "")
    observe = Recovery.observe

    def at_once(self: Recovery, vehicle: VehicleNow, status: Any, asked_at: Seconds) -> bool:
        vehicle.agreed, vehicle.quiet_until = status, Seconds(0.0)
        return observe(self, vehicle, status, asked_at)

    patch.setattr(Recovery, "observe", at_once)


def early_release(patch: pytest.MonkeyPatch) -> None:
    """Track is free as soon as the next barcode is read, though the vehicle's length still covers it."""
    report = Motion.report

    def too_soon(self: Motion, vehicle: VehicleNow, barcode: Any, seq: int) -> None:
        report(self, vehicle, barcode, seq)
        vehicle.trail = {b: d for b, d in vehicle.trail.items() if b == vehicle.barcode}
        left = [b for b in self._books.traffic.held(vehicle.id) if b not in vehicle.trail and b not in vehicle.ahead]
        self._books.traffic.release(vehicle.id, left)
        self._wake_waiters(left)

    patch.setattr(Motion, "report", too_soon)


def released_when_silent(patch: pytest.MonkeyPatch) -> None:
    """A vehicle whose link is lost gives back all that it was granted, as if it had stopped at its last barcode."""
    lost = Recovery.link_lost

    def gone(self: Recovery, vehicle: VehicleNow, reason: str) -> None:
        lost(self, vehicle, reason)
        freed = [b for b in self._books.traffic.held(vehicle.id) if b != vehicle.barcode]
        self._books.traffic.release(vehicle.id, freed)
        self._motion._wake_waiters(freed)

    patch.setattr(Recovery, "link_lost", gone)


def granted_twice(patch: pytest.MonkeyPatch) -> None:
    """Who asks for track gets it, whoever holds it."""
    patch.setattr(Traffic, "obstacle", lambda self, vehicle, barcode: None)
    patch.setattr(Traffic, "_others", lambda self, vehicle, barcode: iter(()))


def answered_before_commit(patch: pytest.MonkeyPatch) -> None:
    """A caller is answered as soon as it is decided."""
    decide = Control._decide

    def at_once(self: Control) -> None:
        decide(self)
        for _, effects in self._uncommitted:
            self._replies += effects.replies
            effects.replies.clear()

    patch.setattr(Control, "_decide", at_once)


def sent_before_commit(patch: pytest.MonkeyPatch) -> None:
    """A command leaves as soon as it is decided; its intent is written meanwhile."""
    decide = Control._decide

    def at_once(self: Control) -> None:
        decide(self)
        for _, effects in self._uncommitted:
            for send in effects.sends:
                if send.vehicle in self._lines:
                    self._lines[send.vehicle].send(send, self.fleet.books.now)
                    self._dirty[send.vehicle] = None
            effects.sends[:] = [send for send in effects.sends if send.vehicle not in self._lines]

    patch.setattr(Control, "_decide", at_once)


def mode_ignored(patch: pytest.MonkeyPatch) -> None:
    """A vehicle is commanded in any mode."""
    patch.setattr(refusals, "_wrong_mode", lambda name, code, mode: None)

    def fit(self: VehicleNow) -> bool:
        return self.stage is Stage.READY and self.oper is not Oper.ALARM and not self.barred and self.recovery is None

    patch.setattr(VehicleNow, "fit", property(fit))
    patch.setattr(Hearing, "_mode_changed", lambda self, *args: None, raising=False)


def silence_unnoticed(patch: pytest.MonkeyPatch) -> None:
    """A half-open link is believed to be up, and an old STATUS to be true."""
    init = Control.__init__

    def patient(self: Control, plant: Plant, kept: Kept, now: Seconds, utc: Timestamp) -> None:
        init(self, plant, kept, now, utc, Timing(stale=Seconds(1e9), silence=Seconds(1e9)))

    patch.setattr(Control, "__init__", patient)


def _everywhere(patch: pytest.MonkeyPatch, name: str, instead: Callable[..., object]) -> None:
    """Replace a function in every part of the fleet that uses it."""
    for module in (missions, beginnings, dispatch, reasons, obstacles):
        if hasattr(module, name):
            patch.setattr(module, name, instead)


def source_not_looked_at(patch: pytest.MonkeyPatch) -> None:
    """A vehicle picks up at a place that is empty, because the job says so."""
    _everywhere(patch, "against_picking_up", lambda books, job: "")
    _everywhere(patch, "brought_first", lambda books, source, order: "")
    _everywhere(patch, "bringer", lambda books, job: None)


def destination_not_looked_at(patch: pytest.MonkeyPatch) -> None:
    """A vehicle puts down where something stands."""
    _everywhere(patch, "against_putting_down", lambda books, station, job: "")


def order_taken_twice(patch: pytest.MonkeyPatch) -> None:
    """An order whose id is known is taken for a new one."""
    patch.setattr(Jobs, "_known", lambda self, request: None)


def audit_forgotten(patch: pytest.MonkeyPatch) -> None:
    """What a person asks for is not written down."""
    audit = Books.audit

    def some(self: Books, actor: Any, action: str, *args: Any, **names: Any) -> None:
        if action != "ReleaseVehicle":
            audit(self, actor, action, *args, **names)

    patch.setattr(Books, "audit", some)


def event_skipped(patch: pytest.MonkeyPatch) -> None:
    """Watchers are not told of a vehicle that was released."""
    publish = Control._publish

    def some(self: Control, updates: Any) -> None:
        publish(self, [u for u in updates if getattr(u.value, "event", "") != "VehicleReleased"])

    patch.setattr(Control, "_publish", some)


def strange_place_believed(patch: pytest.MonkeyPatch) -> None:
    """Whatever barcode a vehicle reads, there it stands."""
    patch.setattr(Recovery, "_strange_place", lambda self, vehicle, status: None)


def door_closed_on_a_vehicle(patch: pytest.MonkeyPatch) -> None:
    """A door closes when nobody is on the way to it any more, whoever is in it."""
    patch.setattr(Passages, "engaged", lambda self, door: {})
    patch.setattr(doors, "NEEDED_FOR", Seconds(0.0), raising=False)


SMALL: dict[str, Mistake] = {
    f.__name__: f
    for f in (
        forgotten_reservation, cmd_ids_again, events_again, forgotten_intents, resent_after_restart, no_quiesce,
        early_release, released_when_silent, granted_twice, answered_before_commit, sent_before_commit, mode_ignored,
        silence_unnoticed, source_not_looked_at, destination_not_looked_at, order_taken_twice, audit_forgotten, event_skipped,
        strange_place_believed,
    )
}  # fmt: skip
HALL: dict[str, Mistake] = {f.__name__: f for f in (door_closed_on_a_vehicle,)}
