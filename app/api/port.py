"""What the API needs of the controller and of the store's reading side."""

from collections.abc import Awaitable, Sequence
from typing import Protocol

from app.api.room_port import RoomReader
from app.api.teaching_port import TeachingReader
from app.domain.drive import DriveId
from app.domain.drive_records import DriveBackup, DriveOperation
from app.domain.drive_requests import Word
from app.domain.ids import CmdId, JobId, LinkId, VehicleId
from app.domain.job import Job
from app.domain.layout import Plant
from app.domain.records import AuditRow, HistoryEvent, Intent
from app.domain.requests import Reply, Request
from app.domain.units import Barcode, Timestamp
from app.domain.view import LineView
from app.domain.webhooks import Webhook, WebhookProgress, WebhookTry
from app.domain.why import Why
from app.fleet.closure_preview import Survey
from app.planning.routing import Route
from app.protocols.itsc.session import LinkQuality
from app.runtime.hub import Hub, ReadModel
from app.runtime.metrics import Figures
from app.runtime.playback import Playback
from app.runtime.reception import Reception
from app.runtime.versions import Versions
from app.runtime.webhooks import Targets
from app.store.chain import Checked


class Reader(TeachingReader, RoomReader, Protocol):
    """Committed history; blocking, called from the thread pool. Raises StoreError."""

    def job(self, job: JobId) -> Job | None:
        """Return one job, ended or not."""
        ...

    def why(self, order: int) -> Why | None:
        """Return what is kept of a job's why, by the job's order."""
        ...

    def jobs_named(self, names: Sequence[JobId]) -> Sequence[Job]:
        """Return those of the named jobs that there are, ended or not, in any order."""
        ...

    def job_count(self) -> int:
        """Return how many jobs there have been."""
        ...

    def job_names(self, after: int, limit: int) -> Sequence[tuple[int, str]]:
        """Return orders above ``after`` and the names of their jobs, oldest first."""
        ...

    def job_by_key(self, key: str) -> Job | None:
        """Return the job first accepted under that idempotency key within its life of 7 days."""
        ...

    def jobs(
        self,
        *,
        state: str | None = None,
        carrier: str | None = None,
        vehicle: str | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> Sequence[Job]:
        """Return jobs, newest first, with orders below ``after``."""
        ...

    def events(
        self, after: int = 0, limit: int = 100, *, job: str | None = None, vehicle: str | None = None
    ) -> Sequence[HistoryEvent]:
        """Return events numbered above ``after``, oldest first."""
        ...

    def webhook_tries(self, webhook: int, after: int | None = None, limit: int = 100) -> Sequence[WebhookTry]:
        """Return a webhook's deliveries numbered below ``after``, newest first."""
        ...

    def intent(self, cmd_id: CmdId) -> Intent | None:
        """Return one command."""
        ...

    def intents(self, vehicle: VehicleId, limit: int = 100) -> Sequence[Intent]:
        """Return a vehicle's commands, newest first."""
        ...

    def audit(self, after: int = 0, limit: int = 100) -> Sequence[tuple[int, AuditRow]]:
        """Return numbered audit rows above ``after``, oldest first."""
        ...

    def audit_found(
        self,
        *,
        actor: str | None = None,
        action: str | None = None,
        target: str | None = None,
        accepted: bool | None = None,
        begin: float | None = None,
        end: float | None = None,
        before: int | None = None,
        limit: int = 100,
    ) -> Sequence[tuple[int, AuditRow]]:
        """Return numbered audit rows, newest first, with numbers below ``before``."""
        ...

    def audit_checked(self, after: int, limit: int) -> Checked:
        """Look whether the rows above ``after`` follow from one another. Raises StoreError."""
        ...

    def operation(self, number: int) -> DriveOperation | None:
        """Return one operation on drives."""
        ...

    def operations(
        self, *, drive: str | None = None, line: str | None = None, after: int | None = None, limit: int = 100
    ) -> Sequence[DriveOperation]:
        """Return operations numbered below ``after``, newest first."""
        ...

    def backup(self, number: int) -> DriveBackup | None:
        """Return one backup of a drive."""
        ...

    def backups(self, drive: DriveId, after: int | None = None, limit: int = 100) -> Sequence[DriveBackup]:
        """Return a drive's backups numbered below ``after``, newest first."""
        ...


class Controller(Protocol):
    """The running controller."""

    @property
    def model(self) -> ReadModel:
        """What has been published so far."""
        ...

    @property
    def hub(self) -> Hub:
        """The fan-out of what is published."""
        ...

    @property
    def figures(self) -> Figures:
        """What is counted as it happens."""
        ...

    @property
    def targets(self) -> Targets:
        """Where webhooks may lead."""
        ...

    def webhooks(self) -> Sequence[tuple[Webhook, WebhookProgress]]:
        """Return all webhooks, and how far each has been told."""
        ...

    async def ping_webhook(self, number: int) -> WebhookTry | None:
        """Deliver a test; None: there is no such webhook."""
        ...

    @property
    def backlog(self) -> tuple[int, int]:
        """Batches that wait for the writer, and decisions that are not durable yet."""
        ...

    def waits(self) -> dict[str, int]:
        """Return how many vehicles wait for what, by cause."""
        ...

    def named_quality(self) -> Sequence[tuple[VehicleId, LinkQuality]]:
        """Return the figures of every hoist's line, by the hoist's name."""
        ...

    @property
    def reader(self) -> Reader:
        """Committed history."""
        ...

    @property
    def reception(self) -> Reception | None:
        """Who may call, and what they and administrators do about it; None: everybody may."""
        ...

    @property
    def plant(self) -> Plant:
        """The plant under control."""
        ...

    @property
    def versions(self) -> Versions | None:
        """The versions of the plant; None: none are kept."""
        ...

    @property
    def version(self) -> int | None:
        """Which of them is under control."""
        ...

    @property
    def trouble(self) -> str:
        """Why nothing can be made durable just now; empty if all is well."""
        ...

    def ask(self, request: Request) -> Awaitable[Reply]:
        """Put a request to the controller; returns when the answer is durable. Raises TimeoutError: there is none in time."""
        ...

    def frames(self, vehicle: VehicleId) -> Sequence[tuple[Timestamp, str, bytes]]:
        """Return the last frames on a vehicle's line, oldest first, as (when, ``in`` or ``out``, bytes)."""
        ...

    def tell(self, word: Word) -> Reply:
        """Take a word that changes nothing that is kept; it takes effect at once, whatever the database does."""
        ...

    def links(self) -> Sequence[LineView]:
        """Return how the links that carry several devices are doing."""
        ...

    def link_frames(self, link: LinkId) -> Sequence[tuple[Timestamp, str, bytes]]:
        """Return the last frames on a link, oldest first, as (when, ``in`` or ``out``, bytes)."""
        ...

    def routes(self, start: Barcode, goal: Barcode, most: int) -> Sequence[Route]:
        """Return the quickest routes as they would be planned now, quickest first. Raises NoRoute."""
        ...

    @property
    def playback(self) -> Playback | None:
        """What was recorded for playback; None: nothing is."""
        ...

    def survey(self) -> Survey:
        """Return the fleet at this moment, fixed."""
        ...

    def utc(self) -> Timestamp:
        """Return the present moment."""
        ...
