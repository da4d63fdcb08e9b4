"""A database that is a backup put back: nothing it says of the plant is believed (COMMANDS section 3.8)."""

from app.domain.ids import Actor
from app.domain.requests import ReleaseVehicle, Verdict
from app.fleet.vehicle import Stage
from tests.fleet.script import V1, V2, Script, transfer

KIM = Actor("kim")


def test_after_a_restored_backup_every_vehicle_is_held_and_jobs_are_still_accepted(ready: Script) -> None:
    ready.restart(restored=True)
    ready.obey()
    ready.accept(transfer())
    ready.run(30)
    for name in (V1, V2):
        hold = ready.vehicle(name).record.hold
        assert hold is not None
        assert "restored backup" in hold.reason
        assert "go_on" in hold.remedy
        assert ready.vehicle(name).stage is not Stage.READY
    assert ready.job("J1").state.value == "queued"
    assert not ready.sends


def test_vehicles_that_a_person_vouched_for_go_on_after_a_restored_backup(ready: Script) -> None:
    ready.restart(restored=True)
    ready.obey()
    ready.accept(transfer())
    for name in (V1, V2):
        ready.accept(ReleaseVehicle(KIM, name, Verdict.GO_ON, "compared with the plant"))
    ready.run_until("J1")
    assert ready.job("J1").state.value == "completed"


def test_the_holds_of_a_restored_backup_outlive_the_next_start(ready: Script) -> None:
    ready.restart(restored=True)
    ready.restart()
    ready.obey()
    ready.run(30)
    assert all(ready.vehicle(name).record.hold for name in (V1, V2))
