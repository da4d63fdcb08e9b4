"""All families of one scrape."""

import platform
import sys
from collections import Counter
from collections.abc import Iterator

from prometheus_client import CollectorRegistry, GCCollector, ProcessCollector
from prometheus_client.metrics_core import Metric

from app.domain.units import Timestamp
from app.domain.webhooks import WebhookState
from app.runtime.metrics import lines, plant
from app.runtime.metrics.figures import Measured
from app.runtime.metrics.shapes import alone, counter, counters, gauge, gauges, histogram

_PROCESS = CollectorRegistry()
ProcessCollector(registry=_PROCESS)
GCCollector(registry=_PROCESS)


def families(controller: Measured, version: str, now: Timestamp) -> Iterator[Metric]:
    """Give the families of ``/metrics``: everything but what is per line. ``now`` is UTC."""
    model, figures = controller.hub.model, controller.figures
    built = {(version, platform.python_version(), sys.platform): 1.0}
    yield gauges("build_info", "The version that runs.", ["version", "python", "system"], built)
    yield from plant.controller(model, controller.trouble)
    yield from plant.vehicles(model, controller.waits())
    yield from plant.jobs(model, figures.jobs, now)
    yield from plant.alarms(model, figures.jobs)
    yield from plant.equipment(model)
    yield from lines.by_wire(lines.qualities(model, controller.named_quality(), controller.links()))
    yield from _service(controller)
    yield from _webhooks(controller, now)
    yield from _PROCESS.collect()


def _webhooks(controller: Measured, now: Timestamp) -> Iterator[Metric]:
    """Give how far those are told that want to be told by HTTP."""
    known, last = controller.webhooks(), controller.hub.model.last_event
    states = Counter(webhook.state for webhook, _ in known)
    shown = {state.value: float(states[state]) for state in WebhookState if state is not WebhookState.REMOVED}
    yield gauges("webhooks", "Webhooks, by their state.", ["state"], alone(shown))
    active = [progress for webhook, progress in known if webhook.state is WebhookState.ACTIVE]
    behind = max((last - progress.position for progress in active), default=0)
    yield gauge("webhook_behind_events", "Events that the active webhook farthest behind has not been told of.", behind)
    failing = max(
        ((0.0 if progress.failing is None else max(now - progress.failing, 0.0)) for progress in active), default=0.0
    )
    yield gauge("webhook_failing_seconds", "Since when the active webhook worst off takes nothing.", failing)
    tried = {name: float(controller.figures.webhook_tries[name]) for name in ("taken", "refused", "unreachable")}
    yield counters(
        "webhook_deliveries", "Deliveries that were tried, by what became of them.", ["outcome"], alone(tried)
    )


def line_families(controller: Measured) -> Iterator[Metric]:
    """Give the families of ``/metrics/lines``: one series a line."""
    found = lines.qualities(controller.hub.model, controller.named_quality(), controller.links())
    yield from lines.by_line(found)


def _service(controller: Measured) -> Iterator[Metric]:
    """Give how the process is doing: loop, writer, planner, watchers."""
    figures, hub = controller.figures, controller.hub
    waiting, uncommitted = controller.backlog
    yield histogram("loop_late_seconds", "How late the event loop was, four times a second.", figures.lateness)
    yield histogram("commit_seconds", "How long commits took.", figures.commit_seconds)
    yield histogram("commit_records", "Records in one commit.", figures.commit_records)
    yield counter(
        "commit_failures", "Commits that the database did not take; each is tried again.", figures.commit_failures
    )
    yield gauge("writer_waiting", "Batches that wait for the writer.", waiting)
    yield gauge("decisions_uncommitted", "Decisions that are not durable yet.", uncommitted)
    yield histogram(
        "tables_seconds", "From the wish for new routing tables until they were there.", figures.table_seconds
    )
    yield counter("tables_failures", "Planner processes that were lost.", figures.table_failures)
    yield gauge("watchers", "Live streams that are open.", hub.watchers)
    yield counter(
        "live_frames_dropped", "Frames of state that slow watchers got the newest state for.", hub.frames_dropped
    )
    yield counter("live_resyncs", "Resync marks given to watchers.", hub.resyncs)
    yield counter("live_catch_ups", "Watchers whose events were read from the store again.", hub.catch_ups)
