"""/metrics: what it gives, what it costs in labels, and who may read it."""

from collections.abc import AsyncIterator
from dataclasses import replace

import httpx
import pytest
from fastapi import FastAPI
from prometheus_client.parser import text_string_to_metric_families
from pydantic import SecretStr

from app.api.application import application
from app.api.calls_counted import LINES, NO_ROUTE, CountedCalls, route_of
from app.domain.view import HoldView, Topic, Update, VehicleView
from app.settings import Settings
from tests.api.scripted import NOW, Scripted

pytestmark = pytest.mark.anyio
KEY, SCRAPER = "0123456789abcdef", "scraper-0123456789"


def samples(text: str) -> dict[tuple[str, tuple[tuple[str, str], ...]], float]:
    """Return every sample of a scrape by its name and labels."""
    return {
        (sample.name, tuple(sorted(sample.labels.items()))): sample.value
        for family in text_string_to_metric_families(text)
        for sample in family.samples
    }


async def scraped(
    client: httpx.AsyncClient, path: str = "/metrics"
) -> dict[tuple[str, tuple[tuple[str, str], ...]], float]:
    answer = await client.get(f"http://localhost{path}")
    assert answer.status_code == 200
    assert answer.headers["content-type"].startswith("text/plain; version=")
    return samples(answer.text)


async def test_vehicles_are_shown_by_kind_and_state_and_by_what_people_have_to_see_to(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    view = controller.model.get(Topic.VEHICLES, "V001")
    assert isinstance(view, VehicleView)
    held = replace(view, state="enroute", hold=HoldView("look", "look", NOW), oper="alarm")
    controller.hub.publish([Update(Topic.VEHICLES, "V001", held)])
    found = await scraped(client)
    assert found["hoistway_vehicles", (("kind", "hoist"), ("state", "enroute"))] == 1
    assert found["hoistway_vehicles", (("kind", "hoist"), ("state", "not_assigned"))] == 1
    assert found["hoistway_vehicles", (("kind", "hoist"), ("state", "acquiring"))] == 0
    assert found["hoistway_vehicles_held", ()] == 1
    assert found["hoistway_alarms_active", (("kind", "hoist"),)] == 1
    assert found["hoistway_vehicles_waiting", (("cause", "held"),)] == 0


async def test_jobs_are_shown_by_state_and_age(client: httpx.AsyncClient, controller: Scripted) -> None:
    await client.post("/jobs", json={"job_id": "OLD", "source": "P1", "destination": "P2", "priority": 95})
    old = controller.model.get(Topic.JOBS, "OLD")
    controller.hub.publish([Update(Topic.JOBS, "OLD", replace(old, created=NOW - 400.0))])  # type: ignore[type-var]
    await client.post("/jobs", json={"job_id": "NEW", "source": "P1", "destination": "P2"})
    found = await scraped(client)
    assert found["hoistway_jobs", (("state", "queued"),)] == 2
    assert found["hoistway_jobs_hot", ()] == 1
    assert found["hoistway_jobs_aged", (("at_least", "300"), ("state", "queued"))] == 1
    assert found["hoistway_jobs_aged", (("at_least", "900"), ("state", "queued"))] == 0
    assert found["hoistway_job_oldest_seconds", (("state", "queued"),)] == 400


async def test_links_are_shown_by_wire_and_one_by_one_under_a_path_of_their_own(client: httpx.AsyncClient) -> None:
    found = await scraped(client)
    assert found["hoistway_links", (("wire", "itsc"),)] == 2
    assert found["hoistway_link_retries_total", (("wire", "itsc"),)] == 6
    assert found["hoistway_link_silences_total", (("wire", "itsc"),)] == 10
    assert found["hoistway_link_duplicates_refused_total", (("wire", "itsc"),)] == 8
    assert found["hoistway_link_round_trip_seconds", (("of", "worst"), ("wire", "itsc"))] == 0.0125
    assert not [name for name, labels in found if "line" in dict(labels)]
    lines = await scraped(client, "/metrics/lines")
    assert lines["hoistway_line_connections_total", (("line", "V001"), ("wire", "itsc"))] == 2
    assert {dict(labels)["line"] for _, labels in lines} >= {"V001", "V002", "AXES"}


async def test_calls_are_counted_by_the_template_of_their_route(client: httpx.AsyncClient) -> None:
    before = await scraped(client)
    for path in ("/jobs/A", "/jobs/B", "/vehicles/V001", "/no/such/path", "/vehicles/V009/whatever"):
        await client.get(path)
    await client.post("/jobs", json={"source": "P1", "destination": "P2"})
    await client.post("/jobs", json={"source": "P1"})
    await client.get("http://localhost/")
    after = await scraped(client)

    def more(method: str, route: str, code: str) -> float:
        key = "hoistway_http_requests_total", (("code", code), ("method", method), ("route", route))
        return after[key] - before.get(key, 0.0)

    assert more("GET", "/api/v1/jobs/{job}", "404") == 2
    assert more("GET", "/api/v1/vehicles/{vehicle}", "200") == 1
    assert more("GET", NO_ROUTE, "404") == 2
    assert more("POST", "/api/v1/jobs", "201") == 1
    assert more("POST", "/api/v1/jobs", "422") == 1
    assert more("GET", "/", "200") == 1
    assert after["hoistway_http_problems_total", (("code", "invalid"),)] >= 1
    assert not [key for key in after if "V001" in str(key) or "/jobs/A" in str(key)]


async def test_openmetrics_is_given_to_whoever_asks_for_it(client: httpx.AsyncClient) -> None:
    answer = await client.get(
        "http://localhost/metrics", headers={"Accept": "application/openmetrics-text; version=1.0.0"}
    )
    assert answer.headers["content-type"].startswith("application/openmetrics-text")
    assert answer.text.endswith("# EOF\n")


@pytest.fixture
async def keyed(controller: Scripted) -> AsyncIterator[httpx.AsyncClient]:
    settings = Settings(access_key=SecretStr(KEY), metrics_key=SecretStr(SCRAPER))
    transport = httpx.ASGITransport(application(controller, settings))
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
        yield client


@pytest.mark.parametrize(
    ("path", "key", "status"),
    [
        ("/metrics", "", 401),
        ("/metrics", "wrong-wrong-wrong", 401),
        ("/metrics", SCRAPER, 200),
        ("/metrics/lines", SCRAPER, 200),
        ("/metrics", KEY, 200),
        ("/api/v1/vehicles", SCRAPER, 403),
        ("/api/v1/vehicles", KEY, 200),
    ],
)
async def test_the_key_of_the_scraper_opens_the_metrics_and_nothing_else(
    keyed: httpx.AsyncClient, path: str, key: str, status: int
) -> None:
    headers = {"Authorization": f"Bearer {key}"} if key else {}
    assert (await keyed.get(path, headers=headers)).status_code == status


async def test_a_route_of_an_included_router_is_named_in_full(served: FastAPI) -> None:
    class Route:
        path = "/jobs/{job}"

    assert route_of({"path": "/api/v1/jobs/X", "route": Route()}) == "/api/v1/jobs/{job}"
    Route.path = "/api/v1/jobs/{job}"
    assert route_of({"path": "/api/v1/jobs/X", "route": Route()}) == "/api/v1/jobs/{job}"
    assert route_of({"path": "/assets/a.js", "root_path": "/assets", "endpoint": None}) == "/assets"
    assert route_of({"path": "/anything"}) == NO_ROUTE


async def test_callers_cannot_fill_the_log(capsys: pytest.CaptureFixture[str]) -> None:
    moment = 0.0
    counted = CountedCalls(lambda: moment)
    scope = {"method": "GET", "path": "/x", "client": ("10.0.0.9", 1), "path_params": {"job": "J7"}}
    told: list[bool] = [counted._may_tell() for _ in range(LINES + 5)]
    assert told == [True] * LINES + [False] * 5
    moment = 61.0
    assert counted._may_tell()
    counted._refuse(scope, 404, b"no JSON at all")
    assert not [family for family in counted.families() if family.name == "hoistway_http_problems" and family.samples]
