"""Prometheus' rules and Grafana's dashboards: what they ask for exists, and they are what the tools take."""

import asyncio
import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
import yaml
from prometheus_client.parser import text_string_to_metric_families

from app.api.application import described
from app.settings import Settings
from tests.api.scripted import Scripted
from tools.dashboards import FOLDER, texts

ROOT = Path(__file__).parents[2]
DEPLOY = ROOT / "deploy"
RULES = DEPLOY / "prometheus/rules/hoistway.yml"
NAME = re.compile(r"\b(?:hoistway_|hoistway:|process_|python_)[a-zA-Z0-9_:]+")
SELECTOR = re.compile(r"\b((?:hoistway|process)_[a-z0-9_]+)(?:\{([^}]*)\})?")
LABEL = re.compile(r"([a-z_]+)\s*(?:=~|!~|!=|=)")
GROUPED = re.compile(r"\b(?:by|without)\s*\(([^)]*)\)")
promtool = pytest.mark.skipif(shutil.which("promtool") is None, reason="promtool is not installed (package prometheus)")


@pytest.fixture(scope="session")
def scraped() -> dict[str, set[str]]:
    """The labels of every sample that a scrape gives, by its name."""

    async def scrape() -> str:
        app = described(Settings())
        app.state.controller = Scripted()
        transport = httpx.ASGITransport(app)
        async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
            await client.get("/api/v1/jobs/none")
            return (await client.get("/metrics")).text + (await client.get("/metrics/lines")).text

    found: dict[str, set[str]] = {}
    for family in text_string_to_metric_families(asyncio.run(scrape())):
        found.setdefault(family.name, set())
        for sample in family.samples:
            found.setdefault(sample.name, set()).update(sample.labels)
    return found


def rules() -> list[dict[str, Any]]:
    groups = yaml.safe_load(RULES.read_text(encoding="utf-8"))["groups"]
    return [rule for group in groups for rule in group["rules"]]


def expressions() -> Iterator[tuple[str, str]]:
    """Every expression of the rules and dashboards, with where it stands."""
    for rule in rules():
        yield rule.get("alert") or rule["record"], rule["expr"]
    for file in sorted(FOLDER.glob("*.json")):
        for panel in json.loads(file.read_text(encoding="utf-8"))["panels"]:
            for target in panel["targets"]:
                yield f"{file.name}: {panel['title']}", target["expr"]


def test_every_metric_of_rules_and_dashboards_exists_with_the_labels_that_are_asked_for(
    scraped: dict[str, set[str]],
) -> None:
    recorded = {rule["record"] for rule in rules() if "record" in rule}
    seen = set()
    for where, expression in expressions():
        used = set(NAME.findall(expression))
        labels: set[str] = set()
        for name in used:
            assert name in scraped or name in recorded, f"{where}: nothing gives {name}"
            labels |= scraped.get(name, set())
        for name, matchers in SELECTOR.findall(expression):
            wanted = set(LABEL.findall(matchers)) - {"job", "instance"}
            assert wanted <= scraped[name], f"{where}: {name} has no label {wanted - scraped[name]}"
        for group in GROUPED.findall(expression):
            names = {part.strip() for part in group.split(",")}
            assert names <= labels | {"le"}, f"{where}: nothing has the label {names - labels}"
        seen |= used
    assert len(seen) > 50


def test_the_description_of_the_metrics_names_every_one_and_no_other(scraped: dict[str, set[str]]) -> None:
    described_names = set(re.findall(r"`(hoistway_[a-z0-9_]+)", (ROOT / "docs/metrics.md").read_text(encoding="utf-8")))
    families = {re.sub(r"_(bucket|sum|count|total)$", "", name) for name in scraped if name.startswith("hoistway_")}
    assert described_names == families


def test_every_alert_says_how_bad_it_is_and_is_explained_for_people_on_duty() -> None:
    page = (ROOT / "docs/operations.md").read_text(encoding="utf-8")
    for rule in rules():
        if "alert" in rule:
            assert rule["labels"]["severity"] in {"critical", "warning", "info"}
            assert rule["annotations"]["summary"]
            assert f"`{rule['alert']}`" in page, rule["alert"]


def test_the_dashboards_are_up_to_date() -> None:
    assert {file.name: file.read_text(encoding="utf-8") for file in FOLDER.glob("*.json")} == texts(), (
        "run `python -m tools.dashboards`"
    )


def test_the_panels_of_a_dashboard_lie_side_by_side_and_read_from_the_provisioned_source() -> None:
    source = yaml.safe_load((DEPLOY / "grafana/provisioning/datasources/prometheus.yml").read_text(encoding="utf-8"))
    uid = source["datasources"][0]["uid"]
    for text in texts().values():
        taken: set[tuple[int, int]] = set()
        for panel in json.loads(text)["panels"]:
            place = panel["gridPos"]
            cells = {
                (x, y)
                for x in range(place["x"], place["x"] + place["w"])
                for y in range(place["y"], place["y"] + place["h"])
            }
            assert not cells & taken
            assert place["x"] + place["w"] <= 24
            taken |= cells
            assert {target["datasource"]["uid"] for target in panel["targets"]} == {uid}


def _promtool(*arguments: str) -> None:
    done = subprocess.run(["promtool", *arguments], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@promtool
def test_promtool_takes_the_rules_and_the_configuration() -> None:
    _promtool("check", "rules", str(RULES))
    _promtool("check", "config", "--syntax-only", str(DEPLOY / "prometheus/prometheus.yml"))


@promtool
def test_promtool_finds_that_alerts_come_when_they_should() -> None:
    _promtool("test", "rules", str(DEPLOY / "prometheus/tests/hoistway.yml"))


@promtool
def test_promtool_takes_every_expression_of_the_dashboards(tmp_path: Path) -> None:
    asked = [expression.replace("$__rate_interval", "1m") for _, expression in expressions()]
    listed = [{"record": f"panel:{number}", "expr": expression} for number, expression in enumerate(asked)]
    file = tmp_path / "panels.yml"
    file.write_text(yaml.safe_dump({"groups": [{"name": "panels", "rules": listed}]}), encoding="utf-8")
    _promtool("check", "rules", str(file))


@promtool
def test_promtool_finds_nothing_wrong_with_the_metrics_themselves() -> None:
    app = described(Settings())
    app.state.controller = Scripted()

    async def scrape() -> str:
        transport = httpx.ASGITransport(app)
        async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
            return (await client.get("/metrics")).text + (await client.get("/metrics/lines")).text

    text = asyncio.run(scrape())
    done = subprocess.run(["promtool", "check", "metrics"], input=text, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
