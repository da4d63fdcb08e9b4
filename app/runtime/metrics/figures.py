"""What is counted as it happens: spreads of durations and sizes, and how often something was."""

import asyncio
from collections import Counter
from collections.abc import Sequence
from typing import Protocol

from app.domain.ids import VehicleId
from app.domain.layout import Plant
from app.domain.view import LineView
from app.domain.webhooks import Webhook, WebhookProgress
from app.protocols.itsc.session import LinkQuality
from app.runtime.hub import Hub
from app.runtime.metrics.jobs import JobFigures
from app.runtime.metrics.spread import Spread

COMMITS = (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0)
"""Upper bounds of commit times, s. Our choice."""
BATCHES = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000)
"""Upper bounds of records in one commit. Our choice."""
LATE = (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0)
"""Upper bounds of the event loop's lateness, s. Our choice."""
TABLES = (0.01, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
"""Upper bounds of the time until new routing tables are there, s. Our choice."""
PROBE = 0.25
"""Seconds between two looks at how late the loop is. Our choice."""


class Figures:
    """The figures of one controller since its start. Fed by the controller, its writer and its planner."""

    def __init__(self, plant: Plant) -> None:
        self.jobs = JobFigures(plant)
        self.commit_seconds = Spread(COMMITS)
        self.commit_records = Spread(BATCHES)
        self.commit_failures = 0
        self.lateness = Spread(LATE)
        self.table_seconds = Spread(TABLES)
        self.table_failures = 0
        self.webhook_tries: Counter[str] = Counter()
        """Deliveries to webhooks, by what became of them: taken, refused, unreachable."""
        self._timer: asyncio.TimerHandle | None = None
        self._due = 0.0

    def committed(self, seconds: float, records: int) -> None:
        """Count a commit."""
        self.commit_seconds.see(seconds)
        self.commit_records.see(records)

    def start(self) -> None:
        """Begin to look how late the loop is."""
        loop = asyncio.get_running_loop()
        self._due = loop.time() + PROBE
        self._timer = loop.call_later(PROBE, self._look)

    def stop(self) -> None:
        """Look no more."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _look(self) -> None:
        loop = asyncio.get_running_loop()
        self.lateness.see(max(loop.time() - self._due, 0.0))
        self.start()


class Measured(Protocol):
    """What families are made of: a controller."""

    @property
    def figures(self) -> Figures:
        """What was counted as it happened."""
        ...

    @property
    def hub(self) -> Hub:
        """The fan-out, with the read model."""
        ...

    @property
    def trouble(self) -> str:
        """Why nothing can be made durable just now; empty if all is well."""
        ...

    @property
    def backlog(self) -> tuple[int, int]:
        """Batches that wait for the writer, and decisions that are not durable yet."""
        ...

    def waits(self) -> dict[str, int]:
        """Return how many vehicles wait for what, by cause."""
        ...

    def webhooks(self) -> Sequence[tuple[Webhook, WebhookProgress]]:
        """Return all webhooks, and how far each has been told."""
        ...

    def links(self) -> Sequence[LineView]:
        """Return how the links that carry several devices are doing."""
        ...

    def named_quality(self) -> Sequence[tuple[VehicleId, LinkQuality]]:
        """Return the figures of every hoist's line, by the hoist's name."""
        ...
