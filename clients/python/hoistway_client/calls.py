"""Made by ``python -m tools.client`` from openapi/openapi.json: change that, not this."""

from __future__ import annotations

from typing import Any, Literal, cast

from hoistway_client import models as m
from hoistway_client.transport import Asynchronous, Synchronous, path


class Calls(Synchronous):
    """Every operation of the API."""

    def create_job(self, body: m.JobIn, *, idempotency_key: str | None = None) -> m.Job:
        """Order a transfer."""
        return cast("m.Job", self._call("POST", "/api/v1/jobs", body=body, headers={"Idempotency-Key": idempotency_key}))

    def list_jobs(self, *, state: m.JobState | None = None, carrier: str | None = None, vehicle: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.Job]:
        """List jobs, ended ones too."""
        return cast("m.Page[m.Job]", self._call("GET", "/api/v1/jobs", params={"state": state, "carrier": carrier, "vehicle": vehicle, "after": after, "limit": limit}))

    def get_job(self, job: str) -> m.JobWithHistory:
        """Show a job with its history."""
        return cast("m.JobWithHistory", self._call("GET", f"/api/v1/jobs/{path(job)}"))

    def change_job(self, job: str, body: m.JobChange) -> m.Job:
        """Change priority, destination or vehicle."""
        return cast("m.Job", self._call("PATCH", f"/api/v1/jobs/{path(job)}", body=body))

    def get_why(self, job: str) -> m.JobWhy:
        """Show why a job got its vehicles, and why it waited."""
        return cast("m.JobWhy", self._call("GET", f"/api/v1/jobs/{path(job)}/why"))

    def cancel_job(self, job: str, body: m.JobEndIn | None = None) -> m.Job:
        """Cancel a job whose carrier is not aboard yet."""
        return cast("m.Job", self._call("POST", f"/api/v1/jobs/{path(job)}/cancel", body=body))

    def abort_job(self, job: str, body: m.JobEndIn | None = None) -> m.Job:
        """End a job whose carrier is aboard; the carrier stays aboard."""
        return cast("m.Job", self._call("POST", f"/api/v1/jobs/{path(job)}/abort", body=body))

    def list_events(self, *, after: int | None = None, limit: int | None = None, job: str | None = None, vehicle: str | None = None) -> m.Page[m.Event]:
        """List events above a number; go on with ``after`` = ``next``. A page that is not full has them all. A number
        that no event has yet is refused: it is of another database, and nothing would come for a long time.
        """
        return cast("m.Page[m.Event]", self._call("GET", "/api/v1/events", params={"after": after, "limit": limit, "job": job, "vehicle": vehicle}))

    def list_vehicles(self) -> m.Page[m.Vehicle]:
        """List vehicles as they are now."""
        return cast("m.Page[m.Vehicle]", self._call("GET", "/api/v1/vehicles"))

    def get_vehicle(self, vehicle: str) -> m.Vehicle:
        """Show one vehicle with every bit of its status."""
        return cast("m.Vehicle", self._call("GET", f"/api/v1/vehicles/{path(vehicle)}"))

    def get_frames(self, vehicle: str, *, lang: Literal['en', 'ko'] | None = None) -> m.Page[m.Frame]:
        """Show the last bytes on a vehicle's line, explained."""
        return cast("m.Page[m.Frame]", self._call("GET", f"/api/v1/vehicles/{path(vehicle)}/frames", params={"lang": lang}))

    def list_commands(self, vehicle: str, *, limit: int | None = None) -> m.Page[m.Command]:
        """List what was sent to a vehicle and what became of it."""
        return cast("m.Page[m.Command]", self._call("GET", f"/api/v1/vehicles/{path(vehicle)}/commands", params={"limit": limit}))

    def command_vehicle(self, vehicle: str, body: m.PlainCommand | m.DisplayCommand | m.MoveCommand | m.TransferCommand | m.AgvMoveManualCommand | m.AgvMoveAutoCommand | m.AgvMarkStopCommand | m.AgvSetCurrentCommand | m.AgvLiftCommand | m.AgvChargeCommand | m.AgvMoveAliasCommand) -> m.Taken:
        """Send a command to a vehicle."""
        return cast("m.Taken", self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/commands", body=body))

    def get_command(self, vehicle: str, command: str) -> m.Command:
        """Show one command by its 16 hex digits."""
        return cast("m.Command", self._call("GET", f"/api/v1/vehicles/{path(vehicle)}/commands/{path(command)}"))

    def recover_vehicle(self, vehicle: str, body: m.RecoverIn) -> m.Taken:
        """Recover from an alarm: clear, servo on, home, auto, as far as each is safe."""
        return cast("m.Taken", self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/recover", body=body))

    def park_vehicle(self, vehicle: str) -> m.Vehicle:
        """Send a vehicle to the nearest free parking place."""
        return cast("m.Vehicle", self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/park"))

    def hold_vehicle(self, vehicle: str, body: m.ReasonIn) -> m.Vehicle:
        """Send nothing more to a vehicle until it is released."""
        return cast("m.Vehicle", self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/hold", body=body))

    def release_vehicle(self, vehicle: str, body: m.ReleaseIn) -> m.Vehicle:
        """A named person decides about a held or absent vehicle."""
        return cast("m.Vehicle", self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/release", body=body))

    def lock_vehicle(self, vehicle: str, body: m.ReasonIn) -> m.Vehicle:
        """People are at the vehicle: no remote command and no movement until they say so."""
        return cast("m.Vehicle", self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/lockout", body=body))

    def unlock_vehicle(self, vehicle: str) -> m.Vehicle:
        """Lift a lockout: its owner alone, or two others together."""
        return cast("m.Vehicle", self._call("DELETE", f"/api/v1/vehicles/{path(vehicle)}/lockout"))

    def set_service(self, vehicle: str, body: m.ServiceIn) -> m.Vehicle:
        """Take a vehicle out of service, or put it back."""
        return cast("m.Vehicle", self._call("PUT", f"/api/v1/vehicles/{path(vehicle)}/service", body=body))

    def list_offsets(self, vehicle: str) -> m.Page[m.PulsesVersion]:
        """Show a vehicle's OFFSET and its history."""
        return cast("m.Page[m.PulsesVersion]", self._call("GET", f"/api/v1/vehicles/{path(vehicle)}/offset"))

    def write_offset(self, vehicle: str, body: m.Target) -> m.Vehicle:
        """Write a new version of a vehicle's OFFSET, as a named person; with If-Match only if nobody else did meanwhile."""
        return cast("m.Vehicle", self._call("PUT", f"/api/v1/vehicles/{path(vehicle)}/offset", body=body))

    def list_stations(self) -> m.Page[m.Station]:
        """List stations and what is believed of them."""
        return cast("m.Page[m.Station]", self._call("GET", "/api/v1/stations"))

    def get_station(self, station: str) -> m.Station:
        """Show one station."""
        return cast("m.Station", self._call("GET", f"/api/v1/stations/{path(station)}"))

    def put_station(self, station: str, body: m.StationPut) -> m.Station:
        """Write the whole state of a station."""
        return cast("m.Station", self._call("PUT", f"/api/v1/stations/{path(station)}", body=body))

    def patch_station(self, station: str, body: m.StationPatch) -> m.Station:
        """Write parts of a station's state."""
        return cast("m.Station", self._call("PATCH", f"/api/v1/stations/{path(station)}", body=body))

    def stage_vehicle(self, station: str, body: m.StageIn) -> m.Vehicle:
        """Send a vehicle to a station before its lot is ready. It stays idle there: it gives way, and takes jobs."""
        return cast("m.Vehicle", self._call("POST", f"/api/v1/stations/{path(station)}/stage", body=body))

    def list_dests(self, station: str) -> m.Page[m.PulsesVersion]:
        """Show a station's DEST and its history."""
        return cast("m.Page[m.PulsesVersion]", self._call("GET", f"/api/v1/stations/{path(station)}/dest"))

    def write_dest(self, station: str, body: m.Target) -> m.Station:
        """Write a new version of a port's DEST, as a named person; with If-Match only if nobody else did meanwhile."""
        return cast("m.Station", self._call("PUT", f"/api/v1/stations/{path(station)}/dest", body=body))

    def list_carriers(self) -> m.Page[m.Carrier]:
        """List carriers and where they are believed to be."""
        return cast("m.Page[m.Carrier]", self._call("GET", "/api/v1/carriers"))

    def get_carrier(self, carrier: str) -> m.Carrier:
        """Locate a carrier."""
        return cast("m.Carrier", self._call("GET", f"/api/v1/carriers/{path(carrier)}"))

    def put_carrier(self, carrier: str, body: m.CarrierPut) -> m.Carrier:
        """Install a carrier, or say where it is."""
        return cast("m.Carrier", self._call("PUT", f"/api/v1/carriers/{path(carrier)}", body=body))

    def remove_carrier(self, carrier: str) -> None:
        """Remove a carrier from the plant."""
        self._call("DELETE", f"/api/v1/carriers/{path(carrier)}")

    def list_drives(self) -> m.Page[m.Drive]:
        """List drives: status, error with its meaning and remedy, whether they move."""
        return cast("m.Page[m.Drive]", self._call("GET", "/api/v1/drives"))

    def get_drive(self, drive: str) -> m.Drive:
        """Show one drive."""
        return cast("m.Drive", self._call("GET", f"/api/v1/drives/{path(drive)}"))

    def get_drive_frames(self, drive: str, *, lang: Literal['en', 'ko'] | None = None) -> m.Page[m.Frame]:
        """Show the last packets on the drive's line, explained; all drives of a line are heard there."""
        return cast("m.Page[m.Frame]", self._call("GET", f"/api/v1/drives/{path(drive)}/frames", params={"lang": lang}))

    def list_drive_operations(self, drive: str, *, after: int | None = None, limit: int | None = None) -> m.Page[m.Operation]:
        """List what was asked of a drive and what came of it."""
        return cast("m.Page[m.Operation]", self._call("GET", f"/api/v1/drives/{path(drive)}/operations", params={"after": after, "limit": limit}))

    def get_catalogue(self, drive: str) -> m.Catalogue:
        """Show what is known of the parameters of the drive's model."""
        return cast("m.Catalogue", self._call("GET", f"/api/v1/drives/{path(drive)}/catalogue"))

    def ask_drive(self, drive: str, *, wait: float | None = None) -> m.Operation:
        """Ask the drive for its status now."""
        return cast("m.Operation", self._call("POST", f"/api/v1/drives/{path(drive)}/status", params={"wait": wait}))

    def press_key(self, drive: str, body: m.KeyIn, *, wait: float | None = None) -> m.Operation:
        """Press a key of the drive's panel once. ``stop_reset`` stops it, and resets an error."""
        return cast("m.Operation", self._call("POST", f"/api/v1/drives/{path(drive)}/keys", body=body, params={"wait": wait}))

    def set_inputs(self, drive: str, body: m.InputsIn, *, wait: float | None = None) -> m.Operation:
        """Set all inputs of the drive."""
        return cast("m.Operation", self._call("PUT", f"/api/v1/drives/{path(drive)}/inputs", body=body, params={"wait": wait}))

    def lock_drive(self, drive: str, body: m.ReasonIn) -> m.Drive:
        """People are at the axis: nothing but status and stop until they say so. An axis that may move is stopped."""
        return cast("m.Drive", self._call("POST", f"/api/v1/drives/{path(drive)}/lockout", body=body))

    def unlock_drive(self, drive: str) -> m.Drive:
        """Lift a lockout: its owner alone, or two others together."""
        return cast("m.Drive", self._call("DELETE", f"/api/v1/drives/{path(drive)}/lockout"))

    def list_parameters(self, drive: str) -> m.Page[m.Parameter]:
        """List parameters as last known, each with the moment of its reading."""
        return cast("m.Page[m.Parameter]", self._call("GET", f"/api/v1/drives/{path(drive)}/parameters"))

    def get_parameter(self, drive: str, number: str) -> m.Parameter:
        """Show one parameter as last known. ``raw`` null: it was not read yet."""
        return cast("m.Parameter", self._call("GET", f"/api/v1/drives/{path(drive)}/parameters/{path(number)}"))

    def write_parameter(self, drive: str, number: str, body: m.WriteIn, *, wait: float | None = None) -> m.Operation:
        """Write a parameter and read it back; with If-Match only if the drive has what you saw."""
        return cast("m.Operation", self._call("PUT", f"/api/v1/drives/{path(drive)}/parameters/{path(number)}", body=body, params={"wait": wait}))

    def read_parameter(self, drive: str, number: str, *, wait: float | None = None) -> m.Operation:
        """Read one parameter from the drive."""
        return cast("m.Operation", self._call("POST", f"/api/v1/drives/{path(drive)}/parameters/{path(number)}/read", params={"wait": wait}))

    def watch_parameters(self, drive: str, watch: str, body: m.WatchIn) -> m.Watch:
        """Poll parameters for some seconds; the same again goes on, with others it changes. The name is yours."""
        return cast("m.Watch", self._call("PUT", f"/api/v1/drives/{path(drive)}/watches/{path(watch)}", body=body))

    def unwatch_parameters(self, drive: str, watch: str) -> None:
        """Poll them no more."""
        self._call("DELETE", f"/api/v1/drives/{path(drive)}/watches/{path(watch)}")

    def read_parameters(self, drive: str, body: m.ReadIn, *, wait: float | None = None) -> m.Operation:
        """Read parameters from the drive; ``{}`` reads all 256, which takes 8 to 33 s. The operation shows how far it is."""
        return cast("m.Operation", self._call("POST", f"/api/v1/drives/{path(drive)}/read", body=body, params={"wait": wait}))

    def back_up_drive(self, drive: str, body: m.BackupIn, *, wait: float | None = None) -> m.Operation:
        """Read all 256 parameters and keep them; ``result.backup`` of the operation is the backup's number."""
        return cast("m.Operation", self._call("POST", f"/api/v1/drives/{path(drive)}/backups", body=body, params={"wait": wait}))

    def list_backups(self, drive: str, *, after: int | None = None, limit: int | None = None) -> m.Page[m.Backup]:
        """List the backups of a drive."""
        return cast("m.Page[m.Backup]", self._call("GET", f"/api/v1/drives/{path(drive)}/backups", params={"after": after, "limit": limit}))

    def get_backup(self, drive: str, backup: int, *, format: Literal['json', 'csv'] | None = None) -> m.BackupWithValues:
        """Show or download a backup: each parameter raw, and in its unit where a catalogue names it."""
        return cast("m.BackupWithValues", self._call("GET", f"/api/v1/drives/{path(drive)}/backups/{path(backup)}", params={"format": format}))

    def compare_drive(self, drive: str, body: m.CompareIn, *, wait: float | None = None) -> m.Operation:
        """Read the drive and tell where it differs from a backup or another drive: see ``result.differences``."""
        return cast("m.Operation", self._call("POST", f"/api/v1/drives/{path(drive)}/compare", body=body, params={"wait": wait}))

    def restore_drive(self, drive: str, body: m.RestoreIn, *, wait: float | None = None) -> m.Operation:
        """Write what differs from a backup, each read back; ``result.rows`` says what becomes of each. Try ``dry_run``
        first.
        """
        return cast("m.Operation", self._call("POST", f"/api/v1/drives/{path(drive)}/restore", body=body, params={"wait": wait}))

    def jog_drive(self, drive: str, body: m.JogIn) -> m.Jog:
        """Begin to jog. The axis stops by itself if the caller does not say in time that the key is still held."""
        return cast("m.Jog", self._call("POST", f"/api/v1/drives/{path(drive)}/jog", body=body))

    def keep_jog(self, drive: str, jog: int) -> m.Jog:
        """Say that the key is still held: five times a second or so. Waits for no disk."""
        return cast("m.Jog", self._call("POST", f"/api/v1/drives/{path(drive)}/jog/{path(jog)}"))

    def get_jog(self, drive: str, jog: int) -> m.Operation:
        """Show a jog: whether the axis moves (``result.moving``), and why it ended (``result.ended``)."""
        return cast("m.Operation", self._call("GET", f"/api/v1/drives/{path(drive)}/jog/{path(jog)}"))

    def release_jog(self, drive: str, jog: int, *, wait: float | None = None) -> m.Operation:
        """Let go of the key; the axis is stopped. Waits for no disk."""
        return cast("m.Operation", self._call("DELETE", f"/api/v1/drives/{path(drive)}/jog/{path(jog)}", params={"wait": wait}))

    def list_operations(self, *, drive: str | None = None, line: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.Operation]:
        """List what was asked of drives and what came of it."""
        return cast("m.Page[m.Operation]", self._call("GET", "/api/v1/operations", params={"drive": drive, "line": line, "after": after, "limit": limit}))

    def get_operation(self, operation: int, *, wait: float | None = None) -> m.Operation:
        """Show an operation; ``wait`` for its end if you like."""
        return cast("m.Operation", self._call("GET", f"/api/v1/operations/{path(operation)}", params={"wait": wait}))

    def cancel_operation(self, operation: int, *, wait: float | None = None) -> m.Operation:
        """Ask nothing more of the drive for it; what was sent already is not undone."""
        return cast("m.Operation", self._call("POST", f"/api/v1/operations/{path(operation)}/cancel", params={"wait": wait}))

    def list_links(self) -> m.Page[m.Line]:
        """List the lines that carry several devices: connected or not, since when, why not, and their figures."""
        return cast("m.Page[m.Line]", self._call("GET", "/api/v1/links"))

    def get_link(self, link: str) -> m.Line:
        """Show one link."""
        return cast("m.Line", self._call("GET", f"/api/v1/links/{path(link)}"))

    def get_link_frames(self, link: str, *, lang: Literal['en', 'ko'] | None = None) -> m.Page[m.Frame]:
        """Show the last packets on a link, explained."""
        return cast("m.Page[m.Frame]", self._call("GET", f"/api/v1/links/{path(link)}/frames", params={"lang": lang}))

    def stop_drives(self, link: str, *, wait: float | None = None) -> m.Operation:
        """Stop all drives of a line at once, by one packet that none of them answers."""
        return cast("m.Operation", self._call("POST", f"/api/v1/links/{path(link)}/stop", params={"wait": wait}))

    def list_teaching_sessions(self, *, state: Literal['open', 'closed', 'abandoned'] | None = None, station: str | None = None, vehicle: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.TeachingSession]:
        """List teaching sessions; go on with ``after`` = ``next``."""
        return cast("m.Page[m.TeachingSession]", self._call("GET", "/api/v1/teaching/sessions", params={"state": state, "station": station, "vehicle": vehicle, "after": after, "limit": limit}))

    def open_teaching_session(self, body: m.SessionIn) -> m.TeachingSessionDetail:
        """Open a session: a named person teaches a port with a vehicle. Jobs that need the port wait and say so."""
        return cast("m.TeachingSessionDetail", self._call("POST", "/api/v1/teaching/sessions", body=body))

    def get_teaching_session(self, session: int) -> m.TeachingSessionDetail:
        """Show a session, its proposals, and what to do next."""
        return cast("m.TeachingSessionDetail", self._call("GET", f"/api/v1/teaching/sessions/{path(session)}"))

    def start_teaching(self, session: int, body: m.StartIn) -> m.Taken:
        """Ask the vehicle, which stands at the port in MANT, for SHFT, ROTA and LIFT."""
        return cast("m.Taken", self._call("POST", f"/api/v1/teaching/sessions/{path(session)}/start", body=body))

    def close_teaching_session(self, session: int, body: m.EndIn) -> m.TeachingSessionDetail:
        """Close a session: its port is open to jobs again; what it has taught waits for approval unless it is abandoned."""
        return cast("m.TeachingSessionDetail", self._call("POST", f"/api/v1/teaching/sessions/{path(session)}/close", body=body))

    def list_proposals(self, *, state: m.ProposalState | None = None, station: str | None = None, vehicle: str | None = None, session: int | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.Proposal]:
        """List sets of teaching events and what became of them; go on with ``after`` = ``next``."""
        return cast("m.Page[m.Proposal]", self._call("GET", "/api/v1/teaching/proposals", params={"state": state, "station": station, "vehicle": vehicle, "session": session, "after": after, "limit": limit}))

    def get_proposal(self, proposal: int, *, shft: int | None = None, rota: int | None = None, lift: int | None = None) -> m.ProposalDetail:
        """Show a proposal with every port and vehicle whose pulses it changes, old and new, and whether it is far off."""
        return cast("m.ProposalDetail", self._call("GET", f"/api/v1/teaching/proposals/{path(proposal)}", params={"shft": shft, "rota": rota, "lift": lift}))

    def approve_proposal(self, proposal: int, body: m.ApproveIn) -> m.ProposalDetail:
        """Make the version that the proposal shows; with If-Match only if nothing has changed since it was looked at."""
        return cast("m.ProposalDetail", self._call("POST", f"/api/v1/teaching/proposals/{path(proposal)}/approve", body=body))

    def reject_proposal(self, proposal: int, body: m.RejectIn) -> m.ProposalDetail:
        """Make nothing of a proposal; its raw events stay."""
        return cast("m.ProposalDetail", self._call("POST", f"/api/v1/teaching/proposals/{path(proposal)}/reject", body=body))

    def assign_proposal(self, proposal: int, body: m.AssignIn) -> m.ProposalDetail:
        """Say which of several ports at one barcode was taught."""
        return cast("m.ProposalDetail", self._call("POST", f"/api/v1/teaching/proposals/{path(proposal)}/assign", body=body))

    def list_teaching_events(self, *, vehicle: str | None = None, barcode: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.TeachingEvent]:
        """List what vehicles sent, as they sent it; go on with ``after`` = ``next``."""
        return cast("m.Page[m.TeachingEvent]", self._call("GET", "/api/v1/teaching/events", params={"vehicle": vehicle, "barcode": barcode, "after": after, "limit": limit}))

    def get_target(self, station: str, vehicle: str) -> m.TaughtTarget:
        """Show what a vehicle would be sent at a port, and from which rows; nothing is sent."""
        return cast("m.TaughtTarget", self._call("GET", f"/api/v1/teaching/targets/{path(station)}/{path(vehicle)}"))

    def compare_dests(self, station: str, old: int, new: int) -> m.TaughtComparison:
        """Compare two versions of a port's DEST: the differences, and what each vehicle would be sent."""
        return cast("m.TaughtComparison", self._call("GET", f"/api/v1/teaching/compare/stations/{path(station)}/{path(old)}/{path(new)}"))

    def compare_offsets(self, vehicle: str, old: int, new: int) -> m.TaughtComparison:
        """Compare two versions of a vehicle's OFFSET: the differences, and what it would be sent at each port."""
        return cast("m.TaughtComparison", self._call("GET", f"/api/v1/teaching/compare/vehicles/{path(vehicle)}/{path(old)}/{path(new)}"))

    def compare_two_vehicles(self, vehicle: str, other: str, *, station: str | None = None) -> m.VehicleComparison:
        """Compare the OFFSETs of two vehicles, and what each would be sent at a port (all ports, if none is named)."""
        return cast("m.VehicleComparison", self._call("GET", f"/api/v1/teaching/compare/offsets/{path(vehicle)}/{path(other)}", params={"station": station}))

    def list_drift(self, *, shft: int | None = None, rota: int | None = None, lift: int | None = None) -> m.Page[m.DriftRow]:
        """List ports and vehicles whose newest version is farther from the one before than so many pulses."""
        return cast("m.Page[m.DriftRow]", self._call("GET", "/api/v1/teaching/drift", params={"shft": shft, "rota": rota, "lift": lift}))

    def roll_back_dest(self, station: str, body: m.RollBackIn) -> m.TaughtComparison:
        """Make a new version of a port's DEST that equals an old one; with If-Match only if nobody wrote meanwhile."""
        return cast("m.TaughtComparison", self._call("POST", f"/api/v1/stations/{path(station)}/dest/rollback", body=body))

    def roll_back_offset(self, vehicle: str, body: m.RollBackIn) -> m.TaughtComparison:
        """The same with a vehicle's OFFSET."""
        return cast("m.TaughtComparison", self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/offset/rollback", body=body))

    def export_dests(self, *, format: Literal['json', 'csv'] | None = None, history: bool | None = None) -> m.Page[m.TaughtDest]:
        """Export the taught values of ports."""
        return cast("m.Page[m.TaughtDest]", self._call("GET", "/api/v1/teaching/dests", params={"format": format, "history": history}))

    def export_offsets(self, *, format: Literal['json', 'csv'] | None = None, history: bool | None = None) -> m.Page[m.TaughtOffset]:
        """Export the taught values of vehicles."""
        return cast("m.Page[m.TaughtOffset]", self._call("GET", "/api/v1/teaching/offsets", params={"format": format, "history": history}))

    def import_dests(self, body: dict[str, Any], *, dry_run: bool | None = None) -> m.ImportReport:
        """Import the taught values of ports: all rows or none. With ``dry_run`` only say what would become of each."""
        return cast("m.ImportReport", self._call("POST", "/api/v1/teaching/dests/import", body=body, params={"dry_run": dry_run}))

    def import_offsets(self, body: dict[str, Any], *, dry_run: bool | None = None) -> m.ImportReport:
        """Import the taught values of vehicles, likewise."""
        return cast("m.ImportReport", self._call("POST", "/api/v1/teaching/offsets/import", body=body, params={"dry_run": dry_run}))

    def list_devices(self) -> m.Page[m.Device]:
        """List doors, buffers and chargers as they are now."""
        return cast("m.Page[m.Device]", self._call("GET", "/api/v1/devices"))

    def get_device(self, device: str) -> m.Device:
        """Show one device: its state, who is in it or waits for it, what is wrong with it."""
        return cast("m.Device", self._call("GET", f"/api/v1/devices/{path(device)}"))

    def get_device_frames(self, device: str, *, lang: Literal['en', 'ko'] | None = None) -> m.Page[m.Frame]:
        """Show the last bytes on a device's link, explained: its own and those of the others there. A charger has none."""
        return cast("m.Page[m.Frame]", self._call("GET", f"/api/v1/devices/{path(device)}/frames", params={"lang": lang}))

    def list_device_commands(self, device: str, *, limit: int | None = None) -> m.Page[m.Command]:
        """List what a device was asked and what became of it."""
        return cast("m.Page[m.Command]", self._call("GET", f"/api/v1/devices/{path(device)}/commands", params={"limit": limit}))

    def command_device(self, device: str, body: m.DeviceCommandIn) -> m.DeviceTaken:
        """Open or close a door, lock or unlock a buffer."""
        return cast("m.DeviceTaken", self._call("POST", f"/api/v1/devices/{path(device)}/commands", body=body))

    def get_device_command(self, device: str, command: str) -> m.Command:
        """Show one command by its 16 hex digits."""
        return cast("m.Command", self._call("GET", f"/api/v1/devices/{path(device)}/commands/{path(command)}"))

    def pin_door(self, device: str, body: m.PinIn) -> m.Device:
        """Keep a door open or closed, whatever vehicles want."""
        return cast("m.Device", self._call("PUT", f"/api/v1/devices/{path(device)}/pin", body=body))

    def unpin_door(self, device: str) -> m.Device:
        """Give a door back to the vehicles."""
        return cast("m.Device", self._call("DELETE", f"/api/v1/devices/{path(device)}/pin"))

    def lock_out_device(self, device: str, body: m.ReasonIn) -> m.Device:
        """People are at the device: no remote command and no grant there until they say so."""
        return cast("m.Device", self._call("POST", f"/api/v1/devices/{path(device)}/lockout", body=body))

    def lift_device_lockout(self, device: str) -> m.Device:
        """Lift a lockout: its owner alone, or two others together."""
        return cast("m.Device", self._call("DELETE", f"/api/v1/devices/{path(device)}/lockout"))

    def set_device_service(self, device: str, body: m.ServiceIn) -> m.Device:
        """Take a device out of service, or put it back: a charger, a buffer or a door that vehicles are not to use."""
        return cast("m.Device", self._call("PUT", f"/api/v1/devices/{path(device)}/service", body=body))

    def raise_emergency(self, body: m.EmergencyIn) -> m.Controller:
        """Stop everything where it is, open or close doors as configured, until somebody releases it. Safe to repeat."""
        return cast("m.Controller", self._call("POST", "/api/v1/controller/emergency", body=body))

    def release_emergency(self, body: m.EmergencyIn) -> m.Controller:
        """A named person says that it is over; the controller stays paused until it is resumed."""
        return cast("m.Controller", self._call("POST", "/api/v1/controller/emergency/release", body=body))

    def list_closures(self) -> m.Page[m.Closure]:
        """List the closures in force: each is one reason, and a place opens with the last of its reasons."""
        return cast("m.Page[m.Closure]", self._call("GET", "/api/v1/closures"))

    def close_place(self, body: m.ClosureIn) -> m.Closure:
        """Close a place: nobody comes in, those inside drive out, then its state is closed. It outlives restarts."""
        return cast("m.Closure", self._call("POST", "/api/v1/closures", body=body))

    def preview_closure(self, body: m.PreviewIn) -> m.ClosurePreview:
        """Show what closing a place would do, and change nothing: stations, vehicles, jobs, and how much longer routes
        get.
        """
        return cast("m.ClosurePreview", self._call("POST", "/api/v1/closures/preview", body=body))

    def list_past_closures(self, *, after: int | None = None, limit: int | None = None) -> m.Page[m.Closure]:
        """List closures, over or not; go on with ``after`` = ``next``."""
        return cast("m.Page[m.Closure]", self._call("GET", "/api/v1/closures/history", params={"after": after, "limit": limit}))

    def get_closure(self, closure: int) -> m.Closure:
        """Show one closure, over or not: who is still inside, and what they wait for."""
        return cast("m.Closure", self._call("GET", f"/api/v1/closures/{path(closure)}"))

    def open_place(self, closure: int, body: m.OpenIn) -> m.Closure:
        """End a closure. One for people's work is opened by its owner alone, or by two others together."""
        return cast("m.Closure", self._call("POST", f"/api/v1/closures/{path(closure)}/open", body=body))

    def show_moment(self, *, at: str | None = None) -> m.Moment:
        """Show the plant as it was at a moment: vehicles, jobs, stations, carriers, devices, closures, alarms."""
        return cast("m.Moment", self._call("GET", "/api/v1/history", params={"at": at}))

    def show_span(self) -> m.Span:
        """Show from when to when there is playback, and how large it is."""
        return cast("m.Span", self._call("GET", "/api/v1/history/span"))

    def show_heat(self, *, from_: str | None = None, to: str | None = None) -> m.Heat:
        """Show where vehicles waited and where many came by in a period (by default the last hour), by barcode. It is
        counted by the five minutes: `from` and `to` in the answer say from when to when, and are null where nothing
        was.
        """
        return cast("m.Heat", self._call("GET", "/api/v1/history/heat", params={"from": from_, "to": to}))

    def list_changes(self, *, from_: str | None = None, to: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.PlaybackChange]:
        """List what changed in a period (by default the last hour). Of a vehicle a change has only the fields that are
        other now.
        """
        return cast("m.Page[m.PlaybackChange]", self._call("GET", "/api/v1/history/changes", params={"from": from_, "to": to, "after": after, "limit": limit}))

    def list_past_events(self, *, from_: str | None = None, to: str | None = None, of_note: bool | None = None, newest: bool | None = None, job: str | None = None, vehicle: str | None = None, limit: int | None = None) -> m.Page[m.Event]:
        """List the events of a period (by default the last hour): the first, or the newest. All of them: `GET /events`."""
        return cast("m.Page[m.Event]", self._call("GET", "/api/v1/history/events", params={"from": from_, "to": to, "of_note": of_note, "newest": newest, "job": job, "vehicle": vehicle, "limit": limit}))

    def show_statistics(self, *, from_: str | None = None, to: str | None = None, interval: int | None = None) -> m.Statistics:
        """Show what a period came to (by default the last day): delivery times by phase, throughput, queue, vehicles,
        waits.
        """
        return cast("m.Statistics", self._call("GET", "/api/v1/statistics", params={"from": from_, "to": to, "interval": interval}))

    def list_walks(self) -> m.Page[m.Walk]:
        """List the audit walks that are under way."""
        return cast("m.Page[m.Walk]", self._call("GET", "/api/v1/walks"))

    def start_walk(self, body: m.WalkIn) -> m.Walk:
        """Begin a walk; what is believed of its places is written down. Vehicles go on meanwhile: what changes is marked
        moved.
        """
        return cast("m.Walk", self._call("POST", "/api/v1/walks", body=body))

    def list_past_walks(self, *, after: int | None = None, limit: int | None = None) -> m.Page[m.Walk]:
        """List audit walks, ended or not; go on with ``after`` = ``next``."""
        return cast("m.Page[m.Walk]", self._call("GET", "/api/v1/walks/history", params={"after": after, "limit": limit}))

    def get_walk(self, walk: int) -> m.Walk:
        """Show one walk, ended or not."""
        return cast("m.Walk", self._call("GET", f"/api/v1/walks/{path(walk)}"))

    def list_walk_places(self, walk: int, *, finding: m.Finding | None = None) -> m.Page[m.WalkPlace]:
        """List the places of a walk: what was believed, what is believed now, what was seen, and what that comes to."""
        return cast("m.Page[m.WalkPlace]", self._call("GET", f"/api/v1/walks/{path(walk)}/places", params={"finding": finding}))

    def enter_sights(self, walk: int, body: m.SightsIn) -> m.Walk:
        """Write down what stands at several places: all or nothing."""
        return cast("m.Walk", self._call("POST", f"/api/v1/walks/{path(walk)}/places", body=body))

    def enter_sight(self, walk: int, station: str, body: m.SightIn) -> m.Walk:
        """Write down what stands at one place; a later entry replaces the one before."""
        return cast("m.Walk", self._call("PUT", f"/api/v1/walks/{path(walk)}/places/{path(station)}", body=body))

    def accept_walk(self, walk: int, body: m.AcceptIn) -> m.Walk:
        """A named person takes what was seen for true: its places and carriers are verified from now on."""
        return cast("m.Walk", self._call("POST", f"/api/v1/walks/{path(walk)}/accept", body=body))

    def abandon_walk(self, walk: int, body: m.AbandonIn) -> m.Walk:
        """End a walk; nothing is believed for it."""
        return cast("m.Walk", self._call("POST", f"/api/v1/walks/{path(walk)}/abandon", body=body))

    def list_active_alarms(self) -> m.Page[m.Alarm]:
        """List the alarms that there are now."""
        return cast("m.Page[m.Alarm]", self._call("GET", "/api/v1/alarms/active"))

    def list_alarms(self, *, kind: m.AlarmKind | None = None, source: str | None = None, code: str | None = None, active: bool | None = None, acknowledged: bool | None = None, from_: str | None = None, to: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.Alarm]:
        """List alarms, ended or not, of a period or of all time; go on with ``after`` = ``next``."""
        return cast("m.Page[m.Alarm]", self._call("GET", "/api/v1/alarms", params={"kind": kind, "source": source, "code": code, "active": active, "acknowledged": acknowledged, "from": from_, "to": to, "after": after, "limit": limit}))

    def count_alarms(self, *, by: Literal['code', 'source', 'both'] | None = None, from_: str | None = None, to: str | None = None, limit: int | None = None) -> m.Page[m.AlarmCount]:
        """Count alarms of a period (by default the last 7 days): how often and how long, by code, by machine, or by both."""
        return cast("m.Page[m.AlarmCount]", self._call("GET", "/api/v1/alarms/pareto", params={"by": by, "from": from_, "to": to, "limit": limit}))

    def show_reliability(self, *, from_: str | None = None, to: str | None = None) -> m.Page[m.Reliability]:
        """Show how vehicles held out in a period (by default the last 7 days), up to now: failures, MTBF, MTTR,
        availability.
        """
        return cast("m.Page[m.Reliability]", self._call("GET", "/api/v1/alarms/reliability", params={"from": from_, "to": to}))

    def get_alarm(self, alarm: int) -> m.Alarm:
        """Show one alarm, ended or not."""
        return cast("m.Alarm", self._call("GET", f"/api/v1/alarms/{path(alarm)}"))

    def acknowledge_alarms(self, body: m.NotedAlarmsIn) -> m.Page[m.AlarmAnswer]:
        """A named person knows of several alarms that have one cause: each is answered, and kept in the audit, by itself.
        One that there is not keeps no other from being acknowledged.
        """
        return cast("m.Page[m.AlarmAnswer]", self._call("POST", "/api/v1/alarms/acknowledge", body=body))

    def acknowledge_alarm(self, alarm: int, body: m.NoteIn) -> m.Alarm:
        """A named person knows of an alarm; the first one stays. It goes on until its cause is gone."""
        return cast("m.Alarm", self._call("POST", f"/api/v1/alarms/{path(alarm)}/acknowledge", body=body))

    def list_zones(self) -> m.Page[m.Zone]:
        """List the plant's zones with who holds track in them, and whether they are paused."""
        return cast("m.Page[m.Zone]", self._call("GET", "/api/v1/zones"))

    def get_zone(self, zone: str) -> m.Zone:
        """Show one zone."""
        return cast("m.Zone", self._call("GET", f"/api/v1/zones/{path(zone)}"))

    def pause_zone(self, zone: str, body: m.ReasonIn) -> m.Zone:
        """Begin no movement in a zone and let nobody in; what moves there comes to rest at the end of its grant."""
        return cast("m.Zone", self._call("POST", f"/api/v1/zones/{path(zone)}/pause", body=body))

    def stop_zone(self, zone: str, body: m.ReasonIn) -> m.Zone:
        """Pause a zone, and stop what drives there where it is. Vehicles keep AUTO."""
        return cast("m.Zone", self._call("POST", f"/api/v1/zones/{path(zone)}/stop", body=body))

    def resume_zone(self, zone: str) -> m.Zone:
        """Let vehicles go on in a zone."""
        return cast("m.Zone", self._call("POST", f"/api/v1/zones/{path(zone)}/resume"))

    def get_controller(self) -> m.Controller:
        """Show the controller's state, and what it still waits for after a start."""
        return cast("m.Controller", self._call("GET", "/api/v1/controller"))

    def pause(self, body: m.ReasonIn) -> m.Controller:
        """Begin no new movement; what moves comes to rest."""
        return cast("m.Controller", self._call("POST", "/api/v1/controller/pause", body=body))

    def stop_all(self, body: m.ReasonIn) -> m.Controller:
        """Stop every vehicle that moves where it is, and begin no new movement. Vehicles keep AUTO; resume to go on."""
        return cast("m.Controller", self._call("POST", "/api/v1/controller/stop", body=body))

    def resume(self) -> m.Controller:
        """Go on."""
        return cast("m.Controller", self._call("POST", "/api/v1/controller/resume"))

    def get_layout(self) -> m.Layout:
        """Show the layout; it changes with the plant file only."""
        return cast("m.Layout", self._call("GET", "/api/v1/layout"))

    def list_routes(self, *, from_: str | None = None, to: str | None = None, k: int | None = None) -> m.Page[m.RouteView]:
        """Show the quickest routes between two places as they would be planned now: around closures, with the present
        delays.
        """
        return cast("m.Page[m.RouteView]", self._call("GET", "/api/v1/layout/routes", params={"from": from_, "to": to, "k": k}))

    def list_versions(self, *, after: int | None = None, limit: int | None = None) -> m.Page[m.PlantVersion]:
        """List the versions of the plant; go on with ``after`` = ``next``."""
        return cast("m.Page[m.PlantVersion]", self._call("GET", "/api/v1/layout/versions", params={"after": after, "limit": limit}))

    def stage_version(self, *, reason: str | None = None) -> m.StagedVersion:
        """Stage a plant file. One with errors is refused with all of them, each with line, column and remedy."""
        return cast("m.StagedVersion", self._call("POST", "/api/v1/layout/versions", params={"reason": reason}))

    def get_version(self, version: int) -> m.PlantVersion:
        """Show one version, without its text."""
        return cast("m.PlantVersion", self._call("GET", f"/api/v1/layout/versions/{path(version)}"))

    def list_version_findings(self, version: int) -> m.Page[m.PlantFinding]:
        """List what the checker says to a version."""
        return cast("m.Page[m.PlantFinding]", self._call("GET", f"/api/v1/layout/versions/{path(version)}/findings"))

    def compare_version(self, version: int, *, against: int | None = None) -> m.PlantDifference:
        """Show what is different in a version, and what that breaks in a plant that has run."""
        return cast("m.PlantDifference", self._call("GET", f"/api/v1/layout/versions/{path(version)}/diff", params={"against": against}))

    def weigh_version(self, version: int) -> m.PlantImpact:
        """Show what would stand in the way of a version if it became active now, what would be lost, and what has to be
        taught.
        """
        return cast("m.PlantImpact", self._call("GET", f"/api/v1/layout/versions/{path(version)}/impact"))

    def activate_version(self, version: int, body: m.ActivateIn) -> m.PlantActivation:
        """Let a version be the active one; a former one: roll back. Refused, with a list, if it breaks anything under
        way. The controller changes over within seconds: connections are cut, vehicles end what they were granted, jobs
        go on. Ask for the version until it is ``active``; if it is not ``awaited`` any more either, ``note`` says why.
        """
        return cast("m.PlantActivation", self._call("POST", f"/api/v1/layout/versions/{path(version)}/activate", body=body))

    def reject_version(self, version: int, body: m.RejectVersionIn) -> m.PlantVersion:
        """Let a staged or awaited version not become active. A former one that is awaited stays a former one."""
        return cast("m.PlantVersion", self._call("POST", f"/api/v1/layout/versions/{path(version)}/reject", body=body))

    def list_audit(self, *, after: int | None = None, limit: int | None = None, actor: str | None = None, action: str | None = None, target: str | None = None, accepted: bool | None = None, from_: str | None = None, to: str | None = None, order: Literal['oldest', 'newest'] | None = None) -> m.Page[m.Audit]:
        """List what people and hosts asked for, refused or not: all oldest first, or what is looked for newest first."""
        return cast("m.Page[m.Audit]", self._call("GET", "/api/v1/audit", params={"after": after, "limit": limit, "actor": actor, "action": action, "target": target, "accepted": accepted, "from": from_, "to": to, "order": order}))

    def check_audit(self, *, after: int | None = None, limit: int | None = None) -> m.AuditCheck:
        """Look whether each row of the audit follows from the one before it; go on with ``after`` = ``next``."""
        return cast("m.AuditCheck", self._call("GET", "/api/v1/audit/check", params={"after": after, "limit": limit}))

    def who_am_i(self) -> m.Caller:
        """Show who calls, and what they may."""
        return cast("m.Caller", self._call("GET", "/api/v1/session"))

    def log_in(self, body: m.LogInIn) -> m.Session:
        """Log in with name and password. The token goes into the header ``Authorization: Bearer TOKEN``."""
        return cast("m.Session", self._call("POST", "/api/v1/session", body=body))

    def log_out(self) -> None:
        """Log out: the token, and those that it was renewed from, are good no longer."""
        self._call("DELETE", "/api/v1/session")

    def show_required(self) -> m.Required:
        """Show whether callers have to say who they are: a page asks for a log-in then, before it asks for anything else."""
        return cast("m.Required", self._call("GET", "/api/v1/session/required"))

    def list_calls(self) -> m.Page[m.Call]:
        """List every call with the roles that may, and whether the caller may: what a page shows as buttons that can be
        pressed.
        """
        return cast("m.Page[m.Call]", self._call("GET", "/api/v1/session/calls"))

    def renew_session(self) -> m.Session:
        """Give a new token for this one, which ends half a minute later."""
        return cast("m.Session", self._call("POST", "/api/v1/session/renew"))

    def change_password(self, body: m.NewPasswordIn) -> None:
        """Have a new password."""
        self._call("PUT", "/api/v1/session/password", body=body)

    def list_users(self) -> m.Page[m.User]:
        """List the people who may log in, and those who may not any more."""
        return cast("m.Page[m.User]", self._call("GET", "/api/v1/users"))

    def add_user(self, body: m.UserIn) -> m.User:
        """Add a person. From the first one on, everybody has to log in."""
        return cast("m.User", self._call("POST", "/api/v1/users", body=body))

    def get_user(self, user: str) -> m.User:
        """Show a person."""
        return cast("m.User", self._call("GET", f"/api/v1/users/{path(user)}"))

    def change_user(self, user: str, body: m.UserChange) -> m.User:
        """Change roles, disable or enable, give a new password; the last two log the person out."""
        return cast("m.User", self._call("PATCH", f"/api/v1/users/{path(user)}", body=body))

    def list_keys(self) -> m.Page[m.Key]:
        """List keys, those that have ended too. No key itself is ever shown again."""
        return cast("m.Page[m.Key]", self._call("GET", "/api/v1/keys"))

    def add_key(self, body: m.MachineKeyIn) -> m.NewKey:
        """Make a key for a machine: 256 random bits, of which a digest is kept."""
        return cast("m.NewKey", self._call("POST", "/api/v1/keys", body=body))

    def get_key(self, key: str) -> m.Key:
        """Show what is known of a key."""
        return cast("m.Key", self._call("GET", f"/api/v1/keys/{path(key)}"))

    def revoke_key(self, key: str) -> m.Key:
        """End a key for ever; what it holds open is cut."""
        return cast("m.Key", self._call("DELETE", f"/api/v1/keys/{path(key)}"))

    def list_problems(self) -> m.Page[m.ProblemKind]:
        """List the stable codes of problems."""
        return cast("m.Page[m.ProblemKind]", self._call("GET", "/api/v1/problems"))

    def get_problem(self, code: str) -> m.ProblemKind:
        """Show one kind of problem: what a problem's ``type`` leads to."""
        return cast("m.ProblemKind", self._call("GET", f"/api/v1/problems/{path(code)}"))

    def give_ticket(self) -> m.Ticket:
        """Give a ticket for ``/api/v1/live?ticket=...``: browsers cannot send a key with a WebSocket."""
        return cast("m.Ticket", self._call("POST", "/api/v1/live/ticket"))

    def list_webhooks(self) -> m.Page[m.Webhook]:
        """List webhooks, with how far each has been told."""
        return cast("m.Page[m.Webhook]", self._call("GET", "/api/v1/webhooks"))

    def add_webhook(self, body: m.WebhookIn) -> m.WebhookWithSecret:
        """Subscribe a URL. Every event wanted is delivered in order, signed, until it is taken; nothing is lost by a
        crash.
        """
        return cast("m.WebhookWithSecret", self._call("POST", "/api/v1/webhooks", body=body))

    def get_webhook(self, webhook: int) -> m.Webhook:
        """Show one webhook."""
        return cast("m.Webhook", self._call("GET", f"/api/v1/webhooks/{path(webhook)}"))

    def change_webhook(self, webhook: int, body: m.WebhookChange) -> m.Webhook:
        """Change a webhook, pause it, or take it up again where it was."""
        return cast("m.Webhook", self._call("PATCH", f"/api/v1/webhooks/{path(webhook)}", body=body))

    def remove_webhook(self, webhook: int) -> None:
        """Remove a webhook for ever."""
        self._call("DELETE", f"/api/v1/webhooks/{path(webhook)}")

    def renew_webhook_secret(self, webhook: int, body: m.SecretIn) -> m.WebhookWithSecret:
        """Sign with a new secret; for a while with the old one too."""
        return cast("m.WebhookWithSecret", self._call("POST", f"/api/v1/webhooks/{path(webhook)}/secret", body=body))

    def replay_webhook(self, webhook: int, body: m.ReplayIn) -> m.Webhook:
        """Tell it all events above a number, as far as they are kept, before it goes on."""
        return cast("m.Webhook", self._call("POST", f"/api/v1/webhooks/{path(webhook)}/replay", body=body))

    def ping_webhook(self, webhook: int) -> m.WebhookDelivery:
        """Deliver a test event at once, and say what became of it."""
        return cast("m.WebhookDelivery", self._call("POST", f"/api/v1/webhooks/{path(webhook)}/ping"))

    def list_webhook_deliveries(self, webhook: int, *, after: int | None = None, limit: int | None = None) -> m.Page[m.WebhookDelivery]:
        """List the deliveries that were tried; the last 200 are kept. Go on with ``after`` = ``next``."""
        return cast("m.Page[m.WebhookDelivery]", self._call("GET", f"/api/v1/webhooks/{path(webhook)}/deliveries", params={"after": after, "limit": limit}))

    def healthz(self) -> m.Health:
        """Say that the server runs."""
        return cast("m.Health", self._call("GET", "/healthz"))

    def readyz(self) -> m.Readiness:
        """Say whether the controller can take jobs, and why not."""
        return cast("m.Readiness", self._call("GET", "/readyz"))


class AsyncCalls(Asynchronous):
    """Every operation of the API."""

    async def create_job(self, body: m.JobIn, *, idempotency_key: str | None = None) -> m.Job:
        """Order a transfer."""
        return cast("m.Job", await self._call("POST", "/api/v1/jobs", body=body, headers={"Idempotency-Key": idempotency_key}))

    async def list_jobs(self, *, state: m.JobState | None = None, carrier: str | None = None, vehicle: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.Job]:
        """List jobs, ended ones too."""
        return cast("m.Page[m.Job]", await self._call("GET", "/api/v1/jobs", params={"state": state, "carrier": carrier, "vehicle": vehicle, "after": after, "limit": limit}))

    async def get_job(self, job: str) -> m.JobWithHistory:
        """Show a job with its history."""
        return cast("m.JobWithHistory", await self._call("GET", f"/api/v1/jobs/{path(job)}"))

    async def change_job(self, job: str, body: m.JobChange) -> m.Job:
        """Change priority, destination or vehicle."""
        return cast("m.Job", await self._call("PATCH", f"/api/v1/jobs/{path(job)}", body=body))

    async def get_why(self, job: str) -> m.JobWhy:
        """Show why a job got its vehicles, and why it waited."""
        return cast("m.JobWhy", await self._call("GET", f"/api/v1/jobs/{path(job)}/why"))

    async def cancel_job(self, job: str, body: m.JobEndIn | None = None) -> m.Job:
        """Cancel a job whose carrier is not aboard yet."""
        return cast("m.Job", await self._call("POST", f"/api/v1/jobs/{path(job)}/cancel", body=body))

    async def abort_job(self, job: str, body: m.JobEndIn | None = None) -> m.Job:
        """End a job whose carrier is aboard; the carrier stays aboard."""
        return cast("m.Job", await self._call("POST", f"/api/v1/jobs/{path(job)}/abort", body=body))

    async def list_events(self, *, after: int | None = None, limit: int | None = None, job: str | None = None, vehicle: str | None = None) -> m.Page[m.Event]:
        """List events above a number; go on with ``after`` = ``next``. A page that is not full has them all. A number
        that no event has yet is refused: it is of another database, and nothing would come for a long time.
        """
        return cast("m.Page[m.Event]", await self._call("GET", "/api/v1/events", params={"after": after, "limit": limit, "job": job, "vehicle": vehicle}))

    async def list_vehicles(self) -> m.Page[m.Vehicle]:
        """List vehicles as they are now."""
        return cast("m.Page[m.Vehicle]", await self._call("GET", "/api/v1/vehicles"))

    async def get_vehicle(self, vehicle: str) -> m.Vehicle:
        """Show one vehicle with every bit of its status."""
        return cast("m.Vehicle", await self._call("GET", f"/api/v1/vehicles/{path(vehicle)}"))

    async def get_frames(self, vehicle: str, *, lang: Literal['en', 'ko'] | None = None) -> m.Page[m.Frame]:
        """Show the last bytes on a vehicle's line, explained."""
        return cast("m.Page[m.Frame]", await self._call("GET", f"/api/v1/vehicles/{path(vehicle)}/frames", params={"lang": lang}))

    async def list_commands(self, vehicle: str, *, limit: int | None = None) -> m.Page[m.Command]:
        """List what was sent to a vehicle and what became of it."""
        return cast("m.Page[m.Command]", await self._call("GET", f"/api/v1/vehicles/{path(vehicle)}/commands", params={"limit": limit}))

    async def command_vehicle(self, vehicle: str, body: m.PlainCommand | m.DisplayCommand | m.MoveCommand | m.TransferCommand | m.AgvMoveManualCommand | m.AgvMoveAutoCommand | m.AgvMarkStopCommand | m.AgvSetCurrentCommand | m.AgvLiftCommand | m.AgvChargeCommand | m.AgvMoveAliasCommand) -> m.Taken:
        """Send a command to a vehicle."""
        return cast("m.Taken", await self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/commands", body=body))

    async def get_command(self, vehicle: str, command: str) -> m.Command:
        """Show one command by its 16 hex digits."""
        return cast("m.Command", await self._call("GET", f"/api/v1/vehicles/{path(vehicle)}/commands/{path(command)}"))

    async def recover_vehicle(self, vehicle: str, body: m.RecoverIn) -> m.Taken:
        """Recover from an alarm: clear, servo on, home, auto, as far as each is safe."""
        return cast("m.Taken", await self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/recover", body=body))

    async def park_vehicle(self, vehicle: str) -> m.Vehicle:
        """Send a vehicle to the nearest free parking place."""
        return cast("m.Vehicle", await self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/park"))

    async def hold_vehicle(self, vehicle: str, body: m.ReasonIn) -> m.Vehicle:
        """Send nothing more to a vehicle until it is released."""
        return cast("m.Vehicle", await self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/hold", body=body))

    async def release_vehicle(self, vehicle: str, body: m.ReleaseIn) -> m.Vehicle:
        """A named person decides about a held or absent vehicle."""
        return cast("m.Vehicle", await self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/release", body=body))

    async def lock_vehicle(self, vehicle: str, body: m.ReasonIn) -> m.Vehicle:
        """People are at the vehicle: no remote command and no movement until they say so."""
        return cast("m.Vehicle", await self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/lockout", body=body))

    async def unlock_vehicle(self, vehicle: str) -> m.Vehicle:
        """Lift a lockout: its owner alone, or two others together."""
        return cast("m.Vehicle", await self._call("DELETE", f"/api/v1/vehicles/{path(vehicle)}/lockout"))

    async def set_service(self, vehicle: str, body: m.ServiceIn) -> m.Vehicle:
        """Take a vehicle out of service, or put it back."""
        return cast("m.Vehicle", await self._call("PUT", f"/api/v1/vehicles/{path(vehicle)}/service", body=body))

    async def list_offsets(self, vehicle: str) -> m.Page[m.PulsesVersion]:
        """Show a vehicle's OFFSET and its history."""
        return cast("m.Page[m.PulsesVersion]", await self._call("GET", f"/api/v1/vehicles/{path(vehicle)}/offset"))

    async def write_offset(self, vehicle: str, body: m.Target) -> m.Vehicle:
        """Write a new version of a vehicle's OFFSET, as a named person; with If-Match only if nobody else did meanwhile."""
        return cast("m.Vehicle", await self._call("PUT", f"/api/v1/vehicles/{path(vehicle)}/offset", body=body))

    async def list_stations(self) -> m.Page[m.Station]:
        """List stations and what is believed of them."""
        return cast("m.Page[m.Station]", await self._call("GET", "/api/v1/stations"))

    async def get_station(self, station: str) -> m.Station:
        """Show one station."""
        return cast("m.Station", await self._call("GET", f"/api/v1/stations/{path(station)}"))

    async def put_station(self, station: str, body: m.StationPut) -> m.Station:
        """Write the whole state of a station."""
        return cast("m.Station", await self._call("PUT", f"/api/v1/stations/{path(station)}", body=body))

    async def patch_station(self, station: str, body: m.StationPatch) -> m.Station:
        """Write parts of a station's state."""
        return cast("m.Station", await self._call("PATCH", f"/api/v1/stations/{path(station)}", body=body))

    async def stage_vehicle(self, station: str, body: m.StageIn) -> m.Vehicle:
        """Send a vehicle to a station before its lot is ready. It stays idle there: it gives way, and takes jobs."""
        return cast("m.Vehicle", await self._call("POST", f"/api/v1/stations/{path(station)}/stage", body=body))

    async def list_dests(self, station: str) -> m.Page[m.PulsesVersion]:
        """Show a station's DEST and its history."""
        return cast("m.Page[m.PulsesVersion]", await self._call("GET", f"/api/v1/stations/{path(station)}/dest"))

    async def write_dest(self, station: str, body: m.Target) -> m.Station:
        """Write a new version of a port's DEST, as a named person; with If-Match only if nobody else did meanwhile."""
        return cast("m.Station", await self._call("PUT", f"/api/v1/stations/{path(station)}/dest", body=body))

    async def list_carriers(self) -> m.Page[m.Carrier]:
        """List carriers and where they are believed to be."""
        return cast("m.Page[m.Carrier]", await self._call("GET", "/api/v1/carriers"))

    async def get_carrier(self, carrier: str) -> m.Carrier:
        """Locate a carrier."""
        return cast("m.Carrier", await self._call("GET", f"/api/v1/carriers/{path(carrier)}"))

    async def put_carrier(self, carrier: str, body: m.CarrierPut) -> m.Carrier:
        """Install a carrier, or say where it is."""
        return cast("m.Carrier", await self._call("PUT", f"/api/v1/carriers/{path(carrier)}", body=body))

    async def remove_carrier(self, carrier: str) -> None:
        """Remove a carrier from the plant."""
        await self._call("DELETE", f"/api/v1/carriers/{path(carrier)}")

    async def list_drives(self) -> m.Page[m.Drive]:
        """List drives: status, error with its meaning and remedy, whether they move."""
        return cast("m.Page[m.Drive]", await self._call("GET", "/api/v1/drives"))

    async def get_drive(self, drive: str) -> m.Drive:
        """Show one drive."""
        return cast("m.Drive", await self._call("GET", f"/api/v1/drives/{path(drive)}"))

    async def get_drive_frames(self, drive: str, *, lang: Literal['en', 'ko'] | None = None) -> m.Page[m.Frame]:
        """Show the last packets on the drive's line, explained; all drives of a line are heard there."""
        return cast("m.Page[m.Frame]", await self._call("GET", f"/api/v1/drives/{path(drive)}/frames", params={"lang": lang}))

    async def list_drive_operations(self, drive: str, *, after: int | None = None, limit: int | None = None) -> m.Page[m.Operation]:
        """List what was asked of a drive and what came of it."""
        return cast("m.Page[m.Operation]", await self._call("GET", f"/api/v1/drives/{path(drive)}/operations", params={"after": after, "limit": limit}))

    async def get_catalogue(self, drive: str) -> m.Catalogue:
        """Show what is known of the parameters of the drive's model."""
        return cast("m.Catalogue", await self._call("GET", f"/api/v1/drives/{path(drive)}/catalogue"))

    async def ask_drive(self, drive: str, *, wait: float | None = None) -> m.Operation:
        """Ask the drive for its status now."""
        return cast("m.Operation", await self._call("POST", f"/api/v1/drives/{path(drive)}/status", params={"wait": wait}))

    async def press_key(self, drive: str, body: m.KeyIn, *, wait: float | None = None) -> m.Operation:
        """Press a key of the drive's panel once. ``stop_reset`` stops it, and resets an error."""
        return cast("m.Operation", await self._call("POST", f"/api/v1/drives/{path(drive)}/keys", body=body, params={"wait": wait}))

    async def set_inputs(self, drive: str, body: m.InputsIn, *, wait: float | None = None) -> m.Operation:
        """Set all inputs of the drive."""
        return cast("m.Operation", await self._call("PUT", f"/api/v1/drives/{path(drive)}/inputs", body=body, params={"wait": wait}))

    async def lock_drive(self, drive: str, body: m.ReasonIn) -> m.Drive:
        """People are at the axis: nothing but status and stop until they say so. An axis that may move is stopped."""
        return cast("m.Drive", await self._call("POST", f"/api/v1/drives/{path(drive)}/lockout", body=body))

    async def unlock_drive(self, drive: str) -> m.Drive:
        """Lift a lockout: its owner alone, or two others together."""
        return cast("m.Drive", await self._call("DELETE", f"/api/v1/drives/{path(drive)}/lockout"))

    async def list_parameters(self, drive: str) -> m.Page[m.Parameter]:
        """List parameters as last known, each with the moment of its reading."""
        return cast("m.Page[m.Parameter]", await self._call("GET", f"/api/v1/drives/{path(drive)}/parameters"))

    async def get_parameter(self, drive: str, number: str) -> m.Parameter:
        """Show one parameter as last known. ``raw`` null: it was not read yet."""
        return cast("m.Parameter", await self._call("GET", f"/api/v1/drives/{path(drive)}/parameters/{path(number)}"))

    async def write_parameter(self, drive: str, number: str, body: m.WriteIn, *, wait: float | None = None) -> m.Operation:
        """Write a parameter and read it back; with If-Match only if the drive has what you saw."""
        return cast("m.Operation", await self._call("PUT", f"/api/v1/drives/{path(drive)}/parameters/{path(number)}", body=body, params={"wait": wait}))

    async def read_parameter(self, drive: str, number: str, *, wait: float | None = None) -> m.Operation:
        """Read one parameter from the drive."""
        return cast("m.Operation", await self._call("POST", f"/api/v1/drives/{path(drive)}/parameters/{path(number)}/read", params={"wait": wait}))

    async def watch_parameters(self, drive: str, watch: str, body: m.WatchIn) -> m.Watch:
        """Poll parameters for some seconds; the same again goes on, with others it changes. The name is yours."""
        return cast("m.Watch", await self._call("PUT", f"/api/v1/drives/{path(drive)}/watches/{path(watch)}", body=body))

    async def unwatch_parameters(self, drive: str, watch: str) -> None:
        """Poll them no more."""
        await self._call("DELETE", f"/api/v1/drives/{path(drive)}/watches/{path(watch)}")

    async def read_parameters(self, drive: str, body: m.ReadIn, *, wait: float | None = None) -> m.Operation:
        """Read parameters from the drive; ``{}`` reads all 256, which takes 8 to 33 s. The operation shows how far it is."""
        return cast("m.Operation", await self._call("POST", f"/api/v1/drives/{path(drive)}/read", body=body, params={"wait": wait}))

    async def back_up_drive(self, drive: str, body: m.BackupIn, *, wait: float | None = None) -> m.Operation:
        """Read all 256 parameters and keep them; ``result.backup`` of the operation is the backup's number."""
        return cast("m.Operation", await self._call("POST", f"/api/v1/drives/{path(drive)}/backups", body=body, params={"wait": wait}))

    async def list_backups(self, drive: str, *, after: int | None = None, limit: int | None = None) -> m.Page[m.Backup]:
        """List the backups of a drive."""
        return cast("m.Page[m.Backup]", await self._call("GET", f"/api/v1/drives/{path(drive)}/backups", params={"after": after, "limit": limit}))

    async def get_backup(self, drive: str, backup: int, *, format: Literal['json', 'csv'] | None = None) -> m.BackupWithValues:
        """Show or download a backup: each parameter raw, and in its unit where a catalogue names it."""
        return cast("m.BackupWithValues", await self._call("GET", f"/api/v1/drives/{path(drive)}/backups/{path(backup)}", params={"format": format}))

    async def compare_drive(self, drive: str, body: m.CompareIn, *, wait: float | None = None) -> m.Operation:
        """Read the drive and tell where it differs from a backup or another drive: see ``result.differences``."""
        return cast("m.Operation", await self._call("POST", f"/api/v1/drives/{path(drive)}/compare", body=body, params={"wait": wait}))

    async def restore_drive(self, drive: str, body: m.RestoreIn, *, wait: float | None = None) -> m.Operation:
        """Write what differs from a backup, each read back; ``result.rows`` says what becomes of each. Try ``dry_run``
        first.
        """
        return cast("m.Operation", await self._call("POST", f"/api/v1/drives/{path(drive)}/restore", body=body, params={"wait": wait}))

    async def jog_drive(self, drive: str, body: m.JogIn) -> m.Jog:
        """Begin to jog. The axis stops by itself if the caller does not say in time that the key is still held."""
        return cast("m.Jog", await self._call("POST", f"/api/v1/drives/{path(drive)}/jog", body=body))

    async def keep_jog(self, drive: str, jog: int) -> m.Jog:
        """Say that the key is still held: five times a second or so. Waits for no disk."""
        return cast("m.Jog", await self._call("POST", f"/api/v1/drives/{path(drive)}/jog/{path(jog)}"))

    async def get_jog(self, drive: str, jog: int) -> m.Operation:
        """Show a jog: whether the axis moves (``result.moving``), and why it ended (``result.ended``)."""
        return cast("m.Operation", await self._call("GET", f"/api/v1/drives/{path(drive)}/jog/{path(jog)}"))

    async def release_jog(self, drive: str, jog: int, *, wait: float | None = None) -> m.Operation:
        """Let go of the key; the axis is stopped. Waits for no disk."""
        return cast("m.Operation", await self._call("DELETE", f"/api/v1/drives/{path(drive)}/jog/{path(jog)}", params={"wait": wait}))

    async def list_operations(self, *, drive: str | None = None, line: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.Operation]:
        """List what was asked of drives and what came of it."""
        return cast("m.Page[m.Operation]", await self._call("GET", "/api/v1/operations", params={"drive": drive, "line": line, "after": after, "limit": limit}))

    async def get_operation(self, operation: int, *, wait: float | None = None) -> m.Operation:
        """Show an operation; ``wait`` for its end if you like."""
        return cast("m.Operation", await self._call("GET", f"/api/v1/operations/{path(operation)}", params={"wait": wait}))

    async def cancel_operation(self, operation: int, *, wait: float | None = None) -> m.Operation:
        """Ask nothing more of the drive for it; what was sent already is not undone."""
        return cast("m.Operation", await self._call("POST", f"/api/v1/operations/{path(operation)}/cancel", params={"wait": wait}))

    async def list_links(self) -> m.Page[m.Line]:
        """List the lines that carry several devices: connected or not, since when, why not, and their figures."""
        return cast("m.Page[m.Line]", await self._call("GET", "/api/v1/links"))

    async def get_link(self, link: str) -> m.Line:
        """Show one link."""
        return cast("m.Line", await self._call("GET", f"/api/v1/links/{path(link)}"))

    async def get_link_frames(self, link: str, *, lang: Literal['en', 'ko'] | None = None) -> m.Page[m.Frame]:
        """Show the last packets on a link, explained."""
        return cast("m.Page[m.Frame]", await self._call("GET", f"/api/v1/links/{path(link)}/frames", params={"lang": lang}))

    async def stop_drives(self, link: str, *, wait: float | None = None) -> m.Operation:
        """Stop all drives of a line at once, by one packet that none of them answers."""
        return cast("m.Operation", await self._call("POST", f"/api/v1/links/{path(link)}/stop", params={"wait": wait}))

    async def list_teaching_sessions(self, *, state: Literal['open', 'closed', 'abandoned'] | None = None, station: str | None = None, vehicle: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.TeachingSession]:
        """List teaching sessions; go on with ``after`` = ``next``."""
        return cast("m.Page[m.TeachingSession]", await self._call("GET", "/api/v1/teaching/sessions", params={"state": state, "station": station, "vehicle": vehicle, "after": after, "limit": limit}))

    async def open_teaching_session(self, body: m.SessionIn) -> m.TeachingSessionDetail:
        """Open a session: a named person teaches a port with a vehicle. Jobs that need the port wait and say so."""
        return cast("m.TeachingSessionDetail", await self._call("POST", "/api/v1/teaching/sessions", body=body))

    async def get_teaching_session(self, session: int) -> m.TeachingSessionDetail:
        """Show a session, its proposals, and what to do next."""
        return cast("m.TeachingSessionDetail", await self._call("GET", f"/api/v1/teaching/sessions/{path(session)}"))

    async def start_teaching(self, session: int, body: m.StartIn) -> m.Taken:
        """Ask the vehicle, which stands at the port in MANT, for SHFT, ROTA and LIFT."""
        return cast("m.Taken", await self._call("POST", f"/api/v1/teaching/sessions/{path(session)}/start", body=body))

    async def close_teaching_session(self, session: int, body: m.EndIn) -> m.TeachingSessionDetail:
        """Close a session: its port is open to jobs again; what it has taught waits for approval unless it is abandoned."""
        return cast("m.TeachingSessionDetail", await self._call("POST", f"/api/v1/teaching/sessions/{path(session)}/close", body=body))

    async def list_proposals(self, *, state: m.ProposalState | None = None, station: str | None = None, vehicle: str | None = None, session: int | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.Proposal]:
        """List sets of teaching events and what became of them; go on with ``after`` = ``next``."""
        return cast("m.Page[m.Proposal]", await self._call("GET", "/api/v1/teaching/proposals", params={"state": state, "station": station, "vehicle": vehicle, "session": session, "after": after, "limit": limit}))

    async def get_proposal(self, proposal: int, *, shft: int | None = None, rota: int | None = None, lift: int | None = None) -> m.ProposalDetail:
        """Show a proposal with every port and vehicle whose pulses it changes, old and new, and whether it is far off."""
        return cast("m.ProposalDetail", await self._call("GET", f"/api/v1/teaching/proposals/{path(proposal)}", params={"shft": shft, "rota": rota, "lift": lift}))

    async def approve_proposal(self, proposal: int, body: m.ApproveIn) -> m.ProposalDetail:
        """Make the version that the proposal shows; with If-Match only if nothing has changed since it was looked at."""
        return cast("m.ProposalDetail", await self._call("POST", f"/api/v1/teaching/proposals/{path(proposal)}/approve", body=body))

    async def reject_proposal(self, proposal: int, body: m.RejectIn) -> m.ProposalDetail:
        """Make nothing of a proposal; its raw events stay."""
        return cast("m.ProposalDetail", await self._call("POST", f"/api/v1/teaching/proposals/{path(proposal)}/reject", body=body))

    async def assign_proposal(self, proposal: int, body: m.AssignIn) -> m.ProposalDetail:
        """Say which of several ports at one barcode was taught."""
        return cast("m.ProposalDetail", await self._call("POST", f"/api/v1/teaching/proposals/{path(proposal)}/assign", body=body))

    async def list_teaching_events(self, *, vehicle: str | None = None, barcode: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.TeachingEvent]:
        """List what vehicles sent, as they sent it; go on with ``after`` = ``next``."""
        return cast("m.Page[m.TeachingEvent]", await self._call("GET", "/api/v1/teaching/events", params={"vehicle": vehicle, "barcode": barcode, "after": after, "limit": limit}))

    async def get_target(self, station: str, vehicle: str) -> m.TaughtTarget:
        """Show what a vehicle would be sent at a port, and from which rows; nothing is sent."""
        return cast("m.TaughtTarget", await self._call("GET", f"/api/v1/teaching/targets/{path(station)}/{path(vehicle)}"))

    async def compare_dests(self, station: str, old: int, new: int) -> m.TaughtComparison:
        """Compare two versions of a port's DEST: the differences, and what each vehicle would be sent."""
        return cast("m.TaughtComparison", await self._call("GET", f"/api/v1/teaching/compare/stations/{path(station)}/{path(old)}/{path(new)}"))

    async def compare_offsets(self, vehicle: str, old: int, new: int) -> m.TaughtComparison:
        """Compare two versions of a vehicle's OFFSET: the differences, and what it would be sent at each port."""
        return cast("m.TaughtComparison", await self._call("GET", f"/api/v1/teaching/compare/vehicles/{path(vehicle)}/{path(old)}/{path(new)}"))

    async def compare_two_vehicles(self, vehicle: str, other: str, *, station: str | None = None) -> m.VehicleComparison:
        """Compare the OFFSETs of two vehicles, and what each would be sent at a port (all ports, if none is named)."""
        return cast("m.VehicleComparison", await self._call("GET", f"/api/v1/teaching/compare/offsets/{path(vehicle)}/{path(other)}", params={"station": station}))

    async def list_drift(self, *, shft: int | None = None, rota: int | None = None, lift: int | None = None) -> m.Page[m.DriftRow]:
        """List ports and vehicles whose newest version is farther from the one before than so many pulses."""
        return cast("m.Page[m.DriftRow]", await self._call("GET", "/api/v1/teaching/drift", params={"shft": shft, "rota": rota, "lift": lift}))

    async def roll_back_dest(self, station: str, body: m.RollBackIn) -> m.TaughtComparison:
        """Make a new version of a port's DEST that equals an old one; with If-Match only if nobody wrote meanwhile."""
        return cast("m.TaughtComparison", await self._call("POST", f"/api/v1/stations/{path(station)}/dest/rollback", body=body))

    async def roll_back_offset(self, vehicle: str, body: m.RollBackIn) -> m.TaughtComparison:
        """The same with a vehicle's OFFSET."""
        return cast("m.TaughtComparison", await self._call("POST", f"/api/v1/vehicles/{path(vehicle)}/offset/rollback", body=body))

    async def export_dests(self, *, format: Literal['json', 'csv'] | None = None, history: bool | None = None) -> m.Page[m.TaughtDest]:
        """Export the taught values of ports."""
        return cast("m.Page[m.TaughtDest]", await self._call("GET", "/api/v1/teaching/dests", params={"format": format, "history": history}))

    async def export_offsets(self, *, format: Literal['json', 'csv'] | None = None, history: bool | None = None) -> m.Page[m.TaughtOffset]:
        """Export the taught values of vehicles."""
        return cast("m.Page[m.TaughtOffset]", await self._call("GET", "/api/v1/teaching/offsets", params={"format": format, "history": history}))

    async def import_dests(self, body: dict[str, Any], *, dry_run: bool | None = None) -> m.ImportReport:
        """Import the taught values of ports: all rows or none. With ``dry_run`` only say what would become of each."""
        return cast("m.ImportReport", await self._call("POST", "/api/v1/teaching/dests/import", body=body, params={"dry_run": dry_run}))

    async def import_offsets(self, body: dict[str, Any], *, dry_run: bool | None = None) -> m.ImportReport:
        """Import the taught values of vehicles, likewise."""
        return cast("m.ImportReport", await self._call("POST", "/api/v1/teaching/offsets/import", body=body, params={"dry_run": dry_run}))

    async def list_devices(self) -> m.Page[m.Device]:
        """List doors, buffers and chargers as they are now."""
        return cast("m.Page[m.Device]", await self._call("GET", "/api/v1/devices"))

    async def get_device(self, device: str) -> m.Device:
        """Show one device: its state, who is in it or waits for it, what is wrong with it."""
        return cast("m.Device", await self._call("GET", f"/api/v1/devices/{path(device)}"))

    async def get_device_frames(self, device: str, *, lang: Literal['en', 'ko'] | None = None) -> m.Page[m.Frame]:
        """Show the last bytes on a device's link, explained: its own and those of the others there. A charger has none."""
        return cast("m.Page[m.Frame]", await self._call("GET", f"/api/v1/devices/{path(device)}/frames", params={"lang": lang}))

    async def list_device_commands(self, device: str, *, limit: int | None = None) -> m.Page[m.Command]:
        """List what a device was asked and what became of it."""
        return cast("m.Page[m.Command]", await self._call("GET", f"/api/v1/devices/{path(device)}/commands", params={"limit": limit}))

    async def command_device(self, device: str, body: m.DeviceCommandIn) -> m.DeviceTaken:
        """Open or close a door, lock or unlock a buffer."""
        return cast("m.DeviceTaken", await self._call("POST", f"/api/v1/devices/{path(device)}/commands", body=body))

    async def get_device_command(self, device: str, command: str) -> m.Command:
        """Show one command by its 16 hex digits."""
        return cast("m.Command", await self._call("GET", f"/api/v1/devices/{path(device)}/commands/{path(command)}"))

    async def pin_door(self, device: str, body: m.PinIn) -> m.Device:
        """Keep a door open or closed, whatever vehicles want."""
        return cast("m.Device", await self._call("PUT", f"/api/v1/devices/{path(device)}/pin", body=body))

    async def unpin_door(self, device: str) -> m.Device:
        """Give a door back to the vehicles."""
        return cast("m.Device", await self._call("DELETE", f"/api/v1/devices/{path(device)}/pin"))

    async def lock_out_device(self, device: str, body: m.ReasonIn) -> m.Device:
        """People are at the device: no remote command and no grant there until they say so."""
        return cast("m.Device", await self._call("POST", f"/api/v1/devices/{path(device)}/lockout", body=body))

    async def lift_device_lockout(self, device: str) -> m.Device:
        """Lift a lockout: its owner alone, or two others together."""
        return cast("m.Device", await self._call("DELETE", f"/api/v1/devices/{path(device)}/lockout"))

    async def set_device_service(self, device: str, body: m.ServiceIn) -> m.Device:
        """Take a device out of service, or put it back: a charger, a buffer or a door that vehicles are not to use."""
        return cast("m.Device", await self._call("PUT", f"/api/v1/devices/{path(device)}/service", body=body))

    async def raise_emergency(self, body: m.EmergencyIn) -> m.Controller:
        """Stop everything where it is, open or close doors as configured, until somebody releases it. Safe to repeat."""
        return cast("m.Controller", await self._call("POST", "/api/v1/controller/emergency", body=body))

    async def release_emergency(self, body: m.EmergencyIn) -> m.Controller:
        """A named person says that it is over; the controller stays paused until it is resumed."""
        return cast("m.Controller", await self._call("POST", "/api/v1/controller/emergency/release", body=body))

    async def list_closures(self) -> m.Page[m.Closure]:
        """List the closures in force: each is one reason, and a place opens with the last of its reasons."""
        return cast("m.Page[m.Closure]", await self._call("GET", "/api/v1/closures"))

    async def close_place(self, body: m.ClosureIn) -> m.Closure:
        """Close a place: nobody comes in, those inside drive out, then its state is closed. It outlives restarts."""
        return cast("m.Closure", await self._call("POST", "/api/v1/closures", body=body))

    async def preview_closure(self, body: m.PreviewIn) -> m.ClosurePreview:
        """Show what closing a place would do, and change nothing: stations, vehicles, jobs, and how much longer routes
        get.
        """
        return cast("m.ClosurePreview", await self._call("POST", "/api/v1/closures/preview", body=body))

    async def list_past_closures(self, *, after: int | None = None, limit: int | None = None) -> m.Page[m.Closure]:
        """List closures, over or not; go on with ``after`` = ``next``."""
        return cast("m.Page[m.Closure]", await self._call("GET", "/api/v1/closures/history", params={"after": after, "limit": limit}))

    async def get_closure(self, closure: int) -> m.Closure:
        """Show one closure, over or not: who is still inside, and what they wait for."""
        return cast("m.Closure", await self._call("GET", f"/api/v1/closures/{path(closure)}"))

    async def open_place(self, closure: int, body: m.OpenIn) -> m.Closure:
        """End a closure. One for people's work is opened by its owner alone, or by two others together."""
        return cast("m.Closure", await self._call("POST", f"/api/v1/closures/{path(closure)}/open", body=body))

    async def show_moment(self, *, at: str | None = None) -> m.Moment:
        """Show the plant as it was at a moment: vehicles, jobs, stations, carriers, devices, closures, alarms."""
        return cast("m.Moment", await self._call("GET", "/api/v1/history", params={"at": at}))

    async def show_span(self) -> m.Span:
        """Show from when to when there is playback, and how large it is."""
        return cast("m.Span", await self._call("GET", "/api/v1/history/span"))

    async def show_heat(self, *, from_: str | None = None, to: str | None = None) -> m.Heat:
        """Show where vehicles waited and where many came by in a period (by default the last hour), by barcode. It is
        counted by the five minutes: `from` and `to` in the answer say from when to when, and are null where nothing
        was.
        """
        return cast("m.Heat", await self._call("GET", "/api/v1/history/heat", params={"from": from_, "to": to}))

    async def list_changes(self, *, from_: str | None = None, to: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.PlaybackChange]:
        """List what changed in a period (by default the last hour). Of a vehicle a change has only the fields that are
        other now.
        """
        return cast("m.Page[m.PlaybackChange]", await self._call("GET", "/api/v1/history/changes", params={"from": from_, "to": to, "after": after, "limit": limit}))

    async def list_past_events(self, *, from_: str | None = None, to: str | None = None, of_note: bool | None = None, newest: bool | None = None, job: str | None = None, vehicle: str | None = None, limit: int | None = None) -> m.Page[m.Event]:
        """List the events of a period (by default the last hour): the first, or the newest. All of them: `GET /events`."""
        return cast("m.Page[m.Event]", await self._call("GET", "/api/v1/history/events", params={"from": from_, "to": to, "of_note": of_note, "newest": newest, "job": job, "vehicle": vehicle, "limit": limit}))

    async def show_statistics(self, *, from_: str | None = None, to: str | None = None, interval: int | None = None) -> m.Statistics:
        """Show what a period came to (by default the last day): delivery times by phase, throughput, queue, vehicles,
        waits.
        """
        return cast("m.Statistics", await self._call("GET", "/api/v1/statistics", params={"from": from_, "to": to, "interval": interval}))

    async def list_walks(self) -> m.Page[m.Walk]:
        """List the audit walks that are under way."""
        return cast("m.Page[m.Walk]", await self._call("GET", "/api/v1/walks"))

    async def start_walk(self, body: m.WalkIn) -> m.Walk:
        """Begin a walk; what is believed of its places is written down. Vehicles go on meanwhile: what changes is marked
        moved.
        """
        return cast("m.Walk", await self._call("POST", "/api/v1/walks", body=body))

    async def list_past_walks(self, *, after: int | None = None, limit: int | None = None) -> m.Page[m.Walk]:
        """List audit walks, ended or not; go on with ``after`` = ``next``."""
        return cast("m.Page[m.Walk]", await self._call("GET", "/api/v1/walks/history", params={"after": after, "limit": limit}))

    async def get_walk(self, walk: int) -> m.Walk:
        """Show one walk, ended or not."""
        return cast("m.Walk", await self._call("GET", f"/api/v1/walks/{path(walk)}"))

    async def list_walk_places(self, walk: int, *, finding: m.Finding | None = None) -> m.Page[m.WalkPlace]:
        """List the places of a walk: what was believed, what is believed now, what was seen, and what that comes to."""
        return cast("m.Page[m.WalkPlace]", await self._call("GET", f"/api/v1/walks/{path(walk)}/places", params={"finding": finding}))

    async def enter_sights(self, walk: int, body: m.SightsIn) -> m.Walk:
        """Write down what stands at several places: all or nothing."""
        return cast("m.Walk", await self._call("POST", f"/api/v1/walks/{path(walk)}/places", body=body))

    async def enter_sight(self, walk: int, station: str, body: m.SightIn) -> m.Walk:
        """Write down what stands at one place; a later entry replaces the one before."""
        return cast("m.Walk", await self._call("PUT", f"/api/v1/walks/{path(walk)}/places/{path(station)}", body=body))

    async def accept_walk(self, walk: int, body: m.AcceptIn) -> m.Walk:
        """A named person takes what was seen for true: its places and carriers are verified from now on."""
        return cast("m.Walk", await self._call("POST", f"/api/v1/walks/{path(walk)}/accept", body=body))

    async def abandon_walk(self, walk: int, body: m.AbandonIn) -> m.Walk:
        """End a walk; nothing is believed for it."""
        return cast("m.Walk", await self._call("POST", f"/api/v1/walks/{path(walk)}/abandon", body=body))

    async def list_active_alarms(self) -> m.Page[m.Alarm]:
        """List the alarms that there are now."""
        return cast("m.Page[m.Alarm]", await self._call("GET", "/api/v1/alarms/active"))

    async def list_alarms(self, *, kind: m.AlarmKind | None = None, source: str | None = None, code: str | None = None, active: bool | None = None, acknowledged: bool | None = None, from_: str | None = None, to: str | None = None, after: int | None = None, limit: int | None = None) -> m.Page[m.Alarm]:
        """List alarms, ended or not, of a period or of all time; go on with ``after`` = ``next``."""
        return cast("m.Page[m.Alarm]", await self._call("GET", "/api/v1/alarms", params={"kind": kind, "source": source, "code": code, "active": active, "acknowledged": acknowledged, "from": from_, "to": to, "after": after, "limit": limit}))

    async def count_alarms(self, *, by: Literal['code', 'source', 'both'] | None = None, from_: str | None = None, to: str | None = None, limit: int | None = None) -> m.Page[m.AlarmCount]:
        """Count alarms of a period (by default the last 7 days): how often and how long, by code, by machine, or by both."""
        return cast("m.Page[m.AlarmCount]", await self._call("GET", "/api/v1/alarms/pareto", params={"by": by, "from": from_, "to": to, "limit": limit}))

    async def show_reliability(self, *, from_: str | None = None, to: str | None = None) -> m.Page[m.Reliability]:
        """Show how vehicles held out in a period (by default the last 7 days), up to now: failures, MTBF, MTTR,
        availability.
        """
        return cast("m.Page[m.Reliability]", await self._call("GET", "/api/v1/alarms/reliability", params={"from": from_, "to": to}))

    async def get_alarm(self, alarm: int) -> m.Alarm:
        """Show one alarm, ended or not."""
        return cast("m.Alarm", await self._call("GET", f"/api/v1/alarms/{path(alarm)}"))

    async def acknowledge_alarms(self, body: m.NotedAlarmsIn) -> m.Page[m.AlarmAnswer]:
        """A named person knows of several alarms that have one cause: each is answered, and kept in the audit, by itself.
        One that there is not keeps no other from being acknowledged.
        """
        return cast("m.Page[m.AlarmAnswer]", await self._call("POST", "/api/v1/alarms/acknowledge", body=body))

    async def acknowledge_alarm(self, alarm: int, body: m.NoteIn) -> m.Alarm:
        """A named person knows of an alarm; the first one stays. It goes on until its cause is gone."""
        return cast("m.Alarm", await self._call("POST", f"/api/v1/alarms/{path(alarm)}/acknowledge", body=body))

    async def list_zones(self) -> m.Page[m.Zone]:
        """List the plant's zones with who holds track in them, and whether they are paused."""
        return cast("m.Page[m.Zone]", await self._call("GET", "/api/v1/zones"))

    async def get_zone(self, zone: str) -> m.Zone:
        """Show one zone."""
        return cast("m.Zone", await self._call("GET", f"/api/v1/zones/{path(zone)}"))

    async def pause_zone(self, zone: str, body: m.ReasonIn) -> m.Zone:
        """Begin no movement in a zone and let nobody in; what moves there comes to rest at the end of its grant."""
        return cast("m.Zone", await self._call("POST", f"/api/v1/zones/{path(zone)}/pause", body=body))

    async def stop_zone(self, zone: str, body: m.ReasonIn) -> m.Zone:
        """Pause a zone, and stop what drives there where it is. Vehicles keep AUTO."""
        return cast("m.Zone", await self._call("POST", f"/api/v1/zones/{path(zone)}/stop", body=body))

    async def resume_zone(self, zone: str) -> m.Zone:
        """Let vehicles go on in a zone."""
        return cast("m.Zone", await self._call("POST", f"/api/v1/zones/{path(zone)}/resume"))

    async def get_controller(self) -> m.Controller:
        """Show the controller's state, and what it still waits for after a start."""
        return cast("m.Controller", await self._call("GET", "/api/v1/controller"))

    async def pause(self, body: m.ReasonIn) -> m.Controller:
        """Begin no new movement; what moves comes to rest."""
        return cast("m.Controller", await self._call("POST", "/api/v1/controller/pause", body=body))

    async def stop_all(self, body: m.ReasonIn) -> m.Controller:
        """Stop every vehicle that moves where it is, and begin no new movement. Vehicles keep AUTO; resume to go on."""
        return cast("m.Controller", await self._call("POST", "/api/v1/controller/stop", body=body))

    async def resume(self) -> m.Controller:
        """Go on."""
        return cast("m.Controller", await self._call("POST", "/api/v1/controller/resume"))

    async def get_layout(self) -> m.Layout:
        """Show the layout; it changes with the plant file only."""
        return cast("m.Layout", await self._call("GET", "/api/v1/layout"))

    async def list_routes(self, *, from_: str | None = None, to: str | None = None, k: int | None = None) -> m.Page[m.RouteView]:
        """Show the quickest routes between two places as they would be planned now: around closures, with the present
        delays.
        """
        return cast("m.Page[m.RouteView]", await self._call("GET", "/api/v1/layout/routes", params={"from": from_, "to": to, "k": k}))

    async def list_versions(self, *, after: int | None = None, limit: int | None = None) -> m.Page[m.PlantVersion]:
        """List the versions of the plant; go on with ``after`` = ``next``."""
        return cast("m.Page[m.PlantVersion]", await self._call("GET", "/api/v1/layout/versions", params={"after": after, "limit": limit}))

    async def stage_version(self, *, reason: str | None = None) -> m.StagedVersion:
        """Stage a plant file. One with errors is refused with all of them, each with line, column and remedy."""
        return cast("m.StagedVersion", await self._call("POST", "/api/v1/layout/versions", params={"reason": reason}))

    async def get_version(self, version: int) -> m.PlantVersion:
        """Show one version, without its text."""
        return cast("m.PlantVersion", await self._call("GET", f"/api/v1/layout/versions/{path(version)}"))

    async def list_version_findings(self, version: int) -> m.Page[m.PlantFinding]:
        """List what the checker says to a version."""
        return cast("m.Page[m.PlantFinding]", await self._call("GET", f"/api/v1/layout/versions/{path(version)}/findings"))

    async def compare_version(self, version: int, *, against: int | None = None) -> m.PlantDifference:
        """Show what is different in a version, and what that breaks in a plant that has run."""
        return cast("m.PlantDifference", await self._call("GET", f"/api/v1/layout/versions/{path(version)}/diff", params={"against": against}))

    async def weigh_version(self, version: int) -> m.PlantImpact:
        """Show what would stand in the way of a version if it became active now, what would be lost, and what has to be
        taught.
        """
        return cast("m.PlantImpact", await self._call("GET", f"/api/v1/layout/versions/{path(version)}/impact"))

    async def activate_version(self, version: int, body: m.ActivateIn) -> m.PlantActivation:
        """Let a version be the active one; a former one: roll back. Refused, with a list, if it breaks anything under
        way. The controller changes over within seconds: connections are cut, vehicles end what they were granted, jobs
        go on. Ask for the version until it is ``active``; if it is not ``awaited`` any more either, ``note`` says why.
        """
        return cast("m.PlantActivation", await self._call("POST", f"/api/v1/layout/versions/{path(version)}/activate", body=body))

    async def reject_version(self, version: int, body: m.RejectVersionIn) -> m.PlantVersion:
        """Let a staged or awaited version not become active. A former one that is awaited stays a former one."""
        return cast("m.PlantVersion", await self._call("POST", f"/api/v1/layout/versions/{path(version)}/reject", body=body))

    async def list_audit(self, *, after: int | None = None, limit: int | None = None, actor: str | None = None, action: str | None = None, target: str | None = None, accepted: bool | None = None, from_: str | None = None, to: str | None = None, order: Literal['oldest', 'newest'] | None = None) -> m.Page[m.Audit]:
        """List what people and hosts asked for, refused or not: all oldest first, or what is looked for newest first."""
        return cast("m.Page[m.Audit]", await self._call("GET", "/api/v1/audit", params={"after": after, "limit": limit, "actor": actor, "action": action, "target": target, "accepted": accepted, "from": from_, "to": to, "order": order}))

    async def check_audit(self, *, after: int | None = None, limit: int | None = None) -> m.AuditCheck:
        """Look whether each row of the audit follows from the one before it; go on with ``after`` = ``next``."""
        return cast("m.AuditCheck", await self._call("GET", "/api/v1/audit/check", params={"after": after, "limit": limit}))

    async def who_am_i(self) -> m.Caller:
        """Show who calls, and what they may."""
        return cast("m.Caller", await self._call("GET", "/api/v1/session"))

    async def log_in(self, body: m.LogInIn) -> m.Session:
        """Log in with name and password. The token goes into the header ``Authorization: Bearer TOKEN``."""
        return cast("m.Session", await self._call("POST", "/api/v1/session", body=body))

    async def log_out(self) -> None:
        """Log out: the token, and those that it was renewed from, are good no longer."""
        await self._call("DELETE", "/api/v1/session")

    async def show_required(self) -> m.Required:
        """Show whether callers have to say who they are: a page asks for a log-in then, before it asks for anything else."""
        return cast("m.Required", await self._call("GET", "/api/v1/session/required"))

    async def list_calls(self) -> m.Page[m.Call]:
        """List every call with the roles that may, and whether the caller may: what a page shows as buttons that can be
        pressed.
        """
        return cast("m.Page[m.Call]", await self._call("GET", "/api/v1/session/calls"))

    async def renew_session(self) -> m.Session:
        """Give a new token for this one, which ends half a minute later."""
        return cast("m.Session", await self._call("POST", "/api/v1/session/renew"))

    async def change_password(self, body: m.NewPasswordIn) -> None:
        """Have a new password."""
        await self._call("PUT", "/api/v1/session/password", body=body)

    async def list_users(self) -> m.Page[m.User]:
        """List the people who may log in, and those who may not any more."""
        return cast("m.Page[m.User]", await self._call("GET", "/api/v1/users"))

    async def add_user(self, body: m.UserIn) -> m.User:
        """Add a person. From the first one on, everybody has to log in."""
        return cast("m.User", await self._call("POST", "/api/v1/users", body=body))

    async def get_user(self, user: str) -> m.User:
        """Show a person."""
        return cast("m.User", await self._call("GET", f"/api/v1/users/{path(user)}"))

    async def change_user(self, user: str, body: m.UserChange) -> m.User:
        """Change roles, disable or enable, give a new password; the last two log the person out."""
        return cast("m.User", await self._call("PATCH", f"/api/v1/users/{path(user)}", body=body))

    async def list_keys(self) -> m.Page[m.Key]:
        """List keys, those that have ended too. No key itself is ever shown again."""
        return cast("m.Page[m.Key]", await self._call("GET", "/api/v1/keys"))

    async def add_key(self, body: m.MachineKeyIn) -> m.NewKey:
        """Make a key for a machine: 256 random bits, of which a digest is kept."""
        return cast("m.NewKey", await self._call("POST", "/api/v1/keys", body=body))

    async def get_key(self, key: str) -> m.Key:
        """Show what is known of a key."""
        return cast("m.Key", await self._call("GET", f"/api/v1/keys/{path(key)}"))

    async def revoke_key(self, key: str) -> m.Key:
        """End a key for ever; what it holds open is cut."""
        return cast("m.Key", await self._call("DELETE", f"/api/v1/keys/{path(key)}"))

    async def list_problems(self) -> m.Page[m.ProblemKind]:
        """List the stable codes of problems."""
        return cast("m.Page[m.ProblemKind]", await self._call("GET", "/api/v1/problems"))

    async def get_problem(self, code: str) -> m.ProblemKind:
        """Show one kind of problem: what a problem's ``type`` leads to."""
        return cast("m.ProblemKind", await self._call("GET", f"/api/v1/problems/{path(code)}"))

    async def give_ticket(self) -> m.Ticket:
        """Give a ticket for ``/api/v1/live?ticket=...``: browsers cannot send a key with a WebSocket."""
        return cast("m.Ticket", await self._call("POST", "/api/v1/live/ticket"))

    async def list_webhooks(self) -> m.Page[m.Webhook]:
        """List webhooks, with how far each has been told."""
        return cast("m.Page[m.Webhook]", await self._call("GET", "/api/v1/webhooks"))

    async def add_webhook(self, body: m.WebhookIn) -> m.WebhookWithSecret:
        """Subscribe a URL. Every event wanted is delivered in order, signed, until it is taken; nothing is lost by a
        crash.
        """
        return cast("m.WebhookWithSecret", await self._call("POST", "/api/v1/webhooks", body=body))

    async def get_webhook(self, webhook: int) -> m.Webhook:
        """Show one webhook."""
        return cast("m.Webhook", await self._call("GET", f"/api/v1/webhooks/{path(webhook)}"))

    async def change_webhook(self, webhook: int, body: m.WebhookChange) -> m.Webhook:
        """Change a webhook, pause it, or take it up again where it was."""
        return cast("m.Webhook", await self._call("PATCH", f"/api/v1/webhooks/{path(webhook)}", body=body))

    async def remove_webhook(self, webhook: int) -> None:
        """Remove a webhook for ever."""
        await self._call("DELETE", f"/api/v1/webhooks/{path(webhook)}")

    async def renew_webhook_secret(self, webhook: int, body: m.SecretIn) -> m.WebhookWithSecret:
        """Sign with a new secret; for a while with the old one too."""
        return cast("m.WebhookWithSecret", await self._call("POST", f"/api/v1/webhooks/{path(webhook)}/secret", body=body))

    async def replay_webhook(self, webhook: int, body: m.ReplayIn) -> m.Webhook:
        """Tell it all events above a number, as far as they are kept, before it goes on."""
        return cast("m.Webhook", await self._call("POST", f"/api/v1/webhooks/{path(webhook)}/replay", body=body))

    async def ping_webhook(self, webhook: int) -> m.WebhookDelivery:
        """Deliver a test event at once, and say what became of it."""
        return cast("m.WebhookDelivery", await self._call("POST", f"/api/v1/webhooks/{path(webhook)}/ping"))

    async def list_webhook_deliveries(self, webhook: int, *, after: int | None = None, limit: int | None = None) -> m.Page[m.WebhookDelivery]:
        """List the deliveries that were tried; the last 200 are kept. Go on with ``after`` = ``next``."""
        return cast("m.Page[m.WebhookDelivery]", await self._call("GET", f"/api/v1/webhooks/{path(webhook)}/deliveries", params={"after": after, "limit": limit}))

    async def healthz(self) -> m.Health:
        """Say that the server runs."""
        return cast("m.Health", await self._call("GET", "/healthz"))

    async def readyz(self) -> m.Readiness:
        """Say whether the controller can take jobs, and why not."""
        return cast("m.Readiness", await self._call("GET", "/readyz"))
