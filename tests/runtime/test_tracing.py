"""Traces of jobs: what spans they have, and that a collector gets them."""

import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer

import pytest
from opentelemetry.proto.collector.trace.v1.trace_service_pb2 import ExportTraceServiceRequest
from opentelemetry.sdk.trace import ReadableSpan
from opentelemetry.sdk.trace.export.in_memory_span_exporter import InMemorySpanExporter
from opentelemetry.trace import StatusCode

from app.domain.job import JobEvent
from app.domain.view import Topic, Update
from app.runtime.metrics.jobs import JobFigures
from app.runtime.tracing import Traces, TracesMissing, provider
from tests.api.scripted import PLANT
from tests.runtime.test_metrics import accepted, happened

E = JobEvent


def traced(*updates: Update) -> list[ReadableSpan]:
    """Return the spans that come of what is published, by their start."""
    exporter = InMemorySpanExporter()
    traces = Traces(provider("tiny", "1.0", {}, exporter))
    jobs = JobFigures(PLANT)
    jobs.told = traces.take
    jobs.take(updates)
    traces.close()
    return sorted(exporter.get_finished_spans(), key=lambda span: (span.start_time or 0, span.name != "delivery"))


def test_a_job_is_one_trace_with_a_span_for_each_phase() -> None:
    spans = traced(
        Update(Topic.JOBS, "J1", accepted(100.0)),
        happened(E.VEHICLE_ASSIGNED, 103.0),
        happened(E.VEHICLE_ACQUIRE_STARTED, 110.0),
        happened(E.VEHICLE_ACQUIRE_COMPLETED, 121.5),
        happened(E.VEHICLE_DEPOSIT_STARTED, 150.0),
        happened(E.VEHICLE_DEPOSIT_COMPLETED, 162.0),
        happened(E.TRANSFER_COMPLETED, 162.5, result="completed"),
    )
    names = ["delivery", "queued", "to_source", "acquiring", "to_destination", "depositing"]
    assert [span.name for span in spans] == names
    whole = spans[0]
    assert (whole.start_time, whole.end_time) == (100 * 10**9, 162_500 * 10**6)
    assert whole.attributes is not None
    assert whole.attributes["hoistway.job"] == "J1"
    assert whole.attributes["hoistway.vehicle"] == "V001"
    assert whole.attributes["hoistway.result"] == "completed"
    assert "hoistway.carrier" not in whole.attributes
    assert whole.context is not None
    for span in spans[1:]:
        assert span.parent is not None
        assert span.parent.span_id == whole.context.span_id
        assert span.context is not None
        assert span.context.trace_id == whole.context.trace_id
    assert (spans[3].start_time, spans[3].end_time) == (110 * 10**9, 121_500 * 10**6)
    assert whole.resource.attributes["service.name"] == "hoistway"
    assert whole.resource.attributes["hoistway.plant"] == "tiny"


def test_two_jobs_are_two_traces_and_a_failed_one_has_the_status_error() -> None:
    spans = traced(
        Update(Topic.JOBS, "J1", accepted(1.0)),
        Update(Topic.JOBS, "J2", accepted(2.0, "J2")),
        happened(E.TRANSFER_COMPLETED, 5.0, result="failed", detail="PICKUP refused"),
        happened(E.TRANSFER_CANCEL_COMPLETED, 6.0, "J2", result="cancelled"),
    )
    assert [span.status.status_code for span in spans] == [StatusCode.ERROR, StatusCode.UNSET]
    assert len({span.context.trace_id for span in spans if span.context}) == 2


@contextmanager
def collector() -> Iterator[tuple[str, list[ExportTraceServiceRequest]]]:
    got: list[ExportTraceServiceRequest] = []

    class Collector(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = self.rfile.read(int(self.headers["Content-Length"]))
            got.append(ExportTraceServiceRequest.FromString(body))
            self.send_response(200)
            self.end_headers()

        def log_message(self, format: str, *args: object) -> None:  # noqa: A002
            pass

    server = HTTPServer(("127.0.0.1", 0), Collector)
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}", got
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


def test_a_collector_gets_them_where_the_standard_variable_says(monkeypatch: pytest.MonkeyPatch) -> None:
    with collector() as (url, got):
        monkeypatch.setenv("OTEL_EXPORTER_OTLP_ENDPOINT", url)
        monkeypatch.setenv("OTEL_EXPORTER_OTLP_COMPRESSION", "none")
        monkeypatch.setenv("OTEL_SERVICE_NAME", "fab 7")
        traces = Traces(provider("tiny", "1.0", os.environ))
        jobs = JobFigures(PLANT)
        jobs.told = traces.take
        jobs.take([Update(Topic.JOBS, "J1", accepted(1.0)), happened(E.TRANSFER_COMPLETED, 5.0, result="completed")])
        traces.close()
    (resource,) = got[0].resource_spans
    assert {a.value.string_value for a in resource.resource.attributes if a.key == "service.name"} == {"fab 7"}
    assert [span.name for scope in resource.scope_spans for span in scope.spans] == ["delivery"]


def test_without_what_makes_them_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "opentelemetry.sdk.trace", None)
    with pytest.raises(TracesMissing) as missing:
        provider("tiny", "1.0", {})
    assert "hoistway[otel]" in missing.value.remedy


def test_nothing_of_it_is_imported_while_traces_are_off() -> None:
    code = "import sys, app.cli.hosting; print([name for name in sys.modules if name.startswith('opentelemetry.sdk')])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
