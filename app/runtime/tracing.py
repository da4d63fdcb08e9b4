"""A trace of each job for OpenTelemetry, if somebody wants them (extra ``hoistway[otel]``). Nothing is imported before.

One trace a job, made when it has ended: the span ``delivery`` from its acceptance to its end, and below it one span a phase.
Where to send them and under which name the standard variables say (OTEL_EXPORTER_OTLP_ENDPOINT, OTEL_SERVICE_NAME ...).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from app.domain.errors import HoistwayError
from app.domain.job import JobState
from app.runtime.metrics.jobs import CREATED, PHASES, Finished

if TYPE_CHECKING:
    from opentelemetry.sdk.trace import TracerProvider
    from opentelemetry.sdk.trace.export import SpanExporter

WHOLE = "whole"


class TracesMissing(HoistwayError):
    """Traces are wanted, and what makes them is not installed."""

    code = "traces-missing"


def provider(
    plant: str, version: str, environ: Mapping[str, str], exporter: SpanExporter | None = None
) -> TracerProvider:
    """Return what sends spans by OTLP over HTTP, in a thread of its own. Raises TracesMissing."""
    try:
        from opentelemetry.exporter.otlp.proto.http.trace_exporter import OTLPSpanExporter
        from opentelemetry.sdk.resources import Resource
        from opentelemetry.sdk.trace import TracerProvider
        from opentelemetry.sdk.trace.export import BatchSpanProcessor
    except ImportError as missing:
        raise TracesMissing(
            f"traces are wanted, and {missing.name} is not installed",
            remedy="Install hoistway[otel], or leave traces off.",
        ) from missing
    named = {} if "OTEL_SERVICE_NAME" in environ else {"service.name": "hoistway"}
    resource = Resource.create({**named, "service.version": version, "hoistway.plant": plant})
    made = TracerProvider(resource=resource, shutdown_on_exit=False)
    made.add_span_processor(BatchSpanProcessor(exporter or OTLPSpanExporter()))
    return made


class Traces:
    """Makes a trace of each job that ends."""

    def __init__(self, provider: TracerProvider) -> None:
        from opentelemetry.context import Context
        from opentelemetry.trace import Status, StatusCode, set_span_in_context

        self._provider = provider
        self._tracer = provider.get_tracer("hoistway")
        self._nothing = Context()
        self._within = set_span_in_context
        self._failed = Status(StatusCode.ERROR)

    def take(self, job: Finished) -> None:
        """Make the trace of a job."""
        end, marks = job.event, job.marks
        about = {
            "hoistway.job": job.job,
            "hoistway.vehicle": end.vehicle,
            "hoistway.carrier": end.carrier,
            "hoistway.source": end.source,
            "hoistway.destination": end.destination,
            "hoistway.result": end.result,
            "hoistway.detail": end.detail,
            "hoistway.event": end.seq,
        }
        attributes = {name: value for name, value in about.items() if value}
        began = min((*marks.values(), end.at))
        whole = self._tracer.start_span("delivery", self._nothing, attributes=attributes, start_time=_ns(began))
        if end.result == JobState.FAILED:
            whole.set_status(self._failed)
        for name, (first, last) in PHASES.items():
            if name != WHOLE and first in marks and last in marks and marks[last] >= marks[first]:
                named = {"hoistway.job": job.job, "hoistway.from": str(first), "hoistway.to": str(last)}
                if end.vehicle and first != CREATED:
                    named["hoistway.vehicle"] = end.vehicle
                phase = self._tracer.start_span(
                    name, self._within(whole, self._nothing), attributes=named, start_time=_ns(marks[first])
                )
                phase.end(_ns(marks[last]))
        whole.end(_ns(max(end.at, began)))

    def close(self) -> None:
        """Send what waits; blocking, for some seconds at most."""
        self._provider.shutdown()


def _ns(moment: float) -> int:
    return int(moment * 1_000_000) * 1000
