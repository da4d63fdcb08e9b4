"""Buffers: locked while they are served, and believed about what stands there (DOMAIN section 2, scenario S57)."""

from app.domain.device_requests import CommandDevice, LiftDeviceLockout, LockOutDevice, SetDeviceService
from app.domain.devices import BufferState, DeviceAct
from app.domain.ids import Actor, CarrierId, StationId
from app.domain.records import IntentState, Provenance
from app.domain.requests import HandleOnce, PauseController, ReleaseVehicle, ResumeController, Verdict, WriteStation
from tests.fleet.drives import KIM, go
from tests.fleet.hall import ToyHall
from tests.fleet.hall_plants import BUFFER1, ring
from tests.fleet.script import FOUP1, FOUP2, P1, P2, P3, V1, V2, Script

LEE = Actor("lee")


def begun(*, full: StationId | None = P1) -> tuple[Script, ToyHall]:
    """Return a fleet with its hall, all connected and settled; FOUP0001 at P1, or at the buffer's station P2."""
    script = Script(ring())
    assert script.hall is not None
    if full is not None:
        script.fill(full, FOUP1)
    script.obey()
    script.forget()
    return script, script.hall


def asked(script: Script) -> list[tuple[str, str]]:
    """Return what the buffer was asked in order, each with what came of it."""
    last = {i.cmd_id: i for i in script.kept_intents() if str(i.vehicle) == BUFFER1}
    return [(i.kind, i.state.value) for i in last.values()]


def locks(script: Script) -> tuple[str | None, bool | None]:
    record = script.fleet.devices.all[BUFFER1].record
    return record.lock.owner if record.lock else None, record.locked


# -- while it is served --------------------------------------------------------------------------------------------------


def test_a_buffer_is_locked_before_a_place_and_unlocked_after_it() -> None:
    script, hall = begun()
    script.order("P1", "P2", vehicle=V1)
    script.run_to("depositing")
    assert hall.buffer().locked
    assert locks(script) == (V1, True)
    kinds = [i.kind for i in script.kept_intents() if i.kind in {"lock", "place"} and i.state is IntentState.OPEN]
    assert kinds == ["lock", "place"]
    script.run_until()
    script.run(3)
    assert script.job("J1").state.value == "completed"
    assert not hall.buffer().locked
    assert asked(script) == [("lock", "done"), ("unlock", "done")]
    assert locks(script) == (None, False)


def test_the_place_is_not_sent_before_the_buffer_has_shown_the_lock() -> None:
    script, hall = begun()
    script.order("P1", "P2", vehicle=V1)
    script.run_to("to_destination")
    while script.job("J1").reason != "BUFFER1 is being locked for V001":
        assert script.job("J1").leg.value == "to_destination"
        script.run(0.25)
    assert hall.buffer().state is BufferState.BUSY
    assert all(intent.kind != "place" for intent in script.intents(V1))


def test_a_pick_up_from_a_buffer_is_locked_too() -> None:
    script, hall = begun(full=P2)
    script.order("P2", "P3", vehicle=V1)
    script.run_to("acquiring")
    assert hall.buffer().locked
    script.run_until()
    script.run(3)
    assert script.job("J1").state.value == "completed"
    assert asked(script) == [("lock", "done"), ("unlock", "done")]


def test_a_station_without_a_buffer_needs_no_lock() -> None:
    script, _ = begun()
    script.order("P1", "P3", vehicle=V1)
    script.run_until()
    assert asked(script) == []


def test_a_buffer_locked_for_a_person_makes_a_job_wait_until_it_is_unlocked() -> None:
    script, _ = begun()
    script.accept(CommandDevice(KIM, BUFFER1, DeviceAct.LOCK))
    script.run(3)
    assert locks(script) == ("kim", True)
    script.order("P1", "P2", vehicle=V1)
    script.run(40)
    assert script.job("J1").reason == "BUFFER1 is locked for kim"
    script.accept(CommandDevice(LEE, BUFFER1, DeviceAct.UNLOCK))
    script.run_until()
    assert script.job("J1").state.value == "completed"


def test_a_person_cannot_take_a_buffer_from_a_vehicle() -> None:
    script, _ = begun()
    script.order("P1", "P2", vehicle=V1)
    script.run_to("depositing")
    for act in (DeviceAct.LOCK, DeviceAct.UNLOCK):
        assert script.refuse(CommandDevice(KIM, BUFFER1, act)).reason == "BUFFER1 is locked for V001"


def test_a_one_shot_of_a_person_locks_the_buffer_too() -> None:
    script, hall = begun(full=P2)
    go(script, "109", action=ring().stations[1].kind.stop_action)
    script.run(30)
    reply = script.accept(HandleOnce(KIM, V1, P2, pickup=True))
    assert reply.cmd_id is None
    script.run(2)
    assert hall.buffer().locked
    script.run(8)
    assert script.toys[V1].aboard == FOUP1
    assert asked(script) == [("lock", "done"), ("unlock", "done")]


def test_a_one_shot_that_waits_for_the_buffer_does_not_begin_while_the_controller_is_paused() -> None:
    script, _ = begun(full=P2)
    go(script, "109", action=ring().stations[1].kind.stop_action)
    script.run(30)
    script.accept(HandleOnce(KIM, V1, P2, pickup=True))
    script.accept(PauseController(KIM, "shift change"))
    script.run(10)
    assert script.toys[V1].aboard is None
    script.accept(ResumeController(KIM))
    script.run(10)
    assert script.toys[V1].aboard == FOUP1


# -- restarts and ends ---------------------------------------------------------------------------------------------------


def test_a_restart_during_the_place_keeps_the_lock_until_it_is_settled_and_then_releases_it() -> None:
    script, hall = begun()
    script.order("P1", "P2", vehicle=V1)
    script.run_to("depositing")
    script.restart(0.5)
    assert locks(script) == (V1, True)
    hall.connect()
    script.run(4)
    assert hall.buffer().locked
    assert locks(script)[0] == V1
    script.obey(V1, V2)
    script.run_until()
    script.run(4)
    assert script.job("J1").state.value == "completed"
    assert locks(script) == (None, False)
    assert not hall.buffer().locked


def test_a_restart_while_the_lock_is_asked_for_asks_again() -> None:
    script, hall = begun()
    script.order("P1", "P2", vehicle=V1)
    while script.device(BUFFER1).pending != "lock":
        script.run(0.25)
    script.restart(0.1)
    script.obey()
    script.run_until()
    script.run(4)
    assert script.job("J1").state.value == "completed"
    assert ("lock", "settled_not_done") in asked(script)
    assert not hall.buffer().locked


def test_a_lock_kept_for_a_vehicle_that_is_taken_off_the_rail_is_released() -> None:
    script, hall = begun()
    script.order("P1", "P2", vehicle=V1)
    script.run_to("depositing")
    script.toys[V1].cut()
    script.run(5)
    assert locks(script) == (V1, True)
    script.accept(ReleaseVehicle(KIM, V1, Verdict.OFF_RAIL, "carried off"))
    script.run(3)
    assert locks(script) == (None, False)
    assert not hall.buffer().locked


def test_a_buffer_that_was_silent_while_locked_is_locked_again() -> None:
    script, hall = begun()
    script.accept(CommandDevice(KIM, BUFFER1, DeviceAct.LOCK))
    script.run(3)
    hall.buffer().power_off(script.now)
    script.run(8)
    hall.buffer().power_on(script.now)
    assert not hall.buffer().locked
    script.run(5)
    assert hall.buffer().locked
    assert locks(script) == ("kim", True)


# -- when it cannot be used ----------------------------------------------------------------------------------------------


def test_a_buffer_in_error_sends_a_loaded_vehicle_to_the_fall_back() -> None:
    script, hall = begun()
    script.order("P1", "P2", vehicle=V1)
    script.run_to("to_destination")
    hall.buffer().set_state(BufferState.ERROR, script.now)
    script.run_until()
    job = script.job("J1")
    assert (job.state.value, job.destination) == ("completed", P3)
    assert script.device(BUFFER1).alarm == "reports an error (255)"


def test_a_job_to_a_buffer_that_cannot_be_used_waits_and_says_why() -> None:
    script, hall = begun()
    script.accept(WriteStation(KIM, P3, present=True, by_person=True))
    hall.buffer().set_state(BufferState.ERROR, script.now)
    script.run(1)
    script.order("P1", "P2")
    script.run(2)
    assert script.job("J1").reason == "BUFFER1 reports error"
    hall.buffer().set_state(BufferState.NO_CART, script.now)
    script.run_until()
    assert script.job("J1").state.value == "completed"


def test_a_short_silence_of_a_buffer_sends_nobody_elsewhere_and_a_long_one_does() -> None:
    script, hall = begun()
    script.order("P1", "P2")
    script.run_to("to_destination")
    hall.cut()
    script.run(5)
    assert script.job("J1").destination == P2
    script.run(8)
    assert script.job("J1").destination == P3


def test_locked_out_or_out_of_service_a_buffer_is_not_used() -> None:
    script, _ = begun()
    script.accept(WriteStation(KIM, P3, present=True, by_person=True))
    script.accept(LockOutDevice(KIM, BUFFER1, "new belt"))
    script.order("P1", "P2")
    script.run(2)
    assert script.job("J1").reason == "BUFFER1 is locked out by kim: new belt"
    script.accept(LiftDeviceLockout(KIM, BUFFER1))
    script.accept(SetDeviceService(KIM, BUFFER1, "spare"))
    script.run(2)
    assert script.job("J1").reason == "BUFFER1 is out of service: spare"
    script.accept(SetDeviceService(KIM, BUFFER1, ""))
    script.run_until()


# -- what it reports -----------------------------------------------------------------------------------------------------


def test_what_a_buffer_reports_is_known_of_its_station_by_sensor() -> None:
    script, _ = begun(full=P2)
    station = script.station(P2)
    assert (station.present, station.provenance) == (True, Provenance.SENSOR)
    del script.world[P2]
    script.run(2)
    assert script.station(P2).present is False
    told = [(e.event, e.destination, e.detail) for e in script.history()]
    assert told == [("PortStateChanged", P2, "empty, reported by BUFFER1")]


def test_a_pick_up_from_a_buffer_that_reports_no_cart_waits_and_says_so() -> None:
    script, _ = begun(full=None)
    script.order("P2", "P3")
    script.run(3)
    assert script.job("J1").reason == "P2 is empty: its buffer reports no cart"
    script.fill(P2, FOUP2)
    script.run_until()
    assert script.job("J1").state.value == "completed"


def test_nothing_is_put_down_at_a_buffer_that_reports_a_cart_whatever_the_books_say() -> None:
    script, _ = begun(full=P1)
    script.accept(WriteStation(KIM, P3, present=True, by_person=True))
    script.fill(P2, FOUP2)
    script.run(2)
    script.accept(WriteStation(KIM, P2, present=False, by_person=True))
    script.run(2)
    script.order("P1", "P2")
    script.run(2)
    assert script.job("J1").reason == "P2 is occupied: its buffer reports a cart"
    assert script.device(BUFFER1).contradiction == "reports a cart, but person says that there is none at P2"


def test_a_carrier_believed_where_the_buffer_reports_no_cart_is_shown_and_not_lost() -> None:
    script, _ = begun(full=P2)
    script.accept(WriteStation(KIM, P2, carrier="FOUP0009", by_person=True))
    script.run(1)
    del script.world[P2]
    script.run(2)
    assert script.device(BUFFER1).alarm == "reports no cart, but FOUP0009 is believed at P2"
    assert script.station(P2).carrier == "FOUP0009"
    assert script.fleet.books.carriers[CarrierId("FOUP0009")].place == P2
    script.fill(P2, CarrierId("FOUP0009"))
    script.run(2)
    assert script.device(BUFFER1).alarm == ""


def test_what_a_buffer_shows_while_it_is_served_contradicts_nothing() -> None:
    script, _ = begun()
    script.order("P1", "P2", vehicle=V1, carrier=FOUP1)
    script.run_to("to_destination")
    script.run_until()
    script.run(4)
    assert not [e for e in script.history() if e.event == "AlarmSet"]
    assert script.station(P2).carrier == FOUP1
    assert script.station(P2).present is True
    assert script.station(P2).provenance is Provenance.SENSOR


def test_a_vehicle_held_at_a_buffer_keeps_its_lock() -> None:
    script, hall = begun()
    script.order("P1", "P2", vehicle=V1)
    script.run_to("depositing")
    script.toys[V1].stop_with(77)
    script.run(10)
    assert script.vehicle(V1).record.hold is not None
    assert hall.buffer().locked
