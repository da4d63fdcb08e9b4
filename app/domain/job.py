"""Transfer jobs by SEMI E82 (DOMAIN section 2, COMMANDS section 4)."""

from dataclasses import dataclass, replace
from enum import StrEnum

from app.domain.ids import Actor, CarrierId, JobId, StationId, VehicleId
from app.domain.units import Timestamp


class JobState(StrEnum):
    """States of a transfer command; the last four are terminal."""

    QUEUED = "queued"
    WAITING = "waiting"
    TRANSFERRING = "transferring"
    PAUSED = "paused"
    CANCELLING = "cancelling"
    ABORTING = "aborting"
    COMPLETED = "completed"
    FAILED = "failed"
    CANCELLED = "cancelled"
    ABORTED = "aborted"

    @property
    def terminal(self) -> bool:
        """Whether a job in this state is over."""
        return self in TERMINAL


TERMINAL = frozenset({JobState.COMPLETED, JobState.FAILED, JobState.CANCELLED, JobState.ABORTED})


class JobStep(StrEnum):
    """What can happen to a job."""

    ASSIGNED = "assigned"
    UNASSIGNED = "unassigned"
    ACQUIRING = "acquiring"
    PAUSE = "pause"
    RESUME = "resume"
    COMPLETE = "complete"
    FAIL = "fail"
    CANCEL = "cancel"
    CANCEL_DONE = "cancel_done"
    CANCEL_FAILED = "cancel_failed"
    ABORT = "abort"
    ABORT_DONE = "abort_done"
    ABORT_FAILED = "abort_failed"


S, E = JobState, JobStep
JOB_STEPS: dict[tuple[JobState, JobStep], JobState] = {
    (S.QUEUED, E.ASSIGNED): S.WAITING,
    (S.WAITING, E.UNASSIGNED): S.QUEUED,
    (S.WAITING, E.ACQUIRING): S.TRANSFERRING,
    (S.QUEUED, E.CANCEL): S.CANCELLING,
    (S.WAITING, E.CANCEL): S.CANCELLING,
    (S.CANCELLING, E.CANCEL_DONE): S.CANCELLED,
    (S.CANCELLING, E.CANCEL_FAILED): S.TRANSFERRING,
    (S.TRANSFERRING, E.PAUSE): S.PAUSED,
    (S.PAUSED, E.RESUME): S.TRANSFERRING,
    (S.TRANSFERRING, E.COMPLETE): S.COMPLETED,
    (S.QUEUED, E.FAIL): S.FAILED,
    (S.WAITING, E.FAIL): S.FAILED,
    (S.TRANSFERRING, E.FAIL): S.FAILED,
    (S.PAUSED, E.FAIL): S.FAILED,
    (S.TRANSFERRING, E.ABORT): S.ABORTING,
    (S.PAUSED, E.ABORT): S.ABORTING,
    (S.ABORTING, E.ABORT_DONE): S.ABORTED,
    (S.ABORTING, E.ABORT_FAILED): S.TRANSFERRING,
    (S.ABORTING, E.COMPLETE): S.COMPLETED,
    (S.ABORTING, E.FAIL): S.FAILED,
    (S.CANCELLING, E.FAIL): S.FAILED,
}
"""The table of COMMANDS section 4. A pair that is not here cannot happen."""


class Leg(StrEnum):
    """How far the vehicle has come with its job; kept with the job, so that a restart knows."""

    NONE = "none"
    TO_SOURCE = "to_source"
    ACQUIRING = "acquiring"
    TO_DESTINATION = "to_destination"
    DEPOSITING = "depositing"


class JobEvent(StrEnum):
    """E82 event names, with those of our own that hosts and operators want (the last group)."""

    TRANSFER_INITIATED = "TransferInitiated"
    VEHICLE_ASSIGNED = "VehicleAssigned"
    VEHICLE_DEPARTED = "VehicleDeparted"
    VEHICLE_ARRIVED = "VehicleArrived"
    TRANSFERRING = "Transferring"
    VEHICLE_ACQUIRE_STARTED = "VehicleAcquireStarted"
    CARRIER_INSTALLED = "CarrierInstalled"
    VEHICLE_ACQUIRE_COMPLETED = "VehicleAcquireCompleted"
    VEHICLE_DEPOSIT_STARTED = "VehicleDepositStarted"
    CARRIER_REMOVED = "CarrierRemoved"
    VEHICLE_DEPOSIT_COMPLETED = "VehicleDepositCompleted"
    VEHICLE_UNASSIGNED = "VehicleUnassigned"
    TRANSFER_COMPLETED = "TransferCompleted"
    TRANSFER_CANCEL_INITIATED = "TransferCancelInitiated"
    TRANSFER_CANCEL_COMPLETED = "TransferCancelCompleted"
    TRANSFER_CANCEL_FAILED = "TransferCancelFailed"
    TRANSFER_ABORT_INITIATED = "TransferAbortInitiated"
    TRANSFER_ABORT_COMPLETED = "TransferAbortCompleted"
    TRANSFER_ABORT_FAILED = "TransferAbortFailed"
    TRANSFER_PAUSED = "TransferPaused"
    TRANSFER_RESUMED = "TransferResumed"
    TRANSFER_UPDATED = "TransferUpdated"
    VEHICLE_BROKEN_DOWN = "VehicleBrokenDown"
    VEHICLE_MENDED = "VehicleMended"
    VEHICLE_HELD = "VehicleHeld"
    VEHICLE_RELEASED = "VehicleReleased"
    VEHICLE_INSTALLED = "VehicleInstalled"
    VEHICLE_REMOVED = "VehicleRemoved"
    ALARM_SET = "AlarmSet"
    ALARM_CLEARED = "AlarmCleared"
    CONTROLLER_AUTO = "ControllerAuto"
    CONTROLLER_PAUSING = "ControllerPausing"
    CONTROLLER_PAUSED = "ControllerPaused"
    PORT_CHANGED = "PortStateChanged"
    CARRIER_MOVED = "CarrierLocationChanged"
    DRIVE_OFFLINE = "DriveOffline"
    DRIVE_ONLINE = "DriveOnline"
    DRIVE_ERROR_SET = "DriveErrorSet"
    DRIVE_ERROR_CLEARED = "DriveErrorCleared"
    DRIVE_WRITTEN = "DriveParameterWritten"
    TEACHING_OPENED = "TeachingSessionOpened"
    TEACHING_ENDED = "TeachingSessionEnded"
    TEACHING_TAKEN = "TeachingTaken"
    TEACHING_APPROVED = "TeachingApproved"
    TEACHING_REJECTED = "TeachingRejected"
    TEACHING_ROLLED_BACK = "TeachingRolledBack"
    TEACHING_IMPORTED = "TeachingImported"
    TEACHING_UNKNOWN = "TeachingCodeUnknown"
    DEVICE_CHANGED = "DeviceChanged"
    EMERGENCY_SET = "EmergencySet"
    EMERGENCY_RELEASED = "EmergencyReleased"
    PLACE_CLOSING = "PlaceClosing"
    PLACE_CLOSED = "PlaceClosed"
    PLACE_OPENED = "PlaceOpened"
    ZONE_PAUSED = "ZonePaused"
    ZONE_RESUMED = "ZoneResumed"
    WALK_STARTED = "WalkStarted"
    WALK_ENDED = "WalkEnded"


HOT_FROM = 90
"""Jobs of this priority and above, of 0 to 99, are hot lots: they come before all others (our choice)."""


@dataclass(frozen=True, slots=True)
class Job:
    """One transfer order.

    ``source`` is a station, or a vehicle that has the carrier aboard (COMMANDS section 4). ``order`` is the durable
    sequence number of acceptance. ``fingerprint`` is a digest of the body as first accepted (COMMANDS section 5).
    ``reason`` says in one sentence why the job is not going on, empty while it is. ``result`` is set at the end.
    ``wish`` pins a vehicle. ``fallbacks`` are stations to use if the destination cannot be.
    """

    id: JobId
    order: int
    carrier: CarrierId | None
    source: StationId | VehicleId
    destination: StationId
    priority: int
    created: Timestamp
    actor: Actor
    fingerprint: str
    idempotency_key: str | None = None
    state: JobState = JobState.QUEUED
    leg: Leg = Leg.NONE
    vehicle: VehicleId | None = None
    wish: VehicleId | None = None
    fallbacks: tuple[StationId, ...] = ()
    reason: str = ""
    result: str = ""
    assigned: Timestamp | None = None
    picked: Timestamp | None = None
    ended: Timestamp | None = None

    @property
    def hot(self) -> bool:
        """Whether it is a hot lot."""
        return self.priority >= HOT_FROM

    def after(self, step: JobStep) -> "Job":
        """Return the job after this step. Raises KeyError for a step that the table does not have: a defect."""
        return replace(self, state=JOB_STEPS[self.state, step])

    def allows(self, step: JobStep) -> bool:
        """Whether the table has this step for the present state."""
        return (self.state, step) in JOB_STEPS
