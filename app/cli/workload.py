"""``hoistway workload``: random jobs for a running controller, over HTTP like any host's."""

from __future__ import annotations

import asyncio
from random import Random
from typing import TYPE_CHECKING, Annotated, Any

import typer

from app.cli.plainly import positive, refuse, why_not
from app.cli.running import on_loop, stop_signal
from app.cli.tongue import language, told_here
from app.domain.ids import CarrierId, StationId
from app.sim.workload import Pace, choose

if TYPE_CHECKING:
    import httpx

EVERY = 1.0
"""Seconds between two looks. Our choice."""


def workload(
    url: Annotated[str, typer.Option(help="the controller's URL")] = "http://127.0.0.1:8080",
    rate: Annotated[float | None, typer.Option(callback=positive, help="jobs per hour, at random moments")] = None,
    keep: Annotated[int | None, typer.Option(min=1, help="keep so many jobs open instead")] = None,
    seed: Annotated[int | None, typer.Option(help="the same seed chooses the same way")] = None,
    key: Annotated[str | None, typer.Option(envvar="HOISTWAY_ACCESS_KEY", help="access key")] = None,
) -> None:
    """Order random transfers, from full places to empty ones, until Ctrl-C."""
    if rate is not None and keep is not None:
        refuse("either --rate or --keep, not both")
    if not url.startswith(("http://", "https://")):
        refuse(f"{url} is not the URL of a controller", "Write it as http://127.0.0.1:8080")

    async def run() -> int:
        stop = stop_signal()
        await order(url, Random(seed), stop, rate=rate, keep=None if rate is not None else keep or 6, key=key)
        return 0

    raise typer.Exit(on_loop(run()))


async def order(
    url: str,
    rng: Random,
    stop: asyncio.Event,
    *,
    rate: float | None,
    keep: int | None,
    key: str | None = None,
    quiet: bool = False,
) -> None:
    """Order jobs until ``stop``; a server that does not answer is asked again later."""
    import httpx

    pace = Pace(rng, per_hour=rate, keep_open=keep)
    headers = {"X-Actor": "workload", "Accept-Language": language()}
    headers |= {"Authorization": f"Bearer {key}"} if key else {}
    loop = asyncio.get_running_loop()

    def tell(line: str) -> None:
        if not quiet:
            print(line, flush=True)

    async with httpx.AsyncClient(base_url=f"{url}/api/v1", headers=headers, timeout=10.0) as client:
        while not stop.is_set():
            try:
                for line in await _look_and_order(client, rng, pace, loop.time()):
                    tell(line)
            except httpx.HTTPStatusError as refusal:
                tell(told_here(f"hoistway workload: {url} refuses: {_refused(refusal.response)}"))
            except (httpx.HTTPError, httpx.InvalidURL) as trouble:
                tell(told_here(f"hoistway workload: {url} does not answer: {why_not(trouble)}"))
            except (ValueError, LookupError, TypeError):
                tell(told_here(f"hoistway workload: what answers at {url} is no controller"))
            try:
                await asyncio.wait_for(stop.wait(), EVERY)
            except TimeoutError:
                continue


async def _look_and_order(client: httpx.AsyncClient, rng: Random, pace: Pace, now: float) -> list[str]:
    """Order what is due; return what came of it, a line for each job."""
    stations = (await _get(client, "/stations"))["items"]
    jobs = (await _get(client, "/jobs?limit=1000"))["items"]
    living = [job for job in jobs if job["ended"] is None]
    engaged = {StationId(job[end]) for job in living for end in ("source", "destination")}
    at = {StationId(one["id"]): CarrierId(one["carrier"]) for one in stations if one["present"] and one["carrier"]}
    ids = [StationId(one["id"]) for one in stations if _usable(one)]
    agv = {StationId(one["id"]) for one in stations if one["kind"] == "agv_buffer"}
    told = []
    for _ in range(pace.due(now, len(living))):
        errand = choose(rng, ids, at, engaged, agv)
        if errand is None:
            break
        engaged |= {errand.source, errand.destination}
        body = {"source": errand.source, "destination": errand.destination, "carrier": errand.carrier}
        answer = await client.post("/jobs", json=body)
        accepted = answer.status_code == 201
        way = f"{errand.source} → {errand.destination}"
        told.append(
            f"{answer.json()['id']}: {way}" if accepted else f"{way}: {told_here('refused')}: {_refused(answer)}"
        )
    return told


def _refused(answer: httpx.Response) -> str:
    """Return why the server does not do it, in its own words where it gives any."""
    try:
        return str(answer.json()["detail"])
    except (ValueError, LookupError, TypeError):
        return f"{answer.status_code} {answer.reason_phrase}"


def _usable(station: dict[str, Any]) -> bool:
    """Whether it is in service, and either a known carrier stands there or none that anybody knows of."""
    return not station["out_of_service"] and (not station["present"] or bool(station["carrier"]))


async def _get(client: httpx.AsyncClient, path: str) -> Any:
    answer = await client.get(path)
    answer.raise_for_status()
    return answer.json()
