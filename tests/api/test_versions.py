"""Versions of the plant over REST: stage, compare, weigh, activate, reject, roll back."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from app.domain.ids import Actor, StationId
from app.domain.job import Job
from app.domain.layout import PulseSet
from app.domain.records import StationDest
from app.domain.units import Pulses
from app.domain.versions import Leaving, Origin, Source
from app.store.versions import KEPT_REJECTED
from tests.api.kept_versions import TEXT, KeptVersions, kept_versions
from tests.api.scripted import NOW, Scripted
from tests.store.samples import job

pytestmark = pytest.mark.anyio

NEW = TEXT.replace("  B1: {", "  P9: {kind: port, at: 108, dest: {shft: 5, rota: 5, lift: 5}}\n  B1: {")
WITHOUT = "\n".join(line for line in TEXT.splitlines() if not line.startswith("  P2:")) + "\n"
KIM = {"X-Actor": "kim"}
YAML = {"Content-Type": "application/yaml"}


@pytest.fixture
def plant(tmp_path: Path) -> Iterator[KeptVersions]:
    with kept_versions(tmp_path) as kept:
        yield kept


@pytest.fixture
def controller(plant: KeptVersions) -> Scripted:
    made = Scripted(plant=plant.plant)
    made.versions, made.version = plant.versions, 1
    return made


async def stage(client: httpx.AsyncClient, text: str, status: int = 201) -> Any:
    answer = await client.post(
        "/layout/versions", params={"reason": "a port more"}, content=text.encode(), headers=YAML | KIM
    )
    assert answer.status_code == status, answer.text
    return answer.json()


async def post(client: httpx.AsyncClient, path: str, status: int, **body: Any) -> Any:
    answer = await client.post(f"/layout/versions/{path}", json={"reason": "tonight", **body}, headers=KIM)
    assert answer.status_code == status, answer.text
    return answer.json()


async def test_a_version_is_staged_listed_and_given_back_to_the_letter(client: httpx.AsyncClient) -> None:
    made = await stage(client, NEW)
    assert [one for one in made["findings"] if one["severity"] == "error"] == []
    assert {name: made[name] for name in ("number", "state", "origin", "actor", "reason", "size")} == {
        "number": 2,
        "state": "staged",
        "origin": "upload",
        "actor": "kim",
        "reason": "a port more",
        "size": len(NEW.encode()),
    }
    listed = (await client.get("/layout/versions")).json()
    assert [(one["number"], one["state"]) for one in listed["items"]] == [(2, "staged"), (1, "active")]
    file = await client.get("/layout/versions/2/file")
    assert (file.text, file.headers["content-type"]) == (NEW, "application/yaml; charset=utf-8")
    assert file.headers["content-disposition"] == 'attachment; filename="small-2.yaml"'
    assert (await client.get("/layout")).json()["version"] == 1


async def test_a_file_with_errors_is_refused_with_line_column_and_remedy_of_each(client: httpx.AsyncClient) -> None:
    wrong = TEXT.replace("  P2: {kind: port", "  P2: {kind: porch").replace("  P1: {kind: port", "  P1: {knd: port")
    problem = await stage(client, wrong, 422)
    lines = dict(enumerate(wrong.splitlines(), 1))
    assert problem["code"] == "invalid"
    assert len(problem["errors"]) >= 2
    for error in problem["errors"]:
        assert set(error) == {"field", "message", "remedy", "line", "column", "severity"}
        assert any(name in lines[error["line"]] for name in ("P1:", "P2:"))
    assert (await client.get("/layout/versions")).json()["items"][0]["number"] == 1


async def test_warnings_do_not_keep_a_file_from_being_staged(client: httpx.AsyncClient) -> None:
    lonely = TEXT.replace("\ntrack:\n", "\ntrack:\n  - {through: [900, 101]}\n", 1).replace(
        "\nbarcodes:\n", "\nbarcodes:\n  900: [90000, 0]\n", 1
    )
    made = await stage(client, lonely)
    found = (await client.get(f"/layout/versions/{made['number']}/findings")).json()["items"]
    assert found == made["findings"]
    assert found
    assert {finding["severity"] for finding in found} == {"warning"}


@pytest.mark.parametrize(
    ("content", "headers", "params", "status", "said"),
    [
        (b"\xff\xfe1", YAML, {"reason": "x"}, 400, "The plant file is not UTF-8: invalid start byte at byte 0."),
        (b"{}", {"Content-Type": "application/json"}, {"reason": "x"}, 415, "The body came as 'application/json'."),
        (b"", YAML, {"reason": "x"}, 422, "has 1 error;"),
        (TEXT.encode(), YAML, {}, 422, "reason: is required"),
        (TEXT.encode(), YAML, {"reason": "a\nb"}, 422, "reason: holds a character"),
        (
            TEXT.replace("name: small", "name: other").encode(),
            YAML,
            {"reason": "x"},
            422,
            "a file of the plant other, and this is small",
        ),
        (TEXT.encode(), YAML, {"reason": "x"}, 409, "That is the active version 1, to the letter."),
        (b"a: &a [1]\nb: *a\n", YAML, {"reason": "x"}, 422, "an alias (*a) cannot be used here"),
        (b"[" * 100_000, YAML, {"reason": "x"}, 422, "has 1 error;"),
        (b"x" * (17 << 20), YAML, {"reason": "x"}, 413, "larger than 16777216 bytes"),
    ],
)
async def test_what_cannot_be_staged_is_refused_with_the_reason(
    client: httpx.AsyncClient, content: bytes, headers: dict[str, str], params: dict[str, str], status: int, said: str
) -> None:
    answer = await client.post("/layout/versions", params=params, content=content, headers=headers)
    assert answer.status_code == status, answer.text[:500]
    assert said in answer.json()["detail"]


async def test_the_difference_is_told_in_both_directions(client: httpx.AsyncClient) -> None:
    await stage(client, NEW)
    there = (await client.get("/layout/versions/2/diff")).json()
    assert (there["version"], there["against"], there["breaks"]) == (2, 1, [])
    assert [(one["what"], one["how"], one["name"]) for one in there["changes"]] == [("station", "added", "P9")]
    assert there["changes"][0]["after"]["barcode"] == "108"
    back = (await client.get("/layout/versions/1/diff", params={"against": 2})).json()
    assert [(one["what"], one["how"], one["name"]) for one in back["changes"]] == [("station", "removed", "P9")]
    assert [one["name"] for one in back["breaks"]] == ["P9"]


async def test_a_version_that_breaks_nothing_is_awaited_and_whoever_runs_the_plant_is_woken(
    client: httpx.AsyncClient, plant: KeptVersions
) -> None:
    await stage(client, NEW)
    impact = (await client.get("/layout/versions/2/impact")).json()
    assert (impact["version"], impact["ready"], impact["in_the_way"], impact["lost"]) == (2, True, [], [])
    assert [(one["what"], one["name"]) for one in impact["lacking"]] == [("station", "P9")]
    made = await post(client, "2/activate", 202)
    assert (made["version"]["state"], made["version"]["asked_by"], made["in_the_way"]) == ("awaited", "kim", [])
    assert plant.versions.wanted.is_set()
    refused = await post(client, "2/activate", 409)
    assert refused["detail"] == "Version 2 is to become active already."
    assert (await post(client, "2/reject", 200))["state"] == "rejected"


async def test_what_stands_in_the_way_is_listed_and_can_be_waited_for(
    client: httpx.AsyncClient, plant: KeptVersions
) -> None:
    plant.ledger.commit([a_job_to("P2"), a_dest_of("P2")])
    await stage(client, WITHOUT)
    impact = (await client.get("/layout/versions/2/impact")).json()
    assert impact["ready"] is False
    assert [(one["what"], one["name"], one["text"]) for one in impact["in_the_way"]] == [
        ("job", "J1", "it names P2, which the new plant does not have")
    ]
    assert [(one["name"], one["text"]) for one in impact["lost"]] == [
        ("P2", "its taught DEST (version 1) serves nobody any more")
    ]
    problem = await post(client, "2/activate", 409)
    assert problem["code"] == "not-now"
    assert problem["errors"] == [
        {
            "field": "job J1",
            "message": "it names P2, which the new plant does not have",
            "remedy": "end it, or cancel it, first",
        }
    ]
    assert (await client.get("/layout/versions/2")).json()["state"] == "staged"
    made = await post(client, "2/activate", 202, wait=True)
    assert made["version"]["patient"] is True
    assert [one["name"] for one in made["in_the_way"]] == ["J1"]


async def test_the_controller_hears_what_goes_as_long_as_a_version_is_awaited(
    client: httpx.AsyncClient, plant: KeptVersions
) -> None:
    heard = list[Leaving | None]()
    plant.versions.attach(heard.append)
    plant.ledger.commit([a_job_to("P2")])
    await stage(client, WITHOUT)
    await stage(client, NEW)
    assert heard == []
    await post(client, "2/activate", 202, wait=True)
    assert heard == [Leaving(2, frozenset({"P2"}), frozenset())]
    await post(client, "3/reject", 200)
    assert len(heard) == 1
    await post(client, "2/reject", 200)
    assert heard[1:] == [None]


async def test_who_activates_over_another_version_than_they_saw_is_told(client: httpx.AsyncClient) -> None:
    await stage(client, NEW)
    problem = await post(client, "2/activate", 412, instead_of=7)
    assert (problem["code"], problem["detail"]) == ("stale", "Version 1 is active, not 7.")
    assert (await post(client, "2/activate", 202, instead_of=1))["version"]["state"] == "awaited"


@pytest.mark.parametrize("path", ["9", "9/file", "9/findings", "9/diff", "9/impact", "1/diff?against=9"])
async def test_a_version_that_there_is_not_is_not_found(client: httpx.AsyncClient, path: str) -> None:
    answer = await client.get(f"/layout/versions/{path}")
    assert answer.status_code == 404
    assert answer.json()["detail"] == "There is no version 9 of the plant."


@pytest.mark.parametrize("path", ["2/file", "2/diff", "2/impact"])
async def test_a_version_whose_text_is_not_kept_any_more_says_so(
    client: httpx.AsyncClient, plant: KeptVersions, path: str
) -> None:
    store = plant.versions.store
    for number in range(2, KEPT_REJECTED + 3):
        store.stage(Source(f"a text {number}"), Origin.UPLOAD, Actor("lee"), "a try", NOW)
        store.reject(number, Actor("lee"), "a typing error", NOW)
    answer = await client.get(f"/layout/versions/{path}")
    assert answer.status_code == 404
    said = "The text of version 2 is not kept any more; it was rejected: lee: a typing error."
    assert answer.json()["detail"] == said
    assert (await client.get("/layout/versions/2/findings")).json()["items"] == []
    assert (await client.get("/layout/versions/2")).json()["pruned"] is not None


async def test_a_catalogue_is_given_as_the_version_has_it(client: httpx.AsyncClient, plant: KeptVersions) -> None:
    plant.versions.store.stage(Source("text", {"sv2": "parameters: {}"}), Origin.UPLOAD, Actor("lee"), "a try", NOW)
    assert list((await client.get("/layout/versions/2")).json()["models"]) == ["sv2"]
    assert (await client.get("/layout/versions/2/catalogues/sv2")).text == "parameters: {}"
    answer = await client.get("/layout/versions/2/catalogues/sv3")
    assert (answer.status_code, answer.json()["detail"]) == (404, "Version 2 has no catalogue sv3.")
    assert (await client.get("/layout/versions/9/catalogues/sv2")).status_code == 404


async def test_a_person_has_to_decide(client: httpx.AsyncClient) -> None:
    answer = await client.post("/layout/versions/1/activate", json={"reason": "x"})
    assert answer.status_code == 422
    assert answer.json()["detail"] == "A named person has to decide this."


async def test_a_server_without_versions_says_so(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.versions = None
    answer = await client.get("/layout/versions")
    assert answer.status_code == 409
    assert answer.json()["detail"] == "This server keeps no versions of the plant."


def a_job_to(station: str) -> Job:
    return job(1, source=StationId("P1"), destination=StationId(station))


def a_dest_of(station: str) -> StationDest:
    pulses = PulseSet(Pulses(5), Pulses(5), Pulses(5))
    return StationDest(StationId(station), 1, pulses, Actor("test"), "rest", NOW)
