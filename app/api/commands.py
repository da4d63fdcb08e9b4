"""The table of commands that can be given over the live stream."""

from collections.abc import Awaitable, Callable
from typing import Any

from starlette.responses import Response

from app.api import (
    alarms,
    closures,
    devices,
    drive_backups,
    drive_jog,
    drive_parameters,
    drives,
    emergency,
    jobs,
    links,
    operations,
    plant,
    stations,
    vehicles,
    walks,
    zones,
)
from app.api import drive_inputs as di
from app.api.calls import answer_of, told
from app.api.closure_inputs import ClosureIn, OpenIn
from app.api.device_inputs import DeviceCommandIn, EmergencyIn, PinIn
from app.api.inputs import JobChange, ReasonIn, RecoverIn, ReleaseIn, ServiceIn
from app.api.spoken import Command, Said, Table, route
from app.api.vehicle_commands import CommandIn
from app.domain import drive_requests as r
from app.domain.drive import DriveId


async def _write(said: Said) -> Response:
    body: di.NamedWriteIn = said.body
    asked = drive_parameters.written(said.actor, said.target, body.parameter, body)
    return await operations.taken(said.controller, asked, 0.0)


async def _jog(said: Said) -> Response:
    """Begin to jog; the jog is the watcher's: it is let go when the watcher goes."""
    return await drive_jog.begun(
        said.controller,
        r.JogDrive(said.actor, DriveId(said.target), said.body.turn()),
        lambda jog: said.speaker.until_gone(f"jog {jog}", r.ReleaseDriveJog(jog)),
    )


async def _keep(said: Said) -> Response:
    drive_jog.keep(said.controller, said.target, said.body.jog)
    return answer_of({"drive": said.target, "jog": str(said.body.jog)})


async def _release(said: Said) -> Response:
    said.speaker.letting_go.pop(f"jog {said.body.jog}", None)
    told(said.controller, r.ReleaseDriveJog(said.body.jog))
    return answer_of({"drive": said.target, "jog": str(said.body.jog)})


async def _watch(said: Said) -> Response:
    """Watch parameters of a drive for as long as the watcher stays."""
    name = f"{said.speaker.name}/{said.target}"
    numbers = said.body.numbers()
    told(said.controller, r.WatchDrive(name, DriveId(said.target), numbers))
    said.speaker.until_gone(f"watch {said.target}", r.UnwatchDrive(name))
    return answer_of({"drive": said.target, "parameters": [f"{number:02X}" for number in numbers]})


async def _unwatch(said: Said) -> Response:
    told(said.controller, r.UnwatchDrive(f"{said.speaker.name}/{said.target}"))
    said.speaker.letting_go.pop(f"watch {said.target}", None)
    return answer_of({"drive": said.target, "parameters": []})


def _of_controller(call: Callable[..., Awaitable[Response]], body: Any = None, *, person: bool = False) -> Command:
    """A command about the controller as a whole, which has no target."""

    async def carry_out(said: Said) -> Response:
        given = () if body is None else (said.body,)
        return await call(*given, controller=said.controller, actor=said.actor)

    return Command(body, carry_out, person, aimed=False)


def numbered(call: Callable[..., Awaitable[Response]], body: Any) -> Command:
    """A named person's command about a walk, whose target is its number."""

    async def carry_out(said: Said) -> Response:
        number = walks.number_of(said.target)
        return await call(number, said.body, controller=said.controller, actor=said.actor)

    return Command(body, carry_out, person=True)


COMMANDS: Table = {
    "controller.pause": _of_controller(plant.pause, ReasonIn),
    "controller.stop": _of_controller(plant.stop_all, ReasonIn),
    "controller.resume": _of_controller(plant.resume),
    "controller.emergency": _of_controller(emergency.raise_emergency, EmergencyIn, person=True),
    "controller.emergency.release": _of_controller(emergency.release_emergency, EmergencyIn, person=True),
    "alarm.acknowledge": route(alarms.acknowledge_named, alarms.NoteIn, person=True),
    "walk.start": _of_controller(walks.start_walk, walks.WalkIn, person=True),
    "walk.enter": numbered(walks.enter_sights, walks.SightsIn),
    "walk.accept": numbered(walks.accept_walk, walks.AcceptIn),
    "walk.abandon": numbered(walks.abandon_walk, walks.AbandonIn),
    "closure.close": _of_controller(closures.close_place, ClosureIn, person=True),
    "closure.open": route(closures.open_named, OpenIn, person=True),
    "zone.pause": route(zones.pause_zone, ReasonIn),
    "zone.stop": route(zones.stop_zone, ReasonIn),
    "zone.resume": route(zones.resume_zone),
    "job.cancel": route(jobs.cancel_job),
    "job.abort": route(jobs.abort_job),
    "job.change": route(jobs.change_job, JobChange),
    "vehicle.command": route(vehicles.command_vehicle, CommandIn),
    "vehicle.recover": route(vehicles.recover_vehicle, RecoverIn),
    "vehicle.park": route(vehicles.park_vehicle),
    "station.stage": route(stations.stage_vehicle, stations.StageIn),
    "vehicle.hold": route(vehicles.hold_vehicle, ReasonIn),
    "vehicle.release": route(vehicles.release_vehicle, ReleaseIn, person=True),
    "vehicle.lockout": route(vehicles.lock_vehicle, ReasonIn, person=True),
    "vehicle.unlock": route(vehicles.unlock_vehicle, person=True),
    "vehicle.service": route(vehicles.set_service, ServiceIn),
    "device.command": route(devices.command_device, DeviceCommandIn),
    "device.pin": route(devices.pin_door, PinIn, person=True),
    "device.unpin": route(devices.unpin_door, person=True),
    "device.lockout": route(devices.lock_out_device, ReasonIn, person=True),
    "device.unlock": route(devices.lift_device_lockout, person=True),
    "device.service": route(devices.set_device_service, ServiceIn),
    "drive.status": route(drives.ask_drive),
    "drive.key": route(drives.press_key, di.KeyIn),
    "drive.inputs": route(drives.set_inputs, di.InputsIn),
    "drive.lockout": route(drives.lock_drive, ReasonIn, person=True),
    "drive.unlock": route(drives.unlock_drive, person=True),
    "drive.read": Command(
        di.ReadIn,
        lambda said: operations.taken(
            said.controller, r.ReadDrive(said.actor, DriveId(said.target), said.body.numbers()), 0.0
        ),
    ),
    "drive.write": Command(di.NamedWriteIn, _write),
    "drive.backup": Command(
        di.BackupIn,
        lambda said: operations.taken(
            said.controller, r.BackUpDrive(said.actor, DriveId(said.target), said.body.note), 0.0
        ),
    ),
    "drive.compare": route(drive_backups.compare_drive, di.CompareIn),
    "drive.restore": route(drive_backups.restore_drive, di.RestoreIn),
    "drive.jog": Command(di.JogIn, _jog),
    "drive.jog.keep": Command(di.JogHeld, _keep),
    "drive.jog.release": Command(di.JogHeld, _release),
    "drive.watch": Command(di.WatchIn, _watch),
    "drive.unwatch": Command(None, _unwatch),
    "link.stop": route(links.stop_drives),
}
"""Name -> body and what carries it out. The target is the object's id."""
