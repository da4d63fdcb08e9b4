"""Grafana's dashboards, from short tables: ``python -m tools.dashboards`` writes ``deploy/grafana/dashboards``."""

import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parents[1] / "deploy/grafana/dashboards"
SOURCE = {"type": "prometheus", "uid": "hoistway"}
WIDTH, HEIGHT = 24, 8
"""Grafana's grid."""

Lines = Sequence[tuple[str, str]]


@dataclass(frozen=True)
class Panel:
    """One picture: ``lines`` are (expression, legend)."""

    title: str
    lines: Lines
    unit: str = "short"
    kind: str = "timeseries"
    about: str = ""
    stacked: bool = False
    width: int = 8
    red_from: float | None = None


@dataclass(frozen=True)
class Board:
    """One dashboard."""

    name: str
    title: str
    panels: Sequence[Panel]
    tags: Sequence[str] = field(default=("hoistway",))


def one(title: str, expression: str, unit: str = "short", red_from: float | None = None) -> Panel:
    """Return a panel with one number."""
    return Panel(title, [(expression, "")], unit, "stat", width=4, red_from=red_from)


def quantiles(metric: str, by: str = "", where: str = "") -> Lines:
    """Return the median and the 95th percentile of a histogram."""
    groups = f"le, {by}" if by else "le"
    legend = f"{{{{{by}}}}} " if by else ""
    inner = f"sum by ({groups}) (rate({metric}_bucket{where}[$__rate_interval]))"
    return [(f"histogram_quantile({q}, {inner})", f"{legend}p{q * 100:.0f}") for q in (0.5, 0.95)]


OVERVIEW = Board(
    "overview",
    "Hoistway: overview",
    [
        one("State", 'hoistway_controller_state{state="auto"}'),
        one("Deliveries per hour", "hoistway:deliveries:per_hour"),
        one("Open jobs", "sum(hoistway_jobs)"),
        one("Vehicles linked", "hoistway_vehicles_linked"),
        one("Alarms now", "sum(hoistway_alarms_active)", red_from=1),
        one("On hold", "hoistway_vehicles_held", red_from=1),
        Panel("Jobs by state", [("sum by (state) (hoistway_jobs)", "{{state}}")], stacked=True),
        Panel("Vehicles by state", [("sum by (state) (hoistway_vehicles)", "{{state}}")], stacked=True),
        Panel("Utilisation", [("hoistway:utilisation:ratio", "vehicles with a job")], "percentunit"),
        Panel("Delivery time", quantiles("hoistway_job_phase_seconds", where='{phase="whole"}'), "s"),
        Panel("Ends per hour", [("sum by (state) (rate(hoistway_jobs_ended_total[15m])) * 3600", "{{state}}")]),
        Panel("Why vehicles wait", [("sum by (cause) (hoistway_vehicles_waiting) > 0", "{{cause}}")], stacked=True),
        Panel("Alarms there are", [("sum by (kind) (hoistway_alarms_active) > 0", "{{kind}}")], stacked=True),
        Panel("Alarms that began, per hour", [("sum by (kind) (increase(hoistway_alarms_total[1h])) > 0", "{{kind}}")]),
        Panel("Alerts", [('ALERTS{alertname=~"Hoistway.*", alertstate="firing"}', "{{alertname}} {{kind}}{{wire}}")]),
    ],
)
TRAFFIC = Board(
    "traffic",
    "Hoistway: traffic",
    [
        Panel("Why vehicles wait", [("sum by (cause) (hoistway_vehicles_waiting) > 0", "{{cause}}")], stacked=True, width=16),
        Panel(
            "Share of the fleet that waits for others",
            [
                (
                    ('sum(hoistway_vehicles_waiting{cause=~"held|conflict|zone|full|circle|meter|turn|door"})'
                    " / clamp_min(sum(hoistway_vehicles), 1)"),
                    "waiting",
                )
            ],
            "percentunit",
        ),
        Panel("What vehicles do", [("sum by (activity) (hoistway_vehicles_activity)", "{{activity}}")], stacked=True, width=16),
        Panel("Idle", [("hoistway_vehicles_parked", "at parking places"), ("hoistway_vehicles_loaded", "loaded")]),
        one("Circles now", "hoistway_circles", red_from=1),
        one("Circles found, 24 h", "increase(hoistway_circles_found_total[24h])"),
        one("Circles resolved, 24 h", "increase(hoistway_circles_resolved_total[24h])"),
        one("Roll-call misses", "hoistway_roll_call_missing", red_from=1),
        one("Emergencies", "hoistway_emergencies", red_from=1),
        one("Out of service", "hoistway_vehicles_out_of_service + hoistway_vehicles_locked_out"),
        Panel("New routing tables take", quantiles("hoistway_tables_seconds"), "s"),
        Panel("Routing tables per minute", [("rate(hoistway_tables_seconds_count[5m]) * 60", "made"),
                                            ("rate(hoistway_tables_failures_total[5m]) * 60", "planner lost")]),
        Panel("Stations", [("hoistway_stations", "{{believed}}"), ("hoistway_stations_out_of_service", "out of service")]),
    ],
)  # fmt: skip
JOBS = Board(
    "jobs",
    "Hoistway: jobs",
    [
        Panel("Open jobs", [("sum by (state) (hoistway_jobs)", "{{state}}")], stacked=True),
        Panel("Open jobs that are old", [("sum by (at_least) (hoistway_jobs_aged) > 0", "{{at_least}} s and more")]),
        Panel("The oldest", [("hoistway_job_oldest_seconds > 0", "{{state}}")], "s"),
        Panel("Hot lots and waits", [("hoistway_jobs_hot", "hot"), ("hoistway_jobs_explained", "with a reason")]),
        Panel("Ends per hour", [("sum by (state) (rate(hoistway_jobs_ended_total[15m])) * 3600", "{{state}}")]),
        Panel("Whole delivery", quantiles("hoistway_job_phase_seconds", where='{phase="whole"}'), "s"),
        Panel(
            "Phases, p95",
            [
                (
                    (
                        "histogram_quantile(0.95, sum by (le, phase) "
                        '(rate(hoistway_job_phase_seconds_bucket{phase!="whole"}[30m])))'
                    ),
                    "{{phase}}",
                )
            ],
            "s",
            width=16,
        ),
        Panel(
            "Phases, mean",
            [
                (
                    (
                        'sum by (phase) (rate(hoistway_job_phase_seconds_sum{phase!="whole"}[30m]))'
                        " / sum by (phase) (rate(hoistway_job_phase_seconds_count[30m]))"
                    ),
                    "{{phase}}",
                )
            ],
            "s",
            stacked=True,
        ),
        Panel(
            "Events per minute", [("sum by (event) (rate(hoistway_events_total[5m])) * 60 > 0", "{{event}}")], width=16
        ),
        Panel("Carriers", [("hoistway_carriers", "{{where}}")]),
    ],
)
SERVICE = Board(
    "service",
    "Hoistway: links and service",
    [
        Panel("Lines up", [("hoistway_links_up", "{{wire}}"), ("hoistway_links", "{{wire}}, of")]),
        Panel("Packets per second",
              [("sum by (wire, direction) (rate(hoistway_link_frames_total[1m]))", "{{wire}} {{direction}}")]),
        Panel("Round trip of polls", [("hoistway_link_round_trip_seconds", "{{wire}} {{of}}")], "s"),
        Panel(
            "Trouble on lines, per minute",
            [
                ("sum by (wire) (rate(hoistway_link_retries_total[5m])) * 60 > 0", "{{wire}} sent again"),
                ("sum by (wire) (rate(hoistway_link_silences_total[5m])) * 60 > 0", "{{wire}} silent"),
                ("sum by (wire) (rate(hoistway_link_garbled_total[5m])) * 60 > 0", "{{wire}} garbled"),
                ("sum by (wire) (rate(hoistway_link_duplicates_refused_total[5m])) * 60 > 0", "{{wire}} twice"),
                ("sum by (wire) (rate(hoistway_link_connections_total[5m])) * 60 > 0", "{{wire}} connected"),
            ],
            width=16,
        ),
        Panel("The worst lines", [("topk(5, rate(hoistway_line_retries_total[15m]) * 60)", "{{line}}")]),
        Panel("Devices", [("hoistway_devices", "{{kind}} {{state}}"), ("hoistway_drives", "drives {{state}}")]),
        Panel("Commit time", quantiles("hoistway_commit_seconds"), "s"),
        Panel(
            "Commits",
            [
                ("rate(hoistway_commit_seconds_count[1m])", "commits/s"),
                ("rate(hoistway_commit_records_sum[1m])", "records/s"),
                ("rate(hoistway_commit_failures_total[1m])", "refused/s"),
            ],
        ),
        Panel("Waiting for the writer",
              [("hoistway_writer_waiting", "batches"), ("hoistway_decisions_uncommitted", "decisions")]),
        Panel("Event loop late", quantiles("hoistway_loop_late_seconds"), "s"),
        Panel("CPU", [('rate(process_cpu_seconds_total{job="hoistway"}[1m])', "cores")]),
        Panel("Memory", [('process_resident_memory_bytes{job="hoistway"}', "resident")], "bytes"),
        Panel("Answers per second", [("sum by (code) (rate(hoistway_http_requests_total[1m]))", "{{code}}")], stacked=True),
        Panel("Slowest routes, p95", [(("topk(8, histogram_quantile(0.95, sum by (le, method, route) "
              "(rate(hoistway_http_request_seconds_bucket[5m]))))"), "{{method}} {{route}}")], "s"),
        Panel("Refused calls per minute", [("sum by (code) (rate(hoistway_http_problems_total[5m])) * 60 > 0", "{{code}}")]),
        Panel(
            "Watchers",
            [
                ("hoistway_watchers", "watch"),
                ("rate(hoistway_live_frames_dropped_total[1m])", "frames dropped/s"),
                ("rate(hoistway_live_resyncs_total[1m])", "resyncs/s"),
                ("rate(hoistway_live_catch_ups_total[1m])", "catch-ups/s"),
            ],
        ),
        Panel("Webhooks behind, events", [("hoistway_webhook_behind_events", "the one farthest behind")]),
        Panel("Deliveries to webhooks per minute",
              [("sum by (outcome) (rate(hoistway_webhook_deliveries_total[5m])) * 60", "{{outcome}}")]),
        one("Webhooks failed", 'hoistway_webhooks{state="failed"}', red_from=1),
        one("Database trouble", "hoistway_database_trouble", red_from=1),
        one("Up since", "time() - hoistway_controller_start_time_seconds", "s"),
        one("Open files", 'process_open_fds{job="hoistway"}'),
        Panel("Version", [("hoistway_build_info", "{{version}} on Python {{python}}")], kind="stat", width=4),
    ],
)  # fmt: skip
BOARDS = (OVERVIEW, TRAFFIC, JOBS, SERVICE)


def shown(board: Board) -> dict[str, Any]:
    """Return a dashboard as Grafana reads it."""
    panels, x, y, height = [], 0, 0, 0
    for number, panel in enumerate(board.panels, 1):
        if x + panel.width > WIDTH:
            x, y, height = 0, y + height, 0
        tall = 4 if panel.kind == "stat" else HEIGHT
        panels.append(_panel(number, panel, {"x": x, "y": y, "w": panel.width, "h": tall}))
        x, height = x + panel.width, max(height, tall)
    return {
        "uid": f"hoistway-{board.name}",
        "title": board.title,
        "tags": list(board.tags),
        "timezone": "browser",
        "editable": False,
        "refresh": "10s",
        "schemaVersion": 39,
        "time": {"from": "now-1h", "to": "now"},
        "links": [
            {"type": "dashboards", "title": "Hoistway", "tags": ["hoistway"], "asDropdown": False, "keepTime": True}
        ],
        "templating": {"list": []},
        "annotations": {"list": []},
        "panels": panels,
    }


def _panel(number: int, panel: Panel, place: dict[str, int]) -> dict[str, Any]:
    steps: list[dict[str, Any]] = [{"color": "green", "value": None}]
    if panel.red_from is not None:
        steps.append({"color": "red", "value": panel.red_from})
    custom = {"fillOpacity": 25 if panel.stacked else 5, "stacking": {"mode": "normal" if panel.stacked else "none"}}
    options: dict[str, Any] = {"legend": {"displayMode": "list", "placement": "bottom"}, "tooltip": {"mode": "multi"}}
    if panel.kind == "stat":
        text = "name" if panel.lines[0][1] else "value"
        options = {"reduceOptions": {"calcs": ["lastNotNull"]}, "textMode": text, "colorMode": "value"}
    return {
        "id": number,
        "type": panel.kind,
        "title": panel.title,
        "description": panel.about,
        "datasource": SOURCE,
        "gridPos": place,
        "fieldConfig": {
            "defaults": {
                "unit": panel.unit,
                "min": 0,
                "thresholds": {"mode": "absolute", "steps": steps},
                **({"custom": custom} if panel.kind == "timeseries" else {}),
            },
            "overrides": [],
        },
        "options": options,
        "targets": [
            {"refId": chr(65 + index), "datasource": SOURCE, "expr": expression, "legendFormat": legend or "__auto"}
            for index, (expression, legend) in enumerate(panel.lines)
        ],
    }


def texts() -> dict[str, str]:
    """Return the text of each file by its name."""
    return {f"{board.name}.json": json.dumps(shown(board), indent=1, ensure_ascii=False) + "\n" for board in BOARDS}


def main() -> None:
    """Write all dashboards."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, text in texts().items():
        (FOLDER / name).write_text(text, encoding="utf-8")
        sys.stdout.write(f"wrote {FOLDER / name}\n")


if __name__ == "__main__":
    main()
