"""The life of a transfer job (DOMAIN section 2, COMMANDS section 4)."""

from tests.fleet.script import Script


def test_a_transfer_tells_the_events_of_e82_in_their_normal_order(ready: Script) -> None:
    ready.order("P1", "P3", vehicle="V001")
    ready.run_until("J1")
    assert ready.events("J1") == [
        "TransferInitiated",
        "VehicleAssigned",
        "VehicleDeparted",
        "VehicleArrived",
        "Transferring",
        "VehicleAcquireStarted",
        "CarrierInstalled",
        "VehicleAcquireCompleted",
        "VehicleDeparted",
        "VehicleArrived",
        "VehicleDepositStarted",
        "CarrierRemoved",
        "VehicleDepositCompleted",
        "VehicleUnassigned",
        "TransferCompleted",
    ]
