"""What the controller says to each thing a person may ask on the page, in many situations: ``tests/against.json``.

The page (web/src/against.ts) disables a button that the controller would refuse, and says why. It has that from the views
alone, so what it says is compared with what the real fleet answers: web/test/against.cases.test.ts reads the file, and
tests/test_against.py makes it anew. ``python -m tests.against`` writes it after a change of the orders.
"""

import json
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, replace
from itertools import combinations
from pathlib import Path
from typing import TypeVar

from app.control.agv_words import condition_of
from app.domain.closures import ClosedPlace, ClosePlace, ClosurePurpose, PlaceKind
from app.domain.commands import Plain
from app.domain.device_requests import CommandDevice, LockOutDevice, PinDoor, RaiseEmergency
from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMode,
    AgvMoveAlias,
    AgvMoveAuto,
    AgvMoveManual,
    AgvRun,
    AgvSetCurrent,
    AgvSpeed,
    AgvStatus,
    AliasName,
    CartState,
    DeviceAct,
    LiftAction,
    LiftState,
    ManualDirection,
    Steering,
)
from app.domain.drive import (
    DriveEvent,
    DriveLineDown,
    DriveLineId,
    DriveLineUp,
    DriveMode,
    DriveOffline,
    DriveOnline,
    DriveReported,
    DriveStatus,
    Hundredths,
    Key,
    Parameter,
    RawValue,
    SetInputs,
    Turn,
)
from app.domain.drive_requests import (
    AskDriveStatus,
    BackUpDrive,
    JogDrive,
    LockDrive,
    PressDriveKey,
    ReadDrive,
    RestoreDrive,
    SetDriveInputs,
    WriteDrive,
)
from app.domain.errors import Refusal
from app.domain.ids import Actor, VehicleId
from app.domain.layout import OnEmergency, Plant, StopAction
from app.domain.records import DoorPosition, EmergencyKind
from app.domain.requests import (
    CommandAgv,
    CommandVehicle,
    DisplayOnVehicle,
    HandleOnce,
    HoldVehicle,
    LockVehicle,
    MoveVehicle,
    ParkVehicle,
    PauseController,
    RecoverAlarm,
    ReleaseVehicle,
    Reply,
    Request,
    SetService,
    Verdict,
)
from app.domain.units import Barcode
from app.domain.vehicle import Condition
from app.domain.view import Topic
from tests.agv.hall import A1, A2, hall, tag
from tests.control.drive_bench import D1, D2, drive_plant
from tests.fleet.hall_plants import BUFFER1, DOOR1, ring
from tests.fleet.script import FOUP1, P1, P3, V1, V2, Script, transfer

FILE = Path(__file__).parent / "against.json"
KIM, LEE = Actor("kim"), Actor("lee")

WORDS = (
    (r" is locked out by ", "against_lockout"),
    (r" is on hold: ", "against_hold"),
    (r" is off the rail: ", "against_off_rail"),
    (r" is out of service: ", "against_service"),
    (r" stands where .* is closed for people", "against_work"),
    (r"^nothing moves: ", "against_emergency"),
    (r"^line \S+ of \S+ is not connected: ", "against_line"),
    (r" is connected and reports", "against_linked"),
    (r" is not connected: ", "against_link"),
    (r"^an alarm recovery of \S+ is under way", "against_recovery"),
    (r"and \w+ needs MANT$", "against_not_mant"),
    (r" is in MANT: \w+ needs AUTO or SEMI", "against_mant"),
    (r" is on job ", "against_job"),
    (r" is not in AUTO$", "against_not_auto"),
    (r" (still )?has an alarm$| is in error$", "against_alarm"),
    (r" is being asked where it is$", "against_settling"),
    (r"^the roll-call still misses ", "against_roll_call"),
    (r" is not stopped at \S+ \(barcode (\S+)\) but at (?!\1)", "against_elsewhere"),
    (r" is loaded$", "against_loaded"),
    (r" is empty$", "against_empty"),
    (r" reports no error to reset$", "against_no_error"),
    (r" stands$", "against_stands"),
    (r" is in auto$", "against_agv_auto"),
    (r" is in manual$", "against_agv_manual"),
    (r" does not stand still$", "against_runs"),
    (r" stands at no charger: ", "against_no_charger"),
    (r" is not on hold$", "against_nothing_held"),
    (r" is silent: ", "against_silent"),
    (r" is locked for ", "against_locked_for"),
    (r" is kept (open|closed) by ", "against_pin"),
    (r" cannot close: ", "against_engaged"),
    (r" is offline: ", "against_offline"),
    (r"^\S+ is at \S+: ", "against_operation"),
    (r" is running\b", "against_drive_runs"),
    (r" is in error \d\d ", "against_drive_error"),
    (r", not in jog$", "against_not_jog"),
)
"""How the page says what a refusal says, by the sentence; the first that fits. Other refusals the page cannot foresee."""

S = TypeVar("S")
Case = dict[str, object]


def word_of(refusal: Refusal) -> str:
    """Return the page's word for a refusal; ``!`` and the sentence where it has none."""
    return next((word for pattern, word in WORDS if re.search(pattern, refusal.reason)), f"!{refusal.reason}")


def refused(
    make: Callable[[], S], ask: Callable[[S, Request], Reply], requests: Mapping[str, Request]
) -> dict[str, str]:
    """Return which requests are refused in a situation, and by which word; it is made anew after one that is accepted."""
    said, world = {}, make()
    for name, request in requests.items():
        reply = ask(world, request)
        if isinstance(reply, Refusal):
            said[name] = word_of(reply)
        else:
            world = make()
    return said


def only(view: object, *names: str) -> dict[str, object]:
    """Return what the page looks at of a view."""
    whole = asdict(view)  # type: ignore[call-overload]
    return {name: whole[name] for name in names}


def up_to_two(
    features: Sequence[str], *, but: Iterable[frozenset[str]] = (), alone: frozenset[str] = frozenset()
) -> Iterator[tuple[str, ...]]:
    """Give nothing, each feature, and each two of them, but those that exclude each other and those that come alone."""
    excluded = [*but]
    for count in range(3):
        for chosen in combinations(features, count):
            together = count > 1 and bool(alone & {*chosen})
            if not together and not any(len(one & {*chosen}) > 1 for one in excluded):
                yield chosen


# -- hoists ---------------------------------------------------------------------------------------------------------------

AT = Barcode("104")
"""Where the hoist of the situations stands: before P1, the port with a FOUP."""
PLAIN_HOIST = (
    "status",
    "stop_by_host",
    "stop",
    "auto",
    "alarm_clear",
    "servo_on",
    "servo_off",
    "search_home",
    "go_home",
)
OF_VEHICLE = (
    "id",
    "activity",
    "service",
    "mode",
    "oper",
    "loaded",
    "barcode",
    "job",
    "granted",
    "covered",
    "hold",
    "lockout",
)
BEFORE_IT_CONNECTS = ("mant", "semi", "alarm", "loaded", "work", "work on the edge", "alone", "unheard", "silent")
HOIST = (
    *BEFORE_IT_CONNECTS,
    "traffic closed",
    "work draining",
    "port closed",
    "job",
    "drives",
    "handles",
    "asked anew",
    "recovers",
    "out of service",
    "hold",
    "lockout",
    "fire",
    "paused",
    "cut",
    "off the rail",
)
ALONE = frozenset({"unheard", "traffic closed", "work draining", "port closed", "paused"})
EXCLUDED = (
    frozenset({"mant", "semi", "alarm"}),
    frozenset({"unheard", "silent", "cut", "off the rail", "asked anew"}),
    frozenset({"work", "silent"}),
    frozenset({"work on the edge", "silent"}),
    frozenset({"work", "work on the edge"}),
    frozenset({"job", "drives", "handles"}),
)


def closes(kind: PlaceKind, *names: str, people: bool = True) -> ClosePlace:
    purpose = ClosurePurpose.WORK if people else ClosurePurpose.TRAFFIC
    return ClosePlace(LEE, ClosedPlace(kind, names), "a loose screw", purpose)


def hoist(features: Sequence[str]) -> Script:
    """Return the small plant with V001 at P1 and as the features say, each brought about by what would bring it about."""
    script = Script()
    script.fill(P1, FOUP1)
    toy = script.toys[V1]
    toy.barcode, toy.trav = AT, 1
    toy.mode = 0 if "mant" in features else 1 if "semi" in features else 3
    toy.alarm = 0x31 if "alarm" in features else 0
    toy.aboard = "FOUP0009" if "loaded" in features else None
    if "alone" not in features:
        script.obey(V2)
    if "work" in features or "work on the edge" in features:  # people come while it is away
        script.accept(ReleaseVehicle(KIM, V1, Verdict.OFF_RAIL, "repair"))
        edge = "work on the edge" in features
        place = closes(PlaceKind.EDGE, "103", "104") if edge else closes(PlaceKind.STRETCH, "103", "105")
        script.accept(place)
        script.run(2)
    if "silent" in features:
        script.link_up(V1)
    elif "unheard" not in features:
        script.obey(V1)
        script.ask(ReleaseVehicle(KIM, V1, Verdict.GO_ON, "seen"))  # it was away, or carries what nobody knows
        script.run(3)
    for name in features:
        if name not in BEFORE_IT_CONNECTS:
            DONE_TO_HOIST[name](script)
    script.wait(0.25)
    return script


def _asked_anew(script: Script) -> None:
    script.toys[V1].cut()
    script.link_up(V1)


def _off_rail(script: Script) -> None:
    script.toys[V1].cut()
    script.ask(ReleaseVehicle(KIM, V1, Verdict.OFF_RAIL, "repair"))


def _job(script: Script) -> None:
    script.ask(transfer("P1", "P3", vehicle=V1))
    script.run(0.25)


def _drives(script: Script) -> None:
    script.ask(MoveVehicle(KIM, V1, Barcode("110"), StopAction.STOP))
    script.run(1)


DONE_TO_HOIST: Mapping[str, Callable[[Script], object]] = {
    "traffic closed": lambda s: s.ask(closes(PlaceKind.STRETCH, "103", "105", people=False)),
    "work draining": lambda s: s.ask(closes(PlaceKind.STRETCH, "103", "105")),
    "port closed": lambda s: s.ask(closes(PlaceKind.STATION, "P1")),
    "job": _job,
    "drives": _drives,
    "handles": lambda s: s.ask(HandleOnce(KIM, V1, P1, pickup=True)),
    "asked anew": _asked_anew,
    "recovers": lambda s: s.ask(RecoverAlarm(KIM, V1, confirmed=True)),
    "out of service": lambda s: s.ask(SetService(KIM, V1, "spare")),
    "hold": lambda s: s.ask(HoldVehicle(KIM, V1, "noise")),
    "lockout": lambda s: s.ask(LockVehicle(KIM, V1, "a wheel")),
    "fire": lambda s: s.ask(RaiseEmergency(LEE, EmergencyKind.FIRE, "smoke")),
    "paused": lambda s: s.ask(PauseController(LEE, "break")),
    "cut": lambda s: s.toys[V1].cut(),
    "off the rail": _off_rail,
}

ASKED_OF_HOIST: Mapping[str, Request] = {
    **{f"command {name}": CommandVehicle(KIM, V1, Plain(name)) for name in PLAIN_HOIST},
    "command system_reset": CommandVehicle(KIM, V1, Plain.SYSTEM_RESET),
    "command display": DisplayOnVehicle(KIM, V1, "HELLO"),
    "move": MoveVehicle(KIM, V1, Barcode("110"), StopAction.STOP),
    "move park": ParkVehicle(KIM, V1),
    "pickup P1": HandleOnce(KIM, V1, P1, pickup=True),
    "place P1": HandleOnce(KIM, V1, P1, pickup=False),
    "pickup P3": HandleOnce(KIM, V1, P3, pickup=True),
    "recover": RecoverAlarm(KIM, V1, confirmed=True),
    "verdict go_on": ReleaseVehicle(KIM, V1, Verdict.GO_ON, "seen"),
    "verdict off_rail": ReleaseVehicle(KIM, V1, Verdict.OFF_RAIL, "repair"),
    "verdict stands_at": ReleaseVehicle(KIM, V1, Verdict.STANDS_AT, "seen", AT),
}


def vehicle_case(features: Sequence[str], script: Script, name: VehicleId, said: Mapping[str, str]) -> Case:
    """Return a situation as the page sees it, and what each request comes to there."""
    view = script.model[Topic.VEHICLES][name]
    shown = only(view, *OF_VEHICLE)
    shown["link"] = {"up": script.vehicle(name).linked}
    others = {
        other: only(seen, "mode", "barcode") for other, seen in script.model[Topic.VEHICLES].items() if other != name
    }
    closures = script.model[Topic.CLOSURES].values()
    (controller,) = script.model[Topic.CONTROLLER].values()
    return {
        "features": [*features],
        "vehicle": shown,
        "others": others,
        "controller": only(controller, "emergencies", "waiting_for"),
        "closures": [only(c, "purpose", "state", "kind", "names", "barcodes", "place", "owner") for c in closures],
        "refused": said,
    }


def hoists() -> Iterator[Case]:
    """Give the situations of a hoist."""
    for features in up_to_two(HOIST, but=EXCLUDED, alone=ALONE):
        said = refused(lambda: hoist(features), Script.ask, ASKED_OF_HOIST)  # noqa: B023  (called at once)
        yield vehicle_case(features, hoist(features), V1, said)


# -- AGVs -----------------------------------------------------------------------------------------------------------------

AGV = (
    "manual",
    "runs",
    "in error",
    "at the charger",
    "cart aboard",
    "another",
    "another missing",
    "missing elsewhere",
    "job",
    "recovers",
    "hold",
    "out of service",
    "lockout",
    "fire",
    "cut",
)
AGV_EXCLUDED = (frozenset({"runs", "in error"}), frozenset({"another", "another missing", "missing elsewhere"}))
ASKED_OF_AGV: Mapping[str, Request] = {
    "agv stop": CommandVehicle(KIM, A1, Plain.STOP),
    "agv alarm_clear": CommandVehicle(KIM, A1, Plain.ALARM_CLEAR),
    "agv agv_mark_stop": CommandAgv(KIM, A1, DeviceAct.MARK_STOP),
    "agv agv_lift up": CommandAgv(KIM, A1, AgvLift(LiftAction.UP)),
    "agv agv_lift down": CommandAgv(KIM, A1, AgvLift(LiftAction.DOWN)),
    "agv agv_lift stop": CommandAgv(KIM, A1, AgvLift(LiftAction.STOP)),
    "agv agv_charge on": CommandAgv(KIM, A1, AgvCharge(on=True)),
    "agv agv_charge off": CommandAgv(KIM, A1, AgvCharge(on=False)),
    "agv agv_set_current": CommandAgv(KIM, A1, AgvSetCurrent(tag(2))),
    "agv agv_move_manual": CommandAgv(KIM, A1, AgvMoveManual(ManualDirection.FORWARD, AgvSpeed.SLOW)),
    "agv agv_move_auto": CommandAgv(
        KIM, A1, AgvMoveAuto(forward=True, steering=Steering.STRAIGHT, speed=AgvSpeed.SLOW)
    ),
    "agv agv_move_alias": CommandAgv(KIM, A1, AgvMoveAlias(AliasName("C1"))),
    "move": MoveVehicle(KIM, A1, tag(4), StopAction.STOP),
    "move park": ParkVehicle(KIM, A1),
    "recover": RecoverAlarm(KIM, A1),
}


def floor(features: Sequence[str] = ()) -> Plant:
    """Return a two-way line of tags with two chargers, and another floor; what AGVs say is played by hand."""
    ways = ["1-2-3-4-5", "11-12"]
    another = [1] if "another" in features or "another missing" in features else []
    elsewhere = [11] if "missing elsewhere" in features else []
    starts = [3, *another, *elsewhere]
    return replace(hall(two_way=ways, stations=[1, 5], starts=starts, carts=1, chargers=[3, 4]), links=())


def agv_says(features: Sequence[str]) -> Condition:
    run = AgvRun.RUN if "runs" in features else AgvRun.ERROR if "in error" in features else AgvRun.STOP
    return condition_of(
        AgvStatus(
            mode=AgvMode.MANUAL if "manual" in features else AgvMode.AUTO,
            run=run,
            steering=Steering.STRAIGHT,
            in_position=run is not AgvRun.RUN,
            charging=False,
            cart=CartState.PRESENT if "cart aboard" in features else CartState.NONE,
            lift=LiftState.DOWN,
            tag=agv_at(features),
            path=0,
        )
    )


def agv_at(features: Sequence[str]) -> Barcode:
    return tag(3) if "at the charger" in features else tag(2)


def agv(features: Sequence[str]) -> Script:
    """Return the floor with an AGV as the features say."""
    script = Script(floor(features))
    at = agv_at(features)
    if "another" in features:
        script.stand(A2, tag(1), agv_says(()))
    if "missing elsewhere" in features:  # it was known to be there before a restart
        script.stand(A2, tag(11), agv_says(()))
        script.restart()
    script.stand(A1, at, agv_says([f for f in features if f == "cart aboard"]))
    if "job" in features:
        script.ask(transfer("B1", "B5", vehicle=A1))
        script.wait(1)
    script.report(A1, at, agv_says(features))
    for name, done in DONE_TO_AGV.items():
        if name in features:
            done(script)
    script.wait(0.25)
    return script


DONE_TO_AGV: Mapping[str, Callable[[Script], object]] = {
    "recovers": lambda s: s.ask(RecoverAlarm(KIM, A1)),
    "hold": lambda s: s.ask(HoldVehicle(KIM, A1, "noise")),
    "out of service": lambda s: s.ask(SetService(KIM, A1, "spare")),
    "lockout": lambda s: s.ask(LockVehicle(KIM, A1, "a wheel")),
    "fire": lambda s: s.ask(RaiseEmergency(LEE, EmergencyKind.FIRE, "smoke")),
    "cut": lambda s: s.link_down(A1),
}


def agvs() -> Iterator[Case]:
    """Give the situations of an AGV."""
    for features in up_to_two(AGV, but=AGV_EXCLUDED):
        said = refused(lambda: agv(features), Script.ask, ASKED_OF_AGV)  # noqa: B023  (called at once)
        yield vehicle_case(features, agv(features), A1, said)


# -- doors and buffers ----------------------------------------------------------------------------------------------------

DEVICE = ("fire", "passes", "silent", "kept open", "kept closed", "lent", "locked by kim", "lockout")
DEVICE_EXCLUDED = (frozenset({"kept open", "kept closed"}), frozenset({"lent", "locked by kim"}))
ASKED_OF_DEVICES: Mapping[str, Request] = {
    "door open": CommandDevice(KIM, DOOR1, DeviceAct.OPEN),
    "door close": CommandDevice(KIM, DOOR1, DeviceAct.CLOSE),
    "pin open": PinDoor(KIM, DOOR1, DoorPosition.OPEN, "air"),
    "pin closed": PinDoor(KIM, DOOR1, DoorPosition.CLOSED, "draught"),
    "buffer lock": CommandDevice(KIM, BUFFER1, DeviceAct.LOCK),
    "buffer unlock": CommandDevice(KIM, BUFFER1, DeviceAct.UNLOCK),
}


def in_hall(features: Sequence[str]) -> Script:
    """Return the ring with its door and buffer as the features say."""
    script = Script(ring(on_emergency=OnEmergency.OPEN))
    script.fill(P1, FOUP1)
    script.obey()
    if "lent" in features:
        script.order("P1", "P2", vehicle=V1)
        for _ in range(400):
            if script.device(BUFFER1).lock:
                break
            script.run(0.25)
        assert script.device(BUFFER1).lock
    elif "passes" in features:
        script.accept(MoveVehicle(KIM, V1, Barcode("110"), StopAction.STOP))
        for _ in range(100):
            if script.device(DOOR1).vehicles:
                break
            script.run(0.25)
        assert script.device(DOOR1).vehicles
    for name, done in DONE_TO_DEVICE.items():
        if name in features:
            done(script)
    script.wait(0.25)
    return script


def _cut_hall(script: Script) -> None:
    assert script.hall
    script.hall.cut()


DONE_TO_DEVICE: Mapping[str, Callable[[Script], object]] = {
    "locked by kim": lambda s: s.ask(CommandDevice(KIM, BUFFER1, DeviceAct.LOCK)),
    "kept open": lambda s: s.ask(PinDoor(KIM, DOOR1, DoorPosition.OPEN, "air")),
    "kept closed": lambda s: s.ask(PinDoor(KIM, DOOR1, DoorPosition.CLOSED, "draught")),
    "silent": _cut_hall,
    "fire": lambda s: s.ask(RaiseEmergency(LEE, EmergencyKind.FIRE, "smoke")),
    "lockout": lambda s: [s.ask(LockOutDevice(KIM, device, "motor")) for device in (DOOR1, BUFFER1)],
}


def devices() -> Iterator[Case]:
    """Give the situations of a door and a buffer."""
    for features in up_to_two(DEVICE, but=DEVICE_EXCLUDED):
        said = refused(lambda: in_hall(features), Script.ask, ASKED_OF_DEVICES)  # noqa: B023  (called at once)
        script = in_hall(features)
        looks = ("fresh", "pin", "lock", "lockout", "vehicles")
        seen = {name: only(script.device(device), *looks) for name, device in (("door", DOOR1), ("buffer", BUFFER1))}
        yield {"features": [*features], **seen, "refused": said}


# -- drives ---------------------------------------------------------------------------------------------------------------

DRIVE = (
    "line down",
    "unheard",
    "offline",
    "error",
    "monitoring",
    "moves",
    "at work",
    "another jogs",
    "lockout",
    "fire",
)
DRIVE_EXCLUDED = (frozenset({"line down", "unheard", "offline"}), frozenset({"error", "monitoring"}))
ALL = tuple((Parameter(number), RawValue(0)) for number in range(4))
ASKED_OF_DRIVE: Mapping[str, Request] = {
    "harmless status": AskDriveStatus(KIM, D1),
    "harmless stop": PressDriveKey(KIM, D1, Key.STOP_RESET),
    "read": ReadDrive(KIM, D1, (Parameter(0x1C),)),
    "read backup": BackUpDrive(KIM, D1),
    "change": WriteDrive(KIM, D1, Parameter(0x1D), raw=RawValue(7)),
    "change dry": RestoreDrive(KIM, D1, "backup 1", "HI-1", ALL, dry_run=True),
    "change inputs": SetDriveInputs(KIM, D1, SetInputs()),
    "write": RestoreDrive(KIM, D1, "backup 1", "HI-1", ALL),
    "move": SetDriveInputs(KIM, D1, SetInputs(run=True)),
    "move key": PressDriveKey(KIM, D1, Key.RUN),
    "jog": JogDrive(KIM, D1, Turn.CW),
}


def tell_drive(script: Script, *events: DriveEvent) -> None:
    for event in events:
        script.hear_drive(event)
    script.wait(0.25)


def drive_says(mode: DriveMode, distance: int = 0) -> DriveStatus:
    return DriveStatus(mode, 0, 3 if mode is DriveMode.ERROR else 0, "", Turn.CW, Hundredths(distance))


def drives_of(features: Sequence[str]) -> Script:
    """Return the small plant with two drives on a line, the first of them as the features say."""
    script = Script(drive_plant())
    script.hall = None  # the line is played by hand
    line = DriveLineId(drive_plant().drives[0].link)
    if "unheard" not in features:
        mode = (
            DriveMode.ERROR
            if "error" in features
            else DriveMode.MONITORING
            if "monitoring" in features
            else DriveMode.JOG
        )
        tell_drive(script, DriveLineUp(line))
        for drive in (D1, D2):
            tell_drive(
                script, DriveOnline(drive), DriveReported(drive, drive_says(mode if drive == D1 else DriveMode.JOG))
            )
        if "moves" in features:
            tell_drive(script, DriveReported(D1, drive_says(mode, 40)))
    for name, done in DONE_TO_DRIVE.items():
        if name in features:
            done(script, line)
    script.wait(0.25)
    return script


DONE_TO_DRIVE: Mapping[str, Callable[[Script, DriveLineId], object]] = {
    "at work": lambda s, _: s.ask(WriteDrive(LEE, D1, Parameter(0x1D), raw=RawValue(7))),
    "another jogs": lambda s, _: s.ask(JogDrive(LEE, D2, Turn.CW)),
    "lockout": lambda s, _: s.ask(LockDrive(KIM, D1, "a belt")),
    "fire": lambda s, _: s.ask(RaiseEmergency(LEE, EmergencyKind.FIRE, "smoke")),
    "offline": lambda s, _: tell_drive(s, DriveOffline(D1, "no answer")),
    "line down": lambda s, line: tell_drive(s, DriveLineDown(line, "unplugged")),
}


def drives() -> Iterator[Case]:
    """Give the situations of an axis drive."""
    for features in up_to_two(DRIVE, but=DRIVE_EXCLUDED):
        said = refused(lambda: drives_of(features), Script.ask, ASKED_OF_DRIVE)  # noqa: B023  (called at once)
        script = drives_of(features)
        (controller,) = script.model[Topic.CONTROLLER].values()
        looks = ("line", "online", "reason", "mode", "moving", "operation", "lockout")
        shown = only(script.model[Topic.DRIVES][D1], *looks)
        told = only(controller, "emergencies")
        yield {"features": [*features], "drive": shown, "controller": told, "refused": said}


# -- the file -------------------------------------------------------------------------------------------------------------


def layout_of(plant: Plant) -> Case:
    """Return what the page looks at of a plant's layout."""
    return {
        "stations": [{"id": s.id, "barcode": s.barcode} for s in plant.stations],
        "chargers": [{"id": c.id, "barcode": c.barcode} for c in plant.chargers],
        "vehicles": [{"id": v.id, "kind": v.kind.value} for v in plant.vehicles],
        "edges": [{"start": e.start, "end": e.end} for e in plant.edges],
    }


def asked() -> dict[str, list[str]]:
    """Return what is asked in each situation, as the page's test tells it apart."""
    requests = {"hoists": ASKED_OF_HOIST, "agvs": ASKED_OF_AGV, "devices": ASKED_OF_DEVICES, "drives": ASKED_OF_DRIVE}
    return {name: [*those] for name, those in requests.items()}


def layouts() -> dict[str, Case]:
    """Return the layouts of the plants in which vehicles are asked."""
    return {"hoists": layout_of(Script().plant), "agvs": layout_of(floor(["missing elsewhere"]))}


def made() -> dict[str, object]:
    """Return all situations with what is refused in each."""
    return {
        "asked": asked(),
        "layouts": layouts(),
        "hoists": list(hoists()),
        "agvs": list(agvs()),
        "devices": list(devices()),
        "drives": list(drives()),
    }


def written(value: Mapping[str, object]) -> str:
    """Return it as the file has it: a line for each situation."""
    parts = []
    for name, what in value.items():
        if isinstance(what, list):
            lines = ",\n".join(json.dumps(case, ensure_ascii=False, sort_keys=True) for case in what)
            parts.append(f'"{name}": [\n{lines}\n]')
        else:
            parts.append(f'"{name}": {json.dumps(what, ensure_ascii=False, sort_keys=True)}')
    return "{\n" + ",\n".join(parts) + "\n}\n"


if __name__ == "__main__":
    FILE.write_text(written(made()), encoding="utf-8")
