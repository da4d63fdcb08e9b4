"""AGVs charge by rules, at chargers reached by granted moves (DOMAIN section 7, COMMANDS section 1)."""

from app.domain.device_requests import LiftDeviceLockout, LockOutDevice, SetDeviceService
from app.domain.devices import AgvCharge, DeviceId
from app.domain.errors import Refusal
from app.domain.job import JobState
from app.domain.layout import ChargingRules, Plant
from app.domain.requests import CommandAgv
from app.domain.units import Seconds
from app.domain.view import DeviceView, VehicleView
from tests.agv.hall import A1, A2, ANNA, HallWorld, hall, tag


def charging_hall(rules: ChargingRules, *, starts: tuple[int, ...] = (3,), chargers: tuple[int, ...] = (8,)) -> Plant:
    """Return a ring 1-2-3-4-5-6 with two buffers, and spurs with a charger and a waiting place."""
    return hall(
        one_way=["1-2-3-4-5-6-1"],
        two_way=["2-8", "4-9", "6-10"],
        stations=[1, 5],
        starts=starts,
        carts=1,
        chargers=chargers,
        parks=[9],
        rules=rules,
    )


def charges(world: HallWorld, view: VehicleView) -> bool:
    return view.agv is not None and view.agv.charging


def test_after_so_many_trips_an_agv_goes_to_charge_and_stays() -> None:
    world = HallWorld(charging_hall(ChargingRules(trips=1, lasting=Seconds(60.0))))
    world.ready()
    world.pass_by(30.0)
    assert not charges(world, world.view())
    world.order("B1", "B5")
    assert world.ends() is JobState.COMPLETED
    world.until(lambda: charges(world, world.view()))
    assert world.view().activity == "charging"
    assert world.view().barcode == tag(8)
    began = world.now
    world.order("B5", "B1", "J2")
    world.pass_by(30.0)
    assert charges(world, world.view()), "it stays for its time"
    assert world.control.fleet.books.jobs["J2"].reason == "no vehicle is free"  # type: ignore[index]
    assert world.ends("J2") is JobState.COMPLETED
    assert world.now >= began + 60.0
    assert world.result().violations == ()


def test_after_so_much_time_an_idle_agv_charges() -> None:
    world = HallWorld(charging_hall(ChargingRules(after=Seconds(40.0), lasting=Seconds(20.0))))
    world.ready()
    world.until(lambda: charges(world, world.view()), 100.0)
    assert world.now > 40.0


def test_in_a_window_idle_agvs_charge_whatever_they_did() -> None:
    world = HallWorld(charging_hall(ChargingRules(windows=((0, 10),), lasting=Seconds(10.0))))
    world.ready()
    world.until(lambda: charges(world, world.view()), 100.0)


def test_charging_survives_a_restart_and_ends_before_the_agv_drives() -> None:
    world = HallWorld(charging_hall(ChargingRules(trips=1, lasting=Seconds(30.0))))
    world.ready()
    world.order("B1", "B5")
    world.until(lambda: charges(world, world.view()))
    world.kill()
    world.until(lambda: world.alive)
    world.ready()
    world.until(lambda: world.view().activity == "charging", 1.0)
    world.order("B5", "B1", "J2")
    assert world.ends("J2") is JobState.COMPLETED
    assert world.result().violations == ()


def test_two_agvs_take_turns_at_one_charger() -> None:
    rules = ChargingRules(after=Seconds(60.0), lasting=Seconds(30.0))
    world = HallWorld(charging_hall(rules, starts=(3, 5)))
    world.ready(A1, A2)
    first, second = (A1, A2)
    world.until(lambda: charges(world, world.view(A1)) or charges(world, world.view(A2)), 200.0)
    if charges(world, world.view(A2)):
        first, second = A2, A1
    world.until(lambda: charges(world, world.view(second)), 300.0)
    assert not charges(world, world.view(first))
    assert world.result().violations == ()


def users(world: HallWorld) -> tuple[str, ...]:
    """Return who is shown at the charger."""
    views = [update.value for update in world.control.snapshot() if update.key == "CH1"]
    (view,) = [view for view in views if isinstance(view, DeviceView)]
    return view.vehicles


def test_a_charger_shows_who_charges_there_or_comes_to_it() -> None:
    world = HallWorld(charging_hall(ChargingRules(after=Seconds(40.0), lasting=Seconds(20.0))))
    world.ready()
    assert users(world) == ()
    world.until(lambda: users(world) == (A1,), 100.0)
    assert not charges(world, world.view())
    world.until(lambda: charges(world, world.view()), 100.0)
    assert users(world) == (A1,)
    world.order("B1", "B5")
    world.until(lambda: users(world) == (), 100.0)


def test_a_charger_out_of_service_is_not_used() -> None:
    world = HallWorld(charging_hall(ChargingRules(after=Seconds(40.0), lasting=Seconds(20.0))))
    world.ready()
    world.reply(SetDeviceService(ANNA, DeviceId("CH1"), "no power"))
    world.pass_by(120.0)
    assert not charges(world, world.view())
    world.reply(SetDeviceService(ANNA, DeviceId("CH1"), ""))
    world.until(lambda: charges(world, world.view()), 100.0)


def test_an_agv_that_only_waits_at_a_charger_makes_room() -> None:
    rules = ChargingRules(trips=1, lasting=Seconds(30.0))
    world = HallWorld(charging_hall(rules, starts=(8, 3)))
    world.ready(A1, A2)
    world.order("B1", "B5", vehicle="A2")
    world.until(lambda: charges(world, world.view(A2)), 300.0)
    assert world.view(A2).barcode == tag(8)
    assert world.result().violations == ()


def test_without_a_charger_nobody_is_kept_waiting() -> None:
    world = HallWorld(charging_hall(ChargingRules(trips=1), chargers=()))
    world.ready()
    world.order("B1", "B5")
    assert world.ends() is JobState.COMPLETED
    world.order("B5", "B1", "J2")
    assert world.ends("J2") is JobState.COMPLETED


def test_at_a_charger_that_is_locked_out_nobody_charges() -> None:
    world = HallWorld(charging_hall(ChargingRules(windows=((0, 1440),))))
    world.ready()
    world.until(lambda: world.view().barcode == tag(2))
    world.reply(LockOutDevice(ANNA, DeviceId("CH1"), "contacts"))
    world.until(lambda: world.view().barcode == tag(8) and world.now_of().in_position)
    world.pass_by(1.0)
    answer = world.reply(CommandAgv(ANNA, A1, AgvCharge(on=True)))
    assert isinstance(answer, Refusal)
    assert answer.reason == "CH1 is locked out by anna: contacts"
    world.pass_by(40.0)
    assert not charges(world, world.view())
    world.reply(LiftDeviceLockout(ANNA, DeviceId("CH1")))
    world.until(lambda: charges(world, world.view()))
